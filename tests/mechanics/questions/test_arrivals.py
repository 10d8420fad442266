"""Whether a motion arrives where a question is asked."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.core.diagnostics import ProblemError
from lagrange.core.symbols import t
from lagrange.explain.report import report
from lagrange.mechanics.questions.arrivals import while_slipping
from lagrange.mechanics.solution import solve
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.mechanics.questions.test_questions import SPHERE, Read, asked
from tests.mechanics.test_book_questions import SPRING


def test_a_position_at_rest_that_may_be_left_to_either_side_leaves_the_sense_open(problem: Read) -> None:
    answer = asked(
        problem, SPHERE + "initial: {theta: 0, theta': 0}\nask: {it: {quantity: \"R*theta'\", when: N = 0}}\n"
    )
    assert answer.mirrored
    assert len(answer.branches) == 2


BOAT = """
title: Boat that drifts
parameters: [m, b, v, s]
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {drag: {on: P, vector: "-b*x'*i"}}
initial: {x: 0, x': v}
"""


def test_a_rest_that_is_only_approached_is_said_to_be(problem: Read) -> None:
    solution = report(problem(BOAT + 'ask: {rest: {quantity: x, when: "x\' = 0"}}\n'), None)
    [answer] = solution.solution.asked
    assert answer.branches[0].limit
    assert "in the limit t → ∞" in terminal.text(solution.derivation, solution.notation, 100)
    assert "in the limit t → ∞" in as_object(solution)["asked"][0]["conditions"]
    with pytest.raises(ProblemError) as error:
        solve(problem(BOAT + 'ask: {rest: {quantity: t, when: "x\' = 0"}}\n'), complete=False)
    assert "only in the limit" in error.value.diagnostics[0].message


def test_a_pendulum_never_gets_above_where_it_was_let_go(problem: Read) -> None:
    text = """
title: Pendulum
parameters: {m: positive, l: positive, g: positive, alpha: acute}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}
gravity: -g*j
initial: {theta: alpha, theta': 0}
ask: {QUESTION}
"""
    for quantity in ("theta'", "theta''", "energy"):
        question = f'side: {{quantity: "{quantity}", when: theta = pi/2}}'
        with pytest.raises(ProblemError) as error:
            solve(problem(text.replace("QUESTION", question)), complete=False)
        assert error.value.diagnostics[0].code == "never-holds"


def test_a_system_that_stays_at_rest_never_gets_anywhere(problem: Read) -> None:
    text = SPRING.partition("forces:")[0] + "initial: {x: 0, x': 0}\nask: {it: {quantity: t, when: x = a}}\n"
    with pytest.raises(ProblemError) as error:
        solve(problem(text))
    assert [d.code for d in error.value.diagnostics] == ["never-holds"]


@pytest.mark.parametrize(
    ("until", "least"),
    [(sp.pi / 2, 1), (sp.pi / 6, sp.Rational(1, 2)), (2, 1)],
)
def test_what_is_never_reached_ends_nothing(until: sp.Expr, least: sp.Expr) -> None:
    """l − A sin(w t) > 0 up to w t = π/2 for l ≥ A, where arcsin(l/A) need not exist."""
    length, size, w = sp.symbols("l A w", positive=True)
    [condition] = while_slipping([length - size * sp.sin(w * t)], until / w, sign_of)
    assert condition.relation == "≥"
    assert sp.simplify((condition.lhs - condition.rhs) / (length - least * size)).is_positive


def test_a_terminal_speed_is_approached(problem: Read) -> None:
    """v' = g - k v²/m from rest: the root √(m g/k) is approached, the other is not."""
    text = FALL + 'ask: {terminal: {quantity: "y\'", when: "y\'\' = 0"}}\n'
    [answer] = report(problem(text), None).solution.asked
    [branch] = answer.branches
    m, g, k = sp.symbols("m g k", positive=True)
    assert (branch.rhs - sp.sqrt(m * g / k)).equals(0)
    assert branch.limit
    assert not branch.provided


FALL = """
title: Fall
axes: {j: down}
parameters: [m, g, k]
coordinates: [y]
particles: {P: {mass: m, position: y*j}}
gravity: g*j
forces: {drag: {on: P, vector: "-k*y'*abs(y')*j"}}
initial: {y: 0, y': 0}
"""
