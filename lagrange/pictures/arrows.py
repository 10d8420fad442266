"""The arrows in a picture of a system: applied forces, the blows of an impact, and gravity beside it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.document.scene import Box, PagePoint, StrokeKind
from lagrange.pictures.floats import FloatVector, NoValueError, plus
from lagrange.pictures.loads import Acting, as_words, given_loads
from lagrange.pictures.sketch import Sketch, beyond, scaled, toward
from lagrange.pictures.systems import SystemPicture, with_other_values
from lagrange.problem.model import AppliedForce

ARROW = 1.15
"""Length of the arrows of unit vectors and loads, in centimetres."""


class Arrows:
    """Draws arrows into a sketch; `places` are those of particles and mass centres."""

    def __init__(self, system: SystemPicture, sketch: Sketch, places: Mapping[str, FloatVector]) -> None:
        self.system = system
        self.sketch = sketch
        self.places = places
        self.pose = system.pose
        self.page = system.page

    def flat(self, place: FloatVector) -> PagePoint:
        """A place on the page."""
        return self.page(place)

    def loads(self) -> None:
        """The applied forces."""
        for name in self.places:
            for acting in given_loads(self.system, name):
                self.load(acting)

    def load(self, acting: Acting) -> None:
        """One of them; moments are not drawn."""
        if acting.is_moment:
            return
        start = self.flat(plus(self.places[acting.on], acting.offset))
        way = toward((0.0, 0.0), self.page.way(acting.vector))
        end = beyond(start, way, ARROW)
        self.sketch.arrow(start, end, StrokeKind.FORCE)
        self.sketch.label(acting.label, end, way)

    def impulses(self) -> None:
        """The blows of an impact, each as an arrow that ends where it strikes."""
        impact = self.system.problem.impact
        drawn = {str(m.label) for m in self.system.marks}
        for blow in impact.impulses if impact is not None else ():
            if not isinstance(blow, AppliedForce):
                continue
            with suppress(NoValueError):
                size = sp.sqrt(textbook_form(blow.vector.dot(blow.vector)))
                if str(size) in drawn:
                    continue
                pose = with_other_values(self.pose, blow.vector.fixed().components)
                way = toward((0.0, 0.0), self.page.way(pose.at(blow.vector)))
                at = self.places[blow.on] if blow.at is None else self.system.at(blow.at)
                start = beyond(self.flat(at), way, -ARROW)
                self.sketch.arrow(start, self.flat(at), StrokeKind.FORCE)
                self.sketch.label(size if size.is_Symbol else as_words(blow.name), start, scaled(way, -1.0))

    def gravity(self) -> None:
        """An arrow in the direction of gravity, to the right of the picture."""
        field = self.system.problem.gravity
        if field is None or field.is_zero:
            return
        way = self.page.way(self.pose.at(field))
        size = sp.sqrt(textbook_form(field.dot(field)))
        if math.hypot(*way) < 1e-9 or not size.is_Symbol:
            return
        way = toward((0, 0), way)
        corners = [p for line in self.sketch.lines for p in line.points] + [d.at for d in self.sketch.dots]
        corners += [p for _, face in self.sketch.filled for p in face.points]
        box = Box.around(corners)
        x = box.right + 0.75
        start = (x, (box.top + box.bottom) / 2 - way[1] * 0.45)
        end = beyond(start, way, 0.9)
        self.sketch.arrow(start, end, StrokeKind.AXIS)
        self.sketch.label_beside(size, start, end)
