"""An axis that stands upright because it spins: the threshold of stability of tops, and of balls on balls.

Let e be a unit vector with the angle θ from k, turned about k by φ, and n = ω·e constant. If along every motion

    θ'' − φ'² sin θ cos θ = β sin θ − α n φ' sin θ ,      φ'' sin θ + 2 θ' φ' cos θ = α n θ' ,

with constants α and β, then for ζ = sin θ e^{iφ} to first order ζ'' = i α n ζ' + β ζ, although θ and φ have a pole at
θ = 0. With ζ ~ e^{iωt}, ω² − α n ω + β = 0: for β > 0 the upright axis is stable if α² n² > 4 β, and falls if it is
less. Nothing is said of motions that are not small.
Reference: Routh, Advanced Rigid Dynamics, on the stability of a sleeping top.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, Surface, is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import VectorSymbol, partial, prime
from lagrange.core.vectors import FIXED, Vector
from lagrange.mechanics.consequences.along import is_short, vanish_along
from lagrange.mechanics.consequences.limits import LONGEST_CONSEQUENCE
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.results import InCoordinates, Solution


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
