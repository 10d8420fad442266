from __future__ import annotations

import math
import random

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.intervals import EmptyIntervalError, IntervalProgram, circle, enclosure

x, y = sp.symbols("x y", real=True)
EXPRESSIONS = [
    x**3 - 2 * x * y + sp.Rational(1, 3),
    sp.sqrt(x**2 + y**2) ** 3 - sp.pi * x,
    (x - y) ** 2 * (x + y - sp.sqrt(2)),
    -(x**2) * y**5 + 10**20,
]


@pytest.mark.parametrize("e", EXPRESSIONS, ids=str)
def test_no_value_lies_outside(e: sp.Expr) -> None:
    rng = random.Random(7)
    for _ in range(20):
        box = {s: tuple(sorted((rng.uniform(-3, 3), rng.uniform(-3, 3)))) for s in (x, y)}
        low, high = enclosure(e, box)
        for _ in range(5):
            at = {s: sp.Rational(rng.uniform(*box[s])) for s in (x, y)}
            assert low <= e.xreplace(at).evalf(40) <= high


def test_the_circle_contains_the_extremes_between_the_ends() -> None:
    cosine, sine = circle(0.9, 2.1)
    assert cosine[0] == -1
    assert sine[1] == 1
    assert cosine[1] == pytest.approx(0.15643446504)
    assert sine[0] == pytest.approx(-0.15643446504)


def test_a_root_of_negative_numbers_is_empty() -> None:
    with pytest.raises(EmptyIntervalError):
        enclosure(sp.sqrt(x), {x: (-2.0, -1.0)})


# -- Programs, on the same boxes and on others: values by SymPy in 40 digits -------------------------------------------

FUNCTIONS = [
    *EXPRESSIONS,
    sp.sin(3 * x) * sp.cos(x - y) ** 3 - sp.tan(x / 4),
    sp.exp(-(x**2)) * sp.Abs(y) ** 3 / (3 + sp.sin(y)),
    sp.log(x**2 + 1) / sp.sqrt(y**2 + sp.Rational(1, 7)) ** 3 + sp.cot(2 + x / 6),
    sp.sign(y) * x + sp.Float("1.5") * sp.sin(1000 * x),
]


@pytest.mark.parametrize("width", [6, 0.3, 1e-6])
@pytest.mark.parametrize("e", FUNCTIONS, ids=str)
def test_a_program_contains_every_value(e: sp.Expr, width: float) -> None:
    rng = random.Random(11)
    program = IntervalProgram([e, sp.S.One], [x, y])
    bounded = 0
    for _ in range(15):
        start = [rng.uniform(-3, 3) for _ in "xy"]
        box = [(s, s + width * rng.random()) for s in start]
        value, one = program.at(box)
        assert one == (1, 1)
        if value is None:
            continue
        bounded += 1
        for _ in range(5):
            at = {s: sp.Rational(rng.uniform(*ends)) for s, ends in zip((x, y), box, strict=True)}
            assert value[0] <= e.xreplace(at).evalf(40) <= value[1]
        if width < 1e-3:
            assert value[1] - value[0] < 1e-3 * (1 + abs(value[0]))
    assert bounded > 5


@pytest.mark.parametrize("first", [0, 1, -1, 3])
def test_a_sine_has_its_extremes_between_the_ends(first: int) -> None:
    """Also where an end is an extreme but for rounding."""
    program = IntervalProgram([sp.sin(x), sp.cos(x)], [x])
    top, nearly = (first + 0.5) * math.pi, 1e-15
    for low, high in ((top - 1, top), (top, top + 1), (top - nearly, top + nearly), (top - 0.3, top + 0.2)):
        sine, cosine = program.at([(low, high)])
        assert sine is not None
        assert sine[first % 2 == 0] == (-1) ** first
        assert cosine is not None
        assert cosine[0] <= math.cos(low) <= cosine[1]


@pytest.mark.parametrize(
    "e", [1 / x, sp.sqrt(x), sp.log(x), sp.tan(x + sp.pi / 2), sp.exp(1000 + x), sp.DiracDelta(x)], ids=str
)
def test_a_program_has_no_value_where_a_part_of_the_box_has_none(e: sp.Expr) -> None:
    assert IntervalProgram([e, x], [x]).at([(-0.1, 0.1)])[0] is None


def test_a_sine_of_a_wide_interval_is_anything() -> None:
    assert IntervalProgram([sp.sin(x)], [x]).at([(-1.0, 9.0)]) == [(-1.0, 1.0)]
    assert IntervalProgram([sp.sin(x)], [x]).at([(1e9, 1e9)]) == [(-1.0, 1.0)]


def test_a_sum_of_squares_is_not_negative() -> None:
    """Its root has a value in a box around the origin, and on its edge."""
    program = IntervalProgram([sp.sqrt(x**2 + y**2), sp.sqrt(x * y)], [x, y])
    assert [v is not None and v[0] for v in program.at([(-1.0, 1.0), (-1.0, 1.0)])] == [0, False]
    assert [v is not None and v[0] for v in program.at([(0.0, 1.0), (0.0, 1.0)])] == [0, 0]
