"""Special configurations in which constraints are no longer independent.

The rank of A (r, n) is taken at generic points. It is less where all minors of r columns vanish. Two kinds of such
places are looked for, and what is not found is not claimed not to exist:

    a factor g of one minor, with rank A < r on g = 0: two blades at one point, sin(θ1 - θ2) = 0;
    a row whose coefficients all vanish: x dx + y dy where x = y = 0.

Both are taken on the surface of the geometric constraints. A place is stated only if a real configuration is there; or,
for a row, if geometric constraints exclude it: a rod with x² + y² = l² never has x = y = 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, Surface, UnsupportedError, has_real_point
from lagrange.algebra.forms.candidates import moves
from lagrange.algebra.forms.combinations import independent_columns
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Sign, Slots
from lagrange.mechanics.constraints.kinematics import Row

MOST_ROWS = 4
MOST_OPERATIONS = 80
MOST_CONDITIONS = 4
MOST_FACTORED = 8


@record
class RankLoss:
    """A place where the constraints are not independent.

    conditions  what vanishes there, all of it
    vanishing   the name of the constraint whose form vanishes there; empty where the forms become dependent
    excluded    names of the geometric constraints that such a place would violate: then it does not exist
    rank        of A there; None for a place that does not exist
    """

    conditions: tuple[sp.Expr, ...]
    vanishing: str = ""
    excluded: tuple[str, ...] = ()
    rank: int | None = None


def rank_losses(rows: Sequence[Row], surface: Surface, slots: Slots) -> tuple[RankLoss, ...]:
    """The places that were found. `rows` are independent, with the geometric constraints of the surface among them."""
    found = [loss for row in rows if (loss := _of_row(row, rows, slots)) is not None]
    for factor in _factors(rows, surface, slots):
        if any(loss.conditions in ((factor,), (-factor,)) for loss in found):
            continue
        place = _place((factor,), rows, slots)
        rank = _rank(rows, place)
        if rank is not None and rank < len(rows) and has_real_point(place):
            found.append(RankLoss((factor,), rank=rank))
    return tuple(found)


def _of_row(row: Row, rows: Sequence[Row], slots: Slots) -> RankLoss | None:
    """Where the form of one constraint vanishes."""
    conditions = _conditions(row, slots)
    if not 0 < len(conditions) <= MOST_CONDITIONS:
        return None
    finite = [r.name for r in rows if r.finite is not None]
    there = _rule(conditions, slots)
    excluded = [r.name for r in rows if r.finite is not None and sp.expand(r.finite.xreplace(there)).is_nonzero]
    if excluded:
        return RankLoss(conditions, row.name, tuple(excluded[:1]))
    place = _place(conditions, rows, slots)
    try:
        clash = place.contradictory()
        if clash:
            names = tuple(finite[k] for k in clash if k < len(finite))
            return RankLoss(conditions, row.name, names) if names else None
        rank = _rank(rows, place)
        return RankLoss(conditions, row.name, rank=rank) if rank is not None and has_real_point(place) else None
    except (UnsupportedError, DivisionByZeroError):
        return None


def _rule(conditions: Sequence[sp.Expr], slots: Slots) -> dict[sp.Basic, sp.Expr]:
    """What x = 0 and x₂ − x₁ = 0 say of coordinates, each of which occurs in one condition only; other conditions say
    nothing here.
    """
    rule: dict[sp.Basic, sp.Expr] = {}
    for condition in conditions:
        others = [c for c in conditions if c is not condition]
        for q in sorted(condition.free_symbols.intersection(slots.coordinates), key=str):
            if abs(condition.diff(q)) == 1 and not any(c.has(q) for c in others):
                rule[q] = sp.expand(q - condition * condition.diff(q))
                break
    return rule


def _conditions(row: Row, slots: Slots) -> tuple[sp.Expr, ...]:
    """What must vanish for a form to vanish, each once; () if it cannot."""
    found: dict[sp.Expr, None] = {}
    for a in row.coefficients:
        if a == 0:
            continue
        varying = _varying(a, slots)
        if not varying:
            return ()
        product = sp.Mul(*varying)
        if -product not in found:
            found[product] = None
    nought = {c: sp.S.Zero for c in found if c in slots.coordinates}
    # x² + y² = 0 says nothing beside x = y = 0.
    told = [c for c in found if c in nought or sp.expand(c.xreplace(nought)) != 0]
    # Coordinates in their own order: x = y = 0.
    return tuple(sorted(told, key=lambda c: slots.coordinates.index(c) if c in slots.coordinates else -1))


def _varying(e: sp.Expr, slots: Slots) -> list[sp.Expr]:
    """The factors of an expression that may vanish."""
    numerator, _ = sp.fraction(sp.together(e) if e.count_ops() <= MOST_OPERATIONS else e)
    content = sp.factor_terms(numerator)
    bases = (f.as_base_exp()[0] for f in sp.Mul.make_args(content))
    return [b for b in bases if moves(b, slots) and not b.is_nonzero and not isinstance(b, Sign | sp.exp)]


def _factors(rows: Sequence[Row], surface: Surface, slots: Slots) -> Iterator[sp.Expr]:
    """The factors of a minor that does not vanish identically: where all minors vanish, one of them does."""
    if not 2 <= len(rows) <= MOST_ROWS:
        return
    columns = independent_columns([r.coefficients for r in rows], surface)
    matrix = sp.Matrix([[r.coefficients[k] for k in columns] for r in rows])
    if not matrix.is_square or sum(e.count_ops() for e in matrix) > MOST_OPERATIONS:
        return
    minor = textbook_form(matrix.det(method="berkowitz"))
    if minor.is_Add and len(minor.free_symbols) <= MOST_FACTORED:
        minor = sp.factor(minor)
    yield from dict.fromkeys(_varying(minor, slots))


def _place(conditions: Sequence[sp.Expr], rows: Sequence[Row], slots: Slots) -> Surface:
    return Surface([*(r.finite for r in rows if r.finite is not None), *conditions], slots.coordinates)


def _rank(rows: Sequence[Row], place: Surface) -> int | None:
    try:
        return place.rank([r.coefficients for r in rows])
    except DivisionByZeroError:
        return None
