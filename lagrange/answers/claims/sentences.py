r"""The sentences of a text, and the relations in them.

    The equilibrium ρ = 0 is stable for Ω² > 2 g c.      ρ = 0   Ω² > 2 g c
    It does not slip if $\mu \ge \tan\alpha$.            \mu \ge \tan\alpha

In plain text a relation ends at words that are no names of the problem, in LaTeX at the delimiters of mathematics.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property

import sympy as sp

from lagrange.answers.limits import LONGEST_CLAIM, MOST_CLAIMS
from lagrange.answers.readings import Reading
from lagrange.answers.written.one_line import is_prose, words_known
from lagrange.answers.written.reading import read_as_written, undeclared
from lagrange.core.diagnostics import Fragment, ProblemError, Source
from lagrange.core.records import record
from lagrange.expressions.reader import limit_of
from lagrange.expressions.scope import Scope

_INEQUALITY = re.compile(r"[<>≤≥≪≫]|\\(?:gt|lt|geq?|leq?|[gl]eqslant)(?![A-Za-z])")
_EQUALITY = re.compile(r"(?<![<>!:=])==?(?![=>])")
_LAYOUT = re.compile(
    r"\\(?:begin|end)\s*\{[^{}]*\}(?:\[[^\[\]]*\])?|\\(?:left|right)(?![A-Za-z])|\\[,;:!]|\\q?quad(?![A-Za-z])|(?<!\\)&"
)
_DELIMITER = re.compile(r"\$\$?|\\[\[\]()](?!\s*\d+(?:pt|ex|em))")
_WORDS_IN_MATHEMATICS = re.compile(r"\\(?:text|mathrm|textrm|mbox)\s*\{([^{}]*)\}")
_END = re.compile(r"[;\n]|\\\\|\.(?=\s|\Z)")
_GOES_ON = re.compile(r"\n(?=\s*(?:if|for|when|where|while|provided|and|or|as\s+long|wenn|für|falls|und|oder)\b)")
_PIECE = re.compile(r",(?=\s|\Z)|[;:](?=\s|\Z)|⇒|⟹|=>|→|->|\\(?:Rightarrow|implies|to)(?![A-Za-z])")
_WORD = re.compile(r"(?<![\w\\'])[^\W\d_]+(?:['’]s)?(?![\w(\[{'^*/])|(?<![\w\\'])[^\W\d_]{2,}(?=\s*\()")

_LINKS = """
the it its if for and or is are was be at in on to of by as so no not one two but can may has out an all any we
das die der den dem ist im am auf und nur bei für wo es ein le la les est et ou si du de
"""
_SHORT_WORDS = frozenset(_LINKS.split())
"""Words of fewer letters than a product of names may have."""


@record
class Relation:
    """A relation in a sentence, with its place there."""

    text: str
    start: int
    end: int

    @property
    def is_inequality(self) -> bool:
        """Whether it has one of the signs of an inequality."""
        return _INEQUALITY.search(self.text) is not None

    def reading(self, scope: Scope) -> Reading:
        """An equation; that at the limit of an inequality."""
        try:
            limit, _ = limit_of(Fragment.of(self.text), "a condition", strict=True)
        except ProblemError as error:
            return Reading(self.text, error=error)
        return read_as_written(limit, scope)

    def positive(self, scope: Scope) -> sp.Expr | None:
        """What is positive where an inequality holds; None if it cannot be read."""
        try:
            limit, side = limit_of(Fragment.of(self.text), "a condition", strict=True)
        except ProblemError:
            return None
        reading = read_as_written(limit, scope)
        if reading.error is not None or len(reading.components) != 1 or side is None:
            return None
        return reading.components[0] * side

    def unknown_names(self, scope: Scope) -> Sequence[str]:
        """The undeclared names for which it cannot be read."""
        return undeclared(self.reading(scope), self.text)


@record
class Sentence:
    """A sentence, without layout and dollar signs, with its relations."""

    text: str
    relations: tuple[Relation, ...]

    @cached_property
    def inequalities(self) -> tuple[Relation, ...]:
        """The relations that are inequalities."""
        return tuple(r for r in self.relations if r.is_inequality)

    @cached_property
    def equations(self) -> tuple[Relation, ...]:
        """The others."""
        return tuple(r for r in self.relations if not r.is_inequality)

    @property
    def words(self) -> str:
        """The sentence without its relations."""
        pieces, at = [], 0
        for r in self.relations:
            pieces += [self.text[at : r.start], " … "]
            at = r.end
        return "".join([*pieces, self.text[at:]])

    @property
    def shown(self) -> str:
        """The sentence in one line."""
        return " ".join(self.text.split()).strip(" .,;:")


def sentences(sources: Sequence[Source], scope: Scope) -> list[Sentence]:
    """The sentences of several texts."""
    made: list[Sentence] = []
    for source in sources:
        text = source.text
        known = words_known(scope, text.splitlines())
        for part in _parts(text):
            if len(made) >= MOST_CLAIMS:
                return made
            if part.strip() and len(part) <= LONGEST_CLAIM:
                made.append(_sentence(part, known))
    return made


def _parts(text: str) -> Iterator[str]:
    text = _WORDS_IN_MATHEMATICS.sub(r"$ \1 $", text)
    text = _GOES_ON.sub(" ", _LAYOUT.sub(" ", text))
    inside, at = False, 0
    boundaries = []
    for m in re.finditer(rf"(?P<mark>{_DELIMITER.pattern})|(?P<end>{_END.pattern})", text):
        if m["mark"]:
            inside = {"\\[": True, "\\(": True, "\\]": False, "\\)": False}.get(m["mark"], not inside)
        elif not (inside and m["end"] == "\n"):
            boundaries.append((at, m.start(), inside))
            at = m.end()
    boundaries.append((at, len(text), inside))
    opened = False
    for start, stop, inside in boundaries:
        yield f"{'$' if opened else ''}{text[start:stop]}{'$' if inside else ''}"
        opened = inside


def _sentence(part: str, known: Callable[[str], bool]) -> Sentence:
    relations = []
    if marks := [*_DELIMITER.finditer(part)]:
        kept, at, inside = [], 0, False
        length = 0
        for m in [*marks, None]:
            stop = m.start() if m else len(part)
            piece = part[at:stop]
            if inside:
                relations += [*_relations(piece, length, None)]
            kept.append(piece)
            length += len(piece)
            at, inside = (m.end() if m else stop), not inside
        return Sentence("".join(kept), tuple(relations))
    return Sentence(part, tuple(_relations(part, 0, known)))


def _relations(text: str, offset: int, known: Callable[[str], bool] | None) -> Iterator[Relation]:
    """The relations in a text: between words if it is no mathematics."""
    cuts = [m.span() for m in _PIECE.finditer(text) if _outside_brackets(text, m.start())]
    if known is not None:
        words = [(m.span(), m[0].rstrip("²³")) for m in _WORD.finditer(text)]
        cuts += [span for span, word in words if word.lower() in _SHORT_WORDS or is_prose(word, known)]
    at = 0
    for start, end in [*sorted(cuts), (len(text), len(text))]:
        piece = text[at:start]
        if at <= start and (_INEQUALITY.search(piece) or _EQUALITY.search(piece)):
            bare = piece.strip(" \t\n.,;")
            bare = bare[:-1] if bare.count(")") > bare.count("(") and bare.endswith(")") else bare
            bare = bare[1:] if bare.count("(") > bare.count(")") and bare.startswith("(") else bare
            first = at + piece.find(bare)
            yield Relation(bare, offset + first, offset + first + len(bare))
        at = max(at, end)


def _outside_brackets(text: str, place: int) -> bool:
    before = text[:place]
    return before.count("(") == before.count(")") and before.count("{") == before.count("}")
