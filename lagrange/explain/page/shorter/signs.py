"""Minus signs in front of products that a sum in them takes: W (R − h) for −W (h − R), in formulas and in sentences.

Like terms of frequencies in one: (M + m) g for M g + m g. cot θ for cos θ/sin θ.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import sympy as sp

from lagrange.document.derivation import (
    Block,
    Display,
    Equation,
    Math,
    Mathematics,
    Part,
    Prose,
    Rule,
    Step,
    listed,
    math,
)
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.factors import in_cotangents, with_like_terms, with_signs, with_turned_sum

_AS_COMPUTED = (Rule.CONSTRAINT, Rule.PFAFFIAN_FORM, Rule.INTEGRABILITY, Rule.DISPLACEMENTS)
"""Forms and their coefficients, which tables and mixed derivatives repeat."""


def with_like_terms_in_one(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with frequencies in which terms that differ in a parameter only are one."""
    letters = {p.symbol for p in solution.problem.parameters}

    def side(s: Mathematics) -> Mathematics:
        return with_like_terms(s, letters) if isinstance(s, sp.Expr) and s.atoms(sp.Pow) else s

    for step in steps:
        about = step.rule in (Rule.LINEARIZATION, Rule.RESULT) and not step.folded
        yield step.map(lambda e: replace(e, sides=tuple(map(side, e.sides)))) if about else step


def with_turned_sums(steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with fewer minus signs in front of products, and with cotangents."""
    for step in steps:
        yield step if step.rule in _AS_COMPUTED else replace(step, body=tuple(map(_block, step.body)))


def _block(b: Block) -> Block:
    if isinstance(b, Display):
        return b.map(lambda e: _with_signs(replace(e, sides=tuple(map(_side, e.sides)))))
    return replace(b, parts=tuple(map(_part, b.parts))) if isinstance(b, Prose) else b


def _with_signs(e: Equation) -> Equation:
    """N = m sgn(cos s) (...), where cos s ≠ 0."""
    pairs = [with_signs(s) if isinstance(s, sp.Expr) else (s, ()) for s in e.sides]
    nonzero = [x for _, signs in pairs for x in signs]
    if not nonzero:
        return e
    where = ("where ", *listed(math(x, sp.S.Zero, relation="≠") for x in nonzero))
    return replace(e, sides=tuple(s for s, _ in pairs), condition=e.condition or where)


def _part(p: Part) -> Part:
    return replace(p, sides=tuple(map(_side, p.sides))) if isinstance(p, Math) else p


def _side(side: Mathematics) -> Mathematics:
    return with_turned_sum(in_cotangents(side)) if isinstance(side, sp.Expr) else side
