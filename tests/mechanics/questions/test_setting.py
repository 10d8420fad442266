"""What is asked must be determined: mistakes have their place.

Coordinates that the constraints give in terms of the others.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.questions.own_answers import compared_answers
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import ProblemError
from lagrange.mechanics.questions.setting import completed, dependent, reduced
from lagrange.mechanics.solution import solve
from tests.mechanics.questions.test_questions import PENDULUM, WIRE, Read
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (PENDULUM + "initial: {x: l, y: l, x': 0}\nask: {it: {quantity: T, when: x = 0}}\n", "initial-contradicts"),
        (PENDULUM + "initial: {x: 0, y: l, y': 1}\nask: {it: {quantity: T, when: x = 0}}\n", "initial-contradicts"),
        (PENDULUM + 'initial: {x: l}\nask: {it: {quantity: "x\'", when: y = l}}\n', "not-determined"),
        (PENDULUM + "initial: {x: l, y: 0, y': 0}\nask: {it: {quantity: \"x'\"}}\n", "not-determined"),
        (PENDULUM + "initial: {x: l, y: 0, y': 0}\nask: {it: {quantity: \"x'\", when: y = -l}}\n", "never-holds"),
        (WIRE + "ask: {it: {quantity: t, when: r = b/2}}\n", "never-holds"),
    ],
)
def test_what_contradicts_or_is_not_determined_is_an_error_with_its_place(text: str, code: str, problem: Read) -> None:
    with pytest.raises(ProblemError) as error:
        solve(problem(text), complete=False)
    [found] = error.value.diagnostics
    assert (found.code, found.span is not None) == (code, True)


CRATE = """title: Crate that is pushed
axes: {i: right, j: up}
parameters: {m: 20 kg, g: 9.81 m/s^2, a: 0.3 m, c: 0.9 m, mu: 0.25, P: 100 N, h: {unit: m}, J: {unit: kg m^2}}
coordinates: [x, y, theta]
bodies: {crate: {mass: m, inertia: J, position: x*i + y*j, angle: theta}}
constraints:
  left: {equation: "dot(r_crate - a*e1_crate - c*e2_crate, j) >= 0", reaction: N_A}
  right: {equation: "dot(r_crate + a*e1_crate - c*e2_crate, j) >= 0", reaction: N_B}
gravity: -g*j
forces: {push: {on: crate, vector: P*i, at: r_crate + (h - c)*j}}
initial: {x': 0, theta: 0}
ask:
  highest: {quantity: h, when: N_A = 0}
  lowest: {quantity: h, when: N_B = 0}
answers:
  ask: {highest: 1.489 m, lowest: 0.311 m}
"""


def test_what_the_constraints_hold_stays_where_it_is_at_first(problem: Read) -> None:
    """Two feet on the floor: theta = 0, not pi; its rate and that of y follow together."""
    solution = solve(problem(CRATE))
    [answer] = compared_answers(solution)
    assert answer.verdict is Verdict.EQUIVALENT
    assert [len(a.branches) for a in solution.asked] == [1, 1]
    assert not any(b.provided for a in solution.asked for b in a.branches)


def test_a_state_that_values_exclude_is_an_error(problem: Read) -> None:
    text = """title: Throw
parameters: {m: 2 kg, g: 9.81 m/s^2}
coordinates: [y]
particles: {P: {mass: m, position: y*j}}
gravity: -g*j
initial: {y: 0, y': 4 m/s}
ask: {top: {quantity: t, when: y = 500 cm}}
"""
    with pytest.raises(ProblemError) as error:
        solve(problem(text), complete=False)
    assert error.value.diagnostics[0].code == "never-holds"


CABINET = """title: Cabinet on a lorry
parameters: [m, M, b, c, F, J, g]
coordinates: [u, x, y, theta]
particles: {lorry: {mass: M, position: u*i}}
bodies: {cabinet: {mass: m, inertia: J, position: x*i + y*j, angle: theta}}
constraints:
  back: {equation: "dot(r_cabinet - b*e1_cabinet - c*e2_cabinet, j) >= 0", reaction: N_1}
  front: {equation: "dot(r_cabinet + b*e1_cabinet - c*e2_cabinet, j) >= 0", reaction: N_2}
  cleat: "dot(r_cabinet - c*e2_cabinet, i) = u"
gravity: -g*j
forces: {drive: {on: lorry, vector: F*i}}
generalized_coordinates: {together: {coordinates: [u], substitute: {x: u, y: c, theta: 0}}}
initial: {u: 0, u': 0, theta: 0}
ask: {tips: {quantity: "u''", when: N_2 = 0}}
"""


def test_a_condition_about_parameters_alone_gives_the_applied_force(problem: Read) -> None:
    """N_2 = (m/2)(g − a c/b) = 0 at u'' = g b/c, whatever F was called before: F is (M + m) g b/c there."""
    [found] = solve(problem(CABINET), complete=False).asked
    b, c, g = sp.symbols("b c g", positive=True)
    assert [v for branch in found.branches for v in branch.values] == [b * g / c]


# Dependent


x, y = sp.symbols("x y", real=True)


def test_what_a_rule_makes_of_equations_and_states() -> None:
    assert reduced([x - y, x + y], {x: y}) == [2 * y]
    assert completed({y: sp.Integer(3)}, {x: 2 * y}, [x, y]) == {x: 6, y: 3}


def test_free_coordinates_depend_on_nothing() -> None:
    assert dependent(solved("ex11-ideal-pendulum").choices[0].configuration) == {}
