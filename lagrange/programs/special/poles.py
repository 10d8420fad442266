"""Poles of coordinates, over which no integration goes.

The depth y = l cos θ of a pendulum is a good coordinate until the bottom. There its mass m l²/(l² − y²) is infinite,
and the equation of motion has y = l as a second solution, on which a computed motion stays for ever, with a wrong
energy. What is conserved shows that something has gone wrong, and the determinant of the linear equations for
accelerations, far larger or smaller there than elsewhere on the way, that it was a pole.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from lagrange.programs.limits import POLE
from lagrange.programs.numerical_system import NumericalSystem

REASON = (
    "it comes to a pole of these coordinates, where their mass matrix is singular or infinite; "
    "`--choice` names other coordinates"
)


def pole(system: NumericalSystem, times: Any, states: Any, errors: Any, largest: float) -> int | None:
    """The last of the times before errors become too large, if that is at a pole; None otherwise.

    times, states, errors  arrays of shape (N,), (n, N), (N,)
    """
    import numpy

    wrong = numpy.flatnonzero(~(errors <= largest))
    if not len(wrong) or wrong[0] == 0:
        return None
    first = int(wrong[0])
    before, near = range(first), range(max(first - 2, 0), min(first + 3, len(times)))
    usual = float(numpy.median([_size(system, times[k], states[:, k]) for k in before[:: max(1, len(before) // 50)]]))
    here = [_size(system, times[k], states[:, k]) for k in near]
    far = any(not math.isfinite(x) or abs(x - usual) > math.log(POLE) for x in here)
    return first - 1 if far and math.isfinite(usual) else None


def _size(system: NumericalSystem, time: float, state: Sequence[float]) -> float:
    """The logarithm of the determinant of the equations for accelerations and multipliers."""
    import numpy

    size = len(system.states.equations.unknowns)
    try:
        numbers = system.matrix(float(time), *map(float, state))
        return float(numpy.linalg.slogdet(numpy.array(numbers).reshape(size, size))[1])
    except (ArithmeticError, ValueError):
        return math.inf
