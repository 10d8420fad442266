"""All consequences of the equations of motion in one set of coordinates.

The motion that a system without friction tends to, in quasi-velocities with constant coefficients.

If u' = c w² with a constant c ≠ 0, u moves in one sense. If the energy is a positive definite quadratic form of the
quasi-velocities alone, u is bounded by it, so that it has a limit and ∫ w² dt is finite; the rate of w² is bounded,
too. Therefore w → 0 (Barbalat's lemma). Where u and w are the only quasi-velocities, the energy of u remains: the
sleigh ends straight, Suslov's body turns evenly in the end about an axis that is fixed in it.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import UnitVector, free_letter
from lagrange.mechanics.consequences.oscillations import (
    Beats,
    DoubleResonance,
    SleepingAxis,
    beats,
    double_resonance,
    sleeping_axis,
)
from lagrange.mechanics.consequences.time_dependent import (
    FastDrive,
    SlowChange,
    UniformStiffness,
    fast_drive,
    slow_change,
    uniform_stiffness,
)
from lagrange.mechanics.consequences.vectors import (
    ConeVector,
    ConstantSpin,
    Hodograph,
    cone_vector,
    constant_spins,
    hodograph,
    kept_directions,
)
from lagrange.mechanics.dynamics.conservation import ConservedQuantity
from lagrange.mechanics.limits import LONGEST_RATE
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.mechanics.rewriting.quasi_velocities import OneWay, one_way, rates_by_speeds


@record
class Consequences:
    """Constant vectors and directions, hodograph, motion in the limit, beats, resonance, what stays upright.

    Under a fast drive the mean motion, and amplitudes while a length changes slowly.
    """

    spins: tuple[ConstantSpin, ...]
    cone: ConeVector | None
    directions: tuple[tuple[sp.Symbol, sp.Symbol], ...]
    hodograph: Hodograph | None
    limits: tuple[LimitMotion, ...]
    beats: Beats | None
    resonance: DoubleResonance | None
    sleeping: SleepingAxis | None
    drive: FastDrive | None
    slow: SlowChange | None
    uniform: UniformStiffness | None


def consequences(solution: Solution, view: InCoordinates) -> Consequences:
    """The consequences; most systems have none."""
    taken = solution.problem.scope.names()
    parameters = tuple(p.symbol for p in solution.problem.parameters)
    v, psi, u = (free_letter(*names, taken=taken) for names in (("v", "w"), ("psi", "chi"), ("u", "U")))
    return Consequences(
        tuple(constant_spins(view)),
        cone_vector(view),
        tuple(kept_directions(view)),
        hodograph(view, (v, psi, u)),
        tuple(limit_motion(view, LONGEST_RATE)),
        beats(view.linearization, parameters),
        double_resonance(view),
        sleeping_axis(solution, view, free_letter("n", "s", "nu", taken=taken)),
        fast_drive(view),
        slow_change(view),
        None if solution.problem.initial else uniform_stiffness(view),
    )


# Limit motion


@record
class LimitMotion:
    """`vanishing` tends to 0, and of the energy there remains that of `lasting`.

    unless  a factor of the rate that must not be zero; None if it cannot be
    spin    the angular velocity of the only body in the limit, where it is along a unit vector of the body
    """

    lasting: sp.Symbol
    vanishing: sp.Symbol
    remaining: sp.Expr
    unless: sp.Expr | None
    spin: sp.Expr | None


def limit_motion(view: InCoordinates, longest: int) -> Iterator[LimitMotion]:
    """The limits, from equations of at most `longest` operations."""
    form, conserved = view.in_speeds, view.conserved
    if form is None or form.equations is None or conserved is None or len(form.velocities.definitions) != 2:
        return
    slots = view.configuration.slots
    energy = next((i for i in conserved.integrals if i.quantity is ConservedQuantity.ENERGY and i.constant), None)
    if energy is None:
        return
    speeds = tuple(form.velocities.definitions)
    rule = rates_by_speeds(slots, form)
    total = sp.expand(
        textbook_form(energy.expression.xreplace({k: v for k, v in rule.items() if k in slots.velocities}))
    )
    if not _is_positive_definite(total, speeds):
        return
    for way in one_way(form, slots, longest):
        factor = None if way.still is None else sp.cancel(way.rate / way.still**2)
        if (
            way.still is None
            or factor is None
            or factor.free_symbols & {*speeds, *slots.coordinates, *slots.velocities}
        ):
            continue
        remaining = textbook_form(total.xreplace({way.still: sp.S.Zero}))
        yield LimitMotion(way.speed, way.still, remaining, _unless(factor), _spin(view, way))


def _is_positive_definite(total: sp.Expr, speeds: tuple[sp.Symbol, ...]) -> bool:
    """Whether it is a u² + b w² with constants a, b > 0."""
    squares = [total.coeff(s, 2) for s in speeds]
    alone = is_zero(total - sp.Add(*(c * s**2 for c, s in zip(squares, speeds, strict=True)))) is True
    return alone and all(_is_positive(c, speeds) for c in squares)


def _is_positive(c: sp.Expr, speeds: tuple[sp.Symbol, ...]) -> bool:
    """Whether each term is non-negative, and they cannot vanish together: A cos² δ + C sin² δ is positive."""
    if c.free_symbols & {*speeds}:
        return False
    if c.is_positive:
        return True
    terms = sp.Add.make_args(sp.expand(c))
    if not all(x.is_nonnegative for x in terms):
        return False
    pairs = [x for x in c.atoms(sp.cos) if sp.expand(c).coeff(x, 2).is_positive]
    return any(sp.expand(c).coeff(sp.sin(x.args[0]), 2).is_positive for x in pairs)


def _unless(factor: sp.Expr) -> sp.Expr | None:
    """The factors that may vanish, as one product."""
    open_ = [f for f in sp.Mul.make_args(sp.factor(factor)) if not f.is_nonzero]
    return sp.Mul(*open_) if open_ else None


def _spin(view: InCoordinates, way: OneWay) -> sp.Expr | None:
    form = view.in_speeds
    if form is None or form.equations is None or len(form.equations.spins) != 1 or way.still is None:
        return None
    [spin] = form.equations.spins.values()
    last = spin.map(lambda c: textbook_form(c.xreplace({way.still: sp.S.Zero}))).as_sum()
    units = [s for s in last.free_symbols if isinstance(s, UnitVector)]
    return last if len(units) == 1 and not last.free_symbols & {*view.configuration.slots.coordinates} else None
