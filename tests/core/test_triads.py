"""The triads of textbooks are orthonormal, and turn as they should."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core import triads
from lagrange.core.vectors import Vector

r, theta, phi, z = sp.symbols("r theta phi z", real=True)


@pytest.mark.parametrize(
    "triad",
    [triads.polar(r, phi), triads.cylindrical(r, phi, z), triads.spherical(r, theta, phi)],
    ids=["polar", "cylindrical", "spherical"],
)
def test_unit_vectors_are_orthonormal_and_right_handed(triad: object) -> None:
    e = sp.Matrix([list(triads.unit_vector(triad, n).fixed().components) for n in range(3)])  # type: ignore[arg-type]
    assert sp.simplify(e * e.T - sp.eye(3)) == sp.zeros(3)
    assert sp.simplify(e.det()) == 1


def test_the_first_vector_points_from_the_origin() -> None:
    radial = triads.unit_vector(triads.spherical(r, theta, phi), 0)
    assert isinstance(radial, Vector)
    assert radial.fixed().components[2] == sp.cos(theta)


def test_names_of_axes() -> None:
    assert triads.axis_names("top")[0] != triads.names_before_last("top")[0]
