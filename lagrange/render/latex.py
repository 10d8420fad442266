r"""A derivation in LaTeX, as typed by hand: `equation`, `align`, `\eqref`, tables and boxed results.

`render` makes a document that compiles with pdflatex, or a fragment for \input; `body` is what one derivation
contributes. Labels are stable: the slug of the title and the id of the equation. Whether a line is too long is judged
by an estimate of its width in ems (`tex_layout.ems`); a broken equation is set in rows, aligned at its terms.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

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
    Table,
    Task,
)
from lagrange.document.math_writer import LATEX, RUNNING_LATEX, WIDE_LATEX, Notation, Writer
from lagrange.render.escape import escape, prefixes_of, slug
from lagrange.render.limits import LATEX_LINE, TALL_BOX
from lagrange.render.selection import Emitter, block_lines, shown
from lagrange.render.tex_layout import ALIGN, Typesetter, Vectors, at_relations, ems, unbroken, with_ampersand
from lagrange.render.tikz import picture

PACKAGES = r"""\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage{lmodern}
\usepackage{amsmath,amssymb}
\usepackage{tikz}
\usetikzlibrary{arrows.meta}
"""
PREAMBLE = r"""\documentclass[11pt,a4paper]{article}
PACKAGES
\usepackage[margin=25mm, top=18mm, bottom=20mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.5\baselineskip}
\setlength{\emergencystretch}{3em}
\allowdisplaybreaks
""".replace("PACKAGES\n", PACKAGES)
PICTURES = r""", \usepackage{tikz} and \usetikzlibrary{arrows.meta}
% for pictures"""
FRAGMENT = r"""% lagsolve: needs \usepackage{amsmath,amssymb}PICTURES, a text width of about 160 mm at 11 pt,
% and for long formulas in the text \setlength{\emergencystretch}{3em}
"""
LARGE = 1.44
"""How much wider the letters of a title are."""
MARKS = {True: r"$\checkmark$", False: r"$\times$", None: "?"}


def render(
    derivations: Sequence[tuple[Derivation, Notation]],
    fragment: bool = False,
    detail: Detail = Detail.STEPS,
    vectors: Vectors = Vectors.BOLD,
    apart: str = "\n",
) -> str:
    """A document with these derivations, or the fragment that goes into one; `apart` is between two of them."""
    prefixes = prefixes_of([derivation.title for derivation, _ in derivations])
    bodies = apart.join(body(*both, detail, prefix) for both, prefix in zip(derivations, prefixes, strict=True))
    bodies = vectors.written(bodies)
    if fragment:
        return FRAGMENT.replace("PICTURES", PICTURES if r"\begin{tikzpicture}" in bodies else "") + bodies
    return f"{PREAMBLE}\n\\begin{{document}}\n\n{bodies}\n\\end{{document}}\n"


def body(derivation: Derivation, notation: Notation, detail: Detail = Detail.STEPS, prefix: str = "") -> str:
    """What one derivation contributes; its labels begin with `prefix`, by default the slug of its title."""
    return "\n".join(_Article(derivation, notation, detail, prefix or slug(derivation.title)).all()) + "\n"


@record
class _Row:
    """A row of `align`."""

    code: str
    anchor: str = ""


class _Article(Emitter[str]):
    """One derivation."""

    def __init__(self, derivation: Derivation, notation: Notation, detail: Detail, prefix: str) -> None:
        self.derivation = derivation
        styles = (LATEX, WIDE_LATEX, RUNNING_LATEX)
        self.typesetter = Typesetter(*(Writer(style, notation, on_page=True) for style in styles))
        self.content = shown(derivation, detail, pictures=True, folded=False)
        self.prefix = prefix

    def all(self) -> Iterator[str]:
        source = escape(self.derivation.source)
        title = escape(self.derivation.title)
        beside = LARGE * ems(title) + ems(source) < LATEX_LINE
        at_right = rf" \hfill \textnormal{{\normalsize {source}}}" if source and beside else ""
        yield rf"\section*{{{title}{at_right}}}"
        if source and not beside:
            yield rf"\emph{{{source}}}" + "\n"
        number = 0
        for step in self.content.steps:
            yield ""
            if step.title:
                number += 1
                yield rf"\subsection*{{{number}\quad {escape(step.title)}}}"
                if isinstance(step.body[0], Display) and len(step.body[0].equations) > 1 and not step.body[0].boxed:
                    yield r"\vspace{-\baselineskip}"  # of the empty paragraph with which `align` begins
            yield from block_lines(step.body, self)
        for choice in dict.fromkeys(self.content.folded.values()):
            yield f"% more on request: --choice {printable(choice) or 'all'}"

    # Words

    def paragraphs(self, run: Sequence[Prose]) -> Iterator[str]:
        yield "\n\n".join(self.prose(block.parts) for block in run)

    def prose(self, parts: Iterable[Part]) -> str:
        return "".join(self.part(part) for part in parts)

    def part(self, part: Part) -> str:
        match self.content.resolved(part):
            case Math(sides=sides, relation=relation):
                return f"${unbroken(self.typesetter.inline(sides, relation, LATEX_LINE))}$"
            case Ref(label=label):
                return rf"\eqref{{{self.label(label)}}}"
            case Emphasis(word=word):
                return rf"\emph{{{escape(word)}}}"
            case str(text):
                return escape(text)

    def label(self, label: str) -> str:
        return f"{self.prefix}:{slug(label) if not re.fullmatch(r'[A-Za-z0-9.:-]+', label) else label}"

    # Equations

    def display(self, block: Display) -> Iterator[str]:
        systems = [self.rows(e, LATEX_LINE - 2 if block.boxed else LATEX_LINE) for e in block.equations]
        if len(systems) == 1 and len(systems[0]) == 1 and not block.boxed:
            yield from self.equation(systems[0][0].code.replace(ALIGN, ""), block.equations[0])
        elif block.boxed and sum(map(len, systems)) > TALL_BOX:
            # A minipage cannot be broken between pages: a tall result is boxed equation by equation.
            for system in systems:
                yield from self.boxed([system]) if len(system) <= 2 * TALL_BOX else self.align([system])
        elif systems:
            yield from self.boxed(systems) if block.boxed else self.align(systems)

    def boxed(self, systems: Sequence[Sequence[_Row]]) -> Iterator[str]:
        # \boxed takes one formula, not an `align`. No page break parts the box from the sentence before it. The space
        # above the first equation would make the frame lopsided. It is as wide as the text; the numbers have room.
        # They are 5 pt from the frame, whose rules and separation are 2 (0.4 + 3) pt wide.
        begin = r"\noindent\fbox{\hspace{5pt}\begin{minipage}{\dimexpr\linewidth-16.8pt}\vspace{-\abovedisplayskip}"
        yield r"\par\nopagebreak\smallskip" + begin
        yield from self.align(systems)
        yield "\\end{minipage}\\hspace{5pt}}\\par\\smallskip\n"

    def equation(self, code: str, equation: Equation) -> Iterator[str]:
        star = "" if equation.label else "*"
        yield rf"\begin{{equation{star}}}" + self.anchor(equation)
        yield "  " + code
        yield rf"\end{{equation{star}}}"

    def anchor(self, equation: Equation) -> str:
        return rf"\label{{{self.label(equation.label)}}}" if equation.label else ""

    def align(self, systems: Sequence[Sequence[_Row]]) -> Iterator[str]:
        """The rows of several equations, aligned at their relations where all of them have short left sides."""
        rows = [row for system in systems for row in system]
        star = "" if any(row.anchor for row in rows) else "*"
        at_relation = at_relations([[row.code for row in system] for system in systems])
        lines = []
        for row in rows:
            code = with_ampersand(row.code, at_relation)
            note = row.anchor or (r"\notag" if not star else "")
            lines.append(f"  {code} {note}".rstrip())
        spread = any(len(system) > 1 for system in systems)
        tall = any(r"\frac" in row.code for row in rows)
        space = "[1ex]" if spread else "[0.5ex]" if tall else ""
        # No page ends within an equation, nor with a single one of several, nor begins with the last of them.
        ends = [
            (r" \\" if 1 < n < len(systems) - 1 else r" \\*") + space if row is system[-1] else r" \\*"
            for n, system in enumerate(systems, 1)
            for row in system
        ]
        yield rf"\begin{{align{star}}}"
        yield from (line + end for line, end in zip(lines[:-1], ends[:-1], strict=True))
        yield lines[-1]
        yield rf"\end{{align{star}}}"

    def rows(self, equation: Equation, width: float) -> list[_Row]:
        """The rows of an equation: the last one has the number, a condition may follow below it."""
        match equation.condition:
            case ():
                condition = ""
            case (Math(sides=sides, relation=relation),):  # a second formula beside the first, and no words
                condition = self.typesetter.writer.relation(sides, relation)
            case parts:
                condition = rf"\text{{{self.prose(parts)}}}"
        codes, below = self.typesetter.rows(equation, width, condition)
        return [*(_Row(code) for code in codes[:-1]), _Row(codes[-1], self.anchor(equation)), *map(_Row, below)]

    # Pictures, matrices, tables and checks

    def picture(self, block: Picture) -> Iterator[str]:
        scene = block.draw()
        if scene is not None:
            yield r"\begin{center}\begin{minipage}{\linewidth}\centering"  # no page break parts it from its caption
            yield from picture(scene, self.typesetter.writer.plain)
            yield rf"\\[1.5ex] {{\small {self.prose(block.caption)}}}"
            yield r"\end{minipage}\end{center}"

    def task(self, block: Task) -> Iterator[str]:
        yield r"\begin{minipage}{\linewidth}"  # no page break parts a task from its room
        yield self.prose(block.parts) + rf"\par\vspace*{{{block.lines}\baselineskip}}"
        yield r"\end{minipage}"

    def matrices(self, block: Matrices) -> Iterator[str]:
        for line in self.typesetter.matrices(block.named, LATEX_LINE):
            if isinstance(line, str):
                yield from (r"\[", f"  {line}", r"\]")
            else:
                yield from block_lines(line, self)

    def table(self, block: Table) -> Iterator[str]:
        grid = [list(block.header), *(list(row) for row in block.rows)]
        turned = [list(column) for column in zip(*grid, strict=True)]
        for candidate in (grid, turned):
            cells = [[self.part(part) for part in row] for row in candidate]
            if sum(max(ems(row[k]) for row in cells) + 1.2 for k in range(len(cells[0]))) < LATEX_LINE + 4:
                yield from _tabular(cells)
                return
        yield r"\begin{itemize}"
        for row in block.rows:
            entries = (f"{self.part(h)}: {self.part(c)}" for h, c in zip(block.header[1:], row[1:], strict=True))
            yield rf"\item {self.part(row[0])}: " + "; ".join(entries)
        yield r"\end{itemize}"

    def checks(self, run: Sequence[CheckMark]) -> Iterator[str]:
        yield r"\begin{itemize}"
        for check in run:
            how = f" --- {escape(check.how)}" if check.how else ""
            yield rf"\item[{MARKS[check.passed]}] {self.prose(check.name)}{how}"
        yield r"\end{itemize}"


Article = _Article
"""One derivation, for layouts that are made of its pieces."""


def _tabular(cells: Sequence[Sequence[str]]) -> Iterator[str]:
    yield r"\begin{center}"
    yield rf"\begin{{tabular}}{{{'l' * len(cells[0])}}}"
    header, *rows = (" & ".join(row) for row in cells)
    yield rf"  {header} \\ \hline"
    yield " \\\\\n".join("  " + row for row in rows)
    yield r"\end{tabular}"
    yield r"\end{center}"
