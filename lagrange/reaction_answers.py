"""Is a stated reaction right?

A textbook gives the reaction of a constraint as one expression: the multiplier, the tension or thrust of a rod, the
normal force of a surface; or as an equation, T = .... It is right when the equation between it and one of these follows
from the equations of motion with multipliers, in the file's coordinates or in those of a choice.

Of a system at rest it is right when it holds at every equilibrium, exactly.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.answer_readings import Reading
from lagrange.answers import EquationVerdict, Verdict
from lagrange.comparison import Standing, compare
from lagrange.diagnostics import Fragment, ProblemError
from lagrange.exact import DivisionByZeroError, is_zero
from lagrange.expressions import MAX_ANSWER_CHARACTERS, read_equation, read_value
from lagrange.newton import Newton, Reaction
from lagrange.notation import base
from lagrange.references import Candidate, Reference
from lagrange.textbook import textbook_form
from lagrange.vectors import Vector

if TYPE_CHECKING:
    from lagrange.static_reactions import StaticReactions


def check_reaction(fragment: Fragment, reaction: Reaction, reference: Reference) -> Verdict:
    """The verdict on what is stated of one reaction."""
    try:
        claims = _claims(fragment, reaction, reference)
    except ProblemError:
        return Verdict.UNREADABLE
    verdicts = {_verdict(claim, c, reference) for claim in claims for c in reference.candidates}
    order = (Verdict.EQUIVALENT, Verdict.UNDECIDED, Verdict.WRONG)
    return next((v for v in order if v in verdicts), Verdict.UNREADABLE)


def reading_error(fragment: Fragment, reference: Reference) -> ProblemError | None:
    """Why what is stated of a reaction cannot be read; None where it can."""
    try:
        if "=" in fragment.text:
            read_equation(fragment, reference.scope, [], MAX_ANSWER_CHARACTERS)
        else:
            read_value(fragment, reference.scope, [])
    except ProblemError as error:
        return error
    return None


def _claims(fragment: Fragment, reaction: Reaction, reference: Reference) -> list[sp.Expr]:
    """What may be meant, each of these being zero."""
    if "=" in fragment.text:
        equation = read_equation(fragment, reference.scope, [], MAX_ANSWER_CHARACTERS, latex=True)
        lhs, rhs = equation.lhs, equation.rhs
        return [] if isinstance(lhs, Vector) or isinstance(rhs, Vector) else [lhs - rhs]
    value = read_value(fragment, reference.scope, [], latex=True)
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
    claim, system = candidate.read(claim), candidate.system
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


class AtRest:
    """What stated reactions of a system at rest are compared with.

    found  the reactions in the file's coordinates and in each choice
    """

    def __init__(self, newton: Newton, found: Sequence[StaticReactions], reference: Reference) -> None:
        self.newton = newton
        self.found = found
        self.reference = reference
        self.names = {*newton.multipliers_by_name.values(), *newton.tensions}

    def check_stated(self, fragment: Fragment, reaction: Reaction) -> Verdict:
        """The verdict on what the file states of one reaction."""
        try:
            claims = _claims(fragment, reaction, self.reference)
        except ProblemError:
            return Verdict.UNREADABLE
        verdicts = {self._verdict([claim]) for claim in claims}
        order = (Verdict.EQUIVALENT, Verdict.UNDECIDED, Verdict.WRONG)
        return next((v for v in order if v in verdicts), Verdict.UNREADABLE)

    def is_about(self, reading: Reading) -> bool:
        """Whether an equation of an answer says something of reactions."""
        return reading.error is None and any(e.free_symbols & self.names for e in reading.components)

    def check(self, reading: Reading) -> EquationVerdict:
        """The verdict on an equation of an answer, which is about reactions."""
        verdict = self._verdict(reading.components)
        diagnosis = {
            Verdict.WRONG: "it does not hold at every equilibrium",
            Verdict.UNDECIDED: "it could not be decided whether it is right",
            Verdict.UNREADABLE: "it divides by what is exactly zero, or mixes coordinates of several choices",
            Verdict.TRIVIAL: "it is an identity",
        }
        return EquationVerdict(reading.text, verdict, diagnosis.get(verdict, ""))

    def _verdict(self, claims: Sequence[sp.Expr]) -> Verdict:
        """The best verdict, over the meanings of names and the sets of coordinates, on claims that are all meant."""
        verdicts = {self._holds(claims, meaning, f) for meaning in self._meanings() for f in self.found}
        order = (Verdict.TRIVIAL, Verdict.EQUIVALENT, Verdict.UNDECIDED, Verdict.WRONG)
        return next((v for v in order if v in verdicts), Verdict.UNREADABLE)

    def _meanings(self) -> Iterator[Mapping[sp.Symbol, sp.Expr]]:
        """What names of forces stand for; that of a rod may mean its tension, the multiplier, or the thrust."""
        tensions = self.newton.tensions
        yield tensions
        named = [r for r in self.newton.reactions if r.named and r.tension is not None]
        if named:
            yield {**tensions, **{r.tension: r.multiplier for r in named}}
            yield {**tensions, **{r.tension: -tensions[r.tension] for r in named}}

    def _holds(
        self, claims: Sequence[sp.Expr], meaning: Mapping[sp.Symbol, sp.Expr], found: StaticReactions
    ) -> Verdict | None:
        """Whether claims hold at every equilibrium of one configuration; None where they use other coordinates."""
        configuration = found.configuration
        used = {base(s).name for e in claims for s in e.free_symbols}
        known = {s.name for s in (*configuration.slots.coordinates, *configuration.expressed)}
        if not used & {q.name for q in self.reference.scope.slots.coordinates} <= known or not found.at:
            return None
        meant = [configuration.rewritten(e.xreplace(dict(meaning))) for e in claims]
        verdicts: list[bool | None] = []
        try:
            if all(is_zero(e) for e in meant):
                return Verdict.TRIVIAL
            for there in found.at:
                if there is None or there.verified is not True:
                    verdicts.append(None)
                    continue
                values = dict(self.reference.values)
                verdicts += [there.points.holds(e.xreplace(there.rule), values) for e in meant]
        except DivisionByZeroError:
            return None
        return Verdict.WRONG if False in verdicts else Verdict.UNDECIDED if None in verdicts else Verdict.EQUIVALENT
