"""A first motion for bodies that attract each other: a nearly circular orbit.

Released from rest, what is attracted by a point falls into it, where the force is infinite. If nothing is known of the
velocities and the potential energy has a term such as −K/r, −K/r² or log r that attracts, the particles of that term
begin in a rotation about their mass centre, or about the fixed point that attracts:

    v = ω k × (r − r_C) ,      ω = 0.9 ω_c ,      d²D/dt² = 0 at ω_c ,

D being the distance (or its square) in that term. With ω_c the orbit would be a circle; with a tenth less the particles
come a little nearer before they go out again.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import partial, t
from lagrange.mechanics.dynamics.energies import potential_energy
from lagrange.programs.compiled import compiled
from lagrange.programs.limits import NEARLY_CIRCULAR, ORBIT_STEP, ROUNDED_SPEED
from lagrange.programs.numerical_system import FloatValues, NumericalSystem
from lagrange.programs.state_equations import StateEquations

_AXES = ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0))


def orbit(states: StateEquations, values: FloatValues, state: Sequence[float]) -> list[float] | None:
    """The state with the velocities of a nearly circular orbit; None if nothing attracts or nothing can turn."""
    e = states.equations
    if e.kept or e.speeds != e.slots.velocities or not e.speeds:
        return None
    try:
        return _Orbits(states, values, tuple(state)).turned()
    except (ArithmeticError, ValueError, TypeError):
        return None


@record
class _Distance:
    """What vanishes where two points meet; `power` is that of the distance: 1, or 2 for its square."""

    value: sp.Expr
    power: int


class _Orbits:
    def __init__(self, states: StateEquations, values: FloatValues, state: tuple[float, ...]) -> None:
        import numpy

        self.states, self.values, self.state = states, values, state
        self.coordinates = states.equations.slots.coordinates
        self.system = NumericalSystem(states, values)
        points = states.configuration.points
        positions = [states.in_state(sp.sympify(c, strict=True)) for p in points for c in p.position.components]
        slopes = [c.diff(q) for c in positions for q in self.coordinates]
        count, n = len(positions) // 3, len(self.coordinates)
        self.places = numpy.array(self._numbers(positions)).reshape(count, 3)
        self.slopes = numpy.array(self._numbers(slopes)).reshape(count, 3, n)
        self.masses = numpy.array(self._numbers([p.mass for p in points]))

    def _numbers(self, expressions: Sequence[sp.Expr]) -> list[float]:
        state = self.states.state
        return [float(x) for x in compiled(state, [*expressions], self.values)(0.0, *self.state)]

    def turned(self) -> list[float] | None:
        """The state in which everything that is attracted turns."""
        import numpy

        n = len(self.coordinates)
        speeds, turning = numpy.array(self.state[n:]), False
        for distance in self._distances():
            slope = numpy.array(self._numbers([partial(distance.value, q) for q in self.coordinates]))
            pattern = self._pattern(distance, slope)
            if pattern is None:
                continue
            rate = self._rate(distance.value, pattern)
            if rate is None:
                continue
            moved = numpy.abs(self.slopes[self._concerned(slope)]).max(axis=(0, 1)) > 0
            speeds, turning = numpy.where(moved, NEARLY_CIRCULAR * rate * pattern, speeds), True
        speeds[numpy.abs(speeds) < ROUNDED_SPEED * numpy.abs(speeds).max()] = 0.0
        return [*self.state[:n], *speeds.tolist()] if turning else None

    def _distances(self) -> Iterator[_Distance]:
        """The distances in whose negative powers, or logarithms, the potential energy is written."""
        potential = self.states.in_state(sp.sympify(potential_energy(self.states.configuration), strict=True))
        moving = {*self.coordinates}
        powers = sorted(potential.atoms(sp.Pow), key=sp.default_sort_key)
        negative = [(a.base, a.exp.q) for a in powers if a.exp.is_Rational and a.exp.is_negative]
        logarithms = [(a.args[0], 1) for a in sorted(potential.atoms(sp.log), key=sp.default_sort_key)]
        known = []
        for base, root in (*negative, *logarithms):
            if base.free_symbols & moving and t not in base.free_symbols and base not in known:
                known.append(base)
                yield _Distance(base, 2 if root == 2 else 1)

    def _pattern(self, distance: _Distance, slope: Any) -> Any:
        """The velocities of a rotation with angular velocity 1 that keeps a distance; None if there is none."""
        import numpy

        centre = self._mass_centre(slope)
        concerned = self._concerned(slope)
        if centre is None:
            [here] = numpy.flatnonzero(concerned) if concerned.sum() == 1 else [-1]
            if here < 0:
                return None
            pull = numpy.linalg.lstsq(self.slopes[here].T, slope, rcond=None)[0]
            [value] = self._numbers([distance.value])
            is_distance = distance.power == 1 and abs(float(pull @ pull) - 1) < 1e-6
            centre = self.places[here] - (1 if is_distance else 2) * value * pull / float(pull @ pull)
        for axis in _AXES:
            wanted = numpy.where(concerned[:, None], numpy.cross(axis, self.places - centre), 0.0)
            velocities = self._velocities(wanted)
            if velocities is not None and numpy.abs(wanted).max() > 1e-6 and abs(float(slope @ velocities)) < 1e-9:
                return velocities
        return None

    def _concerned(self, slope: Any) -> Any:
        """Which of the points the distance depends on, shape (number of points,)."""
        return (abs(self.slopes) * (abs(slope) > 0)).max(axis=(1, 2)) > 0

    def _mass_centre(self, slope: Any) -> Any:
        """The mass centre, if all can move together without a change of the distance; otherwise None."""
        import numpy

        free = False
        for axis in _AXES:
            velocities = self._velocities(numpy.tile(axis, (len(self.places), 1)))
            if velocities is not None:
                if abs(float(slope @ velocities)) > 1e-9:
                    return None
                free = True
        return self.masses @ self.places / self.masses.sum() if free and len(self.places) > 1 else None

    def _velocities(self, wanted: Any) -> Any:
        """The q' for which the points have these velocities; None if there are none."""
        import numpy

        matrix = self.slopes.reshape(-1, self.slopes.shape[2])
        velocities = numpy.linalg.lstsq(matrix, wanted.ravel(), rcond=None)[0]
        return (
            velocities
            if numpy.abs(matrix @ velocities - wanted.ravel()).max() < 1e-9 * (1 + numpy.abs(wanted).max())
            else None
        )

    def _rate(self, value: sp.Expr, pattern: Any) -> float | None:
        """The ω with which the distance would not change: a + b ω + c ω² = 0, a < 0 where there is attraction."""
        slopes = [partial(value, q) for q in self.coordinates]
        change = self.system.function(
            sp.Add(*(g * v for g, v in zip(slopes, self.states.equations.speeds, strict=True)))
        )
        n = len(self.coordinates)

        def grows(rate: float) -> float:
            y = (*self.state[:n], *(rate * pattern).tolist())
            flow = self.system.rate(0.0, *y)
            ahead, behind = (tuple(a + s * ORBIT_STEP * d for a, d in zip(y, flow, strict=True)) for s in (1, -1))
            return (change(ORBIT_STEP, *ahead) - change(-ORBIT_STEP, *behind)) / (2 * ORBIT_STEP)

        a, one, other = grows(0.0), grows(1.0), grows(-1.0)
        b, c = (one - other) / 2, (one + other) / 2 - a
        if not (a < -1e-9 and c > 1e-12):
            return None
        return (-b + math.sqrt(b * b - 4 * a * c)) / (2 * c)
