"""The lines of the result about rest."""

from __future__ import annotations

import math

import pytest

import lagrange
from lagrange.document.derivation import Rule
from lagrange.explain.page.result_at_rest import result_at_rest
from lagrange.explain.report import report
from lagrange.render import terminal
from tests.support.shared import solved


def test_equilibria_have_a_line_and_a_motion_has_none() -> None:
    view = next(v for v in solved("inverted-pendulum-springs").views if v.equilibrium is not None)
    lines = dict(result_at_rest(view, {}, None))
    assert len(lines[Rule.EQUILIBRIUM]) >= 2
    assert not any(equations for _, equations in result_at_rest(solved("ex11-ideal-pendulum").choices[0], {}, None))


HOOP = """title: Hoop
parameters: {R: 0.5 m, g: 10 m/s^2, W: RATE rad/s}
coordinates: [theta]
lagrangian: "R^2*theta'^2/2 + R^2*W^2*sin(theta)^2/2 + g*R*cos(theta)"
find: [motion, linearization]
"""


@pytest.mark.parametrize(
    ("rate", "said", "not_said"),
    [
        ("8", ["with the given values unstable, ω² = −44", "with the given values stable, ω ≈ 7.599"], []),
        (
            "3",
            ["stable where g > R W²; with the given values stable, ω ≈ 3.317"],
            ["(R W² − g)"],
        ),  # cos θ = g/(R W²) > 1
    ],
)
def test_the_values_decide_in_the_head(rate: str, said: list[str], not_said: list[str]) -> None:
    made = report(lagrange.loads(HOOP.replace("RATE", rate)))
    head = " ".join(terminal.text(made.derivation, made.notation, 120).split(" 1  The system")[0].split())
    assert all(s in head.replace(" │", "").replace("│ ", "") for s in said)
    assert not any(s in head for s in not_said)


PUSHED = """title: Pushed
parameters: {W: positive, R: positive, mu: positive, a: positive}
coordinates: [x, y, theta]
bodies: {plate: {position: x*i + y*j, angle: theta}}
constraints:
  left: {equation: "dot(r_plate - a*e1_plate, j) = 0", reaction: S}
  right: {equation: "dot(r_plate + a*e1_plate, j) >= 0", reaction: N}
  guide: {equation: "x = 0", reaction: H}
forces:
  load: {on: plate, vector: -W*j - R*i, at: r_plate + a*e1_plate}
  rub: {static: mu, friction: mu, constraint: right, on: plate, at: r_plate + a*e1_plate}
find: equilibrium
"""
SHAFT = """title: Bracket on a rough shaft
parameters: {W: positive, VALUES}
unknowns: [x_W]
coordinates: [x, y, theta]
bodies: {bracket: {position: x*i + y*j, angle: theta}}
constraints:
  A: {equation: "x + d/2 - h*sin(theta) <= d/2", reaction: N_A}
  B: {equation: "x - d/2 >= -d/2", reaction: N_B}
forces:
  load: {on: bracket, vector: -W*j, at: r_bracket + x_W*i}
  rub_A: {friction: mu, static: mu, constraint: A, on: bracket, at: r_bracket + d/2*i + h*e2_bracket, slip: -j}
  rub_B: {friction: mu, static: mu, constraint: B, on: bracket, at: r_bracket - d/2*i, slip: -j}
find: equilibrium
"""
WHEEL = """title: Wheel
parameters: {m: positive, g: positive, R: positive, mu: positive, alpha: acute}
coordinates: [x, y, theta]
bodies: {wheel: {mass: m, inertia: m*R^2/2, position: x*i + y*j, angle: -theta}}
constraints: {slope: {equation: y >= R, reaction: N}}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
forces: {rub: {static: mu, friction: mu, constraint: slope, on: wheel, at: r_wheel - R*j}}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("text", "said", "not_said"),
    [
        (PUSHED.replace("x = 0", "x = 0"), ["the forces:", "S = 0", "N = W"], ["F_rub"]),
        (WHEEL, ["Two degrees of freedom; the system cannot be at rest."], ["= 0"]),
        (SHAFT.replace("VALUES", "mu: positive, h: positive, d: positive"), ["μ > h/d or", "x_W ≥ d/2 and"], []),
        (
            SHAFT.replace("VALUES", "mu: 0.25, h: 6 in, d: 3 in"),
            ["x_W ≥ h/(2μ) that is x_W ≥ 0.3048 m"],
            ["h/d", "d/2"],
        ),
    ],
    ids=["the forces where nothing can move", "rest is impossible", "two cases", "values exclude one of them"],
)
def test_the_head_of_rest_with_friction(text: str, said: list[str], not_said: list[str]) -> None:
    made = report(lagrange.loads(text))
    head = " ".join(terminal.text(made.derivation, made.notation, 120).split(" 1  The system")[0].split())
    assert all(s in head for s in said)
    assert not any(s in head for s in not_said)


def _head(text: str) -> str:
    made = report(lagrange.loads(text))
    shown = terminal.text(made.derivation, made.notation, 120).split(" 1  The system")[0]
    return " ".join(shown.replace("│", "").split())


TURNING_TABLE = """title: Mass on a turning table
parameters: PARAMETERS
coordinates: {r: {range: [0, 10]}}
particles: {P: {mass: m, position: r*cos(W*t)*i + r*sin(W*t)*j}}
forces: {s: {spring: k, between: [P, 0*i], length: l}}
find: [motion, linearization]
"""


def test_a_frequency_has_the_existence_of_its_equilibrium_beside_it() -> None:
    assert "about r = k l/(k − m W²) where 10k ≥ 10m W² + k l" in _head(
        TURNING_TABLE.replace("PARAMETERS", "[m, k, l, W]")
    )


def test_values_that_settle_the_existence_take_the_place_of_the_condition() -> None:
    values = "{m: 2 kg, k: 50 N/m, l: 0.4 m, W: 2 rad/s}"
    assert "about r = k l/(k − m W²), stable, that is ω ≈ 4.583 rad/s" in _head(
        TURNING_TABLE.replace("PARAMETERS", values)
    )


def test_equal_frequencies_about_several_equilibria_have_one_line() -> None:
    head = _head("""title: Two wells
parameters: [m, c]
coordinates: [x]
lagrangian: "m*x'^2/2 - c*(x^2 - 1)^2/4"
find: [motion, linearization]
""")
    assert "ω² = 2c/m about x = −1 and x = 1, stable" in head or "ω² = 2c/m about x = 1 and x = −1, stable" in head


BALL = """title: A ball that hangs by a string at a wall
parameters: {W: positive, R: positive, l: positive}
coordinates: [x, y]
particles: {ball: {mass: 0, position: x*i + y*j}}
constraints:
  wall: {equation: x >= R, reaction: N}
  cord: {equation: x^2 + y^2 = (l + R)^2, by: string, reaction: T}
forces: {weight: {on: ball, vector: -W*j}}
find: equilibrium
"""


def test_no_place_at_which_a_string_would_push() -> None:
    """Above O the string would have to push; below, the head has the forces: T y/(l + R) = -W, N = T R/(l + R)."""
    made = report(lagrange.loads(BALL))
    text = terminal.text(made.derivation, made.notation, 120)
    head, rest = text.split(" 1  The system")
    assert "y = −√(l² + 2l R)" in head
    assert "y = √(l² + 2l R)" not in head
    assert "N = R W/(√(l + 2R) √l)" in head
    assert "T = W (l + R)/(√(l + 2R) √l)" in head
    assert "T < 0: a string cannot push, so this is no equilibrium." in rest


LINKS = """title: Two links and a spring
parameters: {l: 0.3 m, W: 50 N, k: 1500 N/m, l_0: 0.4 m}
coordinates: {theta: {range: [0, pi/2]}}
particles: {B: {mass: 0, position: l*cos(theta)*i + l*sin(theta)*j}, C: {mass: 0, position: 2*l*cos(theta)*i}}
forces: {weight: {on: B, vector: -W*j}, spring: {spring: k, between: [O, C], length: l_0}}
find: equilibrium
"""


def test_roots_found_in_numbers_stand_at_the_head() -> None:
    """W l cos θ = k (2l cos θ - l_0) 2l sin θ: found by bisection here."""

    def moment(x: float) -> float:
        return 15 * math.cos(x) - 1500 * (0.6 * math.cos(x) - 0.4) * 0.6 * math.sin(x)

    low, high = 0.5, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if moment(low) * moment(middle) > 0 else (low, middle)
    made = report(lagrange.loads(LINKS))
    head = terminal.text(made.derivation, made.notation, 120).split(" 1  The system")[0]
    assert f"θ ≈ {low:.4g} rad" in head
    assert "not solved in closed form" not in head


def test_the_oscillations_about_a_steady_motion_stand_at_the_head() -> None:
    head = _head("""title: Paraboloid
parameters: [m, a, g]
coordinates: [r, phi]
particles: {P: {mass: m, position: "r*cos(phi)*i + r*sin(phi)*j + r^2/(2*a)*k"}}
gravity: -g*k
find: steady
""")
    assert "ω² = 4a g/(r² + a²) of small oscillations about it" in head


def test_frequencies_without_a_closed_form_stand_at_the_head_in_numbers() -> None:
    """Three equal masses between equal springs, one end free: ω = 2 √(k/m) sin((2 n − 1) π/14)."""
    head = _head("""title: Frame
parameters: {m: 1000 kg, k: 600 kN/m}
coordinates: [x_1, x_2, x_3]
particles: {A: {mass: m, position: x_1*i}, B: {mass: m, position: x_2*i}, C: {mass: m, position: x_3*i}}
forces: {columns: {potential: k/2*(x_1^2 + (x_2 - x_1)^2 + (x_3 - x_2)^2)}}
find: linearization
""")
    for n in (1, 2, 3):
        assert f"≈ {2 * math.sqrt(600) * math.sin((2 * n - 1) * math.pi / 14):.2f} rad/s" in head


GYROCOMPASS = """title: Gyrocompass
parameters: {A: positive, C: positive, W: positive, beta: acute}
coordinates: [phi, psi]
lagrangian: "A/2*(phi' + W*sin(beta))^2 + A/2*(W*cos(beta)*sin(phi))^2 + C/2*(psi' + W*cos(beta)*cos(phi))^2"
find: [motion, steady]
"""


def test_frequencies_about_several_steady_motions_that_are_places() -> None:
    """The axis points north or south: A w^2 = W cos(beta) (C psi' + (C - A) W cos(beta)) about the north."""
    explained = report(lagrange.loads(GYROCOMPASS))
    page = terminal.text(explained.derivation, explained.notation, 100).split("The system")[0]
    assert "ω² = (W/A) cos β [C ψ̇ − W (A − C) cos β]    of small oscillations about φ = 0" in page
    assert "about φ = π" in page
    assert page.count("of small oscillations about") == 2


SPRING_IN_NUMBERS = """title: Inverted pendulum on a spring
parameters: {m: 10 kg, g: 9.81 m/s^2}
coordinates: [theta]
particles: {P: {mass: m, position: 0.4*sin(theta)*i + 0.4*cos(theta)*j}}
forces: {spring: {potential: "400*(0.4*sin(theta))^2/2"}}
gravity: -g*j
find: [equilibrium, linearization]
"""


def test_stability_is_not_a_comparison_of_a_weight_with_a_number_without_a_unit() -> None:
    """k l = 160 N is written without its unit: the values decide instead of 160 > m g."""
    found = report(lagrange.loads(SPRING_IN_NUMBERS))
    lines = terminal.text(found.derivation, found.notation, 200).splitlines()
    box = [line for line in lines[: next(n for n, line in enumerate(lines) if "The system" in line)] if "│" in line]
    assert not any(" stable where 160 > m g" in line for line in box)
    assert sum("with the given values stable" in line for line in box) == 2


def box_of(text: str) -> list[str]:
    found = report(lagrange.loads(text))
    head, _, _ = terminal.text(found.derivation, found.notation, 200).partition("The system")
    return [" ".join(line.strip(" │").split()) for line in head.splitlines()]


BARE = """title: Bead on a ring, with a spring whose numbers have no units
parameters: {W: {unit: N}}
coordinates: [theta]
particles: {B: {position: 0.5*sin(theta)*i + 0.5*cos(theta)*j}}
forces:
  load: {on: B, vector: -W*j}
  spring: {spring: 400, between: [0.5*j, B], length: 0.2}
find: equilibrium
"""


def test_a_number_beside_what_has_a_unit_has_it_too() -> None:
    assert "θ = π stable where W > 160 N" in box_of(BARE)
    assert "where W ≤ 160 N; stable where W < 160 N" in " ".join(box_of(BARE))


ON_A_ROD = """title: Weight on a rod, held by a spring
axes: {i: right, j: down}
parameters: {W: 100 N, l: 1 m, k: 400 N/m, s: 0.6 m, b: 1.3 m}
coordinates: [x, y]
particles: {A: {position: x*i + y*j}}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: S}}
forces: {load: {on: A, vector: W*j}, spring: {spring: k, between: [b*i, A], length: s}}
find: equilibrium
"""


def test_each_position_in_numbers_has_its_reaction() -> None:
    """By hand at (0.7899, 0.6132): the spring pulls with 79.1 N, of which 50.6 N to the right; S 0.7899 = 50.6 N."""
    lines = box_of(ON_A_ROD)
    assert any("the equilibria" in line for line in lines)
    assert [line for line in lines if line.startswith("S ≈")] == ["S ≈ −690.9 N or", "S ≈ 63.99 N"]


THREE_RODS = """title: Three rods between two pins
axes: {i: right, j: down}
parameters: {m: 2 kg, g: 9.81 m/s^2, l: 0.5 m, d: 0.9 m}
coordinates: [alpha, beta, gamma]
particles:
  A: {mass: m, position: l*sin(alpha)*i + l*cos(alpha)*j}
  B: {mass: 2*m, position: r_A + l*sin(beta)*i + l*cos(beta)*j}
constraints:
  over: l*sin(alpha) + l*sin(beta) + l*sin(gamma) = d
  down: l*cos(alpha) + l*cos(beta) + l*cos(gamma) = 0
gravity: g*j
find: equilibrium
"""


def test_several_unsolved_systems_have_their_roots_in_numbers_once() -> None:
    """By hand: 3 m g l sin α δα + 2 m g l sin β δβ = 0 at 30.20°, 84.88° and 162.5°, the lower of the two positions."""
    lines = box_of(THREE_RODS)
    assert [line for line in lines if line.startswith("α")] == ["α ≈ 0.5270 rad ≈ 30.20°", "α ≈ 2.615 rad ≈ 149.8°"]
    assert any(line.endswith("stable, or") for line in lines)
    assert not any("closed form" in line for line in lines)


BOOM = """title: A boom held by a cable
parameters: {Q: {value: 900 N}, a: {value: 2 m}, h: {value: 1.5 m}}
coordinates: [x, y, theta]
bodies: {boom: {position: x*i + y*j, angle: theta}}
constraints:
  left: {equation: "dot(r_boom - a*e1_boom, i) = 0", reaction: X}
  level: {equation: "dot(r_boom - a*e1_boom, j) = 0", reaction: Y}
  cable: {equation: norm(r_boom - h*j) = sqrt(h^2 + a^2), reaction: T}
forces: {load: {on: boom, vector: -Q*j, at: r_boom + a*e1_boom}}
find: equilibrium
"""


def test_forces_of_a_held_system_in_each_of_its_positions() -> None:
    """By hand: T h/√(a² + h²) a = Q 2a, X = T a/√(a² + h²) = 2 Q a/h, and Y = Q − 2 Q."""
    lines = box_of(BOOM)
    assert any(line.startswith("T = 2Q √(a² + h²)/h at θ = 0") and "T = 3000 N" in line for line in lines)
    assert any(line.startswith("X = 2a Q/h at θ = 0") for line in lines)
    assert any(line.startswith("X = −2a Q/h at θ = π") for line in lines)


TIED = """title: A block slides from under another one that is tied
axes: {i: down the incline, j: normal to it}
parameters: {W_1: positive, W_2: positive, mu: positive, alpha: acute}
coordinates: [x_1, y_1, x_2, y_2]
particles: {A: {position: x_1*i + y_1*j}, B: {position: x_2*i + y_2*j}}
constraints:
  cord: {equation: x_1 = 0, reaction: T, by: string}
  between: {equation: y_1 - y_2 >= 0, reaction: N_1}
  incline: {equation: y_2 >= 0, reaction: N_2}
forces:
  weight_1: {on: A, vector: W_1*(sin(alpha)*i - cos(alpha)*j)}
  weight_2: {on: B, vector: W_2*(sin(alpha)*i - cos(alpha)*j)}
  rub_1: {friction: mu, static: mu, constraint: between, on: B, slip: i}
  rub_2: {friction: mu, static: mu, constraint: incline, on: B, slip: i}
find: [equilibrium, impending]
"""


def test_the_position_of_a_held_system_is_no_limit() -> None:
    """By hand: W_2 sin α <= μ W_1 cos α + μ (W_1 + W_2) cos α."""
    lines = [line for line in box_of(TIED) if "tan" in line or "=" in line]
    assert lines == ["μ ≥ (W₂/(2W₁ + W₂)) tan α"]


ROPE = """title: A rope over two pegs with three weights
axes: {i: right, j: down}
parameters: {P: positive, W: positive, a: positive, L: positive}
coordinates: [x, y, u, v]
particles: {ring: {position: x*i + y*j}, left: {position: -a*i + u*j}, right: {position: a*i + v*j}}
constraints:
  rope_1: {equation: sqrt((x + a)^2 + y^2) + u = L, reaction: T_1}
  rope_2: {equation: sqrt((x - a)^2 + y^2) + v = L, reaction: T_2}
forces:
  middle: {on: ring, vector: W*j}
  end_1: {on: left, vector: P*j}
  end_2: {on: right, vector: P*j}
find: equilibrium
"""


def test_a_symmetric_position_stands_for_long_equations_at_the_head() -> None:
    """By hand: 2 P sin = W with y/√(a² + y²) for the sine; what is left of the equations is longer than the answer."""
    lines = box_of(ROPE)
    assert "y = a W/√(4P² − W²)" in lines
    assert any("where 2P > W; stable; others, if any, are not solved in closed form" in line for line in lines)


SKATE = """title: Skate held by a spring
parameters: [m, c, J]
coordinates: [x, y, theta]
bodies:
  skate: {mass: m, inertia: J, position: x*i + y*j, angle: theta}
constraints: {blade: "x'*sin(theta) - y'*cos(theta) = 0"}
forces: {s: {potential: "c*x^2/2"}}
find: equilibrium
"""


def test_positions_of_different_coordinates_are_alternatives() -> None:
    """`theta = pi/2` above `x = 0` would read as one position."""
    lines = dict(result_at_rest(lagrange.solve(lagrange.loads(SKATE)).solution.own, {}, None))
    assert [e.condition for e in lines[Rule.EQUILIBRIUM]] == [("or",), ("or",), ()]


def test_what_is_found_in_numbers_exists() -> None:
    """`Whether there is one is left open` does not stand above a table of four."""
    made = report(lagrange.loads(FOUR_BAR))
    page = terminal.text(made.derivation, made.notation, 120)
    assert "The conditions have 4 solutions" in page
    assert "left open" not in page


FOUR_BAR = """title: Four-bar linkage
coordinates: [alpha, beta, gamma]
particles:
  Q: {mass: 1, position: cos(alpha)*i + sin(alpha)*j}
  R: {mass: 1, position: "cos(alpha)*i + sin(alpha)*j + 2*cos(beta)*i + 2*sin(beta)*j"}
constraints:
  cx: cos(alpha) + 2*cos(beta) - 1.5*cos(gamma) = 2
  cy: sin(alpha) + 2*sin(beta) - 1.5*sin(gamma) = 0
gravity: -9.81*j
find: equilibrium
"""
