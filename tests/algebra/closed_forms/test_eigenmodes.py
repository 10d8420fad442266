"""Frequencies and modes in closed form."""

from __future__ import annotations

import pytest
import sympy as sp
from mpmath import matrix, mp, mpf

from lagrange.algebra.closed_forms.eigenmodes import closed_roots, letter_factors, with_repeated_roots_apart
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from tests.support.linearized_systems import (
    SYSTEMS,
    at_numbers,
    linear_equations,
    numbers,
    of,
    solved,
    there,
)

SEEDS = range(4)


def test_published_modes_of_the_molecule() -> None:
    """Goldstein, section 6.4: ω = 0, √(k/m), √(k/m (1 + 2m/M)), with (1, 1, 1), (1, 0, −1), (1, −2m/M, 1)."""
    m, M, c = sp.symbols("m M c", positive=True)
    [s] = of(SYSTEMS["molecule"]).at
    assert s is not None
    wanted = [(0, (1, 1, 1)), (c / m, (1, 0, -1)), (c / m * (1 + 2 * m / M), (1, -2 * m / M, 1))]
    for f, (square, mode) in zip(s.frequencies, wanted, strict=True):
        assert sp.cancel(f.square - square) == 0
        [found] = f.modes
        assert all(sp.cancel(a - b) == 0 for a, b in zip(found, mode, strict=True))
    assert s.judgement.stability.verdict is StabilityVerdict.UNDECIDED  # it may drift


def test_modes_of_the_double_pendulum() -> None:
    """Every mode satisfies (K − ω² M) a = 0 in numbers, and different ones are orthogonal."""
    system = SYSTEMS["double-pendulum"]
    found = of(system)
    for seed in SEEDS:
        p = numbers(system, seed)
        s = there(found, system, p)
        mass, stiff = (
            matrix([[at_numbers(e, p) for e in row] for row in x]) for x in (s.system.mass, s.system.stiffness)
        )
        modes = [matrix([at_numbers(a, p) for a in f.modes[0]]) for f in s.frequencies]
        for f, mode in zip(s.frequencies, modes, strict=True):
            assert mp.norm((stiff - at_numbers(f.square, p) * mass) * mode) < mpf(10) ** -25
        assert abs((modes[0].T * mass * modes[1])[0]) < mpf(10) ** -25


DEGENERATE = """
parameters: [m, c, b]
coordinates: [x, y, z]
particles: {A: {mass: m, position: x*i}, B: {mass: m, position: y*i}, C: {mass: m, position: z*i}}
forces: {ring: {potential: c*((x - y)^2 + (y - z)^2 + (z - x)^2)/2 + b*(x + y + z)^2/2}}
"""


def test_a_frequency_that_belongs_to_two_modes() -> None:
    [s] = linear_equations(solved(DEGENERATE)).at
    assert s is not None
    assert sorted((str(f.square), f.multiplicity, len(f.modes)) for f in s.frequencies) == [
        ("3*b/m", 1, 1),
        ("3*c/m", 2, 2),
    ]


@pytest.mark.parametrize(
    ("potential", "wanted"),
    [
        ("sqrt(14)*(x^2 + y^2)/2", [(sp.sqrt(14), 2)]),  # ω⁴ − 2√14 ω² + 14 is a square
        ("sqrt(3)*(x^2 + y^2 + z^2)/2", [(sp.sqrt(3), 3)]),
        ("sqrt(5)*(x^2 + y^2)/2 + z^2", [(2, 1), (sp.sqrt(5), 2)]),
        ("sqrt(2)*(x^2 + y^2 + z^2 + x*y + y*z + z*x)/2", [(sp.sqrt(2) / 2, 2), (2 * sp.sqrt(2), 1)]),
    ],
)
def test_a_multiple_frequency_with_a_root_in_it_has_all_its_modes(
    potential: str, wanted: list[tuple[sp.Expr, int]]
) -> None:
    names = "x, y, z" if "z" in potential else "x, y"
    place = names if "z" in potential else "x, y, 0"
    text = f"coordinates: [{names}]\nparticles: {{P: {{mass: 1, position: '[{place}]'}}}}\n"
    [s] = linear_equations(solved(text + f"forces: {{v: {{potential: '{potential}'}}}}\n")).at
    assert s is not None
    assert [(f.multiplicity, len(f.modes)) for f in s.frequencies] == [(n, n) for _, n in wanted]
    assert all(sp.expand(f.square - w) == 0 for f, (w, _) in zip(s.frequencies, wanted, strict=True))


TRIPLE = """
parameters: [m, l, g]
coordinates: [a, b, c]
particles:
  P: {mass: m, position: l*sin(a)*i - l*cos(a)*j}
  Q: {mass: m, position: r_P + l*sin(b)*i - l*cos(b)*j}
  R: {mass: m, position: r_Q + l*sin(c)*i - l*cos(c)*j}
gravity: -g*j
"""


def test_a_cubic_equation_stays_an_equation() -> None:
    """The triple pendulum: x³ − 9x² + 18x − 6 = 0 for x = ω² l/g, Laguerre's polynomial; stable all the same."""
    s = linear_equations(solved(TRIPLE)).at[0]
    assert s is not None
    [f] = s.frequencies
    assert f.square is None
    x, g, l = f.letter, *sp.symbols("g l", positive=True)
    polynomial = sp.Poly(f.factor.xreplace({x: x * g / l}), x).monic()
    assert polynomial.all_coeffs() == [1, -9, 18, -6]
    assert s.judgement.stability.verdict is StabilityVerdict.STABLE


def test_the_square_under_the_root_stays_where_that_is_shorter() -> None:
    """A pendulum below a cart on a spring: M l w² − ((M + m) g + k l) w + g k = 0."""
    M, m, k, l, g = sp.symbols("M m k l g", positive=True)
    w = sp.Symbol("w")
    b = (M + m) * g + k * l
    first, second = closed_roots(sp.expand(M * l * w**2 - b * w + g * k), w)
    assert sp.sqrt((M * g + g * m + k * l) ** 2 - 4 * M * g * k * l) in first.atoms(sp.Pow)
    assert sp.expand(first + second - b / (M * l)) == 0
    assert sp.expand(sp.expand(first * second) - g * k / (M * l)) == 0


# -- Roots that are equal by a relation between roots or sines ---------------------------------------------------------


w = sp.Symbol("w", real=True)
a, b, alpha = sp.symbols("a b alpha", positive=True)
root = sp.sqrt(14)
length = sp.sqrt(a**2 + b**2)


def same(f: sp.Expr, g: sp.Expr) -> bool:
    """Whether two polynomials have the same roots with the same multiplicities."""
    a, b = sp.Poly(f, w), sp.Poly(g, w)
    return a.degree() == b.degree() and is_zero(a.LC() * g - b.LC() * f) is True


@pytest.mark.parametrize(
    ("pieces", "wanted"),
    [
        ([(w**2 - 2 * root * w + 14, 1)], [(w - root, 2)]),
        ([(sp.expand((w - root) ** 3), 1)], [(w - root, 3)]),
        ([(sp.expand((w - root) ** 2 * (w - a)), 2)], [(w - a, 2), (w - root, 4)]),
        ([(w**2 - 2 * length * w + a**2 + b**2, 1)], [(w - length, 2)]),
        ([(w - sp.sin(alpha) ** 2, 1), (w - 1 + sp.cos(alpha) ** 2, 1)], [(w - sp.sin(alpha) ** 2, 2)]),
        ([(w**2 - 2 * root * w + 13, 1)], [(w**2 - 2 * root * w + 13, 1)]),  # √14 ± 1
        ([(w - root, 1), (w - a, 2)], [(w - root, 1), (w - a, 2)]),
    ],
)
def test_equal_roots_are_one(pieces: list[tuple[sp.Expr, int]], wanted: list[tuple[sp.Expr, int]]) -> None:
    found = with_repeated_roots_apart(pieces, w)
    assert len(found) == len(wanted)
    for f, n in wanted:
        assert any(n == m and same(f, g) for g, m in found)


def test_factors_of_a_polynomial_with_roots_below() -> None:
    """(w − a) (w − √b)/√(a + √b): the divisor, which does not contain w, changes no root."""
    a, b, w = sp.symbols("a b w", positive=True)
    below = sp.sqrt(a + sp.sqrt(b))
    polynomial = sp.expand((w - a) * (w - sp.sqrt(b))) / below + sp.expand((w - a) * w / below**3)
    roots = {r for f, _ in letter_factors(polynomial, w) for r in sp.solve(f, w)}
    numbers = {a: sp.Rational(3, 2), b: sp.Rational(4)}
    values = sorted(float(r.subs(numbers)) for r in roots)
    true = sorted(float(r) for r in sp.solve(polynomial.subs(numbers), w))
    assert values == pytest.approx(true)
