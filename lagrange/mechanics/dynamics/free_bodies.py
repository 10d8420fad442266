"""The forces that a constraint form stands for, and the constraints that keep a distance.

A particle can be placed along its vectors ∂r/∂q_k, and a body can also be turned about its ω_k. The form Σ a_k dq_k is,
for a multiplier 1, the work of forces g_P and of moments h_B about the mass centres with

    Σ_P g_P·∂r_P/∂q_k + Σ_B h_B·ω_Bk = a_k       for every coordinate q_k that moves something,

each g_P a combination of the ∂r_P/∂q_k, each h_B of the ω_Bk. They are determined where the coordinates place
everything one by one; then g_P = ∂f/∂r_P for particles that are placed freely in space or in a plane.

A relation f(q, t) = 0 keeps P and Q at a distance if and only if its gradient is, everywhere on it, parallel to that of
d·d, d = r_P − r_Q: then d·d is constant on it at a fixed time. The reaction is along d,

    R_P = λ κ d = −T d/|d| ,     R_Q = −R_P ,     T = −κ |d| λ :

T > 0 is a tension, T < 0 a thrust. Q may be a fixed point, or a driven one; then f does not distinguish a rod from a
sphere. The relation is recognised by its gradient, never by its name.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import Surface, is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear, tidy_quotient
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, partial
from lagrange.core.vectors import Triad, Vector
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.coordinates import solved_constraints
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.problem.model import Constraint

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.rigid_bodies import Rotation


@record
class Freedom:
    """The ways in which one particle or mass centre can be placed, or one body turned.

    partials  shape (n,): ∂r/∂q_k, or ω_k
    triad     of the components of the law
    basis     indices of independent partials
    """

    name: str
    turning: bool
    partials: tuple[Vector, ...]
    triad: Triad
    basis: tuple[int, ...] = ()

    def moves(self, column: int) -> bool:
        """Whether a coordinate moves it."""
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
    """The forces on particles and mass centres, and the moments on bodies, equivalent to a form."""

    forces: Mapping[str, Vector]
    moments: Mapping[str, Vector]


def placed_freely(configuration: Configuration) -> Placed | None:
    """What the coordinates place, one by one; None if they satisfy some constraints by themselves."""
    everything = _freedoms(configuration)
    moved = _moved(everything, configuration)
    anywhere = Surface((), configuration.slots.coordinates)
    chosen: list[Freedom] = []
    reached: set[int] = set()
    for freedom, needed in everything:
        columns = [k for k in moved if freedom.moves(k)]
        if not columns or (not needed and sum(len(f.basis) for f in chosen) == len(reached.union(columns))):
            continue  # the coordinates are placed without it; a bar by its foot and its angle needs both
        reached.update(columns)
        basis: list[int] = []
        used = sum(any(freedom.partials[k].components[n] != 0 for k in columns) for n in range(3))
        for k in columns:
            if (
                len(basis) < used
                and anywhere.rank([freedom.partials[n].components for n in (*basis, k)]) == len(basis) + 1
            ):
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


def idle_forces(row: Row, configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The nonzero coefficients of coordinates that move nothing."""
    moved = _moved(_freedoms(configuration), configuration)
    pairs = enumerate(zip(configuration.slots.coordinates, row.coefficients, strict=True))
    return {q: a for k, (q, a) in pairs if a != 0 and k not in moved}


def form_as_forces(row: Row, placed: Placed, surface: Surface) -> Forces | None:
    """The forces and moments equivalent to a form; None: not found."""
    moved = [k for k, _ in enumerate(row.coefficients) if any(f.moves(k) for f in placed)]
    if all(row.coefficients[k] == 0 for k in moved):
        return Forces({}, {})
    columns = [(f, b) for f in placed for b in f.basis]
    matrix = [
        [textbook_form(f.partials[b].dot(f.partials[k])) if f.moves(k) else sp.S.Zero for f, b in columns]
        for k in moved
    ]
    shares = solved_linear(matrix, [row.coefficients[k] for k in moved], surface)
    if shares is None or None in shares:
        return None
    total: dict[bool, dict[str, Vector]] = {False: {}, True: {}}
    for (f, b), c in zip(columns, shares, strict=True):
        if c != 0 and c is not None:
            vectors = total[f.turning]
            vectors[f.name] = vectors.get(f.name, Vector.zero(f.triad)) + f.partials[b] * c
    return Forces(_tidied(total[False]), _tidied(total[True]))


def without_root(row: Row, slots: Slots) -> Row:
    """The row of k (S − l²)/(2l) = 0 for k (√S − l) = 0: the same gradient and multiplier where they hold."""
    coordinates = {*slots.coordinates}
    if row.finite is None:
        return row
    roots = [e for e in row.finite.atoms(sp.Pow) if e.exp == sp.Rational(1, 2) and e.free_symbols & coordinates]
    if len(roots) != 1:
        return row
    length = sp.Dummy("length", positive=True)
    linear = sp.expand(row.finite.xreplace({roots[0]: length}))
    share, rest = linear.coeff(length), linear.coeff(length, 0)
    value = tidy_quotient(-rest / share) if share != 0 else sp.S.Zero
    is_linear = linear == sp.expand(share * length + rest) and value != 0
    if not is_linear or (share.free_symbols | value.free_symbols) & coordinates:
        return row
    finite = share * (roots[0].base - value**2) / (2 * value)
    coefficients = tuple(finite.diff(q) for q in slots.coordinates)
    return replace(row, coefficients=coefficients, drift=slots.frozen_derivative(finite), finite=finite)


def _root(square: sp.Expr) -> sp.Expr:
    """A square root of either sign, because the sense of a unit vector is free: R − r and a sin θ without their moduli,
    2a cos(φ/2) for the root of 2a² (1 + cos φ).
    """
    factors = sp.Mul.make_args(textbook_form(sp.sqrt(square)))
    root = sp.Mul(*(f.args[0] if isinstance(f, sp.Abs) else _half_angle(f) for f in factors))
    return textbook_form(root)


def _half_angle(factor: sp.Expr) -> sp.Expr:
    """√(1 + cos φ) as √2 cos(φ/2), √(1 − cos φ) as √2 sin(φ/2); any other factor unchanged."""
    below, exponent = factor.as_base_exp()
    number, wave = (below - 1).as_coeff_Mul()
    if exponent != sp.Rational(1, 2) or abs(number) != 1 or not isinstance(wave, sp.cos):
        return factor
    half = wave.args[0] / 2
    return sp.sqrt(2) * (sp.cos(half) if number == 1 else sp.sin(half))


def _tidied(vectors: Mapping[str, Vector]) -> dict[str, Vector]:
    tidied = {name: g.map(lambda c: textbook_form(c) if count_operations(c) > 1 else c) for name, g in vectors.items()}
    return {name: g for name, g in tidied.items() if not g.is_zero}


def _freedoms(configuration: Configuration) -> list[tuple[Freedom, bool]]:
    """Everything that can be placed or turned, and whether it has inertia or is acted on; such things first."""
    loaded = {load.on for load in configuration.loads}
    marks = marks_on_bodies(configuration)
    ranked = []
    for p in configuration.points:
        if p.name in marks:
            continue
        ranked.append((Freedom(p.name, False, p.partials, p.position.triad), p.mass != 0, p.name in loaded))
    for r in configuration.rotations:
        turned = bool(configuration.moments_on(r.name))
        ranked.append((Freedom(r.name, True, r.partials, r.angular_velocity.triad), r.has_inertia, turned))
    ranked.sort(key=lambda item: (not item[1], not item[2]))
    return [(freedom, heavy or acted_on) for freedom, heavy, acted_on in ranked]


def marks_on_bodies(configuration: Configuration) -> frozenset[str]:
    """Massless points on which nothing acts and that move with a rigid body, as a named point of it: no particles."""
    loaded = {load.on for load in configuration.loads}
    centres = {p.name: p for p in configuration.points}
    turning = {r.name for r in configuration.rotations}
    return frozenset(
        p.name
        for p in configuration.points
        if p.mass == 0 and p.name not in loaded | turning
        for r in configuration.rotations
        if _moves_with(p, centres[r.name], r)
    )


def _moves_with(p: MassPoint, centre: MassPoint, rotation: Rotation) -> bool:
    """Whether ∂r/∂q = ∂r_G/∂q + (∂ω/∂q') × (r − r_G) for all coordinates."""
    arm = (p.position - centre.position).fixed()
    rates = zip(p.partials, centre.partials, rotation.partials, strict=True)
    return all((a.fixed() - b.fixed() - w.fixed().cross(arm)).map(textbook_form).is_zero for a, b, w in rates)


def _moved(everything: Iterable[tuple[Freedom, bool]], configuration: Configuration) -> list[int]:
    freedoms = [f for f, _ in everything]
    return [k for k, _ in enumerate(configuration.slots.coordinates) if any(f.moves(k) for f in freedoms)]


def _act_where_they_are(configuration: Configuration) -> bool:
    """Whether every applied force on a particle acts at its position; on a body it may act anywhere."""
    positions = {p.name: p.position for p in configuration.points}
    turning = {r.name for r in configuration.rotations}
    return all(
        f.on in turning or (f.on in positions and (f.point - positions[f.on]).is_zero) for f in configuration.loads
    )


@record
class Rod:
    """A constant or prescribed distance between two points.

    ends    names of the points; the second is empty if it is not a particle
    centre  the second end, if it is not a particle
    span    d = r_P − r_Q, or r_P − centre
    length  |d|, as the constraint gives it
    ratio   κ
    factor  T = factor · λ, a tension where positive
    """

    ends: tuple[str, str]
    centre: Vector | None
    span: Vector
    length: sp.Expr
    ratio: sp.Expr
    factor: sp.Expr


def recognised_rod(
    row: Row, configuration: Configuration, directions: dict[str, Vector], stated: sp.Expr | None = None
) -> Rod | None:
    """The distance that a constraint keeps; None if it is not a distance constraint, or not recognised as one.

    It has another length than the stated one only where no distance from a known point has that: for a collar on a
    straight guide x² + h² = c² is x² = c² − h² as well. Where a body has one coordinate, whatever holds it keeps its
    distance from every point.

    directions  of the constraint's reactions on particles, R_P = λ · direction
    """
    slots, surface = configuration.slots, configuration.states
    if row.finite is None or not 1 <= len(directions) <= 2:
        return None
    ways = [sum(not v.is_zero for v in p.partials) for p in configuration.points if p.name in directions]
    if stated is None and ways == [1]:
        return None
    other: Rod | None = None
    for ends, centre, d in _candidates(configuration.points, directions, slots):
        squared = textbook_form(d.dot(d))
        slopes = [partial(squared, q) for q in slots.coordinates]
        ratio = _ratio(row, slopes, surface)
        if ratio is not None:
            length = _length(row, d, squared, ratio, slots)
            if length is None:
                continue
            factor = _where_it_holds(textbook_form(-(ratio * length).xreplace({squared: length**2})), row, slots)
            rod = Rod(ends, centre, d, length, ratio, factor)
            if is_length(length, stated):
                return rod
            other = other or rod
    return other


def stated_length(constraint: Constraint, row: Row, placed: Placed | None, slots: Slots) -> sp.Expr | None:
    """L of √S = L, and of S = L² where a body has one coordinate; None if the equation states no length so."""
    side = constant_side(constraint, row, slots)
    if side is None or side == 0 or placed is None:
        return None
    size = side if side.is_nonnegative else -side if side.is_nonpositive else abs(side)
    if without_root(row, slots) is not row:
        return size
    powers = [e for f in sp.Mul.make_args(size) if not f.is_number for e in [f.as_base_exp()[1]]]
    is_square = bool(powers) and all(e.is_even for e in powers)
    return sp.sqrt(size) if is_square and all(len(f.basis) == 1 for f in placed if not f.turning) else None


def constant_side(constraint: Constraint, row: Row, slots: Slots) -> sp.Expr | None:
    """−b of a − b, or a, where that side of the equation a = b has no coordinates; None if neither is so."""
    if row.finite is None or isinstance(constraint.lhs, Vector) or isinstance(constraint.rhs, Vector):
        return None
    sides = (-constraint.rhs, constraint.lhs) if row.finite == constraint.lhs - constraint.rhs else ()
    return next((side for side in sides if side.free_symbols.isdisjoint(slots.coordinates)), None)


def share_of_polygon(row: Row, constant: sp.Expr | None, slots: Slots) -> sp.Expr | None:
    """T/λ of f = ±c (ℓ² − L²) where ℓ closes a polygon: ℓ² = Σ ℓ_i² + 2 Σ ℓ_i ℓ_j cos φ_ij, as x² + r² − 2 r x cos φ.

    Whatever the ends are: a slider, a crank, of which the coordinates show a part of the force only.

    constant  ∓c L², as the equation is written
    """
    if row.finite is None or constant is None or not (constant.is_negative or constant.is_positive):
        return None
    sign = 1 if constant.is_negative else -1
    terms = [e.as_coeff_Mul() for e in sp.Add.make_args(sp.expand(textbook_form(sign * (row.finite - constant))))]
    squares = {e.base: share for share, e in terms if e.is_Pow and e.exp == 2 and e.base.is_Symbol}
    turning = {s for _, e in terms for wave in e.atoms(sp.sin, sp.cos) for s in wave.free_symbols}
    if len({*squares.values()}) != 1 or turning.isdisjoint(slots.coordinates) or turning & {*squares}:
        return None
    share = next(iter(squares.values()))
    for number, e in terms:
        factors = {*sp.Mul.make_args(e)}
        sides, waves = factors & {*squares}, factors - {*squares}
        is_square = e.is_Pow and e.base in squares
        is_mixed = abs(number) == 2 * share and len(sides) == 2 and all(isinstance(w, sp.sin | sp.cos) for w in waves)
        if not is_square and not is_mixed:
            return None
    return -2 * sign * share * sp.sqrt(abs(constant) / share)


def is_length(length: sp.Expr, stated: sp.Expr | None) -> bool:
    """Whether a length may be the stated one, up to a number; also where none is stated."""
    if stated is None or tidy_quotient(length / stated).is_number:
        return True
    return is_zero(length**2 - stated**2) is not False  # of d + a cos(omega t) the square is written in 2 omega t


def along_rod(rod: Rod, directions: Mapping[str, Vector]) -> dict[str, Vector]:
    """The full force of a rod for λ = 1, even if the coordinates by themselves take up a part of it."""
    first, second = rod.ends
    full = dict(directions)
    for name, sign in ((first, 1), (second, -1)):
        force = (rod.span * (sign * rod.ratio)).map(textbook_form)
        if name and not (force - directions.get(name, Vector.zero())).map(textbook_form).is_zero:
            full[name] = force
    return full


def _where_it_holds(e: sp.Expr, row: Row, slots: Slots) -> sp.Expr:
    """An expression after solving the constraint for one coordinate, if it contains none then: d/(x_1 − x_2) is 1."""
    used = [q for q in slots.coordinates if row.finite is not None and q in row.finite.free_symbols]
    if e.free_symbols.isdisjoint(slots.coordinates) or not used:
        return e
    solved = textbook_form(e.xreplace(dict(solved_constraints([row], used[-1:]).expressed)))
    return solved if solved.free_symbols.isdisjoint(slots.coordinates) else e


def _candidates(
    points: Sequence[MassPoint], directions: dict[str, Vector], slots: Slots
) -> Iterator[tuple[tuple[str, str], Vector | None, Vector]]:
    """The pairs of points that may be kept at a distance, with the vector from the second to the first."""
    if len(directions) == 2:
        chosen = [p for p in points if p.name in directions]
        for p, q in combinations(chosen, 2):
            yield (p.name, q.name), None, p.position - q.position
        return
    [name] = directions
    point = next(p for p in points if p.name == name)
    yield (name, ""), Vector.zero(), point.position
    for p in (p for p in points if p.name != name and all(v.is_zero for v in p.partials)):
        yield (name, ""), p.position.fixed(), point.position.fixed() - p.position.fixed()
    centre = _centre(point, directions[name], slots)
    if centre is not None and not centre.is_zero:
        yield (name, ""), centre, point.position.fixed() - centre


def _centre(point: MassPoint, direction: Vector, slots: Slots) -> Vector | None:
    """The point c with direction = μ (r − c), μ constant: the centre of a circle or sphere given by squares."""
    gradient = direction.fixed()
    for q, tangent in zip(slots.coordinates, point.partials, strict=True):
        along = tangent.fixed()
        size = textbook_form(along.dot(along))
        if size == 0:
            continue
        rate = textbook_form(gradient.partial(q).dot(along) / size)
        if rate == 0 or rate.free_symbols & {*slots.coordinates}:
            return None
        centre = (point.position.fixed() - gradient / rate).map(textbook_form)
        is_fixed = all(c.free_symbols.isdisjoint(slots.coordinates) for c in centre.components)
        return centre if is_fixed else None
    return None


def _ratio(row: Row, slopes: Sequence[sp.Expr], surface: Surface) -> sp.Expr | None:
    """κ with ∂f/∂q = κ/2 ∂(d·d)/∂q where the constraint holds; None if there is none, or it is undecided."""
    pivot = next((k for k, s in enumerate(slopes) if s != 0 and surface.is_zero(s) is False), None)
    if pivot is None:
        return None
    a, b = row.coefficients[pivot], slopes[pivot]
    for a_k, b_k in zip(row.coefficients, slopes, strict=True):
        minor = a_k * b - b_k * a
        if minor != 0 and surface.is_zero(minor) is not True:
            return None
    return tidy_quotient(2 * a / b)


def _length(row: Row, d: Vector, squared: sp.Expr, ratio: sp.Expr, slots: Slots) -> sp.Expr | None:
    """|d| as the constraint gives it, free of coordinates; or the coordinate that is the distance."""
    assert row.finite is not None
    moving = set(slots.coordinates)
    shown = [c for c in d.components if c != 0]
    if d.triad.directions is not None and len(shown) == 1 and shown[0] in moving:
        return shown[0]
    square = None
    if ratio.free_symbols.isdisjoint(moving):
        square = sp.factor(textbook_form(squared - 2 * row.finite / ratio))
    if square is None or square.free_symbols & moving:
        square = _by_elimination(row, squared, slots)
    if square is None or square.free_symbols & moving:
        return None
    return sp.sqrt(square)


def _by_elimination(row: Row, squared: sp.Expr, slots: Slots) -> sp.Expr | None:
    """d·d after solving the constraint for one coordinate."""
    used = [q for q in slots.coordinates if q in row.finite.free_symbols]  # type: ignore[union-attr]
    solution = solved_constraints([row], used[-1:])
    if not solution.expressed:
        return None
    return sp.factor(textbook_form(squared.xreplace(dict(solution.expressed))))
