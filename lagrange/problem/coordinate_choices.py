"""Reading the choices of generalized coordinates, and the quasi-velocities.

A choice lists its coordinates, new ones and old ones that it keeps, and gives the other old coordinates in terms of
them; without `substitute` it keeps some of the old ones and leaves the rest to the constraints. A substitution may use
another (x2 = x1 + ...): they are inserted into one another here, and must not be circular.

Reading the frame of a problem file, whose unit vectors join the language: e_r, e_theta, e_phi beside i, j, k.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial

import sympy as sp

from lagrange.algebra.fourier.vector_cleanup import tidied
from lagrange.core.diagnostics import Diagnostic, ProblemError, Span, UndecidedError, suggestion
from lagrange.core.expression_size import Sizes
from lagrange.core.symbols import Slots, t
from lagrange.core.vectors import FIXED, Triad, cylindrical, polar, spherical, unit_vector
from lagrange.expressions.limits import MAX_LAYERS, MAX_SIZE
from lagrange.expressions.scope import Scope
from lagrange.problem.keys import CHOICE, FRAME, FRAME_COORDINATES, FrameType
from lagrange.problem.load_context import LoadContext, canonical, expanded_size
from lagrange.problem.model import Choice, Constraint, Speed
from lagrange.problem.sections import RATE, SUBSTITUTION, Section, entries_of, items_of, mapping_of, scalar_of
from lagrange.problem.yaml.nodes import Node, Scalar

_EXAMPLE_OF_CHOICE = "{coordinates: [theta], substitute: {x: l*sin(theta)}}"


def read_speeds(node: Node | None, context: LoadContext) -> tuple[Speed, ...]:
    """name -> quasi-velocity."""
    if node is None:
        return ()
    speeds: list[Speed] = []
    example = 'speeds: {u: "x\'*cos(theta)"}'
    for key, value in context.diagnostics.attempt(lambda: entries_of(node, "`speeds`", example)) or ():
        name = context.names.declare(key, "a quasi-velocity")
        speed = context.diagnostics.attempt(partial(_speed, key, value, context))
        if name and speed is not None:
            speeds.append(Speed(sp.Symbol(name, real=True), speed, key.span))
    return tuple(speeds)


def _speed(key: Scalar, node: Node, context: LoadContext) -> sp.Expr:
    what = f"the quasi-velocity `{key.text}`"
    value = context.scalar(node, what, RATE)
    if value.free_symbols.isdisjoint(context.scope.slots.velocities):
        help_ = "write it with the velocities, as `x'*cos(theta) + y'*sin(theta)`"
        raise ProblemError(Diagnostic("no-velocity", f"{what} has no velocity in it", node.span, help=help_))
    _check_linear(what, value, node, context)
    short = tidied(value)
    return value if short.free_symbols.isdisjoint(context.scope.slots.velocities) else short


def _check_linear(what: str, value: sp.Expr, node: Node, context: LoadContext) -> None:
    """Raises ProblemError if it is not linear in the velocities, UndecidedError where that cannot be decided."""
    velocities = context.scope.slots.velocities
    second = [value.diff(v).diff(w) for n, v in enumerate(velocities) for w in velocities[n:]]
    verdicts = [e == 0 or context.is_zero(e) for e in second]
    if False in verdicts:
        message = f"{what} is not linear in the velocities"
        help_ = "write a sum of velocities, each times a function of the coordinates and of time"
        raise ProblemError(Diagnostic("speed-not-linear", message, node.span, help=help_))
    if None in verdicts:
        raise UndecidedError(f"whether {what} is linear in the velocities", node.span)


def read_choices(node: Node | None, context: LoadContext) -> tuple[Choice, ...]:
    """name -> {coordinates, substitute}."""
    if node is None:
        return ()
    choices = []
    example = f"generalized_coordinates: {{angle: {_EXAMPLE_OF_CHOICE}}}"
    entries = context.diagnostics.attempt(lambda: entries_of(node, "`generalized_coordinates`", example))
    for key, value in entries or ():
        name = context.choices.declare(key, "a choice")
        if name is not None:
            choice = context.diagnostics.attempt(partial(_choice, name, key, value, context))
            choices += [choice] if choice is not None else []
    return tuple(choices)


def _choice(name: str, key: Scalar, node: Node, context: LoadContext) -> Choice:
    what = f"the choice `{name}`"
    mapping = mapping_of(node, what, f"{name}: {_EXAMPLE_OF_CHOICE}")
    section = Section(mapping, what, CHOICE, context.diagnostics)
    listed = section.required("coordinates", key.span)
    items = items_of(listed, f"`coordinates` of {what}", "coordinates: [theta]")
    if not items:
        message = f"{what} has no coordinates"
        raise ProblemError(Diagnostic("missing-key", message, listed.span, help="write `coordinates: [theta]`"))
    chosen = _chosen(items, what, context)
    substitute = section.get("substitute")
    if substitute is None:
        if section.has("substitute"):  # its value is missing, which has been reported
            raise ProblemError(())
        _check_old(items, chosen, context)
        return Choice(name, chosen, None, key.span)
    return Choice(name, chosen, _substitution(what, key.span, substitute, chosen, context), key.span)


def choice_relative_to_motion(constraints: Sequence[Constraint], slots: Slots) -> Choice | None:
    """The coordinates that moving constraints leave, φ = ω t and z = a x² leave x; None if that is not read off.

    Where something rests relative to what moves can be said in these only.
    """
    substitute: dict[sp.Symbol, sp.Expr] = {}
    for c in constraints:
        sides = [(q, e) for q, e in ((c.lhs, c.rhs), (c.rhs, c.lhs)) if q in slots.coordinates and not e.has(q)]
        free = [(q, e) for q, e in sides if q not in substitute]
        if c.kinematic or c.side is not None or not free:
            return None
        q, e = free[0]
        substitute = {old: value.xreplace({q: e}) for old, value in substitute.items()}
        substitute[q] = e.xreplace(substitute)
    moving = {t, *slots.prescribed}
    kept = tuple(q for q in slots.coordinates if q not in substitute)
    explicit = all(e.free_symbols.isdisjoint(substitute) for e in substitute.values())
    if not kept or not explicit or all(e.free_symbols.isdisjoint(moving) for e in substitute.values()):
        return None
    return Choice("relative", kept, substitute)


def _chosen(items: tuple[Node, ...], what: str, context: LoadContext) -> tuple[sp.Symbol, ...]:
    """The coordinates of a choice: old ones, and newly declared ones."""
    chosen: list[sp.Symbol] = context.diagnostics.all_of(
        *(lambda i=i: _chosen_one(scalar_of(i, "a coordinate"), what, context) for i in items)
    )
    for n, symbol in enumerate(chosen):
        if symbol in chosen[:n]:
            message = f"{what} has the coordinate `{symbol}` twice"
            raise ProblemError(Diagnostic("declared-twice", message, items[n].span, help="list it once"))
    return tuple(chosen)


def _chosen_one(scalar: Scalar, what: str, context: LoadContext) -> sp.Symbol:
    old = {q.name: q for q in context.scope.slots.coordinates}
    name = canonical(scalar.text, old)
    if name in old:
        return old[name]
    name = context.names.symbol(scalar, "a coordinate") or ""
    if not name:
        raise ProblemError(())
    symbol = sp.Symbol(name, real=True)
    if context.names.has_failed(name):
        raise ProblemError(())
    declared = context.names.declared.get(name)
    if declared is not None and declared.what != _NEW:
        line, _ = declared.span.source.position(declared.span.start)
        message = f"`{name}` is {declared.what} and cannot be a coordinate of {what}"
        label = f"declared on line {line}"
        raise ProblemError(Diagnostic("declared-twice", message, scalar.span, label, "choose another name"))
    if declared is None:
        context.names.add(name, _NEW, scalar.span)
    return symbol


_NEW = "a generalized coordinate"


def _check_old(items: tuple[Node, ...], chosen: tuple[sp.Symbol, ...], context: LoadContext) -> None:
    """Raises ProblemError if a choice without a substitution has new coordinates."""
    old = context.scope.slots.coordinates
    for item, symbol in zip(items, chosen, strict=True):
        if symbol not in old and old:
            message = f"`{symbol}` is new, but nothing says how the old coordinates follow from it"
            help_ = f"add `substitute: {{{old[0]}: ...}}`"
            raise ProblemError(Diagnostic("no-substitution", message, item.span, help=help_))


def _substitution(
    what: str, span: Span, node: Node, chosen: tuple[sp.Symbol, ...], context: LoadContext
) -> Mapping[sp.Symbol, sp.Expr]:
    """old coordinate -> expression of the chosen ones and t."""
    old = context.scope.slots.coordinates
    entries = entries_of(node, f"`substitute` of {what}", "substitute: {x: l*sin(theta)}")
    slots = Slots(tuple(dict.fromkeys((*old, *chosen))), context.scope.slots.prescribed)
    scope = replace(context.scope, scalars={**context.scope.scalars, **{s.name: s for s in chosen}}, slots=slots)
    pairs = context.diagnostics.all_of(
        *(lambda k=k, v=v: _substituted(k, v, chosen, scope, context) for k, v in entries)
    )
    given: dict[sp.Symbol, sp.Expr] = {}
    for (key, _), (symbol, value) in zip(entries, pairs, strict=True):
        if symbol in given:  # once as `θ`, once as `theta`
            message = f"`{symbol}` is replaced twice"
            raise ProblemError(Diagnostic("declared-twice", message, key.span, help="keep one of the two"))
        given[symbol] = value
    _check_complete(given, chosen, what, span, context)
    return _chained(given, what, span)


def _substituted(
    key: Scalar, node: Node, chosen: tuple[sp.Symbol, ...], scope: Scope, context: LoadContext
) -> tuple[sp.Symbol, sp.Expr]:
    names = {s.name for s in chosen}
    if canonical(key.text, names) in names:
        message = f"`{key.text}` is among the coordinates of this choice, but is also replaced"
        help_ = "remove it here, or from its `coordinates`"
        raise ProblemError(Diagnostic("kept-and-replaced", message, key.span, help=help_))
    symbol = coordinate(key, context)
    if symbol in context.scope.slots.prescribed:
        message = f"`{symbol}` is a prescribed motion and cannot be replaced"
        raise ProblemError(Diagnostic("unknown-coordinate", message, key.span, help="replace coordinates only"))
    return symbol, context.scalar(node, f"the substitution for `{symbol}`", SUBSTITUTION, scope)


def _check_complete(
    given: Mapping[sp.Symbol, sp.Expr], chosen: tuple[sp.Symbol, ...], what: str, span: Span, context: LoadContext
) -> None:
    missing = [q for q in context.scope.slots.coordinates if q not in given and q not in chosen]
    if missing:
        listed = ", ".join(f"`{q}`" for q in missing)
        message = f"{what} does not say what becomes of {listed}"
        help_ = "give it in `substitute`, or list it among the `coordinates` if the choice keeps it"
        raise ProblemError(Diagnostic("coordinate-left-out", message, span, help=help_))


def _chained(given: Mapping[sp.Symbol, sp.Expr], what: str, span: Span) -> Mapping[sp.Symbol, sp.Expr]:
    """The substitutions inserted into one another, so that no replaced coordinate is left on a right side."""
    resolved: dict[sp.Symbol, sp.Expr] = {}
    waiting = dict(given)
    while waiting:
        ready = [q for q, e in waiting.items() if e.free_symbols.isdisjoint(waiting)]
        if not ready:
            raise ProblemError(_circle(waiting, what, span))
        for q in ready:
            resolved[q] = _inserted(waiting.pop(q), resolved, what, span)
    return {q: resolved[q] for q in given}


def _circle(waiting: Mapping[sp.Symbol, sp.Expr], what: str, span: Span) -> Diagnostic:
    circle = dict(waiting)
    while outside := [q for q in circle if all(q not in e.free_symbols for e in circle.values())]:
        for q in outside:
            del circle[q]
    listed = ", ".join(f"`{q}`" for q in circle)
    message = f"in {what}, the substitution for {listed} is circular"
    help_ = "write each old coordinate in terms of the chosen ones"
    return Diagnostic("circular-substitution", message, span, help=help_)


def _inserted(value: sp.Expr, resolved: Mapping[sp.Symbol, sp.Expr], what: str, span: Span) -> sp.Expr:
    largest = max((expanded_size(resolved[q]) for q in value.free_symbols & resolved.keys()), default=1)
    inserted = value.xreplace(dict(resolved)) if expanded_size(value) * largest <= 10 * MAX_SIZE else None
    if inserted is None or expanded_size(inserted) > MAX_SIZE or Sizes().of(inserted).layers > MAX_LAYERS:
        message = f"in {what}, the substitutions are too large once they are inserted into one another"
        help_ = "write each old coordinate in terms of the chosen ones"
        raise ProblemError(Diagnostic("expression-too-large", message, span, help=help_))
    return inserted


# Frames


_TRIADS: dict[FrameType, Callable[..., Triad]] = {
    FrameType.CARTESIAN: lambda *_: FIXED,
    FrameType.POLAR: polar,
    FrameType.CYLINDRICAL: cylindrical,
    FrameType.SPHERICAL: spherical,
}

_EXAMPLE_OF_FRAME = "frame: {type: polar, coordinates: [r, phi]}"
_ORDER = {frame_type: ", ".join(names) for frame_type, names in FRAME_COORDINATES.items()}


def read_frame(node: Node | None, context: LoadContext) -> Triad | None:
    """The frame, whose unit vectors join the scope; None if the file has none."""
    if node is None:
        return None
    triad = context.diagnostics.attempt(lambda: _frame(node, context))
    if triad is None:
        context.names.fail_all(node)
        context.names.fail(*(f"e_{name}" for name in ("r", "rho", "theta", "phi", *context.scope.scalars)))
    return triad


def _frame(node: Node, context: LoadContext) -> Triad:
    section = Section(mapping_of(node, "`frame`", _EXAMPLE_OF_FRAME), "the frame", FRAME, context.diagnostics)
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
    """The coordinate or prescribed motion of a name. Raises ProblemError if none is declared."""
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
    """Raises ProblemError if two unit vectors, or one and a fixed vector, would have the same name."""
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
