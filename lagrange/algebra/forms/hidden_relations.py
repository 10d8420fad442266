"""Finite relations implied by several constraints together and shown by none of them alone.

The derived flag (`derived_flag`) counts how many finite relations the constraints imply together. Two wheels on an axle
that do not slip, for instance, imply one, though each of the three constraints is nonintegrable:

    x' cos θ + y' sin θ + b θ' = R φ1',   x' cos θ + y' sin θ − b θ' = R φ2'   =>   R (φ1 − φ2) − 2 b θ = const.

A relation φ = const holds where dφ = Σ c_j ω_j. Candidates for φ are the combinations of a bounded dictionary
(`first_integrals`). Each one found is verified exactly: dφ is in the row space of the forms, and independent of the
relations already known. Relations outside the dictionary are counted and not guessed.

One form as a combination of others: ω = Σ c_j ω_j, with functions c_j of the configuration.

Whether there is such a combination, and which of the ω_j it needs, is read off at random points of the constraint
surface. The c_j follow from as many columns as forms are needed, by Cramer's rule; constants are reconstructed directly
from their residues. Every column is verified on the surface. What would be too long to read is not worked out: then the
result is None.

Shapes: ω (n,), ω_j (m, n), c (m,).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from math import lcm

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.points_needed import ZERO_POINTS
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.forms.exact_forms import differentiated, without_constant_factor
from lagrange.algebra.forms.first_integrals import (
    NoTrialError,
    SampledForms,
    Trial,
    combination_constants,
    combined,
    integral_candidates,
)
from lagrange.algebra.forms.limits import (
    LARGEST_COMBINED,
    LONGEST_COMBINATION,
    LONGEST_COMBINED_RELATION,
    MOST_COMBINED_FORMS,
)
from lagrange.algebra.fourier.terms import normalised
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.algebra.fourier.vector_cleanup import ordered_differences
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, t

Form = tuple[sp.Expr, ...]


@record
class Flag:
    """The derived flag of a system of constraints.

    ranks            of the system, of its first derived system, ..., as far as they were found
    integrable_rank  number of independent finite relations in the constraints (the last rank), or None
    reason           why it is undecided
    beside           number of finite relations in which only forms take part modulo which the ranks are taken
    """

    ranks: tuple[int, ...]
    integrable_rank: int | None
    reason: str = ""
    beside: int = 0

    @property
    def bound(self) -> int | None:
        """An upper bound of `integrable_rank`, None if nothing is known."""
        return self.ranks[-1] if self.ranks else None


@record
class HiddenRelation:
    """function = const, which follows from the constraints.

    differential  d(function), shape (n + 1,)
    combination   c_j with d(function) = Σ c_j ω_j, one for each independent form; None if it is long
    """

    function: sp.Expr
    differential: Form
    combination: Combination | None


@record
class HiddenRelations:
    """The finite relations beyond those known.

    found    those in closed form, independent of one another and of those known
    missing  how many more there are; None: undecided
    """

    found: tuple[HiddenRelation, ...] = ()
    missing: int | None = 0


def hidden_relations(
    forms: Sequence[Form],
    known: Sequence[Form],
    integrable_rank: int | None,
    surface: Surface,
    slots: Slots,
    most: int | None = None,
) -> HiddenRelations:
    """The finite relations in the constraints beyond those known.

    forms            (m, n + 1) of rank m: coefficients of dq_1 ... dq_n, dt
    known            (k, n + 1): the differentials of the relations already known
    integrable_rank  how many independent relations there are; None: undecided
    surface          where the geometric constraints hold; their differentials are among `known`
    most             how many there can be, where that is undecided
    """
    before = surface.rank(known) if known else 0
    if before is None:
        return HiddenRelations(missing=None)
    wanted = (integrable_rank if integrable_rank is not None else len(forms) if most is None else most) - before
    relations: list[HiddenRelation] = []
    if wanted > 0 and forms:
        try:
            for function in _proposed(forms, known, surface, slots):
                relation = _verified(function, forms, [*known, *(r.differential for r in relations)], surface, slots)
                if relation is not None:
                    relations.append(relation)
                if len(relations) == wanted:
                    break
        except (NoTrialError, UnsupportedError, DivisionByZeroError):
            pass
    return HiddenRelations(tuple(relations), None if integrable_rank is None else max(wanted, 0) - len(relations))


def _proposed(forms: Sequence[Form], known: Sequence[Form], surface: Surface, slots: Slots) -> Iterator[sp.Expr]:
    """Candidates that appear to be constant, simplest first. Numbers such as π are treated as parameters."""
    # The coefficients are interpolated with rational numbers: π or √2 takes part as a parameter, and is put back.
    numbers = _irrational_numbers([a for form in (*forms, *known, surface.constraints) for a in form])
    back = {symbol: number for number, symbol in numbers.items()}
    if numbers:
        forms = [tuple(a.xreplace(numbers) for a in form) for form in forms]
        known = [tuple(a.xreplace(numbers) for a in form) for form in known]
        surface = Surface([f.xreplace(numbers) for f in surface.constraints], surface.coordinates)
    # Points solved for a parameter would not keep the values of the parameters that a trial is about.
    order = surface.order
    if order is None or any(u not in slots.coordinates for block in order.blocks for u in block.unknowns):
        return
    space = SampledForms(forms, order, surface, slots)
    for form in known:
        space.know(form)
    tried: set[tuple[int, ...]] = set()
    read = 0
    for stage in integral_candidates(forms, slots, order.rules):
        for function in stage[read:]:
            space.add(function)
        read = len(stage)
        trial = Trial(space)
        for values in trial.combinations(range(len(space.functions))):
            if tuple(values) in tried or not trial.is_new(values):
                continue
            tried.add(tuple(values))
            constants = combination_constants(space, trial, values)
            if constants is not None:
                function = _as_written(combined(space.functions, constants), slots)
                # Known from here on: what comes next must be independent of it.
                yield function.xreplace(back)
                space.know(differential_of(function, slots))


def _irrational_numbers(expressions: Sequence[sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """A symbol for each number such as π or √2 that is a factor, and not inside a function."""
    symbols: dict[sp.Expr, sp.Expr] = {}

    def visit(e: sp.Expr) -> None:
        if e.is_number:
            for factor in sp.Mul.make_args(e):
                base = factor.as_base_exp()[0] if factor.is_Pow and factor.exp.is_Integer else factor
                if not base.is_Rational and base.is_positive and (base is sp.pi or base.is_Pow):
                    symbols[base] = sp.Dummy("number", positive=True)
        elif e.is_Add or e.is_Mul or (e.is_Pow and e.exp.is_Integer):
            for a in e.args:
                visit(a)

    for e in expressions:
        visit(e)
    return symbols


def _verified(
    function: sp.Expr, forms: Sequence[Form], known: Sequence[Form], surface: Surface, slots: Slots
) -> HiddenRelation | None:
    """The relation, if its differential is a combination of the forms and independent of those known."""
    differential = differential_of(function, slots)
    if surface.rank([*forms, differential]) != surface.rank(forms):
        return None
    if surface.rank([*known, differential]) != (surface.rank(known) or 0) + 1:
        return None
    return HiddenRelation(function, differential, combination(differential, forms, surface))


def differential_of(function: sp.Expr, slots: Slots) -> Form:
    """The partial derivatives by the coordinates and t, shape (n + 1,)."""
    return tuple(differentiated(function, v, slots) for v in (*slots.coordinates, t))


def _as_written(function: sp.Expr, slots: Slots) -> sp.Expr:
    """Without a common factor; x y² for (log x)/2 + log y."""
    tidied = normalised(without_constant_factor(function, (*slots.coordinates, t), slots), slots.coordinates)
    parts = [term.as_coeff_Mul() for term in sp.Add.make_args(tidied)]
    if all(isinstance(f, sp.log) and n.is_Rational for n, f in parts):
        denominator = lcm(*(int(n.q) for n, _ in parts))
        return sp.Mul(*(f.args[0].replace(sp.Abs, lambda a: a) ** (n * denominator) for n, f in parts))
    return tidied


# -- Relations f = const and g = const in which a coordinate occurs linearly, added so that it drops out ---------------
#
# With constant slopes a = ∂f/∂q and b = ∂g/∂q the combination b f − a g is constant too, and free of q. It is worth a
# line where it has fewer coordinates than either: of the wheels and the gear of the south-pointing chariot,
# R φ₁ − R φ₂ + 2b ψ = const and 2b θ − R (φ₁ − φ₂) = const, it leaves θ + ψ = const, the direction of the arm.


@record
class CombinedRelation:
    """function = const, from the relations at two places of a list."""

    function: sp.Expr
    places: tuple[int, int]


def combined_relations(functions: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> tuple[CombinedRelation, ...]:
    """The combinations of two functions that have fewer coordinates than either of them, the shortest first."""
    relations = sorted(_combinations(functions, coordinates), key=lambda c: len(c.function.free_symbols))
    return tuple({c.function: c for c in reversed(relations)}.values())[::-1]


def _combinations(functions: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> Iterator[CombinedRelation]:
    moving = {*coordinates}
    for (m, f), (n, g) in combinations(enumerate(functions), 2):
        if max(count_operations(f), count_operations(g)) > LONGEST_COMBINED_RELATION:
            continue
        fewest = min(len(f.free_symbols & moving), len(g.free_symbols & moving))
        for q in sorted(f.free_symbols & g.free_symbols & moving, key=str):
            a, b = sp.diff(f, q), sp.diff(g, q)
            if (a.free_symbols | b.free_symbols) & moving:
                continue
            rest = sp.expand(sp.cancel(b / a) * f - g)
            if 0 < len(rest.free_symbols & moving) < fewest:
                function = sp.Mul(*_without_constants(rest, moving))
                function = -function if function.could_extract_minus_sign() else function
                yield CombinedRelation(_collected(function, coordinates), (m, n))


def _collected(e: sp.Expr, coordinates: Sequence[sp.Symbol]) -> sp.Expr:
    """2y − R φ + r φ as 2y − (R − r) φ, where all coordinates occur linearly with constant slopes."""
    used = [q for q in coordinates if e.has(q)]
    slopes = [sp.factor(e.diff(q)) for q in used]
    if any(s.free_symbols & {*coordinates} for s in slopes):
        return e
    rest = e.xreplace(dict.fromkeys(used, sp.S.Zero))
    return sp.Add(rest, *(ordered_differences(s * q) for s, q in zip(slopes, used, strict=True)))


def _without_constants(e: sp.Expr, moving: set[sp.Symbol]) -> list[sp.Expr]:
    """The factors of an expression with coordinates in them."""
    return [f for f in sp.Mul.make_args(sp.factor(e)) if f.free_symbols & moving]


# Combinations


Coefficients = Sequence[sp.Expr]
Combination = tuple[sp.Expr, ...]


def combination(form: Coefficients, others: Sequence[Coefficients], surface: Surface) -> Combination | None:
    """The c_j, shape (m,), with form = Σ c_j others_j on the surface; None: there is none, or it is not short.

    form (n,), others (m, n) of rank m.
    """
    try:
        values_at_points = surface.sampled(lambda point: _values(point, form, others), ZERO_POINTS)
        if any(values is None for values in values_at_points):
            return None
        needed = [j for j in range(len(others)) if any(values and values[j] for values in values_at_points)]
        # The same small fractions at two points: the c_j are constants, and no determinant is needed.
        numbers = surface.sampled(lambda point: _rational(point, form, others), ZERO_POINTS)
        constant = numbers[0] if numbers[0] == numbers[1] else None
        candidate = constant or _by_cramer(form, others, needed, surface)
        if candidate is None or not _holds(candidate, form, others, surface):
            return None
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        return None
    return candidate if sum(count_operations(c) for c in candidate) <= LONGEST_COMBINATION else None


def _values(point: Point, form: Coefficients, others: Sequence[Coefficients]) -> list[object] | None:
    """The values of the c_j at a point."""
    rows = point.matrix(others)
    solution = point.solution([list(column) for column in zip(*rows, strict=True)], point.values(form))
    return None if solution is None else [None if point.arithmetic.vanishes(c) else c for c in solution]


def _rational(point: Point, form: Coefficients, others: Sequence[Coefficients]) -> Combination | None:
    """The c_j as rational numbers, where they all look like some."""
    values = _values(point, form, others)
    if values is None or not hasattr(point, "reconstructed"):
        return None
    numbers = [sp.S.Zero if c is None else point.reconstructed(c) for c in values]
    return None if None in numbers else tuple(numbers)


def _by_cramer(
    form: Coefficients, others: Sequence[Coefficients], needed: Sequence[int], surface: Surface
) -> Combination | None:
    if not 0 < len(needed) <= MOST_COMBINED_FORMS:
        return None
    rows = [others[j] for j in needed]
    columns = independent_columns(rows, surface, form)
    if len(columns) < len(rows):
        return None
    matrix = sp.Matrix([[row[k] for row in rows] for k in columns])
    right = sp.Matrix([form[k] for k in columns])
    if sum(count_operations(e) for e in (*matrix, *right)) > LARGEST_COMBINED:
        return None
    below = textbook_form(matrix.det(method="berkowitz"))
    coefficients = [sp.S.Zero] * len(others)
    for n, j in enumerate(needed):
        replaced = matrix.copy()
        replaced[:, n] = right
        coefficients[j] = _lowest(textbook_form(replaced.det(method="berkowitz")), below)
    return tuple(coefficients)


def independent_columns(rows: Sequence[Coefficients], surface: Surface, beside: Coefficients = ()) -> list[int]:
    """As many columns as there are rows in which the rows (m, n) of rank m are independent, short ones first.

    `beside`, (n,), is one more row whose length counts. Fewer columns where that is undecided.
    """
    chosen: list[int] = []
    everything = [*rows, beside] if beside else rows
    for k in sorted(range(len(rows[0])), key=lambda k: (sum(count_operations(r[k]) for r in everything), k)):
        if surface.rank([[row[c] for row in rows] for c in (*chosen, k)]) == len(chosen) + 1:
            chosen.append(k)
        if len(chosen) == len(rows):
            break
    return chosen


def _lowest(above: sp.Expr, below: sp.Expr) -> sp.Expr:
    """A quotient in lowest terms, in textbook form where that is shorter."""
    reduced = sp.cancel(above / below)
    tidied = textbook_form(reduced)
    return min((above / below, reduced, tidied), key=lambda e: count_operations(e))


def _holds(candidate: Combination, form: Coefficients, others: Sequence[Coefficients], surface: Surface) -> bool:
    columns = zip(form, *others, strict=True)
    return all(
        surface.is_zero(sp.Add(a, *(-c * b for c, b in zip(candidate, column, strict=True)))) is True
        for a, *column in columns
    )
