"""The reactions of a system at rest: at each equilibrium, or at every position where unknown forces keep it."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.document.derivation import Block, Detail, Equation, Part, Ref, Rule, Step, display, listed, math, prose
from lagrange.explain.reactions import explain_bounds, reaction_lines
from lagrange.explain.words import plural, spoken
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.equilibrium.static_reactions import ReactionsAtRest, StaticReactions


def explain_reactions_at_rest(found: StaticReactions, newton: Newton) -> Step | None:
    """The multipliers and tensions at every branch of equilibria; None where there is nothing to show."""
    if not found.at or not (newton.reactions or found.configuration.rows):
        return None
    name = found.configuration.name
    suffix = f"-{name}" if name else ""
    several = len(found.at) > 1
    body: list[Block] = list(_beginning(found, newton))
    for n, there in enumerate(found.at, start=1):
        place: tuple[Part, ...] = ("At ", Ref(f"equilibrium{suffix}-{n}")) if _labelled(found) else ()
        if there is None:
            words = "the reactions are" if place else "The reactions are"
            body.append(prose(*place, " " if place else "", f"{words} not found in a form that can be written down."))
            continue
        lines = _lines(there, newton, f"{suffix}-{n}" if several else suffix)
        if lines:
            if place and several:
                body.append(prose(*place, " it is" if len(lines) == 1 else " they are"))
            body.append(display(*lines, boxed=True, detail=Detail.BRIEF))
        body += _open(there, newton)
    if not name:
        body += explain_bounds(newton)
    title = plural(len(newton.reactions), "The reaction at rest", "The reactions at rest")
    return Step(Rule.SOLVED_REACTIONS, f"{title}: {spoken(name)}" if name else title, tuple(body))


def _labelled(found: StaticReactions) -> bool:
    """Whether the branches are displayed with numbers."""
    return any(b.relations or b.left for b in found.equilibrium.branches)


def _beginning(found: StaticReactions, newton: Newton) -> Iterator[Block]:
    """The equations that are solved; those with multipliers, where nothing else has shown them."""
    if found.configuration.name:
        yield prose("In these coordinates the same equations give")
        return
    several = len(found.at) > 1
    known = _balances(newton)
    if not known:
        yield prose(
            "With multipliers for the reactions the forces are balanced for every coordinate, and not only for those "
            "whose displacements are free:"
        )
        yield _written_out(found, newton)
    where: list[Part] = ["At an equilibrium "]
    if found.equilibrium.given:
        where = ["With ", *listed(math(f) for f in found.equilibrium.forces), " as just found "]
    elif _labelled(found):
        where = ["At ", *listed(Ref(f"equilibrium-{n}") for n, _ in enumerate(found.at, start=1)), " "]
    equations: list[Part] = [*(("the equations ", *listed(known)) if known else ("these equations",))]
    sole = not any(there and there.reactions.combinations for there in found.at)
    unknowns = listed(math(r.multiplier) for r in newton.reactions) if sole else []
    words = " agree with one another, and give " if sole else " agree with one another, and give"
    yield prose(*where, *equations, words, *unknowns, "." if several else ":")


def _balances(newton: Newton) -> list[Part]:
    """The equations between applied forces and reactions that the free bodies have given."""
    if newton.bodies is None or any(c.inertia != 0 for b in newton.bodies for c in b.laws):
        return []
    found: list[Part] = []
    for b in newton.bodies:
        found += [Ref(f"newton-{b.name}-{n}") for n, _ in enumerate(b.components, start=1)]
        found += [Ref(f"turning-{b.name}-{n}") for n, _ in enumerate(b.turning, start=1)]
    return [*found, *(Ref(f"idle-{q.name}") for q in newton.idle)]


def _written_out(found: StaticReactions, newton: Newton) -> Block:
    """Q_k + Σ λ_j a_jk = 0 for every coordinate."""
    work, slots = found.equilibrium.work, found.configuration.slots
    lines = []
    for k, force in enumerate(work.forces):
        reaction = sp.Add(*(r.multiplier * r.row.coefficients[k] for r in newton.reactions))
        if force != 0 or reaction != 0:
            lines.append(Equation((force + reaction, sp.S.Zero), label=f"balance-{slots.coordinates[k].name}"))
    return display(*lines)


def _lines(there: ReactionsAtRest, newton: Newton, suffix: str) -> list[Equation]:
    reactions = there.reactions
    found = reaction_lines(reactions, newton, f"-at-rest{suffix}")
    for c in reactions.combinations:
        if c.value is not None:
            found.append(Equation((sp.Add(*(share * symbol for share, symbol in c.terms)), c.value)))
    return found


def _open(there: ReactionsAtRest, newton: Newton) -> Iterator[Block]:
    """What the equations leave open."""
    shared = {symbol for c in there.reactions.combinations for _, symbol in c.terms}
    loose = [r.multiplier for r in newton.reactions if r.multiplier in shared]
    if loose:
        yield prose(
            *listed(math(s) for s in loose), " are not determined one by one: the constraints depend on one another, "
            "and the system is statically indeterminate. Only these combinations of them are determined."
        )  # fmt: skip
    if there.open:
        one = len(there.open) == 1
        yield prose(
            *listed(math(s) for s in there.open), " is" if one else " are", " not determined here: in this position "
            "the constraints depend on one another, to first order."
        )  # fmt: skip
