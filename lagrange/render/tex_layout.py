r"""Equations in rows of TeX, for LaTeX (`align`) and Markdown (`aligned`): broken to a width and aligned.

Widths are estimated in ems (`ems`). Letters have their widths in Computer Modern; relations and signs have the space
around them; a fraction is as wide as the wider of its parts; indices are set at seven tenths. Errors stay within a few
percent of a line: tests compare the estimate with what TeX measures.

Vectors are bold, underlined, or have an arrow. Only the letter is marked, under the dots and before the index:
`\ddot{\mathbf{r}}_{P}`, `\ddot{\underline{r}}_{P}`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from enum import StrEnum

import sympy as sp

from lagrange.core.records import record
from lagrange.document.derivation import Block, Equation, Mathematics
from lagrange.document.math_writer import Writer
from lagrange.render.limits import LATEX_LINE, LONG_FORMULA, SHORT_BRACKET, SHORT_RIGHT_SIDE, TEX_LEFT_SIDE
from lagrange.render.line_breaking import Breaker, MathLine
from lagrange.render.selection import entry_by_entry

_TOKEN = re.compile(r"\\eqref\{[^}]*\}|\\[A-Za-z]+|\\.|[^\s]", re.DOTALL)
_LETTERS = {"m": 0.88, "w": 0.72, "i": 0.35, "j": 0.41, "l": 0.3, "f": 0.55, "t": 0.36, "r": 0.46, "s": 0.47}
_COMMANDS = {
    r"\quad": 1.0,
    r"\qquad": 2.0,
    r"\,": 0.17,
    r"\;": 0.28,
    r"\cdot": 0.72,
    r"\wedge": 1.1,
    r"\times": 1.22,
    r"\nabla": 0.83,
    r"\neq": 1.34,
    r"\le": 1.34,
    r"\ge": 1.34,
    r"\approx": 1.34,
    r"\equiv": 1.34,
    r"\to": 1.56,
    r"\propto": 1.34,
    r"\partial": 0.6,
    r"\lvert": 0.28,
    r"\rvert": 0.28,
    r"\omega": 0.65,
    r"\psi": 0.67,
    r"\left": 0.2,
    r"\right": 0.2,
    r"\infty": 1.0,
}
_TRANSPARENT = frozenset(
    {r"\dot", r"\ddot", r"\dddot", r"\mathbf", r"\mathit", r"\mathrm", r"\boldsymbol", r"\boxed", r"\emph"}
)
_FUNCTION = re.compile(r"\\(?:arc)?(?:sin|cos|tan)h?\Z|\\(?:cot|sec|csc|ln|exp)\Z")


def ems(code: str) -> float:
    """The width of a piece of LaTeX, math or text."""
    tokens = _TOKEN.findall(code)
    width, _ = _row(tokens, 0)
    return width


def _row(tokens: list[str], at: int) -> tuple[float, int]:
    """The width of the tokens up to the end of a group, and the position of that end."""
    width = 0.0
    while at < len(tokens) and tokens[at] != "}":
        if tokens[at] in "^_":
            scripts = []  # x_1^2: index and exponent are above each other, the wider one counts
            while at < len(tokens) and tokens[at] in "^_":
                script, at = _atom(tokens, at + 1)
                scripts.append(0.72 * script)
            width += max(scripts) + 0.05
        else:
            more, at = _atom(tokens, at)
            width += more
    return width, at


def _atom(tokens: list[str], at: int) -> tuple[float, int]:
    if at >= len(tokens):
        return 0.0, at
    token = tokens[at]
    at += 1
    if token == "{":
        width, at = _row(tokens, at)
        return width, at + 1
    if token in (r"\frac", r"\tfrac"):
        above, at = _atom(tokens, at)
        below, at = _atom(tokens, at)
        return (0.75 if token == r"\tfrac" else 1.0) * max(above, below) + 0.24, at
    if token == r"\sqrt":
        inner, at = _atom(tokens, at)
        return inner + 0.9, at
    if token in (r"\text", r"\operatorname"):
        inner, at = _atom(tokens, at)
        return 1.15 * inner + 0.2, at
    if token in _TRANSPARENT:
        return _atom(tokens, at)
    return _width(token), at


def _width(token: str) -> float:
    if token in _COMMANDS:
        return _COMMANDS[token]
    if token.startswith(r"\eqref"):
        return 1.8  # a number of two digits in brackets
    if _FUNCTION.match(token):
        return 0.46 * (len(token) - 1) + 0.17
    if token.startswith("\\"):
        return 0.6
    if token in "+-":
        return 1.22
    if token in "=<>":
        return 1.34
    if token in "()[]|":
        return 0.39
    if token in ",.:;":
        return 0.4
    if token.isdigit():
        return 0.5
    if token == "$":
        return 0.0
    return _LETTERS.get(token, 0.77 if token.isupper() else 0.53)


_GROUP = r"(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})"
_D = r"\\(?:partial |mathrm\{d\})"
_SLOPE = re.compile(rf"\\frac\{{({_D}{_GROUP}+)\}}\{{({_D}{_GROUP}+)\}}")
"""∂f/∂x and dH/dt, which is too small in running text as a fraction."""
_OF_SLOPE = re.compile(rf"\\frac\{{\\partial\}}\{{(\\partial {_GROUP}+)\}} (\\partial [\w ]+/\\partial \w+)")
_SECOND = re.compile(rf"\\frac\{{(\\partial\^\{{2\}} {_GROUP}+)\}}\{{(\\partial {_GROUP}+)\}}")
"""∂(∂f/∂x)/∂y and ∂²f/(∂x ∂y), likewise."""
ALIGN = "\ue003"
"""Marks the place of `&` in a row, until it is known whether all equations can be aligned at their relations."""


_BRACKETS = re.compile(r"(?<!\\left)([(\[])([^()\[\]]*)([)\]])")


def unbroken(code: str) -> str:
    """A formula in running text with short brackets, cos(α − β), as groups: TeX breaks lines outside groups only.

    A short right side, = 0, does not stand on a line of its own.
    """

    def grouped(bracket: re.Match[str]) -> str:
        first, inner, last = bracket.groups()
        closed = inner.count("{") == inner.count("}") and not inner.endswith("\\right")
        breakable = any(sign in inner for sign in "+-=<>")
        return f"{first}{{{inner}}}{last}" if closed and breakable and ems(inner) < SHORT_BRACKET else bracket[0]

    if not LONG_FORMULA <= ems(code) <= LATEX_LINE:
        return code  # one of several lines needs every place at which it may be broken
    before, sign, last = _BRACKETS.sub(grouped, code).rpartition(" = ")
    return rf"{before} = \nobreak {last}" if sign and ems(last) < SHORT_RIGHT_SIDE else before + sign + last


@record
class Typesetter:
    """Mathematics as rows of TeX.

    writer   for equations that fit
    wide     for the others: long fractions and roots can be broken
    running  for formulas in a sentence
    """

    writer: Writer
    wide: Writer
    running: Writer

    def inline(self, sides: Sequence[Mathematics], relation: str, width: float) -> str:
        """a = b = c in running text."""
        code = _SLOPE.sub(r"\1/\2", self.running.relation(sides, relation))
        code = _SECOND.sub(r"\1/(\2)", _OF_SLOPE.sub(r"\\partial(\2)/\1", code))
        return code if ems(code) <= width else self.wide.relation(sides, relation)

    def rows(self, equation: Equation, width: float, condition: str = "") -> tuple[list[str], list[str]]:
        """The rows of an equation followed by its condition; rows below, where the condition has no room."""
        relation = self.writer.style.relation(equation.relation)
        for writer in (self.writer, self.wide):
            breaker = Breaker(ems, width, 1)
            lines = breaker.equation([writer.marked(side) for side in equation.sides], relation)
            if all(line.indent + ems(line.code) <= width for line in lines):
                break
        codes = _aligned(lines, relation)
        if condition and lines[-1].indent + ems(lines[-1].code) + 2 + ems(condition) <= width:
            codes[-1] += rf" \qquad {condition}"
            condition = ""
        return codes, [rf"{ALIGN}\qquad {condition}"] if condition else []

    def matrix(self, name: sp.Symbol, rows: Sequence[Sequence[sp.Expr]]) -> tuple[str, float]:
        """M = (a b; c d), and its width."""
        cells = [[self.writer.plain(e) for e in row] for row in rows]
        width = sum(max(ems(row[k]) for row in cells) + 1 for k in range(len(cells[0]))) + 4
        inner = r" \\ ".join(" & ".join(row) for row in cells)
        return rf"{self.writer.plain(name)} = \begin{{pmatrix}} {inner} \end{{pmatrix}}", width

    def matrices(
        self, named: Sequence[tuple[sp.Symbol, Sequence[Sequence[sp.Expr]]]], width: float
    ) -> Iterator[str | tuple[Block, ...]]:
        """Lines of matrices side by side; for one that is too wide, blocks with its entries."""
        line: list[str] = []
        used = 0.0
        for name, rows in named:
            code, own = self.matrix(name, rows)
            if line and used + own > width:
                yield r" ,\qquad ".join(line)
                line, used = [], 0.0
            if own > width:
                yield entry_by_entry(name, rows)
                continue
            line.append(code)
            used += own + 2
        if line:
            yield r" ,\qquad ".join(line)


def at_relations(systems: Sequence[Sequence[str]]) -> bool:
    """Whether several equations can be aligned at their relations: all of them have short left sides."""
    return all(system[0].find(ALIGN) > 0 for system in systems)


def with_ampersand(code: str, at_relation: bool) -> str:
    """A row with the `&` at which it is aligned."""
    return code.replace(ALIGN, "&") if at_relation else "&" + code.replace(ALIGN, "")


def _aligned(lines: Sequence[MathLine], relation: str) -> list[str]:
    """The lines as rows of `align`, marked before the relation if the left side is short, else at the margin."""
    head, sign, tail = lines[0].code.partition(f" {relation} ")
    if not sign or ems(head) > TEX_LEFT_SIDE:
        return [ALIGN + _growing(_space(line.indent) + line.code, len(lines)) for line in lines]
    rows = [_growing(f"{head} {ALIGN}{relation} {tail}", len(lines))]
    for line in lines[1:]:
        continues = not line.code.startswith(f"{relation} ")
        indent = _space(max(line.indent - ems(head), 1)) if continues else ""
        rows.append(ALIGN + _growing(indent + line.code, len(lines)))
    return rows


def _space(indent: float) -> str:
    if indent < 0.5:
        return ""
    if indent < 1.5:
        return r"\quad "
    return r"\qquad " if indent < 2.5 else rf"\hspace{{{indent:.0f}em}} "


def _growing(code: str, rows: int) -> str:
    r"""Brackets of a fixed size in an equation of several rows: `\left` and `\right` cannot be in different rows."""
    if rows == 1:
        return code
    return re.sub(r"\\left(\\.|.)", r"\\biggl\1", re.sub(r"\\right(\\.|.)", r"\\biggr\1", code))


_BOLD = re.compile(r"\\(?:mathbf|boldsymbol)\{")


class Vectors(StrEnum):
    """How vectors are marked."""

    BOLD = "bold"
    UNDERLINED = "underlined"
    ARROW = "arrow"

    def written(self, code: str) -> str:
        """TeX with bold letters, marked in this way instead."""
        command = {Vectors.UNDERLINED: r"\underline{", Vectors.ARROW: r"\vec{"}.get(self)
        return code if command is None else _BOLD.sub(lambda _: command, code)
