"""Forces under names of their own in the working of conditions of rest."""

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ("N = W; H = W/2*tan(theta_1); H <= mu*N", "equivalent"),
        ("N = W; 2*N*l*sin(theta_1) = W*l*sin(theta_1) + 2*H*l*cos(theta_1); H <= mu*N", "equivalent"),
        ("N = 2*W; 2*N*l*sin(theta_1) = W*l*sin(theta_1) + 2*H*l*cos(theta_1); H <= mu*N", "wrong"),
        ("2*N*l*sin(theta_1) = 2*H*l*cos(theta_1), H <= mu*N, so tan(theta_1) <= mu", "wrong"),
        ("theta_1 = theta_2; tan(theta_1) <= 2*mu", "equivalent"),
    ],
)
def test_forces_are_eliminated(stated: str, verdict: str) -> None:
    examiner = Examiner(loaded("step-ladder"), solved("step-ladder"))
    assert examiner.check(tuple(map(Fragment.of, stated.split(";")))).verdict.value == verdict
