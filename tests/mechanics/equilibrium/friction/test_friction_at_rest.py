"""Friction at rest: conditions against a linear program written from the free bodies, at random numbers; by hand."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from functools import cache
from math import cos, sin

import pytest

from lagrange.answers.examiner import check_answer
from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import Fragment, NotCoveredError, ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import json as in_json
from lagrange.render import terminal
from tests.support.trajectories import function_of

Read = Callable[[str], Problem]
Numbers = Mapping[str, float]
Rows = list[dict[str, float]]

LADDER = """title: Ladder, its inclination measured from the wall
parameters: [m, g, l, mu_A, mu_B]
coordinates: [x, y, theta]
let: {{e: "sin(theta)*i - cos(theta)*j"}}
bodies: {{ladder: {{mass: m, inertia: m*l^2/3, position: x*i + y*j, angle: theta}}}}
constraints:
  wall: {{equation: "x - l*sin(theta) >= 0", reaction: N_B}}
  floor: {{equation: "y - l*cos(theta) >= 0", reaction: N_A}}
gravity: -g*j
forces:
  below: {{friction: mu_A, static: mu_A, constraint: floor, on: ladder, at: r_ladder + l*e{below}}}
{above}
find: {find}
"""
ABOVE = "  above: {friction: mu_B, static: mu_B, constraint: wall, on: ladder, at: r_ladder - l*e%s}"
ROUGH = LADDER.format(below="", above=ABOVE % "", find="equilibrium")
SMOOTH = LADDER.format(below="", above="", find="equilibrium").replace(", mu_B]", "]")
COLLAR = """title: Collar on a vertical shaft
parameters: [W, a, h, mu]
coordinates: [x, y, theta]
bodies: {collar: {inertia: 0, position: x*i + y*j, angle: theta}}
constraints:
  upper: {equation: "dot(r_collar + h/2*e2_collar, i) >= 0", reaction: N_A}
  lower: {equation: "dot(r_collar - h/2*e2_collar, i) <= 0", reaction: N_B}
forces:
  load: {on: collar, vector: -W*j, at: r_collar - a*e1_collar}
  rub_A: {friction: mu, static: mu, constraint: upper, on: collar, at: r_collar + h/2*e2_collar, slip: -j}
  rub_B: {friction: mu, static: mu, constraint: lower, on: collar, at: r_collar - h/2*e2_collar, slip: -j}
find: [equilibrium, impending]
generalized_coordinates: {up: {coordinates: [y], substitute: {x: 0, theta: 0}}}
"""
BOOK = """title: Book between wall and hand
parameters: [W, P, mu]
coordinates: [x, y, X]
particles: {book: {position: x*i + y*j}, hand: {position: X*i}}
constraints: {wall: {equation: x >= 0, reaction: N_1}, palm: {equation: x <= X, reaction: N_2}}
forces:
  weight: {on: book, vector: -W*j}
  push: {on: hand, vector: -P*i}
  rub_1: {friction: mu, static: mu, constraint: wall, on: book}
  rub_2: {friction: mu, static: mu, constraint: palm, on: book}
find: equilibrium
"""
WEDGE = """title: Wedge under a load in a smooth vertical guide
parameters: [W, P, alpha, mu]
coordinates: [x, y, X, Y]
particles: {wedge: {position: x*i + y*j}, block: {position: X*i + Y*j}}
constraints:
  floor: {equation: y >= 0, reaction: N_1}
  face: {equation: "(Y - y)*cos(alpha) - (X - x)*sin(alpha) >= 0", reaction: N_2}
  guide: {equation: X = 0, reaction: N_3}
forces:
  load: {on: block, vector: -W*j}
  push: {on: wedge, vector: -P*i}
  rub_1: {friction: mu, static: mu, constraint: floor, on: wedge}
  rub_2: {friction: mu, static: mu, constraint: face, on: block}
find: equilibrium
"""
STACKED = """title: Two blocks, the upper one pulled
parameters: [m, M, g, F, mu_1, mu_2]
coordinates: [x, y, X, Y]
particles: {top: {mass: m, position: x*i + y*j}, bottom: {mass: M, position: X*i + Y*j}}
constraints: {floor: {equation: Y >= 0, reaction: N_2}, between: {equation: y >= Y, reaction: N_1}}
gravity: -g*j
forces:
  pull: {on: top, vector: F*i}
  rub_1: {friction: mu_1, static: mu_1, constraint: between, on: top}
  rub_2: {friction: mu_2, static: mu_2, constraint: floor, on: bottom}
find: equilibrium
"""
HELD = """title: Block held on an incline by a horizontal force; books mean their limits where the divisors are positive
parameters: {W: positive, alpha: acute, mu: positive}
unknowns: [P]
coordinates: [x, y]
particles: {B: {position: x*i + y*j}}
constraints: {plane: {equation: y >= x*tan(alpha), reaction: N}}
forces:
  weight: {on: B, vector: -W*j}
  push: {on: B, vector: P*i}
  rub: {friction: mu, static: mu, constraint: plane, on: B, slip: cos(alpha)*i + sin(alpha)*j}
find: equilibrium
"""
INCLINE = """title: Block on an incline, pushed horizontally
parameters: [m, g, P, alpha, mu, mu_s]
coordinates: [x, y]
particles: {{block: {{mass: m, position: x*i + y*j}}}}
constraints: {{plane: {{equation: y {relation} 0, reaction: N}}}}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
forces:
  push: {{on: block, vector: P*(-cos(alpha)*i - sin(alpha)*j)}}
  rub: {{friction: mu, static: mu_s, constraint: plane, on: block{more}}}
find: {find}
"""
PUSHED = INCLINE.format(relation=">=", more="", find="equilibrium")


def ladder(v: Numbers) -> tuple[Rows, list[tuple[str, str, float]]]:
    s, c, w = sin(v["theta"]), cos(v["theta"]), v["m"] * v["g"]
    rows = [{"F_A": 1, "N_B": 1}, {"N_A": 1, "F_B": 1, "": w}, {"F_B": 2 * s, "N_B": 2 * c, "": w * s}]
    return rows, [("F_A", "N_A", v["mu_A"]), ("F_B", "N_B", v.get("mu_B", 0))]


def collar(v: Numbers) -> tuple[Rows, list[tuple[str, str, float]]]:
    rows = [{"N_A": 1, "N_B": -1}, {"F_A": 1, "F_B": 1, "": v["W"]}]
    rows += [{"N_A": v["h"] / 2, "N_B": v["h"] / 2, "": v["W"] * v["a"]}]
    return rows, [("F_A", "N_A", v["mu"]), ("F_B", "N_B", v["mu"])]


def book(v: Numbers) -> tuple[Rows, list[tuple[str, str, float]]]:
    rows = [{"N_1": 1, "N_2": -1}, {"N_2": 1, "": v["P"]}, {"F_1": 1, "F_2": 1, "": v["W"]}]
    return rows, [("F_1", "N_1", v["mu"]), ("F_2", "N_2", v["mu"])]


def wedge(v: Numbers) -> tuple[Rows, list[tuple[str, str, float]]]:
    s, c = sin(v["alpha"]), cos(v["alpha"])
    rows = [{"F_1": 1, "N_2": s, "F_2": -c, "": v["P"]}, {"N_1": 1, "N_2": -c, "F_2": -s}]
    rows += [{"N_2": c, "F_2": s, "": v["W"]}, {"N_2": -s, "F_2": c, "+": 1, "-": -1}]
    return rows, [("F_1", "N_1", v["mu"]), ("F_2", "N_2", v["mu"])]


def stacked(v: Numbers) -> tuple[Rows, list[tuple[str, str, float]]]:
    rows = [{"F_1": 1, "": -v["F"]}, {"F_2": 1, "F_1": -1}, {"N_1": 1, "": v["m"] * v["g"]}]
    rows += [{"N_2": 1, "N_1": -1, "": v["M"] * v["g"]}]
    return rows, [("F_1", "N_1", v["mu_1"]), ("F_2", "N_2", v["mu_2"])]


def incline(v: Numbers) -> tuple[Rows, list[tuple[str, str, float]]]:
    s, c, w = sin(v["alpha"]), cos(v["alpha"]), v["m"] * v["g"]
    rows = [{"F": 1, "": v["P"] * c - w * s}, {"N": 1, "": w * c + v["P"] * s}]
    return rows, [("F", "N", v["mu_s"])]


def feasible(rows: Rows, rough: list[tuple[str, str, float]]) -> bool:
    """Whether the rows, Σ row·x = row[""], have a solution with N ≥ 0 and |F| ≤ μ N."""
    linprog = pytest.importorskip("scipy.optimize").linprog
    names = sorted({n for row in rows for n in row if n} | {n for f, p, _ in rough for n in (f, p)})
    equal = [[row.get(n, 0) for n in names] for row in rows]
    bounds = [[s * (n == f) - mu * (n == p) for n in names] for f, p, mu in rough for s in (1, -1)]
    free = {f for f, *_ in rough}
    found = linprog(
        [0] * len(names), bounds, [0] * len(bounds), equal, [row.get("", 0) for row in rows],
        [(None, None) if n in free else (0, None) for n in names],
    )  # fmt: skip
    assert found.status in (0, 2)
    return bool(found.status == 0)


compiled = cache(function_of)


def said(rest: AtRest, values: Numbers) -> bool | None:
    """Whether the conditions hold; None too near to a limit."""
    verdicts = []
    for case in rest.cases:
        gaps = [compiled(c.right - c.left)(values) for c in case]
        if any(abs(gap) < 1e-6 for gap in gaps):
            return None
        verdicts.append(all(gap > 0 for gap in gaps))
    return any(verdicts)


def solved(problem: Read, text: str) -> Solution:
    solution = solve(problem(text))
    assert [(c.name, c.choice) for c in solution.checks if c.passed is not True] == []
    return solution


def rest_of(solution: Solution) -> AtRest:
    return next(v.at_rest for v in reversed(solution.views) if v.at_rest is not None)


@pytest.mark.parametrize(
    ("text", "program"),
    [(ROUGH, ladder), (SMOOTH, ladder), (COLLAR, collar), (BOOK, book), (WEDGE, wedge), (STACKED, stacked), (PUSHED, incline)],
    ids=["ladder", "smooth wall", "collar", "book", "wedge", "stacked", "incline"],
)  # fmt: skip
def test_the_conditions_are_those_of_a_linear_program(problem: Read, text: str, program: Callable[..., object]) -> None:
    solution = solved(problem, text)
    rest = rest_of(solution)
    draw, seen = random.Random(7), set()
    names = [p.symbol.name for p in solution.problem.parameters]
    for _ in range(150):
        values = {n: draw.uniform(0.05, 1.5) if n == "alpha" else draw.lognormvariate(0, 0.7) for n in names}
        values["theta"] = draw.uniform(0.05, 1.5)
        claim = said(rest, values)
        if claim is not None:
            seen.add(claim)
            assert claim is feasible(*program(values)), values  # type: ignore[misc]
    assert seen == {True, False}


HELIX = """title: Bead on a rough helical wire
parameters: [m, g, R, c, mu, F]
coordinates: [rho, phi, z]
frame: {type: cylindrical, coordinates: [rho, phi, z]}
particles: {P: {mass: m, position: rho*e_rho + z*k}}
constraints:
  cylinder: {equation: rho = R, reaction: A}
  thread: {equation: z = c*phi, reaction: B}
gravity: -g*k
forces:
  rub: {friction: mu, static: mu, constraint: [cylinder, thread], on: P}
  push: {on: P, vector: F*e_rho}
find: equilibrium
"""
"""At rest F_t = m g c/√(R² + c²) along the wire, across it A = −F and B = m g R/√(R² + c²)."""


@pytest.mark.parametrize(
    ("text", "conditions"),
    [
        (HELIX, ["m*c*g/sqrt(m^2*g^2*R^2 + c^2*F^2 + F^2*R^2) <= mu"]),
        (HELIX.replace("  push: {on: P, vector: F*e_rho}\n", ""), ["c/R <= mu"]),
        (SMOOTH, ["tan(theta)/2 <= mu_A"]),
        (COLLAR, ["h/(2*a) <= mu"]),
        (BOOK, ["W/(2*P) <= mu"]),
        (STACKED, ["F/(m*g) <= mu_1", "F/((M + m)*g) <= mu_2"]),
        (PUSHED.replace("  push: {on: block, vector: P*(-cos(alpha)*i - sin(alpha)*j)}\n", ""), ["tan(alpha) <= mu_s"]),
    ],
)
def test_how_they_are_written(problem: Read, text: str, conditions: list[str]) -> None:
    written = in_json.as_object(report(problem(text)))["rest"]
    assert sorted(written["conditions"]) == sorted(conditions)
    assert written["possible"]


@pytest.mark.parametrize(
    ("text", "stated", "verdict"),
    [
        (ROUGH, "[(1 - mu_A*mu_B)*tan(theta) <= 2*mu_A]", "equivalent"),
        (ROUGH, "[(1 + mu_A*mu_B)*tan(theta) <= 2*mu_A]", "wrong"),
        (SMOOTH, "[tan(theta) <= 2*mu_A]", "equivalent"),
        (SMOOTH, "[theta <= atan(2*mu_A)]", "equivalent"),
        (SMOOTH, "[tan(theta) >= 2*mu_A]", "wrong"),
        (COLLAR, "2*a*mu >= h", "equivalent"),
        (COLLAR, "a*mu > h", "wrong"),
        (STACKED, "[F <= mu_1*m*g]", "incomplete"),
        (STACKED, "[F <= mu_1*m*g, F <= mu_2*(m + M)*g]", "equivalent"),
        (HELD, "[P <= W*(tan(alpha) + mu)/(1 - mu*tan(alpha)), P >= W*tan(alpha - atan(mu))]", "equivalent"),
        (HELD, "[P <= W*tan(alpha + atan(mu)), P >= W*tan(alpha - atan(mu))]", "equivalent"),
        (HELD, "[P <= W*(tan(alpha) + mu)/(1 - 2*mu*tan(alpha)), P >= W*tan(alpha - atan(mu))]", "wrong"),
    ],
)
def test_answers(problem: Read, text: str, stated: str, verdict: str) -> None:
    [answer] = compared_answers(solved(problem, f"{text}answers: {{rest: {stated}}}\n"))
    assert (answer.name, answer.verdict.value) == ("rest", verdict)


def test_what_is_written(problem: Read) -> None:
    told = report(problem(ROUGH))
    page = " ".join(terminal.text(told.derivation, told.notation, 110).split())
    assert "N_B is not determined: the system is statically indeterminate" in page
    assert "tan θ ≤ μ_A (2 + μ_B tan θ)" in page
    assert "cos θ > 0 and sin θ > 0 are assumed" in page


# -- impending motion --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "stated", "verdict"),
    [
        (LADDER.format(below=", slip: i", above=ABOVE % ", slip: -j", find="impending"), '["tan(theta) = 2*mu_A/(1 - mu_A*mu_B)"]', "equivalent"),
        (LADDER.format(below=", slip: i", above=ABOVE % ", slip: -j", find="impending"), '["tan(theta) = 2*mu_A"]', "wrong"),
        (COLLAR, '["h = 2*a*mu"]', "equivalent"),
        (INCLINE.format(relation=">=", more=", slip: -i", find="impending").replace("P, ", "") + "unknowns: [P]\n", '["P = m*g*(sin(alpha) + mu_s*cos(alpha))/(cos(alpha) - mu_s*sin(alpha))"]', "equivalent"),
        (INCLINE.format(relation=">=", more=", slip: positive", find="impending").replace("P, ", "") + "unknowns: [P]\n", '["P = m*g*(sin(alpha) - mu_s*cos(alpha))/(cos(alpha) + mu_s*sin(alpha))"]', "equivalent"),
        (INCLINE.format(relation=">=", more="", find="impending").replace("P, ", "") + "unknowns: [P]\n", '[["P = m*g*(sin(alpha) - mu_s*cos(alpha))/(cos(alpha) + mu_s*sin(alpha))"], ["P = m*g*(sin(alpha) + mu_s*cos(alpha))/(cos(alpha) - mu_s*sin(alpha))"]]', "equivalent"),
        (INCLINE.format(relation=">=", more="", find="impending").replace("P, ", "") + "unknowns: [P]\n", '["P = m*g*(sin(alpha) - mu_s*cos(alpha))/(cos(alpha) + mu_s*sin(alpha))"]', "incomplete"),
    ],
)  # fmt: skip
def test_impending_motion(problem: Read, text: str, stated: str, verdict: str) -> None:
    [answer] = compared_answers(solved(problem, f"{text}answers: {{equilibrium: {stated}}}\n"))
    assert (answer.name, answer.verdict.value) == ("equilibrium", verdict)


def test_without_a_sense_both_are_tried(problem: Read) -> None:
    text = (
        INCLINE.format(relation="=", more="", find="impending")
        .replace("P, ", "")
        .replace("  push: {on: block, vector: P*(-cos(alpha)*i - sin(alpha)*j)}\n", "")
    )
    written = in_json.as_object(report(problem(text)))
    assert written["equilibrium"] == [["tan(alpha) = mu_s", "y = 0"]]


def test_slips_that_no_displacement_has(problem: Read) -> None:
    """A ladder that slides out below slides down above, and never up: x = 2l sin θ, y = 2l cos θ of the ends."""
    text = LADDER.format(below="", above=ABOVE % "", find="impending")
    motions = next(v.impending for v in reversed(solved(problem, text).views) if v.impending)
    [motion] = motions
    friction = {c.name: (c.tangents[0] * motion.senses[c.name]).fixed().components for c in motion.contacts}
    assert friction == {"below": (-1, 0, 0), "above": (0, 1, 0)}
    [relation] = (r for r in motion.equilibrium.branches[0].relations if "theta" in str(r.lhs))
    values = {"mu_A": 0.4, "mu_B": 0.3}
    assert float(relation.rhs.subs({s: values[s.name] for s in relation.rhs.free_symbols})) == pytest.approx(0.8 / 0.88)
    assert str(relation.rhs) == "2*mu_A/(-mu_A*mu_B + 1)"


@pytest.mark.parametrize(
    ("text", "answer", "verdict"),
    [
        (ROUGH, ["(1 - mu_A*mu_B)*tan(theta) <= 2*mu_A"], "equivalent"),
        (ROUGH, ["tan(theta) <= 3*mu_A"], "wrong"),
        (ROUGH, [r"\tan\theta \le \mu_A (2 + \mu_B \tan\theta)"], "equivalent"),
        (STACKED, ["F <= mu_1*m*g, F <= mu_2*(m + M)*g"], "equivalent"),
        (STACKED, ["F <= mu_1*m*g", "F <= mu_2*(m + M)*g"], "equivalent"),
        (STACKED, ["F <= mu_1*m*g"], "incomplete"),
        (COLLAR, ["h <= 2*a*mu", "h = 2*a*mu"], "equivalent"),
        (COLLAR, ["h <= a*mu", "h = 2*a*mu"], "wrong"),
    ],
)
def test_conditions_as_an_answer(problem: Read, text: str, answer: list[str], verdict: str) -> None:
    """`check -e` reads inequalities, alone and beside the limit."""
    judged = check_answer(problem(text), tuple(map(Fragment.of, answer)))
    assert judged.verdict.value == verdict


# -- what is refused ---------------------------------------------------------------------------------------------------


def test_without_a_static_coefficient_it_is_not_covered(problem: Read) -> None:
    with pytest.raises(NotCoveredError, match="has no coefficient of friction at rest"):
        solve(problem(PUSHED.replace(", static: mu_s", "")))


def test_impending_motion_needs_friction(problem: Read) -> None:
    text = PUSHED.replace("  rub: {friction: mu, static: mu_s, constraint: plane, on: block}\n", "")
    with pytest.raises(ProblemError) as caught:
        solve(problem(text.replace("find: equilibrium", "find: impending")))
    assert caught.value.diagnostics[0].code == "impending-without-friction"


def test_in_space_the_friction_has_two_components(problem: Read) -> None:
    text = (
        "title: Block on an incline, pushed across\nparameters: [m, g, alpha, P, mu]\ncoordinates: [x, y, z]\n"
        "particles: {B: {mass: m, position: '[x, y, z]'}}\nconstraints: {plane: {equation: z >= 0, reaction: N}}\n"
        "gravity: g*sin(alpha)*i - g*cos(alpha)*k\nforces: {push: {on: B, vector: P*j}, "
        "rub: {friction: mu, static: mu, constraint: plane, on: B}}\nfind: equilibrium\n"
        "answers: {rest: ['P^2 + (m*g*sin(alpha))^2 <= (mu*m*g*cos(alpha))^2']}\n"
    )
    [answer] = compared_answers(solved(problem, text))
    assert answer.verdict.value in ("equivalent", "undecided")
    rest = rest_of(solve(problem(text)))
    assert said(rest, {"m": 1, "g": 10, "alpha": 0.3, "P": 3, "mu": 0.45}) is True  # 4.21 <= 4.30
    assert said(rest, {"m": 1, "g": 10, "alpha": 0.3, "P": 3.2, "mu": 0.45}) is False


def test_rest_is_not_about_the_friction_of_the_motion(problem: Read) -> None:
    """If both are asked, kinetic friction is no applied force at rest."""
    text = INCLINE.format(relation=">=", more=", slip: i", find="[motion, equilibrium, impending]").replace("P, ", "")
    text = text.replace("  push: {on: block, vector: P*(-cos(alpha)*i - sin(alpha)*j)}\n", "")
    answers = "answers: {rest: ['tan(alpha) <= mu_s'], equations: [\"x'' = g*sin(alpha) - mu*g*cos(alpha)\"]}\n"
    verdicts = {a.name: a.verdict.value for a in compared_answers(solved(problem, text + answers))}
    assert verdicts == {"equations": "equivalent", "rest": "equivalent"}


def test_where_rest_is_impossible(problem: Read) -> None:
    """The string leaves the cylinder where it touches the incline: nothing balances the moment of the weight."""
    told = report(
        problem(
            "title: Cylinder held where it touches\nparameters: [m, g, R, alpha, mu]\ncoordinates: [x, y, theta]\n"
            "bodies: {c: {mass: m, inertia: m*R^2/2, position: x*i + y*j, angle: theta}}\n"
            "constraints: {plane: {equation: y >= R, reaction: N}, s: {equation: x + R*theta <= 0, by: string}}\n"
            "gravity: g*sin(alpha)*i - g*cos(alpha)*j\nforces: {rub: {friction: mu, static: mu, constraint: plane, "
            "on: c, at: r_c - R*j}}\nfind: [equilibrium, impending]\n"
        )
    )
    written = in_json.as_object(told)
    assert written["rest"]["possible"] is False
    assert written["equilibrium"] == []
    page = " ".join(terminal.text(told.derivation, told.notation, 100).split())
    assert "the system cannot be at rest" in page
    assert "the forces balance for none of the directions of slip" in page


JAMMED = """title: A drawer pulled beside its middle
axes: {i: outward, j: across}
parameters: {P: positive, a: positive, b: positive, c: positive, mu: positive}
coordinates: [x, y, theta]
bodies: {drawer: {inertia: 0, position: x*i + y*j, angle: theta}}
constraints:
  left: {equation: "y - a/2*sin(theta) + b/2*(1 - cos(theta)) >= 0", reaction: N_1}
  right: {equation: "y + a/2*sin(theta) - b/2*(1 - cos(theta)) <= 0", reaction: N_2}
forces:
  pull: {on: drawer, vector: P*i, at: r_drawer + a/2*i - c*j}
  rub1: {friction: mu, static: mu, constraint: left, on: drawer, at: "r_drawer - a/2*e1_drawer - b/2*e2_drawer", slip: i}
  rub2: {friction: mu, static: mu, constraint: right, on: drawer, at: "r_drawer + a/2*e1_drawer + b/2*e2_drawer", slip: i}
generalized_coordinates: {along: {coordinates: [x], substitute: {y: 0, theta: 0}}}
find: [equilibrium, impending]
answers: {equilibrium: [mu = a/(2*c)]}
"""


def test_a_drawer_jams(problem: Read) -> None:
    """By hand: a N = c P + (F_2 - F_1) b/2 and F_1 + F_2 = P, |F| <= mu N; mu >= a/b locks without any load."""
    rest = rest_of(solved(problem, JAMMED))
    assert sorted(f"{c.left} <= {c.right}" for case in rest.cases for c in case) == ["a/(2*c) <= mu", "a/b <= mu"]


SHAFT = """title: Bracket on a rough shaft, written without a choice of coordinates
axes: {i: right, j: up}
parameters: {W: positive, mu: positive, h: positive, d: positive, x_W: positive}
coordinates: [x, y, theta]
bodies: {bracket: {inertia: 0, position: x*i + y*j, angle: theta}}
constraints:
  A: {equation: "x + d/2 - h*sin(theta) <= d/2", reaction: N_A}
  B: {equation: "x - d/2 >= -d/2", reaction: N_B}
forces:
  load: {on: bracket, vector: -W*j, at: r_bracket + x_W*i}
  rub_A: {friction: mu, static: mu, constraint: A, on: bracket, at: r_bracket + d/2*i + h*e2_bracket, slip: -j}
  rub_B: {friction: mu, static: mu, constraint: B, on: bracket, at: r_bracket - d/2*i, slip: -j}
find: equilibrium
"""


def test_coordinates_that_the_constraints_hold_are_put_in(problem: Read) -> None:
    rest = in_json.as_object(report(problem(SHAFT)))["rest"]
    assert sorted(case[0] for case in rest["cases"]) == ["h/(2*x_W) <= mu", "h/d <= mu"]


PILE = """title: Two blocks tied by a cable over a pulley
axes: {i: right, j: up}
parameters: {m_A: positive, m_B: positive, g: positive, mu: positive}
unknowns: [P]
coordinates: [x_A, y_A, x_B, y_B]
particles: {A: {mass: m_A, position: x_A*i + y_A*j}, B: {mass: m_B, position: x_B*i + y_B*j}}
constraints:
  cable: {equation: x_A + x_B = 0, reaction: T, by: string}
  between: {equation: y_A - y_B >= 0, reaction: N_1}
  floor: {equation: y_B >= 0, reaction: N_2}
gravity: -g*j
forces:
  push: {on: B, vector: -P*i}
  above: {friction: mu, static: mu, constraint: between, on: A, slip: positive}
  opposite: {friction: mu, static: mu, constraint: between, on: B, slip: negative}
  below: {friction: mu, static: mu, constraint: floor, on: B, slip: negative}
find: [impending, equilibrium]
answers: {equilibrium: [P = mu*g*(3*m_A + m_B)], rest: ["P <= mu*g*(3*m_A + m_B)", "P >= -mu*g*(3*m_A + m_B)"]}
"""


def test_each_of_two_blocks_with_an_entry_of_its_own(problem: Read) -> None:
    """By hand: T = mu m_A g on A, and P = T + mu m_A g + mu (m_A + m_B) g on B."""
    written = in_json.as_object(report(problem(PILE)))
    assert [a["verdict"] for a in written["answers"]] == ["equivalent", "equivalent"]


MAN = """title: Man on a ladder whose ends have names
axes: {i: right, j: up}
parameters: {W: positive, L: positive, mu: positive, s: positive}
coordinates: [x, y, theta]
bodies: {ladder: {inertia: 0, position: x*i + y*j, angle: theta}}
particles: {foot: {position: "[x - L/2*cos(theta), y - L/2*sin(theta)]"}}
constraints:
  floor: {equation: "y - L/2*sin(theta) >= 0", reaction: A}
  wall: {equation: "x + L/2*cos(theta) <= 0", reaction: B}
forces:
  man: {on: ladder, vector: -W*j, at: "r_foot + s*e1_ladder"}
  rub: {friction: mu, static: mu, constraint: floor, on: ladder, at: r_foot, slip: -i}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: -L/2*cos(theta), y: L/2*sin(theta)}}}
find: equilibrium
answers: {rest: ["s <= mu*L*tan(theta)"]}
"""


def test_named_points_of_a_body_are_no_particles(problem: Read) -> None:
    written = in_json.as_object(report(problem(MAN)))
    assert [a["verdict"] for a in written["answers"]] == ["equivalent"]


def test_conditions_in_numbers_stay_inequalities(problem: Read) -> None:
    """W tan(α ± arctan μ) with 100 N, 20° and 0.3."""
    values = "{W: {value: 100 N}, alpha: {assume: acute, value: 20 deg}, mu: {value: 0.3}}"
    told = report(problem(HELD.replace("{W: positive, alpha: acute, mu: positive}", values)), complete=False)
    page = " ".join(terminal.text(told.derivation, told.notation, 100).split())
    assert "P ≥ 5.767 N" in page
    assert "P ≤ 74.54 N" in page
    low, high = in_json.as_object(told)["rest"]["in_numbers"]
    assert (low["number"], low["unit"]) == (pytest.approx(5.767287), "N")
    assert high["condition"].startswith("P <= 74.5356")
