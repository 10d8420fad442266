"""Wrong accelerations at the start that follow from a wrong force beside them."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved

CUT = "rod-cut-loose"
FOLLOWS = "which is wrong, it follows from the equations of motion"


def diagnoses(*lines: str) -> list[str]:
    judged = Examiner(loaded(CUT), solved(CUT)).check(tuple(map(Fragment.of, lines)))
    return [e.diagnosis for a in judged.others for e in a.equations]


@pytest.mark.parametrize(("force", "turning", "falling"), [("m*g/2", "-3*g/l", "-g/2"), ("m*g", "-6*g/l", "0")])
def test_accelerations_that_follow_from_a_wrong_force(force: str, turning: str, falling: str) -> None:
    """m y'' = T - m g, and m l^2/12 theta'' = -T l/2."""
    own, *others = diagnoses(f"tension = {force}", f"turning = {turning}", f"falling = {falling}")
    assert own.startswith("what is stated beside it follows from it")
    assert all(FOLLOWS in said for said in others)


def test_an_acceleration_that_does_not_follow_is_not_said_to() -> None:
    assert not any(FOLLOWS in said for said in diagnoses("tension = m*g/2", "turning = -2*g/l"))


def test_a_force_that_is_left_out_has_one_cause() -> None:
    assert diagnoses("tension = 0", "falling = -g") == [
        "the force of the constraint is missing: it is not zero there",
        "this is the acceleration without the forces of the constraints, as if it moved freely",
    ]
    assert diagnoses("falling = 0", "turning = -3*g/(2*l)")[0] == "it is taken not to be accelerated there, and it is"


def test_an_acceleration_beside_a_wrong_force_may_be_wrong_by_a_factor() -> None:
    """m l^2/12 theta'' = -T l for -T l/2: what reproduces one of the values alone is no cause of the three."""
    own, turning, falling = diagnoses("tension = m*g/7", "turning = -12*g/(7*l)", "falling = -6*g/7")
    assert own == ""
    assert turning == "with T = m*g/7, which is wrong, the equations of motion give 1/2 times this value"
    assert FOLLOWS in falling
