"""Wrong limits of a rope on a drum: the slips with the logarithm, worked out from T = S exp(mu beta) each."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.results.belts import belt_meanings, in_logarithms
from lagrange.answers.results.conditions import StatedCondition, explained_conditions

MU = sp.Symbol("mu", positive=True)
S, P, BETA = sp.symbols("S P beta", positive=True)
EXACT = P * sp.exp(MU * BETA) - S


@pytest.mark.parametrize(
    ("limit", "said"),
    [
        (sp.log(S / P) / (BETA * sp.log(10)), "base ten"),
        (sp.log(S / P) / (BETA * 180 / sp.pi), "in degrees"),
        (2 * sp.pi * sp.log(S / P) / BETA, "number of turns"),
        (sp.log(S / P) / (2 * BETA), "twice the angle"),
        (2 * sp.log(S / P) / BETA, "half of the angle"),
        ((S / P - 1) / BETA, "1 + mu*beta"),
    ],
)
def test_slips_with_the_logarithm_are_named(limit: sp.Expr, said: str) -> None:
    for right in (EXACT, MU - sp.log(S / P) / BETA):
        assert said in explained_conditions([StatedCondition("", MU - limit, False)], [right], [MU])


def test_the_exponential_is_solved_for_the_coefficient() -> None:
    assert in_logarithms(EXACT) == MU * BETA - sp.log(S / P)
    assert in_logarithms(S - P) == S - P
    assert not [*belt_meanings([S - MU * P], [MU])]
