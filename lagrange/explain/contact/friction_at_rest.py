"""Friction at rest: the forces that balance, the bounds, the conditions; and friction at its limit."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import sympy as sp

from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    Math,
    Mathematics,
    Part,
    Rule,
    Step,
    display,
    listed,
    math,
    parts_of,
    prose,
    series,
)
from lagrange.explain.words import (
    are,
    capital,
    constraints_called,
    joined,
    plural,
    spoken,
    suffix_of,
    the,
    title_in,
)
from lagrange.mechanics.consequences.limits_of_a_load import first_limit, for_one_load
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.equilibrium.friction.balance import BeltLaw, RoughContact
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import RestCondition
from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest
from lagrange.mechanics.equilibrium.friction.impending_motion import ImpendingMotion
from lagrange.mechanics.equilibrium.friction.rolling import Rolling
from lagrange.mechanics.equilibrium.loads import load_parameters

ZERO = sp.S.Zero


def _place(rest: AtRest) -> Iterator[Block]:
    """The position that the constraints hold, perhaps up to a displacement of the whole."""
    if rest.place:
        values = listed(math(q, v) for q, v in rest.place.items())
        moves = any(not v.free_symbols.isdisjoint(rest.configuration.slots.coordinates) for v in rest.place.values())
        begin = "Up to a displacement of the whole the constraints give " if moves else "The constraints admit "
        yield prose(begin, *values, ", as used from here on.")
    for other in rest.elsewhere:
        differing = listed(math(q, v) for q, v in other.items() if rest.place.get(q) != v)
        yield prose("They also admit ", *differing, "; there rest is impossible, or needs more friction than here.")


def explain_rest(rest: AtRest, newton: Newton) -> Step:
    """The equations of balance, the forces, the conditions."""
    suffix = suffix_of(rest.name)
    body: list[Block] = [*_contacts(rest.contacts, newton), *_belts(rest.belts)]
    if rest.equal:
        pairs = listed(math(q, e) for q, e in rest.equal.items())
        body.append(prose("For acute angles the constraints give ", *pairs, "."))
    if rest.lengths.values:
        pairs = listed(math(q, e) for q, e in rest.lengths.values.items())
        nonzero = series((math(e, ZERO, relation="≠"),) for e in rest.lengths.nonzero)
        body.append(prose("The constraints give ", *pairs, *((", where ", *nonzero) if nonzero else ()), "."))
    body += _place(rest)
    if rest.balance:
        moments = " and moments" if rest.configuration.rotations else ""
        body += _unbounded(body, rest, newton)
        body.append(prose(f"At rest the forces{moments} balance:"))
        body.append(
            display(*(Equation((e, ZERO), label=f"rest-balance{suffix}-{q.name}") for q, e in rest.balance.items()))
        )
    known = [(u, v) for u, v in rest.forces.items() if u not in rest.open]
    if known:
        body.append(prose("Solved for the forces, these equations give"))
        body.append(display(*(Equation(pair) for pair in known)))
    if rest.presupposed:
        nonzero = series((math(e, ZERO, relation="≠"),) for e in rest.presupposed)
        body.append(prose("where ", *nonzero, "."))
    if rest.equations:
        words = plural(len(rest.equations), "One equation contains no reaction and no friction: rest requires",
                       "Some equations contain no reaction and no friction: rest requires")  # fmt: skip
        lines = [Equation(pair) for pair in rest.relations]
        body += [prose(words), display(*lines, boxed=bool(rest.cases), detail=Detail.BRIEF)]
    if rest.open:
        words = " is not determined: the system is statically indeterminate. It can be at rest if "
        many = " are not determined: the system is statically indeterminate. It can be at rest if "
        end = "some distribution of the forces satisfies all bounds"
        body.append(prose(*listed(math(u) for u in rest.open), plural(len(rest.open), words, many), end, "."))
    body += _conclusion(rest, suffix)
    return Step(Rule.FRICTION_AT_REST, title_in("Rest with friction", rest.name), tuple(body))


def _unbounded(before: Iterable[Block], rest: AtRest, newton: Newton) -> Iterator[Block]:
    """`λ_1 and λ_2 are the multipliers of the first and second hinge constraints.`, where nothing has named them."""
    named = {s for b in before for p in parts_of(b) if isinstance(p, Math) for e in p.sides for s in _letters(e)}
    inside = {s for e in rest.balance.values() for s in e.free_symbols} - named
    new = [r for r in newton.reactions if (r.given or r.multiplier) in inside]
    if new:
        kinds = {"force" if r.given is not None else "multiplier" for r in new}
        kind = "force" if kinds == {"force"} else "multiplier"
        what = plural(len(new), f"the {kind}", f"the {kind}s")
        names = constraints_called(r.name for r in new)
        yield prose(*listed(math(r.given or r.multiplier) for r in new), f"{are(new)}{what} of {names}.")


def _letters(e: Mathematics) -> set[sp.Basic]:
    return set(e.free_symbols) if isinstance(e, sp.Basic) else set()


def _contacts(contacts: Sequence[RoughContact], newton: Newton) -> Iterator[Block]:
    """The friction in each contact, and its bound."""
    alone = len(contacts) == 1
    for n, c in enumerate(contacts):
        body = the(c.friction.on)
        bound = c.coefficient * (c.resultant({f: f for f, _ in c.units}) if c.also else c.normal * _magnitude(c))
        if len(c.components) == 1:
            [force], [tangent] = c.components, c.tangents
            begin = f"At rest the friction on {body} is a force " if alone else "At rest a friction force "
            acts = "" if alone else f" acts on {body}" if n == 0 else f" on {body}"
            first: tuple[Part, ...] = ("Likewise " if n else begin, math(force), " along ", math(tangent), acts)
            size: sp.Expr = sp.Abs(force)
        else:
            begin = f"Likewise that on {body} has" if n else f"At rest the friction on {body} is a force with"
            first = (f"{begin} the components ", *listed(map(math, c.components)))
            size = sp.sqrt(sp.Add(*(f**2 for f in c.components)))
        opposite = f", with the opposite on {the(c.opposite)}" if c.opposite else ""
        pressed = f"resultant of the {len(c.units)} reactions" if c.also else "normal force"
        limit = f", at most the coefficient of static friction times the {pressed}: " if n == 0 else ", with "
        yield prose(*first, opposite, limit,
                    math(size, bound, relation="≤"), ".")  # fmt: skip
    pressing = [r for r in newton.reactions if r.constraint.side is not None]
    if pressing:
        forces = series(
            (math((1 if r.named else r.constraint.side or 1) * r.force, ZERO, relation="≥"),) for r in pressing
        )
        called = constraints_called(r.name for r in pressing)
        words = plural(len(pressing), " is one-sided: ", " are one-sided: ")
        yield prose(capital(called), words, *forces, ".")


def _belts(belts: Sequence[BeltLaw]) -> Iterator[Block]:
    """The tensions of each belt, and their bound."""
    for b in belts:
        yield prose("A rope or belt touches a rough drum over the angle ", math(b.belt.angle), f" ({spoken(b.name)}). "
                    "It does not slip towards its tight side as long as ",
                    math(b.tight, b.growth * b.slack, relation="≤"), ".")  # fmt: skip


def _magnitude(c: RoughContact) -> sp.Expr:
    return sp.Abs(c.reaction.force) if c.sign is None else c.sign * c.reaction.force


def _conclusion(rest: AtRest, suffix: str) -> Iterator[Block]:
    if rest.assumed:
        positive = series((math(e, ZERO, relation=">"),) for e in rest.assumed)
        yield prose("In what follows ", *positive, plural(len(rest.assumed), " is assumed.", " are assumed."))
    if rest.bounds:
        yield prose("With the forces put in, the bounds that do not hold by themselves are")
        yield display(*(_turned(c, {*rest.open}) for c in rest.bounds))
    if not rest.cases:
        yield prose("No admissible forces satisfy the bounds: the system cannot be at rest.", detail=Detail.BRIEF)
        return
    if () in rest.cases:
        also = "further " if rest.equations else ""
        yield prose(f"The bounds can always be satisfied: there is no {also}condition.", detail=Detail.BRIEF)
        return
    several = len(rest.cases) > 1
    if several:
        yield prose("The system can be at rest in one of the following cases, in which all the conditions hold:")
    else:
        so = (*listed(math(f) for f in rest.open), " exists, and so the system can be at rest, if and only if")
        words = ("Such a force ", *so) if rest.bounds else ("The system can be at rest if and only if",)
        yield prose(*(words if not rest.equations else ("and, in addition,",)))
    loads = tuple(load_parameters(rest.configuration))
    for n, case in enumerate(rest.cases, start=1):
        number = f"-{n}" if several else ""
        stated = for_one_load(case, loads)
        lines = [_line(c, f"rest{suffix}{number}-{k}") for k, c in enumerate(stated, start=1)]
        yield display(*lines, boxed=True, detail=Detail.BRIEF)
    if rest.always is not None:
        c = rest.always
        yield prose("It holds in every position if ", math(c.right, c.left, relation="≥"), ".")
    if (first := first_limit(rest)) is not None:
        slips, tips = (math(first.coefficient, first.critical, relation=r) for r in "<>")
        yield prose("As ", math(first.load), " grows, it slips first if ", slips, ". If ", tips, ", ",
                    math(first.force), " vanishes first, and the contact of ",
                    f"{constraints_called([first.constraint])} ends.", detail=Detail.BRIEF)  # fmt: skip
    if rest.unexamined:
        where = series(((math(e, ZERO),) for e in rest.unexamined), " or ")
        yield prose("Whether it can be at rest where exactly ", *where, " is not examined.")
    if rest.partly:
        yield prose("The cases are those that occur for angles and coefficients of friction that are not large; each "
                    "is exact, and there may be others.")  # fmt: skip
    if rest.where:
        conditions = series((math(c.left, c.right, relation="<"),) for c in rest.where)
        yield prose("These are the limits where ", *conditions, "; elsewhere other combinations of the contacts limit "
                    "the force, or none does.")  # fmt: skip


def _line(condition: RestCondition, label: str) -> Equation:
    return Equation((condition.left, condition.right), relation=condition.relation, label=label)


def _turned(c: RestCondition, forces: set[sp.Symbol]) -> Equation:
    """A bound with the force on the left side: (ν + cot θ) N ≥ W/2."""
    above = bool(c.right.free_symbols & forces)
    return Equation((c.right, c.left) if above else (c.left, c.right), relation="≥" if above else c.relation)


def explain_rolling(rolling: Rolling) -> Step:
    """As long as what nothing slips."""
    body: list[Block] = []
    for c in rolling.contacts:
        by = constraints_called(r.name for r in c.reactions)
        body.append(prose(f"{capital(the(c.friction.on))} does not slip as long as the reaction of {by}, which acts at "
                          "the point that touches, is at most the coefficient of static friction times the normal "
                          f"force of {constraints_called([c.normal.name])}. They are"))  # fmt: skip
        body.append(display(Equation((c.symbol, c.size)),
                            Equation((c.normal.force, c.pressed))))  # fmt: skip
    suffix = suffix_of(rolling.configuration.name)
    if rolling.assumed:
        positive = series((math(e, ZERO, relation=">"),) for e in rolling.assumed)
        body.append(prose("Here ", *positive, plural(len(rolling.assumed), " is assumed.", " are assumed.")))
    if not rolling.cases:
        body.append(prose("This is not possible: it slips, or leaves the surface.", detail=Detail.BRIEF))
    elif () in rolling.cases:
        body.append(prose("This always holds.", detail=Detail.BRIEF))
    else:
        lines = [_line(c, f"rolling{suffix}-{n}") for n, c in enumerate(rolling.cases[0], start=1)]
        body += [prose("The condition is"), display(*lines, boxed=True, detail=Detail.BRIEF)]
    return Step(Rule.FRICTION_AT_REST, title_in("Rolling without slipping", rolling.configuration.name), tuple(body))


def explain_impending(motions: Sequence[ImpendingMotion], newton: Newton, name: str = "") -> Step:
    """Equilibrium with friction at its limit, for each direction of slip; `name` of the choice of coordinates."""
    if not motions:
        words = (
            "With friction at its limit, the forces balance for none of the directions of slip that the file leaves "
            "open. A direction of slip that is given may have the wrong sign."
        )
        return Step(Rule.FRICTION_AT_REST, title_in("Impending motion", name), (prose(words, detail=Detail.BRIEF),))
    suffix = suffix_of(name)
    contacts, belts = motions[0].contacts, motions[0].belts
    slips = "slip impends in every contact at once" if len(contacts) + len(belts) > 1 else "slip impends"
    body: list[Block] = [prose(f"If {slips}, friction has its greatest value, against the direction of the slip.")]
    body += [
        prose(f"Then the tensions of {the(b.name)} satisfy ", math(b.tight, b.growth * b.slack), ".") for b in belts
    ]
    open_ = [c.name for c in contacts if c.friction.toward is None and c.friction.slip is None]
    if open_:
        body.append(prose(f"For {joined(map(spoken, open_))} the direction is not given: both are tried."))
    for n, m in enumerate(motions, start=1):
        body += _one_direction(m, newton, f"{suffix}-{n}" if len(motions) > 1 else suffix)
    return Step(Rule.FRICTION_AT_REST, title_in("Impending motion", name), tuple(body))


def _named(c: RoughContact, m: ImpendingMotion) -> tuple[Part, ...]:
    """The name of a contact, where there are several."""
    return (f" ({spoken(c.name)})",) if len(m.contacts) > 1 else ()


def _one_direction(m: ImpendingMotion, newton: Newton, suffix: str) -> Iterator[Block]:
    conditions = (*(c.expression for c in m.equilibrium.conditions), *m.equilibrium.laws)
    if newton.reactions:
        slips = series(
            ("along ", math(c.tangents[0] * sp.Integer(-m.senses[c.name])), *_named(c, m)) for c in m.contacts
        )
        yield prose(*(("With slip impending ", *slips, ", the") if m.contacts else ("The",)),
                    " equations of balance give")  # fmt: skip
        yield display(*(Equation((r.force, m.pressed[r.name])) for r in newton.reactions))
        among = ", with the friction among the applied forces," if m.contacts else ""
        yield prose(f"so that{among} the conditions of equilibrium are" if conditions else "No condition is left.")
    elif conditions:
        yield prose("The conditions of equilibrium are")
    yield display(*(Equation((e, ZERO)) for e in conditions))
    for n, b in enumerate(m.equilibrium.branches, start=1):
        number = f"-{n}" if len(m.equilibrium.branches) > 1 else ""
        lines = [
            Equation((r.lhs, r.rhs), label=f"impending{suffix}{number}-{k}") for k, r in enumerate(b.equations, start=1)
        ]
        yield prose("or if" if n > 1 else "They hold if" if conditions else "The position is")
        yield display(*lines, boxed=True, detail=Detail.BRIEF)
        if b.conditions:
            listed_ = series((math(c.lhs, c.rhs, relation=c.relation),) for c in b.conditions)
            yield prose("where ", *listed_, ".")
    branches = m.equilibrium.branches
    pressed = m.pressed_with(branches[0]) if len(branches) == 1 else m.pressed
    if any(pressed[r.name] != m.pressed[r.name] for r in newton.reactions):
        yield prose(plural(len(newton.reactions), "The reaction is then", "The reactions are then"))
        yield display(*(Equation((r.force, pressed[r.name])) for r in newton.reactions), boxed=True)
    if unsure := m.may_be_lifted(newton, pressed):
        yield prose("Contact requires ", *series((math(f, ZERO, relation="≥"),) for f in unsure.values()), ".")
