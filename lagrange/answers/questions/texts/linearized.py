r"""Equations of small oscillations as an answer, where a problem asks for them: M ξ'' + D ξ' + K ξ = 0.

    for small angles: m l θ1'' + m g θ1 + c l (θ1 - θ2) = 0        2 l \ddot\xi_1 + l \ddot\xi_2 + 2 g \xi_1 = 0

The coordinates, or the letters ξ, stand for the small changes from an equilibrium. An equation c·ξ'' + d·ξ' + k·ξ = 0
is a combination α of the derived ones, with α M = c, if α D = d and α K = k. The equilibrium at which most of the
equations are right is the one that is meant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.limits import MOST_LINEARIZED
from lagrange.answers.questions.frequencies import EquilibriumPoint
from lagrange.answers.readings import GivenEquation
from lagrange.answers.references import reference_of_solution
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written
from lagrange.answers.written.working import Working, understood
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.symbols import base, prime
from lagrange.document.math_writer import text
from lagrange.mechanics.equilibrium.linearization import Linearization
from lagrange.mechanics.results import Solution

_ABOUT = "it is compared with the equations linearized about {}"
_OTHER = "with these coefficients of the accelerations, that of `{}` is another in the equations linearized about {}"


def check_linearized(answer: Sequence[Fragment], solution: Solution) -> AnswerVerdict | None:
    """The verdict on equations that are marked as those of small oscillations; None if there are others."""
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
        if not in_letters and len(working.approximate) < len(readings):
            continue
        slots = linearization.displacements if in_letters else linearization.configuration.slots.coordinates
        for place in _places(linearization):
            size = len(place.oscillations.free)
            if size > MOST_LINEARIZED:
                continue
            at = _position(place)
            claims = [_coefficients(as_written(e).xreplace(dict(reference.values)), slots, place) for e in equations]
            if any(c is None for c in claims):
                continue
            known = [c for c in claims if c is not None]
            parts = [
                _judged(r.text, c, slots, place, at) for r, c in zip(readings, known, strict=True)
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


def _position(place: EquilibriumPoint) -> str:
    """Where the equilibrium is: `theta1 = 0, theta2 = 0`."""
    return ", ".join(f"{text(r.lhs)} = {text(r.rhs)}" for r in place.branch.relations) or "the equilibrium"


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


def _judged(
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
