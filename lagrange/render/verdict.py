"""What is said of somebody's answer, for a terminal or a plain text file.

One line says the verdict; under it each part with its mark, and what is to be said of it on lines of its own. An
equation whose reading could surprise is shown as it was read. Nothing of the derived equations is shown unasked.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.answers.equations import EquationVerdict, Verdict
from lagrange.answers.verdicts import CheckedAnswer
from lagrange.document.math_writer import text as plain
from lagrange.document.math_writer import unicode
from lagrange.document.notation import Notation
from lagrange.problem.model import Problem

MARKS = {
    Verdict.EQUIVALENT: "✓",
    Verdict.WRONG: "✗",
    Verdict.TRIVIAL: "·",
    Verdict.UNREADABLE: "!",
    Verdict.UNDECIDED: "?",
    Verdict.INCOMPLETE: "·",
}
WIDEST = 100  # a longer line is hard to read
_INDENT = "  "
_UNDER = "      "
_LONGEST = 1000  # characters of an equation; more is no answer
_NO_BREAK = "\u00a0"


def text(answer: CheckedAnswer, problem: Problem, width: int, revealed: Sequence[sp.Expr] = ()) -> str:
    """The verdict in lines of at most `width` characters; words that are wider stand on lines of their own.

    revealed  derived equations, each zero, that are to be shown
    """
    notation, width = notation_of_problem(problem), min(width, WIDEST)
    lines = [*_lines(answer, notation, width)]
    if revealed:
        lines += ["", *_wrapped("the derived equations:", width, "", "")]
        for e in revealed:
            lines += _wrapped(f"{plain(e, notation)} = 0", width, _INDENT, _UNDER)
    return "".join(f"{line}\n" for line in lines)


def as_object(answer: CheckedAnswer, problem: Problem, revealed: Sequence[sp.Expr] = ()) -> dict[str, object]:
    """The same for JSON; `reference` has the derived equations."""
    found = answer.as_json()
    if revealed:
        notation = notation_of_problem(problem)
        found["reference"] = [f"{plain(e, notation)} = 0" for e in revealed]
    return found


def notation_of_problem(problem: Problem) -> Notation:
    """How the symbols of a problem are written."""
    new = [q for c in problem.choices for q in c.coordinates]
    return Notation(
        coordinates=tuple(dict.fromkeys((*problem.slots.coordinates, *new))),
        prescribed=problem.slots.prescribed,
        parameters=tuple(p.symbol for p in problem.parameters),
        forces=problem.unknowns,
        scalar_names=frozenset(problem.scope.scalars),
    )


def _lines(answer: CheckedAnswer, notation: Notation, width: int) -> Iterator[str]:
    yield from _wrapped(answer.headline, width, "", _INDENT)
    for part in answer.others:
        yield from _wrapped(f"{MARKS[part.verdict]} {part.name.replace('_', ' ')}", width, _INDENT, _UNDER)
        if part.diagnosis:
            yield from _wrapped(part.diagnosis, width, _UNDER, _UNDER)
        for e in part.equations:
            yield from _equation(e, notation, width, _INDENT + _INDENT)
    for e in answer.equations.equations:
        yield from _equation(e, notation, width, _INDENT)


def _equation(e: EquationVerdict, notation: Notation, width: int, indent: str) -> Iterator[str]:
    under = indent + _UNDER[len(_INDENT) :]
    room = width - len(under)
    written = " ".join(e.text.split())
    written = written if len(written) <= _LONGEST else f"{written[:_LONGEST]} ..."
    yield from _wrapped(f"{MARKS[e.verdict]} {_held(written, room)}", width, indent, under)
    if e.sides:
        read = " = ".join(unicode(side, notation) for side in e.sides)
        yield from _wrapped(f"read as {_held(read, room)}", width, under, under + _INDENT)
    for said in (e.diagnosis, *e.remarks):
        if said:
            yield from _wrapped(said, width, under, under)


def _held(equation: str, room: int) -> str:
    """An equation that is broken before its signs and not inside brackets, where its terms are not too long."""
    depth, held = 0, []
    for c in equation:
        depth += (c in "([{") - (c in ")]}")
        held.append(_NO_BREAK if c == " " and depth > 0 else c)
    words = re.sub("([-+=−]) ", rf"\1{_NO_BREAK}", "".join(held)).split(" ")
    return " ".join(w if len(w) < room else w.replace(_NO_BREAK, " ") for w in words)


def _wrapped(line: str, width: int, first: str, others: str) -> list[str]:
    """A line, broken at blanks where it is too wide, and inside a word only where that is wider than a line."""
    lines = textwrap.wrap(line, max(width, 20), initial_indent=first, subsequent_indent=others, break_on_hyphens=False)
    return [x.replace(_NO_BREAK, " ") for x in lines] or [first.rstrip()]
