"""Results in numbers, in JSON: `number` and `unit` beside the results in letters.

A number is as accurate as a float is; where coordinates are left in a result, `number` is a text in the language of
problem files, with the values in it.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.render.json_steps import condition
from lagrange.render.limits import JSON_DIGITS

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.equations import EquationsOfMotion
    from lagrange.mechanics.equilibrium.damped_modes import DampedModes
    from lagrange.mechanics.equilibrium.friction.conditions_of_rest import RestCondition
    from lagrange.mechanics.equilibrium.friction.impending_motion import ImpendingMotion
    from lagrange.mechanics.equilibrium.in_numbers import Decay, EquilibriaInNumbers, Oscillation, Position
    from lagrange.mechanics.equilibrium.numerical_equilibria import NumericalEquilibria
    from lagrange.mechanics.questions.results import Asked
    from lagrange.mechanics.results import InCoordinates
    from lagrange.values.quantities import Quantity, Values

Write = Callable[[Any], str]

_RELATIONS = {"≤": "<=", "≥": ">=", "<": "<", ">": ">", "=": "="}


def position(p: Position) -> dict[str, Any]:
    """An equilibrium in numbers; `branch` is the place of its equations in `equilibrium`, counted from 0."""
    entries: dict[str, Any] = {"how": "numerical"} if p.branch is None else {"branch": p.branch, "how": "exact"}
    entries["coordinates"] = {u.name: _measured(q) for u, q in p.coordinates.items()}
    if p.stability is not None:
        entries["stability"] = p.stability.value
    if p.oscillations:
        entries["frequencies"] = [_oscillation(o) for o in p.oscillations]
    if p.decays:
        entries["damped_modes"] = [_decay(d) for d in p.decays]
    return entries


def critical(view: InCoordinates, values: Values | None) -> dict[str, Any]:
    """`critical`: conditions that are solved for the one parameter without a value."""
    if values is None:
        return {}
    from lagrange.mechanics.equilibrium.in_numbers import critical_values

    bounds = critical_values(view.equilibrium, view.stability, view.linearization, values)
    entries = [{"name": v.parameter.name, "relation": v.relation} | _measured(v.bound) for v in bounds]
    return {"critical": entries} if entries else {}


def searched(numerical: NumericalEquilibria) -> dict[str, Any]:
    """Between which numbers each unknown was searched, and whether all solutions there are found."""
    between = {u.name: [float(s.low), float(s.high)] for u, s in numerical.searched.items()}
    return {"between": between, "complete": numerical.complete}


def _oscillation(o: Oscillation) -> dict[str, Any]:
    return _measured(o.frequency) | {"period": _measured(o.period)}


def damped_modes(damped: DampedModes, write: Write) -> list[dict[str, Any]]:
    """The damped modes: decay rates, ω², where it oscillates; `equation` of what has no closed form."""
    entries = []
    for m in damped.modes:
        entry: dict[str, Any] = {"decay": [write(r) for r in m.decays]}
        if m.square is not None:
            entry |= {"squared": write(m.square), "oscillates": m.oscillates}
        if m.condition is not None:
            entry["oscillates_where"] = f"{write(m.condition.lhs)} {m.condition.relation} {write(m.condition.rhs)}"
        if m.shape:
            entry["mode"] = [write(a) for a in m.shape]
        entries.append(entry | {"multiplicity": m.multiplicity})
    left = ({"equation": f"{write(f)} = 0", "multiplicity": n} for f, n in damped.left)
    return [*entries, *left]


def _decay(d: Decay) -> dict[str, Any]:
    """A damped mode: `decay`, `frequency` if it oscillates, amplitudes and phases of the free coordinates."""
    entries: dict[str, Any] = {"decay": _measured(d.rate)}
    if d.frequency is not None:
        entries["frequency"] = _measured(d.frequency)
    return entries | {"amplitudes": list(d.amplitudes), "phases": list(d.phases)}


def _measured(quantity: Quantity) -> dict[str, Any]:
    """`number`, and `unit` where it is known."""
    return {"number": quantity.number} | ({"unit": quantity.unit} if quantity.unit else {})


def quantity(expression: sp.Expr | None, values: Values | None, write: Write) -> dict[str, Any]:
    """An expression with the values: `number`, a text where coordinates are left in it, and `unit`."""
    if expression is None or values is None or not expression.free_symbols & values.parameters:
        return {}
    quantity = values.quantity(expression)
    if quantity is None:
        return {}
    if quantity.is_number:
        return _measured(quantity)
    shown = {"number": write(quantity.shown(JSON_DIGITS))}
    return shown | ({"unit": quantity.unit} if quantity.unit else {})


def asked_number(asked: Asked, values: Values, write: Write) -> dict[str, Any]:
    """`number` and `unit` of an answer with one value; of two opposite ones that may both come, the positive."""
    unknown = {"number": None, "unit": None}
    from lagrange.mechanics.questions.ranges import branches_with
    from lagrange.mechanics.questions.results import one_value

    left = branches_with(asked, values)
    if asked.mirrored and len(left) == 2 and left[0].rhs == -left[1].rhs:
        each = [asked_number(replace(asked, branches=(b,)), values, write) for b in left]
        return next((e for e in each if e["number"] is not None and e["number"] > 0), unknown)
    if len(left) != 1:
        return unknown
    [branch] = left
    if asked.how is not None and asked.how.value == "numerical" and branch.rhs.is_number:
        return unknown | {"number": float(branch.rhs), "unit": values.unit_of(asked.question.quantity) or None}
    if asked.question.by is not None:
        return unknown | quantity(branch.rhs, values, write)
    of_angle = branch.lhs != asked.question.quantity
    stated = branch.values if of_angle else (branch.rhs,)
    measured = [values.quantity(v, is_angle=of_angle or _is_part_of_a_turn(v)) for v in stated]
    numbers = [q.number for q in measured if q is not None and q.is_number]
    number = one_value(numbers) if of_angle or len(numbers) == 1 else None
    if number is None or None in measured:
        return unknown
    unit = values.unit_of(asked.question.quantity)
    if not unit and not asked.has_bare_numbers:  # `x = 2` hides a unit, and that of the quantity is sure
        unit = next(q.unit for q in measured if q is not None)
    return {"number": number, "unit": unit or None}


def numbers_of_branches(asked: Asked, values: Values, write: Write) -> list[dict[str, Any]]:
    """`number` and `unit` of each of several branches that has one; empty if it has none."""
    alone = (asked_number(replace(asked, branches=(b,)), values, write) for b in asked.branches)
    return [entry if entry["number"] is not None else {} for entry in alone]


def value_of_asked(asked: Asked, stated: str, values: Values, write: Write) -> dict[str, Any]:
    """`value` with its number; `integral` where the answer is one that has no elementary value."""
    if stated or asked.integral is None:
        return {"value": stated or None, **asked_number(asked, values, write)}
    q, start, end = asked.integral.limits[0]
    return {"integral": {"of": write(asked.integral.function), "over": q.name, "from": write(start), "to": write(end)}}


def _is_part_of_a_turn(value: sp.Expr) -> bool:
    """Whether it is a multiple of π, as angles are."""
    return bool(value.has(sp.pi) and (value / sp.pi).is_Rational)


def equations_in_numbers(motion: EquationsOfMotion, values: Values | None, write: Write) -> dict[str, Any]:
    """The equations of motion with the values; empty if a parameter has none."""
    if values is None:
        return {}
    expressions = [e.expression for e in motion.final]
    quantities = [values.quantity(e) for e in expressions if e.free_symbols & values.parameters]
    if not quantities or len(quantities) < len(expressions) or None in quantities:
        return {}
    return {"equations_in_numbers": [f"{write(q.shown(JSON_DIGITS))} = 0" for q in quantities if q is not None]}


def condition_of_rest(c: RestCondition, write: Write) -> str:
    """`tan(alpha) <= mu`."""
    return f"{write(c.left)} {_RELATIONS[c.relation]} {write(c.right)}"


def rest_in_numbers(cases: Sequence[Sequence[RestCondition]], values: Values | None, write: Write) -> dict[str, Any]:
    """`in_numbers`: what each condition of rest says with the values, `P >= 5.767`; of several cases in order."""
    if values is None or not values.numbers or not cases:
        return {}
    from lagrange.values.bounds import bound_with
    from lagrange.values.quantities import Quantity

    def entry(c: RestCondition) -> dict[str, Any]:
        bound = bound_with(c.left, c.right, values, c.relation)
        if bound is None:
            return {"condition": condition_of_rest(c, write)}
        left = bound.left.formula_shown(JSON_DIGITS) if isinstance(bound.left, Quantity) else bound.left
        right = bound.bound.formula_shown(JSON_DIGITS)
        sign = _RELATIONS[bound.relation]
        low = "" if bound.low is None else f"{write(bound.low.formula_shown(JSON_DIGITS))} {sign} "
        said: dict[str, Any] = {"condition": f"{low}{write(left)} {sign} {write(right)}"}
        if bound.holds is not None:
            return said | {"holds": bound.holds}
        least = {} if bound.low is None else {"low": float(bound.low.number)}
        return said | least | (_measured(bound.bound) if bound.bound.is_number else {})

    rows = [[entry(c) for c in case] for case in cases]
    return {"in_numbers": rows[0] if len(rows) == 1 else rows}


def impending_in_numbers(motion: ImpendingMotion, values: Values | None, write: Write) -> dict[str, Any]:
    """`in_numbers`: of each equilibrium the quantities that have a number, and `reactions_in_numbers`."""
    limits = [
        {write(r.lhs): number for r in b.equations if (number := quantity(r.rhs, values, write))}
        for b in motion.equilibrium.branches
    ]
    pressed = {name: number for name, force in motion.pressed.items() if (number := quantity(force, values, write))}
    numbers: dict[str, Any] = {"in_numbers": limits} if any(limits) else {}
    return numbers | ({"reactions_in_numbers": pressed} if pressed else {})


def add_oscillations(entries: list[dict[str, Any]], in_numbers: EquilibriaInNumbers) -> None:
    """Adds `in_numbers` to each equilibrium, and `number`, `unit` and `period` to what has one value there."""
    for n, entry in enumerate(entries):
        there = [p for p in in_numbers.positions if p.branch == n]
        entry["in_numbers"] = [position(p) for p in there]
        for k, frequency in enumerate(entry.get("frequencies", ())):
            written = {_text(_oscillation(o)) for p in there for o in p.oscillations if o.root == k}
            if len(written) == 1:
                frequency |= json.loads(written.pop())


def _text(value: dict[str, Any]) -> str:
    """A text of a value, so that equal ones can be found."""
    return json.dumps(value, sort_keys=True)


def answered_question(asked: Asked, values: Values, write: Write) -> dict[str, Any]:
    """The answer to one question; several branches that may all be meant are joined by `or` in `value`."""
    question = asked.question
    stated = [
        write(b.rhs) if b.lhs == question.quantity else f"{write(b.lhs)} = {write(b.rhs)}" for b in asked.branches
    ]
    each = [
        [condition(c, write) for c in b.conditions]
        + (["in the limit t → ∞"] if b.limit else [])
        + (["provided that the motion gets there"] if b.provided else [])
        for b in asked.branches
    ]
    common = [c for c in each[0] if all(c in other for other in each)] if each else []
    entries: dict[str, Any] = {
        "name": question.name,
        "quantity": write(question.quantity),
        "when": [f"{write(c.lhs)} = {write(c.rhs)}" for c in question.when],
    }
    entries |= {"by": question.by.name} if question.by is not None else {}
    entries |= value_of_asked(asked, " or ".join(stated), values, write)
    entries |= {"how": None if asked.how is None else asked.how.value, "conditions": common}
    if len(stated) > 1:
        numbers = numbers_of_branches(asked, values, write)
        entries["branches"] = [
            {"value": v, **n, "conditions": c} for v, n, c in zip(stated, numbers, each, strict=True)
        ]
    return entries | ({"choice": asked.choice} if asked.choice else {})
