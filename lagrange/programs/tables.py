"""A simulated motion as a table of CSV, and the units of SI of its columns.

A simulated motion as a table of CSV: time, state, reactions and energy, with their units in the header.

Units of SI for the numbers of a motion: m, rad/s, N m; empty if the units of the file do not determine one.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.symbols import base
from lagrange.core.units import BASE, NO_DIMENSION, Dimension, unit_called, unit_of
from lagrange.problem.model import ENERGY
from lagrange.problem.values import no_values, values_of
from lagrange.programs.simulation import Simulation
from lagrange.programs.state_equations import StateEquations
from lagrange.values.dimensions import Homogeneity, UnitExponents, dimension, exponents_of_product

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


# Units


class Units:
    """The units of the expressions of a motion."""

    def __init__(self, states: StateEquations) -> None:
        states = states.open  # where functions and prescribed motions have dimensions, and no samples with bare numbers
        problem, configuration = states.problem, states.configuration
        known: dict[sp.Symbol, Dimension] = dict((values_of(problem) or no_values(problem)).units)
        self._angles = {q.symbol for q in problem.coordinates if (u := unit_of(q.unit)) is not None and u.is_angle}
        self._known = known | dict.fromkeys(self._angles, NO_DIMENSION)
        idle = {name: force for name, (force, _, _) in states.idle.items()}
        self._columns = {**states.reactions, **idle, **states.conserved}
        self._energies = {e for name, e in states.conserved.items() if name.startswith(ENERGIES)}
        if states.energy is not None:
            self._columns["energy"] = states.energy
            self._energies.add(states.energy)
        self._homogeneity = Homogeneity(self._known)
        vectors = [p.position for p in configuration.points] + [a for r in configuration.rotations for a in r.axes]
        for e in (c for v in vectors for c in v.fixed().components):
            self._homogeneity.exponents(e)
        for choice in problem.choices:
            for q, e in (choice.substitute or {}).items():
                self._homogeneity.equal(q, e)
        for speed in problem.speeds:
            self._homogeneity.equal(speed.symbol, speed.definition)
        self._learn(states)
        places = {*states.equations.slots.coordinates, *(q for c in problem.choices for q in c.coordinates)}
        places |= {*problem.slots.coordinates}
        stated = {q.symbol for q in problem.coordinates if q.unit}
        symbols = {*places, *states.equations.slots.prescribed, *states.equations.speeds, *states.equations.multipliers}
        for s in sorted(map(base, symbols), key=str):
            unit = self._homogeneity.dimension(s)
            if unit is not None:
                self._known[s] = unit
        if any(self._homogeneity.dimension(e) == _ENERGY for e in self._energies):
            self._known[ENERGY] = _ENERGY
            self._energies.add(ENERGY)
        self._angles |= {q for q in places - stated if self._known.get(q) == NO_DIMENSION}
        self._angles |= {s.symbol for s in problem.speeds if self._known.get(s.symbol) == _RATE}

    def _learn(self, states: StateEquations) -> None:
        """M s' − Aᵀ λ = f and A s' = b, each row of one dimension, and what belongs to the motion beside them."""
        e, of = states.equations, self._homogeneity.exponents

        def times(coefficient: sp.Expr, unknown: sp.Symbol) -> UnitExponents | None:
            first, second = of(coefficient), of(unknown)
            return None if first is None or second is None else exponents_of_product((first, 1), (second, 1))

        for v, rate in zip(e.slots.velocities, e.rates, strict=True):
            self._homogeneity.equal(v, rate)
        for g in (*e.kept, *([] if states.energy is None else [states.energy]), *states.conserved.values()):
            of(g)
        for row, right in zip(e.matrix, e.right, strict=True):
            terms = [times(c, x) for c, x in zip(row, e.unknowns, strict=True) if c != 0]
            self._homogeneity.alike([*terms, *map(of, sp.Add.make_args(right))])
        for reaction in states.reactions.values():
            of(reaction)
        for _, multiplier, rate in states.idle.values() if self._known else ():
            power: UnitExponents = {unit: Fraction(int(n)) for unit, n in zip(BASE, _POWER, strict=True) if n}
            self._homogeneity.alike([times(rate, multiplier), power])

    def of(self, expression: sp.Expr) -> str:
        """The unit of an expression; none for a number, rad for an angle, J for an energy."""
        unit = self._homogeneity.dimension(expression) or dimension(expression, self._known)
        if unit is None:
            return ""
        if unit == _ENERGY and expression in self._energies:
            return "J"
        turns = bool(expression.is_Symbol) and base(expression) in self._angles
        return unit_called(unit, turns)

    def of_column(self, name: str, expression: sp.Expr) -> str:
        """That of a reaction or a conserved quantity, by its name."""
        return self.of(self._columns.get(name, expression))


ENERGIES = ("energy", "jacobi")
_RATE: Dimension = tuple(sp.Integer(-(unit == "s")) for unit in BASE)
_POWER: Dimension = tuple(sp.Integer({"kg": 1, "m": 2, "s": -3}.get(unit, 0)) for unit in BASE)
_ENERGY: Dimension = tuple(sp.Integer({"kg": 1, "m": 2, "s": -2}.get(unit, 0)) for unit in BASE)


def with_unit(name: str, unit: str) -> str:
    """A name with its unit: `theta (rad)`."""
    return f"{name} ({unit})" if unit else name
