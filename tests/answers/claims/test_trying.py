"""Claims at random values of the parameters."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.claims.trying import Outcome, agree
from tests.support.shared import solved

a, b = sp.symbols("a b", positive=True)


@pytest.mark.parametrize(
    ("condition", "outcome"),
    [
        (2 * a - b, Outcome.TRUE),
        (a - b / 2, Outcome.TRUE),
        (b - 2 * a, Outcome.FALSE),
        (2.1 * a - b, Outcome.SOMETIMES),
        (201 * a - 100 * b, Outcome.SOMETIMES),
    ],
)
def test_a_condition_is_tried_beside_its_limit(condition: sp.Expr, outcome: Outcome) -> None:
    assert agree([condition], 2 * a - b, solved("inverted-pendulum-springs")) is outcome
