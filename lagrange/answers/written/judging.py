"""The verdict on an answer with its working: on everything that can be read, with notes on what was not judged.

A wrong equation is read in its other way, `a/b c` as a/(b c), if that makes it right. An equation that is marked as an
approximation, or that has no acceleration and is no equation of motion (an energy, an integral), does not make an
answer wrong whose other equations are complete. A line that cannot be read leaves the verdict on the rest as it is,
unless something is missing there: it might have been in that line.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.answers.readings import GivenEquation, displaced_coordinates
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import DOES_NOT_FOLLOW, AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.expansions import contradiction_in_expansion
from lagrange.answers.written.working import Working
from lagrange.core.diagnostics import Diagnostic, Fragment, Severity
from lagrange.core.records import record
from lagrange.core.symbols import base, prime, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.dynamics.comparison import Standing, compare
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy

AnswerCheck = Callable[[Sequence[Fragment], bool], AnswerVerdict]
"""The verdict on equations; with or without a diagnosis of wrong ones."""


def verdict_on(
    working: Working, reference: Reference, check: AnswerCheck, *, moving: bool = True, only_motion: bool = False
) -> AnswerVerdict:
    """The verdict on an answer that has been sorted.

    moving       on equations of motion
    only_motion  nothing else is asked for: a relation between coordinates is a constraint, and no position or path

    Raises ProblemError if it has too many equations.
    """
    equations = list(working.judged)
    notes = list(working.notes)
    verdict = check(equations, False)
    if verdict.verdict is Verdict.WRONG:
        equations, verdict, more = _otherwise(equations, verdict, check)
        notes += more
    if verdict.verdict is Verdict.WRONG and moving:
        stated = _Stated(working, reference, only_motion)
        equations, verdict, more = _without_asides(equations, verdict, stated, check)
        notes += more
    if (
        verdict.verdict is Verdict.WRONG
        and moving
        and all(_states_the_motion(equations[n], reference) for n in _wrong(verdict))
    ):
        verdict = check(equations, True)
        judged = [replace(e, diagnosis=_SOLVED) if e.verdict is Verdict.WRONG else e for e in verdict.equations]
        judged = [replace(e, verdict=Verdict.UNDECIDED) if e.verdict is Verdict.WRONG else e for e in judged]
        verdict = replace(verdict, verdict=Verdict.UNDECIDED, equations=tuple(judged), diagnosis=_SOLVED)
    if verdict.verdict is Verdict.WRONG and moving and len(equations) == len(verdict.equations):
        from lagrange.answers.results.forces import right_as_far_as_stated

        verdict = right_as_far_as_stated(equations, verdict, reference) or verdict
    if verdict.verdict is Verdict.WRONG:
        verdict = _with_expansions_explained(check(equations, True), equations, reference)
    return _with_unreadable(replace(verdict, notes=(*verdict.notes, *notes)), equations, working)


def _with_expansions_explained(
    verdict: AnswerVerdict, equations: Sequence[Fragment], reference: Reference
) -> AnswerVerdict:
    """The verdict with the order in which a wrong expansion differs; that it is not exact is no mistake."""
    judged = [*verdict.equations]
    if len(judged) != len(equations):
        return verdict
    for n in _wrong(verdict):
        if why := contradiction_in_expansion(equations[n], reference):
            hints = (judged[n].hints[0] if judged[n].hints else DOES_NOT_FOLLOW, why, why)
            judged[n] = replace(judged[n], diagnosis=why, hints=hints, cause="", model="")
    return replace(verdict, equations=tuple(judged))


def _wrong(verdict: AnswerVerdict) -> list[int]:
    return [n for n, e in enumerate(verdict.equations) if e.verdict is Verdict.WRONG]


def _otherwise(
    equations: list[Fragment], verdict: AnswerVerdict, check: AnswerCheck
) -> tuple[list[Fragment], AnswerVerdict, list[Diagnostic]]:
    """Wrong equations in their other reading, where that makes them right."""
    notes: list[Diagnostic] = []
    if len(verdict.equations) != len(equations):
        return equations, verdict, notes
    for n in _wrong(verdict):
        fragment = equations[n]
        other = fragment.reading.other if isinstance(fragment, GivenEquation) else None
        if other is None:
            continue
        trial = [*equations[:n], GivenEquation(other.text, fragment.whole, None, other), *equations[n + 1 :]]
        again = check(trial, False)
        if again.equations[n].verdict is Verdict.EQUIVALENT:
            equations, verdict = trial, again
            message = f"`{other.text}` has two readings, and is read as the one that is right"
            help_ = "put brackets around a divisor of several factors, and around the argument of a function"
            notes.append(Diagnostic("read-as", message, fragment.whole, help=help_, level=Severity.NOTE))
    return equations, verdict, notes


@record
class _Stated:
    """The data needed to distinguish a wrong statement next to equations of motion from a wrong equation."""

    working: Working
    reference: Reference
    only_motion: bool

    def counts(self, equation: Fragment, others: Sequence[Fragment]) -> bool:
        """Whether a statement without accelerations changes what the answer says of the motion."""
        if not isinstance(equation, GivenEquation):
            return False
        return self._is_another_lagrangian(equation, others) or (self.only_motion and self._binds(equation))

    def _is_another_lagrangian(self, equation: GivenEquation, others: Sequence[Fragment]) -> bool:
        """Whether it gives L another value than the one that is used: the equations that contain L are then its own."""
        if _LAGRANGIAN.match(equation.text) is None or "L" not in self.working.defined:
            return False
        used = {base(s) for e in equation.reading.components for s in e.free_symbols}
        differs = not used.isdisjoint(self.reference.scope.slots.coordinates)  # by more than a constant
        return differs and any(o is not equation and _NAMES_L.search(o.text) for o in others)

    def _binds(self, equation: GivenEquation) -> bool:
        """Whether it is a relation between coordinates that does not hold in the motion, not even up to a constant."""
        slots = self.reference.scope.slots
        if len(equation.reading.components) != 1 or _CASE.search(equation.beside):
            return False
        [e] = equation.reading.components
        if (
            len(e.free_symbols & {*slots.coordinates}) < 2
            or t in e.free_symbols
            or any(base(s) != s for s in e.free_symbols)
        ):
            return False
        for c in self.reference.candidates_for({s.name for s in e.free_symbols}):
            try:
                result = compare([c.read(slots.time_derivative(e))], c.system)
            except DivisionByZeroError:
                continue
            if result is not None and all(s is not Standing.CONTRADICTS for s in result.standings):
                return False
        return True


_LAGRANGIAN = re.compile(r"[\s$&]*(?:\\(?:mathcal|mathscr|mathrm)\s*\{?\s*L\s*\}?|L|ℒ)\s*&?=(?!=)")
_NAMES_L = re.compile(r"(?<![A-Za-z\\])L(?![A-Za-z0-9_])|ℒ")
_CASE = re.compile(r"\b(?:mode|case|if|when|special|phase|suppose|assum\w*|for|at|fall)\b", re.IGNORECASE)


def _without_asides(
    equations: list[Fragment], verdict: AnswerVerdict, stated: _Stated, check: AnswerCheck
) -> tuple[list[Fragment], AnswerVerdict, list[Diagnostic]]:
    """The equations without approximations, and without wrong statements that are no equations of motion."""
    unchanged: tuple[list[Fragment], AnswerVerdict, list[Diagnostic]] = (equations, verdict, [])
    wrong, working, reference = _wrong(verdict), stated.working, stated.reference
    if not wrong or len(verdict.equations) != len(equations):
        return unchanged
    steady = [n for n in wrong if _says_steady(equations[n], reference)]
    if steady and len(steady) < len(equations):
        kept = [e for n, e in enumerate(equations) if n not in steady]
        notes = [_note(equations[n], "is about a steady motion, and is not judged") for n in steady]
        result = _without_asides(kept, check(kept, False), stated, check)
        return result[0], result[1], [*notes, *result[2]]
    if integrals := _integrals_alone(equations, verdict, check):
        return integrals
    if len(wrong) == len(equations):
        return unchanged
    approximations = [n for n in wrong if n in working.approximate]
    approximations = [n for n in approximations if not contradiction_in_expansion(equations[n], reference)]
    if approximations and len(approximations) < len(equations):
        kept = [e for n, e in enumerate(equations) if n not in approximations]
        again = check(kept, False)
        if not _all_approximate(kept, equations, working) and again.verdict is not Verdict.TRIVIAL:
            notes = [_note(equations[n], "is marked as an approximation, and is not judged") for n in approximations]
            rest = replace(stated, working=replace(working, judged=tuple(kept), approximate=frozenset(), notes=()))
            result = _without_asides(kept, again, rest, check)
            return result[0], result[1], [*notes, *result[2]]
    about = [
        n
        for n in wrong
        if (not is_of_motion(equations[n], reference) and not stated.counts(equations[n], equations))
        or _is_kinetic_energy(equations[n], reference)
        or _is_kinematic(equations[n], reference)
    ]
    if len(about) < len(wrong):
        return unchanged
    kept = [e for n, e in enumerate(equations) if n not in about]
    if not any(_has_acceleration(e) for e in kept):
        return unchanged
    again = check(kept, False)
    special = all(_is_integral(verdict, n) for n in about)
    if again.verdict is not Verdict.EQUIVALENT and not (special and again.verdict is Verdict.INCOMPLETE):
        return unchanged
    diagnoses = [verdict.equations[n].diagnosis for n in about]
    notes = [
        _note(equations[n], f"is no equation of motion, and is not judged: {why}")
        for n, why in zip(about, diagnoses, strict=True)
    ]
    return kept, again, notes


_STEADY = re.compile(r"\bsteady\b|\bcircular motion|\bgleichförmig|\bstationär", re.IGNORECASE)
"""What makes an equation one about a particular motion."""


def _says_steady(equation: Fragment, reference: Reference) -> bool:
    r"""Whether an equation is about a steady motion: `A steady circle has \ddot r = 0, hence \dot\varphi^2 = ...`."""
    if not isinstance(equation, GivenEquation):
        return False
    source, start = equation.whole.source.text, equation.span(0, 0).start
    if not _STEADY.search(f"{equation.beside} {source[source.rfind(chr(10), 0, start) + 1 : start]}"):
        return False
    vanishes = all(e.is_Symbol and base(e) != e for e in equation.reading.components)
    return vanishes or not is_of_motion(equation, reference)


def _is_integral(verdict: AnswerVerdict, n: int) -> bool:
    kind = verdict.equations[n].kind
    return kind is not None and kind.is_first_integral


def _integrals_alone(
    equations: Sequence[Fragment], verdict: AnswerVerdict, check: AnswerCheck
) -> tuple[list[Fragment], AnswerVerdict, list[Diagnostic]] | None:
    """An answer in which first integrals, `... = const`, stand for equations of motion, of which some are missing.

    They are true of every motion, and so not wrong; None if anything else is wrong, or their constants are parameters.
    """
    wrong = _wrong(verdict)
    if not all(_is_integral(verdict, n) and _has_free_constant(equations[n]) for n in wrong):
        return None
    kept = [e for n, e in enumerate(equations) if n not in wrong]
    again = check(kept or [Fragment.of("0 = 0")], False)
    if again.verdict not in (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.TRIVIAL):
        return None
    if again.verdict is not Verdict.EQUIVALENT:
        again = replace(again, verdict=Verdict.INCOMPLETE, equations=again.equations if kept else ())
    why = [verdict.equations[n].diagnosis for n in wrong]
    return kept, again, [_note(equations[n], f"is not judged: {d}") for n, d in zip(wrong, why, strict=True)]


def _has_free_constant(equation: Fragment) -> bool:
    """Whether an equation contains the constant that nobody named, `const`."""
    components = equation.reading.components if isinstance(equation, GivenEquation) else ()
    return any(s.name == "const" for e in components for s in e.free_symbols)


def _all_approximate(kept: Sequence[Fragment], equations: Sequence[Fragment], working: Working) -> bool:
    return all(n in working.approximate for n, e in enumerate(equations) if any(e is k for k in kept))


def _note(equation: Fragment, message: str) -> Diagnostic:
    return Diagnostic("not-judged", f"`{equation.text}` {message}", equation.whole, level=Severity.NOTE)


_SOLVED = "it states the motion itself, x = f(t), which is not compared with the equations of motion"


def _states_the_motion(equation: Fragment, reference: Reference) -> bool:
    """Whether an equation gives one coordinate as a function of the time."""
    if not isinstance(equation, GivenEquation) or len(equation.reading.components) != 1:
        return False
    (e,) = equation.reading.components
    sides = [s for s in equation.reading.sides if s in reference.scope.slots.coordinates]
    if len(sides) != 1 or t not in e.free_symbols:
        return False
    others = e.free_symbols - {sides[0], t}
    return sp.diff(e, sides[0]).is_number and all(base(s) == s for s in others)


def _has_acceleration(equation: Fragment) -> bool:
    if not isinstance(equation, GivenEquation):
        return True
    used = {s for c in equation.reading.components for s in c.free_symbols}
    return any(base(s) != s and prime(base(s)) != s for s in used)


def is_of_motion(equation: Fragment, reference: Reference) -> bool:
    """Whether a statement belongs to the question: it contains an acceleration or a constraint force."""
    if not isinstance(equation, GivenEquation) or _has_acceleration(equation):
        return True
    components = equation.reading.components
    if displaced_coordinates(components, reference.scope.slots.coordinates):
        return True
    used = {s.name for c in components for s in c.free_symbols}
    forces = {s.name for c in reference.candidates for s in (*c.multipliers, *c.meanings)}
    return not used.isdisjoint(forces | {u.name for u in reference.unknowns})


def _is_kinematic(equation: Fragment, reference: Reference) -> bool:
    """Whether an equation is about a lapse of time, as 0 = v + a t: accelerations occur with t as a factor only."""
    if not isinstance(equation, GivenEquation):
        return False
    components = equation.reading.components
    rates = [s for e in components for s in e.free_symbols if base(s) != s and prime(base(s)) != s]
    derived = {s for c in reference.candidates for e in c.system.equations for s in e.free_symbols}
    return t not in derived and bool(rates) and all(sp.diff(e, s).subs(t, 0) == 0 for e in components for s in rates)


def _is_kinetic_energy(equation: Fragment, reference: Reference) -> bool:
    """Whether an equation states the kinetic energy by a letter that the problem has for a force."""
    sides = equation.reading.sides if isinstance(equation, GivenEquation) else ()
    for name, energy in (sides, sides[::-1]) if len(sides) == 2 else ():
        if not isinstance(name, sp.Symbol) or name.name not in ("T", "K") or isinstance(energy, Vector):
            continue
        for c in reference.candidates_for({base(s).name for s in energy.free_symbols}):
            difference = c.read(energy) - c.read(kinetic_energy(c.configuration))
            try:
                result = compare([difference], c.system)
            except DivisionByZeroError:
                continue
            if result is not None and all(s is Standing.CONSTRAINT for s in result.standings):
                return True
    return False


def _with_unreadable(verdict: AnswerVerdict, equations: Sequence[Fragment], working: Working) -> AnswerVerdict:
    """The verdict with the lines that cannot be read, which decide only if they might hold what is missing.

    They stand where they were written.
    """
    unreadable = [f.reading for f in working.unreadable]
    if not unreadable:
        return verdict
    errors = tuple(d for r in unreadable if r.error for d in r.error.diagnostics)
    stays = verdict.verdict in (Verdict.EQUIVALENT, Verdict.WRONG, Verdict.UNDECIDED)
    places = {id(f.whole): n for n, f in enumerate(working.written)}
    judged = [*verdict.equations]
    kept = [places.get(id(f.whole), -1) for f in equations]
    if len(kept) != len(judged):
        kept = [-1] * len(judged)
    lines = [
        (
            places[id(f.whole)],
            EquationVerdict(f.reading.text, Verdict.UNREADABLE, f.reading.error.diagnostics[0].message),
        )
        for f in working.unreadable
        if f.reading.error
    ]
    ordered = sorted([*zip(kept, judged, strict=True), *lines], key=lambda pair: pair[0])
    return replace(
        verdict,
        verdict=verdict.verdict if stays else Verdict.UNREADABLE,
        equations=tuple(e for _, e in ordered),
        unreadable=(*verdict.unreadable, *errors),
    )
