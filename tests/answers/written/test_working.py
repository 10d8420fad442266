"""The working around the equations of an answer."""

from __future__ import annotations

from lagrange.answers.written.working import Working, understood
from lagrange.core.diagnostics import Fragment
from tests.answers.test_equations import given_reference


def sorted_out(*lines: str) -> Working:
    return understood([Fragment.of(line) for line in lines], given_reference("pendulum"))


def test_a_definition_is_put_into_the_equations() -> None:
    working = sorted_out("w2 = g/l", "theta'' = -w2*sin(theta)")
    assert len(working.judged) == 1
    assert {n: str(e) for n, e in working.defined.items()} == {"w2": "g/l"}


def test_values_and_initial_conditions_are_not_judged() -> None:
    working = sorted_out("theta'' = -g/l*sin(theta)", "g = 9.81 m/s^2", "theta(0) = 0")
    assert [f.text for f in working.judged] == ["theta'' = -g/l*sin(theta)"]
    assert working.unreadable == ()


def test_an_undeclared_name_is_an_unknown_that_equations_determine() -> None:
    working = sorted_out("m*l*theta'' = -S*sin(theta)", "S = m*g")
    assert working.unreadable == ()
    assert sorted_out("m*l*theta'' = -S*foo(2)").unreadable != ()
