"""The integrating factor of a form that is not exact: the multiplied form, its equal pairs, the finite relation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.forms.integrability import Comparison
from lagrange.core.symbols import CONSTANT, Partial, differential
from lagrange.document.derivation import Block, Detail, Equation, Part, Prose, display, listed, math, prose
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis

if TYPE_CHECKING:
    from lagrange.algebra.forms.restrictions import FiniteForm, Restriction

SHOWN_PAIRS = 3


def equal(p: Comparison) -> Part:
    """∂a/∂r = ... = ∂b/∂q."""
    (q, r), (a, b), (left, _) = p.variables, p.coefficients, p.derivatives
    return math(Partial(a, r), left, Partial(b, q))


def explain_factor(c: ConstraintAnalysis) -> list[Block]:
    """What was found for an integrable form that is not exact."""
    form = c.finite_form
    if form is None:
        where = "the products of powers, functions of one variable and symmetries that were tried"
        return [prose(f"A factor exists but was not found: it is not among {where}.")]
    body = [] if form.restriction is None else _explain_restriction(form.restriction)
    body += _explain_multiplied(form)
    if c.integral is None:
        return [*body, prose("The finite form was not found in closed form.")]
    finite = Equation((c.integral, CONSTANT), label=f"integral-{c.row.name}")
    return [*body, prose("The constraint is the finite relation"), display(finite), _moral(form)]


def _explain_restriction(there: Restriction) -> list[Block]:
    """What was put in, and the form that comes out."""
    rules = listed(math(q, e) for q, e in there.rules)
    angles = listed(math(a.symbol) for a in there.angles)
    with_angles: tuple[Part, ...] = (", with an angle " if len(there.angles) == 1 else ", with angles ", *angles)
    named = with_angles if there.angles else ()
    return [prose("There ", *rules, *named, ", and the form becomes"), _shown(there.form, there.variables)]


def _explain_multiplied(form: FiniteForm) -> list[Block]:
    """The multiplied form and its pairs; pairs of zeros are left out."""
    found = form.found
    telling = [p for p in found.exactness.comparisons if p.derivatives != (0, 0)]
    more = [prose(equal(p), detail=Detail.FULL) for p in telling[SHOWN_PAIRS:]]
    pairs = [*(prose(equal(p)) for p in telling[:SHOWN_PAIRS]), *more]
    if found.factor == 1:
        return [prose("Its partial derivatives agree in pairs", ":" if pairs else "."), *pairs]
    words = prose("An integrating factor is ", math(found.factor), ". The form multiplied by it is")
    agree = prose("and now all pairs of partial derivatives agree", ":" if pairs else ", being zero.")
    return [words, _shown(found.form, found.variables), agree, *pairs]


def _moral(form: FiniteForm) -> Prose:
    """Where the factor is valid, and what is to be learnt."""
    found = form.found
    conditions: list[Part] = [math(g, sp.S.Zero, relation="≠") for g in found.nonzero]
    conditions += [math(g, sp.S.Zero, relation=">") for g in found.positive]
    valid: tuple[Part, ...] = (" where ", *listed(conditions)) if conditions else ()
    if found.factor == 1:
        return prose("Not exact is not the same as not integrable.")
    return prose("The factor is valid", *(valid or (" everywhere",)), ". Not exact is not the same as not integrable.")


def _shown(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol]) -> Block:
    terms = (a * differential(v) for a, v in zip(form, variables, strict=True))
    return display(Equation((sp.Add(*terms), sp.S.Zero)))
