"""The statement of a problem.

Notes on what may not be meant.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Display, Rule
from lagrange.document.math_writer import unicode
from lagrange.explain.report import report
from lagrange.explain.statement import force_called, remarks
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.render import terminal
from tests.support.derivation_text import words
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("chapter6/ex07-constant-coefficients", "Time appears explicitly in the finite form of the rates constraint"),
        ("constraints/rocking-plane", "Time appears explicitly in the plane constraint"),
        ("constraints/steered-blade", "Time appears explicitly in the blade constraint"),
        ("constraints/rolling-ball", "The first and second no-slip constraints"),
    ],
)
def test_how_time_enters(name: str, said: str) -> None:
    steps = reported(name).derivation.steps
    [classification] = [s for s in steps if s.rule is Rule.CLASSIFICATION]
    assert said in words(classification)


def test_the_statement_says_what_the_file_writes_for_short() -> None:
    statement = reported("chapter6/ex05-ice-skate").derivation.steps[0]
    [line] = [e for b in statement.body if isinstance(b, Display) for e in b.equations]
    assert [unicode(s) for s in line.sides] == ["n", "sin θ i − cos θ j"]
    forces = reported("chapter6/ex02-fixed-surface").derivation.steps[0]
    assert "F_x, F_y and F_z are unspecified functions of x, y, z, ẋ, ẏ, ż and t." in words(forces)


def page(problem: Problem) -> str:
    told = report(problem, complete=False)
    return " ".join(terminal.text(told.derivation, told.notation, 100).split())


def test_a_length_called_l_and_a_speed_called_v(problem: Callable[[str], Problem]) -> None:
    """The Lagrangian and the potential energy have other letters, and the same ones in all steps."""
    chain = """title: A chain
parameters: [rho, L, g]
coordinates: [x]
lagrangian: "rho*L*x'^2/2 + rho*g*x^2/2"
"""
    assert "The Lagrangian is given: Λ = ½ L ρ ẋ² + ½ g ρ x² (1)" in page(problem(chain))
    spring = """title: A spring
parameters: {m: positive, k: positive, V: positive, l: positive, c: positive}
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {s: {spring: k, between: [O, P], length: l}, drag: {on: P, vector: c*V*i}}
find: [equilibrium]
"""
    found = page(problem(spring))
    assert "The potential energy is U = ½ k" in found
    assert "All forces together have the potential Π = ½ k [" in found  # U is that of the spring alone
    assert "an equilibrium is stable if Π has a strict minimum there" in found
    assert "with the force c V at (9) and −c V at (10)" in found  # and not k [(c V + k l)/k − l]


def test_weights_that_the_file_numbers_are_weights() -> None:
    assert [force_called(n) for n in ("weight_1", "weight2", "weights")] == [
        "its weight", "its weight", "the weights force"]  # fmt: skip


def test_the_friction_of_a_body_needs_no_name_and_its_normal_force_is_explained_once() -> None:
    wedge = reported("rough-wedge", complete=False)
    found = " ".join(terminal.text(wedge.derivation, wedge.notation, 100).split())
    assert "are its weight and the friction:" in found
    assert found.count("The friction contains N") == 1


# Remarks


PUSHED = """
title: Pushed
parameters: {m: positive, g: positive, beta: VALUE}
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {push: {on: P, vector: m*g*FACTOR*i}}
"""


@pytest.mark.parametrize(
    ("value", "factor", "codes"),
    [("30", "cos(beta)", ["angle-in-radians"]), ("30 deg", "cos(beta)", []), ("1", "cos(beta)", []),
     ("30", "beta*cos(beta)", [])],
)  # fmt: skip
def test_a_bare_angle_of_several_turns_is_noted(value: str, factor: str, codes: list[str]) -> None:
    text = PUSHED.replace("VALUE", value).replace("FACTOR", factor)
    found = remarks(solve(read_problem(Source("pushed.yaml", text))), Method.DALEMBERT)
    assert [d.code for d in found] == codes
