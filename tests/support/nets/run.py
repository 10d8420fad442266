"""The program under test: one text solved in this process within a limit of processor time, and what a net reports."""

from __future__ import annotations

import json
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType
from typing import Any

from lagrange.api.interface import check, loads
from lagrange.api.result import Result
from lagrange.core.diagnostics import ProblemError
from lagrange.explain.report import Report, report
from lagrange.render.json import as_object
from tests.support.nets.in_print import names_of_file, unfit

SECONDS = 120.0
"""Of processor time, for one case: another process that keeps the machine busy is no finding."""


@dataclass(frozen=True)
class Finding:
    """A statement that is not true, or a result that is missing.

    kind  what sort of statement it is, for counting: "false equilibrium", "stability", ...
    """

    kind: str
    said: str
    true: str
    text: str = ""

    def __str__(self) -> str:
        return f"{self.kind}\n  said: {self.said}\n  true: {self.true}\n" + "\n".join(
            f"    {x}" for x in self.text.splitlines()
        )


class TooLongError(BaseException):
    """Not an `Exception`, so that nothing on the way takes it for one of its own."""


@contextmanager
def limited(seconds: float = SECONDS) -> Iterator[None]:
    """Raises TooLongError after so many seconds of processor time. In the main thread only."""

    def stop(_: int, __: FrameType | None) -> None:
        raise TooLongError

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


@dataclass
class Printed:
    """What is printed of one problem: the JSON object, and the report from which an answer is judged."""

    text: str
    report: Report
    json: dict[str, Any]
    choice: str = ""

    def in_choice(self, name: str) -> Printed:
        """What is printed of it in a choice of generalized coordinates."""
        [chosen] = [c for c in self.json["choices"] if c["name"] == name]
        kept = {k: self.json[k] for k in ("steps", "problem", "checks")}
        return Printed(self.text, self.report, kept | {"constraints": []} | chosen, name)

    def verdict(self, answer: list[list[str]] | list[str]) -> str:
        """The verdict of `check` on an answer; "too long" where there is none within the limit."""
        try:
            with limited():
                return str(check(Result(self.report), answer).verdict.value)
        except TooLongError:
            return "too long"

    def page(self) -> str:
        return json.dumps(self.json["steps"], ensure_ascii=False)


def printed(text: str) -> Printed | Finding:
    """A problem solved. An error of the project's own is a finding too: the files are right."""
    try:
        with limited():
            solved = report(loads(text))
            return Printed(text, solved, as_object(solved))
    except TooLongError:
        return Finding("too long", f"nothing within {SECONDS:g} s of processor time", "it ends", text)
    except ProblemError as error:
        return Finding("refused", str(error)[:600], "an ordinary problem", text)
    except Exception as error:
        return Finding("exception", f"{type(error).__name__}: {error}"[:600], "no exception", text)


def wrong_names(shown: Printed) -> list[Finding]:
    """What must never be printed, names that are not of the file, and checks of the program's own that fail."""
    found = {
        (kind, bad): Finding(kind, f"{bad} in {text[:200]}", "no such thing in print", shown.text)
        for kind, bad, text in unfit(shown.report, shown.json, names_of_file(shown.text))
    }
    failed = [c["name"] for c in shown.json["checks"] if c["passed"] is False]
    if failed:
        found["own check", ""] = Finding(
            "own check", f"does not hold: {'; '.join(failed)}", "every check holds", shown.text
        )
    return [*found.values()]
