"""A force of a constraint that belongs to another situation, in an equation of motion: derived by hand."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import feedback_on

DOWN = "3/2*s'' + X''*cos(alpha) = g*sin(alpha)"
WITHOUT = (
    "it is right with the reaction of `contact` taken as at rest, m*g*cos(alpha) and the reaction of `rolling` left out"
)


@pytest.mark.parametrize(
    ("stated", "named"),
    [
        (f"M*X'' = -m*g*sin(alpha)*cos(alpha);{DOWN}", True),
        (f"M*X'' = m*g*sin(alpha)*cos(alpha);{DOWN}", False),
        (f"M*X'' = -m*g*sin(alpha);{DOWN}", False),
    ],
)
def test_a_normal_force_as_at_rest_is_named(stated: str, named: bool) -> None:
    assert (WITHOUT in " ".join(feedback_on("cylinder-on-wedge", stated).split())) is named
