"""Wrong answers by the hundred: every term's sign, factor, omission and function, in the equations of a shipped problem.

Each mutation knows what was done to which term, so that a diagnosis can be compared with the truth.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from lagrange.answers.references import ReferenceCandidate, reference_of_solution
from lagrange.answers.slips import Slip, terms_of
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.results import Solution

MOST_TERMS = 14


@dataclass(frozen=True)
class Mutation:
    """An equation, zero, in which one term has been changed, and how."""

    slip: Slip
    term: sp.Expr
    equation: sp.Expr


def best_system(solution: Solution) -> tuple[EquationsOfMotion, ReferenceCandidate] | None:
    """The equations of motion of a problem in its first choice of coordinates, or its own; None if they are not derived."""
    candidates = {c.choice: c for c in reversed(reference_of_solution(solution).candidates)}
    found = [(c.motion, candidates[c.name]) for c in solution.choices if c.motion is not None]
    own = [(solution.own.motion, candidates[""])] if solution.own.motion is not None else []
    return next(iter([*found, *own]), None)


def mutations(equations: EquationsOfMotion) -> Iterator[Mutation]:
    """All mutations of equations of motion; of longer ones none."""
    for equation in equations.expressions:
        terms = terms_of(equation) or ()
        if not 2 <= len(terms) <= MOST_TERMS:
            continue
        for n, term in enumerate(terms):
            rest = sp.Add(*terms[:n], *terms[n + 1 :])
            yield Mutation(Slip.SIGN, term, rest - term)
            yield Mutation(Slip.FACTOR, term, rest + 2 * term)
            yield Mutation(Slip.FACTOR, term, rest + term / 2)
            yield Mutation(Slip.MISSING, term, rest)
            for wave in sorted(term.atoms(sp.sin, sp.cos), key=str)[:1]:
                other = sp.cos if isinstance(wave, sp.sin) else sp.sin
                yield Mutation(Slip.FUNCTION, term, rest + term.xreplace({wave: other(wave.args[0])}))
