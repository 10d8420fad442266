"""Whatever a file says: nothing of it steers a terminal, a page, a table or a program that reads JSON.

Random text with control characters goes through every way by which a message or a page is made, in this process.
"""

from __future__ import annotations

import json
import random
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import pytest
from click.testing import CliRunner

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Grader, Submission
from lagrange.core.diagnostics import Fragment, ProblemError, Source
from lagrange.document.derivation import Emphasis, Step, prose
from lagrange.problem.loader import read_problem
from lagrange.problem.stated_answers import read_answers
from lagrange.render import html, latex, markdown, terminal
from lagsolve.command_group import write_stderr
from lagsolve.grading.feedback import page
from lagsolve.grading.submissions import printable_name
from lagsolve.grading.table import TableRow, csv_text, table_text
from lagsolve.main import main
from tests.support.sample_derivations import pendulum
from tests.support.shared import loaded

STEERS = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060\u2066-\u206f\ufeff\ud800-\udfff\ue000]"
)
PARTS = (
    *("\x1b[2J", "\x1b]0;t\x07", "\x9b31m", "\x00", "\x08", "\x7f", "\r", "\n", "\t", "\x85", "\u2028"),
    *("\u202e", "\u2066", "\u200b", "\u200d", "\ufeff", "\u00ad", "\U000e0041", "\ue000", "\ud800", "\udce9", "\uffff"),
    *(
        "theta''",
        " = ",
        "g/l*sin(theta)",
        "x",
        "\\theta",
        "$",
        "{",
        "`",
        "=1+1",
        "@SUM(A1)",
        "日本",
        "θ̈",
        " ",
        ": ",
        "#",
    ),
)


def nasty(seed: int) -> str:
    chance = random.Random(seed)
    return "".join(chance.choice(PARTS) for _ in range(chance.randint(1, 9)))


def harmless(text: str, ends: str = "") -> bool:
    text.encode()
    found = STEERS.search(text.replace(ends, "") if ends else text)
    assert found is None, (found, text)
    return True


@cache
def examiner() -> Examiner:
    return Examiner.of(loaded("ex11-ideal-pendulum"))


@cache
def grader() -> Grader:
    return Grader.of(examiner())


def messages_of_a_problem(text: str) -> Iterator[str]:
    """A key, a name, a value and an expression, quoted so that YAML reads it as intended; and the raw text."""
    quoted = json.dumps(text)
    for file in (
        f"title: {quoted}\ncoordinates: [x, {quoted}]\n{quoted}: 1\nfind: {quoted}\nforces: {{{quoted}: {{on: {quoted}}}}}\n",
        f"title: T\ncoordinates: [x]\nconstraints: {{a: {quoted}}}\nparameters: {{m: {{assume: {quoted}, unit: {quoted}}}}}\n",
        f"title: T\ncoordinates: [x]\nsource: {text}\n",
    ):
        try:
            yield from map(str, read_problem(Source(f"{text}.yaml", file)).notes)
        except ProblemError as error:
            yield error.show()
        try:
            read_answers(
                Source(text, f"equations: [{quoted}]\nclassification: {quoted}\n{quoted}: 1\n"),
                loaded("ex11-ideal-pendulum"),
            )
        except ProblemError as error:
            yield error.show()


SEEDS = range(300)


def test_messages_about_problems_and_answers() -> None:
    assert all(harmless(message) for seed in SEEDS for message in messages_of_a_problem(nasty(seed)))


def test_verdicts_on_answers() -> None:
    for seed in SEEDS:
        text = nasty(seed)
        judgement = examiner().check((Fragment.of(text, text),))
        assert harmless(judgement.text(80))
        assert all(harmless(str(message)) for message in judgement.messages)


def test_tables_and_pages_of_a_course() -> None:
    for seed in SEEDS[::3]:
        text = nasty(seed)
        content = f"{text}\ntheta'' = {text}\n".encode("utf-8", "replace")
        submission = Submission(printable_name(text), ((f"a{('.txt', '.md', '.tex', '.yaml')[seed % 4]}", content),))
        graded = grader().grade(submission)
        rows = [TableRow.of(submission.name, graded)]
        assert harmless(csv_text(rows), ends="\r\n")
        assert harmless(page(text, submission.name, graded))
        if seed % 30 == 0:
            assert harmless(table_text(rows, 80, on_terminal=False))


def test_pages() -> None:
    derivation, notation = pendulum()
    for seed in range(40):
        text = nasty(seed)
        first = derivation.steps[0]
        step = Step(first.rule, text, (prose(text, Emphasis(text)), *derivation.steps[-1].body))
        hostile = [(replace(derivation, title=text, source=text, steps=(step,)), notation)]
        assert harmless(terminal.text(*hostile[0], 80))
        assert harmless(terminal.coloured(*hostile[0], 80))
        for render in (latex.render, markdown.render, html.render):
            assert harmless(render(hostile))


def test_what_is_wrong_with_the_command_line() -> None:
    for arguments in (["\x1b[2J\u202e.yaml"], ["x.yaml", "-o", "\x1b[2J"], ["check", "ex11", "--format", "\x9b2J"]):
        result = CliRunner().invoke(main, arguments)
        assert result.exit_code == 2
        assert harmless(result.stderr)
        assert "□" in result.stderr or "\\x" in result.stderr


def test_messages_are_harmless_whoever_makes_them(capsys: pytest.CaptureFixture[str]) -> None:
    write_stderr("a\x1b[2J\ud800\nb")
    assert capsys.readouterr().err == "a□[2J□\nb\n"
