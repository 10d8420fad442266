"""Two small oscillations that affect one another: beats of equal oscillators, and the resonance 2 : 1.

*Beats.* Two equal oscillators with a weak coupling c have the modes (1, 1) and (1, −1), with ω_1 and ω_2 equal at
c = 0. If one of them alone is displaced at first, ξ_1 = A cos(δt/2) cos(σt/2) and ξ_2 = ±A sin(δt/2) sin(σt/2), with
δ = ω_2 − ω_1 and σ = ω_1 + ω_2: the oscillation passes to the other and back with the frequency δ.

*Resonance 2 : 1.* If reversing b, with its velocity and acceleration, leaves the equation of a as it is and reverses
that of b, the linear equations are those of a and of b alone. In the second order b² and b'² drive a: with b = cos ωt
they contain cos 2ωt. If ω_a = 2 ω_b, this drive resonates, and the motions exchange their energy (Vitt and Gorelik
1933).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import partial, prime, t
from lagrange.mechanics.consequences.along import is_short
from lagrange.mechanics.consequences.limits import LONGEST_CONSEQUENCE
from lagrange.mechanics.results import InCoordinates

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations


@record
class Beats:
    """Two equal oscillators with a weak coupling, at one equilibrium.

    displacements  ξ_1 and ξ_2
    frequencies    ω_1 and ω_2, the lower one for a small coupling first, by their number among the frequencies
    coupling       the parameter that couples them
    difference     ω_2 − ω_1 to first order in it
    """

    displacements: tuple[sp.Symbol, sp.Symbol]
    frequencies: tuple[int, int]
    coupling: sp.Symbol
    difference: sp.Expr


def beats(linear: Linearization | None, parameters: tuple[sp.Symbol, ...]) -> Beats | None:
    """The beats about the first stable equilibrium that has any."""
    for at in () if linear is None else linear.originals:
        if linear is not None and len(at.free) == 2 and at.oscillates and _are_equal(at):
            for c in parameters:
                found = _weakly_coupled(at, c, linear)
                if found is not None:
                    return found
    return None


def _are_equal(at: SmallOscillations) -> bool:
    m, k, d = at.system.mass, at.system.stiffness, at.system.damping
    free = not any(e for row in d for e in row)
    return free and is_zero(m[0][0] - m[1][1]) is True and is_zero(k[0][0] - k[1][1]) is True


def _weakly_coupled(at: SmallOscillations, c: sp.Symbol, linear: Linearization) -> Beats | None:
    squares = [f.square for f in at.frequencies]
    matrices = [at.system.mass, at.system.stiffness]
    if (
        len(squares) != 2
        or not c.is_positive
        or any(s is None or (not s.has(c) and len({*squares}) < 2) for s in squares)
    ):
        return None
    zero = {c: sp.S.Zero}
    if any(m[0][1].has(sp.zoo) or is_zero(m[0][1].xreplace(zero)) is not True for m in matrices):
        return None
    if all(is_zero(m[0][1]) is True for m in matrices):
        return None
    first, second = (s for s in squares if s is not None)
    own = first.xreplace(zero)
    if own.has(sp.zoo, sp.nan) or not own.is_positive or is_zero(own - second.xreplace(zero)) is not True:
        return None
    slope = textbook_form(sp.cancel((second - first).diff(c).xreplace(zero)))
    if slope.has(sp.zoo, sp.nan) or not (slope.is_positive or slope.is_negative):
        return None
    order = (0, 1) if slope.is_positive else (1, 0)
    difference = sp.powdenest(c * abs(slope) / (2 * sp.sqrt(own)), force=True)
    if count_operations(difference) > LONGEST_CONSEQUENCE:
        return None
    moved = (linear.displacements[at.free[0]], linear.displacements[at.free[1]])
    return Beats(moved, order, c, difference)


@record
class DoubleResonance:
    """Small motions of a and b by themselves, with the squares of their frequencies, and where ω_a = 2 ω_b.

    driven, driving  a and b
    rest             the values of a and b about which they move
    squares          ω_a² and ω_b²
    condition        the sides of an equation between parameters
    """

    driven: sp.Symbol
    driving: sp.Symbol
    rest: Mapping[sp.Symbol, sp.Expr]
    squares: tuple[sp.Expr, sp.Expr]
    condition: tuple[sp.Expr, sp.Expr]


def double_resonance(view: InCoordinates) -> DoubleResonance | None:
    """The resonance of two coordinates that nothing constrains, about the rest of a with b = 0."""
    motion, slots = view.motion, view.configuration.slots
    if motion is None or view.configuration.rows or len(slots.coordinates) != 2 or view.signs or slots.prescribed:
        return None
    if len(motion.final) != 2 or not is_short(motion) or any(e.expression.has(t) for e in motion.final):
        return None
    for a, b in (slots.coordinates, slots.coordinates[::-1]):
        found = _resonance(view, a, b)
        if found is not None:
            return found
    return None


def _resonance(view: InCoordinates, a: sp.Symbol, b: sp.Symbol) -> DoubleResonance | None:
    assert view.motion is not None
    slots = view.configuration.slots
    equations = [e.expression for e in view.motion.final]
    reversing = {s: -s for s in (b, prime(b), prime(b, 2))}
    own = [e for e in equations if is_zero(e.xreplace(reversing) - e) is True]
    other = [e for e in equations if is_zero(e.xreplace(reversing) + e) is True]
    if len(own) != 1 or len(other) != 1:
        return None
    of_a, of_b = own[0], other[0]
    still = dict.fromkeys((*slots.velocities, *slots.accelerations, b), sp.S.Zero)
    at_rest = sp.expand(of_a.xreplace(still))
    slope = at_rest.diff(a)
    if is_zero(slope) is not False or slope.has(a) or at_rest.free_symbols & {*slots.prescribed}:
        return None
    value = sp.cancel(-at_rest.xreplace({a: sp.S.Zero}) / slope)
    rest = {**still, a: value}
    squares = []
    for e, q in ((of_a, a), (of_b, b)):
        linear = [partial(e, s).xreplace(rest) for s in (q, prime(q), prime(q, 2))]
        if (
            any(x.has(sp.zoo, sp.nan) for x in linear)
            or is_zero(linear[1]) is not True
            or is_zero(linear[2]) is not False
        ):
            return None
        squares.append(sp.cancel(linear[0] / linear[2]))
    if not all(s.is_positive for s in squares) or not _drives(of_a, b, rest, squares[1]):
        return None
    condition = _condition(squares[0] - 4 * squares[1])
    if condition is None:
        return None
    return DoubleResonance(a, b, {a: textbook_form(value), b: sp.S.Zero}, (squares[0], squares[1]), condition)


def _drives(e: sp.Expr, b: sp.Symbol, rest: Mapping[sp.Symbol, sp.Expr], square: sp.Expr) -> bool:
    """Whether the part of the equation that is of second order in b has an amplitude of cos 2ωt for b = cos ωt.

    There 2 b² has the amplitude 1, and 2 b'² and 2 b b'' have −ω².
    """
    v, a = prime(b), prime(b, 2)
    second = [partial(partial(e, x), y).xreplace(dict(rest)) for x, y in ((b, b), (v, v), (b, a))]
    amplitude = second[0] / 4 - square * second[1] / 4 - square * second[2] / 2
    return is_zero(amplitude) is False


def _condition(difference: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """The difference = 0 as an equation between two sums of positive terms; None where it has no solution."""
    numerator = sp.factor_terms(sp.numer(sp.together(difference)))
    sums = [f for f in sp.Mul.make_args(sp.factor(numerator)) if isinstance(f, sp.Add)]
    if len(sums) != 1 or any(not f.is_nonzero for f in sp.Mul.make_args(sp.factor(numerator)) if f not in sums):
        return None
    terms = sp.Add.make_args(sp.expand(sums[0]))
    left, right = [x for x in terms if x.is_positive], [-x for x in terms if x.is_negative]
    if not left or not right or len(left) + len(right) != len(terms) or count_operations(sums[0]) > LONGEST_CONSEQUENCE:
        return None
    return sp.Add(*left), sp.Add(*right)
