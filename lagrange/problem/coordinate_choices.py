"""Reading the choices of generalized coordinates, and the quasi-velocities.

A choice lists its coordinates, new ones and old ones that it keeps, and gives the other old coordinates in terms of
them; without `substitute` it keeps some of the old ones and leaves the rest to the constraints. A substitution may use
another (x2 = x1 + ...): they are inserted into one another here, and must not be circular.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import sympy as sp

from lagrange.algebra.fourier.vector_cleanup import tidied
from lagrange.core.diagnostics import Diagnostic, ProblemError, Span, UndecidedError
from lagrange.core.expression_size import Sizes
from lagrange.core.symbols import Slots, t
from lagrange.expressions.limits import MAX_LAYERS, MAX_SIZE
from lagrange.expressions.reader import Scope
from lagrange.problem.declared_names import canonical
from lagrange.problem.frames import coordinate
from lagrange.problem.keys import CHOICE
from lagrange.problem.load_context import LoadContext, expanded_size
from lagrange.problem.model import Choice, Constraint, Speed
from lagrange.problem.sections import RATE, SUBSTITUTION, Section, entries_of, items_of, mapping_of, scalar_of
from lagrange.problem.yaml.nodes import Node, Scalar

_EXAMPLE = "{coordinates: [theta], substitute: {x: l*sin(theta)}}"


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
    """Raises ProblemError where it is not linear in the velocities, UndecidedError where that cannot be decided."""
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
    example = f"generalized_coordinates: {{angle: {_EXAMPLE}}}"
    entries = context.diagnostics.attempt(lambda: entries_of(node, "`generalized_coordinates`", example))
    for key, value in entries or ():
        name = context.choices.declare(key, "a choice")
        if name is not None:
            choice = context.diagnostics.attempt(partial(_choice, name, key, value, context))
            choices += [choice] if choice is not None else []
    return tuple(choices)


def _choice(name: str, key: Scalar, node: Node, context: LoadContext) -> Choice:
    what = f"the choice `{name}`"
    mapping = mapping_of(node, what, f"{name}: {_EXAMPLE}")
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
        message = f"`{name}` is {declared.what}, and cannot be a coordinate of {what}"
        label = f"declared on line {line}"
        raise ProblemError(Diagnostic("declared-twice", message, scalar.span, label, "choose another name"))
    if declared is None:
        context.names.add(name, _NEW, scalar.span)
    return symbol


_NEW = "a generalized coordinate"


def _check_old(items: tuple[Node, ...], chosen: tuple[sp.Symbol, ...], context: LoadContext) -> None:
    """Raises ProblemError where a choice without a substitution has new coordinates."""
    old = context.scope.slots.coordinates
    for item, symbol in zip(items, chosen, strict=True):
        if symbol not in old and old:
            message = f"`{symbol}` is new, and nothing says how the old coordinates follow from it"
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
        message = f"`{key.text}` is among the coordinates of this choice, and replaced as well"
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
