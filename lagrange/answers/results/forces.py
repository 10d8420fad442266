"""A wrong equation that states one force of constraint, N = m g cos(theta): what that force would be.

Such an equation is compared as the value of a reaction is: with that at rest, with what balances the other forces as if
nothing were accelerated, with that of a changed problem, with a multiple of the right one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, InadmissibleError, NoPointError, UnsupportedError
from lagrange.answers.limits import LONGEST_COMPARED_REACTION
from lagrange.core.symbols import base

if TYPE_CHECKING:
    from lagrange.answers.references import Reference, ReferenceCandidate
    from lagrange.mechanics.dynamics.newton import Reaction
    from lagrange.mechanics.results import Solution

RATIOS = tuple(sp.Rational(p, q) for p, q in ((2, 1), (1, 2), (3, 2), (2, 3), (3, 1), (1, 3), (4, 3), (3, 4)))
_NUMBER = "only a number is wrong in it: the force is {} times as large"


def explained_force(equation: sp.Expr, candidate: ReferenceCandidate) -> str:
    """What the stated force is, in a sentence; empty if the equation states none, or that is not found.

    An equation with accelerations is one of motion, and no value of a force.
    """
    forces = [s for s in equation.free_symbols if s in candidate.multipliers]
    slots = candidate.configuration.slots
    if len(forces) != 1 or equation.free_symbols & {*slots.accelerations}:
        return ""
    [force] = forces
    slope = equation.diff(force)
    if force in slope.free_symbols or any(base(s) != s and base(s) in slots.coordinates for s in slope.free_symbols):
        return ""
    from lagrange.answers.models.letters import explained_reaction

    opposite = equation.xreplace({force: -force})  # its name may stand for the opposite force
    for stated in (equation, opposite):
        if why := explained_reaction(stated, candidate.models) or _multiple(stated, force, candidate):
            return why
    return ""


def _multiple(equation: sp.Expr, force: sp.Symbol, candidate: ReferenceCandidate) -> str:
    """The simple ratio of the right force to the stated one, in a sentence; empty if there is none."""
    from lagrange.answers.models.letters import claim_holds
    from lagrange.answers.models.variation import Variation

    try:
        states = candidate.models.states([equation])
        equations = candidate.models.system.equations
        waves = sorted({w for e in equations for w in e.atoms(sp.sin, sp.cos) if w.args[0].is_Symbol}, key=str)
        factors = {ratio: _NUMBER.format(ratio) for ratio in RATIOS}
        for wave in waves:
            factors |= {wave: f"a factor {wave} is missing", 1 / wave: f"there is a factor {wave} too many"}
        for factor, said in factors.items():
            if all(claim_holds(equation, Variation("", "", rule={force: force / factor}), at) for at in states):
                return said
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError):
        pass
    return ""


def explained_size(claims: Sequence[sp.Expr], reaction: Reaction, reference: Reference, solution: Solution) -> str:
    """How a stated reaction differs from the derived one: by a term, a factor, a sign; empty if not found.

    claims  what may be meant, as expressions that are zero
    """
    from lagrange.answers.models.questions import NO_DEPENDENCE, explained_value

    forces = {reaction.multiplier, reaction.force, reaction.symbol}
    for view in solution.views:
        reactions = view.dynamics.reactions if view.dynamics is not None else None
        candidate = next((c for c in reference.candidates if c.choice == view.name), None)
        if reactions is None or candidate is None:
            continue
        right = reactions.sizes.get(reaction.name, reactions.multipliers.get(reaction.name))
        slots = view.configuration.slots
        moving = {*slots.coordinates, *slots.velocities, *slots.prescribed}
        if right is None or sp.count_ops(right) > LONGEST_COMPARED_REACTION:
            continue
        for zero in claims[:1]:
            if not {base(s).name for s in zero.free_symbols} & reference.moving <= candidate.known:
                continue
            value = candidate.read(-zero.xreplace(dict.fromkeys(forces, sp.S.Zero)))
            if any(base(s) != s and s not in moving and s not in right.free_symbols for s in value.free_symbols):
                continue
            resting = right.xreplace(dict.fromkeys(slots.velocities, sp.S.Zero))
            for whole, beside in ((right, ""), *([(resting, "it is that at rest, and ")] if resting != right else [])):
                for signed in (sp.expand(whole), -sp.expand(whole)):
                    why = explained_value(value, signed, moving)
                    if why and not why.startswith(NO_DEPENDENCE):
                        return f"{beside}{why}"
    return ""
