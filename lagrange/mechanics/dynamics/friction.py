"""Coulomb friction of a sliding particle: μ |R| against the slip.

    F = −μ |R| v_s/|v_s| ,      v_s = v_P − (velocity of the surface) ,      R = λ g  the reaction on P .

Friction is an applied force: it does virtual work. It needs |R| = |λ| |g|, which Newton's law gives. While that is
solved, |λ| is written σ λ with σ = ±1 the sign of λ, so that the equations stay linear in λ even where λ depends on the
friction. If the solution λ does not contain σ, it gives |λ| at once; otherwise σ remains, on the condition that it is
the sign of λ. Where P slides along a line, v_s = s w with a speed s of either sign, and v_s/|v_s| = sign(s) w/|w|. The
file may fix both signs. The formula holds while the particle slides, v_s ≠ 0.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook_form import CommonFactor, common_factor, textbook_form
from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError
from lagrange.core.ranges import sign_in_range
from lagrange.core.records import record
from lagrange.core.symbols import Sign
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration, Load, MassPoint
from lagrange.mechanics.dynamics.named_forces import where_it_holds
from lagrange.mechanics.dynamics.newton import Newton, Reaction
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
    contact      the sign of λ: ±1 if the file gives it, otherwise a `Sign`
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

    def load(self, magnitude: sp.Expr, point: Vector) -> Load:
        """The force, for a given |R|."""
        size: sp.Expr = -self.coefficient * magnitude * self.sense
        return Load(self.friction.name, self.friction.on, (self.along * size).map(textbook_form), point)

    @property
    def share(self) -> Vector:
        """The force for λ = 1, σ being its sign."""
        size: sp.Expr = -self.coefficient * self.contact * self.normal * self.sense
        share: Vector = self.along * size
        return share

    @property
    def magnitude(self) -> sp.Expr:
        """|R|: |N|, or |g| |λ| where the file has no name N for the force; ±N or |g| ±λ if the sign is known."""
        unknown, normal = self.reaction.force, sp.S.One if self.reaction.named else self.normal
        return normal * (sp.Abs(unknown) if isinstance(self.contact, Sign) else self.contact * unknown)


def friction_forces(
    frictions: Sequence[Friction], newton: Newton, original: Configuration, configuration: Configuration
) -> tuple[FrictionForce, ...]:
    """The friction forces in a configuration; `newton` and `original` are of the file's coordinates.

    Raises ProblemError if a constraint does not act on the particle of its friction.
    """
    return tuple(_friction_force(f, newton, original, configuration) for f in frictions)


def symbolic_loads(frictions: Sequence[FrictionForce], configuration: Configuration) -> tuple[Load, ...]:
    """The forces in terms of |λ|."""
    return tuple(f.load(f.magnitude, _point(configuration, f.friction.on).position) for f in frictions)


def solved_loads(
    frictions: Sequence[FrictionForce], reactions: Reactions, configuration: Configuration
) -> tuple[tuple[Load, ...], dict[Sign, sp.Expr]]:
    """The forces with |λ| as a function of position and velocity, and the signs that remain, each with its λ.

    Raises NotCoveredError if λ is too large, ProblemError if it is not determined.
    """
    loads, signs = [], {}
    for f in frictions:
        name = f.reaction.name
        if name not in reactions.multipliers:
            message = f"the friction `{f.friction.name}` needs the reaction of `{name}`, which is not determined"
            help_ = "other constraints keep the same; remove those that follow from the others"
            raise ProblemError(Diagnostic("friction-undetermined", message, f.friction.span, help=help_))
        value = reactions.multipliers[name]
        if value is None:
            raise NotCoveredError(f"the friction `{f.friction.name}`, whose reaction is too large,", f.friction.span)
        size = textbook_form(value * f.normal)
        magnitude = f.contact * size
        if isinstance(f.contact, Sign):
            if f.contact in value.free_symbols:
                signs[f.contact] = value  # λ depends on its own sign, which only a state can decide
            else:
                magnitude = _absolute(size)
        loads.append(f.load(magnitude, _point(configuration, f.friction.on).position))
    return tuple(loads), signs


def _point(configuration: Configuration, name: str) -> MassPoint:
    return next(p for p in configuration.points if p.name == name)


def _friction_force(
    friction: Friction, newton: Newton, original: Configuration, configuration: Configuration
) -> FrictionForce:
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
        )
    direction = reaction.on(friction.on)
    if direction is None:
        message = f"the constraint `{friction.constraint}` does not act on `{friction.on}`"
        listed = " or ".join(f"`{name}`" for name in reaction.directions)
        help_ = f"it holds {listed}" if listed else "it holds no particle"
        raise ProblemError(Diagnostic("friction-place", message, friction.span, help=help_))
    if not _is_placed_freely(_point(original, friction.on)):
        message = (
            f"the coordinates keep `{friction.on}` on a line or surface by themselves, and so a part of its reaction"
        )
        help_ = f"give `{friction.on}` all its coordinates, and write what keeps it there as a constraint"
        raise ProblemError(Diagnostic("friction-place", message, friction.span, help=help_))
    direction = direction.xreplace(configuration.substitution)
    slip = _slip(friction, reaction, direction, configuration)
    speed, along = _line(slip, friction, configuration) or (None, None)
    if along is None:
        if friction.slip is not None:
            message = f"`slip` of the friction `{friction.name}` is a sense along a line, and there is no line"
            help_ = f"`{friction.on}` may slide in more directions than one; leave `slip` out"
            raise ProblemError(Diagnostic("friction-slip", message, friction.span, help=help_))
        along, sense = slip / textbook_form(slip.norm()), sp.S.One
    else:
        sense = sp.sign(speed) if friction.slip is None else sp.Integer(friction.slip)
    along = _without_moduli(along, configuration)
    contact = Sign(f"sigma_{reaction.name}") if friction.contact is None else sp.Integer(friction.contact)
    coefficient = friction.coefficient.xreplace(configuration.substitution)
    size = _size(direction, reaction, configuration)
    return FrictionForce(friction, reaction, coefficient, size, slip, speed, sense, along, contact)


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


def _size(direction: Vector, reaction: Reaction, configuration: Configuration) -> sp.Expr:
    """|g|; for a distance constraint |factor|, if that contains no coordinates: 2R for x² + y² = R²."""
    if reaction.rough is not None:
        size = textbook_form(sp.Abs(reaction.rough.factor.xreplace(configuration.substitution)))
        if size.free_symbols.isdisjoint(configuration.slots.coordinates):
            return size
    square = textbook_form(direction.dot(direction))
    return textbook_form(sp.sqrt(where_it_holds(square, reaction.row, configuration)))


def _slip(friction: Friction, reaction: Reaction, direction: Vector, configuration: Configuration) -> Vector:
    """The velocity relative to the surface, after substituting the dependent velocities if that makes it shorter.

    A moving surface whose velocity is not given moves along its normal: the slip is the tangential velocity.
    """
    rule = configuration.substitution
    velocity = _point(configuration, friction.on).velocity
    if friction.surface_velocity is not None:
        velocity = velocity - friction.surface_velocity.xreplace(rule)
    elif reaction.row.drift != 0:
        normal_speed = -reaction.row.drift.xreplace(rule) / textbook_form(direction.dot(direction))
        velocity = velocity - direction * normal_speed
    velocity = velocity.map(textbook_form)
    substituted = velocity.map(lambda c: textbook_form(c.xreplace(_dependent(configuration))))
    return substituted if _operations(substituted) <= _operations(velocity) else velocity


def _operations(vector: Vector) -> int:
    return sum(int(c.count_ops()) for c in vector.components)


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
    return sign * known.expression * sp.Abs(known.divide(value))
