"""Forces that only the working of conditions of rest has, under names of its own: they are eliminated.

    N = W                                                    H = W/2 tan(theta)
    2 N l sin(theta) - W l sin(theta) = 2 H l cos(theta)     W/2 tan(theta) <= mu W, which is compared
    H <= mu N,  tan(theta) <= 2 mu

The equations are solved for the forces, in which they are linear. A condition that still contains one, because too few
equations are stated, is working beside the others.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.limits import MOST_WORKING_FORCES
from lagrange.answers.references import Reference
from lagrange.answers.written.reading import is_name, read_as_written, undeclared
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.expressions.reader import limit_of


@record
class WithoutForces:
    """The conditions that can be compared.

    conditions  in names of the problem, and those of the forces that are known
    forces      what the equations say of the forces
    equations   those without forces
    notes       what is not judged
    """

    conditions: tuple[Fragment, ...]
    forces: Mapping[str, sp.Expr]
    equations: tuple[Fragment, ...]
    notes: tuple[Diagnostic, ...] = ()


def without_forces(
    conditions: Sequence[Fragment], equations: Sequence[Fragment], reference: Reference
) -> WithoutForces | None:
    """The answer without the forces of its working; None if it has none, or nothing else."""
    strange = {id(f): {*undeclared(read_as_written(_as_equation(f), reference.scope), f.text)} for f in conditions}
    strange |= {id(f): {*undeclared(read_as_written(f, reference.scope), f.text)} for f in equations}
    names = sorted(n for n in set().union(*strange.values()) if is_name(n))
    if not names or len(names) > MOST_WORKING_FORCES:
        return None
    symbols = {n: sp.Symbol(n, real=True) for n in names}
    scope = replace(reference.scope, scalars={**reference.scope.scalars, **symbols})
    balances = [f for f in equations if strange[id(f)]]
    readings = [read_as_written(f, scope) for f in balances]
    rows = [e for r in readings for e in r.components]
    forces: dict[str, sp.Expr] = {}
    if rows and not any(r.error for r in readings) and all(_is_linear(e, symbols.values()) for e in rows):
        forces = _solved(rows, symbols)
    kept = [f for f in conditions if strange[id(f)] <= forces.keys()]
    if not kept:
        return None
    left_out = [f for f in (*conditions, *equations) if strange[id(f)] and f not in kept]
    notes = (
        Diagnostic("not-judged", f"`{f.text.strip()}` is working, and is not judged", f.whole).as_note()
        for f in left_out
    )
    return WithoutForces(tuple(kept), forces, tuple(f for f in equations if not strange[id(f)]), tuple(notes))


def _as_equation(condition: Fragment) -> Fragment:
    try:
        return limit_of(condition, "a condition", strict=True)[0]
    except ProblemError:
        return condition


def _is_linear(e: sp.Expr, symbols: Collection[sp.Symbol]) -> bool:
    return not any(sp.diff(e, s).free_symbols & {*symbols} for s in symbols)


def _solved(rows: Sequence[sp.Expr], symbols: Mapping[str, sp.Symbol]) -> dict[str, sp.Expr]:
    """What linear equations say of the forces that they determine; empty if they contradict one another."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for row in rows:
        own = sp.expand(row.xreplace(found))
        force = next((s for s in symbols.values() if own.coeff(s) != 0), None)
        if force is None:
            continue  # a consequence of the others, or wrong: the conditions show it
        value = {force: sp.expand(-own.coeff(force, 0) / own.coeff(force))}
        found = {s: sp.expand(e.xreplace(value)) for s, e in found.items()} | value
    unknown = {*symbols.values()}
    return {n: found[s] for n, s in symbols.items() if s in found and not found[s].free_symbols & unknown}
