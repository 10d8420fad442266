"""Linear equations solved in the ring, as long as that stays small.

Quotients of sines and cosines without common factors; what is cancelled is put back and compared by numbers.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.fourier.linear_systems import (
    as_one_quotient,
    in_lowest_terms,
    lowest_terms,
    one_quotient,
    solved_linear,
)
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.algebra.fourier.textbook_form import Textbook
from lagrange.core.effort import allowed
from tests.support.shared import solved


def test_linear_equations() -> None:
    a, b = sp.symbols("a b", real=True)
    assert solved_linear([[a, b], [b, -a]], [sp.S.One, sp.S.Zero], Surface()) == [a / (a**2 + b**2), b / (a**2 + b**2)]
    assert solved_linear([[sp.S.One, a, sp.S.Zero], [sp.S.Zero, sp.S.Zero, b]], [b, b], Surface()) == [None, None, 1]


# Fractions


a, b, m, theta, phi = (sp.Symbol(n, positive=n in "abm", real=True) for n in ("a", "b", "m", "theta", "phi"))
sin, cos = sp.sin, sp.cos

QUOTIENTS = {
    # above, below, what is left of both
    "a sum that only sin² + cos² = 1 shows": (
        (a + m - m * sin(theta) ** 2) * b,
        (a + m * cos(theta) ** 2) * (a + m),
        (b, a + m),
    ),
    "a half angle": (sin(theta), 1 - cos(theta), (1 + cos(theta), sin(theta))),
    "two angles": (
        (a + b * cos(theta - phi)) * sin(phi),
        (a + b * cos(theta - phi)) * (m + cos(theta)),
        (sin(phi), m + cos(theta)),
    ),
    "powers below": ((a / b + cos(theta)) * m, (a / b + cos(theta)) * (2 + cos(theta)) / m**2, (m**3, 2 + cos(theta))),
    "numbers": ((1 + cos(theta)) * sp.Rational(2, 3), (1 + cos(theta)) * (a - b * sin(theta)) / 5,
                (sp.Rational(10, 3), a - b * sin(theta))),
}  # fmt: skip


@pytest.mark.parametrize(("above", "below", "left"), QUOTIENTS.values(), ids=QUOTIENTS)
def test_what_is_in_common_is_divided_out(above: sp.Expr, below: sp.Expr, left: tuple[sp.Expr, sp.Expr]) -> None:
    ring = FourierRing()
    reduced = lowest_terms(ring.from_sympy(above), ring.from_sympy(below))
    assert reduced is not None
    n, d = reduced
    assert n * ring.from_sympy(left[1]) == d * ring.from_sympy(left[0])
    assert len(d) <= len(ring.from_sympy(left[1]))


def test_nothing_in_common() -> None:
    ring = FourierRing()
    assert lowest_terms(ring.from_sympy(a + cos(theta)), ring.from_sympy(b + cos(theta))) is None
    assert lowest_terms(ring.zero, ring.from_sympy(b + cos(theta))) is None


def test_long_ones_and_high_multiples_are_left() -> None:
    ring = FourierRing()
    common = ring.from_sympy(a + cos(theta))
    high = ring.from_sympy(b + cos(40 * theta))
    assert lowest_terms(common * high, common) is None
    long = ring.from_sympy(sp.Add(*(sp.Symbol(f"x{n}") * cos(theta) for n in range(80))))
    assert lowest_terms(common * long, common) is None


def test_roots_and_what_is_no_shorter_are_left() -> None:
    root = (a + cos(theta)) / sp.sqrt(b + cos(theta))
    assert in_lowest_terms(root) == root
    assert in_lowest_terms(a / (b + m)) == a / (b + m)


def test_the_reactions_of_a_coin_on_an_incline() -> None:
    """They had C + m R² cos²θ above and below the line."""
    found = solved("coin-on-incline")
    reactions = found.own.dynamics.reactions if found.own.dynamics is not None else None
    assert reactions is not None
    assert set(reactions.multipliers) == {"rolling.1", "rolling.2"}
    for value in reactions.multipliers.values():
        assert value is not None
        assert not sp.fraction(sp.together(value))[1].has(sp.cos)


NESTED = {
    # value, as one quotient
    "a quotient above the line": (
        (b * (a**2 / b**2 + 1) + m * theta / b) / (a + theta**2),
        (a**2 + b**2 + m * theta) / (b * (a + theta**2)),
    ),
    "the same sum below in every term": (
        a * sin(theta) / (m + b * cos(theta)) - b + b**2 * cos(theta) / (b * cos(theta) + m),
        (a * sin(theta) - b * m) / (m + b * cos(theta)),
    ),
    "minus everywhere": (
        -theta / (b**2 * (m + theta**2)) - b / (m + theta**2),
        -(theta + b**3) / (b**2 * (m + theta**2)),
    ),
    "a denominator with more minus signs": (
        (b * (a / b + theta / b**2)) / (m**3 - theta - phi),
        (a * b + theta) / (b * (m**3 - theta - phi)),
    ),
}


@pytest.mark.parametrize(("value", "expected"), NESTED.values(), ids=NESTED)
def test_one_quotient(value: sp.Expr, expected: sp.Expr) -> None:
    shown = as_one_quotient(value)
    assert sp.expand(sp.fraction(shown)[0] - sp.fraction(expected)[0]) == 0
    assert sp.fraction(shown)[1] == sp.fraction(expected)[1]


def test_what_is_no_shorter_as_one_quotient_is_left() -> None:
    value = a + 1 / (m + theta)
    assert as_one_quotient(value) == value
    assert as_one_quotient(sp.sqrt(a + theta) / b) == sp.sqrt(a + theta) / b


@pytest.mark.parametrize("name", ["snakeboard", "bead-on-lemniscate"])
def test_reactions_without_fractions_above_the_line(name: str) -> None:
    """Those of the snakeboard filled a hundred lines."""
    dynamics = solved(name).own.dynamics
    assert dynamics is not None
    assert dynamics.reactions is not None
    for value in dynamics.reactions.multipliers.values():
        assert value is not None
        above, _ = sp.fraction(value)
        assert all(sp.fraction(term)[1].is_number for e in above.atoms(sp.Add) for term in e.args)
        assert value.count_ops() < 160


def test_a_quotient_is_written_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """As the sum of its terms is; `as_one_quotient` knows that it is one, and reads it no more."""
    v, w = (sp.Symbol(n, real=True) for n in ("theta'", "phi'"))
    above, below = a * v**2 + b * w**2 * cos(theta), a + m * sin(theta) ** 2
    ring = FourierRing()
    with allowed(10**6):
        written = one_quotient(ring.from_sympy(above / m), ring.from_sympy(below / m), Textbook(ring))
        assert written is not None
        assert as_one_quotient(sp.Add(*(term / below for term in above.args))) == written
        monkeypatch.setattr("lagrange.algebra.fourier.linear_systems.lowest_terms", None)
        assert as_one_quotient(written) is written


def test_terms_that_may_be_shorter_apart_are_not_one_quotient() -> None:
    v, w = (sp.Symbol(n, real=True) for n in ("theta'", "phi'"))
    ring = FourierRing()
    read, textbook = ring.from_sympy, Textbook(ring)
    below = a + m * sin(theta) ** 2
    assert one_quotient(read(below * v**2 + b * w**2), read(below), textbook) is None  # θ'² + b φ'²/(...)
    assert one_quotient(read(b * w**2), read(below), textbook) is None  # one term
