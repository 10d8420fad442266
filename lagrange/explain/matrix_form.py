"""The equations of motion in matrix form, and solved for the accelerations: for those who ask for full detail."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import VectorSymbol
from lagrange.document.derivation import Block, Detail, Equation, Matrices, Rule, Step, display, listed, math, prose
from lagrange.explain.words import plural, spoken
from lagrange.mechanics.dynamics.motion import Motion

LONGEST = 250
"""Operations of accelerations that are still shown."""


def explain_matrix_form(motion: Motion, choice: str = "") -> Step | None:
    """M q'' = f, with A q'' = b where constraints bind the coordinates, and q'' where it is solved for; or nothing."""
    form = motion.matrices
    slots = form.configuration.slots
    mass, force = VectorSymbol("M"), VectorSymbol("f")
    left = sp.Mul(mass, VectorSymbol("q''"), evaluate=False)
    many = len(slots.coordinates) > 1
    body: list[Block] = []
    if many:
        q = listed(math(c) for c in slots.coordinates)
        named = [(mass, form.mass), (force, tuple((e,) for e in form.force))]
        words = [
            "In matrix form, with ",
            math(VectorSymbol("q")),
            " for ",
            *q,
            ", the equations are ",
            math(left, force),
        ]
        if form.constraint_matrix:
            names = VectorSymbol("A"), VectorSymbol("b")
            named += [(names[0], form.constraint_matrix), (names[1], tuple((e,) for e in form.constraint_vector))]
            bound = sp.Mul(names[0], VectorSymbol("q''"), evaluate=False)
            words += [" but for the reactions, which add the transpose of ", math(names[0]), " times their multipliers "
                      "on the right; and the constraints, differentiated until accelerations occur, are ",
                      math(bound, names[1])]  # fmt: skip
        body += [prose(*words, ", where", detail=Detail.FULL), Matrices(tuple(named), Detail.FULL)]
    solved = motion.accelerations
    long = sum(e.count_ops() for e in solved.values()) > LONGEST
    what = plural(len(solved), "acceleration", "accelerations")
    if solved and long:
        body.append(prose(f"Solved for the {what} they are long, and left to the output in JSON.", detail=Detail.FULL))
    elif solved:
        verb = "Solved for the" if many else "The equation, solved for the"
        body.append(prose(f"{verb} {what}:", detail=Detail.FULL))
        suffix = f"-{choice}" if choice else ""
        lines = (Equation((a, e), label=f"solved{suffix}-{a.name}") for a, e in solved.items())
        body.append(display(*lines, detail=Detail.FULL))
    title = "In matrix form" if many else "Solved for the acceleration"
    if not body:
        return None
    return Step(Rule.EQUATIONS_OF_MOTION, f"{title}: {spoken(choice)}" if choice else title, tuple(body))
