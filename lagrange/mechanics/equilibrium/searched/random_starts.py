"""Numbers for parameters, and places from which a search begins."""

from __future__ import annotations

from collections.abc import Collection
from random import Random

import sympy as sp

from lagrange.core.symbols import Bounded, Sign
from lagrange.mechanics.equilibrium.limits import BOX


def random_value(s: sp.Symbol, spread: float, random: Random) -> float:
    """A number for a parameter, of the sign or in the range that is declared."""
    if isinstance(s, Sign):
        return random.choice((-1.0, 1.0))
    if isinstance(s, Bounded):
        return float(s.low) + (float(s.high) - float(s.low)) * random.uniform(0.1, 0.9)
    size = 2 ** random.uniform(-spread, spread)
    if s.is_nonnegative or s.is_nonpositive:
        return size if s.is_nonnegative else -size
    return random.choice((-size, size))


def random_start(
    u: sp.Symbol, coordinates: Collection[sp.Symbol], angles: Collection[sp.Expr], random: Random
) -> float:
    """Where the search for an unknown begins: an angle anywhere, a force at 0."""
    if u not in coordinates:
        return 0.0
    return random.uniform(-3.1, 3.1) if u in angles else random.uniform(-BOX, BOX)
