"""Wrong frequencies of small oscillations."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import feedback_on
from tests.answers.results.diagnoses import Row, assert_explained, diagnoses

WRONG: list[Row] = [
    ("triatomic-molecule", "frequencies", ["0", "sqrt(2*c/M)"], "that is the frequency of x2 with the other"),
    # the reduced mass of two atoms: one mode is wrong, and no mass is twice as large
    ("triatomic-molecule", "frequencies", ["0", "sqrt(c/m)", "sqrt(c/m*(1 + m/M))"], "half the term 2*c/M is there"),
    ("triatomic-molecule", "frequencies", ["0", "sqrt(2*c/m)", "sqrt(c/m*(1 + 2*m/M))"], "a factor sqrt(2) too many"),
    ("bead-on-rotating-hoop", "frequencies", [["sqrt(g/R)"]], "for a frame or support that does not move"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_frequencies(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


def test_right_frequencies_in_another_list_explain_nothing() -> None:
    stated = [["sqrt(g/R - Omega^2)"], ["sqrt(Omega^2 - g/R)"]]  # the first is right, with -Omega for Omega as well
    _, diagnosis = diagnoses("bead-on-rotating-hoop", {"frequencies": stated})
    assert "Omega with the opposite sign" not in diagnosis


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        (
            "coupled-oscillators",
            "omega_1 = sqrt(c/m), omega_2 = sqrt((c + kappa)/m - b^2/(4*m^2))",
            "the frequency of x1 with the other coordinates held fast",
        ),
    ],
)
def test_damped_oscillations_with_the_others_held_fast(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
