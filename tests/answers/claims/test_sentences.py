"""Sentences and the relations in them."""

from __future__ import annotations

import pytest

from lagrange.answers.claims.sentences import sentences
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Source
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("text", "equations", "inequalities"),
    [
        (
            "The equilibrium rho = 0 is stable for Omega^2 > 2*g*c and unstable for Omega^2 < 2*g*c.",
            ["rho = 0"],
            ["Omega^2 > 2*g*c", "Omega^2 < 2*g*c"],
        ),
        (r"At rest $\rho = 0$, which is stable if $\Omega^2 < 2gc$.", [r"\rho = 0"], [r"\Omega^2 < 2gc"]),
        ("It rests at rho = 0 or,\nif Omega^2 = 2 g c, anywhere.", ["rho = 0", "Omega^2 = 2 g c"], []),
        ("If mu < 2 it tips (for g > 0).", [], ["mu < 2", "g > 0"]),
        ("no relation here", [], []),
    ],
)
def test_relations_end_at_words(text: str, equations: list[str], inequalities: list[str]) -> None:
    scope = reference_of_solution(solved("turning-parabola")).scope
    [sentence] = sentences([Source("answer", text)], scope)
    assert [r.text for r in sentence.equations] == equations
    assert [r.text for r in sentence.inequalities] == inequalities


def test_sentences_end_at_full_stops_and_lines() -> None:
    scope = reference_of_solution(solved("turning-parabola")).scope
    text = "rho = 0. It is stable.\nz = c rho^2; F = 0\nif rho' = 0"
    shown = [s.shown for s in sentences([Source("answer", text)], scope)]
    assert shown == ["rho = 0", "It is stable", "z = c rho^2", "F = 0 if rho' = 0"]


def test_what_is_positive_where_an_inequality_holds() -> None:
    reference = reference_of_solution(solved("turning-parabola"))
    [sentence] = sentences([Source("answer", "stable if Omega^2 < 2*g*c")], reference.scope)
    p = reference.parameters
    [relation] = sentence.inequalities
    assert relation.positive(reference.scope) == 2 * p["g"] * p["c"] - p["Omega"] ** 2
