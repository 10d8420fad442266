"""A page of Markdown for the author of a submission: the verdict, equation by equation, and what could not be read.

Everything that was handed in is set as code or escaped, so that no page contains a link, a picture or HTML made by its
author. The expected equations are not on it.
"""

from __future__ import annotations

import hashlib
import re
import unicodedata
from collections.abc import Iterable, Iterator

from lagrange.answers.points import Score
from lagrange.answers.submissions import Graded
from lagrange.answers.verdicts import EquationVerdict, Verdict
from lagrange.core.printable import visible
from lagrange.render.markdown import escape
from lagsolve.limits import LONGEST_PAGE_NAME

MARKS = {Verdict.EQUIVALENT: "✓", Verdict.WRONG: "✗", Verdict.UNREADABLE: "!", Verdict.UNDECIDED: "?"}


def page(problem: str, name: str, graded: Graded) -> str:
    """The page; `problem` is the title of the problem, `name` that of the submission."""
    return "\n".join(_lines(problem, name, graded))


def _lines(problem: str, name: str, graded: Graded) -> Iterator[str]:
    verdict, _, sentence = graded.headline.partition(": ")
    yield f"# {marked_up(problem)}"
    yield f"\nSubmission: {code(name)}"
    yield f"\n**{verdict.capitalize()}**{': ' if sentence else ''}{marked_up(sentence)}."
    if graded.right is not None and graded.required is not None and graded.required > max(1, graded.right):
        verb = "is" if graded.right == 1 else "are"
        yield f"\n{graded.right} of the {graded.required} independent equations asked for {verb} right."
    if graded.score is not None and graded.score.weighed:
        yield "\n" + "\n".join(_of_points(graded.score))
    if graded.others:
        yield "\n## Question by question\n"
        for answer in graded.others:
            diagnosis = f" ({marked_up(answer.diagnosis)})" if answer.diagnosis else ""
            mark = MARKS.get(answer.verdict, "·")
            yield f"- {mark} {marked_up(answer.name.replace('_', ' '))}: {answer.verdict.value}{diagnosis}"
            for part in answer.equations:
                yield from (f"  {line}" for line in _of_equation(part))
    if graded.equations:
        yield "\n## Equation by equation\n"
        for equation in graded.equations:
            yield from _of_equation(equation)
    if graded.messages:
        yield "\n## How it was read"
        for message in graded.messages:
            yield f"\n{code_block(message)}"
    yield ""


def _of_points(score: Score) -> Iterator[str]:
    total, *parts = score.lines()
    yield f"**{total.capitalize()}**"
    if parts:
        yield ""
        yield from (f"- {marked_up(line)}" for line in parts)


def _of_equation(equation: EquationVerdict) -> Iterator[str]:
    mark = MARKS.get(equation.verdict, "·")
    yield f"- {mark} {code(equation.text)}: {equation.verdict.value}"
    for sentence in (*((equation.diagnosis,) if equation.diagnosis else ()), *equation.remarks):
        yield f"  - {marked_up(sentence)}"


def marked_up(text: str) -> str:
    """Text in which nothing but `names in backticks` is marked up."""
    parts = re.split(r"(`[^`]+`)", " ".join(text.split()))
    return "".join(code(p[1:-1]) if n % 2 else escape(p) for n, p in enumerate(parts))


def code(text: str) -> str:
    """Text as code in a line."""
    text = visible(" ".join(text.split()))
    fence = "`" * (_longest_run(text) + 1)
    pad = " " if not text or "`" in (text[0], text[-1]) else ""
    return f"{fence}{pad}{text or '(nothing)'}{pad}{fence}"


def code_block(text: str) -> str:
    """Text as a block of code."""
    text = visible(text)
    fence = "`" * max(3, _longest_run(text) + 1)
    return f"{fence}text\n{text}\n{fence}"


def _longest_run(text: str) -> int:
    return max((len(run) for run in re.findall("`+", text)), default=0)


def page_names(names: Iterable[str]) -> dict[str, str]:
    """submission -> name of its page: its own name where that is plain; no two agree, in upper or lower case."""
    pages: dict[str, str] = {}
    taken: set[str] = set()
    for name in names:
        plain = _plain(name)
        if plain != name or plain.casefold() in taken:
            plain = f"{plain}-{hashlib.sha256(name.encode('utf-8', 'surrogatepass')).hexdigest()[:12]}"
        taken.add(plain.casefold())
        pages[name] = f"{plain}.md"
    return pages


def _plain(name: str) -> str:
    """The letters, digits and harmless marks of a name; nothing that a system or a shell could misread."""
    text = unicodedata.normalize("NFC", name)
    kept = "".join(c if c.isalnum() or c in "._- " else "_" for c in text).strip(" .-_") or "_"
    while len(kept.encode()) > LONGEST_PAGE_NAME:
        kept = kept[:-1]
    return kept.rstrip(" .")
