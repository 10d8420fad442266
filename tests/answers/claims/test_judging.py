"""Answers with their claims."""

from __future__ import annotations

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import answer_to
from lagrange.core.diagnostics import Source
from tests.support.shared import loaded, solved


def verdict_on(name: str, text: str) -> str:
    examiner = Examiner(loaded(name), solved(name))
    return examiner.check(answer_to(examiner, Source("answer", text), ".txt")).verdict.value


SKATES = "m_1 x_1'' = lambda y_2'; m_1 y_1'' = -lambda x_2'; m_2 x_2'' = -lambda y_1'; m_2 y_2'' = lambda x_1'"


def test_a_wrong_number_of_degrees_of_freedom_beside_right_equations() -> None:
    assert verdict_on("parallel-skates", f"{SKATES}\nNumber of degrees of freedom: 3.") == "equivalent"
    assert verdict_on("parallel-skates", f"{SKATES}\nNumber of degrees of freedom: 2.") == "wrong"
    assert (
        verdict_on("parallel-skates", f"{SKATES}\nWithout the constraint 4 degrees of freedom, so DOF = 3")
        == "equivalent"
    )


def test_what_cannot_be_judged_is_named() -> None:
    name = "bead-in-a-turning-tube"
    examiner = Examiner(loaded(name), solved(name))
    claim = "The bead stays near the axis if k > 7 m Omega^2"
    text = f"m r'' = m r Omega^2 - k (r - a)\nH = p_r^2/(2 m) + k (r - a)^2/2 - m r^2 Omega^2/2\n{claim}."
    judgement = examiner.check(answer_to(examiner, Source("answer", text), ".txt"))
    assert judgement.verdict.value == "equivalent"
    assert any(d.code == "not-judged" and claim in d.message for d in judgement.messages)


def test_a_judged_claim_is_not_said_to_be_unjudged() -> None:
    name = "turning-parabola"
    examiner = Examiner(loaded(name), solved(name))
    text = (
        "(1 + 4*c^2*rho^2)*rho'' + 4*c^2*rho*rho'^2 + (2*g*c - Omega^2)*rho = 0\nOmega = sqrt(2*g*c)\n"
        "The equilibrium rho = 0 is stable for Omega^2 < 2*g*c."
    )
    judgement = examiner.check(answer_to(examiner, Source("answer", text), ".txt"))
    assert [d for d in judgement.messages if "rho = 0" in d.message] == []
    assert [a.name for a in judgement.others] == ["ask", "claims"]
