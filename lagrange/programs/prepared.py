"""From a problem to its first-order equations in numbers: what `simulate` and `export` begin with.

How long a simulation lasts by default: long enough to see what happens, and no longer.

An oscillation is shown for about five periods, thirty times its time of change √(length/acceleration). In a throw
nothing comes back: the accelerations are constant, and after a few of these times the stone is far below the picture.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from importlib.util import find_spec

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, GaveUpError, ProblemError
from lagrange.core.records import record
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import OnStage, silent, solve
from lagrange.problem.keys import Find
from lagrange.problem.model import Problem
from lagrange.programs.defaults import GRAVITY, UNDECLARED_GRAVITY, drawn_position, oscillation, samples
from lagrange.programs.limits import DEFAULT_TIME, PUSH
from lagrange.programs.numerical_system import NumericalSystem
from lagrange.programs.starting import Settings, Start, start
from lagrange.programs.state_equations import StateEquations, state_equations

EXTRA = 'pip install "lagsolve[sim]"'


def require(*libraries: str) -> None:
    """Raises ProblemError if a library of the extra `sim` is missing."""
    missing = [name for name in libraries if find_spec(name) is None]
    if missing:
        message = (
            f"a simulation needs {' and '.join(missing)}, which {'is' if len(missing) == 1 else 'are'} not installed"
        )
        raise ProblemError(Diagnostic("missing-extra", message, help=f"install the extra `sim`: {EXTRA}"))


@record
class Prepared:
    """A problem, its equations of motion alone, and where the motion starts.

    problem  as the file has it, with the values and the initial state of the command line
    sampled  what is taken for functions and prescribed motions that are not given, by name
    """

    problem: Problem
    solution: Solution
    states: StateEquations
    start: Start
    sampled: Mapping[str, sp.Expr] = field(default_factory=dict)


def prepared(
    problem: Problem,
    choice: str | None = None,
    settings: Settings | None = None,
    on_stage: OnStage = silent,
    *,
    complete: bool = False,
) -> Prepared:
    """The equations of a problem in a choice of coordinates, or in those in which they are best integrated.

    complete  whether functions and motions that are not given are taken from samples, so that everything has numbers

    Raises ProblemError if there are none, or the initial values contradict each other.
    """
    require_masses(problem)
    if problem.impact is not None:
        problem = after_impact(problem, choice, on_stage)
    motion = replace(problem, find=(Find.MOTION,), questions=(), initial=(), answers=None)
    solution = solve(motion, choice or None, complete=False, on_stage=on_stage)
    return prepared_solution(problem, solution, choice, settings, complete=complete)


def after_impact(problem: Problem, choice: str | None, on_stage: OnStage) -> Problem:
    """The motion after the impact of a file: it begins with the velocities that the impact leaves, in the position of
    the impact. Coordinates that `before` leaves open are those of `initial`.
    """
    from lagrange.mechanics.through_impact import problem_begun

    blow = replace(problem, find=(Find.IMPACT,), questions=(), initial=(), answers=None)
    motion = solve(blow, choice or None, complete=False, on_stage=on_stage).impact
    assert motion is not None
    return problem_begun(problem, motion)


def require_masses(problem: Problem) -> None:
    """Raises ProblemError if nothing could move."""
    if not problem.masses and not problem.equations and problem.lagrangian is None:
        message = "nothing moves here: the problem has no masses"
        raise ProblemError(Diagnostic("no-equations", message, help="give particles or bodies with masses"))


def prepared_solution(
    problem: Problem,
    solution: Solution,
    choice: str | None = None,
    settings: Settings | None = None,
    *,
    complete: bool = False,
) -> Prepared:
    """A simulation of a problem that has been solved already.

    Raises ProblemError if it has no equations of motion, or the initial values contradict each other.
    """
    settings = settings or Settings()
    if solution.given_up:
        raise GaveUpError(solution.given_up)
    states = state_equations(solution, choice).with_functions(settings.functions)
    taken = _samples(states, solution) if complete else {}
    states = states.with_functions(taken)
    problem = with_initial(problem, settings)
    states = replace(states, problem=replace(states.problem, questions=problem.questions, initial=problem.initial))
    return Prepared(problem, solution, states, start(states, solution), taken)


def with_initial(problem: Problem, settings: Settings) -> Problem:
    """The problem with the initial values of the command line."""
    initial = {v.symbol: v for v in (*problem.initial, *settings.initial)}
    return replace(problem, initial=tuple(initial.values()))


def _samples(states: StateEquations, solution: Solution) -> dict[str, sp.Expr]:
    """What is taken for the functions and prescribed motions that the equations still contain."""
    missing = states.functions
    if not missing:
        return {}
    drawn = drawn_position(solution, states.view, states.configuration)
    gravity = {UNDECLARED_GRAVITY: sp.Float(GRAVITY)}
    moving = {u.name: oscillation(u, drawn) for u in states.equations.slots.prescribed}
    known = {**samples(solution), **moving}
    return {name: known[name].xreplace(gravity) for name in missing if name in known}


def require_functions(
    states: StateEquations, given: Mapping[str, sp.Expr], cure: str = "`--set '{name}={example}'`"
) -> None:
    """Raises ProblemError if a function that occurs has not been given; `cure` says how to give it."""
    missing = [name for name in states.functions if name not in given]
    if not missing:
        return
    arguments = {f.name: f.arguments for f in states.problem.functions}
    name = missing[0]
    places = arguments.get(name, ("t",))
    shown = f"{name}({', '.join(places)})"
    message = f"the motion depends on {shown}, of which nothing is known"
    example = f"{places[0]}^2/4"
    if places == ("t",):
        example = "1 + 0.1*sin(3*t)"  # a length must not become zero
    elif len(places) == 3 and not any(p == "t" or p.endswith("'") for p in places):
        example = f"{places[2]} - ({places[0]}^2 + {places[1]}^2)/4"  # a bowl, if it is a surface
    help_ = f"give it as an expression in {', '.join(places)}: {cure.format(name=name, example=example)}"
    raise ProblemError(Diagnostic("function-not-given", message, help=help_))


# Durations


def longest_time(states: StateEquations, start: Start) -> float:
    """The default duration of a simulation: about thirty times its time of change, rounded; 10 s if unknown.

    In its time of change an acceleration like that of the start makes the length or, from the origin, the speed of the
    start; without an acceleration the speed makes the length. If the accelerations are constant, as in a throw, nothing
    comes back, and a few of these times show it all.
    """
    e = states.equations
    n = len(e.slots.coordinates)
    system = NumericalSystem(states, start.values)
    try:
        rate = system.rate(0.0, *start.state)
    except (ArithmeticError, ValueError):
        return DEFAULT_TIME
    place, speed, acceleration = math.hypot(*start.state[:n]), math.hypot(*rate[:n]), math.hypot(*rate[n:])
    place = PUSH if start.pushed and speed < PUSH else place
    if acceleration > 1e-9 * (place + speed):
        change = math.sqrt(place / acceleration) if place > 1e-9 else speed / acceleration
    else:
        pairs = zip(start.state[:n], rate[:n], strict=True)
        change = min((abs(q or place) / abs(v) for q, v in pairs if v != 0), default=0.0)
    if not 1e-6 < change < 1e9:
        return DEFAULT_TIME
    wanted = _times_of_change(system, start, rate, change) * change
    power = 10.0 ** math.floor(math.log10(wanted))
    return next(k * power for k in (1, 2, 5, 10) if k * power >= wanted * 0.7)


def _times_of_change(system: NumericalSystem, start: Start, rate: Sequence[float], change: float) -> float:
    """How many times of change are shown: 30; 4 if the accelerations stay what they are, 10 if something is asked."""
    n = len(system.states.equations.slots.coordinates)
    largest = max(map(abs, rate[n:]), default=0.0)
    if len(rate) != 2 * n:  # quasi-velocities
        return 30
    for time in (change, -change, 3 * change):
        moved = [y + time * v for y, v in zip(start.state, rate, strict=True)]
        moved[:n] = (q + time**2 / 2 * a for q, a in zip(moved[:n], rate[n:], strict=True))
        try:
            there = system.rate(abs(time), *moved)
        except (ArithmeticError, ValueError):
            return 30
        if largest == 0 or any(abs(a - b) > 1e-9 * largest for a, b in zip(rate[n:], there[n:], strict=True)):
            return 30
    return 10 if system.states.problem.questions else 4
