"""Quasi-coordinates of bodies, and what a constraint is in true coordinates.

A file may give an angular velocity by its components: ω = α' i + β' j + γ' k. How the body is turned is no function of
α, β, γ then, and dα is the differential of no function: x' = R β' is not x = R β + const. The rates Ω_k of
ω = Σ Ω_k q_k' + Ω_t belong to coordinates of the rotation if they are those of one matrix R(q, t), ∂R/∂q_k = Ω_k × R,
which takes

    ∂Ω_k/∂q_j − ∂Ω_j/∂q_k = Ω_j × Ω_k       for all pairs, t among them        (Maurer, Cartan) ,

components in i, j, k. Where that fails for coordinates that occur by their velocities only, they are quasi-coordinates.
Three of them with independent Ω_k are as good as any three angles: with ω of a sequence of rotations, the q_k' are
solved for, and a form becomes one in true coordinates, to which Frobenius' theorem applies. With fewer, it is left
undecided.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.exact import is_zero
from lagrange.core.records import record
from lagrange.core.rotation import angular_velocity
from lagrange.core.symbols import Slots, prime, t
from lagrange.core.vectors import Vector
from lagrange.problem.model import Problem

Form = tuple[sp.Expr, ...]


@record
class QuasiCoordinates:
    """The quasi-coordinates of a problem.

    coordinates  in the order of the problem
    slots        the problem's, with angles in the place of those that can be replaced
    velocities   of these, by the velocities of the angles and of the others
    """

    coordinates: tuple[sp.Symbol, ...]
    slots: Slots
    velocities: Mapping[sp.Symbol, sp.Expr]

    def used_by(self, form: Sequence[sp.Expr], slots: Slots) -> tuple[sp.Symbol, ...]:
        """Those whose differentials a form in the coordinates of `slots`, dt last, has."""
        return tuple(q for q, a in zip(slots.coordinates, form, strict=False) if a != 0 and q in self.coordinates)

    def in_angles(self, form: Sequence[sp.Expr], slots: Slots) -> Form | None:
        """A form of shape (n + 1,) in true coordinates; None where these were not found."""
        if any(prime(q) not in self.velocities for q in self.used_by(form, slots)):
            return None
        total = sp.Add(*(a * v for a, v in zip(form, slots.velocities, strict=False)), form[-1])
        total = total.xreplace(dict(self.velocities))
        still = dict.fromkeys(self.slots.velocities, sp.S.Zero)
        return (*(total.diff(v) for v in self.slots.velocities), total.xreplace(still))


def quasi_coordinates(problem: Problem) -> QuasiCoordinates | None:
    """The quasi-coordinates of the bodies whose angular velocity is given; None where there are none."""
    spins = {b.name: b.angular_velocity.fixed() for b in problem.bodies if b.angular_velocity is not None}
    found: list[sp.Symbol] = []
    angles: dict[sp.Symbol, sp.Symbol] = {}
    solved: dict[sp.Symbol, sp.Expr] = {}
    plain = _occurring(problem) if spins else set()
    for body, spin in spins.items():
        rates = _rates(spin, problem.slots)
        own = [q for q in _failing(rates, problem.slots) if q not in plain and q not in found]
        found += own
        if len(own) == 3:
            taken = problem.scope.names()
            names = (next(n for n in _names(body, k) if n not in taken) for k in range(3))
            new = tuple(sp.Symbol(n, real=True) for n in names)
            velocities = _solved(rates, own, new)
            if velocities is not None:
                angles |= dict(zip(own, new, strict=True))
                solved |= velocities
    if not found:
        return None
    slots = Slots(tuple(angles.get(q, q) for q in problem.slots.coordinates), problem.slots.prescribed)
    return QuasiCoordinates(tuple(q for q in problem.slots.coordinates if q in found), slots, solved)


def _names(body: str, number: int) -> Iterator[str]:
    n = 0
    while True:
        yield f"angle_{number + 1}_{body}{'_' * n}"
        n += 1


def _occurring(problem: Problem) -> set[sp.Symbol]:
    """The symbols that occur otherwise than by their velocities: in positions, axes, constraints."""
    vectors = [*(p.position for p in problem.masses), *(a for b in problem.bodies for a in b.axes)]
    vectors += [b.angular_velocity for b in problem.bodies if b.angular_velocity is not None]
    parts = [c for v in vectors for c in v.fixed().components] + [c.function for c in problem.constraints]
    return {s for e in parts for s in e.free_symbols}


def _rates(spin: Vector, slots: Slots) -> dict[sp.Symbol, Vector]:
    """Ω_k of each coordinate, and Ω_t, in i, j, k as ω is."""
    still = dict.fromkeys(slots.velocities, sp.S.Zero)
    return {**{q: spin.partial(prime(q)) for q in slots.coordinates}, t: spin.map(lambda c: c.xreplace(still))}


def _failing(rates: Mapping[sp.Symbol, Vector], slots: Slots) -> list[sp.Symbol]:
    """The coordinates of ω for which the condition on pairs fails."""
    turning = [q for q, w in rates.items() if not w.is_zero]
    failing: set[sp.Symbol] = set()
    for j, k in combinations(rates, 2):
        if j not in turning and k not in turning:
            continue
        bending = _derivative(rates[k], j, slots) - _derivative(rates[j], k, slots) - rates[j].cross(rates[k])
        if any(c != 0 and is_zero(c) is not True for c in bending.components):
            failing |= {j, k}
    return [q for q in turning if q in failing and q != t]


def _derivative(rate: Vector, by: sp.Symbol, slots: Slots) -> Vector:
    return rate.frozen_derivative(slots) if by == t else rate.partial(by)


def _solved(
    rates: Mapping[sp.Symbol, Vector], own: Sequence[sp.Symbol], angles: Sequence[sp.Symbol]
) -> dict[sp.Symbol, sp.Expr] | None:
    """The velocities of three quasi-coordinates, ω being that of three rotations; None where they do not follow."""
    matrix = sp.Matrix([rates[q].components for q in own]).T
    below = matrix.det(method="berkowitz")
    if is_zero(below) is not False:
        return None
    spin = angular_velocity(list(zip((3, 1, 3), angles, strict=True)), Slots(tuple(angles)))
    for q, w in rates.items():
        if q not in own:
            spin = spin - w * (sp.S.One if q == t else prime(q))
    values = matrix.adjugate() * sp.Matrix(spin.components)
    return {prime(q): value / below for q, value in zip(own, values, strict=True)}
