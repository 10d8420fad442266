"""Stability of positions beside equations of motion."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import answer_to
from lagrange.core.diagnostics import Source
from tests.support.shared import loaded, solved

TUBE = "m r'' = m r Omega^2 - k (r - a)\nH = p_r^2/(2 m) + k (r - a)^2/2 - m r^2 Omega^2/2\n"
PARABOLA = "(1 + 4*c^2*rho^2)*rho'' + 4*c^2*rho*rho'^2 + (2*g*c - Omega^2)*rho = 0\nOmega = sqrt(2*g*c)\n"
POLE = "(M + m)*x'' + m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta) = F - b*x'\n4/3*l*theta'' + x''*cos(theta) - g*sin(theta) = 0\n"
POST = "theta = 0 or cos(theta) = W*l/(c*b^2)\n"


def verdict_on(name: str, text: str) -> str:
    examiner = Examiner(loaded(name), solved(name))
    return examiner.check(answer_to(examiner, Source("answer", text), ".txt")).verdict.value


@pytest.mark.parametrize(
    ("name", "text", "verdict"),
    [
        (
            "bead-in-a-turning-tube",
            f"{TUBE}It rests at r = k a/(k - m Omega^2), which is stable if k > m Omega^2.",
            "equivalent",
        ),
        (
            "bead-in-a-turning-tube",
            f"{TUBE}It rests at r = k a/(k - m Omega^2), which is stable if k < m Omega^2.",
            "wrong",
        ),
        ("bead-in-a-turning-tube", f"{TUBE}For k > m Omega^2 it is stable, for k < m Omega^2 unstable.", "equivalent"),
        ("bead-in-a-turning-tube", f"{TUBE}For k > 11/10 m Omega^2 it is stable, otherwise unstable.", "wrong"),
        ("turning-parabola", f"{PARABOLA}The equilibrium rho = 0 is stable for Omega^2 < 2*g*c.", "equivalent"),
        ("turning-parabola", f"{PARABOLA}The equilibrium rho = 0 is stable for Omega^2 > 2*g*c.", "wrong"),
        ("turning-parabola", f"{PARABOLA}rho = 0 is unstable if Omega^2 < 2*g*c.", "wrong"),
        (
            "pole-on-cart",
            f"{POLE}For F = 0 the equilibrium at theta = 0 is stable because of the resistance b.",
            "wrong",
        ),
        ("pole-on-cart", f"{POLE}For F = 0 the equilibrium at theta = 0 is unstable.", "equivalent"),
        ("pole-on-cart", f"{POLE}theta = 0 is not stable, theta = pi is stable.", "equivalent"),
        ("pole-on-cart", f"{POLE}theta = 0 is unstable, and theta = pi is not stable.", "wrong"),
        ("pole-on-cart", f"{POLE}theta = 0 is stable for small angles only.", "equivalent"),  # and not judged
        ("inverted-pendulum-springs", f"{POST}The inclined positions are stable.", "wrong"),
        (
            "inverted-pendulum-springs",
            f"{POST}The inclined positions exist if W*l < c*b^2, and they are unstable.",
            "equivalent",
        ),
    ],
)
def test_a_false_claim_beside_right_equations(name: str, text: str, verdict: str) -> None:
    assert verdict_on(name, text) == verdict
