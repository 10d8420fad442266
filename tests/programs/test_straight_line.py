"""Straight-line programs."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.programs.straight_line import (
    StraightLine,
    can_be_eliminated,
    occurring_inputs,
    solved_in_line,
    straight_line,
)

x, y = sp.symbols("x y", real=True)


def carried_out(program: StraightLine, values: dict[sp.Symbol, float]) -> list[float]:
    known: dict[sp.Basic, object] = dict(values)
    for symbol, e in program.assignments:
        known[symbol] = e.xreplace(known).evalf()
    return [float(e.xreplace(known)) for e in program.outputs]


def test_repeated_parts_are_computed_once() -> None:
    part = sp.sin(x * y) + x
    program = straight_line([part**2, part + 1])
    assert program.assignments
    assert occurring_inputs(program) == {x, y}
    values = {x: 0.7, y: 1.9}
    assert carried_out(program, values) == pytest.approx([float(e.subs(values)) for e in (part**2, part + 1)])


def test_long_expressions_share_the_parts_that_occur_more_than_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lagrange.programs.straight_line.LONGEST_SEARCHED", 1)
    part = sp.sin(x * y) + 2 * x
    outputs = [part**2 - part / y, x * part * y, part, sp.Integer(3), x]
    program = straight_line(outputs)
    assert [e for _, e in program.assignments if e.has(sp.sin)] == [sp.sin(x * y) + 2 * x]
    assert occurring_inputs(program) == {x, y}
    values = {x: 0.7, y: 1.9}
    assert carried_out(program, values) == pytest.approx([float(e.subs(values)) for e in outputs])


def test_a_linear_system_is_eliminated() -> None:
    matrix, right = [[sp.Integer(2), x], [x, y]], [x * y, sp.Integer(1)]
    values = {x: 0.5, y: 2.0}
    *_, first, second = carried_out(solved_in_line([], matrix, right), values)
    expected = sp.Matrix(matrix).subs(values).LUsolve(sp.Matrix(right).subs(values))
    assert [first, second] == pytest.approx([float(e) for e in expected])
    assert can_be_eliminated(1, 0)
    assert not can_be_eliminated(1, 1)
