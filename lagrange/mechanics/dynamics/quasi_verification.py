"""The quasi-velocities of one set of coordinates, and the checks of what is found by them.

    kinematic equations         q' = B u + b, put into the definitions of the u_s and into the constraints
    equations of motion         with the definitions put in, against Lagrange's equations with multipliers

The second route shares nothing with the first but the positions: no quasi-velocity occurs in it.
"""

from __future__ import annotations

from collections.abc import Sequence

from lagrange.core.records import record
from lagrange.core.symbols import prime
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import compare
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.quasi_equations import QuasiEquations, quasi_equations
from lagrange.mechanics.dynamics.quasi_velocities import QuasiVelocities, quasi_velocities
from lagrange.mechanics.dynamics.verification import Check, at_random_states, certainty, multiplier_system
from lagrange.problem.model import Problem, Speed


@record
class InSpeeds:
    """The velocities by the quasi-velocities, and the equations of motion in these where motion is asked."""

    velocities: QuasiVelocities
    equations: QuasiEquations | None
    configuration: Configuration


def in_speeds(speeds: Sequence[Speed], configuration: Configuration, motion: EquationsOfMotion | None) -> InSpeeds:
    """What the quasi-velocities of a file come to in a configuration. Raises what `quasi_velocities` raises."""
    quasi = quasi_velocities(speeds, configuration)
    if motion is None:
        return InSpeeds(quasi, None, configuration)
    return InSpeeds(quasi, quasi_equations(quasi, motion.configuration), motion.configuration)


def check_speeds(found: InSpeeds, problem: Problem) -> list[Check]:
    """The checks of both."""
    quasi = found.velocities
    name = quasi.configuration.name
    how = f"{certainty(quasi.configuration.surface)}: put into the definitions and the constraints"
    checks = [Check("the kinematic equations give the velocities", _give_velocities(quasi), how, name)]
    if found.equations is not None:
        configuration = found.configuration
        reactions = {c.name: c.reaction for c in problem.constraints}
        multipliers = tuple(reactions[row.name] for row in configuration.rows)
        system = multiplier_system(configuration, lagrange_equations(configuration).left, multipliers)
        result = compare([quasi.defined(e) for e in found.equations.expressions], system)
        passed = None if result is None else result.agree
        how = at_random_states(configuration)
        checks.append(Check("Lagrange's equations give the same motion in the quasi-velocities", passed, how, name))
    return checks


def _give_velocities(quasi: QuasiVelocities) -> bool | None:
    """u(q, B u + b) = u, and A (B u + b) + a_t = 0."""
    configuration = quasi.configuration
    rule = quasi.rates
    left = [e.xreplace(rule) - prime(u) for u, e in quasi.definitions.items()]
    left += [r.velocity_form(configuration.slots).xreplace(rule) for r in configuration.rows]
    verdicts = [configuration.surface.is_zero(e) for e in left]
    return False if False in verdicts else None if None in verdicts else True
