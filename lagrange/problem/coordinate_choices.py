"""Reading the choices of generalized coordinates, and the quasi-velocities.

A choice lists its coordinates, old ones that it keeps and new ones, and gives the other old coordinates in terms of
them; without `substitute` it keeps some of the old ones and leaves the rest to the constraints. One substitution may
use another (x2 = x1 + ...): they are put into one another here, and may not go round in a circle.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from lagrange.algebra.fourier.vector_cleanup import tidied
from lagrange.core.diagnostics import Diagnostic, ProblemError, Span, UndecidedError
from lagrange.core.expression_size import Measures
from lagrange.core.symbols import Slots
from lagrange.expressions.bounded import MAX_LAYERS, MAX_SIZE
from lagrange.expressions.reader import Scope
from lagrange.problem.model import Choice, Speed
from lagrange.problem.names import canonical
from lagrange.problem.nodes import Node, Scalar
from lagrange.problem.reading import Reading, size
from lagrange.problem.reference_frame import coordinate
from lagrange.problem.sections import Section, entries_of, items_of, mapping_of, scalar_of
from lagrange.problem.symbols import RATE, SUBSTITUTION

_EXAMPLE = "{coordinates: [theta], substitute: {x: l*sin(theta)}}"


def read_speeds(node: Node | None, reading: Reading) -> tuple[Speed, ...]:
    """name -> quasi-velocity."""
    if node is None:
        return ()
    found: list[Speed] = []
    example = 'speeds: {u: "x\'*cos(theta)"}'
    for key, value in reading.findings.attempt(lambda: entries_of(node, "`speeds`", example)) or ():
        name = reading.names.declare(key, "a quasi-velocity")
        speed = reading.findings.attempt(lambda k=key, v=value: _speed(k, v, reading))  # type: ignore[misc]
        if name and speed is not None:
            found.append(Speed(sp.Symbol(name, real=True), speed, key.span))
    return tuple(found)


def _speed(key: Scalar, node: Node, reading: Reading) -> sp.Expr:
    what = f"the quasi-velocity `{key.text}`"
    value = reading.scalar(node, what, RATE)
    if value.free_symbols.isdisjoint(reading.scope.slots.velocities):
        help_ = "write it with the velocities, as `x'*cos(theta) + y'*sin(theta)`"
        raise ProblemError(Diagnostic("no-velocity", f"{what} has no velocity in it", node.span, help=help_))
    _check_linear(what, value, node, reading)
    short = tidied(value)
    return value if short.free_symbols.isdisjoint(reading.scope.slots.velocities) else short


def _check_linear(what: str, value: sp.Expr, node: Node, reading: Reading) -> None:
    """Refuses what is not linear in the velocities."""
    velocities = reading.scope.slots.velocities
    bent = [value.diff(v).diff(w) for n, v in enumerate(velocities) for w in velocities[n:]]
    verdicts = [e == 0 or reading.is_zero(e) for e in bent]
    if False in verdicts:
        message = f"{what} is not linear in the velocities"
        help_ = "write a sum of velocities, each times a function of the coordinates and of time"
        raise ProblemError(Diagnostic("speed-not-linear", message, node.span, help=help_))
    if None in verdicts:
        raise UndecidedError(f"whether {what} is linear in the velocities", node.span)


def read_choices(node: Node | None, reading: Reading) -> tuple[Choice, ...]:
    """name -> {coordinates, substitute}."""
    if node is None:
        return ()
    found = []
    example = f"generalized_coordinates: {{angle: {_EXAMPLE}}}"
    entries = reading.findings.attempt(lambda: entries_of(node, "`generalized_coordinates`", example))
    for key, value in entries or ():
        name = reading.choices.declare(key, "a choice")
        if name is not None:
            choice = reading.findings.attempt(lambda n=name, k=key, v=value: _choice(n, k, v, reading))  # type: ignore[misc]
            found += [choice] if choice is not None else []
    return tuple(found)


def _choice(name: str, key: Scalar, node: Node, reading: Reading) -> Choice:
    what = f"the choice `{name}`"
    mapping = mapping_of(node, what, f"{name}: {_EXAMPLE}")
    section = Section(mapping, what, ("coordinates", "substitute"), reading.findings)
    listed = section.required("coordinates", key.span, "[theta]")
    items = items_of(listed, f"`coordinates` of {what}", "coordinates: [theta]")
    if not items:
        message = f"{what} has no coordinates"
        raise ProblemError(Diagnostic("missing-key", message, listed.span, help="write `coordinates: [theta]`"))
    chosen = _chosen(items, what, reading)
    substitute = section.get("substitute")
    if substitute is None:
        if section.has("substitute"):  # without a value, and that has been said
            raise ProblemError(())
        _check_old(items, chosen, reading)
        return Choice(name, chosen, None, key.span)
    return Choice(name, chosen, _substitution(what, key.span, substitute, chosen, reading), key.span)


def _chosen(items: tuple[Node, ...], what: str, reading: Reading) -> tuple[sp.Symbol, ...]:
    """The coordinates of a choice: old ones, and new names."""
    chosen: list[sp.Symbol] = reading.findings.all_of(
        *(lambda i=i: _chosen_one(scalar_of(i, "a coordinate"), what, reading) for i in items)
    )
    for n, symbol in enumerate(chosen):
        if symbol in chosen[:n]:
            message = f"{what} has the coordinate `{symbol}` twice"
            raise ProblemError(Diagnostic("declared-twice", message, items[n].span, help="list it once"))
    return tuple(chosen)


def _chosen_one(scalar: Scalar, what: str, reading: Reading) -> sp.Symbol:
    old = {q.name: q for q in reading.scope.slots.coordinates}
    name = canonical(scalar.text, old)
    if name in old:
        return old[name]
    name = reading.names.symbol(scalar, "a coordinate") or ""
    if not name:
        raise ProblemError(())
    symbol = sp.Symbol(name, real=True)
    if reading.names.has_failed(name):
        raise ProblemError(())
    declared = reading.names.declared.get(name)
    if declared is not None and declared.what != _NEW:
        line, _ = declared.span.source.position(declared.span.start)
        message = f"`{name}` is {declared.what}, and cannot be a coordinate of {what}"
        label = f"declared on line {line}"
        raise ProblemError(Diagnostic("declared-twice", message, scalar.span, label, "choose another name"))
    if declared is None:
        reading.names.add(name, _NEW, scalar.span)
    return symbol


_NEW = "a generalized coordinate"


def _check_old(items: tuple[Node, ...], chosen: tuple[sp.Symbol, ...], reading: Reading) -> None:
    """Without a substitution, a choice keeps old coordinates and has no new ones."""
    old = reading.scope.slots.coordinates
    for item, symbol in zip(items, chosen, strict=True):
        if symbol not in old and old:
            message = f"`{symbol}` is new, and nothing says how the old coordinates follow from it"
            help_ = f"add `substitute: {{{old[0]}: ...}}`"
            raise ProblemError(Diagnostic("no-substitution", message, item.span, help=help_))


def _substitution(
    what: str, span: Span, node: Node, chosen: tuple[sp.Symbol, ...], reading: Reading
) -> Mapping[sp.Symbol, sp.Expr]:
    """old coordinate -> expression of the chosen ones and t."""
    old = reading.scope.slots.coordinates
    entries = entries_of(node, f"`substitute` of {what}", "substitute: {x: l*sin(theta)}")
    slots = Slots(tuple(dict.fromkeys((*old, *chosen))), reading.scope.slots.prescribed)
    scope = replace(reading.scope, scalars={**reading.scope.scalars, **{s.name: s for s in chosen}}, slots=slots)
    pairs = reading.findings.all_of(*(lambda k=k, v=v: _substituted(k, v, chosen, scope, reading) for k, v in entries))
    given: dict[sp.Symbol, sp.Expr] = {}
    for (key, _), (symbol, value) in zip(entries, pairs, strict=True):
        if symbol in given:  # once as `θ`, once as `theta`
            message = f"`{symbol}` is replaced twice"
            raise ProblemError(Diagnostic("declared-twice", message, key.span, help="keep one of the two"))
        given[symbol] = value
    _check_complete(given, chosen, what, span, reading)
    return _chained(given, what, span)


def _substituted(
    key: Scalar, node: Node, chosen: tuple[sp.Symbol, ...], scope: Scope, reading: Reading
) -> tuple[sp.Symbol, sp.Expr]:
    names = {s.name for s in chosen}
    if canonical(key.text, names) in names:
        message = f"`{key.text}` is among the coordinates of this choice, and replaced as well"
        help_ = "remove it here, or from its `coordinates`"
        raise ProblemError(Diagnostic("kept-and-replaced", message, key.span, help=help_))
    symbol = coordinate(key, reading)
    if symbol in reading.scope.slots.prescribed:
        message = f"`{symbol}` is a prescribed motion and cannot be replaced"
        raise ProblemError(Diagnostic("unknown-coordinate", message, key.span, help="replace coordinates only"))
    return symbol, reading.scalar(node, f"the substitution for `{symbol}`", SUBSTITUTION, scope)


def _check_complete(
    given: Mapping[sp.Symbol, sp.Expr], chosen: tuple[sp.Symbol, ...], what: str, span: Span, reading: Reading
) -> None:
    missing = [q for q in reading.scope.slots.coordinates if q not in given and q not in chosen]
    if missing:
        listed = ", ".join(f"`{q}`" for q in missing)
        message = f"{what} does not say what becomes of {listed}"
        help_ = "give it in `substitute`, or list it among the `coordinates` if the choice keeps it"
        raise ProblemError(Diagnostic("coordinate-left-out", message, span, help=help_))


def _chained(given: Mapping[sp.Symbol, sp.Expr], what: str, span: Span) -> Mapping[sp.Symbol, sp.Expr]:
    """The substitutions with no replaced coordinate left on their right sides."""
    resolved: dict[sp.Symbol, sp.Expr] = {}
    waiting = dict(given)
    while waiting:
        ready = [q for q, e in waiting.items() if e.free_symbols.isdisjoint(waiting)]
        if not ready:
            raise ProblemError(_circle(waiting, what, span))
        for q in ready:
            resolved[q] = _put_in(waiting.pop(q), resolved, what, span)
    return {q: resolved[q] for q in given}


def _circle(waiting: Mapping[sp.Symbol, sp.Expr], what: str, span: Span) -> Diagnostic:
    circle = dict(waiting)
    while outside := [q for q in circle if all(q not in e.free_symbols for e in circle.values())]:
        for q in outside:
            del circle[q]
    listed = ", ".join(f"`{q}`" for q in circle)
    message = f"in {what}, the substitution for {listed} goes round in a circle"
    help_ = "write each old coordinate with the chosen ones"
    return Diagnostic("circular-substitution", message, span, help=help_)


def _put_in(value: sp.Expr, resolved: Mapping[sp.Symbol, sp.Expr], what: str, span: Span) -> sp.Expr:
    largest = max((size(resolved[q]) for q in value.free_symbols & resolved.keys()), default=1)
    found = value.xreplace(dict(resolved)) if size(value) * largest <= 10 * MAX_SIZE else None
    if found is None or size(found) > MAX_SIZE or Measures().of(found).layers > MAX_LAYERS:
        message = f"in {what}, the substitutions put into one another are too large"
        help_ = "write each old coordinate with the chosen ones"
        raise ProblemError(Diagnostic("expression-too-large", message, span, help=help_))
    return found
