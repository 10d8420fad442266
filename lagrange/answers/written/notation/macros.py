r"""The abbreviations of a LaTeX document, `\newcommand{\tdd}{\ddot\theta}`, written out in its equations.

`\newcommand`, `\renewcommand`, `\providecommand`, `\def` without patterns and `\DeclareMathOperator` are known, with up
to three arguments. A definition may use those before it. Nothing is expanded twice, and no text grows beyond what an
equation may have, so that the work is bounded.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

from lagrange.answers.limits import LONGEST_MACRO, MOST_MACROS
from lagrange.core.diagnostics import Fragment
from lagrange.core.records import record
from lagrange.expressions.edits import Draft, Edit, closings
from lagrange.expressions.latex_layout import OneEquation
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS

_DEFINES = re.compile(
    r"\\(?:(?:re)?newcommand|providecommand|DeclareRobustCommand)\*?\s*(?:\{\s*\\(?P<name>[A-Za-z]{1,20})\s*\}|\\(?P<bare>[A-Za-z]{1,20}))"
    r"\s*(?:\[(?P<arguments>[0-3])\])?\s*(?=\{)"
    r"|\\def\s*\\(?P<old>[A-Za-z]{1,20})\s*(?P<pattern>(?:#[1-3]){0,3})\s*(?=\{)"
    r"|\\DeclareMathOperator\*?\s*\{\s*\\(?P<operator>[A-Za-z]{1,20})\s*\}\s*(?=\{)"
)


@record
class Macro:
    """What a command stands for."""

    body: str
    arguments: int = 0


def macros_of(text: str) -> dict[str, Macro]:
    """The commands that a text defines, each written out in those before it."""
    if not re.search(r"\\(?:(?:re)?newcommand|providecommand|def|DeclareMathOperator)(?![a-z])", text):
        return {}
    ends = closings(text)
    macros: dict[str, Macro] = {}
    for match in _DEFINES.finditer(text):
        end = ends.get(match.end())
        if end is None or len(macros) >= MOST_MACROS or end - match.end() > LONGEST_MACRO:
            continue
        body = text[match.end() + 1 : end]
        if match["operator"]:
            macros[match["operator"]] = Macro(rf"\operatorname{{{body}}}")
            continue
        body = _expanded(body, macros)
        if len(body) <= LONGEST_MACRO:
            number = int(match["arguments"] or 0) or (match["pattern"] or "").count("#")
            macros[match["name"] or match["bare"] or match["old"]] = Macro(body, number)
    return macros


def with_macros(fragment: Fragment, macros: Mapping[str, Macro]) -> Fragment:
    """An equation with the commands written out."""
    draft = Draft(fragment)
    if not draft.apply(_edits(draft.text, macros)) or len(draft.text) > MAX_ANSWER_CHARACTERS:
        return fragment
    made = draft.finished(latex=True)
    beside = getattr(fragment, "beside", "")
    return replace(made, beside=beside) if isinstance(made, OneEquation) else made


def _expanded(text: str, macros: Mapping[str, Macro]) -> str:
    draft = Draft(Fragment.of(text))
    draft.apply(_edits(text, macros))
    return draft.text


def _edits(text: str, macros: Mapping[str, Macro]) -> Iterator[Edit]:
    if not macros:
        return
    ends = closings(text)
    for match in re.finditer(r"\\([A-Za-z]{1,20})(?![A-Za-z])", text):
        macro = macros.get(match[1])
        if macro is None:
            continue
        at, given = match.end(), []
        for _ in range(macro.arguments):
            while at < len(text) and text[at].isspace():
                at += 1
            if at < len(text) and text[at] == "{" and at in ends:
                given.append(text[at + 1 : ends[at]])
                at = ends[at] + 1
            elif (single := re.compile(r"\\[A-Za-z]+|[^\s{}]").match(text, at)) is not None:
                given.append(single[0])
                at = single.end()
        if len(given) == macro.arguments:
            body = re.sub(r"#([1-3])", partial(_argument, given), macro.body)
            raised = text[: match.start()].rstrip()[-1:] in ("^", "_") or text[at:].lstrip()[:1] in ("^", "_")
            yield match.start(), at, f"{{{body}}}" if raised else f"{body} "


def _argument(given: Sequence[str], match: re.Match[str]) -> str:
    number = int(match[1])
    return given[number - 1] if number <= len(given) else match[0]
