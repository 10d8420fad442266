"""A simulated motion as a table of CSV: time, state, reactions and energy, with their units in the header."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from lagrange.core.diagnostics import NotCoveredError
from lagrange.programs.simulation import Simulation
from lagrange.programs.units import Units, with_unit

DIGITS = 12


def columns(simulation: Simulation) -> Iterator[tuple[str, str, Any]]:
    """Name, unit and values of all that is known along a motion: t, the state, reactions, conserved quantities."""
    units, states = Units(simulation.equations), simulation.equations
    yield "t", "s", simulation.times
    for k, symbol in enumerate(states.state):
        yield symbol.name, units.of(symbol), simulation.states[k]
    more = {**states.reactions, **({} if states.energy is None else {"energy": states.energy}), **states.conserved}
    for name, expression in more.items():
        try:
            values = simulation.system.along(expression, simulation.times, simulation.states)
        except NotCoveredError:
            continue
        yield name, units.of_column(name, expression), values


def csv_text(simulation: Simulation) -> str:
    """The table: a line for each time. Names are identifiers, so that nothing needs quotes."""
    names, rows = [], []
    for name, unit, values in columns(simulation):
        names.append(with_unit(name, unit))
        rows.append([f"{x:.{DIGITS}g}" for x in values.tolist()])
    return "\n".join(",".join(line) for line in (names, *zip(*rows, strict=True))) + "\n"
