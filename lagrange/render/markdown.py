r"""A derivation in Markdown with `$...$`, as GitHub, Jupyter, Quarto and pandoc render it.

What they agree on is less than LaTeX, and here is how it is met. Numbers stand behind the equations as `\qquad (3)`,
since not all of them know `\tag`; several equations are one `aligned`, since `align` inside `$$` is an error in LaTeX.
Some take the backslash before a sign for Markdown's, so that there is no `\,` and no `\{`; an underscore behind a
brace begins emphasis for some, unless there is a space before it; and no dollar stands inside mathematics.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
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
    Prose,
    Ref,
    Table,
    Term,
)
from lagrange.document.math_writer import LATEX, WIDE_LATEX, Notation, Writer
from lagrange.render.aligned import ALIGN, Typesetter, at_relations, with_ampersand
from lagrange.render.escape import escape as tex
from lagrange.render.letters_of_vectors import Vectors
from lagrange.render.shown import shown

LINE = 38.0  # ems of an equation beside its number: a column of text on GitHub, at a desk
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
    """Text that stands for itself in Markdown."""
    kept = "".join(
        " " if c.isspace() else c for c in text if c.isspace() or unicodedata.category(c) not in ("Cc", "Cf")
    )
    return _SIGNS.sub(r"\\\1", kept)


def dialect(code: str) -> str:
    """LaTeX in the form that every reader of Markdown understands."""
    for written, instead in _DIALECT:
        code = code.replace(written, instead)
    return code


class _Page:
    """One derivation; what it yields is set apart by empty lines."""

    def __init__(self, derivation: Derivation, notation: Notation, detail: Detail) -> None:
        self.derivation = derivation
        self.typesetter = Typesetter(Writer(LATEX, notation), Writer(WIDE_LATEX, notation))
        self.content = shown(derivation, detail)

    def all(self) -> Iterator[str]:
        yield f"# {escape(self.derivation.title)}"
        if self.derivation.source:
            yield f"*{escape(self.derivation.source).strip()}*"
        for number, step in enumerate(self.content.steps, 1):
            yield f"## {number}. {escape(step.title)}"
            for kind, blocks in groupby(step.body, key=type):
                if kind is CheckMark:
                    yield "\n".join(self.check(b) for b in blocks if isinstance(b, CheckMark))
                else:
                    for block in blocks:
                        yield from self.block(block)

    def block(self, block: Block) -> Iterator[str]:
        match block:
            case Prose():
                yield _OPENING.sub(r"\1\\\2", self.prose(block.parts))
            case Display():
                yield self.display(block)
            case Table():
                yield self.table(block)
            case Matrices():
                for line in self.typesetter.matrices(block.named, LINE):
                    if isinstance(line, str):
                        yield f"$$\n{dialect(line)}\n$$"
                    else:
                        for part in line:
                            yield from self.block(part)

    def prose(self, parts: Iterable[Part]) -> str:
        return "".join(self.part(part) for part in parts)

    def part(self, part: Part) -> str:
        match part:
            case Math():
                return f"${dialect(self.typesetter.inline(part.sides, part.relation, LINE))}$"
            case Ref() if part.label in self.content.numbers:
                return f"({self.content.numbers[part.label]})"
            case Ref() if part.label in self.content.hidden:
                hidden = self.content.hidden[part.label]
                return f"${dialect(self.typesetter.inline(hidden.sides, hidden.relation, LINE))}$"
            case Ref():
                return "(?)"
            case Term():
                return f"*{escape(part.word)}*"
        return escape(part)

    def display(self, block: Display) -> str:
        systems = [self.rows(equation) for equation in block.equations]
        rows = [row for system in systems for row in system]
        if len(rows) == 1:
            code = rows[0].replace(ALIGN, "")
        else:
            at_relation = at_relations(systems)
            lines = " \\\\\n".join(with_ampersand(row, at_relation) for row in rows)
            code = f"\\begin{{aligned}}\n{lines}\n\\end{{aligned}}"
        code = dialect(code)
        return f"$$\n\\boxed{{{code}}}\n$$" if block.boxed else f"$$\n{code}\n$$"

    def rows(self, equation: Equation) -> list[str]:
        """The rows of an equation, with its number behind the last one of the equation itself."""
        codes, below = self.typesetter.rows(equation, LINE, self.condition(equation.condition))
        number = self.content.numbers.get(equation.label or "")
        if number:
            codes[-1] += rf" \qquad ({number})"
        return [*codes, *below]

    def condition(self, parts: Iterable[Part]) -> str:
        """Words and mathematics inside mathematics, where no dollar may stand."""
        codes = []
        for part in parts:
            if isinstance(part, Math):
                codes.append(self.typesetter.writer.relation(part.sides, part.relation))
            else:
                words = part.word if isinstance(part, Term) else self.part(part) if isinstance(part, Ref) else part
                codes.append(_text(words))
        return " ".join(code for code in codes if code)

    def table(self, block: Table) -> str:
        rows = [[self.part(part) or " " for part in row] for row in (block.header, *block.rows)]
        header, *others = (f"| {' | '.join(row)} |" for row in rows)
        return "\n".join([header, "|" + "---|" * len(block.header), *others])

    def check(self, check: CheckMark) -> str:
        how = f" — {escape(check.how)}" if check.how else ""
        return f"- {MARKS[check.passed]} {self.prose(check.name)}{how}"


def _text(words: str) -> str:
    """Words inside mathematics; letters that are mathematics themselves stand beside them."""
    pieces = re.split(r"\$([^$]*)\$", tex(words))
    return "".join(p if n % 2 else rf"\text{{{p}}}" if p else "" for n, p in enumerate(pieces))
