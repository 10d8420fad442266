"""The reactions as functions of position, velocity and time."""

from __future__ import annotations

import sympy as sp

from lagrange.document.derivation import Block, Detail, Equation, Part, Rule, Step, display, listed, math, prose
from lagrange.explain.words import plural, spoken
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.dynamics.multipliers import LagrangeMotion
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.dynamics.reactions import Reactions

LONGEST = 60
"""Operations of a reaction that is still shown without being asked for, where other coordinates are to be had."""


def explain_reactions(
    motion: Motion, newton: Newton, choice: str = "", shorter: bool = False, first: bool = True
) -> Step | None:
    """The multipliers and the tensions; None where there is nothing to show.

    choice   the name of the choice of coordinates that they are written in
    shorter  whether there are choices, where they may be shorter
    first    whether they have not been shown in other coordinates before
    """
    reactions = motion.reactions
    if reactions is None or not newton.reactions:
        return None
    body: list[Block] = []
    suffix = f"-{choice}" if choice else ""
    lines = reaction_lines(reactions, newton, suffix)
    long = (shorter or choice) and any(
        s.count_ops() > LONGEST for line in lines for s in line.sides if isinstance(s, sp.Expr)
    )
    lost = [
        r.name for r in newton.reactions if r.name in reactions.multipliers and reactions.multipliers[r.name] is None
    ]
    equations = "Lagrange's" if isinstance(motion.written, LagrangeMotion) else "Newton's"
    if lines and not long:
        named = newton.equations is not None or isinstance(motion.written, LagrangeMotion)
        which = f"{equations} equations" if named else "The equations with multipliers"
        words = f"{which} and the constraints, differentiated until accelerations occur, are linear in "
        what = "accelerations and multipliers; solved for the latter they give"
        body.append(prose(*((words, what) if first else ("In these coordinates the same equations give",))))
    elif lines:
        named = newton.equations is not None or isinstance(motion.written, LagrangeMotion)
        which = f"{equations} equations" if named else "these equations"
        body.append(prose(f"Solved for the multipliers, {which} give long expressions, left out here."))
    if lines:
        body.append(display(*lines, boxed=True, detail=Detail.FULL if long else Detail.STEPS))
    if lost:
        names = listed(f"of {spoken(n)}" for n in lost)
        body.append(prose("The reaction ", *names, " is too long to be written down here."))
    body += _undetermined(reactions, newton)
    body += _signs(motion)
    if first:
        body += explain_bounds(newton)
    title = f"Reactions: {spoken(choice)}" if choice else plural(len(newton.reactions), "The reaction", "The reactions")
    return Step(Rule.SOLVED_REACTIONS, title, tuple(body)) if body else None


def reaction_lines(reactions: Reactions, newton: Newton, suffix: str) -> list[Equation]:
    """The multipliers, where the file has no name for the tension, and the tensions."""
    found = []
    for r in newton.reactions:
        value = reactions.multipliers.get(r.name)
        if value is None:
            continue
        if not r.named:
            found.append(Equation((r.multiplier, value), label=f"multiplier{suffix}-{r.name}"))
        if r.tension is not None and r.name in reactions.tensions:
            found.append(Equation((r.tension, reactions.tensions[r.name]), label=f"tension{suffix}-{r.name}"))
    return found


def _undetermined(reactions: Reactions, newton: Newton) -> list[Block]:
    """What is determined where the multipliers are not."""
    loose = [r for r in newton.reactions if r.name not in reactions.multipliers]
    if not loose:
        return []
    names = listed(math(r.force) for r in loose)
    words: tuple[Part, ...] = (*names, " are not determined one by one, because the constraints depend on one another.")
    lines = [Equation(d.written) for d in reactions.combinations if d.written is not None]
    if not lines:
        return [prose(*words)]
    return [prose(*words, " What is determined is"), display(*lines)]


def _signs(motion: Motion) -> list[Block]:
    found: list[Block] = []
    for sign, value in motion.signs.items():
        condition = math(sp.Mul(sign, value, evaluate=False), sp.S.Zero, relation=">")
        found.append(
            prose("The friction depends on the reaction, and the reaction on the friction: ", math(sign),
                  " is +1 or −1, the sign of the multiplier, so that ", condition, ".")
        )  # fmt: skip
    return found


def explain_bounds(newton: Newton) -> list[Block]:
    """What rods, strings and surfaces can bear."""
    found: list[Block] = []
    rods = [r for r in newton.reactions if r.rod is not None and r.tension is not None]
    tensions = listed(math(r.tension, sp.S.Zero, relation="≥") for r in rods if r.tension is not None)
    if len(rods) == 1 and rods[0].rod is not None and rods[0].rod.centre is not None and rods[0].tension is not None:
        outside = math(rods[0].tension, sp.S.Zero, relation="≤")
        found.append(
            prose("A rod can pull and push. A string in its place, or a surface that holds the particle inside, needs ",
                  *tensions, "; a surface that carries it on its outside, ", outside, ".")
        )  # fmt: skip
    elif rods:
        found.append(
            prose("A rod can pull and push. A string in its place can only pull, and keeps its length as long as "
                  if len(rods) == 1 else
                  "Rods can pull and push. Strings in their place can only pull, and keep their lengths as long as ",
                  *tensions, ".")
        )  # fmt: skip
    normal = [r for r in newton.reactions if r.is_normal]
    if normal:
        multipliers = listed(math(r.multiplier) for r in normal)
        keep = plural(len(normal), " keeps its sign", " keep their signs")
        found.append(
            prose("A surface that can only push keeps its particle as long as ", *multipliers, keep,
                  ": there is contact while the reaction points to the side of the particle.")
        )  # fmt: skip
    return found
