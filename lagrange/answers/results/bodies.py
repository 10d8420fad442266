"""Wrong values and conditions that are right for bodies with other moments of inertia.

A quantity that is asked for, or the friction that rolling needs, contains the moment of inertia as a number: 2/5, 1/2.
So the problem is solved once more with a letter J for it, and the stated result is compared with the right one for
J = 0 (the rotation is ignored) and for the moments of inertia of other standard bodies.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import lru_cache

import sympy as sp

from lagrange.answers.limits import MOST_OTHER_BODIES, UNITS_OF_OTHER_BODIES
from lagrange.answers.models.kinetic import BODIES, RATIOS
from lagrange.answers.references import Identical
from lagrange.core.diagnostics import ProblemError
from lagrange.core.effort import allowed_for
from lagrange.document.math_writer import text
from lagrange.document.notation import Notation
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Assumption, Parameter, Problem

Substitution = Mapping[sp.Symbol, sp.Expr]


def other_bodies(solution: Solution) -> tuple[Solution, list[tuple[str, Substitution]]] | None:
    """The problem solved with letters for its moments of inertia, and what these are in changed problems, each with
    the end of a sentence; None if there are none with numbers in them, or it cannot be solved so."""
    solved = _with_letters(Identical(solution))
    return None if solved is None else (solved[0], list(_changes(solved[1])))


@lru_cache(maxsize=8)
def _with_letters(same: Identical) -> tuple[Solution, dict[str, tuple[sp.Symbol, sp.Expr]]] | None:
    problem: Problem = same.solution.problem
    letters = {}
    bodies = []
    for b in problem.bodies:
        if len(b.inertia) == 1 and b.inertia[0].free_symbols and not b.inertia[0].is_Symbol:
            letters[b.name] = sp.Symbol(f"J_of_{b.name}", positive=True), b.inertia[0]
            b = replace(b, inertia=(letters[b.name][0],))
        bodies.append(b)
    if not letters or len(letters) > MOST_OTHER_BODIES:
        return None
    more = tuple(Parameter(j, Assumption.POSITIVE) for j, _ in letters.values())
    changed = replace(problem, bodies=tuple(bodies), parameters=(*problem.parameters, *more), answers=None)
    try:
        with allowed_for("comparing answers", UNITS_OF_OTHER_BODIES):
            return solve(changed), letters
    except ProblemError:
        return None


def _changes(letters: Mapping[str, tuple[sp.Symbol, sp.Expr]]) -> Iterator[tuple[str, Substitution]]:
    own: dict[sp.Symbol, sp.Expr] = dict(letters.values())
    for name, (j, _) in letters.items():
        yield f"without the rotation of `{name}`", {**own, j: sp.S.Zero}
    for name, (j, moment) in letters.items():
        for ratio in RATIOS:
            value = ratio * moment
            body = BODIES.get(value.as_coeff_Mul()[0]) if len(moment.free_symbols) == 2 else None
            if body is not None:
                clause = f"with the moment of inertia {text(value, Notation())} for `{name}`, which {body} has"
                yield clause, {**own, j: value}
