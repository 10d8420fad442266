r"""A derivation in Markdown with `$...$`, as GitHub, Jupyter, Quarto and pandoc render it.

What all of them accept is less than LaTeX. Numbers follow the equations as `\qquad (3)`, because not all know `\tag`;
several equations are one `aligned`, because `align` inside `$$` is an error in LaTeX. Some read a backslash before
punctuation as Markdown's, so there is no `\,` and no `\{`; for some an underscore after a brace begins emphasis unless
a space precedes it; and there is no dollar inside mathematics.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby

from lagrange.core.printable import printable
from lagrange.document.derivation import (
    CheckMark,
    Derivation,
    Detail,
    Display,
    Emphasis,
    Equation,
    Math,
    Matrices,
    Part,
    Prose,
    Ref,
    Table,
)
from lagrange.document.math_writer import LATEX, WIDE_LATEX, Notation, Writer
from lagrange.render.escape import escape as tex
from lagrange.render.limits import MARKDOWN_LINE
from lagrange.render.selection import shown
from lagrange.render.tex_layout import ALIGN, Typesetter, Vectors, at_relations, with_ampersand
from lagrange.render.walk import Emitter, block_lines

MARKS = {True: "✓", False: "✗", None: "?"}
_DIALECT = (
    (r" \, ", " "),
    (r"\,", " "),
    (r"\left\{", r"\left\lbrace"),
    (r"\right\}", r"\right\rbrace"),
    (r"\biggl\{", r"\biggl\lbrace"),
    (r"\biggr\}", r"\biggr\rbrace"),
    (r"\{", r"\lbrace "),
    (r"\}", r"\rbrace "),
    ("}_", "} _"),
    ("<", r"\lt "),
    (">", r"\gt "),
    ("](", "] ("),
)
_SIGNS = re.compile(r"([\\`*_\[\]<>$|~])")
_OPENING = re.compile(r"^(\s*\d*)([#+.)-])(?=\s|$)")


def render(
    derivations: Sequence[tuple[Derivation, Notation]],
    detail: Detail = Detail.STEPS,
    vectors: Vectors = Vectors.BOLD,
) -> str:
    """The derivations, one after the other."""
    return vectors.written("\n".join(body(derivation, notation, detail) for derivation, notation in derivations))


def body(derivation: Derivation, notation: Notation, detail: Detail = Detail.STEPS) -> str:
    """One derivation."""
    return "\n\n".join(_Page(derivation, notation, detail).all()) + "\n"


def escape(text: str) -> str:
    """Text as Markdown that shows it."""
    return _SIGNS.sub(r"\\\1", printable(text))


def dialect(code: str) -> str:
    """LaTeX in the form that every reader of Markdown understands."""
    for latex, everywhere in _DIALECT:
        code = code.replace(latex, everywhere)
    return code


class _Page(Emitter[str]):
    """One derivation: paragraphs and displays, which empty lines will separate."""

    def __init__(self, derivation: Derivation, notation: Notation, detail: Detail) -> None:
        self.derivation = derivation
        self.typesetter = Typesetter(Writer(LATEX, notation, on_page=True), Writer(WIDE_LATEX, notation, on_page=True))
        self.content = shown(derivation, detail)

    def all(self) -> Iterator[str]:
        yield f"# {escape(self.derivation.title)}"
        if self.derivation.source:
            yield f"*{escape(self.derivation.source).strip()}*"
        number = 0
        for folded, steps in groupby(self.content.steps, key=lambda step: step.folded):
            if folded:
                yield f"<details><summary>{self.prose(folded)}</summary>"
            for step in steps:
                if step.title:
                    number += 1
                    yield f"## {number}. {escape(step.title)}"
                yield from block_lines(step.body, self)
            if folded:
                yield "</details>"

    def paragraphs(self, run: Sequence[Prose]) -> Iterator[str]:
        return (_OPENING.sub(r"\1\\\2", self.prose(block.parts)) for block in run)

    def prose(self, parts: Iterable[Part]) -> str:
        return "".join(self.part(part) for part in parts)

    def part(self, part: Part) -> str:
        match self.content.resolved(part):
            case Math(sides=sides, relation=relation):
                return f"${dialect(self.typesetter.inline(sides, relation, MARKDOWN_LINE))}$"
            case Ref(label=label):
                return f"({self.content.numbers[label]})"
            case Emphasis(word=word):
                return f"*{escape(word)}*"
            case str(text):
                return escape(text)

    def display(self, block: Display) -> Iterator[str]:
        systems = [self.rows(equation) for equation in block.equations]
        rows = [row for system in systems for row in system]
        if len(rows) == 1:
            code = rows[0].replace(ALIGN, "")
        else:
            at_relation = at_relations(systems)
            lines = " \\\\\n".join(with_ampersand(row, at_relation) for row in rows)
            code = f"\\begin{{aligned}}\n{lines}\n\\end{{aligned}}"
        code = dialect(code)
        yield f"$$\n\\boxed{{{code}}}\n$$" if block.boxed else f"$$\n{code}\n$$"

    def rows(self, equation: Equation) -> list[str]:
        """The rows of an equation, with its number after the last one; a condition may follow below."""
        codes, below = self.typesetter.rows(equation, MARKDOWN_LINE, self.condition(equation.condition))
        if number := self.content.number(equation):
            codes[-1] += rf" \qquad {number}"
        return [*codes, *below]

    def condition(self, parts: Iterable[Part]) -> str:
        """Words and mathematics inside a displayed equation, where a dollar would end it."""
        codes = []
        for part in parts:
            match self.content.resolved(part):
                case Math(sides=sides, relation=relation):
                    codes.append(self.typesetter.writer.relation(sides, relation))
                case Ref(label=label):
                    codes.append(_text(f"({self.content.numbers[label]})"))
                case Emphasis(word=text) | str(text):
                    codes.append(_text(text))
        return " ".join(code for code in codes if code)

    def matrices(self, block: Matrices) -> Iterator[str]:
        for line in self.typesetter.matrices(block.named, MARKDOWN_LINE):
            if isinstance(line, str):
                yield f"$$\n{dialect(line)}\n$$"
            else:
                yield from block_lines(line, self)

    def table(self, block: Table) -> Iterator[str]:
        rows = [[self.part(part) or " " for part in row] for row in (block.header, *block.rows)]
        header, *others = (f"| {' | '.join(row)} |" for row in rows)
        yield "\n".join([header, "|" + "---|" * len(block.header), *others])

    def checks(self, run: Sequence[CheckMark]) -> Iterator[str]:
        ways = (f" — {escape(check.how)}" if check.how else "" for check in run)
        yield "\n".join(f"- {MARKS[c.passed]} {self.prose(c.name)}{how}" for c, how in zip(run, ways, strict=True))


def _text(words: str) -> str:
    r"""Words as `\text`, except for letters that need mathematics (`$\alpha$`), which come outside it."""
    pieces = re.split(r"\$([^$]*)\$", tex(words))
    return "".join(p if n % 2 else rf"\text{{{p}}}" if p else "" for n, p in enumerate(pieces))
