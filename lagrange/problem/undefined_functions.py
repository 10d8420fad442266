"""Where the undefined functions of a problem are taken.

A function f that a file takes at one place only, f(x - u, y, z), is meant there when its name stands alone: an answer
writes ∂f/∂X as `diff(f, X)`. Where the argument names are themselves symbols of the file, they say so already; where
the function is taken at several places, its arguments must be written.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import fields, is_dataclass, replace

import sympy as sp

from lagrange.core.symbols import Unspecified
from lagrange.expressions.reader import FunctionDeclaration, Scope
from lagrange.problem.model import Problem


def with_standard_arguments(problem: Problem) -> Problem:
    """The problem, its functions taken where the file takes them, as far as that is one place."""
    if not problem.functions:
        return problem
    taken: dict[str, set[tuple[sp.Expr, ...]]] = {}
    for expression in expressions_of(problem):
        for function in expression.atoms(Unspecified):
            taken.setdefault(function.name, set()).add(function.arguments)
    functions = tuple(_standard(f, taken.get(f.name, set()), problem.scope) for f in problem.functions)
    scope = replace(problem.scope, functions={f.name: f for f in functions})
    return replace(problem, functions=functions, scope=scope)


def _standard(function: FunctionDeclaration, taken: set[tuple[sp.Expr, ...]], scope: Scope) -> FunctionDeclaration:
    readable = all(scope.scalar(name.rstrip("'")) is not None for name in function.arguments)
    if readable or len(taken) != 1:
        return function
    [arguments] = taken
    return replace(function, standard=arguments)


def expressions_of(part: object) -> Iterator[sp.Expr]:
    """All expressions in a problem, or in a part of one."""
    if isinstance(part, sp.Expr):
        yield part
    elif is_dataclass(part):
        for f in fields(part):
            yield from expressions_of(getattr(part, f.name))
    elif isinstance(part, dict):
        yield from expressions_of(part.values())
    elif isinstance(part, Iterable) and not isinstance(part, str | sp.Basic):
        for item in part:
            yield from expressions_of(item)
