"""Reading the frame of a problem file, whose unit vectors join the language: e_r, e_theta, e_phi beside i, j, k."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, ProblemError, Span, suggestion
from lagrange.core.triads import cylindrical, polar, spherical, unit_vector
from lagrange.core.vectors import FIXED, Triad
from lagrange.problem.declared_names import canonical
from lagrange.problem.keys import FRAME, FRAME_COORDINATES, FrameType
from lagrange.problem.load_context import LoadContext
from lagrange.problem.sections import Section, items_of, mapping_of, scalar_of
from lagrange.problem.yaml.nodes import Node, Scalar

_TRIADS: dict[FrameType, Callable[..., Triad]] = {
    FrameType.CARTESIAN: lambda *_: FIXED,
    FrameType.POLAR: polar,
    FrameType.CYLINDRICAL: cylindrical,
    FrameType.SPHERICAL: spherical,
}

_EXAMPLE = "frame: {type: polar, coordinates: [r, phi]}"
_ORDER = {frame_type: ", ".join(names) for frame_type, names in FRAME_COORDINATES.items()}


def read_frame(node: Node | None, context: LoadContext) -> Triad | None:
    """The frame, whose unit vectors join the scope; None where the file has none."""
    if node is None:
        return None
    triad = context.diagnostics.attempt(lambda: _frame(node, context))
    if triad is None:
        context.names.fail_all(node)
        context.names.fail(*(f"e_{name}" for name in ("r", "rho", "theta", "phi", *context.scope.scalars)))
    return triad


def _frame(node: Node, context: LoadContext) -> Triad:
    section = Section(mapping_of(node, "`frame`", _EXAMPLE), "the frame", FRAME, context.diagnostics)
    kind = _type(section.required("type", node.span))
    items = _coordinates(section, kind, node.span)
    symbols = tuple(coordinate(scalar_of(i, "a coordinate"), context) for i in items)
    triad = _TRIADS[kind](*symbols)
    if triad is not FIXED:
        _check_names(triad, kind, symbols, node.span)
        _declare(triad, kind, symbols, context, node.span)
    return triad


def _type(node: Node) -> FrameType:
    scalar = scalar_of(node, "`type`")
    if scalar.text in set(FrameType):
        return FrameType(scalar.text)
    help_ = suggestion(scalar.text, [*FrameType], "types")
    raise ProblemError(Diagnostic("unknown-frame", f"`{scalar.text}` is not a type of frame", scalar.span, help=help_))


def _coordinates(section: Section, kind: FrameType, span: Span) -> tuple[Node, ...]:
    """The coordinates of the frame; a Cartesian one needs none."""
    count = 0 if kind is FrameType.CARTESIAN else len(FRAME_COORDINATES[kind])
    if not count and not section.has("coordinates"):
        return ()
    node = section.required("coordinates", span, f"[{_ORDER[kind]}]")
    items = items_of(node, "`coordinates`", f"coordinates: [{_ORDER[kind]}]")
    if count and len(items) != count:
        message = f"a {kind} frame has {count} coordinates, not {len(items)}"
        help_ = f"list them in the order {_ORDER[kind]}, under the names that they have in the file"
        raise ProblemError(Diagnostic("frame-coordinates", message, node.span, help=help_))
    return items


def coordinate(scalar: Scalar, context: LoadContext) -> sp.Symbol:
    """The coordinate or prescribed motion of a name. Raises ProblemError where none is declared."""
    slots = context.scope.slots
    symbols = {s.name: s for s in (*slots.coordinates, *slots.prescribed)}
    name = canonical(scalar.text, symbols)
    if name in symbols:
        return symbols[name]
    if context.names.has_failed(name):
        raise ProblemError(())
    message = f"`{scalar.text}` is not a coordinate of this file"
    help_ = suggestion(name, list(symbols), "coordinates")
    raise ProblemError(Diagnostic("unknown-coordinate", message, scalar.span, help=help_))


def _check_names(triad: Triad, kind: FrameType, symbols: tuple[sp.Symbol, ...], span: Span) -> None:
    """Raises ProblemError where two unit vectors, or one and a fixed vector, would have the same name."""
    third = f"e_{symbols[2].name}" if kind is FrameType.CYLINDRICAL else triad.names[2]
    fixed = {"e_x", "e_y", "e_z"} - ({third} if kind is FrameType.CYLINDRICAL else set())
    taken = next((name for name in (*triad.names[:2], third) if name in fixed), None)
    if taken is not None:
        message = f"the frame would call a unit vector `{taken}`, and `e_x`, `e_y`, `e_z` are i, j, k"
        help_ = f"rename the coordinate `{taken[2:]}`"
    elif len(set(symbols)) < len(symbols):
        message, help_ = "the frame has one coordinate twice", f"list them in the order {_ORDER[kind]}"
    else:
        return
    raise ProblemError(Diagnostic("frame-coordinates", message, span, help=help_))


def _declare(triad: Triad, kind: FrameType, symbols: tuple[sp.Symbol, ...], context: LoadContext, span: Span) -> None:
    """Adds the unit vectors to the scope. A third that is k is also `k` and `e_z`, so that sums stay in the frame."""
    units = {name: unit_vector(triad, n) for n, name in enumerate(triad.names)}
    if kind is FrameType.CYLINDRICAL:
        units[f"e_{symbols[2].name}"] = unit_vector(triad, 2)
    for name in units:
        if name not in ("k", "e_z"):
            context.names.add(name, "a unit vector of the frame", span)
    if kind is not FrameType.SPHERICAL:
        units |= {"e_z": unit_vector(triad, 2), "k": unit_vector(triad, 2)}
    context.add_vectors(units)
