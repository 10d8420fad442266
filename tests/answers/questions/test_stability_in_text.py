"""Words on stability beside positions.

Sentences on stability without an equation for the position.
"""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions.stability_in_text import check_stability_sentences, is_about_stability
from lagrange.answers.references import reference_of_solution
from lagrange.answers.submissions import Grader, Submission
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved

NAME = "inverted-pendulum-springs"


@pytest.mark.parametrize(
    ("stable", "verdict"),
    [
        ("stable for W > c*l*10^9", "wrong"),
        ("stable for 10*W*l < 11*c*b^2", "wrong"),  # near: it is tried beside its limit
        ("stable for W*l < c*b^2", "incomplete"),
    ],
)
def test_a_wrong_claim_makes_a_right_position_wrong(stable: str, verdict: str) -> None:
    examiner = Examiner(loaded(NAME), solved(NAME))
    alone = examiner.check((Fragment.of("theta = 0"),)).verdict.value
    claimed = examiner.check((Fragment.of(f"theta = 0, {stable}"),)).verdict.value
    assert alone in ("incomplete", "equivalent")
    assert claimed == verdict


# Stability alone


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("The upright position is stable for W*l < c*b^2 and unstable for W*l > c*b^2.", Verdict.EQUIVALENT),
        ("stable as long as c*b^2 > W*l", Verdict.EQUIVALENT),
        ("stable for W*l > c*b^2", Verdict.WRONG),
        ("stable for W*l < 2*c*b^2", Verdict.WRONG),
        ("stable for 10*W*l < 11*c*b^2", Verdict.WRONG),  # near: it is tried beside its limit
        ("stable for 100*W*l < 101*c*b^2", Verdict.WRONG),
    ],
)
def test_the_upright_pendulum_between_springs(line: str, verdict: Verdict) -> None:
    """V'' = b² c − W l at the top."""
    solution = solved("inverted-pendulum-springs")
    assert is_about_stability(line)
    answer = check_stability_sentences([Fragment.of(line)], solution, reference_of_solution(solution))
    assert answer is not None
    assert answer.verdict is verdict


@pytest.mark.parametrize(
    ("name", "text", "verdict"),
    [
        ("bead-on-rotating-hoop", "theta = 0: omega = sqrt(g/R - Omega^2), stable for Omega^2 < g/R", "equivalent"),
        ("bead-on-rotating-hoop", "theta = 0: omega = sqrt(g/R - Omega^2), stable for Omega^2 > g/R", "wrong"),
        ("marble-in-a-cone", "The steady motion is stable if tan(alpha) > 1 and unstable otherwise.", "wrong"),
    ],
)
def test_claims_after_a_label_and_on_steady_motions(name: str, text: str, verdict: str) -> None:
    equations = {
        "bead-on-rotating-hoop": "R theta'' = (R Omega^2 cos(theta) - g) sin(theta)\n"
        "cos(theta) = g/(R Omega^2): omega = sqrt(Omega^2 - g^2/(R^2 Omega^2))\n",
        "marble-in-a-cone": "r'' - r phi'^2 sin(alpha)^2 + g cos(alpha) = 0\nr phi'' + 2 r' phi' = 0\n"
        "phi'^2 = g cos(alpha)/(r sin(alpha)^2)\n",
    }
    grader = Grader.of(Examiner(loaded(name), solved(name)))
    graded = grader.grade(Submission("x", (("a.txt", f"{equations[name]}{text}\n".encode()),)))
    assert graded.verdict.value == verdict, graded.equations
