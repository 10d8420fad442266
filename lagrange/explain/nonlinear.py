"""Constraints that are not linear in the velocities: what they come to, and what is different where they stay so."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.document.derivation import (
    Block,
    Equation,
    Part,
    Prose,
    Ref,
    Term,
    display,
    listed,
    math,
    paragraph,
    prose,
)
from lagrange.explain.words import counted
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.constraints.displacements import virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.problem.alternatives import Reduction, Why
from lagrange.problem.model import Given

ZERO = sp.S.Zero

_BECAUSE = {
    Why.POWER: "a power is zero only where its base is",
    Why.FACTOR: "its other factors do not vanish",
    Why.QUOTIENT: "a quotient is zero only where its numerator is",
    Why.FUNCTION: "the function is zero only at zero",
    Why.INVERSE: "the function takes no value twice",
    Why.DIRECTION: "the angle is that of a direction",
    Why.SQUARED: "both sides may be squared",
    Why.SQUARES: "in real numbers a sum of terms of one sign is zero only where all are",
    Why.FACTORED: "so it reads in factors",
    Why.EXPANDED: "so it reads when it is multiplied out",
    Why.SPLIT: "the first admits what the others do",
}


def explain_reduction(given: Given, count: int) -> list[Block]:
    """The constraint of the file, and step by step when it holds; the `count` equations that it comes to follow."""
    shown = display(Equation((given.lhs, given.rhs)))
    steps = [_sentence(step) for step in given.steps]
    end = "So it comes to" if count == 1 else f"So it comes to {count} constraints,"
    words = prose("is not linear in the velocities as it stands.")
    return [prose("The constraint"), shown, paragraph(words, *steps, prose(end))]


def _sentence(step: Reduction) -> Prose:
    """`x'² + y'² = 0 just when x' = 0 and y' = 0: in real numbers ...`"""
    zeros = listed((math(f, ZERO) for f in step.forms), " or " if step.why is Why.SPLIT else " and ")
    return prose(math(step.function, ZERO), " just when ", *zeros, *_conditions(step.conditions),
                 f": {_BECAUSE[step.why]}.")  # fmt: skip


def _conditions(conditions: Sequence[tuple[sp.Expr, str]]) -> tuple[Part, ...]:
    if not conditions:
        return ()
    return (" (where ", *listed(math(e, ZERO, relation=relation) for e, relation in conditions), ")")


def without_form(members: Sequence[ConstraintAnalysis]) -> list[Block]:
    """Constraints that are not linear in the velocities."""
    if not members:
        return []
    refs = listed(Ref(f"constraint-{c.row.name}") for c in members)
    if len(members) == 1:
        words = (" is not linear in the velocities, nor a way of writing linear equations. It has no differential "
                 "form, and lies outside the ")  # fmt: skip
    else:
        words = (" are not linear in the velocities, nor a way of writing linear equations. They have no differential "
                 "forms, and lie outside the ")  # fmt: skip
    return [prose(*refs, words, Term("Pfaffian"), " class.")]


def explain_bending(c: ConstraintAnalysis) -> list[Block]:
    """Why a constraint that is not linear in the velocities is no finite relation."""
    label = f"constraint-{c.row.name}"
    if c.integrable is None:
        return [prose("Whether ", Ref(label), " is a finite relation could not be decided.")]
    if c.integrable:
        words = (" leaves no velocity free: it gives each as a function of position and time, perhaps in several "
                 "branches, and such equations have finite relations between coordinates and time for "
                 "solutions.")  # fmt: skip
        return [prose(Ref(label), words)]
    why = prose(
        "A finite relation, differentiated by time, is linear in the velocities: those that it admits at one position "
        "and time fill a plane. Those of ", Ref(label), " lie on a surface that is curved",
    )  # fmt: skip
    end = prose("No plane holds them: it is ", Term("not integrable"), ".")
    if c.bending is None:
        return [paragraph(Prose((*why.parts, ".")), end)]
    changes = [math(e) for e in c.bending.direction]
    shown: tuple[Part, ...] = (
        ": where ", *listed(math(v) for v in c.bending.velocities), " change in the ratio of ", changes[0], " to ",
        changes[1],
        ", it still holds to first order, but the second derivative of its left side less its right side is ",
        math(c.bending.value, sp.S.Zero, relation="≠"), ".",
    )  # fmt: skip
    return [paragraph(Prose((*why.parts, *shown)), end)]


def together(classification: Classification) -> list[Block]:
    """The finite relations of all constraints, of which some are not linear in the velocities."""
    found = classification.flag.integrable_rank
    if found is None:
        return [prose("How many finite relations the constraints hold together could not be decided.")]
    relations = counted(found, "finite relation") if found else "no finite relation"
    if classification.degrees_of_freedom == 0:
        return [prose(f"Taken together, the constraints leave no velocity free: they come to {relations}.")]
    words = (f"Taken together, the constraints come to {relations} between the coordinates: the velocities admitted at "
             "one position span all that the linear constraints leave, so that the others add none.")  # fmt: skip
    return [prose(words)]


def by_chetaev(configuration: Configuration) -> list[Block]:
    """The virtual displacements of constraints that are not linear in the velocities: a postulate."""
    rows = [r for r in configuration.rows if r.nonlinear is not None]
    if not rows:
        return []
    of = f"rate-{configuration.name}-" if configuration.name else "constraint-"
    refs = listed(Ref(f"{of}{r.name}") for r in rows)
    slots = configuration.slots
    lines = (Equation((virtual_displacement(r, slots), sp.S.Zero), label=f"virtual-{r.name}") for r in rows)
    return [
        prose(
            "What a possible displacement satisfies by ", *refs, " is not linear, so that nothing linear holds of the "
            "difference of two of them, and virtual displacements are not found in that way. ", Term("Chetaev's rule"),
            " takes those for which the derivatives of the constraint by the velocities, each times the virtual "
            "displacement of its coordinate, add up to zero. For constraints that are linear in the velocities that is "
            "nothing new; for others it is a ", Term("postulate"), " and follows from nothing above. Here it reads",
        ),
        display(*lines),
    ]  # fmt: skip
