"""Which equilibria count: those within the ranges of the coordinates, and poles of a chart among them.

Equilibria within the ranges of the coordinates: what lies outside is omitted.

An angle θ lies in [a, b] modulo 2π, for b − a ≤ π, if and only if sin(θ − a) ≥ 0 and sin(b − θ) ≥ 0; for a larger range
it lies outside if it is strictly in the complement, which is shorter. Any other coordinate x is in [a, b] if x − a ≥ 0
and b − x ≥ 0. The signs are those at the points of a branch. A point is omitted where it is certainly outside; where
the parameters leave that open, it becomes a condition if the coordinate is no angle.

Poles of a chart among the equilibria: positions at which a coordinate moves nothing.

With r = l (sin θ cos φ, sin θ sin φ, −cos θ) the position θ = 0 is the same for every φ. There δφ moves nothing, and
the displacements δθ at one φ are not all the displacements of the particle. So Q_θ = Q_φ = 0 is necessary for
equilibrium, and sufficient only if it holds for every φ: a horizontal force is not balanced at θ = 0, although
Q_θ = F l cos φ vanishes for φ = π/2.

A crank at its dead centre is no pole. There ∂r/∂φ vanishes for one value of φ, not for all. But with x = a cos θ for
the place of a slider θ = 0 is the edge of what θ can name: δθ is no displacement there, while x has one.

Whether V has a minimum at a pole is decided in other coordinates, u = θ cos φ and v = θ sin φ. Half a turn of φ
exchanges δθ and −δθ, and since V is a function of the position, V_θθ = V_uu cos² φ + 2 V_uv sin φ cos φ + V_vv sin² φ.
So the values of V_θθ at four φ give V_uu, V_uv and V_vv, and the equation itself is tested for all φ.

a sin θ + b θ cos θ = 0 within a quarter turn of θ = 0, whose other roots have no closed form.

tan θ/θ is even, and rises from 1 at θ = 0 without bound up to θ = π/2: its derivative is (2θ − sin 2θ)/(2θ² cos² θ).
So there is one pair of roots ±θ₁ beside θ = 0 where −b/a > 1, and none elsewhere. There the derivative of the left
side, with b θ = −a tan θ,

    a (1/cos θ − sin θ/θ) ,

has the sign of a, since 1/cos θ > 1 > sin θ/θ. A plank that rocks on a cylinder: h sin θ − R θ cos θ = 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.conditions import further_conditions
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, not_negative, sign_of
from lagrange.algebra.closed_forms.single_equation import Relation, Values
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet, with_shares_of_pi
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero, rank
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import sign_between
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.equilibrium.limits import LONGEST_RANGE_CONDITION
from lagrange.problem.model import Range

QUARTER = Range(-sp.pi / 2, sp.pi / 2)
CIRCLE = Range(-sp.pi, sp.pi)


def within(b: Branch, ranges: Mapping[sp.Symbol, Range], solution: SolutionSet) -> Branch | None:
    """The branch without the points outside of the ranges; None if all of them are."""
    if b.left and not b.special and len(solution.unknowns) == 1 and ranges.get(q := solution.unknowns[0]) == QUARTER:
        return beside_zero(b, q)
    if b.left and b.points and all(is_outside(p, ranges, solution) for p in b.points):
        return None  # by the coordinates that are solved for
    if b.left or b.special or not b.points:
        return b
    positive = [c.lhs - c.rhs for c in b.conditions if c.relation == ">"]
    positive += [c.rhs - c.lhs for c in b.conditions if c.relation == "<"]
    kept = tuple(p for p in b.points if not is_outside(p, ranges, solution, positive))
    if not kept:
        return None
    known = tuple(c for q, r in ranges.items() for c in _known(q, r, solution))
    more = [c for q, r in ranges.items() for c in _conditions(q, r, kept, solution, positive)]
    bounds = [pair for r in b.relations for pair in _bounds_of_wave(r, ranges, solution, positive)]
    more += [c for c, _ in bounds]
    weaker = {c for _, c in bounds}  # |cos θ| ≤ 1
    conditions = tuple(dict.fromkeys([*(c for c in b.conditions if c not in weaker), *more]))
    if more:
        for _ in range(2):  # a > b, which a ≥ b and a ≠ b make, decides the sign in |c/(a − b)| ≤ 1
            shorter = further_conditions(conditions)
            if shorter is None:
                return None
            conditions = shorter

    def inside(q: sp.Symbol, value: sp.Expr) -> bool:
        turned = [_is_between(value + turn, ranges[q]) for turn in (0, 2 * sp.pi, -2 * sp.pi) if q in ranges]
        return turned == [True, False, False]

    restricted = replace(b, points=kept, implied=(*b.implied, *known), conditions=conditions)
    return with_shares_of_pi(restricted, solution.letters, solution.unknowns, inside)


def within_bounds(b: Branch, bounded: Sequence[tuple[sp.Expr, Range]], solution: SolutionSet) -> Branch | None:
    """The branch where functions of the coordinates are within bounds; None if at all of its points one is not.

    Of a rod in a bowl the distance 2 r cos θ from its lower end to the rim is at most its length.
    """
    if not bounded or b.left or b.special or len(b.points) != 1:
        return b
    [point] = b.points
    margins = [m for e, r in bounded for m in (e - r.low, r.high - e)]
    positive = [c.lhs - c.rhs for c in b.conditions if c.relation == ">"]
    conditions = list(b.conditions)
    for margin in margins:
        try:
            value = solution.at(point, sp.expand_trig(margin))
        except (NotAlgebraicError, DivisionByZeroError):
            continue
        if value.free_symbols & {*solution.unknowns} or count_operations(value) > LONGEST_RANGE_CONDITION:
            continue
        needed = not_negative(sp.factor(value), positive)
        if needed is None:
            return None
        conditions += needed
    shorter = further_conditions(tuple(dict.fromkeys(conditions)))
    return None if shorter is None else replace(b, conditions=shorter)


def _is_between(value: sp.Expr, limits: Range) -> bool:
    """Whether a number is certainly in a range; False where the range is given by letters."""
    return bool(limits.low.is_number and limits.high.is_number and limits.low <= value <= limits.high)


def distances(q: sp.Expr, limits: Range, is_angle: bool) -> tuple[tuple[sp.Expr, ...], bool]:
    """Expressions that are ≥ 0 where q is in the range, or, if the second result is true, > 0 where it is not."""
    if not is_angle:
        return (q - limits.low, limits.high - q), False
    width = limits.high - limits.low
    if width.is_number and width >= 2 * sp.pi:
        return (), False
    if width.is_number and width > sp.pi:
        return (sp.sin(q - limits.high), sp.sin(limits.low - q)), True
    return (sp.sin(q - limits.low), sp.sin(limits.high - q)), False


def angles_with(wave: sp.Expr, value: sp.Expr, limits: Range) -> list[sp.Expr]:
    """All θ in a range of numbers with cos θ, sin θ or tan θ = value; none if that is no number."""
    inverse, period = {sp.cos: (sp.acos, 2 * sp.pi), sp.sin: (sp.asin, 2 * sp.pi), sp.tan: (sp.atan, sp.pi)}[wave.func]
    first = inverse(value)
    if not value.is_number or not first.is_real:
        return []
    others = {sp.cos: (-first,), sp.sin: (sp.pi - first,), sp.tan: ()}[wave.func]
    turned = [sp.expand(a + n * period) for a in (first, *others) for n in range(-2, 3)]
    return [a for a in dict.fromkeys(turned) if limits.low <= a <= limits.high]


def is_outside(
    point: Values, ranges: Mapping[sp.Symbol, Range], solution: SolutionSet, positive: Sequence[sp.Expr] = ()
) -> bool:
    """Whether a coordinate is certainly outside of its range at a point, where some expressions are positive."""
    return any(_is_outside(q, r, point, solution, positive) for q, r in ranges.items())


def _is_outside(q: sp.Symbol, limits: Range, point: Values, solution: SolutionSet, positive: Sequence[sp.Expr]) -> bool:
    tested, complement = distances(*as_measured(q, limits, solution), q in solution.letters.angles)
    signs = [_sign(e, point, solution, positive) for e in tested]
    if complement:
        return bool(signs) and all(s == 1 for s in signs)
    return -1 in signs


def as_measured(q: sp.Symbol, limits: Range, solution: SolutionSet) -> tuple[sp.Expr, Range]:
    """A coordinate with its range, an angle as its letters measure it: with θ/2, θ = π and θ = −π are two positions."""
    angle = solution.letters.angles.get(q)
    if angle is None or angle.measure == q:
        return q, limits
    times = q / angle.measure
    return angle.measure, Range(limits.low / times, limits.high / times)


def _sign(e: sp.Expr, point: Values, solution: SolutionSet, positive: Sequence[sp.Expr]) -> int | None:
    """The strict sign of an expression at a point; None: it is not known, 0: it vanishes."""
    try:
        value = solution.at(point, sp.expand_trig(e))
        if value.has(sp.zoo, sp.nan):
            return None
        return 0 if value == 0 or is_zero(value) else sign_of(value, positive)
    except (NotAlgebraicError, DivisionByZeroError):
        return None


def _conditions(
    q: sp.Symbol, limits: Range, points: tuple[Values, ...], solution: SolutionSet, positive: Sequence[sp.Expr]
) -> Iterator[SignCondition]:
    """What has to hold for a coordinate to be in its range; of an angle, the signs of sine and cosine there."""
    for c in _known(q, limits, solution):
        try:
            values = {solution.at(p, c.lhs) for p in points}
        except (NotAlgebraicError, DivisionByZeroError):
            continue
        value = values.pop()
        if values or value.free_symbols & {*solution.unknowns} or count_operations(value) > LONGEST_RANGE_CONDITION:
            continue
        if c.relation == "≥" or sign_of(value, positive) is not None:
            yield from not_negative(value, positive) or ()
        else:
            yield more_than_zero(value)


def _bounds_of_wave(
    r: Relation, ranges: Mapping[sp.Symbol, Range], solution: SolutionSet, positive: Sequence[sp.Expr]
) -> Iterator[tuple[SignCondition, SignCondition | None]]:
    """The bounds of sin θ, cos θ or tan θ in a range of θ in which it only grows or only falls; what each replaces.

    With tan θ = v and |θ| ≤ 45° they are −1 ≤ v ≤ 1. An end at which any value is admitted gives none; of cos θ = v in
    a range that is the same on both sides of 0 there is only |θ| ≤ b.
    """
    measured = dict(as_measured(q, limits, solution) for q, limits in ranges.items() if q in solution.letters.angles)
    limits = measured.get(r.lhs.args[0]) if isinstance(r.lhs, (sp.sin, sp.cos, sp.tan)) else None
    if limits is None or r.rhs.free_symbols & {*solution.unknowns}:
        return
    low, high = limits.low, limits.high
    falls = isinstance(r.lhs, sp.cos)
    low = sp.S.Zero if falls and low == -high else low
    begin, end = (sp.S.Zero, sp.pi) if falls else (-sp.pi / 2, sp.pi / 2)
    if not (low.is_number and high.is_number and begin <= low < high <= end):
        return
    wave = r.lhs.func
    for edge, outermost, sense in ((low, begin, 1), (high, end, -1)):
        if edge != outermost and count_operations(r.rhs) <= LONGEST_RANGE_CONDITION:
            sense = -sense if falls else sense
            is_bound = not wave(outermost).is_infinite
            at_most = not_negative(sense * (r.rhs - wave(outermost)), positive) if is_bound else None
            for c in not_negative(sense * (r.rhs - wave(edge)), positive) or ():
                yield c, at_most[0] if at_most else None


def _known(q: sp.Symbol, limits: Range, solution: SolutionSet) -> Iterator[SignCondition]:
    """What holds in the whole range: cos θ ≥ 0 between −π/2 and π/2."""
    zero = sp.S.Zero
    if q not in solution.letters.angles:
        yield from (SignCondition(e, "≥", zero) for e in distances(q, limits, False)[0])
        return
    angle, limits = as_measured(q, limits, solution)
    if not (limits.low.is_number and limits.high.is_number):
        return
    for f in (sp.sin, sp.cos):
        for strict, relation in ((False, ">"), (True, "≥")):
            sign = sign_between(f, limits.low, limits.high, (strict, strict))
            if sign is not None:
                yield SignCondition(sign * f(angle), relation, zero)
                break


# Chart poles


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
    """What a displacement δq_k moves, rotates, or violates."""
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


# The equation tan θ = −b θ/a


def tangent_coefficients(e: sp.Expr, q: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """a and b of a sin q + b q cos q; None if the expression is not of this form, or a has no known sign."""
    a = e.xreplace({q: sp.pi / 2})
    b = -e.xreplace({q: sp.pi}) / sp.pi
    if a.has(sp.nan, sp.zoo) or b.has(sp.nan, sp.zoo) or sign_of(a) not in (1, -1):
        return None
    return (a, b) if is_zero(e - a * sp.sin(q) - b * q * sp.cos(q)) else None


def beside_zero(b: Branch, q: sp.Symbol) -> Branch | None:
    """The roots of such a branch with q ≠ 0, |q| ≤ π/2, and where they exist; None: nowhere. Others are unchanged."""
    found = tangent_coefficients(b.left[0], q) if len(b.left) == 1 and not b.relations else None
    if found is None or b.conditions != (SignCondition(q, "≠", sp.S.Zero),):
        return b
    steeper = -(found[0] + found[1]) * (sign_of(found[0]) or 1)
    sign = sign_of(steeper)
    if sign in (0, -1):
        return None
    conditions = b.conditions if sign == 1 else (more_than_zero(steeper), *b.conditions)
    return replace(b, conditions=conditions, occupied=True)


def slope(e: sp.Expr, q: sp.Symbol) -> tuple[sp.Expr, int] | None:
    """The derivative of such an expression at its roots beside zero, and its sign; None for other expressions."""
    found = tangent_coefficients(e, q)
    return None if found is None else (found[0] * (1 / sp.cos(q) - sp.sin(q) / q), sign_of(found[0]) or 0)


def symmetric_places(equations: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> Iterator[tuple[sp.Expr, ...]]:
    """q or sin q for each coordinate that may be 0 or π by symmetry: one of the equations then holds identically."""
    for q in coordinates:
        if any(q in e.free_symbols and _vanishes_at_zero(e, q) for e in equations):
            yield (_at_zero(q, equations),)


def place_as_drawn(configuration: Configuration) -> Iterator[tuple[sp.Expr, ...]]:
    """All coordinates, each zero, where the constraints admit that, otherwise the angles: a file is often written about
    the position that is drawn.
    """
    finite, coordinates = configuration.finite_constraints, configuration.slots.coordinates
    origin = dict.fromkeys(coordinates, sp.S.Zero)
    places = [_at_zero(q, finite) for q in coordinates]
    try:
        admitted = bool(finite) and all(is_zero(f.xreplace(origin)) is True for f in finite)
    except DivisionByZeroError:
        admitted = False
    turned = tuple(place for place in places if place not in coordinates)
    if admitted or (finite and turned):
        yield tuple(places) if admitted else turned


def _at_zero(q: sp.Symbol, equations: Sequence[sp.Expr]) -> sp.Expr:
    """What vanishes where a coordinate is 0, of an angle its sine."""
    turns = any(q in f.free_symbols for e in equations for f in e.atoms(sp.sin, sp.cos, sp.tan))
    return sp.sin(q) if turns else q


def _vanishes_at_zero(e: sp.Expr, q: sp.Symbol) -> bool:
    """Whether a function of q is zero where q = 0; not where it does not exist, as exp(−r/a)/r² does not."""
    try:
        return is_zero(e.xreplace({q: sp.S.Zero})) is True
    except DivisionByZeroError:
        return False
