"""Contradictions in an answer about equilibrium: two equations of a system that hold together in special cases only.

    P = W/2 tan φ,  P = W/2 cot φ        -W l sin θ + c b² sin θ cos θ = 0,  cos θ = c b²/(W l)

The system has solutions, all of them equilibria, if φ or the parameters are such that both hold. But one equation says
by itself what is asked for, and the other is true at none of the equilibria: it is wrong, and not a special case.

An equation with a factor in which there are only parameters, (c b² − W l) sin θ = 0, also holds at every position if
that factor vanishes. If not all of these are equilibria, it is no condition of equilibrium, although its solutions for
other parameters are equilibria.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.limits import LONGEST_FACTORED
from lagrange.answers.readings import Reading
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Reason, Verdict, Why
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium

_RIGHT = (Verdict.EQUIVALENT, Verdict.INCOMPLETE)

Judge = Callable[[Sequence[Sequence[Reading]]], AnswerVerdict | None]
"""The verdict on alternative systems; None if they cannot be compared."""


def with_contradictions(verdict: AnswerVerdict, readings: Sequence[Sequence[Reading]], judge: Judge) -> AnswerVerdict:
    """The verdict on alternative systems, in which equations that contradict the rest of their system are wrong."""
    flat = [(a, n) for a in readings for n in range(len(a))]
    if verdict.verdict is not Verdict.INCOMPLETE or len(flat) != len(verdict.equations):
        return verdict
    equations = [
        EquationVerdict.because(e.text, Why(Reason.NOWHERE)) if _contradicts(a, n, judge) else e
        for e, (a, n) in zip(verdict.equations, flat, strict=True)
    ]
    if all(e.verdict is not Verdict.WRONG for e in equations):
        return verdict
    return replace(verdict, verdict=Verdict.WRONG, equations=tuple(equations), missing=0)


def _contradicts(system: Sequence[Reading], n: int, judge: Judge) -> bool:
    """Whether an equation is true at no equilibrium, although the others of its system describe equilibria."""
    own, others = (_symbols(part) for part in (system[n : n + 1], [*system[:n], *system[n + 1 :]]))
    if own.isdisjoint(others):  # y = 0 beside x = 0, where any y will do: it is one of many positions
        return False
    alone, rest = judge([[system[n]]]), judge([[*system[:n], *system[n + 1 :]]])
    if alone is None or rest is None or rest.verdict not in _RIGHT:
        return False
    return alone.verdict is Verdict.WRONG and all(e.is_for(Reason.NOWHERE) for e in alone.equations)


def _symbols(readings: Sequence[Reading]) -> set[sp.Basic]:
    return {s for r in readings for e in r.components for s in e.free_symbols}


def with_factors_of_parameters(
    verdict: AnswerVerdict, readings: Sequence[Sequence[Reading]], equilibria: Sequence[Equilibrium]
) -> AnswerVerdict:
    """The verdict on alternatives of one equation each, in which those with a factor of parameters alone that is none
    of the conditions of equilibrium are wrong."""
    if verdict.verdict is not Verdict.INCOMPLETE or any(len(a) > 1 for a in readings):
        return verdict
    if len(readings) != len(verdict.equations):
        return verdict
    equations = tuple(
        EquationVerdict.because(v.text, Why(Reason.HOLDS_ELSEWHERE)) if _holds_elsewhere(r, equilibria) else v
        for v, [r] in zip(verdict.equations, readings, strict=True)
    )
    if equations == verdict.equations:
        return verdict
    return replace(verdict, verdict=Verdict.WRONG, equations=equations, missing=0)


def _holds_elsewhere(reading: Reading, equilibria: Sequence[Equilibrium]) -> bool:
    """Whether an equation holds at every position for parameters for which not every position is an equilibrium."""
    if len(reading.components) != 1 or sp.count_ops(reading.components[0]) > LONGEST_FACTORED:
        return False
    equation = reading.components[0]
    for e in equilibria:
        coordinates = {*e.configuration.slots.coordinates}
        used = {s for c in e.required for s in c.free_symbols} - {*e.forces}
        if e.given or e.configuration.rows or e.forces or not equation.free_symbols & coordinates <= used:
            continue
        factored = sp.factor(sp.numer(sp.together(equation)))
        own = [f for f in sp.Mul.make_args(factored) if f.is_Add and f.free_symbols <= used - coordinates]
        for letter, value in (solved for f in own for solved in _solved(f)):
            try:
                if any(is_zero(c.xreplace({letter: value})) is False for c in e.required):
                    return True
            except (DivisionByZeroError, NoPointError, UnsupportedError):
                continue
    return False


def _solved(factor: sp.Expr) -> list[tuple[sp.Symbol, sp.Expr]]:
    """A sum that vanishes for positive letters, solved for one that it is linear in; empty if there is none."""
    for s in sorted(factor.free_symbols, key=str):
        slope = factor.diff(s)
        if slope != 0 and s not in slope.free_symbols:
            value = -factor.xreplace({s: sp.S.Zero}) / slope
            return [] if value.is_negative else [(s, value)]
    return []
