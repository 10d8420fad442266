"""The pages that are handed out."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import pytest

from lagrange.answers.equations import EquationVerdict, Verdict
from lagrange.answers.points import PartScore, Score
from lagrange.answers.submissions import Graded
from lagrange.answers.verdicts import AnswerVerdict
from lagsolve.grading.feedback import code, marked_up, page, page_names

HOSTILE = "</code><script>alert(1)</script> ![x](http://x) [a](b) `code` ``more`` *b* # h | t"


def test_the_page_of_a_wrong_answer() -> None:
    equations = (
        EquationVerdict("theta'' = 0", Verdict.WRONG, "it does not follow from the equations of motion"),
        EquationVerdict("0 = 0", Verdict.TRIVIAL, "it is an identity", ("a remark",)),
    )
    graded = Graded(Verdict.WRONG, "wrong: not every equation follows", equations, ("note[x]: `a` read as b",), 0, 2)
    assert page("Ideal pendulum", "anna.txt", graded) == (
        "# Ideal pendulum\n\nSubmission: `anna.txt`\n\n**Wrong**: not every equation follows.\n\n"
        "0 of the 2 independent equations asked for are right.\n\n## Equation by equation\n\n"
        "- ✗ `theta'' = 0`: wrong\n  - it does not follow from the equations of motion\n"
        "- · `0 = 0`: trivial\n  - it is an identity\n  - a remark\n\n"
        "## How it was read\n\n```text\nnote[x]: `a` read as b\n```\n"
    )


def test_the_parts_of_an_answer_stand_below_it() -> None:
    part = EquationVerdict("lowest: m*g/k", Verdict.WRONG, "it is half as large as it should be")
    asked = AnswerVerdict(Verdict.WRONG, (part,), name="ask")
    freedom = AnswerVerdict(Verdict.WRONG, name="degrees_of_freedom", diagnosis="a constraint is not subtracted")
    score = Score((PartScore("ask", Fraction(0), Fraction(2), "wrong"),), weighed=True)
    text = page("Spring", "a", Graded(Verdict.WRONG, "wrong: no", others=(asked, freedom), score=score))
    assert "\n**Points: 0 of 2**\n" in text
    assert (
        "- ✗ ask: wrong\n  - ✗ `lowest: m*g/k`: wrong\n    - it is half as large as it should be\n"
        "- ✗ degrees of freedom: wrong (a constraint is not subtracted)\n"
    ) in text


def test_nothing_that_was_handed_in_is_marked_up() -> None:
    equation = EquationVerdict(HOSTILE, Verdict.UNREADABLE, HOSTILE, (HOSTILE,))
    text = page(
        HOSTILE, HOSTILE, Graded(Verdict.UNREADABLE, f"unreadable: {HOSTILE}", (equation,), (f"```\n{HOSTILE}",))
    )
    text = re.sub(r"^(`{3,})text\n.*?\n\1$", "", text, flags=re.DOTALL | re.MULTILINE)
    outside = re.sub(r"(?<![`\\])(`+)(?!`).*?(?<!`)\1(?!`)", "", text)
    assert "script" in outside
    assert not re.search(r"(?<!\\)[<\[]", outside)
    assert "](" not in outside.replace("\\]", "")


@pytest.mark.parametrize(
    ("text", "written"),
    [("a", "`a`"), ("`a", "`` `a ``"), ("a``b", "```a``b```"), ("a\nb", "`a b`"), ("", "` (nothing) `")],
)
def test_code_in_a_line(text: str, written: str) -> None:
    assert code(text) == written


def test_names_in_backticks_stay_code() -> None:
    assert marked_up("`x_1` is *not* declared ` <b>") == "`x_1` is \\*not\\* declared \\` \\<b\\>"


@pytest.mark.parametrize(
    "name",
    [
        "../../etc/passwd",
        "..",
        "/abs",
        "a/b",
        "C:\\x",
        "~root",
        "-rf",
        "=1",
        "a\nb",
        ".hidden",
        "CON ",
        "x" * 5000,
        "é" * 300,
        "日本",
    ],
)
def test_a_page_stays_in_its_folder(name: str, tmp_path: Path) -> None:
    file = page_names([name])[name]
    path = (tmp_path / file).resolve()
    assert path.parent == tmp_path.resolve()
    assert not file.startswith((".", "-", "~", "="))
    path.touch()


def test_no_two_submissions_have_the_same_page() -> None:
    names = ["a.txt", "A.TXT", "a/txt", "a?txt", "a_txt", "é", "e\u0301", "x" * 200 + "1", "x" * 200 + "2"]
    pages = page_names(names)
    assert len({p.casefold() for p in pages.values()}) == len(names)
    assert pages["a.txt"] == "a.txt.md"
