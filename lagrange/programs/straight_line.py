"""Straight-line programs: common subexpressions taken out, small linear systems eliminated in symbols.

Repeated parts of the outputs become assignments to names c0, c1, ...; nothing is expanded or simplified. A regular
system that needs no pivoting, M x = f with M symmetric and positive definite up to factors of its rows, is eliminated
by Gauss's method in the order of its unknowns,

    l = m_ik/m_kk ,   m_ij -> m_ij − l m_kj ,   f_i -> f_i − l f_k ,

as further assignments: its leading minors are those of M, and positive. The mass matrix is of this kind. Everything
else needs a solver with pivoting, which each language has or gets (`languages.py`).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, count

import sympy as sp

from lagrange.core.expression_size import count_distinct, distinct_parts
from lagrange.core.records import record
from lagrange.programs.limits import LARGEST_ELIMINATED, LONGEST_SEARCHED

Assignment = tuple[sp.Symbol, sp.Expr]


@record
class StraightLine:
    """Assignments in their order, and outputs in terms of inputs and assigned symbols."""

    assignments: tuple[Assignment, ...]
    outputs: tuple[sp.Expr, ...]


def temporaries() -> Iterator[sp.Symbol]:
    """New symbols; whatever their names are, they differ from all others."""
    return (sp.Dummy(f"c{n}", real=True) for n in count())


def straight_line(outputs: Sequence[sp.Expr], symbols: Iterator[sp.Symbol] | None = None) -> StraightLine:
    """The outputs without repeated parts."""
    names = temporaries() if symbols is None else symbols
    if count_distinct(outputs) > LONGEST_SEARCHED:
        return _shared(outputs, names)
    assignments, reduced = sp.cse(list(outputs), symbols=names, optimizations=None, order="none", list=True)
    return StraightLine(tuple(assignments), tuple(reduced))


def _shared(outputs: Sequence[sp.Expr], names: Iterator[sp.Symbol]) -> StraightLine:
    """The same for long expressions: parts that occur more than once as they stand, without a search in sums and
    products for others, which takes ten times as long and finds little in expressions that are built of common parts.
    """
    written: dict[sp.Basic, sp.Basic] = {}
    assignments: list[Assignment] = []
    uses = Counter(a for e in distinct_parts(outputs) for a in e.args if a.args)
    uses.update(e for e in outputs if e.args)
    waiting: list[tuple[sp.Basic, bool]] = [(e, False) for e in reversed(outputs)]
    while waiting:
        e, ready = waiting.pop()
        if e in written:
            continue
        if not e.args or e.is_number:
            written[e] = e
        elif not ready:
            waiting.append((e, True))
            waiting += [(a, False) for a in e.args if a not in written]
        else:
            args = [written[a] for a in e.args]
            made = type(e)._from_args(args, is_commutative=True) if isinstance(e, sp.Add | sp.Mul) else e.func(*args)
            written[e] = made
            if uses[e] > 1:
                written[e] = next(names)
                assignments.append((written[e], made))
    return StraightLine(tuple(assignments), tuple(written[e] for e in outputs))


def can_be_eliminated(size: int, constraints: int) -> bool:
    """Whether a system is eliminated in symbols: a small one without multipliers."""
    return constraints == 0 and size <= LARGEST_ELIMINATED


def solved_in_line(
    rates: Sequence[sp.Expr], matrix: Sequence[Sequence[sp.Expr]], right: Sequence[sp.Expr]
) -> StraightLine:
    """The rates, then x of matrix · x = right, without pivoting."""
    names = temporaries()
    flat = [*rates, *chain.from_iterable(matrix), *right]
    parts = straight_line(flat, names)
    n, size = len(rates), len(right)
    rows = [list(parts.outputs[n + k * size : n + (k + 1) * size]) for k in range(size)]
    b = list(parts.outputs[n + size * size :])
    more: list[Assignment] = []

    def named(e: sp.Expr) -> sp.Expr:
        if not e.args:
            return e
        symbol = next(names)
        more.append((symbol, e))
        return symbol

    for k in range(size):
        rows[k][k] = named(rows[k][k])
        for i in range(k + 1, size):
            if rows[i][k] == 0:
                continue
            share = named(rows[i][k] / rows[k][k])
            for j in range(k + 1, size):
                rows[i][j] = named(rows[i][j] - share * rows[k][j])
            b[k] = named(b[k])
            b[i] = b[i] - share * b[k]
    x: list[sp.Expr] = [sp.S.Zero] * size
    for k in reversed(range(size)):
        known = sp.Add(*(rows[k][j] * x[j] for j in range(k + 1, size)))
        x[k] = named((b[k] - known) / rows[k][k])
    return _without_unused(StraightLine((*parts.assignments, *more), (*parts.outputs[:n], *x)))


def _without_unused(program: StraightLine) -> StraightLine:
    """The program without assignments that no output needs: factors that have cancelled."""
    used = set().union(*(e.free_symbols for e in program.outputs))
    kept: list[Assignment] = []
    for symbol, value in reversed(program.assignments):
        if symbol in used:
            kept.append((symbol, value))
            used |= value.free_symbols
    return StraightLine(tuple(reversed(kept)), program.outputs)


def occurring_inputs(program: StraightLine) -> set[sp.Symbol]:
    """The inputs that occur."""
    assigned = {s for s, _ in program.assignments}
    used: Iterable[set[sp.Symbol]] = (e.free_symbols for e in (*(v for _, v in program.assignments), *program.outputs))
    return set().union(*used) - assigned
