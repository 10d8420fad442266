"""Mistakes in composed velocities are named: the answers are derived by hand from the wrong models."""

from __future__ import annotations

import pytest

from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, examiner, name_of


@pytest.mark.parametrize("answer", answers_by("composed"), ids=name_of)
def test_the_cause_is_named(answer: WrongAnswer) -> None:
    assert_named(answer)


OFFSET = "without r in the position, and with phi' subtracted from the angular velocity of `yo_yo`"
ABSOLUTE = "for `cylinder` turning according to its absolute velocity, X' included"
AT_RIGHT_ANGLES = "as if the part of the velocity of `half` that comes from x' were at right angles to the rest"


@pytest.mark.parametrize(
    ("problem", "equations", "said"),
    [
        ("rocking-half-cylinder", ["(I_G + m*(R^2 + h^2))*theta'' + m*g*h*sin(theta) = 0"], AT_RIGHT_ANGLES),
        ("rocking-half-cylinder", ["(I_G + m*h^2)*theta'' + m*g*h*sin(theta) = 0"], "without what x' contributes"),
        (
            "cylinder-on-wedge",
            [
                "(M + m)*X'' + m*s''*cos(alpha) + m/2*cos(alpha)*(s'' + X''*cos(alpha)) = 0",
                "3/2*(s'' + X''*cos(alpha)) = g*sin(alpha)",
            ],
            ABSOLUTE,
        ),
        (
            "swinging-yo-yo",
            ["(m + I_G/r^2)*s'' = m*s*phi'^2 + m*g*cos(phi)", "s*phi'' + 2*s'*phi' + g*sin(phi) = 0"],
            OFFSET,
        ),
    ],
)
def test_the_part_of_the_velocity_is_named(problem: str, equations: list[str], said: str) -> None:
    judgement = examiner(problem).check(tuple(map(Fragment.of, equations)))
    assert judgement.verdict is Verdict.WRONG
    assert all(said in e.diagnosis for e in judgement.each)


CHANGED = [
    (
        "turning-parabola",
        ["(1 + 4*c^2*rho^2)*rho'' + 8*c^2*rho*rho'^2 + (2*g*c - Omega^2)*rho = 0"],
        "without what the product rho'^2 in T contributes to dT/dq",
    ),
    (
        "blade-from-a-lagrangian",
        ["x'' = g*cos(phi)^2", "y'' = g*sin(phi)*cos(phi)", "phi'' = 0"],
        "if d/dt of the constraint `blade` is carried out for the velocities alone",
    ),
]


@pytest.mark.parametrize(("problem", "equations", "said"), CHANGED)
def test_a_part_of_a_derivative_is_named(problem: str, equations: list[str], said: str) -> None:
    judgement = examiner(problem).check(tuple(map(Fragment.of, equations)))
    assert any(said in e.diagnosis for e in judgement.each)


def test_a_model_without_the_force_of_the_rod_explains_no_factor_of_it() -> None:
    """With r·r'' = 0 for the rod between two free particles its force vanishes: any factor of it would do."""
    stated = [f"m1*{q}1'' = lambda_rod*({q}1 - {q}2)" for q in "xy"] + ["m1*z1'' = lambda_rod*(z1 - z2) - m1*g"]
    stated += [f"m2*{q}2'' = lambda_rod*({q}1 - {q}2)" for q in "xy"] + ["m2*z2'' = lambda_rod*(z1 - z2) - m2*g"]
    said = [e.diagnosis for e in examiner("ex14-two-particles").check(tuple(map(Fragment.of, stated))).each]
    assert said[:2] == [f"Only half of the reaction of `rod` is there in the equation of {q}1." for q in "xy"]
    assert said[3] == "Only half of the reaction of `rod` is there, with the wrong sign, in the equation of x2."


@pytest.mark.parametrize("axes", ["x", "xy"])
def test_a_square_differentiated_without_its_two(axes: str) -> None:
    """(x1 − x2)² + ... = l² gives 2 λ (x1 − x2); the same equation is that of twice the inertia."""
    stated = (Fragment.of(f"m1*{q}1'' = lambda_rod*({q}1 - {q}2)") for q in axes)
    judgement = examiner("ex14-two-particles").check(tuple(stated))
    assert {e.model for e in judgement.each} == {"square in a constraint differentiated without its 2"}
    assert all("only half of the reaction of `rod`, as if its squares" in e.diagnosis for e in judgement.each)
