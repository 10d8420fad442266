"""Stated frequencies of small oscillations: are they right, and all of them?

A list has the frequencies ω of one equilibrium. Each must be a root of the characteristic equation there, by exact
substitution, so that no closed form is needed; coordinates in either have their values at the equilibrium. All
different ones must be there, with or without the frequency 0. A root ω² that is negative for all values of the
parameters is no frequency. Several lists belong to several equilibria. A list is tried at every equilibrium, in every
set of coordinates, and the best verdict counts. It is wrong only if the linear equations are known at all equilibria.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.models.letters import explained_frequencies
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import UNDECIDED, AnswerVerdict, Verdict
from lagrange.answers.written.decimals import as_written, rounded
from lagrange.answers.written.reading import tried
from lagrange.answers.written.statements import statement
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import read_value
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations

_BEST = (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.UNDECIDED, Verdict.WRONG)
_NONE_KNOWN = "no equilibrium with a characteristic equation for the frequencies is known in closed form"
_NOT_ALL_KNOWN = "not right at any equilibrium with known linear equations, but not all equilibria have these"
_SEVERAL = "no equilibrium has all of them"


@record
class _Place:
    """A point of an equilibrium and its linear equations.

    resting  all equilibria of the configuration
    """

    oscillations: SmallOscillations
    resting: Equilibrium
    branch: Branch
    point: Values

    @property
    def characteristic(self) -> sp.Expr:
        """The polynomial in ω at the point."""
        assert self.oscillations.characteristic is not None
        return self.oscillations.characteristic

    def at(self, e: sp.Expr) -> sp.Expr:
        """An expression with the values of the coordinates. Raises NotAlgebraicError."""
        coordinates = {*self.resting.configuration.slots.coordinates}
        stated = {r.lhs: r.rhs for r in self.branch.relations if r.lhs in coordinates}
        for _ in stated:
            e = e.xreplace(stated)
        return self.resting.solution.at(self.point, e) if e.free_symbols & coordinates else e

    def sign(self, e: sp.Expr) -> int | None:
        """The sign of an expression, if it is the same for all values of the parameters."""
        try:
            return sign_of(self.at(e))
        except NotAlgebraicError:
            return None

    def is_root(self, claim: sp.Expr, values: Values) -> bool | None:
        """Whether a frequency satisfies the characteristic equation; None: undecided."""
        try:
            residual = self.at(self.characteristic.xreplace({self.oscillations.unknown: claim})).xreplace(values)
            right = is_zero(as_written(residual))
            return True if right is False and rounded([residual]) is not None else right
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


def check_frequencies(
    stated: Sequence[Sequence[Fragment]], linearizations: Sequence[Linearization], reference: Reference
) -> AnswerVerdict:
    """The verdict on all lists together."""
    try:
        lists = [[_read(f, reference) for f in fragments] for fragments in stated]
    except ProblemError as error:
        why = error.diagnostics[0].message
        return AnswerVerdict(Verdict.UNREADABLE, unreadable=tuple(error.diagnostics), name=_NAME, diagnosis=why)
    places = [p for f in linearizations for p in _places(f)]
    if not places:
        return AnswerVerdict(Verdict.UNDECIDED, name=_NAME, diagnosis=_NONE_KNOWN)
    complete = any(_is_complete(f) for f in linearizations)
    values = dict(reference.values)
    texts = [[f.text.strip() for f in fragments] for fragments in stated]
    verdicts = [_of_list(c, t, places, values, complete=complete) for c, t in zip(lists, texts, strict=True)]
    best = max(verdicts, key=lambda v: _BEST.index(v.verdict))
    if best.verdict is not Verdict.WRONG and best.diagnosis != _NOT_ALL_KNOWN:
        return best
    for sentence, meant in (pair for claims in lists for pair in explained_frequencies(claims)):
        if _of_list(meant, [""] * len(meant), places, values, complete=complete).verdict in (
            Verdict.EQUIVALENT,
            Verdict.INCOMPLETE,
        ):
            return replace(best, diagnosis="; ".join(filter(None, [best.diagnosis, sentence])))
    sentence = next(filter(None, (_of_models(claims, places, reference) for claims in lists)), "")
    return replace(best, diagnosis="; ".join(filter(None, [best.diagnosis, sentence])))


def _of_models(claims: Sequence[sp.Expr], places: Sequence[_Place], reference: Reference) -> str:
    """Of which changed problem these are the frequencies at one of the equilibria, in a sentence."""
    from lagrange.answers.models.frequencies import explained_by_models

    for place in places:
        own = place.resting.configuration.slots.coordinates
        for c in reference.candidates:
            if c.system.configuration.slots.coordinates != own:
                continue
            try:
                if found := explained_by_models([as_written(e) for e in claims], c.models, place.at):
                    return found
            except (NotAlgebraicError, DivisionByZeroError):
                continue
    return ""


_NAME = "frequencies"


def _places(f: Linearization) -> Iterator[_Place]:
    """The points at which the characteristic equation is one for ω."""
    for branch, s in zip(f.branches, f.at, strict=True):
        if s is not None and s.oscillates and s.characteristic is not None:
            yield from (_Place(s, f.equilibrium, branch, p) for p in branch.points)


def _is_complete(f: Linearization) -> bool:
    """Whether all equilibria, and the characteristic equations there, are known."""
    known = all(
        b.special or (s is not None and s.characteristic is not None) for b, s in zip(f.branches, f.at, strict=True)
    )
    return f.complete and f.equilibrium.solution.verified is not None and known


def _read(fragment: Fragment, reference: Reference) -> sp.Expr:
    """ω; it may be stated as `omega^2 = ...`, by the period `T = ...`, or by `f = ...`, the periods in a second."""
    stated = statement(fragment, replace(reference.scope, decimals=""), reference.declared)
    if len(stated.sides) > 1:
        message = "a frequency is one value"
        help_ = "write `sqrt(k/m)`, or `omega = sqrt(k/m)`"
        raise ProblemError(Diagnostic("unexpected-equation", message, fragment.whole, help=help_))
    value = tried(stated.sides[0], stated.scope, lambda f: read_value(f, stated.scope, [], latex=True))
    if isinstance(value, Vector):
        raise ProblemError(Diagnostic("vector-for-scalar", "a frequency is a number, not a vector", fragment.whole))
    letter, squared = stated.label[:1], stated.label.endswith("^2")
    value = sp.sqrt(value) if squared else value
    if letter in ("T", "τ") and value != 0:
        return 2 * sp.pi / value
    return 2 * sp.pi * value if stated.label.removesuffix("^2") in ("f", "nu", "ν") else value


def _of_list(
    claims: Sequence[sp.Expr],
    texts: Sequence[str],
    places: Sequence[_Place],
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
    claims: Sequence[sp.Expr], right: Sequence[bool | None], place: _Place, values: dict[sp.Symbol, sp.Rational]
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


def _degrees(place: _Place) -> Iterator[int]:
    """The number of different frequencies of each factor, without zero and roots ω² known to be negative."""
    frequencies = place.oscillations.frequencies
    factors = {f.factor: f for f in frequencies}
    squares = {(f.factor, f.square) for f in frequencies if f.square is not None}
    none = [factor for factor, square in squares if place.sign(square) in (-1, 0)]
    for f in factors.values():
        if f.factor != f.letter:
            yield int(sp.degree(f.factor, f.letter)) - none.count(f.factor)
