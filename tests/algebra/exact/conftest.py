"""`point`: a point in residues, and one in reals."""

from __future__ import annotations

import pytest

from lagrange.algebra.exact.zero_test import Point
from tests.support.points import field_point, real_point


@pytest.fixture(params=[field_point, real_point], ids=["field", "reals"])
def point(request: pytest.FixtureRequest) -> Point:
    return request.param()
