"""For which values of a parameter the solutions of linear equations decay: a bicycle between two speeds.

det(M p² + D p + K) = a_0 p^n + ... + a_n, with coefficients that are polynomials in the parameter. As it changes, an
exponent p can pass to the other side of the imaginary axis only where a_n = 0 (p = 0), where the last but one of
Hurwitz' determinants vanishes (p = ±iω), or where a_0 = 0 (Orlando). Between such places the number of exponents on
either side is constant, and one value tells which it is.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import sympy as sp
from mpmath.libmp.libhyper import NoConvergence

from lagrange.core.records import record
from lagrange.mechanics.nearby.limits import CLEARLY_REAL, MOST_ROOT_STEPS, SHOWN_DIGITS

Entries = tuple[tuple[sp.Expr, ...], ...]


@record
class StableRange:
    """low < letter < high: all solutions decay there. `high` is infinity where there is no end; an end at which two
    exponents reach the imaginary axis together is one of `oscillating`.
    """

    letter: sp.Symbol
    low: sp.Expr
    high: sp.Expr
    oscillating: tuple[sp.Expr, ...]


def stable_ranges(*tables: Entries) -> tuple[StableRange, ...] | None:
    """The positive values of the only letter in M, D, K for which every solution decays; None where that is open."""
    rational = [sp.Matrix(t).applyfunc(_exact) for t in tables]
    letters = {s for t in rational for s in t.free_symbols}
    if len(letters) != 1:
        return None
    [letter] = letters
    p = sp.Dummy("p")
    mass, damping, stiffness = rational
    a = sp.Poly((mass * p**2 + damping * p + stiffness).det(method="berkowitz"), p).all_coeffs()
    if len(a) < 2 or a[-1] == 0:
        return ()
    try:
        ends = {x: n == 1 for n, e in enumerate((a[-1], _last_but_one(a), a[0])) for x in _positive_roots(e, letter)}
        ranges = [
            (low, high)
            for low, high in pairwise([sp.S.Zero, *sorted(ends), sp.oo])
            if _decays(a, letter, 2 * low + 1 if high is sp.oo else (low + high) / 2)
        ]
    except NoConvergence:
        return None
    return tuple(StableRange(letter, *f, tuple(x for x in f if ends.get(x))) for f in ranges)


def _exact(e: sp.Expr) -> sp.Expr:
    """With fractions for decimals."""
    return e.xreplace({x: sp.Rational(x) for x in e.atoms(sp.Float)})


def _last_but_one(a: list[sp.Expr]) -> sp.Expr:
    """Hurwitz' determinant of order n − 1."""
    n = len(a) - 1
    rows = [[a[2 * j - i + 1] if 0 <= 2 * j - i + 1 <= n else sp.S.Zero for j in range(n - 1)] for i in range(n - 1)]
    return sp.expand(sp.Matrix(rows).det(method="berkowitz")) if n > 1 else sp.S.One


def _positive_roots(e: sp.Expr, letter: sp.Symbol) -> Iterator[sp.Expr]:
    polynomial = sp.Poly(e, letter)
    if polynomial.is_zero:
        raise NoConvergence  # an exponent is on the axis for all values
    for root in sp.Poly(polynomial.sqf_part(), letter).nroots(n=2 * SHOWN_DIGITS, maxsteps=MOST_ROOT_STEPS):
        real, imaginary = root.as_real_imag()
        if abs(imaginary) < CLEARLY_REAL * abs(root) and real > 0:
            yield real


def _decays(a: list[sp.Expr], letter: sp.Symbol, value: sp.Expr) -> bool:
    """Whether all exponents have negative real parts at one value."""
    p = sp.Dummy("p")
    at = sp.Poly([c.subs(letter, value) for c in a], p)
    roots = at.nroots(n=SHOWN_DIGITS, maxsteps=MOST_ROOT_STEPS)
    return all(sp.re(r) < 0 for r in roots)
