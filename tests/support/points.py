"""Points in residues and in reals, for tests that hold in both."""

from __future__ import annotations

from typing import Any

from lagrange.algebra.exact.zero_test import Fields, Point, Surface


def field_point() -> Point:
    return Surface(fields=Fields(2)).point()


def real_point() -> Point:
    return Surface(fields=Fields(2)).real_point()


def close(point: Point, a: Any, b: Any) -> bool:
    return point.arithmetic.vanishes(point.arithmetic.reduce(a - b))
