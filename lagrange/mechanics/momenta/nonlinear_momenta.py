"""Momenta that contain a root of a function of the velocities: p = m v/√(1 − v²/c²) of a fast particle.

Where all momenta contain one root only, S = √B(q, q'), they are linear in the velocities except for S,

    p_k − b_k = Σ m_kj(q, S) q_j' ,     which gives     q' = M(q, S)⁻¹ (p − b) .

With these velocities S² = B is an equation for S² alone. Where that is linear, a S² + c = 0, the velocities follow in
closed form, S = √(−c/a) being positive: of the fast particle S = m c/√(m² c² + p²). Reference: Goldstein, § 8.4.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.core.operations import count_operations
from lagrange.core.symbols import partial
from lagrange.mechanics.limits import LONGEST_NONLINEAR


def velocities_by_root(
    lagrangian: sp.Expr,
    stated: Sequence[sp.Expr],
    velocities: Sequence[sp.Symbol],
    momenta: Sequence[sp.Symbol],
    surface: Surface,
) -> tuple[tuple[sp.Expr, ...], sp.Expr] | None:
    """The velocities in terms of the momenta, and Σ p_k q_k' − L; None where they are not found.

    stated  shape (n,): ∂L/∂q_k'
    """
    moving = {*velocities}
    powers = {p for e in (lagrangian, *stated) for p in e.atoms(sp.Pow) if _is_root(p) and p.base.free_symbols & moving}
    if not powers or count_operations(lagrangian) > LONGEST_NONLINEAR:
        return None
    base, S = min((p.base for p in powers), key=count_operations), sp.Dummy("S", positive=True)
    shares = {p: sp.cancel(p.base / base) for p in powers}  # c² of c² − v² to 1 − v²/c²
    if any(not e.is_positive or e.free_symbols & moving for e in shares.values()):
        return None
    with_letter = {p: e**p.exp * S ** (2 * p.exp) for p, e in shares.items()}
    written = [sp.expand(e.xreplace(with_letter)) for e in stated]
    mass = [[partial(e, v) for v in velocities] for e in written]
    if any(e.free_symbols & moving for row in mass for e in row) or not base.is_polynomial(*velocities):
        return None
    still = dict.fromkeys(velocities, sp.S.Zero)
    shifts = [e.xreplace(still) for e in written]
    moved = [sp.Dummy(p.name, real=True) if b != 0 else p for p, b in zip(momenta, shifts, strict=True)]  # p − b
    meant = {u: p - b for u, p, b in zip(moved, momenta, shifts, strict=True) if u != p}
    solved = solved_linear(mass, moved, surface)
    if solved is None or any(e is None for e in solved):
        return None
    inverted = {v: e for v, e in zip(velocities, solved, strict=True) if e is not None}
    root = _root_of(base.xreplace(inverted) - S**2, S)
    if root is None:
        return None
    work = sp.Add(*((u + b if u in meant else u) * v for u, b, v in zip(moved, shifts, velocities, strict=True)))
    function = (work - lagrangian.xreplace(with_letter)).xreplace(inverted)
    in_momenta = [_with_root(e, S, root).xreplace(meant) for e in (*(inverted[v] for v in velocities), function)]
    return tuple(in_momenta[:-1]), in_momenta[-1]


def _is_root(p: sp.Expr) -> bool:
    return bool(p.exp.is_Rational and p.exp.q == 2)


def _root_of(equation: sp.Expr, S: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """a and b with S² = a/b, from an equation that is linear in S²."""
    above = sp.fraction(sp.cancel(sp.together(equation)))[0]
    if not above.is_polynomial(S) or count_operations(above) > LONGEST_NONLINEAR:
        return None
    terms: Mapping[tuple[int, ...], sp.Expr] = sp.Poly(above, S).as_dict()
    degrees = sorted(k for (k,) in terms)
    if len(degrees) != 2 or degrees[1] - degrees[0] != 2:
        return None
    a, b = sp.fraction(sp.factor(-terms[(degrees[0],)] / terms[(degrees[1],)]))
    if a.could_extract_minus_sign() and b.could_extract_minus_sign():
        a, b = -a, -b
    squares = sp.Mul(*(f for f in sp.Mul.make_args(a) if f.is_Pow and f.exp == 2 and not f.base.is_positive))
    return a / squares, sp.expand(b / squares)  # p_r² + p_φ²/r² + m² c² instead of this times r²


def _with_root(e: sp.Expr, S: sp.Symbol, root: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
    """An expression with S = √(a/b): what is even in S, and what is odd, where b cancels if it can."""
    a, b = root
    even, odd = sp.S.Zero, sp.S.Zero
    for power, coefficient in sp.collect(sp.expand(e), S, evaluate=False).items():
        n = int(sp.degree(power, S)) if power.is_polynomial(S) else -int(sp.degree(1 / power, S))
        if n % 2:
            odd += coefficient * (a / b) ** ((n - 1) // 2)
        else:
            even += coefficient * (a / b) ** (n // 2)
    factor = sp.factor(sp.cancel(sp.together(odd)))
    without = sp.factor(sp.cancel(sp.together(odd / b)))
    shorter = count_operations(without) < count_operations(factor)
    return sp.Add(without * sp.sqrt(a) * sp.sqrt(b) if shorter else factor * sp.sqrt(a) / sp.sqrt(b), even)
