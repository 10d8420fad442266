r"""The equations in a file that somebody has written: what is mathematics in it, and what is prose.

    .tex             what stands between `$`, in displays and in environments, if it has a `=`; where there is no
                     mathematics and no `\begin{document}`, each line
    .md              the same, fenced code and code spans; where there is none of these, each line
    everything else  each line, and displays and environments over several lines

A line without a `=` is prose. A line with one is an equation, which may have a number, a label or a bullet before it;
where it has `$`, the equation is between them. Comments are lines that begin with `#` or `%`, and in LaTeX whatever
follows a `%`. Every equation knows where in its file it stands.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Source, Span
from lagrange.expressions.latex_layout import Mark, Region, delimited, equations, has_equation, marks_of, rows

_BULLET = re.compile(r"\s*(?:[*•◦▪]\s+)?")
_MARKDOWN_BULLET = re.compile(r"\s*(?:>\s*)*(?:[-+*]\s+)?")
_NUMBER = re.compile(r"(?:\(\s*(?P<round>[0-9]{1,2})\s*\)\s*|(?P<point>[0-9]{1,2})\.\s+)")
_ENUMERATION = re.compile(r"(?:[0-9]{1,2}|[a-z]|[ivx]{1,4})\s?\)\s*")
_LABEL = re.compile(r"[^=:\\${}()+*/^]{0,60}:(?!=)\s*")
_FENCE = re.compile(r"\s{0,3}(?:[-*+]\s+|[0-9]{1,2}[.)]\s+)?(?P<fence>`{3,}|~{3,})")
_SPAN = re.compile(r"(?<!`)(?P<ticks>`{1,2})(?!`)(?P<code>[^`\n]{1,2000})(?P=ticks)(?!`)")
_BODY, _END = re.compile(r"\\begin\s?\{document\}"), re.compile(r"\\end\s?\{document\}")
_CONTINUES = re.compile(r"\s*(?:[-+*/−·]|\\cdot|\\times)")
_WORDS = re.compile(r"[^\W\d_]{2,}")
_INLINE = ("$", r"\(", r"\)")


def equations_in_file(source: Source, ending: str) -> tuple[Fragment, ...]:
    """The equations in a text; `ending` is that of the file's name: `.tex`, `.md`, ...

    Raises ProblemError at mathematics that is not closed, and at a line that continues another.
    """
    whole = Fragment(source.text, Span(source, 0, len(source.text)), 0)
    match ending.lower():
        case ".tex" | ".latex" | ".ltx":
            return tuple(_in_latex(whole))
        case ".md" | ".markdown":
            return tuple(_in_markdown(whole))
        case _:
            return tuple(_in_lines(whole))


def _part(whole: Fragment, start: int, end: int) -> Fragment:
    return Fragment(whole.text[start:end], whole.span(start, end), (whole.start or 0) + start)


def _regions(whole: Fragment, marks: Sequence[Mark]) -> list[Region]:
    """The mathematics with equations in it."""
    regions, unclosed = delimited(marks)
    if unclosed:
        first = unclosed[0]
        message = f"this `{whole.text[first.start : first.end]}` is not closed"
        span = whole.span(first.start, first.end)
        raise ProblemError(Diagnostic("not-closed", message, span, help="close the mathematics where it ends"))
    return [r for r in regions if has_equation(marks, r)]


def _in_latex(whole: Fragment) -> Iterator[Fragment]:
    begins, ends = _BODY.search(whole.text), _END.search(whole.text)
    start = begins.end() if begins else 0
    body = _part(whole, start, ends.start() if ends and ends.start() > start else len(whole.text))
    marks = marks_of(body.text)
    regions = _regions(body, marks)
    if regions or begins:
        yield from (equation for r in regions for equation in rows(body, marks, r))
    else:
        yield from _in_lines(body)


def _in_markdown(whole: Fragment) -> Iterator[Fragment]:
    blanked, found = _code(whole)
    marks = marks_of(blanked)
    for region in _regions(Fragment(blanked, whole.whole, whole.start), marks):
        found += [(region.start, equation) for equation in rows(whole, marks, region)]
    if found:
        yield from (equation for _, equation in sorted(found, key=lambda f: f[0]))
    else:
        yield from _in_lines(whole, _MARKDOWN_BULLET)


def _code(whole: Fragment) -> tuple[str, list[tuple[int, Fragment]]]:
    """The text with blanks in place of its code, and the equations in that, each with the place of its code."""
    blanked: list[str] = []
    found: list[tuple[int, Fragment]] = []
    fence, begins = "", 0
    for start, end in [*_lines(whole.text), (len(whole.text), len(whole.text))]:
        line = whole.text[start:end]
        opens = _FENCE.match(line)
        last = start == len(whole.text) and bool(fence)
        if fence and (last or (opens and opens["fence"].startswith(fence) and not line[opens.end() :].strip())):
            found += [(begins, equation) for equation in _in_lines(_part(whole, begins, max(begins, start)))]
            fence, line = "", " " * len(line)
        elif fence:
            line = " " * len(line)
        elif opens:
            fence, begins, line = opens["fence"], min(end + 1, len(whole.text)), " " * len(line)
        else:
            shown, at = [], 0
            for span in _SPAN.finditer(line):
                if "=" in span["code"]:
                    code = _part(whole, start + span.start("code"), start + span.end("code"))
                    found += [(start + span.start(), equation) for equation in equations(code)]
                    shown += [line[at : span.start()], " " * len(span[0])]
                    at = span.end()
            line = "".join([*shown, line[at:]])
        blanked.append(line)
    return "\n".join(blanked[:-1]), found


def _in_lines(whole: Fragment, bullet: re.Pattern[str] = _BULLET) -> Iterator[Fragment]:
    """The lines that are equations, and mathematics in displays and environments, over several lines too."""
    marks = [m for m in marks_of(whole.text) if m.kind not in _INLINE]
    regions = _regions(whole, marks)
    number, next_region, last = 0, 0, -2
    for index, (start, end) in enumerate(_lines(whole.text)):
        line = whole.text[start:end]
        if next_region and start < regions[next_region - 1].closes:
            pass
        elif next_region == len(regions) or regions[next_region].opens >= end:
            if not line.strip() or line.lstrip().startswith(("#", "%")):
                continue
            if "=" in line:
                yield from equations(_part(whole, start + _beginning(line, number, bullet), end))
                number, last = number + 1, index
            elif last == index - 1 and _CONTINUES.match(line) and len(_WORDS.findall(line)) < 3:
                message = "this line continues the equation before it"
                help_ = "write an equation on one line, or in an environment of LaTeX"
                raise ProblemError(Diagnostic("continued-line", message, whole.span(start, end), help=help_))
            continue
        while next_region < len(regions) and regions[next_region].opens < end:
            found = rows(whole, marks, regions[next_region])
            number, next_region = number + len(found), next_region + 1
            yield from found


def _beginning(line: str, number: int, bullet: re.Pattern[str]) -> int:
    """Where the equation begins in a line: behind a bullet, its number, or a label that ends with a colon.

    `(2)` and `2.` are numbers where the second equation stands, and factors elsewhere.
    """
    found = bullet.match(line)
    at = found.end() if found else 0
    if (numbered := _NUMBER.match(line, at)) and int(numbered["round"] or numbered["point"]) == number + 1:
        at = numbered.end()
    elif not numbered and (enumerated := _ENUMERATION.match(line, at)):
        at = enumerated.end()
    label = _LABEL.match(line, at)
    return label.end() if label else at


def _lines(text: str) -> Iterator[tuple[int, int]]:
    """Where each line begins and ends."""
    start = 0
    while start <= len(text):
        end = text.find("\n", start)
        end = len(text) if end < 0 else end
        yield start, end
        start = end + 1
