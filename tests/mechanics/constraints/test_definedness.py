"""Statements that exist nowhere on the surface of the constraints, and problems that used to end in an exception."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError
from lagrange.core.diagnostics import ProblemError, UndecidedError
from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.definedness import check_defined, explained_failures
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]

HEAD = """title: Example
parameters: [m, g, c, l, mu]
coordinates: [x, y]
"""
PARTICLE = "particles: {P: {mass: m, position: x*i + y*j}}\n"
FLOOR = "constraints: {floor: y = 0}\n"
ONE = "(sin(x)^2 + cos(x)^2 - 1)"


def check(problem: Problem) -> None:
    check_defined(problem, classify(problem).constrained)


@pytest.mark.parametrize(
    ("more", "line", "message"),
    [
        (PARTICLE + FLOOR + "forces: {f: {potential: c/y}}", 6, "the force `f` divides by `y`"),
        (PARTICLE + FLOOR + "forces: {f: {potential: c*sqrt(y)}}", 6, "the force `f` divides by `y`"),
        (PARTICLE + FLOOR + "forces: {f: {potential: c*log(y)}}", 6, "the force `f` divides by `y`"),
        (PARTICLE + FLOOR + "forces: {f: {friction: mu/y, constraint: floor, on: P}}", 6, "divides by `y`"),
        (PARTICLE + FLOOR + "speeds: {u: \"x'/y\"}", 6, "the quasi-velocity `u` divides by `y`"),
        (PARTICLE + f"gravity: g/{ONE}*j", 5, "`gravity` divides by"),
        (PARTICLE + f"forces: {{f: {{on: P, vector: i/{ONE}}}}}", 5, "the force `f` divides by"),
        (f"particles: {{P: {{mass: m, position: x*i + y/{ONE}*j}}}}", 4, "the position of `P` divides by"),
        (PARTICLE + f"generalized_coordinates: {{c: {{coordinates: [s], substitute: {{x: s, y: s/{ONE.replace('x', 's')}}}}}}}",
         5, "the substitution for `y` in the choice `c` divides by"),
        (PARTICLE + FLOOR + "forces: {f: {spring: c, between: [P, x*i], length: l}}", 6, "has no direction"),
    ],
)  # fmt: skip
def test_what_exists_nowhere_is_reported_at_its_place(problem: Read, more: str, line: int, message: str) -> None:
    with pytest.raises(ProblemError) as caught:
        check(problem(HEAD + more))
    [finding] = caught.value.diagnostics
    assert message in finding.message
    assert finding.span is not None
    assert finding.span.source.position(finding.span.start)[0] == line


@pytest.mark.parametrize(
    "more",
    [
        "forces: {f: {potential: c/x}}",  # singular at single points only
        "forces: {f: {potential: c/(y + 1)}}",
        "forces: {f: {spring: c, between: [P, x*i]}}",  # of rest length 0: c y²/2
        "forces: {f: {spring: c, between: [P, 0*i], length: l}}",
    ],
)
def test_what_exists_is_not(problem: Read, more: str) -> None:
    check(problem(HEAD + PARTICLE + FLOOR + more))


def test_failures_of_the_algebra_are_errors_about_the_file(problem: Read) -> None:
    file = problem(HEAD + PARTICLE + "forces: {f: {potential: c/x}}")
    x = file.slots.coordinates[0]
    with pytest.raises(ProblemError, match="the equations divide by `x`") as caught, explained_failures(file):
        raise DivisionByZeroError(x)
    assert caught.value.diagnostics[0].span is not None
    for error in (UnsupportedError("Piecewise is not evaluated exactly"), NoPointError()):
        with pytest.raises(UndecidedError), explained_failures(file):
            raise error
    with pytest.raises(sp.PolynomialError), explained_failures(file):
        raise sp.PolynomialError


@pytest.mark.parametrize("wall", ["y = abs(x)", "y = cos(sqrt(2*x^2))"])
def test_moduli_are_differentiated_twice(problem: Read, wall: str) -> None:
    """On y = |x|, y'' is sign(x) x'': they ended in Derivative(sign(x), x)."""
    found = solve(problem(f"{HEAD}{PARTICLE}constraints: {{wall: {wall}}}\ngravity: -g*j\n"), complete=False)
    assert found.holds
