"""All consequences of the equations of motion in one set of coordinates."""

from __future__ import annotations

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import free_letter
from lagrange.mechanics.consequences.directions import Hodograph, hodograph, kept_directions
from lagrange.mechanics.consequences.limit_motion import LimitMotion, limit_motion
from lagrange.mechanics.consequences.limits import LONGEST_RATE
from lagrange.mechanics.consequences.modes import Beats, DoubleResonance, beats, double_resonance
from lagrange.mechanics.consequences.sleeping import SleepingAxis, sleeping_axis
from lagrange.mechanics.consequences.vectors import ConeVector, ConstantSpin, cone_vector, constant_spins
from lagrange.mechanics.results import InCoordinates, Solution


@record
class Consequences:
    """Constant vectors and directions, hodograph, motion in the limit, beats, resonance, what stays upright."""

    spins: tuple[ConstantSpin, ...]
    cone: ConeVector | None
    directions: tuple[tuple[sp.Symbol, sp.Symbol], ...]
    hodograph: Hodograph | None
    limits: tuple[LimitMotion, ...]
    beats: Beats | None
    resonance: DoubleResonance | None
    sleeping: SleepingAxis | None


def consequences(solution: Solution, view: InCoordinates) -> Consequences:
    """The consequences; most systems have none."""
    taken = solution.problem.scope.names()
    parameters = tuple(p.symbol for p in solution.problem.parameters)
    v, psi, u = (free_letter(*names, taken=taken) for names in (("v", "w"), ("psi", "chi"), ("u", "U")))
    return Consequences(
        tuple(constant_spins(view)),
        cone_vector(view),
        tuple(kept_directions(view)),
        hodograph(view, (v, psi, u)),
        tuple(limit_motion(view, LONGEST_RATE)),
        beats(view.linearization, parameters),
        double_resonance(view),
        sleeping_axis(solution, view, free_letter("n", "s", "nu", taken=taken)),
    )
