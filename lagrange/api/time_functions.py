"""Slots and functions of time: q, q', q'' on one side, q(t), dq/dt, d²q/dt² as SymPy writes them on the other.

The program calculates in slots, plain symbols that are called `theta`, `theta'`, `theta''`. Other programs for SymPy
want `Function("theta")(t)` and `Derivative`. An undefined function f(X, Y) is `Function("f")`, its partial derivative
at a place `Subs(Derivative(f(X, Y), X), (X, Y), place)`. What comes from outside is read by the names in it, whatever
is assumed of its symbols: `Symbol("m")` is the mass that the problem declares as positive.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import BooleanAtom

from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import Slots, Unspecified, base, t
from lagrange.expressions.bounded import SCALAR_FUNCTIONS, Arithmetic
from lagrange.expressions.constants import RefusedError
from lagrange.expressions.lexicon import FUNCTIONS
from lagrange.expressions.scope import Scope
from lagrange.expressions.spelling import help_for_function, help_for_symbol

TIME = sp.Symbol("t")
"""The time of `sympy.physics.mechanics.dynamicsymbols`."""


def in_functions_of_time(expression: sp.Expr, slots: Slots, time: sp.Symbol = TIME) -> sp.Expr:
    """An expression of slots in functions of time, derivatives not carried out further.

    slots  what moves: their coordinates and prescribed motions become functions of `time`; all else stays a symbol
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
class Reader:
    """Reads SymPy's expressions, of slots or of functions of time, as expressions of a problem.

    scope   what is declared: the only names that have a meaning
    formal  symbols that mean themselves: the places of a derivative inside `Subs`
    """

    scope: Scope
    formal: Mapping[str, sp.Symbol] = field(default_factory=dict)

    def equation(self, given: sp.Basic) -> tuple[sp.Expr, sp.Expr]:
        """The two sides of an equation; an expression is one that vanishes. Raises ProblemError."""
        if isinstance(given, BooleanAtom):  # what SymPy makes of 0 = 0 and 1 = 0
            return sp.S.Zero, sp.S.Zero if given == sp.true else sp.S.One
        if isinstance(given, sp.Equality):
            return self.expression(given.lhs), self.expression(given.rhs)
        if isinstance(given, sp.Expr):
            return self.expression(given), sp.S.Zero
        raise _not_understood(given)

    def expression(self, e: sp.Basic) -> sp.Expr:
        """The expression of the problem. Raises ProblemError where a name is not declared, or has no meaning here."""
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
        """Total time derivatives, within the bounds of those in a text: two of a coordinate, four of a given motion."""
        arithmetic = Arithmetic(self.scope.slots)
        try:
            for _ in range(order):
                value = arithmetic.rate(value)
        except RefusedError as refused:
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
        """Derivatives by time are total ones, others partial."""
        value = self.expression(e.expr)
        for variable, count in e.variable_count:
            by = self.expression(variable)
            if by == t:
                value = self._rate(value, int(count))
            elif by.is_Symbol:
                value = value.diff(by, int(count))
            else:
                raise _not_understood(e)
        return value

    def _substituted(self, e: sp.Subs) -> sp.Expr:
        formal = {str(v): sp.Dummy(str(v), real=True) for v in e.variables if isinstance(v, sp.Symbol)}
        if len(formal) < len(e.variables):
            raise _not_understood(e)
        inside = Reader(self.scope, {**self.formal, **formal}).expression(e.expr)
        at = map(self.expression, e.point)
        return inside.xreplace({formal[str(v)]: p for v, p in zip(e.variables, at, strict=True)})


def _not_understood(e: object) -> ProblemError:
    """An object of SymPy, or of something else, that no problem has a meaning for."""
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
