"""Reading the frame of a problem file, whose unit vectors join the language: e_r, e_theta, e_phi beside i, j, k."""

from __future__ import annotations

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, ProblemError, Span, suggestion
from lagrange.core.vectors import FIXED, Triad, Vector
from lagrange.problem.frames import FRAMES, FrameType
from lagrange.problem.names import canonical
from lagrange.problem.nodes import Node, Scalar
from lagrange.problem.reading import Reading
from lagrange.problem.sections import Section, items_of, mapping_of, scalar_of

_EXAMPLE = "frame: {type: polar, coordinates: [r, phi]}"
_ORDER = {
    FrameType.CARTESIAN: "x, y, z",
    FrameType.POLAR: "r, phi",
    FrameType.CYLINDRICAL: "rho, phi, z",
    FrameType.SPHERICAL: "r, theta, phi",
}


def read_frame(node: Node | None, reading: Reading) -> Triad | None:
    """The frame, whose unit vectors join the scope; None where the file has none."""
    if node is None:
        return None
    triad = reading.findings.attempt(lambda: _frame(node, reading))
    if triad is None:
        reading.names.fail_all(node)
        reading.names.fail(*(f"e_{name}" for name in ("r", "rho", "theta", "phi", *reading.scope.scalars)))
    return triad


def _frame(node: Node, reading: Reading) -> Triad:
    section = Section(mapping_of(node, "`frame`", _EXAMPLE), "the frame", ("type", "coordinates"), reading.findings)
    kind = _type(section.required("type", node.span, "polar"))
    items = _coordinates(section, kind, node.span)
    symbols = tuple(coordinate(scalar_of(i, "a coordinate"), reading) for i in items)
    triad = FRAMES[kind][1](*symbols)
    if triad is not FIXED:
        _check_names(triad, kind, symbols, node.span)
        _declare(triad, kind, reading, node.span)
    return triad


def _type(node: Node) -> FrameType:
    scalar = scalar_of(node, "`type`")
    if scalar.text in set(FrameType):
        return FrameType(scalar.text)
    help_ = suggestion(scalar.text, [*FrameType], "types")
    raise ProblemError(Diagnostic("unknown-frame", f"`{scalar.text}` is not a type of frame", scalar.span, help=help_))


def _coordinates(section: Section, kind: FrameType, span: Span) -> tuple[Node, ...]:
    """The coordinates of the frame; a Cartesian one needs none."""
    count = FRAMES[kind][0]
    if not count and not section.has("coordinates"):
        return ()
    node = section.required("coordinates", span, f"[{_ORDER[kind]}]")
    items = items_of(node, "`coordinates`", f"coordinates: [{_ORDER[kind]}]")
    if count and len(items) != count:
        message = f"a {kind} frame has {count} coordinates, not {len(items)}"
        help_ = f"list them in the order {_ORDER[kind]}, under the names that they have in the file"
        raise ProblemError(Diagnostic("frame-coordinates", message, node.span, help=help_))
    return items


def coordinate(scalar: Scalar, reading: Reading) -> sp.Symbol:
    """A declared coordinate or prescribed motion, by name. Raises ProblemError where there is none of that name."""
    slots = reading.scope.slots
    symbols = {s.name: s for s in (*slots.coordinates, *slots.prescribed)}
    name = canonical(scalar.text, symbols)
    if name in symbols:
        return symbols[name]
    if reading.names.has_failed(name):
        raise ProblemError(())
    message = f"`{scalar.text}` is not a coordinate of this file"
    help_ = suggestion(name, list(symbols), "coordinates")
    raise ProblemError(Diagnostic("unknown-coordinate", message, scalar.span, help=help_))


def _check_names(triad: Triad, kind: FrameType, symbols: tuple[sp.Symbol, ...], span: Span) -> None:
    """The unit vectors must have three names, none of which is another vector's."""
    fixed = {"e_x", "e_y", "e_z"} - ({triad.names[2]} if kind is FrameType.CYLINDRICAL else set())
    taken = next((name for name in triad.names if name in fixed), None)
    if taken is not None:
        message = f"the frame would call a unit vector `{taken}`, and `e_x`, `e_y`, `e_z` are i, j, k"
        help_ = f"rename the coordinate `{taken[2:]}`"
    elif len(set(symbols)) < len(symbols):
        message, help_ = "the frame has one coordinate twice", f"list them in the order {_ORDER[kind]}"
    else:
        return
    raise ProblemError(Diagnostic("frame-coordinates", message, span, help=help_))


def _declare(triad: Triad, kind: FrameType, reading: Reading, span: Span) -> None:
    """Makes the unit vectors known. Where the third is k, `k` and `e_z` name it too, so that sums stay in the frame."""
    units = {name: _unit(triad, n) for n, name in enumerate(triad.names)}
    for name in units:
        if name not in ("k", "e_z"):
            reading.names.add(name, "a unit vector of the frame", span)
    if kind is not FrameType.SPHERICAL:
        units |= {"e_z": _unit(triad, 2), "k": _unit(triad, 2)}
    reading.add_vectors(units)


def _unit(triad: Triad, index: int) -> Vector:
    x, y, z = (sp.S.One if n == index else sp.S.Zero for n in range(3))
    return Vector((x, y, z), triad)
