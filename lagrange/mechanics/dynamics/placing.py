"""How coordinates place particles and turn bodies, and the forces that a form stands for.

A particle can be placed along its vectors ∂r/∂q_k, a body also be turned about its ω_k. The form Σ a_k dq_k of a
constraint, for a multiplier 1, is the work of forces g_P and moments h_B with

    Σ_P g_P·∂r_P/∂q_k + Σ_B h_B·ω_Bk = a_k       for every coordinate q_k that moves something,

each g_P a combination of the ∂r_P/∂q_k, each h_B of the ω_Bk, about the mass centre. They are determined where the
coordinates place everything one by one: then g_P is ∂f/∂r_P for particles that are placed freely in space or a plane.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.exact import Surface
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.records import record
from lagrange.core.vectors import Triad, Vector
from lagrange.mechanics.constraints.kinematics import Configuration, Row


@record
class Freedom:
    """The ways in which one particle or mass centre can be placed, or one body turned.

    partials  shape (n,): ∂r/∂q_k, or ω_k
    triad     in which its components are
    basis     columns of the partials that are independent
    """

    name: str
    turning: bool
    partials: tuple[Vector, ...]
    triad: Triad
    basis: tuple[int, ...] = ()

    def moves(self, column: int) -> bool:
        """Whether a coordinate has anything to do with it."""
        return not self.partials[column].is_zero

    @property
    def units(self) -> list[Vector]:
        """The unit vectors along which a law is written: those of the coordinates, or of the triad.

        They span the directions in which it can be placed, or the axes about which it can be turned.
        """
        partials = [p for p in self.partials if not p.is_zero]
        chosen = [self.partials[b] for b in self.basis]
        sizes = [textbook_form(p.dot(p)) for p in chosen]
        used = [n for n in range(3) if any(p.along(self.triad).components[n] != 0 for p in partials)]
        aligned = len(used) == len(self.basis)
        orthonormal = all(size == 1 for size in sizes) and all(
            textbook_form(a.dot(b)) == 0 for n, a in enumerate(chosen) for b in chosen[:n]
        )
        if aligned and not (orthonormal and len(partials) == len(self.basis)):
            units = [tuple(sp.S.One if n == m else sp.S.Zero for m in range(3)) for n in used]
            return [Vector(u, self.triad) for u in units]
        return [(p / _root(size)).map(textbook_form) for p, size in zip(chosen, sizes, strict=True)]


Placed = tuple[Freedom, ...]


@record
class Forces:
    """The forces on particles and mass centres, and the moments on bodies, that a form stands for."""

    forces: Mapping[str, Vector]
    moments: Mapping[str, Vector]


def placed_freely(configuration: Configuration) -> Placed | None:
    """What the coordinates place, one by one; None where they keep constraints by themselves."""
    everything = _freedoms(configuration)
    moved = _moved(everything, configuration)
    anywhere = Surface((), configuration.slots.coordinates)
    chosen: list[Freedom] = []
    reached: set[int] = set()
    for freedom, needed in everything:
        columns = [k for k in moved if freedom.moves(k)]
        if not columns or (not needed and reached.issuperset(columns)):
            continue
        reached.update(columns)
        basis: list[int] = []
        for k in columns:
            if anywhere.rank([freedom.partials[n].components for n in (*basis, k)]) == len(basis) + 1:
                basis.append(k)
        chosen.append(replace(freedom, basis=tuple(basis)))
    total = sum(len(f.basis) for f in chosen)
    if total != len(moved) or not chosen or not _act_where_they_are(configuration):
        return None
    stacked = [[c for f in chosen for c in f.partials[k].fixed().components] for k in moved]
    if configuration.states.rank(stacked) != total:
        return None
    order = [p.name for p in configuration.points]
    return tuple(sorted(chosen, key=lambda f: (order.index(f.name), f.turning)))


def left_out(row: Row, configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The coefficients of coordinates that move nothing."""
    moved = _moved(_freedoms(configuration), configuration)
    pairs = enumerate(zip(configuration.slots.coordinates, row.coefficients, strict=True))
    return {q: a for k, (q, a) in pairs if a != 0 and k not in moved}


def form_as_forces(row: Row, placed: Placed, surface: Surface) -> Forces | None:
    """The forces and moments that a form stands for; None: not found."""
    moved = [k for k, _ in enumerate(row.coefficients) if any(f.moves(k) for f in placed)]
    if all(row.coefficients[k] == 0 for k in moved):
        return Forces({}, {})
    columns = [(f, b) for f in placed for b in f.basis]
    matrix = [
        [textbook_form(f.partials[b].dot(f.partials[k])) if f.moves(k) else sp.S.Zero for f, b in columns]
        for k in moved
    ]
    found = solved_linear(matrix, [row.coefficients[k] for k in moved], surface)
    if found is None or None in found:
        return None
    total: dict[bool, dict[str, Vector]] = {False: {}, True: {}}
    for (f, b), c in zip(columns, found, strict=True):
        if c != 0 and c is not None:
            there = total[f.turning]
            there[f.name] = there.get(f.name, Vector.zero(f.triad)) + f.partials[b] * c
    return Forces(_tidied(total[False]), _tidied(total[True]))


def _root(square: sp.Expr) -> sp.Expr:
    """A square root: the sense of a unit vector is free, so that R − r and a sin θ serve as well as their magnitudes,
    and 2a cos(φ/2) for the root of 2a² (1 + cos φ).
    """
    factors = sp.Mul.make_args(textbook_form(sp.sqrt(square)))
    root = sp.Mul(*(f.args[0] if isinstance(f, sp.Abs) else _half_angle(f) for f in factors))
    return textbook_form(root)


def _half_angle(factor: sp.Expr) -> sp.Expr:
    """√(1 + cos φ) as √2 cos(φ/2), √(1 − cos φ) as √2 sin(φ/2), and what else there may be as it is."""
    below, exponent = factor.as_base_exp()
    number, wave = (below - 1).as_coeff_Mul()
    if exponent != sp.Rational(1, 2) or abs(number) != 1 or not isinstance(wave, sp.cos):
        return factor
    half = wave.args[0] / 2
    return sp.sqrt(2) * (sp.cos(half) if number == 1 else sp.sin(half))


def _tidied(vectors: Mapping[str, Vector]) -> dict[str, Vector]:
    tidied = {name: g.map(lambda c: textbook_form(c) if c.count_ops() > 1 else c) for name, g in vectors.items()}
    return {name: g for name, g in tidied.items() if not g.is_zero}


def _freedoms(configuration: Configuration) -> list[tuple[Freedom, bool]]:
    """Everything that can be placed or turned, and whether it has inertia or is acted on; such things first."""
    loaded = {load.on for load in configuration.loads}
    found = []
    for p in configuration.points:
        found.append((Freedom(p.name, False, p.partials, p.position.triad), p.mass != 0, p.name in loaded))
    for r in configuration.rotations:
        turned = bool(configuration.moments_on(r.name))
        found.append((Freedom(r.name, True, r.partials, r.angular_velocity.triad), r.has_inertia, turned))
    found.sort(key=lambda item: (not item[1], not item[2]))
    return [(freedom, heavy or acted_on) for freedom, heavy, acted_on in found]


def _moved(everything: Iterable[tuple[Freedom, bool]], configuration: Configuration) -> list[int]:
    freedoms = [f for f, _ in everything]
    return [k for k, _ in enumerate(configuration.slots.coordinates) if any(f.moves(k) for f in freedoms)]


def _act_where_they_are(configuration: Configuration) -> bool:
    """Whether every applied force acts at its particle, and not beside it; on a body it may act anywhere."""
    positions = {p.name: p.position for p in configuration.points}
    turning = {r.name for r in configuration.rotations}
    return all(
        f.on in turning or (f.on in positions and (f.point - positions[f.on]).is_zero) for f in configuration.loads
    )
