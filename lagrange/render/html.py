"""A derivation as a web page: one file without scripts that needs nothing from the network.

Mathematics is MathML; a long equation is several formulas in a row, so that the browser breaks it at its signs. A
table that is wider than a phone is shown there as a list. What is seen is also said: headings in order, table headers,
equations in words of the problem language.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from html import escape
from itertools import groupby

from lagrange.document.derivation import (
    Block,
    CheckMark,
    Derivation,
    Detail,
    Display,
    Equation,
    Math,
    Matrices,
    Part,
    Picture,
    Prose,
    Ref,
    Table,
    Term,
)
from lagrange.document.math_writer import UNICODE, Notation, Writer
from lagrange.render.escape import slug
from lagrange.render.mathml import Formulas
from lagrange.render.shown import shown, written_out
from lagrange.render.stylesheet import CSS
from lagrange.render.svg import figure

MARKS = {True: ("✓", "held", "held"), False: ("✗", "failed", "did not hold"), None: ("?", "open", "undecided")}
CLOSING = re.compile(r"[).,:;]+")
LONG = 12
"""Equations of a display that may be broken between pages."""


def render(derivations: Sequence[tuple[Derivation, Notation]], detail: Detail = Detail.STEPS) -> str:
    """A page with these derivations."""
    articles = [_Article(d, n, detail, _prefix(d, k, derivations)) for k, (d, n) in enumerate(derivations)]
    titles = [clean(a.derivation.title) for a in articles]
    lines = [
        "<!DOCTYPE html>",
        '<html lang="en">',
        "<head>",
        '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{', '.join(titles)}</title>",
        f"<style>\n{CSS}\n</style>",
        "</head>",
        "<body>",
        "<main>",
    ]
    if len(articles) > 1:
        items = (f'<li><a href="#{a.prefix}">{title}</a></li>' for a, title in zip(articles, titles, strict=True))
        lines += ['<nav aria-label="Contents">', "<ol>", *items, "</ol>", "</nav>"]
    for article in articles:
        lines += article.all()
    return "\n".join([*lines, "</main>", "</body>", "</html>"]) + "\n"


def clean(text: str) -> str:
    """Text that stands for itself in HTML."""
    kept = (" " if c.isspace() else c for c in text if c.isspace() or unicodedata.category(c) not in ("Cc", "Cf"))
    return escape("".join(kept))


def _prefix(derivation: Derivation, place: int, derivations: Sequence[tuple[Derivation, Notation]]) -> str:
    """What ids of a derivation begin with; with its place where titles are alike."""
    name = slug(derivation.title)
    alike = sum(slug(d.title) == name for d, _ in derivations) > 1
    return f"{name}-{place + 1}" if alike else name


class _Article:
    """One derivation."""

    def __init__(self, derivation: Derivation, notation: Notation, detail: Detail, prefix: str) -> None:
        self.derivation = derivation
        self.formulas = Formulas.of(notation)
        self.in_pictures = Writer(UNICODE, notation)
        self.content = shown(derivation, detail, pictures=True)
        self.prefix = prefix

    def all(self) -> Iterator[str]:
        yield f'<article id="{self.prefix}">'
        yield f"<h1>{clean(self.derivation.title)}</h1>"
        if self.derivation.source:
            yield f'<p class="source">{clean(self.derivation.source)}</p>'
        for number, step in enumerate(self.content.steps, 1):
            yield f'<h2><span class="count">{number}</span>{clean(step.title)}</h2>'
            for kind, blocks in groupby(step.body, key=type):
                if kind is CheckMark:
                    yield '<ul class="checks">'
                    yield from (self.check(b) for b in blocks if isinstance(b, CheckMark))
                    yield "</ul>"
                else:
                    for block in blocks:
                        yield from self.block(block)
        yield "</article>"

    def block(self, block: Block) -> Iterator[str]:
        match block:
            case Prose():
                yield f"<p>{self.prose(block.parts)}</p>"
            case Display():
                yield from self.display(block)
            case Table():
                yield from self.table(block)
            case Picture():
                yield from self.picture(block)
            case Matrices():
                yield from self.matrices(block)

    def prose(self, parts: Iterable[Part]) -> str:
        """Words and formulas; what closes a phrase stays on the line of the formula before it."""
        found = ""
        for part in parts:
            if isinstance(part, str) and found.endswith("</math>") and (closing := CLOSING.match(part)):
                start = found.rindex("<math")
                found = f'{found[:start]}<span class="together">{found[start:]}{clean(closing[0])}</span>'
                part = part[closing.end() :]
            found += self.part(part)
        return found

    def part(self, part: Part) -> str:
        match part:
            case Math():
                return self.formulas.equation(part.sides, part.relation)
            case Ref() if part.label in self.content.numbers:
                return f'<a href="#{self.id(part.label)}">({self.content.numbers[part.label]})</a>'
            case Ref() if part.label in self.content.hidden:
                hidden = self.content.hidden[part.label]
                return self.formulas.equation(hidden.sides, hidden.relation)
            case Ref():
                return "(?)"
            case Term():
                return f"<em>{clean(part.word)}</em>"
        return clean(part)

    def id(self, label: str) -> str:
        return f"{self.prefix}-{re.sub(r'[^A-Za-z0-9-]+', '-', label)}"

    # Equations

    def display(self, block: Display) -> Iterator[str]:
        equations = block.equations
        aligned = len(equations) > 1 and all(len(e.sides) > 1 and self.formulas.is_short(e.sides[0]) for e in equations)
        kinds = ["display", *["aligned"] * aligned, *["result"] * block.boxed, *["long"] * (len(equations) > LONG)]
        yield f'<div class="{" ".join(kinds)}">'
        for e in equations:
            if aligned:
                yield f'<div class="left">{self.formulas.left(e.sides[0])}</div>'
            body = self.formulas.equation(e.sides, e.relation, displayed=True, first=int(aligned)) + self.condition(e)
            said = self.formulas.text(e.sides, e.relation)
            yield f'<div class="equation" role="math" aria-label="{said}">{body}</div>'
            yield f'<div class="number"{self.anchor(e)}>{self.number(e)}</div>'
        yield "</div>"

    def condition(self, equation: Equation) -> str:
        return f' <span class="condition">{self.prose(equation.condition)}</span>' if equation.condition else ""

    def anchor(self, equation: Equation) -> str:
        return f' id="{self.id(equation.label)}"' if equation.label else ""

    def number(self, equation: Equation) -> str:
        number = self.content.numbers.get(equation.label or "")
        return f"({number})" if number else ""

    # Pictures, matrices, tables and checks

    def picture(self, block: Picture) -> Iterator[str]:
        scene = block.draw()
        if scene is not None:
            yield "<figure>"
            yield from figure(scene, clean(block.alt), self.in_pictures.plain)
            yield f"<figcaption>{self.prose(block.caption)}</figcaption>"
            yield "</figure>"

    def matrices(self, block: Matrices) -> Iterator[str]:
        """Those that fit on a line, the others entry by entry."""
        drawn = [(self.formulas.matrix(name, rows), name, rows) for name, rows in block.named]
        if any(found is not None for found, *_ in drawn):
            yield '<div class="scroll">' + " ".join(found for found, *_ in drawn if found is not None) + "</div>"
        for found, name, rows in drawn:
            if found is None:
                for part in written_out(name, rows):
                    yield from self.block(part)

    def table(self, block: Table) -> Iterator[str]:
        header = [self.part(part) for part in block.header]
        wide = len(block.header) > 3
        yield f'<div class="scroll"><table{" class=" + chr(34) + "wide" + chr(34) if wide else ""}>'
        yield "<thead><tr>" + "".join(f'<th scope="col">{h}</th>' for h in header) + "</tr></thead>"
        yield "<tbody>"
        for row in block.rows:
            first, *others = (self.part(part) for part in row)
            cells = "".join(
                f'<td><span class="label" aria-hidden="true">{h}: </span>{c}</td>'
                for h, c in zip(header[1:], others, strict=True)
            )
            yield f'<tr><th scope="row">{first}</th>{cells}</tr>'
        yield "</tbody></table></div>"

    def check(self, check: CheckMark) -> str:
        sign, kind, said = MARKS[check.passed]
        how = f' <span class="how">{clean(check.how)}</span>' if check.how else ""
        mark = f'<span class="mark {kind}" aria-hidden="true">{sign}</span><span class="unseen">{said}: </span>'
        return f"<li>{mark}{self.prose(check.name)}{how}</li>"
