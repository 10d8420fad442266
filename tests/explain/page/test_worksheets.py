"""Worksheets: the statement and tasks, nothing of the solution; the solution under the same numbers, all of it."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import (
    Derivation,
    Detail,
    Display,
    Emphasis,
    Picture,
    Prose,
    Purpose,
    Rule,
    Step,
    Task,
    prose,
)
from lagrange.explain.limits import LEAST_ROOM, MOST_ROOM
from lagrange.explain.page import worksheets
from lagrange.explain.page.worksheets import worked_solution, worksheet
from lagrange.explain.report import Report
from lagrange.render import terminal
from tests.support.shared import reported

PROBLEMS = [
    "ex05-ice-skate",
    "ex11-ideal-pendulum",
    "ex15-rough-incline",
    "leaving-a-sphere",
    "sleigh",
    "beads-on-hoop",
    "double-pendulum-small-oscillations",
]


def both(name: str) -> tuple[Report, Derivation, Derivation]:
    found = reported(name, complete=False)
    made = found.solution, found.derivation
    return found, worksheet(*made), worked_solution(*made)


def words(derivation: Derivation) -> str:
    page = terminal.text(derivation, reported("ex11-ideal-pendulum", complete=False).notation, 200)
    return " ".join(page.split())


@pytest.mark.parametrize("name", PROBLEMS)
def test_sheet_and_solution_have_the_same_parts(name: str) -> None:
    _, sheet, solution = both(name)
    statement, *parts = sheet.page
    assert statement.rule is Rule.STATEMENT
    assert not statement.title  # and no number
    assert [p.title for p in parts] == [p.title for p in solution.page]
    for p in parts:
        [task] = p.body
        assert isinstance(task, Task)
        assert LEAST_ROOM <= task.lines <= MOST_ROOM
        assert str(task.parts[-1]).endswith((".", "?"))


@pytest.mark.parametrize("name", PROBLEMS)
def test_the_solution_has_the_open_steps_of_the_page(name: str) -> None:
    found, _, solution = both(name)
    left_out = (Rule.RESULT, Rule.STATEMENT, Rule.CHECKS, Rule.MEANING)
    steps = [s for s in found.derivation.page if not s.folded and s.rule not in left_out]
    wanted = [b for s in steps for b in s.body if b.detail <= Detail.STEPS]
    assert wanted
    written = [b for s in solution.page for b in s.body]
    assert [b for b in wanted if b not in written] == []


@pytest.mark.parametrize("name", PROBLEMS)
def test_the_sheet_gives_no_result_away(name: str) -> None:
    found, sheet, solution = both(name)
    results = [
        e
        for s in found.derivation.page
        if s.rule is Rule.RESULT
        for b in s.body
        if isinstance(b, Display)
        for e in b.equations
    ]
    shown = [e.sides for s in sheet.page for b in s.body if isinstance(b, Display) for e in b.equations]
    constraints = [(c.lhs, c.rhs) for c in found.solution.problem.constraints]
    assert [e.sides for e in results if e.sides in shown and e.sides not in constraints] == []
    assert len(shown) < sum(len(b.equations) for s in solution.page for b in s.body if isinstance(b, Display)) + 20


def test_the_pendulum() -> None:
    _, sheet, solution = both("ex11-ideal-pendulum")
    text = words(sheet)
    assert "x² + y² = l²" in text
    assert "Take θ as generalized coordinate, with x = l sin θ and y = l cos θ. Derive the equation of motion." in text
    assert "θ̈" not in text
    assert "Find the reaction of the rod constraint in terms of position and velocity." in text
    assert any(isinstance(b, Picture) for b in sheet.page[0].body)
    assert "θ̈ + (g/l) sin θ = 0" in words(solution)
    assert solution.title == "Ideal pendulum: solution"


def test_questions_of_the_file_are_tasks() -> None:
    _, sheet, _ = both("leaving-a-sphere")
    asked = [s for s in sheet.page if s.rule is Rule.QUESTION]
    assert [s.title for s in asked] == [
        "The angle from the top where contact ends",
        "The speed where contact ends",
        "The reaction as a function of the angle from the top",
    ]
    text = words(sheet)
    assert "Find θ when N = 0." in text
    assert "Find N as a function of θ." in text


def test_statics_asks_for_the_equilibrium() -> None:
    assert "find the positions of equilibrium by it. Are they stable?" in words(both("beads-on-hoop")[1])


def test_no_question_about_constraints_where_there_are_none() -> None:
    sheet = both("double-pendulum-small-oscillations")[1]
    assert [s.title for s in sheet.page[1:]] == [
        "D'Alembert's principle and the equations of motion",
        "Small oscillations",
        "What it says",
    ]


def test_equations_of_the_statement_have_no_numbers() -> None:
    _, sheet, solution = both("ex11-ideal-pendulum")
    assert [e.label for b in sheet.page[0].body if isinstance(b, Display) for e in b.equations if e.label] == []
    assert "(1)" not in words(sheet)
    assert "(1)" in words(solution)
    assert [b for s in sheet.page[1:] for b in s.body if isinstance(b, Prose)] == []


def test_conserved_quantities_are_asked_for_where_the_page_has_some() -> None:
    uniform = prose(Emphasis("Accelerations"), ": none; every coordinate changes uniformly.")
    energy = prose(Emphasis("Energy"), ": constant.", purpose=Purpose.CONSERVED)
    assert worksheets._about_meaning(Step(Rule.MEANING, "What it says", (uniform,))) == ()
    [asked] = worksheets._about_meaning(Step(Rule.MEANING, "What it says", (uniform, energy)))
    assert asked == "Which quantities does the motion conserve?"
