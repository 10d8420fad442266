"""Slips in the virtual work are named: derivatives of constraints, weights and reactions taken elsewhere."""

from __future__ import annotations

import pytest

from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from tests.answers.models.slips import examiner

DIFFERENTIAL = "in the differential of the constraint `rod`, the derivative of"
ALONE = "this balances the component of the weight along it, as if no other reaction had a component"


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        (
            "slider-crank",
            "P*sin(theta)*(x - 2*r*cos(theta)) = -Q*(x - r*cos(theta))",
            f"{DIFFERENTIAL} (x - r*cos(theta))^2 with respect to theta has the wrong sign",
        ),
        ("slider-crank", "P*sin(theta) = Q", f"{DIFFERENTIAL} r^2*sin(theta)^2 with respect to theta is missing"),
        ("rod-on-unequal-planes", "N_A = W*cos(alpha)", ALONE),
        ("lorry-on-a-bridge", "P = B/2 + W*b/l; Q = B/2 + W*(l - b)/l", "with P and Q exchanged"),
        ("support-under-a-beam", "N = W + P + Q; s = (W*l + Q*a)/(W + P + Q)", "acting at an end of `beam`"),
        ("ex16-rod-on-two-planes", "tan(theta) = (1 - 2*k)/tan(alpha)", "with 1 - k in place of k"),
        ("drawbridge", "P = W/2*sin(theta) - Q*sin(theta/2)*diff(f, u)", "sin(theta/2) stands where cos(theta/2)"),
    ],
)
def test_the_slip_is_named(problem: str, stated: str, said: str) -> None:
    judgement = examiner(problem).check(tuple(Fragment.of(e) for e in stated.split(";")))
    assert judgement.verdict is Verdict.WRONG
    assert any(said in e.diagnosis for e in judgement.each), [e.diagnosis for e in judgement.each]
