"""Answers as students write them, in files beside this one: plain, LaTeX, Unicode, computer algebra, with their working.

A file has `@ PROBLEM`, then for each answer `--- VERDICT [EXTENSION]` and its text. They were written from the problem
files, before the reader of answers was changed for any of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Grader, Submission
from tests.support.shared import loaded, solved

FOLDER = Path(__file__).with_name("student_answers")


def answers() -> dict[str, list[tuple[str, str, str, str]]]:
    """Problem -> its answers: their place, the verdict expected, the extension, and the text."""
    found: dict[str, list[tuple[str, str, str, str]]] = {}
    for file in sorted(FOLDER.glob("*.txt")):
        for place, problem, verdict, ending, text in in_file(file):
            found.setdefault(problem, []).append((place, verdict, ending, text))
    return found


def in_file(file: Path) -> Iterator[tuple[str, str, str, str, str]]:
    problem, head, lines = "", ("", "", ""), list[str]()
    for number, line in enumerate([*file.read_text(encoding="utf-8").splitlines(), "---"], 1):
        if line.startswith(("@ ", "---")):
            if head[1]:
                yield head[0], problem, head[1], head[2], "\n".join(lines) + "\n"
            problem = line[2:].strip() if line.startswith("@") else problem
            _, verdict, ending = (*line.split(), "", "")[:3] if line.startswith("--- ") else ("", "", "")
            head, lines = (f"{file.name}:{number}", verdict, ending or ".txt"), []
        else:
            lines.append(line)


ANSWERS = answers()


@cache
def grader_of(problem: str) -> Grader:
    return Grader.of(Examiner(loaded(problem), solved(problem)))


def verdict_on(problem: str, ending: str, text: str) -> tuple[str, list[str]]:
    graded = grader_of(problem).grade(Submission("x", ((f"answer{ending}", text.encode()),)))
    details = [f"{e.verdict}: {e.text} -- {e.diagnosis} {e.remarks}" for e in graded.equations]
    return graded.verdict.value, [graded.headline, *details, *graded.messages]


@pytest.mark.parametrize("problem", ANSWERS)
def test_answers_of_students(problem: str) -> None:
    failures = []
    for place, expected, ending, text in ANSWERS[problem]:
        verdict, details = verdict_on(problem, ending, text)
        if verdict != expected:
            failures.append("\n".join([f"{place}: {verdict}, not {expected}", text, *details]))
    assert not failures, "\n\n".join(failures)


def test_there_are_hundreds_on_thirty_problems() -> None:
    assert len(ANSWERS) >= 30
    assert sum(map(len, ANSWERS.values())) >= 300


def test_unreadable_lines_stand_where_they_were_written() -> None:
    text = b"theta'' + q = 0\ntheta'' = -g/l*sin(theta)\n0 = theta'' + )\nl*theta'' + g*sin(theta) = 0\n"
    graded = grader_of("ex11-ideal-pendulum").grade(Submission("a", (("a.txt", text),)))
    assert [e.verdict.value for e in graded.equations] == ["unreadable", "equivalent", "unreadable", "equivalent"]


@pytest.mark.parametrize(
    "line",
    [
        "d/dt(dL/dtheta') - dL/dtheta = 0",
        r"\frac{d}{dt}\frac{\partial L}{\partial \dot\theta} - \frac{\partial L}{\partial\theta} = 0",
        r"\dv{t}\pdv{\mathcal{L}}{\dot q} = \pdv{\mathcal{L}}{q}",
        "D[D[L, θ'[t]], t] == D[L, θ[t]]",
        "diff(diff(L, theta'), t) - diff(L, theta) = 0",
        "∂L/∂θ = -mgl sinθ",
        "L = T - V",
        "F = m a",
        "E = T + V = const",
        "sum M = I alpha",
    ],
)
def test_the_method_may_be_quoted(line: str) -> None:
    text = f"{line}\n\ntheta'' = -g/l*sin(theta)\n".encode()
    graded = grader_of("ex11-ideal-pendulum").grade(Submission("a", (("a.txt", text),)))
    assert [e.verdict.value for e in graded.equations] == ["equivalent"]
    assert not any(m.startswith("error") for m in graded.messages)
    assert any("not judged" in m for m in graded.messages)


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ("T = m*g*cos(theta) + m*l*theta'^2", "equivalent"),
        (r"T = mg\cos\theta + ml\dot\theta^2", "equivalent"),
        ("T = m*g*cos(theta) - m*l*theta'^2", "wrong"),
        ("lambda = -m/(2*l^2)*(g*y + x'^2 + y'^2)", "equivalent"),
        ("λ = -m*g*y/(2*l^2)", "wrong"),
    ],
)
def test_a_reaction_may_be_named_as_on_the_page(stated: str, verdict: str) -> None:
    text = f'reactions: {{rod: "{stated}"}}\n'.replace("\\", "\\\\")
    graded = grader_of("ex11-ideal-pendulum").grade(Submission("a", (("a.yaml", text.encode()),)))
    assert [a.verdict.value for a in graded.others] == [verdict]


def test_a_wrong_steady_motion_is_not_called_an_equilibrium() -> None:
    text = b'steady: ["cos(theta) = 2*g/(l*phi\'^2)"]\n'
    [steady] = grader_of("conical-pendulum").grade(Submission("a", (("a.yaml", text),))).others
    words = " ".join([steady.diagnosis, *(e.diagnosis for e in steady.equations)])
    assert "steady motion" in words
    assert "equilibri" not in words
