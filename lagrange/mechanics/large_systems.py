"""The stages for a system whose virtual displacements are too long to be solved for, such as a bicycle.

Nothing is eliminated in symbols then. The constraints are classified at random points; the equations of motion are
those with multipliers, in abbreviations; about a motion that `initial` gives they are linearized numerically.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from lagrange.core.diagnostics import NotCoveredError
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Find, Problem

_COVERED = (
    "`find: motion` gives the equations in JSON, `find: linearization` the linear ones about the motion of `initial`, "
    "`find: equilibrium` a position of rest in numbers, "
    "`lagsolve export` and `lagsolve simulate` the motion in numbers"
)
COVERED = {Find.CONSTRAINTS, Find.MOTION, Find.LINEARIZATION, Find.STEADY, Find.EQUILIBRIUM}


def stages_of_large(problem: Problem, on_stage: Callable[[str], None]) -> Iterator[Callable[[Solution], Solution]]:
    """The stages after the constraints, as the file asks for them. Raises NotCoveredError."""
    wanted = frozenset(problem.find)
    beside = (("ask", problem.questions), ("speeds", problem.speeds), ("generalized_coordinates", problem.choices))
    missing = [*(f"find: {f.value}" for f in sorted(wanted - COVERED)), *(key for key, given in beside if given)]
    if missing:
        what = ", ".join(f"`{m}`" for m in missing)
        raise NotCoveredError(
            f"{what} for a system whose displacements are too long to be solved for",
            cure=f"leave {'it' if len(missing) == 1 else 'them'} out: {_COVERED}",
        )
    if Find.MOTION in wanted:
        yield lambda s: _with_long_equations(s, on_stage)
    if {Find.LINEARIZATION, Find.STEADY} & wanted:
        yield lambda s: _with_linear_motion(s, on_stage)
    if Find.EQUILIBRIUM in wanted:
        yield lambda s: _with_rest(s, on_stage)


def _with_long_equations(solution: Solution, on_stage: Callable[[str], None]) -> Solution:
    """The solution with the equations of motion in abbreviations."""
    from lagrange.mechanics.nearby.long_equations import check_long_equations, long_equations
    from lagrange.mechanics.nearby.one_state import check_state, start_in_numbers

    on_stage("equations of motion")
    equations = long_equations(solution.problem, solution.own.configuration)
    checks = check_long_equations(equations, solution.own.configuration)
    start = start_in_numbers(solution.problem, solution.own.configuration)
    checks += [check_state(start, "accelerations")] if start is not None else []
    return replace(solution, long_equations=equations, at_start=start, checks=(*solution.checks, *checks))


def _with_linear_motion(solution: Solution, on_stage: Callable[[str], None]) -> Solution:
    """The solution with the linear equations about the motion that the file gives."""
    from lagrange.mechanics.nearby.checks import check_linear_motion
    from lagrange.mechanics.nearby.linear_motion import linear_motion

    on_stage("linear equations")
    problem, configuration = solution.problem, solution.own.configuration
    motion = linear_motion(problem, configuration)
    checks = check_linear_motion(problem, configuration, motion)
    return replace(solution, linear_motion=motion, checks=(*solution.checks, *checks))


def _with_rest(solution: Solution, on_stage: Callable[[str], None]) -> Solution:
    """The solution with the position of equilibrium near the one that the file gives."""
    from lagrange.mechanics.equilibrium.checks import require_statics
    from lagrange.mechanics.nearby.one_state import check_rest_in_numbers, rest_in_numbers

    on_stage("equilibrium")
    problem, configuration = solution.problem, solution.own.configuration
    require_statics(problem, configuration)
    rest = rest_in_numbers(problem, configuration)
    return replace(solution, rest_in_numbers=rest, checks=(*solution.checks, *check_rest_in_numbers(rest)))


def with_long_reactions(solution: Solution) -> Solution:
    """The solution with the reactions that were too long in every set of coordinates."""
    from lagrange.mechanics.nearby.long_equations import check_long_reactions, long_reactions

    own, law = solution.own, solution.law
    solved = [v.dynamics.reactions for v in solution.views if v.dynamics and v.dynamics.reactions]
    if law is None:
        return solution
    reactions = long_reactions(law, own.configuration, own.elimination.independent, solved, own.spot)
    if reactions is None:
        return solution
    return replace(solution, long_reactions=reactions, checks=(*solution.checks, *check_long_reactions(reactions)))
