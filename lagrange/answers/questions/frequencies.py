"""Stated frequencies of small oscillations: are they right, and all of them?

A list has the frequencies ω of one equilibrium. Each must be a root of the characteristic equation there, by exact
substitution, so that no closed form is needed; coordinates in either have their values at the equilibrium. All
different ones must be there, with or without the frequency 0. A root ω² that is negative for all values of the
parameters is no frequency. Several lists belong to several equilibria. A list is tried at every equilibrium, in every
set of coordinates, and the best verdict counts. It is wrong only if the linear equations are known at all equilibria.

With damping the frequencies are the ω of the exponents −δ ± iω, and decay rates can be stated: the δ of all modes
that oscillate or may do so, and those of all real exponents. Where these have no closed form, but the parameters have
values, the stated numbers are compared with the exponents in numbers: a decimal stands for all that round to it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import combinations, islice

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.equilibria import with_both_signs
from lagrange.answers.limits import HIGHEST_FREQUENCY_EQUATION, LONGEST_SQUARE
from lagrange.answers.models.letters import NUMBER_OF_MEANINGS, NUMBER_WITH_FACTORS, explained_frequencies
from lagrange.answers.questions.texts.frequency_labels import LABELLED, listed_frequencies
from lagrange.answers.readings import decimals_in
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import UNDECIDED, AnswerVerdict, Verdict
from lagrange.answers.written.decimals import as_written, numbers_rounding_to
from lagrange.answers.written.reading import tried
from lagrange.answers.written.statements import statement
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import read_value
from lagrange.mechanics.equilibrium.damped_modes import exponents_in_numbers
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Answers

_BEST = (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.UNDECIDED, Verdict.WRONG)
_NONE_KNOWN = "no characteristic equation for the frequencies is known in closed form, about a rest or a steady motion"
_NOT_ALL_KNOWN = "not right at any equilibrium with known linear equations, but not all equilibria have these"
_SEVERAL = "no equilibrium has all of them"


@record
class EquilibriumPoint:
    """A point of an equilibrium and its linear equations.

    resting  all equilibria of the configuration
    rates    of a steady motion: constant velocities that are determined
    """

    oscillations: SmallOscillations
    resting: Equilibrium
    branch: Branch
    point: Values
    rates: Values = field(default_factory=dict)

    @property
    def characteristic(self) -> sp.Expr:
        """The polynomial in ω at the point."""
        assert self.oscillations.characteristic is not None
        return self.oscillations.characteristic

    def at(self, e: sp.Expr) -> sp.Expr:
        """An expression with the values of the coordinates. Raises NotAlgebraicError."""
        e = e.xreplace(dict(self.rates))
        coordinates = {*self.resting.configuration.slots.coordinates}
        stated = {r.lhs: r.rhs for r in self.branch.relations if r.lhs in coordinates}
        for _ in stated:
            e = e.xreplace(stated)
        return self.resting.solution.at(self.point, e) if e.free_symbols & coordinates else e

    def is_at(self, conditions: Sequence[sp.Expr], values: Values) -> bool:
        """Whether conditions on the position hold there."""
        try:
            return all(is_zero(self.at(c).xreplace(values)) is True for c in conditions)
        except (DivisionByZeroError, NotAlgebraicError):
            return False

    def sign(self, e: sp.Expr) -> int | None:
        """The sign of an expression, if it is the same for all values of the parameters."""
        try:
            return sign_of(self.at(e))
        except NotAlgebraicError:
            return None

    def held_fast(self, claims: Sequence[sp.Expr], values: Values) -> str:
        """Whether ω² = K_jj/M_jj for a claim: with the other coordinates held fast; a sentence, or empty."""
        free, system = self.oscillations.free, self.oscillations.system
        if len(free) < 2 or not claims:
            return ""
        names = []
        for claim in claims:
            own = [
                j for j in range(len(free)) if self._is_own(claim, system.stiffness[j][j], system.mass[j][j], values)
            ]
            if not own:
                return ""
            names += own[:1]
        coordinates = self.resting.configuration.slots.coordinates
        alone = " and ".join(dict.fromkeys(str(coordinates[free[j]]) for j in names))
        return f"that is the frequency of {alone} with the other coordinates held fast"

    def of_one_term(self, claim: sp.Expr, values: Values) -> str:
        """A sentence naming the wrong term or factor in the square of a frequency; empty if not exactly one is."""
        from lagrange.answers.models.questions import explained_value

        if len(self.oscillations.free) != 1:
            return self._of_one_root(claim, values)
        system = self.oscillations.system
        [j] = self.oscillations.free if len(system.mass) > 1 else [0]
        try:
            right = sp.expand(sp.cancel(self.at(system.stiffness[j][j] / system.mass[j][j])))
        except (NotAlgebraicError, IndexError):
            return ""
        if sp.count_ops(right) > LONGEST_SQUARE or sign_of(right) in (-1, 0):
            return ""  # nothing oscillates there
        why = explained_value(sp.expand(as_written(claim) ** 2).xreplace(values), right.xreplace(values), set())
        if why == "its sign is wrong":
            from lagrange.answers.questions.linear_equations import position_of  # which imports this one

            return f"that is the square of the frequency about {position_of(self)} with the opposite sign"
        return f"in omega^2, {why}" if why else ""

    def _of_one_root(self, claim: sp.Expr, values: Values) -> str:
        """The same for one of several frequencies that are known in closed form."""
        squares = [f.square for f in self.oscillations.frequencies if f.square is not None and f.square != 0]
        from lagrange.answers.models.one_place import wrong_square

        try:
            return wrong_square(as_written(claim) ** 2, [self.at(s) for s in squares], values)
        except NotAlgebraicError:
            return ""

    def _is_own(self, claim: sp.Expr, stiffness: sp.Expr, mass: sp.Expr, values: Values) -> bool:
        try:
            return claim != 0 and is_zero(self.at(as_written(claim**2 * mass - stiffness)).xreplace(values)) is True
        except (DivisionByZeroError, NotAlgebraicError):
            return False

    def is_root(self, claim: sp.Expr, values: Values) -> bool | None:
        """Whether a frequency satisfies the characteristic equation; None: undecided."""
        try:
            residual = self.at(self.characteristic.xreplace({self.oscillations.unknown: claim})).xreplace(values)
            right = is_zero(as_written(residual))
            return True if right is False and numbers_rounding_to([residual]) is not None else right
        except DivisionByZeroError:
            return False
        except NotAlgebraicError:
            return None

    def differ(self, a: sp.Expr, b: sp.Expr, values: Values) -> bool | None:
        """Whether two frequencies differ in magnitude; None: undecided."""
        try:
            same = is_zero(self.at(as_written(a**2 - b**2)).xreplace(values))
        except (DivisionByZeroError, NotAlgebraicError):
            return None
        return None if same is None else not same


def check_oscillation_answers(answers: Answers, solution: Solution) -> Iterator[AnswerVerdict]:
    """The verdicts on frequencies and on decay rates."""
    if answers.frequencies:
        yield check_frequencies(answers.frequencies, solution)
    if answers.decay:
        linearizations = [f for f, _ in _oscillating(solution)]
        yield check_decay(answers.decay, linearizations, reference_of_solution(solution))


def _oscillating(solution: Solution) -> list[tuple[Linearization, Values]]:
    """The linear equations about equilibria, and about steady motions with the rates that these determine."""
    oscillating: list[tuple[Linearization, Values]] = [
        (v.linearization, {}) for v in solution.views if v.linearization is not None
    ]
    families = (f for v in solution.views if v.steady is not None for f in v.steady.families)
    return [*oscillating, *((f.about, f.rates) for f in families)]


def check_frequencies(
    stated: Sequence[Sequence[Fragment]],
    solution: Solution,
    defined: Mapping[str, sp.Expr] | None = None,
    only_at: Sequence[sp.Expr] = (),
) -> AnswerVerdict:
    """The verdict on all lists together.

    defined  names that the answer defines
    only_at  what vanishes at the equilibrium whose frequencies they are stated to be
    """
    reference, oscillating = reference_of_solution(solution), _oscillating(solution)
    if defined:
        scope = reference.scope
        reference = replace(reference, scope=replace(scope, scalars={**scope.scalars, **defined}))
    linearizations = [f for f, _ in oscillating]
    try:
        stated = [
            [e for f in fragments for one in listed_frequencies(f) for e in with_both_signs(one)]
            for fragments in stated
        ]
        read = [[(f, value) for f in fragments for value in _values(f, reference)] for fragments in stated]
        stated = [[f for f, _ in pairs] for pairs in read]
        lists = [[value for _, value in pairs] for pairs in read]
    except ProblemError as error:
        why = error.diagnostics[0].message
        return AnswerVerdict(Verdict.UNREADABLE, unreadable=tuple(error.diagnostics), name=_NAME, diagnosis=why)
    places = [p for f, rates in oscillating for p in _places(f, rates)]
    places = [p for p in places if not only_at or p.is_at(only_at, dict(reference.values))]
    damped = [p for f in linearizations for p in _damped(f, reference, rates=False)]
    if damped and not places:
        return _of_exponents(_NAME, stated, [[c**2 for c in claims] for claims in lists], damped, linearizations)
    if not places:
        return AnswerVerdict(Verdict.UNDECIDED, name=_NAME, diagnosis=_NONE_KNOWN)
    complete = any(_is_complete(f) for f, rates in oscillating if not rates) or all(map(_is_complete, linearizations))
    values = dict(reference.values)
    complete = complete or bool(only_at) or _asked_by_the_file(solution, places, values, reference)
    texts = [[f.text.strip() for f in fragments] for fragments in stated]
    verdicts = [_of_list(c, t, places, values, complete=complete) for c, t in zip(lists, texts, strict=True)]
    best = max(verdicts, key=lambda v: _BEST.index(v.verdict))
    if best.verdict is not Verdict.WRONG and best.diagnosis != _NOT_ALL_KNOWN:
        return best
    wrong = [
        claims
        for claims, v in zip(lists, verdicts, strict=True)
        if v.verdict is Verdict.WRONG or v.diagnosis == _NOT_ALL_KNOWN
    ]
    if best.verdict is Verdict.WRONG:
        sentence = next(_explained(wrong, places, values, reference), "") or _of_other_bodies(wrong, solution, values)
    else:  # it may be right elsewhere: what is wrong in it cannot be said
        sentence = next(filter(None, (_of_models(claims, places, reference) for claims in wrong)), "")
    return replace(best, diagnosis="; ".join(filter(None, [best.diagnosis, sentence])))


def _asked_by_the_file(
    solution: Solution, places: Sequence[EquilibriumPoint], values: dict[sp.Symbol, sp.Rational], reference: Reference
) -> bool:
    """Whether the file states frequencies itself, and all of them belong to known equilibria.

    Then these are what is asked for, although there may be other equilibria.
    """
    own = solution.problem.answers.frequencies if solution.problem.answers is not None else ()
    try:
        lists = [[v for f in fragments for v in _values(f, reference)] for fragments in own]
    except ProblemError:
        return False
    return bool(lists) and all(any(all(p.is_root(c, values) for c in claims) for p in places) for claims in lists)


def _explained(
    lists: Sequence[Sequence[sp.Expr]],
    places: Sequence[EquilibriumPoint],
    values: dict[sp.Symbol, sp.Rational],
    reference: Reference,
) -> Iterator[str]:
    """What wrong lists of frequencies are instead, the likeliest first."""

    def right(claims: Sequence[sp.Expr]) -> bool:
        return any(all(p.is_root(c, values) for c in claims) for p in places)

    plain = explained_frequencies(lists[0]) if len(lists) == 1 else iter(())
    yield from (sentence for sentence, meant in islice(plain, NUMBER_OF_MEANINGS) if right(meant))
    for claims in lists:
        alone = [c for c in claims if not right([c])]
        if len(alone) == len(claims) > 1:
            yield from filter(None, [_of_models(claims, places, reference)])
        yield from filter(None, (p.held_fast(alone, values) for p in places))
        if len(alone) == 1 < sum(c != 0 for c in claims):  # one term of one mode: a change spares no others
            factors = islice(explained_frequencies(alone), NUMBER_WITH_FACTORS)
            yield from (sentence for sentence, meant in factors if right(meant))
            yield from filter(None, (p.of_one_term(alone[0], values) for p in places))
        yield from filter(None, [_of_models(claims, places, reference)])
    for claims in lists:
        alone = [c for c in claims if not right([c])]
        for stated in (claims, alone):
            yield from (sentence for sentence, meant in explained_frequencies(stated) if right(meant))
        yield from filter(None, (p.of_one_term(c, values) for c in alone for p in places))
        if 0 < len(alone) < len(claims):  # what changes the problem would change the right ones beside them as well
            yield from filter(None, [_of_models(alone, places, reference)])


def frequencies_in(fragment: Fragment, reference: Reference) -> list[sp.Expr]:
    """The frequencies that a text states. Raises ProblemError."""
    each = (e for one in listed_frequencies(fragment) for e in with_both_signs(one))
    return [as_written(v) for e in each for v in _values(e, reference)]


def _values(fragment: Fragment, reference: Reference) -> list[sp.Expr]:
    """The frequency that a text states, or those that satisfy an equation for them. Raises ProblemError."""
    omega = reference.scope.scalar("omega")
    scope = replace(reference.scope, decimals="")
    if "=" not in fragment.text or LABELLED.match(fragment.text) or not isinstance(omega, sp.Symbol):
        return [_read(fragment, reference)]
    stated = statement(fragment, scope, reference.declared)
    if len(stated.sides) != 2:
        return [_read(fragment, reference)]
    sides = [tried(f, stated.scope, lambda f: read_value(f, stated.scope, [], latex=True)) for f in stated.sides]
    square = sp.Symbol("square", positive=True)
    difference = sides[0] - sides[1] if not any(isinstance(side, Vector) for side in sides) else sp.S.Zero
    equation = sp.numer(sp.together(difference.xreplace({omega: sp.sqrt(square)})))
    if (
        not equation.is_polynomial(square)
        or not 0 < sp.degree(sp.expand(equation), square) <= HIGHEST_FREQUENCY_EQUATION
    ):
        return [_read(fragment, reference)]
    return [sp.sqrt(root) for root in sp.roots(sp.expand(equation), square)]


def _of_models(claims: Sequence[sp.Expr], places: Sequence[EquilibriumPoint], reference: Reference) -> str:
    """The changed problem that has these frequencies at one of the equilibria, in a sentence."""
    from lagrange.answers.models.frequencies import explained_by_models

    for place in places:
        own = place.resting.configuration.slots.coordinates
        for c in reference.candidates:
            if c.system.configuration.slots.coordinates != own:
                continue
            try:
                if reason := explained_by_models([as_written(e) for e in claims], c.models, place.at):
                    return reason
            except (NotAlgebraicError, DivisionByZeroError):
                continue
    return ""


def _of_other_bodies(lists: Sequence[Sequence[sp.Expr]], solution: Solution, values: Values) -> str:
    """The other moments of inertia with which these are the frequencies, in a sentence; empty if there are none."""
    from lagrange.answers.results.meanings import other_bodies

    others = other_bodies(solution)
    if others is None:
        return ""
    places = [p for v in others[0].views if v.linearization is not None for p in _places(v.linearization, {})]
    for clause, rule in others[1]:
        special = {**values, **rule}
        if all(c != 0 and any(p.is_root(c, special) for p in places) for claims in lists for c in claims):
            return f"these are the frequencies {clause}"
    return ""


_NAME = "frequencies"


def _places(f: Linearization, rates: Values) -> Iterator[EquilibriumPoint]:
    """The points at which the characteristic equation is one for ω."""
    for branch, s in zip(f.branches, f.at, strict=True):
        if s is not None and s.oscillates and s.characteristic is not None:
            yield from (EquilibriumPoint(s, f.equilibrium, branch, p, rates) for p in branch.points)


def _is_complete(f: Linearization) -> bool:
    """Whether all equilibria, and the characteristic equations there, are known."""
    known = all(
        b.special or (s is not None and s.characteristic is not None) for b, s in zip(f.branches, f.at, strict=True)
    )
    return f.complete and f.equilibrium.solution.verified is not None and known


def _one_value(fragment: Fragment, reference: Reference, what: str, cure: str) -> tuple[str, sp.Expr]:
    """The name before the first `=`, if any, and the value."""
    stated = statement(fragment, replace(reference.scope, decimals=""), reference.declared)
    if len(stated.sides) > 1:
        raise ProblemError(Diagnostic("unexpected-equation", f"{what} is one value", fragment.whole, help=cure))
    value = tried(stated.sides[0], stated.scope, lambda f: read_value(f, stated.scope, [], latex=True))
    if isinstance(value, Vector):
        raise ProblemError(Diagnostic("vector-for-scalar", f"{what} is a number, not a vector", fragment.whole))
    return stated.label, value


def _read(fragment: Fragment, reference: Reference) -> sp.Expr:
    """ω; it may be stated as `omega^2 = ...`, by the period `T = ...`, or by `f = ...`, the periods in a second."""
    label, value = _one_value(fragment, reference, "a frequency", "write `sqrt(k/m)`, or `omega = sqrt(k/m)`")
    letter, squared = label[:1], label.endswith("^2")
    value = sp.sqrt(value) if squared else value
    if letter in ("T", "τ") and value != 0:
        return 2 * sp.pi / value
    return 2 * sp.pi * value if label.removesuffix("^2") in ("f", "nu", "ν") else value


def _of_list(
    claims: Sequence[sp.Expr],
    texts: Sequence[str],
    places: Sequence[EquilibriumPoint],
    values: dict[sp.Symbol, sp.Rational],
    *,
    complete: bool,
) -> AnswerVerdict:
    """The verdict on one list, at the equilibrium where it is best."""
    roots = [[p.is_root(c, values) for c in claims] for p in places]
    verdict = min((_at_one(claims, r, p, values) for r, p in zip(roots, places, strict=True)), key=_BEST.index)
    if verdict is Verdict.WRONG and not complete:
        return AnswerVerdict(Verdict.UNDECIDED, name=_NAME, diagnosis=_NOT_ALL_KNOWN)
    diagnosis = UNDECIDED if verdict is Verdict.UNDECIDED else ""
    if verdict is Verdict.WRONG and len(claims) > 1:
        nowhere = [text for text, *at in zip(texts, *roots, strict=True) if True not in at]
        diagnosis = f"not right: {', '.join(nowhere)}" if nowhere else _SEVERAL
    return AnswerVerdict(verdict, name=_NAME, diagnosis=diagnosis)


def _at_one(
    claims: Sequence[sp.Expr],
    right: Sequence[bool | None],
    place: EquilibriumPoint,
    values: dict[sp.Symbol, sp.Rational],
) -> Verdict:
    """The verdict on one list at one equilibrium; `right`: whether each is a root there."""
    if None in right or False in right:
        return Verdict.WRONG if False in right else Verdict.UNDECIDED
    nonzero = [c for c in claims if place.differ(c, sp.S.Zero, values)]
    different = [place.differ(a, b, values) for a, b in combinations(nonzero, 2)]
    if None in different:
        return Verdict.UNDECIDED
    repeated = different.count(False)
    return Verdict.EQUIVALENT if len(nonzero) - repeated == sum(_degrees(place)) else Verdict.INCOMPLETE


def _degrees(place: EquilibriumPoint) -> Iterator[int]:
    """The number of different frequencies of each factor, without zero and roots ω² known to be negative."""
    frequencies = place.oscillations.frequencies
    factors = {f.factor: f for f in frequencies}
    squares = {(f.factor, f.square) for f in frequencies if f.square is not None}
    none = [factor for factor, square in squares if place.sign(square) in (-1, 0)]
    for f in factors.values():
        if f.factor != f.letter:
            yield int(sp.degree(f.factor, f.letter)) - none.count(f.factor)


# -- with damping ------------------------------------------------------------------------------------------------------


@record
class _Exponents:
    """What can be stated of the modes at one equilibrium: their ω², or their decay rates.

    exact    in closed form; None if not all are
    own      what ω² would be without damping, as far as known
    numbers  with the values of the parameters; None if some have none
    zero     whether zero is one of them: it may be stated, and omitted
    """

    exact: tuple[sp.Expr, ...] | None
    own: tuple[sp.Expr, ...]
    numbers: tuple[sp.Expr, ...] | None
    values: dict[sp.Symbol, sp.Rational]
    zero: bool

    def has(self, claim: sp.Expr, squared: bool) -> int | None:
        """The index of a stated value, or _ZERO; −1 where it is none of them, None if that is undecided."""
        if claim == 0 and self.zero:
            return _ZERO
        undecided = False
        for n, wanted in enumerate(self.exact or ()):
            difference = (claim - wanted).xreplace(self.values)
            right = vanishes_or_not(as_written(difference))
            if right or (right is False and numbers_rounding_to([difference]) is not None):
                return n
            undecided = undecided or right is None
        if self.exact is not None or self.numbers is None:
            return None if undecided or self.exact is None else -1
        claim = (sp.sqrt(claim) if squared else claim).xreplace(self.values)
        value = as_written(claim)
        if not value.is_number:
            return -1
        slack = sp.Add(*(abs(as_written(claim.diff(d))) * d.half_width for d in decimals_in([claim])))
        near = slack + abs(value) * sp.Float(10) ** -20
        return next((n for n, w in enumerate(self.numbers) if bool(abs((value - w).evalf(30)) <= near.evalf(30))), -1)


def vanishes_or_not(e: sp.Expr) -> bool | None:
    """`is_zero`, where a division by zero is not zero."""
    try:
        return is_zero(e)
    except DivisionByZeroError:
        return False


def check_decay(
    stated: Sequence[Sequence[Fragment]], linearizations: Sequence[Linearization], reference: Reference
) -> AnswerVerdict:
    """The verdict on stated decay rates."""
    try:
        lists = [[_read_rate(f, reference) for f in fragments] for fragments in stated]
    except ProblemError as error:
        why = error.diagnostics[0].message
        return AnswerVerdict(Verdict.UNREADABLE, unreadable=tuple(error.diagnostics), name="decay", diagnosis=why)
    damped = [p for f in linearizations for p in _damped(f, reference, rates=True)]
    if not damped:
        return AnswerVerdict(Verdict.UNDECIDED, name="decay", diagnosis=_NO_DECAY)
    return _of_exponents("decay", stated, lists, damped, linearizations)


_ZERO = -2  # instead of an index
_UNDAMPED = "these are the frequencies without damping"
_NO_DECAY = "no equilibrium with decay rates is known: nothing is damped there, or the exponents have no closed form"


def _damped(f: Linearization, reference: Reference, *, rates: bool) -> Iterator[_Exponents]:
    """The modes about the equilibria of damped equations."""
    values = dict(reference.values)
    for s in f.at:
        decaying = None if s is None else s.decaying
        if s is None or decaying is None:
            continue
        exact: list[sp.Expr] = []
        for m in decaying.modes:
            exact += m.decays if rates else [m.square] if m.square is not None and m.oscillates is not False else []
        coordinates = {*f.configuration.slots.coordinates}
        if any(e.free_symbols & coordinates for e in exact):
            continue
        numbers = None if decaying.complete else _in_numbers(s, values, rates=rates)
        own = () if rates else tuple(m.own for m in decaying.modes if m.own is not None)
        zero = any(e == 0 for e in exact)
        yield _Exponents(tuple(_different(exact)) if decaying.complete else None, own, numbers, values, zero)


def _different(exact: Sequence[sp.Expr]) -> Iterator[sp.Expr]:
    """The nonzero values, each once."""
    kept: list[sp.Expr] = []
    for e in exact:
        if e != 0 and not any(vanishes_or_not(e - k) for k in kept):
            kept.append(e)
    return iter(kept)


def _in_numbers(
    s: SmallOscillations, values: dict[sp.Symbol, sp.Rational], *, rates: bool
) -> tuple[sp.Expr, ...] | None:
    """The decay rates, or the frequencies, of the exponents in numbers; None if a parameter has no value."""
    with mpmath.workdps(60):
        tables = [[[e.xreplace(values) for e in row] for row in x]
                  for x in (s.system.mass, s.system.damping, s.system.stiffness)]  # fmt: skip
        if any(not e.is_number for table in tables for row in table for e in row):
            return None
        read = [mpmath.matrix([[mpmath.mpf(str(e.evalf(60))) for e in row] for row in table]) for table in tables]
        try:
            exponents = exponents_in_numbers(*read)
        except (ZeroDivisionError, mpmath.NoConvergence):
            return None
        numbers = (sp.Float(x.rate if rates else x.frequency, 40) for x in exponents)
        kept: list[sp.Float] = []
        for x in numbers:
            if x != 0 and all(abs(x - k) > sp.Float(10) ** -20 * abs(x) for k in kept):
                kept.append(x)
        return tuple(kept)


def _of_exponents(
    name: str,
    stated: Sequence[Sequence[Fragment]],
    lists: Sequence[Sequence[sp.Expr]],
    places: Sequence[_Exponents],
    linearizations: Sequence[Linearization],
) -> AnswerVerdict:
    """The verdict on all lists, each at the equilibrium where it is best; the worst list counts."""
    squared = name == _NAME
    verdicts, wrong = [], []
    for fragments, claims in zip(stated, lists, strict=True):
        at = [[p.has(c, squared) for c in claims] for p in places]
        verdict = min((_of_found(matched, p) for matched, p in zip(at, places, strict=True)), key=_BEST.index)
        verdicts.append(verdict)
        if verdict is Verdict.WRONG:
            wrong += [f.text.strip() for f, *matched in zip(fragments, *at, strict=True) if {*matched} == {-1}]
    worst = max(verdicts, key=_BEST.index)
    if worst is Verdict.WRONG and not all(_is_complete(f) for f in linearizations):
        return AnswerVerdict(Verdict.UNDECIDED, name=name, diagnosis=_NOT_ALL_KNOWN)
    if worst is not Verdict.WRONG:
        return AnswerVerdict(worst, name=name, diagnosis=UNDECIDED if worst is Verdict.UNDECIDED else "")
    undamped = any(
        all(any(vanishes_or_not(as_written(c - w)) for w in p.own) for c in claims) for claims in lists for p in places
    )
    why = f"not right: {', '.join(wrong)}" if wrong else _SEVERAL
    if undamped:
        return AnswerVerdict(worst, name=name, diagnosis=f"{why}; {_UNDAMPED}")
    from lagrange.answers.models.frequencies import of_damped

    claimed = [as_written(c) for claims in lists for c in claims if {p.has(c, squared) for p in places} == {-1}]
    causes = of_damped(claimed, [p.exact or () for p in places], linearizations, squared=squared)
    return AnswerVerdict(worst, name=name, diagnosis="; ".join(filter(None, [why, next(filter(None, causes), "")])))


def _of_found(matched: Sequence[int | None], place: _Exponents) -> Verdict:
    if None in matched or -1 in matched:
        return Verdict.WRONG if -1 in matched else Verdict.UNDECIDED
    wanted = place.exact if place.exact is not None else place.numbers
    return Verdict.EQUIVALENT if len({*matched} - {_ZERO}) == len(wanted or ()) else Verdict.INCOMPLETE


def _read_rate(fragment: Fragment, reference: Reference) -> sp.Expr:
    """σ; it may be stated as `sigma = ...`, or by the time constant `tau = ...`."""
    label, value = _one_value(fragment, reference, "a decay rate", "write `c/(2*m)`, or `sigma = c/(2*m)`")
    return 1 / value if label in ("tau", "τ") and value != 0 else value
