"""Results in quasi-velocities u, with q' = B u + b and q'' = Ḃ u + B u̇ + ḃ substituted, and what their rates say.

(M + 2m) (y'' cos θ − x'' sin θ) is (M + 2m) v ω. The sign of a rate may be seen: u' = a ω² is never negative, u only
grows. The square of a velocity follows from a constraint that is a sum of squares: x'² + y'² = v².
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from enum import StrEnum
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, prime, t
from lagrange.mechanics.constraints.constrained_system import Row

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.quasi_equations import QuasiVelocityForm


def rates_by_speeds(slots: Slots, form: QuasiVelocityForm) -> dict[sp.Expr, sp.Expr]:
    """The velocities by the quasi-velocities, q' = B u + b, and the accelerations by their derivatives."""
    kinematic, speeds = form.velocities.kinematic, form.velocities.symbols
    rule: dict[sp.Expr, sp.Expr] = dict(kinematic)
    for velocity, acceleration in zip(slots.velocities, slots.accelerations, strict=True):
        if velocity in kinematic:
            e = kinematic[velocity]
            moved = [e.diff(c) * kinematic.get(v, v) for c, v in zip(slots.coordinates, slots.velocities, strict=True)]
            rule[acceleration] = sp.Add(*moved, *(e.diff(u) * prime(u) for u in speeds), e.diff(t))
    return rule


def substituted(e: sp.Expr, rule: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    """The expression with velocities and accelerations substituted, in textbook form."""
    return textbook_form(e.xreplace(dict(rule)))


def squares_by_constraints(rows: Sequence[Row], slots: Slots) -> list[tuple[sp.Symbol, sp.Expr]]:
    """Velocities whose squares constraints give, with the squares."""
    return [rule for r in rows if r.nonlinear is not None and (rule := _square_of(r, slots)) is not None]


def _square_of(row: Row, slots: Slots) -> tuple[sp.Symbol, sp.Expr] | None:
    """The square of a velocity by the others, where a constraint is a sum of squares and more."""
    if row.nonlinear is None:
        return None
    for v in slots.velocities:
        dummy = sp.Dummy()
        form = sp.expand(row.nonlinear).xreplace({v**2: dummy})
        factor = form.diff(dummy)
        if not form.has(v) and factor.is_number and factor != 0:
            return v, sp.expand(-form.xreplace({dummy: sp.S.Zero}) / factor)
    return None


def with_squares(e: sp.Expr, squares: Sequence[tuple[sp.Symbol, sp.Expr]]) -> sp.Expr:
    """The expression with these squares substituted, one after the other, where that makes it shorter."""
    for velocity, square in squares:
        reduced = sp.factor(sp.cancel(sp.expand(e).xreplace({velocity**2: square})))
        e = reduced if count_operations(reduced) < count_operations(e) else e
    return e


class Course(StrEnum):
    """How a quantity changes whose rate never changes its sign."""

    GROWS = "grows"
    FALLS = "falls"
    ONE_SENSE = "one sense"


@record
class OneWay:
    """u' = rate, of one sign; `still` is the only quasi-velocity that vanishes where the rate does, if there is one."""

    speed: sp.Symbol
    rate: sp.Expr
    course: Course
    still: sp.Symbol | None


def one_way(form: QuasiVelocityForm, slots: Slots, longest: int) -> Iterator[OneWay]:
    """The quasi-velocities whose rates have one sign, from equations of at most `longest` operations."""
    if form.equations is None:
        return
    speeds = tuple(form.velocities.definitions)
    for e in form.equations.expressions:
        involved = [u for u in speeds if e.has(prime(u))]
        if len(involved) != 1 or count_operations(e) > longest:
            continue
        [u] = involved
        factor = sp.diff(e, prime(u))
        rate = sp.factor_terms(-e.xreplace({prime(u): sp.S.Zero}) / factor)
        if factor.has(prime(u)) or not factor.is_nonzero or not rate.free_symbols & {*speeds}:
            continue
        grows, falls = rate.is_nonnegative, rate.is_nonpositive
        if rate == 0 or (bool(grows) == bool(falls) and not _never_turns(rate, slots, speeds)):
            continue
        course = Course.FALLS if falls else Course.GROWS if grows else Course.ONE_SENSE
        bases = [f.as_base_exp()[0] for f in sp.Mul.make_args(rate) if not f.is_nonzero]
        moving = [b for b in bases if b.free_symbols & {*speeds}]
        yield OneWay(u, rate, course, moving[0] if len(moving) == 1 and moving[0] in speeds else None)


def _never_turns(rate: sp.Expr, slots: Slots, speeds: Sequence[sp.Symbol]) -> bool:
    """Whether it is a constant times a factor that is never negative."""
    constant, moving = rate.as_independent(*speeds, as_Add=False)
    changing = {*slots.coordinates, *slots.velocities, *slots.prescribed, t}
    return bool(moving.is_nonnegative) and not constant.free_symbols & changing
