"""The prime field: canonical roots, roots of unity that match them, the circle, rational reconstruction."""

from __future__ import annotations

import random
import subprocess
import sys
from fractions import Fraction
from itertools import islice

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from lagrange.algebra.exact.prime_field import Fields, InadmissibleError, M, PrimeField, ZeroDivisorError, reconstructed
from tests.support.processes import PATIENCE

FIELDS = [PrimeField.draw(random.Random(seed)) for seed in range(8)]
any_field = st.sampled_from(FIELDS)
residues = st.integers(min_value=1, max_value=2**88)


@pytest.fixture(params=FIELDS, ids=lambda f: str(f.p)[:6])
def field(request: pytest.FixtureRequest) -> PrimeField:
    return request.param


def test_primes_have_the_form_that_roots_and_angles_need(field: PrimeField) -> None:
    assert sp.isprime(field.p)
    assert field.p.bit_length() == 89
    assert (field.p + 1) % M == 0
    assert field.p % 4 == 3


@pytest.mark.parametrize("prime", [2, 3, 5, 7, 11, 13, 17, 19, 23])
def test_primes_up_to_23_are_squares(field: PrimeField, prime: int) -> None:
    root = field.root(prime)
    assert root * root % field.p == prime
    assert field.sign(root) == 1


def test_roots_are_multiplicative(field: PrimeField) -> None:
    assert field.root(2) * field.root(3) % field.p == field.root(6)
    a, b = (pow(field.sample(), 2, field.p) for _ in range(2))
    assert field.root(a) * field.root(b) % field.p == field.root(a * b)


@given(any_field, residues)
def test_root_of_a_square_is_the_absolute_value(field: PrimeField, x: int) -> None:
    assert field.root(x * x) == x * field.sign(x) % field.p


@given(any_field, residues)
def test_of_x_and_minus_x_one_is_a_square(field: PrimeField, x: int) -> None:
    assert field.sign(x) * field.sign(-x) == (0 if x % field.p == 0 else -1)


def test_a_number_that_is_not_a_square_has_no_root(field: PrimeField) -> None:
    with pytest.raises(InadmissibleError):
        field.root(-1)
    with pytest.raises(InadmissibleError):
        field.power(-8, 1, 3)


@given(any_field, residues, st.integers(1, 12), st.integers(1, 30))
def test_fractional_powers_are_consistent(field: PrimeField, x: int, n: int, d: int) -> None:
    square = x * x % field.p
    if square:
        assert pow(field.power(square, n, d), d, field.p) == pow(square, n, field.p)
        assert field.power(square, 2 * n, 2 * d) == field.power(square, n, d)


def test_division_by_zero(field: PrimeField) -> None:
    with pytest.raises(ZeroDivisorError):
        field.inverse(field.p)
    with pytest.raises(ZeroDivisorError):
        field.power(0, -1, 2)


def test_wanted_primes_are_squares() -> None:
    wanted = (29, 31, 109, 113)
    field = PrimeField.draw(random.Random(5), wanted)
    assert all(field.root(n) ** 2 % field.p == n for n in wanted)
    assert not all(f.sign(n) == 1 for f in FIELDS for n in wanted)  # others do not have these roots


# cos and sin of 2π n/d by radicals, as tables give them.
ROOTS_OF_UNITY = [
    (1, 4, "0", "1"),
    (1, 8, "sqrt(2)/2", "sqrt(2)/2"),
    (1, 12, "sqrt(3)/2", "1/2"),
    (1, 3, "-1/2", "sqrt(3)/2"),
    (1, 24, "(sqrt(6) + sqrt(2))/4", "(sqrt(6) - sqrt(2))/4"),
    (1, 5, "(sqrt(5) - 1)/4", "sqrt(10 + 2*sqrt(5))/4"),
    (1, 10, "(sqrt(5) + 1)/4", "sqrt(10 - 2*sqrt(5))/4"),
    (1, 16, "sqrt(2 + sqrt(2))/2", None),
    (7, 12, "-sqrt(3)/2", "-1/2"),
    (-1, 6, "1/2", "-sqrt(3)/2"),
]


@pytest.mark.parametrize(("n", "d", "cosine", "sine"), ROOTS_OF_UNITY)
def test_roots_of_unity_match_the_canonical_roots(
    field: PrimeField, n: int, d: int, cosine: str, sine: str | None
) -> None:
    def value(e: sp.Expr) -> int:
        if e.is_Rational:
            return field.number(int(e.p), int(e.q))
        if e.is_Pow and e.exp == sp.Rational(1, 2):
            return field.root(value(e.base))
        combine = sum if e.is_Add else sp.prod
        return int(combine([value(a) for a in e.args])) % field.p

    found = field.unity(n, d)
    assert found[0] == value(sp.sympify(cosine))
    if sine is not None:
        assert found[1] == value(sp.sympify(sine))


def test_gauss_sums_have_the_sign_that_gauss_proved(field: PrimeField) -> None:
    seventh = [field.unity(n, 7)[1] for n in (1, 2, 4)]
    assert 2 * sum(seventh) % field.p == field.root(7)
    thirteenth = [field.unity(n, 13)[0] for n in (1, 3, 4)]
    assert 4 * sum(thirteenth) % field.p == (field.root(13) - 1) % field.p


def test_roots_of_unity_outside_the_circle(field: PrimeField) -> None:
    with pytest.raises(InadmissibleError):
        field.unity(1, 29)


@given(any_field, st.integers(-50, 50), st.integers(-50, 50), st.integers(1, 60))
def test_circle_powers_add(field: PrimeField, m: int, n: int, d: int) -> None:
    w = field.random_circle()
    assert (w[0] ** 2 + w[1] ** 2) % field.p == 1
    assert field.times(field.circle_power(w, m), field.circle_power(w, n)) == field.circle_power(w, m + n)
    part = field.circle_fraction(w, 1, d)
    assert field.circle_power(part, d) == w
    assert field.circle_fraction(w, n, d) == field.circle_power(part, n)


def test_roots_of_any_circle_point(field: PrimeField) -> None:
    made = 0
    for n in islice(range(100), 100):
        x = field.sample()
        point = ((1 - x * x) * field.inverse(1 + x * x) % field.p, 2 * x * field.inverse(1 + x * x) % field.p)
        for d in (2, 3, 7, 29):
            try:
                root = field.circle_root(point, d)
            except InadmissibleError:
                continue
            made += 1
            assert field.circle_power(root, d) == point, n
    assert made > 100  # all for 29, half for 2


@given(any_field, st.fractions(max_denominator=10**6).filter(lambda f: abs(f.numerator) < 10**6))
def test_reconstruction_finds_small_fractions(field: PrimeField, f: Fraction) -> None:
    assert reconstructed(field.number(f.numerator, f.denominator), field.p) == f


def test_reconstruction_rejects_random_residues(field: PrimeField) -> None:
    assert [reconstructed(field.sample(), field.p) for _ in range(100)] == [None] * 100


def test_seeded_fields_repeat_and_others_do_not() -> None:
    assert Fields(3).field().p == Fields(3).field().p
    assert Fields(3).field().p != Fields(4).field().p
    assert Fields().field().p != Fields().field().p


def test_every_process_has_a_prime_of_its_own() -> None:
    """With one public prime p, an equation could be forged by adding p·θ to it."""
    code = "from lagrange.algebra.exact.prime_field import process_fields as f; print(f().field().p, f().field(1).p)"
    runs = [
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=PATIENCE)
        for _ in range(3)
    ]
    primes = [int(p) for run in runs for p in run.stdout.split()]
    assert len(set(primes)) == len(primes) == 6
