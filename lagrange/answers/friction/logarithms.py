"""Equilibria that a belt leaves unsolved: a = b exp(μ β) for the coefficient μ, which is ln(a/b)/β.

The conditions of equilibrium are solved as polynomials, in which an exponential function of an unknown has no place. Of
the law of a belt, whose tensions are known, it is the only such part, and its exponent is linear in one unknown. Books
state the value of that unknown, so the branch gets it here as a point, and is compared like any other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet
from lagrange.algebra.closed_forms.unit_circle import CIRCULAR


def with_logarithms(solution: SolutionSet) -> SolutionSet:
    """The solutions with the value of the unknown wherever one equation a exp(u) = b is left in a branch."""
    return replace(solution, branches=tuple(_solved(b, solution.unknowns) for b in solution.branches))


def _solved(branch: Branch, unknowns: Sequence[sp.Symbol]) -> Branch:
    if len(branch.left) != 1 or len(branch.points) != 1:
        return branch
    [equation], [point] = branch.left, branch.points
    open_ = sorted(equation.free_symbols & {*unknowns}, key=str)
    powers = [p for p in equation.atoms(sp.exp) if not p.free_symbols.isdisjoint(open_)]
    if len(open_) != 1 or len(powers) != 1 or any(open_[0] in e.free_symbols for e in point.values()):
        return branch
    [unknown], [power] = open_, powers
    rate = sp.diff(power.args[0], unknown)
    letter = sp.Dummy()
    slack = sp.expand(equation.xreplace({power: letter}))
    if rate == 0 or {unknown, letter} & {*rate.free_symbols, *sp.diff(slack, letter).free_symbols}:
        return branch
    size = sp.factor(-slack.xreplace({letter: sp.S.Zero}) / sp.diff(slack, letter))
    start = power.args[0].xreplace({unknown: sp.S.Zero})
    if size == 0 or unknown in size.free_symbols:
        return branch
    return replace(branch, left=(), points=({**point, unknown: in_sums((sp.log(size) - start) / rate)},))


def at(solution: SolutionSet, point: Mapping[sp.Expr, sp.Expr], e: sp.Expr) -> sp.Expr:
    """An expression at a point of a branch, exponents and given angles first. Raises NotAlgebraicError."""
    inside = {s for p in e.atoms(sp.exp) for s in p.free_symbols} & {*solution.unknowns} & point.keys()
    inside |= {s for f in e.atoms(*CIRCULAR) for s in f.free_symbols & point.keys()} - {*solution.unknowns}
    plain = {s: point[s] for s in inside if point[s].free_symbols.isdisjoint(point)}
    return solution.at(point, e.xreplace(plain) if plain else e)


def in_sums(e: sp.Expr) -> sp.Expr:
    """An expression with ln a − ln b for ln(a/b), a form that two results have in common."""
    return sp.expand_log(e) if e.has(sp.log) else e


def parted_logarithms(e: sp.Expr) -> sp.Expr:
    """log(a b/c) as log a + log b − log c: all logarithms of the same argument are one then.

    A factor of unknown sign, m_0 − q t, is taken with one of its signs; log(−1), where one is left over, counts as a
    number of its own.
    """
    of_minus = sp.Dummy("log(-1)")

    def parted(argument: sp.Expr) -> sp.Expr:
        factors = [f.as_base_exp() for f in sp.Mul.make_args(sp.factor(sp.together(argument)))]
        if any(b.is_zero or b.is_real is False or not (b.is_positive or n.is_Integer) for b, n in factors):
            return sp.log(argument)
        reversed_ = [(b, n) for b, n in factors if not b.is_positive and b.could_extract_minus_sign()]
        sizes = [(-b if (b, n) in reversed_ else b, n) for b, n in factors]
        is_odd = sp.Add(*(n for _, n in reversed_)) % 2
        return sp.Add(is_odd * of_minus, *(n * sp.log(b) for b, n in sizes))

    return sp.expand(e.replace(sp.log, parted), log=False)
