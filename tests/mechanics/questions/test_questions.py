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
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
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
    (BALL, "", "{quantity: y, when: \"y' = 0\"}", "m/(2*c)*log(1 + c*v**2/(m*g))", Route.INTEGRALS),
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
    """A quarter of the period is K(sin α/2) √(l/g); the integral needs no extra."""
    answer = asked(problem, QUARTER)
    assert answer.integrand is not None
    exact = sp.elliptic_k(sp.sin(sp.Rational(1, 2)) ** 2).evalf() / sp.sqrt(9.81)
    assert answer.how is How.NUMERICAL
    assert float(answer.branches[0].rhs) == pytest.approx(float(exact), rel=1e-5)


def test_without_the_extra_it_is_said_which_one_is_missing(problem: Read, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numerical, "is_available", lambda: False)
    answer = asked(problem, QUARTER.replace("when: theta = 0", "when: theta'^2 = 1"))
    assert not answer.answered
    assert answer.needs == "sim"


def test_without_values_such_a_question_is_left_open(problem: Read) -> None:
    answer = asked(
        problem,
        QUARTER.replace("{m: {value: 1}, l: {value: 1}, g: {value: 9.81}, alpha: {value: 1}}", "[m, l, g, alpha]"),
    )
    assert (answer.how, answer.branches, answer.needs) == (None, (), "")
    assert answer.integrand is not None
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


def test_an_absolute_value_is_no_angle(problem: Read) -> None:
    found = report(problem(SLOPE.replace('speed: {quantity: "x\'"', 'speed: {quantity: "abs(x\')"')))
    page = terminal.text(found.derivation, found.notation, 80)
    assert "|ẋ| ≈ 5.777 m/s" in page
    assert "°" not in page[page.index("Question") :]


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
    assert page.count("x ≈") == 2  # at the head and with the answer, of the one branch that exists


UP_AND_DOWN = """
title: Block sent up a rough slope
axes: {i: up the slope, j: away from it}
parameters: {m: positive, g: positive, mu: positive, alpha: acute, v: positive}
coordinates: [x, y]
particles: {P: {mass: m, position: [x, y]}}
constraints: {slope: {equation: y >= 0, reaction: N}}
gravity: -g*sin(alpha)*i - g*cos(alpha)*j
initial: {x: 0, x': v}
"""
RUB = "forces: {rub: {friction: mu, constraint: slope, on: P}}\n"
RUB_UPWARDS = "forces: {rub: {friction: mu, constraint: slope, on: P, slip: i}}\n"
BACK = 'ask: {back: {quantity: "x\'", when: x = 0}}\n'


def test_friction_turns_with_the_slip_and_may_hold_the_block(problem: Read) -> None:
    answer = asked(problem, UP_AND_DOWN + RUB + BACK)
    [branch] = answer.branches
    m, g, mu, v = (sp.Symbol(n, positive=True) for n in ("m", "g", "mu", "v"))
    [alpha] = (s for s in branch.rhs.free_symbols if s.name == "alpha")
    steep = {g: 9.8, mu: 0.3, v: 6.0, alpha: 0.6}
    up, down = (math.sin(0.6) + s * 0.3 * math.cos(0.6) for s in (1, -1))
    assert float(branch.rhs.subs(steep)) == pytest.approx(-6 * math.sqrt(down / up))
    assert all(bool((c.lhs - c.rhs).subs(steep) > 0) for c in branch.conditions)
    flat = {**steep, alpha: 0.2}  # tan 0.2 < 0.3
    assert not all(bool((c.lhs - c.rhs).subs(flat) > 0) for c in branch.conditions)
    assert answer.turning is not None
    assert answer.turning.value.subs(steep) == pytest.approx(36 / (2 * 9.8 * up))
    assert m not in branch.rhs.free_symbols


def test_slip_in_a_stated_sense_is_not_followed_back(problem: Read) -> None:
    answer = solve(problem(UP_AND_DOWN + RUB_UPWARDS + BACK), complete=False).asked[0]
    assert not answer.answered


def test_a_coordinate_coupled_to_another_is_not_integrated_alone(problem: Read) -> None:
    """With a cubic spring between them nothing is elementary; without it both are cosines."""
    text = """
title: Two masses
parameters: [m, k, b, a]
coordinates: [x, y]
particles: {A: {mass: m, position: x*i}, B: {mass: m, position: y*i}}
forces: {s: {potential: "k*x^2/2 + k*y^2/2 + b*(x - y)^4"}}
initial: {x: a, x': 0, y: 0, y': 0}
ask: {x_t: {quantity: x, by: t}}
"""
    assert not solve(problem(text), complete=False).asked[0].answered
    answer = asked(problem, text.replace("^4", "^2"))
    assert answer.route is Route.SOLUTION
    assert {q.name for q in answer.solutions} == {"x", "y"}


def test_the_size_of_a_force_that_rolling_needs_has_no_sense(problem: Read) -> None:
    """μ_s = 2/7 tan α for a ball, whichever way the equation of rolling is written."""
    text = """
title: Ball on an incline
axes: {i: down, j: away}
parameters: {m: positive, r: positive, alpha: acute, mu: positive, g: positive}
coordinates: [x, y, phi]
bodies: {ball: {mass: m, inertia: 2/5*m*r^2, position: x*i + y*j, angle: -phi}}
constraints: {contact: {equation: y >= r, reaction: N}, rolling: {equation: "SIDES", reaction: F}}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
initial: {x: 0, x': 0}
ask: {least: {quantity: mu, when: F = mu*N}}
"""
    answers = [asked(problem, text.replace("SIDES", s)) for s in ("x' = r*phi'", "r*phi' = x'")]
    for a in answers:
        [value_found] = a.branches[0].values
        [alpha] = value_found.free_symbols
        assert is_zero(value_found - sp.Rational(2, 7) * sp.tan(alpha)) is True
    assert [a.opposite is None for a in answers] == [False, True]


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


def test_a_place_beyond_that_limit_is_under_a_condition(problem: Read) -> None:
    [branch] = asked(problem, BOAT + 'ask: {there: {quantity: "x\'", when: x = s}}\n').branches
    m, b, v, s = (sp.Symbol(n, positive=True) for n in "mbvs")
    [condition] = branch.conditions
    assert sp.cancel((condition.lhs - condition.rhs) / (m * v - b * s)).is_positive


def test_what_is_not_decided_is_said(problem: Read) -> None:
    """Two degrees of freedom coupled by a fourth power: nothing tells whether x gets to a."""
    text = """
title: Particle on a hill in the plane
parameters: [m, k, b, a, v]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces: {s: {potential: "-k*x^2/2 + b*x^2*y^2"}}
initial: {x: 0, x': v, y: 0, y': v}
ask: {motion: {quantity: b*(x*y)^2 + a*x*b, when: [x = a, y = a]}}
"""
    told = report(problem(text), None)
    assert told.solution.asked[0].branches[0].provided
    assert "provided that the motion gets there" in terminal.text(told.derivation, told.notation, 100)
    assert "provided that the motion gets there" in as_object(told)["asked"][0]["conditions"]


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


def test_the_initial_state_is_used_where_nothing_is_asked(problem: Read) -> None:
    boat = report(problem(BOAT), None)
    assert boat.solution.from_start is not None
    [motion] = boat.solution.from_start.motions
    m, b, v = (sp.Symbol(n, positive=True) for n in "mbv")
    [(x, solution)] = motion.solutions.items()
    t = sp.Symbol("t", real=True)
    assert x.name == "x"
    assert is_zero(solution - m * v / b * (1 - sp.exp(-b * t / m))) is True
    assert "Motion from the initial state" in terminal.text(boat.derivation, boat.notation, 100)
    assert as_object(boat)["from_start"][0]["solutions"].keys() == {"x"}
    sphere = report(problem(SPHERE + "initial: {theta: 0, theta': 0}\n"), None)
    assert sphere.solution.from_start is not None
    assert not sphere.solution.from_start.motions
    assert "do not integrate in closed form" in terminal.text(sphere.derivation, sphere.notation, 100)


def test_an_initial_state_without_questions_must_still_satisfy_the_constraints(problem: Read) -> None:
    with pytest.raises(ProblemError) as error:
        solve(problem(PENDULUM + "initial: {x: l, y: l}\n"), complete=False)
    assert error.value.diagnostics[0].code == "initial-contradicts"


def test_an_initial_state_in_numbers_may_rest_on_the_values_of_letters(problem: Read) -> None:
    """x = 3, y = 4 satisfy x² + y² = l² with l = 5; x = 3, y = 3 do not."""
    valued = PENDULUM.replace("[m, l, g]", "{m: {value: 2}, l: {value: 5}, g: {value: 10}}")
    assert solve(problem(valued + "initial: {x: 3, y: 4, x': 0}\n"), complete=False).own is not None
    with pytest.raises(ProblemError):
        solve(problem(valued + "initial: {x: 3, y: 3, x': 0}\n"), complete=False)
