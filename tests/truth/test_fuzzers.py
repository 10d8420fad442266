"""A bounded run of the fuzzers; `python -m tests.support.fuzzers` runs any number."""

from __future__ import annotations

import pytest

from tests.support.fuzzers.kinds import KINDS

NUMBERS = {
    "problems": 40,
    "grammar": 12,
    "parts": 12,
    "simulations": 6,
    "files": 40,
    "texts": 100,
    "answers": 60,
    "replies": 12,
    "submissions": 40,
    "journals": 60,
}


@pytest.mark.parametrize(("kind", "seed"), [(kind, seed) for kind, number in NUMBERS.items() for seed in range(number)])
def test_a_broken_input_ends_in_a_result_or_a_message(kind: str, seed: int) -> None:
    """Any exception but the project's own would leave the call."""
    assert KINDS[kind](seed)


@pytest.mark.parametrize(
    "seed",
    [
        pytest.param(1717, id="an equation without an equals sign, rewritten, is marked at its end"),
    ],
)
def test_faults_found_before(seed: int) -> None:
    assert KINDS["answers"](seed) == "unreadable"


def test_a_run_of_letters_before_an_equation_is_one_word() -> None:
    """Eighty letters can be split into eight words in so many ways that a search for them took hours."""
    assert KINDS["submissions"](5000442) == "unreadable"
