"""The force of a path, against the law of motion along a curve: m v²/ρ and the weight along the normal."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.mechanics.path_reaction import path_reaction
from tests.support.shared import solved


def test_a_cycloid_presses_with_the_curvature_and_the_weight() -> None:
    """x = a (φ + sin φ), y = −a (1 + cos φ) with the lowest point at φ = 0; n is the upward normal."""
    reaction = path_reaction(solved("cycloidal-pendulum"))
    assert reaction is not None
    assert reaction.normal == "n"
    symbols = {s.name: s for s in reaction.value.free_symbols}
    a, m, g, phi, rate = (symbols[n] for n in ("a", "m", "g", "phi", "phi'"))
    x, y = a * (phi + sp.sin(phi)), -a * (1 + sp.cos(phi))
    dx, dy = x.diff(phi), y.diff(phi)
    size = sp.sqrt(dx**2 + dy**2)
    curvature = (dx * dy.diff(phi) - dy * dx.diff(phi)) / size**3
    expected = m * (size * rate) ** 2 * curvature + m * g * dx / size
    at = {a: sp.Rational(7, 5), m: 3, g: sp.Rational(49, 5), phi: sp.Rational(2, 3), rate: sp.Rational(5, 4)}
    assert abs((reaction.value - expected).xreplace(at).evalf(30)) < 1e-25


@pytest.mark.parametrize("name", ["ex11-ideal-pendulum", "rolling-disc", "roberval-balance"])
def test_where_multipliers_give_the_reaction_or_several_bodies_move_there_is_none(name: str) -> None:
    assert path_reaction(solved(name)) is None
