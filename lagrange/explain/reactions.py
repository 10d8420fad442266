"""The reactions as functions of position, velocity and time; at rest, at each equilibrium or given position."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Sign, t
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    Part,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    prose,
)
from lagrange.explain.contact.one_sided import explain_contacts
from lagrange.explain.limits import LONGEST_IN_TEXT, LONGEST_REACTION, LONGEST_REACTIONS
from lagrange.explain.words import are, capital, constraints_called, joined, plural, suffix_of, the, title_in
from lagrange.mechanics.dynamics.equations import LagrangeMotion
from lagrange.mechanics.dynamics.free_bodies import without_root
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.reaction_signs import SURFACES
from lagrange.mechanics.dynamics.reactions import Reactions
from lagrange.mechanics.rewriting.constraint_forms import is_drive
from lagrange.problem.model import Keeper

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.static_reactions import ReactionsAtRest, StaticReactions
    from lagrange.mechanics.nearby.long_equations import LongReactions


def explain_reactions(
    motion: Motion,
    newton: Newton,
    choice: str = "",
    shorter: bool = False,
    first: bool = True,
    lost_ones: LongReactions | None = None,
) -> Step | None:
    """The multipliers and the tensions; None if there is nothing to show.

    choice   the name of the choice of coordinates in which they are written
    shorter  whether there are choices, in which they may be shorter
    first    whether they have not been shown in other coordinates before
    lost_ones  those that are too long in every set of coordinates
    """
    reactions = motion.reactions
    if reactions is None or not newton.reactions:
        return None
    body: list[Block] = []
    suffix = suffix_of(choice)
    lines = reaction_lines(reactions, newton, suffix)
    long = (shorter or choice) and any(
        count_operations(s) > LONGEST_REACTION for line in lines for s in line.sides if isinstance(s, sp.Expr)
    )
    lost = [
        r.name for r in newton.reactions if r.name in reactions.multipliers and reactions.multipliers[r.name] is None
    ]
    by_lagrange = isinstance(motion.written, LagrangeMotion)
    equations = "Lagrange's equations" if by_lagrange else "Newton's equations"
    if newton.equations is None and not by_lagrange:
        equations = "the equations with multipliers"
    if lines and not long:
        words = f"{equations} and {_differentiated(newton)}, give"
        body.append(prose(capital(words) if first else "In these coordinates the same equations give"))
    elif lines:
        body.append(prose(f"Solved for the multipliers, {equations} give long expressions."))
    if lines:
        body.append(display(*lines, boxed=True, detail=Detail.FULL if long else Detail.STEPS))
    if lost and first and lost_ones is not None:
        body += explain_long_reactions(lost_ones)
    elif lost:
        reactions_of = plural(len(lost), "The reaction of", "The reactions of")
        verb = plural(len(lost), "is", "are")
        body.append(prose(f"{reactions_of} {constraints_called(lost)} {verb} too long to be written out here."))
    body += _undetermined(reactions, newton)
    body += _signs(motion)
    body += explain_contacts(reactions, newton)
    if first:
        pressed = {f.reaction.name for f in motion.friction_forces if not isinstance(f.contact, Sign)}
        body += explain_bounds(newton, pressed)
    return Step(Rule.SOLVED_REACTIONS, title_in(title_of_reactions(newton), choice), tuple(body)) if body else None


def title_of_reactions(newton: Newton) -> str:
    """The title of the step."""
    return plural(len(newton.reactions), "The reaction", "The reactions")


def _differentiated(newton: Newton) -> str:
    """`the constraint, differentiated twice`: as often as it takes for accelerations to appear."""
    kinds = {r.row.finite is None for r in newton.reactions}
    often = "until accelerations appear" if len(kinds) > 1 else "once" if True in kinds else "twice"
    return f"{plural(len(newton.reactions), 'the constraint', 'the constraints')}, differentiated {often}"


def reaction_lines(reactions: Reactions, newton: Newton, suffix: str) -> list[Equation]:
    """The multipliers, where the file has no name for the tension, and the tensions."""
    lines = []
    for r in newton.reactions:
        value = reactions.multipliers.get(r.name)
        if value is None:
            continue
        velocities = {*reactions.configuration.slots.velocities}
        if not r.named:
            where = while_moving(value, velocities)
            lines.append(Equation((r.multiplier, value), label=f"multiplier{suffix}-{r.name}", condition=where))
        if r.symbol is not None and r.name in reactions.sizes:
            label, size = "tension" if r.tension is not None else "force", reactions.sizes[r.name]
            where = while_moving(size, velocities)
            lines.append(Equation((r.symbol, size), label=f"{label}{suffix}-{r.name}", condition=where))
    return lines


def while_moving(value: sp.Expr, velocities: Collection[sp.Symbol]) -> tuple[Part, ...]:
    """`where z' ≠ 0`, of a velocity by which the value is divided: the motion may come to a place where it vanishes."""
    below = {p.base for p in value.atoms(sp.Pow) if p.exp.is_negative and p.base in velocities}
    return ("where ", *listed(math(v, sp.S.Zero, relation="≠") for v in sorted(below, key=str))) if below else ()


def _undetermined(reactions: Reactions, newton: Newton) -> list[Block]:
    """The combinations that are determined where the multipliers are not."""
    loose = [r for r in newton.reactions if r.name not in reactions.multipliers]
    if not loose:
        return []
    names = listed(math(r.force) for r in loose)
    words: tuple[Part, ...] = (
        *names, are(loose), "not determined individually, because the constraints are not independent.",
    )  # fmt: skip
    lines = [Equation(d.written) for d in reactions.combinations if d.written is not None]
    if not lines:
        return [prose(*words)]
    return [prose(*words, " The equations determine only"), display(*lines)]


def _signs(motion: Motion) -> list[Block]:
    blocks: list[Block] = []
    for sign, value in motion.signs.items():
        condition = math(sp.Mul(sign, value, evaluate=False), sp.S.Zero, relation=">")
        blocks.append(
            prose("The friction depends on the reaction, and the reaction on the friction: ", math(sign),
                  " is +1 or −1, the sign of the multiplier, so that ", condition, ".")
        )  # fmt: skip
    return blocks


CORDS = ("rope", "string", "cord", "thread", "chain")
"""What can only pull, by the names of constraints."""
BOTH_SIDES = ("wire", "hoop", "ring", "rail", "slot", "tube", "track")
"""What holds a particle from both sides, by the names of constraints."""


def _holds(reaction: Reaction) -> bool:
    return any(word in reaction.name for word in BOTH_SIDES)


def _is_taut(value: sp.Expr) -> tuple[Part, ...] | None:
    """Where a tension is positive: everywhere, or ` where z > 0`; None if its sign is not evident."""
    if value.is_positive:
        return ()
    open_ = [f for f in sp.Mul.make_args(value) if not f.is_positive]
    if len(open_) != 1:
        return None
    base, exponent = open_[0].as_base_exp()
    odd = exponent.is_Integer and exponent % 2 == 1
    return (" where ", math(base, sp.S.Zero, relation=">")) if base.is_Symbol and odd else None


def explain_bounds(
    newton: Newton, pressed: Collection[str] = (), values: Mapping[str, sp.Expr] = MappingProxyType({})
) -> list[Block]:
    """The forces that rods, strings and surfaces can exert, where the constraints do not tell.

    pressed  names of constraints of which friction has said already that they press
    values   the tensions, by constraint, if they are known
    """
    blocks: list[Block] = []
    open_ = [r for r in newton.reactions if r.constraint.side is None]
    pulling = [r for r in open_ if r.tension is not None and r.constraint.by not in (Keeper.ROD, *SURFACES)]
    strings = [r for r in pulling if r.constraint.by is Keeper.STRING or r.rod is None]
    rods = [(r, r.rod) for r in pulling if r.rod is not None and r not in strings and not r.on_body]
    tensions = listed(math(r.tension, sp.S.Zero, relation="≥") for r, _ in rods if r.tension is not None)
    known = {r.name: _is_taut(values[r.name]) for r in strings if r.name in values}
    for r in [r for r in strings if known.get(r.name) is not None and r.tension is not None]:
        strings.remove(r)
        pulls: tuple[Part, ...] = (
            "A string can only pull: it is taut, since ",
            math(r.tension, sp.S.Zero, relation=">"),
        )
        blocks.append(prose(*pulls, *(known[r.name] or ()), "."))
    taut = listed(math(r.tension, sp.S.Zero, relation="≥") for r in strings if r.tension is not None)
    if strings:
        words = plural(len(strings), "A string can only pull, and stays taut as long as ",
                       "Strings can only pull, and stay taut as long as ")  # fmt: skip
        blocks.append(prose(words, *taut, "."))
    if len(rods) == 1 and rods[0][1].centre is not None and rods[0][0].tension is not None:
        slack = math(rods[0][0].tension, sp.S.Zero, relation="<")
        cord = next((word for word in CORDS if word in rods[0][0].name), None)
        if "rod" in rods[0][0].name:
            blocks.append(
                prose(
                    "A rod may also push; a string in its place would go slack where ",
                    slack,
                    ".",
                    purpose=Purpose.MAY_PUSH,
                )
            )
        elif cord is not None:
            blocks.append(prose(f"A {cord} can only pull, and stays taut as long as ", *tensions, "."))
        else:
            outside = math(rods[0][0].tension, sp.S.Zero, relation="≤")
            blocks.append(
                prose("What can only act inwards, as a string or the inside of a bowl, requires ", *tensions,
                      "; what can only act outwards, as the surface of a sphere, requires ", outside, ".")
            )  # fmt: skip
    elif rods:
        blocks.append(
            prose(plural(len(rods), "A rod may also push; a string in its place would stay taut as long as ",
                         "Rods may also push; strings in their place would stay taut as long as "), *tensions, ".",
                  purpose=Purpose.MAY_PUSH)
        )  # fmt: skip
    for r in pulling:
        if r.on_body and r not in strings and r.rod is not None and r.tension is not None:
            first, second = r.rod.ends
            outside, inside = (math(r.tension, sp.S.Zero, relation=sign) for sign in "≤≥")
            bodies = joined(map(the, (first, second))) if second else f"{the(first)} and the surface"
            blocks.append(
                prose(f"Where {bodies} touch, they can only push each other: contact from outside requires ", outside,
                      ", contact from inside ", inside, ". A string, which can only pull, requires ", inside, " too.")
            )  # fmt: skip
    other = (Keeper.WIRE, Keeper.STRING, Keeper.ROD)
    threaded = {p for r in newton.reactions if r.constraint.by in other or _holds(r) for p in r.acts_on}
    supports = [r for r in open_ if r.is_normal and r.name not in pressed and not is_drive(r)]
    normal = [r for r in supports if threaded.isdisjoint(r.acts_on)]
    blocks += [pushed_side(r) for r in normal]
    return blocks


def pushed_side(reaction: Reaction, gradient: sp.Expr | None = None) -> Prose:
    """`A support that can only push requires N > 0 where P is on the side to which 𝐣 points, N < 0 ...`

    gradient  the direction of the force for λ = 1, where the page has a symbol for it
    """
    above, below = (math(reaction.force, sp.S.Zero, relation=sign) for sign in "><")
    [particle] = reaction.acts_on
    along = reaction.per_unit(particle) if gradient is None else gradient
    long = isinstance(along, Vector) and sum(map(count_operations, along.components)) > LONGEST_IN_TEXT
    side: tuple[Part, ...] = (f"where {the(particle)} is on the side to which ", math(along), " points")
    if along is None or long:
        side = ("where the left side less the right side increases towards ", the(particle))
    return prose("A support that can only push requires ", above, " ", *side, ", ", below,
                 " where it is on the other.", purpose=Purpose.ONLY_PUSHES)  # fmt: skip


def explain_reactions_at_rest(
    static: StaticReactions, newton: Newton, own: StaticReactions | None = None
) -> Step | None:
    """The multipliers and tensions at every branch of equilibria; None if there is nothing to show.

    own  those in the file's coordinates, if `static` is in others and no step before has shown the equations
    """
    if not static.at or not (newton.reactions or static.configuration.rows):
        return None
    name = static.configuration.name
    from lagrange.mechanics.equilibrium.static_reactions import would_act_backwards

    suffix = suffix_of(name)
    several = len(static.at) > 1
    body: list[Block] = list(_beginning(static, newton, own))
    groups: dict[object, list[int]] = {}
    for n, there in enumerate(static.at, start=1):
        same = () if there is None else tuple(e.sides for e in _lines(there, newton, suffix))
        groups.setdefault(same or n, []).append(n)
    for numbers in groups.values():
        first, there = numbers[0], static.at[numbers[0] - 1]
        refs = listed(Ref(f"equilibrium{suffix}-{n}") for n in numbers)
        place: tuple[Part, ...] = ("At ", *refs) if _labelled(static) else ()
        if there is None:
            words = "the reactions are" if place else "The reactions are"
            body.append(prose(*place, " " if place else "", f"{words} not found in a form that can be written out."))
            continue
        lines = _lines(there, newton, f"{suffix}-{first}" if several else suffix)
        if lines:
            if place and several:
                body.append(prose(*place, " it is" if len(lines) == 1 else " they are"))
            body.append(display(*lines, boxed=True, detail=Detail.BRIEF))
        body += _open(there, newton)
        body += explain_contacts(there.reactions, newton, place if several else (), there.contact)
        slack = [r for r in would_act_backwards(there, newton) if r.constraint.side is None]
        if slack:
            forces = listed(math(r.symbol_of_force or r.force, sp.S.Zero, relation="<") for r in slack)
            are_ = plural(len(slack), "a string cannot push", "strings cannot push")
            body.append(prose(*forces, f": {are_}, so this is no equilibrium.", purpose=Purpose.CONTACT))
    if not name or own is not None:
        alone = static.at[0] if len(static.at) == 1 else None
        body += explain_bounds(newton, values=alone.reactions.sizes if alone is not None else {})
    title = plural(len(newton.reactions), "The reaction at rest", "The reactions at rest")
    return Step(Rule.SOLVED_REACTIONS, title_in(title, name), tuple(body))


def _labelled(static: StaticReactions) -> bool:
    """Whether the branches are displayed with numbers."""
    return any(b.relations or b.left for b in static.equilibrium.branches)


def _beginning(static: StaticReactions, newton: Newton, own: StaticReactions | None) -> Iterator[Block]:
    """The equations to be solved; those containing multipliers if they have not been shown before."""
    suffix = suffix_of(static.configuration.name)
    if suffix and own is None:
        yield prose("In these coordinates the same equations give")
        return
    several = len(static.at) > 1
    known = _balances(newton)
    if not known:
        what = "" if all(r.force != r.multiplier for r in newton.reactions) else "multipliers for "
        yield prose(
            f"With {what}the reactions, the generalized forces add up to zero in every coordinate, not only in those "
            "whose displacements are free:"
        )
        yield _written_out(own or static, newton)
    where: list[Part] = ["At an equilibrium "]
    if static.equilibrium.given:
        where = ["With ", *listed(math(f) for f in static.equilibrium.forces), " as just found "]
    elif _labelled(static):
        where = ["At ", *listed(Ref(f"equilibrium{suffix}-{n}") for n, _ in enumerate(static.at, start=1)), " "]
    equations: list[Part] = [*(("the equations ", *listed(known)) if known else ("these equations",))]
    sole = not any(there and there.reactions.combinations for there in static.at)
    unknowns = listed(math(r.given or r.multiplier) for r in newton.reactions) if sole else []
    words = " are consistent and give " if sole else " are consistent and give"
    yield prose(*where, *equations, words, *unknowns, "." if several else ":")


def _balances(newton: Newton) -> list[Part]:
    """The equations between applied forces and reactions that the free bodies have given."""
    if newton.bodies is None or any(c.inertia != 0 for b in newton.bodies for c in b.laws):
        return []
    balances: list[Part] = []
    for b in newton.bodies:
        balances += [Ref(f"newton-{b.name}-{n}") for n, _ in enumerate(b.components, start=1)]
        balances += [Ref(f"turning-{b.name}-{n}") for n, _ in enumerate(b.turning, start=1)]
    return [*balances, *(Ref(f"idle-{q.name}") for q in newton.idle)]


def _written_out(static: StaticReactions, newton: Newton) -> Block:
    """Q_k + Σ λ_j a_jk = 0 for every coordinate."""
    work, slots = static.equilibrium.work, static.configuration.slots
    lines, rows = [], [(r.force * r.per_force, without_root(r.row, slots)) for r in newton.reactions]
    for k, force in enumerate(work.forces):
        reaction = sp.Add(*(multiplier * row.coefficients[k] for multiplier, row in rows))
        if force != 0 or reaction != 0:
            lines.append(Equation((force + reaction, sp.S.Zero), label=f"balance-{slots.coordinates[k].name}"))
    return display(*lines)


def _lines(there: ReactionsAtRest, newton: Newton, suffix: str) -> list[Equation]:
    reactions = there.reactions
    lines = reaction_lines(reactions, newton, f"-at-rest{suffix}")
    for c in reactions.combinations:
        if c.value is not None:
            lines.append(Equation((sp.Add(*(share * symbol for share, symbol in c.terms)), c.value)))
    return lines


def _open(there: ReactionsAtRest, newton: Newton) -> Iterator[Block]:
    """The multipliers that the equations do not determine."""
    shared = {symbol for c in there.reactions.combinations for _, symbol in c.terms}
    loose = [r.multiplier for r in newton.reactions if r.multiplier in shared]
    if loose:
        yield prose(
            *listed(math(s) for s in loose), " are not determined individually: the constraints are not independent, "
            "and the system is statically indeterminate. Only these combinations of them are determined."
        )  # fmt: skip
    if there.open:
        yield prose(
            *listed(math(s) for s in there.open), are(there.open), "not determined here: in this position the "
            "constraints are not independent, to first order."
        )  # fmt: skip


# -- Reactions that are too long as functions of position and velocity: by the accelerations, and in numbers -----------


ZERO = sp.S.Zero


def explain_long_reactions(reactions: LongReactions) -> Iterator[Block]:
    """What is too long, where it is, what it is in terms of accelerations, and the numbers at one state."""
    names = [r.name for r in reactions.lost]
    words = plural(len(names), "The reaction of ", "The reactions of ") + constraints_called(names)
    words += plural(len(names), " is", " are") + " too long to be written as functions of position and velocity."
    values = [reactions.by_accelerations.get(name) for name in names]
    if all(e is not None and not any(s.name.endswith("''") for s in e.free_symbols) for e in values):
        yield prose("Newton's equations alone give")
        yield display(
            *(Equation((r.force, reactions.by_accelerations[r.name]), label=f"by-accelerations-{r.name}")
              for r in reactions.lost),
            boxed=True,
        )  # fmt: skip
    elif reactions.by_accelerations:
        detail = (
            Detail.FULL
            if sum(count_operations(e) for e in reactions.by_accelerations.values()) > LONGEST_REACTIONS
            else Detail.STEPS
        )
        if detail is Detail.FULL:
            yield prose(f"{words} In terms of the accelerations, Newton's equations give them in fewer: "
                        "--detail full shows these.")  # fmt: skip
            yield prose("They are", detail=detail)
        else:
            reason = Phrase(f"{words} ", Purpose.REASON)
            yield prose(reason, "In terms of the accelerations, Newton's equations give")
        yield display(
            *(
                Equation((r.force, reactions.by_accelerations[r.name]), label=f"by-accelerations-{r.name}")
                for r in reactions.lost
                if r.name in reactions.by_accelerations
            ),
            boxed=True,
            detail=detail,
        )
    else:
        yield prose(words)
    if reactions.at is not None:
        from lagrange.values.quantities import rounded_in

        state: tuple[Part, ...] = ("At the start, ", math(t, ZERO), ", they are, in SI units,")
        if not reactions.from_initial:
            shown = [math(s, rounded_in(e)) for s, e in reactions.at.state.items()]
            state = ("In the position and with the velocities ", *listed(shown), " they are, in SI units,")
        yield prose(*state)
        yield display(
            *(
                Equation((r.force, rounded_in(reactions.numbers[r.name])))
                for r in reactions.lost
                if r.name in reactions.numbers
            )
        )
