"""The force of a curve that the coordinates of a particle describe: no constraint stands for it, Newton's law gives it.

Where r(q) satisfies the constraint by itself, and the file names a unit vector n with n·∂r/∂q = 0, the reaction of a
smooth curve or surface is along n, and R·n = m r''·n − F·n is all of it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.symbols import DotProduct, VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.document.builders import display, prose
from lagrange.document.derivation import Detail, Equation, Prose, Rule, Step
from lagrange.explain.words import capital, constraints_called, the
from lagrange.mechanics.results import Solution


def without_idle(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps without the work of a constraint that exerts no force, where the path is kept by another."""
    if reaction_along_normal(solution) is None:
        yield from steps
        return
    names = constraints_called(c.row.name for c in solution.classification.constraints)
    for step in steps:
        if step.rule is Rule.PRINCIPLE and isinstance(step.body[0], Prose):
            words = prose(
                f"{capital(names)} only says what a coordinate means, and no force maintains it. The force that keeps "
                f"{the(solution.own.configuration.points[0].name)} on its path is normal to the path: it does no "
                "virtual work, and drops out of Newton's law multiplied by the virtual displacement:"
            )
            yield replace(step, body=(words, *step.body[1:]))
        elif step.rule not in (Rule.REACTIONS, Rule.WORKLESS):
            yield step


def reaction_along_normal(solution: Solution) -> Step | None:
    """R·n of the only particle; None without a unit vector n that is normal to all of its displacements."""
    configuration = solution.own.configuration
    reactions = None if solution.own.dynamics is None else solution.own.dynamics.reactions
    if len(configuration.points) != 1 or configuration.rotations or configuration.links or reactions is None:
        return None
    if any(m != 0 for m in reactions.multipliers.values()):
        return None
    [point] = configuration.points
    slots = configuration.slots
    position = point.position.fixed()
    displacements = [position.map(lambda c, q=q: c.diff(q)) for q in slots.coordinates]  # type: ignore[misc]
    force = sum((f.vector.fixed() for f in configuration.loads), Vector.zero())
    for name, vector in solution.problem.abbreviations.items():
        unit = vector.fixed() if isinstance(vector, Vector) else Vector.zero()
        if is_zero(unit.dot(unit) - 1) is not True or any(is_zero(d.dot(unit)) is not True for d in displacements):
            continue
        value = textbook_form(point.mass * point.acceleration.fixed().dot(unit) - force.dot(unit))
        if set(slots.accelerations) & value.free_symbols:
            continue
        n, moved = VectorSymbol(name), VectorSymbol(f"r_{point.name}''")
        applied = sp.S.Zero if force.is_zero else DotProduct(VectorSymbol(f"F_{point.name}"), n)
        sides = (DotProduct(VectorSymbol(f"R_{point.name}"), n), point.mass * DotProduct(moved, n) - applied,
                 sp.factor_terms(value))  # fmt: skip
        line = display(Equation(sides, label=f"normal-{point.name}"), boxed=True, detail=Detail.BRIEF)
        words = f"The force that keeps {the(point.name)} on its path is along its normal. By Newton's law it is"
        return Step(Rule.SOLVED_REACTIONS, "The reaction", (prose(words), line))
    return None
