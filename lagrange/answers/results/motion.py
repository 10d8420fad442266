"""Wrong results about a motion: accelerations at the start, speeds, times, distances, places.

Wrong speeds, times and distances of a motion with a constant acceleration: which changed problem has them?

Where the energy of a coordinate q is ½ M q'² + c q with constant M and c, its acceleration A is constant, and each of

    v² = v_0² + 2 A (q − q_0) ,     q − q_0 = v_0 t + ½ A t²

gives the A that a stated speed, time or place implies. It is compared with the equations of each changed problem, as a
stated acceleration would be. A time that is the distance divided by the final velocity, or that lacks the ½, is named
as such.

Wrong accelerations and reactions at the start: which changed problem has them?

At t = 0 the state is given, so that an acceleration or a reaction follows from the equations of motion alone, which
are linear in them. A stated value is compared with the equations of each changed problem in that state.

Wrong times, places and motions where the motion is known as a function of time: what happens then and there instead.

A time that is asked for belongs to an event, y = 0 or x' = 0. A wrong one often belongs to another event: the stone is
at its highest point, the oscillation is over once and not half. A wrong place is where the acceleration vanishes, or
where another velocity does. A wrong motion x(t) does not begin as the problem says.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.linear_algebra import RowSpace
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.limits import MAX_MODEL_WORK
from lagrange.answers.models.letters import balanced_by_forces
from lagrange.answers.models.search import Models, changed_space
from lagrange.answers.models.states import ModelState
from lagrange.answers.references import ReferenceCandidate
from lagrange.core.records import record
from lagrange.core.symbols import base, prime, t
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.questions.results import Asked


@record
class Uniform:
    """A motion with a constant acceleration from q_0 with v_0."""

    coordinate: sp.Symbol
    start: sp.Expr
    velocity: sp.Expr
    acceleration: sp.Expr


def explained_uniform(
    claim: sp.Expr, asked: Asked, others: Sequence[Asked], candidates: Sequence[ReferenceCandidate]
) -> str:
    """The changed problem that gives a wrong value, in a sentence; empty if none is found."""
    own = next((c.configuration for c in candidates if c.choice == asked.choice), None)
    motion = next(filter(None, (_uniform(a, own) for a in (asked, *others) if a.choice == asked.choice)), None)
    if motion is None:
        return ""
    try:
        if asked.question.quantity == t and (place := _place(asked, motion)) is not None:
            way, end = (
                place - motion.start,
                sp.sqrt(motion.velocity**2 + 2 * motion.acceleration * (place - motion.start)),
            )
            if motion.velocity == 0 and is_zero(claim**2 - way / motion.acceleration) is True:
                return "the distance is taken as A t^2, but with a constant acceleration A from rest it is A t^2/2"
            if is_zero(claim**2 - (way / end) ** 2) is True:
                return "the distance is divided by the final velocity, but the velocity changes"
        stated = _acceleration(claim, asked, motion)
        if stated is None or is_zero(stated - motion.acceleration) is not False:
            return ""
        for candidate in candidates:
            q = motion.coordinate
            if q in candidate.configuration.slots.coordinates:
                return next(_of_models(stated, q, candidate), "")
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError, ValueError):
        pass
    return ""


def _uniform(asked: Asked, configuration: Configuration | None) -> Uniform | None:
    initial = {s.symbol: s.value for s in asked.initial}
    bound = {} if configuration is None else _bound_to_others(asked, configuration)
    for integral in asked.integrals:
        whole = sp.expand(integral.expression.xreplace(bound))
        rates = sorted((s for s in whole.free_symbols if s.name.endswith("'")), key=str)
        if integral.factor != 1 or len(rates) != 1:
            continue
        [v] = rates
        q = base(v)
        inertia, pull = 2 * whole.coeff(v, 2), whole.coeff(v, 0).diff(q)
        constant = not (inertia.has(v, q) or pull.has(v, q)) and whole.coeff(v, 1) == 0
        if constant and inertia != 0 and pull != 0 and q in initial and v in initial:
            return Uniform(q, initial[q], initial[v], -pull / inertia)
    return None


def _bound_to_others(asked: Asked, configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The velocities that a constraint with constant coefficients ties to that of the place which is asked about."""
    expressions = [asked.question.quantity, *(c.lhs - c.rhs for c in asked.question.when)]
    named = {base(s) for e in expressions for s in e.free_symbols}
    rule: dict[sp.Symbol, sp.Expr] = {}
    for row in configuration.rows:
        pairs = zip(configuration.slots.velocities, row.coefficients, strict=True)
        velocities = {v: a for v, a in pairs if a != 0}
        kept = [v for v in velocities if base(v) in named]
        if len(velocities) == 2 and len(kept) == 1 and row.drift == 0 and row.nonlinear is None:
            [other] = [v for v in velocities if v not in kept]
            rule[other] = -velocities[kept[0]] / velocities[other] * kept[0]
    return rule


def _place(asked: Asked, motion: Uniform) -> sp.Expr | None:
    """The value of q at which the question is asked; None if `when` is no such place."""
    for c in asked.question.when:
        difference = sp.expand(c.lhs - c.rhs)
        slope = difference.coeff(motion.coordinate)
        rest = sp.expand(difference - slope * motion.coordinate)
        if slope != 0 and slope.is_number and not rest.has(motion.coordinate, prime(motion.coordinate)):
            return -rest / slope
    return None


def _acceleration(claim: sp.Expr, asked: Asked, motion: Uniform) -> sp.Expr | None:
    """The A for which a stated value would be right; None if the question is of another kind."""
    q, v = motion.coordinate, prime(motion.coordinate)
    quantity, place = asked.question.quantity, _place(asked, motion)
    last = _last_velocity(asked, v)
    if place is not None and quantity in (v, v**2):
        square = claim**2 if quantity == v else claim
        return (square - motion.velocity**2) / (2 * (place - motion.start))
    if place is not None and quantity == t:
        return 2 * (place - motion.start - motion.velocity * claim) / claim**2
    if last is not None and quantity == q:
        return (last**2 - motion.velocity**2) / (2 * (claim - motion.start))
    if last is not None and quantity == t:
        return (last - motion.velocity) / claim
    return None


def _last_velocity(asked: Asked, v: sp.Symbol) -> sp.Expr | None:
    """The velocity at which the question is asked; None if `when` is no such event."""
    for c in asked.question.when:
        difference = sp.expand(c.lhs - c.rhs)
        slope = difference.coeff(v)
        rest = difference - slope * v
        if slope in (1, -1) and not rest.has(v, base(v), t):
            return -rest * slope
    return None


def explained_by_first_acceleration(claim: sp.Expr, asked: Asked, candidates: Sequence[ReferenceCandidate]) -> str:
    """Whether a wrong speed, time or place is that of a constant acceleration, the one at the start, in a sentence;
    empty if not."""
    initial = {s.symbol: s.value for s in asked.initial}
    for candidate in candidates:
        slots = candidate.configuration.slots
        if candidate.choice != asked.choice or candidate.multipliers or len(slots.coordinates) != 1:
            continue
        [q], [v], [a] = slots.coordinates, slots.velocities, slots.accelerations
        if len(candidate.system.equations) != 1 or not {q, v} <= initial.keys():
            continue
        [equation] = candidate.system.equations
        slope, rest = equation.diff(a), equation.xreplace({a: sp.S.Zero})
        if slope == 0 or slope.has(a) or not (slope.has(q, v) or rest.has(q, v)):
            continue
        first = sp.cancel((-rest / slope).xreplace({**initial, t: sp.S.Zero}))
        parameters = (slope.free_symbols | rest.free_symbols) - {q, v, t}
        if not parameters <= first.free_symbols | slope.free_symbols:
            continue  # a force that vanishes at the start is left out, rather than taken as constant
        stated = _acceleration(claim, asked, Uniform(q, initial[q], initial[v], first))
        if first != 0 and stated is not None and is_zero(stated - first) is True:
            return "the acceleration at the start is taken as constant, but it changes"
    return ""


def _of_models(stated: sp.Expr, q: sp.Symbol, candidate: ReferenceCandidate) -> Iterator[str]:
    models = candidate.models
    if models.mechanics is None:
        return
    yield from of_changed_problems(prime(q, 2) - stated, models)


# At the start


def explained_at_start(claim: sp.Expr, asked: Asked, candidates: Sequence[ReferenceCandidate]) -> str:
    """The changed problem that gives a wrong value at t = 0, in a sentence; empty if none is found.

    candidates  the file's own system, and those in chosen coordinates
    """
    return next(filter(None, (_at_start(claim, asked, c) for c in candidates)), "")


def _at_start(claim: sp.Expr, asked: Asked, candidate: ReferenceCandidate) -> str:
    question = asked.question
    slots = candidate.configuration.slots
    initial = _with_bound_velocities({s.symbol: s.value for s in asked.initial}, candidate.configuration)
    whole = {*slots.coordinates, *slots.velocities}
    moving = {base(s) for s in question.quantity.free_symbols if base(s) != s}
    at_start = all(c.lhs - c.rhs in (t, -t) for c in question.when) and bool(question.when)
    if not at_start or not whole <= initial.keys() or not moving <= whole:
        return ""
    start = {s: initial[s] for s in whole}
    try:
        equation = candidate.read(question.quantity - claim)
        models = Models(candidate.system, {**candidate.values, **start}, candidate.parts)
        if models.mechanics is None:
            return ""
        return next(of_changed_problems(equation, models), "")
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError, ValueError):
        pass
    return ""


def explained_by_free_fall(claim: sp.Expr, asked: Asked, candidates: Sequence[ReferenceCandidate]) -> str:
    """Whether a wrong acceleration at the start is that without any force of a constraint, in a sentence; empty if
    not."""
    quantity = asked.question.quantity
    initial = {s.symbol: s.value for s in asked.initial}
    for candidate in candidates:
        slots, multipliers = candidate.configuration.slots, candidate.system.multipliers
        if quantity not in slots.accelerations or not multipliers:
            continue
        start = {s: initial[s] for s in (*slots.coordinates, *slots.velocities) if s in initial}
        try:
            models = Models(candidate.system, {**candidate.values, **start}, candidate.parts)
            states = models.states([quantity - claim])
            if all(_falls_freely(quantity - claim, at, len(multipliers)) for at in states):
                return "this is the acceleration without the forces of the constraints, as if it moved freely"
        except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError, ValueError):
            continue
    return ""


def explained_as_motion(claim: sp.Expr, asked: Asked, candidates: Sequence[ReferenceCandidate]) -> str:
    """The changed problem whose equation of motion a stated acceleration is, in a sentence; empty if it is none."""
    from lagrange.answers.models.search import explained

    quantity = asked.question.quantity
    for candidate in candidates:
        if quantity not in candidate.configuration.slots.accelerations or asked.question.when:
            continue
        [found] = explained([candidate.read(quantity - claim)], [0], candidate.models)
        if found is not None:
            return found.sentence
    return ""


def explained_by_whole_weight(claim: sp.Expr, asked: Asked, candidates: Sequence[ReferenceCandidate]) -> str:
    """Whether a wrong limit follows from a normal force equal to the whole weight, in a sentence; empty if not."""
    quantity = asked.question.quantity
    related = [c.lhs - c.rhs for c in asked.question.when]
    if len(related) != 1 or quantity not in related[0].free_symbols:
        return ""
    for candidate in candidates:
        forces = [s for s in related[0].free_symbols if s in candidate.multipliers or s in candidate.meanings]
        weights = [w.vector.fixed() for w in candidate.configuration.loads if w.name == "weight"]
        if len(forces) != 1 or not weights:
            continue
        [force] = forces
        slope = related[0].diff(force)
        if slope == 0 or force in slope.free_symbols:
            continue
        stated = (-related[0].xreplace({force: sp.S.Zero}) / slope).xreplace({quantity: claim})
        total = sum(weights[1:], weights[0])
        if is_zero(sp.expand(stated**2 - total.dot(total))) is True:
            return f"{force} is taken as the whole weight"
    return ""


def explained_by_half_weight(claim: sp.Expr, asked: Asked, candidates: Sequence[ReferenceCandidate]) -> str:
    """Whether a wrong reaction is half of the weight, in a sentence; empty if not."""
    quantity = asked.question.quantity
    for candidate in candidates:
        weights = [w.vector.fixed() for w in candidate.configuration.loads if w.name == "weight"]
        if not weights or not (quantity in candidate.multipliers or quantity in candidate.meanings):
            continue
        total = sum(weights[1:], weights[0])
        if is_zero(sp.expand(4 * claim**2 - total.dot(total))) is True:
            return "this is half the weight, as one of two equal supports carries at rest"
    return ""


def _falls_freely(equation: sp.Expr, at: ModelState, count: int) -> bool:
    """Whether an equation follows from the equations of motion alone where all multipliers, the first unknowns, are
    zero."""
    row, nothing = at.row(equation), [at.point.number(0)] * count
    space = RowSpace(at.point.arithmetic, [[*nothing, *derived[count:]] for derived in at.derived])
    impossible = [*[at.point.number(0)] * len(at.unknowns), at.point.number(1)]  # chosen coordinates keep a constraint
    return row is not None and row in space and impossible not in space


def explained_in_any_state(claim: sp.Expr, asked: Asked, candidates: Sequence[ReferenceCandidate]) -> str:
    """The changed problem that gives a wrong reaction, or a wrong parameter in a relation between reactions, whatever
    the state is; or what it balances at rest. A sentence; empty if none is found."""
    quantity = asked.question.quantity
    related = [c.lhs - c.rhs for c in asked.question.when]
    stated, other = quantity - claim, None
    if len(related) == 1 and quantity in related[0].free_symbols and quantity not in claim.free_symbols:
        stated, other = (related[0].xreplace({quantity: c}) for c in (claim, 2 * claim))
    for candidate in candidates:
        try:
            equation, models = candidate.read(stated), candidate.models
            if equation.free_symbols.isdisjoint(candidate.multipliers) or models.mechanics is None:
                continue
            empty = None if other is None else candidate.read(other)
            said = balanced_by_forces(equation, models, models.states([equation]))
            if other is not None:
                said = said.replace("it balances the other forces", "with it the forces are balanced")
            if said := said or next(of_changed_problems(equation, models, empty), ""):
                return said
        except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError, ValueError):
            continue
    return ""


def _with_bound_velocities(initial: dict[sp.Symbol, sp.Expr], configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The initial state with the one velocity that a constraint between the others fixes."""
    for row in configuration.rows:
        open_ = [v for a, v in zip(row.coefficients, configuration.slots.velocities, strict=True) if a != 0]
        open_ = [v for v in open_ if v not in initial]
        if len(open_) == 1:
            form = row.velocity_form(configuration.slots).xreplace(initial)
            slope = form.diff(open_[0])
            if slope != 0 and open_[0] not in slope.free_symbols:
                initial = {**initial, open_[0]: -form.xreplace({open_[0]: sp.S.Zero}) / slope}
    return initial


def of_changed_problems(equation: sp.Expr, models: Models, empty: sp.Expr | None = None) -> Iterator[str]:
    """The changed problems whose equations an equation follows from at several states, within the work allowed.

    A value alone is explained by some odd moment of inertia far too easily, and a body is taken not to be accelerated
    rather than to lack one component of its velocity.

    empty  what must not follow as well: where N = F = 0, any relation between them holds
    """
    found = (pair for pair in _changed_problems(equation, models, empty) if pair[0] != _TOO_EASY)
    first, said = next(found, ("", ""))
    if first == _NO_VELOCITY:
        said = next((other for name, other in found if name == _NO_TRANSLATION), said)
    if said:
        yield said


_NO_VELOCITY, _NO_TRANSLATION = "carried velocity left out", "kinetic energy of one part left out"
_TOO_EASY = "moment of inertia with another factor"


def _changed_problems(equation: sp.Expr, models: Models, empty: sp.Expr | None) -> Iterator[tuple[str, str]]:
    states = models.states([equation] if empty is None else [equation, empty])
    rows = [at.row(equation) for at in states]
    none = None if empty is None else states[0].row(empty)
    work = MAX_MODEL_WORK
    for number, (name, variation) in enumerate(models.variations):
        work -= len(models.system.equations) * (len(states[0].unknowns) + 1)
        if work < 0 or None in rows:
            return
        if variation.mechanics is None or variation.is_reduced:
            continue
        space = models.space(number, variation)
        if space is None or rows[0] is None or rows[0] not in space or (none is not None and none in space):
            continue
        later = [changed_space(variation, at) for at in states[1:]]
        if all(s is not None and r is not None and r in s for s, r in zip(later, rows[1:], strict=True)):
            yield name, f"this is the answer {variation.clause}"


# Instants


StateAndRates = Mapping[sp.Symbol, sp.Expr]


def explained_as_change(stated: sp.Expr, right: Sequence[sp.Expr], of: sp.Expr, asked: Asked) -> str:
    """Whether a value is by how much the quantity, or `of` a function of it, changes from the start, in a sentence."""
    initial = {s.symbol: s.value for s in asked.initial}
    start = of.xreplace(initial)
    if of.free_symbols - {*initial} & {*asked.question.quantity.free_symbols} or start.has(asked.question.quantity):
        return ""
    try:
        for value in right:
            change = value - start
            if is_zero(start) is False and any(is_zero(stated - way) is True for way in (change, -change)):
                return "this is by how much it has changed since the start, and not its value"
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        pass
    return ""


def explained_instant(claim: sp.Expr, asked: Asked, others: Sequence[Asked]) -> str:
    """What happens at a wrong time or place, or how a wrong motion begins, in a sentence; empty if that is not found.

    others  all questions, in some of which the motion was found as a function of time
    """
    motion: dict[sp.Symbol, sp.Expr] = {}
    for a in others:
        motion |= {q: e for q, e in a.solutions.items() if a.choice == asked.choice}
    question = asked.question
    initial = {s.symbol: s.value for s in asked.initial}
    try:
        if question.by == t and question.quantity.is_Symbol:
            return next(_beginnings(claim, question.quantity, initial), "")
        if not motion or question.by is not None:
            return ""
        if question.quantity == t:
            return next(_events(claim, motion, initial, "then"), "")
        own = motion.get(question.quantity) if question.quantity.is_Symbol else None
        return "" if own is None else next(_at_place(claim, question.quantity, own, motion, initial), "")
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        return ""


def explained_alone(claim: sp.Expr, asked: Asked, candidates: Sequence[ReferenceCandidate]) -> str:
    """Whether a wrong motion is that with the other coordinates held at zero, in a sentence; empty if not."""
    q = asked.question.quantity
    for candidate in candidates if asked.question.by == t else ():
        slots, equations = candidate.configuration.slots, candidate.system.equations
        if q not in slots.coordinates or candidate.multipliers or len(slots.coordinates) != len(equations):
            continue
        motion: dict[sp.Expr, sp.Expr] = {}
        for p in slots.coordinates:
            alone = claim if p == q else sp.S.Zero
            motion |= {p: alone} | {prime(p, order): sp.diff(alone, t, order) for order in (1, 2)}
        own = equations[slots.coordinates.index(q)]
        others = [p for p in slots.coordinates if p != q and own.has(p, prime(p))]
        if others and is_zero(sp.expand(own.xreplace(motion))) is True:
            names = " and ".join(map(str, others))
            return f"this is the motion with {names} held fast, as if nothing moved there"
    return ""


def explained_balance(claim: sp.Expr, asked: Asked, candidates: Sequence[ReferenceCandidate]) -> str:
    """Whether the forces are balanced at a wrong place, in a sentence; empty if not."""
    q = asked.question.quantity
    for candidate in candidates:
        slots, unknowns = candidate.configuration.slots, candidate.multipliers
        if q not in slots.coordinates or len(unknowns) > 2:
            continue
        still = dict.fromkeys((*slots.velocities, *slots.accelerations), sp.S.Zero)
        forces = [e.xreplace(still) for e in candidate.system.equations]
        other = {*slots.coordinates} - {q}
        if any(f.free_symbols & other for f in forces) or claim.free_symbols & {*slots.coordinates}:
            continue
        try:
            there = [f.xreplace({q: candidate.read(claim)}) for f in forces]
            if _are_balanced(forces, unknowns) or not _are_balanced(there, unknowns):
                continue
        except (DivisionByZeroError, NoPointError, UnsupportedError, ValueError):
            continue
        else:
            return f"there {prime(q, 2)} = 0: the forces are balanced, and it passes with a velocity"
    return ""


def _are_balanced(forces: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> bool:
    """Whether some values of the reactions balance forces in which they are linear."""
    zero = dict.fromkeys(unknowns, sp.S.Zero)
    rows = [[*(f.diff(u) for u in unknowns), f.xreplace(zero)] for f in forces]
    minors = (sp.Matrix(chosen).det() for chosen in combinations(rows, len(unknowns) + 1))
    return all(is_zero(minor) is True for minor in minors)


def _beginnings(claim: sp.Expr, quantity: sp.Symbol, initial: Mapping[sp.Basic, sp.Expr]) -> Iterator[str]:
    for symbol, value in ((quantity, claim), (prime(quantity), sp.diff(claim, t))):
        if base(quantity) == quantity and symbol in initial:
            begins = value.xreplace({t: sp.S.Zero})
            if is_zero(begins - initial[symbol]) is False:
                yield f"at t = 0 this gives {symbol} = {_written(begins)} and not {_written(initial[symbol])}"


def _events(time: sp.Expr, motion: StateAndRates, initial: Mapping[sp.Basic, sp.Expr], when: str) -> Iterator[str]:
    """What happens at a time."""
    if is_zero(time) is not False:
        return
    states = {
        prime(q, n) if n else q: sp.diff(e, t, n).xreplace({t: time}) for q, e in motion.items() for n in (0, 1, 2)
    }
    start = {s: v for s, v in states.items() if s in initial}
    if len(start) >= 2 * len(motion) and all(is_zero(v - initial[s]) is True for s, v in start.items()):
        yield f"{when} everything is as at the start again: it is a whole period, or several"
    for n in (1, 2, 0):
        for q, e in motion.items():
            s = prime(q, n) if n else q
            rate = sp.diff(e, t, n)  # one that is constant is zero at all times
            if rate.has(t) and is_zero(states[s]) is True and is_zero(sp.diff(rate, t)) is not True:
                yield f"{when} {s} = 0, which is not what is asked for"


def _at_place(
    claim: sp.Expr, q: sp.Symbol, own: sp.Expr, motion: StateAndRates, initial: Mapping[sp.Basic, sp.Expr]
) -> Iterator[str]:
    """What happens where a coordinate has a value."""
    rate = sp.diff(own, t)
    if rate != 0 and not rate.has(t):
        yield from _events((claim - own.xreplace({t: sp.S.Zero})) / rate, motion, initial, "there")
        return
    turning = [w for w in own.atoms(sp.sin, sp.cos) if w.has(t)]
    middle = own.xreplace(dict.fromkeys(turning, sp.S.Zero))
    if turning and not middle.has(t) and is_zero(claim - middle) is True:
        yield f"there {prime(q, 2)} = 0: it is the middle of the oscillation"


def _written(e: sp.Expr) -> str:
    return text(e, Notation())
