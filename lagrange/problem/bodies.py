"""Reading rigid bodies, and how they are turned.

A planar body turns by an angle α about k: ω = α' k. In space the orientation is a sequence of three rotations about
body axes (`313`: first about e_3, then about the new e_1, then about the new e_3), or the file gives a triad for the
inertia and the angular velocity (`rotation.py`). A body adds vectors to the language: its position, its angular
velocity and its axes, in components of a triad in which they are short (`orientation.py`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.vectors import Vector
from lagrange.problem.model import Body
from lagrange.problem.nodes import Mapping as MappingNode
from lagrange.problem.nodes import Node, Scalar
from lagrange.problem.nodes import Sequence as ListNode
from lagrange.problem.orientation import axis_names, names_before_last, orientation
from lagrange.problem.reading import Reading
from lagrange.problem.sections import Section, items_of, mapping_of, scalar_of, wrong_kind
from lagrange.problem.symbols import CONSTANT, POSITION, RATE

SEQUENCES = ("121", "123", "131", "132", "212", "213", "231", "232", "312", "313", "321", "323")
_KEYS = ("mass", "inertia", "position", "angle", "orientation", "axes", "angular_velocity")
_EXAMPLE = "{mass: m, inertia: I_G, position: x*i + y*j, angle: theta}"
_TURNING = (
    "a planar body has one moment of inertia and `angle`; a body in space has three, and `orientation`, "
    "or `axes` with `angular_velocity`"
)


def names_of_turning(name: str, node: Node) -> dict[str, str]:
    """The vectors that a body adds to the language beside its position, and what they are."""
    found = {f"omega_{name}": f"the angular velocity of `{name}`"}
    found |= dict.fromkeys(axis_names(name), f"an axis of the body `{name}`")
    if isinstance(node, MappingNode) and any(key.text == "orientation" for key, _ in node.entries):
        found |= dict.fromkeys(names_before_last(name), f"an axis before the last rotation of `{name}`")
    return found


class BodyBeingRead:
    """One entry of `bodies`. How the body is turned is read apart from where it is: a position may use its axes."""

    def __init__(self, name: str, key: Scalar, node: Node, reading: Reading) -> None:
        self.name = name
        self.key = key
        self.node = node
        self.reading = reading
        self._body: Body | None = None

    @cached_property
    def _section(self) -> Section:
        what = f"the body `{self.name}`"
        return Section(mapping_of(self.node, what, f"{self.name}: {_EXAMPLE}"), what, _KEYS, self.reading.findings)

    def turning(self) -> Mapping[str, Vector]:
        """Reads all but the position; the vectors that this adds to the language."""
        section, reading = self._section, self.reading
        mass, inertia = reading.findings.all_of(
            lambda: mass_of(section.get("mass"), self.name, reading),
            lambda: _inertia(section.required("inertia", self.key.span, "I_G"), reading),
        )
        self._body = _turned_body(Body(self.name, mass, Vector.zero(), inertia, self.key.span), section, reading)
        found = orientation(self._body, reading.scope.slots)
        return {f"omega_{self.name}": found.angular_velocity, **found.vectors}

    def position(self) -> Vector:
        """Reads the position of the mass centre."""
        node = self._section.required("position", self.key.span, "x*i + y*j")
        return self.reading.vector(node, f"the position of `{self.name}`")

    def at(self, position: Vector) -> Body | None:
        """The body; None where the rest of it could not be read."""
        return None if self._body is None else replace(self._body, position=position)


def constant(node: Node, what: str, reading: Reading) -> sp.Expr:
    """An expression of parameters that is not negative. Raises ProblemError where it is none."""
    value = reading.scalar(node, what, CONSTANT)
    if value.xreplace(reading.values).is_negative:
        shown = "" if value.is_negative else ", with the values that the file gives"
        raise ProblemError(Diagnostic("negative", f"{what} is negative{shown}", node.span, help="change its sign"))
    return value


def mass_of(node: Node | None, name: str, reading: Reading) -> sp.Expr:
    """The mass of a particle or body; 0 where the file gives none."""
    return sp.S.Zero if node is None else constant(node, f"the mass of `{name}`", reading)


def _inertia(node: Node, reading: Reading) -> tuple[sp.Expr, ...]:
    if isinstance(node, Scalar) and node.text.lstrip().startswith("["):
        message = "`inertia` is a list here, and not a text"
        raise ProblemError(Diagnostic("inertia", message, node.span, help="write `inertia: [A, B, C]` without quotes"))
    if not isinstance(node, ListNode):
        return (constant(node, "a moment of inertia", reading),)
    if len(node.items) != 3:
        message = f"`inertia` has one moment, or three principal moments, and not {len(node.items)}"
        raise ProblemError(Diagnostic("inertia", message, node.span, help="write `inertia: [A, B, C]`"))
    return tuple(constant(item, "a moment of inertia", reading) for item in node.items)


def _turned_body(body: Body, section: Section, reading: Reading) -> Body:
    """The body with what says how it is turned."""
    given = {k for k in ("angle", "orientation", "axes", "angular_velocity") if section.has(k)}
    planar = len(body.inertia) == 1
    if planar and given == {"angle"}:
        return _with_angle(body, section, reading)
    if not planar and given == {"orientation"}:
        return _with_orientation(body, section, reading)
    if not planar and given == {"axes", "angular_velocity"}:
        return _with_axes(body, section, reading)
    message = f"it is not clear how the body `{body.name}` is turned"
    raise ProblemError(Diagnostic("orientation", message, body.span, help=_TURNING))


def _with_angle(body: Body, section: Section, reading: Reading) -> Body:
    angle = reading.scalar(section.required("angle", body.span, "theta"), f"the angle of `{body.name}`", POSITION)
    return replace(body, angle=angle)


def _with_orientation(body: Body, section: Section, reading: Reading) -> Body:
    example = "{axes: 313, angles: [phi, theta, psi]}"
    node = section.required("orientation", body.span, example)
    mapping = mapping_of(node, "`orientation`", f"orientation: {example}")
    inner = Section(mapping, "the orientation", ("axes", "angles"), reading.findings)
    sequence = _sequence(inner.required("axes", node.span, "313"))
    angles_node = inner.required("angles", node.span, "[phi, theta, psi]")
    items = items_of(angles_node, "`angles`", "angles: [phi, theta, psi]")
    if len(items) != 3:
        message = f"an orientation has three angles, not {len(items)}"
        help_ = "write `angles: [phi, theta, psi]`"
        raise ProblemError(Diagnostic("orientation", message, angles_node.span, help=help_))
    angles = tuple(reading.scalar(i, f"an angle of `{body.name}`", POSITION) for i in items)
    return replace(body, sequence=sequence, angles=angles)


def _sequence(node: Node) -> str:
    scalar = scalar_of(node, "`axes`")
    if scalar.text not in SEQUENCES:
        message = f"`{scalar.text}` is not a sequence of rotations"
        help_ = f"it is one of {', '.join(SEQUENCES)}: neighbouring axes differ"
        raise ProblemError(Diagnostic("unknown-sequence", message, scalar.span, help=help_))
    return scalar.text


def _with_axes(body: Body, section: Section, reading: Reading) -> Body:
    node = section.required("axes", body.span, "[e1, e2, e3]")
    items = items_of(node, "`axes`", "axes: [e1, e2, e3]")
    if len(items) != 3:
        raise ProblemError(wrong_kind(node, f"`axes` has three vectors, and not {len(items)}", "write `[e1, e2, e3]`"))
    a, b, c = (reading.vector(i, f"an axis of `{body.name}`") for i in items)
    _check_triad((a, b, c), node, reading)
    spin_node = section.required("angular_velocity", body.span, "theta'*k")
    spin = reading.vector(spin_node, f"the angular velocity of `{body.name}`", RATE)
    names = tuple(item.text for item in items if isinstance(item, Scalar) and item.text in reading.scope.vectors)
    called = names if len(set(names)) == 3 else ()
    return replace(body, axes=(a, b, c), axes_called=called, angular_velocity=spin)


def _check_triad(axes: tuple[Vector, Vector, Vector], node: Node, reading: Reading) -> None:
    """Refuses axes that are not perpendicular unit vectors in right-handed order. What is undecided passes."""
    wanted = [(axes[m].dot(axes[n]), int(m == n)) for m in range(3) for n in range(m, 3)]
    if any(_differs(value, number, reading) for value, number in wanted):
        message = "these axes are not perpendicular unit vectors"
        help_ = "check their lengths and the angles between them"
    elif _differs(axes[0].cross(axes[1]).dot(axes[2]), 1, reading):
        message, help_ = "these axes are left-handed", "reverse or exchange two of them"
    else:
        return
    raise ProblemError(Diagnostic("axes", message, node.span, help=help_))


def _differs(value: sp.Expr, number: int, reading: Reading) -> bool:
    try:
        return reading.is_zero(value - number) is False
    except DivisionByZeroError:
        return True
