"""Wrong amplitudes of a steady state."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import feedback_on
from tests.answers.results.diagnoses import Row, assert_explained

ABSORBER = "dynamic-absorber"
SWAPPED = "((c_1 + c_2 - m_2*w^2)*(c_2 - m_1*w^2) - c_2^2)"
WHOLE = "((c_1 + c_2 - m_1*w^2)*(c_2 - m_2*w^2) - c_2^2)"

WRONG: list[Row] = [
    (ABSORBER, "response", {"x": f"F*c_2/{WHOLE}", "y": f"F*(c_2 - m_2*w^2)/{WHOLE}"}, "x and y are exchanged"),
    (ABSORBER, "response", {"x": f"F*(c_2 - m_1*w^2)/{SWAPPED}", "y": f"F*c_2/{SWAPPED}"}, "m_1 and m_2 exchanged"),
    (ABSORBER, "response", {"x": "F/(c_1 - m_1*w^2)"}, "without what couples x with y in the equation of x"),
    (ABSORBER, "response", {"y": f"F*(c_1 + c_2 - m_1*w^2)/{WHOLE}"}, "a drive that acts on y and not on x"),
    ("damped-oscillator", "response", {"x": "F/(b*w)"}, "at resonance"),
    ("shaken-support", "response", {"x": "a*m*w^2/sqrt((c - m*w^2)^2 + b^2*w^2)"}, "relative to the support"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_amplitudes(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        ("damped-oscillator", "x = F/(c - m*w^2 + b*w)", "are added as if they had one phase"),
        ("damped-oscillator", "x = F/sqrt((c - m*w^2)^2 - b^2*w^2)", "the sign of (b*w)^2 under the root is wrong"),
    ],
)
def test_what_is_not_in_phase(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
