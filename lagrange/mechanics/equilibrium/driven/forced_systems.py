"""The system without its drive, and with the drive as a prescribed motion."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.records import record
from lagrange.core.symbols import prime
from lagrange.mechanics.equilibrium.driven.drives import (
    Drive,
    drive_of,
    driven,
    harmonics,
    time_beside_harmonics,
    undriven,
    without_prescribed,
)
from lagrange.problem.model import Problem


@record
class ForcedSystems:
    """A driven system.

    still  without the drive
    moved  with the drive as prescribed motions
    small  the slots of these, and what they are as functions of time
    drive  None where they have no law
    """

    still: Problem
    moved: Problem
    small: Mapping[sp.Symbol, sp.Expr]
    drive: Drive | None


def forced_systems(problem: Problem, steady: bool) -> ForcedSystems:
    """The systems of a driven problem; `steady`: the steady state is asked for, which needs one harmonic drive.

    Raises NotCoveredError where there is none, or where it is of another kind.
    """
    frequencies = harmonics(problem)
    if sp.nan in frequencies or time_beside_harmonics(problem):
        raise NotCoveredError("forced oscillations under a drive that is not harmonic, F*cos(w*t),")
    if len(frequencies) > 1:
        raise NotCoveredError(
            "forced oscillations under drives of several frequencies: one file for each, as they add up,"
        )
    if problem.slots.prescribed:
        if steady or frequencies:
            names = ", ".join(f"`{u}(t)`" for u in problem.slots.prescribed)
            raise NotCoveredError(f"the response to {names}, which has no law: write a*cos(w*t) instead, otherwise it")
        small = {prime(u, k) if k else u: prime(u, k) if k else u for u in problem.slots.prescribed for k in range(4)}
        return ForcedSystems(without_prescribed(problem), problem, small, None)
    if not frequencies:
        raise NotCoveredError(
            "the response of a system that nothing drives: give a force or a support cos(w*t), otherwise it"
        )
    [frequency] = frequencies
    drive = drive_of(problem, frequency, frozenset(problem.scope.names()))
    return ForcedSystems(undriven(problem, drive), driven(problem, drive), drive.slots, drive)
