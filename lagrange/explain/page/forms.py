"""Which form of the equations of motion a page derives: that of the file's answers, where the result has it."""

from __future__ import annotations

from dataclasses import replace

from lagrange.document.derivation import Equation
from lagrange.explain.page import linked_particles
from lagrange.explain.page.motion import ends_with_speeds
from lagrange.explain.page.result import is_better
from lagrange.explain.page.surfaces import on_surface
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.quasi_velocities import StatedEquations, in_names
from lagrange.mechanics.rewriting.stated_form import in_stated_form


def with_stated_equations(solution: Solution, stated: StatedEquations) -> Solution:
    """The solution with the stated equations where they are derived, if the result at the head of the page has them."""
    in_other_words = on_surface(solution) is not None or linked_particles.linked(solution) is not None
    if not stated or in_other_words or ends_with_speeds(solution) or in_names(solution, stated) != stated:
        return solution
    view = min(solution.choices, key=lambda c: bool(c.signs), default=solution.own)
    motion = view.motion
    if motion is None:
        return solution
    rates = [Equation((row.velocity_form(motion.configuration.slots), 0)) for row in motion.completing]
    if not is_better(view, stated, [*(Equation(e.sides) for e in motion.final), *rates]):
        return solution
    restated = in_stated_form(view, stated)
    if restated is None:
        return solution
    if view is solution.own:
        return replace(solution, own=restated)
    return replace(solution, choices=tuple(restated if c is view else c for c in solution.choices))
