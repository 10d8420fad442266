"""Functions in Python, C, MATLAB (and Octave), Julia and JavaScript.

A `GeneratedFunction` has arguments, each a number or an array of numbers, and outputs; `Language.function` writes it as
a function of that language that returns the array of its outputs, with assignments for repeated parts. Locals are named
as the caller says, and temporaries c0, c1, ...
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from enum import StrEnum

import sympy as sp

from lagrange.core.printable import printable
from lagrange.core.records import record
from lagrange.programs.names import ProgramNames
from lagrange.programs.printer import Printer, Syntax
from lagrange.programs.straight_line import StraightLine, occurring_inputs, straight_line

Argument = tuple[str, sp.Symbol | tuple[sp.Symbol, ...]]
"""The name of an argument, one of the program's own, and what it is: a number, or an array."""


class Target(StrEnum):
    """The languages that a problem can be exported to."""

    PYTHON = "python"
    C = "c"
    MATLAB = "matlab"
    JULIA = "julia"


@record
class GeneratedFunction:
    """A function of numbers and arrays, and its outputs in terms of their symbols.

    program  the outputs as a straight-line program
    names    of symbols that are to have a readable name; the elements of arrays are used as they are otherwise
    constants  the code of symbols that are no arguments
    """

    name: str
    arguments: tuple[Argument, ...]
    program: StraightLine
    names: Mapping[sp.Symbol, str] = field(default_factory=dict)
    constants: Mapping[sp.Symbol, str] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        name: str,
        arguments: Sequence[Argument],
        outputs: Sequence[sp.Expr],
        names: Mapping[sp.Symbol, str] | None = None,
    ) -> GeneratedFunction:
        """The function with these outputs."""
        return cls(name, tuple(arguments), straight_line(outputs), names or {})


@record
class Language:
    """How a language writes functions.

    first     the index of the first element of an array
    element   an element of an array, with `{array}` and `{index}`
    assign    an assignment, with `{name}` and `{code}`
    head      the first line of a function, with `{name}` and `{arguments}`
    argument  an argument that is a number, with `{name}`
    array     an argument that is an array, with `{name}`
    result    how the outputs are returned, with `{outputs}`, or each with `{index}` and `{code}` where `each`
    tail      the last line of a function
    comment   what begins a comment that ends with the line
    """

    syntax: Syntax
    first: int
    element: str
    assign: str
    head: str
    result: str
    tail: str
    comment: str
    argument: str = "{name}"
    array: str = "{name}"
    each: bool = False
    separator: str = ", "

    def comments(self, text: str) -> list[str]:
        """A text as comments, one for each of its lines, from which nothing can get out."""
        lines = text.splitlines() or [""]
        return [f"{self.comment} {_harmless(line)}".rstrip() for line in lines]

    def _result(self, outputs: Sequence[str]) -> list[str]:
        """The statement that returns the outputs, in several lines where it is long: all of them within brackets."""
        rows: list[str] = []
        for code in outputs:
            if rows and len(rows[-1]) + len(self.separator) + len(code) < WIDTH:
                rows[-1] += f"{self.separator}{code}"
            else:
                rows.append(code)
        if len(rows) < 2:
            return [self.result.format(outputs="".join(rows))]
        before, after = self.result.split("{outputs}")
        between = self.separator.rstrip()
        return [f"{before}{rows[0]}{between}", *(f"    {r}{between}" for r in rows[1:-1]), f"    {rows[-1]}{after}"]

    def function(self, function: GeneratedFunction) -> list[str]:
        """The lines of a function."""
        used = occurring_inputs(function.program)
        code = dict(function.constants)
        lines: list[str] = []
        written: list[str] = []
        for argument, meant in function.arguments:
            if isinstance(meant, sp.Symbol):
                code[meant] = argument
                written.append(self.argument.format(name=argument))
                continue
            written.append(self.array.format(name=argument))
            for k, symbol in enumerate(meant):
                element = self.element.format(array=argument, index=k + self.first)
                wanted = function.names.get(symbol)
                code[symbol] = element if wanted is None else wanted
                if wanted is not None and symbol in used:
                    lines.append(self.assign.format(name=wanted, code=element))
        taken = ProgramNames([*(n for n, _ in function.arguments), *code.values()])
        printer = Printer(self.syntax, code)
        for symbol, value in function.program.assignments:
            written_value = printer(value)
            code[symbol] = taken.numbered(symbol, "c")
            lines.append(self.assign.format(name=code[symbol], code=written_value))
        outputs = [printer(e) for e in function.program.outputs]
        if self.each:
            lines += [self.result.format(index=k + self.first, code=c) for k, c in enumerate(outputs)]
        else:
            lines += self._result(outputs)
        head = self.head.format(name=function.name, arguments=", ".join(written))
        return [head, *(f"    {line}" for line in lines), *([self.tail] if self.tail else [])]


WIDTH = 100
"""Columns after which the outputs of a function are continued on the next line."""


def _harmless(line: str) -> str:
    """A line of a comment that does not go on in the next line, as one with `\\` or C's trigraph for it would."""
    return printable(line).replace("??", "? ?").rstrip().rstrip("\\")


_C_NAMES = {"abs": "fabs", "power": "pow", "sign": "sgn"}
_MATH = {"sqrt", "power", "abs", "sign", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh"}

PYTHON = Language(
    syntax=Syntax({"power": "pow"}, "**"),
    first=0,
    element="{array}[{index}]",
    assign="{name} = {code}",
    head="def {name}({arguments}):",
    result="return [{outputs}]",
    tail="",
    comment="#",
)
C = Language(
    syntax=Syntax(_C_NAMES),
    first=0,
    element="{array}[{index}]",
    assign="const double {name} = {code};",
    head="static void {name}({arguments}, double *out) {{",
    argument="double {name}",
    array="const double *{name}",
    result="out[{index}] = {code};",
    each=True,
    tail="}",
    comment="//",
)
MATLAB = Language(
    syntax=Syntax({}, "^"),
    first=1,
    element="{array}({index})",
    assign="{name} = {code};",
    head="function out = {name}({arguments})",
    result="out = [{outputs}];",
    separator="; ",
    tail="end",
    comment="%",
)
JULIA = Language(
    syntax=Syntax({"power": "^", "atan2": "atan"}, "^"),
    first=1,
    element="{array}[{index}]",
    assign="{name} = {code}",
    head="function {name}({arguments})",
    result="return [{outputs}]",
    tail="end",
    comment="#",
)
JAVASCRIPT = Language(
    syntax=Syntax({name: f"Math.{ {'power': 'pow'}.get(name, name) }" for name in (*_MATH, "exp", "log")}),
    first=0,
    element="{array}[{index}]",
    assign="const {name} = {code};",
    head="function {name}({arguments}) {{",
    result="return [{outputs}];",
    tail="}",
    comment="//",
)
LANGUAGES: dict[Target, Language] = {
    Target.PYTHON: PYTHON,
    Target.C: C,
    Target.MATLAB: MATLAB,
    Target.JULIA: JULIA,
}
