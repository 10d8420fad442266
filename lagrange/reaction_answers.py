"""Is a stated reaction right?

A textbook gives the reaction of a constraint as one expression: the multiplier, the tension or thrust of a rod, the
normal force of a surface; or as an equation, T = .... It is right when the equation between it and one of these follows
from the equations of motion with multipliers, in the file's coordinates or in those of a choice.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.answers import Verdict
from lagrange.comparison import Standing, compare
from lagrange.diagnostics import Fragment, ProblemError
from lagrange.exact import DivisionByZeroError
from lagrange.expressions import MAX_ANSWER_CHARACTERS, read_equation, read_value
from lagrange.newton import Reaction
from lagrange.notation import base
from lagrange.references import Candidate, Reference
from lagrange.textbook import textbook_form
from lagrange.vectors import Vector


def check_reaction(fragment: Fragment, reaction: Reaction, reference: Reference) -> Verdict:
    """The verdict on what is stated of one reaction."""
    try:
        claims = _claims(fragment, reaction, reference)
    except ProblemError:
        return Verdict.UNREADABLE
    verdicts = {_verdict(claim, c, reference) for claim in claims for c in reference.candidates}
    order = (Verdict.EQUIVALENT, Verdict.UNDECIDED, Verdict.WRONG)
    return next((v for v in order if v in verdicts), Verdict.UNREADABLE)


def _claims(fragment: Fragment, reaction: Reaction, reference: Reference) -> list[sp.Expr]:
    """What may be meant, each of these being zero."""
    if "=" in fragment.text:
        equation = read_equation(fragment, reference.scope, [], MAX_ANSWER_CHARACTERS)
        lhs, rhs = equation.lhs, equation.rhs
        return [] if isinstance(lhs, Vector) or isinstance(rhs, Vector) else [lhs - rhs]
    value = read_value(fragment, reference.scope, [])
    return [] if isinstance(value, Vector) else [force - value for force in _meanings(reaction)]


def _meanings(reaction: Reaction) -> Iterator[sp.Expr]:
    """What the one number of a reaction may be."""
    multiplier = reaction.multiplier
    yield multiplier
    if reaction.rod is not None:
        yield reaction.rod.factor * multiplier
        yield -reaction.rod.factor * multiplier
    elif reaction.is_normal and reaction.directions:
        [direction] = reaction.directions.values()
        size = textbook_form(sp.sqrt(textbook_form(direction.dot(direction))))
        yield size * multiplier
        yield -size * multiplier


def _verdict(claim: sp.Expr, candidate: Candidate, reference: Reference) -> Verdict | None:
    """The verdict in one set of coordinates; None where the claim uses others."""
    used = {base(s).name for s in claim.free_symbols}
    if not used & reference.moving <= candidate.known:
        return None
    claim = candidate.read(claim).xreplace(dict(reference.values))
    system = candidate.system_with(reference.values)
    try:
        result = compare(
            [claim], system, [u for u in reference.unknowns if u.name in used and u not in system.multipliers]
        )
    except DivisionByZeroError:
        return Verdict.UNREADABLE
    if result is None:
        return Verdict.UNDECIDED
    bad = {Standing.CONTRADICTS, Standing.NOT_LINEAR}
    return Verdict.WRONG if bad & set(result.standings) else Verdict.EQUIVALENT
