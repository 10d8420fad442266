"""How long a simulation lasts by default: long enough to see what happens, and no longer.

An oscillation is shown for about five periods, thirty times its time of change √(length/acceleration). In a throw
nothing comes back: the accelerations are constant, and after a few of these times the stone is far below the picture.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from lagrange.programs.limits import DEFAULT_TIME, PUSH
from lagrange.programs.numerical_system import NumericalSystem
from lagrange.programs.starting import Start
from lagrange.programs.state_equations import StateEquations


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
