"""Answers to questions, against values worked out by hand."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.diagnostics import ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.questions import numerical
from lagrange.mechanics.questions.results import Asked, Because, How, Route
from lagrange.mechanics.solution import Solution, solve
from lagrange.problem.model import Problem
from lagrange.render import terminal
from lagrange.render.json import as_object

Read = Callable[[str], Problem]

SPHERE = """
title: Sphere
axes: {i: right, j: up}
parameters: [m, R, g, v]
coordinates: [r, theta]
particles: {P: {mass: m, position: r*sin(theta)*i + r*cos(theta)*j}}
constraints: {sphere: {equation: r = R, reaction: N, by: surface}}
gravity: -g*j
generalized_coordinates: {angle: {coordinates: [theta]}}
"""
PENDULUM = """
title: Pendulum
axes: {i: right, j: down}
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: T}}
gravity: g*j
"""
ORBIT = """
title: Orbit
parameters: [m, k, a, v]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
forces: {f: {potential: -m*k/r}}
initial: {r: a, r': 0, phi: 0, phi': v/a}
"""
WIRE = """
title: Bead on a wire that turns
parameters: [m, w, b, L]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
constraints: {drive: {equation: phi = w*t, reaction: M}}
generalized_coordinates: {radius: {coordinates: [r], substitute: {phi: w*t}}}
initial: {r: b, r': 0}
"""
ATWOOD = """
title: Atwood's machine
axes: {j: down}
parameters: [m1, m2, g, h, L]
coordinates: [a, b]
particles: {A: {mass: m1, position: a*j}, B: {mass: m2, position: b*j}}
constraints: {string: {equation: a + b = L, reaction: T}}
gravity: g*j
initial: {a: 0, a': 0}
"""
BALL = """
title: Ball thrown up against drag
axes: {j: up}
parameters: [m, c, g, v]
coordinates: [y]
particles: {P: {mass: m, position: y*j}}
gravity: -g*j
forces: {drag: {on: P, vector: "-c*abs(y')*y'*j"}}
initial: {y: 0, y': v}
"""
TOPPLING = """
title: Rod that topples
axes: {i: right, j: up}
parameters: [m, l, g]
coordinates: [x, y, theta]
bodies: {rod: {mass: m, inertia: m*l^2/12, position: x*i + y*j, angle: -theta}}
constraints:
  sideways: {equation: x = l/2*sin(theta), reaction: H}
  upright: {equation: y = l/2*cos(theta), reaction: V}
gravity: -g*j
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l/2*sin(theta), y: l/2*cos(theta)}}}
initial: {theta: 0, theta': 0}
"""


def asked(read: Read, text: str) -> Asked:
    solution: Solution = solve(read(text), complete=False)
    [answer] = solution.asked
    assert all(c.passed for c in solution.checks), [c.name for c in solution.checks if not c.passed]
    return answer


def value(text: str) -> sp.Expr:
    """An expression of letters that are positive, apart from the moving ones."""
    moving = {n: sp.Symbol(n, real=True) for n in ("theta", "r", "x", "y", "phi")}
    names = sorted({*"mlgkavRwbLMhcz", "m1", "m2"})
    return sp.sympify(
        text, locals={**{n: sp.Symbol(n, positive=True) for n in names}, "t": sp.Symbol("t", real=True), **moving}
    )


SKATE = """
title: Skate
parameters: [m, I, w]
coordinates: [x, y, theta]
bodies: {skate: {mass: m, inertia: I, position: x*i + y*j, angle: theta}}
constraints: {blade: "y'*cos(theta) = x'*sin(theta)"}
initial: {x: 0, y: 0, theta: 0, x': 0, theta': w}
"""

CASES = [
    (SKATE, "", "{quantity: \"theta'\", when: t = 1}", "w", Route.SOLUTION),
    (SPHERE, "{theta: 0, theta': 0}", "{quantity: R*cos(theta), when: N = 0}", "2*R/3", Route.INTEGRALS),
    (SPHERE, "{theta: 0, theta': v/R}", "{quantity: R*cos(theta), when: N = 0}", "2*R/3 + v**2/(3*g)", Route.INTEGRALS),
    (SPHERE, "{theta: 0, theta': v/R}", "{quantity: v, when: [theta = 0, N = 0]}", "sqrt(g*R)", Route.INTEGRALS),
    (SPHERE, "", "{quantity: \"theta''\", when: theta = pi/2}", "g/R", Route.STATE),
    (SPHERE, "", "{quantity: N, when: [theta = 0, \"theta' = v/R\"]}", "m*g - m*v**2/R", Route.STATE),
    (PENDULUM, "{x: l, y: 0, y': 0}", "{quantity: \"x'\", when: x = 0}", "-sqrt(2*g*l)", Route.INTEGRALS),
    (PENDULUM, "{x: l, y: 0, y': 0}", "{quantity: T, when: x = 0}", "3*m*g", Route.INTEGRALS),
    (PENDULUM, "{x: l, y: 0, y': 0}", "{quantity: energy}", "0", Route.INTEGRALS),
    (PENDULUM, "{x: l, y: 0, y': 0}", "{quantity: T_kinetic, by: y}", "m*g*y", Route.INTEGRALS),
    (ORBIT, "", "{quantity: r, when: \"r' = 0\"}", "a**2*v**2/(2*k - a*v**2)", Route.INTEGRALS),
    (ORBIT, "", "{quantity: v, when: [r = a, \"r'' = 0\"]}", "sqrt(k/a)", Route.INTEGRALS),
    (ORBIT, "", "{quantity: \"r*phi'\", by: r}", "a*v/r", Route.INTEGRALS),
    (WIRE, "", "{quantity: \"r'\", when: r = L}", "w*sqrt(L**2 - b**2)", Route.INTEGRALS),
    (WIRE, "", "{quantity: M, by: r}", "2*m*w**2*sqrt(r**2 - b**2)", Route.INTEGRALS),
    (WIRE, "", "{quantity: r, by: t}", "b*cosh(w*t)", Route.SOLUTION),
    (ATWOOD, "", "{quantity: \"a'\", when: a = h}", "sqrt(2*g*h*(m1 - m2)/(m1 + m2))", Route.INTEGRALS),
    (ATWOOD, "", "{quantity: T, when: a = h}", "2*m1*m2*g/(m1 + m2)", Route.STATE),
    (ATWOOD, "", "{quantity: t, when: a = h}", "sqrt(2*h*(m1 + m2)/(g*(m1 - m2)))", Route.SOLUTION),
    (BALL, "", "{quantity: y, when: \"y' = 0\"}", "m/(2*c)*log(1 + c*v**2/(m*g))", Route.SOLUTION),
    (BALL, "", "{quantity: t, when: \"y' = 0\"}", "sqrt(m/(c*g))*atan(v*sqrt(c/(m*g)))", Route.SOLUTION),
    (TOPPLING, "", "{quantity: \"theta'\", when: theta = pi/2}", "sqrt(3*g/l)", Route.INTEGRALS),
    (TOPPLING, "", "{quantity: H, by: theta}", "3*m*g*sin(theta)*(3*cos(theta) - 2)/4", Route.INTEGRALS),
    (TOPPLING, "", "{quantity: V, when: theta = pi/2}", "m*g/4", Route.STATE),
]  # fmt: skip


@pytest.mark.parametrize(("text", "initial", "question", "expected", "route"), CASES)
def test_the_answer_is_that_of_the_hand(
    text: str, initial: str, question: str, expected: str, route: Route, problem: Read
) -> None:
    state = f"initial: {initial}\n" if initial else ""
    answer = asked(problem, f"{text}{state}ask: {{it: {question}}}\n")
    assert answer.how is How.EXACT
    assert answer.route is route
    values = [v for b in answer.branches for v in b.values]
    assert len(values) == 1
    assert is_zero(values[0] - value(expected)) is True


def test_a_position_at_rest_that_may_be_left_to_either_side_leaves_the_sense_open(problem: Read) -> None:
    answer = asked(
        problem, SPHERE + "initial: {theta: 0, theta': 0}\nask: {it: {quantity: \"R*theta'\", when: N = 0}}\n"
    )
    assert answer.mirrored
    assert len(answer.branches) == 2


def test_a_particle_beside_the_top_leaves_to_its_side(problem: Read) -> None:
    """No turning point lies between: the other side comes later."""
    text = SPHERE + "initial: {theta: 1/10, theta': 0}\nask: {it: {quantity: theta, when: N = 0}}\n"
    answer = asked(problem, text)
    assert [b.states[0][sp.Symbol("theta'", real=True)].could_extract_minus_sign() for b in answer.branches] == [False]


def test_of_two_turning_points_that_of_the_start_is_left_out(problem: Read) -> None:
    text = PENDULUM + 'initial: {x: 3/5*l, y: 4/5*l, y\': 0}\nask: {it: {quantity: x, when: ["x\' = 0", "y\' = 0"]}}\n'
    answer = asked(problem, text)
    dropped = [why for _, why in answer.dropped]
    assert Because.INITIAL in dropped or len(answer.branches) == 1


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


QUARTER = """
title: Pendulum
axes: {i: right, j: down}
parameters: {m: {value: 1}, l: {value: 1}, g: {value: 9.81}, alpha: {value: 1}}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}
gravity: g*j
initial: {theta: alpha, theta': 0}
ask: {it: {quantity: t, when: theta = 0}}
"""


def test_a_time_that_is_no_elementary_integral_is_found_in_numbers(problem: Read) -> None:
    """A quarter of the period is K(sin α/2) √(l/g)."""
    pytest.importorskip("scipy")
    answer = asked(problem, QUARTER)
    exact = sp.elliptic_k(sp.sin(sp.Rational(1, 2)) ** 2).evalf() / sp.sqrt(9.81)
    assert answer.how is How.NUMERICAL
    assert float(answer.branches[0].rhs) == pytest.approx(float(exact), rel=1e-5)


def test_without_the_extra_it_is_said_which_one_is_missing(problem: Read, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numerical, "is_available", lambda: False)
    answer = asked(problem, QUARTER)
    assert not answer.answered
    assert answer.needs == "sim"


def test_without_values_such_a_question_is_left_open(problem: Read) -> None:
    answer = asked(
        problem,
        QUARTER.replace("{m: {value: 1}, l: {value: 1}, g: {value: 9.81}, alpha: {value: 1}}", "[m, l, g, alpha]"),
    )
    assert (answer.how, answer.branches, answer.needs) == (None, (), "")
    assert answer.integrals


SLOPE = """\
title: A block slides down
parameters:
  m: {assume: positive, value: 40 kg}
  g: {assume: positive, value: "9.81 m/s^2"}
  alpha: {assume: acute, value: 30 deg}
  mu: {assume: positive, value: "1/4"}
  d: {assume: positive, value: 6 m}
coordinates: [x, y]
particles: {A: {mass: m, position: x*i + y*j}}
constraints: {plane: {equation: y >= 0, reaction: N}}
forces:
  weight: {on: A, vector: "m*g*(sin(alpha)*i - cos(alpha)*j)"}
  rub: {friction: mu, constraint: plane, on: A, slip: positive}
initial: {x: 0, x': 0}
ask:
  speed: {quantity: "x'", when: "x = d"}
  time: {quantity: t, when: "x = d"}
  push: {quantity: N, when: "x = d"}
"""


def test_answers_in_numbers_with_their_units(problem: Read) -> None:
    """a = g (sin 30° − cos 30°/4); the units of ẋ and t follow from those of the parameters."""
    a = 9.81 * (0.5 - math.sqrt(3) / 8)
    expected = {"speed": (math.sqrt(12 * a), "m/s"), "time": (math.sqrt(12 / a), "s")}
    expected["push"] = (40 * 9.81 * math.sqrt(3) / 2, "N")
    found = report(problem(SLOPE))
    answers = {a["name"]: (a["number"], a["unit"]) for a in as_object(found)["asked"]}
    assert {name: unit for name, (_, unit) in answers.items()} == {name: unit for name, (_, unit) in expected.items()}
    assert all(answers[name][0] == pytest.approx(value) for name, (value, _) in expected.items())
    page = terminal.text(found.derivation, found.notation, 80)
    assert "ẋ ≈ 5.777 m/s" in page
    assert "t ≈ 2.077 s" in page


def test_an_angle_is_given_in_degrees(problem: Read) -> None:
    state = "initial: {theta: 0, theta': 0}\nask: {leaves: {quantity: theta, when: N = 0}}\n"
    found = report(problem(SPHERE + state))
    [leaves] = as_object(found)["asked"]
    assert (leaves["number"], leaves["unit"]) == (pytest.approx(math.acos(2 / 3)), "rad")
    assert "That is θ ≈ 48.19°." in terminal.text(found.derivation, found.notation, 80)


def test_a_branch_that_the_values_exclude_has_no_number(problem: Read) -> None:
    """Into a buffer: k x²/2 − m g x (sin 25° − cos 25°/5) = m v²/2 has one positive root, which is the answer."""
    text = SLOPE[: SLOPE.index("initial")].replace("forces:\n", 'forces:\n  buffer: {potential: "k*(x - d)^2/2"}\n')
    text = text.replace("parameters:\n", "parameters:\n  k: {assume: positive, value: 20 N/cm}\n")
    start = 'initial: {x: d, x\': "sqrt(2*d*g*(sin(alpha) - mu*cos(alpha)))"}\n'
    found = report(problem(text + start + 'ask: {furthest: {quantity: x, when: "x\' = 0"}}\n'))
    [furthest] = as_object(found)["asked"]
    pull = 40 * 9.81 * (0.5 - math.sqrt(3) / 8)
    compressed = (pull + math.sqrt(pull**2 + 2 * 2000 * pull * 6)) / 2000
    assert furthest["number"] == pytest.approx(6 + compressed)
    page = terminal.text(found.derivation, found.notation, 80)
    assert "does not exist with the given values" in page
    assert page.count("x ≈") == 1
