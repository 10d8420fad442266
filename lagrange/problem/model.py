"""A problem: the statement of a textbook exercise, as data.

Everything is as the file states it, read and checked for form; nothing is derived but the orientation of a body, whose
vectors a file may use. Quantities are SymPy expressions in the symbols of `core.symbols` (q, q', q'', t); positions and
forces are `Vector`s. A constraint is f(q, q', t) = 0, where f is the difference of its sides. `unit`, `meaning` and
`note` are for the reader; `span` is the place in the file, for messages.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from fractions import Fraction
from typing import ClassVar

import sympy as sp

from lagrange.algebra.forms.velocity_polynomials import Reduction
from lagrange.algebra.fourier.vector_cleanup import cleaned_up
from lagrange.core.diagnostics import Diagnostic, Fragment, Span
from lagrange.core.inertia import NO_PRODUCTS, InertiaTensor
from lagrange.core.mime import Shown
from lagrange.core.records import record
from lagrange.core.symbols import Slots
from lagrange.core.units import Dimension
from lagrange.core.vectors import (
    Components,
    Orientation,
    Triad,
    Vector,
    turned_by_angle,
    turned_by_rotations,
    turned_with_axes,
)
from lagrange.expressions.reader import FunctionDeclaration, Scope
from lagrange.problem.keys import Assumption as Assumption
from lagrange.problem.keys import Drawn as Drawn
from lagrange.problem.keys import Find as Find
from lagrange.problem.keys import Keeper as Keeper
from lagrange.problem.keys import Outline as Outline


@record
class Range:
    """Between which values a parameter or coordinate lies, ends included, in SI units."""

    low: sp.Expr
    high: sp.Expr


@record
class Parameter:
    """A constant of the problem; where the file gives a value, `value` is its exact number in SI units.

    value_span   the place of the value
    measured     whether the value has a unit
    stated_unit  what the file has under `unit`; `unit` is the one of the value, in SI
    is_stated    whether the file says what is assumed; otherwise a value of 30 deg makes it an acute angle
    """

    symbol: sp.Symbol
    assume: Assumption = Assumption.POSITIVE
    unit: str = ""
    meaning: str = ""
    value: sp.Expr | None = None
    value_span: Span | None = None
    measured: bool = False
    stated_unit: str = ""
    range: Range | None = None
    is_stated: bool = False


@record
class Varied:
    """The values that a parameter has in variants of the problem, as texts: `0.2 m`."""

    name: str
    values: tuple[str, ...]


@record
class Coordinate:
    """One of the coordinates q; the ends of its range may contain parameters."""

    symbol: sp.Symbol
    meaning: str = ""
    unit: str = ""
    range: Range | None = None


@record
class Exchange:
    """With what velocity mass leaves or joins a particle of variable mass.

    velocity   in the fixed axes or, where `relative`, with respect to the particle
    """

    velocity: Vector
    relative: bool
    leaves: bool
    span: Span


@record
class Particle:
    """A point of mass m (0: a massless point) at the position r(q, t); `exchange` where the mass varies, m(q, t)."""

    name: str
    mass: sp.Expr
    position: Vector
    span: Span
    exchange: Exchange | None = None


@record
class Body:
    """A rigid body; `position` is its mass centre. Planar: a moment of inertia and an angle. In space: the moments of
    its tensor of inertia, the elements off its diagonal (`products`), and either an Euler sequence with its angles, or
    a triad with the angular velocity. `axes_called` are the names of the vectors of that triad in the file.
    """

    name: str
    mass: sp.Expr
    position: Vector
    inertia: tuple[sp.Expr, ...]
    span: Span
    products: Components = NO_PRODUCTS
    angle: sp.Expr | None = None
    sequence: str = ""
    angles: tuple[sp.Expr, ...] = ()
    axes: tuple[Vector, ...] = ()
    axes_called: tuple[str, ...] = ()
    angular_velocity: Vector | None = None

    def orientation(self, slots: Slots) -> Orientation:
        """The orientation that the file gives the body."""
        if self.angle is not None:
            return turned_by_angle(self.name, self.angle, self.inertia[0], slots)
        a, b, c = self.inertia
        inertia = InertiaTensor((a, b, c), self.products)
        if self.angular_velocity is None:
            rotations = tuple(zip(map(int, self.sequence), self.angles, strict=True))
            return turned_by_rotations(self.name, rotations, inertia, slots)
        first, second, third = self.axes
        called = (self.axes_called[0], self.axes_called[1], self.axes_called[2]) if self.axes_called else None
        axes = (first, second, third)
        return turned_with_axes(self.name, axes, called, self.angular_velocity, inertia, slots, cleaned_up)


@record
class Given:
    """A constraint as the file has it, and how it reduces to what is used instead: (x' − y')² = 0, x' − y' = 0."""

    lhs: sp.Expr
    rhs: sp.Expr
    steps: tuple[Reduction, ...]


@record
class Constraint:
    """f(q, q', t) = 0, where f is the left side minus the right side.

    `kinematic` is true where a velocity occurs. `reaction` is the name of its reaction, a force where it is a single
    one, otherwise the multiplier. `given` is the constraint of the file, where that is not linear in the velocities and
    f = 0 is equivalent; it may reduce to several constraints. `by` is what keeps it, where the file says so.
    `side` is that of a one-sided constraint, +1 where f ≥ 0 is permitted and −1 where f ≤ 0 is; None if f = 0 always.
    """

    name: str
    lhs: sp.Expr
    rhs: sp.Expr
    kinematic: bool
    reaction: sp.Symbol
    span: Span
    note: str = ""
    given: Given | None = None
    by: Keeper | None = None
    side: int | None = None

    @property
    def function(self) -> sp.Expr:
        """f, whose vanishing is the constraint."""
        return self.lhs - self.rhs

    @property
    def relation(self) -> str:
        """The relation between its sides in the file."""
        return "=" if self.side is None else "≥" if self.side > 0 else "≤"


@record
class AppliedForce:
    """A force vector on a particle or body, at its position or `at` another point."""

    name: str
    on: str
    vector: Vector
    span: Span
    at: Vector | None = None


@record
class AppliedMoment:
    """A moment on a rigid body."""

    name: str
    on: str
    moment: Vector
    span: Span


@record
class Spring:
    """A linear spring of stiffness k and free length between two points.

    `sense` is the sign of r_2 − r_1 along a unit vector, where the file gives it.
    """

    name: str
    stiffness: sp.Expr
    ends: tuple[Vector, Vector]
    length: sp.Expr
    span: Span
    sense: int | None = None


@record
class Damper:
    """A linear damper of coefficient c between two points."""

    name: str
    coefficient: sp.Expr
    ends: tuple[Vector, Vector]
    span: Span


@record
class Potential:
    """A potential energy V(q, t), or one that depends on velocities too, U(q, q', t)."""

    name: str
    energy: sp.Expr
    span: Span


@record
class GeneralizedForce:
    """Generalized forces Q_k, by coordinate."""

    name: str
    components: Mapping[sp.Symbol, sp.Expr]
    span: Span


@record
class Friction:
    """Coulomb friction μ|R| against the slip, R being the reaction of a constraint; at rest at most `static` |R|.

    `also` names further constraints on the same particle: R is then the resultant, as on a wire in space.
    `at` is the point of a body that touches. `slip` is the sense of the slip along a coordinate, `toward` the direction
    in which the touching point slips or is about to slip; a file gives one of them, or none. `static` is the
    coefficient at rest, None if the file gives none.
    """

    name: str
    coefficient: sp.Expr
    constraint: str
    on: str
    span: Span
    surface_velocity: Vector | None = None
    slip: int | None = None
    contact: int | None = None
    at: Vector | None = None
    toward: Vector | None = None
    static: sp.Expr | None = None
    also: tuple[str, ...] = ()

    @property
    def constraints(self) -> tuple[str, ...]:
        """All whose reactions press."""
        return self.constraint, *self.also


@record
class Belt:
    """A belt or rope on a rough drum, at rest: tight ≤ slack e^(coefficient · angle) for its two tensions.

    `tight` and `slack` may contain unknown forces and the names of reactions; `angle` is that of contact.
    """

    name: str
    coefficient: sp.Expr
    angle: sp.Expr
    tight: sp.Expr
    slack: sp.Expr
    span: Span


Force = AppliedForce | AppliedMoment | Spring | Damper | Potential | GeneralizedForce | Friction | Belt


@record
class Speed:
    """A quasi-velocity u = Σ S_k(q, t) q_k' + s(q, t): its name and definition."""

    symbol: sp.Symbol
    definition: sp.Expr
    span: Span


@record
class Choice:
    """A choice of generalized coordinates.

    `substitute` gives the old coordinates that it does not keep, in terms of the chosen ones and t. It is None where
    the choice keeps some of the old coordinates and leaves the rest to be solved from the constraints.
    """

    name: str
    coordinates: tuple[sp.Symbol, ...]
    substitute: Mapping[sp.Symbol, sp.Expr] | None
    span: Span | None = None


@record
class BodyShape:
    """What a particle or body looks like: `kind` is a word of `Outline`, with its lengths; a rod has its two ends.

    axis  the axis of symmetry in space, the third axis of the body where it is None
    """

    kind: Outline
    lengths: tuple[sp.Expr, ...] = ()
    ends: tuple[Vector, ...] = ()
    axis: Vector | None = None


@record
class FigureLine:
    """A chain of straight pieces in a figure; a text is the name of a pulley around which it goes."""

    kind: Drawn
    places: tuple[Vector | str, ...]


@record
class FigureCircle:
    """A circle, disc or sphere in a figure; `axis` is None if it lies in the plane of the page."""

    kind: Drawn
    centre: Vector
    radius: sp.Expr
    axis: Vector | None = None


@record
class FigureCurve:
    """The places of a point while one symbol runs between its two ends; a surface where there are two of them."""

    kind: Drawn
    point: Vector
    along: tuple[sp.Symbol, ...]
    between: tuple[tuple[sp.Expr, sp.Expr], ...]


@record
class FigureMark:
    """What is written into a figure: an angle [at, from, to], or a length or an arrow [from, to], with its label."""

    kind: Drawn
    label: sp.Expr
    vectors: tuple[Vector, ...]


@record
class Figure:
    """What a file adds to its figure.

    at      numbers for coordinates, parameters and functions, by name: the position that is drawn
    down    what points down on the page, if that is not gravity
    seen_from  the direction towards the reader, for a system in space
    hidden  names of coordinates and particles, and `axes`, `gravity`, `loads`, `constraints`, that are not drawn
    """

    at: Mapping[str, sp.Expr] = field(default_factory=dict)
    down: Vector | None = None
    seen_from: Vector | None = None
    points: Mapping[str, Vector] = field(default_factory=dict)
    lines: tuple[FigureLine, ...] = ()
    pulleys: Mapping[str, FigureCircle] = field(default_factory=dict)
    circles: tuple[FigureCircle, ...] = ()
    curves: tuple[FigureCurve, ...] = ()
    marks: tuple[FigureMark, ...] = ()
    hidden: frozenset[str] = frozenset()
    shapes: Mapping[str, BodyShape] = field(default_factory=dict)


KINETIC_ENERGY = sp.Symbol("T_kinetic", real=True)
"""The kinetic energy, in questions."""
ENERGY = sp.Symbol("energy", real=True)
"""The total energy T + V, in questions."""


@record
class Measured:
    """A number with a unit in a place where an expression may stand, `2 m`.

    number      in SI units
    dimension   that of its unit
    fragment    where it stands
    names       the names of the file that the unit is made of, if all its letters are such: 2 m may be a product, too
    """

    number: sp.Expr
    dimension: Dimension
    fragment: Fragment
    names: tuple[str, ...] = ()


@record
class InitialValue:
    """The value of a coordinate or velocity at t = 0.

    measured     where the file gives it as a number with a unit
    factor       of the velocity, where the file gives a multiple of it: r of r φ' = 9 km/s
    hides_units  whether a term of it had a unit, R + 500 km: it is a number in SI now, without a dimension
    """

    symbol: sp.Symbol
    value: sp.Expr
    span: Span
    measured: Measured | None = None
    factor: sp.Expr = sp.S.One
    hides_units: bool = False


@record
class Condition:
    """An equation lhs = rhs that holds at the state that is asked about.

    measured     the right side, where the file gives it as a number with a unit
    hides_units  whether a term of a side had a unit, y = L/2 + 3 m
    """

    lhs: sp.Expr
    rhs: sp.Expr
    span: Span
    measured: Measured | None = None
    hides_units: bool = False

    @property
    def function(self) -> sp.Expr:
        """The left side minus the right side."""
        return self.lhs - self.rhs


@record
class Question:
    """What is `quantity` when all of `when` hold; with `by`, as a function of that coordinate or of t.

    written  the quantity as the file has it
    """

    name: str
    quantity: sp.Expr
    written: Fragment
    when: tuple[Condition, ...]
    by: sp.Symbol | None
    span: Span


@record
class Impact:
    """What happens in an instant: blows, and constraints that begin to act.

    before       coordinates and velocities just before, as far as they are given
    impulses     given impulses, and impulsive moments, on particles and bodies
    constraints  those that begin to act
    restitution  the coefficient e of each of these, by name; 0 where there is none
    """

    span: Span
    before: tuple[InitialValue, ...] = ()
    impulses: tuple[AppliedForce | AppliedMoment, ...] = ()
    constraints: tuple[Constraint, ...] = ()
    restitution: Mapping[str, sp.Expr] = field(default_factory=dict)


@record
class Weight:
    """The points for a part of an answer, a key of `answers`, or for one statement of it by its name."""

    part: str
    name: str
    points: Fraction


@record
class Answers:
    """The textbook's answers. Expressions stay text: they are read like anybody's answer."""

    degrees_of_freedom: int | None = None
    classification: tuple[str, ...] = ()
    integrable: Mapping[str, bool] = field(default_factory=dict)
    equations: tuple[Fragment, ...] = ()
    equilibrium: tuple[tuple[Fragment, ...], ...] = ()
    reactions: Mapping[str, Fragment] = field(default_factory=dict)
    frequencies: tuple[tuple[Fragment, ...], ...] = ()
    decay: tuple[tuple[Fragment, ...], ...] = ()
    ask: Mapping[str, Fragment] = field(default_factory=dict)
    rest: tuple[Fragment, ...] = ()
    hamiltonian: Fragment | None = None
    steady: tuple[tuple[Fragment, ...], ...] = ()
    kinetic_energy: Fragment | None = None
    generalized_forces: Mapping[str, Fragment] = field(default_factory=dict)
    conserved: tuple[Fragment, ...] = ()
    virtual_displacements: tuple[Fragment, ...] = ()
    response: Mapping[str, Fragment] = field(default_factory=dict)
    impact: Mapping[str, Fragment] = field(default_factory=dict)


@record
class Problem(Shown):
    """A problem file, read. Coordinates, velocities and accelerations are symbols called `x`, `x'` and `x''`."""

    title: str
    coordinates: tuple[Coordinate, ...]
    slots: Slots
    scope: Scope
    source: str = ""
    description: str = ""
    axes: Mapping[str, str] = field(default_factory=dict)
    frame: Triad | None = None
    parameters: tuple[Parameter, ...] = ()
    functions: tuple[FunctionDeclaration, ...] = ()
    abbreviations: Mapping[str, sp.Expr | Vector] = field(default_factory=dict)
    particles: tuple[Particle, ...] = ()
    bodies: tuple[Body, ...] = ()
    constraints: tuple[Constraint, ...] = ()
    gravity: Vector | None = None
    gravity_span: Span | None = None
    forces: tuple[Force, ...] = ()
    unknowns: tuple[sp.Symbol, ...] = ()
    speeds: tuple[Speed, ...] = ()
    choices: tuple[Choice, ...] = ()
    initial: tuple[InitialValue, ...] = ()
    questions: tuple[Question, ...] = ()
    impact: Impact | None = None
    lagrangian: sp.Expr | None = None
    equations: tuple[Fragment, ...] = ()
    find: tuple[Find, ...] = (Find.CONSTRAINTS,)
    answers: Answers | None = None
    points: tuple[Weight, ...] = ()
    notes: tuple[Diagnostic, ...] = ()
    figure: Figure = Figure()
    vary: tuple[Varied, ...] = ()

    in_html: ClassVar[Callable[[Problem], str] | None] = None
    """What shows a problem in a notebook; `lagrange.api`, which knows pictures and pages, sets it."""

    def _repr_html_(self) -> str | None:
        return None if Problem.in_html is None else Problem.in_html(self)

    def __repr__(self) -> str:
        """Title and names; all fields would fill pages with places in the file."""
        named = {
            "coordinates": [q.symbol.name for q in self.coordinates],
            "constraints": [c.name for c in self.constraints],
            "choices": [c.name for c in self.choices],
        }
        listed = (f"{what} {', '.join(names)}" for what, names in named.items() if names)
        return f"<Problem {self.title!r}: {'; '.join(listed)}>"

    @property
    def masses(self) -> tuple[Particle | Body, ...]:
        """The particles, then the bodies."""
        return (*self.particles, *self.bodies)

    @property
    def radius(self) -> sp.Symbol | None:
        """The coordinate that is the distance r of a frame e_r, e_φ: it is not negative; None without such a frame."""
        first = self.frame.names[0] if self.frame is not None and self.frame.turning else ""
        return next((c.symbol for c in self.coordinates if first == f"e_{c.symbol}"), None)

    @property
    def given_values(self) -> dict[sp.Symbol, sp.Expr]:
        """The numbers that the file gives to parameters."""
        return {p.symbol: p.value for p in self.parameters if p.value is not None}

    @property
    def geometric(self) -> tuple[Constraint, ...]:
        """The constraints in which no velocity occurs."""
        return tuple(c for c in self.constraints if not c.kinematic)

    @property
    def kinematic(self) -> tuple[Constraint, ...]:
        """The constraints in which a velocity occurs."""
        return tuple(c for c in self.constraints if c.kinematic)
