"""Coulomb friction of a sliding particle: μ |R| against the slip.

    F = −μ |R| v_s/|v_s| ,      v_s = v_P − (velocity of the surface) ,      R = λ g  the reaction on P .

Friction is an applied force: it does virtual work. It needs |R| = |λ| |g|, which Newton's law gives. While that is
solved, |λ| is written σ λ with σ = ±1 the sign of λ, so that the equations stay linear in λ even where λ depends on the
friction. If the solution λ does not contain σ, it gives |λ| at once; otherwise σ remains, on the condition that it is
the sign of λ; a one-sided constraint settles it. Where P slides along a line, v_s = s w with a speed s of either sign,
and v_s/|v_s| = sign(s) w/|w|. The file may fix both signs. The formula holds while the particle slides, v_s ≠ 0.

On a rigid body P is the point that touches (`contact.touching`); there the force acts, so that it has a moment about
the mass centre. What the other side of the contact belongs to, if it moves, takes the opposite force.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from itertools import combinations

import sympy as sp

from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook_form import CommonFactor, common_factor, textbook_form
from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Sign, sign_in_range, without_known_magnitudes
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration, Load, MassPoint
from lagrange.mechanics.dynamics.contact.touching import (
    acts_at,
    centre_of,
    named_beside,
    point_on,
    relative_partials,
    velocity_at,
)
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.reaction_signs import where_it_holds
from lagrange.mechanics.dynamics.reactions import Reactions
from lagrange.problem.model import Friction


@record
class FrictionForce:
    """One friction force in the coordinates of a configuration.

    coefficient  μ, which may depend on the place
    normal       |g|: |R| = |λ| · normal
    slip         v_s
    speed        s, if the slip is along a line; otherwise None
    sense        the sign of s: ±1 if known, otherwise sign(s); 1 if there is no line
    along        the unit vector of the slip, w/|w| or v_s/|v_s|
    contact      the sign of λ: ±1 if the file or a one-sided constraint gives it, otherwise a `Sign`
    point        where it acts
    moved        shape (n,): ∂r_P/∂q_k for the file's coordinates, relative to the other body
    opposite     the particle or body on which the opposite force acts; empty if there is none
    beside       where that acts
    also         the other reactions on the same particle, if R is their resultant; no sign is needed then
    configured   the file's coordinates in those of the configuration
    """

    friction: Friction
    reaction: Reaction
    coefficient: sp.Expr
    normal: sp.Expr
    slip: Vector
    speed: sp.Expr | None
    sense: sp.Expr
    along: Vector
    contact: sp.Expr
    point: Vector
    moved: tuple[Vector, ...]
    opposite: str = ""
    beside: Vector | None = None
    also: tuple[Reaction, ...] = ()
    configured: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    @property
    def sense_is_stated(self) -> bool:
        """Whether the file says in which sense what touches slips, as a sign or as a vector."""
        return self.friction.slip is not None or self.friction.toward is not None

    def loads(self, magnitude: sp.Expr) -> list[Load]:
        """The force and its opposite, for a given |R|."""
        size: sp.Expr = -self.coefficient * magnitude * self.sense
        force = (self.along * size).map(textbook_form)
        name = self.friction.name
        loads = [Load(name, self.friction.on, force, self.point)]
        return loads if self.beside is None else [*loads, Load(name, self.opposite, -force, self.beside)]

    def generalized(self, force: Vector) -> list[sp.Expr]:
        """The generalized forces, for the file's coordinates, of a force on it and of its opposite, shape (n,)."""
        return [force.dot(moved) for moved in self.moved]

    @property
    def share(self) -> Vector:
        """The force for λ = 1, σ being its sign."""
        size: sp.Expr = -self.coefficient * self.contact * self.normal * self.sense
        share: Vector = self.along * size
        return share

    @property
    def magnitude(self) -> sp.Expr:
        """|R|: |N|, or |g| |λ| where the file has no name N for the force; ±N or |g| ±λ if the sign is known.

        Of several reactions it is √(ΣN n)².
        """
        if self.also:
            rule = dict(self.configured)
            units = [(r.force, r.per_unit(self.friction.on)) for r in self.pressing]
            return _length(((force, u.xreplace(rule)) for force, u in units if u is not None))
        unknown, normal = self.reaction.force, sp.S.One if self.reaction.named else self.normal
        return normal * (sp.Abs(unknown) if isinstance(self.contact, Sign) else self.sign_of_force * unknown)

    @property
    def pressing(self) -> tuple[Reaction, ...]:
        """The reactions that press."""
        return self.reaction, *self.also

    def resultant(self, values: Mapping[str, sp.Expr]) -> sp.Expr:
        """|Σ λ g| for the λ of each constraint."""
        directions = [(values[r.name], r.on(self.friction.on)) for r in self.pressing]
        return _length((value, g.xreplace(dict(self.configured))) for value, g in directions if g is not None)

    @property
    def sign_of_force(self) -> sp.Expr:
        """The sign of the unknown in which the reaction is written, N or λ."""
        side = self.reaction.constraint.side
        return sp.S.One if self.reaction.named and side is not None else self.contact


def _length(parts: Iterable[tuple[sp.Expr, Vector]]) -> sp.Expr:
    """|Σ a v|."""
    total = Vector.zero()
    for a, v in parts:
        total = total + v.fixed() * a
    return textbook_form(sp.sqrt(textbook_form(total.dot(total))))


def friction_forces(
    frictions: Sequence[Friction], newton: Newton, original: Configuration, configuration: Configuration
) -> tuple[FrictionForce, ...]:
    """The friction forces in a configuration; `newton` and `original` are of the file's coordinates.

    Raises ProblemError if a constraint does not act on the particle of its friction.
    """
    return tuple(_friction_force(f, frictions, newton, original, configuration) for f in frictions)


def rolling_contacts(frictions: Sequence[Friction], newton: Newton, original: Configuration) -> tuple[Friction, ...]:
    """The friction in contacts whose point the constraints keep from slipping. Raises ProblemError without `static`."""
    admitted = original.constrained.admitted_states
    contacts = []
    turning = {r.name for r in original.rotations}
    for f in frictions:
        if f.on not in turning or f.at is None:
            continue
        reaction = rough_reaction(f, newton, original)
        opposite = other_side(f, frictions, reaction, original)
        slip = velocity_at(original, f.on, f.at)
        if opposite:
            slip = slip - velocity_at(original, opposite, f.at)
        elif f.surface_velocity is not None:
            slip = slip - f.surface_velocity
        if any(admitted.is_zero(c) is not True for c in slip.fixed().components):
            continue
        if f.static is None:
            message = f"the point of `{f.on}` that touches does not slip, so that there is no kinetic friction"
            help_ = "give `static:`, the coefficient at rest, for the condition under which it rolls"
            raise ProblemError(Diagnostic("friction-slip", message, f.span, help=help_))
        contacts.append(f)
    return tuple(contacts)


def symbolic_loads(frictions: Sequence[FrictionForce]) -> tuple[Load, ...]:
    """The forces in terms of |λ|."""
    return tuple(load for f in frictions for load in f.loads(f.magnitude))


def solved_loads(
    frictions: Sequence[FrictionForce], reactions: Reactions
) -> tuple[tuple[Load, ...], dict[Sign, sp.Expr]]:
    """The forces with |λ| as a function of position and velocity, and the signs that remain, each with its λ.

    Raises NotCoveredError if λ is too large, ProblemError if it is not determined.
    """
    loads: list[Load] = []
    signs = {}
    for f in frictions:
        name = next((r.name for r in f.pressing if r.name not in reactions.multipliers), f.reaction.name)
        if name not in reactions.multipliers:
            message = f"the friction `{f.friction.name}` needs the reaction of `{name}`, which is not determined"
            help_ = "other constraints act in the same way; remove those that follow from the others"
            raise ProblemError(Diagnostic("friction-undetermined", message, f.friction.span, help=help_))
        value = reactions.multipliers[name]
        known = {r.name: v for r in f.pressing if (v := reactions.multipliers[r.name]) is not None}
        if value is None or len(known) < len(f.pressing):
            raise NotCoveredError(f"the friction `{f.friction.name}`, whose reaction is too large,", f.friction.span)
        if all(v == 0 for v in known.values()):
            raise ProblemError(unpressed(f.friction))
        if f.also:
            loads += f.loads(f.resultant(known))
            continue
        size = textbook_form(value * f.normal)
        magnitude = f.contact * size
        if isinstance(f.contact, Sign):
            if f.contact in value.free_symbols:
                signs[f.contact] = value  # λ depends on its own sign, which only a state can decide
            else:
                magnitude = _in_stated_sense(_absolute(size), f)
        loads += f.loads(magnitude)
    return tuple(loads), signs


def _in_stated_sense(magnitude: sp.Expr, f: FrictionForce) -> sp.Expr:
    """A magnitude without |s| where the file states the sense of the slip: 2 m ω r' in a tube that turns."""
    if not f.sense_is_stated or f.speed is None or f.sense not in (1, -1):
        return magnitude
    velocities = {v for v in f.speed.free_symbols if v.name.endswith("'")}
    rule = {}
    for a in magnitude.atoms(sp.Abs):
        share = textbook_form(a.args[0] / f.speed)
        if velocities and share.free_symbols.isdisjoint(velocities):
            rule[a] = sp.Abs(share) * f.sense * f.speed
    return textbook_form(magnitude.xreplace(rule)) if rule else magnitude


def _point(configuration: Configuration, name: str) -> MassPoint:
    return next(p for p in configuration.points if p.name == name)


def _friction_force(
    friction: Friction,
    frictions: Sequence[Friction],
    newton: Newton,
    original: Configuration,
    configuration: Configuration,
) -> FrictionForce:
    rule = configuration.substitution
    reaction, opposite, place = rough_contact(friction, frictions, newton, original)
    moved = tuple(p.xreplace(rule) for p in relative_partials(original, friction.on, opposite, place))
    place = place.xreplace(rule)
    direction = reaction.on(friction.on)
    assert direction is not None
    direction = direction.xreplace(rule)
    slip = _slip(friction, reaction, direction, configuration, place, opposite)
    speed, along, sense = _sense(friction, slip, direction, configuration)
    if friction.slip is not None:
        sense *= _sign_along_own(along, friction, opposite, original, configuration)
    along = _without_moduli(along, configuration)
    side = reaction.constraint.side
    contact = Sign(f"sigma_{reaction.name}") if friction.contact is None else sp.Integer(friction.contact)
    if side is not None:
        contact = sp.Integer(side)
    coefficient = friction.coefficient.xreplace(rule)
    size = normal_size(direction, reaction, configuration)
    beside = point_on(configuration, opposite, place) if opposite else None
    also = tuple(rough_reaction(replace(friction, constraint=name), newton, original) for name in friction.also)
    return FrictionForce(
        friction,
        reaction,
        coefficient,
        size,
        slip,
        speed,
        sense,
        along,
        contact,
        place,
        moved,
        opposite,
        beside,
        also,
        rule,
    )


def _sense(
    friction: Friction, slip: Vector, direction: Vector, configuration: Configuration
) -> tuple[sp.Expr | None, Vector, sp.Expr]:
    """s, w/|w| and the sign of s; s is None if there is no line."""
    if friction.toward is not None:
        along = unit_toward(friction, direction, configuration)
        across = slip.fixed().cross(along).components
        admitted = configuration.constrained.admitted_states
        if any(c != 0 and admitted.is_zero(c) is False for c in across):
            message = f"the point that touches does not slip along the `slip` of the friction `{friction.name}`"
            help_ = "give the direction of its velocity, or leave `slip` out where it may slip in several directions"
            raise ProblemError(Diagnostic("friction-slip", message, friction.span, help=help_))
        return textbook_form(slip.fixed().dot(along)), along, sp.S.One
    speed, line = _line(slip, friction, configuration) or (None, None)
    if line is not None:
        return speed, line, sp.sign(speed) if friction.slip is None else sp.Integer(friction.slip)
    if friction.slip is not None:
        message = f"`slip` of the friction `{friction.name}` is a sense along a line, but there is no such line"
        help_ = f"`{friction.on}` may slide in more directions than one; leave `slip` out"
        raise ProblemError(Diagnostic("friction-slip", message, friction.span, help=help_))
    return None, slip / textbook_form(slip.norm()), sp.S.One


def unit_toward(friction: Friction, direction: Vector, configuration: Configuration) -> Vector:
    """The unit vector along `slip`, if that is a vector. Raises ProblemError if it is not tangent to the surface."""
    assert friction.toward is not None
    toward = friction.toward.xreplace(configuration.substitution).fixed()
    if configuration.surface.is_zero(toward.dot(direction.fixed())) is False:
        message = f"`slip` of the friction `{friction.name}` is not along the surface"
        help_ = f"what touches slips at right angles to the reaction of `{friction.constraint}`"
        x, y, z = direction.fixed().map(textbook_form).components
        if z == 0 and not direction.is_zero:
            help_ += f": write `slip: [{y}, {textbook_form(-x)}]` or the opposite"
        raise ProblemError(Diagnostic("friction-slip", message, friction.span, help=help_))
    unit: Vector = toward / textbook_form(toward.norm())
    return unit.map(textbook_form)


def rough_contact(
    friction: Friction, frictions: Sequence[Friction], newton: Newton, original: Configuration
) -> tuple[Reaction, str, Vector]:
    """The reaction that presses, what takes the opposite friction, and the point that touches."""
    reaction = rough_reaction(friction, newton, original)
    if friction.also:
        beside = [rough_reaction(replace(friction, constraint=name), newton, original) for name in friction.also]
        if any(r.name == friction.on for r in original.rotations) or any(len([*r.acts_on]) > 1 for r in beside):
            what = f"the friction `{friction.name}` on a resultant, other than on a particle by what is at rest,"
            raise NotCoveredError(what, friction.span)
    opposite = other_side(friction, frictions, reaction, original)
    return reaction, opposite, place_of_contact(friction, reaction, opposite, original)


def rough_reaction(friction: Friction, newton: Newton, original: Configuration) -> Reaction:
    """The reaction that presses. Raises ProblemError if it is not one, or does not act on what is rubbed."""
    reactions = [r for r in newton.reactions if r.name == friction.constraint]
    if not reactions:
        message = f"`{friction.constraint}` is a vector equation, and the friction `{friction.name}` needs one reaction"
        help_ = f"name a component, as `{friction.constraint}.1`, or write the constraint as a scalar equation"
        raise ProblemError(Diagnostic("friction-place", message, friction.span, help=help_))
    [reaction] = reactions
    if reaction.directions is None:
        raise NotCoveredError(
            f"the friction `{friction.name}`: the coordinates do not place the particles one by one, and its reaction",
            friction.span,
            cure="give a mass that is fixed to a body as a force: `{on: ladder, vector: -M*g*j, at: ...}`",
        )
    direction = reaction.on(friction.on)
    if direction is None:
        message = f"the constraint `{friction.constraint}` does not act on `{friction.on}`"
        listed = " or ".join(f"`{name}`" for name in reaction.directions)
        free = f"the coordinates must place `{friction.on}` freely: give it coordinates along the reaction and across"
        help_ = f"it holds {listed}" if listed else f"it holds no particle; {free}"
        raise ProblemError(Diagnostic("friction-place", message, friction.span, help=help_))
    if not _is_placed_freely(_point(original, friction.on)):
        message = (
            f"the coordinates keep `{friction.on}` on a line or surface by themselves, and so a part of its reaction"
        )
        help_ = f"give `{friction.on}` all its coordinates, and write what keeps it there as a constraint"
        raise ProblemError(Diagnostic("friction-place", message, friction.span, help=help_))
    if friction.contact == -1 and reaction.constraint.side is not None:
        message = f"`contact: negative` of the friction `{friction.name}` contradicts the one-sided `{reaction.name}`"
        help_ = "its force is positive while contact lasts; leave `contact` out"
        raise ProblemError(Diagnostic("friction-place", message, friction.span, help=help_))
    return reaction


def other_side(friction: Friction, frictions: Sequence[Friction], reaction: Reaction, original: Configuration) -> str:
    """What takes the opposite friction; empty if it is at rest, or has a friction of its own in the file.

    Of two particles, one has it where the file gives the velocity of the surface. Raises ProblemError if more than
    two things touch.
    """
    others = [name for name in reaction.acts_on if name != friction.on]
    if any(f.constraint == friction.constraint and f.on in others for f in frictions):
        return ""
    if not others and friction.surface_velocity is None:
        others = named_beside(reaction.constraint, friction.on, original)
        if any(f.constraint == friction.constraint and f.on in others for f in frictions):
            return ""
    turning = {r.name for r in original.rotations}
    given = friction.surface_velocity is not None
    if friction.static is None and given and not turning & {friction.on, *others}:
        return ""
    if len(others) > 1:
        message = f"the reaction of `{reaction.name}` acts on {len(others) + 1} things, and friction is between two"
        help_ = "write what touches as a constraint between two bodies"
        raise ProblemError(Diagnostic("friction-place", message, friction.span, help=help_))
    return others[0] if others else ""


def place_of_contact(friction: Friction, reaction: Reaction, opposite: str, original: Configuration) -> Vector:
    """The point that touches, in the file's coordinates.

    Raises ProblemError if the file does not give it, or if the normal force does not act there.
    """
    centre = centre_of(original, friction.on)
    if all(r.name != friction.on for r in original.rotations):
        beside = () if friction.at is None else (friction.at - centre).fixed().components
        if any(original.surface.is_zero(c) is False for c in beside):
            message = f"`{friction.on}` is a particle, and the friction `{friction.name}` has another point `at`"
            raise ProblemError(Diagnostic("friction-place", message, friction.span, help="leave `at` out"))
        return centre
    if friction.at is None:
        message = f"the friction `{friction.name}` does not say which point of `{friction.on}` touches"
        help_ = f"add `at:` with its position, as `at: r_{friction.on} - R*j`"
        raise ProblemError(Diagnostic("friction-place", message, friction.span, help=help_))
    others = [name for name in reaction.acts_on if name != friction.on]
    there = acts_at(reaction, friction.on, opposite or next(iter(others), ""), friction.at, original)
    if there is None:
        what = f"the friction `{friction.name}`, of which it is undecided whether its reaction acts at the same point,"
        raise NotCoveredError(what, friction.span)
    if not there:
        message = f"the reaction of `{reaction.name}` does not act at the `at` of the friction `{friction.name}`"
        help_ = "give the point that the constraint keeps on the surface"
        reversed_ = [replace(r, partials=tuple(-w for w in r.partials)) for r in original.rotations]
        turned = replace(original, rotations=tuple(reversed_))
        if acts_at(reaction, friction.on, opposite or next(iter(others), ""), friction.at, turned):
            help_ = f"it would if `{friction.on}` turned the other way: change the sign of its `angle`"
        raise ProblemError(Diagnostic("friction-place", message, friction.span, help=help_))
    return friction.at


def _is_placed_freely(point: MassPoint) -> bool:
    """Whether the coordinates place a particle freely in space, or in a plane with a fixed normal."""
    partials = [p.fixed() for p in point.partials if not p.is_zero]
    if any(textbook_form(a.dot(b.cross(c))) != 0 for a, b, c in combinations(partials, 3)):
        return True
    normals = (a.cross(b).map(textbook_form) for a, b in combinations(partials, 2))
    normal = next((n for n in normals if not n.is_zero), None)
    if normal is None:
        return False
    symbols = sorted(_symbols(normal), key=str)
    return all(normal.cross(normal.map(lambda c, s=s: c.diff(s))).map(textbook_form).is_zero for s in symbols)  # type: ignore[misc]


def normal_size(direction: Vector, reaction: Reaction, configuration: Configuration) -> sp.Expr:
    """|g|; for a distance constraint |factor|, if that contains no coordinates: 2R for x² + y² = R²."""
    if reaction.rough is not None:
        size = without_known_magnitudes(
            textbook_form(sp.Abs(reaction.rough.factor.xreplace(configuration.substitution)))
        )
        if size.free_symbols.isdisjoint(configuration.slots.coordinates):
            return size
    square = textbook_form(direction.dot(direction))
    return without_known_magnitudes(textbook_form(sp.sqrt(where_it_holds(square, reaction.row, configuration))))


def _slip(
    friction: Friction,
    reaction: Reaction,
    direction: Vector,
    configuration: Configuration,
    place: Vector,
    opposite: str,
) -> Vector:
    """The velocity relative to the surface, after substituting the dependent velocities if that makes it shorter.

    A moving surface whose velocity is not given moves along its normal: the slip is the tangential velocity.
    """
    rule = configuration.substitution
    velocity = velocity_at(configuration, friction.on, place)
    if opposite and friction.surface_velocity is None:
        velocity = velocity - velocity_at(configuration, opposite, place)
    elif friction.surface_velocity is not None:
        velocity = velocity - friction.surface_velocity.xreplace(rule)
    elif reaction.row.drift != 0:
        normal_speed = -reaction.row.drift.xreplace(rule) / textbook_form(direction.dot(direction))
        velocity = velocity - direction * normal_speed
    velocity = velocity.map(textbook_form)
    substituted = velocity.map(lambda c: textbook_form(c.xreplace(_dependent(configuration))))
    return substituted if _operations(substituted) <= _operations(velocity) else velocity


def _operations(vector: Vector) -> int:
    return sum(count_operations(c) for c in vector.components)


def _dependent(configuration: Configuration) -> Mapping[sp.Symbol, sp.Expr]:
    """The dependent velocities, from A q' + a_t = 0; empty if they are not found."""
    slots, rows = configuration.slots, configuration.rows
    if not rows:
        return {}
    chosen: list[int] = []
    for k in reversed(range(len(slots.velocities))):  # the last first: x stays where x and y depend on each other
        if configuration.states.rank([[r.coefficients[c] for c in (*chosen, k)] for r in rows]) == len(chosen) + 1:
            chosen.append(k)
    matrix = [[r.coefficients[k] for k in chosen] for r in rows]
    right = [
        sp.Add(
            -r.drift,
            *(-a * v for k, (a, v) in enumerate(zip(r.coefficients, slots.velocities, strict=True)) if k not in chosen),
        )
        for r in rows
    ]
    solved = solved_linear(matrix, right, configuration.states)
    if solved is None or None in solved:
        return {}
    return {slots.velocities[k]: v for k, v in zip(chosen, solved, strict=True) if v is not None}


def unpressed(friction: Friction) -> Diagnostic:
    """Nothing presses, so that there is no friction: usually a weight has been forgotten."""
    message = (
        f"nothing presses `{friction.on}` against `{friction.constraint}`: the reaction is zero, and so is friction"
    )
    help_ = "is `gravity` or another force missing? If not, remove the friction"
    return Diagnostic("friction-unpressed", message, friction.span, help=help_)


def _line(slip: Vector, friction: Friction, configuration: Configuration) -> tuple[sp.Expr, Vector] | None:
    """s and w/|w| with v_s = s w, w independent of velocities; None if the slip is not along a line.

    w belongs to the first velocity that the surface does not have, so that s > 0 where that coordinate increases. A
    direction that turns with the coordinates is not separated, unless the file gives the sense of the slip.
    """
    substituted = slip.map(lambda c: textbook_form(c.xreplace(_dependent(configuration))))
    of_surface = set() if friction.surface_velocity is None else _symbols(friction.surface_velocity)
    velocities = [v for v in configuration.slots.velocities if v in _symbols(substituted)]
    velocities.sort(key=lambda v: v in of_surface)
    if not velocities:
        return None
    partials = [substituted.map(lambda c, v=v: textbook_form(c.diff(v))) for v in velocities]  # type: ignore[misc]
    rest = substituted.map(lambda c: textbook_form(c.xreplace(dict.fromkeys(velocities, sp.S.Zero))))
    w = partials[0]
    if any(_symbols(p) & set(velocities) for p in partials):
        return None
    if not all(w.cross(p).map(textbook_form).is_zero for p in (*partials, rest)):
        return None
    square = textbook_form(w.dot(w))
    if friction.slip is None and square.free_symbols & set(configuration.slots.coordinates):
        return None
    speed = sp.Add(*(v * textbook_form(p.dot(w) / square) for v, p in zip(velocities, partials, strict=True)))
    return speed + textbook_form(rest.dot(w) / square), (w / textbook_form(sp.sqrt(square))).map(textbook_form)


def _sign_along_own(
    along: Vector, friction: Friction, opposite: str, original: Configuration, configuration: Configuration
) -> sp.Expr:
    """The sign of a direction along that in which the file's own coordinate increases: it may turn with the position.

    With x_A + x_B = L the slip of B is −x_A' too, and its sense in the file is that of x_B. On a circle x = R cos θ
    increases against θ in the upper half and with θ in the lower: the sign is −sgn(sin θ).
    """
    place = friction.at if friction.at is not None else _point(original, friction.on).position
    slip = velocity_at(original, friction.on, place)
    if opposite and friction.surface_velocity is None:
        slip = slip - velocity_at(original, opposite, place)
    of_surface = set() if friction.surface_velocity is None else _symbols(friction.surface_velocity)
    velocities = [v for v in original.slots.velocities if v in _symbols(slip)]
    first = next((v for v in sorted(velocities, key=lambda v: v in of_surface)), None)
    if first is None:
        return sp.S.One
    own = slip.map(lambda c: c.diff(first).xreplace(configuration.substitution)).fixed()
    share = _without_roots(textbook_form(own.dot(along.fixed())))
    turning = share.free_symbols & set(configuration.slots.coordinates)
    sign = 1 if share.is_positive else -1 if share.is_negative else sign_in_range(share)
    return sp.Integer(sign) if sign is not None else sp.sign(share) if turning else sp.S.One


def _without_roots(product: sp.Expr) -> sp.Expr:
    """A product without its factors that cannot be negative where they exist: roots, magnitudes, even powers."""
    odd = (f for f in sp.Mul.make_args(product) if not isinstance(f, sp.Abs))
    return sp.Mul(*(f for f in odd if not (f.is_Pow and (f.exp.is_integer is False or f.exp.is_even))))


def _without_moduli(vector: Vector, configuration: Configuration) -> Vector:
    """The vector with r for |r| where a constraint gives r = R > 0."""
    moduli = {a for c in vector.components for a in c.atoms(sp.Abs)}
    if not moduli:
        return vector
    coordinates = set(configuration.slots.coordinates)
    known: dict[sp.Basic, sp.Basic] = {}
    for f in configuration.finite_constraints:
        moving = f.free_symbols & coordinates
        slope = f.diff(*moving) if len(moving) == 1 else sp.S.Zero
        if slope.is_number and slope != 0:
            [q] = moving
            known[q] = -f.xreplace({q: sp.S.Zero}) / slope
    values = {a: a.args[0].xreplace(known) for a in moduli}
    signed = {a: a.args[0] * (1 if v.is_positive else -1) for a, v in values.items() if v.is_positive or v.is_negative}
    return vector.map(lambda c: textbook_form(c.xreplace(signed))) if signed else vector


def _symbols(vector: Vector) -> set[sp.Basic]:
    return set().union(*(c.free_symbols for c in vector.components))


def _absolute(value: sp.Expr) -> sp.Expr:
    """|value|, with its positive factors in front: m |g + u''|."""
    factor = common_factor(value)
    signs = [(f, e, 1 if f.is_positive else sign_in_range(f)) for f, e in factor.powers]
    known = CommonFactor(factor.number, tuple((f, e) for f, e, sign in signs if sign is not None))
    sign = sp.Mul(*(sign for _, e, sign in signs if sign is not None and e % 2))
    size: sp.Expr = sp.Abs(known.divide(value))
    return sign * known.expression * size.replace(sp.Abs, lambda x: sp.Mul(*map(sp.Abs, sp.Mul.make_args(x))))
