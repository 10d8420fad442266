"""Constraints, their notes and their reactions."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import t
from lagrange.problem.model import Keeper
from tests.support.problem_texts import HEAD, places, read

x, y, theta = (sp.Symbol(n, real=True) for n in ("x", "y", "theta"))
v, w, om = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'"))
m, l, g, k, c, F, R, mu, A, C, I_G = sp.symbols("m l g k c F R mu A C I_G", positive=True)


CONSTRAINTS: dict[str, tuple[sp.Expr, bool]] = {
    "x^2 + y^2 = l^2": (x**2 + y**2 - l**2, False),
    "{equation: x = 0}": (x, False),
    "\"x' - R*theta' = 0\"": (v - R * om, True),
    "sin(theta)*d(x) - cos(theta)*d(y) = 0": (sp.sin(theta) * v - sp.cos(theta) * w, True),
    "x*d(x) = l*d(t)": (x * v - l, True),
    "d(x) = t*d(y)": (v - t * w, True),
    "y = x*tan(theta)": (y - x * sp.tan(theta), False),
    "x == y": (x - y, False),
    "\"(x' + 1)*x = x'*x\"": (x, False),
}


@pytest.mark.parametrize("text", CONSTRAINTS)
def test_constraint(text: str) -> None:
    constraint = read(f"{HEAD}constraints: {{rod: {text}}}\n").constraints[0]
    expected, kinematic = CONSTRAINTS[text]
    assert sp.expand(constraint.function - expected) == 0
    assert constraint.kinematic is kinematic
    assert (constraint.name, constraint.reaction) == ("rod", sp.Symbol("lambda_rod", real=True))


def test_notes_and_reactions_of_constraints() -> None:
    problem = read(
        f"{HEAD}constraints: {{no_slip: {{equation: \"x' = R*theta'\", reaction: N, note: 'It  rolls'}}, no: y = 0}}\n"
    )
    rolling, no = problem.constraints
    assert (rolling.reaction.name, rolling.note) == ("N", "It rolls")
    assert (no.name, no.reaction.name) == ("no", "lambda_no")
    assert problem.scope.scalars["N"] == sp.Symbol("N", real=True)


def test_a_vector_constraint_counts_as_its_components() -> None:
    problem = read(f"{HEAD}constraints:\n  hinge: {{equation: '[x, y, 0] = [l, x, 0]', reaction: N}}\n")
    assert [(c.name, c.function, c.reaction.name) for c in problem.constraints] == [
        ("hinge.1", x - l, "N_1"),
        ("hinge.2", y - x, "N_2"),
    ]


def test_identical_components_of_a_vector_constraint_do_not_count() -> None:
    problem = read(f"{HEAD}constraints:\n  a: '[x, sin(x)^2 + cos(x)^2, y] = [0, 1, l]'\n")
    assert [c.name for c in problem.constraints] == ["a.1", "a.3"]
    assert places(f"{HEAD}constraints:\n  a: '[1, sin(x)^2] = [1, 1 - cos(x)^2]'\n") == [("restricts-nothing", 5, 6)]
    assert places(f"{HEAD}constraints:\n  a: '[x, m] = [0, l]'\n") == [("restricts-nothing", 5, 6)]


def test_what_keeps_a_constraint() -> None:
    by = f"{HEAD}constraints: {{rod: {{equation: x = l, by: WORD}}}}\n"
    assert [c.by for c in read(by.replace("WORD", "string")).constraints] == [Keeper.STRING]
    assert read(f"{HEAD}constraints: {{rod: x = l}}\n").constraints[0].by is None
    assert places(by.replace("WORD", "rubber")) == [("unknown-keeper", 4, 42)]
