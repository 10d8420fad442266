"""A simulated motion, for Python programs and notebooks: arrays, plots, an animation.

motion = result.simulate(20, initial={"theta": 0.5})
motion.t, motion["theta"], motion["theta'"], motion["T_rod"], motion.energy
motion.plot(), motion.phase_portrait("theta"), motion.animate()
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, SupportsFloat

import sympy as sp

from lagrange.core.diagnostics import Fragment, NotCoveredError, suggestion
from lagrange.core.records import record
from lagrange.core.symbols import t
from lagrange.mechanics.results import Solution
from lagrange.problem.model import InitialValue
from lagrange.programs.prepared import longest_time, require, require_functions
from lagrange.programs.simulation import Event, Simulation, meant, simulated
from lagrange.programs.starting import start
from lagrange.programs.state_equations import state_equations


@record
class SimulatedMotion:
    """A motion in numbers, at N times.

    A string is the name of a coordinate, velocity, reaction or conserved quantity; an expression may contain
    coordinates, velocities, accelerations, named reactions, t and parameters. Both give an array of shape (N,).
    """

    simulation: Simulation
    solution: Solution

    @property
    def t(self) -> Any:
        """The times, shape (N,)."""
        return self.simulation.times

    @property
    def y(self) -> Any:
        """The states, shape (n + p, N); `names` are those of its rows."""
        return self.simulation.states

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the components of the state."""
        return self.simulation.names

    @property
    def energy(self) -> Any:
        """T + V, shape (N,); None if there is no potential."""
        e = self.simulation.equations.energy
        return None if e is None else self[e]

    @property
    def events(self) -> tuple[Event, ...]:
        """What happened: `kind`, `name`, `time`, `state`, `value`."""
        return self.simulation.events

    @property
    def drift(self) -> Mapping[str, float]:
        """The drift of each conserved quantity, relative to its terms."""
        return self.simulation.drift

    @property
    def violation(self) -> float:
        """The largest error in the constraints, relative to their terms."""
        return self.simulation.violation

    @property
    def assumed(self) -> Mapping[str, float]:
        """The numbers that are not given."""
        return self.simulation.start.assumed

    @property
    def holds(self) -> bool:
        """Whether the motion was followed to its end, and what should stay constant did."""
        return self.simulation.is_accurate

    def __getitem__(self, quantity: str | sp.Expr) -> Any:
        """The values of a quantity along the motion, shape (N,). Raises KeyError if it is not known."""
        states = self.simulation.equations
        if isinstance(quantity, str):
            known = {**states.conserved, **states.reactions}
            e = known.get(quantity, sp.Symbol(quantity, real=True))
        else:
            e = quantity
        try:
            return self.simulation.along(self._meant(e))
        except NotCoveredError:
            names = [*self.names, *states.reactions, *states.conserved]
            raise KeyError(f"`{quantity}` is not known along this motion; {suggestion(str(quantity), names)}") from None

    def function(self, expression: sp.Expr) -> Callable[[Any, Any], Any]:
        """An expression as a function of t and y that broadcasts: for y of shape (n + p, N), an array of shape (N,)."""
        import numpy

        e = meant(self.simulation.equations, self._meant(expression))
        system = self.simulation.system

        def value(time: Any, y: Any) -> Any:
            states = numpy.asarray(y, dtype=float)
            shape = states.shape[1:]
            flat = states.reshape(len(states), -1)
            times = numpy.broadcast_to(numpy.asarray(time, dtype=float), shape).reshape(-1)
            values = system.along(e, times, flat).reshape(shape)
            return values if shape else float(values)

        return value

    def _meant(self, e: sp.Expr) -> sp.Expr:
        """An expression with the symbols of the problem: symbols are known by their names."""
        e = _expression(e)
        declared = {s.name: s for s in (t, *self.simulation.start.values)}
        rule = {
            s: declared.get(s.name, sp.Symbol(s.name, real=True)) for s in e.free_symbols if isinstance(s, sp.Symbol)
        }
        return e.xreplace(rule)

    def plot(self) -> Any:
        """Coordinates and reactions over time, and phase planes: a figure of Matplotlib."""
        require("matplotlib")
        from lagrange.programs.plots import overview

        return overview(self.simulation)

    def phase_portrait(self, coordinate: str = "") -> Any:
        """q and q' of a coordinate, by default the first: a figure of Matplotlib. Raises KeyError."""
        require("matplotlib")
        from lagrange.programs.plots import phase_plane

        coordinates = {q.name: q for q in self.simulation.equations.equations.slots.coordinates}
        name = coordinate or next(iter(coordinates))
        if name not in coordinates:
            raise KeyError(f"there is no coordinate `{name}`; {suggestion(name, [*coordinates], 'coordinates')}")
        return phase_plane(self.simulation, coordinates[name])

    def animate(self, frames: int = 200) -> Any:
        """The points, rods and springs in motion: a `FuncAnimation`, which notebooks display automatically."""
        require("matplotlib")
        from lagrange.programs.plots import animated

        return animated(self.simulation, self.solution.law, frames)

    def __repr__(self) -> str:
        shown = ", ".join(self.names)
        return f"<Motion of ({shown}) for {len(self.t)} times from 0 to {float(self.t[-1]) if len(self.t) else 0:g}>"


def simulated_motion(
    solution: Solution,
    until: float | None,
    choice: str | None,
    values: Mapping[str, SupportsFloat],
    initial: Mapping[str, SupportsFloat],
    functions: Mapping[str, sp.Expr],
    samples: int | None,
) -> SimulatedMotion:
    """The motion of a solved problem. Raises ValueError at a name that does not exist, ProblemError as the command."""
    require("numpy", "scipy")
    problem = solution.problem
    states = state_equations(solution, choice).with_functions({n: _expression(e) for n, e in functions.items()})
    require_functions(states, functions, "`functions={{'{name}': ...}}`, in SymPy")
    numbers = {**values, **initial, **({} if until is None else {"until": until})}
    for name, number in numbers.items():
        if not math.isfinite(float(number)) or (name == "until" and not float(number) > 0):
            raise ValueError(
                f"`{name}` is {float(number):g}, and not a {'positive' if name == 'until' else 'finite'} number"
            )
    known = [*dict.fromkeys(p.symbol.name for p in (*problem.parameters, *states.parameters))]
    coordinates = [q.symbol for q in problem.coordinates] + [q for c in problem.choices for q in c.coordinates]
    moving = {n for q in coordinates for n in (q.name, f"{q.name}'")} | {s.name for s in states.state}
    for names, allowed, what in (
        (values, known, "parameters"),
        (initial, sorted(moving), "coordinates and velocities"),
    ):
        for name in map(str, names):
            if name not in allowed:
                raise ValueError(f"there is no `{name}`; {suggestion(name, list(allowed), what)}")
    at_start = [_initial(str(n), float(v)) for n, v in initial.items()]
    begun = start(states, solution, at_start, {str(n): float(v) for n, v in values.items()})
    end = longest_time(states, begun) if until is None else float(until)
    made = simulated(states, begun, end, questions=problem.questions, samples=samples)
    return SimulatedMotion(made, solution)


def _expression(e: object) -> sp.Expr:
    if not isinstance(e, sp.Expr | SupportsFloat) or isinstance(e, bool):
        raise TypeError(f"this must be an expression of SymPy or a number, and not {type(e).__name__}")
    made: sp.Expr = sp.sympify(e, strict=True)
    return made


def _initial(name: str, value: float) -> InitialValue:
    span = Fragment.of(f"{name}={value:g}", "initial").whole
    return InitialValue(sp.Symbol(name, real=True), sp.Float(value, 17), span)
