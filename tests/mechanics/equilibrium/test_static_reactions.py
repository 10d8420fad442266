"""Reactions of systems at rest, against forces and moments balanced by hand."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import pytest
import sympy as sp

from lagrange.answers.equations import Verdict
from lagrange.answers.examiner import Judgement, check_answer, check_own_answers
from lagrange.core.diagnostics import Fragment, Source
from lagrange.explain.report import Report, report
from lagrange.mechanics.dynamics.reactions import Reactions
from lagrange.mechanics.equilibrium import static_reactions
from lagrange.mechanics.equilibrium.static_reactions import StaticReactions
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load, read_problem
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from lagrange.render.terminal import text as as_text
from tests.support.paths import PROBLEMS

# The ladder's foot A stands on the floor, B leans against the wall, a rope at the floor holds A. By hand: N_A = W,
# N_B = rope, and moments about A, N_B h = W b/2.
LADDER = """
title: Ladder against a smooth wall, held by a rope
parameters: [W, l, b]
axes: {i: right, j: up}
coordinates: [x_A, y_A, x_B, y_B]
particles:
  A: {position: x_A*i + y_A*j}
  B: {position: x_B*i + y_B*j}
constraints:
  floor: {equation: y_A = 0, reaction: N_A}
  wall: {equation: x_B = 0, reaction: N_B}
  rope: {equation: x_A = b, reaction: S}
  ladder: (x_A - x_B)^2 + (y_A - y_B)^2 = l^2
forces:
  half_at_A: {on: A, vector: -W/2*j}
  half_at_B: {on: B, vector: -W/2*j}
"""
# Along the plane T = W sin α; across it N = W cos α.
INCLINE = """
title: Particle on an incline held by a rope
parameters: [W, alpha, L]
axes: {i: right, j: up}
coordinates: [x, y]
particles: {P: {position: x*i + y*j}}
constraints:
  plane: {equation: y*cos(alpha) - x*sin(alpha) = 0, reaction: N}
  rope: {equation: x^2 + y^2 = L^2, reaction: T}
forces: {weight: {on: P, vector: -W*j}}
"""
# The joint hangs at (0, 0) from two rods that end at (-a, h) and (b, h). By hand: T_1 sin = T_2 sin horizontally.
TRUSS = """
title: Joint of two rods with a weight
parameters: [W, a, b, h]
axes: {i: right, j: up}
coordinates: [x, y]
particles: {P: {position: x*i + y*j}}
constraints:
  left: {equation: (x + a)^2 + (y - h)^2 = a^2 + h^2, reaction: T_1}
  right: {equation: (x - b)^2 + (y - h)^2 = b^2 + h^2, reaction: T_2}
forces: {weight: {on: P, vector: -W*j}}
"""
# Ex. 16 with the planes as constraints; their unit normals are in the equations, so that N_A, N_B are the thrusts.
PLANES = """
title: Rod on two smooth planes
parameters: [l, W, k, alpha]
axes: {i: right, j: up}
coordinates: [x_A, y_A, theta]
particles:
  A: {position: x_A*i + y_A*j}
  B: {position: r_A + l*cos(theta)*i + l*sin(theta)*j}
  G: {position: r_A + k*l*cos(theta)*i + k*l*sin(theta)*j}
constraints:
  left: {equation: x_A*sin(alpha) + y_A*cos(alpha) = 0, reaction: N_A}
  right: {equation: (y_A + l*sin(theta))*cos(alpha) - (x_A + l*cos(theta))*sin(alpha) = 0, reaction: N_B}
forces: {weight: {on: G, vector: -W*j}}
"""
CHAIN = """
title: Two links, pulled aside
parameters: [W, l, P]
axes: {i: right, j: down}
coordinates: [x, y, u, v]
particles: {A: {position: x*i + y*j}, B: {position: u*i + v*j}}
constraints:
  upper: {equation: x^2 + y^2 = l^2, reaction: T_1}
  lower: {equation: (u - x)^2 + (v - y)^2 = l^2, reaction: T_2}
forces: {w: {on: A, vector: W*j}, w2: {on: B, vector: W*j}, pull: {on: B, vector: P*i}}
generalized_coordinates:
  angles:
    coordinates: [theta, phi]
    substitute: {x: l*sin(theta), y: l*cos(theta), u: l*sin(theta) + l*sin(phi), v: l*cos(theta) + l*cos(phi)}
"""
# A weight on a plate that three vertical strings hold in one line, at −a, 0, a: only two sums are determined.
STRINGS = """
title: A weight on three strings
parameters: [W, a, c]
axes: {i: right, j: up}
coordinates: [y, s]
particles: {G: {position: (y + c*s)*j}}
constraints:
  first: {equation: y - a*s = 0, reaction: S_1}
  second: {equation: y = 0, reaction: S_2}
  third: {equation: y + a*s = 0, reaction: S_3}
forces: {weight: {on: G, vector: -W*j}}
"""
PULLEY = """
title: Two weights on a string, the lighter one on a rope too
parameters: [W, w, L, h]
axes: {i: right, j: down}
coordinates: [x, y]
particles: {A: {position: x*j}, B: {position: "[1, y]"}}
constraints:
  string: x + y = L
  rope: {equation: y = h, reaction: R}
forces: {heavy: {on: A, vector: W*j}, light: {on: B, vector: w*j}}
"""
HELD = """
title: Which force holds the particle on the circle?
parameters: [W, l]
unknowns: [P]
axes: {i: right, j: down}
coordinates: [x, y]
particles: {B: {position: x*i + y*j}}
constraints: {circle: x^2 + y^2 = l^2}
forces: {weight: {on: B, vector: W*j}, push: {on: B, vector: P*i}}
"""
PENDULUM = """
title: Pendulum
axes: {i: right, j: down}
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
gravity: g*j
find: [equilibrium, motion]
generalized_coordinates:
  angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}
"""


@cache
def read(text: str) -> Problem:
    return read_problem(Source("problem.yaml", text))


@cache
def solved(text: str) -> Solution:
    return solve(read(text))


@cache
def reported(text: str) -> Report:
    return report(read(text))


def check(text: str, *equations: str) -> Judgement:
    return check_answer(read(text), tuple(Fragment.of(e) for e in equations))


def numbers(found: StaticReactions | None, values: dict[str, float]) -> list[dict[str, float]]:
    """Multipliers and tensions at every real point, as numbers, with the coordinates."""
    assert found is not None
    result = []
    for there in found.at:
        assert there is not None
        assert there.verified is True
        for point in there.points.values:
            rows: dict[str, float] = {}
            claims = {f"lambda_{n}": v for n, v in there.reactions.multipliers.items()}
            claims |= {f"T_{n}": v for n, v in there.reactions.tensions.items()}
            moving = found.configuration.slots.coordinates
            claims |= {q.name: q for q in moving if found.equilibrium.solution.letters.angle_of(q) is None}
            for name, e in claims.items():
                exact = there.points.at(point, e)
                value = complex(exact.subs({s: values[s.name] for s in exact.free_symbols}).evalf())
                assert abs(value.imag) < 1e-9
                rows[name] = value.real
            result.append(rows)
    return result


@pytest.mark.parametrize(
    "text", [LADDER, INCLINE, TRUSS, PLANES, CHAIN, STRINGS, PULLEY, HELD, PENDULUM], ids=lambda t: t.split("\n")[1]
)
def test_checks_hold_and_reactions_are_balanced(text: str) -> None:
    result = reported(text)
    assert result.holds, result.shortcomings
    names = [c.name for c in result.solution.checks]
    assert "the reactions satisfy Lagrange's equations at every equilibrium" in names
    assert "the reactions do no virtual work" in names


@pytest.mark.parametrize("factor", [-1, 2])
def test_a_wrong_reaction_at_rest_is_found_out(monkeypatch: pytest.MonkeyPatch, factor: int) -> None:
    """The check by Lagrange's equations can fail."""
    right = static_reactions.reactions_at

    def wrong(*given: Any) -> Reactions:
        found = right(*given)
        return replace(found, values={s: None if v is None else factor * v for s, v in found.values.items()})

    monkeypatch.setattr(static_reactions, "reactions_at", wrong)
    checks = {c.name: c.passed for c in solve(read_problem(Source("problem.yaml", INCLINE))).checks}
    assert checks["the reactions satisfy Lagrange's equations at every equilibrium"] is False


def test_ladder() -> None:
    found = numbers(solved(LADDER).own.reactions_at_rest, {"W": 10, "l": 5, "b": 3})
    assert len(found) == 2
    for there in found:
        h = there["y_B"]
        assert abs(h) == pytest.approx(4)
        assert there["lambda_floor"] == pytest.approx(10)
        assert there["lambda_wall"] * h == pytest.approx(10 * 3 / 2)
        assert there["lambda_rope"] == pytest.approx(-there["lambda_wall"])
    assert check(LADDER, "N_A = W").verdict is Verdict.EQUIVALENT
    assert check(LADDER, "N_B = W*b/(2*y_B)").verdict is Verdict.EQUIVALENT
    assert check(LADDER, "S = -W*b/(2*y_B)", "N_A = W").verdict is Verdict.EQUIVALENT
    above = check(LADDER, "N_B = W*b/(2*sqrt(l^2 - b^2))")  # below the floor it is negative
    assert above.verdict is Verdict.INCOMPLETE
    assert check(LADDER, "N_A = W/2").verdict is Verdict.WRONG


def test_incline() -> None:
    for there in numbers(solved(INCLINE).own.reactions_at_rest, {"W": 2, "alpha": 0.3, "L": 1}):
        up = 1 if there["x"] > 0 else -1  # from the foot of the incline the rope reaches up or down
        assert there["lambda_plane"] == pytest.approx(2 * float(sp.cos(0.3)))
        assert there["T_rope"] == pytest.approx(-2 * float(sp.sin(0.3)) * up)
    assert check(INCLINE, "N = W*cos(alpha)").verdict is Verdict.EQUIVALENT
    assert check(INCLINE, "T = -W*y/L").verdict is Verdict.EQUIVALENT


def test_truss() -> None:
    """Two rods allow two places of the joint, above each other: in the upper one they would push."""
    along = "T_1*(a + x)/sqrt(a^2 + h^2) = T_2*(b - x)/sqrt(b^2 + h^2)"
    upward = "T_1*(h - y)/sqrt(a^2 + h^2) + T_2*(h - y)/sqrt(b^2 + h^2) = W"
    assert check(TRUSS, along, upward).verdict is Verdict.EQUIVALENT
    assert check(TRUSS, along.replace("a + x", "2*a + x")).verdict is Verdict.WRONG
    # true as well: x = 0 at both places
    assert check(TRUSS, along.replace("a + x", "a - x")).verdict is Verdict.EQUIVALENT
    found = solved(TRUSS).own.reactions_at_rest
    assert found is not None
    # at x = y = 0 moments about the other end give each tension, and at x = 0, y = 2 h they have the opposite signs
    w, a, b, h = 7.0, 2.0, 3.0, 1.5
    rule = {"W": w, "a": a, "b": b, "h": h}
    for there, sign in zip(found.at, (1, -1), strict=True):
        assert there is not None
        tensions = {
            n: float(v.subs({s: rule[s.name] for s in v.free_symbols})) for n, v in there.reactions.tensions.items()
        }
        assert tensions["left"] == pytest.approx(sign * w * b / (a + b) * (a**2 + h**2) ** 0.5 / h)
        assert tensions["right"] == pytest.approx(sign * w * a / (a + b) * (b**2 + h**2) ** 0.5 / h)


def test_rod_on_two_planes() -> None:
    assert check(PLANES, "N_A = W/(2*cos(alpha))", "N_B = W/(2*cos(alpha))").verdict is Verdict.EQUIVALENT
    assert check(PLANES, "N_A = W/2").verdict is Verdict.WRONG
    for there in numbers(solved(PLANES).own.reactions_at_rest, {"W": 3, "alpha": 0.5, "k": 0.4, "l": 2}):
        assert there["lambda_left"] == pytest.approx(3 / (2 * float(sp.cos(0.5))))


def test_chain() -> None:
    w, p = 2.0, 1.0
    upper, lower = (p**2 + 4 * w**2) ** 0.5, (p**2 + w**2) ** 0.5
    there = solved(CHAIN).choices[0].reactions_at_rest
    found = numbers(there, {"W": w, "P": p, "l": 1})
    assert len(found) == 4
    assert {(round(abs(r["T_upper"]), 6), round(abs(r["T_lower"]), 6)) for r in found} == {
        (round(upper, 6), round(lower, 6))
    }
    assert check(CHAIN, "T_1*sin(theta) = P", "T_2*sin(phi) = P").verdict is Verdict.EQUIVALENT
    assert check(CHAIN, "T_1*cos(theta) = 2*W").verdict is Verdict.EQUIVALENT
    assert check(CHAIN, "T_1*cos(theta) = W").verdict is Verdict.WRONG


def test_what_is_indeterminate_is_said() -> None:
    result = reported(STRINGS)
    assert result.solution.own.reactions_at_rest is not None
    [there] = result.solution.own.reactions_at_rest.at
    assert there is not None
    assert not there.reactions.multipliers
    # by hand: the strings bear W together, and their moment about the second is W c
    for equation in ("S_1 + S_2 + S_3 = W", "a*(S_3 - S_1) = W*c"):
        assert check(STRINGS, equation).verdict is Verdict.EQUIVALENT
    assert check(STRINGS, "S_2 = W/3").verdict is Verdict.WRONG
    assert "statically indeterminate" in " ".join(as_text(result.derivation, result.notation, 80).split())
    assert len(as_object(result)["reactions_determined"][0]) == 2


def test_pulley() -> None:
    [there] = numbers(solved(PULLEY).own.reactions_at_rest, {"W": 5, "w": 3, "L": 10, "h": 4})
    # string pulls both up with W; the rope holds B down with W − w
    assert there["lambda_string"] == pytest.approx(-5)
    assert there["lambda_rope"] == pytest.approx(2)
    assert check(PULLEY, "lambda_string = -W", "R = W - w").verdict is Verdict.EQUIVALENT


def test_reaction_beside_unknown_forces() -> None:
    assert check(HELD, "lambda_circle = -W/(2*y)").verdict is Verdict.EQUIVALENT
    assert check(HELD, "T_circle = W*l/y").verdict is Verdict.EQUIVALENT
    assert check(HELD, "T_circle = W").verdict is Verdict.WRONG
    assert "unknowns" not in as_object(reported(HELD))


def test_statics_beside_motion() -> None:
    found = as_object(reported(PENDULUM))
    rod = found["reactions"]["rod"]
    assert rod["at_equilibrium"][0]["tension"] == "m*g"
    assert "x'" in rod["multiplier"]
    assert [r["tension"] for r in found["choices"][0]["reactions"]["rod"]["at_equilibrium"]] == ["m*g", "-m*g"]
    assert check(PENDULUM, "T_rod = m*g*cos(theta)").verdict is Verdict.EQUIVALENT


def test_reactions_beside_positions() -> None:
    both = "theta = 0 or theta = pi"
    assert check(PENDULUM, both, "T_rod = m*g*cos(theta)").verdict is Verdict.EQUIVALENT
    assert check(PENDULUM, both, "T_rod = m*g").verdict is Verdict.WRONG
    assert check(PENDULUM, "theta = 0", "T_rod = m*g*cos(theta)").verdict is Verdict.INCOMPLETE
    assert check(PENDULUM, "T_rod = -2*l*lambda_rod").verdict is Verdict.TRIVIAL  # what the tension is


def test_file_answers() -> None:
    for name in ("pendulum-in-wind", "slider-crank", "rod-on-unequal-planes"):
        result = check_own_answers(load(PROBLEMS / "statics" / f"{name}.yaml"))
        assert [a.verdict for a in result.others if a.name == "reactions"] == [Verdict.EQUIVALENT]
    wrong = STRINGS + "answers: {reactions: {second: W/3}}\n"
    result = check_own_answers(read(wrong))
    assert [a.verdict for a in result.others] == [Verdict.WRONG]
    right = LADDER + "answers: {reactions: {floor: W, wall: W*b/(2*y_B)}}\n"
    assert [a.verdict for a in check_own_answers(read(right)).others] == [Verdict.EQUIVALENT]


def test_what_a_reaction_acts_on_is_not_guessed() -> None:
    """The rope pulls at A: the massless point must not be forgotten for G, which the same coordinates move."""
    text = """
title: Ladder
parameters: [W, l, b]
axes: {i: right, j: up}
coordinates: [x, y]
particles: {A: {position: x*i}, B: {position: y*j}, G: {position: x/2*i + y/2*j}}
constraints: {ladder: x^2 + y^2 = l^2, rope: {equation: x = b, reaction: S}}
forces: {weight: {on: G, vector: -W*j}}
"""
    result = solved(text)
    assert result.law is not None
    assert result.law.newton.bodies is None
    assert check(text, "S = -W*b/(2*y)").verdict is Verdict.EQUIVALENT


TRIANGLE = """
title: Two rods and a bar that carry a weight
parameters: {W: positive, l: positive, b: positive}
coordinates: [x_C, y_C, x_B]
particles: {C: {position: x_C*i + y_C*j}, B: {position: x_B*i}}
constraints:
  AC: {equation: norm(r_C) = l, by: rod, reaction: S_1}
  BC: {equation: norm(r_C - r_B) = l, by: rod, reaction: S_2}
  AB: {equation: BAR, by: rod, reaction: S_3}
forces: {load: {on: C, vector: -W*j}}
find: equilibrium
"""


@pytest.mark.parametrize("bar", ["norm(r_B) = b", "x_B = b"])
def test_a_triangle_that_the_constraints_hold(bar: str) -> None:
    """By hand, C above: the rods are pressed by W/(2 sin α), the bar pulls with W/(2 tan α), cos α = b/(2l)."""
    written = as_object(report(read_problem(Source("triangle.yaml", TRIANGLE.replace("BAR", bar)))))
    sizes = {"W": 10, "l": 2, "b": 3}
    sine, cosine = (1 - 0.75**2) ** 0.5, 0.75
    assert written["equilibrium_conditions"] == [["2*l > b"]] * len(written["equilibrium"])
    for n, place in enumerate(written["equilibrium"]):
        height = next(e.split(" = ")[1] for e in place if e.startswith("y_C"))
        above = -1 if height.startswith("-") else 1
        forces = {k: v["at_equilibrium"][n]["force"] for k, v in written["reactions"].items()}
        values = {k: float(sp.parse_expr(v.replace("^", "**")).subs(sizes)) for k, v in forces.items()}
        expected = {"AC": -10 / (2 * sine), "BC": -10 / (2 * sine), "AB": 10 * cosine / (2 * sine)}
        assert values == pytest.approx({k: above * v for k, v in expected.items()})


# V = m g y with y = (x − a) tan θ, x = l cos θ/2 has V' = 0 where cos³ θ = 2a/l; N_A = m g tan θ, N_B = m g/cos θ.
ROD_OVER_PEG = """title: Rod between a smooth wall and a smooth peg
parameters: {m: positive, g: positive, l: positive, a: positive}
coordinates: [x, y, theta]
bodies: {rod: {mass: m, position: x*i + y*j, angle: theta}}
constraints:
  wall: {equation: x - l/2*cos(theta) >= 0, reaction: N_A}
  peg: {equation: y*cos(theta) - (x - a)*sin(theta) >= 0, reaction: N_B}
gravity: -g*j
find: [equilibrium]
"""
# V = k (l cos θ)²/2 + m g l sin θ/2; the wall presses with N_B = k l cos θ. V'' = −k l² cos² θ where sin θ = m g/(2k l).
HELD_LADDER = """title: Ladder held by a spring at its foot
parameters: {m: positive, g: positive, l: positive, k: positive}
coordinates: [x, y, theta]
bodies: {ladder: {mass: m, position: x*i + y*j, angle: theta}}
constraints:
  floor: {equation: y - l/2*sin(theta) >= 0, reaction: N_A}
  wall: {equation: x + l/2*cos(theta) <= 0, reaction: N_B}
forces:
  spring: {spring: k, between: [0, x*i + y*j - l/2*cos(theta)*i - l/2*sin(theta)*j], length: 0}
gravity: -g*j
find: [equilibrium]
"""


@pytest.mark.parametrize(
    ("text", "contact", "slack", "said"),
    [
        (ROD_OVER_PEG, {"wall": "sin(theta) ≥ 0"}, "sin(theta)", "in contact where sin θ ≥ 0; unstable where l > 2a"),
        (HELD_LADDER, {"wall": "cos(theta) ≥ 0"}, "cos(theta)", "in contact where cos θ ≥ 0; unstable where"),
    ],
)
def test_a_contact_that_may_pull_is_a_condition(text: str, contact: dict[str, str], slack: str, said: str) -> None:
    found = report(read_problem(Source("x.yaml", text)))
    view = found.solution.own
    assert found.shortcomings == ()
    assert view.reactions_at_rest is not None
    assert view.equilibrium is not None
    there = view.reactions_at_rest.at[-1]
    assert there is not None
    assert {name: f"{c.lhs} {c.relation} {c.rhs}" for name, c in there.contact.items()} == contact
    [pulled] = view.equilibrium.slack
    [place] = pulled.points
    value = view.equilibrium.solution.at(place, sp.sympify(slack, locals={"theta": sp.Symbol("theta", real=True)}))
    numbers = {s: {"a": 1, "l": 3, "m": 1, "g": 1, "k": 1}[s.name] for s in value.free_symbols}
    assert value.xreplace(numbers).evalf() < 0
    assert said in " ".join(as_text(found.derivation, found.notation, 200).split())


def test_the_second_derivative_is_written_by_the_sine_that_is_known() -> None:
    """−½ k l² (1 + cos² θ) + m² g²/(8k) is −k l² cos² θ there: unstable, without a condition on θ."""
    found = report(read_problem(Source("x.yaml", HELD_LADDER)))
    page = " ".join(as_text(found.derivation, found.notation, 200).split())
    assert "(m g − 2k l) (m g + 2k l)/(4k), negative where 2k l > m g: unstable" in page
    assert "One degree of freedom; the equilibria: " in page


def test_reactions_are_written_by_the_cosine_that_is_stated() -> None:
    """A rod on a smooth wall and over a smooth peg: cos³ θ = 2a/l, N_A = m g tan θ and N_B = m g/cos θ by Lami."""
    text = """title: Rod on a wall and a peg
axes: {i: right, j: up}
parameters: [m, g, l, a]
coordinates: [x, y, theta]
bodies: {rod: {mass: m, position: x*i + y*j, angle: theta}}
constraints:
  wall: {equation: x - l/2*cos(theta) >= 0, reaction: N_A}
  peg: {equation: y*cos(theta) - (x - a)*sin(theta) >= 0, reaction: N_B}
gravity: -g*j
find: [equilibrium]
"""
    result = report(read_problem(Source("p.yaml", text)))
    page = " ".join(as_text(result.derivation, result.notation, 300).split())
    assert "x = ½ l cos θ" in page
    assert "y = ½ l sin θ − a tan θ" in page
    assert "N_A = m g tan θ" in page
    assert "N_B = m g/cos θ" in page
    assert "in contact where sin θ ≥ 0; unstable where l > 2a" in page
    assert "because N_B is positive" in page


def test_where_a_contact_would_have_to_pull_stability_is_that_of_the_potential() -> None:
    """A bead inside a cylinder: at the top it is excluded, and V has a maximum there, whatever contact would need."""
    text = (
        "title: Bead inside a cylinder\nparameters: [m, g, R]\ncoordinates: [x, y]\n"
        "particles: {P: {mass: m, position: x*i + y*j}}\n"
        "constraints: {wall: {equation: x^2 + y^2 <= R^2, reaction: N, by: surface}}\n"
        "gravity: -g*j\nfind: equilibrium\n"
    )
    solution = solve(read_problem(Source("bead.yaml", text)))
    assert solution.own.equilibrium is not None
    assert solution.own.stability is not None
    assert [len(solution.own.equilibrium.slack), len(solution.own.equilibrium.branches)] == [1, 2]
    verdicts = {
        str(b.common[sp.Symbol("y", real=True)]): v.verdict.value
        for b, v in zip(solution.own.equilibrium.branches, solution.own.stability.verdicts, strict=True)
    }
    assert verdicts == {"R": "unstable", "-R": "stable"}


ASTRIDE = """title: Rod on a cylinder, hinged on the vertical through its axis
parameters: {W: positive, l: positive, a: positive}
coordinates: {x: right, y: up, theta: {range: [0, 90 deg]}}
let: {e: "sin(theta)*i - cos(theta)*j", n: "cos(theta)*i + sin(theta)*j"}
bodies: {rod: {position: x*i + y*j + l*e, angle: theta}}
constraints:
  symmetry: {equation: "dot(r_rod - l*e, i) = 0", reaction: H}
  cylinder: {equation: "dot(r_rod, n) >= a", reaction: N, by: surface}
forces: {weight: {on: rod, vector: -W*j}}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: 0, y: a/sin(theta)}}}
find: equilibrium
answers:
  equilibrium: ["l*sin(theta)^3 = a*cos(theta)"]
  reactions: {N: W/sin(theta), H: -W/tan(theta)}
"""


def test_reactions_where_the_position_is_not_solved() -> None:
    """l sin³ θ = a cos θ has no closed form; N sin θ = W and H = −N cos θ all the same, also at the head."""
    problem = read_problem(Source("astride.yaml", ASTRIDE))
    assert [a.verdict.value for a in report(problem).answers] == ["equivalent", "equivalent"]
    page = as_text(report(problem).derivation, report(problem).notation, 100)
    assert "N = W/sin θ" in page.split("The system")[0]


HALF_CHAIN = """title: Half of a chain of four rods
parameters: {W: 100 N, l: 1 m, d: 1.4 m}
coordinates: {alpha: {range: [0, 90 deg]}, beta: {range: [0, 90 deg]}}
let: {e: "cos(alpha)*i - sin(alpha)*j", f: "cos(beta)*i - sin(beta)*j"}
bodies: {upper: {position: l/2*e, angle: -alpha}, lower: {position: l*e + l/2*f, angle: -beta}}
constraints: {middle: {equation: l*cos(alpha) + l*cos(beta) = d, reaction: H}}
forces: {weight_1: {on: upper, vector: -W*j}, weight_2: {on: lower, vector: -W*j}}
find: equilibrium
answers: {reactions: {H: 91.77}}
"""


def test_a_named_multiplier_at_a_position_found_in_numbers() -> None:
    """tan α = 3 tan β and cos α + cos β = 1.4: α = 58.54°, H = 3W/(2 tan α) = 91.77 N."""
    explained = report(read_problem(Source("chain.yaml", HALF_CHAIN)))
    assert [a.verdict.value for a in explained.answers] == ["equivalent"]
    assert "H ≈ 91.77 N" in as_text(explained.derivation, explained.notation, 100)
