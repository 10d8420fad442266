"""What `lagsolve simulate` prints: the numbers it used, the state at both ends, events, and the drift."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator

from lagrange.core.printable import printable
from lagrange.document.math_writer import text
from lagrange.problem.model import Parameter
from lagrange.programs.limits import LARGEST_DRIFT
from lagrange.programs.simulation import Event, EventKind, Simulation
from lagrange.programs.tables import Units
from lagsolve.limits import ROUNDED_COMPONENT
from lagsolve.output import terminal_width, wrapped

DIGITS = 5


def report_text(simulation: Simulation, until: float, sampled: Collection[str] = (), *, by_default: bool) -> str:
    """The report, without an end of line; no line is wider than the terminal unless it has no blanks.

    sampled  the names of functions that are not given
    """
    width = terminal_width()
    return "\n".join(wrapped(printable(line), width, "    ") for line in _lines(simulation, until, sampled, by_default))


def _lines(simulation: Simulation, until: float, sampled: Collection[str], by_default: bool) -> Iterator[str]:
    states, start, units = simulation.equations, simulation.start, Units(simulation.equations)
    names = ", ".join(q.name for q in states.equations.slots.coordinates)
    where = f" (choice {states.name})" if states.name else ""
    yield states.problem.title
    yield f"0 to {until:g} s{' (by default; --until changes it)' if by_default else ''}, in {names}{where}"
    kept = states.equations.finite or states.equations.velocity_forms
    if kept:
        yield "constraints kept:"
        yield from (f"  {text(e)} = 0" for e in kept)
    rows = [(p.symbol.name, start.values[p.symbol], p.unit or units.of(p.symbol)) for p in _parameters(simulation)]
    yield from _table("Parameters", [(n, (x,), u, _mark(simulation, n)) for n, x, u in rows])
    if states.given:
        arguments = {f.name: f.arguments for f in states.problem.functions}
        yield ""
        yield "Functions"
        for name, e in states.given.items():
            mark = "    assumed; --set changes it" if name in sampled else ""
            yield f"  {name}({', '.join(arguments.get(name, ('t',)))}) = {text(e)}{mark}"
    final = simulation.states[:, -1].tolist() if len(simulation.times) else list(start.state)
    n = len(states.equations.slots.coordinates)
    sizes = [max(map(abs, part), default=0.0) for part in (start.state[:n], start.state[n:])]
    least = [ROUNDED_COMPONENT * min(1.0, sizes[k >= n]) for k in range(len(start.state))]
    last = simulation.times[-1] if len(simulation.times) else 0.0
    state: list[tuple[str, tuple[float, ...], str, str]] = [
        (s.name, (_or_zero(a, e), _or_zero(b, e)), units.of(s), _mark(simulation, s.name))
        for s, a, b, e in zip(states.state, start.state, final, least, strict=True)
    ]
    yield from _table(f"State at t = 0 and at t = {last:.5g} s", state)
    if start.pushed:
        yield ""
        yield "This state is an equilibrium: the motion was started slightly away from it."
    if start.orbits:
        yield ""
        yield "There is an attraction: the velocities assumed are those of a nearly circular orbit."
    if simulation.events:
        yield ""
        yield "Events"
        yield from (f"  {_event(e, simulation, units)}" for e in simulation.events)
    errors = dict(simulation.drift)
    if states.equations.kept:
        errors["constraints"] = simulation.violation
    if simulation.repeated is not None:
        errors["repeated with a larger tolerance"] = simulation.repeated
    yield ""
    yield f"Accuracy: relative change of what is constant; at most {LARGEST_DRIFT:g}"
    width = max(map(len, errors), default=0)
    for name, error in errors.items():
        yield f"  {name:{width}}  {error:.1e}{'' if error <= LARGEST_DRIFT else '   too large'}"


def _parameters(simulation: Simulation) -> list[Parameter]:
    """The parameters of the equations, and those in which the file gives the initial state."""
    states = simulation.equations
    stated = set().union(*(v.value.free_symbols for v in states.problem.initial))
    shown = {p.symbol for p in states.parameters} | stated
    declared = [p for p in states.problem.parameters if p.symbol in shown]
    return [*declared, *(p for p in states.parameters if p not in declared)]


def _mark(simulation: Simulation, name: str) -> str:
    return "assumed" if name in simulation.start.assumed else ""


def _table(title: str, rows: list[tuple[str, tuple[float, ...], str, str]]) -> Iterator[str]:
    if not rows:
        return
    yield ""
    yield title
    width = max(len(name) for name, *_ in rows)
    for name, numbers, unit, mark in rows:
        columns = "  ".join(f"{_number(x):>12}" for x in numbers)
        yield f"  {name:{width}}  {columns} {unit:8} {mark}".rstrip()


def _or_zero(x: float, least: float) -> float:
    return 0.0 if abs(x) < least else x


def _number(x: float) -> str:
    return f"{x:.{DIGITS}g}" if math.isfinite(x) else str(x)


def _event(event: Event, simulation: Simulation, units: Units) -> str:
    at = f"t = {event.time:.6g} s"
    match event.kind:
        case EventKind.ASKED:
            return f"{event.name}: " + ", ".join(dict.fromkeys([at, *_asked(event, simulation, units)]))
        case EventKind.CONTACT:
            return f"{at}: contact at {event.name} ends; the equations no longer hold"
        case EventKind.EXCHANGE:
            return f"{at}: mass no longer joins or leaves {event.name}; the equations no longer hold"
        case EventKind.EMPTY:
            return f"{at}: {event.name} has no mass left; the equations no longer hold"
        case EventKind.SLIP:
            return f"{at}: the slip that the file gives ends; the equations no longer hold"
        case EventKind.AT_REST if event.time == 0:
            return (
                f"{at}: of several slips in a plane one is zero at the start; what friction does there is not simulated"
            )
        case EventKind.AT_REST:
            return f"{at}: of several slips in a plane one ends; what friction does then is not simulated"
        case EventKind.REVERSED:
            sides = "as the constraint is an equation; `>=` or `<=` would let contact end here"
            return f"{at}: {event.name} changes its sign; the motion goes on, {sides}"
        case EventKind.HELD if event.time == 0:
            return f"{at}: nothing slips at the start, and friction holds it; the simulation ends"
        case EventKind.HELD:
            return f"{at}: slip ends, and friction keeps it from beginning again; the simulation ends"
        case EventKind.STOPPED:
            return f"{at}: the motion cannot be followed any further; {event.name}"


def _asked(event: Event, simulation: Simulation, units: Units) -> list[str]:
    """`theta = 0.841 rad`: the quantity of a question where its condition holds; nothing if it has no number."""
    if event.value is None:
        return []
    [quantity] = (q.quantity for q in simulation.equations.problem.questions if q.name == event.name)
    unit = units.of(quantity)
    return [f"{text(quantity)} = {event.value:.6g}{' ' + unit if unit else ''}"]
