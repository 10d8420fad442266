"""Plots of a simulated motion, by Matplotlib: coordinates and reactions over time, and the phase plane.

What is written on a plot is made of symbols, by the program's own writer of formulas; a title of a file is set as plain
text, in which `$` means nothing.
"""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from typing import Any

import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.printable import one_line
from lagrange.core.symbols import prime
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import latex
from lagrange.programs.limits import MOST_PLANES
from lagrange.programs.numerical_system import NumericalSystem
from lagrange.programs.simulation import Simulation
from lagrange.programs.tables import Units

FORMATS = {".svg": "svg", ".png": "png", ".pdf": "pdf"}
_COLOURS = ("#1f5aa6", "#c8461e", "#2f7d4f", "#7a4fa3", "#8a6d1a", "#3a8fa0", "#a83a6a", "#555555")


def labelled(symbol: sp.Symbol, unit: str) -> str:
    """A symbol as a formula, with its unit."""
    return f"${latex(symbol)}$" + (f" ({unit.replace('^-1', '⁻¹').replace('^2', '²')})" if unit else "")


def overview(simulation: Simulation) -> Any:
    """A figure with the coordinates and the reactions over time, and phase planes."""
    from matplotlib.figure import Figure

    groups = _groups(simulation)
    planes = _planes(simulation)
    rows = len(groups) + bool(planes)
    figure = Figure(figsize=(7.5, 2.3 * rows + 0.5), layout="constrained")
    grid = figure.add_gridspec(max(rows, 1), max(1, len(planes)))
    for row, (unit, members) in enumerate(groups):
        axes = figure.add_subplot(grid[row, :])
        for (label, values), colour in zip(members, _COLOURS * (1 + len(members) // len(_COLOURS)), strict=False):
            axes.plot(simulation.times, values, color=colour, linewidth=1.1, label=label)
        axes.set_ylabel(unit.replace("^2", "²").replace("^-1", "⁻¹"), parse_math=False)
        axes.legend(loc="best", fontsize="small", framealpha=0.8, edgecolor="none")
        _tidy(axes, simulation)
        if row == len(groups) - 1:
            axes.set_xlabel("t (s)")
    for column, one in enumerate(planes):
        _draw_plane(figure.add_subplot(grid[rows - 1, column]), one, _COLOURS[column % len(_COLOURS)])
    figure.suptitle(one_line(simulation.equations.problem.title)[:90], fontsize="medium", parse_math=False)
    return figure


def _groups(simulation: Simulation) -> list[tuple[str, list[tuple[str, Any]]]]:
    """What is plotted over time, by units: coordinates first, then reactions."""
    units, states = Units(simulation.equations), simulation.equations
    groups: dict[tuple[int, str], list[tuple[str, Any]]] = {}
    for k, q in enumerate(states.equations.slots.coordinates):
        groups.setdefault((0, units.of(q)), []).append((f"${latex(q)}$", simulation.states[k]))
    for name, e in states.reactions.items():
        try:
            values = simulation.system.along(e, simulation.times, simulation.states)
        except NotCoveredError:
            continue
        groups.setdefault((1, units.of_column(name, e)), []).append((f"${latex(sp.Symbol(name, real=True))}$", values))
    return [(unit, members) for (_, unit), members in sorted(groups.items(), key=lambda item: item[0][0])]


def _planes(simulation: Simulation) -> list[tuple[Any, Any, str, str]]:
    """The phase planes of the first coordinates."""
    return [plane(simulation, q) for q in simulation.equations.equations.slots.coordinates[:MOST_PLANES]]


def plane(simulation: Simulation, q: sp.Symbol) -> tuple[Any, Any, str, str]:
    """q and q' along the motion, with their labels."""
    units = Units(simulation.equations)
    y = simulation.along(prime(q))
    return simulation.along(q), y, labelled(q, units.of(q)), labelled(prime(q), units.of(prime(q)))


def phase_plane(simulation: Simulation, q: sp.Symbol) -> Any:
    """A figure with the phase plane of one coordinate; the start is marked."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5, 4), layout="constrained")
    axes = figure.add_subplot()
    _draw_plane(axes, plane(simulation, q), _COLOURS[0])
    return figure


def _draw_plane(axes: Any, drawn: tuple[Any, Any, str, str], colour: str) -> None:
    x, y, across, up = drawn
    axes.plot(x, y, color=colour, linewidth=0.9)
    axes.plot(x[:1], y[:1], "o", color="black", markersize=3)
    axes.set_xlabel(across)
    axes.set_ylabel(up)
    axes.grid(alpha=0.25)


def _tidy(axes: Any, simulation: Simulation) -> None:
    axes.grid(alpha=0.25)
    axes.margins(x=0)
    for event in simulation.events:
        axes.axvline(event.time, color="grey", linewidth=0.8, linestyle=":")


def plot_file(simulation: Simulation, ending: str) -> bytes:
    """The overview as a file, by its ending: .svg, .png or .pdf."""
    import matplotlib

    out = io.BytesIO()
    form = FORMATS[ending]
    metadata = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "png": {}}[form]
    with matplotlib.rc_context({"svg.hashsalt": "lagsolve", "svg.fonttype": "path", "mathtext.fontset": "cm"}):
        overview(simulation).savefig(out, format=form, dpi=150, metadata=metadata)
    return out.getvalue()


# -- the moving system -------------------------------------------------------------------------------------------------


class Stage:
    """The places of points along a motion, projected onto the page: i to the right, and gravity down."""

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation
        self._system: NumericalSystem = simulation.system
        self._configuration = simulation.equations.configuration
        across, up = _axes(simulation)
        self._axes = across, up
        self.points = {p.name: self._place(p.position) for p in self._configuration.points}

    def _place(self, vector: Vector) -> tuple[Any, Any]:
        """The two components of a vector on the page, arrays."""
        x = vector.fixed().components
        made = [sp.Add(*(a * c for a, c in zip(axis, x, strict=True))) for axis in self._axes]
        return self._simulation.along(made[0]), self._simulation.along(made[1])

    def lines(self, law: Any) -> list[tuple[tuple[Any, Any], tuple[Any, Any], str]]:
        """Rods and strings, springs and dampers, each from end to end."""
        lines = []
        for r in law.newton.reactions if law is not None else ():
            if r.rod is not None:
                first, second = r.rod.ends
                end = self.points.get(second) if second else None
                if end is None and r.rod.centre is not None:
                    end = self._place(r.rod.centre)
                if end is not None and first in self.points:
                    lines.append((self.points[first], end, "-"))
        for link in self._configuration.links:
            ends = [self.points.get(e) if isinstance(e, str) else self._place(e) for e in link.ends]
            if ends[0] is not None and ends[1] is not None:
                lines.append((ends[0], ends[1], "--"))
        return lines


def _axes(simulation: Simulation) -> tuple[Sequence[sp.Expr], Sequence[sp.Expr]]:
    """The directions of the page in i, j, k: right, and against gravity."""
    problem = simulation.equations.problem
    right, up = (1, 0, 0), (0, 1, 0)
    if problem.gravity is not None:
        g = problem.gravity.fixed().components
        sizes = [
            float(sp.N(c.xreplace({s: sp.Float(v) for s, v in simulation.start.values.items()})))
            if not (c.free_symbols - simulation.start.values.keys())
            else 0.0
            for c in g
        ]
        along = max(range(3), key=lambda k: abs(sizes[k]))
        if sizes[along] != 0:
            sign = -1 if sizes[along] > 0 else 1
            up = tuple(sign * (k == along) for k in range(3))  # type: ignore[assignment]
            right = (0, 1, 0) if along == 0 else (1, 0, 0)
    return [sp.Integer(k) for k in right], [sp.Integer(k) for k in up]


def animated(simulation: Simulation, law: Any, frames: int = 200) -> Any:
    """An animation of the points, rods and springs, with traces, for notebooks: a `FuncAnimation`."""
    from matplotlib.animation import FuncAnimation
    from matplotlib.figure import Figure

    stage = Stage(simulation)
    lines = stage.lines(law)
    figure = Figure(figsize=(5, 5))
    axes = figure.add_subplot()
    axes.set_aspect("equal")
    every = [*stage.points.values()] + [end for a, b, _ in lines for end in (a, b)]
    if every:
        for set_limits, k in ((axes.set_xlim, 0), (axes.set_ylim, 1)):
            low, high = min(float(p[k].min()) for p in every), max(float(p[k].max()) for p in every)
            room = 0.1 * (high - low) + 0.1 * (math.hypot(high, low) or 1)
            set_limits(low - room, high + room)
    drawn_lines = [axes.plot([], [], style, color="black", linewidth=1.5)[0] for _, _, style in lines]
    traces = [
        axes.plot([], [], color=c, linewidth=0.7, alpha=0.5)[0]
        for _, c in zip(stage.points, _COLOURS * 9, strict=False)
    ]
    dots = [axes.plot([], [], "o", color=c)[0] for _, c in zip(stage.points, _COLOURS * 9, strict=False)]
    clock = axes.text(0.02, 0.96, "", transform=axes.transAxes)
    step = max(1, len(simulation.times) // frames)

    def show(frame: int) -> list[Any]:
        k = frame * step
        for artist, (a, b, _) in zip(drawn_lines, lines, strict=True):
            artist.set_data([a[0][k], b[0][k]], [a[1][k], b[1][k]])
        for trace, dot, p in zip(traces, dots, stage.points.values(), strict=True):
            trace.set_data(p[0][: k + 1], p[1][: k + 1])
            dot.set_data([p[0][k]], [p[1][k]])
        clock.set_text(f"t = {simulation.times[k]:.2f} s")
        return [*drawn_lines, *traces, *dots, clock]

    class Shown(FuncAnimation):
        """An animation that a notebook shows by itself, with buttons."""

        def _repr_html_(self) -> str:
            html: str = self.to_jshtml()
            return html

    return Shown(figure, show, frames=len(range(0, len(simulation.times), step)), interval=40.0, blit=False)
