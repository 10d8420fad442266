"""An impact: the state before, the new constraints, the principle for impulses, velocities, impulses, energy lost."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import prime, t, variation, velocity_before
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    EquationKind,
    Part,
    Prose,
    Rule,
    Step,
    display,
    listed,
    math,
    paragraph,
    prose,
)
from lagrange.explain.limits import LONGEST_IN_TEXT
from lagrange.explain.words import (
    capital,
    constraints_called,
    must_vanish,
    plural,
    spoken,
    the,
    title_in,
)
from lagrange.mechanics.constraints.displacements import virtual_displacement
from lagrange.mechanics.dynamics.reaction_signs import ForceKind
from lagrange.mechanics.energy_symbols import EnergySymbols
from lagrange.mechanics.momenta.impact import ImpulsiveMotion, ReactionImpulse
from lagrange.mechanics.results import Solution
from lagrange.mechanics.through_impact import vanishings
from lagrange.problem.model import AppliedMoment, Impact

ZERO = sp.S.Zero


def explain_impact(motion: ImpulsiveMotion, impact: Impact, letters: EnergySymbols) -> Step:
    """The step on an impact."""
    body: list[Block] = [
        *_instant(motion, impact),
        *_constraints(motion),
        *_principle(motion),
        *_velocities(motion),
        *_impulses(motion),
        *_energy(motion, letters),
    ]
    return Step(Rule.IMPACT, title_in("The impact", motion.configuration.name), tuple(body))


def explain_motion_after(after: Solution, impulsive: ImpulsiveMotion) -> Step:
    """What acts after the impact, when t = 0 is, and the equations of motion from then on."""
    persistent = [name for name in impulsive.new if any(c.name == name for c in after.problem.constraints)]
    ended = [name for name in impulsive.new if name not in persistent]
    words = "The questions are about the motion after the impact. It begins with the velocities just after it, at "
    parts: list[Part] = [words, math(t, ZERO), "."]
    if persistent:
        remain = plural(len(persistent), "remains in force", "remain in force")
        parts.append(f" {capital(constraints_called(persistent))} {remain}.")
    if ended:
        over = plural(len(ended), "no longer acts", "no longer act")
        parts.append(f" {capital(constraints_called(ended))} {over}, until the parts meet again.")
    view = next((v for v in reversed(after.views) if v.motion is not None and not v.signs), after.own)
    if view.motion is None:
        return Step(Rule.IMPACT, "The motion after the impact", (prose(*parts),))
    lines = [Equation((e.expression, ZERO), label=f"after-{n}") for n, e in enumerate(view.motion.final, start=1)]
    lines += [Equation((r.finite, ZERO), label=f"after-{r.name}") for r in view.configuration.rows if r.finite]
    motion = plural(len(view.motion.final), "The equation of motion is then", "The equations of motion are then")
    body = (prose(*parts, f" {motion}"), display(*lines))
    return Step(Rule.IMPACT, "The motion after the impact", body)


def _instant(motion: ImpulsiveMotion, impact: Impact) -> Iterator[Block]:
    """What changes in the instant and what does not; the position and the velocities before."""
    blows = [(f.moment if isinstance(f, AppliedMoment) else f.vector, f) for f in impact.impulses]
    given: list[Part] = []
    for n, (vector, f) in enumerate(blows):
        kind = "impulsive moment" if isinstance(f, AppliedMoment) else "impulse"
        given += [" and " if n else "", f"the {kind} ", math(vector.as_sum()), f" ({spoken(f.name)}) on {the(f.on)}"]
    first = prose("In the instant of an impact the velocities change and the position does not. Forces that remain "
                  "finite have no impulse.")  # fmt: skip
    acts = prose("What acts is ", *given, ".") if given else None
    position = [math(q, e) for q, e in motion.position.items()]
    at = prose("The position is ", *listed(position), ".") if position else None
    yield paragraph(*(p for p in (first, acts, at) if p is not None))
    coordinates = motion.slots.coordinates
    known = [(q, b) for q, b in zip(coordinates, motion.before, strict=True) if b != velocity_before(q)]
    free = [q for q in coordinates if q not in [k for k, _ in known]]
    if known and not free and all(b == 0 for _, b in known):
        yield prose("Just before the impact everything is at rest.")
    elif known:
        yield prose("Just before the impact the velocities are")
        yield display(
            *(Equation((velocity_before(q), b), label=f"before-{q.name}", kind=EquationKind.BEFORE) for q, b in known)
        )
    if free:
        letters = listed(math(velocity_before(q)) for q in free)
        words = plural(len(free), " is the velocity just before the impact", " are velocities just before the impact")
        yield prose(*letters, words, ", not given.")


def _constraints(motion: ImpulsiveMotion) -> Iterator[Block]:
    """The new constraints, and the virtual displacements under all of them."""
    new = [i for i in motion.impulses if i.is_new]
    if new:
        lines = []
        for i in new:
            c = i.reaction.constraint
            lines.append(Equation((c.lhs, c.rhs), label=f"new-{i.name}", relation=c.relation))
        begins = plural(len(new), " begins to act", " begin to act")
        also = ", beside those that act already" if len(new) < len(motion.impulses) else ""
        sided = " While the impact lasts the equality holds." if any(i.reaction.constraint.side for i in new) else ""
        yield prose(capital(constraints_called([i.name for i in new])), begins, also, ":")
        yield display(*lines)
        if sided:
            yield prose(sided.strip())
    rows = [r for r in motion.rows if any(a != 0 for a in r.coefficients)]
    if not rows:
        return
    yield prose(
        "Virtual displacements in this position satisfy ", "all constraints:" if len(rows) > 1 else "the constraint:"
    )
    lines = [Equation((virtual_displacement(r, motion.slots), ZERO), label=f"struck-{r.name}") for r in rows]
    yield display(*lines)


def _principle(motion: ImpulsiveMotion) -> Iterator[Block]:
    """Σ (m Δv − J)·δr = 0 in these coordinates, and the equations that follow."""
    slots, elimination = motion.slots, motion.elimination
    parts = [c * variation(q) for c, q in zip(motion.balance, slots.coordinates, strict=True)]
    workless = " in which the reactions do no work" if motion.rows else ""
    yield prose(
        f"For all virtual displacements,{workless}{',' if workless else ''} the principle for impulses holds: the "
        "changes of momentum less the given impulses do no work. Here this reads"
    )
    yield display(Equation((sp.Add(*parts, evaluate=False), ZERO), label="impulses"))
    free = [math(variation(slots.coordinates[k])) for k in elimination.independent]
    if not free:
        yield prose("No displacement is left, so the constraints alone determine the velocities.")
        return
    solved = elimination.solved(slots)
    if solved:
        lines = [Equation((q, e)) for q, e in solved.items()]
        yield prose("With")
        yield display(*lines)
    yield must_vanish(free, ())
    yield display(*(Equation((e, ZERO), label=f"impulse-equation-{n}") for n, e in enumerate(motion.equations, 1)))


def _velocities(motion: ImpulsiveMotion) -> Iterator[Block]:
    """The constraints on the velocities after, and these."""
    slots = motion.slots
    elastic = [i for i in motion.impulses if i.restitution != 0]
    if motion.rows:
        lines = []
        by_name = {i.name: i for i in motion.impulses}
        for r in motion.rows:
            e = by_name[r.name].restitution
            approach = sp.Add(r.drift, *(a * b for a, b in zip(r.coefficients, motion.before, strict=True)))
            lines.append(Equation((r.velocity_form(slots), -e * approach), label=f"after-{r.name}"))
        words: list[Part] = ["The velocities just after the impact satisfy the constraints"]
        if elastic:
            at = listed(part for i in elastic for part in (math(i.restitution),))
            words += [", where the rate of separation is that of approach times the coefficient of restitution ", *at]
        yield prose(*words, ":")
        yield display(*lines)
    count = len(motion.velocities)
    yield prose("Hence" if count else "Nothing moves.", detail=Detail.BRIEF)
    yield display(
        *(Equation((prime(q), v), label=f"velocity-after-{q.name}") for q, v in motion.all_velocities.items()),
        boxed=True,
        detail=Detail.BRIEF,
    )


def _impulses(motion: ImpulsiveMotion) -> Iterator[Block]:
    """The impulses of the reactions, what they are, and what one-sided constraints presuppose."""
    if not motion.impulses:
        return
    known = [i for i in motion.impulses if i.value is not None]
    if known:
        several = plural(len(known), "The impulse of the reaction follows", "The impulses of the reactions follow")
        yield prose(f"{several} from the momenta of all coordinates, with these velocities:")
        yield display(
            *(Equation((i.symbol, i.value), label=f"reaction-impulse-{i.name}") for i in known if i.value is not None),
            boxed=True,
        )
        yield paragraph(*map(_meaning, known))
        yield from _vanishing(motion, known)
    left = motion.open_impulses
    if left:
        yield prose(f"The impulses of {constraints_called(left)} are not determined: the constraints depend on one "
                    "another in this position, so different impulses give the same velocities.")  # fmt: skip
    for c in motion.conditions:
        one = f"{capital(constraints_called([c.constraint]))} acts "
        why = "only if the impulse presses: " if c.is_impulse else "only if it is approached: "
        yield prose(one, why, math(c.quantity, ZERO, relation="≥" if c.is_impulse else ">"), ".")


def _vanishing(motion: ImpulsiveMotion, known: list[ReactionImpulse]) -> Iterator[Block]:
    """Where an impulse is zero: a hand that holds the rod there is not jarred."""
    coefficients = [a for r in motion.rows for a in r.coefficients]
    for i in known if motion.full.loads or motion.full.torques else []:
        for v in vanishings(i.value or ZERO, coefficients):
            turns = ", and changes its sense there" if v.turns else ""
            yield prose(math(i.symbol), " vanishes where ", math(v.left, v.right), f"{turns}.")


def _meaning(i: ReactionImpulse) -> Prose:
    """The meaning of the symbol of an impulse."""
    single, called = i.reaction.single, constraints_called([i.name])
    if single is None:
        return prose(math(i.symbol), f" is the impulse of the multiplier of {called}.")
    if single.kind is ForceKind.TENSION:
        return prose(math(i.symbol), f" is the impulse of the tension of {called}, positive where it pulls.")
    if single.direction is None:
        return prose(math(i.symbol), f" is the impulse of the force of {called}.")
    return prose(math(i.symbol), f" acts on {the(single.on)} along ", math(single.direction.as_sum()), ".")


def _energy(motion: ImpulsiveMotion, letters: EnergySymbols) -> Iterator[Block]:
    """The kinetic energy before and after, what is lost and where."""
    T = letters.kinetic
    before, after = motion.kinetic
    earlier = letters.before
    blows = motion.full.loads or motion.full.torques
    if motion.is_driven:
        yield prose(
            "Positions or constraints contain time: what drives them does work too. The kinetic energy changes by"
        )
        yield display(Equation((T - earlier, motion.energy_gained), label="energy-change"))
        return
    yield prose("The kinetic energy before and after the impact is")
    yield display(Equation((earlier, before), label="energy-before"), Equation((T, after), label="energy-after"))
    if blows:
        yield prose("The blow does the work of its impulse on the mean of the velocities before and after, ",
                    math(motion.work), ".")  # fmt: skip
    places = [i for i in motion.impulses if i.lost is not None and i.lost != 0]
    if motion.energy_lost == 0:
        yield from [] if blows else [prose("No energy is lost.")]
        return
    yield prose("Beyond that work, the energy lost is" if blows else "The energy lost in the impact is")
    lost = earlier - T if not blows else earlier - T + motion.work
    yield display(Equation((lost, motion.energy_lost), label="energy-lost"), boxed=True)
    if (share := motion.share_lost) is not None and 1 < count_operations(share) <= LONGEST_IN_TEXT:
        yield prose("That is ", math(share), " of the energy before.", detail=Detail.BRIEF)
    if len(places) == 1:
        yield prose(f"It is lost at {constraints_called([places[0].name.partition('.')[0]])}.")
    elif len({i.restitution for i in places}) > 1:
        shares = [part for i in places for part in (math(i.lost), f" at {constraints_called([i.name])}")]
        parts: list[Part] = []
        for n in range(0, len(shares), 2):
            parts += [" and " if n == len(shares) - 2 else ", " if n else "", shares[n], shares[n + 1]]
        yield prose("Of this, ", *parts, plural(len(places), " is lost.", " are lost."))
