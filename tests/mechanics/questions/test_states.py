"""The initial state."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.diagnostics import ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.kinematics import file_configuration
from lagrange.mechanics.questions.states import places_stated
from lagrange.mechanics.solution import solve
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.mechanics.questions.test_arrivals import BOAT
from tests.mechanics.questions.test_questions import PENDULUM, SPHERE, Read, asked


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


def test_the_modulus_of_a_difference_is_that_at_the_start(problem: Read) -> None:
    """A struck particle and another, joined by a spring: the momentum and the reduced mass give both answers."""
    made = report(
        problem("""title: Two on a line
parameters: {m: positive, M: positive, k: positive, l: positive, v: positive}
coordinates: [x, y]
particles: {A: {mass: m, position: x*i}, B: {mass: M, position: y*i}}
forces: {spring: {spring: k, between: [A, B], length: l}}
initial: {x: 0, y: l, x': v, y': 0}
ask: {closest: {quantity: y - x, when: "x' = y'"}}
""")
    )
    [asked] = made.solution.asked
    [branch] = asked.branches
    m, M, k, l, v = (sp.Symbol(n, positive=True) for n in "mMklv")
    assert is_zero(branch.values[0] - (l - v * sp.sqrt(M * m / ((M + m) * k)))) is True
    assert branch.conditions  # they must not meet before: v <= l √((M + m) k/(M m))


def test_places_that_a_question_states(problem: Read) -> None:
    """θ = 0 and x = l are states, x = y and N = 0 are none: only the first two simplify what is to be solved there."""
    text = """
title: Example
parameters: [m, l]
coordinates: [x, y, theta]
particles: {P: {mass: m, position: x*i + y*j}}
bodies: {B: {mass: m, inertia: m, position: 0*i, angle: theta}}
initial: {x: 0, y: 0, theta: 0}
ask: {it: {quantity: "x'", when: [theta = 0, x = l, "y = x", "y' = 0"]}}
"""
    read = problem(text)
    slots = file_configuration(read, classify(read).constrained).slots
    stated = places_stated(read.questions[0], slots)
    assert {q.name: str(v) for q, v in stated.items()} == {"theta": "0", "x": "l"}


def bowl(start: str) -> str:
    return f"""title: A particle in a bowl
axes: {{i: right, j: back, k: up}}
parameters: {{m: positive, R: positive, v: positive, g: positive}}
coordinates: [x, y, z]
particles: {{P: {{mass: m, position: [x, y, z]}}}}
constraints: {{bowl: {{equation: x^2 + y^2 + z^2 <= R^2, reaction: N, by: surface}}}}
gravity: -g*k
generalized_coordinates:
  spherical: {{coordinates: [theta, phi],
    substitute: {{x: R*cos(theta)*cos(phi), y: R*cos(theta)*sin(phi), z: -R*sin(theta)}}}}
initial: {{{start}}}
ask: {{lowest: {{quantity: z, when: "theta' = 0"}}}}
"""


def test_a_position_that_is_given_has_several_names_in_a_choice(problem: Read) -> None:
    """θ = φ = 0 or θ = φ = π: one place, in which a velocity along y is one of φ. The depth is that of Lamb."""
    answer = asked(problem, bowl("x: R, y: 0, z: 0, x': 0, y': v, z': 0"))
    R, v, g = (sp.Symbol(n, positive=True) for n in "Rvg")
    [b] = answer.branches
    assert is_zero(b.values[0] + (sp.sqrt(v**4 + 16 * g**2 * R**2) - v**2) / (4 * g)) is True


def test_a_velocity_that_leaves_a_surface_still_contradicts(problem: Read) -> None:
    with pytest.raises(ProblemError) as error:
        asked(problem, bowl("x: R, y: 0, z: 0, x': v, y': 0, z': 0"))
    assert error.value.diagnostics[0].code == "initial-contradicts"


def test_a_position_by_the_angles_that_the_file_gives(problem: Read) -> None:
    """l sin α, 0, −l cos α is θ = α, φ = 0; in a circle v² = g l sin α tan α."""
    text = bowl("x: R*cos(b), y: 0, z: -R*sin(b), x': 0, y': v, z': 0").replace("R: positive", "R: positive, b: acute")
    text = text[: text.index("ask:")] + "ask: {circle: {quantity: v, when: [t = 0, \"theta'' = 0\"]}}\n"
    [branch] = asked(problem, text).branches
    values = {s: {"b": sp.Rational(1, 3), "g": 10, "R": 2}[s.name] for s in branch.rhs.free_symbols}
    assert float(branch.rhs.subs(values)) ** 2 == pytest.approx(20 * math.cos(1 / 3) / math.tan(1 / 3))


def test_the_range_of_a_coordinate_tells_where_a_constraint_holds_it_at_first(problem: Read) -> None:
    """x² + z² = l² has z = ± √(l² − x²) at x = l/2: below, and the speed at the lowest point is that of the fall."""
    text = """title: Pendulum
axes: {i: right, k: down}
parameters: [m, l, g]
coordinates: {x: across, z: {meaning: depth, range: [0, l]}}
particles: {P: {mass: m, position: x*i + z*k}}
constraints: {rod: {equation: x^2 + z^2 = l^2, reaction: T}}
gravity: g*k
initial: {x: l/2, x': 0}
ask: {fast: {quantity: "x'^2", when: x = 0}}
"""
    [branch] = asked(problem, text).branches
    l, g = (sp.Symbol(n, positive=True) for n in ("l", "g"))
    assert is_zero(branch.values[0] - 2 * g * l * (1 - sp.sqrt(3) / 2)) is True
