"""One of two lengths that make up a distance is named: the answers are derived by hand with it throughout."""

from __future__ import annotations

import pytest

from lagrange.answers.models.lengths import one_of_two_lengths
from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, feedback_on, name_of
from tests.support.shared import reference_of


@pytest.mark.parametrize("answer", answers_by("lengths"), ids=name_of)
def test_the_cause_is_named(answer: WrongAnswer) -> None:
    assert_named(answer)


DISTANCES = [
    ("cylinder-in-cylinder", "3/2*R*phi'' + g*sin(phi) = 0", "with R in place of R - r throughout"),
    ("cylinder-in-cylinder", "3/2*r*phi'' + g*sin(phi) = 0", "with r in place of R - r throughout"),
    ("hoop-off-a-cylinder", "2*R*theta'' = g*sin(theta)", "with R in place of a + R throughout"),
    ("hoop-off-a-cylinder", "2*a*theta'' = g*sin(theta)", "with a in place of a + R throughout"),
]


@pytest.mark.parametrize(("problem", "stated", "said"), DISTANCES)
def test_the_length_that_stands_for_a_sum_is_named(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)


@pytest.mark.parametrize("problem", ["swinging-atwood", "planetary-gear"])
def test_a_sum_of_masses_is_no_distance_and_constraints_keep_theirs(problem: str) -> None:
    for c in reference_of(problem).candidates:
        if c.models.mechanics is not None:
            assert [*one_of_two_lengths(c.models.mechanics)] == []
