r"""A derivation in Markdown with `$...$`, as GitHub, Jupyter, Quarto and pandoc render it.

They all accept only a part of LaTeX. Numbers follow the equations as `\qquad (3)`, because not all know `\tag`;
several equations are one `aligned`, because `align` inside `$$` is an error in LaTeX. Some read a backslash before
punctuation as Markdown's, so there is no `\,` and no `\{`; for some an underscore after a brace begins emphasis unless
a space precedes it; and there is no dollar inside mathematics. For MyST and Quarto equations have labels instead of
numbers (`notes.flavours`): one for each formula, so that several numbered equations are several formulas. Pictures are
files beside the page, where there is a page to put them beside.

Worksheets in Markdown as the blocks for exercises that MyST and Quarto have: `{exercise}`, `{solution}`, `#exr-`.

Inside such a block there are no headings: the titles of the parts are paragraphs.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import groupby

from lagrange.core.printable import printable
from lagrange.core.records import record
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
    Picture,
    Prose,
    Ref,
    Step,
    Table,
)
from lagrange.document.math_writer import LATEX, RUNNING_LATEX, UNICODE, WIDE_LATEX, Writer
from lagrange.document.names import Notation
from lagrange.render.escape import escape as tex
from lagrange.render.escape import prefixes_of, slug
from lagrange.render.flavours import Flavour, Labels
from lagrange.render.limits import MARKDOWN_LINE
from lagrange.render.selection import Emitter, block_lines, shown
from lagrange.render.svg import Figures, svg_file
from lagrange.render.tex_layout import ALIGN, Typesetter, Vectors, at_relations, with_ampersand

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
_SIGNS = re.compile(r"([\\`*_\[\]<>$|~^{}@])")
_OPENING = re.compile(r"^(\s*\d*)([#+.)-](?=\s|$)|:::|%|\+\+\+|---)")


def render(
    derivations: Sequence[tuple[Derivation, Notation]],
    detail: Detail = Detail.STEPS,
    vectors: Vectors = Vectors.BOLD,
    flavour: Flavour = Flavour.GITHUB,
    figures: Figures | None = None,
) -> str:
    """The derivations, one after the other; their pictures are added to `figures`, without which there are none."""
    prefixes = prefixes_of([derivation.title for derivation, _ in derivations])
    pages = (body(*both, detail, flavour, figures, p) for both, p in zip(derivations, prefixes, strict=True))
    return vectors.written("\n".join(pages))


def body(
    derivation: Derivation,
    notation: Notation,
    detail: Detail = Detail.STEPS,
    flavour: Flavour = Flavour.GITHUB,
    figures: Figures | None = None,
    prefix: str = "",
) -> str:
    """One derivation; its labels begin with `prefix`, by default the slug of its title."""
    page = _Page(derivation, notation, detail, flavour, figures, prefix or slug(derivation.title))
    return "\n\n".join(page.all()) + "\n"


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

    def __init__(
        self,
        derivation: Derivation,
        notation: Notation,
        detail: Detail,
        flavour: Flavour = Flavour.GITHUB,
        figures: Figures | None = None,
        prefix: str = "",
    ) -> None:
        self.derivation = derivation
        self.flavour = flavour
        self.figures = figures
        self.drawn = 0
        self.labels = Labels(prefix or slug(derivation.title), {})
        self.in_pictures = Writer(UNICODE, notation)
        styles = (LATEX, WIDE_LATEX, RUNNING_LATEX)
        self.typesetter = Typesetter(*(Writer(style, notation, on_page=True) for style in styles))
        self.content = shown(derivation, detail, pictures=figures is not None)

    def all(self) -> Iterator[str]:
        yield f"# {escape(self.derivation.title)}"
        if self.derivation.source:
            yield f"*{escape(self.derivation.source).strip()}*"
        yield from self.steps(self.content.steps)

    def steps(self, steps: Iterable[Step], inside: bool = False) -> Iterator[str]:
        """The steps; `inside` a block, where MyST and Quarto have no headings, their titles are paragraphs."""
        number = 0
        for folded, together in groupby(steps, key=lambda step: step.folded):
            first, last = self.flavour.folded(self.prose(folded)) if folded else ("", "")
            if folded:
                yield first
            for step in together:
                if step.title:
                    number += 1
                    title = f"{number}. {escape(step.title)}"
                    plain = inside or (folded and self.flavour.labels)
                    yield f"**{title.replace('.', chr(92) + '.', 1)}**" if plain else f"## {title}"
                yield from block_lines(step.body, self)
            if folded:
                yield last

    def paragraphs(self, run: Sequence[Prose]) -> Iterator[str]:
        return (_OPENING.sub(r"\1\\\2", self.prose(block.parts)) for block in run)

    def prose(self, parts: Iterable[Part]) -> str:
        return "".join(self.part(part) for part in parts)

    def part(self, part: Part) -> str:
        match self.content.resolved(part):
            case Math(sides=sides, relation=relation):
                return f"${dialect(self.typesetter.inline(sides, relation, MARKDOWN_LINE))}$"
            case Ref(label=label) if self.flavour.labels:
                return self.flavour.reference(self.labels.of(label))
            case Ref(label=label):
                return f"({self.content.numbers[label]})"
            case Emphasis(word=word):
                inner = word.strip()  # an asterisk beside a space opens nothing
                before, after = word[: word.index(inner)], word[word.index(inner) + len(inner) :]
                return f"{escape(before)}*{escape(inner)}*{escape(after)}" if inner else escape(word)
            case str(text):
                return escape(text)

    def display(self, block: Display) -> Iterator[str]:
        if self.flavour.labels and len(block.equations) > 1 and any(e.label for e in block.equations):
            for equation in block.equations:  # a formula has one label
                yield from self.display(replace(block, equations=(equation,)))
            return
        systems = [self.rows(equation) for equation in block.equations]
        rows = [row for system in systems for row in system]
        if len(rows) == 1:
            code = rows[0].replace(ALIGN, "")
        else:
            at_relation = at_relations(systems)
            lines = " \\\\\n".join(with_ampersand(row, at_relation) for row in rows)
            code = f"\\begin{{aligned}}\n{lines}\n\\end{{aligned}}"
        code = dialect(code)
        [label, *_] = [self.label(e) for e in block.equations] or [None]
        yield self.flavour.formula(f"\\boxed{{{code}}}" if block.boxed else code, label)

    def rows(self, equation: Equation) -> list[str]:
        """The rows of an equation, with its number after the last one; a condition may follow below."""
        codes, below = self.typesetter.rows(equation, MARKDOWN_LINE, self.condition(equation.condition))
        if not self.flavour.labels and (number := self.content.number(equation)):
            codes[-1] += rf" \qquad {number}"
        return [*codes, *below]

    def label(self, equation: Equation) -> str | None:
        """The label of an equation that is numbered, where the reader numbers."""
        return self.labels.of(equation.label) if self.flavour.labels and equation.label else None

    def condition(self, parts: Iterable[Part]) -> str:
        """Words and mathematics inside a displayed equation, where a dollar would end it."""
        codes = []
        for part in parts:
            match self.content.resolved(part):
                case Math(sides=sides, relation=relation):
                    codes.append(self.typesetter.writer.relation(sides, relation))
                case Ref(label=label):
                    codes.append(self.inside(label))
                case Emphasis(word=text) | str(text):
                    codes.append(_text(text))
        return " ".join(code for code in codes if code)

    def inside(self, label: str) -> str:
        """A reference inside a formula, where no label is read: the number, or the equation where it has a label."""
        if not self.flavour.labels:
            return _text(f"({self.content.numbers[label]})")
        equation = self.content.equation(label)
        return "" if equation is None else self.typesetter.writer.relation(equation.sides, equation.relation)

    def picture(self, block: Picture) -> Iterator[str]:
        scene = block.draw()
        if scene is not None and self.figures is not None:
            file = self.figures.add(svg_file(scene, block.alt, self.in_pictures.plain))
            self.drawn += 1
            label = self.labels.of(f"figure-{self.drawn}")
            yield self.flavour.figure(file, self.prose(block.caption), escape(block.alt), label)

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


Page = _Page
"""One derivation, for layouts that are made of its pieces."""


def _text(words: str) -> str:
    r"""Words as `\text`, except for letters that need mathematics (`$\alpha$`), which come outside it."""
    pieces = re.split(r"\$([^$]*)\$", tex(words))
    return "".join(p if n % 2 else rf"\text{{{p}}}" if p else "" for n, p in enumerate(pieces))


# Exercises


@record
class Sheet:
    """An exercise, its solution, or both."""

    exercise: Derivation | None
    solution: Derivation | None
    notation: Notation


def with_exercises(sheets: Sequence[Sheet], vectors: Vectors, flavour: Flavour, figures: Figures | None = None) -> str:
    """The exercises and solutions, each as a block."""
    either = [s.exercise or s.solution for s in sheets]
    labels = prefixes_of([d.title.removesuffix(": solution") for d in either if d is not None])
    blocks = (b for sheet, label in zip(sheets, labels, strict=True) for b in _blocks(sheet, label, flavour, figures))
    return vectors.written("\n\n".join(blocks) + "\n")


def _blocks(sheet: Sheet, label: str, flavour: Flavour, figures: Figures | None) -> Iterator[str]:
    if sheet.exercise is not None:
        body = _body(sheet.exercise, sheet.notation, flavour, figures, label)
        yield "\n\n".join(flavour.exercise(escape(sheet.exercise.title), label, body))
    if sheet.solution is not None:
        body = _body(sheet.solution, sheet.notation, flavour, figures, f"{label}-solution")
        yield "\n\n".join(flavour.solution(escape(sheet.solution.title), label, body))


def _body(
    derivation: Derivation, notation: Notation, flavour: Flavour, figures: Figures | None, prefix: str
) -> Iterator[str]:
    page = Page(derivation, notation, Detail.STEPS, flavour, figures, prefix)
    if derivation.source:
        yield f"*{escape(derivation.source).strip()}*"
    yield from page.steps(page.content.steps, inside=flavour.labels)
