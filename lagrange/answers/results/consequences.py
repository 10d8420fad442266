"""Wrong accelerations at the start that follow from a wrong force beside them: one mistake, and not several.

Who takes the tension in a string as m g/2 and goes on rightly has m y'' = T − m g and the equation for the rotation
with that T. So the E_k with the stated number for its multiplier are asked for each stated acceleration, without the
constraints themselves, which with this force cannot be satisfied.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, InadmissibleError, NoPointError, UnsupportedError
from lagrange.answers.models.search import Models
from lagrange.answers.references import Reference, ReferenceCandidate
from lagrange.answers.results.taken_forces import follows_with_forces
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.core.symbols import t
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.mechanics.questions.results import Asked


def with_consequences(
    verdict: AnswerVerdict, stated: Mapping[int, tuple[Asked, sp.Expr]], reference: Reference
) -> AnswerVerdict:
    """The verdict, in which wrong accelerations that follow from a wrong force beside them are said to.

    stated  for parts of the verdict, by their numbers: the question and the value
    """
    wrong = [n for n, e in enumerate(verdict.equations) if e.verdict is Verdict.WRONG and n in stated]
    for n, found, factors in _found({n: stated[n] for n in wrong}, reference):
        force, value = stated[n][0].question.quantity, stated[n][1]
        parts, given = [*verdict.equations], f"with {force} = {text(value, Notation())}, which is wrong,"
        for k in found:
            parts[k] = replace(parts[k], diagnosis=f"{given} it follows from the equations of motion")
        for k, factor in factors.items():  # one mistake more: what explains a value by itself explains none of them
            parts[k] = replace(parts[k], diagnosis=f"{given} the equations of motion give {factor} times this value")
        if factors:
            parts[n] = replace(parts[n], diagnosis="")
            return replace(verdict, equations=tuple(parts))
        own = f"what is stated beside it follows from it; {parts[n].diagnosis}" if parts[n].diagnosis else ""
        parts[n] = replace(parts[n], diagnosis=own.rstrip("; ") or "what is stated beside it follows from it")
        return replace(verdict, equations=tuple(parts))
    return verdict


_FACTORS = tuple(sp.Rational(p, q) for p, q in ((1, 2), (2, 1), (-1, 1), (1, 3), (3, 1), (1, 4), (4, 1)))


def _found(
    stated: Mapping[int, tuple[Asked, sp.Expr]], reference: Reference
) -> Iterator[tuple[int, Sequence[int], Mapping[int, sp.Rational]]]:
    """Each wrong force that is not zero, with the wrong accelerations that follow from it, and those that do so but
    for a factor."""
    for c in reference.candidates:
        if c.choice or not c.multipliers:
            continue
        slots = c.configuration.slots
        moving = {k: pair for k, pair in stated.items() if pair[0].question.quantity in slots.accelerations}
        for n, (asked, value) in stated.items():
            if n in moving or value == 0 or not moving:
                continue
            initial = {s.symbol: s.value for s in asked.initial}
            at_start = bool(asked.question.when) and all(w.lhs - w.rhs in (t, -t) for w in asked.question.when)
            if not at_start or not {*slots.coordinates, *slots.velocities} <= initial.keys():
                continue
            try:
                found = [k for k, (q, a) in moving.items() if _follows(q.question.quantity - a, asked, value, c)]
                factors = {
                    k: f
                    for k, (q, a) in moving.items()
                    for f in (_FACTORS if found and k not in found else ())
                    if _follows(q.question.quantity - f * a, asked, value, c)
                }
            except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError, ValueError):
                continue
            if found:
                yield n, found, factors


def _follows(equation: sp.Expr, asked: Asked, value: sp.Expr, c: ReferenceCandidate) -> bool:
    """Whether an equation follows at the start from the equations of motion with a value of the one force asked for."""
    slots = c.configuration.slots
    stated = c.read(asked.question.quantity - value)
    forces = [s for s in c.multipliers if s in stated.free_symbols]
    if len(forces) != 1:
        return False
    [force] = forces
    slope = stated.diff(force)
    if slope == 0 or force in slope.free_symbols:
        return False
    initial = {s.symbol: s.value for s in asked.initial}
    start = {s: initial[s] for s in (*slots.coordinates, *slots.velocities)}
    number = (-stated.xreplace({force: sp.S.Zero}) / slope).xreplace(start)
    models = Models(c.system, {**c.values, **start}, c.parts)
    return all(follows_with_forces(c.read(equation), {force: number}, at) for at in models.states([equation]))
