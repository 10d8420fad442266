"""Small oscillations that affect one another, and an axis that stands upright because it spins.

Two small oscillations that affect one another: beats of equal oscillators, and the resonance 2 : 1.

*Beats.* Two equal oscillators with a weak coupling c have the modes (1, 1) and (1, −1), with ω_1 and ω_2 equal at
c = 0. If one of them alone is displaced at first, ξ_1 = A cos(δt/2) cos(σt/2) and ξ_2 = ±A sin(δt/2) sin(σt/2), with
δ = ω_2 − ω_1 and σ = ω_1 + ω_2: the oscillation passes to the other and back with the frequency δ.

*Resonance 2 : 1.* If reversing b, with its velocity and acceleration, leaves the equation of a as it is and reverses
that of b, the linear equations are those of a and of b alone. In the second order b² and b'² drive a: with b = cos ωt
they contain cos 2ωt. If ω_a = 2 ω_b, this drive resonates, and the motions exchange their energy (Vitt and Gorelik
1933).

An axis that stands upright because it spins: the threshold of stability of tops, and of balls on balls.

Let e be a unit vector with the angle θ from k, turned about k by φ, and n = ω·e constant. If along every motion

    θ'' − φ'² sin θ cos θ = β sin θ − α n φ' sin θ ,      φ'' sin θ + 2 θ' φ' cos θ = α n θ' ,

with constants α and β, then for ζ = sin θ e^{iφ} to first order ζ'' = i α n ζ' + β ζ, although θ and φ have a pole at
θ = 0. With ζ ~ e^{iωt}, ω² − α n ω + β = 0: for β > 0 the upright axis is stable if α² n² > 4 β, and falls if it is
less. Nothing is said of motions that are not small.
Reference: Routh, Advanced Rigid Dynamics, on the stability of a sleeping top.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import Surface, is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import VectorSymbol, partial, prime, t
from lagrange.core.vectors import FIXED, Vector
from lagrange.mechanics.consequences.vectors import is_short, vanish_along
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.limits import LONGEST_CONSEQUENCE
from lagrange.mechanics.results import InCoordinates, Solution

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.rigid_bodies import Rotation
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
    squares          ω_a² and ω_b², with a for its value at rest where that is shorter
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
    squares, shown = [], []
    for e, q in ((of_a, a), (of_b, b)):
        anywhere = [partial(e, s).xreplace(still) for s in (q, prime(q), prime(q, 2))]
        linear = [x.xreplace({a: value}) for x in anywhere]
        if (
            any(x.has(sp.zoo, sp.nan) for x in linear)
            or is_zero(linear[1]) is not True
            or is_zero(linear[2]) is not False
        ):
            return None
        squares.append(sp.cancel(linear[0] / linear[2]))
        shown.append(min(squares[-1], sp.cancel(anywhere[0] / anywhere[2]), key=count_operations))
    if not all(s.is_positive for s in squares) or not _drives(of_a, b, rest, squares[1]):
        return None
    condition = between_positive_sums(squares[0] - 4 * squares[1])
    if condition is None:
        return None
    return DoubleResonance(a, b, {a: textbook_form(value), b: sp.S.Zero}, (shown[0], shown[1]), condition)


def _drives(e: sp.Expr, b: sp.Symbol, rest: Mapping[sp.Symbol, sp.Expr], square: sp.Expr) -> bool:
    """Whether the part of the equation that is of second order in b has an amplitude of cos 2ωt for b = cos ωt.

    There 2 b² has the amplitude 1, and 2 b'² and 2 b b'' have −ω².
    """
    v, a = prime(b), prime(b, 2)
    second = [partial(partial(e, x), y).xreplace(dict(rest)) for x, y in ((b, b), (v, v), (b, a))]
    amplitude = second[0] / 4 - square * second[1] / 4 - square * second[2] / 2
    return is_zero(amplitude) is False


def between_positive_sums(difference: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """The difference = 0 as an equation between two sums of positive terms; None if it has no solution."""
    numerator = sp.factor_terms(sp.numer(sp.together(difference)))
    sums = [f for f in sp.Mul.make_args(sp.factor(numerator)) if isinstance(f, sp.Add)]
    if len(sums) != 1 or any(not f.is_nonzero for f in sp.Mul.make_args(sp.factor(numerator)) if f not in sums):
        return None
    terms = sp.Add.make_args(sp.expand(sums[0]))
    left, right = [x for x in terms if x.is_positive], [-x for x in terms if x.is_negative]
    if not left or not right or len(left) + len(right) != len(terms) or count_operations(sums[0]) > LONGEST_CONSEQUENCE:
        return None
    return sp.Add(*left), sp.Add(*right)


# Sleeping


@record
class SleepingAxis:
    """The upright axis is stable if more > less, both without denominators; `spin` is n in them.

    body   whose spin it is
    axis   e, by its name
    angle  θ
    """

    body: str
    axis: sp.Symbol
    angle: sp.Symbol
    spin: sp.Symbol
    more: sp.Expr
    less: sp.Expr


def sleeping_axis(solution: Solution, view: InCoordinates, letter: str) -> SleepingAxis | None:
    """The threshold of the first axis that has one; `letter`: the name for its spin."""
    motion = view.motion
    if (
        motion is None
        or len(view.configuration.rotations) != 1
        or not is_short(motion)
        or view.configuration.slots.prescribed
    ):
        return None
    [rotation] = view.configuration.rotations
    for name, e in _named(solution, rotation):
        found = _about(motion, rotation, e)
        if found is not None:
            theta, square, four = found
            n = sp.Symbol(letter, real=True)
            more, less = _without_denominators(square * n**2, four)
            if max(count_operations(more), count_operations(less)) <= LONGEST_CONSEQUENCE:
                return SleepingAxis(rotation.name, name, theta, n, more, less)
    return None


def _named(solution: Solution, rotation: Rotation) -> Iterator[tuple[sp.Symbol, Vector]]:
    """The last axis of the body, and the vectors that the file names, in i, j, k."""
    triad = rotation.angular_velocity.triad
    if triad.directions is not None:
        yield triad.units[2], Vector((sp.S.Zero, sp.S.Zero, sp.S.One), triad).fixed()
    for name, vector in solution.problem.abbreviations.items():
        if isinstance(vector, Vector):
            yield VectorSymbol(name), vector.fixed()


def _about(motion: EquationsOfMotion, rotation: Rotation, e: Vector) -> tuple[sp.Symbol, sp.Expr, sp.Expr] | None:
    """θ, α² and 4 β, if the motion of e is of that kind, and upright e needs its spin."""
    slots = motion.configuration.slots
    height = e.components[2]
    [theta, *more] = [q for q in slots.coordinates if height == sp.cos(q)] or [None, None]
    turned = Vector((sp.S.Zero, sp.S.Zero, sp.S.One), FIXED).cross(e)
    around = [q for q in slots.coordinates if _are_same(e.partial(q), turned)]
    if theta is None or more or len(around) != 1:
        return None
    [phi] = around
    spin = rotation.angular_velocity.dot(e)
    if not vanish_along(motion, [slots.time_derivative(spin)]):
        return None
    constants = _constants(motion, spin, theta, phi)
    if constants is None:
        return None
    alpha, beta = constants
    s, c, v, w = sp.sin(theta), sp.cos(theta), prime(theta), prime(phi)
    claims = [
        prime(theta, 2) - w**2 * s * c - beta * s + alpha * spin * w * s,
        prime(phi, 2) * s + 2 * v * w * c - alpha * spin * v,
    ]
    if not beta.is_positive or not vanish_along(motion, claims):
        return None
    return theta, alpha**2, 4 * beta


def _are_same(a: Vector, b: Vector) -> bool:
    return all(is_zero(x - y) is True for x, y in zip(a.fixed().components, b.components, strict=True))


def _constants(
    motion: EquationsOfMotion, spin: sp.Expr, theta: sp.Symbol, phi: sp.Symbol
) -> tuple[sp.Expr, sp.Expr] | None:
    """α and β from one state: at θ = π/2, with θ' = 1, φ' = 0 and n = 1, φ'' = α and θ'' = β."""
    configuration = motion.configuration
    slots, rows = configuration.slots, configuration.rows
    place: Mapping[sp.Basic, sp.Basic] = {**dict.fromkeys(slots.coordinates, sp.S.Zero), theta: sp.pi / 2}
    rates = {r.velocity_form(slots).xreplace(place): sp.S.Zero for r in rows}
    rates |= {spin.xreplace(place): sp.S.One, prime(theta): sp.S.One, prime(phi): sp.S.Zero}
    velocities = _solved(rates, slots.velocities)
    if velocities is None:
        return None
    state = {**place, **velocities}
    laws = [*(e.expression for e in motion.final), *configuration.accelerated_constraints]
    accelerations = _solved({e.xreplace(place).xreplace(state): sp.S.Zero for e in laws}, slots.accelerations)
    if accelerations is None:
        return None
    alpha, beta = (sp.factor(accelerations[prime(q, 2)]) for q in (phi, theta))
    return None if {*alpha.free_symbols, *beta.free_symbols} & {*slots.velocities} else (alpha, beta)


def _solved(equations: Mapping[sp.Expr, sp.Expr], unknowns: tuple[sp.Symbol, ...]) -> dict[sp.Symbol, sp.Expr] | None:
    """The only solution of linear equations, each left side with its value."""
    zero = dict.fromkeys(unknowns, sp.S.Zero)
    kept = {e: value for e, value in equations.items() if e.free_symbols & {*unknowns}}
    rows = [[partial(e, u) for u in unknowns] for e in kept]
    right = [value - e.xreplace(zero) for e, value in kept.items()]
    if any(x.has(sp.zoo, sp.nan) for x in (*right, *(x for row in rows for x in row))):
        return None
    try:
        values = solved_linear(rows, right, Surface())
    except DivisionByZeroError:
        return None
    if values is None or any(x is None for x in values):
        return None
    return {u: x for u, x in zip(unknowns, values, strict=True) if x is not None}


def _without_denominators(more: sp.Expr, less: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """more > less, multiplied by what makes both polynomials without common factors; all of it is positive."""
    (a, b), (c, d) = sp.fraction(sp.cancel(more)), sp.fraction(sp.cancel(less))
    left, right = sp.factor(a * d), sp.factor(c * b)
    common = sp.gcd(left, right)
    return sp.factor(sp.cancel(left / common)), sp.factor(sp.cancel(right / common))
