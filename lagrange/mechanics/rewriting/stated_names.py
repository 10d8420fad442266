"""Equations as they were stated, in the names that the file gives: quasi-velocities, and ω·n with a vector of `let`.

Where an answer says A p' = (B − C) q r, or dot(omega_ball, out), these have been replaced by what they mean before it
was judged. For printing they are restored: a sum that is exactly such a quantity or its time derivative is replaced.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.symbols import DotProduct, TimeDerivative, VectorSymbol, prime
from lagrange.core.vectors import Vector
from lagrange.mechanics.limits import MOST_STATED_NAMES
from lagrange.mechanics.results import Solution

StatedEquations = tuple[tuple[sp.Expr, ...], ...]
"""Equations, each as its sides."""


def in_names(solution: Solution, stated: StatedEquations) -> StatedEquations:
    """The equations with the names."""
    names = [*_names(solution)]
    return tuple(tuple(_named(side, names) for side in sides) for sides in stated) if names else stated


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
