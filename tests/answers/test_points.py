"""Points: the weights of a problem file, and what answers earn."""

from __future__ import annotations

from fractions import Fraction

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.points import points_in_words
from lagrange.answers.submissions import Graded, Grader, Submission
from lagrange.core.diagnostics import ProblemError, Source
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Weight
from tests.support.shared import loaded, solved

BEAD = """
title: Bead on a string
axes: {i: right, j: down}
parameters: [m, M, g, l]
coordinates: [x, theta]
particles:
  cart: {mass: M, position: x*i}
  bob: {mass: m, position: (x + l*sin(theta))*i + l*cos(theta)*j}
gravity: g*j
points: {equations: 6, degrees_of_freedom: 1, conserved: 2.5}
"""
FIRST = "(M + m)*x'' + m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta) = 0"
SECOND = "l*theta'' + x''*cos(theta) + g*sin(theta) = 0"
WRONG = "l*theta'' + x''*sin(theta) + g*sin(theta) = 0"
MOMENTUM = "M*x' + m*x' + m*l*theta'*cos(theta) = const"
ENERGY = "M*x'^2/2 + m/2*(x'^2 + 2*l*x'*theta'*cos(theta) + l^2*theta'^2) - m*g*l*cos(theta) = const"


@pytest.fixture(scope="module")
def grader() -> Grader:
    return Grader.of(Examiner.of(read_problem(Source("bead", BEAD))))


def graded(grader: Grader, text: str, ending: str = ".txt") -> Graded:
    return grader.grade(Submission("a", ((f"a{ending}", text.encode()),)))


@pytest.mark.parametrize(
    ("equations", "points"),
    [
        ([FIRST, SECOND], "6"),
        ([FIRST], "3"),
        ([FIRST, f"2*({FIRST.partition(' = ')[0]}) = 0"], "3"),
        ([FIRST, WRONG], "3"),
        ([WRONG], "0"),
        ([FIRST, SECOND, WRONG], "3"),
        ([FIRST, WRONG, WRONG], "0"),
        (["0 = 0"], "0"),
        ([FIRST, "x'' = qqq"], "3"),
        (["x'' = qqq"], "0"),
        (["I do not know"], "0"),
    ],
)
def test_equations_earn_their_share(grader: Grader, equations: list[str], points: str) -> None:
    result = graded(grader, "\n".join(equations))
    assert result.score is not None
    assert (points_in_words(result.score.points), points_in_words(result.score.possible)) == (points, "9.5")
    assert result.score.weighed


def test_each_part_has_its_verdict_and_its_points(grader: Grader) -> None:
    text = f'degrees_of_freedom: 3\nequations: ["{FIRST}", "{SECOND}"]\nconserved: ["{MOMENTUM}"]\n'
    result = graded(grader, text, ".yaml")
    assert result.verdict.value == "wrong"
    assert result.remark.startswith("degrees of freedom wrong, conserved incomplete, equations right; ")
    assert result.score is not None
    parts = {p.part: (points_in_words(p.points), points_in_words(p.possible), p.verdict) for p in result.score.parts}
    assert parts == {
        "degrees_of_freedom": ("0", "1", "wrong"),
        "equations": ("6", "6", "equivalent"),
        "conserved": ("1.25", "2.5", "incomplete"),
    }
    assert [*result.score.lines()] == [
        "points: 7.25 of 9.5",
        "  degrees of freedom: 0 of 1 (wrong)",
        "  equations: 6 of 6 (equivalent)",
        "  conserved: 1.25 of 2.5 (incomplete)",
    ]
    both = graded(grader, f'degrees_of_freedom: 2\nconserved: ["{MOMENTUM}", "{ENERGY}"]\n', ".yaml")
    assert both.score is not None
    assert [(p.part, points_in_words(p.points), p.verdict) for p in both.score.parts] == [
        ("degrees_of_freedom", "1", "equivalent"),
        ("equations", "0", "missing"),
        ("conserved", "2.5", "equivalent"),
    ]


def test_without_weights_each_equation_is_worth_one_point() -> None:
    examiner = Examiner(loaded("ex18-double-pendulum"), solved("ex18-double-pendulum"))
    result = graded(Grader.of(examiner), "l2*phi2'' + l1*phi1''*cos(phi1 - phi2) - l1*phi1'^2*sin(phi1 - phi2) = 0")
    assert result.score is not None
    assert (result.score.points, result.score.possible, result.score.weighed) == (0, 2, False)


QUESTIONS = """
title: Thrown up
axes: {i: up}
parameters: [m, g, v]
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
gravity: -g*i
initial: {x: 0, x': v}
ask:
  height: {quantity: x, when: "x' = 0"}
  time: {quantity: t, when: "x' = 0"}
  below: {quantity: "x'", when: x = 0}
"""


@pytest.mark.parametrize(
    ("points", "answers", "earned"),
    [
        ("{ask: 3}", {"height": "v^2/(2*g)"}, "1 of 3"),
        ("{ask: 3}", {"height": "v^2/(2*g)", "time": "v/g", "below": "-v"}, "3 of 3"),
        ("{ask: 3}", {"height": "v^2/g", "time": "v/g"}, "1 of 3"),
        ("{ask: {height: 2, time: 0.5}}", {"height": "v^2/g", "time": "v/g"}, "0.5 of 2.5"),
        ("{ask: {height: 2}, equations: 4}", {"height": "v^2/(2*g)"}, "2 of 6"),
        ("{ask: {height: 2}, equations: 4}", {"time": "v/g"}, "0 of 6"),
    ],
)
def test_questions_have_points_together_or_each(points: str, answers: dict[str, str], earned: str) -> None:
    problem = read_problem(Source("thrown", f"{QUESTIONS}points: {points}\n"))
    text = "ask:\n" + "".join(f'  {name}: "{answer}"\n' for name, answer in answers.items())
    result = graded(Grader.of(Examiner.of(problem)), text, ".yaml")
    assert result.score is not None
    assert next(result.score.lines()) == f"points: {earned}"


def test_the_weights_of_a_file() -> None:
    problem = read_problem(Source("bead", BEAD))
    assert problem.points == (
        Weight("degrees_of_freedom", "", Fraction(1)),
        Weight("equations", "", Fraction(6)),
        Weight("conserved", "", Fraction(5, 2)),
    )


@pytest.mark.parametrize(
    ("points", "code", "said"),
    [
        ("{equations: many}", "not-a-number", "`many` is not a number of points"),
        ("{equations: -1}", "not-a-number", "`-1` is not a number of points"),
        ("{equations: 0}", "not-a-number", "`0` is not a number of points"),
        ("{equations: 1e9}", "not-a-number", "`1e9` is not a number of points"),
        ("{equations: [1, 2]}", "wrong-kind", "the points for `equations` is one value"),
        ("{equation: 1}", "unknown-key", "`equation` is not a key of `points`"),
        ("{ask: {hight: 1}}", "unknown-name", "`hight` is not a question of this file"),
        ("{reactions: {rod: 1}}", "unknown-name", "`rod` is not a constraint of this file"),
        ("{equations: {x: 1}}", "wrong-kind", "the points for `equations` is one value"),
        ("6", "wrong-kind", "`points` is a mapping"),
    ],
)
def test_mistakes_in_weights_stand_at_their_place(points: str, code: str, said: str) -> None:
    with pytest.raises(ProblemError) as error:
        read_problem(Source("thrown", f"{QUESTIONS}points: {points}\n"))
    [diagnostic] = error.value.diagnostics
    assert (diagnostic.code, diagnostic.message) == (code, said)
    assert diagnostic.span is not None
    assert "points: {" in str(diagnostic) or "points: 6" in str(diagnostic)
    assert diagnostic.help


# -- A text: which line answers what -----------------------------------------------------------------------------------

SPHERE = """
title: Particle on a sphere
coordinates: [r, theta]
parameters: [m, g, R]
particles: {P: {mass: m, position: r*sin(theta)*i + r*cos(theta)*j}}
constraints: {sphere: {equation: r >= R, reaction: N}}
gravity: -g*j
initial: {theta: 0, theta': 0}
ask: {leaves: {quantity: theta, when: N = 0}}
points: {equations: 3, ask: {leaves: 4}, reactions: {sphere: 2}}
"""
RIGHT = {
    "equations": "R theta'' = g sin theta",
    "sphere": "N = m g cos(theta) - m R theta'^2",
    "leaves": "cos(theta) = 2/3",
}
MISTAKES = {"equations": "R theta'' = g cos theta", "sphere": "$N$ = m g cos(theta)", "leaves": "cos(theta) = 3/4"}


@pytest.fixture(scope="module")
def sphere() -> Grader:
    return Grader.of(Examiner.of(read_problem(Source("sphere", SPHERE))))


@pytest.mark.parametrize("wrong", [(), *((part,) for part in RIGHT), ("equations", "sphere"), ("sphere", "leaves")])
def test_each_line_of_a_text_earns_the_points_of_its_part(sphere: Grader, wrong: tuple[str, ...]) -> None:
    lines = [MISTAKES[part] if part in wrong else line for part, line in RIGHT.items()]
    found = graded(sphere, "\n".join(lines))
    assert found.score is not None
    earned = {p.part.rpartition(": ")[2]: (str(p.points), p.verdict) for p in found.score.parts}
    whole = {"equations": "3", "sphere": "2", "leaves": "4"}
    assert earned == {p: ("0", "wrong") if p in wrong else (whole[p], "equivalent") for p in whole}
    assert not any("not judged" in m and "cos(theta)" in m for m in found.messages)


def test_what_a_text_does_not_state_is_missing(sphere: Grader) -> None:
    score = graded(sphere, RIGHT["equations"]).score
    assert score is not None
    assert [(p.part, p.verdict) for p in score.parts if p.verdict == "missing"] == [
        ("reactions: sphere", "missing"),
        ("ask: leaves", "missing"),
    ]
