"""Constraints that integrate at sight, in one section: a wheel rolling along a line, or several that move.

R θ' = x' is R dθ − dx = 0, which is exact and integrates to R θ − x = const. It teaches nothing about integrability
that would justify three sections: the relations, their forms, the finite relation, classification and freedom share
one. A form that is exact only where the geometric constraints hold, ds − h dψ with h = R, belongs here too; one that
needs an integrating factor does not. Of several geometric constraints with time in them each is the differential of a
relation as well; a single one keeps its sections, which show what time changes.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.core.operations import count_operations
from lagrange.core.symbols import CONSTANT, differential, t
from lagrange.document.builders import display, listed, math, paragraph, prose
from lagrange.document.derivation import Block, Emphasis, Equation, Part, Prose, Ref, Rule, Step
from lagrange.explain.constraints import explain_time
from lagrange.explain.contact.one_sided import explain_in_contact, explain_one_sided
from lagrange.explain.limits import LONGEST_INTEGRATED_RELATION
from lagrange.explain.page.constraints import relation_of
from lagrange.explain.words import counted, plural
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.constraints.displacements import possible_displacement
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.constraint_forms import common_number, without_common_number


def integrates_at_sight(solution: Solution) -> bool:
    """Whether all constraints are finite relations or integrate to them, on a page about a motion or an impact.

    Where all are finite relations and free of time, `explain_geometric` says so in fewer lines.
    """
    classification = solution.classification
    constraints = classification.constraints
    if solution.own.dynamics is None and solution.impact is None:
        return False
    kinematic = any(c.row.finite is None for c in constraints)
    moving = len(constraints) > 1 and any(c.contains_time for c in constraints)
    simple = all(_is_simple(c) for c in constraints) and (kinematic or moving)
    independent = classification.rank == len(constraints) and not classification.redundancies
    usual = all(loss.excluded for loss in classification.losses) and not classification.hidden.found
    return simple and independent and usual and classification.holonomic is True


def _is_simple(c: ConstraintAnalysis) -> bool:
    if c.constraint.given is not None or not c.pfaffian or c.quasi:
        return False
    if c.row.finite is not None:
        return True
    if c.contains_time or c.catastatic is not True:
        return False
    form = c.finite_form
    angles = form is not None and form.restriction is not None and form.restriction.angles
    exact_where_restricted = form is not None and not angles and form.found.factor == 1
    return c.integral is not None and (c.exactness.exact is True or exact_where_restricted)


def explain_at_sight(solution: Solution) -> Step:
    """The constraints, their forms, the relations that these integrate to, classification and freedom."""
    classification, slots = solution.classification, solution.problem.slots
    constraints = classification.constraints
    forms = (
        Equation((possible_displacement(_form(c), slots), sp.S.Zero), label=f"form-{c.row.name}") for c in constraints
    )
    relations = display(*map(relation_of, constraints))
    body: list[Block] = [relations, _kinds(constraints), display(*forms), *_integrated(constraints)]
    return Step(
        Rule.CONSTRAINT,
        plural(len(constraints), "The constraint", "Constraints"),
        tuple(_ending(body, _conclusions(classification))),
    )


def _ending(body: list[Block], conclusions: list[Prose]) -> list[Block]:
    """The conclusions, in the paragraph before them if there is one."""
    last = body[-1]
    if isinstance(last, Prose):
        return [*body[:-1], paragraph(last, *conclusions)]
    return [*body, paragraph(*conclusions)]


def _form(c: ConstraintAnalysis) -> Row:
    return without_common_number(c.row) if c.row.finite is not None else c.row


def _kinds(constraints: Sequence[ConstraintAnalysis]) -> Prose:
    """Which are geometric and which kinematic; how their forms come about."""
    geometric = [c for c in constraints if c.row.finite is not None]
    kinematic = [c for c in constraints if c.row.finite is None]
    timed = [Ref(f"constraint-{c.row.name}") for c in constraints if c.contains_time]
    refs = [listed(Ref(f"constraint-{c.row.name}") for c in group) for group in (geometric, kinematic)]
    are = [plural(len(group), " is ", " are ") for group in (geometric, kinematic)]
    words: list[Part] = []
    if geometric:
        words += [*refs[0], are[0], Emphasis("geometric"), ", " if kinematic else ""]
    if kinematic:
        words += [*refs[1], are[1], Emphasis("kinematic")]
    words += ["; time appears in ", *listed(timed), ". "] if timed else ["; time does not appear. "]
    sentences = explain_in_contact(constraints)
    words += [*sentences[0].parts, " "] if sentences else []
    divided = ", without common factors," if any(common_number(c.row) != 1 for c in geometric) else ""
    multiplied = (" multiplied by ", math(differential(t)))
    if not geometric:
        words += ["Multiplied by ", math(differential(t)), plural(len(constraints), ", it is", ", they are")]
    elif not kinematic:
        words += [f"Their differentials{divided} are"]
    else:
        differentials = plural(len(geometric), "The differential of ", "The differentials of ")
        words += [differentials, *refs[0], divided or ",", " and ", *refs[1], *multiplied, ", are"]
    return prose(*words)


def _integrated(constraints: Sequence[ConstraintAnalysis]) -> list[Block]:
    """That the forms are exact, at least where the others hold, and the relations that the kinematic ones are."""
    geometric = [c for c in constraints if c.row.finite is not None]
    kinematic = [c for c in constraints if c.row.finite is None]
    relations = listed(Ref(f"constraint-{c.row.name}") for c in geometric)
    refs = listed(Ref(f"form-{c.row.name}") for c in kinematic or geometric)
    if not kinematic:
        return [prose(*refs, " are ", Emphasis("exact"), ", being the differentials of ", *relations, ".")]
    restricted = [c for c in kinematic if c.exactness.exact is not True]
    where = ("Where ", *relations, plural(len(geometric), " holds, ", " hold, ")) if restricted else ()
    lead: tuple[Part, ...] = (*where, *refs, plural(len(kinematic), " is ", " are "), Emphasis("exact"))
    integrals = [c.integral for c in kinematic if c.integral is not None]
    if len(integrals) == 1 and count_operations(integrals[0]) <= LONGEST_INTEGRATED_RELATION:
        return [prose(*lead, " and integrates to ", math(integrals[0], CONSTANT), ".")]
    lines = (Equation((c.integral, CONSTANT), label=f"integral-{c.row.name}") for c in kinematic if c.integral)
    return [prose(*lead, plural(len(kinematic), " and integrates to", " and integrate to")), display(*lines)]


def _conclusions(classification: Classification) -> list[Prose]:
    freedom = classification.degrees_of_freedom
    timeless = classification.scleronomic is True
    time = prose("So the system is ", Emphasis("holonomic"), *((", and ", Emphasis("scleronomic")) if timeless else ()),
                 ".")  # fmt: skip
    count = f"{classification.coordinates}\u00a0−\u00a0{classification.rank}\u00a0=\u00a0"
    return [
        time,
        *([] if timeless else [explain_time(classification)]),
        prose(f"It has {count}", Emphasis(f"{counted(freedom, 'degree')} of freedom"), "."),
        *explain_one_sided(classification.constraints),
    ]
