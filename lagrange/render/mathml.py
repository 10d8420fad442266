"""Formulas of a web page: MathML in pieces between which a browser may break the line.

Browsers do not break a formula. So a sum is cut at its signs into several formulas, which are inline elements with a
`<wbr>` between them. A term wider than a phone's column is also cut at the signs inside its brackets; its pieces share
an inline block, so that the browser breaks inside it only if the whole term does not fit on a line. Fractions and tall
brackets cannot be cut; where they are too wide for a phone, the page has a second writing of the formula with
(...)/(...) and brackets of a fixed size, and the style sheet shows one of the two. Widths are estimated in ems.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from html import escape
from itertools import pairwise
from xml.etree import ElementTree

import sympy as sp

from lagrange.core.records import record
from lagrange.document.derivation import Mathematics
from lagrange.document.math_writer import TEXT, Notation, Writer
from lagrange.document.names import BREAK, END, START, plain
from lagrange.document.style_mathml import TIMES, MathML, RunningMathML, WideMathML
from lagrange.render.limits import DESK_ROW, PHONE_LEFT_SIDE, PHONE_PIECE

MATHML, WIDE_MATHML, RUNNING_MATHML = MathML(), WideMathML(), RunningMathML()
_TOKENS = re.compile(f"([{START}{BREAK}{END}])")
_OPERATORS = "+−=≠≤≥<>≡≈→∝∧"
_OPENED = re.compile(r"<\w[^>]*(?<!/)>")
_SMALLER = {"msub", "msup", "msubsup"}


@record
class Formulas:
    """Writes formulas in one notation.

    writer  with fractions and brackets of their full size
    wide    with long fractions and tall brackets that can be cut
    running for running text
    spoken  in the language of problem files, for screen readers
    """

    writer: Writer
    wide: Writer
    running: Writer
    spoken: Writer

    @classmethod
    def of(cls, notation: Notation) -> Formulas:
        """The formulas of a derivation."""
        usual, wide, running = (Writer(s, notation, on_page=True) for s in (MATHML, WIDE_MATHML, RUNNING_MATHML))
        return cls(usual, wide, running, Writer(TEXT, notation))

    def equation(self, sides: Sequence[Mathematics], relation: str, displayed: bool = False, first: int = 0) -> str:
        """a = b = c, beginning with the side numbered `first`; in two writings where a phone needs another one."""
        writer = self.writer if displayed else self.running
        codes = [writer.marked(side) for side in sides]
        flat = [self.wide.marked(side) for side in sides]
        if sum(map(width, codes)) > DESK_ROW:
            return self._written(flat, relation, displayed, first)
        if codes == flat or all(width(piece) <= PHONE_PIECE for code in codes for piece in _cut(code)):
            return self._written(codes, relation, displayed, first)
        desk = self._written(codes, relation, displayed, first, whole_products=True)
        phone = self._written(flat, relation, displayed, first)
        return f'<span class="desk">{desk}</span><span class="phone">{phone}</span>'

    def _written(
        self, codes: Sequence[str], relation: str, displayed: bool, first: int, whole_products: bool = False
    ) -> str:
        sign = self.writer.style.relation(relation)
        style = ' displaystyle="true"' if displayed else ""
        sides = ((sign if n else "") + code for n, code in enumerate(codes) if n >= first)
        return "<wbr>".join(_elements(side, style, whole_products) for side in sides)

    def matrix(self, name: sp.Symbol, rows: Sequence[Sequence[sp.Expr]]) -> str | None:
        """M = (a b; c d); None if it is too wide for a line."""
        cells = [[self.writer.plain(e) for e in line] for line in rows]
        if sum(max(width(line[k]) for line in cells) + 1 for k in range(len(cells[0]))) > DESK_ROW:
            return None
        table = "".join("<mtr>" + "".join(f"<mtd>{cell}</mtd>" for cell in line) + "</mtr>" for line in cells)
        equals = self.writer.style.relation("=")
        matrix = f"<mrow><mo>(</mo><mtable>{table}</mtable><mo>)</mo></mrow>"
        return f'<math displaystyle="true">{self.writer.plain(name)}{equals}{matrix}</math>'

    def left(self, side: Mathematics) -> str:
        """A short left side."""
        return f'<math displaystyle="true">{self.writer.plain(side)}</math>'

    def is_short(self, side: Mathematics) -> bool:
        """Whether the left side leaves room for aligned relations, on a phone too."""
        code = self.writer.marked(side)
        return BREAK not in code and width(code) <= PHONE_LEFT_SIDE

    def text(self, sides: Sequence[Mathematics], relation: str) -> str:
        """The formula in the language of problem files, for screen readers."""
        return escape(self.spoken.relation(sides, relation))


def width(code: str) -> float:
    """The estimated width of elements in ems."""
    return _width(ElementTree.fromstring(f"<mrow>{plain(code)}</mrow>"))


def _width(element: ElementTree.Element) -> float:
    children = [_width(child) for child in element]
    if element.tag == "mfrac":
        return max(children) + 0.2
    if element.tag in _SMALLER:
        return children[0] + 0.72 * max(children[1:])
    if element.tag == "mover":
        return children[0]
    if element.tag == "mo" and element.text and element.text in _OPERATORS:
        return 1.3
    if element.tag == "mspace":
        return 0.17
    own = sum(_letter(c) for c in element.text or "")
    return own + sum(children) + (0.9 if element.tag == "msqrt" else 0.0)


def _letter(character: str) -> float:
    if character in "\u2061\u2062":
        return 0.0
    return 0.8 if character.isupper() or character in "mwMW" else 0.3 if character in "ijl,.|" else 0.55


def _elements(code: str, style: str, whole_products: bool) -> str:
    """A marked sum as formulas in a row: one for each term; a box of several for a term that is too wide."""
    terms = []
    for term in _parts(code):
        pieces = list(_cut(term))
        if not whole_products:
            pieces = [p for piece in pieces for p in _at_factors(piece)]
        formulas = "<wbr>".join(f"<math{style}>{piece}</math>" for piece in pieces)
        terms.append(f'<span class="term">{formulas}</span>' if len(pieces) > 1 else formulas)
    return "<wbr>".join(terms)


def _cut(code: str) -> Iterator[str]:
    """The pieces of a term, cut at inner signs, outer ones first, until each piece fits or has no sign."""
    parts = _parts(code) if width(code) > PHONE_PIECE else [code]
    if len(parts) == 1:
        yield plain(code)
    else:
        for part in parts:
            yield from _cut(part)


def _at_factors(piece: str) -> Iterator[str]:
    """The pieces of a product without signs that is too wide for a phone: cut between its factors."""
    if width(piece) <= PHONE_PIECE:
        yield piece
        return
    room, part, factor = PHONE_PIECE, "", ""
    for text in piece.split(TIMES):
        factor = f"{factor}{TIMES}{text}" if factor else text
        if len(_OPENED.findall(factor)) != factor.count("</"):
            continue  # inside a fraction or a root
        size = width(factor)
        if part and size > room:
            yield part
            room, part = PHONE_PIECE, ""
        part, room, factor = f"{part}{TIMES}{factor}" if part else factor, room - size, ""
    yield part


def _parts(code: str) -> list[str]:
    """The code between its outermost signs; marks of inner signs remain.

    The outermost signs are the shallowest that there are: in -(a + b) they are those inside the bracket.
    """
    tokens = _TOKENS.split(code)
    depth = 0
    breaks = []
    for n, token in enumerate(tokens):
        depth += (token == START) - (token == END)
        if token == BREAK:
            breaks.append((depth, n))
    if not breaks:
        return [code]
    outermost = min(depth for depth, _ in breaks)
    cuts = [0, *(n for depth, n in breaks if depth == outermost), len(tokens)]
    return ["".join(tokens[a:b]).removeprefix(BREAK) for a, b in pairwise(cuts)]
