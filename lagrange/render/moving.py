"""The moving figure of a web page: its controls, its numbers, and its script.

The script is the same on every page (`moving.js`), followed by the functions of each figure, which the program has
written itself. The texts of a file are in labels only, each escaped; the data of a figure are numbers. The page allows
nothing but these very scripts and this very style sheet: its content security policy names their hashes, so that no
other code runs even if some were smuggled in, and nothing is fetched from anywhere.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator, Sequence
from functools import cache
from importlib.resources import files

import sympy as sp

from lagrange.animation.figure import MovingFigure, Slider
from lagrange.core.printable import printable
from lagrange.core.symbols import prime
from lagrange.document.math_writer import UNICODE, Writer
from lagrange.document.names import Notation
from lagrange.render.escape import html_text as escape
from lagrange.render.limits import STEPS_OF_A_SLIDER
from lagrange.render.mathml import Formulas
from lagrange.render.svg import content_of

INTEGRALS = {
    "energy": "energy",
    "jacobi": "Jacobi’s integral",
    "momentum": "momentum",
    "angular-momentum": "angular momentum",
}


@cache
def resource(name: str) -> str:
    """The script or style sheet of this folder."""
    return files("lagrange.render").joinpath(name).read_text(encoding="utf-8").strip()


def call(place: int, figure: MovingFigure) -> str:
    """The script of one figure."""
    return f"\nlagsolveFigure({place}, {figure.code});\n"


def moving_lines(figure: MovingFigure, place: int, notation: Notation, alt: str) -> Iterator[str]:
    """The lines of the figure's element."""
    return _Controls(figure, place, notation, alt).all()


class _Controls:
    """One figure with its controls."""

    def __init__(self, figure: MovingFigure, place: int, notation: Notation, alt: str) -> None:
        self.figure, self.place, self.alt = figure, place, escape(printable(alt))
        self.formulas = Formulas.of(notation)
        self.plain = Writer(UNICODE, notation).plain

    def all(self) -> Iterator[str]:
        figure = self.figure
        does = "Drag the sliders, or press Play." if figure.moves else "Drag the sliders."
        yield f'<figure class="moving" data-moving="{self.place}" hidden>'
        empty = "" if figure.data["items"] else " empty"  # a Lagrangian without positions
        yield f'<svg class="picture stage{empty}" role="img" tabindex="0" aria-label="{self.alt} {does}">'
        yield '<g class="lines"></g><g class="labels">'
        yield from (f"<text>{content_of(label, self.plain)}</text>" for label in figure.labels)
        yield '</g><g class="tags"></g></svg>'
        yield '<div class="controls">'
        if figure.moves:
            yield from self.transport()
        yield from self.shows()
        yield "</div>"
        if figure.equilibria or figure.data["rest"]:
            yield from self.equilibria()
        yield '<p class="message" role="status" data-out="message"></p>'
        yield '<div class="panels">'
        yield from self.sliders("Position", figure.coordinates, "q")
        yield from self.sliders("Parameters", figure.parameters, "p")
        yield from self.readings()
        yield "</div>"
        yield from self.graphs()
        yield f"<figcaption>{self.caption()}</figcaption>"
        yield f'<script type="application/json">{self.data()}</script>'
        yield "</figure>"

    def data(self) -> str:
        """The numbers of the figure and the names of coordinates, with nothing in them that could end the element."""
        names = [s.label if isinstance(s.label, str) else self.plain(s.label) for s in self.figure.coordinates]
        text = json.dumps(
            {**self.figure.data, "names": list(map(printable, names))}, separators=(",", ":"), allow_nan=False
        )
        return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")

    def math(self, e: sp.Expr | str) -> str:
        return escape(e) if isinstance(e, str) else self.formulas.equation((e,), "=")

    def transport(self) -> Iterator[str]:
        yield '<button type="button" class="play" aria-label="Play">▶ Play</button>'
        yield '<button type="button" class="step">Step</button>'
        yield '<button type="button" class="reset">Reset</button>'
        speeds = (("0.1", "1/10"), ("0.25", "1/4"), ("1", "1"), ("4", "4"))
        options = "".join(f'<option value="{v}"{" selected" * (v == "1")}>{t} ×</option>' for v, t in speeds)
        yield f'<label>speed <select class="speed">{options}</select></label>'
        yield '<label class="wide">time <input class="time" type="range" min="0" max="1" step="1" value="0"></label>'

    def shows(self) -> Iterator[str]:
        figure = self.figure
        if not figure.data["items"]:
            return
        boxes = [("forces", "forces to scale", True)] if figure.data["loads"] or figure.data["bound"] else []
        boxes += [("trace", "trace", True)] if figure.moves else []
        boxes.append(("virtual", "virtual displacement δr", False))
        boxes += [("possible", "possible displacement dr", False)] if figure.data["rheonomic"] else []
        for name, words, checked in boxes:
            yield f'<label><input type="checkbox" data-show="{name}"{" checked" * checked}> {words}</label>'
        if len(figure.coordinates) > 1:
            names = (f"δ{self.plain_name(s)}" for s in figure.coordinates)
            options = "".join(f'<option value="{k}">{name}</option>' for k, name in enumerate(names))
            yield f'<label>by <select class="which" aria-label="displacement by">{options}</select></label>'

    def plain_name(self, slider: Slider) -> str:
        return escape(slider.label if isinstance(slider.label, str) else self.plain(slider.label))

    def equilibria(self) -> Iterator[str]:
        yield '<div class="controls rest"><span>At rest:</span>'
        for k, e in enumerate(self.figure.equilibria):
            written = ", ".join(self.formulas.equation(pair, "=") for pair in e.relations)
            how = f" <small>{escape(e.stability)}</small>" if e.stability in ("stable", "unstable") else ""
            plain = ", ".join(f"{self.plain(left)} = {self.plain(right)}" for left, right in e.relations)
            called = escape(f"At rest at {plain}")
            yield f'<button type="button" data-rest="{k}" aria-label="{called}">{written}{how}</button>'
        if self.figure.data["rest"]:
            never = f' data-never="{escape(self.never())}"' if self.figure.needed else ""
            yield f'<span class="found"{never}></span>'
        if self.figure.moves:
            yield '<button type="button" class="push">Push</button>'
        yield "</div>"

    def never(self) -> str:
        """`nowhere while τ ≠ 0`: what keeps the system from being at rest in any position."""
        factors = [[f for f in sp.Mul.make_args(e) if not f.is_nonzero and f.free_symbols] for e in self.figure.needed]
        if not all(factors):
            return "nowhere"
        which = dict.fromkeys(self.plain(sp.Mul(*f)) for f in factors)
        return "nowhere while " + " or ".join(f"{w} ≠ 0" for w in which)

    def sliders(self, title: str, sliders: Sequence[Slider], kind: str) -> Iterator[str]:
        if sliders:
            yield f'<fieldset class="knobs"><legend>{title}</legend>'
            yield from (self.slider(k, s, kind) for k, s in enumerate(sliders))
            yield "</fieldset>"

    def slider(self, number: int, s: Slider, kind: str) -> str:
        step = s.step or _round((s.high - s.low) / STEPS_OF_A_SLIDER)
        low, high = math.floor(s.low / step + 1e-9) * step, math.ceil(s.high / step - 1e-9) * step
        if kind == "p" and s.low > 0 and low <= 0:
            low = step
        meaning = escape(s.meaning)
        name = f"{meaning} {self.math(s.label)}" if s.meaning.endswith(" of") else self.math(s.label)
        title = f' title="{meaning}"' if meaning else ""
        called = f"{self.plain_name(s)}: {meaning}" if meaning else self.plain_name(s)
        unit = f" {_unit(s.unit)}" if s.unit and s.unit != "1" else ""
        ends = f'min="{low:.6g}" max="{high:.6g}" step="{step:.6g}" value="{s.value:.6g}"'
        return (
            f'<label{title}><span>{name}</span><input type="range" data-{kind}="{number}" {ends} aria-label="{called}">'
            f'<span class="value"><output data-{kind}="{number}"></output>{unit}</span></label>'
        )

    def readings(self) -> Iterator[str]:
        """Names, outputs and units of what is shown beside the figure."""
        figure = self.figure
        rows: list[tuple[str, str, str]] = []
        joule, newton = (" J", " N") if figure.data["newton"] else ("", "")
        if figure.moves:
            kept = any(kind == "energy" for kind, _ in figure.conserved)
            rows.append(("time", _out("t"), " s"))
            for k, s in enumerate(figure.coordinates):
                if isinstance(s.label, sp.Symbol):
                    rate = f" {_unit(s.unit)}/s" if s.unit in ("m", "rad") else ""
                    rows.append((self.math(prime(s.label)), f'<output data-u="{k}"></output>', rate))
            if figure.divided:
                rows += [("kinetic energy", _out("T"), joule), ("potential energy", _out("V"), joule)]
                rows.append(("their sum (conserved)" if kept else "their sum", _out("E"), joule))
        elif figure.rests:
            rows += [(f"force along {self.math(s.label)}", _out(f"Q{k}"), "") for k, s in enumerate(figure.coordinates)]
        for k, (kind, _) in enumerate(figure.conserved):
            if kind != "energy" or not figure.divided:
                rows.append((f"conserved: {INTEGRALS.get(kind, escape(kind))}", _out(f"I{k}"), ""))
        for k, r in enumerate(figure.reactions):
            rows.append((self.math(r), _out(f"R{k}"), "" if str(r).startswith("lambda") else newton))
        if 1 in figure.data["conserved"]:
            kinds = [kind for kind, _ in figure.conserved]
            name = "the energy" if "energy" in kinds else INTEGRALS["jacobi"]
            rows.append((f"relative error of {name}", _out("drift"), ""))
        if figure.data["shape"]["con"][1]:
            rows.append(("error of the constraints", _out("error"), ""))
        yield '<dl class="readings">'
        yield from (f"<div><dt>{name}</dt><dd>{output}{unit}</dd></div>" for name, output, unit in rows)
        yield "</dl>"

    def graphs(self) -> Iterator[str]:
        figure = self.figure
        yield '<div class="graphs">'
        if figure.moves:
            yield self.canvas("coordinates", "Coordinates over time (s)", "".join(map(self.plotted, range(self.size))))
            if figure.reactions:
                names = (f'<span class="c{k % 5}">{self.math(r)}</span>' for k, r in enumerate(figure.reactions))
                yield self.canvas("reactions", "Reactions over time (s)", "".join(names))
        if figure.moves or (figure.rests and not figure.data["shape"]["con"][1]):
            names = (self.plain_name(s) for s in figure.coordinates)
            options = "".join(f'<option value="{k}">{name}</option>' for k, name in enumerate(names))
            choice = (
                f'<label>of <select class="phase" aria-label="coordinate of the graph">{options}</select></label>'
                if self.size > 1
                else ""
            )
            title = (
                "Phase plane: rate over coordinate" if figure.moves else "Work against the forces along the coordinate"
            )
            yield self.canvas("phase", title, choice)
        yield "</div>"

    @property
    def size(self) -> int:
        return len(self.figure.coordinates)

    def plotted(self, k: int) -> str:
        """The box that puts a coordinate into the graph."""
        slider = self.figure.coordinates[k]
        called = f'aria-label="show {self.plain_name(slider)}"'
        box = f'<input type="checkbox" data-plot="{k}" {called}{" checked" * self.is_plotted(k)}>'
        return f'<label class="c{k % 5}">{box} {self.math(slider.label)}</label>'

    def is_plotted(self, k: int) -> bool:
        angles = [s.angle for s in self.figure.coordinates]
        return angles[k] == angles[0] and k < 5

    def canvas(self, name: str, title: str, beside: str) -> str:
        head = f'<div class="head"><b>{title}</b>{beside}</div>'
        return f'<div class="graph">{head}<canvas class="{name}" role="img" aria-label="{title}"></canvas></div>'

    def caption(self) -> str:
        figure = self.figure
        driven = dict.fromkeys(figure.driven)
        chosen = [s for s in figure.parameters if not s.given and s.label not in driven]
        start = figure.moves and not figure.released
        parts = []
        if chosen and len(chosen) == len(figure.parameters):
            more = " and the initial state" * start
            parts.append(f"The file gives no values: those of the sliders{more} were chosen for this page.")
        else:
            names = list(dict.fromkeys(self.math(s.label) for s in chosen)) + ["the initial state"] * start
            if names:
                parts.append(f"Not given in the file, and chosen for this page: {', '.join(names)}.")
        for u in map(self.math, driven):
            parts.append(
                f"The file does not say how {u} moves: here it oscillates about a mean, "
                f"{u} = mean + amplitude · sin(frequency · time), with the numbers of the sliders."
            )
        if figure.pushed:
            parts.append("It would stay at rest in this position, so it begins slightly away from it.")
        if figure.orbits:
            parts.append("There is an attraction: it begins with somewhat less than the velocity of a circular orbit.")
        if figure.data["motion"]:
            until = figure.data["motion"][-1][-1]
            parts.append(
                f"Play goes through the motion computed by <code>lagsolve simulate</code>, up to {until:g} s, "
                "and continues it."
            )
        for left, right in figure.assumed:
            parts.append(f"The file leaves {self.math(left)} open; the figure takes {self.math(right)}.")
        return " ".join(parts)


def _out(name: str) -> str:
    return f'<output data-out="{name}"></output>'


def _round(number: float) -> float:
    """1, 2 or 5 times a power of ten, no smaller than the number."""
    size = float(10 ** math.floor(math.log10(number)))
    return next(k * size for k in (1, 2, 5, 10) if k * size >= number * (1 - 1e-9))


def _unit(unit: str) -> str:
    """`m/s^2` as it is printed: m/s²."""
    raised = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
    return escape(re.sub(r"\^\(?(-?\d+)\)?", lambda m: m[1].translate(raised), unit).replace("*", " "))
