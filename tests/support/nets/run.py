"""The program under test: one text solved in this process within a limit of processor time, and what a net reports."""

from __future__ import annotations

import json
import re
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
from tests.support.nets.evaluate import names_in

SECONDS = 30.0
"""Of processor time, for one case: another process that keeps the machine busy is no finding."""

PREDEFINED = {"i", "j", "k", "e_x", "e_y", "e_z", "t", "pi", "delta", "d", "omega", "lambda", "xi", "V", "diff"}
NOT_IN_PRINT = re.compile(
    r"\bnan\b|\bzoo\b|\boo\b|DiracDelta|_of_equilibrium|Subs\(|Derivative\(|Piecewise|RootOf|_?Dummy"
)


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


def strings(value: Any) -> Iterator[str]:
    """All texts in a JSON object."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for v in value.values():
            yield from strings(v)
    elif isinstance(value, list):
        for v in value:
            yield from strings(v)


RESULTS = ("equilibrium", "equilibrium_conditions", "generalized_forces", "equations", "accelerations", "linearization",
           "reactions", "conserved", "newton", "equations_with_multipliers", "mass_matrix", "force_vector")  # fmt: skip
WORDS = {"kind", "because", "stability", "how", "name", "choice", "unit"}


def wrong_names(shown: Printed, names: set[str]) -> list[Finding]:
    """Symbols that are no names of the file, and what must never be printed; checks of the program's own that fail."""
    found = []
    known = names | PREDEFINED | {f"lambda_{c['name']}" for c in shown.json["constraints"]}
    for key in RESULTS:
        for text in _expressions(shown.json.get(key)):
            strange = {n for n in names_in(text) - known if not re.fullmatch(r"(xi|omega|lambda)_\w+", n)}
            if strange:
                found.append(
                    Finding(
                        "strange symbol", f"{key}: {text}", f"no {', '.join(sorted(strange))} in the file", shown.text
                    )
                )
    for text in strings(shown.json):
        if NOT_IN_PRINT.search(text):
            found.append(Finding("not for print", text[:200], "no such thing in print", shown.text))
            break
    failed = [c["name"] for c in shown.json["checks"] if c["passed"] is False]
    if failed:
        found.append(Finding("own check", f"does not hold: {'; '.join(failed)}", "every check holds", shown.text))
    return found


def _expressions(value: Any) -> Iterator[str]:
    if isinstance(value, dict):
        for k, v in value.items():
            if k not in WORDS:
                yield from _expressions(v)
    elif isinstance(value, list):
        for v in value:
            yield from _expressions(v)
    elif isinstance(value, str):
        yield value
