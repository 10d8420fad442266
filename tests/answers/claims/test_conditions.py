"""What happens under a condition."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import answer_to
from lagrange.core.diagnostics import Source
from tests.support.shared import loaded, solved

HOOP = "x'' = g*sin(alpha)/2, F = -m*g*sin(alpha)/2, N = m*g*cos(alpha)\n"
WEDGE = "(M + m) X'' + m s'' cos(alpha) = 0\ns'' + X'' cos(alpha) = g sin(alpha) - mu (g cos(alpha) + X'' sin(alpha))\n"
CRATE = "no sliding: P <= mu*W\nno tipping: P*h <= W*b\n"
BALL = "x'' = -mu g\nR theta'' = 5/2 mu g\nRolling begins at t = 2 (v + R w)/(7 mu g)\nwith the speed x' = (5 v - 2 R w)/7\n"
CONE = (
    "l*theta'' - l*phi'^2*sin(theta)*cos(theta) + g*sin(theta) = 0\nphi''*sin(theta) + 2*theta'*phi'*cos(theta) = 0\n"
)
SLEDGE = (
    "x'' = -g*sin(alpha) - mu*g*cos(alpha)\ndistance: v^2/(2*g*(sin(alpha) + mu*cos(alpha)))\n"
    "time: v/(g*(sin(alpha) + mu*cos(alpha)))\nroughness: v^2/(2*g*s*cos(alpha)) - tan(alpha)\n"
)
HILL = "(a^2 + x^2)*x'' + x*x'^2 = a*g*x\npressure: m*(g - v^2/a)\nfastest: sqrt(g*a)\n"
ROLLER = "(M + m)*X'' + m*s''*cos(alpha) = 0\n3/2*s'' + X''*cos(alpha) = g*sin(alpha)\n"
ATWOOD = "(M + m) r'' = m r theta'^2 + g (m cos(theta) - M)\nr theta'' + 2 r' theta' + g sin(theta) = 0\n"


def verdict_on(name: str, text: str) -> str:
    examiner = Examiner(loaded(name), solved(name))
    return examiner.check(answer_to(examiner, Source("answer", text), ".txt")).verdict.value


@pytest.mark.parametrize(
    ("name", "text", "verdict"),
    [
        (
            "hoop-on-incline",
            f"{HOOP}It does not slip if mu >= tan(alpha)/2, where mu is the coefficient of friction.",
            "equivalent",
        ),
        ("hoop-on-incline", f"{HOOP}It does not slip if mu >= tan(alpha).", "wrong"),
        ("hoop-on-incline", f"{HOOP}It slips if mu < tan(alpha)/2.", "equivalent"),
        ("hoop-on-incline", f"{HOOP}It slips if mu > tan(alpha)/2.", "wrong"),
        ("rough-wedge", f"{WEDGE}The block begins to slide down only if tan(alpha) > mu.", "equivalent"),
        ("rough-wedge", f"{WEDGE}The block begins to slide down only if tan(alpha) > mu (1 + m/M).", "wrong"),
        ("rough-wedge", f"{WEDGE}The block does not slide if tan(alpha) > mu.", "wrong"),
        ("crate-tips-or-slides", f"{CRATE}If mu > b/h it tips before it slides.", "equivalent"),
        ("crate-tips-or-slides", f"{CRATE}If mu < b/h it tips before it slides.", "wrong"),
        ("crate-tips-or-slides", f"{CRATE}It slides first if mu < b/h.", "equivalent"),
        ("ball-with-backspin", f"{BALL}The ball comes back if R w > 5/2 v.", "equivalent"),
        ("ball-with-backspin", f"{BALL}The ball comes back if R w > 2/5 v.", "wrong"),
        ("ball-with-backspin", f"{BALL}The ball does not come back if R w < 5/2 v.", "equivalent"),
        ("conical-pendulum", f"{CONE}cos(theta) = g/(l*phi'^2), which is only possible if phi'^2 > g/l.", "equivalent"),
        ("conical-pendulum", f"{CONE}cos(theta) = g/(l*phi'^2), which is only possible if phi'^2 < g/l.", "wrong"),
        ("sledge-up-a-slope", f"{SLEDGE}It stays at rest at the top if mu >= tan(alpha).", "equivalent"),
        ("sledge-up-a-slope", f"{SLEDGE}It stays at rest at the top if mu <= tan(alpha).", "wrong"),
        ("crest-of-a-hill", f"{HILL}It stays on the road only if v^2 < g*a.", "equivalent"),
        ("crest-of-a-hill", f"{HILL}It stays on the road only if v^2 > g*a.", "wrong"),
        ("cylinder-on-wedge", f"{ROLLER}It has s'' > 0 at all times.", "equivalent"),
        ("cylinder-on-wedge", f"{ROLLER}It has s'' < 0 at all times.", "wrong"),
        ("swinging-atwood", f"{ATWOOD}If M > m then r'' < 0 at all times.", "wrong"),
        ("swinging-atwood", f"{ATWOOD}If M > m then r'' < g + r theta'^2 at all times.", "equivalent"),
        ("swinging-atwood", f"{ATWOOD}At the start r'' < 0 if M > m.", "equivalent"),  # and not judged
    ],
)
def test_a_false_condition_beside_right_equations(name: str, text: str, verdict: str) -> None:
    assert verdict_on(name, text) == verdict
