"""Self-contained source files with f(t, y), in Python, C, MATLAB (and Octave) and Julia.

A file has a header with the problem, the meaning and order of the components of y and of the parameters p, numbers for
the parameters and the state at t = 0, and f. Where it solves linear equations with multipliers it has a solver with
pivoting, unless the language has one. Undefined functions and prescribed motions become functions to be filled in: as
long as they are not, f returns NaN.

Names in the file are legal names made from those of the problem (`names.py`), so that x' is x_dot. Texts of the problem
occur in comments only, one line each.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain

import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.expression_size import count_distinct
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, base, t
from lagrange.document.math_writer import text
from lagrange.programs.languages import LANGUAGES, GeneratedFunction, Language, Printer, ProgramNames, Target
from lagrange.programs.limits import LONGEST_PROGRAM
from lagrange.programs.starting import Start
from lagrange.programs.state_equations import StateEquations
from lagrange.programs.straight_line import StraightLine, can_be_eliminated, solved_in_line, straight_line

ENDINGS = {Target.PYTHON: ".py", Target.C: ".c", Target.MATLAB: ".m", Target.JULIA: ".jl"}


@record
class _Call:
    """A function to be filled in, at some arguments, and the symbol that stands for its value."""

    symbol: sp.Symbol
    name: str
    arguments: tuple[sp.Expr, ...]
    described: str


def source_file(states: StateEquations, start: Start, target: Target, name: str = "f") -> str:
    """The text of the file; `name` is that of the function f(t, y, p).

    Raises NotCoveredError if an expression cannot be written, or the program would be very long.
    """
    if count_distinct(states.expressions) > LONGEST_PROGRAM:
        raise NotCoveredError("a program of so many operations")
    return "\n".join(_File(states, start, target, name).lines()) + "\n"


class _File:
    def __init__(self, states: StateEquations, start: Start, target: Target, name: str) -> None:
        self.states, self.start, self.target, self.name = states, start, target, name
        self.language: Language = LANGUAGES[target]
        self.parameters = tuple(p.symbol for p in states.parameters)
        self.names = ProgramNames([name])
        self.called = {s: self.names.readable(s) for s in (*states.state, *self.parameters)}
        self.calls: dict[sp.Basic, _Call] = {}

    def lines(self) -> Iterator[str]:
        """The lines of the file."""
        e = self.states.equations
        rates, right = [*map(self._without_calls, e.rates)], [*map(self._without_calls, e.right)]
        matrix = [[*map(self._without_calls, row)] for row in e.matrix]
        in_line = can_be_eliminated(len(right), len(e.multipliers))
        if in_line:
            functions = [self._function(self.name, solved_in_line(rates, matrix, right))]
        else:
            functions = [self._function("equations", straight_line([*rates, *chain.from_iterable(matrix), *right]))]
        yield from _WRITERS[self.target](self, functions, in_line)

    def _function(self, name: str, program: StraightLine) -> list[str]:
        arguments = (("t", t), ("y", self.states.state), ("p", self.parameters))
        calls: dict[sp.Symbol, str] = {}
        used = {s for x in (*(v for _, v in program.assignments), *program.outputs) for s in x.free_symbols}
        needed = [c for c in self.calls.values() if c.symbol in used]
        if not needed:
            return self.language.function(GeneratedFunction(name, arguments, program, self.called))
        # A call is the value of a function of the state; its arguments are written out where it stands.
        printer = Printer(self.language.syntax, {t: "t", **self.called})
        for c in needed:
            calls[c.symbol] = f"{c.name}({', '.join(map(printer, c.arguments))})"
        extra = {s for c in needed for x in c.arguments for s in x.free_symbols}
        lines = self.language.function(GeneratedFunction(name, arguments, program, self.called, constants=calls))
        bound = [self.called[s] for s in self.called if s in extra and s not in used]
        return [lines[0], *(f"    {self._binding(n)}" for n in bound), *lines[1:]]

    def _binding(self, name: str) -> str:
        [symbol] = (s for s, n in self.called.items() if n == name)
        array, inside = ("y", self.states.state) if symbol in self.states.state else ("p", self.parameters)
        element = self.language.element.format(array=array, index=inside.index(symbol) + self.language.first)
        return self.language.assign.format(name=name, code=element)

    def _without_calls(self, e: sp.Expr) -> sp.Expr:
        """An expression with symbols for the values of functions that are to be filled in."""
        prescribed = {*self.states.equations.slots.prescribed}
        rule: dict[sp.Basic, sp.Basic] = {
            s: self._call(s, s.name, (t,), s.name) for s in e.free_symbols if base(s) in prescribed
        }
        if e.has(Unspecified):
            e = e.replace(lambda a: isinstance(a, Unspecified), self._of_function)
        return e.xreplace(rule) if rule else e

    def _of_function(self, f: Unspecified) -> sp.Symbol:
        derivative = "".join(n * k for n, k in zip((f"_{a}" for a in f.argument_names), f.orders, strict=True))
        places = [sp.Symbol(n, real=True) for n in f.argument_names]
        formal = Unspecified(f.args[0], f.args[1], f.args[2], *places)
        return self._call(f, f"{f.name}{derivative}", f.arguments, text(formal))

    def _call(self, key: sp.Basic, name: str, arguments: tuple[sp.Expr, ...], described: str) -> sp.Symbol:
        if key not in self.calls:
            stand_in = sp.Symbol(name, real=True)
            known = next((c.name for c in self.calls.values() if c.described == described), None)
            called = known or self.names.readable(sp.Dummy(stand_in.name))
            self.calls[key] = _Call(sp.Dummy("value", real=True), called, arguments, described)
        return self.calls[key].symbol

    # -- texts ---------------------------------------------------------------------------------------------------------

    def header(self) -> list[str]:
        """What the file is about, as lines of text."""
        problem, states = self.states.problem, self.states
        where = f"choice {states.name}" if states.name else "the coordinates of the problem"
        lines = [problem.title, *([problem.source] if problem.source else []), "", f"dy/dt = f(t, y, p), {where}", ""]
        meanings = {q.symbol: (q.meaning, q.unit) for q in problem.coordinates}
        meanings |= {p.symbol: (p.meaning, p.unit) for p in states.parameters}
        first = self.language.first
        for array, symbols in (("y", states.state), ("p", self.parameters)):
            for k, s in enumerate(symbols, start=first):
                meaning, unit = meanings.get(s, ("", ""))
                code = self.language.element.format(array=array, index=k)
                meaning = meaning or _derived(s, meanings)
                said = f"{code}  {s.name}" + (f", {meaning}" if meaning else "") + (f", in {unit}" if unit else "")
                lines.append(said + (" (a number assumed)" if s.name in self.start.assumed else ""))
            lines.append("")
        if states.equations.multipliers:
            lines += ["Multipliers are eliminated; begin in a state that satisfies the constraints:"]
            lines += [f"{text(g)} = 0" for g in states.equations.kept]
            lines.append("")
        return lines

    def filled_in(self) -> list[tuple[str, int, str]]:
        """Name, number of arguments, and meaning of each function that is to be filled in."""
        return list(dict.fromkeys((c.name, len(c.arguments), c.described) for c in self.calls.values()))

    def numbers(self) -> tuple[list[str], list[str]]:
        """The numbers for p, and y at t = 0."""
        return [repr(float(self.start.values[s])) for s in self.parameters], [repr(float(y)) for y in self.start.state]

    @property
    def sizes(self) -> tuple[int, int, int]:
        """n coordinates, p speeds, and unknowns."""
        e = self.states.equations
        return len(e.rates), len(e.speeds), len(e.unknowns)


def _derived(symbol: sp.Symbol, meanings: Mapping[sp.Symbol, tuple[str, str]]) -> str:
    q = base(symbol)
    return f"rate of {q.name}" if q != symbol and q in meanings else ""


def _arguments(count: int) -> str:
    return ", ".join(f"x{k}" for k in range(1, count + 1))


def _python(file: _File, functions: Sequence[list[str]], in_line: bool) -> Iterator[str]:
    p, y = file.numbers()
    n, speeds, size = file.sizes
    yield "# dy/dt of a mechanical system, written by lagsolve."
    yield "#"
    yield from chain.from_iterable(file.language.comments(line) for line in file.header())
    yield "from math import acos, asin, atan, atan2, cos, cosh, exp, log, pow, sin, sinh, sqrt, tan, tanh"
    yield from ("", f"PARAMETERS = [{', '.join(p)}]", f"START = [{', '.join(y)}]", "", "")
    yield from ("def sign(x):", "    return float((x > 0) - (x < 0))", "", "")
    for name, count, described in file.filled_in():
        yield f"def {name}({_arguments(count)}):"
        yield from (f"    {line}" for line in file.language.comments(f"{described}: fill it in"))
        yield from ('    return float("nan")', "", "")
    for function in functions:
        yield from (
            *(line.replace(", p):", ", p=PARAMETERS):") if k == 0 else line for k, line in enumerate(function)),
            "",
        )
    if in_line:
        return
    yield from ("", *_PYTHON_SOLVER.splitlines(), "", "")
    yield from (
        f"def {file.name}(t, y, p=PARAMETERS):",
        "    values = equations(t, y, p)",
        f"    rows = [values[{n} + {size}*k:{n} + {size}*(k + 1)] for k in range({size})]",
        f"    return values[:{n}] + solved(rows, values[{n + size * size}:])[:{speeds}]",
    )


_PYTHON_SOLVER = """def solved(rows, right):
    a = [row + [b] for row, b in zip(rows, right)]
    n = len(a)
    for k in range(n):
        best = max(range(k, n), key=lambda i: abs(a[i][k]))
        a[k], a[best] = a[best], a[k]
        for i in range(k + 1, n):
            share = a[i][k]/a[k][k]
            a[i] = [u - share*v for u, v in zip(a[i], a[k])]
    x = [0.0]*n
    for k in reversed(range(n)):
        x[k] = (a[k][n] - sum(a[k][j]*x[j] for j in range(k + 1, n)))/a[k][k]
    return x"""


def _c(file: _File, functions: Sequence[list[str]], in_line: bool) -> Iterator[str]:
    p, y = file.numbers()
    n, speeds, size = file.sizes
    yield "// dy/dt of a mechanical system, written by lagsolve. Compile with a C99 compiler, and -lm."
    yield "//"
    yield from chain.from_iterable(file.language.comments(line) for line in file.header())
    yield from ("#include <math.h>", "")
    yield f"const double {file.name}_parameters[{max(1, len(p))}] = {{{', '.join(p) or '0.0'}}};"
    yield f"const double {file.name}_start[{len(y)}] = {{{', '.join(y)}}};"
    yield f"const int {file.name}_size = {len(y)};"
    yield from ("", "static inline double sgn(double x) { return (x > 0) - (x < 0); }", "")
    for name, count, described in file.filled_in():
        arguments = ", ".join(f"double x{k}" for k in range(1, count + 1))
        yield from file.language.comments(f"{described}: fill it in")
        used = " ".join(f"(void)x{k};" for k in range(1, count + 1))
        yield from (f"static double {name}({arguments}) {{ {used} return NAN; }}", "")
    for function in functions:
        head = function[0].replace("static void", "void") if in_line else function[0]
        yield from (head, "    (void)t; (void)y; (void)p;", *function[1:], "")
    if in_line:
        return
    yield from (line.replace("SIZE", str(size)) for line in _C_SOLVER.splitlines())
    yield from (
        f"void {file.name}(double t, const double *y, const double *p, double *out) {{",
        f"    double values[{n + size * size + size}], x[{size}];",
        "    equations(t, y, p, values);",
        f"    solved(values + {n}, values + {n + size * size}, x);",
        f"    for (int k = 0; k < {n}; k++) out[k] = values[k];",
        f"    for (int k = 0; k < {speeds}; k++) out[{n} + k] = x[k];",
        "}",
    )


_C_SOLVER = """static void solved(double *a, double *b, double *x) {
    for (int k = 0; k < SIZE; k++) {
        int best = k;
        for (int i = k + 1; i < SIZE; i++) if (fabs(a[SIZE*i + k]) > fabs(a[SIZE*best + k])) best = i;
        for (int j = 0; j < SIZE; j++) {
            double kept = a[SIZE*k + j];
            a[SIZE*k + j] = a[SIZE*best + j];
            a[SIZE*best + j] = kept;
        }
        double kept = b[k];
        b[k] = b[best];
        b[best] = kept;
        for (int i = k + 1; i < SIZE; i++) {
            double share = a[SIZE*i + k]/a[SIZE*k + k];
            for (int j = k; j < SIZE; j++) a[SIZE*i + j] -= share*a[SIZE*k + j];
            b[i] -= share*b[k];
        }
    }
    for (int k = SIZE - 1; k >= 0; k--) {
        double rest = b[k];
        for (int j = k + 1; j < SIZE; j++) rest -= a[SIZE*k + j]*x[j];
        x[k] = rest/a[SIZE*k + k];
    }
}
"""


def _matlab(file: _File, functions: Sequence[list[str]], in_line: bool) -> Iterator[str]:
    p, y = file.numbers()
    n, speeds, size = file.sizes
    main = functions[0] if in_line else [f"function out = {file.name}(t, y, p)", "end"]
    yield main[0]
    yield from file.language.comments("dy/dt of a mechanical system, written by lagsolve.")
    yield "%"
    yield from chain.from_iterable(file.language.comments(line) for line in file.header())
    yield from file.language.comments(f"y at t = 0: [{'; '.join(y)}]")
    yield from ("    if nargin < 3", f"        p = [{', '.join(p)}];", "    end")
    if in_line:
        yield from main[1:]
    else:
        yield "    values = equations(t, y, p);"
        yield f"    matrix = reshape(values({n + 1}:{n + size * size}), {size}, {size}).';"
        yield f"    x = matrix \\ values({n + size * size + 1}:end);"
        yield from (f"    out = [values(1:{n}); x(1:{speeds})];", "end")
        yield from ("", *functions[0])
    for name, count, described in file.filled_in():
        yield from ("", f"function out = {name}({_arguments(count)})")
        yield from (f"    {line}" for line in file.language.comments(f"{described}: fill it in"))
        yield from ("    out = NaN;", "end")


def _julia(file: _File, functions: Sequence[list[str]], in_line: bool) -> Iterator[str]:
    p, y = file.numbers()
    n, speeds, size = file.sizes
    yield "# dy/dt of a mechanical system, written by lagsolve."
    yield "#"
    yield from chain.from_iterable(file.language.comments(line) for line in file.header())
    yield from (f"const PARAMETERS = Float64[{', '.join(p)}]", f"const START = Float64[{', '.join(y)}]", "")
    for name, count, described in file.filled_in():
        yield f"function {name}({_arguments(count)})"
        yield from (f"    {line}" for line in file.language.comments(f"{described}: fill it in"))
        yield from ("    return NaN", "end", "")
    head, *rest = functions[0]
    yield from (head.replace(", p)", ", p=PARAMETERS)"), *rest)
    if in_line:
        return
    yield from (
        "",
        f"function {file.name}(t, y, p=PARAMETERS)",
        "    values = equations(t, y, p)",
        f"    matrix = permutedims(reshape(values[{n + 1}:{n + size * size}], {size}, {size}))",
        f"    x = matrix \\ values[{n + size * size + 1}:end]",
        f"    return vcat(values[1:{n}], x[1:{speeds}])",
        "end",
    )


_WRITERS = {Target.PYTHON: _python, Target.C: _c, Target.MATLAB: _matlab, Target.JULIA: _julia}
