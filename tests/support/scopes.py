"""Names that a text may use, without a problem that would have to be solved: those of a pendulum, and of a point in a plane."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import Slots
from lagrange.expressions.scope import Scope


def scope(coordinates: str, parameters: str) -> Scope:
    """The coordinates, which are real, and the parameters, which are positive."""
    moving = sp.symbols(coordinates, real=True, seq=True)
    constant = sp.symbols(parameters, positive=True, seq=True)
    return Scope(scalars={s.name: s for s in (*moving, *constant)}, slots=Slots(tuple(moving)))


PENDULUM = scope("theta", "m g l")
PLANE = scope("x y", "m g k a b c")
