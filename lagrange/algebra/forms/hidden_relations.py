"""Finite relations implied by several constraints together and shown by none of them alone.

The derived flag (`derived_flag`) counts how many finite relations the constraints imply together. Two wheels on an axle
that do not slip, for instance, imply one, though each of the three constraints is nonintegrable:

    x' cos θ + y' sin θ + b θ' = R φ1',   x' cos θ + y' sin θ − b θ' = R φ2'   =>   R (φ1 − φ2) − 2 b θ = const.

A relation φ = const holds where dφ = Σ c_j ω_j. Candidates for φ are the combinations of a bounded dictionary
(`first_integrals`). Each one found is verified exactly: dφ is in the row space of the forms, and independent of the
relations already known. Relations outside the dictionary are counted and not guessed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from math import lcm

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, Surface, UnsupportedError
from lagrange.algebra.forms.combinations import Combination, combination
from lagrange.algebra.forms.exact_forms import differentiated, without_constant_factor
from lagrange.algebra.forms.first_integrals import (
    NoTrialError,
    SampledForms,
    Trial,
    combination_constants,
    combined,
    integral_candidates,
)
from lagrange.algebra.forms.limits import LONGEST_COMBINED_RELATION
from lagrange.algebra.fourier.terms import normalised
from lagrange.algebra.fourier.vector_cleanup import ordered_differences
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, t

Form = tuple[sp.Expr, ...]


@record
class HiddenRelation:
    """function = const, which follows from the constraints.

    differential  d(function), shape (n + 1,)
    combination   c_j with d(function) = Σ c_j ω_j, one for each independent form; None where it is long
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
    """Functions that seem to stay constant, the simplest first. Numbers such as π are taken for parameters."""
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
