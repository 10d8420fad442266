"""Reading what acts: gravity, forces, moments, springs, dampers, potentials, friction.

The kind of a force is told by its keys: `vector`, `moment`, `spring`, `damper`, `potential` or `friction`. Applied
forces may depend on position, velocity and time, never on accelerations.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, ProblemError, suggestion
from lagrange.core.vectors import Vector
from lagrange.problem.model import AppliedForce, AppliedMoment, Damper, Force, Friction, Potential, Spring
from lagrange.problem.names import canonical, names_in
from lagrange.problem.nodes import Node, Scalar
from lagrange.problem.reading import Reading
from lagrange.problem.sections import Section, entries_of, items_of, mapping_of, scalar_of
from lagrange.problem.symbols import ENERGY, FORCE, POSITION, RATE, Allowed

_EXAMPLE = "forces: {push: {on: P, vector: F*i}}"


def read_gravity(node: Node | None, reading: Reading) -> Vector | None:
    """The acceleration of gravity."""
    return None if node is None else reading.findings.attempt(lambda: reading.vector(node, "`gravity`", FORCE))


def read_forces(node: Node | None, reading: Reading) -> tuple[Force, ...]:
    """name -> what acts."""
    if node is None:
        return ()
    found = []
    for key, value in reading.findings.attempt(lambda: entries_of(node, "`forces`", _EXAMPLE)) or ():
        name = reading.forces.declare(key, "a force")
        if name is not None:
            force = reading.findings.attempt(lambda n=name, k=key, v=value: _force(n, k, v, reading))  # type: ignore[misc]
            found += [force] if force is not None else []
    return tuple(found)


def _force(name: str, key: Scalar, node: Node, reading: Reading) -> Force:
    what = f"the force `{name}`"
    mapping = mapping_of(node, what, f"{name}: {{on: P, vector: F*i}}")
    kinds = [k for k in _KINDS if any(entry.text == k for entry, _ in mapping.entries)]
    if len(kinds) > 1:
        listed = " and ".join(f"`{k}`" for k in kinds)
        help_ = "give every force an entry of its own"
        raise ProblemError(Diagnostic("force-kind", f"{what} has {listed}", key.span, help=help_))
    keys = _KINDS[kinds[0]][0] if kinds else tuple(dict.fromkeys(k for keys, _ in _KINDS.values() for k in keys))
    section = Section(mapping, what, keys, reading.findings)
    kind = kinds[0] if kinds else next((k for k in _KINDS if section.has(k)), None)
    if kind is None and section.strange:
        raise ProblemError(())  # the key may have been meant to say it, and has been reported
    if kind is None:
        listed = ", ".join(f"`{k}`" for k in _KINDS)
        message = f"{what} does not say what acts"
        raise ProblemError(Diagnostic("force-kind", message, key.span, help=f"give it one of {listed}"))
    return _KINDS[kind][1](_Entry(name, what, key, section, reading))


class _Entry:
    """One entry of `forces`, whose values are asked for by their keys."""

    def __init__(self, name: str, what: str, key: Scalar, section: Section, reading: Reading) -> None:
        self.name = name
        self.what = what
        self.span = key.span
        self.section = section
        self.reading = reading
        self.all_of = reading.findings.all_of

    def node(self, key: str, example: str) -> Node:
        """The value of a key that must be there."""
        return self.section.required(key, self.span, example)

    def scalar(self, key: str, example: str, allowed: Allowed = FORCE) -> sp.Expr:
        """A scalar that must be there."""
        return self.reading.scalar(self.node(key, example), f"`{key}` of {self.what}", allowed)

    def vector(self, key: str, example: str) -> Vector:
        """A vector that must be there."""
        return self.reading.vector(self.node(key, example), f"`{key}` of {self.what}", FORCE)

    def optional_vector(self, key: str, allowed: Allowed) -> Vector | None:
        """A vector that may be there."""
        node = self.section.get(key)
        return None if node is None else self.reading.vector(node, f"`{key}` of {self.what}", allowed)

    def one_of(self, key: str, known: Sequence[str], example: str, kind: str, kinds: str) -> str:
        """A name of something that the file declares elsewhere."""
        scalar = scalar_of(self.node(key, example), f"`{key}` of {self.what}")
        name = canonical(scalar.text, known)
        if name in known:
            return name
        if self.reading.names.has_failed(scalar.text):
            raise ProblemError(())
        message = f"`{scalar.text}` is not {kind} of this file"
        raise ProblemError(Diagnostic("unknown-name", message, scalar.span, help=suggestion(name, known, kinds)))

    def point(self) -> str:
        """The particle or body that is acted on."""
        return self.one_of("on", self.reading.things.known(), "P", "a particle or body", "particles or bodies")

    def ends(self) -> tuple[Vector, Vector]:
        """The two ends of a spring or damper: particles, bodies or position vectors."""
        node = self.node("between", "[P, Q]")
        items = items_of(node, f"`between` of {self.what}", "between: [P, Q]")
        if len(items) != 2:
            message = f"{self.what} needs two ends, not {len(items)}"
            help_ = "write `between: [P, Q]`; an end is a particle, a body or a position vector"
            raise ProblemError(Diagnostic("two-ends", message, node.span, help=help_))
        a, b = self.all_of(*(lambda i=i: self.end(i) for i in items))
        return a, b

    def end(self, node: Node) -> Vector:
        """One end: a particle, a body, or a position vector."""
        points = self.reading.points
        if isinstance(node, Scalar):
            name = canonical(node.text, points)
            if name in points:
                return self.position(name)
            if self.reading.names.has_failed(node.text):
                raise ProblemError(())
            if names_in(node.text) == (name,) and not self.reading.is_known(name):
                known = (*points, *self.reading.scope.vectors)
                message = f"`{node.text}` is neither a particle or body nor a vector of this file"
                help_ = suggestion(name, known, "ends")
                raise ProblemError(Diagnostic("unknown-name", message, node.span, help=help_))
        return self.reading.vector(node, f"an end of {self.what}", POSITION)

    def position(self, name: str) -> Vector:
        """The position of a particle or body."""
        point = self.reading.points[name]
        if point is None:  # it could not be read, and that has been said
            raise ProblemError(())
        return point

    def sense(self, key: str) -> int | None:
        """`positive` or `negative`, where the key is there."""
        node = self.section.get(key)
        if node is None:
            return None
        scalar = scalar_of(node, f"`{key}` of {self.what}")
        senses = {"positive": 1, "negative": -1}
        if scalar.text not in senses:
            help_ = f"write `{key}: positive` or `{key}: negative`, or leave it out where it is not known"
            raise ProblemError(Diagnostic("unknown-sense", f"`{scalar.text}` is no sense", scalar.span, help=help_))
        return senses[scalar.text]


def _applied(f: _Entry) -> Force:
    on, vector, at = f.all_of(f.point, lambda: f.vector("vector", "F*i"), lambda: f.optional_vector("at", POSITION))
    return AppliedForce(f.name, on, vector, f.span, at)


def _moment(f: _Entry) -> Force:
    on, moment = f.all_of(
        lambda: f.one_of("on", f.reading.bodies, "rod", "a rigid body", "bodies"), lambda: f.vector("moment", "M*k")
    )
    return AppliedMoment(f.name, on, moment, f.span)


def _spring(f: _Entry) -> Force:
    stiffness, ends, length, sense = f.all_of(
        lambda: f.scalar("spring", "c", ENERGY),
        f.ends,
        lambda: f.scalar("length", "l_0", ENERGY) if f.section.get("length") else sp.S.Zero,
        lambda: f.sense("sense"),
    )
    if sense is not None and sum(c != 0 for c in (ends[1] - ends[0]).components) != 1:
        message = f"the ends of the spring `{f.name}` are not on a line along a unit vector"
        help_ = "leave `sense` out: it is the sign of the second end's coordinate less the first's, on such a line"
        raise ProblemError(Diagnostic("sense-off-line", message, f.span, help=help_))
    return Spring(f.name, stiffness, ends, length, f.span, sense)


def _damper(f: _Entry) -> Force:
    coefficient, ends = f.all_of(lambda: f.scalar("damper", "b"), f.ends)
    return Damper(f.name, coefficient, ends, f.span)


def _potential(f: _Entry) -> Force:
    return Potential(f.name, f.scalar("potential", "m*g*y", ENERGY), f.span)


def _friction(f: _Entry) -> Force:
    constraints = f.reading.constraints.known()
    coefficient, constraint, on, velocity, slip, contact = f.all_of(
        lambda: f.scalar("friction", "mu"),
        lambda: f.one_of("constraint", constraints, "surface", "a constraint", "constraints"),
        f.point,
        lambda: f.optional_vector("surface_velocity", RATE),
        lambda: f.sense("slip"),
        lambda: f.sense("contact"),
    )
    return Friction(f.name, coefficient, constraint, on, f.span, velocity, slip, contact)


_KINDS: dict[str, tuple[tuple[str, ...], Callable[[_Entry], Force]]] = {
    "vector": (("vector", "on", "at"), _applied),
    "moment": (("moment", "on"), _moment),
    "spring": (("spring", "between", "length", "sense"), _spring),
    "damper": (("damper", "between"), _damper),
    "potential": (("potential",), _potential),
    "friction": (("friction", "constraint", "on", "surface_velocity", "slip", "contact"), _friction),
}
"""The kinds of forces: the keys that each may have, and how it is read."""
