"""Texts of the problem file as they are printed, with the mathematics in them set as mathematics.

That is `l*sin(theta)` between backquotes, $l \\sin\\theta$ between dollars, an equation or a power in declared names
without any marks, z = c (x^2 + y^2), and a declared symbol as it stands: alpha, l1, m. The letters a and I are words,
but for the distance a.
What cannot be read stays as it was written.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.symbols import UnitSymbol, UnitVector
from lagrange.core.units import split_number, unit_of
from lagrange.core.vectors import UNITS
from lagrange.document.derivation import Math, Part, math
from lagrange.explain.limits import MOST_FORMULAS
from lagrange.expressions.formulas_in_text import formulas_in
from lagrange.expressions.reader import Scope, read_equation, read_value
from lagrange.problem.model import Problem
from lagrange.problem.values import known_dimensions

_MARKED = re.compile(r"`([^`\n]+)`|\$([^$\n]+)\$")
_SYMBOL = re.compile(r"(?<![\w'’`$\\-])([A-Za-z]+(?:_?\w+)?'{0,2})(?![\w'’])")
_ROOT = re.compile(r"([0-9]*)\s*(?:\\sqrt\{([^{}]*)\}|\*?sqrt\(([^()]*)\))")
_NUMBERED = re.compile(r"[a-z]_?\d")
"""Vectors whose names are no words: n1, e_3."""
_WORDS = frozenset({"a", "A", "I"})
_MEASURES = frozenset({"amplitude", "depth", "distance", "height", "length", "radius", "thickness", "width"})
"""What a letter follows that is else a word: the distance a."""


def set_text(text: str, problem: Problem) -> tuple[Part, ...]:
    """A text with its formulas and symbols."""
    parts: list[Part] = []
    end = 0
    for n, match in enumerate(_MARKED.finditer(text)):
        if n == MOST_FORMULAS:
            break
        parts += _unmarked(text[end : match.start()], problem)
        parts += _formula(match[1] or match[2], problem)
        end = match.end()
    return tuple(_joined([*parts, *_unmarked(text[end:], problem)]))


def _unmarked(text: str, problem: Problem) -> Iterator[Part]:
    """A text without marks: what reads as a formula in declared names is one."""
    end = 0
    for n, (start, stop) in enumerate(formulas_in(text, {*problem.scope.names()})):
        if n == MOST_FORMULAS:
            break
        formula = _chain(text[start:stop], problem)
        if formula is not None:
            yield from _with_symbols(text[end:start], problem)
            yield formula
            end = stop
    yield from _with_symbols(text[end:], problem)


def _chain(text: str, problem: Problem) -> Math | None:
    """An expression, an equation, or several equal sides; None if it cannot be read."""
    *sides, last = text.split("=")
    quantity = _with_unit(last, problem, sides[-1] if sides else "")
    try:
        values = [_value(s, problem.scope) for s in (sides if quantity is not None else [*sides, last])]
    except ProblemError:
        return None
    return math(*values, *([] if quantity is None else [quantity]))


def _formula(text: str, problem: Problem) -> tuple[Part, ...]:
    """A formula, which may have letters that only the description uses; the text as it is if it cannot be read."""
    name, equals, right = text.rpartition("=")
    quantity = _with_unit(right, problem, name)
    if quantity is not None:
        [left] = _formula(name, problem) if equals else (math(quantity),)
        return (math(*left.sides, quantity) if equals and isinstance(left, Math) else math(quantity),)
    scope = problem.scope
    if "O" not in scope.vectors:  # in a text the point, and not its position
        scope = replace(scope, scalars={"O": sp.Symbol("O", real=True), **scope.scalars})
    try:
        return _read(text, scope)
    except ProblemError as error:
        names = [d.about for d in error.diagnostics if d.code == "unknown-symbol"]
    known = {name: sp.Symbol(name, real=True) for name in names}
    try:
        return _read(text, replace(scope, scalars={**known, **scope.scalars}))
    except ProblemError:
        return (text,)


def _with_unit(text: str, problem: Problem, equals: str) -> sp.Expr | None:
    """`60 N` as a number with its unit; None if there is no unit, or all its letters are declared.

    equals  what it is the value of: with a mass m in the file, `a = 0.3 m` is a length where a is one
    """
    parts = split_number(text)
    unit = None if parts is None else unit_of(parts[1])
    if parts is None or unit is None or not re.fullmatch(r"\s*\d+(?:\.\d+)?\s*", parts[0]):
        return None
    if {*problem.scope.names()} >= {*re.findall(r"[^\W\d]+", parts[1])}:
        symbol = problem.scope.scalars.get(equals.strip())
        if not isinstance(symbol, sp.Symbol) or known_dimensions(problem).get(symbol) != unit.dimension:
            return None
    digits = parts[0].strip()
    number = (
        sp.Float(digits, dps=len(digits.replace(".", "").lstrip("0")) or 1) if "." in digits else sp.Integer(digits)
    )
    return sp.Mul(number, UnitSymbol(parts[1], positive=True), evaluate=False)


def _read(text: str, scope: Scope) -> tuple[Part, ...]:
    if "=" not in text:
        return (math(_value(text, scope)),)
    equation = read_equation(Fragment.of(text), scope, [], latex=True)
    return (math(equation.lhs, equation.rhs),)


def _value(text: str, scope: Scope) -> sp.Expr:
    """The value of a formula; a square root of a product stays one."""
    root = _ROOT.fullmatch(text.strip())
    if root is None:
        return read_value(Fragment.of(text), scope, [], latex=True)
    number, latex, plain = root.groups()
    value = sp.Pow(read_value(Fragment.of(latex or plain), scope, [], latex=True), sp.S.Half, evaluate=False)
    return sp.Mul(int(number), value, evaluate=False) if number else value


def _with_symbols(text: str, problem: Problem) -> Iterator[Part]:
    """A text in which declared symbols are symbols."""
    symbols = {q.name: q for q in (*problem.slots.coordinates, *problem.slots.prescribed, *problem.unknowns)}
    symbols |= {p.symbol.name: p.symbol for p in problem.parameters}
    symbols |= {c.reaction.name: c.reaction for c in problem.constraints if not c.reaction.name.startswith("lambda_")}
    symbols |= {name: sp.Symbol(name, real=True) for name in _letters(problem) if name not in symbols}
    units: dict[str, sp.Expr] = {name: unit for name, unit in UNITS.items() if name not in symbols}
    units |= {name: UnitVector(name) for name in problem.scope.vectors if _NUMBERED.fullmatch(name)}
    if len(problem.bodies) == 1:  # n1 of the only body
        end_of = f"_{problem.bodies[0].name}"
        short = {n.removesuffix(end_of) for n in problem.scope.vectors if n.endswith(end_of)} - {*symbols}
        units = {n: UnitVector(n) for n in short if _NUMBERED.fullmatch(n)} | units
    end = 0
    for match in _SYMBOL.finditer(text):
        name = match[1].rstrip("'")
        if match[1] in units:
            yield text[end : match.start()]
            yield math(units[name])
            end = match.end()
            continue
        if name not in symbols or (name in _WORDS and not _MEASURES & {*text[: match.start()].split()[-1:]}):
            continue
        yield text[end : match.start()]
        yield math(sp.Symbol(match[1], real=True) if match[1] != name else symbols[name])
        end = match.end()
    yield text[end:]


def _letters(problem: Problem) -> Iterator[str]:
    """The names of quasi-velocities and undefined functions that are no words: v, f, omega_1."""
    names = (*(s.symbol.name for s in problem.speeds), *(f.name for f in problem.functions))
    return (name for name in names if len(name) == 1 or _NUMBERED.fullmatch(name))


def _joined(parts: list[Part]) -> Iterator[Part]:
    """The parts without empty texts."""
    return (p for p in parts if p != "")
