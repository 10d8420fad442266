"""The solution in the forms that a page derives.

Equations of motion have the form of the file's answers, where the result at the head of the page has it. Linear
equations about an equilibrium contain the coordinate itself instead of a root that is its value.
"""

from __future__ import annotations

from dataclasses import replace

from lagrange.document.derivation import Equation
from lagrange.explain.page import linked_particles
from lagrange.explain.page.motion import ends_with_speeds
from lagrange.explain.page.result import is_better
from lagrange.explain.page.surfaces import on_surface
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.equilibrium_values import by_coordinates
from lagrange.mechanics.rewriting.quasi_velocities import StatedEquations, in_names
from lagrange.mechanics.rewriting.stated_form import in_stated_form, substituted_at_once


def in_forms_of_page(solution: Solution, stated: StatedEquations) -> Solution:
    """The solution with the equations as a page has them; itself if it has them already."""
    return _with_values(_substituted(_with_stated_equations(solution, stated)))


def _substituted(solution: Solution) -> Solution:
    """With the rates of rolling wheels substituted at once, in the coordinates of choices."""
    found = tuple(substituted_at_once(c) for c in solution.choices)
    choices = tuple(c if f is None else f for c, f in zip(solution.choices, found, strict=True))
    return replace(solution, choices=choices) if any(found) else solution


def _with_values(solution: Solution) -> Solution:
    """With the coordinates in linear equations about equilibria at which they are roots."""
    own = by_coordinates(solution.own)
    found = tuple(by_coordinates(c) for c in solution.choices)
    choices = tuple(c if f is None else f for c, f in zip(solution.choices, found, strict=True))
    if own is None and not any(found):
        return solution
    return replace(solution, own=own or solution.own, choices=choices)


def _with_stated_equations(solution: Solution, stated: StatedEquations) -> Solution:
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
