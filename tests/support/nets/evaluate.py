"""Texts in the language of problem files, evaluated with numbers or series: a second reader, which shares no code with the first.

A text becomes Python's syntax (x' is `x__1`, ^ is **), and its tree is walked; whatever is not arithmetic, a name or a function of the
language is refused. i, j and k (or e_x, e_y, e_z) are arrays of three, if the names given say so. What is outside a domain is nan.
"""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np

from tests.support.nets.taylor import Taylor, function

VECTORS = {"i": np.array([1.0, 0, 0]), "j": np.array([0, 1.0, 0]), "k": np.array([0, 0, 1.0])}
VECTORS |= {"e_x": VECTORS["i"], "e_y": VECTORS["j"], "e_z": VECTORS["k"]}

PLAIN = {
    **{
        name: getattr(math, name)
        for name in ["sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt"]
    },
    "abs": abs,
    "sign": lambda x: math.copysign(1, x) if x else 0.0,
}
OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul}
COMPARED = re.compile(r"\s(=|≠|≥|≤|>|<|!=|>=|<=)\s")
NAME = re.compile(r"(?<![\w.])[^\W\d]\w*'*")
FUNCTIONS = {*PLAIN, "atanh", "cot", "sec", "csc", "atan2", "dot", "cross", "norm", "min", "max"}


class NotReadError(Exception):
    """A text that is not in the language, or has a name without a value."""


@lru_cache(maxsize=4000)
def _tree(text: str) -> ast.expr:
    source = re.sub(r"('+)", lambda m: f"__{len(m[1])}", text.replace("^", "**").replace("−", "-"))
    source = re.sub(r"\blambda\b", "lambda__0", source)
    try:
        return ast.parse(source.strip(), mode="eval").body
    except SyntaxError as error:
        raise NotReadError(f"{text!r}: {error.msg}") from None


def evaluate(text: str, names: Mapping[str, Any]) -> Any:
    """The value of an expression: a float, a series, or an array of three."""
    return _value(_tree(text), names, text)


def python_name(name: str) -> str:
    """x' as it is called in the tree: x__1."""
    bare = name.rstrip("'")
    return f"{bare}__{len(name) - len(bare)}" if bare != name else name


def _value(node: ast.expr, names: Mapping[str, Any], text: str) -> Any:
    match node:
        case ast.Constant(value=int() | float() as number):
            return float(number)
        case ast.Name(id=name):
            if name in names:
                return names[name]
            if name == "pi":
                return math.pi
            raise NotReadError(f"`{name}` in {text!r} is no name of the file")
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return -_value(inner, names, text)
        case ast.UnaryOp(op=ast.UAdd(), operand=inner):
            return _value(inner, names, text)
        case ast.BinOp(left=a, op=ast.Pow(), right=b):
            return _power(_value(a, names, text), _value(b, names, text))
        case ast.BinOp(left=a, op=ast.Div(), right=b):
            return _quotient(_value(a, names, text), _value(b, names, text))
        case ast.BinOp(left=a, op=op, right=b) if type(op) in OPERATORS:
            return OPERATORS[type(op)](_value(a, names, text), _value(b, names, text))
        case ast.Call(func=ast.Name(id=name), args=arguments) if name in FUNCTIONS:
            return _called(name, [_value(a, names, text) for a in arguments])
    raise NotReadError(f"{ast.dump(node)[:60]} in {text!r}")


def _power(base: Any, exponent: Any) -> Any:
    if isinstance(base, Taylor):
        return base**exponent
    if isinstance(exponent, Taylor):
        return exponent.__rpow__(base)
    try:
        value = base**exponent
    except (ZeroDivisionError, OverflowError):
        return math.nan
    return math.nan if isinstance(value, complex) else value


def _quotient(above: Any, below: Any) -> Any:
    try:
        return above / below
    except ZeroDivisionError:
        return math.nan


def _called(name: str, x: list[Any]) -> Any:
    match name:
        case "tan" if isinstance(x[0], Taylor):
            return _called("sin", x) / _called("cos", x)
        case "tanh" if isinstance(x[0], Taylor):
            return _called("sinh", x) / _called("cosh", x)
        case "atanh":  # of a real integral, which goes on beyond 1
            return 0.5 * _called("log", [_called("abs", [_quotient(1 + x[0], 1 - x[0])])])
        case "cot":
            return _quotient(_called("cos", x), _called("sin", x))
        case "sec" | "csc":
            return _quotient(1.0, _called("cos" if name == "sec" else "sin", x))
        case "atan2" if any(isinstance(v, Taylor) for v in x):
            y, other = x  # by the half angle, of which the derivatives are right wherever atan2 is smooth
            return 2 * function(math.atan, "atan", y / ((other * other + y * y) ** 0.5 + other))
        case "atan2":
            return math.atan2(*x)
        case "dot":
            return sum(a * b for a, b in zip(*x, strict=True))
        case "cross":
            return np.cross(*x)
        case "norm":
            return _power(sum(a * a for a in x[0]), 0.5)
        case "min" | "max":
            return (min if name == "min" else max)(x)
    return function(PLAIN[name], name, x[0])


def sides(text: str) -> tuple[str, str, str]:
    """Left side, relation and right side of an equation or inequality."""
    parts = COMPARED.split(text)
    if len(parts) != 3:
        raise NotReadError(f"{text!r} is no relation")
    left, relation, right = parts
    return left, {"≠": "!=", "≥": ">=", "≤": "<="}.get(relation, relation), right


def difference(text: str, names: Mapping[str, Any]) -> Any:
    """Left minus right side of an equation."""
    left, _, right = sides(text)
    return evaluate(left, names) - evaluate(right, names)


def holds(text: str, names: Mapping[str, Any], tolerance: float = 1e-7) -> bool | None:
    """Whether an inequality holds; None too near to its limit to tell, or where a side has no value."""
    left, relation, right = sides(text)
    a, b = evaluate(left, names), evaluate(right, names)
    if not (math.isfinite(a) and math.isfinite(b)):
        return None
    if abs(a - b) <= tolerance * (1 + abs(a) + abs(b)):
        return None if relation != "=" else True
    return {"!=": True, "=": False, ">=": a > b, ">": a > b, "<=": a < b, "<": a < b}[relation]


def names_in(text: str) -> set[str]:
    """The names that occur in a text, without primes, apart from functions of the language."""
    return {n.rstrip("'") for n in NAME.findall(text)} - FUNCTIONS
