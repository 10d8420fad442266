"""The symbols that a problem file declares: parameters, coordinates, functions, unknown forces.

A parameter is positive unless the file says otherwise. A function of t alone is a prescribed motion and gets the slots
u, u', u''; any other is an undefined function of its arguments. A wrong section is reported, and the names in it count
as failed, so that their uses are not reported as well.

If a file takes an undefined function f at one point only, f(x - u, y, z), the name f alone means its value there: an
answer writes ∂f/∂X as `diff(f, X)`. Argument names that are symbols of the file state the point themselves; if the
function is taken at several points, its arguments must be written.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import fields, is_dataclass, replace
from functools import partial
from typing import TypeVar

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Severity, nearest
from lagrange.core.records import record
from lagrange.core.symbols import Slots, Unspecified
from lagrange.core.units import has_unit, unit_of
from lagrange.expressions.reader import RESERVED, FunctionDeclaration, Scope
from lagrange.problem.keys import COORDINATE, PARAMETER, Assumption
from lagrange.problem.load_context import DeclaredNames, canonical, names_in
from lagrange.problem.model import Coordinate, Parameter, Problem, Range
from lagrange.problem.sections import Section, entries_of, items_of, scalar_of, wrong_kind
from lagrange.problem.values import bounded_symbol, parameter_symbol, read_number_with_unit, read_range, with_value
from lagrange.problem.yaml.nodes import ListNode, MappingNode, Node, Scalar

T = TypeVar("T")


def read_parameters(node: Node | None, names: DeclaredNames) -> tuple[Parameter, ...]:
    """A list of names, all positive; or name -> assumption, or name -> {assume, unit, meaning, value}."""
    return _declared(node, "parameters", names, _parameter)


def read_coordinates(node: Node | None, names: DeclaredNames) -> tuple[Coordinate, ...]:
    """A list of names, or name -> meaning, or name -> {meaning, unit}."""
    return _declared(node, "coordinates", names, _coordinate)


def read_unknowns(node: Node | None, names: DeclaredNames, forces: Node | None = None) -> tuple[sp.Symbol, ...]:
    """A list of names of unknown forces. Coefficients of friction and angles of contact among them are positive."""
    unknown = _declared(node, "unknowns", names, _unknown)
    entries = forces.entries if isinstance(forces, MappingNode) else ()
    coefficients = {
        value.text.strip()
        for _, force in entries
        if isinstance(force, MappingNode)
        for key, value in force.entries
        if key.text in ("belt", "friction", "static", "angle") and isinstance(value, Scalar)
    }
    return tuple(sp.Symbol(s.name, positive=True) if s.name in coefficients else s for s in unknown)


def _declared(
    node: Node | None, key: str, names: DeclaredNames, read: Callable[[Scalar, Node | None, DeclaredNames], T | None]
) -> tuple[T, ...]:
    """The names declared by a list or a mapping."""
    if node is None:
        return ()
    entries: list[tuple[Node, Node | None]]
    if isinstance(node, MappingNode) and key != "unknowns":
        entries = list(node.entries)
    elif isinstance(node, ListNode):
        entries = [(item, None) for item in node.items]
        if not entries and key == "coordinates":
            help_ = "list what moves, as `coordinates: [x, y]`"
            names.diagnostics.report(Diagnostic("empty-value", "`coordinates` is an empty list", node.span, help=help_))
    else:
        names.fail_all(node)
        names.diagnostics.report(wrong_kind(node, f"`{key}` is a list of names", f"write `{key}: {_as_list(node)}`"))
        return ()
    declared = []
    for name, value in entries:
        item = names.diagnostics.attempt(partial(_entry, name, value, key, names, read))
        if item is not None:
            declared.append(item)
    return tuple(declared)


def _entry(
    name: Node,
    value: Node | None,
    key: str,
    names: DeclaredNames,
    read: Callable[[Scalar, Node | None, DeclaredNames], T | None],
) -> T | None:
    if not isinstance(name, Scalar):
        names.fail_all(name)
        message = f"an entry of the list `{key}` is one name"
        raise ProblemError(wrong_kind(name, message, f"write all of `{key}` as a list, or all as a mapping"))
    if value is not None and isinstance(value, Scalar) and value.is_empty:
        value = None
    try:
        return read(name, value, names)
    except ProblemError:
        names.fail(canonical(name.text))
        raise


def _as_list(node: Node) -> str:
    listed = names_in(node.text) if isinstance(node, Scalar) else ()
    return f"[{', '.join(listed or ('a', 'b'))}]"


def _parameter(key: Scalar, value: Node | None, names: DeclaredNames) -> Parameter | None:
    name = names.declare(key, "a parameter")
    if name is None:
        return None
    if value is None:
        return Parameter(parameter_symbol(name, Assumption.POSITIVE))
    attempt = names.diagnostics.attempt
    if isinstance(value, Scalar) and states_value(value.text):
        positive = Parameter(parameter_symbol(name, Assumption.POSITIVE))
        return _with_value(positive, value, None, Assumption.POSITIVE, names)
    if isinstance(value, Scalar) and value.text not in set(Assumption) and unit_of(value.text) is not None:
        return Parameter(
            parameter_symbol(name, Assumption.POSITIVE), Assumption.POSITIVE, value.text, stated_unit=value.text
        )
    if isinstance(value, Scalar):
        assume = attempt(lambda: _assumption(value)) or Assumption.POSITIVE
        return Parameter(parameter_symbol(name, assume), assume, is_stated=True)
    if isinstance(value, ListNode):
        message = f"the declaration of `{name}` is an assumption or a mapping"
        names.diagnostics.report(wrong_kind(value, message, f"write `{name}: positive`"))
        return Parameter(parameter_symbol(name, Assumption.POSITIVE))
    section = Section(value, f"the parameter `{name}`", PARAMETER, names.diagnostics)
    assumed, number = section.get("assume"), section.get("value")
    known = attempt(lambda: _assumption(scalar_of(assumed, "`assume`"))) if assumed else Assumption.POSITIVE
    assume = known or Assumption.POSITIVE
    unit, limits = section.text("unit"), section.get("range")
    within = attempt(lambda: _range_in_numbers(limits, name, unit)) if limits else None
    if within is not None and limits is not None:
        assume = known if assumed and known else Assumption.REAL
        symbol = attempt(lambda: bounded_symbol(name, within, assume, limits.span)) or parameter_symbol(name, assume)
    else:
        symbol = parameter_symbol(name, assume)
    parameter = Parameter(symbol, assume, unit, section.text("meaning"), stated_unit=unit, range=within)
    parameter = replace(parameter, is_stated=assumed is not None or limits is not None)
    if number is None:
        return parameter
    declared = section.get("unit") if unit else None
    stated = Fragment(unit, declared.span) if declared else None
    return _with_value(parameter, number, stated, known, names)


def states_value(text: str) -> bool:
    """Whether a declaration is a value, `m: 2 kg` for `m: {value: 2 kg}`."""
    return re.match(r"\s*[-+−]?\s*\.?[0-9]", text) is not None


def _with_value(
    parameter: Parameter, number: Node, unit: Fragment | None, known: Assumption | None, names: DeclaredNames
) -> Parameter:
    read = names.diagnostics.attempt(
        lambda: read_number_with_unit(scalar_of(number, "`value`").fragment, unit, parameter.symbol, known)
    )
    if read is None:
        return parameter
    return with_value(parameter, read)


def _range_in_numbers(node: Node, name: str, unit: str) -> Range:
    """The range of a parameter. Raises ProblemError, also where an end contains another parameter."""
    ends = node.items if isinstance(node, ListNode) else ()
    for text in (e.text for e in ends if isinstance(e, Scalar) and not has_unit(e.text)):
        others = [n for n in names_in(text) if n not in RESERVED]
        if others:
            message = f"the range of the parameter `{name}` contains `{others[0]}`"
            help_ = "its ends are numbers, `range: [0, 60 deg]`; only those of a coordinate may contain parameters"
            raise ProblemError(Diagnostic("bad-range", message, node.span, help=help_))
    return read_range(node, name, unit, Scope())


def _assumption(scalar: Scalar) -> Assumption:
    if scalar.text in set(Assumption):
        return Assumption(scalar.text)
    message = f"`{scalar.text}` is not an assumption"
    listed = ", ".join(f"`{a}`" for a in Assumption)
    near = None if scalar.text == "negative" else nearest(scalar.text, [*Assumption])
    help_ = f"did you mean `{near}`?" if near else f"write {listed}, or a value with its unit, `2 kg`"
    if scalar.text == "negative":
        help_ = "name its positive size, and write a minus where it is used; or write `real`"
    raise ProblemError(Diagnostic("unknown-assumption", message, scalar.span, help=help_))


def _coordinate(key: Scalar, value: Node | None, names: DeclaredNames) -> Coordinate | None:
    name = names.declare(key, "a coordinate")
    if name is None:
        return None
    symbol = sp.Symbol(name, real=True)
    if value is None:
        return Coordinate(symbol)
    if isinstance(value, Scalar):
        meaning = " ".join(value.text.split())
        if meaning in [*Assumption]:
            names.diagnostics.report(_assumed_of_coordinate(name, value))
            return Coordinate(symbol)
        return Coordinate(symbol, meaning)
    if isinstance(value, ListNode):
        message = f"the declaration of `{name}` is its meaning or a mapping"
        names.diagnostics.report(wrong_kind(value, message, f"write `{name}: its meaning`"))
        return Coordinate(symbol)
    section = Section(value, f"the coordinate `{name}`", COORDINATE, names.diagnostics)
    unit, limits = section.text("unit"), section.get("range")
    scope = Scope(scalars={p.name: p for p in names.parameters})
    within = names.diagnostics.attempt(lambda: read_range(limits, name, unit, scope)) if limits else None
    return Coordinate(symbol, section.text("meaning"), unit, within)


def _assumed_of_coordinate(name: str, value: Scalar) -> Diagnostic:
    message = f"`{value.text}` is an assumption about a parameter, but `{name}` is a coordinate"
    help_ = f"write `{name}: {{range: [0, 10 m]}}` for where it may lie; what stands after the colon is its meaning"
    return Diagnostic("assumed-of-coordinate", message, value.span, help=help_, level=Severity.NOTE)


def _unknown(key: Scalar, _value: Node | None, names: DeclaredNames) -> sp.Symbol | None:
    name = names.declare(key, "an unknown force")
    return None if name is None else sp.Symbol(name, real=True)


@record
class DeclaredFunctions:
    """The prescribed motions u(t), and the other undefined functions."""

    prescribed: tuple[sp.Symbol, ...] = ()
    undefined: tuple[FunctionDeclaration, ...] = ()


def read_functions(node: Node | None, names: DeclaredNames) -> DeclaredFunctions:
    """name -> list of argument names."""
    if node is None:
        return DeclaredFunctions()
    prescribed: list[sp.Symbol] = []
    undefined: list[FunctionDeclaration] = []
    for key, value in names.diagnostics.attempt(lambda: _function_entries(node, names)) or ():
        name = names.declare(key, "a function")
        if name is None:
            continue
        arguments = names.diagnostics.attempt(partial(_arguments, name, value))
        if arguments is None:
            names.fail(name)
        elif arguments == ("t",):
            prescribed.append(sp.Symbol(name, real=True))
        else:
            undefined.append(FunctionDeclaration(name, arguments))
    return DeclaredFunctions(tuple(prescribed), tuple(undefined))


def _function_entries(node: Node, names: DeclaredNames) -> tuple[tuple[Scalar, Node], ...]:
    if not isinstance(node, MappingNode):
        names.fail_all(node)
    return entries_of(node, "`functions`", "functions: {f: [X, Y], u: [t]}")


def _arguments(function: str, node: Node) -> tuple[str, ...]:
    items = items_of(node, f"the declaration of the function `{function}`", f"{function}: [t]")
    if not items:
        message = f"the function `{function}` has no arguments"
        raise ProblemError(Diagnostic("no-arguments", message, node.span, help=f"write `{function}: [X, Y]` or `[t]`"))
    arguments: list[str] = []
    for item in items:
        scalar = scalar_of(item, "an argument")
        name = _argument(scalar)
        if name in arguments:
            message = f"the function `{function}` has two arguments `{name}`"
            raise ProblemError(Diagnostic("declared-twice", message, scalar.span, help="give them different names"))
        arguments.append(name)
    return tuple(arguments)


def _argument(scalar: Scalar) -> str:
    """A name, a name with a prime, or t."""
    plain = scalar.text.rstrip("'′’")
    primes = len(scalar.text) - len(plain)
    named = names_in(plain)
    if len(named) == 1 and canonical(plain) == named[0] and primes <= 1:
        return named[0] + "'" * primes
    message = f"`{scalar.text}` cannot be the name of an argument"
    help_ = "write a name, a velocity such as `x'`, or `t`; its places are filled where the function is used"
    raise ProblemError(Diagnostic("bad-name", message, scalar.span, help=help_))


def first_scope(
    parameters: tuple[Parameter, ...],
    coordinates: tuple[Coordinate, ...],
    functions: DeclaredFunctions,
    unknowns: tuple[sp.Symbol, ...],
) -> Scope:
    """The scope of the declared symbols alone."""
    symbols = [*(p.symbol for p in parameters), *(c.symbol for c in coordinates), *unknowns]
    return Scope(
        scalars={s.name: s for s in symbols},
        slots=Slots(tuple(c.symbol for c in coordinates), functions.prescribed),
        functions={f.name: f for f in functions.undefined},
    )


def with_standard_arguments(problem: Problem) -> Problem:
    """The problem with the point of each function that its name alone stands for, where there is only one."""
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


def note_unused(problem: Problem, node: Node | None, report: Callable[[Diagnostic], None]) -> None:
    """Notes on parameters that appear nowhere: a forgotten spring, or a misspelt letter."""
    used: set[str] = {name for f in problem.functions for name in f.arguments}
    for f in fields(problem):
        if f.name not in ("parameters", "scope", "slots"):
            used |= {s.name for e in expressions_of(getattr(problem, f.name)) for s in e.free_symbols}
    keys = [key for key, _ in node.entries] if isinstance(node, MappingNode) else getattr(node, "items", ())
    declared = {canonical(k.text): k for k in keys if isinstance(k, Scalar)}
    idle = [name for name in declared if name in problem.scope.scalars and name not in used]
    if idle:
        listed = ", ".join(f"`{name}`" for name in idle)
        message = f"{listed} {'is' if len(idle) == 1 else 'are'} not used"
        help_ = "remove what is not needed, or use it where it was meant to act"
        span = declared[idle[0]].span
        report(Diagnostic("unused-parameter", message, span, help=help_, level=Severity.NOTE))


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
