"""Poles of a chart among the equilibria: positions at which a coordinate moves nothing.

With r = l (sin θ cos φ, sin θ sin φ, −cos θ) the position θ = 0 is the same for every φ. There δφ moves nothing, and
the displacements δθ at one φ are not all the displacements of the particle. So Q_θ = Q_φ = 0 is necessary for
equilibrium, and sufficient only if it holds for every φ: a horizontal force is not balanced at θ = 0, although
Q_θ = F l cos φ vanishes for φ = π/2.

A crank at its dead centre is no pole. There ∂r/∂φ vanishes for one value of φ, not for all. But with x = a cos θ for
the place of a slider θ = 0 is the edge of what θ can name: δθ is no displacement there, while x has one.

Whether V has a minimum at a pole is decided in other coordinates, u = θ cos φ and v = θ sin φ. Half a turn of φ
exchanges δθ and −δθ, and since V is a function of the position, V_θθ = V_uu cos² φ + 2 V_uv sin φ cos φ + V_vv sin² φ.
So the values of V_θθ at four φ give V_uu, V_uv and V_vv, and the equation itself is tested for all φ.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero, rank
from lagrange.mechanics.constraints.kinematics import Configuration


def idle_coordinates(configuration: Configuration, solution: SolutionSet, b: Branch) -> tuple[sp.Symbol, ...]:
    """The coordinates that change nothing at the points of a branch, whatever their values, but do so elsewhere."""
    coordinates = configuration.slots.coordinates
    if len(coordinates) == 1 or not b.points:
        return ()
    return tuple(
        q
        for k, q in enumerate(coordinates)
        if (effects := [e for e in _effects(configuration, k) if e != 0])
        and all(_all_vanish(effects, solution, _without(q, p, solution)) for p in b.points)
    )


def is_at_edge(configuration: Configuration, old: Sequence[sp.Symbol], solution: SolutionSet, b: Branch) -> bool:
    """Whether the coordinates of a choice name fewer displacements at the points of a branch than they do elsewhere.

    old  the file's coordinates, which are functions of those of the choice
    """
    table = [[configuration.rewritten(x).diff(q) for q in configuration.slots.coordinates] for x in old]
    elsewhere = rank(table)
    try:
        there = [rank([[solution.at(p, e) for e in row] for row in table]) for p in b.points]
    except (NotAlgebraicError, DivisionByZeroError):
        return False
    return bool(there) and elsewhere is not None and all(r is not None and r < elsewhere for r in there)


def moves_nothing(configuration: Configuration, solution: SolutionSet, b: Branch) -> bool:
    """Whether the only coordinate moves nothing at the points of a branch, to first order: a dead centre."""
    if len(configuration.slots.coordinates) != 1 or configuration.rows or not b.points or b.left or b.special:
        return False
    effects = [e for e in _effects(configuration, 0) if e != 0]
    return bool(effects) and all(_all_vanish(effects, solution, p) for p in b.points)


def _effects(configuration: Configuration, k: int) -> Iterator[sp.Expr]:
    """What a displacement δq_k moves, turns, or violates."""
    q = configuration.slots.coordinates[k]
    for p in configuration.points:
        yield from p.partials[k].fixed().components
    for r in configuration.rotations:
        yield from r.partials[k].components
    for load in configuration.loads:
        yield from (c.diff(q) for c in load.point.fixed().components)
    for spring in configuration.springs:
        yield spring.distance.diff(q)
    for row in configuration.rows:
        yield row.coefficients[k]


def _without(q: sp.Symbol, point: Values, solution: SolutionSet) -> Values:
    """A point with a coordinate left open."""
    angle = solution.letters.angles.get(q)
    own = {q, *(angle.letters if angle else ())}
    return {s: v for s, v in point.items() if s not in own}


def _all_vanish(effects: list[sp.Expr], solution: SolutionSet, point: Values) -> bool:
    try:
        return all(is_zero(solution.at(point, e)) for e in effects)
    except (NotAlgebraicError, DivisionByZeroError):
        return False


def is_only_of_chart(
    forces: dict[sp.Symbol, sp.Expr], solution: SolutionSet, b: Branch, idle: Iterable[sp.Symbol]
) -> bool:
    """Whether a branch is no equilibrium: at a pole where no φ meets a force, and another force vanishes for some only.

    forces  Q_k of the free displacements, by coordinate

    An explicit c φ²/2 is a torsion spring: φ is then more than a name of directions, and must have its value.
    """
    idle = tuple(idle)
    if b.left or b.special or not b.points or not any(r.residual.has(*idle) for r in b.equations if idle):
        return False
    own, others = [forces[q] for q in idle if q in forces], [f for q, f in forces.items() if q not in idle]
    for p in b.points:
        for q in idle:
            p = _without(q, p, solution)
        if not _all_vanish(own, solution, p) or not any(_differs(f, solution, p) for f in others):
            return False
    return True


def _differs(force: sp.Expr, solution: SolutionSet, point: Values) -> bool:
    try:
        return is_zero(solution.at(point, force)) is False
    except (NotAlgebraicError, DivisionByZeroError):
        return False


def radius_at(configuration: Configuration, solution: SolutionSet, b: Branch, phi: sp.Symbol) -> sp.Symbol | None:
    """The coordinate whose displacements half a turn of φ reverses at a pole, and no other's; None if there is none."""
    reversed_: list[sp.Symbol] = []
    for k, q in enumerate(configuration.slots.coordinates):
        if q == phi:
            continue
        effects = [e for e in _effects(configuration, k) if e != 0]
        opposite = [e.xreplace({phi: phi + sp.pi}) for e in effects]
        same = [e - o for e, o in zip(effects, opposite, strict=True)]
        if all(_all_vanish(same, solution, _without(phi, p, solution)) for p in b.points):
            continue
        against = [e + o for e, o in zip(effects, opposite, strict=True)]
        if not all(_all_vanish(against, solution, _without(phi, p, solution)) for p in b.points):
            return None
        reversed_.append(q)
    return reversed_[0] if len(reversed_) == 1 else None


def without_pole(matrix: Sequence[Sequence[sp.Expr]], theta: int, phi: int, name: sp.Symbol) -> list[list[sp.Expr]]:
    """V'' at a pole with respect to θ cos φ, θ sin φ and the others, from that in the coordinates; [] if it is not of
    that form. `theta` and `phi` are the places of the coordinates in the matrix, `name` is φ.
    """

    def at(e: sp.Expr, part: sp.Rational) -> sp.Expr:
        return e.xreplace({name: part * sp.pi})

    quarter, half = sp.Rational(1, 4), sp.Rational(1, 2)
    others = [k for k in range(len(matrix)) if k not in (theta, phi)]
    second = matrix[theta][theta]
    mixed = (at(second, quarter) - at(second, 3 * quarter)) / 2
    first, last = at(second, sp.S.Zero), at(second, half)
    c, s = sp.cos(name), sp.sin(name)
    rest = [second - (first * c**2 + 2 * mixed * s * c + last * s**2)]
    along = [(at(matrix[theta][k], sp.S.Zero), at(matrix[theta][k], half)) for k in others]
    rest += [matrix[theta][k] - (u * c + v * s) for k, (u, v) in zip(others, along, strict=True)]
    rest += [matrix[k][j] - at(matrix[k][j], sp.S.Zero) for k in others for j in others]
    if not all(is_zero(e) for e in rest):
        return []
    rows = [[first, mixed, *(u for u, _ in along)], [mixed, last, *(v for _, v in along)]]
    rows += [[u, v, *(at(matrix[k][j], sp.S.Zero) for j in others)] for k, (u, v) in zip(others, along, strict=True)]
    return rows
