"""Rough contacts at rest, and the balance of forces: linear equations for reactions, friction and unknown forces.

    Q_k + Σ_j λ_j a_jk + Σ_i F_i t_i·∂r_i/∂q_k = 0     for every coordinate of the file.

They are solved by elimination, in an order in which the forces that are wanted remain open.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import irreducible_factors
from lagrange.algebra.exact.zero_test import Surface
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.free_bodies import without_root
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.equilibrium.equilibrium import VirtualWork
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Inequality, Signs, shortest
from lagrange.problem.model import Friction


@record
class RoughContact:
    """A contact with friction at rest, in the coordinates of a configuration.

    reaction     that presses
    opposite     what takes the opposite friction; empty if it is at rest
    place        the point that touches
    coefficient  μ_s
    normal       |N| is `normal` times the magnitude of the unknown in which the reaction is written
    tangents     the unit vectors of the components of F; in the plane there is one
    components   F, along these
    generalized  for each component, shape (n,): its generalized forces for the file's coordinates, for F = 1
    sign         of that unknown, +1 or −1; None if it is not known
    also         the other reactions on the same particle, if N is the size of their resultant
    units        in this case, of each of them: the force in which it is written, and the reaction for 1 of that
    """

    friction: Friction
    reaction: Reaction
    opposite: str
    place: Vector
    coefficient: sp.Expr
    normal: sp.Expr
    tangents: tuple[Vector, ...]
    components: tuple[sp.Symbol, ...]
    generalized: tuple[tuple[sp.Expr, ...], ...]
    sign: int | None
    also: tuple[Reaction, ...] = ()
    units: tuple[tuple[sp.Symbol, Vector], ...] = ()

    @property
    def name(self) -> str:
        """The name of the friction."""
        return self.friction.name

    def at(self, position: Mapping[sp.Symbol, sp.Expr]) -> RoughContact:
        """The contact where some coordinates have given values."""
        rule = dict(position)
        rows = tuple(tuple(shortest(e.xreplace(rule)) for e in row) for row in self.generalized)
        coefficient, normal = self.coefficient.xreplace(rule), self.normal.xreplace(rule)
        units = tuple((force, unit.xreplace(rule)) for force, unit in self.units)
        return replace(self, coefficient=coefficient, normal=normal, generalized=rows, units=units) if rule else self

    def resultant(self, forces: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
        """The size of the resultant of all reactions, for given forces."""
        total = [sp.S.Zero] * 3
        for force, unit in self.units:
            total = [a + forces[force] * b for a, b in zip(total, unit.fixed().components, strict=True)]
        return sp.sqrt(shortest(sp.Add(*(a**2 for a in total))))


@record
class SolvedBalance:
    """The unknowns in terms of those left open; `linear` has (constant, coefficients) of each."""

    forces: Mapping[sp.Symbol, sp.Expr]
    linear: Mapping[sp.Symbol, Inequality]
    open: tuple[sp.Symbol, ...]
    equations: tuple[sp.Expr, ...]
    presupposed: tuple[sp.Expr, ...]


class ForceBalance:
    """The equations of balance, in the coordinates of a configuration."""

    def __init__(
        self,
        newton: Newton,
        contacts: Sequence[RoughContact],
        original: Configuration,
        configuration: Configuration,
        work: VirtualWork,
        unknown: Sequence[sp.Symbol],
        sought: Sequence[sp.Symbol],
        held: Mapping[sp.Symbol, sp.Expr],
    ) -> None:
        def write(e: sp.Expr) -> sp.Expr:
            return configuration.rewritten(e).xreplace(dict(held))

        columns: dict[sp.Symbol, list[sp.Expr]] = {}
        extra: list[dict[sp.Symbol, sp.Expr]] = []
        for c in contacts:
            columns |= {f: list(row) for f, row in zip(c.components, c.generalized, strict=True)}
            if len(c.components) > 1:
                normals = (r.on(c.friction.on) for r in (c.reaction, *c.also))
                extra += [dict(zip(c.components, map(write, n.fixed().components), strict=True)) for n in normals if n]
        for r in newton.reactions:
            form = without_root(r.row, original.slots).coefficients
            columns[r.force] = [shortest(write(a * r.per_force)) for a in form]
        linear = [f for f in unknown if all(q.diff(f, 2) == 0 for q in work.forces)]
        forces = {f: [shortest(write(q.diff(f))) for q in work.forces] for f in linear}
        forces = {f: column for f, column in forces.items() if any(a != 0 for a in column)}
        columns |= forces
        self.unknowns = tuple(columns)
        self.sought = tuple(f for f in sought if f in forces)
        self.pressing = tuple(r.force for r in newton.reactions if r.constraint.side is not None)
        self.surface: Surface = configuration.surface
        count = len(original.slots.coordinates)
        right = [shortest(write(-q.xreplace(dict.fromkeys(forces, sp.S.Zero)))) for q in work.forces]
        self.rows = [[*(columns[u][k] for u in self.unknowns), right[k]] for k in range(count)]
        self.balance = [
            sp.Add(*(a * u for a, u in zip(row, self.unknowns, strict=False)), -row[-1]) for row in self.rows
        ]
        self.rows += [[*(e.get(u, sp.S.Zero) for u in self.unknowns), sp.S.Zero] for e in extra]

    def solved(self, signs: Signs, last: Sequence[sp.Symbol]) -> SolvedBalance:
        """The unknowns by elimination, `last` after the others, so that these remain open."""
        first = [u for u in self.unknowns if u not in self.pressing and u not in self.sought]
        places = [self.unknowns.index(u) for u in (*first, *last, *self.sought)]
        work = [list(row) for row in self.rows]
        pivots: dict[int, int] = {}
        presupposed: list[sp.Expr] = []
        for column in places:
            candidates = [
                (signs.of(row[column]) is None, count_operations(row[column]), n)
                for n, row in enumerate(work)
                if n not in pivots.values() and not self._is_zero(row[column])
            ]
            if not candidates:
                continue
            unsure, _, chosen = min(candidates)
            pivot = work[chosen][column]
            if unsure:
                presupposed += [f for f in _factors_that_may_vanish(pivot, signs) if f not in presupposed]
            work[chosen] = [shortest(e / pivot) for e in work[chosen]]
            for n, row in enumerate(work):
                if n != chosen and row[column] != 0:
                    factor = row[column]
                    work[n] = [shortest(a - factor * b) for a, b in zip(row, work[chosen], strict=True)]
            pivots[column] = chosen
        given = [k for k, u in enumerate(self.unknowns) if k not in pivots and u in self.sought]
        open_ = [k for k in range(len(self.unknowns)) if k not in pivots and k not in given]
        linear, forces = {}, {}
        for k, unknown in enumerate(self.unknowns):
            if k in given:
                continue
            if k in pivots:
                row = work[pivots[k]]
                constant = sp.Add(row[-1], *(-row[g] * self.unknowns[g] for g in given))
                linear[unknown] = Inequality(tuple(-row[o] for o in open_), shortest(constant))
            else:
                linear[unknown] = Inequality(tuple(sp.Integer(o == k) for o in open_), sp.S.Zero)
            terms = zip(linear[unknown].coefficients, open_, strict=True)
            forces[unknown] = sp.Add(linear[unknown].constant, *(c * self.unknowns[o] for c, o in terms))
        left = [row[-1] for n, row in enumerate(work) if n not in pivots.values()]
        equations = tuple(e for e in left if not self._is_zero(e))
        return SolvedBalance(forces, linear, tuple(self.unknowns[k] for k in open_), equations, tuple(presupposed))

    def _is_zero(self, e: sp.Expr) -> bool:
        return e == 0 or self.surface.is_zero(e) is True


def _factors_that_may_vanish(pivot: sp.Expr, signs: Signs) -> list[sp.Expr]:
    above, _ = sp.fraction(sp.together(pivot))
    split = irreducible_factors(above)
    return [pivot] if split is None else [f for f in split if signs.of(f) is None]
