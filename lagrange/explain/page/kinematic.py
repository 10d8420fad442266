"""Geometric constraints beside kinematic ones: their forms without common factors, here as where they stand alone.

Forms and their partial derivatives are those of the full derivation, divided by the whole number that their
coefficients have in common; so is Frobenius' product, once for each form in it.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.symbols import Slots, variation
from lagrange.document.builders import listed, math, prose
from lagrange.document.derivation import Detail, Display, Equation, Prose, Step
from lagrange.explain.constraints import explain_forms, explain_integrability
from lagrange.explain.displacements import explain_displacements
from lagrange.explain.page.constraints import common_number, halved
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.results import Solution


def with_short_forms(classification: Classification) -> Classification | None:
    """The classification with the geometric forms without common factors.

    None where no geometric form has a common factor, or where other forms are written as combinations of them.
    """
    numbers = {c.row.name: common_number(c.row) for c in classification.constraints if c.row.finite is not None}
    if all(n == 1 for n in numbers.values()) or classification.hidden.found or classification.redundancies:
        return None
    product = sp.Mul(*numbers.values())
    constraints = tuple(_divided(c, numbers.get(c.row.name, sp.S.One), product) for c in classification.constraints)
    return replace(classification, constraints=constraints)


def _divided(c: ConstraintAnalysis, number: sp.Integer, product: sp.Expr) -> ConstraintAnalysis:
    if c.row.finite is None:
        parts = (replace(k, coefficient=textbook_form(k.coefficient / product)) for k in c.frobenius)
        return replace(c, frobenius=tuple(parts))
    pairs = (
        replace(
            p,
            coefficients=tuple(a / number for a in p.coefficients),
            derivatives=tuple(a / number for a in p.derivatives),
        )
        for p in c.exactness.comparisons
    )
    return replace(c, row=halved(c.row), exactness=replace(c.exactness, comparisons=tuple(pairs)))


def explain_short_forms(short: Classification, slots: Slots) -> Step:
    """The forms."""
    step = explain_forms(short, slots)
    first = step.body[0]
    assert isinstance(first, Prose)
    at = next(n for n, p in enumerate(first.parts) if isinstance(p, str) and p.startswith((", and", " is", " are")))
    parts = (*first.parts[:at], ", without common factors", *first.parts[at:])
    return replace(step, body=(replace(first, parts=parts), *step.body[1:]))


def explain_short_integrability(solution: Solution, short: Classification) -> Step:
    """Which of the forms are integrable."""
    return explain_integrability(
        short, solution.problem.slots, {*solution.problem.scope.names(), *solution.problem.scope.vectors}
    )


def explain_short_displacements(solution: Solution) -> Step:
    """The displacements, those that are zero put into the other conditions; no solution that is too long to be read."""
    own = solution.own
    rows = tuple(halved(r) if r.finite is not None else r for r in own.configuration.rows)
    configuration = replace(own.configuration, constrained=replace(own.configuration.constrained, rows=rows))
    known = tuple(n for n in solution.normals if not _is_one_coordinate(n.row))
    step = explain_displacements(configuration, own.elimination, solution.transport_rates, known)
    zero = {variation(q): sp.S.Zero for r in rows if _is_one_coordinate(r) for q in _only(r, solution.problem.slots)}
    body = [_with(zero, b) if isinstance(b, Display) else b for b in step.body]
    long = [n for n, b in enumerate(body) if isinstance(b, Display) and b.detail is Detail.FULL]
    for n in long:
        free = listed(math(variation(solution.problem.slots.coordinates[k])) for k in own.elimination.independent)
        body[n - 1 : n + 2] = [
            prose(
                "As many displacements as there are conditions depend on the others, for instance all but ", *free, "."
            )
        ]
    return replace(step, body=tuple(body))


def _with(zero: dict[sp.Symbol, sp.Expr], block: Display) -> Display:
    """Equations between displacements, with those put in that are zero; those that say it stay."""
    return replace(block, equations=tuple(_simpler(zero, e) for e in block.equations))


def _simpler(zero: dict[sp.Symbol, sp.Expr], e: Equation) -> Equation:
    left, *right = e.sides
    if not (e.label or "").startswith("virtual-") or left in zero or not isinstance(left, sp.Expr):
        return e
    return replace(e, sides=(left.xreplace(zero), *right))


def _is_one_coordinate(row: Row) -> bool:
    """Whether a form is dq = 0 for one coordinate."""
    nonzero = [a for a in row.coefficients if a != 0]
    return len(nonzero) == 1 and bool(nonzero[0].is_number) and row.drift == 0


def _only(row: Row, slots: Slots) -> list[sp.Symbol]:
    return [q for q, a in zip(slots.coordinates, row.coefficients, strict=True) if a != 0]
