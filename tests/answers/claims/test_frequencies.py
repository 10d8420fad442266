"""Frequencies of small oscillations that the file does not ask for."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import answer_to
from lagrange.core.diagnostics import Source
from tests.support.shared import loaded, solved

ROLLER = "3/2*(R - r)*phi'' + g*sin(phi) = 0\n"
SPRING = "m r'' = m r phi'^2 - c (r - l) + m g cos(phi)\nr phi'' + 2 r' phi' = -g sin(phi)\n"


def verdict_on(name: str, text: str) -> str:
    examiner = Examiner(loaded(name), solved(name))
    return examiner.check(answer_to(examiner, Source("answer", text), ".txt")).verdict.value


@pytest.mark.parametrize(
    ("name", "text", "verdict"),
    [
        (
            "cylinder-in-cylinder",
            f"{ROLLER}For small phi it oscillates with omega_0 = sqrt(2*g/(3*(R - r))).",
            "equivalent",
        ),
        ("cylinder-in-cylinder", f"{ROLLER}For small phi it oscillates with omega_0 = sqrt(3*g/(2*(R - r))).", "wrong"),
        (
            "cylinder-in-cylinder",
            f"{ROLLER}The period of small oscillations is T = 2*pi*sqrt(3*(R - r)/(2*g)).",
            "equivalent",
        ),
        ("cylinder-in-cylinder", f"{ROLLER}The period of small oscillations is T = 2*pi*sqrt((R - r)/g).", "wrong"),
        (
            "cylinder-in-cylinder",
            f"{ROLLER}A simple pendulum of this length oscillates with omega_0 = sqrt(g/(R - r)).",
            "equivalent",
        ),
        (
            "spring-pendulum",
            f"{SPRING}The frequencies of small oscillations are omega_1 = sqrt(c/m) and omega_2 = sqrt(g/(l + m g/c)).",
            "equivalent",
        ),
        (
            "spring-pendulum",
            f"{SPRING}The frequencies of small oscillations are omega_1 = sqrt(c/m) and omega_2 = sqrt(g/l).",
            "wrong",
        ),
    ],
)
def test_a_wrong_frequency_beside_right_equations(name: str, text: str, verdict: str) -> None:
    assert verdict_on(name, text) == verdict
