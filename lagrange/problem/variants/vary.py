"""The section `vary`: the values that parameters have in variants of a problem.

    vary: {m: [1 kg, 2 kg], l: {from: 0.2 m, to: 1 m, step: 0.1 m}}

A list has its values as they are written; a range has from, from + step, ... up to `to`, in the unit of `from`, all
exact. Every value must be one that the parameter may have: its dimension, its assumption, its range are checked where
they stand, so that no seed draws a value that the file could not have.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, suggestion
from lagrange.core.units import split_number, unit_of
from lagrange.problem.diagnostic_collector import Diagnostics
from lagrange.problem.keys import VARY
from lagrange.problem.limits import MOST_VARIED_VALUES
from lagrange.problem.load_context import canonical
from lagrange.problem.model import Parameter, Varied
from lagrange.problem.sections import Section, entries_of, items_of, scalar_of, wrong_kind
from lagrange.problem.values import ValueRead, read_number_with_unit, without_value
from lagrange.problem.yaml.nodes import ListNode, MappingNode, Node

_EXAMPLE = "vary: {m: [1 kg, 2 kg], l: {from: 0.2 m, to: 1 m, step: 0.1 m}}"


def read_vary(node: Node | None, parameters: Sequence[Parameter], diagnostics: Diagnostics) -> tuple[Varied, ...]:
    """The section; entries with mistakes are reported and omitted."""
    if node is None:
        return ()
    known = {p.symbol.name: p for p in parameters}
    varied: dict[str, Varied] = {}
    for key, value in diagnostics.attempt(lambda: entries_of(node, "`vary`", _EXAMPLE)) or ():
        name = canonical(key.text, known)
        if name not in known:
            message = f"`{key.text}` is not a parameter of this file"
            help_ = suggestion(name, list(known), "parameters")
            diagnostics.report(Diagnostic("unknown-parameter", message, key.span, help=help_))
            continue
        entry = diagnostics.attempt(partial(_varied, without_value(known[name]), value, diagnostics))
        if entry is not None:
            varied[name] = entry
    return tuple(varied.values())


def _varied(parameter: Parameter, node: Node, diagnostics: Diagnostics) -> Varied:
    name = parameter.symbol.name
    if isinstance(node, ListNode):
        items = items_of(node, f"the values of `{name}`", _EXAMPLE)
        fragments = [scalar_of(item, f"a value of `{name}`").fragment for item in items]
        if not fragments:
            message = f"`{name}` has no values to be drawn"
            raise ProblemError(Diagnostic("empty-value", message, node.span, help=f"list some: `{_EXAMPLE}`"))
        unit = _unit(fragments[0], parameter)
        for fragment in fragments:
            _read(fragment, parameter, unit)
        return Varied(name, tuple(" ".join(f.text.split()) for f in fragments))
    if not isinstance(node, MappingNode):
        message = f"the values of `{name}` are a list, or a range with `from`, `to` and `step`"
        raise ProblemError(wrong_kind(node, message, f"write `{_EXAMPLE}`"))
    section = Section(node, f"the range of `{name}`", VARY, diagnostics)
    low, high, step = (
        scalar_of(section.required(key, node.span), f"`{key}`").fragment for key in ("from", "to", "step")
    )
    return Varied(name, _grid(parameter, low, high, step))


def _grid(parameter: Parameter, low: Fragment, high: Fragment, step: Fragment) -> tuple[str, ...]:
    """from, from + step, ..., as texts in the unit of `from`."""
    known = _unit(low, parameter)
    first, last = _read(low, parameter, known), _read(high, parameter, known)
    by = _read(step, parameter, known, as_value=False)
    parts = split_number(low.text)
    unit = parts[1] if parts else ""
    factor = _factor(unit or parameter.stated_unit)
    begin, end, stride = (n / factor for n in (first.number, last.number, by.number))
    if not all(n.is_Rational for n in (begin, end, stride)):
        message = f"the range of `{parameter.symbol}` is not a range of rational numbers in one unit"
        raise ProblemError(
            Diagnostic("bad-range", message, low.whole, help="write decimals: `from: 10 deg`, not pi/18")
        )
    if stride <= 0 or end < begin:
        message = f"the range of `{parameter.symbol}` does not go up from `from` to `to`"
        raise ProblemError(Diagnostic("bad-range", message, step.whole, help=f"write `{_EXAMPLE}`"))
    number = int((end - begin) // stride) + 1
    if number > MOST_VARIED_VALUES:
        message = f"the range of `{parameter.symbol}` has {number:,} values; at most {MOST_VARIED_VALUES:,} are allowed"
        raise ProblemError(Diagnostic("bad-range", message, step.whole, help="take a larger step"))
    return tuple(f"{decimal(begin + k * stride)} {unit}".strip() for k in range(number))


def _factor(unit: str) -> sp.Expr:
    known = unit_of(unit) if unit else None
    return sp.S.One if known is None else known.factor


def _unit(fragment: Fragment, parameter: Parameter) -> str:
    """The unit whose dimension all values have: that of the parameter, or else that of the first value."""
    parts = split_number(fragment.text)
    return parameter.unit or (parts[1] if parts else "")


def _read(fragment: Fragment, parameter: Parameter, unit: str, as_value: bool = True) -> ValueRead:
    """A value, checked as one of the parameter is; a step need only have its dimension."""
    stated_unit = unit if split_number(fragment.text) else parameter.stated_unit
    stated = Fragment(stated_unit, fragment.whole) if stated_unit and unit_of(stated_unit) else None
    return read_number_with_unit(fragment, stated, parameter.symbol, parameter.assume if as_value else None)


def decimal(number: sp.Rational) -> str:
    """A number as a decimal fraction where it is one, 0.35, otherwise as a quotient, 1/3."""
    rest, twos, fives = int(number.q), 0, 0
    while rest % 2 == 0:
        rest, twos = rest // 2, twos + 1
    while rest % 5 == 0:
        rest, fives = rest // 5, fives + 1
    if rest != 1:
        return f"{number.p}/{number.q}"
    places = max(twos, fives)
    digits = str(abs(int(number * 10**places))).rjust(places + 1, "0")
    text = f"{digits[:-places]}.{digits[-places:]}" if places else digits
    return f"-{text}" if number < 0 else text
