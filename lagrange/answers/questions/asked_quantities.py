"""Is the stated answer to a question right?

An answer is an expression for the quantity, or an equation: `2/3*R`, `cos(theta) = 2/3`, `leaves = acos(2/3)`. An
expression must equal the derived value, exactly, with decimals that may be rounded; angles count modulo 2π. An
equation must hold at the derived state, and have no other solutions for the quantity. Where the initial state leaves
the sense of the motion open, one of two opposite values is enough; a velocity may be given as a speed, without its
sign; the name of a reaction may stand for the opposite force or for the multiplier. A remark says so.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import CIRCULAR
from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.equilibria import with_both_signs
from lagrange.answers.friction.logarithms import parted_logarithms
from lagrange.answers.limits import ROUNDING_DIGITS
from lagrange.answers.questions.named_values import WRONG_UNIT, Judged, check_each, label_of, text_in_si
from lagrange.answers.readings import ForceMeaning, decimals_in, meanings_of_force
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import UNDECIDED, WORST_TO_BEST, AnswerVerdict, Verdict
from lagrange.answers.written.decimals import as_written, numbers_rounding_to
from lagrange.answers.written.reading import tried
from lagrange.answers.written.statements import statement
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import all_hold
from lagrange.core.symbols import base
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import Scope, read_value, read_value_otherwise
from lagrange.mechanics.questions.elimination import eliminated
from lagrange.mechanics.questions.results import Asked, How
from lagrange.mechanics.results import Solution
from lagrange.problem.questions import scope_of_questions
from lagrange.values.dimensions import dimension, dimension_of_unit, dimensions_of_units

_FACTORS = (
    (sp.Rational(1, 2), "it is twice as large as it should be"),
    (sp.Integer(2), "it is half as large as it should be"),
    (sp.S.NegativeOne, "it has the wrong sign"),
    (sp.sqrt(2), "a factor sqrt(2) is missing"),
    (1 / sp.sqrt(2), "there is a factor sqrt(2) too many"),
    (2 * sp.pi, "a factor 2*pi is missing"),
    (1 / (2 * sp.pi), "there is a factor 2*pi too many"),
)
"""What would make a wrong value right."""
_HALVED = ": its square is half as large, as from a kinetic energy without its 1/2"
_SIDES = "one of two opposite values: the sense of the motion is left open by the initial state"
_SPEED = "it is taken as a magnitude, without the sign that it has here"
_SIGN = "it leaves the sign open"
_OTHER = "it has other solutions as well"
_ONE_OF_SEVERAL = "there are other values as well"
_ONE_CASE = "it is right in one of several cases"
_ROUNDED = "it is taken as a rounded number"
_NOT_ANSWERED = "the derivation did not find an answer to compare with"
MAGNITUDES = frozenset({"a", "alpha"})
"""The letters of accelerations, whose sense a figure shows and nobody states."""
_SAYS_NOTHING = "it says nothing about the quantity that is asked for"

_CLOSE = sp.Rational(1, 10**ROUNDING_DIGITS)


def check_asked(stated: Mapping[str, Fragment], solution: Solution) -> AnswerVerdict:
    """The verdict on the answers to all questions together."""
    reference = reference_of_solution(solution)
    asked = {a.question.name: _with_values(a, reference.values) for a in solution.asked}

    taken: dict[sp.Expr, ForceMeaning] = {}

    def judged(name: str, fragment: Fragment) -> Judged:
        if name not in asked:
            return Verdict.UNDECIDED, _NOT_ANSWERED
        claims = claims_of(fragment, asked[name], solution, reference)
        judged = [(claim.verdict(), claim) for claim in claims]
        (verdict, remark), claim = max(judged, key=lambda v: WORST_TO_BEST.index(v[0][0]))
        if verdict is Verdict.EQUIVALENT and any(v[0] is not Verdict.EQUIVALENT for v, _ in judged):
            moves = any(base(s) != s for s in asked[name].question.quantity.free_symbols)
            return (verdict, remark) if moves else (Verdict.UNDECIDED, _ONE_SIGN)
        if claim.meaning is not None and taken.setdefault(claim.quantity, claim.meaning) != claim.meaning:
            return Verdict.WRONG, f"`{claim.quantity}` has another sign or meaning here than in the answer before"
        return verdict, remark

    return with_stated_forces(check_each("ask", stated, judged), [*stated.items()], solution)


def with_stated_forces(
    verdict: AnswerVerdict, stated: Sequence[tuple[str, Fragment]], solution: Solution
) -> AnswerVerdict:
    """The verdict on wrong values, of which some may follow from others; `stated`: question and text of each part."""
    from lagrange.answers.results.consequences import with_consequences

    wrong = [n for n, e in enumerate(verdict.equations) if e.verdict is Verdict.WRONG]
    if len(wrong) < 2 or len(stated) != len(verdict.equations):
        return verdict
    reference, asked = reference_of_solution(solution), {a.question.name: a for a in solution.asked}
    values = {}
    for n, (name, fragment) in enumerate(stated):
        if n not in wrong or name not in asked:
            continue
        try:
            value = claims_of(fragment, asked[name], solution, reference)[0].value
        except (ProblemError, DivisionByZeroError):
            continue
        if value is not None:
            values[n] = asked[name], value
    return with_consequences(verdict, values, reference)


def claims_of(fragment: Fragment, asked: Asked, solution: Solution, reference: Reference) -> list[AskedClaim]:
    """What a text states about a question; with `±` two of them. Raises ProblemError."""
    stated, fits = text_in_si(fragment, asked, reference)
    both = with_both_signs(stated)
    claims = [AskedClaim(f, asked, solution, reference, fits) for f in both]
    if len(claims) == 1 and has_other_reading(both[0], claims[0].scope, asked.question.name):
        other = AskedClaim(both[0], asked, solution, reference, fits, otherwise=True)
        verdicts = [c.verdict(explaining=False)[0] for c in (claims[0], other)]
        if verdicts[0] is not Verdict.EQUIVALENT and verdicts[1] is Verdict.EQUIVALENT:
            return [other]
    return claims


def _with_values(asked: Asked, values: Mapping[sp.Symbol, sp.Expr]) -> Asked:
    """The answer without the branches that the values exclude."""
    left = tuple(b for b in asked.branches if not b.excluded_by(values))
    return replace(asked, branches=left) if left and len(left) < len(asked.branches) else asked


_OTHERWISE = "it is right with `a/b c` read as `a/(b c)`, and `sin x^2` as `sin(x^2)`"
_ONE_SIGN = "it is right with one of the two signs only"


class AskedClaim:
    """A stated answer to one question."""

    def __init__(
        self,
        fragment: Fragment,
        asked: Asked,
        solution: Solution,
        reference: Reference,
        unit_fits: bool,
        otherwise: bool = False,
    ) -> None:
        self.asked = asked
        self.unit_fits = unit_fits
        self.otherwise = otherwise
        self.solution = solution
        self.values, self.units = dict(reference.values), reference.units
        self.candidates = reference.candidates
        self.own = self.candidates[0] if self.candidates else None
        self.scope = replace(scope_of_questions(reference.scope, (), ()), decimals="")
        self.expression, self.equation = read_stated(fragment, self.scope, asked.question.name, otherwise)
        self.quantity = asked.question.quantity
        letter = label_of(fragment).partition("_")[0]
        self.letter = letter if letter not in reference.declared else ""
        law = solution.law
        self.reaction = next((r for r in law.newton.reactions if r.given == self.quantity), None) if law else None
        self.meaning: ForceMeaning | None = None  # of the reaction's name, where the answer is right
        if self.equation is not None and self.reaction is not None and self.reaction.single is not None:
            in_force = self.reaction.force / self.reaction.single.factor
            self.equation = self.equation.xreplace({self.reaction.multiplier: self._rewritten(in_force)})

    @property
    def value(self) -> sp.Expr | None:
        """The value that is stated; None if it is an equation of another kind."""
        stated = self.expression
        if stated is None and self.equation is not None:
            stated = self._stated_value(self.equation)
        return None if stated is None else as_written(stated)

    def _rewritten(self, e: sp.Expr) -> sp.Expr:
        """An expression in the coordinates in which the question was answered."""
        view = self.solution.view(self.asked.choice)
        return view.configuration.rewritten(e)

    def verdict(self, *, explaining: bool = True) -> tuple[Verdict, str]:
        """The verdict, with a remark or a diagnosis. Raises DivisionByZeroError."""
        if not self.asked.answered:
            return Verdict.UNDECIDED, _NOT_ANSWERED
        if not self.unit_fits:
            return Verdict.WRONG, WRONG_UNIT
        claim = self.expression if self.expression is not None else self.equation
        assert claim is not None
        claim = claim.xreplace(dict(self.asked.related))
        verdict, remark = self._judged(as_written(claim))
        if verdict in (Verdict.WRONG, Verdict.INCOMPLETE, Verdict.UNDECIDED) and decimals_in([claim]):
            rounded_verdict, rounded_remark = self._judged(claim)
            if rounded_verdict is Verdict.EQUIVALENT or verdict is not Verdict.INCOMPLETE:
                right = rounded_verdict is Verdict.EQUIVALENT
                return rounded_verdict, "; ".join(filter(None, [rounded_remark, _ROUNDED if right else ""]))
        if explaining and verdict is Verdict.WRONG and not remark and self.asked.how is not How.NUMERICAL:
            remark = self._explained(as_written(claim))
        if self.otherwise and verdict is Verdict.EQUIVALENT:
            remark = "; ".join(filter(None, [remark, _OTHERWISE]))
        return verdict, remark

    def _explained(self, claim: sp.Expr) -> str:
        """The changed problem that a wrong answer solves, or the factor by which it is off; empty if not found."""
        return next(filter(None, self._causes(claim)), "")

    def _causes(self, claim: sp.Expr) -> Iterator[str]:
        """What each kind of cause says about a wrong answer, the likeliest first; empty where it is not that kind."""
        from lagrange.answers.results.motion import explained_as_change

        value = claim if self.expression is not None else self._stated_value(claim)
        of, stated = (self.quantity, value) if value is not None else self._of_function(claim)
        if stated is not None:
            yield from self._of_another_law(value, stated, of)
            right = [v if value is not None else of.xreplace({self.quantity: v}) for v in self._derived()]
            yield explained_as_change(stated, right, of, self.asked)
        if value is not None:
            yield self._of_a_factor(value)
        yield self._of_other_letters(claim)
        yield self._of_exchanged_waves(claim)
        if stated is not None:
            yield from self._of_another_state(value, stated, of)

    def _of_another_law(self, value: sp.Expr | None, stated: sp.Expr, of: sp.Expr) -> Iterator[str]:
        """Where another law, another body or another instant gives what is stated."""
        from lagrange.answers.models.questions import (
            explained_answer,
            explained_by_constant_velocity,
            explained_by_energy,
        )
        from lagrange.answers.results.lost_energy import explained_by_lost_energy
        from lagrange.answers.results.motion import (
            explained_alone,
            explained_balance,
            explained_by_first_acceleration,
            explained_by_free_fall,
            explained_by_half_weight,
            explained_by_whole_weight,
            explained_instant,
            explained_uniform,
        )

        if value is not None:
            for of_forces in (explained_by_free_fall, explained_by_whole_weight, explained_by_half_weight):
                yield of_forces(value, self.asked, self.candidates)
            yield self._of_nothing(value)
        yield self._of_another_body(stated, of)
        impact = self.solution.impact
        yield explained_answer(self.asked, stated, of, None if impact is None else impact.kinetic[0])
        if value is not None:
            for of_time in (explained_by_constant_velocity, explained_instant):
                yield of_time(value, self.asked, self.solution.asked)
            yield explained_uniform(value, self.asked, self.solution.asked, self.candidates)
        yield explained_by_energy(self.asked, stated, of)
        ways = explained_balance, explained_by_first_acceleration, explained_by_lost_energy, explained_alone
        for of_motion in ways if value is not None else ():
            yield of_motion(value, self.asked, self.candidates)

    def _of_nothing(self, value: sp.Expr) -> str:
        """Where a force or an acceleration is stated to be zero: then any change that loses it would explain it."""
        if value != 0:
            return ""
        if self.reaction is not None:
            return "the force of the constraint is missing: it is not zero there"
        moving = self.quantity.is_Symbol and self.quantity.name.endswith("''")
        return "it is taken not to be accelerated there, and it is" if moving else ""

    def _of_a_factor(self, value: sp.Expr) -> str:
        """Where a multiple of the value, its square or its root would be right."""
        for factor, how in _FACTORS:
            if self._of_expression(factor * value)[0] is Verdict.EQUIVALENT:
                return f"{how}{_HALVED}" if factor == sp.sqrt(2) and self._is_speed(value) else how
        for changed, how in () if value.is_number else ((value**2, "root"), (sp.sqrt(value), "square")):
            if self._of_expression(changed)[0] is Verdict.EQUIVALENT:
                return f"this is the {how} of what is asked for"
        return ""

    def _is_speed(self, value: sp.Expr) -> bool:
        """Whether a value is a velocity, by its units."""
        return dimension(value, dimensions_of_units(self.units)) == dimension_of_unit("m/s")

    def _of_other_letters(self, claim: sp.Expr) -> str:
        """Where letters are exchanged, or one of them is lost."""
        from lagrange.answers.models.letters import letter_variations

        up_to_sign = ""  # a velocity of either sign counts as a speed: what is right as it stands is likelier meant
        for variation in letter_variations([claim], (), self.scope.slots, lengths=self._lengths()):
            try:
                changed = claim.xreplace(dict(variation.rule))
                verdict, remark = self._judged(changed) if changed != claim else (Verdict.WRONG, "")
                if verdict is Verdict.EQUIVALENT and not remark:
                    return f"this is the answer {variation.clause}"
                if verdict is Verdict.EQUIVALENT:
                    up_to_sign = up_to_sign or f"this is the answer {variation.clause}"
            except (DivisionByZeroError, NoPointError, UnsupportedError):
                continue
        return up_to_sign

    def _of_exchanged_waves(self, claim: sp.Expr) -> str:
        if (turned := _with_waves_exchanged(claim)) != claim and self._judged(turned)[0] is Verdict.EQUIVALENT:
            return "this is the answer with sine and cosine exchanged: the angles are measured from another direction"
        return ""

    def _of_another_state(self, value: sp.Expr | None, stated: sp.Expr, of: sp.Expr) -> Iterator[str]:
        """Where the answer is that of another state, lacks terms, or has another dimension."""
        from lagrange.answers.models.questions import explained_value
        from lagrange.answers.results.meanings import wrong_dimension
        from lagrange.answers.results.motion import explained_as_motion, explained_at_start, explained_in_any_state

        if value is not None:
            yield explained_at_start(value, self.asked, self.candidates)
            yield explained_as_motion(value, self.asked, self.candidates)
        fixed = {*self.scope.slots.coordinates, *self.quantity.free_symbols}
        right = [v if value is not None else of.xreplace({self.quantity: v}) for v in self._derived()]
        lengths = self._lengths()
        lost = next(filter(None, (explained_value(stated, v, fixed, lengths) for v in right)), "")
        if not lost.startswith("this is the answer without") and value is not None:
            lost = explained_in_any_state(value, self.asked, self.candidates) or lost
        yield lost
        if right:
            yield wrong_dimension(stated, self.units, right[0])

    def _lengths(self) -> Collection[sp.Basic]:
        """The parameters of the geometry, which no variation sets to zero."""
        from lagrange.answers.models.letters import geometry_of

        return geometry_of(self.own.configuration) if self.own is not None else ()

    def _judged(self, claim: sp.Expr) -> tuple[Verdict, str]:
        return self._of_expression(claim) if self.expression is not None else self._of_equation(claim)

    def _of_another_body(self, stated: sp.Expr, of: sp.Expr) -> str:
        """The answer for another moment of inertia, as a sentence; empty if it is none."""
        from lagrange.answers.results.meanings import other_bodies

        others = other_bodies(self.solution, self.asked.question.name)
        if others is None:
            return ""
        solved, changes = others
        values = [
            v for a in solved.asked if a.question.name == self.asked.question.name for b in a.branches for v in b.values
        ]
        for clause, rule in changes:
            for value in values:
                right = of.xreplace({self.quantity: value.xreplace(dict(rule))})
                if self._same(stated, right) or (self._is_odd() and self._same(stated, -right)):
                    return f"this is the answer {clause}"
        return ""

    def _of_function(self, claim: sp.Expr) -> tuple[sp.Expr, sp.Expr | None]:
        """f and y where the equation is f(quantity) = y with a sine, cosine or tangent."""
        waves = [w for w in claim.atoms(*CIRCULAR) if w.args[0] == self.quantity]
        if len(waves) == 1:
            [wave] = waves
            rest = sp.expand(wave - claim), sp.expand(wave + claim)
            for value in rest:
                if not value.has(wave) and value.free_symbols.isdisjoint(self.quantity.free_symbols):
                    return wave, value
        return self.quantity, None

    def _derived(self) -> list[sp.Expr]:
        return list(dict.fromkeys(v for b in self.asked.branches for v in b.values))

    def _same(self, claim: sp.Expr, value: sp.Expr) -> bool | None:
        """Whether two values are equal, those of an angle modulo 2π."""
        value = value.xreplace(dict(self.asked.related)).xreplace(self.values)
        if value.has(sp.I) and decimals_in([claim]) and not value.free_symbols:
            value = sp.Rational(str(sp.re(value.evalf(30))))  # √(−2)/√(−3) of a quotient that is known to be positive
        difference = claim.xreplace(self.values) - value
        if decimals_in([difference]):
            residual = sp.sin(difference / 2) if self._is_angle() else difference
            return numbers_rounding_to([residual]) is not None
        same = is_zero(difference)
        if same is None and difference.has(sp.log):
            same = is_zero(parted_logarithms(difference))
        if same is False and self._is_angle():
            return all_hold((is_zero(sp.cos(difference) - 1), is_zero(sp.sin(difference))))
        return same

    def _is_angle(self) -> bool:
        return self.quantity.is_Symbol and any(
            b.lhs.has(*CIRCULAR) or any((v / sp.pi).is_Rational for v in b.values) for b in self.asked.branches
        )

    def _of_expression(self, claim: sp.Expr) -> tuple[Verdict, str]:
        derived = self._derived()
        if self.asked.how is How.NUMERICAL:
            return self._of_number(claim, derived)
        same = [self._same(claim, v) for v in derived]
        if True in same:
            if len(derived) == 1 or all(s is True for s in same):
                if self.reaction is not None and is_zero(claim) is False:
                    self.meaning = meanings_of_force(self.reaction)[0]
                return Verdict.EQUIVALENT, ""
            if len(self.asked.branches) == 1 or self.asked.mirrored:
                return Verdict.EQUIVALENT, _SIDES
            if self._is_odd() and all(s or self._same(claim, -v) for s, v in zip(same, derived, strict=True)):
                return Verdict.EQUIVALENT, _SPEED
            return self._in_some_cases([any(self._same(claim, v) for v in b.values) for b in self.asked.branches])
        if None in same:
            return Verdict.UNDECIDED, UNDECIDED
        if self._is_odd() and any(self._same(claim, -v) or self._same(claim**2, v**2) for v in derived):
            return Verdict.EQUIVALENT, _SPEED
        for meaning in meanings_of_force(self.reaction)[1:] if self.reaction is not None else ():
            if any(self._same(claim, v) for v in self._values_for(meaning)):
                self.meaning = meaning
                return Verdict.EQUIVALENT, meaning.remark
        return Verdict.WRONG, ""

    def _in_some_cases(self, holds: Sequence[bool]) -> tuple[Verdict, str]:
        """The verdict on an answer that is right in some branches; a relation between parameters makes none needed."""
        pairs = list(zip(self.asked.branches, holds, strict=True))
        if all(right or any(c.relation == "=" for c in b.conditions) for b, right in pairs):
            return Verdict.EQUIVALENT, ""
        cases = all(b.conditions for b in self.asked.branches)
        return Verdict.INCOMPLETE, _ONE_CASE if cases else _ONE_OF_SEVERAL

    def _of_number(self, claim: sp.Expr, derived: Sequence[sp.Expr]) -> tuple[Verdict, str]:
        """The verdict where the derived value is a number only; equal digits of an exact claim prove nothing."""
        decimals = decimals_in([claim])
        width = as_written(sp.Add(*(abs(claim.diff(d)) * d.half_width for d in decimals))).xreplace(self.values)
        close = []
        for v in derived:  # a number, or one times a product of positive letters, which are divided out
            letters = v.as_coeff_Mul()[1].xreplace(self.values) if v.free_symbols else sp.S.One
            off, allowed = (
                sp.expand(e.xreplace(self.values) / letters).evalf(20) for e in (as_written(claim) - v, width)
            )
            if off.is_number and allowed.is_number and abs(off) <= abs(allowed) + _CLOSE:
                close.append(v)
        if not close:
            return Verdict.WRONG, ""
        return (Verdict.EQUIVALENT, "") if decimals else (Verdict.UNDECIDED, UNDECIDED)

    def _is_odd(self) -> bool:
        """Whether a magnitude may be given: of a velocity, which changes its sign with the motion, or of `a = ...`."""
        if self.letter in MAGNITUDES and str(self.quantity).endswith("''"):
            return True
        velocities = {
            s: -s for s in self.quantity.free_symbols if s.name.endswith("'") and base(s).name + "'" == s.name
        }
        return bool(velocities) and sp.expand(self.quantity.xreplace(velocities) + self.quantity) == 0

    def _values_for(self, meaning: ForceMeaning) -> Iterator[sp.Expr]:
        """The values in another meaning of a reaction's name; that of a multiplier may depend on the position."""
        ratio = self._rewritten(meaning.ratio)
        for b in self.asked.branches:
            for value in b.values:
                at = [ratio.xreplace(_with_functions(s)) for s in b.states] or [ratio]
                yield from (value * r for r in at if not self._is_open(r))

    def _of_equation(self, claim: sp.Expr) -> tuple[Verdict, str]:
        if is_zero(claim.xreplace(self.values)) is True:
            return Verdict.TRIVIAL, "it is an identity"
        if claim.free_symbols.isdisjoint(self.quantity.free_symbols):
            return Verdict.WRONG, _SAYS_NOTHING
        if self.asked.how is How.NUMERICAL:
            stated = self._stated_value(claim)
            return self._of_expression(stated) if stated is not None else (Verdict.UNDECIDED, UNDECIDED)
        by_branch: list[list[bool | None]] = []
        for b in self.asked.branches:
            residuals = [
                _without_half_angles(claim.xreplace(s)).xreplace(self.values) for s in self._states(b.values, b.states)
            ]
            by_branch.append([None if self._is_open(e) else _vanishes(e) for e in residuals])
        holds = [h for each in by_branch for h in each]
        if not holds or None in holds:
            return Verdict.UNDECIDED, UNDECIDED
        if not any(holds):
            opposite = self._stated_value(claim)
            return self._of_expression(opposite) if opposite is not None else (Verdict.WRONG, "")
        if not all(holds):
            if self.asked.mirrored or len(self.asked.branches) == 1:
                return Verdict.EQUIVALENT, _SIDES
            return self._in_some_cases([any(h) for h in by_branch])
        return self._alone(claim)

    def _stated_value(self, claim: sp.Expr) -> sp.Expr | None:
        """v where the equation is quantity = v."""
        for sign in (1, -1):
            value = sp.expand(self.quantity - sign * claim)
            if value.free_symbols.isdisjoint(self.quantity.free_symbols):
                return value
        return None

    def _states(
        self, values: Sequence[sp.Expr], states: Sequence[Mapping[sp.Symbol, sp.Expr]]
    ) -> list[dict[sp.Expr, sp.Expr]]:
        if self.quantity.is_Symbol:
            shared = _with_functions(states[0]) if len(states) == 1 and len(values) == 1 else {}
            reached = {s[self.quantity]: _with_functions(s) for s in states if self.quantity in s}
            return [reached.get(v, {**shared, self.quantity: v}) for v in values]
        return [_with_functions(s) for s in states]

    def _is_open(self, e: sp.Expr) -> bool:
        """Whether an expression contains coordinates, velocities or reactions that have no value here."""
        by = self.asked.question.by
        return any(
            (base(s) in self.scope.slots.coordinates and s != by) or (s == sp.Symbol("t", real=True) and s != by)
            for s in e.free_symbols
        )

    def _alone(self, claim: sp.Expr) -> tuple[Verdict, str]:
        """The verdict on an equation that holds: whether it has other solutions for the quantity."""
        if not self.quantity.is_Symbol:
            return Verdict.EQUIVALENT, ""
        solved = eliminated([claim], self.quantity, [self.quantity], [], self.quantity)
        if not solved.solved or solved.free:
            return Verdict.EQUIVALENT, ""
        derived = self._derived()
        stated_alike = {(b.lhs, b.rhs) for b in self.asked.branches if b.lhs != self.quantity}
        for value in (v for b in solved.branches if (b.lhs, b.rhs) not in stated_alike for v in b.values):
            same = [self._same(value, d) for d in derived]
            if True in same:
                continue
            if any(self._same(-value, d) is True for d in derived):
                return Verdict.EQUIVALENT, _SIGN
            if None not in same:
                return Verdict.INCOMPLETE, _OTHER
        return Verdict.EQUIVALENT, ""


def _with_waves_exchanged(claim: sp.Expr) -> sp.Expr:
    other = {sp.sin: sp.cos, sp.cos: sp.sin, sp.tan: sp.cot, sp.cot: sp.tan}
    return claim.xreplace({w: other[type(w)](w.args[0]) for w in claim.atoms(*other)})


def _with_functions(state: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """A state with the sines and cosines of its angles, whose values it has under their names.

    sin θ = 2/3 sin α says more than θ = acos √(1 − 4/9 sin² α), where the sine of α may have either sign.
    """
    letters = {s.name: v for s, v in state.items()}
    rule: dict[sp.Expr, sp.Expr] = dict(state)
    for q in state:
        pair = [letters.get(str(f(q))) for f in (sp.sin, sp.cos)]
        rule |= {f(q): v for f, v in zip((sp.sin, sp.cos), pair, strict=True) if v is not None}
        if pair[0] is not None and pair[1] not in (None, 0):
            rule[sp.tan(q)] = pair[0] / pair[1]
    return rule


def _without_half_angles(e: sp.Expr) -> sp.Expr:
    """The expression with the functions of halves of angles acos u as roots: sin(acos(u)/2) = sqrt((1 - u)/2)."""
    rule: dict[sp.Expr, sp.Expr] = {}
    for wave in e.atoms(*CIRCULAR):
        factor, angle = wave.args[0].as_coeff_Mul()
        if abs(factor) == sp.Rational(1, 2) and isinstance(angle, sp.acos):
            below, above = (sp.sqrt(sp.together((1 + sign * angle.args[0]) / 2)) for sign in (-1, 1))
            sine = below if factor > 0 else -below
            values = {sp.sin: sine, sp.cos: above, sp.tan: sine / above, sp.cot: above / sine}
            rule |= {wave: values[type(wave)]} if type(wave) in values else {}
    return e.xreplace(rule)


def _vanishes(e: sp.Expr) -> bool | None:
    """Whether an expression is zero, its decimals being numbers that round to them; None: undecided."""
    return numbers_rounding_to([e]) is not None if decimals_in([e]) else is_zero(e)


def has_other_reading(fragment: Fragment, scope: Scope, name: str) -> bool:
    """Whether a stated value has two readings, as `a/b c` has. Raises ProblemError."""
    stated = statement(fragment, scope, name=name)
    others = (tried(s, stated.scope, lambda f: read_value_otherwise(f, stated.scope)) for s in stated.sides)
    return any(value is not None for value in others)


def read_stated(
    fragment: Fragment, scope: Scope, name: str, otherwise: bool = False
) -> tuple[sp.Expr | None, sp.Expr | None]:
    """An expression, or an equation as an expression that is zero; the name of what is stated may be its left side.

    otherwise  in the other reading of what has two

    Raises ProblemError.
    """
    stated = statement(fragment, scope, name=name)
    scope = stated.scope

    def value_of(side: Fragment) -> sp.Expr | Vector:
        other = read_value_otherwise(side, scope) if otherwise else None
        return read_value(side, scope, [], latex=True) if other is None else other

    values = [tried(side, scope, value_of) for side in stated.sides]
    if len(values) > 1:
        lhs, rhs = values
        if isinstance(lhs, Vector) or isinstance(rhs, Vector):
            raise ProblemError(Diagnostic("vector-for-scalar", "an equation between vectors", fragment.whole))
        return None, lhs - rhs
    [value] = values
    if isinstance(value, Vector):
        raise ProblemError(Diagnostic("vector-for-scalar", "a quantity is a number, not a vector", fragment.whole))
    return sp.sqrt(value) if stated.label.endswith("^2") else value, None
