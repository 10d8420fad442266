"""Unsolved equations: whether they have a real solution at all, and where they hold without being what was asked."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.existence import real_branches
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import TrigLetters

theta, phi, beta, gamma, x, y = sp.symbols("theta phi beta gamma x y", real=True)
a, b, p, q, k, m, g, l = sp.symbols("a b p q k m g l", positive=True)
sin, cos, sqrt = sp.sin, sp.cos, sp.sqrt


def unsolved(equations: list[sp.Expr]) -> list[Branch]:
    unknowns = [u for u in (theta, phi, beta, gamma, x, y) if any(u in e.free_symbols for e in equations)]
    return [branch for branch in solutions(equations, unknowns).branches if branch.left]


NEVER = [
    [1 + sin(theta) * cos(phi), 5 * sin(theta) - 8 * sin(theta) * cos(theta) + 4 * cos(theta) * cos(phi)],
    [2 * sin(beta) - sin(gamma), 2 * cos(beta) - 5 - cos(gamma)],
    [a * cos(beta) + a * cos(gamma) - 3 * a, a * sin(beta) + a * sin(gamma) - q],
    [2 + sqrt(5 - 4 * sin(theta)) ** 3],
    [x**6 - x + 3],
    [x**4 * y**2 + x**2 + y**4 + k],
    [3 * k + k * sin(theta) ** 2 * cos(phi) ** 3 - k * sin(theta) * cos(phi) ** 2 - k * sin(phi) ** 5],
    [x**3 * y - 5 + sin(phi), x**3 * y + 5 - cos(phi)],
    [x**2 * sin(phi) + x - 7 - cos(phi) ** 3, x**2 + 2 + sin(phi)],
]
SOMEWHERE = [
    [x**5 - x - 1],
    [m * g * cos(theta) ** 3 + k * sin(theta) - m * g * sin(theta) * cos(theta) ** 2 / 5],
    [sqrt(2) * cos(theta) - sqrt(2 - sin(theta)) ** 3 * sin(theta)],
    [x**4 + x**3 - 3 + sqrt(x**2 + 1)],
    [cos(theta) ** 5 - 3 * cos(theta) + sin(theta) + 1],
    [k * (theta - p) + m * g * cos(theta)],
    [k * x**5 + a * x**2 - sin(theta) + b],
]
OPEN = [
    [k * x**4 + a * x - b * cos(theta)],
    [(a - b) * x**5 + k * x**2 + m],
    [a * cos(theta) ** 3 + b * sin(theta) ** 3 * cos(theta) + p],
    [k * theta - m * g * l * sin(theta)],
]


@pytest.mark.parametrize("equations", NEVER, ids=str)
def test_equations_without_a_real_solution_are_no_branch(equations: list[sp.Expr]) -> None:
    assert not solutions(equations, sorted({theta, phi, beta, gamma, x, y}, key=str)).branches


@pytest.mark.parametrize("equations", SOMEWHERE, ids=str)
def test_a_change_of_sign_is_a_solution(equations: list[sp.Expr]) -> None:
    assert [branch.occupied for branch in unsolved(equations)] == [True]


@pytest.mark.parametrize("equations", OPEN, ids=str)
def test_what_parameters_leave_open_stays_open(equations: list[sp.Expr]) -> None:
    assert [branch.occupied for branch in unsolved(equations)] == [False]


def test_two_links_close_as_a_triangle_does() -> None:
    """a = 1, b = 3, p = 1, q = 1: no triangle has the sides 1, 3 and √2."""
    [branch] = unsolved([a * cos(beta) + b * cos(gamma) - p, a * sin(beta) - b * sin(gamma) - q])

    assert branch.occupied
    assert branch.closing

    def closes(*sides: int) -> bool:
        at = dict(zip((a, b, p, q), map(sp.Integer, sides), strict=True))
        assert {c.relation for c in branch.conditions} == {"≥"}
        return all((c.lhs - c.rhs).subs(at) >= 0 for c in branch.conditions)

    assert [closes(1, 3, 1, 1), closes(1, 3, 3, 1), closes(3, 1, 1, 1), closes(1, 1, 1, 1), closes(1, 1, 2, 1)] == [
        False, True, False, True, False
    ]  # fmt: skip


def test_a_pole_at_which_the_multiplied_equation_holds_is_excluded() -> None:
    """√2 cos θ/(1 − sin θ)^(3/2) − sin θ at θ = π/2."""
    force = sqrt(2) * cos(theta) / sqrt(1 - sin(theta)) ** 3 - sin(theta)
    multiplied = sqrt(2) * cos(theta) - sqrt(1 - sin(theta)) ** 3 * sin(theta)
    [branch] = solutions([multiplied], [theta], origin=[force]).branches
    assert [(c.lhs - c.rhs, c.relation) for c in branch.conditions] == [(sin(theta) - 1, "≠")]
    assert branch.occupied


def test_a_pole_at_which_it_does_not_hold_is_not_mentioned() -> None:
    force = 1 / sqrt(1 - sin(theta)) ** 3 - sin(theta) * cos(theta)
    multiplied = 1 - sqrt(1 - sin(theta)) ** 3 * sin(theta) * cos(theta)
    branches = solutions([multiplied], [theta], origin=[force]).branches
    assert all(not branch.conditions for branch in branches)


def test_what_cannot_be_read_in_letters_stays_open() -> None:
    """A fourth root of an unknown is left by an elimination; its branch stays open."""
    x = sp.Symbol("x", real=True)
    branch = Branch((), left=((1 / x) ** sp.Rational(1, 4) - x - 1,))
    assert real_branches([branch], TrigLetters([x], [x])) == [branch]


@pytest.mark.parametrize(
    ("equation", "exists"),
    [
        (a * sin(theta) - b * theta * cos(theta), True),  # tan θ = (b/a) θ between π and 3π/2
        (a * cos(theta) - b * theta * (2 + sin(theta)), True),
        (a * sin(theta) - b * theta, False),  # only for a > b, or for large angles: left open
    ],
)
def test_an_angle_outside_sines_and_cosines(equation: sp.Expr, exists: bool) -> None:
    [branch] = unsolved([equation])
    assert branch.occupied is exists
