"""Polynomials in the velocities, and where a quadratic one vanishes.

    φ = Σ_ij M_ij u_i u_j ,    u = (q_1', ..., q_k', 1),    M symmetric, functions of q and t.

Completing squares repeatedly gives φ = Σ d_r ℓ_r², with affine forms ℓ_r in the velocities. If all d_r have one sign,
φ = 0 if and only if every ℓ_r vanishes. Two squares of opposite sign are a product of two affine forms: two branches.
Three squares of both signs are a cone or a hyperboloid, which no affine forms describe.

Reference: any book on linear algebra under Lagrange's reduction, and Sylvester's law of inertia.

How a constraint is reduced (`nonlinear_constraints`): the steps, each an equivalence, and the alternatives.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence, Set
from enum import StrEnum

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.forms.limits import HIGHEST_VELOCITY_DEGREE, MOST_VELOCITY_TERMS
from lagrange.algebra.fourier.terms import common_factor, normalised
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Slots

Monomial = tuple[int, ...]
Polynomial = dict[Monomial, sp.Expr]
ZeroTest = Callable[[sp.Expr], bool | None]


def polynomial(expression: sp.Expr, velocities: Sequence[sp.Symbol], is_zero: ZeroTest) -> Polynomial | None:
    """Exponents of the velocities -> coefficient, free of velocities and not zero.

    None if it is not a polynomial, or exceeds MOST_VELOCITY_TERMS or HIGHEST_VELOCITY_DEGREE.
    """
    try:
        expanded = _expanded(expression, velocities)
    except _NotPolynomialError:
        return None
    return {m: c for m, c in expanded.items() if c != 0 and is_zero(c) is not True}


class _NotPolynomialError(Exception):
    """It is not a polynomial, or it is too long."""


def _expanded(e: sp.Expr, velocities: Sequence[sp.Symbol]) -> Polynomial:
    constant = (0,) * len(velocities)
    if e in velocities:
        return {tuple(int(v == e) for v in velocities): sp.S.One}
    if e.free_symbols.isdisjoint(velocities):
        return {constant: e}
    if e.is_Add:
        return _sum([_expanded(a, velocities) for a in e.args])
    if e.is_Mul:
        product: Polynomial = {constant: sp.S.One}
        for factor in e.args:
            product = _product(product, _expanded(factor, velocities))
        return product
    if e.is_Pow and e.exp.is_Integer and 0 < e.exp <= HIGHEST_VELOCITY_DEGREE:
        base, power = _expanded(e.base, velocities), {constant: sp.S.One}
        for _ in range(int(e.exp)):
            power = _product(power, base)
        return power
    raise _NotPolynomialError


def _sum(parts: Sequence[Polynomial]) -> Polynomial:
    total: dict[Monomial, list[sp.Expr]] = {}
    for part in parts:
        for monomial, coefficient in part.items():
            total.setdefault(monomial, []).append(coefficient)
    return {m: sp.Add(*cs) for m, cs in total.items()}


def _product(a: Polynomial, b: Polynomial) -> Polynomial:
    if len(a) * len(b) > MOST_VELOCITY_TERMS**2:
        raise _NotPolynomialError
    pairs = [
        {tuple(i + j for i, j in zip(m, n, strict=True)): c * d} for m, c in a.items() for n, d in b.items()
    ]  # fmt: skip
    product = _sum(pairs)
    if len(product) > MOST_VELOCITY_TERMS or any(sum(m) > HIGHEST_VELOCITY_DEGREE for m in product):
        raise _NotPolynomialError
    return product


def degree(p: Polynomial) -> int:
    """The degree in the velocities."""
    return max((sum(m) for m in p), default=0)


def is_definite(p: Polynomial) -> bool:
    """Whether a form of one degree in two velocities, with numbers for coefficients, is zero at zero only.

    Σ c_k u^k v^(n−k) is so when Σ c_k s^k has n as its degree and no real zero, by Sturm's theorem.
    """
    highest = degree(p)
    if any(len(m) != 2 or sum(m) != highest or not c.is_Rational for m, c in p.items()):
        return False
    return (highest, 0) in p and sp.Poly({(m[0],): c for m, c in p.items()}, sp.Dummy()).count_roots() == 0


def polynomial_as_sum(p: Polynomial, velocities: Sequence[sp.Symbol]) -> sp.Expr:
    """A polynomial as a sum."""
    powers = (sp.Mul(*(v**e for v, e in zip(velocities, m, strict=True))) for m in p)
    return sp.Add(*(textbook_form(c) * power for c, power in zip(p.values(), powers, strict=True)))


def without_content(form: sp.Expr) -> sp.Expr:
    """An affine form without denominators and without what its terms have in common: x'/r + y'/r is x' + y'."""
    tidied = textbook_form(form)
    return normalised(textbook_form(common_factor(tidied).divide(tidied)))


@record
class Square:
    """One term d ℓ² of a quadratic polynomial: d is `factor`, ℓ is `form`, affine in the velocities."""

    factor: sp.Expr
    form: sp.Expr


def squares(p: Polynomial, velocities: Sequence[sp.Symbol], is_zero: ZeroTest) -> tuple[Square, ...] | None:
    """A quadratic polynomial as a sum of squares, as many as its rank. None if a zero could not be decided.

    Where no velocity is squared, the product of two counts as a difference of squares: 4 a b = (a + b)² − (a − b)².
    """
    u = (*velocities, sp.S.One)
    matrix = _matrix(p, len(u))
    left = list(range(len(u)))
    terms: list[Square] = []
    while True:
        zeros = {(i, j): is_zero(matrix[i][j]) for i in left for j in left if i <= j}
        if None in zeros.values():
            return None
        # squares before products, velocities before the constant, numbers before functions
        nonzero = [place for place, zero in zeros.items() if not zero]
        ranked = [(i != j, i == len(u) - 1, not matrix[i][j].is_number, i, j) for i, j in nonzero]
        if not ranked:
            return tuple(terms)
        *_, i, j = min(ranked)
        left = [k for k in left if k not in (i, j)]
        terms += _square(matrix, i, left, u) if i == j else _product_of_two(matrix, i, j, left, u)


def _matrix(p: Polynomial, size: int) -> list[list[sp.Expr]]:
    """M, shape (size, size); the last of the u is 1."""
    matrix = [[sp.S.Zero] * size for _ in range(size)]
    for monomial, coefficient in p.items():
        places = [k for k, e in enumerate(monomial) for _ in range(e)]
        i, j = (*places, size - 1, size - 1)[:2]
        matrix[i][j] += coefficient / 2
        matrix[j][i] += coefficient / 2
    return matrix


def _square(matrix: list[list[sp.Expr]], i: int, left: Sequence[int], u: Sequence[sp.Expr]) -> list[Square]:
    """M_ii (u_i + Σ_k M_ik u_k/M_ii)², taken off the matrix."""
    pivot = matrix[i][i]
    row = {k: sp.cancel(matrix[i][k] / pivot) for k in left}
    for k in left:
        for m in left:
            matrix[k][m] = sp.cancel(matrix[k][m] - pivot * row[k] * row[m])
    return [Square(pivot, sp.Add(u[i], *(c * u[k] for k, c in row.items())))]


def _product_of_two(
    matrix: list[list[sp.Expr]], i: int, j: int, left: Sequence[int], u: Sequence[sp.Expr]
) -> list[Square]:
    """2 M_ij a b with a = u_i + Σ M_jk u_k/M_ij and b = u_j + Σ M_ik u_k/M_ij, taken off the matrix."""
    pivot = matrix[i][j]
    of_a, of_b = ({k: sp.cancel(matrix[n][k] / pivot) for k in left} for n in (j, i))
    for k in left:
        for m in left:
            matrix[k][m] = sp.cancel(matrix[k][m] - pivot * (of_a[k] * of_b[m] + of_a[m] * of_b[k]))
    a, b = (sp.Add(u[n], *(c * u[k] for k, c in of.items())) for n, of in ((i, of_a), (j, of_b)))
    return [Square(pivot / 2, a + b), Square(-pivot / 2, a - b)]


# -- Whether a constraint is affine in the velocities, a(q, t) · q' + b(q, t), decided without multiplying out ---------
#
# The function is a polynomial in the velocities and in whatever depends on them in another way, sin q' say. Where its
# degree as written is one, it is affine. Otherwise terms may cancel, (q₁' + q₂')² − q₁'² − 2 q₁' q₂' − q₂'²: the
# coefficients are read off at random velocities, and the form they make is compared at others (Schwartz, Zippel).
# Rows of
# a bicycle have some thousand terms when they are multiplied out.


def is_affine(function: sp.Expr, slots: Slots) -> bool:
    """Whether a function is written as one that is affine in the velocities, or can be by multiplying out."""
    moving = frozenset(slots.velocities)
    written = _AsPolynomial(moving)
    polynomial = written.of(function)
    if written.degree(polynomial) <= 1 and not written.others:
        return True
    unknowns = [*sorted(moving & polynomial.free_symbols, key=str), *written.others.values()]

    def affine(point: Point) -> bool:
        row = point.affine([polynomial], unknowns)
        return row is not None and all(map(point.arithmetic.vanishes, row[0][len(unknowns) - len(written.others) : -1]))

    try:
        return all(Surface().sampled(affine))
    except (UnsupportedError, DivisionByZeroError, NoPointError):
        return False


class _AsPolynomial:
    """Functions as polynomials in the velocities and in `others`: whatever depends on velocities in another way."""

    def __init__(self, moving: Set[sp.Symbol]) -> None:
        self._moving = moving
        self.others: dict[sp.Expr, sp.Symbol] = {}
        self._known: dict[sp.Expr, sp.Expr] = {}
        self._degrees: dict[sp.Expr, float] = {}

    def of(self, e: sp.Expr) -> sp.Expr:
        """The polynomial; each distinct part is worked out once."""
        if e not in self._known:
            self._known[e] = self._written(e)
        return self._known[e]

    def _written(self, e: sp.Expr) -> sp.Expr:
        if not e.args or e.free_symbols.isdisjoint(self._moving):
            return e
        if e.is_Add or e.is_Mul:
            return e.func(*map(self.of, e.args))
        if e.is_Pow and e.exp.is_Integer and e.exp.is_positive:
            return self.of(e.base) ** e.exp
        return self.others.setdefault(e, sp.Dummy(real=True))

    def degree(self, e: sp.Expr) -> float:
        """An upper bound of the degree of a polynomial in the velocities."""
        if e not in self._degrees:
            self._degrees[e] = self._bound(e)
        return self._degrees[e]

    def _bound(self, e: sp.Expr) -> float:
        if e in self._moving:
            return 1
        if e.is_Add:
            return max(map(self.degree, e.args))
        if e.is_Mul:
            return sum(map(self.degree, e.args))
        return self.degree(e.base) * float(e.exp) if e.is_Pow and e.exp.is_Integer and e.exp.is_positive else 0


# Reductions


class Why(StrEnum):
    """Why a function vanishes if and only if others do."""

    POWER = "power"  # u^n = 0: u = 0
    FACTOR = "factor"  # a u = 0 with a ≠ 0: u = 0
    QUOTIENT = "quotient"  # u/v = 0: u = 0, with v ≠ 0
    FUNCTION = "function"  # |u| = 0, sinh u = 0: u = 0
    INVERSE = "inverse"  # exp u = w: u = log w
    DIRECTION = "direction"  # atan2(u, v) = w: u cos w − v sin w = 0
    SQUARED = "squared"  # √u = w: u = w²
    SQUARES = "squares"  # u² + v² = 0: u = 0 and v = 0
    FACTORED = "factored"  # u² − 2 u v + v² = 0: (u − v)² = 0
    EXPANDED = "expanded"  # multiplied out, it is linear
    SPLIT = "split"  # u v = 0: u = 0 or v = 0


SideCondition = tuple[sp.Expr, str]
"""An assumption of a step: (e, "≠") for e ≠ 0, (e, "≥") for e ≥ 0."""


@record
class Reduction:
    """`function` vanishes if and only if all `forms` do; where it splits, if one does, and the first is followed.

    excluded  functions of q and t whose zeros satisfy it as well; they are assumed not to vanish
    """

    function: sp.Expr
    why: Why
    forms: tuple[sp.Expr, ...]
    conditions: tuple[SideCondition, ...] = ()
    excluded: tuple[sp.Expr, ...] = ()


@record
class Alternative:
    """Functions of q, q', t that all vanish, and the steps that lead to them."""

    forms: tuple[sp.Expr, ...]
    steps: tuple[Reduction, ...] = ()


@record
class Alternatives:
    """All alternatives of a constraint; none if it cannot be satisfied. `endless`: the first of infinitely many."""

    members: tuple[Alternative, ...]
    endless: bool = False
