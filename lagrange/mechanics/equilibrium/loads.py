"""The loads among the parameters: a condition such as 2 k > l P is that on the critical load, P < 2 k/l."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import CIRCULAR
from lagrange.mechanics.constraints.kinematics import Configuration

WEIGHT = "weight"


def loads(configuration: Configuration, unknown_forces: Sequence[sp.Symbol] = ()) -> tuple[sp.Symbol, ...]:
    """The parameters that are the size of an applied force or moment; weights and forces that vary are none.

    In a vector with an unknown force this is the size, and no parameter.
    """
    coordinates = {*configuration.slots.coordinates, *configuration.slots.velocities}
    vectors = [load.vector for load in configuration.loads if load.name != WEIGHT]
    vectors += [torque.vector for torque in configuration.torques]
    found: dict[sp.Symbol, None] = {}
    for vector in vectors:
        components = [c for c in vector.components if c != 0]
        outside = [c.xreplace({f: sp.Dummy() for f in c.atoms(*CIRCULAR)}) for c in components]
        if any(c.free_symbols & (coordinates | {*unknown_forces}) for c in outside):
            continue
        for s in sorted({s for c in components for s in c.free_symbols}, key=str):
            rates = [sp.expand(c).diff(s) for c in components]
            if (
                s.is_positive
                and all(s not in r.free_symbols for r in rates)
                and all(sp.expand(c - s * r) == 0 for c, r in zip(components, rates, strict=True))
            ):
                found[s] = None
    return tuple(found)
