"""What a problem may ask for: what is refused before anything is solved, and which choices of coordinates are meant."""

from __future__ import annotations

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError, suggestion
from lagrange.core.symbols import t
from lagrange.mechanics.constraints.variable_mass import variable_masses
from lagrange.problem.model import Belt, Choice, Find, Friction, Problem


def chosen_coordinates(problem: Problem, name: str | None) -> list[Choice]:
    """The choices of generalized coordinates: all, or the one with a name. Raises ProblemError if there is none."""
    if name is None:
        return list(problem.choices)
    chosen = [c for c in problem.choices if c.name == name]
    if not chosen:
        names = [c.name for c in problem.choices]
        help_ = suggestion(name, names, "choices")
        raise ProblemError(Diagnostic("no-such-choice", f"the problem has no choice `{name}`", help=help_))
    return chosen


def _refuse_of_variable_mass(problem: Problem) -> None:
    """Raise if a problem of variable mass asks for what is not available, or begins with the mass zero."""
    variable = [p for p in problem.particles if p.exchange is not None]
    if not variable:
        return
    [p, *_] = variable
    refused = {
        Find.EQUILIBRIUM: "equilibrium",
        Find.IMPENDING: "equilibrium",
        Find.HAMILTONIAN: "Hamilton's function",
        Find.STEADY: "steady motions",
        Find.RESPONSE: "forced oscillations",
        Find.IMPACT: "an impact",
    }
    if what := next((words for f, words in refused.items() if f in problem.find), ""):
        raise NotCoveredError(f"{what} of a system in which the mass of `{p.name}` varies", p.span)
    timed = next((p for p in variable if {t, *problem.slots.prescribed} & p.mass.free_symbols), None)
    if Find.LINEARIZATION in problem.find and timed is not None:
        raise NotCoveredError(f"small oscillations while the mass of `{timed.name}` varies with time", timed.span)
    turning = next((m for m in variable_masses(problem) if m.has_one_sense and not m.velocity.is_zero), None)
    if Find.LINEARIZATION in problem.find and turning is not None:
        what = f"small oscillations in which `{turning.name}` would lose mass and gain it in turn"
        raise NotCoveredError(what, next(p.span for p in variable if p.name == turning.name))
    start = {t: sp.S.Zero, **{i.symbol: i.value for i in problem.initial}}
    for p in variable:
        if p.mass.xreplace(start) == 0:
            message = f"the mass of `{p.name}` is 0 at t = 0, where the equations of motion do not determine the motion"
            help_ = (
                "begin with a small mass, such as that at `x: a` under `initial`, and let it tend to 0 in the result"
            )
            raise ProblemError(Diagnostic("starts-without-mass", message, p.span, help=help_))


def refuse_what_is_not_covered(problem: Problem) -> None:
    """Raise NotCoveredError or ProblemError if the problem asks for something unavailable for such a system."""
    _refuse_of_variable_mass(problem)
    for force in (f for f in problem.forces if isinstance(f, Friction)):
        if {Find.EQUILIBRIUM, Find.IMPENDING} & {*problem.find} and force.static is None:
            what = f"equilibrium with the friction `{force.name}`, which has no coefficient of friction at rest,"
            raise NotCoveredError(what, force.span, cure="give it: `static: mu_s`")
        if Find.LINEARIZATION in problem.find:
            raise NotCoveredError(f"small oscillations with dry friction, `{force.name}`,", force.span)
    belts = [f for f in problem.forces if isinstance(f, Belt)]
    if belts and {Find.MOTION, Find.LINEARIZATION} & {*problem.find}:
        raise NotCoveredError(f"a belt on a rough drum, `{belts[0].name}`, in motion", belts[0].span)
    if Find.IMPENDING in problem.find and not any(isinstance(f, Friction | Belt) for f in problem.forces):
        message = "impending motion is asked for, but no friction is given"
        help_ = "give friction with a static coefficient: `rub: {friction: mu, static: mu_s, constraint: floor, on: P}`"
        raise ProblemError(Diagnostic("impending-without-friction", message, help=help_))
    if problem.equations:
        cure = 'check answers against it, `lagsolve check FILE -e "..."`, or give what it is derived from'
        raise NotCoveredError("deriving anything from a reference system, `equations`,", cure=cure)
    if Find.LINEARIZATION in problem.find and problem.unknowns:
        raise NotCoveredError("small oscillations with unknown forces, which have no law,")
