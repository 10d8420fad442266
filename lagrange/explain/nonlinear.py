"""Constraints that are not linear in the velocities: reduction to linear ones, Chetaev's rule for the rest."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.forms.reductions import Reduction, Why
from lagrange.document.builders import display, listed, math, paragraph, prose
from lagrange.document.derivation import Block, Emphasis, Equation, Part, Prose, Ref
from lagrange.explain.words import counted, plural
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.constraints.displacements import virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.problem.model import Given

ZERO = sp.S.Zero

_BECAUSE = {
    Why.POWER: "a power is zero only where its base is",
    Why.FACTOR: "its other factors do not vanish",
    Why.QUOTIENT: "a quotient is zero only where its numerator is",
    Why.FUNCTION: "the function vanishes only at zero",
    Why.INVERSE: "the function takes no value twice",
    Why.DIRECTION: "the angle is that of a direction",
    Why.SQUARED: "both sides may be squared",
    Why.SQUARES: "a sum of real terms of one sign is zero only where all of them are",
    Why.FACTORED: "this is its factorized form",
    Why.EXPANDED: "this is its expanded form",
    Why.SPLIT: "the first alternative admits whatever the others do",
}


def explain_reduction(given: Given, count: int) -> list[Block]:
    """The constraint of the file, its reduction step by step; the `count` equivalent equations follow."""
    shown = display(Equation((given.lhs, given.rhs)))
    steps = [_sentence(step) for step in given.steps]
    end = "It is therefore equivalent to" if count == 1 else f"It is therefore equivalent to the {count} constraints"
    words = prose("is not linear in the velocities as it stands.")
    excluded = [*dict.fromkeys(e for step in given.steps for e in step.excluded)]
    if excluded:
        zeros = [math(e, ZERO) for e in excluded]
        words = prose(*words.parts, " It admits more velocities where ", *listed(zeros, " or "), "; such positions are "
                      "excluded here.")  # fmt: skip
    return [prose("The constraint"), shown, paragraph(words, *steps, prose(end))]


def _sentence(step: Reduction) -> Prose:
    """`x'² + y'² = 0 if and only if x' = 0 and y' = 0: a sum of real terms ...`"""
    zeros = listed((math(f, ZERO) for f in step.forms), " or " if step.why is Why.SPLIT else " and ")
    return prose(math(step.function, ZERO), " if and only if ", *zeros, *_conditions(step.conditions),
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
        words = (" is neither linear in the velocities nor equivalent to linear equations. It has no differential form "
                 "and lies outside the ")  # fmt: skip
    else:
        words = (" are neither linear in the velocities nor equivalent to linear equations. They have no differential "
                 "forms and lie outside the ")  # fmt: skip
    return [prose(*refs, words, Emphasis("Pfaffian"), " class.")]


def explain_bending(c: ConstraintAnalysis) -> list[Block]:
    """Why a constraint that is not linear in the velocities is, or is not, equivalent to finite relations."""
    label = f"constraint-{c.row.name}"
    if c.integrable is None:
        return [prose("It could not be decided whether ", Ref(label), " is equivalent to a finite relation.")]
    if c.integrable:
        words = (" leaves no velocity free: it gives each as a function of position and time, perhaps in several "
                 "branches, and the solutions of such equations are finite relations between coordinates and "
                 "time.")  # fmt: skip
        return [prose(Ref(label), words)]
    why = prose(
        "A finite relation, differentiated with respect to time, is linear in the velocities: those that it admits at "
        "one position and time fill a plane. Those of ", Ref(label), " lie on a curved surface",
    )  # fmt: skip
    end = prose("No plane contains them: the constraint is ", Emphasis("not integrable"), ".")
    if c.bending is None:
        return [paragraph(Prose((*why.parts, ".")), end)]
    changes = [math(e) for e in c.bending.direction]
    shown: tuple[Part, ...] = (
        ": where ", *listed(math(v) for v in c.bending.velocities), " change in the ratio ", changes[0], " to ",
        changes[1],
        ", the constraint still holds to first order, but the second derivative of its left side minus its right side "
        "is ",
        math(c.bending.value, sp.S.Zero, relation="≠"), ".",
    )  # fmt: skip
    return [paragraph(Prose((*why.parts, *shown)), end)]


def together(classification: Classification) -> list[Block]:
    """The finite relations of all constraints, of which some are not linear in the velocities."""
    rank = classification.flag.integrable_rank
    if rank is None:
        return [prose("It could not be decided how many finite relations the constraints imply together.")]
    relations = counted(rank, "finite relation") if rank else "no finite relation"
    if classification.degrees_of_freedom == 0:
        return [prose(f"Taken together, the constraints leave no velocity free: they are equivalent to {relations}.")]
    words = (f"Taken together, the constraints imply {relations} between the coordinates: the velocities admitted at "
             "one position span all that the linear constraints leave, so the others add none.")  # fmt: skip
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
            "The condition that ", *refs, plural(len(rows), " imposes", " impose"), " on possible displacements is not "
            "linear, so their differences satisfy no linear condition, and virtual displacements cannot be found in "
            "that way. ", Emphasis("Chetaev's rule"),
            " admits those for which the derivatives of the constraint with respect to the velocities, each times the "
            "virtual displacement of its coordinate, add up to zero. For constraints linear in the velocities this is "
            "nothing new; for others it is a ", Emphasis("postulate"), " and follows from nothing above. Here it reads",
        ),
        display(*lines),
    ]  # fmt: skip
