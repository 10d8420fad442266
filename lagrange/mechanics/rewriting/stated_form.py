"""Equations of motion in the form of the file's answers, where each of these is a multiple of one of them.

A stated S = 0 has the accelerations of an equation of motion E = 0 times c, with S = c E exactly. c must not vanish, or
only where the equation has been divided by what vanishes there; the factor f of E that was divided out becomes f/c, and
a multiplier ν in a conserved quantity, d/dt(...) = ν E, becomes ν/c. So everything that is said of the equations holds
for the stated ones. For (1 + sin²s) s'' + ... of the lemniscate c = 1 + sin²s.

Likewise equations in which the rates of a rolling wheel are substituted at once, θ'' = x''/R: they are the equations
before the substitution divided by a factor, and what is a multiple ν of these is one of the others.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.terms import CommonFactor
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Unspecified, never_vanishes, partial
from lagrange.mechanics.dynamics.conservation import Integral
from lagrange.mechanics.dynamics.equations import EquationOfMotion
from lagrange.mechanics.limits import LONGEST_AT_ONCE, LONGEST_COMBINED
from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.rewriting.quasi_velocities import StatedEquations


def in_stated_form(view: InCoordinates, stated: StatedEquations) -> InCoordinates | None:
    """The view with the stated equations as its equations of motion; None if they are not multiples one by one."""
    motion, dynamics = view.motion, view.dynamics
    if motion is None or dynamics is None or len(stated) != len(motion.final) or any(len(s) != 2 for s in stated):
        return None
    every = [*(e.expression for e in motion.final), *(side for sides in stated for side in sides)]
    if sum(map(count_operations, every)) > LONGEST_COMBINED or any(e.has(Unspecified) for e in every):
        return None
    found = [_restated(e, stated, view) for e in motion.final]
    if any(f is None for f in found):
        return None
    pairs = [f for f in found if f is not None]
    equations = tuple(e for e, _ in pairs)
    if len({e.written for e in equations}) < len(equations):
        return None
    if view.linearization is not None and not all(c.is_number for _, c in pairs):
        return None  # small motions refer to the equations as they are
    if motion.closed is not None:
        restated = replace(motion, closed=replace(motion.closed, equations=equations))
        return replace(view, dynamics=replace(dynamics, equations=restated))
    restated = replace(motion, equations=equations)
    return _with_multipliers(replace(view, dynamics=replace(dynamics, equations=restated)), [c for _, c in pairs])


def _restated(
    e: EquationOfMotion, stated: StatedEquations, view: InCoordinates
) -> tuple[EquationOfMotion, sp.Expr] | None:
    """The equation as one of the stated ones, and c."""
    accelerations = [a for a in view.configuration.slots.accelerations if partial(e.expression, a) != 0]
    for left, right in stated if accelerations else ():
        difference = left - right
        ratio = textbook_form(partial(difference, accelerations[0]) / partial(e.expression, accelerations[0]))
        c = sp.factor(ratio) if ratio.is_Add else ratio
        if c == 0 or is_zero(difference - c * e.expression) is not True:
            continue
        number, powers = _taken_apart(c)
        factors = dict(e.factor.powers)
        if any(not never_vanishes(f) and f not in factors for f in powers):
            return None
        left_over = {f: factors.get(f, 0) - powers.get(f, 0) for f in (*factors, *powers)}
        factor = CommonFactor(e.factor.number / abs(number), tuple((f, n) for f, n in left_over.items() if n != 0))
        reversed_ = e.reversed is bool(number > 0)
        return EquationOfMotion(e.coordinate, difference, factor, reversed_, (left, right)), c
    return None


def _taken_apart(c: sp.Expr) -> tuple[sp.Rational, dict[sp.Expr, Fraction]]:
    """The number and the powers of the factors of c."""
    number, rest = c.as_coeff_Mul()
    pairs = [f.as_base_exp() if f.as_base_exp()[1].is_Rational else (f, sp.S.One) for f in sp.Mul.make_args(rest)]
    return number, {base: Fraction(int(n.p), int(n.q)) for base, n in pairs if base != 1}


def _with_multipliers(view: InCoordinates, ratios: Sequence[sp.Expr]) -> InCoordinates:
    if view.conserved is None or view.motion is None:
        return view
    integrals = tuple(
        replace(i, multipliers=tuple(textbook_form(m / c) for m, c in zip(i.multipliers, ratios, strict=True)))
        if i.multipliers
        else i
        for i in view.conserved.integrals
    )
    return replace(view, conserved=replace(view.conserved, motion=view.motion, integrals=integrals))


def substituted_at_once(view: InCoordinates) -> InCoordinates | None:
    """The view in which short rates are put into the principle; None where there are none."""
    motion, dynamics = view.motion, view.dynamics
    if motion is None or dynamics is None or motion.closed is None or view.is_own:
        return None
    closed = motion.closed
    pairs = [*zip(motion.equations, closed.equations, strict=False)]
    rates = sum(count_operations(e) for e in closed.rates.values())
    if len(closed.equations) != len(motion.equations) or rates > LONGEST_AT_ONCE or len(closed.velocities) > 1:
        return None
    merged = tuple(_merged(e, after) for e, after in pairs)
    if any(is_zero(_coefficient(e).xreplace(dict(closed.rates)) - _coefficient(m)) is not True
           for (e, _), m in zip(pairs, merged, strict=True)):  # fmt: skip
        return None
    restated = replace(motion, closed=replace(closed, equations=merged, at_once=True))
    changed = replace(view, dynamics=replace(dynamics, equations=restated))
    if view.conserved is None:
        return changed
    integrals = tuple(_of_closed(i, pairs, closed.velocities) for i in view.conserved.integrals)
    return replace(changed, conserved=replace(view.conserved, motion=restated, integrals=integrals))


def _coefficient(e: EquationOfMotion) -> sp.Expr:
    """The coefficient of the virtual displacement."""
    return e.expression * e.factor.expression * (-1 if e.reversed else 1)


def _merged(e: EquationOfMotion, after: EquationOfMotion) -> EquationOfMotion:
    """The second equation with what both have been divided by."""
    powers = dict(e.factor.powers)
    for f, n in after.factor.powers:
        powers[f] = powers.get(f, 0) + n
    factor = CommonFactor(e.factor.number * after.factor.number, tuple((f, n) for f, n in powers.items() if n != 0))
    return replace(after, factor=factor, reversed=e.reversed is not after.reversed)


def _of_closed(
    integral: Integral, pairs: Sequence[tuple[EquationOfMotion, EquationOfMotion]], rates: Mapping[sp.Symbol, sp.Expr]
) -> Integral:
    """The integral as a sum of multiples of the equations after the substitution."""
    multipliers = tuple(
        textbook_form(m.xreplace(dict(rates)) * after.factor.expression * (-1 if after.reversed else 1))
        for m, (_, after) in zip(integral.multipliers, pairs, strict=False)
    )
    return replace(integral, multipliers=multipliers)
