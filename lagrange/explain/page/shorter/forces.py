"""Constant forces in terms of the accelerations, F = m (g + a), where they are long in terms of parameters alone.

Two pulleys with inertia have tensions with a denominator of five products, and accelerations with the same one.
Newton's law gives each tension from the accelerations in a few letters, which is how a book writes it.
"""

from __future__ import annotations

from dataclasses import replace

from lagrange.document.builders import prose
from lagrange.document.derivation import Display, Prose, Step
from lagrange.explain.limits import SHORTER_IN_ACCELERATIONS
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.mechanics.rewriting.constant_accelerations import constant_accelerations


def in_accelerations(solution: Solution, step: Step, view: InCoordinates) -> Step:
    """The forces, in terms of the accelerations if these are constant and stated, and the forces much shorter so."""
    at = next((n for n, b in enumerate(step.body) if isinstance(b, Display) and b.boxed), None)
    law = solution.law
    if at is None or law is None or view.motion is None or law.all_frictions or view is not solution.chosen:
        return step
    box = step.body[at]
    assert isinstance(box, Display)
    lines = [e for e in box.equations if e.label]
    accelerations = constant_accelerations(view)
    if len(lines) == len(box.equations) or not accelerations:
        return step  # no denominator has a letter: they are short enough
    from lagrange.mechanics.nearby.forces_in_turn import forces_in_turn

    forces = forces_in_turn(law, solution.own, view, accelerations)
    if forces is None or any(e.sides[0] not in forces for e in lines):
        return step
    labels = {e.sides[0]: e for e in lines}
    short = [replace(labels[name], sides=(name, value)) for name, value in forces.items() if name in labels]
    if SHORTER_IN_ACCELERATIONS * sum(e.operations for e in short) > box.operations:
        return step
    laws = "Newton's equations" if law.newton.bodies is not None else "the equations with multipliers"
    words = prose(f"In terms of the accelerations, {laws} give one after another")
    before = step.body[:at] if at == 0 or not isinstance(step.body[at - 1], Prose) else step.body[: at - 1]
    return replace(step, body=(*before, words, replace(box, equations=tuple(short)), *step.body[at + 1 :]))
