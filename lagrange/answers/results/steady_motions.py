"""Wrong conditions of steady motion: which changed problem has them?

In a steady motion the cyclic velocities are constant and the other coordinates at rest, so that the equations of motion
of these are conditions E_o(q_o, q_c') = 0 without accelerations. A stated condition is solved for a letter that occurs
linearly in it, mostly g. At random states at which that letter has this value, the E_o of a changed problem vanish if
the condition is the changed one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.answers.limits import MAX_MODEL_WORK
from lagrange.answers.models.search import Models, changed_rows
from lagrange.answers.models.states import ModelState
from lagrange.answers.references import ReferenceCandidate
from lagrange.core.symbols import base, prime, t

if TYPE_CHECKING:
    from lagrange.mechanics.momenta.steady_motions import SteadyMotions


def explained_steady_motion(stated: sp.Expr, steady: SteadyMotions, candidate: ReferenceCandidate) -> str:
    """The changed problem whose steady motions a condition describes, in a sentence; empty if none is found."""
    slots = candidate.configuration.slots
    if candidate.configuration.rows or candidate.multipliers:
        return ""
    others = [n for n, q in enumerate(slots.coordinates) if q not in steady.cyclic]
    still = {prime(slots.coordinates[n]): sp.S.Zero for n in others}
    try:
        condition = sp.numer(sp.together(candidate.read(stated).xreplace(still)))
        known = {s for e in candidate.system.equations for s in e.free_symbols}
        moving = {*slots.coordinates, *slots.velocities, *slots.accelerations, t}
        for letter, value in _solved(condition, known - moving):
            at_rest = Models(candidate.system, {**candidate.values, **still}, candidate.parts)
            models = Models(candidate.system, {**candidate.values, **still, letter: value}, candidate.parts)
            if models.mechanics is not None:
                return next(_changed(condition, models, at_rest, others), "")
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError, ValueError):
        pass
    return ""


def _solved(condition: sp.Expr, letters: set[sp.Symbol]) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """A letter that occurs linearly in a condition, with its value there."""
    for letter in sorted(letters & condition.free_symbols, key=lambda s: (s.name != "g", s.name)):
        slope = condition.diff(letter)
        if base(letter) == letter and slope != 0 and letter not in slope.free_symbols:
            yield letter, -condition.xreplace({letter: sp.S.Zero}) / slope


def _changed(condition: sp.Expr, models: Models, at_rest: Models, others: Sequence[int]) -> Iterator[str]:
    states, free = models.states(()), at_rest.states(())
    if all(_vanish(at.derived, others, at) for at in states):
        return
    work = MAX_MODEL_WORK
    for _, variation in models.variations:
        work -= len(models.system.equations)
        if work < 0:
            return
        if variation.rule or variation.is_reduced or not condition.free_symbols.isdisjoint(variation.values):
            continue
        at_states = [changed_rows(variation, at) for at in states]
        if not all(rows is not None and _vanish(rows, others, at) for rows, at in zip(at_states, states, strict=True)):
            continue
        anywhere = [changed_rows(variation, at) for at in free]
        if all(rows is not None and not _vanish(rows, others, at) for rows, at in zip(anywhere, free, strict=True)):
            yield f"these are the steady motions {variation.clause}"


def _vanish(rows: Sequence[Sequence[object]], others: Sequence[int], at: ModelState) -> bool:
    """Whether the equations of some coordinates hold without accelerations."""
    return all(at.point.arithmetic.vanishes(rows[n][-1]) for n in others)
