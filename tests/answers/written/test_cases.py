"""Equations with a case for each sense of the motion.

The sense of a motion by a word, or by a sign alone.

Special cases stated beside the equations.
"""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Grader, Submission
from lagrange.answers.written.cases import single_condition, with_cases, with_senses
from lagrange.core.diagnostics import Source
from lagrange.problem.loader import read_problem
from tests.support.shared import loaded, solved

BLOCK = """
title: Block on a spring with friction
coordinates: [x]
parameters: [m, k, mu, g, v]
equations: ["m*x'' + k*x + mu*m*g*sign(x' - v) = 0"]
"""
AT_REST = BLOCK.replace(" - v)", ")")


def verdict(problem: str, text: str) -> str:
    grader = Grader.of(Examiner.of(read_problem(Source("block", problem))))
    return grader.grade(Submission("x", (("answer.txt", text.encode()),))).verdict.value


RIGHT = [
    "for x' > 0: m x'' = -k x - mu m g\nfor x' < 0: m x'' = -k x + mu m g",
    "m x'' + k x + mu m g = 0 (x' > 0)\nm x'' + k x - mu m g = 0 (x' < 0)",
    "m x'' + k x = -mu m g for x' > 0, +mu m g for x' < 0",
    "m x'' + k x = Piecewise((-mu*m*g, x' > 0), (mu*m*g, True))",
    "m x''[t] + k x[t] == Piecewise[{{-mu*m*g, x'[t] > 0}, {mu*m*g, x'[t] < 0}}]",
    "m x'' + k x == If[x' > 0, -mu m g, mu m g]",
    "m x'' = -k x - F, where F = mu m g if x' > 0 and F = -mu m g if x' < 0",
    "m x'' + k x = ∓ mu m g (upper sign for x' > 0, lower for x' < 0)",
    "m x'' + k x = ∓ mu m g",
    r"$m\ddot{x} + k x = \mp \mu m g$",
    "m x'' = -k x - mu m g (moving right)\nm x'' = -k x + mu m g (moving to the left)",
    "right: m x'' = -k x - mu m g for x' > 0; going left: m x'' = -k x + mu m g for x' < 0",
    r"m\ddot x + kx = \begin{cases} -\mu m g & \dot x > 0\\ +\mu m g & \dot x < 0\end{cases}",
    r"m\ddot x + kx = \left\{\begin{array}{ll} -\mu mg, & \dot{x} > 0 \\ \mu mg, & \text{otherwise}\end{array}\right.",
    r"$m\ddot x = -kx-\mu mg$ for $\dot x>0$ and $m\ddot x=-kx+\mu mg$ for $\dot x < 0$",
    r"\dot x>0:\quad m\ddot x+kx=-\mu mg\\ \dot x<0:\quad m\ddot x+kx=\mu mg",
]


@pytest.mark.parametrize("text", RIGHT)
def test_two_cases_are_one_equation(text: str) -> None:
    assert verdict(AT_REST, text) == "equivalent"


@pytest.mark.parametrize("text", RIGHT[:6])
def test_friction_the_other_way_is_wrong(text: str) -> None:
    exchanged = text.replace(">", "§").replace("<", ">").replace("§", "<")
    assert verdict(AT_REST, exchanged) == "wrong"


def test_velocities_are_compared_with_one_another() -> None:
    right = "x' < v: m x'' + k x = mu m g; x' > v: m x'' + k x = -mu m g"
    assert verdict(BLOCK, right) == "equivalent"
    assert verdict(AT_REST, right) == "wrong"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("for x' > 0: m x'' = -k x - mu m g", "incomplete"),
        ("m x'' = -k x - mu (m g) for x' > 0", "incomplete"),
        (r"$m\ddot{x} = -kx - \mu mg$ while the block slides to the right ($\dot{x} > 0$)", "incomplete"),
        ("for x' < 0: m x'' = -k x - mu m g", "wrong"),
        ("m x'' = -k x - mu m g", "wrong"),
    ],
)
def test_a_single_case_is_right_as_far_as_it_goes(text: str, expected: str) -> None:
    assert verdict(AT_REST, text) == expected


@pytest.mark.parametrize(
    "text", ["x'' = -k*x", "r >= R", "v > 0", "x'' = g (r > 0)", "N >= 0 while the string is taut"]
)
def test_other_texts_stay_as_they_are(text: str) -> None:
    assert with_cases(text) == text


@pytest.mark.parametrize(
    "text", ["while " * 300 + "x' > 0", "Piecewise(" * 190 + "x' > 0", "for x' > 0 = " * 150, "x'>0; x'<0; a=b;" * 120]
)
def test_hostile_texts_end(text: str) -> None:
    assert isinstance(with_cases(text), str)


def test_a_condition_among_words() -> None:
    assert single_condition("for x' > 0:") == ("x'", "0")
    assert single_condition("for r > 0:") is None
    assert single_condition("for x' > 0 and y' > 0") is None


# By words


READ = [
    ("m x'' = ∓ a", "m x'' = - sign(x')* a"),
    (r"m \ddot{x} = \mp a", r"m \ddot{x} = - \operatorname{sgn}\left(\dot{x}\right)\cdot  a"),
    ("m x'' = -a (moving right)", "m x'' = -a (x' > 0)"),
    ("m x'' = a, moving to the left", "m x'' = a, x' < 0"),
]
KEPT = [
    "m x'' = ± a",
    "m x'' = ∓ a (upper sign for x' > 0)",
    "m x'' = ∓ a, M y'' = 0",
    "theta = ∓ pi/2",
    "m x'' = -a while it slides to the right (x' > 0)",
]


@pytest.mark.parametrize(("text", "read"), [*READ, *((t, t) for t in KEPT)])
def test_the_sense_of_a_motion(text: str, read: str) -> None:
    assert with_senses(text) == read


# Special


ATWOOD = """
title: Atwood
coordinates: [a]
parameters: [m, M, g, l]
unknowns: [T]
equations: ["m*a'' = m*g - T", "M*a'' = T - M*g"]
"""
EQUATIONS = "m a'' = m g - T\nM a'' = T - M g\n"


@pytest.mark.parametrize(
    ("beside", "expected"),
    [
        ("so, if M = 3m, then a'' = -g/2", "equivalent"),
        ("a'' = -g/2 if M = 3m", "equivalent"),
        ("For M = 3m we find a'' = -g/2", "equivalent"),
        ("in the special case M = m we have a'' = 0 and T = m g", "equivalent"),
        ("a'' = -g/2", "wrong"),
    ],
)
def test_special_cases_are_not_judged(beside: str, expected: str) -> None:
    grader = Grader.of(Examiner.of(read_problem(Source("atwood", ATWOOD))))
    graded = grader.grade(Submission("x", (("answer.txt", f"{EQUATIONS}{beside}\n".encode()),)))
    assert graded.verdict.value == expected, graded.equations


def test_a_constraint_is_no_special_case() -> None:
    text = "title: p\ncoordinates: [theta]\nparameters: [g, l]\nequations: [\"l*theta'' + g*sin(theta) = 0\"]\n"
    grader = Grader.of(Examiner.of(read_problem(Source("p", text))))
    wrong = "l theta'' + g sin(theta) = 0\nfor theta = theta: l theta'' = 0\n"
    assert grader.grade(Submission("x", (("a.txt", wrong.encode()),))).verdict.value == "wrong"


@pytest.mark.parametrize(
    ("beside", "expected"),
    [
        ("For alpha = 30 deg and beta = 45 deg: theta = 20.1 deg", "equivalent"),
        ("For $\\alpha=30^\\circ$, $\\beta=45^\\circ$ this gives $\\theta\\approx 20.1^\\circ$.", "equivalent"),
        ("For alpha = 30 deg and beta = 45 deg: theta = 21.4 deg", "wrong"),
        ("For alpha = 30 deg and beta = 45 deg: theta = 0.351 deg", "wrong"),
    ],
)
def test_a_number_for_given_angles_must_fit_what_the_answer_says_in_general(beside: str, expected: str) -> None:
    """tan θ = (cot α − cot β)/2: θ = 20.1° for 30° and 45°."""
    grader = Grader.of(Examiner(loaded("rod-on-unequal-planes"), solved("rod-on-unequal-planes")))
    general = (
        "tan(theta) = (1/tan(alpha) - 1/tan(beta))/2\n"
        "N_A = W sin(beta)/sin(alpha + beta), N_B = W sin(alpha)/sin(alpha + beta)\n"
    )
    graded = grader.grade(Submission("x", (("a.txt", f"{general}{beside}\n".encode()),)))
    assert graded.verdict.value == expected, graded.equations


def test_what_is_set_to_zero_for_an_equilibrium_is_no_equation_of_motion() -> None:
    grader = Grader.of(Examiner(loaded("bead-on-rotating-hoop"), solved("bead-on-rotating-hoop")))
    text = (
        "R theta'' = (R Omega^2 cos(theta) - g) sin(theta)\n"
        "theta = 0: omega^2 = g/R - Omega^2\ncos(theta) = g/(R Omega^2): omega^2 = Omega^2 sin(theta)^2\n"
        "Setting theta'' = 0 the equilibria are sin(theta) = 0 or cos(theta) = g/(R Omega^2)\n"
    )
    assert grader.grade(Submission("x", (("a.txt", text.encode()),))).verdict.value == "equivalent"
