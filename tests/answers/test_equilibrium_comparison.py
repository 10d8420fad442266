"""Stated equilibria against those derived: each with the condition of its branch."""

from __future__ import annotations

import pytest

from lagrange.answers.equations import Verdict
from lagrange.answers.examiner import check_own_answers
from lagrange.core.diagnostics import Fragment
from tests.answers.test_equilibria import EQUIVALENT, INCOMPLETE, TORSION, WRONG, examiner, read, verdict
from tests.support.statics_texts import (
    ATWOOD,
    BEAD,
    CROSS_WIND,
    OPEN_LINKAGE,
    PULLED_SPRING,
    SCALES,
    WIND,
)


@pytest.mark.parametrize(
    ("problem", "equations", "said"),
    [
        (
            WIND,
            ["theta = atan(F/(m*g - H)) or theta = 0"],
            ["", "it does not hold at any equilibrium; these are the equilibria without the force `wind`"],
        ),
        (SCALES, ["theta = 0"], ["it does not hold at any equilibrium, unless a*P = b*Q"]),
        (PULLED_SPRING, ["x = P/k", "W = 7*l"], ["", "the conditions of equilibrium do not require it"]),
        (
            PULLED_SPRING,
            ["x = 7*l", "W = 7*l"],
            ["it does not hold at any equilibrium", "the conditions of equilibrium do not require it"],
        ),
        (
            TORSION,
            ["theta = pi"],
            [
                "it does not hold at any equilibrium; "
                "these are the equilibria without the force of the potential `spring`"
            ],
        ),
        (
            ATWOOD,
            ["x = L", "W = 2*M"],
            [
                "",
                "the conditions of equilibrium do not require it; these are the equilibria for the force `v` twice as "
                "large, or acting at twice the distance, or for the force `w` acting at half the distance",
            ],
        ),
        (BEAD, ["theta = 0", "theta = pi"], ["", ""]),
    ],
)
def test_each_equation_is_tested_by_itself(problem: str, equations: list[str], said: list[str]) -> None:
    found = examiner(problem).check(tuple(Fragment.of(e) for e in equations))
    assert [e.diagnosis for e in found.each] == said
    assert all((e.verdict is WRONG) == bool(e.diagnosis) for e in found.each)


def test_poles_of_the_coordinates_are_not_asked_for() -> None:
    """At θ = 0 the conditions hold for tan φ = −1, but the wind is not balanced there."""
    both = '[["tan(theta) = sqrt(2)", "phi = pi/4"], ["tan(theta) = -sqrt(2)", "phi = -3*pi/4"]]'
    assert check_own_answers(read(CROSS_WIND + f"answers: {{equilibrium: {both}}}\n")).verdict is EQUIVALENT


@pytest.mark.parametrize(
    ("equations", "expected"),
    [
        (["tan(alpha) = 3/2 or sin(beta - gamma) = 0"], EQUIVALENT),
        (["tan(alpha) = 3/2"], INCOMPLETE),
        (["sin(beta - gamma) = 0"], INCOMPLETE),
        (["tan(alpha) = 2/3 or sin(beta - gamma) = 0"], WRONG),
    ],
)
def test_equilibria_without_a_closed_form_are_compared_in_numbers(equations: list[str], expected: Verdict) -> None:
    """The pushed crank along the force, or coupler and rocker in line."""
    assert examiner(OPEN_LINKAGE).check(tuple(Fragment.of(e) for e in equations)).verdict is expected


ROCKING_STONE = """
title: Rocking stone
parameters: [W, a, b]
coordinates: [phi]
forces: {weight: {potential: "W*((a + b)*cos(phi) - b*cos(phi*(1 + b/a)))"}}
find: equilibrium
"""


def test_beside_an_angle_of_which_no_multiple_occurs_an_answer_is_incomplete() -> None:
    """With sin(φ (1 + b/a)) the conditions are no polynomials in sin φ and cos φ: it ended in an exception.

    What the page states beside φ = 0 is not solved, and the answer lacks it, as with k θ = m g l sin θ.
    """
    assert verdict(read(ROCKING_STONE), "phi = 0").verdict is INCOMPLETE


SPRING_FROM_ABOVE = """
title: A rod on a pivot, held by a spring from a point above
parameters: [g, H]
coordinates: [theta]
particles: {P: {mass: 1, position: sin(theta)*i + cos(theta)*j}}
gravity: -g*j
forces: {spring: {spring: 5, between: [H*j, P], length: 1}}
find: equilibrium
"""


def test_an_answer_counts_with_the_condition_of_its_branch() -> None:
    """The spring has the length d = 5 H/(5 H − g), so 5 H ≥ g; the equation for cos θ gives d² alone."""
    side = "cos(theta) = (H^2 + 1 - 25*H^2/(5*H - g)^2)/(2*H)"
    problem = read(SPRING_FROM_ABOVE)
    assert verdict(problem, f"theta = 0 or theta = pi or {side}").verdict is EQUIVALENT
    other = "cos(theta) = (H^2 + 1 - 25*H^2/(5*H + g)^2)/(2*H)"
    assert verdict(problem, f"theta = 0 or theta = pi or {other}").verdict is WRONG
    assert verdict(problem, "theta = 0 or theta = pi").verdict is INCOMPLETE


SKATE_ON_A_SPRING = """
title: a skate on a spring
parameters: [k]
coordinates: [x, y, theta]
particles: {P: {position: x*i + y*j}}
constraints: {blade: "y'*cos(theta) - x'*sin(theta) = 0"}
forces: {spring: {spring: k, between: [0*i, P]}}
find: equilibrium
"""
"""In equilibrium for x cos θ + y sin θ = 0."""


@pytest.mark.parametrize(
    ("stated", "expected"),
    [
        ("x*cos(theta) + y*sin(theta) = 0", EQUIVALENT),
        ("y = -x*cos(theta)/sin(theta)", INCOMPLETE),
        ("x = -y*tan(theta)", INCOMPLETE),
        ("tan(theta) = -x/y", INCOMPLETE),
        ("y = -x*cot(theta) or x = -y*tan(theta)", EQUIVALENT),
    ],
)
def test_equilibria_lost_by_dividing(stated: str, expected: Verdict) -> None:
    """x = 0, θ = 0 with any y is lost by a division by sin θ, and x = y = 0 with any θ by one by y."""
    judged = examiner(SKATE_ON_A_SPRING).check((Fragment.of(stated),))
    assert judged.verdict is expected


FOUR_BAR = """
title: Four-bar linkage with a force on the crank's pin
coordinates: [alpha, beta, gamma]
particles: {A: {position: 2*cos(alpha)*i + 2*sin(alpha)*j}}
constraints:
  h: 2*cos(alpha) + cos(beta) - cos(gamma) = 2
  v: 2*sin(alpha) + sin(beta) - sin(gamma) = 0
forces: {push: {on: A, vector: 2*i + 3*j}}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("last", "expected"),
    [("cos(beta)*sin(gamma) - sin(beta)*cos(gamma) = 0", INCOMPLETE), ("cos(beta)*sin(gamma) = 1/2", WRONG)],
)
def test_forces_balance_where_a_linkage_is_stretched_out(last: str, expected: Verdict) -> None:
    """Where β = γ the crank cannot turn, and the conditions of equilibrium, divided by sin(β − γ), do not vanish.

    These equilibria, as the program states them, were called wrong for "solutions that are not equilibria".
    """
    closed = ["2*sin(alpha) + sin(beta) - sin(gamma) = 0", "2*cos(alpha) - 2 + cos(beta) - cos(gamma) = 0"]
    stated = tuple(Fragment.of(e) for e in (*closed, last))
    assert examiner(FOUR_BAR).check(stated).verdict is expected


ROD_OVER_PEG = """title: Rod between a smooth wall and a smooth peg
parameters: {m: positive, g: positive, l: positive, a: positive}
coordinates: [x, y, theta]
bodies: {rod: {mass: m, position: x*i + y*j, angle: theta}}
constraints:
  wall: {equation: x - l/2*cos(theta) >= 0, reaction: N_A}
  peg: {equation: y*cos(theta) - (x - a)*sin(theta) >= 0, reaction: N_B}
gravity: -g*j
find: [equilibrium]
"""


def test_an_angle_without_contact_does_not_stand_for_the_one_with_contact() -> None:
    """cos³ θ = 2a/l, with N_A = m g tan θ: only θ > 0 presses on the wall."""
    judge = examiner(ROD_OVER_PEG)
    verdicts = {
        e: judge.check((Fragment.of(e),)).verdict
        for e in ("theta = acos((2*a/l)^(1/3))", "theta = -acos((2*a/l)^(1/3))", "cos(theta)^3 = 2*a/l")
    }
    assert [*verdicts.values()] == [EQUIVALENT, INCOMPLETE, EQUIVALENT]
