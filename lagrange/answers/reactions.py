"""Is a stated reaction right?

A textbook gives the reaction of a constraint as one expression (the multiplier, the tension or thrust of a rod, the
normal force of a surface), or as an equation, T = .... It is right if the equation between the two follows from the
equations of motion with multipliers, in the file's coordinates or in those of a choice. For a system at rest it is
right if it holds at every equilibrium, exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.limits import LONGEST_COMPARED_REACTION
from lagrange.answers.readings import Reading, decimals_in, meanings_of_force, other_readings
from lagrange.answers.recognition import FROM_THE_START
from lagrange.answers.references import Reference, ReferenceCandidate
from lagrange.answers.verdicts import DIVIDES_BY_ZERO, UNDECIDED, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written, numbers_rounding_to, remark_on, rounded_in_motion
from lagrange.core.diagnostics import Fragment
from lagrange.core.records import record
from lagrange.core.symbols import base
from lagrange.core.vectors import Vector
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS
from lagrange.expressions.reader import read_equation, read_value
from lagrange.mechanics.dynamics.comparison import Standing, compare
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.reaction_signs import ForceKind

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.kinematics import Configuration
    from lagrange.mechanics.equilibrium.static_reactions import ReactionsAtRest, StaticReactions
    from lagrange.mechanics.results import Solution


def check_reaction(
    fragment: Fragment, reaction: Reaction, reference: Reference, solution: Solution | None = None
) -> EquationVerdict | None:
    """The verdict on the stated value of one reaction; None if no set of coordinates covers all that it uses.

    If it is right with another meaning of the reaction than in the derivation, a remark names that meaning. Raises
    ProblemError if it cannot be read.
    """
    stated = _stated(fragment, reaction, reference, lambda text, claim: _judged(text, claim, reference))
    if stated is None or stated.verdict is not Verdict.WRONG:
        return stated
    claims = [zero for zero, _ in _claims(fragment, reaction, reference)]
    if "=" in fragment.text and reaction.given is not None:
        claims = [
            zero.xreplace({reaction.force: m.ratio * reaction.force})
            for zero in claims
            for m in meanings_of_force(reaction)
        ]
    for zero in claims:
        for candidate in reference.candidates:
            if {base(s).name for s in zero.free_symbols} & reference.moving <= candidate.known:
                from lagrange.answers.models.letters import explained_reaction

                why = explained_reaction(candidate.read(as_written(zero)), candidate.models)
                if why:
                    return replace(stated, diagnosis=why, cause=why)
    from lagrange.answers.results.meanings import wrong_dimension

    if solution is not None:
        from lagrange.answers.results.forces import explained_size

        if why := explained_size([as_written(zero) for zero in claims], reaction, reference, solution):
            return replace(stated, diagnosis=why, cause=why)
    forces = {reaction.multiplier, reaction.force, reaction.symbol}
    values = [zero.xreplace(dict.fromkeys(forces, sp.S.Zero)) for zero in claims]
    why = next(filter(None, (wrong_dimension(v, reference.units) for v in values)), "")
    return replace(stated, diagnosis=why, cause=why) if why else stated


def _stated(
    fragment: Fragment,
    reaction: Reaction,
    reference: Reference,
    judged: Callable[[str, ReactionClaim], Iterator[EquationVerdict]],
) -> EquationVerdict | None:
    """The best verdict over all possible meanings; None if none of them can be judged."""
    text = f"{reaction.name}: {fragment.text}"
    claims = _claims(fragment, reaction, reference)
    if not claims:
        return EquationVerdict(text, Verdict.UNREADABLE)
    return _best((verdict for claim in claims for verdict in judged(text, claim)), _STATED)


_STATED = (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.UNDECIDED, Verdict.WRONG)


def _best(verdicts: Iterable[EquationVerdict], order: Sequence[Verdict]) -> EquationVerdict | None:
    """The best verdict in an order; None if there are none. After a best possible one no more are evaluated."""
    best: EquationVerdict | None = None
    for judged in verdicts:
        if judged.verdict is order[0]:
            return judged
        if best is None or _rank(judged.verdict, order) < _rank(best.verdict, order):
            best = judged
    return best


def _rank(verdict: Verdict, order: Sequence[Verdict]) -> int:
    return order.index(verdict) if verdict in order else len(order)


def _judged(text: str, claim: ReactionClaim, reference: Reference) -> Iterator[EquationVerdict]:
    """The verdicts on a claim in all sets of coordinates that have what it uses."""
    zero, remarks = claim
    for c in reference.candidates_for({s.name for s in zero.free_symbols}):
        verdict = _verdict(as_written(zero), c, reference)
        more = c.remarks_on([zero])
        if verdict is Verdict.WRONG and c.holds_from_start([c.read(zero)], [zero]):
            verdict, more = Verdict.EQUIVALENT, (FROM_THE_START, *more)
        if verdict is Verdict.WRONG and decimals_in([zero]):
            values = rounded_in_motion([c.read(zero)], c.system)
            if values is not None:
                verdict, more = Verdict.EQUIVALENT, (remark_on(values), *more)
        if verdict is not None:
            yield EquationVerdict(text, verdict, remarks=(*remarks, *more) if verdict is Verdict.EQUIVALENT else ())


ReactionClaim = tuple[sp.Expr, tuple[str, ...]]
"""What may be meant, as an expression that is zero; and the remarks if it is right."""


def _claims(fragment: Fragment, reaction: Reaction, reference: Reference) -> list[ReactionClaim]:
    """The possible meanings of a claim, that of the derivation first. Raises ProblemError if it cannot be read."""
    from lagrange.answers.written.names import printed_names
    from lagrange.answers.written.reading import tried
    from lagrange.answers.written.values import force_in_si, with_value_in_si

    within = with_value_in_si(fragment, reference) if "=" in fragment.text else fragment
    fragment = within if within is not fragment else force_in_si(fragment, reaction, reference)
    short = printed_names(reference)
    scope = replace(reference.scope, decimals="", scalars={**reference.scope.scalars, **short})
    if "=" in fragment.text:
        equation = tried(fragment, scope, lambda f: read_equation(f, scope, [], MAX_ANSWER_CHARACTERS, latex=True))
        lhs, rhs = equation.lhs, equation.rhs
        return [] if isinstance(lhs, Vector) or isinstance(rhs, Vector) else [(lhs - rhs, ())]
    value = tried(fragment, scope, lambda f: read_value(f, scope, [], latex=True))
    if isinstance(value, Vector):
        return []
    return [(force - value, (remark,) if remark else ()) for force, remark in _meanings(reaction)]


def _meanings(reaction: Reaction) -> Iterator[tuple[sp.Expr, str]]:
    """The forces that one number for a reaction may be, each with a remark."""
    multiplier, single = reaction.multiplier, reaction.single
    force = multiplier if single is None else single.factor * multiplier
    if reaction.given is not None:
        yield from ((meaning.ratio * force, meaning.remark) for meaning in meanings_of_force(reaction))
        return
    is_tension = single is not None and single.kind is ForceKind.TENSION
    if not is_tension:
        yield multiplier, ""
    if single is not None:
        yield force, ""
        yield -force, _OPPOSITE[single.kind]
    if is_tension:
        yield multiplier, f"it is taken as the multiplier `{multiplier}`, not as the tension"


_OPPOSITE = {
    ForceKind.TENSION: "it is taken as a force that pushes, the opposite of the tension",
    ForceKind.ALONG: "it is taken as the force against the gradient of the constraint",
}


def _verdict(claim: sp.Expr, candidate: ReferenceCandidate, reference: Reference) -> Verdict | None:
    """The verdict in one set of coordinates; None if the claim uses others."""
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


_SAME_NUMBER = sp.Float(10) ** -20
_AT_SOME = "it holds at some positions of equilibrium only: say at which, or give it as a function of the position"


@record
class _AtBranch:
    """What claims are at the points of a branch of equilibria, and which of these the answer names beside them."""

    claims: list[list[bool | None]]
    beside: list[bool]

    @classmethod
    def of(
        cls,
        r: ReactionsAtRest | None,
        claims: Sequence[sp.Expr],
        places: Sequence[Sequence[sp.Expr]],
        configuration: Configuration,
        values: Mapping[sp.Symbol, sp.Expr],
    ) -> _AtBranch | None:
        """At one branch; None if the reactions there are not known. Raises DivisionByZeroError."""
        if r is None or r.verified is not True:
            return None
        by_claim = [[*r.points.verdicts(e.xreplace(r.rule), values)] for e in claims]
        stated = [[configuration.rewritten(as_written(e)) for e in place] for place in places]

        def at_each(e: sp.Expr) -> list[bool | None]:
            known = {s for point in r.points.values for s in point}
            angles = [q for q in configuration.slots.coordinates if q not in known]
            if any(e.diff(q) in (1, -1) for q in angles):  # theta = pi; its sine and cosine are known
                e = sp.expand_trig(sp.cos(e)) - 1
            return [*r.points.verdicts(e, values)]

        named = [[*zip(*map(at_each, place), strict=True)] for place in stated if place]
        claimed = [[*at] for at in zip(*by_claim, strict=True)]
        beside = [any(all(v is True for v in place[n]) for place in named) for n in range(len(claimed))]
        return cls(claimed, beside)

    def chosen(self, *, beside: bool) -> list[list[bool | None]]:
        """The claims at each point, or at each that the answer names."""
        return [c for c, named in zip(self.claims, self.beside, strict=True) if named or not beside]


def _at_special_position(stated: sp.Expr, right: sp.Expr, configuration: Configuration) -> str:
    """For which angle a stated force is the right one, where the position is tied to it: T = W where strings hang
    vertically. In a sentence; empty if for none."""
    coordinates = {*configuration.slots.coordinates}
    if max(map(sp.count_ops, (stated, right))) > LONGEST_COMPARED_REACTION:
        return ""
    for q in configuration.slots.coordinates:
        ties = [f.xreplace({q: sp.S.Zero}) for f in configuration.finite_constraints if f.has(sp.sin(q), sp.cos(q))]
        off = sp.numer(sp.together((stated - right).xreplace({q: sp.S.Zero})))
        if len(ties) == 1 and off != 0 and (sp.gcd(off, sp.expand(ties[0])).free_symbols & coordinates):
            return f"it is the force where {q} = 0 alone"
    return ""


class StatedReactionsAtRest:
    """The reactions of a system at rest, with which stated ones are compared.

    reactions   those in the file's coordinates and in each choice
    in_numbers  the named forces at each equilibrium that was found in numbers, if all were found so
    """

    def __init__(
        self,
        newton: Newton,
        reactions: Sequence[StaticReactions],
        reference: Reference,
        in_numbers: Sequence[Mapping[sp.Symbol, sp.Expr]] = (),
    ) -> None:
        self.newton = newton
        self.reactions = reactions
        self.reference = reference
        self.in_numbers = in_numbers
        self.names = {*newton.multipliers_by_name.values(), *newton.single_forces}

    def check_stated(self, fragment: Fragment, reaction: Reaction) -> EquationVerdict | None:
        """The verdict on the stated value of one reaction, as `check_reaction` gives it for a moving system."""
        stated = _stated(
            fragment, reaction, self.reference, lambda text, claim: self._judged(text, claim[:1], claim[1])
        )
        if stated is not None and stated.verdict is Verdict.UNDECIDED and self.in_numbers:
            return self._compared_in_numbers(stated, fragment, reaction)
        if stated is None or stated.verdict is not Verdict.WRONG:
            return stated
        claims = _claims(fragment, reaction, self.reference)
        why = self._why([zero for zero, _ in claims])
        return replace(stated, diagnosis=why, cause=why) if why else stated

    def _compared_in_numbers(self, stated: EquationVerdict, fragment: Fragment, reaction: Reaction) -> EquationVerdict:
        """The verdict on a number for a force, of either sign, from its values at positions found in numbers."""
        if not all(reaction.force in forces for forces in self.in_numbers):
            return stated
        factor = sp.S.One if reaction.single is None else reaction.single.factor
        in_force = {reaction.multiplier: reaction.force / factor}
        sizes = [forces[reaction.force] for forces in self.in_numbers]
        for zero, remarks in _claims(fragment, reaction, self.reference):
            e = zero.xreplace(in_force).xreplace(dict(self.reference.values))
            decimals = decimals_in([e])
            if e.free_symbols - {reaction.force, *decimals}:
                return stated
            leeway = sp.Add(*(abs(e.diff(d)) * d.half_width for d in decimals))
            off = [abs(as_written(e).xreplace({reaction.force: size})) for size in sizes]
            if all(
                x <= as_written(leeway) + _SAME_NUMBER * (1 + abs(size)) for x, size in zip(off, sizes, strict=True)
            ):
                return replace(stated, verdict=Verdict.EQUIVALENT, diagnosis="", remarks=remarks)
        return replace(stated, verdict=Verdict.WRONG)

    def _why(self, zeros: Sequence[sp.Expr]) -> str:
        """The first explanation of wrong values; empty if there is none."""
        try:
            return next(filter(None, map(self._explained, zeros)), "")
        except (DivisionByZeroError, NotAlgebraicError, NoPointError, UnsupportedError):
            return ""

    def _exchanged(self, zero: sp.Expr) -> str:
        """Which other reaction has the stated value, in a sentence; empty if none, or if the value is zero."""
        usual = self.newton.single_forces
        used = self.names & zero.free_symbols
        if len(used) != 1 or zero.xreplace(dict.fromkeys(used, sp.S.Zero)) == 0:
            return ""
        [stated] = used
        for other in sorted(self.names - {stated}, key=str):
            for sign in (1, -1):
                claim = zero.xreplace({stated: sign * other})
                if any(self._holds([claim], usual, r, ()) is Verdict.EQUIVALENT for r in self.reactions):
                    return f"this is `{other}`, and not `{stated}`"
        return ""

    def _explained(self, zero: sp.Expr) -> str:
        """How a wrong value differs from the reaction at one of the equilibria, in a sentence; empty if not found."""
        from lagrange.answers.models.questions import explained_value
        from lagrange.answers.results.balances import of_one_letter
        from lagrange.answers.results.virtual_work import of_the_direction_alone

        if why := self._exchanged(zero):
            return why
        for reactions in self.reactions:
            configuration = reactions.configuration
            meant = configuration.rewritten(as_written(zero).xreplace(dict(self.newton.single_forces)))
            if why := of_the_direction_alone(meant, self.newton, configuration):
                return why
            known = {*configuration.slots.coordinates, *self.reference.parameters.values(), *self.reference.unknowns}
            for r in self._possible(reactions):
                if r is None or r.verified is not True or not meant.free_symbols - {*r.rule} <= known:
                    continue
                value = -meant.xreplace(dict.fromkeys(r.rule, sp.S.Zero))
                at_rest = next(iter(r.points.values_at([value, meant.xreplace(r.rule)])))
                stated, off = (sp.factor(sp.together(v)) for v in at_rest)
                right = sp.factor(sp.together(stated + off))
                letters = sorted({*self.reference.parameters.values()}, key=str)
                if why := _at_special_position(stated, right, configuration):
                    return why
                if why := of_one_letter(value, off, letters, r, configuration.slots.coordinates):
                    return why
                if sp.count_ops(right) <= LONGEST_COMPARED_REACTION:
                    why = explained_value(stated, right, {*configuration.slots.coordinates})
                    if why:
                        return why
        return ""

    def mentions_reactions(self, reading: Reading) -> bool:
        """Whether reactions occur in an equation of an answer."""
        return reading.error is None and any(e.free_symbols & self.names for e in reading.components)

    def check(self, reading: Reading, places: Sequence[Sequence[sp.Expr]] = ()) -> EquationVerdict:
        """The verdict on an equation of an answer that is about reactions.

        places  the positions beside which it stands, as alternatives; empty if it stands alone
        """
        order = (Verdict.TRIVIAL, *_STATED)
        best = _best(self._judged(reading.text, reading.with_decimals or reading.components, (), places), order)
        verdict = best.verdict if best is not None else Verdict.UNREADABLE
        diagnosis = {
            Verdict.WRONG: "it does not hold at " + ("the equilibrium beside it" if places else "every equilibrium"),
            Verdict.INCOMPLETE: _AT_SOME,
            Verdict.UNDECIDED: UNDECIDED,
            Verdict.UNREADABLE: f"{DIVIDES_BY_ZERO}, or mixes coordinates of several choices",
            Verdict.TRIVIAL: "it is an identity",
        }
        why = self._why(reading.components[:1]) if verdict is Verdict.WRONG and len(reading.components) == 1 else ""
        said = "; ".join(filter(None, [diagnosis.get(verdict, ""), why]))
        return EquationVerdict(reading.text, verdict, said, best.remarks if best else (), cause=why)

    def _judged(
        self,
        text: str,
        claims: Sequence[sp.Expr],
        remarks: tuple[str, ...] = (),
        places: Sequence[Sequence[sp.Expr]] = (),
    ) -> Iterator[EquationVerdict]:
        """The verdicts on claims that are all meant, for each meaning of the names in each set of coordinates."""
        used = set().union(*(e.free_symbols for e in claims))
        for meaning, remarks_on_names in self._meanings({s.name for s in used}):
            of_names = tuple(remarks_on_names.values())
            for reactions in self.reactions:
                verdict = self._holds(claims, meaning, reactions, places)
                if verdict is not None:
                    right = verdict is Verdict.EQUIVALENT
                    yield EquationVerdict(text, verdict, remarks=(*remarks, *of_names) if right else ())

    def _meanings(self, used: Collection[str]) -> Iterator[tuple[Mapping[sp.Symbol, sp.Expr], Mapping[str, str]]]:
        """The meanings of the names of forces in multipliers, with remarks on those that differ from the derivation."""
        usual = self.newton.single_forces
        yield usual, {}
        for reading in other_readings(self.newton, used):
            other = {s: ratio * usual.get(s, s) for s, ratio in reading.ratios.items()}
            yield {**usual, **other}, reading.remarks

    def _holds(
        self,
        claims: Sequence[sp.Expr],
        meaning: Mapping[sp.Symbol, sp.Expr],
        reactions: StaticReactions,
        places: Sequence[Sequence[sp.Expr]],
    ) -> Verdict | None:
        """Whether claims hold at every equilibrium of one configuration, or at those of places.

        None if they use other coordinates.
        """
        configuration = reactions.configuration
        used = {base(s).name for e in claims for s in e.free_symbols}
        known = {s.name for s in (*configuration.slots.coordinates, *configuration.expressed)}
        if not used & {q.name for q in self.reference.scope.slots.coordinates} <= known or not reactions.at:
            return None
        meant = [configuration.rewritten(as_written(e).xreplace(dict(meaning))) for e in claims]
        by_branch: list[list[bool | None]] = []
        values = dict(self.reference.values)
        try:
            if all(is_zero(e) for e in meant):
                return Verdict.TRIVIAL
            at = [_AtBranch.of(r, meant, places, configuration, values) for r in self._possible(reactions)]
            beside = any(x is not None and True in x.beside for x in at)
            for x in at:
                by_branch += [[None]] if x is None else x.chosen(beside=beside)
        except DivisionByZeroError:
            return None
        verdicts = [v for each in by_branch for v in each]
        somewhere = any(all(v is True for v in each) for each in by_branch)
        if somewhere and not places and (False in verdicts or None in verdicts):
            return Verdict.INCOMPLETE  # other equilibria have other reactions, or such as are not found
        if False in verdicts and decimals_in(claims) and self._round(claims, meaning, reactions):
            return Verdict.EQUIVALENT
        return Verdict.WRONG if False in verdicts else Verdict.UNDECIDED if None in verdicts else Verdict.EQUIVALENT

    def _possible(self, reactions: StaticReactions) -> list[ReactionsAtRest | None]:
        """The reactions where none of them would have to act backwards, as books mean the equilibria."""
        from lagrange.mechanics.equilibrium.static_reactions import possible

        return [reactions.at[n] for n in possible(reactions.at, self.newton, self.reference.values)]

    def _round(
        self, claims: Sequence[sp.Expr], meaning: Mapping[sp.Symbol, sp.Expr], reactions: StaticReactions
    ) -> bool:
        """Whether claims hold at every equilibrium with numbers that round to their decimals."""
        values = dict(self.reference.values)
        for r in self._possible(reactions):
            if r is None or r.verified is not True:
                return False
            meant = [reactions.configuration.rewritten(e.xreplace(dict(meaning))).xreplace(r.rule) for e in claims]
            try:
                places = [*r.points.values_at(meant)]
            except NotAlgebraicError:
                return False
            if any(numbers_rounding_to([e.xreplace(values) for e in at], r.points.around) is None for at in places):
                return False
        return True
