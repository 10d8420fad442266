"""Are the moments of inertia constant in the triad that the file gives for them?

A triad that turns with Ω while the body turns with ω is not fixed in the body unless ω = Ω. Moments about its axes stay
what they are only where the inertia does not notice: the body may turn relative to it about e_3 if A = B, so that

    (B − C) (ω − Ω)·e_1 = 0 ,    (C − A) (ω − Ω)·e_2 = 0 ,    (A − B) (ω − Ω)·e_3 = 0 .

These must hold in every possible state: where the constraints hold, for velocities that satisfy them.
"""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.exact.exact import Point
from lagrange.algebra.exact.sampling import agreed
from lagrange.core.diagnostics import Diagnostic, ProblemError, UndecidedError
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.constraints.rigid_bodies import relative_to_triad
from lagrange.mechanics.dynamics.comparison import state, symbols_of
from lagrange.problem.model import Body, Problem


def check_constant_inertia(problem: Problem, configuration: Configuration) -> None:
    """Refuses a triad in which the inertia of a body changes.

    Raises ProblemError with the reason, UndecidedError where that could not be settled.
    """
    rotations = {r.name: r for r in configuration.rotations}
    for body in problem.bodies:
        parts = relative_to_triad(rotations[body.name], configuration.slots)
        constant = _vanish(parts, configuration)
        if constant is None:
            question = f"whether the moments of inertia of the body `{body.name}` are constant in its axes"
            raise UndecidedError(question, body.span)
        if not constant:
            raise ProblemError(_refusal(body))


def _refusal(body: Body) -> Diagnostic:
    a, b, c = body.inertia
    message = (
        f"the body `{body.name}` turns relative to its axes, and its moments of inertia about them do not stay constant"
    )
    equal = a in (b, c) or b == c
    help_ = (
        "two moments are equal: it may turn relative to the axes about the third axis only; check `angular_velocity`"
        if equal
        else "give axes that are fixed in the body, so that `angular_velocity` is theirs, or two equal moments, "
        "written alike, where the body spins about the third axis"
    )
    return Diagnostic("varying-inertia", message, body.span, help=help_)


def _vanish(parts: tuple[sp.Expr, ...], configuration: Configuration) -> bool | None:
    if not parts:
        return True
    symbols = symbols_of(parts)

    def vanish(moving: Point) -> bool:
        return all(moving.is_zero(e) for e in parts)

    return agreed(configuration.surface, vanish, parts, there=lambda p: state(p, configuration, symbols))
