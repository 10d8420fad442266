"""The table of wrong answers derived from wrong models, `slips.txt`, and the feedback on each.

An answer is *helped* if the physical cause is named: the model is one of those expected. It is *true but useless* if the
feedback is true but does not name the cause, or if there is none. It is *misleading* if a model is named that does
not reproduce it, which the program tests, or one that is listed here as no explanation of it.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from lagrange.answers.examiner import Examiner
from lagrange.answers.models.table import MODELS
from lagrange.answers.verdicts import EquationVerdict, Judgement, Verdict
from lagrange.core.diagnostics import Fragment
from lagrange.core.records import record
from tests.support.shared import loaded, solved

FILE = Path(__file__).with_name("slips.txt")


@record
class WrongAnswer:
    """A row of the table: the problem, the models that name the cause, what was done, and the equations."""

    problem: str
    expected: tuple[str, ...]
    mistake: str
    equations: tuple[str, ...]


def wrong_answers() -> list[WrongAnswer]:
    """The rows of the table."""
    found: list[WrongAnswer] = []
    problem = ""
    for line in FILE.read_text(encoding="utf-8").splitlines():
        if line.startswith("@ "):
            problem = line[2:]
        elif line.startswith("--- "):
            names, _, mistake = line[4:].partition(": ")
            expected = tuple(n for n in names.split("|") if n != "-")
            found.append(WrongAnswer(problem, expected, mistake, ()))
        elif not line.startswith("#"):
            last = found.pop()
            found.append(WrongAnswer(last.problem, last.expected, last.mistake, (*last.equations, line)))
    return found


def answers_by(module: str) -> list[WrongAnswer]:
    """The rows that are tried beside one module: that of the first model named, `pairs` for two, `groups` for others."""
    return [w for w in wrong_answers() if _module_of(w.expected[0] if w.expected else "") == module]


def _module_of(name: str) -> str:
    return "pairs" if ";" in name else _MADE_IN.get(name, "groups")


def name_of(answer: WrongAnswer) -> str:
    """The name of a row among tests."""
    return f"{answer.problem}-{answer.mistake}"


_MADE_IN = {m.name: m.changes.__module__.rpartition(".")[2] for m in MODELS}


@cache
def examiner(problem: str) -> Examiner:
    """The examiner of a problem, for all its answers."""
    return Examiner(loaded(problem), solved(problem, complete=False))


def judged(answer: WrongAnswer) -> Judgement:
    """The judgement on an answer."""
    return examiner(answer.problem).check(tuple(map(Fragment.of, answer.equations)))


def feedback_on(problem: str, stated: str) -> str:
    """Everything that is said of an answer, with `;` between its equations."""
    judgement = examiner(problem).check(tuple(map(Fragment.of, stated.split(";"))))
    parts = (judgement.equations, *judgement.others)
    return "; ".join([p.diagnosis for p in parts] + [e.diagnosis for p in parts for e in p.equations])


def helps(answer: WrongAnswer, judgement: Judgement) -> bool:
    """Whether the cause is named."""
    return any(e.model in answer.expected for e in wrong_parts(judgement))


def wrong_parts(judgement: Judgement) -> list[EquationVerdict]:
    """The wrong equations."""
    return [e for e in judgement.each if e.verdict is Verdict.WRONG]


def assert_named(answer: WrongAnswer) -> None:
    """The answer is wrong, and the feedback on each of its wrong equations names the cause."""
    judgement = judged(answer)
    assert judgement.verdict is Verdict.WRONG
    parts = wrong_parts(judgement)
    assert all(part.diagnosis for part in parts)
    if answer.expected:
        assert helps(answer, judgement), [part.diagnosis for part in parts]
