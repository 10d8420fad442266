"""Rough contacts at rest, and the balance of forces: linear equations for reactions, friction and unknown forces.

    Q_k + Σ_j λ_j a_jk + Σ_i F_i t_i·∂r_i/∂q_k = 0     for every coordinate of the file.

They are solved by elimination, in an order in which the forces that are wanted remain open.

Belts and ropes on rough drums.

A belt in contact over the angle β is at rest on the drum as long as the friction along it suffices: with dT = μ dN and
dN = T dφ at the limit, the tensions satisfy

    T_1 ≤ T_2 e^(μ β) ,     T_1 ≥ 0 ,

T_1 being that of the side towards which it would slip. At the limit the two sides are equal. Other forces of the file,
or the constraints that they keep, say what the tensions act on.

Reference: Euler, 1769; Eytelwein, 1808.

What the constraints imply for the position in which a system with rough contacts rests: coordinates that they fix,
angles that they make equal, and lengths that they give by angles.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.polynomial_roots import irreducible_factors
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import Surface, is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import without_known_magnitudes
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.free_bodies import without_root
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.reaction_signs import is_called_string
from lagrange.mechanics.equilibrium.equilibrium import VirtualWork
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Inequality, Signs, shortest
from lagrange.mechanics.equilibrium.limits import LONGEST_SLACK, MOST_SHIFTED
from lagrange.mechanics.equilibrium.static_reactions import is_string
from lagrange.problem.model import Belt, Friction, Problem


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
    keeping      the reactions that keep the contact from slipping: F stands for them
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
    keeping: tuple[Reaction, ...] = ()

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
    """The unknowns in terms of those left open; `linear` has (constant, coefficients) of each.

    one_sided  those that only push or only pull, each with a factor that makes it not negative
    pulling    the unknown forces that are tensions of strings
    """

    forces: Mapping[sp.Symbol, sp.Expr]
    linear: Mapping[sp.Symbol, Inequality]
    open: tuple[sp.Symbol, ...]
    equations: tuple[sp.Expr, ...]
    presupposed: tuple[sp.Expr, ...]
    one_sided: Sequence[tuple[Reaction, sp.Expr]]
    pulling: tuple[sp.Symbol, ...] = ()


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
        self.one_sided = one_sided(newton, original.slots.coordinates)
        strings = [f.vector for f in original.loads if is_called_string(f.name)]
        self.pulling = tuple(u for u in forces if any(u in c.free_symbols for v in strings for c in v.components))
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
        unknown = tuple(self.unknowns[k] for k in open_)
        return SolvedBalance(forces, linear, unknown, equations, tuple(presupposed), self.one_sided, self.pulling)

    def _is_zero(self, e: sp.Expr) -> bool:
        return e == 0 or self.surface.is_zero(e) is True


def _factors_that_may_vanish(pivot: sp.Expr, signs: Signs) -> list[sp.Expr]:
    above, _ = sp.fraction(sp.together(pivot))
    split = irreducible_factors(above)
    return [pivot] if split is None else [f for f in split if signs.of(f) is None]


def one_sided(newton: Newton, coordinates: Collection[sp.Symbol]) -> list[tuple[Reaction, sp.Expr]]:
    """The reactions that only push or only pull, each with what its unknown is multiplied by not to be negative.

    So is the tension of a string that keeps distances, if the unknown is that up to a factor whose sign is known. Of
    lengths that are coordinates, x_A + x_B = 0 over a pulley, the side to which they grow is not known.
    """
    senses: list[tuple[Reaction, sp.Expr]] = []
    for r in newton.reactions:
        if r.constraint.side is not None:
            senses.append((r, sp.Integer(1 if r.named else r.constraint.side)))
        elif is_string(r) and r.single is not None and _keeps_distances(r, coordinates):
            sense = 1 if r.named else sign_of(r.single.factor)
            senses += [(r, sp.Integer(sense))] if sense else []
    return senses


def _keeps_distances(r: Reaction, coordinates: Collection[sp.Symbol]) -> bool:
    """Whether all that varies in a constraint are distances as such, |r_A − r_B| + |r_B − r_C| = l."""
    f = r.constraint.function
    beside = f.xreplace({a: sp.Dummy() for a in f.atoms(sp.Pow) if a.exp == sp.S.Half})
    return r.rod is not None or (beside != f and beside.free_symbols.isdisjoint(coordinates))


# Belts


@record
class BeltLaw:
    """The tensions of a belt in terms of parameters, unknown forces and reactions; `growth` is e^(μ β)."""

    belt: Belt
    tight: sp.Expr
    slack: sp.Expr
    growth: sp.Expr

    @property
    def name(self) -> str:
        """The name of the belt."""
        return self.belt.name

    @property
    def reserve(self) -> sp.Expr:
        """T_2 e^(μ β) − T_1: not negative at rest, zero at the limit."""
        return self.growth * self.slack - self.tight


def belt_laws(problem: Problem, newton: Newton, configuration: Configuration) -> tuple[BeltLaw, ...]:
    """The belts of a problem, in the coordinates of a configuration."""
    forces = {r.constraint.reaction: r.force for r in newton.reactions}

    def written(e: sp.Expr) -> sp.Expr:
        return configuration.rewritten(e).xreplace(forces)

    belts = (f for f in problem.forces if isinstance(f, Belt))
    return tuple(
        BeltLaw(b, written(b.tight), written(b.slack), sp.exp(configuration.rewritten(b.coefficient * b.angle)))
        for b in belts
    )


def sought_forces(problem: Problem, belts: Sequence[BeltLaw]) -> tuple[sp.Symbol, ...]:
    """The unknown forces that the conditions may be about, tensions of belts first, so that others remain open.

    A tension is eliminated like a reaction if that at the other side of its belt is given.
    """
    unknown = {*problem.unknowns}
    sides = [({*b.tight.free_symbols} & unknown, {*b.slack.free_symbols} & unknown) for b in belts]
    inner = {s for tight, slack in sides if not (tight and slack) for s in tight | slack}
    tensions = [s for side in (0, 1) for pair in sides for s in sorted(pair[side], key=str)]
    return tuple(dict.fromkeys(s for s in (*tensions, *problem.unknowns) if s not in inner))


def tensions_between(problem: Problem, loading: Collection[sp.Symbol]) -> set[sp.Symbol]:
    """The unknown tensions of belts both ends of which pull at something: these are inside of the system.

    They are eliminated like reactions, unless the system can be at rest whatever the rest is; then they are asked for.
    """
    unknown = {*problem.unknowns}
    ends = [{*b.tight.free_symbols, *b.slack.free_symbols} & unknown for b in problem.forces if isinstance(b, Belt)]
    return {s for pair in ends if len(pair) == 2 and pair <= {*loading} for s in pair}


# Held positions


@record
class LengthsGiven:
    """Lengths in terms of angles, and what must not vanish for that."""

    values: Mapping[sp.Symbol, sp.Expr]
    nonzero: tuple[sp.Expr, ...] = ()


def held_coordinates(configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates that the constraints hold at a constant, of an angle the value with a positive cosine."""
    finite, coordinates = configuration.finite_constraints, configuration.slots.coordinates
    used = [q for q in coordinates if any(q in f.free_symbols for f in finite)]
    if not used or any(count_operations(f) > LONGEST_SLACK for f in finite):
        return {}
    if len(used) > len(finite):
        return _held_outright(configuration)
    turning = {f.args[0] for e in finite for f in e.atoms(sp.sin, sp.cos, sp.tan)}
    if (upright := _upright(finite, used, turning, _held_outright(configuration))) is not None:
        return upright
    held = []
    for b in _positions(finite, tuple(used)):
        values = {r.lhs: r.rhs for r in b.relations if r.lhs in used and r.rhs.free_symbols.isdisjoint(used)}
        if b.left or b.special or len(values) < len(used):
            return {}
        if all(sign_of(sp.cos(v)) == 1 for q, v in values.items() if q in turning):
            held.append(values)
    return held[0] if len(held) == 1 else {}


def held_positions(configuration: Configuration) -> list[dict[sp.Symbol, sp.Expr]]:
    """The positions that the constraints hold, perhaps up to a displacement of the whole: logs in a pile on a floor.

    A coordinate that such a displacement changes stays a letter, by which the others are given. Positions outside of
    the ranges of the coordinates are left out, and where all angles can be 0 those in which they are not: a file is
    written in the position in which its vectors are simple.
    """
    held = held_coordinates(configuration)
    finite, coordinates = configuration.finite_constraints, configuration.slots.coordinates
    used = [q for q in coordinates if any(q in f.free_symbols for f in finite)]
    turning = {s for e in finite for f in e.atoms(sp.sin, sp.cos, sp.tan) for s in f.free_symbols} & {*used}
    if not used or len(used) > MOST_SHIFTED or any(count_operations(f) > LONGEST_SLACK for f in finite):
        return [held]
    shifted: tuple[sp.Symbol, ...] = ()
    if len(used) == len(finite) + 1 and not turning:
        shifted = _shifted_together(finite, used)
    if not shifted and (held or len(used) != len(finite)):
        return [held]
    at_origin = dict.fromkeys(shifted[:1], sp.S.Zero)
    unknowns = [q for q in used if q not in at_origin]
    solved = _positions(tuple(f.xreplace(at_origin) for f in finite), tuple(unknowns))
    found = [(b, {r.lhs: r.rhs for r in b.relations if r.lhs in unknowns}) for b in solved]
    upright = [(b, values) for b, values in found if all(values.get(q) == 0 for q in turning)]
    positions = []
    for b, values in upright or found:
        given = all(v.free_symbols.isdisjoint(used) for v in values.values())
        if b.left or b.special or len(values) < len(unknowns) or not given or (shifted and b.conditions):
            return [held]
        values = {q: without_known_magnitudes(v) for q, v in values.items()}
        place = {q: v + shifted[0] if q in shifted else v for q, v in values.items()}
        ends = ((place[q] - r.low, r.high - place[q]) for q, r in configuration.ranges.items() if q in place)
        if all(sign_of(sp.expand(e)) != -1 for pair in ends for e in pair):
            positions.append(place)
    return positions or [held]


@lru_cache(maxsize=32)
def _positions(finite: tuple[sp.Expr, ...], coordinates: tuple[sp.Symbol, ...]) -> tuple[Branch, ...]:
    """The positions that finite constraints admit; none if they are not found."""
    try:
        return solutions(finite, coordinates).branches
    except (NotAlgebraicError, DivisionByZeroError):
        return ()


def _shifted_together(finite: Sequence[sp.Expr], used: Sequence[sp.Symbol]) -> tuple[sp.Symbol, ...]:
    """Coordinates by which the constraints do not change if all of them grow alike; none if there are none."""
    slopes = [{q: f.diff(q) for q in used if q in f.free_symbols} for f in finite]
    choices = (c for n in range(1, len(used) + 1) for c in combinations(used, n))
    for chosen in choices:
        sums = [sp.Add(*(row.get(q, sp.S.Zero) for q in chosen)) for row in slopes]
        if all(e == 0 or is_zero(e) is True for e in sums):
            return chosen
    return ()


def _upright(
    finite: Sequence[sp.Expr],
    used: Sequence[sp.Symbol],
    turning: Collection[sp.Expr],
    outright: Mapping[sp.Symbol, sp.Expr],
) -> dict[sp.Symbol, sp.Expr] | None:
    """The position in which all angles are 0, where the constraints admit it and hold the system there: a bracket on a
    pipe is upright as it is drawn, though it would fit in another position, too.

    Where the constraints are not linear in the other coordinates, these are 0 as well: a file is written in the
    position in which its vectors are simple.
    """
    if not turning or not {*turning} <= {*used}:
        return None
    at = {q: sp.S.Zero for q in used if q in turning} | dict(outright)
    left = [e for e in (shortest(f.xreplace(at)) for f in finite) if e != 0]
    others = [q for q in used if q not in at]
    candidates: Iterable[Sequence[sp.Expr]]
    if any(e.diff(q).free_symbols & {*others} for e in left for q in others):
        candidates = [[sp.S.Zero] * len(others)]
        left_there = [shortest(e.xreplace(dict.fromkeys(others, sp.S.Zero))) for e in left]
        if any(e != 0 for e in left_there):
            return None
    else:
        candidates = sp.linsolve(left, others) if left and others else () if left else ((),)
    for values in candidates:
        place = at | dict(zip(others, values, strict=False))
        slopes = sp.Matrix([[shortest(f.diff(q).xreplace(place)) for q in used] for f in finite])
        fixed = all(v.free_symbols.isdisjoint(used) for v in place.values())
        return place if fixed and len(place) == len(used) and slopes.rank() == len(used) else None
    return None


def _held_outright(configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates that are fixed by a single constraint: ρ = R."""
    held: dict[sp.Symbol, sp.Expr] = {}
    for f in configuration.finite_constraints:
        own = f.free_symbols & {*configuration.slots.coordinates}
        slope = f.diff(*own) if len(own) == 1 else sp.S.Zero
        if slope.is_number and slope != 0:
            held |= {q: -f.xreplace({q: sp.S.Zero}) / slope for q in own}
    return held


def equal_angles(configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The acute angles made equal by the constraints: cos θ_2 = cos θ_1 for two legs on one floor.

    Combinations of the constraints in which no other coordinate is left show that.
    """
    finite, coordinates = configuration.finite_constraints, configuration.slots.coordinates
    turning = {q for f in finite for g in f.atoms(sp.sin, sp.cos) for q in g.free_symbols if q in coordinates}
    others = [q for q in coordinates if q not in turning]
    slopes = sp.Matrix([[f.diff(q) for q in others] for f in finite]) if finite and others else sp.Matrix()
    if len(turning) < 2 or slopes.free_symbols or any(count_operations(f) > LONGEST_SLACK for f in finite):
        return {}
    equal: dict[sp.Symbol, sp.Expr] = {}
    for combination in slopes.T.nullspace():
        relation = sp.factor(sp.Add(*(c * f for c, f in zip(combination, finite, strict=True))).xreplace(equal))
        for piece in sp.Mul.make_args(relation):
            waves = sorted(piece.atoms(sp.sin, sp.cos), key=str)
            if len(waves) != 2 or waves[0].func != waves[1].func:
                continue
            first, second = (w.args[0] for w in waves)
            rate = sp.expand(piece).coeff(waves[0])
            if first in turning and second in turning and sp.expand(piece - rate * (waves[0] - waves[1])) == 0:
                equal = {q: e.xreplace({second: first}) for q, e in equal.items()} | {second: first}
    return equal


def lengths_by_angles(configuration: Configuration, known: Mapping[sp.Symbol, sp.Expr]) -> LengthsGiven:
    """The coordinates that constraints linear in them give in terms of angles: y = (l/2) sin θ of a bar on the floor.

    known  coordinates that are held already
    """
    coordinates = {*configuration.slots.coordinates}
    values, nonzero = dict(known), list[sp.Expr]()
    open_ = [f for f in configuration.finite_constraints if count_operations(f) <= LONGEST_SLACK]
    turning = {q for f in open_ for g in f.atoms(sp.sin, sp.cos, sp.tan) for q in g.free_symbols & coordinates}
    while True:
        solvable = []
        for f in open_:
            left = shortest(f.xreplace(values))
            lengths = (left.free_symbols & coordinates) - turning
            slope = left.diff(*lengths) if len(lengths) == 1 else sp.S.Zero
            if slope != 0 and slope.free_symbols <= turning:
                [q] = lengths
                solvable.append((not slope.is_number, str(q), q, slope, shortest(q - left / slope), f))
        if not solvable:
            return LengthsGiven({q: v for q, v in values.items() if q not in known}, tuple(nonzero))
        _, _, q, slope, value, used = min(solvable, key=lambda s: s[:2])
        values = {p: shortest(v.xreplace({q: value})) for p, v in values.items()} | {q: value}
        nonzero += [] if slope.is_number else [slope]
        open_.remove(used)
