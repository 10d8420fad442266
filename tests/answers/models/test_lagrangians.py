"""Mistakes with a given Lagrangian or a potential with velocities: the answers are derived by hand."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import feedback_on

ANGULAR = "r*phi'' + 2*r'*phi' = 0"
LAGRANGIANS = [
    ("relativistic-oscillator", "m*x'' = -k*x", "for an infinite c"),
    ("relativistic-oscillator", "m*x''/sqrt(1 - x'^2/c^2) = -k*x", "for the factor q' alone, as if the other factor"),
    ("relativistic-oscillator", "m*x''/(1 - x'^2/c^2)^(3/2) = k*x", "for L = T + V"),
    ("relativistic-oscillator", "m*x''/(1 - x'^2/c^2)^(3/2) = -2*k*x", "with twice the term `-k*x^2/2`"),
    ("weber-attraction", f"m*(r'' - r*phi'^2) = k/r^2*(1 + r'^2/c^2);{ANGULAR}", "without d/dt of dU/dq'"),
    (
        "weber-attraction",
        f"m*(r'' - r*phi'^2) = k/r^2;{ANGULAR}",
        "without the velocity-dependent part of the potential `weber`",
    ),
    (
        "weber-attraction",
        f"m*(r'' - r*phi'^2) = k/r^2*(1 + r'^2/c^2 + 2*r*r''/c^2);{ANGULAR}",
        "if d/dt of dU/dq' of the potential `weber` is carried out for the velocities alone",
    ),
    ("oscillating-circuit", "L_c*q'' - R*q' + q/C = 0", "for the force `resistor` acting the other way"),
    ("oscillating-circuit", "L_c*q'' + R*q' + 2*q/C = 0", "with twice the term"),
    ("blade-from-a-lagrangian", "phi'' = 0;cos(phi)*x'' + sin(phi)*y'' = 0", "without the term"),
]


@pytest.mark.parametrize(("problem", "stated", "said"), LAGRANGIANS)
def test_the_part_of_the_derivatives_is_named(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
