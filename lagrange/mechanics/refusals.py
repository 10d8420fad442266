"""Questions that cannot be answered, or not yet: refused before any work is done."""

from __future__ import annotations

from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError
from lagrange.problem.model import Find, Friction, Problem


def refuse_what_is_not_covered(problem: Problem) -> None:
    """Raises NotCoveredError or ProblemError for a question that has no answer yet, or none at all."""
    for force in (f for f in problem.forces if isinstance(f, Friction)):
        if {Find.EQUILIBRIUM, Find.IMPENDING} & {*problem.find} and force.static is None:
            what = f"equilibrium with dry friction, `{force.name}`, which at rest is any force up to a limit,"
            raise NotCoveredError(what, force.span)
        if Find.LINEARIZATION in problem.find:
            raise NotCoveredError(f"small oscillations with dry friction, `{force.name}`,", force.span)
    if Find.IMPENDING in problem.find and not any(isinstance(f, Friction) for f in problem.forces):
        message = "impending motion is asked for, and no friction is given"
        help_ = "give friction with a static coefficient: `rub: {friction: mu, static: mu_s, constraint: floor, on: P}`"
        raise ProblemError(Diagnostic("impending-without-friction", message, help=help_))
    if problem.equations:
        raise NotCoveredError("a reference system given by `equations`: it can only be checked against; solving it")
    if Find.LINEARIZATION in problem.find and problem.unknowns:
        raise NotCoveredError("small oscillations with unknown forces, which have no law,")
