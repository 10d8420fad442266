r"""The equations in a piece of LaTeX: between `$`, in environments, in rows that end with `\\`.

An equation is a range of characters of the text, delimited by marks and not rewritten, so that places in it remain
places in the text. A row that begins with `=`, or with a sign and has no `=`, continues the row before it. Labels and
numbers, punctuation and words next to an equation are omitted. One pass over the text collects the marks; everything
else works on them.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field, replace

from lagrange.core.diagnostics import Fragment, Span
from lagrange.core.records import record
from lagrange.core.units import has_unit


@record
class OneEquation(Fragment):
    """A fragment that is one equation, and is not searched for several; `beside` are words that it stands under."""

    beside: str = field(default="", kw_only=True)


@record
class LatexFragment(OneEquation):
    """A piece of another fragment, from `offset`, that is in LaTeX even where it has neither a backslash nor a `$`."""

    outer: Fragment | None = None
    offset: int = 0

    def span(self, start: int, end: int) -> Span:
        """The place of characters `start` to `end` in the source."""
        return (
            super().span(start, end) if self.outer is None else self.outer.span(self.offset + start, self.offset + end)
        )


@record
class Region:
    """Mathematics between two marks of a text: characters `start` to `end`, `opens` to `closes` with the two marks.

    The marks inside are those numbered `first` to `last` (exclusive).
    """

    start: int
    end: int
    first: int
    last: int
    opens: int = 0
    closes: int = 0


@record
class LayoutMark:
    """Something that matters for the layout: `kind` is its text, or a word for it."""

    kind: str
    start: int
    end: int


_MARK = (
    r"(?s)(?P<comment>%[^\n]*)|\\(?P<side>begin|end)\s?\{(?P<name>[A-Za-z]{1,20}\*?)\}"
    r"|(?P<row>\\\\\*?(?:\[[0-9a-z. ]{1,20}\])?|\\newline(?![A-Za-z]))"
    r"|(?P<words>\\(?:text|textrm|mbox|textit|intertext|shortintertext)\{)"
    r"|(?P<label>\\(?:label|tag\*?|eqref|ref|cite)\s?\{[^{}]{0,200}\})|(?P<box>\\(?:boxed|fbox)\s?\{)"
    r"|(?P<wide>\\(?:quad|qquad|enspace)(?![A-Za-z])|\\hspace\*?\{[^{}]{0,20}\}|\\hfill(?![A-Za-z]))"
    r"|(?P<arrow>\\(?:Rightarrow|Longrightarrow|implies|therefore|because|leadsto|rightarrow|longrightarrow|to"
    r"|Leftrightarrow|Longleftrightarrow|iff)(?![A-Za-z])|[⇒⟹→⟶∴⇔⟺])"
    r"|(?P<equals>:=|\\(?:equiv|coloneqq|triangleq)(?![A-Za-z])|\\(?:overset|stackrel)\s?\{!\}\s?\{=\})"
    r"|(?P<thin>\\(?:[,;:! ]|nonumber|notag|displaystyle|hline|centering|noindent)(?![A-Za-z]))"
    r"|(?P<cases>\\left\s?(?:\\\{|\\lbrace|\.)(?=\s*\\begin)|\\right\s?\.)"
    r"|(?P<column>&)|(?P<sign>\$\$|\$|\\[()\[\]]|\\?[{}]|[()\[\]=,;])|(?P<paragraph>\n[ \t\r]*\n)|\\(?:[A-Za-z]+|.)"
)
"""Compiled when LaTeX is read first: it takes longer than the modules of this package."""
ALTERNATIVE = re.compile(r"\\(?:text|textrm|mbox|mathrm)\{\s*or\s*\}")
"""What separates alternatives; it does not separate equations that hold together."""
_BRACE = re.compile(r"\\.|%[^\n]*|[{}]", re.DOTALL)
_OPEN = {"$": "$", "$$": "$$", r"\(": r"\)", r"\[": r"\]"}
_DISPLAYS = ("$$", r"\[", r"\]")
MATRICES = ("matrix", "pmatrix", "bmatrix", "Bmatrix", "vmatrix", "Vmatrix", "smallmatrix")
_VERBATIM = ("verbatim", "verbatim*", "lstlisting", "comment", "thebibliography")
_ARGUMENTS = re.compile(r"(?:\s?\[[a-z]{0,3}\])?(?:\s?\{[^{}=\\]{0,40}\})?")
_WITH_ARGUMENTS = ("array", "alignat", "alignedat", "aligned", "gathered", "split")
_WORDS = re.compile(r"\\(?:text|textrm|mbox|textit|intertext|shortintertext)\{\s*([^{}]{1,80}?)\s*\}")
_NUMBER = re.compile(r"\([0-9]{1,3}[a-z]?\)\Z")
_WORD = re.compile(r"\\[a-z]+\{(?:[A-Za-z0-9_]*)\}")
_AFTER_NUMBER = re.compile(r"[0-9](?:\s|~|\\[,;:! ])*\Z")
"""What precedes a unit, 5.78\\,\\text{m/s}, which is no word beside an equation."""
_CONJUNCTIONS = frozenset(["and", "where", "with", "so", "thus", "hence", "for", "if", "i", "ii", "iii", "iv"])
_BESIDE = ("label", "thin", "comment", "wide", "cases", "row")


def piece(fragment: Fragment, start: int, end: int) -> LatexFragment:
    """Characters `start` to `end` of a fragment, as LaTeX."""
    return LatexFragment(fragment.text[start:end], fragment.span(start, end), None, fragment, start)


def is_latex(fragment: Fragment) -> bool:
    """Whether a text is LaTeX: it has a backslash or a `$`."""
    certain = isinstance(fragment, LatexFragment) or getattr(fragment, "latex", False)
    return certain or "\\" in fragment.text or "$" in fragment.text


def separated_latex(answer: Iterable[Fragment]) -> tuple[Fragment, ...]:
    """The equations of an answer; one text in LaTeX may have several."""
    return tuple(e for fragment in answer for e in equations(fragment))


def equations(fragment: Fragment) -> Sequence[Fragment]:
    """The equations in one text; the whole text where there are none, so that an error can point at it."""
    if isinstance(fragment, OneEquation) or not is_latex(fragment):
        return (fragment,)
    marks = marks_of(fragment.text)
    regions = [r for r in delimited(marks)[0] if has_equation(marks, r)]
    inside = {m.start for r in regions for m in marks[r.first : r.last] if m.kind == "="}
    outside = [m for m in marks if m.kind == "=" and m.start not in inside]
    if any(not _COUNTS.search(fragment.text[max(0, m.start - 3) : m.end + 3]) for m in outside):  # `$\ddot x$ = 0`
        regions = []
    parts = [e for r in regions or [Region(0, len(fragment.text), 0, len(marks))] for e in rows(fragment, marks, r)]
    return parts or (piece(fragment, 0, len(fragment.text)),)


_COUNTS = re.compile(r"[0-9]\s?=\s?[0-9]")
"""A sum of whole numbers beside the mathematics, `$a = b$. Degrees of freedom: 6 - 1 = 5`."""


def marks_of(text: str) -> list[LayoutMark]:
    """What matters for the layout, in the order of the text. Verbatim environments are skipped."""
    marks = []
    closing = _closing_braces(text)
    at, verbatim = 0, ""
    pattern = re.compile(_MARK)
    while match := pattern.search(text, at):
        start, at = match.start(), match.end()
        side, name = match["side"], match["name"]
        if verbatim:
            verbatim = "" if side == "end" and name == verbatim else verbatim
        elif side == "begin" and name in _VERBATIM:
            verbatim = name
        elif side and name.rstrip("*") in MATRICES:  # in which rows are no equations
            marks.append(LayoutMark("{" if side == "begin" else "}", start, at))
        elif side:
            if name.rstrip("*") in _WITH_ARGUMENTS and side == "begin" and (arguments := _ARGUMENTS.match(text, at)):
                at = arguments.end()
            marks.append(LayoutMark(f"{side} {name}", start, at))
        elif match["words"] and at - 1 not in closing:
            marks.append(LayoutMark("{", at - 1, at))
        elif match.lastgroup:
            at = closing[at - 1] if match["words"] else at
            kind = match[0] if match.lastgroup == "sign" else match.lastgroup
            kind = "=" if kind == "equals" else "wide" if kind == "arrow" else kind
            kind = "or" if ALTERNATIVE.fullmatch(text, start, at) else kind
            marks.append(LayoutMark(kind, start, at))
    return marks


def _closing_braces(text: str) -> dict[int, int]:
    """The position of each `{` that is closed -> the position after the brace that closes it."""
    ends: dict[int, int] = {}
    opened: list[int] = []
    for match in _BRACE.finditer(text):
        if match[0] == "{":
            opened.append(match.start())
        elif match[0] == "}" and opened:
            ends[opened.pop()] = match.end()
    return ends


ENVIRONMENTS = tuple(
    name + star
    for name in (
        "equation", "align", "aligned", "alignat", "alignedat", "flalign", "cases", "dcases", "rcases", "gather",
        "gathered", "split", "multline", "multlined", "array", "eqnarray", "subequations", "math", "displaymath",
        "empheq",
    )
    for star in ("", "*")
)  # fmt: skip
"""The environments in which equations are searched for."""


def delimited(marks: Sequence[LayoutMark]) -> tuple[list[Region], list[LayoutMark]]:
    r"""The outermost parts between `$`, `$$`, `\(`, `\[` or in environments; and the marks that are not closed."""
    regions: list[Region] = []
    unclosed: list[LayoutMark] = []
    opened: LayoutMark | None = None
    index = level = 0
    for n, mark in enumerate(marks):
        if opened is None:
            if mark.kind in _OPEN or (mark.kind.startswith("begin ") and mark.kind[6:] in ENVIRONMENTS):
                opened, index, level = mark, n, 0
            continue
        if opened.kind.startswith("begin "):
            level += (mark.kind == opened.kind) - (mark.kind == f"end {opened.kind[6:]}")
            closes = level < 0
        else:
            closes = mark.kind == _OPEN[opened.kind]
        if closes:
            regions.append(Region(opened.end, mark.start, index + 1, n, opened.start, mark.end))
            opened = None
        elif mark.kind == "paragraph" and opened.kind in ("$", r"\("):
            unclosed += [opened] if any(m.kind == "=" for m in marks[index:n]) else []
            opened = None
    if opened is not None and any(m.kind == "=" for m in marks[index:]):
        unclosed.append(opened)
    return regions, unclosed


def has_equation(marks: Sequence[LayoutMark], region: Region) -> bool:
    """Whether there is a `=` in a region."""
    return any(m.kind == "=" for m in marks[region.first : region.last])


def rows(fragment: Fragment, marks: Sequence[LayoutMark], region: Region) -> list[LatexFragment]:
    """The equations in one region of a text."""
    text, trim = fragment.text, _Trim(fragment.text, marks[region.first : region.last])
    cut = [(start, *trim.both(start, end), equals) for start, end, equals in _cut(text, marks, region)]
    parts = [(start, end, equals) for _, start, end, equals in cut if start < end]
    words = {start: " ".join(_WORDS.findall(text, first, start)) for first, start, end, _ in cut if start < end}
    joined: list[tuple[int, int, bool]] = []
    for n, (start, end, equals) in enumerate(parts):
        if joined and (not joined[-1][2] or _continues(text, *joined[-1][:2], parts[n:])):
            joined[-1] = (joined[-1][0], end, joined[-1][2] or equals)
        else:
            joined.append((start, end, equals))
    return [replace(piece(fragment, start, end), beside=words[start]) for start, end, _ in joined]


def _continues(text: str, begun: int, ended: int, parts: Sequence[tuple[int, int, bool]]) -> bool:
    """Whether the first of the parts continues the equation before it, which has its `=`."""
    start, _, equals = parts[0]
    if text[start] == "=" or text.count("(", begun, ended) > text.count(")", begun, ended):
        return True
    begins_another = any(has for _, _, has in parts) and text[start] not in "+-*/−"
    return not equals and not begins_another


def _cut(text: str, marks: Sequence[LayoutMark], region: Region) -> Iterator[tuple[int, int, bool]]:
    """Cut at rows, delimiters and environments; at commas, wide spaces and columns that another equation follows.

    Yields where each part begins and ends, and whether it has a `=`.
    """
    boxes = _boxes_of_equations(marks, region)
    followed = _followed_by_equation(marks, region)
    start, equals, equals_since_or = region.start, False, False
    braces = brackets = 0
    for n in range(region.first, region.last):
        kind = marks[n].kind
        outside = n in boxes or kind.startswith(("begin ", "end ")) or kind in ("paragraph", *_DISPLAYS)
        if n in boxes:
            pass
        elif kind in ("{", "box"):
            braces += 1
        elif kind == "}":
            braces = max(braces - 1, 0)
        elif kind in ("(", "[", r"\{"):
            brackets += 1
        elif kind in (")", "]", r"\}"):
            brackets = max(brackets - 1, 0)
        elif kind == "=":
            equals = equals_since_or = True
        elif kind == "or":
            equals_since_or = False
        elif braces == 0 and kind == "row":
            outside = True
        elif braces == brackets == 0 and kind in (",", ";", "wide", "words"):
            outside = equals_since_or and n in followed
        elif braces == brackets == 0 and kind == "column" and equals and n in followed:
            outside = text[marks[n].end :].lstrip(" \t\r\n&")[:1] not in "=<>+-"  # in b & = c it goes on
        if outside:
            yield start, marks[n].start, equals
            start, equals, equals_since_or, brackets = marks[n].end, False, False, 0
    yield start, region.end, equals


def _followed_by_equation(marks: Sequence[LayoutMark], region: Region) -> set[int]:
    """The marks that a `=` follows in the same row."""
    followed, follows = set(), False
    for n in range(region.last - 1, region.first - 1, -1):
        kind = marks[n].kind
        if kind == "row" or kind.startswith(("begin ", "end ")):
            follows = False
        elif kind == "=":
            follows = True
        elif kind == "or":
            follows = False
        elif follows:
            followed.add(n)
    return followed


def _boxes_of_equations(marks: Sequence[LayoutMark], region: Region) -> set[int]:
    r"""The marks of each `\boxed{...}` around whole equations."""
    boxes: set[int] = set()
    open_: list[tuple[int, int]] = []
    equals = 0
    for n in range(region.first, region.last):
        kind = marks[n].kind
        equals += kind == "="
        if kind in ("{", "box"):
            open_.append((n, equals))
        elif kind == "}" and open_:
            first, before = open_.pop()
            if marks[first].kind == "box" and equals > before:
                boxes |= {first, n}
    return boxes


class _Trim:
    """Strips what accompanies an equation: spaces, labels, its number, punctuation, words."""

    def __init__(self, text: str, marks: Sequence[LayoutMark]) -> None:
        self.text = text
        self.marks = marks
        self.starts = [m.start for m in marks]
        self.ends = [m.end for m in marks]

    def both(self, start: int, end: int) -> tuple[int, int]:
        """Where the equation itself begins and ends."""
        start = self._from_the_left(start, end)
        return start, self._from_the_right(start, end)

    def _from_the_left(self, start: int, end: int) -> int:
        n = bisect_left(self.starts, start)
        while start < end:
            if self.text[start] in " \t\r\n&~,;" or (
                self.text[start] == ":" and self.text[start + 1 : start + 2] != "="
            ):
                start += 1
            else:
                while n < len(self.marks) and self.starts[n] < start:
                    n += 1
                if n == len(self.marks) or self.starts[n] != start or not self._is_beside(self.marks[n]):
                    break
                start = self.ends[n]
        return min(start, end)

    def _from_the_right(self, start: int, end: int) -> int:
        n = bisect_left(self.ends, end + 1) - 1
        while end > start:
            while n >= 0 and self.ends[n] > end:
                n -= 1
            mark = self.marks[n] if n >= 0 and self.ends[n] == end else None
            if mark is not None and mark.start >= start and self._is_beside(mark):
                end = mark.start
            elif self.text[end - 1] in " \t\r\n&~,;.:":
                end -= 1
            elif (number := _NUMBER.search(self.text, max(start, end - 6), end)) and self._wide_before(number.start()):
                end = number.start()
            else:
                break
        return end

    def _wide_before(self, place: int) -> bool:
        """Whether a wide space precedes a position, up to blanks."""
        n = bisect_left(self.ends, place + 1) - 1
        while n >= 0 and self.starts[n] >= place:
            n -= 1
        return n >= 0 and self.marks[n].kind == "wide" and not self.text[self.ends[n] : place].strip()

    def _is_separate(self, mark: LayoutMark) -> bool:
        """Whether there is a wide space on both sides, or on one and nothing on the other, as around no factor."""
        before, after = self._wide_before(mark.start), self._wide_after(mark.end)
        return (before and (after or not self.text[mark.end :].strip())) or (
            after and not self.text[: mark.start].strip()
        )

    def _wide_after(self, place: int) -> bool:
        """Whether a wide space follows a position, up to blanks."""
        n = bisect_left(self.starts, place)
        return n < len(self.marks) and self.marks[n].kind == "wide" and not self.text[place : self.starts[n]].strip()

    def _is_beside(self, mark: LayoutMark) -> bool:
        if mark.kind != "words":
            return mark.kind in _BESIDE
        if self._is_separate(mark):
            return True
        written = self.text[mark.start : mark.end]
        inside = written[written.index("{") + 1 : -1].strip()
        if _AFTER_NUMBER.search(self.text, max(0, mark.start - 12), mark.start) and has_unit(f"1 {inside}"):
            return False
        return not _WORD.fullmatch(written) or inside in _CONJUNCTIONS or not inside
