"""Wrong conditions of rest and limits of friction where several contacts have one coefficient: which contact is it?

With one letter μ for two contacts a condition does not tell what the friction of each contributes. So the problem is
solved once more, each contact with a coefficient of its own; then the friction of one contact alone may act the other
way, or be omitted: μ_1 → −μ or 0, and μ_k → μ for all others.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.limits import MOST_OTHER_CONTACTS, UNITS_OF_OTHER_CONTACTS
from lagrange.answers.results.conditions import StatedCondition, is_limit
from lagrange.core.diagnostics import ProblemError
from lagrange.core.effort import allowed_for
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Force, Friction, Problem


def explained_by_contacts(stated: Sequence[StatedCondition], solution: Solution) -> str:
    """Which friction is reversed or omitted in wrong conditions or limits, in a sentence; empty if that is not found.

    All stated ones have to be those of the same changed problem.
    """
    separate = _with_own_coefficients(solution.problem)
    if separate is None or not stated:
        return ""
    problem, common = separate
    try:
        with allowed_for("comparing answers", UNITS_OF_OTHER_CONTACTS):
            solved = solve(problem)
    except ProblemError:
        return ""
    limits = list(_limits(solved, rest=not stated[0].equation))
    for friction, own, mu in common:
        others = {o: m for _, o, m in common if o != own}
        for value, clause in ((-mu, "acts the other way"), (sp.S.Zero, "")):
            rule = {**others, own: value}
            changed = [e.xreplace(rule) for e in limits]
            if all(any(is_limit(c, s.slack) for c in changed) for s in stated):
                how = (
                    f"for the friction `{friction}` acting the other way"
                    if clause
                    else f"without the friction `{friction}`"
                )
                return f"{'these are the limits' if len(stated) > 1 else 'this is the limit'} {how}"
    return ""


Common = list[tuple[str, sp.Symbol, sp.Symbol]]
"""The name of each friction, its own coefficient, and the one that it shares."""


def _with_own_coefficients(problem: Problem) -> tuple[Problem, Common] | None:
    """The problem with a coefficient for each contact; None if none is shared."""
    rough = [f for f in problem.forces if isinstance(f, Friction) and f.static is not None]
    shared = {f.static for f in rough if isinstance(f.static, sp.Symbol)}
    if len(shared) == len(rough) or len(rough) > MOST_OTHER_CONTACTS or any(f.static not in shared for f in rough):
        return None
    known = {p.symbol: p for p in problem.parameters}
    if not shared <= known.keys() or any(known[mu].value is not None for mu in shared):
        return None
    common: Common = []
    parameters = list(problem.parameters)
    forces: list[Force] = []
    for f in problem.forces:
        if isinstance(f, Friction) and isinstance(f.static, sp.Symbol):
            own = sp.Symbol(f"{f.static.name}_of_{f.name}", positive=True)
            common.append((f.name, own, f.static))
            parameters.append(replace(known[f.static], symbol=own))
            forces.append(replace(f, static=own))
        else:
            forces.append(f)
    return replace(problem, parameters=tuple(parameters), forces=tuple(forces), answers=None), common


def _limits(solution: Solution, *, rest: bool) -> Iterator[sp.Expr]:
    """The slacks of the conditions of rest, or what vanishes where friction is at its limit."""
    for v in solution.views:
        if rest and v.at_rest is not None and len(v.at_rest.cases) == 1:
            yield from (c.right - c.left for c in v.at_rest.cases[0])
        if not rest:
            yield from (r.lhs - r.rhs for m in v.impending or () for b in m.equilibrium.branches for r in b.relations)
