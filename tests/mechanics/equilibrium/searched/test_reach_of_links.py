"""How far rods reach, and their angles."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.equilibrium.searched.reach_of_links import angles_of_links, reach_of_links

x, y, u, v = sp.symbols("x y u v", real=True)
UPPER = x**2 + y**2 - sp.Rational(1, 4)
LOWER = (u - x) ** 2 + (v - y) ** 2 - 1


def test_points_on_a_chain_of_rods_reach_as_far_as_the_rods() -> None:
    half, both = sp.Rational(1, 2), sp.Rational(3, 2)
    assert reach_of_links([LOWER, UPPER], [x, y, u, v]) == {x: half, y: half, u: both, v: both}
    swapped = reach_of_links([-LOWER, -3 * UPPER], [x, y, u, v])  # l² = x² + y²
    assert swapped == {x: half, y: half, u: both, v: both}
    assert reach_of_links([x**2 - y**2 - 1, x * y - 1], [x, y]) == {}


def test_the_constraints_hold_for_all_angles_of_the_rods() -> None:
    places = angles_of_links([LOWER, UPPER], [x, y, u, v])
    assert places is not None
    assert [sp.simplify(e.xreplace(places)) for e in (UPPER, LOWER)] == [0, 0]
    assert angles_of_links([UPPER, x + u - 1], [x, y, u, v]) is None
    assert angles_of_links([x**2 + 2 * y**2 - 1], [x, y]) is None
