"""Signs of functions of parameters with a range, against sampled values."""

from __future__ import annotations

import pickle

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.core.ranges import never_vanishes, sign_in_range
from lagrange.core.symbols import Bounded

pi = sp.pi
a = Bounded("a", sp.S.Zero, pi / 2, (True, True))
b = Bounded("b", sp.S.Zero, pi / 2)
c = Bounded("c", -pi / 4, pi / 3)
d = Bounded("d", sp.Rational(1, 2), sp.Integer(2))

FUNCTIONS = [
    sp.sin(a), sp.cos(a), sp.tan(a), sp.sin(2 * a), sp.cos(2 * a), sp.cos(a / 2), sp.sin(a - pi / 2), sp.sin(b),
    sp.cos(b), sp.sin(2 * b), sp.cos(c), sp.sin(c), c - pi / 2, a - pi / 2, sp.sin(a + b), sp.cos(a - b), sp.sin(3 * a),
    sp.cot(a), 1 - 3 * d, d - 2, 2 * d - c, sp.cos(d), sp.sin(d), sp.sin(d + a), sp.tan(2 * c), sp.sin(5 * d),
]  # fmt: skip
DECIDED = {
    sp.sin(a): 1, sp.cos(a): 1, sp.tan(a): 1, sp.sin(2 * a): 1, sp.cos(a / 2): 1, sp.cos(c): 1, c - pi / 2: -1,
    a - pi / 2: -1, sp.sin(a + b): 1, sp.cot(a): 1, 1 - 3 * d: -1, sp.sin(d): 1, sp.cos(a - b): 1,
}  # fmt: skip


@pytest.mark.parametrize("f", FUNCTIONS, ids=str)
def test_signs_agree_with_samples(f: sp.Expr) -> None:
    sign = sign_of(f)
    assert sign == DECIDED.get(f, sign)
    values = [f]
    for s in sorted(f.free_symbols, key=str):
        steps = [sp.Rational(n, 12) for n in range(0 if not s.strict[0] else 1, 13 if not s.strict[1] else 12)]
        values = [v.subs(s, s.low + (s.high - s.low) * part) for v in values for part in steps]
    if sign is not None:
        assert all((v.evalf() > 0) if sign == 1 else (v.evalf() < 0) for v in values)


def test_ends_that_belong_to_the_range_are_not_forgotten() -> None:
    assert sign_in_range(sp.sin(b)) is None
    assert sign_in_range(sp.cos(b)) is None
    assert not never_vanishes(sp.cos(b))
    assert never_vanishes(sp.cos(a))


def test_parameters_with_different_ranges_are_different() -> None:
    assert a != Bounded("a", sp.S.Zero, pi / 2)
    assert a == Bounded("a", sp.S.Zero, pi / 2, (True, True))
    assert a != sp.Symbol("a", positive=True)
    assert pickle.loads(pickle.dumps(a)) == a
    assert (a.is_positive, b.is_positive, b.is_nonnegative, c.is_positive) == (True, None, True, None)
