"""Equilibria at which the second variation vanishes in some directions: the lowest terms of V along them decide.

Let V'' be positive definite in the coordinates r, and let its rank be their number; z are the others. Then ∂V/∂r = 0
has one solution r(z) near the equilibrium, the bottom of a valley, and V has a strict minimum there if and only if

    g(z) = V(z, r(z))

has one (splitting lemma): V = c (x⁴ + y²) has the valley y = 0 with g = c x⁴. Since ∂g/∂z = ∂V/∂z on the valley, r(z)
and g follow power by power from the derivatives of V at the equilibrium, taken in the displacements that the
constraints leave free. The terms of the lowest order that do not vanish are a form in z. A form of odd order, or one
that takes negative values, excludes a minimum; a positive definite one is a strict minimum; one that vanishes in some
direction decides nothing. Of forms in two variables the real roots of g(t, 1) are counted (Sturm).
V = c Σ q_j^(2n_j), with c > 0, q measured from the equilibrium, and a power of each coordinate alone, is a strict
minimum by itself, whatever the orders.

Reference: Poston and Stewart, Catastrophe Theory and its Applications, ch. 4.

Whether a matrix of numbers is positive definite, by the signs of its principal minors in interval arithmetic.

At an equilibrium whose position is a number, nested roots may be too long to be judged in closed form. An interval that
is rounded outwards and does not contain 0 has the sign of the number in it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import combinations, combinations_with_replacement, product
from math import factorial, prod

import sympy as sp

from lagrange.algebra.closed_forms.intervals import EmptyIntervalError, enclosure
from lagrange.algebra.closed_forms.signs import SignCondition, sign_of
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import HIGHEST_ORDER, LONGEST_DEGENERATE, MOST_IN_A_VALLEY


@record
class UniformMotion:
    """Stable up to a motion along which V is constant (`linear_stability`), if the conditions hold.

    coordinates  those that change in it
    others       those in which V has a strict minimum
    several      whether there are several such motions
    """

    coordinates: tuple[sp.Symbol, ...]
    others: tuple[sp.Symbol, ...]
    conditions: tuple[SignCondition, ...] = ()
    several: bool = False


@record
class Neighbourhood:
    """Coordinates of the constraint surface near an equilibrium, V'' in them, shape (f, f), and derivatives.

    free  the coordinates
    rest  the dependent ones, with ∂/∂q_free of each, shape (n − f, f)
    """

    matrix: Sequence[Sequence[sp.Expr]]
    free: tuple[sp.Symbol, ...]
    rest: tuple[tuple[sp.Symbol, Sequence[sp.Expr]], ...]

    def along(self, expression: sp.Expr, column: int) -> sp.Expr:
        """D_j of an expression."""
        slopes = (row[column] * expression.diff(q) for q, row in self.rest)
        return sp.Add(expression.diff(self.free[column]), *slopes)


def along_free(expression: sp.Expr, column: int, e: Equilibrium) -> sp.Expr:
    """D_j of an expression, j being the coordinate of a free displacement."""
    q = e.configuration.slots.coordinates
    derivative = expression.diff(q[e.elimination.independent[column]])
    for d, solved in zip(e.elimination.dependent, e.elimination.solution, strict=True):
        derivative += solved[column] * expression.diff(q[d])
    return derivative


def chart_of(
    elimination: Elimination, e: Equilibrium, matrix: Sequence[Sequence[sp.Expr]] = ()
) -> Neighbourhood | None:
    """The coordinates that an elimination leaves free; without `matrix`, V'' is derived anew in them."""
    q, free, rest = e.configuration.slots.coordinates, elimination.independent, elimination.dependent
    solved: Sequence[Sequence[sp.Expr]] = elimination.solution
    if not matrix:
        bound = sp.Matrix([[r.coefficients[d] for d in rest] for r in e.binding])
        if bound.rows != bound.cols:
            return None
        solved = (-bound.LUsolve(sp.Matrix([[r.coefficients[k] for k in free] for r in e.binding]))).tolist()
    chart = Neighbourhood(
        matrix, tuple(q[k] for k in free), tuple((q[d], row) for d, row in zip(rest, solved, strict=True))
    )
    if matrix:
        return chart
    forces = e.work.forces
    reduced = [
        sp.Add(forces[k], *(row[n] * forces[d] for d, row in zip(rest, solved, strict=True)))
        for n, k in enumerate(free)
    ]
    return replace(chart, matrix=[[chart.along(-f, column) for column in range(len(free))] for f in reduced])


@record
class LowestForm:
    """The terms of the lowest order of V along a valley.

    order    n
    form     the terms, a homogeneous polynomial of degree n in `symbols`
    symbols  the displacements z along the valley, measured from the equilibrium
    """

    order: int
    form: sp.Expr
    symbols: tuple[sp.Symbol, ...]

    def in_coordinates(self, along: tuple[sp.Symbol, ...]) -> LowestForm:
        """The form in the coordinates themselves, common factors before it."""
        named = self.form.xreplace(dict(zip(self.symbols, along, strict=True)))
        return replace(self, form=sp.factor_terms(named), symbols=along)

    @property
    def derivative(self) -> sp.Expr:
        """g⁽ⁿ⁾ along a valley of one coordinate."""
        [z] = self.symbols
        return sp.factor(self.form.coeff(z, self.order) * factorial(self.order))


def lowest_form(
    matrix: Sequence[Sequence[sp.Expr]],
    valley: Sequence[int],
    along: Callable[[sp.Expr, int], sp.Expr],
    at_rest: Callable[[sp.Expr], sp.Expr | None],
) -> LowestForm | None:
    """The terms of V along the valley; None if they are of the second order, of a high one, or not known.

    matrix   V'', shape (f, f), regular at the equilibrium without the rows and columns of the valley
    along    the derivative of an expression by a free coordinate
    at_rest  the value of an expression at the equilibrium; None if it cannot be written
    """
    size = len(matrix)
    if size > MOST_IN_A_VALLEY:
        return None
    formed: dict[tuple[int, tuple[int, ...]], sp.Expr] = {}

    def derivative(k: int, by: tuple[int, ...]) -> sp.Expr | None:
        formed[k, by] = matrix[k][by[0]] if len(by) == 1 else along(formed[k, by[:-1]], by[-1])
        return at_rest(formed[k, by])

    others = [k for k in range(size) if k not in valley]
    t = tuple(sp.Dummy(f"z_{k}", real=True) for k in valley)
    place: list[sp.Expr] = [t[valley.index(k)] if k in valley else sp.S.Zero for k in range(size)]
    second: dict[tuple[int, int], sp.Expr] = {}
    terms: dict[int, list[tuple[tuple[int, ...], sp.Expr]]] = {k: [] for k in range(size)}
    for degree in range(1, HIGHEST_ORDER):
        for k in range(size):
            for by in combinations_with_replacement(range(size), degree):
                value = derivative(k, by)
                if value is None or count_operations(value) > LONGEST_DEGENERATE:
                    return None
                if value != 0:
                    multiple = prod(factorial(by.count(j)) for j in set(by))
                    terms[k].append((by, value / multiple))
                if degree == 1:
                    second[k, by[0]] = value
        # r(z) to the power of the degree makes ∂V/∂r vanish to that power.
        if others:
            inner = sp.Matrix([[second[i, j] for j in others] for i in others])
            step = inner.LUsolve(sp.Matrix([-_power(terms[k], place, t, degree) for k in others]))
            for k, a in zip(others, step, strict=True):
                place[k] += sp.factor(a)
        slope = sp.Add(*(z * _power(terms[k], place, t, degree) for z, k in zip(t, valley, strict=True)))
        form = _without_zeros(slope / (degree + 1), t)
        if form != 0:
            return LowestForm(degree + 1, form, t) if degree > 1 else None
    return None


def _power(
    terms: Sequence[tuple[tuple[int, ...], sp.Expr]], place: Sequence[sp.Expr], t: Sequence[sp.Symbol], degree: int
) -> sp.Expr:
    """The terms of a degree of a polynomial at a place that is a polynomial in t."""
    total: sp.Expr = sp.S.Zero
    for by, value in terms:
        product = sp.Poly(sp.Mul(*(place[j] for j in by)), *t)
        of_degree = (c * sp.Mul(*(z**n for z, n in zip(t, powers, strict=True)))
                     for powers, c in product.terms() if sum(powers) == degree)  # fmt: skip
        total += value * sp.Add(*of_degree)
    return sp.expand(total)


def _without_zeros(form: sp.Expr, t: Sequence[sp.Symbol]) -> sp.Expr:
    """A form without the terms that are zero, each coefficient in factors."""
    terms = ((sp.factor(c), powers) for powers, c in sp.Poly(form, *t).terms())
    return sp.Add(*(c * sp.Mul(*(z**n for z, n in zip(t, powers, strict=True))) for c, powers in terms))


def sign_of_form(form: LowestForm, sign: Callable[[sp.Expr], int | None]) -> tuple[int, tuple[sp.Expr, ...]] | None:
    """Whether a form is positive definite, 1, or takes negative values, −1; None if it vanishes or that is open.

    With 1 what must be positive for it, where that depends on the parameters; otherwise it takes negative values.
    sign  of a coefficient: 1, 0, −1; None if the parameters leave it open
    """
    t, poly = form.symbols, sp.Poly(form.form, *form.symbols)
    terms = dict(poly.terms())
    signs = {powers: sign(c) for powers, c in terms.items()}
    alone = [tuple(form.order * (k == j) for k in range(len(t))) for j in range(len(t))]
    if len(terms) == 1 and None in signs.values():
        return None
    if form.order % 2:
        return (-1, ()) if any(signs.values()) else None
    if any(signs.get(powers) == -1 for powers in alone):
        return -1, ()
    if all(signs.get(powers) == 1 for powers in alone) and all(
        s in (0, 1) and not any(n % 2 for n in powers) for powers, s in signs.items()
    ):
        return 1, ()
    leading = poly.coeffs()[0]
    ratios = {powers: sp.cancel(c / leading) for powers, c in terms.items()}
    in_numbers = all(r.is_Rational for r in ratios.values()) and sign(leading) in (1, -1)
    for place in product((0, 1, -1, 2, -2), repeat=len(t)) if any(signs.values()) else ():
        if sign(sp.factor(poly.as_expr().xreplace(dict(zip(t, map(sp.Integer, place), strict=True))))) == -1:
            return -1, ()
    if in_numbers and len(t) == 2:
        return _of_binary(ratios, t, sign(leading) or 0)
    return _in_squares(terms, t, sign)


def _of_binary(
    ratios: dict[tuple[int, ...], sp.Expr], t: Sequence[sp.Symbol], sign: int
) -> tuple[int, tuple[sp.Expr, ...]] | None:
    """`sign_of_form` of a form in two variables of even order, with rational coefficients times one of known sign."""
    z = t[0]
    along = sp.Poly(sp.Add(*(sign * r * z ** powers[0] for powers, r in ratios.items())), z, domain="QQ")
    order = sum(next(iter(ratios)))
    roots = along.intervals()  # each with its multiplicity; t = ∞ is one where the degree is lower
    changes = any(n % 2 for _, n in roots) or (order - along.degree()) % 2
    if changes or along.LC() < 0:
        return -1, ()
    return (1, ()) if not roots and along.degree() == order else None


def _in_squares(
    terms: dict[tuple[int, ...], sp.Expr], t: Sequence[sp.Symbol], sign: Callable[[sp.Expr], int | None]
) -> tuple[int, tuple[sp.Expr, ...]] | None:
    """`sign_of_form` of a x⁴ + b x² y² + c y⁴ and so on: a quadratic form in the squares, which are not negative.

    It is positive definite for squares if it is for all values. In two variables with b < 0 the converse holds too.
    """
    half = {tuple(n // 2 for n in powers): c for powers, c in terms.items()}
    if any(n % 2 for powers in terms for n in powers) or any(sum(powers) != 2 for powers in half):
        return None
    size = range(len(t))
    matrix = sp.Matrix(
        len(t), len(t),
        lambda i, j: half.get(tuple((i == k) + (j == k) for k in size), sp.S.Zero) * sp.Rational(1, 2 - (i == j)),
    )  # fmt: skip
    minors = [sp.factor(matrix[:n, :n].det()) for n in range(1, len(t) + 1)]
    signs = [sign(m) for m in minors]
    if all(s == 1 for s in signs):
        return 1, ()
    if len(t) != 2 or sign(matrix[0, 1]) != -1 or [sign(matrix[0, 0]), sign(matrix[1, 1])] != [1, 1]:
        return None
    return (-1, ()) if signs[1] == -1 else (1, (minors[1],)) if signs[1] is None else None


def rises_in_even_powers(gradient: Sequence[sp.Expr], place: Sequence[tuple[sp.Symbol, sp.Expr]]) -> bool:
    """Whether V is visibly a sum of even powers with positive coefficients at a place.

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


# Numerical definiteness


def is_definite(matrix: Sequence[Sequence[sp.Expr]], e: Equilibrium, at: Values) -> bool | None:
    """Whether K at a point is positive definite; False if it takes negative values; None: undecided."""
    size = len(matrix)
    letters = sp.Matrix(size, size, lambda i, j: sp.Symbol(f"K_{min(i, j)}{max(i, j)}", real=True))
    try:
        box = {letters[i, j]: enclosure(e.solution.at(at, matrix[i][j]), {}) for i in range(size) for j in range(i + 1)}
        leading = []
        for n in range(1, size + 1):
            for rows in combinations(range(size), n):
                low, high = enclosure(letters.extract(list(rows), list(rows)).det(method="berkowitz"), box)
                if high < 0:
                    return False
                if rows == tuple(range(n)):
                    leading.append(low > 0)
    except (NotAlgebraicError, DivisionByZeroError, EmptyIntervalError, ValueError, KeyError, OverflowError):
        return None
    return True if all(leading) else None
