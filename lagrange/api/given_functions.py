"""What stands for undefined functions and prescribed motions where a motion is calculated in numbers.

The equations of motion have u, u' and u'' of a prescribed motion u(t), and partial derivatives of f(X, Y). Each may be
given as

    an expression of SymPy           0.1*sin(3*t), X**2/4: in t, or in the names of the arguments, and in parameters
    a function made of SymPy         lambda X, Y: X**2/4 + Y
    functions of numbers             (u, du, ddu), a function of one argument with its derivatives in their order, or
                                     {(0, 0): f, (1, 0): f_X, ...} by orders of differentiation

The first two are differentiated exactly; nothing is ever differentiated by finite differences.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import count
from typing import Any, TypeAlias

import sympy as sp

from lagrange.core.symbols import Slots, Unspecified, base, t

Given: TypeAlias = (
    sp.Expr | Callable[..., Any] | Sequence[Callable[..., float]] | Mapping[tuple[int, ...], Callable[..., float]]
)
Calls: TypeAlias = dict[str, Callable[..., float]]


def with_given(
    expressions: Sequence[sp.Expr], functions: Mapping[str, Given], slots: Slots, unknowns: Sequence[sp.Symbol] = ()
) -> tuple[list[sp.Expr], Calls]:
    """The expressions with what is given put in, and the functions of numbers that they call.

    unknowns  forces that may be given as expressions of t, coordinates and velocities

    Raises ValueError where something is missing.
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
    """Derivatives of what is given; functions of numbers are called call0, call1, ..."""

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
            raise ValueError(f"the equations contain {name}({listed}), which nothing is known of; {help_}")
        given = self._functions[name]
        if isinstance(given, Mapping | list | tuple):
            return self._call(name, given, orders)(*arguments)
        places = [sp.Dummy(n, real=True) for n in names]
        e = self._expression(name, given, dict(zip(names, places, strict=True)))
        by = [(x, n) for x, n in zip(places, orders, strict=True) if n]
        return (e.diff(*by) if by else e).xreplace(dict(zip(places, arguments, strict=True)))

    def _expression(self, name: str, given: Any, places: Mapping[str, sp.Symbol]) -> sp.Expr:
        """What is given in the places of its arguments; t, coordinates and velocities by their names."""
        if callable(given) and not isinstance(given, sp.Basic):
            given = _called(name, given, list(places.values()))
        e = sp.sympify(given, strict=True)
        meant = {**self._moving, **places}
        return e.xreplace({s: meant[s.name] for s in e.free_symbols if s.name in meant})

    def _call(self, name: str, given: Any, orders: tuple[int, ...]) -> Any:
        """A function of numbers as one that SymPy can write down."""
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
    """What a function made of SymPy's functions comes to."""
    try:
        return function(*places)
    except (TypeError, ValueError, AttributeError) as error:
        help_ = "make it of SymPy's functions, or give a tuple of functions of numbers: itself and its derivatives"
        raise ValueError(f"`{name}` cannot be differentiated: {error}; {help_}") from error
