"""Is a stated reaction right?

A textbook gives the reaction of a constraint as one expression: the multiplier, the tension or thrust of a rod, the
normal force of a surface; or as an equation, T = .... It is right when the equation between it and one of these follows
from the equations of motion with multipliers, in the file's coordinates or in those of a choice.

Of a system at rest it is right when it holds at every equilibrium, exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, is_zero
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.answers.answer_readings import Reading
from lagrange.answers.equations import EquationVerdict, Verdict
from lagrange.answers.references import AS_MULTIPLIER, AS_THRUST, Candidate, Reference
from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import base
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import MAX_ANSWER_CHARACTERS, read_equation, read_value
from lagrange.mechanics.dynamics.comparison import Standing, compare
from lagrange.mechanics.dynamics.newton import Newton, Reaction

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.static_reactions import StaticReactions


def check_reaction(fragment: Fragment, reaction: Reaction, reference: Reference) -> EquationVerdict | None:
    """The verdict on what is stated of one reaction; None where no set of coordinates has all that it uses.

    Where it is right with another meaning of the reaction than the derivation's, the remark says which was taken.
    Raises ProblemError where it cannot be read.
    """
    return _stated(fragment, reaction, reference, lambda text, claim: _judged(text, claim, reference))


def _stated(
    fragment: Fragment,
    reaction: Reaction,
    reference: Reference,
    judged: Callable[[str, Claim], Iterator[EquationVerdict]],
) -> EquationVerdict | None:
    """The best verdict on all that may be meant; None where nothing is said of any of it."""
    text = f"{reaction.name}: {fragment.text}"
    claims = _claims(fragment, reaction, reference)
    if not claims:
        return EquationVerdict(text, Verdict.UNREADABLE)
    return _best((verdict for claim in claims for verdict in judged(text, claim)), _STATED)


_STATED = (Verdict.EQUIVALENT, Verdict.UNDECIDED, Verdict.WRONG)


def _best(found: Iterable[EquationVerdict], order: Sequence[Verdict]) -> EquationVerdict | None:
    """The first with the first verdict of an order, otherwise any; None where there are none. No more are asked for."""
    best: EquationVerdict | None = None
    for judged in found:
        if judged.verdict is order[0]:
            return judged
        if best is None or _rank(judged.verdict, order) < _rank(best.verdict, order):
            best = judged
    return best


def _rank(verdict: Verdict, order: Sequence[Verdict]) -> int:
    return order.index(verdict) if verdict in order else len(order)


def _judged(text: str, claim: Claim, reference: Reference) -> Iterator[EquationVerdict]:
    """The verdicts on what may be meant, in all sets of coordinates that have what it uses."""
    zero, said = claim
    for c in reference.candidates:
        verdict = _verdict(zero, c, reference)
        if verdict is not None:
            right = verdict is Verdict.EQUIVALENT
            yield EquationVerdict(text, verdict, remarks=(*said, *c.said_of([zero])) if right else ())


Claim = tuple[sp.Expr, tuple[str, ...]]
"""What may be meant, being zero; and what is to be said where it is right."""


def _claims(fragment: Fragment, reaction: Reaction, reference: Reference) -> list[Claim]:
    """What may be meant, what the derivation means first. Raises ProblemError where it cannot be read."""
    if "=" in fragment.text:
        equation = read_equation(fragment, reference.scope, [], MAX_ANSWER_CHARACTERS, latex=True)
        lhs, rhs = equation.lhs, equation.rhs
        return [] if isinstance(lhs, Vector) or isinstance(rhs, Vector) else [(lhs - rhs, ())]
    value = read_value(fragment, reference.scope, [], latex=True)
    if isinstance(value, Vector):
        return []
    return [(force - value, (said,) if said else ()) for force, said in _meanings(reaction)]


def _meanings(reaction: Reaction) -> Iterator[tuple[sp.Expr, str]]:
    """What the one number of a reaction may be, and what is to be said of that."""
    multiplier = reaction.multiplier
    if reaction.rod is not None:
        tension = reaction.rod.factor * multiplier
        yield tension, ""
        yield -tension, "it is taken as a force that pushes, the opposite of the tension"
        yield multiplier, f"it is taken as the multiplier `{multiplier}`, not as the tension"
        return
    yield multiplier, ""
    if reaction.is_normal and reaction.directions:
        [direction] = reaction.directions.values()
        size = textbook_form(sp.sqrt(textbook_form(direction.dot(direction))))
        yield size * multiplier, ""
        yield -size * multiplier, "it is taken as the normal force against the gradient of the constraint"


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

    def check_stated(self, fragment: Fragment, reaction: Reaction) -> EquationVerdict | None:
        """The verdict on what the file states of one reaction, as `check_reaction` gives it of a moving system."""
        return _stated(fragment, reaction, self.reference, lambda text, claim: self._judged(text, claim[:1], claim[1]))

    def is_about(self, reading: Reading) -> bool:
        """Whether an equation of an answer says something of reactions."""
        return reading.error is None and any(e.free_symbols & self.names for e in reading.components)

    def check(self, reading: Reading) -> EquationVerdict:
        """The verdict on an equation of an answer, which is about reactions."""
        order = (Verdict.TRIVIAL, *_STATED)
        found = _best(self._judged(reading.text, reading.components), order)
        verdict = found.verdict if found is not None else Verdict.UNREADABLE
        diagnosis = {
            Verdict.WRONG: "it does not hold at every equilibrium",
            Verdict.UNDECIDED: "it could not be decided whether it is right",
            Verdict.UNREADABLE: "it divides by what is exactly zero, or mixes coordinates of several choices",
            Verdict.TRIVIAL: "it is an identity",
        }
        return EquationVerdict(reading.text, verdict, diagnosis.get(verdict, ""), found.remarks if found else ())

    def _judged(self, text: str, claims: Sequence[sp.Expr], said: tuple[str, ...] = ()) -> Iterator[EquationVerdict]:
        """The verdicts on claims that are all meant, over the meanings of names and the sets of coordinates."""
        used = set().union(*(e.free_symbols for e in claims))
        for meaning, words in self._meanings():
            of_names = tuple(said_of for s, said_of in words.items() if s in used)
            for found in self.found:
                verdict = self._holds(claims, meaning, found)
                if verdict is not None:
                    right = verdict is Verdict.EQUIVALENT
                    yield EquationVerdict(text, verdict, remarks=(*said, *of_names) if right else ())

    def _meanings(self) -> Iterator[tuple[Mapping[sp.Symbol, sp.Expr], Mapping[sp.Symbol, str]]]:
        """What names of forces stand for; that of a rod its tension, thrust or multiplier, with what is said of it."""
        tensions = self.newton.tensions
        yield tensions, {}
        named = {r.tension: r.multiplier for r in self.newton.reactions if r.named and r.tension is not None}
        if named:
            yield {**tensions, **{s: -tensions[s] for s in named}}, {s: AS_THRUST.format(s) for s in named}
            yield {**tensions, **named}, {s: AS_MULTIPLIER.format(s) for s in named}

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
