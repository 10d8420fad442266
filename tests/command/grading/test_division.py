"""Several problems in one submission: what belongs to which, and what happens where nothing says so."""

from __future__ import annotations

import pytest

from lagrange.answers.submissions import Submission
from lagrange.core.diagnostics import Source
from lagsolve.grading.division import AssignedProblem, divided

ASKED = (
    AssignedProblem("ex11", "Ideal pendulum", Source("problems/chapter6/ex11-ideal-pendulum.yaml", "")),
    AssignedProblem("bead", "Bead on a parabola", Source("bead.yaml", "")),
)


def parts(*files: tuple[str, str], asked: tuple[AssignedProblem, ...] = ASKED) -> list[str] | str:
    """What each problem gets: the lines that are not empty, of all its files."""
    found = divided(Submission("s", tuple((name, text.encode()) for name, text in files)), asked)
    if isinstance(found, str):
        return found
    assert [part.problem for part in found] == list(range(len(asked)))
    texts = ("\n".join(content.decode() for _, content in part.files) for part in found)
    return [" | ".join(line.strip() for line in text.split("\n") if line.strip()) for text in texts]


HEADINGS = [
    ("## Problem 1", "## Problem 2"),
    ("Exercise 11", "Problem 2:"),
    ("Ex. 11: the pendulum", "bead"),
    (r"\section*{Ideal pendulum}", r"\subsection{Bead on a parabola}"),
    ("**ex11**", "**Part b)**"),
    ("<h2>Question 1</h2>", "<h2>Question 2</h2>"),
    ("(a)", "(b)"),
    ("1.", "2."),
    ("### ex11-ideal-pendulum", "# BEAD #"),
    ("PROBLEM #1", "problem 2 - the bead"),
]


@pytest.mark.parametrize(("first", "second"), HEADINGS)
def test_a_heading_says_which_problem_follows(first: str, second: str) -> None:
    text = f"Anna, 1234\n\n{first}\n\ntheta'' = 0\n{second}\nx'' = 1\ny = x^2\n"
    name = "answer.html" if "<h2>" in first else "answer.tex" if "\\" in first else "answer.md"
    pendulum, bead = parts((name, text))
    assert "theta'' = 0" in pendulum
    assert "x''" not in pendulum
    assert "x'' = 1 | y = x^2" in bead.replace("<br>", "")


def test_the_answer_may_stand_behind_the_heading() -> None:
    assert parts(("a.txt", "Problem 2: x'' = 1\nex11: theta'' = 0\n")) == ["theta'' = 0", "x'' = 1"]


@pytest.mark.parametrize(
    "line", ["Problem 3", "part = 1", "x'' = 2 problem 2", "p1 = m*v", "q2 = x", "bead = 1", "the bead slides"]
)
def test_what_is_no_heading(line: str) -> None:
    pendulum, bead = parts(("a.txt", f"Problem 1\ntheta'' = 0\n{line}\n"))
    assert pendulum.startswith("theta'' = 0")
    assert bead == ""


def test_lines_keep_their_numbers() -> None:
    found = divided(Submission("s", (("a.txt", b"Problem 2\nx''=1\nProblem 1\ntheta'' = 0"),)), ASKED)
    assert not isinstance(found, str)
    assert [
        part.files[0][1].decode().split("\n").index(line)
        for part, line in zip(found, ("theta'' = 0", "x''=1"), strict=True)
    ] == [3, 1]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("ex11.txt", "bead.tex"),
        ("problem1.txt", "problem2.md"),
        ("1.txt", "2.txt"),
        ("anna-ex11.txt", "anna_bead.txt"),
        ("a", "b"),
    ],
)
def test_the_name_of_a_file(first: str, second: str) -> None:
    assert parts((first, "theta'' = 0"), (second, "x'' = 1")) == ["theta'' = 0", "x'' = 1"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "ex11: {degrees_of_freedom: 1}\nbead:\n  equations: ['x=1']\n",
            ["answers: {degrees_of_freedom: 1}", "answers: | equations: ['x=1']"],
        ),
        ('bead: ["x = 1"]\nproblem 1: "theta = 0"\n', ['equations: "theta = 0"', 'equations: ["x = 1"]']),
        (
            "{ex11: {degrees_of_freedom: 1}, bead: ['x = 1']}",
            ["answers: {degrees_of_freedom: 1}", "equations: ['x = 1']"],
        ),
    ],
)
def test_a_key_of_a_yaml_file(text: str, expected: list[str]) -> None:
    assert parts(("a.yaml", text)) == expected


def test_where_nothing_says_which_problem_it_is() -> None:
    assert "no heading, file name or key says which problem it answers: `ex11`, `bead`" in parts(("anna.txt", "x = 1"))
    found = divided(Submission("s", (("ex11.txt", b"x=1"), ("scratch.txt", b"y=1"))), ASKED)
    assert not isinstance(found, str)
    assert found[0].notes == ("scratch.txt: no heading, file name or key says which problem it answers",)
    assert found[1].files == ()


@pytest.mark.parametrize("content", [b"\xff\xfe\x00", b"a: [", b"x: 1\nx: 2", b"", b"\x00"])
@pytest.mark.parametrize("name", ["a.yaml", "a.txt", "a.html"])
def test_nothing_that_is_handed_in_raises(content: bytes, name: str) -> None:
    divided(Submission("s", ((name, content),)), ASKED)


def test_one_problem_takes_everything() -> None:
    submission = Submission("s", (("anna.txt", b"Problem 7\nx = 1"),))
    assert divided(submission, ASKED[:1]) == (submission,)


def test_a_file_of_a_million_lines_is_not_looked_through() -> None:
    """Each problem gets it whole, and refuses it, within the limits of a submission."""
    content = b"Problem 1\n" * (1 << 16)
    found = divided(Submission("s", (("a.txt", content),)), ASKED)
    assert not isinstance(found, str)
    assert [part.files for part in found] == [(("a.txt", content),)] * 2
