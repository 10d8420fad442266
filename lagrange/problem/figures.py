"""Reading `figure` and the shapes of particles and bodies: what a figure shows that the mechanics does not tell.

A figure is drawn from positions, constraints and forces. These leave out what has no part in the mechanics: where the
ground is, which way a string goes, how large a disc is. Everything here is given in vectors of the problem, so that it
is where the system is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import chain
from typing import TypeVar

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, ProblemError, suggestion
from lagrange.core.records import record
from lagrange.core.symbols import UnitVector
from lagrange.core.vectors import Vector
from lagrange.problem.keys import CIRCLE, CURVE, FIGURE, HIDEABLE, SHAPE, Drawn, Outline
from lagrange.problem.limits import MOST_DRAWN
from lagrange.problem.load_context import LoadContext
from lagrange.problem.model import BodyShape, Choice, Figure, FigureCircle, FigureCurve, FigureLine, FigureMark
from lagrange.problem.sections import FORCE, POSITION, Section, entries_of, items_of, mapping_of, scalar_of, wrong_kind
from lagrange.problem.values import read_number_with_unit
from lagrange.problem.yaml.nodes import ListNode, Node, Scalar

T = TypeVar("T")
_CHAINS = (Drawn.GROUND, Drawn.RODS, Drawn.STRINGS, Drawn.LINES, Drawn.OUTLINES, Drawn.SPRINGS, Drawn.DAMPERS)
_PAIRS = (Drawn.BLADES, Drawn.WHEELS)
_MARKS = {Drawn.ANGLES: "[at, from, to]", Drawn.LENGTHS: "[from, to]", Drawn.ARROWS: "[from, to]"}


def read_figure(root: Section, context: LoadContext, choices: tuple[Choice, ...]) -> Figure:
    """The section `figure` and the shapes of particles and bodies. Reports what is wrong."""
    shapes = {}
    for name, node in context.shapes.items():
        shape = context.diagnostics.attempt(partial(_shape, name, node, context))
        if shape is not None:
            shapes[name] = shape
    whole = root.section("figure")
    mapping = context.diagnostics.attempt(lambda: mapping_of(whole, "`figure`", "figure: {...}")) if whole else None
    if mapping is None:
        return Figure(shapes=shapes)
    section = Section(mapping, "the figure", FIGURE, context.diagnostics)
    figure = _FigureBeingRead(section, context, choices).read()
    return replace(figure, shapes=shapes)


def _shape(name: str, node: Node, context: LoadContext) -> BodyShape:
    what = f"the shape of `{name}`"
    section = Section(mapping_of(node, what, "shape: {disc: R}"), what, SHAPE, context.diagnostics)
    given = [o for o in Outline if section.has(o)]
    if len(given) != 1:
        message = f"{what} is one of {', '.join(f'`{o}`' for o in Outline)}"
        raise ProblemError(Diagnostic("shape", message, node.span, help="write one of them: `shape: {disc: R}`"))
    [kind] = given
    value = section.required(kind, node.span)
    axis_node = section.get("axis")
    axis = None if axis_node is None else context.vector(axis_node, f"the axis of `{name}`")
    if kind is Outline.ROD:
        return BodyShape(kind, ends=tuple(_place(i, what, context) for i in _several(value, what, 2, "rod: [A, B]")))
    sides = (value,) if isinstance(value, Scalar) else _several(value, what, 2, f"{kind}: [a, b]")
    if len(sides) != (2 if kind in (Outline.BOX, Outline.CONE) else 1):
        example = f"{kind}: [a, b]" if kind in (Outline.BOX, Outline.CONE) else f"{kind}: R"
        raise ProblemError(wrong_kind(value, f"{what} has another number of lengths", f"write `{example}`"))
    return BodyShape(kind, tuple(context.scalar(s, what, POSITION) for s in sides), axis=axis)


def _several(node: Node, what: str, number: int, example: str) -> tuple[Node, ...]:
    items = items_of(node, what, example)
    if len(items) != number:
        raise ProblemError(wrong_kind(node, f"{what} has {number} parts, not {len(items)}", f"write `{example}`"))
    return items


def _place(node: Node, what: str, context: LoadContext, points: dict[str, Vector] | None = None) -> Vector:
    """A place: a particle, a body, a point of the figure, `O`, or a vector."""
    if isinstance(node, Scalar):
        known = {**context.points, **(points or {})}
        if node.text in known:
            point = known[node.text]
            if point is None:
                raise ProblemError(())  # it could not be read, which has been reported
            return point
        if node.text in ("O", "0") and "O" not in context.scope.names():
            return Vector.zero()
    return context.vector(node, what, POSITION)


@record
class _FigureBeingRead:
    section: Section
    context: LoadContext
    choices: tuple[Choice, ...]

    def read(self) -> Figure:
        """All parts, the points first."""
        points: dict[str, Vector] = {}
        for key, node in self.entries("points", "points: {A: l*i}"):
            vector = self.context.diagnostics.attempt(lambda n=node: self.place(n, points))  # type: ignore[misc]
            if vector is not None:
                points[key.text] = vector
        pulleys = {}
        for key, node in self.entries("pulleys", "pulleys: {upper: {centre: h*j, radius: R}}"):
            circle = self.context.diagnostics.attempt(lambda n=node: self.circle(n, points, pulley=True))  # type: ignore[misc]
            if circle is not None:
                pulleys[key.text] = circle
        down, seen_from = (self.vector(key) for key in ("down", "seen_from"))
        supports = (FigureLine(Drawn.SUPPORTS, (p,)) for p in self.each("supports", lambda n: self.place(n, points)))
        lines = chain.from_iterable(self.lines(kind, points, pulleys) for kind in (*_CHAINS, *_PAIRS))
        figure = Figure(
            at=self.position(),
            down=down,
            seen_from=seen_from,
            points=points,
            lines=(*lines, *supports),
            pulleys=pulleys,
            circles=tuple(self.each("circles", lambda n: self.circle(n, points, pulley=False))),
            curves=tuple(self.each("curves", lambda n: self.curve(n, points))),
            marks=tuple(chain.from_iterable(self.marks(kind, points) for kind in _MARKS)),
            hidden=frozenset(self.each("hide", self.hidden)),
        )
        number = sum(len(p) for p in (points, figure.lines, pulleys, figure.circles, figure.curves, figure.marks))
        if number > MOST_DRAWN:
            message = f"the figure has {number} parts, but at most {MOST_DRAWN} can be drawn"
            self.context.diagnostics.report(
                Diagnostic("figure-too-large", message, self.section.node.span, help="draw what the text speaks of")
            )
            return Figure()
        return figure

    def entries(self, key: str, example: str) -> tuple[tuple[Scalar, Node], ...]:
        node = self.section.get(key)
        if node is None:
            return ()
        return self.context.diagnostics.attempt(lambda: entries_of(node, f"`{key}`", example)) or ()

    def each(self, key: str, read: Callable[[Node], T]) -> list[T]:
        """The items of a list that can be read."""
        node = self.section.get(key)
        if node is None:
            return []
        listed = node
        items = self.context.diagnostics.attempt(lambda: items_of(listed, f"`{key}`", f"{key}: [...]"))
        results = (self.context.diagnostics.attempt(partial(read, i)) for i in items or ())
        return [r for r in results if r is not None]

    def vector(self, key: str) -> Vector | None:
        """A direction of the figure."""
        node = self.section.get(key)
        return None if node is None else self.context.diagnostics.attempt(lambda: self.place(node, {}))

    def place(self, node: Node, points: dict[str, Vector]) -> Vector:
        return _place(node, "a place of the figure", self.context, points)

    def position(self) -> dict[str, sp.Expr]:
        """The numbers under `at`."""
        slots = self.context.scope.slots
        known = {s.name for s in (*self.context.names.parameters, *slots.coordinates, *slots.prescribed)}
        known |= {q.name for c in self.choices for q in c.coordinates} | {"t"} | {*self.context.scope.functions}
        at = {}
        for key, node in self.entries("at", "at: {theta: 30 deg}"):
            if key.text not in known:
                message = f"`{key.text}` is neither a coordinate nor a parameter of this file"
                help_ = suggestion(key.text, sorted(known), "names")
                self.context.diagnostics.report(Diagnostic("unknown-name", message, key.span, help=help_))
                continue
            number = self.context.diagnostics.attempt(lambda n=node: self.number(n))  # type: ignore[misc]
            if number is not None:
                at[key.text] = number
        return at

    def number(self, node: Node) -> sp.Expr:
        fragment = scalar_of(node, "a number of the figure").fragment
        return read_number_with_unit(fragment, None, sp.Symbol("x", real=True), None).number

    def lines(self, kind: Drawn, points: dict[str, Vector], pulleys: dict[str, FigureCircle]) -> list[FigureLine]:
        """The chains of one kind."""

        def one(node: Node) -> FigureLine:
            items = items_of(node, f"an entry of `{kind}`", f"{kind}: [[A, B]]")
            if len(items) < 2 or (kind in _PAIRS and len(items) != 2):
                parts = "place and direction" if kind in _PAIRS else "at least two places"
                raise ProblemError(wrong_kind(node, f"an entry of `{kind}` has {parts}", f"write `{kind}: [[A, B]]`"))
            around = kind is Drawn.STRINGS
            places: list[Vector | str] = []
            for item in items:
                if around and isinstance(item, Scalar) and item.text in pulleys:
                    places.append(item.text)
                else:
                    places.append(self.place(item, points))
            return FigureLine(kind, tuple(places))

        return self.each(kind, one)

    def circle(self, node: Node, points: dict[str, Vector], *, pulley: bool) -> FigureCircle:
        what = "a pulley" if pulley else "a circle of the figure"
        section = Section(mapping_of(node, what, "{centre: A, radius: R}"), what, CIRCLE, self.context.diagnostics)
        axis = section.get("axis")
        return FigureCircle(
            Drawn.PULLEY if pulley else self.word(section, Drawn.DISC),
            self.place(section.required("centre", node.span), points),
            self.context.scalar(section.required("radius", node.span), f"the radius of {what}", POSITION),
            None if axis is None else self.context.vector(axis, f"the axis of {what}"),
        )

    def word(self, section: Section, default: Drawn) -> Drawn:
        """What the key `as` says. Raises ProblemError if it is none of the words."""
        node = section.get("as")
        if node is None:
            return default
        [key] = (k for k in section.form.keys if k.name == "as")
        words = key.kind.words  # type: ignore[union-attr]
        scalar = scalar_of(node, "`as`")
        if scalar.text not in words:
            message = f"`{scalar.text}` is not something that can be drawn here"
            help_ = suggestion(scalar.text, words, "words")
            raise ProblemError(Diagnostic("figure-word", message, scalar.span, help=help_))
        return Drawn(scalar.text)

    def curve(self, node: Node, points: dict[str, Vector]) -> FigureCurve:
        what = "a curve of the figure"
        section = Section(mapping_of(node, what, "{point: x*i, along: x, ...}"), what, CURVE, self.context.diagnostics)
        names, starts, ends = (_listed(section.required(key, node.span)) for key in ("along", "from", "to"))
        if not len(names) == len(starts) == len(ends) <= 2:
            message = f"{what} has one parameter with its two ends, a surface has two"
            raise ProblemError(wrong_kind(node, message, "write `along: [u, v], from: [0, 0], to: [1, pi]`"))
        between = tuple(
            (self.context.scalar(a, what, POSITION), self.context.scalar(b, what, POSITION))
            for a, b in zip(starts, ends, strict=True)
        )
        scope = self.context.scope
        along = []
        for scalar in (scalar_of(n, "`along`") for n in names):
            known = scope.scalars.get(scalar.text)
            symbol = known if isinstance(known, sp.Symbol) else sp.Symbol(scalar.text, real=True)
            if not scalar.text.isidentifier() or len(scalar.text) > 20:
                raise ProblemError(wrong_kind(scalar, f"`{scalar.text[:20]}` is not a name", "write `along: x`"))
            along.append(symbol)
        new = {s.name: s for s in along if s.name not in scope.scalars}
        self.context.scope = replace(scope, scalars={**scope.scalars, **new})
        try:
            point = self.place(section.required("point", node.span), points)
        finally:
            self.context.scope = scope
        return FigureCurve(self.word(section, Drawn.CURVE), point, tuple(along), between)

    def marks(self, kind: Drawn, points: dict[str, Vector]) -> list[FigureMark]:
        """Angles, lengths or arrows with their labels."""
        number = 3 if kind is Drawn.ANGLES else 2

        def one(key: Scalar, node: Node) -> FigureMark:
            what = f"an entry of `{kind}`"
            label = self.label(key, what)
            items = _several(node, what, number, f"{key.text}: {_MARKS[kind]}")
            return FigureMark(kind, label, tuple(self.place(i, points) for i in items))

        marks = (
            self.context.diagnostics.attempt(lambda k=key, n=node: one(k, n))  # type: ignore[misc]
            for key, node in self.entries(kind, f"{kind}: {{R: {_MARKS[kind]}}}")
        )
        return [m for m in marks if m is not None]

    def label(self, key: Scalar, what: str) -> sp.Expr:
        """An expression, in which coordinates of the choices may occur too; or the name of a vector."""
        scope = self.context.scope
        if key.text in scope.vectors:
            return UnitVector(key.text)
        new = {q.name: q for c in self.choices for q in c.coordinates if q.name not in scope.names()}
        return self.context.scalar(key, what, FORCE, replace(scope, scalars={**scope.scalars, **new}))

    def hidden(self, node: Node) -> str:
        scalar = scalar_of(node, "`hide`")
        slots = self.context.scope.slots
        known = {
            *HIDEABLE,
            *self.context.points,
            *self.context.constraints.known(),
            *(q.name for q in slots.coordinates),
        }
        known |= {q.name for c in self.choices for q in c.coordinates}
        if scalar.text not in known:
            message = f"`{scalar.text}` is nothing that this figure shows"
            help_ = suggestion(scalar.text, sorted(known), "names")
            raise ProblemError(Diagnostic("unknown-name", message, scalar.span, help=help_))
        return scalar.text


def _listed(node: Node) -> tuple[Node, ...]:
    return node.items if isinstance(node, ListNode) else (node,)
