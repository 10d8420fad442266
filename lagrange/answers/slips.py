"""The slips that people make in a term of an equation, and the terms that may have been meant.

A wrong sign or a wrong factor need not be guessed: its value follows from the residues (`diagnosis`), and is looked up
among simple `factors` made of numbers, parameters, coordinates, velocities, sines and cosines. Other slips change the
term itself, and its `variants` are tried one by one: cos for sin, an angle for its sine, a dot too few, another
coordinate, another parameter, a sum for a difference of angles.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from enum import Enum, auto
from functools import lru_cache
from itertools import combinations

import sympy as sp

from lagrange.answers.limits import (
    MAX_CLEARED_SIZE,
    MAX_FACTOR_ANGLES,
    MAX_FACTOR_COORDINATES,
    MAX_FACTOR_LENGTHS,
    MAX_FACTOR_PARAMETERS,
    MAX_TERMS,
)
from lagrange.core.expression_size import Sizes, count_operations
from lagrange.core.symbols import Slots, base, prime

NUMBERS = tuple(
    sp.Rational(p, q)
    for p, q in ((-1, 1), (2, 1), (1, 2), (-2, 1), (-1, 2), (3, 1), (1, 3), (4, 1), (1, 4), (3, 2), (2, 3), (3, 4),
                 (4, 3), (-3, 1), (-1, 3), (-4, 1), (-1, 4), (-3, 2), (-2, 3))
)  # fmt: skip

_SWAPPED: dict[type, type] = {sp.sin: sp.cos, sp.cos: sp.sin}


class Slip(Enum):
    """A slip in a term of an equation."""

    SIGN = auto()  # of a term
    FACTOR = auto()  # of a term
    INVERTED = auto()  # l/g for g/l
    POWER = auto()  # of a velocity or coordinate: θ' for θ'²
    MISSING = auto()  # a term
    EXTRA = auto()  # a term
    FUNCTION = auto()  # sin for cos
    SMALL_ANGLE = auto()  # θ for sin θ
    EXACT_ANGLE = auto()  # sin θ for θ
    ANGLE = auto()  # cos(a + b) for cos(a − b), sin 2θ for sin θ
    COORDINATE = auto()  # x for y
    PARAMETER = auto()  # m1 for m2
    DOT = auto()  # θ' for θ''
    NUMBER = auto()  # 9.81 for g, 0.33 for 1/3


@lru_cache(maxsize=512)
def terms_of(equation: sp.Expr) -> tuple[sp.Expr, ...] | None:
    """The terms of an equation, products of sums multiplied out; None if there are too many."""
    if Sizes().of(equation).terms > MAX_TERMS:
        parts = sp.Add.make_args(equation)
        return parts if len(parts) <= MAX_TERMS else None
    return tuple(sp.Add.make_args(sp.expand(equation, trig=False, power_exp=False, power_base=False, log=False)))


def cleared(equation: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """The equation multiplied by the sums that it is divided by, and these; None if it is divided by none."""
    if Sizes().of(equation).size > MAX_CLEARED_SIZE:
        return None
    numerator, denominator = sp.fraction(sp.together(equation))
    sums = [f for f in sp.Mul.make_args(denominator) if any(isinstance(a, sp.Add) for a in sp.preorder_traversal(f))]
    return (numerator, sp.Mul(*sums)) if sums else None


def variants(
    term: sp.Expr, slots: Slots, parameters: Sequence[sp.Symbol], angles: Sequence[sp.Expr]
) -> Iterator[tuple[Slip, sp.Expr]]:
    """The terms possibly intended, likeliest first; `angles` are those whose sines may occur in them."""
    seen = {term}
    for slip, variant in _all_variants(term, slots, parameters, angles):
        if variant not in seen and variant.is_finite is not False and not variant.has(sp.zoo, sp.nan):
            seen.add(variant)
            yield slip, variant


def _all_variants(
    term: sp.Expr, slots: Slots, parameters: Sequence[sp.Symbol], angles: Sequence[sp.Expr]
) -> Iterator[tuple[Slip, sp.Expr]]:
    waves = sorted(term.atoms(sp.sin, sp.cos, sp.tan), key=str)
    for wave in waves:
        if type(wave) in _SWAPPED:
            other = _SWAPPED[type(wave)](wave.args[0])
            yield Slip.FUNCTION, term.xreplace({wave: other})
            yield Slip.FUNCTION, term / wave * other
    if len(waves) > 1:
        flipped = {
            w: (sp.cos if isinstance(w, sp.sin) else sp.sin)(w.args[0]) for w in waves if not isinstance(w, sp.tan)
        }
        yield Slip.FUNCTION, term.xreplace(flipped)
    for wave in waves:
        for f in (sp.sin, sp.cos, sp.tan):
            if not isinstance(wave, f):
                yield Slip.FUNCTION, term.xreplace({wave: f(wave.args[0])})
    yield from _angles(term, waves, slots, angles)
    yield from _dots(term, slots)
    yield from _renamed(term, slots, parameters)


def _angles(
    term: sp.Expr, waves: Sequence[sp.Expr], slots: Slots, angles: Sequence[sp.Expr]
) -> Iterator[tuple[Slip, sp.Expr]]:
    factors_of_term = sp.Mul.make_args(term)
    for angle in angles:
        for f in (sp.sin, sp.tan):
            if angle in factors_of_term:
                yield Slip.SMALL_ANGLE, term / angle * f(angle)
            for q in (q for q in slots.coordinates if q in factors_of_term and q != angle):
                yield Slip.SMALL_ANGLE, term / q * f(angle)
        # Of a given angle, sin α and cos α are components: a factor, and no small angle.
        if not any(w.args[0] == angle for w in waves) and angle.free_symbols & {*slots.coordinates}:
            yield Slip.SMALL_ANGLE, term * sp.cos(angle)
    for wave in waves:
        angle = wave.args[0]
        yield Slip.EXACT_ANGLE, term.xreplace({wave: sp.S.One if isinstance(wave, sp.cos) else angle})
        for other in (2 * angle, angle / 2, *_other_sums(angle)):
            yield Slip.ANGLE, term.xreplace({wave: wave.func(other)})
        for q in sorted(angle.free_symbols & set(slots.coordinates), key=str):
            for p in slots.coordinates:
                if p != q and p not in angle.free_symbols:
                    yield Slip.ANGLE, term.xreplace({wave: wave.func(angle - p)})
                    yield Slip.ANGLE, term.xreplace({wave: wave.func(angle + p)})
            if angle != q:
                yield Slip.ANGLE, term.xreplace({wave: wave.func(q)})


def _other_sums(angle: sp.Expr) -> Iterator[sp.Expr]:
    """a + b for a − b."""
    parts = sp.Add.make_args(angle)
    for n, part in enumerate(parts if len(parts) > 1 else ()):
        if n:
            yield sp.Add(*parts[:n], -part, *parts[n + 1 :])


def _dots(term: sp.Expr, slots: Slots) -> Iterator[tuple[Slip, sp.Expr]]:
    """A derivative too many or too few, of one factor."""
    for factor in sp.Mul.make_args(term):
        s, n = factor.as_base_exp()
        if not isinstance(s, sp.Symbol) or base(s) not in slots.coordinates:
            continue
        q, order = base(s), len(s.name) - len(s.name.rstrip("'"))
        for other in range(3):
            if other != order:
                yield Slip.DOT, term / factor * prime(q, other) ** n if other else term / factor * q**n
        if n == 2:
            for p in slots.coordinates:
                if p != q and order:
                    yield Slip.COORDINATE, term / s * prime(p, order)


def _renamed(term: sp.Expr, slots: Slots, parameters: Sequence[sp.Symbol]) -> Iterator[tuple[Slip, sp.Expr]]:
    """One coordinate, or one parameter, replaced by another."""
    used = term.free_symbols
    for q, p in combinations(slots.coordinates, 2):
        forth = {s: prime(p, k) if k else p for k, s in enumerate((q, prime(q), prime(q, 2)))}
        back = {v: k for k, v in forth.items()}
        for rule in (forth, back, forth | back):
            if used & set(rule):
                yield Slip.COORDINATE, term.xreplace(rule)
        for k in range(3):
            a, b = (prime(s, k) if k else s for s in (q, p))
            for wrong, right in ((a, b), (b, a)):
                if wrong in used:
                    yield Slip.COORDINATE, term.xreplace({wrong: right})
    for a in (s for s in parameters if s in used):
        for b in parameters:
            if b != a:
                yield Slip.PARAMETER, term.xreplace({a: b})


def lengths_in(expressions: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """The square roots of sums in expressions, and magnitudes: distances and speeds."""
    roots = {
        sp.sqrt(p.base)
        for e in expressions
        for p in e.atoms(sp.Pow)
        if p.exp.is_Rational and p.exp.q == 2 and p.base.is_Add
    }
    sizes = {a for e in expressions for a in e.atoms(sp.Abs)}
    return tuple(sorted(roots | sizes, key=str)[:MAX_FACTOR_LENGTHS])


@lru_cache(maxsize=64)
def factors(
    parameters: Sequence[sp.Symbol], slots: Slots, angles: Sequence[sp.Expr], lengths: Sequence[sp.Expr] = ()
) -> tuple[sp.Expr, ...]:
    """The wrong factors that a term may have, up to a number, the simplest first.

    lengths  distances and speeds: roots and magnitudes
    """
    constants = list(parameters)[:MAX_FACTOR_PARAMETERS]
    simple: list[sp.Expr] = [sp.S.One]
    simple += [s**n for s in constants for n in (1, -1, 2, -2)]
    moving: list[sp.Expr] = []
    for q in slots.coordinates[:MAX_FACTOR_COORDINATES]:
        moving += [
            prime(q),
            1 / prime(q),
            q,
            1 / q,
            prime(q) ** 2,
            prime(q) ** -2,
            q**2,
            q**-2,
            prime(q, 2),
            1 / prime(q, 2),
        ]
    for angle in angles[:MAX_FACTOR_ANGLES]:
        sine, cosine = sp.sin(angle), sp.cos(angle)
        moving += [sine, 1 / sine, cosine, 1 / cosine, sine**2, cosine**2, sine / cosine, cosine / sine]
    simple += moving
    simple += [d**n for d in lengths for n in (1, -1, 2, -2)]
    simple += [a / b for a in constants for b in constants if a != b]
    simple += [a * b for a, b in combinations(constants, 2)] + [1 / (a * b) for a, b in combinations(constants, 2)]
    simple += [(a / b) ** n for a, b in combinations(constants, 2) for n in (2, -2)]
    simple += [a * b**2 for a in constants for b in constants if a != b]
    simple += [1 / (a * b**2) for a in constants for b in constants if a != b]
    simple += [a / b**2 for a in constants for b in constants if a != b]
    simple += [a**2 / b for a in constants for b in constants if a != b]
    simple += [a * f for a in constants for f in moving]
    simple += [f / a for a in constants for f in moving]
    return tuple(simple)


def is_decimal(term: sp.Expr) -> bool:
    """Whether the number in a term looks measured: 9.81, 0.33, 10."""
    number = term.as_coeff_Mul()[0]
    return bool(number.is_Rational) and (number.q >= 10 or abs(number.p) >= 10)


def kind_of_factor(term: sp.Expr, factor: sp.Expr, velocities: Sequence[sp.Symbol]) -> Slip:
    """The name of a wrong factor."""
    if factor == -1:
        return Slip.SIGN
    number, rest = factor.as_coeff_Mul()
    if is_decimal(term) and (rest != 1 or abs(abs(factor) - 1) < sp.Rational(1, 20)):
        return Slip.NUMBER
    root = sp.sqrt(rest)
    if number == 1 and count_operations(term * root) < count_operations(term) and _is_quotient(root):
        return Slip.INVERTED
    return Slip.POWER if rest.free_symbols & {*velocities} else Slip.FACTOR


def is_divided(e: sp.Expr) -> bool:
    """Whether a term is divided by a sum."""
    return any(f.is_Pow and f.exp.is_negative and f.base.is_Add for f in sp.Mul.make_args(e))


def _is_quotient(factor: sp.Expr) -> bool:
    return isinstance(factor, sp.Mul) and len(factor.args) == 2 and any(f.as_base_exp()[1] == -1 for f in factor.args)
