"""Minima at which the second variation vanishes in one direction: the potential along the valley decides.

Let V'' be positive definite in all coordinates r but one, z, and singular as a whole. Then ∂V/∂r = 0 has one solution
r(z) near the equilibrium, the bottom of a valley, and V has a strict minimum there if and only if

    g(z) = V(z, r(z))

has one (splitting lemma): V = c (x⁴ + y²) has the valley y = 0 with g = c x⁴. Since g' = ∂V/∂z on the valley, r(z) and
g' follow power by power from the derivatives of V at the equilibrium; the first that does not vanish decides.
In more directions V is decided only where it has no other terms than c Π q_j^(2n_j) with c > 0, q measured from the
equilibrium, and among them a power of each coordinate alone: V = c (x⁴ + y⁴) is a strict minimum by itself.

Reference: Poston and Stewart, Catastrophe Theory and its Applications, ch. 4.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations_with_replacement
from math import factorial, prod

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition, sign_of
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.mechanics.equilibrium.limits import HIGHEST_ORDER, LONGEST_DEGENERATE, MOST_IN_A_VALLEY


@record
class UniformMotion:
    """Stable but for a motion in which V stays the same (`linear_stability`), where the conditions hold.

    coordinates  those that change in it
    others       those in which V has a strict minimum
    several      whether there are several such motions
    """

    coordinates: tuple[sp.Symbol, ...]
    others: tuple[sp.Symbol, ...]
    conditions: tuple[SignCondition, ...] = ()
    several: bool = False


def along_valley(
    matrix: Sequence[Sequence[sp.Expr]],
    z: int,
    along: Callable[[sp.Expr, int], sp.Expr],
    at_rest: Callable[[sp.Expr], sp.Expr | None],
) -> Iterator[tuple[int, sp.Expr]]:
    """The order and the value of the derivatives g⁽ⁿ⁾, n = 3, 4, ...; ends where one is not known.

    matrix   V'', shape (f, f), regular at the equilibrium without row and column z
    along    the derivative of an expression by a free coordinate
    at_rest  the value of an expression at the equilibrium; None if it cannot be written
    """
    size = len(matrix)
    if size > MOST_IN_A_VALLEY:
        return
    formed: dict[tuple[int, tuple[int, ...]], sp.Expr] = {}

    def derivative(k: int, by: tuple[int, ...]) -> sp.Expr | None:
        formed[k, by] = matrix[k][by[0]] if len(by) == 1 else along(formed[k, by[:-1]], by[-1])
        return at_rest(formed[k, by])

    others = [k for k in range(size) if k != z]
    t = sp.Dummy("z", real=True)
    place: list[sp.Expr] = [t if k == z else sp.S.Zero for k in range(size)]
    slopes: dict[int, sp.Expr] = dict.fromkeys(range(size), sp.S.Zero)
    second: dict[tuple[int, int], sp.Expr] = {}
    terms: dict[int, list[tuple[tuple[int, ...], sp.Expr]]] = {k: [] for k in range(size)}
    for degree in range(1, HIGHEST_ORDER):
        for k in range(size):
            for by in combinations_with_replacement(range(size), degree):
                value = derivative(k, by)
                if value is None or count_operations(value) > LONGEST_DEGENERATE:
                    return
                if value != 0:
                    multiple = prod(factorial(by.count(j)) for j in set(by))
                    terms[k].append((by, value / multiple))
                if degree == 1:
                    second[k, by[0]] = value
        # r(z) to the power z^degree makes ∂V/∂r vanish to that power.
        for k in range(size):
            slopes[k] = _power(terms[k], place, t, degree)
        inner = sp.Matrix([[second[i, j] for j in others] for i in others])
        step = inner.LUsolve(sp.Matrix([-slopes[k] for k in others]))
        for k, a in zip(others, step, strict=True):
            place[k] += sp.factor(a) * t**degree
        if degree >= 2:
            yield degree + 1, sp.factor(_power(terms[z], place, t, degree) * factorial(degree))


def _power(
    terms: Sequence[tuple[tuple[int, ...], sp.Expr]], place: Sequence[sp.Expr], t: sp.Symbol, degree: int
) -> sp.Expr:
    """The coefficient of t^degree of a polynomial at a place that is a polynomial in t."""
    total: sp.Expr = sp.S.Zero
    for by, value in terms:
        total += value * sp.expand(sp.Mul(*(place[j] for j in by))).coeff(t, degree)
    return sp.expand(total)


def rises_in_even_powers(gradient: Sequence[sp.Expr], place: Sequence[tuple[sp.Symbol, sp.Expr]]) -> bool:
    """Whether V is a sum of even powers with positive coefficients at a place; False where that is not seen.

    gradient  ∂V/∂q_k, k = 1, ..., n
    place     q_k and its value at the equilibrium
    """
    symbols = [q for q, _ in place]
    shifted = {q: q + value for q, value in place}
    for k, slope in enumerate(gradient):
        alone = False
        if count_operations(slope) > LONGEST_DEGENERATE:
            return False
        try:
            terms = sp.Poly(slope.xreplace(shifted), *symbols).terms()
        except sp.PolynomialError:
            return False
        for powers, value in terms:
            if sign_of(value) != 1 or any((n + (j == k)) % 2 for j, n in enumerate(powers)):
                return False
            alone = alone or sum(powers) == powers[k]
        if not alone:
            return False
    return True
