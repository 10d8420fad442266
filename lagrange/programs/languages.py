"""Expressions, names and functions in the syntax of Python, C, MATLAB (and Octave), Julia and JavaScript.

Functions in Python, C, MATLAB (and Octave), Julia and JavaScript.

A `GeneratedFunction` has arguments, each a number or an array of numbers, and outputs; `Language.function` writes it as
a function of that language that returns the array of its outputs, with assignments for repeated parts. Locals are named
as the caller says, and temporaries c0, c1, ...

Legal names for symbols: `theta'` is `theta_dot`, `θ'` is `theta_dot`, `lambda` is `lambda_`.

A name is made of the letters A to Z, a to z, digits and underscores alone, begins with a letter, is not a keyword of
any of the languages, and belongs to one symbol. Whatever cannot be made so is `s1`, `s2`, ... Numbered names, y0, p3,
c12, take nothing from the file at all.

Expressions in the syntax of a programming language.

Only numbers, +, ·, powers and the functions of a short list are written; everything else is refused. A
symbol is written by the name that the caller has given it, which is made by `names.py` or is an element of an array:
no text of a file becomes code.

Numbers are written as floating-point literals, so that 1/2 is no division of integers; a fraction p/q is a quotient of
such literals, correctly rounded as each language divides. `x^2` is written as a product where that is one.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from enum import StrEnum

import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.printable import printable
from lagrange.core.records import record
from lagrange.programs.limits import LARGEST_WHOLE, LONGEST_PROGRAM_NAME
from lagrange.programs.straight_line import StraightLine, occurring_inputs, straight_line

_SUM, _PRODUCT, _POWER, _ATOM = range(1, 5)
_RECIPROCAL: dict[type[sp.Basic], type[sp.Basic]] = {sp.cot: sp.tan, sp.sec: sp.cos, sp.csc: sp.sin}
FUNCTIONS: dict[type[sp.Basic], str] = {
    sp.sin: "sin", sp.cos: "cos", sp.tan: "tan", sp.asin: "asin", sp.acos: "acos", sp.atan: "atan",
    sp.atan2: "atan2", sp.sinh: "sinh", sp.cosh: "cosh", sp.tanh: "tanh", sp.exp: "exp", sp.log: "log",
    sp.Abs: "abs", sp.sign: "sign",
}  # fmt: skip
"""The functions that are written, besides sqrt, and cot, sec, csc as reciprocals."""


@record
class Syntax:
    """What expressions look like in a language.

    functions  the name of each function that is not called as in `FUNCTIONS`; `sqrt` and `power` among them
    power      the infix operator of powers with whole exponents; empty: the function `power`
    """

    functions: Mapping[str, str] = field(default_factory=dict)
    power: str = ""

    def function(self, name: str) -> str:
        """The name of a function."""
        return self.functions.get(name, name)


class Printer:
    """Writes expressions in a syntax; `names` gives the code of each symbol."""

    def __init__(self, syntax: Syntax, names: Mapping[sp.Symbol, str]) -> None:
        self._syntax = syntax
        self._names = names

    def __call__(self, expression: sp.Expr) -> str:
        """The code of an expression. Raises NotCoveredError at what has none."""
        return self._written(expression, 0)

    def _written(self, e: sp.Basic, within: int) -> str:
        code, level = self._code(e)
        return f"({code})" if level < within else code

    def _code(self, e: sp.Basic) -> tuple[str, int]:
        if isinstance(e, sp.Symbol):
            return self._symbol(e), _ATOM
        if isinstance(e, sp.Rational | sp.Float) or e in (sp.pi, sp.E):
            return _number(e)
        if isinstance(e, sp.Add):
            return self._sum(e), _SUM
        if isinstance(e, sp.Mul):
            return self._product(e)
        if isinstance(e, sp.Pow):
            return self._power(e.base, e.exp)
        return self._call(e)

    def _symbol(self, s: sp.Symbol) -> str:
        if s not in self._names:
            raise NotCoveredError(f"`{s.name}` as part of a program")
        return self._names[s]

    def _sum(self, e: sp.Add) -> str:
        code = ""
        for term in sorted(e.args, key=_is_negative):
            negative = _is_negative(term)
            written = self._written(-term if negative else term, _PRODUCT)
            sign = ("-" if negative else "") if not code else (" - " if negative else " + ")
            code += sign + written
        return code

    def _product(self, e: sp.Mul) -> tuple[str, int]:
        if _is_negative(e):
            return f"-{self._written(-e, _PRODUCT)}", _SUM
        above: list[sp.Expr] = []
        below: list[sp.Expr] = []
        for f in e.args:
            if isinstance(f, sp.Pow) and f.exp.is_Rational and f.exp < 0:
                below.append(sp.Pow(f.base, -f.exp, evaluate=False) if f.exp != -1 else f.base)
            elif isinstance(f, sp.Rational) and f.q != 1:
                above += [sp.Integer(f.p)] if f.p != 1 else []
                below.append(sp.Integer(f.q))
            else:
                above.append(f)
        top = "*".join(self._written(f, _PRODUCT) for f in above) or "1.0"
        if not below:
            return top, _PRODUCT
        bottom = "*".join(self._written(f, _PRODUCT) for f in below)
        alone = len(below) == 1 and self._code(below[0])[1] >= _POWER
        return f"{top}/{bottom if alone else f'({bottom})'}", _PRODUCT

    def _power(self, base: sp.Expr, exponent: sp.Expr) -> tuple[str, int]:
        call = self._syntax.function
        if exponent == sp.S.Half:
            return f"{call('sqrt')}({self._written(base, 0)})", _ATOM
        if exponent.is_Rational and exponent < 0:
            below, level = self._power(base, -exponent) if exponent != -1 else self._code(base)
            return f"1.0/{below if level >= _POWER else f'({below})'}", _PRODUCT
        if exponent in (2, 3) and not base.args:
            return "*".join([self._written(base, _POWER)] * int(exponent)), _PRODUCT
        if exponent.is_Integer and self._syntax.power:
            return f"{self._written(base, _ATOM)}{self._syntax.power}{exponent}", _POWER
        return f"{call('power')}({self._written(base, 0)}, {self._written(exponent, 0)})", _ATOM

    def _call(self, e: sp.Basic) -> tuple[str, int]:
        arguments = ", ".join(self._written(a, 0) for a in e.args if isinstance(a, sp.Expr))
        if type(e) in _RECIPROCAL:
            return f"1.0/{self._syntax.function(FUNCTIONS[_RECIPROCAL[type(e)]])}({arguments})", _PRODUCT
        name = FUNCTIONS.get(type(e))
        if name is None:
            raise NotCoveredError(f"`{type(e).__name__}` as part of a program")
        return f"{self._syntax.function(name)}({arguments})", _ATOM


def _is_negative(e: sp.Basic) -> bool:
    return bool(e.could_extract_minus_sign()) and (e.is_Mul or e.is_Number) and bool(e.as_coeff_Mul()[0].is_negative)


def _number(e: sp.Expr) -> tuple[str, int]:
    """A literal, and how strongly it binds."""
    if e.is_Rational and max(abs(e.p), e.q) < LARGEST_WHOLE:
        level = _ATOM if e.p >= 0 else _SUM
        if e.q == 1:
            return f"{e.p}.0", level
        short = repr(float(e))
        if len(short) <= 8 and "e" not in short and sp.Rational(short) == e:
            return short, level
        return f"{e.p}.0/{e.q}.0", min(level, _PRODUCT)
    try:
        number = float(e)
    except OverflowError:
        raise NotCoveredError("a number beyond the range of floating point") from None
    return repr(number), _ATOM if number >= 0 else _SUM


# Languages


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


# Names


_LEGAL = re.compile(r"[A-Za-z][A-Za-z0-9_]*")

_WORDS = """
False None True and as assert async await break class continue def del elif else except finally for from global
if import in is lambda nonlocal not or pass raise return try while with yield match case type
auto char const default do double enum extern float goto inline int long register restrict short signed sizeof
static struct switch typedef union unsigned void volatile bool asm fortran true false nullptr typeof
end function elseif otherwise parfor persistent spmd catch unwind_protect until endif endfunction endwhile endfor
begin baremodule let local macro module quote export using mutable abstract primitive where isa outer public
arguments debugger delete eval implements instanceof interface new null package private protected super this throw
var undefined NaN Infinity of get set constructor prototype
sin cos tan asin acos atan atan2 sinh cosh tanh exp log abs fabs sign sgn sqrt pow power pi Pi inf Inf nan NAN
INFINITY HUGE EOF NULL I Complex_I errno signgam j0 j1 jn y0 y1 yn gamma lgamma erf erfc main printf math Math
t y p dy dydt f out row col matrix right result solve solved state parameters names start copysign hypot fmax
OVERFLOW UNDERFLOW DOMAIN SING PLOSS TLOSS MAXFLOAT linux unix i386 M_PI ans eps e im size length zeros nargin
disp error len range list dict max min sum print rates unknowns equations defaults
"""
RESERVED = frozenset(_WORDS.split())
"""Words of Python, C, MATLAB, Octave, Julia, JavaScript, and what the programs use themselves."""


class ProgramNames:
    """Names for symbols, one for each."""

    def __init__(self, taken: Iterable[str] = ()) -> None:
        self._taken = {*RESERVED, *taken}
        self._of: dict[sp.Symbol, str] = {}

    @property
    def known(self) -> dict[sp.Symbol, str]:
        """The names given so far."""
        return self._of

    def readable(self, symbol: sp.Symbol) -> str:
        """A name that resembles that of the symbol."""
        return self._named(symbol, legal_name(symbol.name) or "s")

    def numbered(self, symbol: sp.Symbol, letter: str) -> str:
        """A name with a number: the letter is one of the program's own."""
        return self._named(symbol, letter, number=True)

    def _named(self, symbol: sp.Symbol, wanted: str, *, number: bool = False) -> str:
        if symbol not in self._of:
            name, n = f"{wanted}0" if number else wanted, 0
            if not number and name in RESERVED:
                name = f"{wanted}_"
            while name in self._taken:
                n += 1
                name = f"{wanted}{n}" if number else f"{wanted}_{n}"
            self._taken.add(name)
            self._of[symbol] = name
        return self._of[symbol]


def legal_name(name: str) -> str:
    """A name of letters, digits and underscores that begins with a letter; empty if there is none."""
    plain = name.rstrip("'")
    dots = len(name) - len(plain)
    spelled = "".join(_spelled(c) for c in plain)
    spelled = re.sub(r"[^A-Za-z0-9]+", "_", spelled).strip("_")[:LONGEST_PROGRAM_NAME]
    if not _LEGAL.fullmatch(spelled):
        return ""
    return spelled + {0: "", 1: "_dot", 2: "_ddot"}.get(dots, f"_d{dots}")


def _spelled(char: str) -> str:
    """A letter of the alphabet as it is, a Greek one by its name, anything else as an underscore."""
    if char.isascii():
        return char
    name = unicodedata.name(char, "")
    match = re.fullmatch(r"GREEK (SMALL|CAPITAL) LETTER (\w+)", name)
    if match is None:
        return "_"
    return match[2].lower() if match[1] == "SMALL" else match[2].capitalize()
