"""The checks of small oscillations by a second route.

linear equations    M, D, K from Lagrange's equations, differentiated and taken at each point of the equilibrium
modes               put back: (K − ω² M) a = 0
orthogonality       aᵀ M b = 0 for modes of different frequencies, where K is symmetric
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.closed_form import Values
from lagrange.algebra.closed_forms.eigenmodes import Matrix
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.exact import DivisionByZeroError, is_zero
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.verification import Check
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations

MOST_POINTS = 4
"""Points of an equilibrium at which the linear equations are compared."""


def check_linearization(found: Linearization) -> list[Check]:
    """The checks of one set of coordinates."""
    name = found.configuration.name
    checks = []
    if any(s is not None for s in found.at):
        passed = _together(_same_equations(found))
        how = "exact: differentiated at each equilibrium"
        checks.append(Check("Lagrange's equations have the same linear equations", passed, how, name))
    modes = [v for s in found.at if s is not None for v in _modes_hold(s)]
    if modes:
        checks.append(Check("the modes satisfy the linear equations", _together(modes), "exact, put back", name))
    right = [v for s in found.at if s is not None and s.system.symmetric for v in _orthogonal(s)]
    if right:
        how = "exact: aᵀ M b = 0"
        checks.append(Check("modes of different frequencies are orthogonal", _together(right), how, name))
    return checks


def _together(verdicts: Iterator[bool | None] | list[bool | None]) -> bool | None:
    found = list(verdicts)
    return False if False in found else None if None in found else True


def _same_equations(found: Linearization) -> Iterator[bool | None]:
    """Whether Nᵀ M N, Nᵀ D N, Nᵀ K N of Lagrange's equations are the matrices found, entry by entry."""
    configuration = found.configuration
    slots = configuration.slots
    rows = [r for r in configuration.rows if not r.is_identity]
    multipliers = found.equilibrium.multipliers
    left = [
        e - sp.Add(*(m * r.coefficients[k] for m, r in zip(multipliers, rows, strict=True)))
        for k, e in enumerate(lagrange_equations(configuration).left)
    ]
    still = dict.fromkeys((*slots.velocities, *slots.accelerations), sp.S.Zero)
    tables = [
        sp.Matrix([[e.diff(s).xreplace(still) for s in symbols] for e in left])
        for symbols in (slots.accelerations, slots.velocities, slots.coordinates)
    ]
    for b, s in zip(found.branches, found.at, strict=True):
        if s is None:
            continue
        n = sp.Matrix(s.shape)
        for point in b.points[:MOST_POINTS]:
            for table, matrix in zip(tables, (s.system.mass, s.system.damping, s.system.stiffness), strict=True):
                difference = n.T * table * n - sp.Matrix(matrix)
                yield from (_is_zero_at(found, b, point, e) for e in difference)


def _is_zero_at(found: Linearization, b: Branch, point: Values, e: sp.Expr) -> bool | None:
    """Whether an expression is zero at a point; beside other angles than those of the conditions, by plain values."""
    try:
        try:
            there = found.equilibrium.solution.at(point, e)
        except NotAlgebraicError:
            plain = {r.lhs: r.rhs for r in b.relations if r.lhs in found.configuration.slots.coordinates}
            there = e.xreplace({m: point[m] for m in found.equilibrium.multipliers if m in point}).xreplace(plain)
            if there.free_symbols & set(found.configuration.slots.coordinates):
                return None
        return is_zero(there)
    except DivisionByZeroError:
        return None


def _modes_hold(s: SmallOscillations) -> Iterator[bool | None]:
    mass, stiffness = sp.Matrix(s.system.mass), sp.Matrix(s.system.stiffness)
    for f in s.frequencies:
        for mode in f.modes:
            yield from (is_zero(e) for e in (stiffness - f.square * mass) * sp.Matrix(mode))


def _orthogonal(s: SmallOscillations) -> Iterator[bool | None]:
    for f, g in combinations(s.frequencies, 2):
        for a in f.modes:
            for b in g.modes:
                yield is_zero(_product(a, s.system.mass, b))


def _product(a: tuple[sp.Expr, ...], mass: Matrix, b: tuple[sp.Expr, ...]) -> sp.Expr:
    product: sp.Expr = (sp.Matrix(a).T * sp.Matrix(mass) * sp.Matrix(b))[0]
    return product
