"""The box at the head: what the problem asks, with the stability of equilibria beside them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from lagrange.document.derivation import Detail, Display, Rule, Step
from lagrange.explain.report import Report, report
from lagrange.problem.model import Problem
from lagrange.render import terminal
from tests.support.shared import reported


def box(r: Report) -> str:
    first: Step = r.derivation.page[0]
    assert first.rule is Rule.RESULT
    [display] = [b for b in first.body if isinstance(b, Display)]
    assert display.boxed
    page = terminal.text(r.derivation, r.notation, 120)
    return page[: page.index("\n 1  ")]


@pytest.mark.parametrize(
    ("name", "contained"),
    [
        (
            "ex16-rod-on-two-planes",
            ("One degree of freedom; the equilibrium", "tan θ = (2k − 1)/tan α    where |2k − 1| ≤ tan²α; unstable"),
        ),
        ("rod-in-bowl", ("the equilibrium:", "where 2r ≥ a")),
        ("inverted-pendulum-springs", ("the equilibria", "stable where b² c > l W")),
        ("leaving-a-sphere", ("what is asked", "cos θ = 2/3", "θ ≈ 48.19°")),
        ("released-pendulum", ("T = m g (3 − 2 cos α)    when θ = 0",)),
        ("ladder-on-rough-ground", ("the conditions of rest", "tan θ = 2μ/(1 − μ ν)    at the limit")),
        ("cylinder-on-rough-incline", ("μ_s ≥ ⅓ tan α",)),
        ("conical-pendulum", ("steady motions", "cos θ = g/(l φ̇²)    where l φ̇² ≥ g; stable ")),
        ("double-pendulum-small-oscillations", ("small oscillations", "ω₁² = g (2 − √2)/l", "stable")),
        ("spherical-pendulum-by-routh", ("Hamilton's and Routh's functions", "H = p_θ²", "R = ½ m l² θ̇²")),
        ("slider-crank", ("P = Q (x − r cos θ)/(x sin θ)", "x² − 2r x cos θ + r² = l²")),
        ("disc-against-a-step", ("ẋ = (R − h) θ̇",)),
        ("ballistic-pendulum", ("S_rod = S_catch₂ = 0", "−S_catch₁ = M m v/(M + m)")),
        ("door-closer", ("a c h (1 − l/d) sin θ = 0", "d² = a² + h² − 2a h cos θ")),
        ("rolling-without-slip", ("ẍ = ⅔ g sin α", "F = ⅓ m g sin α")),
        ("double-atwood", ("β̈ = (m₃ − m₂) g r (2m₁ R² + I₁)/Δ", "Δ = [I₁ + (M + m₁) R²] [I₂ + (m₂ + m₃) r²]")),
    ],
)
def test_the_box_contains_what_is_asked(name: str, contained: tuple[str, ...]) -> None:
    found = box(reported(name, complete=False))
    for line in contained:
        assert line in found


def test_an_acceleration_that_is_asked_for_stands_there_once(problem: Callable[[str], Problem]) -> None:
    text = (
        "title: Fall\nparameters: [m, g]\ncoordinates: [x, y]\ngravity: g*j\n"
        "particles: {P: {mass: m, position: x*i + y*j}}\nask: {rate: {quantity: y''}}\n"
    )
    found = report(problem(text), complete=False)
    assert box(found).count("ÿ = g") == 1
    question = terminal.text(found.derivation, found.notation, 80).partition("The acceleration")[2]
    assert question.count("ÿ = g") == 1


STEADY = """title: Two beads on a turning rod
parameters: [m, J, k, a]
coordinates: [x, y, phi]
let: {u: "cos(phi)*i + sin(phi)*j"}
bodies: {rod: {inertia: J, position: 0*i, angle: phi}}
particles: {A: {mass: m, position: x*u}, B: {mass: m, position: -y*u}}
forces: {s: {potential: "k*(x + y - 2*a)^2/2"}}
find: steady
"""


def test_a_steady_motion_that_is_unstable_is_said_to_be(problem: Callable[[str], Problem]) -> None:
    assert "where 2k ≠ m φ̇²; unstable where φ̇ ≠ 0" in box(report(problem(STEADY), complete=False))


def test_a_reaction_that_is_asked_for_stands_there_once(problem: Callable[[str], Problem]) -> None:
    text = (
        "title: Yo-yo\nparameters: [m, R, g]\ncoordinates: [y, phi]\ngravity: g*j\n"
        "bodies: {disc: {mass: m, inertia: m*R^2/2, position: y*j, angle: phi}}\n"
        "constraints: {string: {equation: y = R*phi, reaction: S, by: string}}\n"
        "initial: {y: 0, y': 0}\nask: {pull: {quantity: S, when: t = 0}}\n"
    )
    assert box(report(problem(text))).count("S = ⅓ m g") == 1


@pytest.mark.parametrize("name", ["ex16-rod-on-two-planes", "beads-on-hoop"])
def test_brief_pages_say_what_is_stable(name: str) -> None:
    r = reported(name, complete=False)
    page = terminal.text(r.derivation, r.notation, 80, Detail.BRIEF)
    assert "stable" in page[page.index("\n 1  ") :]


def test_stability_of_the_linear_equations_alone_is_called_so() -> None:
    assert "stable to first order where P <" in box(reported("ziegler-column", complete=False))


LADDER = """title: Ladder
axes: {i: right, j: up}
parameters: {m: {value: 3 kg}, l: {value: 2 m}, g: {value: 9.81 m/s^2}, alpha: {assume: acute, value: 70 deg}}
coordinates: {x: middle, y: height, theta: {range: [0, 90 deg]}}
bodies: {ladder: {mass: m, inertia: m*l^2/3, position: x*i + y*j, angle: -theta}}
constraints:
  floor: {equation: "y = l*sin(theta)", reaction: N}
  wall: {equation: "x = l*cos(theta)", reaction: W}
gravity: -g*j
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*cos(theta), y: l*sin(theta)}}}
initial: {theta: alpha, theta': 0}
ask: {leaves: {quantity: theta, when: W = 0}, floor: {quantity: N, by: theta}}
"""


def test_numbers_in_the_box_are_numbers_and_an_angle_has_its_degrees(problem: Callable[[str], Problem]) -> None:
    """asin(2/3 sin 70°) = 38.79°; N as a function of θ is no number."""
    boxed = box(report(problem(LADDER), complete=False))
    assert "that is sin θ ≈ 0.6265, θ ≈ 38.79°" in boxed
    assert boxed.count("that is") == 1


def test_equilibria_of_several_lines_are_alternatives(problem: Callable[[str], Problem]) -> None:
    """θ = 0 and φ = 0, or θ = π and φ = 0: no system of four equations."""
    text = """
title: Two angles
parameters: [k]
coordinates: [theta, phi]
forces: {v: {potential: "-k*cos(theta) - k*cos(phi)"}}
find: equilibrium
"""
    shown = box(report(problem(text)))
    assert "the equilibria:" in shown
    assert shown.count("or ") == 3
    assert "stable, or" in shown


def test_constant_accelerations_have_their_numbers(problem: Callable[[str], Problem]) -> None:
    """A block on a table and a load on a pulley without mass: (M + 4m) h'' = M g, x'' = -2 h''."""
    text = """title: A load on a moving pulley
axes: {j: down}
parameters: {m: {value: 4 kg}, M: {value: 2 kg}, g: {value: 9.81 m/s^2}, L: positive}
coordinates: {x: {unit: m}, p: {unit: m}, h: {unit: m}}
particles: {A: {mass: m, position: -x*i}, B: {mass: M, position: h*j}}
constraints: {rope: {equation: x + 2*p = L, reaction: S}, hook: {equation: h - p = 0.3, reaction: T, by: string}}
gravity: g*j
"""
    told = box(report(problem(text), complete=False))
    assert "ḧ = M g/(M + 4m)    that is ḧ = 1.09 m/s²" in told
    assert "S = 2M m g/(M + 4m)    that is S = 8.72 N" in told


def test_a_ball_that_rolls_in_a_bowl_has_one_equation(problem: Callable[[str], Problem]) -> None:
    """By energy, ½ m (1 + 2/5) (R − r)² φ'² − m g (R − r) cos φ: 7 (R − r) φ'' + 5 g sin φ = 0."""
    text = """title: A ball in a bowl
parameters: {m: positive, r: positive, R: positive, g: positive}
coordinates: [phi, psi]
bodies:
  ball: {mass: m, inertia: 2*m*r^2/5, position: "(R - r)*(sin(phi)*i - cos(phi)*j)", angle: psi}
constraints: {rolling: "(R - r)*phi' + r*psi' = 0"}
gravity: -g*j
"""
    told = report(problem(text), complete=False)
    assert "│  7 (R − r) φ̈ + 5g sin φ = 0" in box(told)
    assert "│  (R − r) φ̇ + r ψ̇ = 0" in box(told)
    page = " ".join(terminal.text(told.derivation, told.notation, 100).split())
    assert "Without ψ: by the constraints, ψ̈ = [(r − R)/r] φ̈ leaves" in page
    pulled = text.replace("gravity:", "forces: {spring: {potential: psi^2*m}}\ngravity:")
    assert "ψ̈" in box(report(problem(pulled), complete=False))  # ψ itself stays in the equation


def test_a_coordinate_that_is_held_has_its_value(problem: Callable[[str], Problem]) -> None:
    """Polar coordinates with r = R: R θ'' = g sin θ, N = m g cos θ − m R θ'²."""
    text = (
        "title: A skier\nparameters: {m: positive, R: positive, g: positive}\ncoordinates: [r, theta]\n"
        "particles: {S: {mass: m, position: r*sin(theta)*i + r*cos(theta)*j}}\ngravity: -g*j\n"
        "constraints: {hill: {equation: r >= R, reaction: N}}\n"
    )
    told = report(problem(text), complete=False)
    assert "│  R θ̈ − g sin θ = 0" in box(told)
    assert "│  N = m g cos θ − m R θ̇²" in box(told)
    assert "With r = R: R θ̈ − g sin θ = 0." in terminal.text(told.derivation, told.notation, 100)


SPRING = """title: Mass on a spring
parameters: {m: 2 kg, k: 800 N/m}
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {spring: {potential: k*x^2/2}}
initial: {x: 0, x': 3 m/s}
ask: {kinetic: {quantity: T_kinetic, when: "x = 0.1 m"}, whole: {quantity: energy, when: "x = 0.1 m"}}
"""


def test_a_formula_whose_numbers_hide_units_gives_way_to_the_number_and_energies_are_in_joules(
    problem: Callable[[str], Problem],
) -> None:
    head = box(report(problem(SPRING), complete=False))
    assert "T_kinetic = 5 J    when x = 0.1 m" in head
    assert "energy = 9 J    when x = 0.1 m" in head
    with_letters = SPRING.replace("x': 3 m/s", "x': v").replace("800 N/m", "800 N/m, v: 3 m/s")
    letters = box(report(problem(with_letters), complete=False))
    assert "energy = ½ m v²    when x = 0.1 m, that is energy = 9 J" in letters


def test_the_energy_lost_in_an_impact_is_in_joules(problem: Callable[[str], Problem]) -> None:
    text = """title: Two pucks
parameters: {m_1: 1 kg, m_2: 2 kg, v: 3 m/s, e: 0.5}
coordinates: [x_1, x_2]
particles: {A: {mass: m_1, position: x_1*i}, B: {mass: m_2, position: x_2*i}}
find: impact
impact: {before: {x_1': v, x_2': 0}, constraints: {contact: x_1 - x_2 = 0}, restitution: {contact: e}}
"""
    assert "2.25 J" in box(report(problem(text), complete=False))


def test_the_inclination_at_which_slip_begins_is_in_degrees(problem: Callable[[str], Problem]) -> None:
    text = """title: Block on a slope
parameters: {W: 100 N, mu: {value: 0.2}, alpha: acute}
coordinates: [x, y]
particles: {P: {position: x*i + y*j}}
constraints: {slope: y >= 0}
forces:
  weight: {on: P, vector: W*(sin(alpha)*i - cos(alpha)*j)}
  rub: {friction: mu, static: mu, constraint: slope, on: P, slip: i}
find: impending
"""
    assert "tan α = μ    that is tan α = 0.2, α ≈ 11.31°" in box(report(problem(text), complete=False))


def test_an_impulse_along_an_axis_says_on_what_it_acts_and_not_which_component_of_a_constraint_it_is() -> None:
    page = terminal.text(reported("rod-caught-at-an-end").derivation, reported("rod-caught-at-an-end").notation, 80)
    assert "the impulse on the rod along" in page
    assert "held 2" not in page


def test_the_force_of_a_constraint_in_its_own_unit_although_a_place_is_given_as_a_number(
    problem: Callable[[str], Problem],
) -> None:
    """Beer and Johnston's collar and spring: N = k b (1 − l/√(y² + b²)) with y = 6 in."""
    text = """title: Collar and spring
parameters: {W: 20 lb, k: 3 lb/in, l_0: 4 in, b: 8 in, g: 32.2 ft/s^2}
coordinates: {x: {unit: in}, y: {unit: in}}
particles: {collar: {mass: W/g, position: x*i + y*j}}
constraints: {rod: {equation: x = b, reaction: N, by: wire}}
gravity: g*j
forces: {spring: {spring: k, between: [O, collar], length: l_0}}
generalized_coordinates: {along: {coordinates: [y]}}
initial: {y: 0, y': 0}
ask: {press: {quantity: N, when: y = 6 in}}
"""
    assert "N ≈ 64.05 N    when y = 6 in" in box(report(problem(text), complete=False))


def test_of_two_answers_whose_formulas_hide_units_each_is_a_number(problem: Callable[[str], Problem]) -> None:
    """The slow and the fast precession of a cone on its tip, both without conditions, which the values satisfy."""
    text = """title: Cone on its tip
parameters: {m: 1 kg, h: 100 mm, r: 50 mm, g: 9.81 m/s^2}
coordinates: {phi: precession, theta: {range: [0, pi]}, psi: spin}
bodies:
  cone:
    mass: m
    inertia: [3*m*(4*r^2 + h^2)/80, 3*m*(4*r^2 + h^2)/80, 3*m*r^2/10]
    position: 3*h/4*e3_cone
    orientation: {axes: 313, angles: [phi, theta, psi]}
gravity: -g*k
ask: {rates: {quantity: "phi'", when: [theta = 30 deg, "theta' = 0", "theta'' = 0", "psi' = 2000 rpm"]}}
"""
    head = box(report(problem(text), complete=False))
    for rate in ("5.687", "26.56"):
        assert f"φ̇ ≈ {rate} rad/s    when θ = π/6, θ̇ = 0, θ̈ = 0 and ψ̇ = 2000 rpm" in head
    assert "conditions" not in head
