"""Constraints that contradict each other, and configurations where independent constraints become dependent.

Contradictory constraints are an error that names them, and no others:

    f = 0 with f = 1             no position satisfies both
    φ' = 1 with φ' = 2           no velocity: a_t is outside the range of A at generic points
    x = 0 with x' = y            a velocity only where y = 0, a condition that the file has to state

The last is a relation hidden in a geometric and a kinematic constraint together. Hidden finite relations are included:
if dφ is a combination of the forms, then with φ = t the equations A q' = −a_t have no solution.

The rank r of A, shape (r, n), is taken at generic points. It drops where all minors of r columns vanish. Two kinds of
such places are sought, without a claim that there are no others:

    a factor g of one minor, with rank A < r on g = 0: two blades at one point, sin(θ1 − θ2) = 0;
    a row whose coefficients all vanish: x dx + y dy where x = y = 0.

A place is reported only if it contains a real configuration on the surface of the geometric constraints; or, for a row,
if these exclude it: a rod with x² + y² = l² never has x = y = 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from itertools import islice, product

import sympy as sp

from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    Surface,
    UnsupportedError,
    has_real_point,
    kept_surface,
    rank,
)
from lagrange.algebra.forms.antiderivatives import multiplied_out
from lagrange.algebra.forms.first_integrals import is_variable
from lagrange.algebra.forms.hidden_relations import combination, independent_columns
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.determinants import expanded_determinant
from lagrange.core.diagnostics import Diagnostic, ProblemError, UndecidedError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Sign, Slots
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem, Row
from lagrange.mechanics.constraints.limits import (
    LONGEST_MINOR,
    MOST_CASES,
    MOST_CONDITIONS,
    MOST_FACTORED_SYMBOLS,
    MOST_MINOR_ROWS,
)
from lagrange.problem.model import Constraint

Pairs = list[tuple[Constraint, Row]]


def check_consistent(constraints: Sequence[Constraint], system: ConstrainedSystem) -> None:
    """Raise ProblemError if constraints contradict each other or restrict nothing; `system` has their rows."""
    surface = system.surface
    for c in constraints:
        factors = [] if c.given is None else [e for step in c.given.steps for e in step.excluded]
        if any(surface.is_zero(e) for e in factors):
            message = (
                f"the constraint `{c.name}` restricts nothing where the other constraints hold: a factor of it vanishes"
            )
            raise ProblemError(
                Diagnostic("restricts-nothing", message, c.span, help="remove it, or divide by the factor")
            )
    linear = [(c, row) for c, row in zip(constraints, system.rows, strict=True) if row.nonlinear is None]
    constraints, rows = [c for c, _ in linear], [row for _, row in linear]
    geometric = [c for c in constraints if not c.kinematic]
    # A real point refutes a contradiction; to look for one in a large closed chain takes several times as long.
    possible = surface.exact or has_real_point(surface)
    clash = [] if possible else [geometric[k] for k in surface.contradictory()]
    if not clash:
        _check_regular(geometric, rows, surface)
        pairs = _clash_of_rates(linear, surface)
        _check_no_condition(pairs, surface.coordinates)
        clash = [c for c, _ in pairs]
    if clash:
        raise _contradiction(clash)


def _contradiction(clash: Sequence[Constraint]) -> ProblemError:
    message = f"{_named(clash)} contradict each other" if len(clash) > 1 else f"{_named(clash)} cannot be satisfied"
    help_ = "no position or velocity satisfies them; correct or remove one"
    return ProblemError(Diagnostic("contradictory-constraints", message, clash[-1].span, help=help_))


def _named(constraints: Sequence[Constraint]) -> str:
    *first, last = (f"`{c.name}`" for c in constraints)
    return f"{', '.join(first)} and {last}" if first else last


def _check_regular(geometric: Sequence[Constraint], rows: Sequence[Row], surface: Surface) -> None:
    """Refuse constraints such as sin x = 1, whose differential vanishes where they hold."""
    finite = [r for r in rows if r.finite is not None]
    for constraint, row in zip(geometric, finite, strict=True):
        if surface.rank([row.coefficients]) == 0:
            message = f"the differential of `{constraint.name}` vanishes wherever the constraint holds"
            help_ = "write it so that it changes sign there: `x = pi/2` and not `sin(x) = 1`"
            raise ProblemError(Diagnostic("singular-constraint", message, constraint.span, help=help_))


def _clash_of_rates(pairs: Pairs, surface: Surface) -> Pairs:
    """The first constraint whose velocity form contradicts earlier ones, with the constraints in the contradiction."""
    if not _clash([row for _, row in pairs], surface):
        return []  # a contradiction between some of them is one between all
    for count in range(1, len(pairs) + 1):
        if _clash([row for _, row in pairs[:count]], surface):
            later = [(c, row) for c, row in pairs[count:] if row.finite is not None]
            return _smallest_clash([*pairs[:count], *later], surface)
    return []


def _clash(rows: Sequence[Row], surface: Surface) -> bool:
    """Whether A q' = -a_t has no solution at generic points of a surface."""
    of_coefficients = surface.rank([r.coefficients for r in rows]) if rows else 0
    augmented = surface.rank([r.form for r in rows]) if rows else 0
    return of_coefficients is not None and augmented is not None and augmented > of_coefficients


def _smallest_clash(pairs: Pairs, surface: Surface) -> Pairs:
    """The pairs without constraints that the contradiction does not need, neither as rows nor for the surface."""
    for pair in list(pairs):
        fewer = [p for p in pairs if p is not pair]
        if _clash([row for _, row in fewer], _surface(fewer, surface.coordinates)):
            pairs = fewer
    return pairs


def _surface(pairs: Pairs, coordinates: Sequence[sp.Symbol]) -> Surface:
    return Surface([row.finite for _, row in pairs if row.finite is not None], coordinates)


def _check_no_condition(clash: Pairs, coordinates: Sequence[sp.Symbol]) -> None:
    """Refuse constraints that admit velocities only where one more relation between the coordinates holds."""
    condition = _condition(clash, coordinates)
    if condition is not None:
        written = str(condition).replace("**", "^")
        message = f"{_named([c for c, _ in clash])} together require {written} = 0, which the file does not state"
        help_ = f"add the constraint `{written} = 0`, or correct one of them"
        raise ProblemError(Diagnostic("unstated-condition", message, clash[-1][0].span, help=help_))


def _condition(clash: Pairs, coordinates: Sequence[sp.Symbol]) -> sp.Expr | None:
    """g(q, t), if the clash amounts to g = 0 and this is possible: Σ c_j A_j = 0 with Σ c_j a_tj = g."""
    surface = _surface(clash, coordinates)
    for n, (_, row) in enumerate(clash):
        others = [r for k, (_, r) in enumerate(clash) if k != n]
        if row.finite is not None or surface.rank([r.coefficients for r in others]) != len(others):
            continue
        values = combination(row.coefficients, [r.coefficients for r in others], surface) if others else None
        if values is None:
            continue
        rest = textbook_form(row.drift - sp.Add(*(c * r.drift for c, r in zip(values, others, strict=True))))
        condition, _ = sp.fraction(sp.factor_terms(rest))
        condition = sp.Mul(*(f for f in sp.Mul.make_args(condition) if f.free_symbols & {*coordinates}))
        try:
            if condition != 1 and has_real_point(Surface([*surface.constraints, condition], coordinates)):
                return condition
        except DivisionByZeroError:
            continue
    return None


def check_curved(constraints: Sequence[Constraint], system: ConstrainedSystem) -> None:
    """Refuse nonlinear constraints on velocities that contradict others, or whose ∂φ/∂q' vanish where φ = 0."""
    rows, states = system.rows, system.states
    curved = [(c, r) for c, r in zip(constraints, rows, strict=True) if r.nonlinear is not None]
    if not curved:
        return
    clash = states.contradictory()
    if clash and not has_real_point(states):
        finite = [c for c, r in zip(constraints, rows, strict=True) if r.finite is not None]
        ordered = [*finite, *constraints]
        raise _contradiction(list(dict.fromkeys(ordered[k] for k in clash)))
    for constraint, row in curved:
        if states.rank([row.coefficients]) == 0:
            raise _singular(constraint)


def _singular(constraint: Constraint) -> ProblemError:
    message = f"the derivatives of `{constraint.name}` by the velocities vanish wherever the constraints hold"
    help_ = "write it so that it changes sign there, as a product without squares"
    return ProblemError(Diagnostic("singular-constraint", message, constraint.span, help=help_))


def check_follows(constraint: Constraint, before: ConstrainedSystem, row: Row) -> None:
    """Refuse a constraint that is only tangent to earlier ones: x' = 1 touches x'² + y'² = 1 at y' = 0."""
    if before.is_pfaffian and row.nonlinear is None:
        return
    follows = before.admitted_states.is_zero(row.velocity_form(before.slots))
    if follows is None:
        raise UndecidedError(f"whether the constraint `{constraint.name}` follows from the others", constraint.span)
    if not follows:
        raise _singular(constraint)


@record
class RankLoss:
    """A place where the constraints are not independent.

    conditions  the expressions that all vanish there
    vanishing   the name of the constraint whose form vanishes there; empty if forms become dependent
    excluded    names of the geometric constraints that such a place would violate: then it does not exist
    rank        of A there; None if the place does not exist
    """

    conditions: tuple[sp.Expr, ...]
    vanishing: str = ""
    excluded: tuple[str, ...] = ()
    rank: int | None = None


def rank_losses(independent: ConstrainedSystem) -> tuple[RankLoss, ...]:
    """The places found at which independent constraints become dependent."""
    rows = independent.rows
    losses = [loss for row in rows for loss in _of_row(row, independent)]
    for factor in _factors(independent):
        if any(loss.conditions in ((factor,), (-factor,)) for loss in losses):
            continue
        place = _place((factor,), independent)
        there = _rank(rows, place)
        if there is not None and there < len(rows) and has_real_point(place):
            losses.append(RankLoss((factor,), rank=there))
    return tuple(losses)


def _of_row(row: Row, independent: ConstrainedSystem) -> Sequence[RankLoss]:
    """Where the form of one constraint vanishes: y z dx + x z dy + x y dz on three lines."""
    conditions = _conditions(row, independent.slots)
    if not 0 < len(conditions) <= MOST_CONDITIONS:
        return ()
    cases = _cases(conditions, independent.slots)
    places = [loss for case in cases if (loss := _at(case, row, independent)) is not None]
    exist = [loss for loss in places if not loss.excluded]
    if not places and (at_origin := _at_origin(row, independent)) is not None:
        return (at_origin,)
    return exist or places[:1]


def _cases(conditions: Sequence[sp.Expr], slots: Slots) -> list[tuple[sp.Expr, ...]]:
    """Sets of factors, one of each product at least: where those of some set vanish, all products do."""
    cases: dict[tuple[sp.Expr, ...], None] = {}

    @cache  # the same factors occur in many choices
    def factors_of(e: sp.Expr) -> tuple[sp.Expr, list[sp.Expr]]:
        rest = multiplied_out(e)
        return rest, [] if rest == 0 else _varying(rest, slots)

    for choice in islice(product(*(_varying(c, slots) for c in conditions)), MOST_CASES):
        if (case := _reduced(dict.fromkeys(choice), slots, factors_of)) is not None:
            cases[case] = None
    return [case for case in cases if not any(set(other) < set(case) for other in cases)]


def _reduced(
    case: Iterable[sp.Expr], slots: Slots, factors_of: Callable[[sp.Expr], tuple[sp.Expr, list[sp.Expr]]]
) -> tuple[sp.Expr, ...] | None:
    """The conditions with what follows from q = 0 for some coordinates put in; None if they cannot all hold.

    factors_of  an expression multiplied out, and its factors that may vanish
    """
    conditions = list(case)
    while True:
        zeros = dict.fromkeys((c for c in conditions if c in slots.coordinates), sp.S.Zero)
        left: dict[sp.Expr, None] = dict.fromkeys(zeros)
        for condition in (c for c in conditions if c not in zeros):
            rest, varying = factors_of(condition.xreplace(zeros))
            if rest == 0:
                continue
            if not varying:
                return None
            left[varying[0] if len(varying) == 1 else condition] = None
        if list(left) == conditions:
            break
        conditions = list(left)
    moved = [q for q in slots.coordinates if any(c.has(q) for c in conditions)]
    at_zero = dict.fromkeys(moved, sp.S.Zero)
    if not any(c.xreplace(at_zero) for c in conditions):
        slopes = [[c.diff(q) for q in moved] for c in conditions]
        if all(e.is_number for row in slopes for e in row) and rank(slopes) == len(moved):
            conditions = list(moved)
    return tuple(sorted(conditions, key=lambda c: slots.coordinates.index(c) if c in slots.coordinates else -1))


def _at_origin(row: Row, independent: ConstrainedSystem) -> RankLoss | None:
    """Where all coordinates in the coefficients of a form are zero, if it vanishes there."""
    slots = independent.slots
    conditions = tuple(q for q in slots.coordinates if any(a.has(q) for a in row.coefficients))
    rule = dict.fromkeys(conditions, sp.S.Zero)
    try:
        vanishes = all(a.xreplace(rule) == 0 for a in (*row.coefficients, row.drift))
    except (UnsupportedError, DivisionByZeroError, ZeroDivisionError):
        return None
    return _at(conditions, row, independent) if conditions and vanishes else None


def _at(conditions: tuple[sp.Expr, ...], row: Row, independent: ConstrainedSystem) -> RankLoss | None:
    """What is lost where these vanish, with which the form of a constraint does."""
    rule = _rule(conditions, independent.slots)
    excluded = [r.name for r in independent.geometric if sp.expand(r.finite.xreplace(rule)).is_nonzero]  # type: ignore[union-attr]
    if excluded:
        return RankLoss(conditions, row.name, tuple(excluded[:1]))
    place = _place(conditions, independent)
    try:
        clash = place.contradictory()
        if clash:
            names = tuple(independent.geometric[k].name for k in clash if k < len(independent.geometric))
            return RankLoss(conditions, row.name, names) if names else None
        there = _rank(independent.rows, place)
        return RankLoss(conditions, row.name, rank=there) if there is not None and has_real_point(place) else None
    except (UnsupportedError, DivisionByZeroError):
        return None


def _rule(conditions: Sequence[sp.Expr], slots: Slots) -> dict[sp.Basic, sp.Expr]:
    """The substitution from conditions such as x = 0 and x₂ − x₁ = 0, for coordinates in only one of them."""
    rule: dict[sp.Basic, sp.Expr] = {}
    for condition in conditions:
        others = [c for c in conditions if c is not condition]
        for q in sorted(condition.free_symbols.intersection(slots.coordinates), key=str):
            if any(c.has(q) for c in others):
                continue
            slope = condition.diff(q)
            if abs(slope) == 1:
                rule[q] = sp.expand(q - condition * slope)
                break
    return rule


def _conditions(row: Row, slots: Slots) -> tuple[sp.Expr, ...]:
    """The expressions that must vanish for a form to vanish, each once; () if it cannot."""
    products: dict[sp.Expr, None] = {}
    for a in row.coefficients:
        if a == 0:
            continue
        varying = _varying(a, slots)
        if not varying:
            return ()
        factors = sp.Mul(*varying)
        if -factors not in products:
            products[factors] = None
    zeros = {c: sp.S.Zero for c in products if c in slots.coordinates}
    # x² + y² = 0 adds nothing to x = y = 0.
    needed = [c for c in products if c in zeros or multiplied_out(c.xreplace(zeros)) != 0]
    # Coordinates in their own order: x = y = 0.
    return tuple(sorted(needed, key=lambda c: slots.coordinates.index(c) if c in slots.coordinates else -1))


def _varying(e: sp.Expr, slots: Slots) -> list[sp.Expr]:
    """The factors of an expression that may vanish."""
    numerator, _ = sp.fraction(sp.together(e) if count_operations(e) <= LONGEST_MINOR else e)
    content = sp.factor_terms(numerator)
    bases = (f.as_base_exp()[0] for f in sp.Mul.make_args(content))
    return [b for b in bases if is_variable(b, slots) and not b.is_nonzero and not isinstance(b, Sign | sp.exp)]


def _factors(independent: ConstrainedSystem) -> Iterator[sp.Expr]:
    """The factors of a minor that does not vanish identically: where all minors vanish, one of them does."""
    rows = independent.rows
    if not 2 <= len(rows) <= MOST_MINOR_ROWS:
        return
    columns = independent_columns([r.coefficients for r in rows], independent.surface)
    matrix = [[r.coefficients[k] for k in columns] for r in rows]
    if len(columns) != len(rows) or sum(count_operations(e) for row in matrix for e in row) > LONGEST_MINOR:
        return
    minor = textbook_form(expanded_determinant(matrix))
    if minor.is_Add and len(minor.free_symbols) <= MOST_FACTORED_SYMBOLS:
        minor = sp.factor(minor)
    yield from dict.fromkeys(_varying(minor, independent.slots))


def _place(conditions: Sequence[sp.Expr], system: ConstrainedSystem) -> Surface:
    return kept_surface([*system.finite_constraints, *conditions], system.slots.coordinates)


def _rank(rows: Sequence[Row], place: Surface) -> int | None:
    try:
        return place.rank([r.coefficients for r in rows])
    except DivisionByZeroError:
        return None
