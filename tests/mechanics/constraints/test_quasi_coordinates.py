"""Quasi-coordinates: a constraint with α' of ω = α' i + β' j + γ' k is judged by how the body is turned."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from lagrange.document.derivation import Detail
from lagrange.explain.report import report
from lagrange.mechanics.constraints.classification import Classification, classify
from lagrange.mechanics.constraints.quasi_coordinates import quasi_coordinates
from lagrange.problem.model import Problem
from lagrange.render import latex

Read = Callable[[str], Problem]

BALL = """
title: A ball on a plane
parameters: [m, R, I]
coordinates: [x, y, alpha, beta, gamma]
bodies:
  ball: {mass: m, inertia: [I, I, I], position: x*i + y*j + R*k, axes: [i, j, k],
         angular_velocity: "alpha'*i + beta'*j + gamma'*k"}
constraints:
"""
ROLLING = '  rolling: "r_ball\' + cross(omega_ball, -R*k) = 0"\n'
EULER = """
title: The same ball with angles
parameters: [m, R, I]
coordinates: [x, y, phi, theta, psi]
bodies:
  ball: {mass: m, inertia: [I, I, I], position: x*i + y*j + R*k, orientation: {axes: 313, angles: [phi, theta, psi]}}
constraints:
"""


def ranks(c: Classification) -> tuple[int, int | None, bool | None]:
    return c.rank, c.integrable_rank, c.holonomic


@pytest.mark.parametrize(
    ("constraints", "rank", "integrable"),
    [
        (ROLLING, 2, 0),
        (ROLLING + '  no_pivot: "dot(omega_ball, k) = 0"\n', 3, 0),
        ('  spin: "dot(omega_ball, i) = dot(omega_ball, j)"\n', 1, 0),
        ('  still: "omega_ball = 0"\n', 3, 3),
        (ROLLING + '  groove: "y\' = 0"\n', 3, 1),
    ],
)
def test_a_ball_is_classified_as_with_angles(problem: Read, constraints: str, rank: int, integrable: int) -> None:
    """A rolling ball can be brought to any place, turned in any way: it is nonholonomic."""
    quasi, angles = (classify(problem(text + constraints)) for text in (BALL, EULER))
    assert ranks(quasi) == ranks(angles) == (rank, integrable, rank == integrable)
    if integrable < rank:  # ω = 0 has its components along other axes in the other file
        assert [c.integrable for c in quasi.constraints] == [c.integrable for c in angles.constraints]
    assert not any(q.name in str(c.integral) for c in quasi.constraints for q in c.quasi)


def test_what_is_said_and_checked(problem: Read) -> None:
    found = report(problem(BALL + ROLLING))
    assert found.holds
    assert "is exact" not in latex.render([(found.derivation, found.notation)])
    text = latex.render([(found.derivation, found.notation)], detail=Detail.FULL)
    assert "a quasi-coordinate: the time integral of a component of an angular velocity, which determines no" in text
    complete = latex.render([(found.derivation, found.notation)], detail=Detail.FULL)
    assert "is exact" not in complete
    assert "Frobenius' condition fails for the rolling 1 constraint" in complete


@pytest.mark.parametrize(
    ("spin", "constraints", "rank", "integrable", "reachable"),
    [
        ("alpha'*i + beta'*j", ROLLING, 2, 0, 5),
        ("beta'*j + alpha'*k", ROLLING, 2, 1, 4),  # y' = 0
        ("alpha'*(i + k) + beta'*(j - k)", ROLLING, 2, 0, 5),
        ("alpha'*i + beta'*j", '  turned: "alpha\' = 0"\n', 1, 1, 3),
        ("alpha'*i + beta'*j", "  turned: \"alpha' = 2*beta'\"\n", 1, 1, 3),
        ("alpha'*i + beta'*j", "  turned: \"alpha' = y*beta'\"\n", 1, 0, 5),
        ("alpha'*i + beta'*j", '  line: "x = y"\n', 1, 1, 4),
        ("alpha'*i + beta'*j", ROLLING + '  groove: "y\' = 0"\n', 3, 3, 1),
        ("alpha'*i + beta'*j", ROLLING + '  groove: "y = x"\n', 3, 3, 1),
        ("alpha'*i + beta'*j", ROLLING + '  groove: "y = x^2"\n', 3, 3, 1),
        ("alpha'*(cos(x)*i + sin(x)*j)", '  driven: "alpha\' = x\'"\n  line: "y\' = 0"\n', 2, 2, 1),
        ("alpha'*(cos(x)*i + sin(x)*j)", "  driven: \"alpha' = y'\"\n", 1, 0, 5),
    ],
)
def test_fewer_than_three_restrict_the_rotation(
    problem: Read, spin: str, constraints: str, rank: int, integrable: int, reachable: int
) -> None:
    """Compared with ranks found by hand, in three angles with the constraints that the angular velocity states.

    With one component of ω zero, a rolling ball still reaches every place and orientation (Chow): 2 + 3 dimensions.
    """
    text = BALL.replace("alpha'*i + beta'*j + gamma'*k", spin).replace(", gamma", "")
    text = text if "beta" in spin else text.replace(", beta", "")
    found = classify(problem(text + constraints))
    assert ranks(found) == (rank, integrable, rank == integrable)
    if found.further_angles:
        assert found.reachable_dimension == reachable
    assert None not in [c.integrable for c in found.constraints]


def test_words_on_a_restricted_rotation(problem: Read) -> None:
    text = (BALL + ROLLING).replace(" + gamma'*k", "").replace(", gamma", "")
    known = report(problem(text))
    assert known.holds
    page = latex.render([(known.derivation, known.notation)], detail=Detail.FULL)
    assert "the constraint implies no finite relation: it is" in page
    assert "has dimension 5, the orientation of a body counted with three angles" in page


@pytest.mark.parametrize(
    "spin", ["phi'*k + theta'*(cos(phi)*i + sin(phi)*j)", "phi'*k", "0.5*t*k + phi'*k", "theta'*j"]
)
def test_angles_are_no_quasi_coordinates(problem: Read, spin: str) -> None:
    text = EULER.replace(
        "orientation: {axes: 313, angles: [phi, theta, psi]}", f'axes: [i, j, k], angular_velocity: "{spin}"'
    )
    assert quasi_coordinates(problem(text + "  turned: \"phi' = theta'\"\n")) is None
