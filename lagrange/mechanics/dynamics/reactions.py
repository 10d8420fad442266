"""Reactions as functions of position, velocity and time.

Sign convention: m r'' = F + R with R = Σ λ_j ∂f_j/∂r (`newton.py`). The equations with multipliers and the constraints,
differentiated until accelerations occur, are linear in both,

    M q'' − Aᵀ λ = h ,      A q'' = β :

n + m equations for q'' and λ. They are solved by elimination, in the coordinates of the file or rewritten in those of a
choice, where the geometric constraints hold identically and the result is shorter: T = m g cos θ + m l θ'². Applied
forces may be proportional to a multiplier (friction). Where the constraints are dependent, only some combinations of
multipliers are determined. The work is bounded (`linear_systems`); a system that is too large is left unsolved.

Shapes: M (n, n), A (m, n), h (n,), β (m,).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import field
from functools import cached_property

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.algebra.fourier.limits import MOST_CANCELLED
from lagrange.algebra.fourier.linear_systems import (
    Decides,
    Tidy,
    as_one_quotient,
    is_quotient_of_sums,
    solved_in_blocks,
    solved_linear,
    tidy_quotient,
)
from lagrange.algebra.fourier.textbook_form import common_factor, textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.free_bodies import without_root
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.principle import Balance
from lagrange.mechanics.dynamics.reaction_signs import ForceKind

Dragging = tuple[sp.Symbol, Sequence[sp.Expr]]
"""A multiplier λ, and the generalized forces for the file's coordinates for λ = 1, shape (n,)."""


@record
class Determined:
    """A combination Σ c_j λ_j that is determined although its multipliers are not: `terms` are pairs (c_j, λ_j).

    written  both sides with the forces that the file names, the first of them with the factor 1
    """

    terms: tuple[tuple[sp.Expr, sp.Symbol], ...]
    value: sp.Expr | None
    written: tuple[sp.Expr, sp.Expr] | None = None


@record
class Reactions:
    """The reactions in one set of coordinates. None means too large to be written down.

    multipliers    by name of the constraint; without those that are not determined
    sizes          of the reactions that are single forces: tensions, forces along unit vectors, by name
    pulling        names of those that are tensions
    units          the unit vectors of the single forces, where they are known
    directions     of the reaction of each constraint on each particle, for a multiplier of 1
    couples        likewise of its moment on each body, about the mass centre
    sides          of the one-sided constraints, by name: ±1 where ±λ pushes or pulls to the permitted side
    accelerations  q'' of the file's coordinates
    values         the known multipliers and accelerations, by symbol
    combinations   of the multipliers that are not determined individually
    """

    configuration: Configuration
    multipliers: Mapping[str, sp.Expr | None]
    sizes: Mapping[str, sp.Expr] = field(default_factory=dict)
    pulling: frozenset[str] = frozenset()
    units: Mapping[str, Vector] = field(default_factory=dict)
    directions: Mapping[str, Mapping[str, Vector]] = field(default_factory=dict)
    couples: Mapping[str, Mapping[str, Vector]] = field(default_factory=dict)
    accelerations: Mapping[sp.Symbol, sp.Expr | None] = field(default_factory=dict)
    values: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    combinations: tuple[Determined, ...] = ()
    tidy: Tidy = tidy_quotient
    sides: Mapping[str, int] = field(default_factory=dict)

    def sign_of_contact(self, name: str) -> int | None:
        """The sign of the quantity that must be nonnegative during contact, if it does not change."""
        from lagrange.algebra.closed_forms.signs import sign_of

        return sign_of(self.contacts[name])

    @cached_property
    def contacts(self) -> Mapping[str, sp.Expr]:
        """By name of each one-sided constraint what is not negative while contact lasts: its force, or ±λ.

        Those whose reaction is not known are omitted.
        """
        contacts = {}
        for name, side in self.sides.items():
            value = self.multipliers.get(name)
            if name in self.sizes:
                contacts[name] = self.sizes[name]
            elif value is not None:
                contacts[name] = side * value
        return contacts

    @property
    def tensions(self) -> Mapping[str, sp.Expr]:
        """The tensions, positive where they pull, by name of the constraint."""
        return {name: size for name, size in self.sizes.items() if name in self.pulling}

    @cached_property
    def forces(self) -> Mapping[str, Mapping[str, Vector]]:
        """The reaction of each constraint on each particle."""
        return self._valued(self.directions)

    @cached_property
    def moments(self) -> Mapping[str, Mapping[str, Vector]]:
        """The moment of each constraint's reaction on each body."""
        return self._valued(self.couples)

    def _valued(self, per_unit: Mapping[str, Mapping[str, Vector]]) -> Mapping[str, Mapping[str, Vector]]:
        return {
            name: {p: _force(g, value, self.tidy) for p, g in directions.items()}
            for name, directions in per_unit.items()
            if (value := self.multipliers.get(name)) is not None
        }

    @property
    def complete(self) -> bool:
        """Whether every multiplier was found."""
        return None not in self.multipliers.values()


@record
class ReactionSystem:
    """The equations rows · (unknowns) = right, in the file's coordinates."""

    rows: tuple[tuple[sp.Expr, ...], ...]
    right: tuple[sp.Expr, ...]
    unknowns: tuple[sp.Symbol, ...]


@record
class SolutionPlace:
    """The place where a system is solved: the constraint surface, the coordinates of a choice, or an equilibrium.

    write    rewrites an expression of the file's coordinates for this place
    surface  decides whether an expression is zero there
    states   the same with the velocities that are admissible there
    tidy     simplifies intermediate results
    show     simplifies results
    """

    write: Callable[[sp.Expr], sp.Expr]
    surface: Decides
    states: Decides
    tidy: Tidy
    show: Tidy

    def shown(self, value: sp.Expr | None) -> sp.Expr | None:
        """A result as it is written: 0 where the velocities make it zero, 2 m (x x' + y y') z' on a cylinder."""
        if value is None:
            return None
        try:
            vanishes = self.states.is_zero(value) is True
        except DivisionByZeroError:
            vanishes = False
        return sp.S.Zero if vanishes else self.show(value)

    def scaled(self, value: sp.Expr, factor: sp.Expr) -> sp.Expr:
        """A shown result times a factor, as it is written: a quotient times 2 l remains one."""
        product = factor * value
        finished = is_quotient_of_sums(value) and not factor.has(sp.Add, sp.Function)
        kept = finished and not product.could_extract_minus_sign()
        return product if kept else self.show(textbook_form(product))


def motion_system(principle: Balance, used: Sequence[Reaction]) -> ReactionSystem:
    """The equations with the multipliers of `used`, for accelerations and multipliers."""
    configuration = principle.configuration
    slots = configuration.slots
    multipliers = tuple(r.multiplier for r in used)
    unknowns = (*slots.accelerations, *multipliers)
    rows, right = rows_with_multipliers(principle, used, unknowns)
    for r in used:
        row = without_root(r.row, slots)
        rate = slots.time_derivative(row.velocity_form(slots))
        no_acceleration = dict.fromkeys(slots.accelerations, sp.S.Zero)
        rows.append((*row.coefficients, *(sp.S.Zero for _ in multipliers)))
        right.append(-rate.xreplace(no_acceleration))
    return ReactionSystem(tuple(rows), tuple(right), unknowns)


def rows_with_multipliers(
    principle: Balance, used: Sequence[Reaction], unknowns: Sequence[sp.Symbol]
) -> tuple[list[tuple[sp.Expr, ...]], list[sp.Expr]]:
    """D_k − Σ λ_j a_jk = 0 for each coordinate, as rows and right sides."""
    rows, right = [], []
    slots = principle.configuration.slots
    forms = {r.multiplier: without_root(r.row, slots).coefficients for r in used}
    for k, element in enumerate(principle.coefficients):
        coefficients, rest = principle.ring.linear(element, unknowns)
        row = [principle.textbook.form(c) for c in coefficients]
        for multiplier, form in forms.items():
            row[unknowns.index(multiplier)] -= form[k]
        rows.append(tuple(row))
        right.append(principle.textbook.form(-rest))
    return rows, right


def solved_reactions(
    system: ReactionSystem,
    newton: Newton,
    used: Sequence[Reaction],
    configuration: Configuration,
    dragging: Sequence[Dragging] = (),
    applied: Sequence[sp.Expr] = (),
    resting: Collection[sp.Symbol] = (),
) -> Reactions:
    """The unknowns of a system, in the coordinates of a configuration: the file's own, or those of a choice.

    dragging  applied forces that are proportional to a multiplier
    applied   further generalized forces for the file's coordinates, shape (n,)
    resting   velocities that the constraints keep zero

    Forces are written in the coordinates of the configuration.
    """
    tidy = tidy_quotient if configuration.expressed else _on_surface(configuration)
    rows, right = _in_coordinates(system, configuration, dragging)
    for k, force in enumerate(applied):
        right[k] = right[k] + force
    # In an unspecified force F(x, x') no argument is replaced: F(x, 0) would be another function.
    arguments = {s for b in right for f in b.atoms(Unspecified) for s in f.free_symbols}
    at_rest = dict.fromkeys([v for v in resting if v not in arguments], sp.S.Zero)
    right = [b.xreplace(at_rest) for b in right]
    rule = _positions_and_velocities(configuration)
    constrained = configuration.constrained
    place = SolutionPlace(
        lambda e: e.xreplace(rule), constrained.states, constrained.admitted_states, tidy, over_one_denominator
    )
    rewritten = ReactionSystem(tuple(tuple(row) for row in rows), tuple(right), system.unknowns)
    return reactions_at(place, rewritten, newton, used, configuration)


def reactions_at(
    place: SolutionPlace, system: ReactionSystem, newton: Newton, used: Sequence[Reaction], configuration: Configuration
) -> Reactions:
    """The unknowns of a system that has been rewritten for a place."""
    accelerations = sum(s.name.endswith("''") for s in system.unknowns)
    moving = {*configuration.slots.coordinates, *configuration.slots.velocities, *configuration.slots.prescribed, t}
    solved = solved_in_blocks(
        system.rows,
        system.right,
        accelerations,
        place.surface,
        place.tidy,
        constant=lambda e: e.free_symbols.isdisjoint(moving) and not e.has(Unspecified),
        leading=not configuration.expressed,
    )
    solved = solved or [None] * len(system.unknowns)
    values = dict(zip(system.unknowns, map(place.shown, solved), strict=True))
    unused = [r for r in newton.reactions if r not in used]
    combinations = _combinations(used, unused, values, place) if unused else ()
    undetermined = {symbol for c in combinations if len(c.terms) > 1 for _, symbol in c.terms}
    determined = [r for r in used if r.multiplier not in undetermined]
    multipliers = {r.name: values[r.multiplier] for r in determined}
    return Reactions(
        configuration=configuration,
        multipliers=multipliers,
        sizes={
            r.name: place.scaled(v, place.write(r.single.factor))
            for r in determined
            if r.single is not None and (v := values[r.multiplier]) is not None
        },
        pulling=frozenset(r.name for r in determined if r.single and r.single.kind is ForceKind.TENSION),
        units={
            r.name: r.single.direction.map(lambda c: textbook_form(place.write(c)))
            for r in determined
            if r.single is not None and r.single.direction is not None
        },
        directions={
            r.name: {p: g.rewritten(place.write) for p, g in r.directions.items()} for r in determined if r.directions
        },
        couples={r.name: {b: g.rewritten(place.write) for b, g in r.moments.items()} for r in determined if r.moments},
        accelerations={s: values[s] for s in system.unknowns if s.name.endswith("''")},
        values={s: v for s, v in values.items() if v is not None and s not in undetermined},
        combinations=tuple(c for c in combinations if len(c.terms) > 1),
        tidy=place.tidy,
        sides={r.name: r.constraint.side for r in newton.reactions if r.constraint.side is not None},
    )


def _in_coordinates(
    system: ReactionSystem, configuration: Configuration, dragging: Sequence[Dragging]
) -> tuple[list[list[sp.Expr]], list[sp.Expr]]:
    """Rows and right sides in the coordinates of a configuration, with forces proportional to multipliers."""
    rule = _positions_and_velocities(configuration)
    rows = [[e.xreplace(rule) for e in row] for row in system.rows]
    for multiplier, shares in dragging:
        if multiplier in system.unknowns:
            for k, share in enumerate(shares):
                rows[k][system.unknowns.index(multiplier)] -= share
    return rows, [e.xreplace(rule) for e in system.right]


def written_out(system: ReactionSystem, configuration: Configuration, dragging: Sequence[Dragging]) -> list[sp.Expr]:
    """The equations of a system, each zero, in the coordinates of a configuration."""
    rows, right = _in_coordinates(system, configuration, dragging)
    return [
        sp.Add(*(e * u for e, u in zip(row, system.unknowns, strict=True)), -b)
        for row, b in zip(rows, right, strict=True)
    ]


def over_one_denominator(value: sp.Expr) -> sp.Expr:
    """A sum whose terms share a denominator, as one quotient or one product: (m/l) (x'² + y'² + g y)."""
    return as_one_quotient(_joined(value))


def _joined(value: sp.Expr) -> sp.Expr:
    if not value.is_Add:
        return _unnested(value)
    common = common_factor(value)
    if not any(e < 0 for _, e in common.powers):
        return value
    rest = common.divide(value)
    terms = sp.Add.make_args(rest)
    if all(term.could_extract_minus_sign() for term in terms):
        return -(common.expression * sp.Add(*(-term for term in terms)))
    return common.expression * rest


def _unnested(value: sp.Expr) -> sp.Expr:
    """A quotient without quotients in the sums of its numerator: g (l² − y²), not g l² (1 − y²/l²)."""
    numerator, _ = sp.fraction(value)
    sums = (s for s in numerator.atoms(sp.Add) if count_operations(s) <= MOST_CANCELLED)
    if count_operations(numerator) > MOST_CANCELLED or all(
        sp.fraction(term)[1].is_number for s in sums for term in s.args
    ):
        return value
    over, under = sp.fraction(sp.together(value))
    formed = textbook_form(over) / textbook_form(under)
    return formed if count_operations(formed) < count_operations(value) else value


def _force(direction: Vector, value: sp.Expr, tidy: Tidy) -> Vector:
    force: Vector = direction * value
    return force.map(lambda c: tidy(c) if count_operations(c) < MOST_CANCELLED else c)


def _positions_and_velocities(configuration: Configuration) -> dict[sp.Basic, sp.Basic]:
    """The substitution of a choice, accelerations omitted."""
    return {s: e for s, e in configuration.substitution.items() if not str(s).endswith("''")}


def _combinations(
    used: Sequence[Reaction],
    unused: Sequence[Reaction],
    values: Mapping[sp.Symbol, sp.Expr | None],
    place: SolutionPlace,
) -> tuple[Determined, ...]:
    """With a_u = Σ c_uj a_j for each dependent form, the equations determine λ_j + Σ_u c_uj λ_u."""
    columns = range(len(used[0].row.coefficients)) if used else range(0)
    terms: dict[sp.Symbol, list[tuple[sp.Expr, sp.Symbol]]] = {r.multiplier: [(sp.S.One, r.multiplier)] for r in used}
    for u in unused:
        matrix = [[place.write(r.row.coefficients[k]) for r in used] for k in columns]
        target = [place.write(u.row.coefficients[k]) for k in columns]
        shares = solved_linear(matrix, target, place.surface)
        for r, c in zip(used, shares or [None] * len(used), strict=True):
            if c is None:
                return ()
            if c != 0:
                terms[r.multiplier].append((c, u.multiplier))
    reactions = {r.multiplier: r for r in (*used, *unused)}
    return tuple(
        Determined(tuple(t), value, None if value is None else _with_tensions(t, value, reactions, place))
        for symbol, t in terms.items()
        for value in [values[symbol]]
    )


def _with_tensions(
    terms: Sequence[tuple[sp.Expr, sp.Symbol]],
    value: sp.Expr,
    reactions: Mapping[sp.Symbol, Reaction],
    place: SolutionPlace,
) -> tuple[sp.Expr, sp.Expr]:
    """Σ c_j λ_j = value with the forces that the file names instead of their λ, times the factor of the first."""
    scale = 1 / place.write(reactions[terms[0][1]].per_force)
    left = (textbook_form(scale * c * place.write(reactions[s].per_force)) * reactions[s].force for c, s in terms)
    return sp.Add(*left), place.show(textbook_form(scale * value))


def _on_surface(configuration: Configuration) -> Tidy:
    """Quotients in lowest terms, and shortened by the finite constraints: x² + y² becomes l²."""
    coordinates = configuration.slots.coordinates
    relations = [
        sp.expand(f)
        for f in configuration.finite_constraints
        if f.is_polynomial(*coordinates) and count_operations(f) <= MOST_CANCELLED
    ]
    lowest = min((_degree(f, coordinates) for f in relations), default=0)

    def tidy(entry: sp.Expr) -> sp.Expr:
        formed = tidy_quotient(entry)
        moving = formed.free_symbols & set(coordinates)
        if not relations or not moving or count_operations(formed) > MOST_CANCELLED:
            return formed
        numerator, denominator = sp.fraction(sp.together(formed))
        reduced = [
            e if _degree(e, coordinates) < lowest else _reduced(e, relations, coordinates)
            for e in (numerator, denominator)
        ]
        if reduced == [numerator, denominator] or reduced[1] == 0:
            return formed
        shorter = tidy_quotient(reduced[0] / reduced[1])
        return shorter if count_operations(shorter) < count_operations(formed) else formed

    return tidy


def _degree(e: sp.Expr, coordinates: Sequence[sp.Symbol]) -> int:
    """The degree in the coordinates that occur; a large number if it is not a polynomial."""
    own = sorted(e.free_symbols.intersection(coordinates), key=lambda s: s.name)
    if not own:
        return 0
    return int(sp.Poly(e, *own).total_degree()) if e.is_polynomial(*own) else MOST_CANCELLED


def _reduced(e: sp.Expr, relations: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> sp.Expr:
    """The remainder of a polynomial modulo the relations, if that is shorter; otherwise the polynomial."""
    if not e.is_polynomial(*coordinates) or e.free_symbols.isdisjoint(coordinates):
        return e
    _, remainder = sp.reduced(e, relations, *coordinates, order="grevlex")
    return remainder if count_operations(remainder) < count_operations(e) else e
