"""Expansions in a small coordinate beside the exact equations: they must agree below the order that is neglected."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import answer_to
from lagrange.core.diagnostics import Source
from tests.support.shared import loaded, solved

PENDULUM, CART = "ex11-ideal-pendulum", "pole-on-cart"
RIGHT = "l*theta'' + g*sin(theta) = 0"
EXPANSIONS = [
    ("theta'' = -g/l*theta + O(theta^3)", "equivalent"),
    ("theta'' = -g/l*theta + O(theta^2)", "equivalent"),
    ("theta'' = -g/l*theta + O(theta^5)", "wrong"),  # the cubic term is missing
    ("theta'' = -g/l*theta + g/(6*l)*theta^3 + O(theta^5)", "equivalent"),
    ("theta'' = -g/l*theta + g/(3*l)*theta^3 + O(theta^5)", "wrong"),
    ("theta'' = -2*g/l*theta + O(theta^3)", "wrong"),
    ("theta'' = 2*g/l*theta^2 - g/l*theta + O(theta^2)", "equivalent"),
    ("For small theta: theta'' = -g/l*theta", "equivalent"),
    ("For small theta: theta'' = g/l*theta", "wrong"),
    (r"\ddot\theta = -\frac gl\theta + \mathcal{O}(\theta^3)", "equivalent"),
    (r"\ddot\theta = -\frac{2g}{l}\theta + \mathcal{O}(\theta^3)", "wrong"),
    ("for theta << 1 neglecting everything: theta'' = 0", "equivalent"),  # not known what is neglected
]


def verdict_on(problem: str, text: str) -> tuple[str, str]:
    examiner = Examiner(loaded(problem), solved(problem))
    judged = examiner.check(answer_to(examiner, Source("answer", text), ".txt"))
    return judged.verdict.value, " ".join(e.diagnosis for e in judged.each)


@pytest.mark.parametrize(("line", "expected"), EXPANSIONS)
@pytest.mark.parametrize("first", [True, False])
def test_an_expansion_beside_the_exact_equation(line: str, expected: str, first: bool) -> None:
    text = f"{line}\n{RIGHT}\n" if first else f"{RIGHT}\n{line}\n"
    assert verdict_on(PENDULUM, text)[0] == expected


def test_the_order_that_differs_is_named() -> None:
    text = f"{RIGHT}\ntheta'' = -g/l*theta + g/(3*l)*theta^3 + O(theta^5)\n"
    assert "terms of order 3 in theta" in verdict_on(PENDULUM, text)[1]


def test_with_two_coordinates() -> None:
    exact = (
        "(M + m)*x'' + m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta) = F - b*x'\n"
        "4/3*l*theta'' + x''*cos(theta) = g*sin(theta)\n"
    )
    assert verdict_on(CART, f"{exact}4/3*l*theta'' + x'' = g*theta + O(theta^2)\n")[0] == "equivalent"
    assert verdict_on(CART, f"{exact}4/3*l*theta'' + x'' = 2*g*theta + O(theta^2)\n")[0] == "wrong"
