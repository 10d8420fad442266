"""Damped normal modes: the exponents p of M ξ'' + D ξ' + K ξ = 0 as decay rates and frequencies.

A pair of conjugate exponents p = −σ ± iω is one mode, ξ = a e^{−σt} cos ωt. Each belongs to a factor of second degree,

    p² + 2σ p + ω₀² ,      ω² = ω₀² − σ² ,

and for ω² ≤ 0 the motion does not oscillate: two real exponents p = −σ ± √(σ² − ω₀²), one of them twice at the critical
damping σ = ω₀. A factor of first degree is a single real exponent p = −σ.

Damping is proportional where the modes a of the undamped system satisfy D a = 2σ M a: then they are the modes of the
damped one as well, all parts in phase, with σ = aᵀ D a / (2 aᵀ M a) (Rayleigh; Caughey 1960). This is decided exactly,
mode by mode. Otherwise the characteristic polynomial is factored; the parts of a mode then have different phases, and
shapes are given in numbers (`in_numbers`). Reference: Meirovitch, Fundamentals of Vibrations, § 7.15.
"""

from __future__ import annotations

from collections.abc import Iterable

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.eigenmodes import (
    Frequency,
    Matrix,
    determinant,
    frequencies,
    letter_factors,
    without_minus,
)
from lagrange.algebra.closed_forms.signs import SignCondition, sign_of
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.determinants import expanded_determinant
from lagrange.core.records import record

ZERO = sp.S.Zero


@record
class DampedMode:
    """One factor of the characteristic polynomial.

    rate          σ
    square        ω² = ω₀² − σ², negative where the motion does not oscillate; None for a single real exponent
    own           ω₀²; None for a single real exponent
    multiplicity  of the factor
    condition     where it oscillates, if that depends on the parameters: c < 2 √(k m)
    shape         a, where damping is proportional
    """

    rate: sp.Expr
    square: sp.Expr | None
    own: sp.Expr | None
    multiplicity: int = 1
    condition: SignCondition | None = None
    shape: tuple[sp.Expr, ...] = ()

    @property
    def difference(self) -> sp.Expr | None:
        """ω² as ω₀² − σ², (c + 2 κ)/m − (b/m)²; None for a single real exponent."""
        return None if self.own is None else sp.Add(self.own, -(self.rate**2))

    @property
    def oscillates(self) -> bool | None:
        """Whether ω² > 0; None if that depends on the parameters, or is not known."""
        if self.square is None:
            return False
        sign = sign_of(self.square)
        return None if sign is None else sign > 0

    @property
    def is_critical(self) -> bool:
        """Whether a real exponent is double."""
        return self.square is not None and self.square == 0

    @property
    def decays(self) -> tuple[sp.Expr, ...]:
        """The decay rates: σ of oscillating modes; one or two rates if nothing oscillates."""
        if self.square is None or self.square == 0 or self.oscillates is not False:
            return (self.rate,)
        root = sp.sqrt(sp.factor(-self.square))
        return self.rate - root, self.rate + root


@record
class DampedModes:
    """The modes of one damped system; `left`: factors of higher degree in the exponent, with their multiplicities."""

    modes: tuple[DampedMode, ...]
    left: tuple[tuple[sp.Expr, int], ...]
    letter: sp.Symbol
    proportional: bool = False

    @property
    def complete(self) -> bool:
        """Whether all are in closed form."""
        return not self.left


def damped_modes(matrices: tuple[Matrix, Matrix, Matrix], polynomial: sp.Expr, letter: sp.Symbol) -> DampedModes:
    """The modes, from M, D, K and det(K + p D + p² M) as a polynomial in the letter p."""
    proportional = _proportional(*matrices) if len(matrices[0]) > 1 else None
    if proportional is not None:
        return DampedModes(proportional, (), letter, proportional=True)
    modes, left = [], []
    for factor, multiplicity in letter_factors(polynomial, letter):
        coefficients = sp.Poly(factor, letter).all_coeffs()
        match len(coefficients):
            case 2:
                a, b = coefficients
                modes.append(DampedMode(sp.factor(b / a), None, None, multiplicity))
            case 3:
                a, b, c = coefficients
                modes.append(_mode(a, b, c, multiplicity))
            case _:
                left.append((factor, multiplicity))
    return DampedModes(tuple(modes), tuple(left), letter)


def _mode(m: sp.Expr, d: sp.Expr, k: sp.Expr, multiplicity: int = 1, shape: tuple[sp.Expr, ...] = ()) -> DampedMode:
    """The mode m p² + d p + k = 0."""
    own, rate = sp.factor(k / m), sp.factor(d / (2 * m))
    square = without_minus(sp.factor(own - rate**2))
    return DampedMode(rate, square, own, multiplicity, _where_it_oscillates(m, d, k, square), shape)


def _where_it_oscillates(m: sp.Expr, d: sp.Expr, k: sp.Expr, square: sp.Expr) -> SignCondition | None:
    """c < 2 √(k m), or 4 k m > c² where a sign is not known."""
    if sign_of(square) is not None:
        return None
    if sign_of(d) == 1 and sign_of(m) == 1 and sign_of(k) == 1:
        shared = sp.gcd(sp.gcd(m, d), k)
        shared = shared if sign_of(shared) == 1 else sp.S.One
        content = abs(sp.factor(d / shared).as_coeff_Mul()[0])
        number, rest = sp.factor(4 * m * k / (shared * content) ** 2).as_coeff_Mul()
        root = sp.sqrt(number)
        outside, inside = (root, rest) if root.is_Rational else (sp.S.One, number * rest)
        bound = sp.Pow(inside, sp.S.Half, evaluate=False)
        bound = bound if outside == 1 else sp.Mul(outside, bound, evaluate=False)
        return SignCondition(sp.factor(d / (shared * content)), "<", bound)
    shared = sp.gcd(4 * k * m, d**2)
    shared = shared if sign_of(shared) == 1 else sp.S.One
    return SignCondition(sp.expand(sp.cancel(4 * k * m / shared)), ">", sp.factor(sp.cancel(d**2 / shared)))


def _proportional(mass: Matrix, damping: Matrix, stiffness: Matrix) -> tuple[DampedMode, ...] | None:
    """The modes of the undamped system, where D a = 2σ M a for each of them; None if not, or not in closed form."""
    size = len(mass)
    if any(is_zero(x[i][j] - x[j][i]) is not True for x in (mass, stiffness) for i in range(size) for j in range(i)):
        return None
    w = sp.Dummy("omega_squared", real=True)
    polynomial = determinant([[k - w * m for k, m in zip(ks, ms, strict=True)] for ks, ms in
                              zip(stiffness, mass, strict=True)])  # fmt: skip
    if polynomial is None:
        return None
    undamped = frequencies(mass, stiffness, letter_factors(polynomial, w), w, with_modes=True)
    if any(f.square is None for f in undamped) or sum(len(f.modes) for f in undamped) != size:
        return None
    modes = [_of_undamped(f, mode, mass, damping) for f in undamped for mode in f.modes]
    return tuple(m for m in modes if m is not None) if None not in modes else None


def _of_undamped(f: Frequency, a: tuple[sp.Expr, ...], mass: Matrix, damping: Matrix) -> DampedMode | None:
    """The damped mode with the shape of an undamped one; None if the damping couples it with others."""
    lost, moved = _times(damping, a), _times(mass, a)
    m, d = (sp.factor(sp.Add(*(x * y for x, y in zip(a, row, strict=True)))) for row in (moved, lost))
    if any(is_zero(x * m - d * y) is not True for x, y in zip(lost, moved, strict=True)):
        return None
    assert f.square is not None
    ratio = sp.factor(sp.radsimp(sp.cancel(sp.together(d / m))))
    numerator, denominator = sp.fraction(ratio)
    return _mode(denominator, numerator, sp.factor(f.square * denominator), shape=a)


def _times(matrix: Matrix, a: Iterable[sp.Expr]) -> list[sp.Expr]:
    vector = list(a)
    return [sp.Add(*(x * y for x, y in zip(row, vector, strict=True))) for row in matrix]


def all_exponents_hold(damped: DampedModes, matrices: tuple[Matrix, Matrix, Matrix]) -> bool | None:
    """Whether det(K + p D + p² M) = det M Π (p² + 2σ p + ω₀²) Π (p + σ) Π (what is left): the second route."""
    mass, damping, stiffness = (sp.Matrix(x) for x in matrices)
    p = sp.Dummy("p", real=True)
    product = expanded_determinant(mass.tolist())
    for m in damped.modes:
        factor = p + m.rate if m.own is None else p**2 + 2 * m.rate * p + m.own
        if m.own is not None and is_zero(m.own - m.rate**2 - (m.square or ZERO)) is not True:
            return False
        product *= factor**m.multiplicity
    for factor, multiplicity in damped.left:
        polynomial = sp.Poly(factor, damped.letter)
        product *= (factor.xreplace({damped.letter: p}) / polynomial.LC()) ** multiplicity
    return is_zero(expanded_determinant((stiffness + p * damping + p**2 * mass).tolist()) - product)


@record
class NumericalMode:
    """A mode in numbers: σ, ω (0: no oscillation), amplitudes and phases; those of the largest part are 1 and 0."""

    rate: mpmath.mpf
    frequency: mpmath.mpf
    amplitudes: tuple[mpmath.mpf, ...]
    phases: tuple[mpmath.mpf, ...]


def exponents_in_numbers(mass: mpmath.matrix, damping: mpmath.matrix, stiffness: mpmath.matrix) -> list[NumericalMode]:
    """The modes of a system in numbers, slow decays first: the eigenvalues p and eigenvectors (a, p a) of

        (0, 1; −M⁻¹ K, −M⁻¹ D) ,

    with the working precision of mpmath. What is smaller than half of its digits counts as zero.
    """
    size = mass.rows
    inverse = mass**-1
    block = mpmath.zeros(2 * size)
    for i in range(size):
        block[i, size + i] = 1
        for j in range(size):
            block[size + i, j] = -sum(inverse[i, n] * stiffness[n, j] for n in range(size))
            block[size + i, size + j] = -sum(inverse[i, n] * damping[n, j] for n in range(size))
    values, vectors = mpmath.eig(block)
    small = mpmath.mpf(10) ** (-mpmath.mp.dps // 2) * max(abs(v) for v in values)
    exponents = []
    for n, p in enumerate(values):
        if p.imag < -small:
            continue  # the conjugate
        shape = [vectors[i, n] for i in range(size)]
        largest = max(shape, key=abs)
        ratios = [a / largest for a in shape]
        phases = (mpmath.arg(a) if abs(a) > small else mpmath.mpf(0) for a in ratios)
        tidy = tuple(mpmath.mpf(0) if abs(x) < small else x for x in phases)
        frequency = p.imag if p.imag > small else mpmath.mpf(0)
        rate = -p.real if abs(p.real) > small else mpmath.mpf(0)
        exponents.append(NumericalMode(rate, frequency, tuple(abs(a) for a in ratios), tidy))
    return sorted(exponents, key=lambda e: (e.rate, e.frequency))
