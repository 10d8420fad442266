"""Speeds at which a motion is stable."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.mechanics.nearby.linear_motion import stable_ranges
from tests.mechanics.nearby.test_linear_motion import bicycle


def test_the_speeds_at_which_the_bicycle_is_stable() -> None:
    """Weave and capsize speed of the same paper, and between them, as at 5 m/s, all exponents on the left."""
    *_, block = bicycle()[2].blocks
    assert block.stable_ranges is not None
    [found] = block.stable_ranges
    assert float(found.low) == pytest.approx(4.29238253634111, rel=1e-12)
    assert float(found.high) == pytest.approx(6.02426201538837, rel=1e-12)
    assert found.oscillating == (found.low,)


@pytest.mark.parametrize(
    ("damping", "stiffness", "expected"),
    [
        ("v", "1", [(0, float("inf"))]),
        ("-v", "1", []),
        ("1", "v - 2", [(2, float("inf"))]),
        ("3 - v", "v - 1", [(1, 3)]),
        ("1", "(v - 1)*(v - 2)*(v - 4)", [(1, 2), (4, float("inf"))]),
        ("0", "v", None),
    ],
)
def test_ranges_of_one_equation(damping: str, stiffness: str, expected: list[tuple[float, float]] | None) -> None:
    """q'' + d q' + k q = 0 decays if and only if d > 0 and k > 0."""
    found = stable_ranges(((sp.S.One,),), ((sp.sympify(damping),),), ((sp.sympify(stiffness),),))
    assert (None if found is None else [(float(r.low), float(r.high)) for r in found]) == expected
