r"""Stated linear equations, of a large system about its steady motion and of small oscillations: are they right?

Are stated linear equations those of a large system about its steady motion, M ξ'' + D ξ' + K ξ = 0 in numbers?

The coordinates stand for their small changes. An equation c·ξ'' + d·ξ' + k·ξ = 0 is right if it is a combination of
the derived ones: with α M = c, its other coefficients must be α D and α K, for several values of the parameters without
values. A decimal stands for all numbers that round to it: every coefficient may differ by what half a unit in the last
place of each of its decimals makes of it. Blocks without D and K, which only say that a velocity is constant, need not
be stated.

Published matrices are compared in this form, a row of M, D, K written as one equation.

Equations of small oscillations as an answer, where a problem asks for them: M ξ'' + D ξ' + K ξ = 0.

    for small angles: m l θ1'' + m g θ1 + c l (θ1 - θ2) = 0        2 l \ddot\xi_1 + l \ddot\xi_2 + 2 g \xi_1 = 0

The coordinates, or the letters ξ, stand for the small changes from an equilibrium. An equation c·ξ'' + d·ξ' + k·ξ = 0
is a combination α of the derived ones, with α M = c, if α D = d and α K = k. The equilibrium at which most of the
equations are right is the one that is meant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.limits import MOST_LINEARIZED, ROUNDED_COEFFICIENT
from lagrange.answers.questions.frequencies import EquilibriumPoint
from lagrange.answers.questions.texts.frequency_labels import stated_position
from lagrange.answers.readings import GivenEquation, decimals_in
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written
from lagrange.answers.written.reading import tried
from lagrange.answers.written.statements import statement
from lagrange.answers.written.working import Working, understood
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.symbols import base, prime
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import read_value
from lagrange.mechanics.equilibrium.linearization import Linearization
from lagrange.mechanics.nearby.linear_motion import LinearMotion
from lagrange.mechanics.results import Solution

VALUES = (mpmath.mpf("0.7321"), mpmath.mpf("1.6180"), mpmath.mpf("3.1973"), mpmath.mpf("5.4321"))
"""Of a parameter without a value: more than the degree of any coefficient needs."""
_NONLINEAR = "it is not linear in the small changes: of a system of this size only the linear equations are compared"


class _Tables:
    """M, D, K of all blocks together, coordinate by coordinate."""

    def __init__(self, motion: LinearMotion) -> None:
        self.letters = motion.letters
        self.coordinates = tuple(q for b in motion.blocks for q in b.coordinates)
        self.required = sum(
            len(b.coordinates)
            for b in motion.blocks
            if any(e != 0 for t in (b.damping, b.stiffness) for r in t for e in r)
        )
        self.all = [
            sp.diag(*(sp.Matrix(table) for table in tables))
            for tables in zip(*((b.mass, b.damping, b.stiffness) for b in motion.blocks), strict=True)
        ]

    @property
    def slots(self) -> list[sp.Symbol]:
        """ξ'', then ξ', then ξ."""
        return [prime(q, order) if order else q for order in (2, 1, 0) for q in self.coordinates]

    def at(self, values: dict[sp.Symbol, sp.Expr]) -> list[mpmath.matrix]:
        """M, D, K at values of the letters."""
        return [mpmath.matrix(m.xreplace(values).evalf(30).tolist()) for m in self.all]


def check_linear_motion_answers(stated: Sequence[Fragment], solution: Solution) -> AnswerVerdict:
    """The verdict on equations together."""
    assert solution.linear_motion is not None
    tables, reference = _Tables(solution.linear_motion), reference_of_solution(solution)
    parts: list[EquationVerdict] = []
    unreadable: list[Diagnostic] = []
    right: list[sp.Expr] = []
    for fragment in stated:
        text = fragment.text.strip()
        try:
            e = _balance(fragment, reference).xreplace(reference.values)
        except ProblemError as error:
            unreadable += error.diagnostics
            parts.append(EquationVerdict.of(text, Verdict.UNREADABLE, error.diagnostics[0].message))
            continue
        verdict, why = _judged_about_motion(e, tables)
        right += [e] if verdict is Verdict.EQUIVALENT else []
        parts.append(EquationVerdict.of(text, verdict, why))
    order = (Verdict.UNREADABLE, Verdict.WRONG, Verdict.UNDECIDED)
    verdict = next((v for v in order if any(p.verdict is v for p in parts)), Verdict.EQUIVALENT)
    missing = 0
    if verdict is Verdict.EQUIVALENT:
        missing = max(0, tables.required - _independent(right, tables))
        verdict = Verdict.INCOMPLETE if missing and right else Verdict.TRIVIAL if not right else verdict
    return AnswerVerdict(verdict, tuple(parts), missing, unreadable=tuple(unreadable))


def _balance(fragment: Fragment, reference: Reference) -> sp.Expr:
    """Left side minus right side. Raises ProblemError."""
    read = statement(fragment, replace(reference.scope, decimals=""), reference.declared)
    sides = [tried(side, read.scope, lambda f: read_value(f, read.scope, [], latex=True)) for side in read.sides]
    scalars = [s for s in sides if not isinstance(s, Vector)]
    if len(sides) != 2 or len(scalars) != 2:
        code = "no-equals-sign" if len(sides) < 2 else "several-equals-signs"
        help_ = "write each equation in a line of its own: `m*x'' + k*x = 0`"
        raise ProblemError(Diagnostic(code, "an equation between two numbers is expected", fragment.whole, help=help_))
    return sp.expand(scalars[0] - scalars[1])


def _judged_about_motion(e: sp.Expr, tables: _Tables) -> tuple[Verdict, str]:
    slots = tables.slots
    others = {base(s) for s in e.free_symbols} - {*tables.coordinates, *tables.letters}
    if strangers := sorted(s.name for s in others if s not in decimals_in([e])):
        names = ", ".join(f"`{q.name}`" for q in tables.coordinates)
        return Verdict.UNDECIDED, f"`{strangers[0]}` is not among {names}, in which the linear equations are compared"
    coefficients = [e.diff(s) for s in slots]
    rest = e.xreplace(dict.fromkeys(slots, sp.S.Zero))
    if as_written(rest) != 0 or any(c.free_symbols & {*slots} for c in coefficients):
        return Verdict.WRONG, _NONLINEAR
    if all(as_written(c) == 0 for c in coefficients):
        return Verdict.TRIVIAL, "it holds for every motion"
    for value in VALUES[: 1 if not tables.letters else None]:
        at = {v: sp.Float(str(value * (n + 1)), 30) for n, v in enumerate(tables.letters)}
        wrong = _first_that_differs(coefficients, at, tables)
        if wrong is not None:
            return Verdict.WRONG, f"with these coefficients of the accelerations, that of `{wrong}` is another"
    return Verdict.EQUIVALENT, ""


def _first_that_differs(
    coefficients: Sequence[sp.Expr], at: dict[sp.Symbol, sp.Expr], tables: _Tables
) -> sp.Symbol | None:
    """The first slot whose coefficient does not follow from those of the accelerations, at values of the letters."""
    size = len(tables.coordinates)
    stated = [mpmath.mpf(str(as_written(c).xreplace(at).evalf(30))) for c in coefficients]
    slack = [mpmath.mpf(str(_slack(c, at))) for c in coefficients]
    mass, *others = tables.at(at)
    inverse = mass**-1
    combination = mpmath.matrix([stated[:size]]) * inverse
    largest = max(abs(x) for x in stated)
    for k, table in enumerate(others, start=1):
        share = inverse * table
        expected = combination * table
        for j in range(size):
            spread = slack[k * size + j] + sum(slack[i] * abs(share[i, j]) for i in range(size))
            if abs(stated[k * size + j] - expected[j]) > spread + ROUNDED_COEFFICIENT * largest:
                return tables.slots[k * size + j]
    return None


def _slack(coefficient: sp.Expr, at: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """The tolerance of a coefficient that is given in decimals."""
    return sp.Add(
        *(abs(as_written(coefficient.diff(d)).xreplace(at)) * d.half_width for d in decimals_in([coefficient]))
    ).evalf(30)


def _independent(right: Sequence[sp.Expr], tables: _Tables) -> int:
    """How many of the equations are independent, apart from those of coordinates that move uniformly."""
    accelerations = [prime(q, 2) for q in tables.coordinates]
    rows = [[as_written(e.diff(a)).xreplace(dict.fromkeys(tables.letters, sp.Rational(7, 5))) for a in accelerations]
            for e in right]  # fmt: skip
    return int(sp.Matrix(rows).rank(iszerofunc=lambda x: abs(x) < sp.Float("1e-9"))) if rows else 0


# About an equilibrium


_ABOUT = "it is compared with the equations linearized about {}"
_OTHER = "with these coefficients of the accelerations, that of `{}` is another in the equations linearized about {}"


def check_linearized(
    answer: Sequence[Fragment], solution: Solution, *, are_marked: bool = False
) -> AnswerVerdict | None:
    """The verdict on equations that are marked as those of small oscillations; None if there are others.

    are_marked  whether what stands beside them, frequencies, marks them
    """
    reference = reference_of_solution(solution)
    try:
        working = understood(answer, reference)
    except ProblemError:
        return None
    readings = [f.reading for f in working.judged if isinstance(f, GivenEquation)]
    equations = [e for r in readings for e in r.components]
    if not equations or len(equations) != len(working.judged) or working.unreadable or working.unknowns:
        return None
    best: tuple[int, list[EquationVerdict], int, str] | None = None
    for view in solution.views:
        linearization = view.linearization
        if linearization is None:
            continue
        letters = dict(zip(linearization.displacements, linearization.configuration.slots.coordinates, strict=True))
        in_letters = any(base(s) in letters for e in equations for s in e.free_symbols)
        if not (
            are_marked or in_letters or 0 in working.approximate
        ):  # a mark before the first counts for all that follow
            continue
        slots = linearization.displacements if in_letters else linearization.configuration.slots.coordinates
        for place in _places(linearization):
            size = len(place.oscillations.free)
            if size > MOST_LINEARIZED:
                continue
            at = stated_position(place.branch)
            claims = [_coefficients(as_written(e).xreplace(dict(reference.values)), slots, place) for e in equations]
            if any(c is None for c in claims):
                continue
            known = [c for c in claims if c is not None]
            parts = [
                _judged_about_rest(r.text, c, slots, place, at) for r, c in zip(readings, known, strict=True)
            ]  # fmt: skip
            right = [c for c, p in zip(known, parts, strict=True) if p.verdict is Verdict.EQUIVALENT]
            rank = sp.Matrix([[*c[0]] for c in right]).rank(iszerofunc=_vanishes) if right else 0
            if best is None or len(right) > best[0]:
                best = len(right), parts, size - rank, at
    return _verdict(best, working, answer) if best is not None else None


def _verdict(
    best: tuple[int, list[EquationVerdict], int, str], working: Working, answer: Sequence[Fragment]
) -> AnswerVerdict:
    _, parts, missing, at = best
    verdict = next((v for v in (Verdict.WRONG, Verdict.UNDECIDED) if any(p.verdict is v for p in parts)), None)
    if verdict is None:
        verdict = Verdict.INCOMPLETE if missing else Verdict.EQUIVALENT
    note = Diagnostic("read-as", _ABOUT.format(at), answer[0].whole).as_note()
    missing = missing if verdict is Verdict.INCOMPLETE else 0
    return AnswerVerdict(verdict, tuple(parts), missing, notes=(*working.notes, note), name="linear_equations")


def _places(linearization: Linearization) -> Iterator[EquilibriumPoint]:
    """The equilibria with their linear equations."""
    for branch, s in zip(linearization.branches, linearization.at, strict=True):
        if s is not None:
            yield from (EquilibriumPoint(s, linearization.equilibrium, branch, point) for point in branch.points)


def number_of_oscillating_places(solution: Solution) -> int | None:
    """The number of equilibria with different frequencies, without those where nothing can oscillate; None: unknown."""
    numbers = []
    for view in solution.views:
        if view.linearization is None:
            continue
        found: list[list[sp.Expr]] = []
        for place in _places(view.linearization):
            try:
                squares = [f.square if f.square is None else place.at(f.square) for f in place.oscillations.frequencies]
            except NotAlgebraicError:
                return None
            if not squares or None in squares:
                return None
            known = [e for e in squares if e is not None]
            same = any(len(o) == len(known) and all(map(_vanishes, map(sp.Add, o, (-e for e in known)))) for o in found)
            if not same and all(place.sign(f.square) != -1 for f in place.oscillations.frequencies):
                found.append(known)
        numbers.append(len(found))
    return max(numbers, default=None)


_Coefficients = tuple[list[sp.Expr], list[sp.Expr], list[sp.Expr]]
"""Of the accelerations, the velocities, and the positions."""


def _coefficients(e: sp.Expr, slots: Sequence[sp.Symbol], place: EquilibriumPoint) -> _Coefficients | None:
    """The coefficients of an equation in the independent small changes; None if it is not linear in these alone."""
    every = [prime(q, order) if order else q for order in (2, 1, 0) for q in slots]
    e = sp.expand(e)
    if any(e.diff(s).free_symbols & {*every} for s in every):
        return None
    try:
        if not _vanishes(e.xreplace(dict.fromkeys(every, sp.S.Zero))):
            return None
    except DivisionByZeroError:
        return None
    shape = place.oscillations.shape
    rows = [[e.diff(s) for s in every[n * len(slots) : (n + 1) * len(slots)]] for n in range(3)]
    free = range(len(place.oscillations.free))
    second, first, none = (
        [sp.Add(*(c * place.at(shape[k][j]) for k, c in enumerate(row))) for j in free] for row in rows
    )
    return second, first, none


def _judged_about_rest(
    text_: str, claim: _Coefficients, slots: Sequence[sp.Symbol], place: EquilibriumPoint, at: str
) -> EquationVerdict:
    try:
        wrong = next(_differing(claim, place), None)
    except (DivisionByZeroError, NotAlgebraicError):
        return EquationVerdict.of(text_, Verdict.UNDECIDED, "it could not be compared")
    if wrong is None:
        return EquationVerdict(text_, Verdict.EQUIVALENT)
    order, j = wrong
    q = slots[place.oscillations.free[j]]
    slot = prime(q, order) if order else q
    return EquationVerdict.of(text_, Verdict.WRONG, _OTHER.format(slot, at))


def _differing(claim: _Coefficients, place: EquilibriumPoint) -> Iterator[tuple[int, int]]:
    """The slots, by order and number, whose coefficients do not follow from those of the accelerations."""
    system = place.oscillations.system
    mass, damping, stiffness = (
        sp.Matrix([[place.at(e) for e in row] for row in table])
        for table in (system.mass, system.damping, system.stiffness)
    )
    combination = sp.Matrix([claim[0]]) * mass.adjugate()
    determinant = mass.det(method="berkowitz")
    for order, table, stated in ((1, damping, claim[1]), (0, stiffness, claim[2])):
        expected = combination * table
        for j, coefficient in enumerate(stated):
            if not _vanishes(expected[j] - determinant * coefficient):
                yield order, j


def _vanishes(e: sp.Expr) -> bool:
    return is_zero(e) is True
