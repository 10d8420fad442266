"""The checks of a page, and numbers for a calculator."""

from __future__ import annotations

from lagrange.document.derivation import CheckMark, Rule
from lagrange.explain.report import report
from lagrange.render import terminal
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


def test_values_to_try_are_those_of_the_file_as_it_has_them() -> None:
    falls = read("title: A sledge\nparameters: {g: 9.81, mu: 0.2, a: 30 deg}\ncoordinates: [s]\n"
                 "particles: {P: {mass: 2, position: s*cos(a)*i - s*sin(a)*j}}\ngravity: -g*j\n"
                 "forces: {drag: {on: P, vector: -mu*s'*i}}\n")  # fmt: skip
    found = report(falls, complete=False)
    [line] = [x for x in terminal.text(found.derivation, found.notation, 200).splitlines() if "Try it" in x]
    assert "g = 9.81" in line
    assert "μ = 0.2" in line
    assert "a = 30°" in line
