"""The sign convention of a reaction: of its multiplier, and of the force that the name of the reaction stands for.

Newton's law is m r'' = F + R with R = +λ ∂f/∂r, so that λ > 0 pushes to where f = left − right increases. λ belongs to
the equation f = 0 as it is written: for 2f = 0 it is half as large, and for −f = 0 it has the other sign. The force
does not depend on the writing. With R_P = λ g_P (`free_bodies`) there are three cases.

*Tension.* A constraint keeps a length, or a sum of lengths Σ n_i ℓ_i, if f = k (Σ n_i ℓ_i − L) with constant k, n_i, L.
The tension does the work −T Σ n_i δℓ_i = λ δf, so that

    T = −k λ ,          T > 0 where it pulls;      f = c (d·d − l²) has k = 2 c l.

ℓ = |d| is the distance between two points, each at rest or on a particle or body, if d depends on the places of the
particles and mass centres as r_A − r_B does: ∂d/∂q = ∂r_A/∂q − ∂r_B/∂q for every coordinate that turns neither. On a
straight line the coordinate itself may be the length, or the difference of two, x_1 − x_2 = d, or from a pulley without
mass, whose coordinate p moves nothing else: (x − p) + (y − p) = L. It grows or decreases toward the pulley; a weight
tells which, because a string that passes over a pulley holds it up. A constraint that is called a string, or is kept
`by` one, may have terms of both signs, z − x = L; if it shows no length at all, it pulls against the weight. Where
the coordinates do not show the ends, as in 2l sin θ = c or the distance of the end of a boom from a hook, the whole
of what equals the length L is ℓ.

*Force along a unit vector.* Otherwise, if R acts on one body along a line, or with opposite signs on two,

    R = N n ,      n = g/|g| ,      N = |g| λ .

n points to where left minus right increases; for a one-sided constraint to the permitted side, so that n = −g/|g| if f
≤ 0 is permitted. |g| is written without the moduli of lengths and of single sines and cosines, as for ranges in which
these are positive.

*Neither.* A moment, forces on several bodies, or coordinates that do not place the bodies: the name is the multiplier.
So it is where a coordinate leads a body along a curve, as of the force of a wall on a pendulum, l sin θ ≤ d.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from enum import StrEnum
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.on_a_curve import where_zero
from lagrange.algebra.exact.zero_test import DivisionByZeroError, Surface
from lagrange.algebra.fourier.linear_systems import shorter_product, tidy_quotient
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.dynamics.free_bodies import Forces, Placed, Rod, constant_side, form_as_forces, share_of_polygon
from lagrange.problem.model import Constraint, Keeper

SURFACES = frozenset({Keeper.SURFACE, Keeper.WIRE})
"""What presses at right angles, even if it keeps a distance."""


class ForceKind(StrEnum):
    """The kinds of single forces."""

    TENSION = "tension"
    ALONG = "along a unit vector"


@record
class SingleForce:
    """A reaction that is one force.

    factor     the force is factor · λ
    on         the particle or body that `direction` refers to; empty if the direction is not known
    direction  the unit vector of the force on it, where the force is positive
    opposite   the particle or body on which the opposite force acts, if there is one
    presumed   what is taken to be positive in |g|
    """

    kind: ForceKind
    factor: sp.Expr
    on: str = ""
    direction: Vector | None = None
    opposite: str = ""
    presumed: tuple[sp.Expr, ...] = ()


def tension_of_rod(rod: Rod, forces: Mapping[str, Vector]) -> SingleForce:
    """The tension of a rod; on its first end it is directed to the second.

    forces  for λ = 1: of r = R they are along e_r itself, and −d/R = −(r/R) e_r only where the constraint holds
    """
    direction = (rod.span * (-1 / rod.length)).map(tidy_quotient)
    pull = (forces[rod.ends[0]] * (1 / rod.factor)).map(tidy_quotient)
    if sum(map(count_operations, pull.components)) < sum(map(count_operations, direction.components)):
        direction = pull
    return SingleForce(ForceKind.TENSION, rod.factor, rod.ends[0], direction, rod.ends[1])


def single_force(
    row: Row,
    by: Keeper | None,
    acts: Forces | None,
    placed: Placed | None,
    configuration: Configuration,
    constraint: Constraint,
    rooted: Row,
    *,
    leads: bool = False,
    is_whole: bool = True,
) -> SingleForce | None:
    """The single force that a reaction is, if it is not that of a rod; None if it is none.

    Of a one-sided constraint it is positive where it pushes or pulls to the permitted side.

    acts      the forces and moments for λ = 1; None if they are not known
    rooted    the row as it is written, with √S = l where `row` has S = l²
    leads     whether only a part of the force is along ways that the coordinates leave
    is_whole  whether these are all; a string has one tension also where it runs over a pulley without mass, x + p = L
    """
    side, constant = constraint.side, constant_side(constraint, rooted, configuration.slots)
    leads = leads or acts is None or placed is None
    if by not in SURFACES and (keeping := row if row.finite is not None else _kept(row, configuration)):
        is_cord = rooted is row and (leads or by is Keeper.STRING)
        tension = _tension(keeping, by, acts, placed, configuration, constant, whole=is_cord)
        named = constraint.reaction != row.multiplier and is_called_string(row.name)
        written = keeping if rooted.finite is None else rooted
        if tension is None and (rooted is not row or by is Keeper.STRING or named):
            tension = _tension(written, by, acts, None, configuration, constant, whole=True)
        if tension is None and (share := share_of_polygon(written, constant, configuration.slots)) is not None:
            tension = SingleForce(ForceKind.TENSION, share)
        if tension is not None and (side is None or (side * tension.factor).is_positive):
            return tension
    if leads and placed is not None and side == -1:  # λ, counted as it pushes
        return SingleForce(ForceKind.ALONG, sp.S.NegativeOne)
    if acts is None or placed is None or leads or by is Keeper.GEAR or not is_whole:
        return None
    force = _along_unit_vector(row, acts, placed, configuration, side or 1)
    if force is None or side is not None or not (by is Keeper.STRING or is_called_string(row.name)):
        return force
    falling = (_held_up(p, force.direction.fixed(), configuration) == -1
               for p in configuration.points if p.name == force.on and force.direction is not None)  # fmt: skip
    return _along_unit_vector(row, acts, placed, configuration, -1) if any(falling) else force


def _kept(row: Row, configuration: Configuration) -> Row | None:
    """A constraint on velocities that keeps a sum of coordinates, as the finite one: y' = R φ' as y = R φ."""
    slots = configuration.slots
    moving = {*slots.coordinates, *slots.velocities, *slots.prescribed, t}
    if (
        row.nonlinear is not None
        or row.drift != 0
        or any(not moving.isdisjoint(a.free_symbols) for a in row.coefficients)
    ):
        return None
    return replace(row, finite=sp.Add(*(a * q for a, q in zip(row.coefficients, slots.coordinates, strict=True))))


# -- forces along a unit vector ----------------------------------------------------------------------------------------


def _along_unit_vector(
    row: Row, acts: Forces, placed: Placed, configuration: Configuration, side: int
) -> SingleForce | None:
    if (ends := _ends(acts, placed, configuration)) is None:
        return None
    direction = acts.forces[ends[0]]
    root, written = _root_of_square(direction, row, configuration), _differences(row, configuration)
    plain = _without_signs(root, written)
    size = side * plain
    sizes = (a for a in sorted(root.atoms(sp.Abs), key=str) if not plain.has(a))
    presumed = tuple(written.get(a.args[0], a.args[0]) for a in sizes)
    unit = direction.map(lambda c: shorter_product(textbook_form(c) / size))
    return SingleForce(ForceKind.ALONG, size, ends[0], unit, ends[1], presumed)


def is_led(row: Row, acts: Forces | None, placed: Placed | None, configuration: Configuration) -> bool:
    """Whether coordinates lead a body with a reaction along a curve, and the constraint is more than q = c.

    It is more where q is no length or angle along the curve: x = c stops a bead on y = x²/a by a wall.
    """
    if acts is None or placed is None or row.finite is None:
        return False
    coordinates, held = configuration.slots.coordinates, [(k, a) for k, a in enumerate(row.coefficients) if a != 0]
    is_at = len(held) == 1 and held[0][1].free_symbols.isdisjoint(coordinates)
    for f in (f for f in placed if not f.turning and f.name in acts.forces):
        ways = [f.partials[b].fixed() for b in f.basis]
        used = sum(any(w.components[n] != 0 for w in ways) for n in range(3))
        if len(ways) < used and any(not w.partial(q).is_zero for w in ways for q in coordinates):
            way = f.partials[held[0][0]].fixed()
            if not is_at or textbook_form(way.dot(way)).free_symbols & {*coordinates}:
                return True
    return False


def _ends(acts: Forces, placed: Placed, configuration: Configuration) -> tuple[str, str] | None:
    """The body on which one force acts along a line, and that on which its opposite does (empty: none); None: neither.

    What a body's coordinates leave out, a component of the force or of its moment, is taken by what guides the body:
    the full force is that on the body with more freedom, and at a fixed mass centre only the moment is seen.
    """
    forces, moments = acts.forces, acts.moments
    if not 1 <= len(forces) <= 2 or len({*forces, *moments}) > 2:
        return None
    surface = configuration.states
    moved = {f.name: [f.partials[b] for b in f.basis] for f in placed if not f.turning}
    turned = {f.name: [f.partials[b] for b in f.basis] for f in placed if f.turning}
    first, *others = sorted(forces, key=lambda name: -len(moved[name]))
    g = forces[first].fixed()
    if any(not surface.is_zero((forces[other] + g).dot(along)) for other in others for along in moved[other]):
        return None
    if any(_is_wrench(forces[n], h, turned[n], surface) for n, h in moments.items() if n in forces):
        return None
    pinned = [name for name in moments if name not in forces]
    if not pinned:
        return first, others[0] if others else ""
    places = {p.name: p.position.fixed() for p in configuration.points}
    arm = places[first] - places[pinned[0]]
    total = sum((h.fixed() for h in moments.values()), arm.cross(g))
    return (first, pinned[0]) if all(surface.is_zero(c) for c in total.components) else None


def _is_wrench(force: Vector, moment: Vector, turnings: Sequence[Vector], surface: Surface) -> bool:
    """Whether a moment has a component along the force that no shift of its line can explain."""
    if surface.is_zero(moment.dot(force)):
        return False
    axes = [w.fixed().components for w in turnings]
    return surface.rank([*axes, force.fixed().components]) == len(axes)


def _root_of_square(direction: Vector, row: Row, configuration: Configuration) -> sp.Expr:
    square = textbook_form(direction.dot(direction))
    return textbook_form(sp.sqrt(where_it_holds(square, row, configuration)))


def _without_signs(root: sp.Expr, written: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    return root.replace(
        lambda e: isinstance(e, sp.Abs) and (e.args[0] in written or _has_a_sign(e.args[0])),
        lambda e: written.get(e.args[0], e.args[0]),
    )


def _differences(row: Row, configuration: Configuration) -> dict[sp.Expr, sp.Expr]:
    """Differences of lengths, R − r, as the constraint and the substitution write them, by ±(R − r): positive, as
    (R − r) sin φ is the way to the centre of a body within another.
    """
    places = [row.finite or sp.S.Zero, *configuration.substitution.values()]
    differences: dict[sp.Expr, sp.Expr] = {}
    for e in (a for place in places for a in place.atoms(sp.Add)):
        if len(e.free_symbols) > 1 and all(s.is_positive for s in e.free_symbols) and e.is_positive is None:
            if e in differences and differences[e] != e:
                return {}
            differences |= {e: e, -e: e}
    return differences


def _has_a_sign(e: sp.Expr) -> bool:
    """Whether an expression is a length or the sine or cosine of an angle, or a product of such."""
    factors = (f.as_base_exp()[0] for f in sp.Mul.make_args(e))
    return all(f.is_positive or f.is_Symbol or isinstance(f, sp.sin | sp.cos) for f in factors)


def where_it_holds(square: sp.Expr, row: Row, configuration: Configuration) -> sp.Expr:
    """|g|² on the constraint, where that is shorter: 4R² for x² + y² = R²."""
    finite = (row.finite or sp.S.Zero).xreplace(configuration.substitution)
    return where_zero(square, finite, configuration.slots.coordinates)


# -- tensions ----------------------------------------------------------------------------------------------------------


@record
class Length:
    """A term k ℓ of f.

    share   k
    toward  −1 if a tension makes ℓ shorter, +1 if it makes ℓ longer; None: shorter if ℓ is a length
    shown   whether the equation itself shows that ℓ is the distance between two points
    on      the particle or body on which the tension acts along `unit`, which is where ℓ increases
    """

    share: sp.Expr
    toward: int | None
    shown: bool
    on: str = ""
    unit: Vector | None = None
    opposite: str = ""


def _tension(
    row: Row,
    by: Keeper | None,
    acts: Forces | None,
    placed: Placed | None,
    configuration: Configuration,
    written: sp.Expr | None,
    *,
    whole: bool,
) -> SingleForce | None:
    """The tension that keeps a distance to a point of a body, or a sum of lengths; None if it is no tension.

    written  the constant of f as it is written; None: by its terms
    whole    whether what equals it may be a length by which no points are seen
    """
    assert row.finite is not None
    coordinates = set(configuration.slots.coordinates)
    constant, terms = _separated(row.finite, coordinates)
    roots = [x for x in terms if isinstance(x[1], sp.Abs) or (isinstance(x[1], sp.Pow) and x[1].exp == sp.S.Half)]
    is_sum = by is Keeper.STRING and all(e in coordinates for _, e in terms)
    turns = acts is not None and acts.moments and not is_sum
    if not roots and placed is not None and turns and (squared := _of_square(row, placed, configuration)) is not None:
        return squared
    lengths = [_length(k, e, placed, configuration) for k, e in terms]
    if len(terms) > 1 and all(e in coordinates for _, e in terms) and _move_apart([e for _, e in terms], configuration):
        lengths = [
            x if x is None or x.shown else _carried(k, e, configuration)
            for x, (k, e) in zip(lengths, terms, strict=True)
        ]
    is_cord = by in (Keeper.STRING, Keeper.ROD) or is_called_string(row.name)
    if whole and None in lengths and (is_cord or len(terms) == len(roots) == 1):
        content, q = abs(sp.expand(row.finite).primitive()[0]), terms[0][1].as_base_exp()[0]  # 3 of 3 norm(d)^2 = 3 l^2
        part = _coordinate(sp.S.One, q, configuration).share if len(terms) == 1 and q in coordinates else sp.S.One
        return _of_whole_length(constant if written is None else written, content, part)
    known = [x for x in lengths if x is not None]
    if not all(k.free_symbols.isdisjoint(coordinates) for k, _ in terms) or len(known) < len(lengths):
        return None
    if bar := _between_two(constant, terms, configuration):
        return bar
    ends = [x for x, (_, e) in zip(known, terms, strict=True) if x.on or not _moves_nothing(e, configuration)]
    seen = _is_seen(constant, ends) and (len(ends) == len(known) or (ends and constant != 0))
    if by not in (Keeper.STRING, Keeper.ROD) and not seen and not is_called_string(row.name):
        return None
    return _pulling(constant, known)


def _of_whole_length(constant: sp.Expr, content: sp.Expr, part: sp.Expr) -> SingleForce | None:
    """The tension of f = ±(ℓ − L), T = ∓λ, or f = ±k (ℓ² − L²), T = ∓2 k L λ, by the constant −L or −k L².

    k is a number. For coordinates that do not place its ends: 2l sin θ = c of a cord between the feet of two rods."""
    size, sign = abs(constant), 1 if constant.is_positive else -1 if constant.is_negative else 0
    if constant.is_number or sign == 0:
        return None
    squared = all(e.is_even for f in sp.Mul.make_args(size) if not f.is_number for e in [f.as_base_exp()[1]])
    times = content if (size / content).as_coeff_Mul()[0] == 1 else sp.S.One
    return SingleForce(ForceKind.TENSION, sign * part * (2 * sp.sqrt(size * times) if squared else 1))


def _moves_nothing(e: sp.Expr, configuration: Configuration) -> bool:
    """Whether a term is a coordinate on which no position depends: the place of a pulley without mass."""
    if e not in configuration.slots.coordinates:
        return False
    column = configuration.slots.coordinates.index(e)
    return not _moved_by(e, configuration) and all(r.partials[column].is_zero for r in configuration.rotations)


def _between_two(
    constant: sp.Expr, terms: Sequence[tuple[sp.Expr, sp.Expr]], configuration: Configuration
) -> SingleForce | None:
    """The tension of a link between two points on a line, x_1 − x_2 = d with d > 0: f = k (x_1 − x_2 − d)."""
    if len(terms) != 2 or any(e not in configuration.slots.coordinates for _, e in terms):
        return None
    (k, first), (other, second) = terms
    apart = -constant / k  # x_1 − x_2
    if k + other != 0 or not (apart.is_positive or apart.is_negative):
        return None
    ends = []
    for q in (first, second):
        moved = _moved_by(q, configuration)
        if len(moved) != 1:
            return None
        ends += [(p.name, way) for p, way in moved]
    (one, unit), (two, same) = ends
    if one == two or not (unit - same).map(textbook_form).is_zero:
        return None
    steady = all(unit.partial(s).map(textbook_form).is_zero for s in configuration.slots.coordinates)
    places = {p.name: p.position.fixed() for p in configuration.points}
    if not steady and not (places[one] - places[two] - unit * (first - second)).map(textbook_form).is_zero:
        return None  # on a line that turns they are apart by x_1 − x_2 only if both are measured from one point
    if textbook_form(unit.dot(unit)) != 1:
        return None
    if apart.is_positive:
        return SingleForce(ForceKind.TENSION, -k, one, -unit, two)
    return SingleForce(ForceKind.TENSION, k, two, -unit, one)


def _is_seen(constant: sp.Expr, lengths: Sequence[Length]) -> bool:
    """Whether an equation shows a string: a distance between two points, or equal shares of several lengths."""
    alike = constant != 0 and len({x.share for x in lengths}) == 1
    return all(x.shown for x in lengths) and (len(lengths) == 1 or alike)


def is_called_string(name: str) -> bool:
    """Whether a constraint is called a string, `rope_1` or `cords`; one `thread` may be that of a screw."""
    first = name.partition("_")[0].rstrip("0123456789")
    return first == "threads" or first.removesuffix("s") in ("string", "rope", "cable", "cord")


def _pulling(constant: sp.Expr, lengths: Sequence[Length]) -> SingleForce | None:
    """T = −k λ; the sign by what the string holds up, otherwise because the terms are lengths."""
    placing = [x for x in lengths if x.on] or [x for x in lengths if x.toward is not None]
    unit = _unit_share(constant, [x.share for x in placing])
    if unit is None:
        return None
    signs = {x.toward if x.share.is_positive else -x.toward for x in placing if x.toward is not None}
    signs = signs or {-1 if x.share.is_positive else 1 for x in lengths}
    if len(signs) != 1:
        return None
    [sign] = signs
    names = [x.on for x in placing]
    for x in placing if all(names) else ():
        if x.unit is not None and abs(x.share) == unit and names.count(x.on) == 1:  # one part of the string pulls there
            direction = x.unit if x.share.is_positive == (sign == 1) else -x.unit
            return SingleForce(ForceKind.TENSION, sign * unit, x.on, direction, x.opposite)
    return SingleForce(ForceKind.TENSION, sign * unit)


def _unit_share(constant: sp.Expr, shares: Sequence[sp.Expr]) -> sp.Expr | None:
    """|k|: the share of L where the others are multiples of it, otherwise the smallest share; None: no such shares."""
    if not shares or any(not k.is_positive and not k.is_negative for k in shares):
        return None
    sizes = [abs(k) for k in shares]
    ratios = [tidy_quotient(k / sizes[0]) for k in sizes]
    if not all(r.is_Rational for r in ratios):
        return None
    number, length = constant.as_coeff_Mul()
    whole = [tidy_quotient(k / abs(number)) for k in sizes] if length.is_Symbol else []
    if whole and all(k.is_Integer for k in whole):
        return sp.Abs(number)
    return sizes[ratios.index(min(ratios))]


def _separated(f: sp.Expr, coordinates: set[sp.Symbol]) -> tuple[sp.Expr, list[tuple[sp.Expr, sp.Expr]]]:
    """The terms of f without coordinates, and (share, rest) of the others, those with the same rest joined."""
    constant: sp.Expr = sp.S.Zero
    shares: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(f, power_base=False, power_exp=False)):
        share, rest = term.as_independent(*coordinates, as_Add=False)
        if rest == 1:
            constant = constant + share
        else:
            shares[rest] = shares.get(rest, sp.S.Zero) + share
    return constant, [(k, rest) for rest, k in shares.items() if k != 0]


def _length(share: sp.Expr, rest: sp.Expr, placed: Placed | None, configuration: Configuration) -> Length | None:
    """A term as a length: a distance √S, or a coordinate; None if it is neither."""
    if isinstance(rest, sp.Pow) and rest.exp == sp.Rational(1, 2):
        return _distance(share, rest.base, placed, configuration)
    if isinstance(rest, sp.Abs):  # of a point on a line
        return _distance(share, rest.args[0] ** 2, placed, configuration)
    if rest not in configuration.slots.coordinates:
        return None
    return _coordinate(share, rest, configuration)


def _distance(share: sp.Expr, square: sp.Expr, placed: Placed | None, configuration: Configuration) -> Length | None:
    """√S of f, S = c d·d with the distance |d| of two points."""
    if placed is None:  # points that the coordinates do not place freely, as the end of a boom that turns
        return Length(_number_of_times(share, square, configuration), -1, shown=True)
    distance = _squared_distance(square, placed, configuration)
    if distance is None:
        return None
    between, scale = distance
    if not scale.is_positive:
        return None
    unit = (between.span / sp.sqrt(square / scale)).map(tidy_quotient)
    return Length(textbook_form(share * sp.sqrt(scale)), -1, True, between.on, unit, between.opposite)


def _number_of_times(share: sp.Expr, square: sp.Expr, configuration: Configuration) -> sp.Expr:
    """k of share·√S = k |d|: 1 for 2l |sin θ| between the feet of two rods, of which the factor 2l is taken out.

    By the distances of points that have names; where it is none of these, the letters at least are parts of |d|.
    """
    places = [p.position.fixed() for p in configuration.points]
    for d in (*places, *(one - two for one, two in combinations(places, 2))):
        times = tidy_quotient(textbook_form(share**2 * square) / (textbook_form(d.dot(d)) or sp.nan))
        if times.is_positive and times.is_number:
            return sp.sign(share) * sp.sqrt(times)
    return share.as_coeff_Mul()[0] if share.is_number else sp.sign(share)


def _coordinate(share: sp.Expr, q: sp.Symbol, configuration: Configuration) -> Length:
    """A coordinate as a length: r of polar coordinates is the distance from O; on a straight line it may be one.

    If another point is at −q on the same line, as much pulls there: 2q is between the two.
    """
    moving, coordinates = _moved_by(q, configuration), configuration.slots.coordinates
    for p, moved in moving:
        place = p.position.fixed()
        origin = place - moved * q
        if textbook_form(moved.dot(moved)) != 1 or any(
            not origin.partial(s).map(textbook_form).is_zero for s in coordinates
        ):
            continue
        if any((place + o.position.fixed()).map(textbook_form).is_zero for o, _ in moving) and origin.is_zero:
            share = share / 2
        turns = any(not moved.partial(s).map(textbook_form).is_zero for s in coordinates)
        return Length(share, -1 if turns else _held_up(p, moved, configuration), True, p.name, moved)
    return Length(share, None, shown=False)


def _moved_by(q: sp.Symbol, configuration: Configuration) -> list[tuple[MassPoint, Vector]]:
    """The points that move with a coordinate, each with ∂r/∂q."""
    column = configuration.slots.coordinates.index(q)
    return [(p, p.partials[column].fixed()) for p in configuration.points if not p.partials[column].is_zero]


def _move_apart(moving: Sequence[sp.Symbol], configuration: Configuration) -> bool:
    """Whether no point moves with two of these coordinates: x + y = a of one particle is a line and no string."""
    columns = [configuration.slots.coordinates.index(q) for q in moving]
    return all(sum(not p.partials[k].is_zero for k in columns) <= 1 for p in configuration.points)


def _carried(share: sp.Expr, q: sp.Symbol, configuration: Configuration) -> Length:
    """A coordinate along a line that is counted from what moves, or moves several points: a weight below a pulley."""
    moved = _moved_by(q, configuration)
    along = moved[0][1] if moved else Vector.zero()
    alike = all((u - along).map(textbook_form).is_zero for _, u in moved)
    steady = all(along.partial(s).map(textbook_form).is_zero for s in configuration.slots.coordinates)
    if not alike or not steady or textbook_form(along.dot(along)) != 1:
        return Length(share, None, shown=False)
    toward = next((h for p, _ in moved if (h := _held_up(p, along, configuration)) is not None), None)
    return Length(share, toward, True, moved[0][0].name, along if len(moved) == 1 else None)


def _held_up(point: MassPoint, along: Vector, configuration: Configuration) -> int | None:
    """−1 if a tension against the weight makes the coordinate along a line smaller, +1 if larger; None: no weight."""
    for load in configuration.loads:
        if load.on == point.name and load.name == "weight":
            share = textbook_form(load.vector.dot(along))
            return -1 if share.is_positive else 1 if share.is_negative else None
    return None


@record
class VectorToPoint:
    """The vector d to a point of `on` from a fixed point, or from a point of `opposite`."""

    span: Vector
    on: str
    opposite: str = ""


def _of_square(row: Row, placed: Placed, configuration: Configuration) -> SingleForce | None:
    """The tension of f = c (d·d − l²): T = −2 c l λ."""
    assert row.finite is not None
    distance = _squared_distance(row.finite, placed, configuration)
    if distance is None:
        return None
    between, scale = distance
    square = sp.factor(textbook_form(between.span.dot(between.span) - row.finite / scale))
    if square.free_symbols & {*configuration.slots.coordinates} or square.is_nonpositive:
        return None
    length = sp.sqrt(square)
    factor = textbook_form(-2 * scale * length)
    direction = (between.span * (-1 / length)).map(tidy_quotient)
    return SingleForce(ForceKind.TENSION, factor, between.on, direction, between.opposite)


def _squared_distance(
    function: sp.Expr, placed: Placed, configuration: Configuration
) -> tuple[VectorToPoint, sp.Expr] | None:
    """d and c, if a function is c d·d up to a constant, and |d| is the distance of two points."""
    coordinates = configuration.slots.coordinates
    row = Row("", tuple(function.diff(q) for q in coordinates), sp.S.Zero)
    try:
        acts = form_as_forces(row, placed, configuration.states)
    except DivisionByZeroError:
        return None
    if acts is None or not 1 <= len(acts.forces) <= 2 or len({*acts.forces, *acts.moments}) > 2:
        return None
    first, *second = acts.forces
    gradient = acts.forces[first].fixed()
    if second and not (gradient + acts.forces[second[0]].fixed()).map(textbook_form).is_zero:
        return None
    points = {p.name: p for p in configuration.points}
    turned = {k for r in configuration.rotations if r.name in {*acts.moments, *acts.forces}
              for k, w in enumerate(r.partials) if not w.is_zero}  # fmt: skip
    scale: sp.Expr | None = None
    for k, q in enumerate(coordinates):
        if k in turned:
            continue
        moved = points[first].partials[k].fixed()
        if second:
            moved = moved - points[second[0]].partials[k].fixed()
        rate = gradient.partial(q)
        if scale is None and not moved.is_zero:
            scale = textbook_form(rate.dot(moved) / moved.dot(moved)) / 2
            if scale == 0 or scale.free_symbols & {*coordinates}:
                return None
        if not (rate - moved * (2 * (scale or sp.S.Zero))).map(textbook_form).is_zero:
            return None
    if scale is None:
        return None
    others = [name for name in (*acts.moments,) if name not in acts.forces]
    return VectorToPoint((gradient / (2 * scale)).map(textbook_form), first, *(second or others)), scale
