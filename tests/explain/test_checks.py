"""The checks of a page, and numbers for a calculator."""

from __future__ import annotations

from lagrange.document.derivation import CheckMark, Rule
from lagrange.explain.report import report
from tests.support.derivation_text import said_in
from tests.support.problem_texts import read
from tests.support.shared import reported


def test_every_check_of_the_solution_is_on_the_page_once() -> None:
    found = reported("ex11-ideal-pendulum")
    [step] = [s for s in found.derivation.steps if s.rule is Rule.CHECKS]
    marks = [b for b in step.body if isinstance(b, CheckMark)]
    assert len(marks) >= len({c.name for c in found.solution.checks})
    assert all(m.passed for m in marks)


def test_numbers_are_named() -> None:
    assert "Numerical check: " in said_in("ex11-ideal-pendulum", Rule.CHECKS)


def test_without_any_number_there_is_nothing_to_try() -> None:
    free = read("title: A free particle\ncoordinates: [x]\nparticles: {P: {mass: 2, position: x*i}}\n")
    [step] = [s for s in report(free, complete=False).derivation.page if s.rule is Rule.CHECKS]
    assert "Try it" not in str(step.body)
