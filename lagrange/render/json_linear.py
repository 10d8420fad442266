"""The matrices of the equations of motion and the linear equations, for JSON."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.motion import Motion
    from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations

Write = Callable[[Any], str]


def matrices(dynamics: Motion, write: Write) -> dict[str, Any]:
    """M, f and where constraints bind the coordinates A, b; the accelerations, all of them or none."""
    form = dynamics.matrices
    found: dict[str, Any] = {
        "mass_matrix": matrix(form.mass, write),
        "force_vector": [write(e) for e in form.force],
    }
    if form.constraint_matrix:
        found["constraint_matrix"] = matrix(form.constraint_matrix, write)
        found["constraint_vector"] = [write(e) for e in form.constraint_vector]
    solved = dynamics.accelerations
    if len(solved) == len(form.mass):
        found["accelerations"] = {s.name.rstrip("'"): write(v) for s, v in solved.items()}
    return found


def matrix(rows: Sequence[Sequence[Any]], write: Write) -> list[list[str]]:
    """A matrix as a list of its rows."""
    return [[write(e) for e in row] for row in rows]


def linearized(found: Linearization, write: Write) -> list[dict[str, Any]]:
    """One entry for each equilibrium; where there are no linear equations, the equilibrium alone."""
    coordinates = found.configuration.slots.coordinates
    entries = []
    for b, s in zip(found.branches, found.at, strict=True):
        entry: dict[str, Any] = {
            "equilibrium": [f"{write(r.lhs)} = {write(r.rhs)}" for r in b.equations],
            "conditions": [f"{write(c.lhs)} {c.relation} {write(c.rhs)}" for c in b.conditions],
        }
        entries.append(entry | (_oscillations(s, found, coordinates, write) if s is not None else {"stable": None}))
    return entries


def _oscillations(
    s: SmallOscillations, found: Linearization, coordinates: Sequence[sp.Symbol], write: Write
) -> dict[str, Any]:
    """`displacements` are all small changes, in terms of the independent ones, which the matrices are for."""
    moved = [found.displacements[k] for k in s.free]
    shape = [sp.Add(*(c * x for c, x in zip(row, moved, strict=True))) for row in s.shape]
    stability = s.judgement.stability
    result: dict[str, Any] = {
        "displacements": {q.name: write(e) for q, e in zip(coordinates, shape, strict=True)},
        "mass_matrix": matrix(s.system.mass, write),
        "damping_matrix": matrix(s.system.damping, write),
        "stiffness_matrix": matrix(s.system.stiffness, write),
        "equations": [f"{write(e)} = 0" for e in s.equations],
        "characteristic": None if s.characteristic is None else f"{write(s.characteristic)} = 0",
    }
    if s.oscillates:
        result["frequencies"] = [
            {"squared": None if f.square is None else write(f.square), "equation": f"{write(s.remaining(f))} = 0"}
            | {"multiplicity": f.multiplicity, "modes": [[write(a) for a in mode] for mode in f.modes]}
            for f in s.frequencies
        ]
    decided = {"stable": True, "unstable": False}
    result |= {"stable": decided.get(stability.verdict.value), "stability": stability.verdict.value}
    if stability.conditions:
        result["stable_where"] = [f"{write(c.lhs)} {c.relation} {write(c.rhs)}" for c in stability.conditions]
    return result
