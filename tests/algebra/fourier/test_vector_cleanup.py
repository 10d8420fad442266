"""Products of sines and cosines combined, and those left unchanged."""

from __future__ import annotations

import time

import pytest
import sympy as sp
from sympy import cos, sin

from lagrange.algebra.fourier.vector_cleanup import in_differences, tidied, with_cotangents

a, b, x, y = sp.symbols("a b x y", real=True)
v, w = sp.symbols("x' y'", real=True)
R = sp.Symbol("R", positive=True)


@pytest.mark.parametrize(
    ("written", "tidy"),
    [
        (R * sin(a) ** 2 * sin(b) + R * cos(a) ** 2 * sin(b), R * sin(b)),
        (cos(a) * (w + R * v * cos(a)) - sin(a) * (x - R * v * sin(a)), w * cos(a) - x * sin(a) + R * v),
        (sin(a) * sin(a + b) + cos(a) * cos(a + b), cos(b)),
        (sin(a) * cos(b) * v + cos(a) * sin(b) * v, sin(a) * cos(b) * v + cos(a) * sin(b) * v),
    ],
)
def test_put_together(written: sp.Expr, tidy: sp.Expr) -> None:
    assert tidied(written) == tidy


@pytest.mark.parametrize(
    "written",
    [
        sin(a) * (x + R * y) - cos(a) * (y - R * x),
        (3 * x * y + y**2) * v,
        x * (x + y) - y * (x - y),
        sin(a) ** 2 * v + R * w,
        sin(a) * sin(b) * v + cos(a) * cos(b) * w,
        2 * sin(a) ** 2 * cos(a) ** 2 * v,
    ],
)
def test_left_as_written(written: sp.Expr) -> None:
    assert tidied(written) == written


def nested(depth: int) -> sp.Expr:
    """An expression of 2^depth leaves, of which each level is written once."""
    e = sin(a) + cos(a)
    for _ in range(depth):
        e = sp.Add(sp.Mul(e, e + x, evaluate=False), y, evaluate=False)
    return e


@pytest.mark.parametrize(
    "written",
    [
        (x + y + a + b + sin(x)) ** 20 * sin(a) ** 2 * cos(a) ** 2 * v,
        (x + sin(a) + cos(a) + y) ** 20 * v,
        (x - y + a - b) ** 20 * R + (x + a - v) ** 10,
        (x + y + a + b + v) ** 20 / (x - y),
        nested(60),
    ],
    ids=["powers of sums", "of sines", "of differences", "in a quotient", "2^60 leaves"],
)
def test_what_is_long_is_left_alone_at_once(written: sp.Expr) -> None:
    start = time.perf_counter()
    assert tidied(written) is written
    assert in_differences(written, (x, y, a, b)) is written
    assert time.perf_counter() - start < 1


@pytest.mark.parametrize(
    ("written", "short"),
    [
        (8 * x * (x - 2 * y) + 8 * y**2, 8 * (y - x) ** 2),
        (x**2 - 2 * x * y + y**2 + a**2 - 2 * a * b + b**2, (b - a) ** 2 + (y - x) ** 2),
        ((x**2 - 2 * x * y + y**2 + a**2) / (x - y) ** 2, (a**2 + (y - x) ** 2) / (y - x) ** 2),
        (R * (x**2 + y**2), R * (x**2 + y**2)),
        (x - y, x - y),
        (2 * x - 2 * y, 2 * x - 2 * y),
        (cos(x) * y**2, cos(x) * y**2),
    ],
)
def test_in_differences(written: sp.Expr, short: sp.Expr) -> None:
    assert in_differences(written, (a, b, x, y)) == short


def test_a_cosine_over_its_sine_is_a_cotangent() -> None:
    assert with_cotangents(x * cos(a) / sin(a) + cos(b) / sin(a)) == x * sp.cot(a) + cos(b) / sin(a)
    assert with_cotangents(cos(a) * (x + cos(a) / sin(a)) / sin(a) ** 3) == sp.cot(a) * (x + sp.cot(a)) / sin(a) ** 2
    assert with_cotangents(cos(a) ** 3 / sin(a)) == cos(a) ** 2 * sp.cot(a)
    for kept in (
        sin(a) / cos(a),
        cos(a) / sp.sqrt(sin(a)),
        cos(2 * a) / sin(a),
        sin(a) * cos(a),
        sp.sqrt(cos(a)) / sin(a),
    ):
        assert with_cotangents(kept) == kept
