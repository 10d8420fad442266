"""The examiner: how much it reads, and the exit status of its verdicts."""

from __future__ import annotations

import pytest
from click.testing import CliRunner

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Grader, Submission
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment, ProblemError, Source
from lagrange.problem.loader import read_problem
from lagsolve.main import main
from tests.answers.test_equations import (
    EQUIVALENT,
    SOLVED,
    solved_reference,
    verdict_on,
)
from tests.support.shared import loaded, solved

RIGHT = "theta'' + g/l*sin(theta) = 0"


def test_twelve_equations_are_read_and_thirteen_refused() -> None:
    against = solved_reference("pendulum")
    assert verdict_on(" ; ".join([RIGHT] * 12), against).verdict.value == EQUIVALENT
    with pytest.raises(ProblemError, match="12 equations"):
        verdict_on(" ; ".join([RIGHT] * 13), against)


@pytest.fixture
def pendulum_file(tmp_path: object) -> str:
    path = tmp_path / "pendulum.yaml"  # type: ignore[operator]
    path.write_text(SOLVED["pendulum"] + "answers: {equations: [\"l*theta'' = -g*sin(theta)\"]}\n", encoding="utf-8")
    return str(path)


@pytest.mark.parametrize(
    ("answer", "status"),
    [
        ([RIGHT], 0),
        (["theta'' = 0"], 1),
        (["0 = 0"], 1),
        (["x^2 + y^2 = l^2"], 1),
        (["theta'' + q = 0"], 2),
        (["theta''/0 = 0"], 2),
        (["theta'' == 0"], 1),
        (["="], 2),
        (["theta''"], 2),
        (["   "], 2),
        ([RIGHT] * 13, 2),
        (["x" * 2001], 2),
        ([], 0),
    ],
)
def test_exit_status_of_check(pendulum_file: str, answer: list[str], status: int) -> None:
    arguments = [part for e in answer for part in ("-e", e)]
    result = CliRunner().invoke(main, ["check", pendulum_file, *arguments])
    assert result.exit_code == status, result.output
    assert "Traceback" not in result.output


@pytest.mark.parametrize(
    ("said", "status"),
    [
        ("degrees_of_freedom: 1", 0),
        ("degrees_of_freedom: 2", 3),
        ("classification: [nonholonomic]", 3),
        ("integrable: {rod: false}", 3),
        ("equations: [\"theta'' = 0\"]", 3),
        ('equations: ["x^2 + y^2 = l^2"]', 3),
        ("equations: [\"theta'' + q = 0\"]", 2),
        ("degrees_of_freedom: many", 2),
        ("integrable: {rope: true}", 2),
    ],
)
def test_exit_status_of_a_solve(tmp_path: object, said: str, status: int) -> None:
    path = tmp_path / "pendulum.yaml"  # type: ignore[operator]
    path.write_text(SOLVED["pendulum"] + f"answers: {{{said}}}\n", encoding="utf-8")
    result = CliRunner().invoke(main, [str(path)])
    assert result.exit_code == status, result.output
    assert "Traceback" not in result.output


def test_two_positions_in_one_line() -> None:
    """Commas within a position, `or` between positions."""
    place = "y = 0, x = {0}F*l/sqrt(F^2 + W^2), z = {0}W*l/sqrt(F^2 + W^2)"
    lines = Submission("one", (("answer.txt", f"{place.format('')} or {place.format('-')}".encode()),))
    examiner = Examiner(loaded("pendulum-in-wind"), solved("pendulum-in-wind", complete=False))
    assert Grader.of(examiner).grade(lines).verdict.value == EQUIVALENT


@pytest.mark.parametrize(
    ("second", "said"),
    [
        ("cos(theta) = W*l/(2*c*b^2)", "as from an energy without its 1/2"),
        ("cos(theta) = W/(c*l)", "with l in place of b"),
        ("W*l = 2*c*b^2*cos(theta)", "as from an energy without its 1/2"),
    ],
)
def test_positions_that_hold_together_for_some_parameters_only(second: str, said: str) -> None:
    """theta = 0 does not make cos(theta) = W/(c*l) right as a relation between parameters, nor any change of it."""
    name = "inverted-pendulum-springs"
    examiner = Examiner(loaded(name), solved(name, complete=False))
    verdict = examiner.check(tuple(map(Fragment.of, ("theta = 0", second)))).equations
    assert [e.verdict for e in verdict.equations] == [Verdict.EQUIVALENT, Verdict.WRONG]
    assert said in verdict.equations[1].diagnosis


SIGN = """
title: Rod held by a coil
axes: {i: right, j: up}
parameters: [W, l, k, theta_0]
coordinates: {theta: inclination of the rod above the level}
particles: {G: {position: l*cos(theta)*i + l*sin(theta)*j}}
forces:
  weight: {on: G, vector: -W*j}
  coil: {potential: "k*(theta - theta_0)^2/2"}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("2*k*(theta - theta_0) + W*l*cos(theta) = 0", "as from an energy without its 1/2"),
        ("k*(theta - theta_0) = W*l*cos(theta)", "for gravity that acts the other way"),
        ("theta = theta_0", "it does not hold at any equilibrium; these are the equilibria without the weight"),
    ],
)
def test_wrong_equilibria_without_a_closed_form_are_explained(answer: str, said: str) -> None:
    examiner = Examiner.of(read_problem(Source("problem.yaml", SIGN)))
    [verdict] = examiner.check((Fragment.of(answer),)).each
    assert said in verdict.diagnosis


TROUGH = """
title: Cylinder that rolls in a trough
axes: {i: right, j: down}
parameters: [m, a, R, g]
coordinates: {theta: angle of the line to the axis from the vertical, phi: angle of the cylinder}
bodies:
  roller: {mass: m, inertia: m*a^2/2, position: (R - a)*sin(theta)*i + (R - a)*cos(theta)*j, angle: phi}
constraints:
  rolling: {equation: "a*phi' = (R - a)*theta'", reaction: F, by: rolling}
gravity: g*j
generalized_coordinates: {swing: {coordinates: [theta]}}
initial: {theta: pi/2, theta': 0}
ask: {speed: {quantity: "(R - a)*theta'", when: theta = 0}}
find: [motion, linearization]
"""


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("omega = sqrt(5*g/(7*(R - a)))", "with the moment of inertia 2*m*a^2/5 for `roller`"),
        ("speed = sqrt(2*g*(R - a))", "without the rotation of `roller`"),
    ],
)
def test_a_frequency_is_no_answer_to_a_question_for_a_speed(answer: str, said: str) -> None:
    examiner = Examiner.of(read_problem(Source("problem.yaml", TROUGH)))
    judgement = examiner.check((Fragment.of(answer),))
    assert judgement.verdict is Verdict.WRONG
    assert said in " ".join(str(judgement).split())
