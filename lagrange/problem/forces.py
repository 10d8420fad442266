"""Reading the forces: gravity, applied forces, moments, springs, dampers, potentials, friction.

The kind of a force is the one key it has of `vector`, `moment`, `spring`, `damper`, `potential`, `friction`, `belt`.
Applied forces may depend on position, velocity and time, never on accelerations.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, ProblemError, suggestion
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import Scope
from lagrange.problem.keys import FORCES, IMPULSES, SENSES
from lagrange.problem.load_context import LoadContext, Namespace, canonical, names_in
from lagrange.problem.model import (
    AppliedForce,
    AppliedMoment,
    Belt,
    Constraint,
    Damper,
    Force,
    Friction,
    GeneralizedForce,
    Potential,
    Spring,
)
from lagrange.problem.sections import (
    COEFFICIENT,
    ENERGY,
    FORCE,
    PLACE,
    POSITION,
    RATE,
    SPRING,
    Allowed,
    Section,
    entries_of,
    items_of,
    mapping_of,
    scalar_of,
)
from lagrange.problem.yaml.kinds import Keys
from lagrange.problem.yaml.nodes import ListNode, MappingNode, Node, Scalar

_EXAMPLE = "forces: {push: {on: P, vector: F*i}}"
_EXAMPLE_OF_IMPULSE = "impulses: {blow: {on: P, vector: J*i}}"


def read_gravity(node: Node | None, context: LoadContext) -> Vector | None:
    """The acceleration of gravity."""
    return None if node is None else context.diagnostics.attempt(lambda: _gravity(node, context))


def _gravity(node: Node, context: LoadContext) -> Vector:
    help_ = "gravity is a vector: write `gravity: -g*j` where j points up, `gravity: g*j` where it points down"
    return _vector_or(help_, lambda: context.vector(node, "`gravity`", FORCE))


def _vector_or(help_: str, read: Callable[[], Vector]) -> Vector:
    """A vector; where a scalar stands in its place, the error says how this vector is written. Raises ProblemError."""
    try:
        return read()
    except ProblemError as error:
        if [d.code for d in error.diagnostics] != ["scalar-for-vector"]:
            raise
        raise ProblemError([replace(d, help=help_) for d in error.diagnostics]) from None


def read_forces(node: Node | None, context: LoadContext, constraints: Iterable[Constraint]) -> tuple[Force, ...]:
    """name -> what acts; the tensions of a belt may be reactions of the constraints."""
    if node is None:
        return ()
    reactions = {c.reaction.name: c.reaction for c in constraints}
    tensions = replace(context.scope, scalars={**context.scope.scalars, **reactions})
    forces = []
    for key, value in context.diagnostics.attempt(lambda: entries_of(node, "`forces`", _EXAMPLE)) or ():
        name = context.forces.declare(key, "a force")
        if name is not None:
            force = context.diagnostics.attempt(partial(_force, name, key, value, context, tensions))
            forces += [force] if force is not None else []
    return tuple(forces)


def read_impulses(node: Node | None, context: LoadContext) -> tuple[AppliedForce | AppliedMoment, ...]:
    """name -> a given impulse: a vector or a moment."""
    if node is None:
        return ()
    impulses, declared = [], Namespace(context.names)
    for key, value in context.diagnostics.attempt(lambda: entries_of(node, "`impulses`", _EXAMPLE_OF_IMPULSE)) or ():
        name = declared.declare(key, "an impulse")
        if name is not None:
            read = partial(_force, name, key, value, context, context.scope, IMPULSES, "impulse")
            impulses.append(context.diagnostics.attempt(read))
    return tuple(i for i in impulses if isinstance(i, AppliedForce | AppliedMoment))


def _force(
    name: str,
    key: Scalar,
    node: Node,
    context: LoadContext,
    tensions: Scope,
    forms: Mapping[str, Keys] = FORCES,
    noun: str = "force",
) -> Force:
    what = f"the {noun} `{name}`"
    if name == "gravity" and _is_vector_alone(node):
        message = "`gravity` is not one of the forces: it acts on every mass"
        help_ = "write the acceleration, without the mass, beside `forces`: `gravity: -g*j`"
        raise ProblemError(Diagnostic("misplaced-gravity", message, key.span, help=help_))
    mapping = mapping_of(node, what, f"{name}: {{on: P, vector: F*i}}")
    _refuse_type(mapping, what, forms)
    kinds = [k for k in forms if any(entry.text == k for entry, _ in mapping.entries)]
    if len(kinds) > 1:
        listed = " and ".join(f"`{k}`" for k in kinds)
        help_ = f"give every {noun} an entry of its own"
        raise ProblemError(Diagnostic("force-kind", f"{what} has {listed}", key.span, help=help_))
    section = Section(mapping, what, forms[kinds[0]] if kinds else _any_of(noun, forms), context.diagnostics)
    kind = kinds[0] if kinds else next((k for k in forms if section.has(k)), None)
    if kind is None and section.strange:
        raise ProblemError(())  # one of these keys may have been meant to be the kind, and has been reported
    if kind is None:
        listed = ", ".join(f"`{k}`" for k in forms)
        message = f"{what} does not say what acts"
        help_ = f"give it one of {listed}"
        if "friction" in forms and section.has("static"):
            help_ = "add `friction: mu`, the coefficient while it slides; at rest only that of `static` is used"
        raise ProblemError(Diagnostic("force-kind", message, key.span, help=help_))
    section.form = forms[kind]
    return _READERS[kind](_Entry(name, what, key, section, context, tensions))


def _is_vector_alone(node: Node) -> bool:
    """Whether it is a vector that acts on nothing, and not a force that is only called gravity."""
    if isinstance(node, MappingNode) and [key.text for key, _ in node.entries] == ["vector"]:
        node = node.entries[0][1]
    return isinstance(node, Scalar)


def _refuse_type(mapping: MappingNode, what: str, forms: Mapping[str, Keys]) -> None:
    """Refuse `type: spring`, with the cure: the key that says what acts is the kind itself. Raises ProblemError."""
    for key, value in mapping.entries:
        if key.text in ("type", "kind") and isinstance(value, Scalar) and value.text in forms:
            needed = ", ".join(f"{k.name}: {k.example}" for k in forms[value.text].keys if k.required)
            message = f"`{key.text}` is not a key of {what}: the key `{value.text}` itself says what acts"
            raise ProblemError(Diagnostic("force-kind", message, key.span, help=f"write `{{{needed}}}`"))


def _any_of(noun: str, forms: Mapping[str, Keys]) -> Keys:
    """All keys of forces, to suggest one where the kind of a force is not clear."""
    return Keys(f"a {noun}", tuple({key.name: key for form in forms.values() for key in form.keys}.values()))


class _Entry:
    """One entry of `forces`; its values are read by their keys."""

    def __init__(
        self, name: str, what: str, key: Scalar, section: Section, context: LoadContext, tensions: Scope
    ) -> None:
        self.name = name
        self.what = what
        self.span = key.span
        self.section = section
        self.context = context
        self.tensions = tensions
        self.all_of = context.diagnostics.all_of

    def node(self, key: str) -> Node:
        """The value of a required key."""
        return self.section.required(key, self.span)

    def scalar(self, key: str, allowed: Allowed = FORCE, scope: Scope | None = None) -> sp.Expr:
        """A required scalar."""
        return self.context.scalar(self.node(key), f"`{key}` of {self.what}", allowed, scope)

    def vector(self, key: str) -> Vector:
        """A required vector."""
        return self.context.vector(self.node(key), f"`{key}` of {self.what}", FORCE)

    def optional_vector(self, key: str, allowed: Allowed) -> Vector | None:
        """An optional vector."""
        node = self.section.get(key)
        return None if node is None else self.context.vector(node, f"`{key}` of {self.what}", allowed)

    def one_of(self, key: str, known: Sequence[str], kind: str, kinds: str) -> str:
        """The name of something that the file declares elsewhere."""
        return self._declared(scalar_of(self.node(key), f"`{key}` of {self.what}"), known, kind, kinds)

    def several_of(self, key: str, known: Sequence[str], kind: str, kinds: str) -> tuple[str, ...]:
        """One name, or a list of names, each different."""
        node = self.node(key)
        if not isinstance(node, ListNode):
            return (self.one_of(key, known, kind, kinds),)
        items = [
            scalar_of(item, f"`{key}` of {self.what}") for item in items_of(node, f"`{key}` of {self.what}", "[a, b]")
        ]
        names = self.all_of(*(lambda i=i: self._declared(i, known, kind, kinds) for i in items))
        for n, name in enumerate(names):
            if name in names[:n]:
                message = f"`{name}` occurs twice in the `{key}` of {self.what}"
                raise ProblemError(Diagnostic("declared-twice", message, items[n].span, help="keep one of the two"))
        if not names:
            raise ProblemError(
                Diagnostic("empty-value", f"`{key}` of {self.what} is empty", node.span, help=f"name {kind}")
            )
        return tuple(names)

    def _declared(self, scalar: Scalar, known: Sequence[str], kind: str, kinds: str) -> str:
        name = canonical(scalar.text, known)
        if name in known:
            return name
        if self.context.names.has_failed(scalar.text):
            raise ProblemError(())
        message = f"`{scalar.text}` is not {kind} of this file"
        raise ProblemError(Diagnostic("unknown-name", message, scalar.span, help=suggestion(name, known, kinds)))

    def point(self) -> str:
        """The particle or body that is acted on."""
        name = self.one_of("on", self.context.things.known(), "a particle or body", "particles or bodies")
        return self.context.called.get(name, name)

    def body(self) -> str:
        """The body that is acted on."""
        name = self.one_of("on", self.context.bodies, "a rigid body", "bodies")
        return self.context.called.get(name, name)

    def ends(self) -> tuple[Vector, Vector]:
        """The two ends of a spring or damper: particles, bodies or position vectors."""
        node = self.node("between")
        items = items_of(node, f"`between` of {self.what}", "between: [P, Q]")
        if len(items) != 2:
            message = f"{self.what} needs two ends, not {len(items)}"
            help_ = "write `between: [P, Q]`; an end is a particle, a body or a position vector"
            raise ProblemError(Diagnostic("two-ends", message, node.span, help=help_))
        a, b = self.all_of(*(lambda i=i: self.end(i) for i in items))
        return a, b

    def end(self, node: Node) -> Vector:
        """One end: a particle, a body, or a position vector."""
        points = self.context.points
        if isinstance(node, Scalar):
            name = canonical(node.text, points)
            if name in points:
                return self.position(name)
            if self.context.names.has_failed(node.text):
                raise ProblemError(())
            if name == "O" and not self.context.is_known(name):
                return Vector((sp.S.Zero,) * 3)
            if names_in(node.text) == (name,) and not self.context.is_known(name):
                known = (*points, *self.context.scope.vectors)
                message = f"`{node.text}` is neither a particle or body nor a vector of this file"
                help_ = suggestion(name, known, "ends")
                raise ProblemError(Diagnostic("unknown-name", message, node.span, help=help_))
        return self.context.vector(node, f"an end of {self.what}", POSITION)

    def position(self, name: str) -> Vector:
        """The position of a particle or body."""
        point = self.context.points[name]
        if point is None:  # it could not be read, which has been reported
            raise ProblemError(())
        return point

    def slip(self) -> int | Vector | None:
        """The sense of the slip, +1 or −1, or a vector along it; None if the key is absent."""
        node = self.section.get("slip")
        if isinstance(node, Scalar):
            name = canonical(node.text, self.context.scope.vectors)
            if node.text in SENSES or (names_in(node.text) == (name,) and not self.context.is_known(name)):
                return self.sense("slip")
        along = self.optional_vector("slip", POSITION)
        if along is not None and along.is_zero:
            help_ = "give the direction in which the touching point slips, as `slip: -j`"
            raise ProblemError(Diagnostic("friction-slip", f"`slip` of {self.what} is zero", self.span, help=help_))
        return along

    def refuse_negative(self, value: sp.Expr, key: str, help_: str) -> None:
        """Raises ProblemError if a value is negative for all parameters, or with the values that they have."""
        with_values = value.xreplace(self.context.values)
        if value.is_negative or with_values.is_negative:
            message = f"`{key}` of {self.what} is negative"
            raise ProblemError(Diagnostic("negative-coefficient", message, self.node(key).span, help=help_))

    def sense(self, key: str) -> int | None:
        """+1 for `positive`, -1 for `negative`; None if the key is absent."""
        node = self.section.get(key)
        if node is None:
            return None
        scalar = scalar_of(node, f"`{key}` of {self.what}")
        if scalar.text not in SENSES:
            help_ = f"write `{key}: positive` or `{key}: negative`, or leave it out where it is not known"
            raise ProblemError(Diagnostic("unknown-sense", f"`{scalar.text}` is not a sense", scalar.span, help=help_))
        return SENSES[scalar.text]


def _applied(f: _Entry) -> Force:
    on, vector, at = f.all_of(f.point, lambda: f.vector("vector"), lambda: f.optional_vector("at", PLACE))
    return AppliedForce(f.name, on, vector, f.span, at)


def _moment(f: _Entry) -> Force:
    help_ = "a moment is a vector along its axis: write `M*k` for one that turns i towards j"
    on, moment = f.all_of(f.body, lambda: _vector_or(help_, lambda: f.vector("moment")))
    return AppliedMoment(f.name, on, moment, f.span)


def _spring(f: _Entry) -> Force:
    stiffness, ends, length, sense = f.all_of(
        lambda: f.scalar("spring", SPRING),
        f.ends,
        lambda: f.scalar("length", SPRING) if f.section.get("length") else sp.S.Zero,
        lambda: f.sense("sense"),
    )
    if sense is not None and sum(c != 0 for c in (ends[1] - ends[0]).components) != 1:
        message = f"the ends of the spring `{f.name}` are not on a line along a unit vector"
        help_ = "leave `sense` out: it is the sign of the second end's coordinate less the first's, on such a line"
        raise ProblemError(Diagnostic("sense-off-line", message, f.span, help=help_))
    return Spring(f.name, stiffness, ends, length, f.span, sense)


def _damper(f: _Entry) -> Force:
    coefficient, ends = f.all_of(lambda: f.scalar("damper"), f.ends)
    return Damper(f.name, coefficient, ends, f.span)


def _potential(f: _Entry) -> Force:
    return Potential(f.name, f.scalar("potential", ENERGY), f.span)


def _generalized(f: _Entry) -> Force:
    example = "generalized: {theta: -c*theta'}"
    entries = entries_of(f.node("generalized"), f"`generalized` of {f.what}", example)
    coordinates = {q.name: q for q in f.context.scope.slots.coordinates}
    components: dict[sp.Symbol, sp.Expr] = {}
    for key, value in entries:
        name = canonical(key.text, coordinates)
        if name not in coordinates:
            if not f.context.names.has_failed(key.text):
                help_ = suggestion(name, list(coordinates), "coordinates")
                message = f"`{key.text}` is not a coordinate of this file"
                f.context.diagnostics.report(Diagnostic("unknown-name", message, key.span, help=help_))
            continue
        what = f"the generalized force of `{name}` in {f.what}"
        read = f.context.diagnostics.attempt(lambda v=value, w=what: f.context.scalar(v, w, FORCE))  # type: ignore[misc]
        if read is not None:
            components[coordinates[name]] = read
    return GeneralizedForce(f.name, components, f.span)


def _friction(f: _Entry) -> Force:
    constraints = f.context.constraints.known()
    coefficient, constraint, on, velocity, slip, contact, at, static = f.all_of(
        lambda: f.scalar("friction"),
        lambda: f.several_of("constraint", constraints, "a constraint", "constraints"),
        f.point,
        lambda: f.optional_vector("surface_velocity", RATE),
        f.slip,
        lambda: f.sense("contact"),
        lambda: f.optional_vector("at", POSITION),
        lambda: f.scalar("static") if f.section.get("static") else None,
    )
    f.refuse_negative(coefficient, "friction", "a coefficient of friction is not negative")
    if static is not None:
        f.refuse_negative(static, "static", "a coefficient of friction is not negative")
    sense, toward = (slip, None) if isinstance(slip, int) else (None, slip)
    first, *also = constraint
    return Friction(f.name, coefficient, first, on, f.span, velocity, sense, contact, at, toward, static, (*also,))


def _belt(f: _Entry) -> Force:
    coefficient, angle, tight, slack = f.all_of(
        lambda: f.scalar("belt", COEFFICIENT),
        lambda: f.scalar("angle", PLACE),
        lambda: f.scalar("tight", FORCE, f.tensions),
        lambda: f.scalar("slack", FORCE, f.tensions),
    )
    f.refuse_negative(angle, "angle", "the angle of contact is counted from the slack side, and is positive")
    f.refuse_negative(coefficient, "belt", "a coefficient of friction is not negative")
    return Belt(f.name, coefficient, angle, tight, slack, f.span)


_READERS: dict[str, Callable[[_Entry], Force]] = {
    "vector": _applied,
    "moment": _moment,
    "spring": _spring,
    "damper": _damper,
    "potential": _potential,
    "generalized": _generalized,
    "friction": _friction,
    "belt": _belt,
}
