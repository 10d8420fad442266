"""What a choice knows only through its velocities is put into its equations of motion."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
import sympy as sp

import lagrange
from lagrange.answers.answer_readings import read_answer
from lagrange.core.diagnostics import Fragment
from lagrange.explain.report import report
from lagrange.mechanics.solution import ChoiceSolution, Method, solve
from lagrange.problem.model import Problem
from lagrange.render import latex
from lagrange.render.json import as_object

Read = Callable[[str], Problem]

LIBRARY = Path(__file__).parent.parent / "problems" / "motion"

DRUM = """
title: A bucket on a drum
parameters: [m, J, R, g, kappa]
coordinates: [y, phi]
particles: {P: {mass: m, position: y*j}}
bodies: {drum: {inertia: J, position: 0*i, angle: phi}}
constraints: {string: "R*phi' = y'"}
gravity: g*j
generalized_coordinates: {depth: {coordinates: [y]}}
"""

DISC = """
title: Rolling disc, upright
parameters: [m, A, C, R, F]
coordinates: [x, y, theta, phi]
let: {n: sin(theta)*i - cos(theta)*j}
bodies:
  disc: {mass: m, inertia: [A, A, C], position: x*i + y*j + R*k, axes: ["cross(k, n)", k, n],
         angular_velocity: "theta'*k + phi'*n"}
constraints: {along: "x' = R*phi'*cos(theta)", across: "y' = R*phi'*sin(theta)"}
forces: {push: {on: disc, vector: F*i}}
generalized_coordinates: {angles: {coordinates: [theta, phi]}}
"""


def final(problem: Problem, method: Method = Method.DALEMBERT) -> tuple[list[sp.Expr], list[str]]:
    """The equations of the only choice, and the names of the constraints that complete them; all checks hold."""
    solution = solve(problem, method=method)
    assert solution.holds
    [choice] = solution.choices
    assert isinstance(choice, ChoiceSolution)
    assert choice.motion is not None
    return [e.expression for e in choice.motion.final], [r.name for r in choice.motion.completing]


@pytest.mark.parametrize("method", [*Method])
@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        (
            "planetary-gear",
            [
                "phi''*(4*J_0*s^2*(r + s)^2 + J_1*r^2*(r + s)^2 + r^2*s^2*(J_2 + m*(r + s)^2))"
                " - r*s^2*(2*M_0*s - r*(L - 2*M_0))"
            ],
        ),
        (
            "swinging-yo-yo",
            [
                "(m*r^2 + I_G)*s'' - r*(m*r^2 + I_G)*phi'' - m*r^2*s*phi'^2 - m*g*r^2*cos(phi)",
                "r*(m*(s^2 + r^2) + I_G)*phi'' - (m*r^2 + I_G)*s'' + 2*m*r*s*s'*phi' + m*g*r*s*sin(phi)"
                " + m*g*r^2*cos(phi)",
            ],
        ),
    ],
)
def test_equations_are_in_the_chosen_coordinates(name: str, wanted: list[str], method: Method) -> None:
    problem = lagrange.load(LIBRARY / f"{name}.yaml")
    found, completing = final(problem, method)
    assert completing == []
    for e, text in zip(found, wanted, strict=True):
        [read] = read_answer(Fragment.of(text + " = 0"), problem.scope).components
        assert sp.expand(e - read) == 0


def test_a_gear_is_written_by_its_parts() -> None:
    """Each share of the inertia in factors: not J_1 r⁴ + 2 J_1 r³ s + ..."""
    [equation], _ = final(lagrange.load(LIBRARY / "planetary-gear.yaml"))
    assert "4*J_0*s**2*(r + s)**2" in str(equation)
    assert "J_1*r**2*(r + s)**2" in str(equation)


def test_a_disc_that_rolls_needs_no_place(problem: Read) -> None:
    """x'' and y'' have velocities in them, which cancel."""
    found, completing = final(problem(DISC))
    assert [str(e) for e in found] == ["theta''", "-F*R*cos(theta) + phi''*(C + R**2*m)"]
    assert completing == []


def test_a_position_that_is_left_is_completed_by_its_constraint(problem: Read) -> None:
    """A spiral spring on the drum: φ stays, φ'' does not."""
    spring = "forces: {spiral: {potential: kappa*phi^2/2}}\n"
    [plain], completing = final(problem(DRUM))
    assert "phi" not in {s.name for s in plain.free_symbols}
    assert completing == []
    [sprung], completing = final(problem(DRUM + spring))
    assert {"phi", "y''"} <= {s.name for s in sprung.free_symbols}
    assert {"phi'", "phi''"}.isdisjoint(s.name for s in sprung.free_symbols)
    assert completing == ["string"]


def test_finite_relations_that_cannot_be_solved_stay(problem: Read) -> None:
    """cos ψ = ... is not solved for ψ: the equations keep ψ'', and the constraint beside them."""
    text = DRUM.replace("R*phi' = y'", "y = R*(phi + sin(phi))").replace("R*phi'", "R*phi")
    [equation], completing = final(problem(text))
    assert "phi''" in {s.name for s in equation.free_symbols}
    assert completing == ["string"]


def test_what_is_put_in_is_said(problem: Read) -> None:
    told = report(problem(DRUM))
    text = latex.render([(told.derivation, told.notation)])
    shown = text[text.index("Equation of motion: depth") :]
    for line in (
        "gives, solved for the velocities and differentiated,",
        r"\dot{\phi} = \frac{\dot{y}}{R}",
        r"\ddot{\phi} = \frac{\ddot{y}}{R}",
        "Put in, this leaves (multiplying by $R$):",
        r"\boxed{(m R^{2} + J) \ddot{y} - m g R^{2} = 0}",
    ):
        assert line in shown.replace("&", "")
    [choice] = as_object(told)["choices"]
    assert choice["equations"] == ["(m*R^2 + J)*y'' - m*g*R^2 = 0"]
    assert choice["through_velocities"] == {"phi'": "y'/R"}


def test_python_has_the_same(problem: Read) -> None:
    found = lagrange.solve(problem(DRUM))["depth"]
    assert [str(e) for e in found.equations] == ["-R**2*g*m + y''*(J + R**2*m)"]
