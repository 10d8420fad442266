"""Sentences on stability without an equation for the position they are about.

    The upright position is stable for W l < c b^2 and unstable for W l > c b^2.      stable as long as Ω² < g/R

They are right if they are true at one of the equilibria, at random values of the parameters; the feedback says which. A
condition alone is meant to be decisive: where it fails, the equilibrium is unstable.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.answers.limits import CLEAR_STABILITY, SENTENCE_SAMPLES
from lagrange.answers.questions import stability_in_text as said
from lagrange.answers.references import Reference
from lagrange.answers.results.approximate import beside_limit
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.reading import read_as_written
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.records import record
from lagrange.document.math_writer import text
from lagrange.expressions.relations import is_inequality, limit_of
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.results import Solution

_ABOUT = "it is taken to be about {}"
_NOWHERE = "this is true at none of the equilibria"
_REVERSED = "the condition for stability has the wrong sense"


@record
class _Clause:
    """Stable, or unstable, where the condition is positive."""

    stable: bool
    condition: sp.Expr


@record
class _Place:
    """An equilibrium, and the matrix that is positive definite where it is stable."""

    resting: Equilibrium
    branch: Branch
    matrix: sp.Matrix


def is_about_stability(text_: str) -> bool:
    """Whether a text without equations says when something is stable."""
    return said.WORD.search(text_) is not None and is_inequality(Fragment.of(text_))


def check_stability_sentences(
    answer: Sequence[Fragment], solution: Solution, reference: Reference
) -> AnswerVerdict | None:
    """The verdict on such sentences; None if they are none, or cannot be understood."""
    places = [*_places(solution)]
    parts: list[EquationVerdict] = []
    for f in answer:
        clauses = _clauses(f.text, reference)
        if not clauses or not places:
            return None
        stated = " ".join(f.text.split())
        at = [p for p in places if _is_true(clauses, p)]
        if at:
            where = " or ".join(_where(p) for p in at)
            parts.append(EquationVerdict(stated, Verdict.EQUIVALENT, remarks=(_ABOUT.format(where),)))
            continue
        opposite = [_Clause(not c.stable, c.condition) for c in clauses]
        why = _REVERSED if any(_is_true(opposite, p) for p in places) else _NOWHERE
        parts.append(EquationVerdict.of(stated, Verdict.WRONG, why))
    wrong = any(p.verdict is Verdict.WRONG for p in parts)
    return AnswerVerdict(Verdict.WRONG if wrong else Verdict.EQUIVALENT, tuple(parts), name="stability")


def _where(place: _Place) -> str:
    return ", ".join(f"{text(r.lhs)} = {text(r.rhs)}" for r in place.branch.relations)


def _clauses(stated: str, reference: Reference) -> list[_Clause]:
    """The clauses of a sentence on stability; none if a part of it cannot be read."""
    matches = [*said.WORD.finditer(stated)]
    clauses = []
    for n, match in enumerate(matches):
        rest = stated[match.end() : matches[n + 1].start() if n + 1 < len(matches) else len(stated)]
        conditional = said.CONDITION.match(rest)
        if conditional is None:
            if n > 0 and not is_inequality(Fragment.of(rest)):  # `unstable otherwise`
                continue
            return []
        try:
            limit, side = limit_of(Fragment.of(said.ENDS.split(conditional["text"])[0].strip(" .")), "", strict=True)
        except ProblemError:
            return []
        reading = read_as_written(limit, reference.scope)
        if reading.error is not None or len(reading.components) != 1:
            return []
        stable = not (match["not"] or match["word"].lower() == "labil")
        clauses.append(_Clause(stable, reading.components[0] * (side or 1)))
    return clauses


def _places(solution: Solution) -> Iterator[_Place]:
    for view in solution.views:
        if view.equilibrium is not None and view.stability is not None:
            for branch in view.equilibrium.branches:
                yield _Place(view.equilibrium, branch, sp.Matrix(view.stability.matrix))
        elif view.linearization is not None:
            for branch, s in zip(view.linearization.branches, view.linearization.at, strict=True):
                if s is not None and all(e == 0 for row in s.system.damping for e in row):
                    yield _Place(view.linearization.equilibrium, branch, sp.Matrix(s.system.stiffness))


def _is_true(clauses: Sequence[_Clause], place: _Place) -> bool:
    """Whether the clauses are true at an equilibrium, which is stable in some cases and unstable in others."""
    coordinates = place.resting.configuration.slots.coordinates
    everything = [*place.resting.required, *place.matrix, *(c.condition for c in clauses)]
    everything += [r.lhs - r.rhs for r in place.branch.relations]
    parameters = sorted({s for e in everything for s in e.free_symbols} - {*coordinates}, key=str)
    angles = {s for e in everything for f in e.atoms(sp.sin, sp.cos, sp.tan) for s in f.args[0].free_symbols}
    draw, seen = random.Random(3), set()
    for _ in range(SENTENCE_SAMPLES):
        state: dict[sp.Symbol, sp.Expr] = {
            s: sp.Float(draw.uniform(0.05, 1.5) if s in angles else draw.lognormvariate(0, 0.8)) for s in parameters
        }
        beside = (moved for clause in clauses for moved in beside_limit(clause.condition, state))
        for stable, at in (s for moved in (state, *beside) for s in _states(place, coordinates, moved)):
            for clause in clauses:
                holds = clause.condition.xreplace(at).evalf()
                if not holds.is_number or abs(holds) < CLEAR_STABILITY or (holds < 0 and len(clauses) > 1):
                    continue
                if stable is not (clause.stable if holds > 0 else not clause.stable):
                    return False
                seen.add(stable)
    return len(seen) == 2


def _states(
    place: _Place, coordinates: Sequence[sp.Symbol], state: dict[sp.Symbol, sp.Expr]
) -> Iterator[tuple[bool, dict[sp.Symbol, sp.Expr]]]:
    """Whether the equilibrium is stable at values of the parameters, at each of its points that exist there."""
    for point in place.branch.points:
        letters = place.resting.solution.letters
        position = said.position_at({k: letters.write(v) for k, v in point.items()}, coordinates, state)
        if position is None:
            continue
        at = {**state, **position}
        numbers = place.matrix.xreplace(at).evalf()
        if any(not e.is_real for e in numbers):
            continue
        stable = said.is_stable(numbers)
        if stable is not None:
            yield stable, at
