"""The equations of motion where a parameter vanishes, grows, or equals another, as far as that says something.

An equation of motion E(q, q', q'', p) = 0 is polynomial in its parameters once denominators are cleared. At
p = 0 it stays the equation of the system if its accelerations are still determined, that is, if the matrix ∂E/∂q'' is
regular there, and no term is neglected in which the velocity of a cyclic coordinate may grow: in a cone whose angle α
vanishes, r φ'² sin² α is p²/(m² r³ sin² α) by the momentum. For p -> oo the same is asked of the leading coefficients
in p, and equal parameters are substituted. With roots in p, as in the root of c² − v², the acceleration is taken at
1/p = 0. Of a reaction the limit at p = 0 is its value there; what can only push has to push there.

Only limits are kept that leave less to read, and that have a name or a solved form: uniform or uniformly accelerated
motion, harmonic oscillation, the simple pendulum, Kepler's problem. The equation again with a term less is none.

*Massless bodies.* What the accelerations of a system of point masses become if pulleys, drums and wheels have neither
mass nor moment of inertia.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import field
from enum import Enum
from functools import lru_cache

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero, kept_surface
from lagrange.algebra.fourier.textbook_form import common_factor, textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, base, partial, prime, t
from lagrange.mechanics.limits import LONGEST_LIMIT, LONGEST_WITH_LIMITS, MOST_LIMITS
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.mechanics.rewriting.readable_forms import is_same
from lagrange.problem.model import Assumption

_UNDEFINED = (sp.zoo, sp.nan, sp.oo, -sp.oo)


class Named(Enum):
    """Motions that have a name."""

    UNIFORM = "a constant velocity"
    ACCELERATED = "a constant acceleration"
    OSCILLATION = "a harmonic oscillation"
    PENDULUM = "a simple pendulum"
    CIRCLE = "uniform motion in a circle"
    INVERSE_SQUARE = "a central force inversely proportional to the square of the distance"
    FREE = "the equations of a free particle in a plane, in polar coordinates"


@record
class NamedMotion:
    """What an equation of motion is.

    coordinate  q, or the distance from the centre
    value       the acceleration of a uniformly accelerated motion; ω² of an oscillation, or of a pendulum with
                q'' + ω² sin q = 0; μ of an inverse square, r'' = r φ'² − μ/r²
    """

    named: Named
    coordinate: sp.Symbol
    value: sp.Expr


@record
class LimitingCase:
    """The equations of motion where a parameter vanishes, grows, or equals another; `to` is 0, oo or the other.

    reactions  the values of the reactions there that have the parameter, by symbol; none for a growing parameter
    changed    those that differ from the equations of motion, or all of them
    named      what these are, one for each, or one for all
    """

    parameter: sp.Symbol
    to: sp.Expr
    equations: tuple[sp.Expr, ...]
    reactions: Mapping[sp.Symbol, sp.Expr]
    changed: tuple[sp.Expr, ...]
    named: tuple[NamedMotion, ...]


@record
class MasslessBodies:
    """The constant accelerations without the masses and moments of inertia of the bodies.

    keeps_shape  whether a moment of inertia vanishes only with a mass, ½ m R²: its ratio to the mass stays, and so does
                 what it does to the motion
    """

    vanishing: tuple[sp.Symbol, ...]
    accelerations: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    keeps_shape: bool = False


def limiting_cases(
    solution: Solution, view: InCoordinates, reactions: Mapping[sp.Symbol, sp.Expr], pushing: Collection[sp.Symbol]
) -> Iterator[LimitingCase]:
    """The limits that have a name or a solved form; `pushing`: the forces that are positive while there is contact."""
    motion = view.motion
    assert motion is not None
    equations = tuple(e.expression for e in motion.final)
    if (
        motion.completing
        or sum(count_operations(e) for e in equations) > LONGEST_WITH_LIMITS
        or _has_functions(equations)
    ):
        return
    free = {p.symbol for p in solution.problem.parameters if p.value is None and p.symbol.is_positive}
    free -= {s for m in view.configuration.variable_masses for s in m.mass.free_symbols}
    symbols = sorted(free & {s for e in equations for s in e.free_symbols}, key=str)
    limits: list[tuple[sp.Expr, ...]] = []
    by_unit = {u: [p.symbol for p in solution.problem.parameters if p.unit == u] for u in ("m", "kg", "m/s")}
    # A pendulum of no length is none, and nothing moves without mass; a velocity as of light is large, not small.
    kept = {*by_unit["m"], *by_unit["m/s"], *(by_unit["kg"] if len(by_unit["kg"]) == 1 else ())}
    fast = [s for s in symbols if s in by_unit["m/s"]]
    constants = {p.symbol for p in solution.problem.parameters}
    acute = {p.symbol for p in solution.problem.parameters if p.assume is Assumption.ACUTE}
    flat = ((s, sp.pi / 2) for s in symbols if s in acute and len(equations) > 1)
    for parameter, to in (*((s, sp.oo) for s in fast), *_candidates(symbols, len(equations) > 1), *flat):
        if to == 0 and parameter in kept:
            continue
        limit = _limit(equations, parameter, to, view)
        if limit is None or limit in limits or (to == 0 and _neglects_what_may_grow(equations, parameter, view)):
            continue
        if to == sp.oo and not any(e.free_symbols & constants for e in limit):
            continue  # of what the problem is about nothing is left
        if to == sp.oo and _only_stops(limit, equations, view):
            continue  # what is very heavy is not accelerated: trivial
        values = (
            {}
            if to == sp.oo
            else {s: _at(e, parameter, to) for s, e in reactions.items() if parameter in e.free_symbols}
        )
        if any(s in pushing and (e is None or not e.is_nonnegative or e == 0) for s, e in values.items()):
            continue  # contact may be lost
        shown = {s: e for s, e in values.items() if e is not None and count_operations(e) <= LONGEST_LIMIT}
        still = all(e in view.configuration.slots.accelerations for e in limit)
        if to == 0 and still and shown and not any(shown.values()):
            continue  # nor that nothing happens without a cause
        whole = len(shown) == len(values) and sum(count_operations(e) for e in shown.values()) <= LONGEST_LIMIT
        if to == 0 and len(limit) > 1 and not (shown and whole) and _only_stops(limit, equations, view):
            continue  # nor that without forces there is no acceleration
        changed = tuple(e for e in limit if not any(is_same(e, f) for f in equations)) or limit
        named = named_motions(changed, limit, view)
        if named is None:
            continue  # the equation again, with a term less
        if all(m.named is Named.UNIFORM for m in named) and not (shown and whole):
            continue  # nor that a velocity stays without a cause
        yield LimitingCase(parameter, to, limit, shown if whole else {}, changed, named)
        limits.append(limit)
        if len(limits) == MOST_LIMITS:
            return


def _neglects_what_may_grow(equations: Sequence[sp.Expr], parameter: sp.Symbol, view: InCoordinates) -> bool:
    """Whether an equation loses the velocity of a cyclic coordinate whose momentum depends on other coordinates."""
    slots = view.configuration.slots
    symbols = {s for e in equations for s in e.free_symbols}
    for q, v, a in zip(slots.coordinates, slots.velocities, slots.accelerations, strict=True):
        own = [e for e in equations if a in e.free_symbols and {*slots.velocities} & e.free_symbols - {v}]
        if q in symbols or not own:
            continue
        others = [e for e in equations if a not in e.free_symbols and v in e.free_symbols]
        if any(v not in e.xreplace({parameter: sp.S.Zero}).free_symbols for e in others):
            return True
    return False


def _has_functions(equations: Sequence[sp.Expr]) -> bool:
    return any(e.has(Unspecified) for e in equations)


def _candidates(symbols: Sequence[sp.Symbol], coupled: bool) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """Each parameter to zero; those of one letter equal; each to infinity."""
    yield from ((s, sp.S.Zero) for s in symbols)
    for n, a in enumerate(symbols):
        for b in symbols[n + 1 :]:
            if a.name.rstrip("0123456789_") == b.name.rstrip("0123456789_"):
                yield b, a
    if coupled:  # of a single equation it would leave no more than its leading term
        yield from ((s, sp.oo) for s in symbols)


def _limit(
    equations: Sequence[sp.Expr], parameter: sp.Symbol, to: sp.Expr, view: InCoordinates
) -> tuple[sp.Expr, ...] | None:
    """The equations in the limit; None if they do not become much simpler, or do not determine the motion."""
    accelerations = view.configuration.slots.accelerations
    try:
        there = [_where_large(e, parameter, view) if to == sp.oo else e.xreplace({parameter: to}) for e in equations]
    except TypeError:  # SymPy compares what is undefined, as in sinh(x/a) for a → 0
        return None
    if any(e is None or e == 0 or e.has(sp.zoo, sp.nan, sp.oo) for e in there) or not _occur(accelerations, there):
        return None  # one that occurs nowhere is not determined
    shorter = [_without_common_factor(textbook_form(e)) for e in there if e is not None]
    shorter = _with_zeros(shorter, accelerations)
    before, after = (sum(count_operations(e) for e in es) for es in (equations, shorter))
    if 3 * after > 2 * before or any(count_operations(e) > LONGEST_LIMIT for e in shorter):
        return None
    try:
        regular = kept_surface().rank([[partial(e, a) for a in accelerations] for e in shorter]) == len(accelerations)
    except DivisionByZeroError:
        return None
    return tuple(shorter) if regular else None


def _only_stops(limit: Sequence[sp.Expr], equations: Sequence[sp.Expr], view: InCoordinates) -> bool:
    """Whether every equation affected by the limit now says only that an acceleration is zero."""
    changed = [e for e in limit if not any(sp.expand(e - f) == 0 for f in equations)]
    return all(e in view.configuration.slots.accelerations for e in changed)


def _with_zeros(equations: Sequence[sp.Expr], accelerations: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """The equations with the accelerations substituted that one of them says are zero."""
    zero = {e: sp.S.Zero for e in equations if e in accelerations}
    return [e if e in zero else textbook_form(e.xreplace(zero)) for e in equations] if zero else [*equations]


def _occur(symbols: Sequence[sp.Symbol], expressions: Sequence[sp.Expr]) -> bool:
    return set(symbols) <= {s for e in expressions for s in e.free_symbols}


def _without_common_factor(e: sp.Expr) -> sp.Expr:
    factor = common_factor(e)
    return e if factor.expression == 1 else textbook_form(factor.divide(e))


def _leading(e: sp.Expr, parameter: sp.Symbol) -> sp.Expr | None:
    """The coefficient of the highest power of a parameter; None if the expression is no polynomial in it."""
    by_power: dict[int, list[sp.Expr]] = {}
    for term in sp.Add.make_args(_expanded(e)):
        coefficient, power = term.as_independent(parameter, as_Add=False)
        base, exponent = power.as_base_exp() if power != 1 else (parameter, sp.S.Zero)
        if base != parameter or not exponent.is_Integer or exponent < 0:
            return None
        by_power.setdefault(int(exponent), []).append(coefficient)
    highest = max(by_power)
    return sp.Add(*by_power[highest]) if highest else e


@lru_cache(maxsize=16)
def _expanded(e: sp.Expr) -> sp.Expr:
    return sp.expand(e)


def _at(e: sp.Expr, parameter: sp.Symbol, to: sp.Expr) -> sp.Expr | None:
    value = e.xreplace({parameter: to})
    return None if value.has(sp.nan, sp.zoo, sp.oo) else textbook_form(value)


def _where_large(e: sp.Expr, parameter: sp.Symbol, view: InCoordinates) -> sp.Expr | None:
    """The leading coefficient; with roots in the parameter, q'' − its limit, for one coordinate."""
    leading = _leading(e, parameter)
    if leading is not None:
        return leading
    accelerations = view.configuration.slots.accelerations
    if len(accelerations) != 1 or not parameter.is_positive:
        return None
    [acceleration] = accelerations
    value = from_linear_equation(e, acceleration)
    if value is None:
        return None
    small = sp.Dummy("small", positive=True)
    inverse = sp.powdenest(_without_quotients_in_roots(value.xreplace({parameter: 1 / small})), force=True)
    limit = sp.expand(inverse).xreplace({small: sp.S.Zero})
    return None if limit.has(*_UNDEFINED) else acceleration - limit


def _without_quotients_in_roots(e: sp.Expr) -> sp.Expr:
    """(1/s² − v²)^r as (1 − s² v²)^r / s^(2r), for a positive s."""

    def apart(p: sp.Pow) -> sp.Expr:
        numerator, denominator = sp.fraction(sp.together(p.base))
        return sp.Pow(numerator, p.exp) * sp.powdenest(sp.Pow(denominator, -p.exp), force=True)

    roots = {p: apart(p) for p in e.atoms(sp.Pow) if p.exp.is_Rational and p.exp.q > 1}
    return e.xreplace(roots)


# What the equations are


def named_motions(
    changed: Sequence[sp.Expr], equations: Sequence[sp.Expr], view: InCoordinates
) -> tuple[NamedMotion, ...] | None:
    """What each equation is that changes, or all of them together; None if one of them has no name."""
    single = [_named(e, view) for e in changed]
    known = tuple(m for m in single if m is not None)
    if len(known) == len(single):
        return known
    together = _inverse_square(equations, view)
    return None if together is None else (together,)


def _named(e: sp.Expr, view: InCoordinates) -> NamedMotion | None:
    slots = view.configuration.slots
    own = [a for a in slots.accelerations if a in e.free_symbols]
    if len(own) != 1:
        return None
    q = base(own[0])
    value = from_linear_equation(e, own[0])
    if value is None or value.has(t, Unspecified):
        return None
    moving = {*slots.coordinates, *slots.velocities, *slots.prescribed}
    if value == 0:
        return NamedMotion(Named.CIRCLE if _is_circle(q, view) else Named.UNIFORM, q, value)
    if not value.free_symbols & moving:
        return NamedMotion(Named.ACCELERATED, q, textbook_form(value))
    if value.free_symbols & (moving - {q}):
        return None
    for of, named in ((q, Named.OSCILLATION), (sp.sin(q), Named.PENDULUM)):
        square = sp.cancel(-value / of)
        if not square.has(q) and square.is_positive:
            return NamedMotion(named, q, textbook_form(square))
    return None


def from_linear_equation(e: sp.Expr, unknown: sp.Symbol) -> sp.Expr | None:
    """The unknown from e = 0, an acceleration by the state, if e is linear in it."""
    factor = partial(e, unknown)
    if factor.has(unknown) or is_zero(factor) is not False:
        return None
    value: sp.Expr = sp.cancel(-e.xreplace({unknown: sp.S.Zero}) / factor)
    return None if value.has(*_UNDEFINED) else value


def _is_circle(q: sp.Symbol, view: InCoordinates) -> bool:
    """Whether q is the only coordinate, and an angle through which the only particle goes round a centre."""
    points = [p for p in view.configuration.points if p.mass != 0]
    if len(points) != 1 or len(view.configuration.slots.coordinates) != 1 or view.configuration.rotations:
        return False
    place = sp.Matrix(points[0].position.fixed().components)
    return place.diff(q) != sp.zeros(3, 1) and all(sp.expand(x) == 0 for x in place.diff(q, 3) + place.diff(q))


def _inverse_square(equations: Sequence[sp.Expr], view: InCoordinates) -> NamedMotion | None:
    """r'' = r φ'² − μ/r² with r φ'' + 2 r' φ' = 0, if the coordinates are polar ones of the only moving particle."""
    slots = view.configuration.slots
    if len(slots.coordinates) != 2 or len(equations) != 2:
        return None
    for r, phi in (slots.coordinates, slots.coordinates[::-1]):
        radial = [e for e in equations if prime(r, 2) in e.free_symbols and prime(phi, 2) not in e.free_symbols]
        around = [e for e in equations if prime(phi, 2) in e.free_symbols and prime(r, 2) not in e.free_symbols]
        if len(radial) != 1 or len(around) != 1:
            continue
        first, second = from_linear_equation(radial[0], prime(r, 2)), from_linear_equation(around[0], prime(phi, 2))
        if first is None or second is None or sp.cancel(second + 2 * prime(r) * prime(phi) / r) != 0:
            continue
        constant = sp.cancel((r * prime(phi) ** 2 - first) * r**2)
        if constant == 0:
            return NamedMotion(Named.FREE, r, constant)
        if not constant.free_symbols & {*slots.coordinates, *slots.velocities, t}:
            return NamedMotion(Named.INVERSE_SQUARE, r, constant)
    return None


# Bodies without mass


def massless_bodies(
    solution: Solution, view: InCoordinates, constant: Mapping[sp.Symbol, sp.Expr]
) -> MasslessBodies | None:
    """The constant accelerations without the inertia of the bodies that turn, where point masses remain."""
    if not constant or len(constant) != len(view.configuration.slots.accelerations):
        return None
    bodies = {b.name: b for b in solution.problem.bodies}
    turning = [r for r in view.configuration.rotations if r.name in bodies]
    heavy = [p.mass for p in view.configuration.points if p.name not in bodies and p.mass != 0]
    own: set[sp.Symbol] = set()
    for p in view.configuration.points:
        own |= p.mass.free_symbols if p.name in bodies else set()
    for r in turning:
        own |= {s for row in r.inertia.rows for e in row for s in e.free_symbols}
    kept = {p.symbol for p in solution.problem.parameters if p.value is None}
    kept -= {s for m in heavy for s in m.free_symbols}
    lengths = {p.symbol for p in solution.problem.parameters if p.unit == "m"}
    occur = {s for e in constant.values() for s in e.free_symbols}
    vanishing = tuple(sorted(own & kept & occur - lengths, key=str))
    if not turning or not heavy or not vanishing:
        return None
    zero = dict.fromkeys(vanishing, sp.S.Zero)
    try:
        there = {a: sp.cancel(e.xreplace(zero)) for a, e in constant.items()}
    except (TypeError, ZeroDivisionError):
        return None
    if any(e.has(*_UNDEFINED) for e in there.values()):
        return None
    shown = {a: textbook_form(sp.factor(e)) for a, e in there.items()}
    before, after = (sum(count_operations(e) for e in es.values()) for es in (constant, shown))
    masses = {s for p in view.configuration.points for s in p.mass.free_symbols}
    moments = [{s for row in r.inertia.rows for e in row for s in e.free_symbols} for r in turning]
    return MasslessBodies(vanishing, shown, any(m & masses for m in moments)) if 3 * after <= 2 * before else None
