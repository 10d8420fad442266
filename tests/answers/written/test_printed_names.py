"""Short names of reactions in an answer."""

from __future__ import annotations

import pytest

from lagrange.answers.written.printed_names import lines_with, may_be_force, printed_names, spelled_out
from tests.support.shared import reference_of


def test_the_reaction_of_the_rod_is_t() -> None:
    assert {short: symbol.name for short, symbol in printed_names(reference_of("ex11-ideal-pendulum")).items()} == {
        "T": "T_rod",
        "lambda": "lambda_rod",
    }


def test_a_name_by_itself() -> None:
    assert lines_with("T", ["T = m g", "T_rod = 0", "mT", "2 T + 1"]) == [0, 3]
    assert lines_with("theta", [r"\\theta = 0", "θ = 0", "theta_1 = 0"]) == [0, 1]
    assert spelled_out("θ₁") == " theta_1"


@pytest.mark.parametrize(
    ("texts", "force"), [(["L = T - V"], False), (["the period is T"], False), (["T = m g"], True)]
)
def test_beside_energies_and_periods_t_is_no_force(texts: list[str], force: bool) -> None:
    assert may_be_force("T", None, texts, reference_of("ex11-ideal-pendulum")) is force
