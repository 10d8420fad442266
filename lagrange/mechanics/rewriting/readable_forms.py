"""Expressions as a reader sees them: which are the same, long roots by letters, numbers for a calculator.

Whether two expressions are the same to a reader: equal when multiplied out, without anything else being used.

What is decided here chooses what a page repeats, not what is true; `is_zero` in `algebra/exact` decides that.

Long roots by letters: with d = √(a² + 2a l (sin θ₂ − sin θ₁) + ...) the force of a spring is c (d − a).

Numbers for a pocket calculator as a reader sees them: only the relevant ones, angles within a turn, short terms.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from lagrange.algebra.closed_forms.shortest_form import in_sines
from lagrange.algebra.exact.zero_test import kept_surface
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Slots, Unspecified, base, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.limits import LONGEST_RATIO, LONGEST_SOLVED, LONGEST_SPOT_FORMULA
from lagrange.mechanics.results import InCoordinates

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.linearization import Linearization


def is_same(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether the difference vanishes when it is multiplied out; that of different letters never does here."""
    return bool(a == b or (a.free_symbols == b.free_symbols and sp.expand(a - b) == 0))


def multiplied_out(v: Vector) -> tuple[sp.Expr, ...]:
    """The components along i, j, k, multiplied out: equal for vectors that a reader sees are equal."""
    return tuple(sp.expand(c) for c in v.fixed().components)


def are_same_equations(left: Sequence[tuple[sp.Expr, ...]], right: Sequence[sp.Expr]) -> bool:
    """Whether each equation a = b of the left is one of e = 0 of the right, or a constant times it."""
    differences, expressions = [in_sines(a - b) for a, b, *_ in left], [in_sines(e) for e in right]
    return all(any(_is_multiple(d, e) for e in expressions) for d in differences)


def _is_multiple(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether the first is the second, or −1, ½ or another constant times it: R times it."""
    if is_same(a, b) or is_same(a, -b):
        return True
    if (
        any(not s.is_positive for s in a.free_symbols ^ b.free_symbols)
        or b == 0
        or count_operations(a) + count_operations(b) > LONGEST_RATIO
    ):
        return False
    ratio = sp.cancel(a / b)
    return ratio.is_nonzero is True and all(s.is_positive for s in ratio.free_symbols)


def are_same_formulas(a: sp.Expr, b: sp.Expr, rule: dict[sp.Symbol, sp.Expr]) -> bool:
    """Whether the first is the second written otherwise, or with other names: r for R."""
    if a.free_symbols == b.free_symbols and sp.cancel(a - b) == 0:
        return True
    return is_same(a.xreplace(rule), b) and count_operations(a) == count_operations(b)


def has_plain_accelerations(value: Vector, slots: Slots) -> bool:
    """Whether the components are sums of accelerations of coordinates with constant coefficients."""
    terms = [a for c in value.components for a in sp.Add.make_args(sp.expand(c)) if a != 0]
    moving = {*slots.coordinates, *slots.velocities, *slots.prescribed, *slots.accelerations, t}
    return all(len(a.free_symbols & moving) == 1 and a.free_symbols & {*slots.accelerations} for a in terms)


def is_linear(linearization: Linearization) -> bool:
    """Whether the equations of motion are linear with constant coefficients, without anything being neglected."""
    expressions = linearization.motion.expressions
    symbols = {s for e in expressions for s in e.free_symbols}
    moving = {*linearization.configuration.slots.coordinates, *(s for s in symbols if base(s) != s)}  # cyclic ones, too
    if linearization.configuration.rows or any(e.has(Unspecified, sp.sign, sp.Abs, t) for e in expressions):
        return False
    return all(not e.diff(x).free_symbols & moving for e in expressions for x in moving)


def divisors(values: Sequence[sp.Expr]) -> set[sp.Expr]:
    """What the values divide by: the bases of the factors of their denominators."""
    below = (sp.factor(sp.fraction(sp.together(v))[1]) for v in values)
    return {f.as_base_exp()[0] for d in below for f in sp.Mul.make_args(d)}


# Root letters


FACTORS = tuple(sp.Rational(n) for n in ("1", "2", "4", "8", "1/2", "1/4", "1/8"))
"""By which radicands may differ where common factors have been divided out."""


def is_root_of(value: sp.Expr, radicand: sp.Expr) -> bool:
    """Whether the square of a value is the radicand, in whatever form."""
    return kept_surface().is_zero(value**2 - radicand) is True


def roots_by_letters(e: sp.Expr, lengths: Mapping[sp.Expr, sp.Symbol]) -> sp.Expr:
    """The expression with letters for the roots of these radicands."""
    powers = [p for p in e.atoms(sp.Pow) if p.exp.is_Rational and p.base.is_Add]
    powers = [p for p in powers if p.exp.q == 2 or p.exp == -1]  # √(...), and what the force of a damper divides by
    return e.xreplace({p: new for p in powers if (new := _by_letter(p, lengths)) is not None})


def _by_letter(power: sp.Pow, lengths: Mapping[sp.Expr, sp.Symbol]) -> sp.Expr | None:
    """A power of d for the root itself, and √2 d for that of twice the radicand."""
    for radicand, letter in lengths.items():
        if power.base.free_symbols != radicand.free_symbols:
            continue
        for factor in FACTORS:
            if power.base == radicand or sp.expand(power.base - factor * radicand) == 0:
                times = sp.S.One if power.base == radicand else factor
                return sp.Pow(times, power.exp) * letter ** (2 * power.exp)
    return None


# Spot formulas


def values_that_matter(view: InCoordinates, values: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """The values without coordinates that occur in no equation, with angles between −π and π."""
    equations = _equations(view)
    coordinates = {*view.configuration.slots.coordinates}
    used = {s: e for s, e in values.items() if s not in coordinates or any(a.has(s) for a in equations)}
    far = {s: e for s, e in used.items() if s in coordinates and e.is_number and not abs(e) < 3}
    if not far:
        return used
    plain = [e.replace(lambda x: isinstance(x, TrigonometricFunction), lambda _: sp.Dummy()) for e in equations]
    turns = {s: sp.floor((e + sp.pi) / (2 * sp.pi)) for s, e in far.items() if not any(p.has(s) for p in plain)}
    return {s: sp.N(e - 2 * sp.pi * turns[s], 6) if turns.get(s) else e for s, e in used.items()}


def _equations(view: InCoordinates) -> list[sp.Expr]:
    """What the accelerations follow from."""
    rows = view.configuration.rows
    equations = [] if view.motion is None else [e.expression for e in view.motion.equations]
    equations += [e for r in rows for e in (*r.coefficients, r.drift, *([r.finite] if r.finite is not None else []))]
    return [*equations, *(r.nonlinear for r in rows if r.nonlinear is not None)]


def acceleration_formula(view: InCoordinates, acceleration: sp.Symbol) -> sp.Expr | None:
    """The acceleration as a formula, where there is only one and it is short."""
    if view.motion is None or len(view.motion.equations) != 1 or view.configuration.rows:
        return None
    equation = view.motion.equations[0].expression
    if count_operations(equation) > LONGEST_SOLVED:
        return None
    factor = equation.diff(acceleration)
    if factor == 0 or factor.has(acceleration):
        return None
    formula = textbook_form(-(equation - factor * acceleration).expand() / factor)
    return formula if count_operations(formula) <= LONGEST_SPOT_FORMULA and not formula.is_number else None
