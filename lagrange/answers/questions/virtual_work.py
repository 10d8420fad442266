"""Virtual work as an answer about equilibrium: W δy − 2 P y/√(b² + y²) δy = 0.

It vanishes for all virtual displacements, so that the coefficient of each independent one is zero: these are the
conditions of equilibrium that it states. In statics dy is written for δy as well.
"""

from __future__ import annotations

from dataclasses import replace

from lagrange.answers.readings import GivenEquation, displaced_coordinates, without_displacements
from lagrange.answers.written.working import Working
from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import differential, variation
from lagrange.mechanics.results import Solution


def with_stated_conditions(working: Working, solution: Solution) -> Working:
    """The answer with the conditions that its equations between virtual displacements state."""
    return replace(working, judged=tuple(_conditions(f, solution) for f in working.judged))


def _conditions(fragment: Fragment, solution: Solution) -> Fragment:
    if not isinstance(fragment, GivenEquation):
        return fragment
    components = fragment.reading.components
    for view in (v for v in solution.views if not v.configuration.rows):  # where the displacements are independent
        coordinates = (*view.configuration.slots.coordinates, *view.configuration.expressed)
        displaced = displaced_coordinates(components, coordinates)
        if not displaced:
            continue
        virtual = [e.xreplace({differential(q): variation(q) for q in displaced}) for e in components]
        conditions = tuple(
            c for e in virtual for c in without_displacements(view.configuration.rewritten(e), view.configuration)
        )
        if any(c != 0 for c in conditions) and conditions != tuple(virtual):
            reading = replace(fragment.reading, components=conditions, sides=())
            return replace(fragment, reading=reading)
    return fragment
