"""Constraints together: contradictory, redundant, degenerate."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError, Source, Span
from lagrange.core.effort import allowed
from lagrange.core.symbols import Slots
from lagrange.mechanics.constraints.constraints import constraint_row
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Constraint, Problem
from lagsolve.exit_statuses import status_of_error

Read = Callable[[str], Problem]


def refusal(problem: Problem) -> tuple[str, str, int]:
    """Code, message and exit status of the one thing that is wrong."""
    with pytest.raises(ProblemError) as caught:
        solve(problem)
    [found] = caught.value.diagnostics
    assert found.span is None or found.span.end > found.span.start
    return found.code, str(found), status_of_error(caught.value)


@pytest.mark.parametrize(
    ("constraints", "named"),
    [
        ("{a: x = 0, b: x = 1}", ("`a`", "`b`")),
        ("{a: x = 0, b: y = 2, c: x + y = 1}", ("`a`", "`b`", "`c`")),
        ('{a: "x\' = 0", b: "x\' = t"}', ("`a`", "`b`")),
        ("{a: \"x' + y' = 1\", b: \"2*x' + 2*y' = 3\"}", ("`a`", "`b`")),
    ],
)
def test_contradictory_constraints_are_named(problem: Read, constraints: str, named: tuple[str, ...]) -> None:
    text = f"title: T\ncoordinates: [x, y]\nconstraints: {constraints}\nfind: constraints\n"
    code, message, status = refusal(problem(text))
    assert (code, status) == ("contradictory-constraints", 2)
    assert all(n in message for n in named)


@pytest.mark.parametrize("equation", ["x^3 = c", "x^4 = 2", "x^5 + x = c", "tan(x) = c", "exp(x) = 2"])
def test_satisfiable_constraints_are_no_contradiction(problem: Read, equation: str) -> None:
    text = f"title: T\nparameters: [c]\ncoordinates: [x, y]\nconstraints: {{k: '{equation}'}}\n"
    assert solve(problem(text)).classification.degrees_of_freedom == 1


def test_a_constraint_whose_differential_vanishes_is_refused(problem: Read) -> None:
    text = "title: T\ncoordinates: [x, y]\nconstraints: {k: sin(x) = 1}\n"
    assert refusal(problem(text))[0] == "singular-constraint"


def test_a_redundant_constraint_is_named_and_not_counted(problem: Read) -> None:
    text = "title: T\ncoordinates: [x, y, z]\nconstraints: {a: x = y, b: y = z, c: x = z}\n"
    found = solve(problem(text)).classification
    assert found.redundant == ("c",)
    assert (found.rank, found.degrees_of_freedom, found.configuration_dimension) == (2, 1, 1)


def test_a_derivative_of_nested_functions_is_not_multiplied_out() -> None:
    """The derivative of tanh(tanh(...q')) has a factor 1 − tanh² for each: 2²⁰ terms. A square of q' that cancels is found."""
    x, y = sp.symbols("x y", real=True)
    slots, rest = Slots((x, y)), (True, sp.Symbol("lambda_a"), Span(Source("a", ""), 0, 0))
    u, v = slots.velocities
    nested = u
    for _ in range(20):
        nested = sp.tanh(nested)
    with allowed(10_000):
        assert constraint_row(Constraint("a", v, nested, *rest), slots).nonlinear is not None
    square = v + (u + v) * (u - v) + v**2
    row = constraint_row(Constraint("a", square, u * (u + 2 * x), *rest), slots)
    assert (row.nonlinear, row.coefficients) == (None, (-2 * x, 1))
