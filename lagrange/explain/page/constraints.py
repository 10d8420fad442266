"""Geometric constraints in one section: the relations, their differentials, exactness, classification, freedom.

Where every constraint is a finite relation between the coordinates, free of time and independent of the others,
each of these takes one line. Where any of this needs an argument, the sections of the full derivation are kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.forms.frobenius import PartialsComparison
from lagrange.core.symbols import DotProduct, Slots, Unspecified, VectorSymbol
from lagrange.document.builders import display, listed, paragraph, prose
from lagrange.document.derivation import Block, Display, Emphasis, Equation, Part, Prose, Ref, Rule, Step
from lagrange.explain.constraint_systems import explain_losses
from lagrange.explain.constraints import equal, explain_time, telling_pair
from lagrange.explain.contact.one_sided import explain_in_contact, explain_one_sided
from lagrange.explain.words import counted, in_words, plural, spoken
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.constraints.displacements import possible_displacement
from lagrange.mechanics.rewriting.constraint_forms import common_number, vanishing_components, without_common_number
from lagrange.problem.model import Problem


def is_plainly_geometric(classification: Classification) -> bool:
    """Whether all constraints are geometric, independent and free of time, and so are the positions."""
    constraints = classification.constraints
    plain = all(c.row.finite is not None and not c.contains_time and c.constraint.given is None for c in constraints)
    whole = not classification.redundancies and classification.rank == len(constraints)
    return bool(constraints) and plain and whole and classification.scleronomic is True


def relation_of(c: ConstraintAnalysis) -> Equation:
    """The constraint as the file states it, with its name and note."""
    named = f"({spoken(c.row.name)}{f': {c.constraint.note}' if c.constraint.note else ''})"
    sides = (c.constraint.lhs, c.constraint.rhs)
    return Equation(sides, label=f"constraint-{c.row.name}", relation=c.constraint.relation, condition=(named,))


def explain_geometric(classification: Classification, slots: Slots) -> Step:
    """The constraints, their differentials, and what follows."""
    constraints = classification.constraints
    lines = (
        Equation((possible_displacement(without_common_number(c.row), slots), sp.S.Zero), label=f"form-{c.row.name}")
        for c in constraints
    )
    kind = plural(len(constraints), "a ", "")
    body: list[Block] = [
        display(*map(relation_of, constraints)),
        prose(
            "Neither velocities nor time appear: ", kind, Emphasis("geometric"),
            plural(len(constraints), " constraint. ", " constraints. "), *_in_contact(constraints),
            plural(len(constraints), "Its differential", "Their differentials"),
            _divided([common_number(c.row) for c in constraints]), ":",
        ),
        display(*lines),
        paragraph(*_conclusions(classification)),
    ]  # fmt: skip
    return Step(Rule.CONSTRAINT, plural(len(constraints), "The constraint", "Constraints"), tuple(body))


def _in_contact(constraints: Sequence[ConstraintAnalysis]) -> tuple[Part, ...]:
    """That a one-sided constraint is treated in contact."""
    sentences = explain_in_contact(constraints)
    return (*sentences[0].parts, " ") if sentences else ()


def _divided(contents: Sequence[sp.Integer]) -> str:
    """`, halved`."""
    if all(c == 1 for c in contents):
        return ""
    if set(contents) == {sp.Integer(2)}:
        return ", halved"
    return ", without common factors"


def _conclusions(classification: Classification) -> list[Prose]:
    """Exact, holonomic, scleronomic; the number of degrees of freedom; where a form vanishes."""
    constraints = classification.constraints
    freedom = classification.degrees_of_freedom
    are_exact = plural(len(constraints), " is ", " are ")
    being = plural(len(constraints), "being the differential of ", "being the differentials of ")
    exact: list[Part] = [*listed(Ref(f"form-{c.row.name}") for c in constraints), are_exact, Emphasis("exact")]
    pair = _pair(constraints)
    exact += [", ", being, *listed(Ref(f"constraint-{c.row.name}") for c in constraints)]
    exact += [" in contact"] if any(c.constraint.side is not None for c in constraints) else []
    exact += [" (", equal(pair), ")"] if pair is not None else []
    left = f"{classification.coordinates}\u00a0−\u00a0{classification.rank}\u00a0=\u00a0"
    sentences = [
        prose(*exact, ". So the system is ", Emphasis("holonomic"), ", and ", Emphasis("scleronomic"), "."),
        prose(f"It has {left}", Emphasis(f"{counted(freedom, 'degree')} of freedom"), "."),
    ]
    if freedom == 0:
        sentences.append(prose("The constraints alone determine the position."))
    return [
        *sentences,
        *explain_one_sided(constraints),
        *(s for s in explain_losses(classification) if not _is_excluded(classification)),
    ]


def _is_excluded(classification: Classification) -> bool:
    """Whether the constraints exclude every place where a form would vanish."""
    return all(loss.excluded for loss in classification.losses)


def _pair(constraints: Sequence[ConstraintAnalysis]) -> PartialsComparison | None:
    """The mixed partial derivatives of the only constraint, where they are short and tell something."""
    if len(constraints) != 1:
        return None
    [c] = constraints
    pair = telling_pair(c)
    if pair is None or 0 in pair.coefficients or any(a.has(Unspecified) for a in pair.coefficients):
        return None
    content = common_number(c.row)
    (a, b), (left, right) = pair.coefficients, pair.derivatives
    return replace(pair, coefficients=(a / content, b / content), derivatives=(left / content, right / content))


def without_component(problem: Problem, step: Step) -> Step:
    """The constraints, with v·n = 0 for one that forbids a velocity along a unit vector that the file names."""
    components = vanishing_components(problem)
    lines = [Equation((DotProduct(velocity, VectorSymbol(n)), sp.S.Zero)) for velocity, n in components]
    if not lines:
        return step
    one, more = "a component of the velocity vanishes", "components of velocities vanish"
    words = f"That is, {plural(len(lines), one, more)}:"
    at = next(n for n, b in enumerate(step.body) if isinstance(b, Display)) + 1
    return replace(step, body=(*step.body[:at], prose(words), display(*lines), *step.body[at:]))


def explain_without(classification: Classification, built_in: bool) -> Step:
    """Freedom and classification where no constraint relates the coordinates."""
    freedom = classification.degrees_of_freedom
    why = "No constraint relates the coordinates"
    if built_in:
        why = "The positions, written in these coordinates, satisfy the constraints already; none is left"
    count = "With its one coordinate it has " if freedom == 1 else "It has as many degrees of freedom as coordinates: "
    holonomic = prose(f"{why}, so the system is ", Emphasis("holonomic"), ".")
    many = prose(count, Emphasis(in_words(freedom, "degree") + " of freedom"), ".")
    return Step(
        Rule.DEGREES_OF_FREEDOM, "Degrees of freedom", (paragraph(holonomic, explain_time(classification), many),)
    )
