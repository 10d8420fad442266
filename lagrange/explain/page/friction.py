"""Friction in d'Alembert's principle: the normal force that it contains has to be known before."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import t
from lagrange.document.derivation import Display, Equation, Purpose, Ref, Rule, Step, has_purpose, listed, math, prose
from lagrange.mechanics.results import Solution


def with_reaction_first(solution: Solution, steps: Sequence[Step]) -> list[Step]:
    """The steps, the reactions before the principle where friction contains them.

    Reactions do no work and drop out of the principle, but the friction μ N does not. Newton's law and the constraints
    give N by themselves.
    """
    # Of what rolls the friction is a reaction: it drops out.
    slipping = () if solution.own.dynamics is None else solution.own.dynamics.friction_forces
    rough = {c for f in slipping for c in f.friction.constraints}
    principle = _only(steps, Rule.PRINCIPLE)
    reactions = _only(steps, Rule.SOLVED_REACTIONS)
    if not rough or principle is None or reactions is None or reactions < principle or solution.law is None:
        return [*steps]
    forces = {r.force for r in solution.law.newton.reactions if r.name in rough}
    given = [
        e
        for b in steps[reactions].body
        if isinstance(b, Display)
        for e in b.equations
        if e.label and e.sides[0] in forces and _is_in_given_coordinates(solution, e)
    ]
    if {e.sides[0] for e in given} != forces:
        return [*steps]
    here = steps[principle]
    names = listed(math(e.sides[0]) for e in given if isinstance(e.sides[0], sp.Expr))
    refs = listed(Ref(e.label) for e in given if e.label)
    said = prose("The friction stays, with ", *names, " from ", *refs, ".")
    at = next((n for n, b in enumerate(here.body) if has_purpose(b, Purpose.WRITTEN_OUT)), len(here.body))
    changed = replace(here, body=(*here.body[:at], said, *here.body[at:]))
    others = [*steps[principle + 1 : reactions], *steps[reactions + 1 :]]
    return [*steps[:principle], steps[reactions], changed, *others]


def _only(steps: Sequence[Step], rule: Rule) -> int | None:
    """The index of the only step of a kind that is not folded."""
    found = [n for n, s in enumerate(steps) if s.rule is rule and not s.folded]
    return found[0] if len(found) == 1 else None


def _is_in_given_coordinates(solution: Solution, e: Equation) -> bool:
    """Whether the value contains nothing but what the page has introduced before the principle."""
    problem = solution.problem
    known = {*problem.slots.coordinates, *problem.slots.velocities, *(p.symbol for p in problem.parameters), t}
    return all(isinstance(s, sp.Expr) and s.free_symbols <= known for s in e.sides[1:])
