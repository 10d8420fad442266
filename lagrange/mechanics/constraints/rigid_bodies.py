"""Rotation of a rigid body in a configuration: ω, the virtual rotation δπ, the angular momentum H and dH/dt.

    ω = Σ ω_k q_k' + ω_t ,    δπ = Σ ω_k δq_k ,    H = J ω = A ω_1 e_1 + B ω_2 e_2 + C ω_3 e_3 in principal axes ,

about the mass centre, in a triad e_1, e_2, e_3 in which the tensor of inertia J is constant. The triad turns with an
angular velocity Ω of its own, Ω = ω where it is fixed in the body, and

    dH/dt = J ω' + Ω × H          (ω' with its components differentiated).

δπ is not the variation of any function: the ω_k need not be derivatives, and the q_k may be quasi-coordinates.
Reference: Whittaker, Analytical Dynamics, §§ 62-64.

Quasi-coordinates of bodies, and constraints rewritten in true coordinates.

A file may give an angular velocity by its components: ω = α' i + β' j + γ' k. Then the orientation is not a function of
α, β, γ, and dα is not the differential of a function: x' = R β' does not integrate to x = R β + const. The rates Ω_k of
ω = Σ Ω_k q_k' + Ω_t belong to true coordinates if and only if one rotation matrix R(q, t) has them, ∂R/∂q_k = Ω_k × R,
which requires, with components in i, j, k,

    ∂Ω_k/∂q_j − ∂Ω_j/∂q_k = Ω_j × Ω_k       for all pairs, t included        (Maurer, Cartan) .

Coordinates for which this fails and of which only the velocities occur are quasi-coordinates. Up to three of them with
independent Ω_k can be replaced by three angles: their velocities follow from the ω of a sequence of rotations, and a
form becomes one in true coordinates, to which Frobenius' theorem applies. One or two of them also restrict the
rotation: the components of ω along the unit vectors that complete the Ω_k to a basis vanish, one form each in the
angles. With more than three the question is left undecided.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.inertia import InertiaTensor
from lagrange.core.records import record
from lagrange.core.symbols import Slots, prime, t
from lagrange.core.vectors import Axes, Vector, angular_velocity, triad_in, turning_rate
from lagrange.problem.model import Body, Problem


@record
class Rotation:
    """The rotation of one body.

    axes              the axes that the tensor of inertia refers to, in i, j, k
    inertia           J along the axes of the triad in which the vectors here have their components
    angular_velocity  ω
    partials          shape (n,): ω_k
    momentum          H, about the mass centre
    momentum_rate     dH/dt
    given             whether the file gives ω and the axes separately
    """

    name: str
    axes: Axes
    inertia: InertiaTensor
    angular_velocity: Vector
    partials: tuple[Vector, ...]
    momentum: Vector
    momentum_rate: Vector
    given: bool

    @property
    def has_inertia(self) -> bool:
        """Whether any moment of inertia is not 0."""
        return not self.inertia.is_zero

    def virtual(self, steps: Sequence[sp.Expr]) -> Vector:
        """Σ ω_k s_k, for s of shape (n,)."""
        total = Vector.zero(self.angular_velocity.triad)
        for partial, step in zip(self.partials, steps, strict=True):
            total = total + partial * step
        return total


def rotation_of(body: Body, slots: Slots) -> Rotation:
    """The rotation of a body in the coordinates of the file."""
    oriented = body.orientation(slots)
    given = body.angular_velocity is not None
    return _rotation(body.name, oriented.axes, oriented.inertia, oriented.angular_velocity, given, slots)


def rotation_in(
    rotation: Rotation, expressed: dict[sp.Symbol, sp.Expr], rule: dict[sp.Basic, sp.Basic], slots: Slots
) -> Rotation:
    """The rotation in other coordinates; `expressed` gives each replaced coordinate, `rule` its derivatives as well."""
    triad = triad_in(rotation.angular_velocity.triad, expressed, slots)
    spin = Vector(rotation.angular_velocity.components, triad).map(lambda c: c.xreplace(rule))
    first, second, third = (axis.xreplace(rule) for axis in rotation.axes)
    return _rotation(rotation.name, (first, second, third), rotation.inertia, spin, rotation.given, slots)


def _rotation(name: str, axes: Axes, inertia: InertiaTensor, spin: Vector, given: bool, slots: Slots) -> Rotation:
    partials = tuple(spin.map(lambda c, q=q: c.diff(prime(q))) for q in slots.coordinates)  # type: ignore[misc]
    momentum = Vector(inertia.times(spin.components), spin.triad)
    return Rotation(name, axes, inertia, spin, partials, momentum, momentum.time_derivative(slots), given)


def relative_to_triad(rotation: Rotation, slots: Slots) -> tuple[sp.Expr, ...]:
    """The expressions that vanish if the tensor of inertia is constant in the triad: (A − B) (ω − Ω)·e_3, and so on.

    There are none unless the file gives ω and the axes separately.
    """
    if not rotation.given:
        return ()
    spin = rotation.angular_velocity
    relative = (spin - turning_rate(spin.triad, slots)).components
    if not rotation.inertia.is_principal:
        return tuple(e for e in rotation.inertia.turned_with(relative) if e != 0)
    a, b, c = rotation.inertia.moments
    pairs = ((b - c, relative[0]), (c - a, relative[1]), (a - b, relative[2]))
    return tuple(difference * w for difference, w in pairs if difference != 0 and w != 0)


# Quasi coordinates


Form = tuple[sp.Expr, ...]


@record
class QuasiCoordinates:
    """The quasi-coordinates of a problem.

    coordinates   in the order of the problem
    slots         the problem's, with angles instead of the quasi-coordinates that can be replaced; further angles last
    velocities    of the replaced ones, in terms of the velocities of the angles and of the others
    restrictions  forms over `slots`, dt last, that vanish because ω has fewer than three quasi-coordinates
    """

    coordinates: tuple[sp.Symbol, ...]
    slots: Slots
    velocities: Mapping[sp.Symbol, sp.Expr]
    restrictions: tuple[Form, ...]

    def used_by(self, form: Sequence[sp.Expr], slots: Slots) -> tuple[sp.Symbol, ...]:
        """The quasi-coordinates whose differentials occur in a form over `slots`, dt last."""
        return tuple(q for q, a in zip(slots.coordinates, form, strict=False) if a != 0 and q in self.coordinates)

    def in_angles(self, form: Sequence[sp.Expr], slots: Slots) -> Form | None:
        """A form of shape (n + 1,) in true coordinates; None if these were not found."""
        if any(prime(q) not in self.velocities for q in self.used_by(form, slots)):
            return None
        total = sp.Add(*(a * v for a, v in zip(form, slots.velocities, strict=False)), form[-1])
        return _form(total.xreplace(dict(self.velocities)), self.slots)


def quasi_coordinates(problem: Problem) -> QuasiCoordinates | None:
    """The quasi-coordinates of the bodies whose angular velocity is given; None if there are none."""
    spins = {b.name: b.angular_velocity.fixed() for b in problem.bodies if b.angular_velocity is not None}
    quasi: list[sp.Symbol] = []
    angles: dict[sp.Symbol, sp.Symbol] = {}
    further: list[sp.Symbol] = []
    solved: dict[sp.Symbol, sp.Expr] = {}
    vanishing: list[sp.Expr] = []
    plain = _occurring(problem) if spins else set()
    for body, spin in spins.items():
        rates = _rates(spin, problem.slots)
        own = [q for q in _failing(rates, problem.slots) if q not in plain and q not in quasi]
        quasi += own
        if 0 < len(own) <= 3:
            taken = problem.scope.names()
            names = (next(n for n in _names(body, k) if n not in taken) for k in range(3))
            new = tuple(sp.Symbol(n, real=True) for n in names)
            turned = _solved(rates, own, new)
            if turned is not None:
                velocities, restrictions = turned
                angles |= dict(zip(own, new, strict=False))
                further += new[len(own) :]
                solved |= velocities
                vanishing += restrictions
    if not quasi:
        return None
    slots = Slots((*(angles.get(q, q) for q in problem.slots.coordinates), *further), problem.slots.prescribed)
    forms = tuple(_form(e.xreplace(solved), slots) for e in vanishing)
    return QuasiCoordinates(tuple(q for q in problem.slots.coordinates if q in quasi), slots, solved, forms)


def _form(linear: sp.Expr, slots: Slots) -> Form:
    """The coefficients of the differentials in what is linear in the velocities, dt last."""
    at_rest = dict.fromkeys(slots.velocities, sp.S.Zero)
    return (*(linear.diff(v) for v in slots.velocities), linear.xreplace(at_rest))


def _names(body: str, number: int) -> Iterator[str]:
    n = 0
    while True:
        yield f"angle_{number + 1}_{body}{'_' * n}"
        n += 1


def _occurring(problem: Problem) -> set[sp.Symbol]:
    """The symbols that occur themselves, and not only through their velocities: in positions, axes, constraints."""
    vectors = [*(p.position for p in problem.masses), *(a for b in problem.bodies for a in b.axes)]
    vectors += [b.angular_velocity for b in problem.bodies if b.angular_velocity is not None]
    parts = [c for v in vectors for c in v.fixed().components] + [c.function for c in problem.constraints]
    return {s for e in parts for s in e.free_symbols}


def _rates(spin: Vector, slots: Slots) -> dict[sp.Symbol, Vector]:
    """Ω_k of each coordinate, and Ω_t, in i, j, k as ω is."""
    at_rest = dict.fromkeys(slots.velocities, sp.S.Zero)
    return {**{q: spin.partial(prime(q)) for q in slots.coordinates}, t: spin.map(lambda c: c.xreplace(at_rest))}


def _failing(rates: Mapping[sp.Symbol, Vector], slots: Slots) -> list[sp.Symbol]:
    """The coordinates of ω for which the condition on pairs fails."""
    turning = [q for q, w in rates.items() if not w.is_zero]
    failing: set[sp.Symbol] = set()
    for j, k in combinations(rates, 2):
        if j not in turning and k not in turning:
            continue
        defect = _derivative(rates[k], j, slots) - _derivative(rates[j], k, slots) - rates[j].cross(rates[k])
        if any(c != 0 and is_zero(c) is not True for c in defect.components):
            failing |= {j, k}
    return [q for q in turning if q in failing and q != t]


def _derivative(rate: Vector, by: sp.Symbol, slots: Slots) -> Vector:
    return rate.frozen_derivative(slots) if by == t else rate.partial(by)


def _solved(
    rates: Mapping[sp.Symbol, Vector], own: Sequence[sp.Symbol], angles: Sequence[sp.Symbol]
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]] | None:
    """The velocities of quasi-coordinates with ω that of a sequence of rotations, and what must vanish besides.

    None if they are not determined.
    """
    spin = angular_velocity(list(zip((3, 1, 3), angles, strict=True)), Slots(tuple(angles)))
    for q, w in rates.items():
        if q not in own:
            spin = spin - w * (sp.S.One if q == t else prime(q))
    columns = [rates[q].components for q in own]
    units = [tuple(sp.Integer(i == k) for i in range(3)) for k in range(3)]
    for completing in combinations(units, 3 - len(own)):
        matrix = sp.Matrix([*columns, *completing]).T
        determinant = matrix.det(method="berkowitz")
        if is_zero(determinant) is False:
            values = [*(matrix.adjugate() * sp.Matrix(spin.components))]
            velocities = {prime(q): value / determinant for q, value in zip(own, values, strict=False)}
            return velocities, values[len(own) :]
    return None
