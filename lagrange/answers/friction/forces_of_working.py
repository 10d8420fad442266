"""Forces that only the working of conditions of rest has, under names of its own: they are eliminated.

    N = W                                                    H = W/2 tan(theta)
    2 N l sin(theta) - W l sin(theta) = 2 H l cos(theta)     W/2 tan(theta) <= mu W, which is compared
    H <= mu N,  tan(theta) <= 2 mu

The equations are solved for the forces, in which they are linear. A condition that still contains one, because too few
equations are stated, is working beside the others.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.limits import MOST_WORKING_FORCES
from lagrange.answers.references import Reference
from lagrange.answers.written.reading import is_name, read_as_written, undeclared
from lagrange.answers.written.values import WHEN
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.reader import is_inequality, limit_of


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
    conditions: Sequence[Fragment],
    equations: Sequence[Fragment],
    reference: Reference,
    reactions: Mapping[str, sp.Symbol] | None = None,
) -> WithoutForces | None:
    """The answer without the forces of its working; None if it has none, or nothing else.

    reactions  those of the problem that are eliminated, too, under their names
    """
    declared = reactions or {}

    def forces_in(f: Fragment, equation: Fragment) -> set[str]:
        reading = read_as_written(equation, reference.scope)
        used = {s for e in reading.components for s in e.free_symbols}
        return {*undeclared(reading, f.text)} | {n for n, s in declared.items() if s in used}

    strange = {id(f): forces_in(f, _as_equation(f)) for f in conditions} | {id(f): forces_in(f, f) for f in equations}
    names = sorted(n for n in set().union(*strange.values()) if is_name(n))
    if not names or len(names) > MOST_WORKING_FORCES:
        return None
    symbols = {n: declared.get(n, sp.Symbol(n, real=True)) for n in names}
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


_SIGN = r"(?:<=|>=|[<>≤≥]|\\(?:leq?|geq?|lt|gt|leqslant|geqslant)(?![A-Za-z]))"
_CHAIN = re.compile(
    rf"\A(?P<first>[^=<>≤≥]+?)\s*&?=\s*(?P<value>(?:(?!{_SIGN})[^=])+?)\s*(?P<rest>{_SIGN}.*)\Z", re.DOTALL
)


def in_two(condition: Fragment) -> list[Fragment]:
    """`F = P <= mu W` as F = P and P <= mu W; any other condition as it is."""
    match = _CHAIN.match(condition.text)
    if match is None or re.search(_SIGN, match["first"]):
        return [condition]
    equation, limit = Draft(condition), Draft(condition)
    equation.keep(0, match.end("value"))
    limit.keep(match.start("value"), len(condition.text))
    latex = is_latex(condition)
    return [equation.finished(latex=latex), limit.finished(latex=latex)]


_IN_CASE = re.compile(
    rf"\A(?P<condition>.*?{_SIGN}.*?)(?P<case>[\s,$(]*(?<![^\W\d_]){WHEN}\s+\$?[^=$]*?{_SIGN}[^$]*\$?\s*\)?"
    rf"|\s\(\s*[^=$()]*{_SIGN}[^$()]*\))[\s.]*\Z",
    re.DOTALL | re.IGNORECASE,
)


def without_case(answer: Sequence[Fragment], positions: Collection[str]) -> tuple[list[Fragment], str]:
    """`tan(theta) <= 2 mu/(1 - mu nu) for mu nu < 1` without the only case of an answer, and this; empty for several.

    positions  the names of coordinates, which do not occur in a case
    """
    stated = [(n, f) for n, f in enumerate(answer) if is_inequality(f)]
    if len(stated) != 1:
        return [*answer], ""
    [(n, condition)] = stated
    match = _IN_CASE.match(condition.text)
    if match is None or {*re.findall(r"[^\W\d]\w*", match["case"])} & {*positions}:
        return [*answer], ""
    draft = Draft(condition)
    kept = match["condition"].rstrip(" ,(")
    draft.keep(0, len(kept))
    if kept.count("$") % 2:
        draft.apply([(len(kept), len(kept), "$")])
    alone = draft.finished(latex=is_latex(condition))
    return [*answer[:n], alone, *answer[n + 1 :]], match["case"].strip(" ,.$()")


def in_both_senses(equation: Fragment) -> Iterator[Fragment]:
    """`P h = W b` as P h <= W b, and as P h >= W b."""
    sign = re.search(r"(?<![<>!=:])=(?![=>])", equation.text)
    for relation in (" <= ", " >= ") if sign else ():
        draft = Draft(equation)
        draft.apply([(*sign.span(), relation)])  # type: ignore[union-attr]
        yield draft.finished(latex=is_latex(equation))


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
