"""One degree of freedom: a motion with a constant stiffness, a fast drive averaged, a length that changes slowly.

*Constant stiffness.* The general solution of q'' = k q + b is C_1 cosh √k t + C_2 sinh √k t − b/k for k > 0.

*Fast drive.* Let q'' = f(q) + a Ω² (γ(q) cos Ωt + σ(q) sin Ωt), where f, γ and σ contain neither a nor Ω. For Ω → ∞
with a Ω constant the motion is a slow one with a small ripple, −a (γ cos Ωt + σ sin Ωt), and to leading order the mean
over one period of the drive satisfies

    q'' = f − ¼ a² Ω² d/dq (γ² + σ²) .

Where f and that derivative vanish together, the mean motion can rest; it is stable there if the right side falls.
Reference: Landau and Lifshitz, Mechanics, section 30; Arnold, Mathematical Methods of Classical Mechanics, section 25.

*Slow change.* Near a rest q_0 that does not depend on a prescribed l(t), let m ξ'' + d ξ' + k ξ = 0 with d = l' b(l) m
and, up to rates of l, the stiffness k at a fixed l. If l changes little during one period, ξ = A cos(phase) with
A² exp(∫ b dl) √(k/m) constant, to leading order (Liouville and Green; the adiabatic invariant). With b = n/l and
k/m ∝ l^p the amplitude A is proportional to l^(−n/2 − p/4).
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, partial, prime, t
from lagrange.mechanics.consequences.oscillations import between_positive_sums
from lagrange.mechanics.limits import LONGEST_CONSEQUENCE, LONGEST_WITH_LIMITS
from lagrange.mechanics.results import InCoordinates

_UNDEFINED = (sp.zoo, sp.nan, sp.oo, -sp.oo)


@record
class AtRestOnAverage:
    """A place where the mean motion can rest. stable  as an inequality between positive sums; or a verdict."""

    place: sp.Expr
    without_drive: bool
    more: sp.Expr
    less: sp.Expr


@record
class FastDrive:
    """The mean motion under a fast drive.

    mean       the acceleration q'' of the mean motion
    changed    where the drive changes whether a rest is stable; `more > less` is the condition for the change
    """

    coordinate: sp.Symbol
    amplitude: sp.Symbol
    frequency: sp.Symbol
    mean: sp.Expr
    changed: tuple[AtRestOnAverage, ...]


@record
class SlowChange:
    """The amplitude of small motions about `place` is proportional to length**exponent if `length` changes slowly."""

    coordinate: sp.Symbol
    place: sp.Expr
    length: sp.Symbol
    exponent: sp.Expr


@record
class UniformStiffness:
    """The general motion; `first` and `second` are the functions of time that its two constants multiply."""

    coordinate: sp.Symbol
    first: sp.Expr
    second: sp.Expr
    rest: sp.Expr


def uniform_stiffness(view: InCoordinates) -> UniformStiffness | None:
    """The general solution, where it grows; of oscillations the period is said."""
    value = _acceleration(view)
    slots = view.configuration.slots
    if value is None or slots.prescribed or value.free_symbols & {*slots.velocities, t}:
        return None
    [q] = slots.coordinates
    k = value.diff(q)
    if not k.is_positive or k.has(q):
        return None
    rate = sp.sqrt(sp.factor(k))
    rest = textbook_form(-value.xreplace({q: sp.S.Zero}) / k)
    return UniformStiffness(q, sp.cosh(rate * t), sp.sinh(rate * t), rest)


def _acceleration(view: InCoordinates) -> sp.Expr | None:
    """q'' as a function of the state and the time, for one coordinate and a short equation."""
    motion, slots = view.motion, view.configuration.slots
    if motion is None or len(slots.coordinates) != 1 or len(motion.final) != 1 or view.signs or motion.completing:
        return None
    equation = motion.final[0].expression
    if equation.has(Unspecified) or count_operations(equation) > LONGEST_WITH_LIMITS:
        return None
    [acceleration] = slots.accelerations
    inertia = partial(equation, acceleration)
    rest = equation.xreplace({acceleration: sp.S.Zero})
    if is_zero(inertia) is not False or inertia.has(acceleration):
        return None
    value: sp.Expr = sp.expand(-rest / inertia)
    return None if value.has(*_UNDEFINED) else value


def fast_drive(view: InCoordinates) -> FastDrive | None:
    """The mean motion, if the drive has one amplitude and one frequency, and occurs with the square of it."""
    value = _acceleration(view)
    slots = view.configuration.slots
    if value is None or not value.has(t) or slots.prescribed or value.free_symbols & {*slots.velocities}:
        return None
    [q] = slots.coordinates
    waves = [w for w in value.atoms(sp.sin, sp.cos) if w.has(t)]
    [frequency, *others] = {w.args[0] / t for w in waves} or {sp.S.Zero}
    if others or not isinstance(frequency, sp.Symbol) or not frequency.is_positive or frequency == q:
        return None
    cosine, sine = sp.cos(frequency * t), sp.sin(frequency * t)
    slow = value.xreplace({cosine: sp.S.Zero, sine: sp.S.Zero})
    shares = [value.coeff(w) for w in (cosine, sine)]
    if slow.has(frequency) or any(s.has(t) for s in (slow, *shares)) or is_zero(
        value - slow - shares[0] * cosine - shares[1] * sine
    ) is not True:  # fmt: skip
        return None
    for amplitude in sorted(value.free_symbols - {q, frequency, t}, key=str):
        forms = [sp.expand(s / (amplitude * frequency**2)) for s in shares]
        if amplitude.is_positive and not any(f.has(amplitude, frequency) for f in (slow, *forms)):
            square = sp.expand(sum(f**2 for f in forms))
            ripple = -(amplitude**2) * frequency**2 * square.diff(q) / 4
            mean = textbook_form(slow + ripple)
            if ripple == 0 or count_operations(mean) > LONGEST_CONSEQUENCE:
                return None
            return FastDrive(q, amplitude, frequency, mean, tuple(_changed(q, slow, ripple)))
    return None


def _changed(q: sp.Symbol, slow: sp.Expr, ripple: sp.Expr) -> Iterator[AtRestOnAverage]:
    """The rests whose stability a large drive changes, where the sign of each slope is known."""
    for place in _places(q, slow, ripple):
        own, added = (e.diff(q).xreplace({q: place}) for e in (slow, ripple))
        if not ((own.is_positive and added.is_negative) or (own.is_negative and added.is_positive)):
            continue
        sides = between_positive_sums(own + added if added.is_positive else -own - added)
        if sides is not None:
            yield AtRestOnAverage(place, bool(own.is_negative), *sides)


def _places(q: sp.Symbol, *forces: sp.Expr) -> Iterator[sp.Expr]:
    """Those of 0 and π at which all of these vanish; π only for an angle."""
    angle = any(q in w.free_symbols for e in forces for w in e.atoms(sp.sin, sp.cos))
    for place in (sp.S.Zero, sp.pi) if angle else (sp.S.Zero,):
        values = [e.xreplace({q: place}) for e in forces]
        if not any(v.has(*_UNDEFINED) for v in values) and all(is_zero(v) is True for v in values):
            yield place


def slow_change(view: InCoordinates) -> SlowChange | None:
    """The first stable rest with a power of a prescribed function of time."""
    value = _acceleration(view)
    slots = view.configuration.slots
    if value is None or value.has(t) or not slots.prescribed:
        return None
    [q], [v] = slots.coordinates, slots.velocities
    lengths = [s for s in sorted(value.free_symbols, key=str) if prime(s) in value.free_symbols and s != q]
    if len(lengths) != 1:
        return None
    [length] = lengths
    rates = {prime(length): sp.S.Zero, prime(length, 2): sp.S.Zero}
    for place in _places(q, value.xreplace({**rates, v: sp.S.Zero})):
        rest = {q: place, v: sp.S.Zero}
        if is_zero(value.xreplace(rest)) is not True:
            continue  # a change of the length moves the place itself
        stiffness = -partial(value, q).xreplace({**rest, **rates})
        damping = -partial(value, v).xreplace(rest)
        powers = [
            sp.cancel(length * damping / prime(length)),
            sp.cancel(length * stiffness.diff(length) / stiffness) if stiffness != 0 else sp.nan,
        ]
        positive = stiffness.xreplace({length: sp.Dummy(positive=True)}).is_positive
        if positive and all(p.is_Rational for p in powers):
            n, p = powers
            return SlowChange(q, place, length, -n / 2 - p / 4)
    return None
