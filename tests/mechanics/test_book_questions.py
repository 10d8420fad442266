"""What textbooks ask of statics and of motions in letters, against values worked out by hand."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import NotCoveredError, ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.friction import friction_at_rest
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import terminal
from lagrange.render.json import as_object

Read = Callable[[str], Problem]

INCLINE = """
title: A block held on a rough slope
axes: {i: up the slope, j: away from it}
parameters: {m: {value: 10 kg}, g: {value: 9.81 m/s^2}, mu: {value: 0.3}, alpha: {assume: acute, value: 30 deg}}
unknowns: [P]
coordinates: [x, y]
particles: {B: {mass: m, position: x*i + y*j}}
constraints: {plane: {equation: y >= 0, reaction: N}}
gravity: -g*sin(alpha)*i - g*cos(alpha)*j
forces:
  push: {on: B, vector: P*i}
  rub: {friction: mu, static: mu, constraint: plane, on: B, slip: i}
find: [equilibrium, impending]
ask: {force: {quantity: P, when: x = 0}}
"""
UP, PRESSED = 98.1 * (math.sin(math.pi / 6) + 0.3 * math.cos(math.pi / 6)), 98.1 * math.cos(math.pi / 6)


def test_a_question_about_rest_is_answered_with_friction_at_its_limit(problem: Read) -> None:
    solved = report(problem(INCLINE))
    found = as_object(solved)
    assert found["asked"][0]["number"] == pytest.approx(UP)
    [motion] = found["impending"]
    assert motion["in_numbers"] == [{"P": {"number": pytest.approx(UP), "unit": "N"}}]
    assert motion["reactions_in_numbers"] == {"plane": {"number": pytest.approx(PRESSED), "unit": "N"}}
    with pytest.raises(ProblemError) as error:
        solve(problem(INCLINE.replace(", slip: i", "")))
    assert [d.code for d in error.value.diagnostics] == ["not-determined"]


def test_impending_motion_is_kept_where_rest_is_given_up(problem: Read, monkeypatch: pytest.MonkeyPatch) -> None:
    def undecided(*_: object) -> None:
        raise NotCoveredError("friction at rest")

    monkeypatch.setattr(friction_at_rest, "rest_with_friction", undecided)
    text = INCLINE.partition("ask:")[0]
    solution = solve(problem(text))
    assert solution.given_up.startswith("friction at rest")
    assert solution.own.at_rest is None
    assert solution.own.impending
    with pytest.raises(NotCoveredError):
        solve(problem(text.replace(", impending", "")))


ROUGH = """
title: A block on a rough slope
parameters: {m: positive, g: positive, mu: positive, alpha: acute}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {slope: {equation: y = -x*tan(alpha), reaction: N}}
gravity: -g*j
forces: {rub: {friction: mu, constraint: slope, on: P, slip: cos(alpha)*i - sin(alpha)*j}}
generalized_coordinates: {down: {coordinates: [s], substitute: {x: s*cos(alpha), y: -s*sin(alpha)}}}
"""


def test_an_acute_slope_leaves_no_magnitudes_and_friction_names_its_force(problem: Read) -> None:
    solved = report(problem(ROUGH))
    page = " ".join(terminal.text(solved.derivation, solved.notation, 120).split())
    assert "s̈ − g sin α + μ g cos α = 0" in page
    assert "|cos α|" not in page
    assert "The friction contains N, the reaction of the slope constraint, found below." in page


SPRING = """
title: A spring released at any length
parameters: {m: positive, k: positive, l: positive, a: positive}
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {one: {spring: k, between: [0*i, P], length: l, sense: positive}}
initial: {x: a, x': 0}
ask:
  speed: {quantity: "x'", when: x = l}
  other_end: {quantity: x, when: x' = 0}
"""


def test_the_order_of_two_lengths_may_stay_open(problem: Read) -> None:
    m, k, l, a = sp.symbols("m k l a", positive=True)
    speed, end = solve(problem(SPRING)).asked
    [branch] = speed.branches
    assert sp.simplify(branch.rhs - (l - a) * sp.sqrt(k / m)) == 0
    assert not branch.provided
    assert [b.rhs for b in end.branches] == [2 * l - a]


RATES = """
title: Units of rates and forces
axes: {j: up, k: up}
parameters: {m: {value: 2 kg}, l: {value: 1 m}, g: {value: 9.81 m/s^2}}
coordinates: [a, b, theta]
particles:
  A: {mass: m, position: -a*k}
  B: {mass: 2*m, position: i - b*k}
  C: {mass: m, position: l*cos(theta)*i + l*sin(theta)*j}
constraints: {rope: {equation: a + b = 4*l, reaction: T, by: string}}
gravity: -g*k
initial: {a: 0, a': 0, theta: 0, theta': 30 rpm}
ask:
  force: {quantity: T, when: "a = -1 m"}
  rate: {quantity: "theta'", when: "a = -1 m"}
"""


def test_angular_velocities_are_in_radians_per_second_and_named_forces_in_newtons(problem: Read) -> None:
    found = {a["name"]: (a["number"], a["unit"]) for a in as_object(report(problem(RATES)))["asked"]}
    assert found == {"force": (pytest.approx(4 / 3 * 2 * 9.81), "N"), "rate": (pytest.approx(math.pi), "rad/s")}


STRINGS = """
title: A weight on two strings
axes: {i: right, j: down}
parameters: {W: {value: 100 N}, a: {value: 5 m}, b: {value: 3 m}, c: {value: 4 m}}
coordinates: {x: {range: [0, 5]}, y: {range: [1, 10]}}
particles: {P: {position: x*i + y*j}}
constraints:
  left: {equation: x^2 + y^2 <= b^2, reaction: T_1}
  right: {equation: (x - a)^2 + y^2 <= c^2, reaction: T_2}
forces: {weight: {on: P, vector: W*j}}
find: equilibrium
"""


def test_a_position_that_strings_determine_is_found_with_their_tensions(problem: Read) -> None:
    """Lengths 3, 4 and 5 m: the strings are at right angles."""
    solved = report(problem(STRINGS))
    page = " ".join(terminal.text(solved.derivation, solved.notation, 120).split())
    assert "that is x = 1.8 m" in page
    assert "that is y = 2.4 m" in page
    assert "T₁ = 80 N" in page
    assert "T₂ = 60 N" in page
    assert "where" not in page.partition("1 The system")[0]  # of a triangle with the sides 3, 4 and 5 nothing is open
    in_letters = report(problem(STRINGS.replace("c: {value: 4 m}", "c: positive")))
    assert (
        "where"
        in " ".join(terminal.text(in_letters.derivation, in_letters.notation, 120).split()).partition("1 The")[0]
    )


def test_a_time_found_in_numbers_has_its_unit(problem: Read) -> None:
    text = """
title: Pendulum
axes: {i: right, j: down}
parameters: {l: {value: 1 m}, g: {value: 9.81 m/s^2}, m: {value: 1 kg}}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}
gravity: g*j
initial: {theta: 60 deg, theta': 0}
ask: {quarter: {quantity: t, when: theta = 0}}
"""
    solved = report(problem(text))
    page = " ".join(terminal.text(solved.derivation, solved.notation, 120).split())
    assert f"t ≈ {float(sp.elliptic_k(sp.Rational(1, 4)) / sp.sqrt(9.81)):.4g} s" in page


HILL = """
title: A sledge on a hill
parameters: {m: 10 kg, g: 9.81 m/s^2, mu: 0.1, alpha: 25 deg}
coordinates: [s, n]
let: {u: cos(alpha)*i + sin(alpha)*j, w: cos(alpha)*j - sin(alpha)*i}
particles: {P: {mass: m, position: s*u + n*w}}
constraints: {hill: {equation: n >= 0, reaction: N}}
gravity: -g*j
forces: {rub: {friction: mu, constraint: hill, on: P, slip: -u}}
initial: {s: 0, s': 0}
ask: {speed: {quantity: s', when: s = -12.5 ft}}
"""


def test_the_head_has_no_trivial_acceleration_and_the_units_of_the_question(problem: Read) -> None:
    solved = report(problem(HILL))
    page = terminal.text(solved.derivation, solved.notation, 100)
    head = page.partition("╯")[0]
    assert "n̈" not in head
    assert "when s = −12.5 ft" in head
    speed = math.sqrt(2 * 12.5 * 0.3048 * 9.81 * (math.sin(math.radians(25)) - 0.1 * math.cos(math.radians(25))))
    assert f"{speed:.3f} m/s" in head


@pytest.mark.parametrize(
    ("written", "instead", "code", "cure"),
    [
        ("s = -12.5 ft", "hill = 0", "unknown-symbol", "`hill` is a constraint; its force is `N`"),
        ("n >= 0", "n > = 0", "inequality", "write `>=` without a space"),
        ("slip: -u", "slip: i", "friction-slip", "write `slip: [cos(alpha), sin(alpha)]`"),
        ("gravity: -g*j", "gravity: 0*j", "friction-unpressed", "is `gravity` or another force missing?"),
        ("s = -12.5 ft", "sdd = 0", "unknown-symbol", "did you mean `s''`?"),
    ],
)
def test_cures_that_a_newcomer_needs(problem: Read, written: str, instead: str, code: str, cure: str) -> None:
    with pytest.raises(ProblemError) as error:
        solve(problem(HILL.replace(written, instead)))
    assert (code, True) in [(d.code, cure in d.help) for d in error.value.diagnostics]


def test_a_string_by_its_name_pulls(problem: Read) -> None:
    """A block M on a smooth table, drawn by a load m: T = M m g/(M + m), though z − x = L looks like no sum of lengths."""
    text = """
title: A block drawn by a load
parameters: [M, m, g, L]
coordinates: [x, z]
particles: {A: {mass: M, position: x*i}, B: {mass: m, position: L*i - z*j}}
constraints: {string: {equation: z - x = L, reaction: T}}
gravity: -g*j
"""
    for written in (text, text.replace("string:", "rope_1:"), text.replace("z - x = L", "x - z = -L")):
        found = as_object(report(problem(written)))["reactions"]
        [tension] = found.values()
        assert tension["force"] == "M*m*g/(M + m)"
    other = as_object(report(problem(text.replace("string:", "link:"))))["reactions"]["link"]
    assert "force" not in other


COLLAR = """
title: A collar drawn up a rough vertical rod
parameters: {W: 20 N, theta: 50 deg, mu: 0.4}
unknowns: [P]
coordinates: [x, y]
particles: {collar: {position: x*i + y*j}}
constraints: {rod: {equation: x = 0, reaction: N}}
forces:
  weight: {on: collar, vector: -W*j}
  pull: {on: collar, vector: P*sin(theta)*i + P*cos(theta)*j}
  rub: {friction: mu, static: mu, constraint: rod, on: collar, slip: j}
find: impending
"""


def test_values_decide_on_which_side_a_collar_is_pressed(problem: Read) -> None:
    [motion] = as_object(report(problem(COLLAR)))["impending"]
    pull = 20 / (math.cos(math.radians(50)) - 0.4 * math.sin(math.radians(50)))
    assert motion["in_numbers"] == [{"P": {"number": pytest.approx(pull), "unit": "N"}}]
    with pytest.raises(NotCoveredError):
        solve(problem(COLLAR.replace("{W: 20 N, theta: 50 deg, mu: 0.4}", "{W: positive, theta: acute, mu: positive}")))


def test_the_unit_of_an_answer_where_a_bare_number_hides_one(problem: Read) -> None:
    """v = √(2 g h) with h = 1 m: the derived value √2 √g has the unit of √g."""
    text = """
title: A fall
parameters: {m: 1 kg, g: 9.81 m/s^2}
coordinates: [y]
particles: {P: {mass: m, position: -y*j}}
gravity: -g*j
initial: {y: 0, y': 0}
ask: {speed: {quantity: y', when: y = 1 m}}
answers: {ask: {speed: 4.429 m/s}}
"""
    verdicts = [as_object(report(problem(t)))["answers"][0]["verdict"] for t in (text, text.replace("4.429", "4.5"))]
    assert verdicts == ["equivalent", "wrong"]
