"""A bound has what it is about on the left."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import CONSTANT
from lagrange.document.builders import display
from lagrange.document.derivation import Equation, Rule, Step
from lagrange.explain.page.shorter.relations import with_symbol_first

mu, alpha, P = sp.symbols("mu alpha P", positive=True)


def turned(e: Equation, rule: Rule) -> Equation:
    [step] = with_symbol_first([Step(rule, "", (display(e, boxed=True),))])
    [box] = step.body
    [line] = box.equations  # type: ignore[union-attr]
    return line


def test_a_bound_is_turned_round() -> None:
    bound = Equation((sp.tan(alpha) / 3, mu), relation="≤")
    for rule in (Rule.RESULT, Rule.FRICTION_AT_REST):
        assert turned(bound, rule) == Equation((mu, sp.tan(alpha) / 3), relation="≥")
    assert turned(bound, Rule.MEANING) == bound


def test_what_stands_well_stays() -> None:
    for e in (
        Equation((mu, sp.tan(alpha)), relation="≤"),
        Equation((mu * P, P), relation="≤"),  # P is on both sides
        Equation((sp.tan(alpha), 2 * mu), relation="≤"),
    ):
        assert turned(e, Rule.FRICTION_AT_REST) == e
    relation = Equation((mu + P, CONSTANT))
    assert turned(relation, Rule.RESULT) == relation  # f(x) = const at the head


def test_an_answer_in_factors() -> None:
    value = (mu * P * alpha + mu * P) / (P**2 * alpha + P * mu)
    line = turned(Equation((alpha, value)), Rule.QUESTION)
    assert line.sides[1] == mu * P * (alpha + 1) / (P * (P * alpha + mu))
    roots = Equation((alpha, (sp.sqrt(mu + P) + P) / (P + mu)))
    assert turned(roots, Rule.QUESTION) == roots
