"""Results in the names that a file gives: quasi-velocities, one velocity after an impact, ω·n.

Results in quasi-velocities u, with q' = B u + b and q'' = Ḃ u + B u̇ + ḃ substituted, and what their rates say.

(M + 2m) (y'' cos θ − x'' sin θ) is (M + 2m) v ω. The sign of a rate may be seen: u' = a ω² is never negative, u only
grows. The square of a velocity follows from a constraint that is a sum of squares: x'² + y'² = v².

Velocities after an impact as multiples of one velocity, where they are long by themselves.

After an impact that leaves one degree of freedom all velocities are multiples of one: x' = (R − h) θ' of a disc that
turns about an edge.

Equations as they were stated, in the names that the file gives: quasi-velocities, and ω·n with a vector of `let`.

Where an answer says A p' = (B − C) q r, or dot(omega_ball, out), these have been replaced by what they mean before it
was judged. For printing they are restored: a sum that is exactly such a quantity or its time derivative is replaced.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from enum import StrEnum
from itertools import combinations
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import DotProduct, Slots, TimeDerivative, VectorSymbol, prime, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.limits import LONGEST_RATIO, MOST_STATED_NAMES, SHORTEST_BY_VELOCITY
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.factors import with_terms_added

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


# After an impact, by one velocity


Values = Mapping[sp.Symbol, sp.Expr]


def by_one_velocity(velocities: Values) -> dict[sp.Symbol, sp.Expr]:
    """The velocities, first the one by which others are written: the shortest that differs from zero."""
    moving = [v for v, value in velocities.items() if value != 0]
    if len(moving) < 2 or max(count_operations(velocities[v]) for v in moving) < SHORTEST_BY_VELOCITY:
        return {**velocities}
    first = min(moving, key=lambda v: count_operations(velocities[v]))
    shorter = dict(_multiples(first, velocities[first], velocities))
    return {**velocities} if shorter == {**velocities} else {first: velocities[first]} | shorter


def _multiples(velocity: sp.Symbol, known: sp.Expr, values: Values) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    for name, value in values.items():
        if (
            name == velocity
            or count_operations(value) < SHORTEST_BY_VELOCITY
            or count_operations(value) > LONGEST_RATIO
        ):
            yield name, value
            continue
        ratio = sp.factor(sp.cancel(value / known))
        multiple = ratio * velocity
        exact = is_zero(ratio * known - value) is True
        yield name, multiple if exact and 3 * count_operations(multiple) <= 2 * _printed_length(value) else value


def _printed_length(product: sp.Expr) -> int:
    """The operations of a product whose square roots are printed under one."""
    roots = sum(f.is_Pow and abs(f.exp) == sp.S.Half for f in sp.Mul.make_args(product))
    return int(count_operations(product) - 2 * max(0, roots - 1))


# Stated names


StatedEquations = tuple[tuple[sp.Expr, ...], ...]
"""Equations, each as its sides."""


def in_names(solution: Solution, stated: StatedEquations) -> StatedEquations:
    """The equations with the names."""
    names = [*_names(solution)]
    return tuple(tuple(_named(side, names) for side in sides) for sides in stated) if names else stated


def with_terms_added_in(stated: StatedEquations) -> StatedEquations:
    """The equations with like terms as one."""
    return tuple(tuple(with_terms_added(e) if e.is_Add else e for e in sides) for sides in stated)


def _names(solution: Solution) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """Pairs: a sum, and what it is called; of each quantity also the time derivative."""
    slots, problem = solution.problem.slots, solution.problem
    pairs: list[tuple[sp.Expr, sp.Expr, sp.Expr]] = []
    pairs += [(u.definition, u.symbol, prime(u.symbol)) for u in problem.speeds]
    for r in solution.own.configuration.rotations:
        for name, direction in problem.abbreviations.items():
            if not isinstance(direction, Vector):
                continue
            value = r.angular_velocity.fixed().dot(direction.fixed())
            called = DotProduct(VectorSymbol(f"omega_{r.name}"), VectorSymbol(name))
            pairs.append((value, called, TimeDerivative(called)))
    for value, called, rate in pairs[:MOST_STATED_NAMES]:
        if isinstance(value, sp.Expr) and value.is_Add:
            yield value, called
            yield slots.time_derivative(value), rate


def by_named_rates(solution: Solution, e: sp.Expr, stated: StatedEquations) -> sp.Expr:
    """An expression by the quantities ω·n that the stated equations have, where that is shorter: φ' (ω·out).

    The constraints on velocities and these quantities are linear in the velocities, and are solved for some of those.
    """
    used = {d for sides in stated for side in sides for d in side.atoms(DotProduct)}
    names = [(value, called) for value, called in _names(solution) if called in used]
    configuration = solution.own.configuration
    slots = configuration.slots
    rates = [v for v in slots.velocities if v in e.free_symbols]
    if not names or not rates or any(r.nonlinear is not None for r in configuration.rows):
        return e
    letters = {sp.Dummy(real=True): called for _, called in names}
    bound = [r.velocity_form(slots) for r in configuration.rows]
    bound += [value - letter for (value, _), letter in zip(names, letters, strict=True)]
    best = e
    for chosen in combinations(slots.velocities, len(bound)):
        if not {*rates} & {*chosen}:
            continue
        rows = [[f.diff(v) for v in chosen] for f in bound]
        still = dict.fromkeys(chosen, sp.S.Zero)
        solved = solved_linear(rows, [-f.xreplace(still) for f in bound], configuration.states)
        if solved is None or any(v is None for v in solved):
            continue
        written = textbook_form(e.xreplace(dict(zip(chosen, solved, strict=True)))).xreplace(letters)
        if count_operations(written) < count_operations(best):
            best = written
    return best


def _named(e: sp.Expr, names: list[tuple[sp.Expr, sp.Expr]]) -> sp.Expr:
    if e.is_Add:
        for value, called in names:
            if e.free_symbols == value.free_symbols:
                if is_zero(e - value) is True:
                    return called
                if is_zero(e + value) is True:
                    return -called
    return e.func(*(_named(a, names) for a in e.args)) if e.args else e
