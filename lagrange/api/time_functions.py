"""Slots and functions of time: q, q', q'' in one notation, q(t), dq/dt, d²q/dt² as SymPy writes them in the other.

The program calculates in slots, plain symbols named `theta`, `theta'`, `theta''`; other programs for SymPy use
`Function("theta")(t)` and `Derivative`. An undefined function f(X, Y) is `Function("f")`, its partial derivative at a
place `Subs(Derivative(f(X, Y), X), (X, Y), place)`. Input is read by the names in it, whatever is assumed of its
symbols: `Symbol("m")` is the mass that the problem declares as positive. So are answers made with SymPy; they need no
text, and texts may be among them.

For a motion in numbers, prescribed motions u(t) and functions f(X, Y) must be given, in one of three ways:

    an expression of SymPy           0.1*sin(3*t), X**2/4: in t, or in the names of the arguments, and in parameters
    a function made of SymPy         lambda X, Y: X**2/4 + Y
    functions of numbers             (u, du, ddu), a function of one argument with its derivatives in order, or
                                     {(0, 0): f, (1, 0): f_X, ...} by orders of differentiation

The first two are differentiated exactly; nothing is ever differentiated by finite differences.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field
from itertools import count
from typing import Any, TypeAlias

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import BooleanAtom

from lagrange.answers.readings import GivenEquation, Reading
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import Slots, Unspecified, base, t
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.expressions.bounded_arithmetic import SCALAR_FUNCTIONS, BoundedArithmetic, TooExpensiveError
from lagrange.expressions.scope import Scope, help_for_function, help_for_symbol
from lagrange.expressions.syntax_tree import FUNCTIONS

TIME = sp.Symbol("t")
"""The time of `sympy.physics.mechanics.dynamicsymbols`."""


def in_functions_of_time(expression: sp.Expr, slots: Slots, time: sp.Symbol = TIME) -> sp.Expr:
    """An expression of slots as an expression of functions of time; derivatives stay unevaluated.

    slots  the coordinates and prescribed motions that become functions of `time`; all other symbols stay symbols
    """
    moving = {*slots.coordinates, *slots.prescribed}
    rule: dict[sp.Basic, sp.Basic] = {t: time}
    for s in expression.free_symbols:
        if base(s) in moving:
            order = len(s.name) - len(base(s).name)
            function = sp.Function(base(s).name)(time)
            rule[s] = sp.Derivative(function, (time, order)) if order else function
    return _with_functions(expression).xreplace(rule)


def _with_functions(expression: sp.Expr) -> sp.Expr:
    """Undefined functions as those of SymPy."""
    return expression.replace(lambda e: isinstance(e, Unspecified), _function)


def _function(f: Unspecified) -> sp.Expr:
    function = sp.Function(f.name)
    if not any(f.orders):
        return function(*f.arguments)
    places = [sp.Symbol(n) for n in f.argument_names]
    by = [(x, n) for x, n in zip(places, f.orders, strict=True) if n]
    return sp.Subs(sp.Derivative(function(*places), *by), tuple(places), f.arguments)


@record
class SympyReader:
    """Reads SymPy's expressions, of slots or of functions of time, as expressions of a problem.

    scope   the declared names, the only ones with a meaning
    formal  symbols that mean themselves: the arguments of a derivative inside `Subs`
    """

    scope: Scope
    formal: Mapping[str, sp.Symbol] = field(default_factory=dict)

    def equation(self, given: sp.Basic) -> tuple[sp.Expr, sp.Expr]:
        """The two sides of an equation; those of an expression are the expression and 0. Raises ProblemError."""
        if isinstance(given, BooleanAtom):  # what SymPy makes of 0 = 0 and 1 = 0
            return sp.S.Zero, sp.S.Zero if given == sp.true else sp.S.One
        if isinstance(given, sp.Equality):
            return self.expression(given.lhs), self.expression(given.rhs)
        if isinstance(given, sp.Expr):
            return self.expression(given), sp.S.Zero
        raise _not_understood(given)

    def expression(self, e: sp.Basic) -> sp.Expr:
        """The expression of the problem. Raises ProblemError if a name is not declared, or has no meaning here."""
        if isinstance(e, sp.Symbol):
            return self._symbol(e.name)
        if isinstance(e, sp.Float):
            return sp.Rational(str(e))  # 0.1 is a tenth, as in a problem file
        if isinstance(e, sp.Rational) or e in (sp.pi, sp.E):
            return e
        if isinstance(e, Unspecified):
            return e.func(*e.args[:3], *map(self.expression, e.arguments))
        if isinstance(e, sp.Derivative):
            return self._derivative(e)
        if isinstance(e, sp.Subs):
            return self._substituted(e)
        if isinstance(e, AppliedUndef):
            return self._applied(e)
        if e.func in (sp.Add, sp.Mul, sp.Pow, *SCALAR_FUNCTIONS.values()):
            return e.func(*map(self.expression, e.args))
        raise _not_understood(e)

    def _symbol(self, name: str) -> sp.Expr:
        if name in self.formal:
            return self.formal[name]
        plain = name.rstrip("'")
        value = self.scope.scalar(plain)
        if value is None:
            error = Diagnostic("unknown-symbol", f"`{name}` is not declared", help=help_for_symbol(plain, self.scope))
            raise ProblemError(error)
        return self._rate(value, len(name) - len(plain))

    def _rate(self, value: sp.Expr, order: int) -> sp.Expr:
        """A total time derivative, as in texts: up to q'' of a coordinate, up to the fourth of a prescribed motion."""
        arithmetic = BoundedArithmetic(self.scope.slots)
        try:
            for _ in range(order):
                value = arithmetic.rate(value)
        except TooExpensiveError as refused:
            raise ProblemError(Diagnostic(refused.code, refused.message.format(value), help=refused.help)) from None
        return value

    def _applied(self, e: AppliedUndef) -> sp.Expr:
        """f(X, Y), or q(t)."""
        name = e.func.__name__
        declared = self.scope.functions.get(name)
        if declared is not None and len(declared.arguments) == len(e.args):
            return Unspecified.of(name, declared.arguments, *map(self.expression, e.args))
        if declared is None and self.scope.scalar(name) is not None and list(map(self.expression, e.args)) == [t]:
            return self._symbol(name)
        help_ = f"it is declared as {declared}" if declared else help_for_function(name, self.scope)
        raise ProblemError(Diagnostic("unknown-function", f"`{e}` is not declared", help=help_))

    def _derivative(self, e: sp.Derivative) -> sp.Expr:
        """A total derivative for those with respect to time, otherwise a partial one."""
        value = self.expression(e.expr)
        for variable, order in e.variable_count:
            by = self.expression(variable)
            if by == t:
                value = self._rate(value, int(order))
            elif by.is_Symbol:
                value = value.diff(by, int(order))
            else:
                raise _not_understood(e)
        return value

    def _substituted(self, e: sp.Subs) -> sp.Expr:
        formal = {str(v): sp.Dummy(str(v), real=True) for v in e.variables if isinstance(v, sp.Symbol)}
        if len(formal) < len(e.variables):
            raise _not_understood(e)
        inside = SympyReader(self.scope, {**self.formal, **formal}).expression(e.expr)
        at = map(self.expression, e.point)
        return inside.xreplace({formal[str(v)]: p for v, p in zip(e.variables, at, strict=True)})


def _not_understood(e: object) -> ProblemError:
    """The error about an object that has no meaning in a problem."""
    what = getattr(getattr(e, "func", None), "__name__", type(e).__name__)
    help_ = f"an expression has numbers, declared names, + - * / **, derivatives, and {', '.join(sorted(FUNCTIONS))}"
    return ProblemError(Diagnostic("unknown-function", f"`{what}` has no meaning in an equation of motion", help=help_))


def flattened(given: object) -> Iterable[object]:
    """The equations in lists, tuples and matrices of them, in their order."""
    if isinstance(given, sp.MatrixBase | list | tuple):
        for part in given:
            yield from flattened(part)
    else:
        yield given


Given: TypeAlias = (
    sp.Expr | Callable[..., Any] | Sequence[Callable[..., float]] | Mapping[tuple[int, ...], Callable[..., float]]
)
Calls: TypeAlias = dict[str, Callable[..., float]]


def with_given(
    expressions: Sequence[sp.Expr], functions: Mapping[str, Given], slots: Slots, unknowns: Sequence[sp.Symbol] = ()
) -> tuple[list[sp.Expr], Calls]:
    """The expressions after substitution of the given functions, and the functions of numbers that they call.

    unknowns  forces that may be given as expressions of t, coordinates and velocities

    Raises ValueError if something is missing.
    """
    maker = _Maker(functions, slots)
    symbols = set().union(*(e.free_symbols for e in expressions)) if expressions else set()
    rule: dict[sp.Basic, sp.Expr] = {}
    for s in sorted(symbols, key=lambda s: str(s.name)):
        if base(s) in slots.prescribed:
            rule[s] = maker.derivative(base(s).name, ("t",), (len(s.name) - len(base(s).name),), (t,))
        elif s in unknowns and s.name in functions:
            rule[s] = maker.derivative(s.name, (), (), ())

    def put(f: Unspecified) -> sp.Expr:
        return maker.derivative(f.name, f.argument_names, f.orders, f.arguments)

    taken = (e.replace(lambda a: isinstance(a, Unspecified), put) for e in expressions)
    return [e.xreplace(rule) for e in taken], maker.calls


class _Maker:
    """Derivatives of given functions; functions of numbers are named call0, call1, ..."""

    def __init__(self, functions: Mapping[str, Given], slots: Slots) -> None:
        self.calls: Calls = {}
        self._functions = functions
        self._moving = {s.name: s for s in (t, *slots.coordinates, *slots.velocities)}
        self._numbers = count()
        self._known: dict[tuple[str, tuple[int, ...]], Any] = {}

    def derivative(
        self, name: str, names: Sequence[str], orders: tuple[int, ...], arguments: Sequence[sp.Expr]
    ) -> sp.Expr:
        """The derivative of these orders of a function, at its arguments."""
        if name not in self._functions:
            listed = ", ".join(names)
            help_ = f"functions={{{name!r}: an expression in {listed}}} gives it"
            raise ValueError(f"the equations contain {name}({listed}), which is not given; {help_}")
        given = self._functions[name]
        if isinstance(given, Mapping | list | tuple):
            return self._call(name, given, orders)(*arguments)
        places = [sp.Dummy(n, real=True) for n in names]
        e = self._expression(name, given, dict(zip(names, places, strict=True)))
        by = [(x, n) for x, n in zip(places, orders, strict=True) if n]
        return (e.diff(*by) if by else e).xreplace(dict(zip(places, arguments, strict=True)))

    def _expression(self, name: str, given: Any, places: Mapping[str, sp.Symbol]) -> sp.Expr:
        """A given function of the symbols for its arguments; t, coordinates and velocities are found by name."""
        if callable(given) and not isinstance(given, sp.Basic):
            given = _called(name, given, list(places.values()))
        e = sp.sympify(given, strict=True)
        meant = {**self._moving, **places}
        return e.xreplace({s: meant[s.name] for s in e.free_symbols if s.name in meant})

    def _call(self, name: str, given: Any, orders: tuple[int, ...]) -> Any:
        """A symbolic function for a function of numbers."""
        key = (name, orders)
        if key not in self._known:
            by_orders = given if isinstance(given, Mapping) else {(n,): f for n, f in enumerate(given)}
            if orders not in by_orders:
                which = orders[0] if len(orders) == 1 else orders
                raise ValueError(f"the equations contain the derivative of `{name}` of order {which}: give it too")
            self._known[key] = sp.Function(f"call{next(self._numbers)}")
            self.calls[self._known[key].__name__] = by_orders[orders]
        return self._known[key]


def _called(name: str, function: Callable[..., Any], places: Sequence[sp.Symbol]) -> Any:
    """The value of a function made of SymPy's functions."""
    try:
        return function(*places)
    except (TypeError, ValueError, AttributeError) as error:
        help_ = "make it of SymPy's functions, or give a tuple of functions of numbers: itself and its derivatives"
        raise ValueError(f"`{name}` cannot be differentiated: {error}; {help_}") from error


def answer_of(equations: object, scope: Scope, notation: Notation) -> tuple[Fragment, ...]:
    """An answer from texts and SymPy's equations, or lists and matrices of them; an expression is meant to vanish."""
    parts = enumerate(flattened(equations), start=1)
    return tuple(_fragment(e, f"equation {n}", scope, notation) for n, e in parts)


def _fragment(equation: object, name: str, scope: Scope, notation: Notation) -> Fragment:
    if isinstance(equation, str):
        return Fragment.of(equation, name)
    try:
        lhs, rhs = SympyReader(scope).equation(equation)
    except ProblemError as error:
        return GivenEquation.of_reading(Reading(str(equation), error=error), name)
    written = f"{text(lhs, notation)} = {text(rhs, notation)}"
    return GivenEquation.of_reading(Reading(written, (lhs - rhs,)), name)
