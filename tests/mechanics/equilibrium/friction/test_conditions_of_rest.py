"""Conditions of rest as inequalities: those of a linear program, and as they are written.

Limits of one force between several rough contacts, against the bounds themselves in numbers.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from itertools import combinations
from math import cos, sin

import numpy as np
import pytest
import sympy as sp

from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import (
    SolvedFor,
    limits_of_load,
    not_negative,
    vanishing,
)
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Inequality, Signs
from lagrange.render import json as in_json
from lagrange.render import terminal
from tests.mechanics.equilibrium.friction.test_friction_at_rest import (
    LADDER,
    PUSHED,
    ROUGH,
    Numbers,
    Read,
    rest_of,
    said,
    solved,
)

Rows = list[dict[str, float]]


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


FROM_FLOOR = """title: Ladder, its inclination measured from the floor
parameters: [W, l, mu_A, mu_B]
coordinates: [x, y, theta]
let: {u: -cos(theta)*i + sin(theta)*j}
bodies: {ladder: {position: x*i + y*j, angle: -theta}}
constraints:
  floor: {equation: y - l/2*sin(theta) >= 0, reaction: N_A}
  wall: {equation: x - l/2*cos(theta) >= 0, reaction: N_B}
forces:
  weight: {on: ladder, vector: -W*j}
  foot: {friction: mu_A, static: mu_A, constraint: floor, on: ladder, at: r_ladder - l/2*u}
  top: {friction: mu_B, static: mu_B, constraint: wall, on: ladder, at: r_ladder + l/2*u}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("text", "conditions"),
    [
        (HELIX, ["m*c*g/sqrt(m^2*g^2*R^2 + c^2*F^2 + F^2*R^2) <= mu"]),
        (HELIX.replace("  push: {on: P, vector: F*e_rho}\n", ""), ["c/R <= mu"]),
        (SMOOTH, ["tan(theta)/2 <= mu_A"]),
        (ROUGH, ["(1 - mu_A*mu_B)*tan(theta) <= 2*mu_A"]),
        (FROM_FLOOR, ["(1 - mu_A*mu_B)/(2*mu_A) <= tan(theta)"]),
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


def test_conditions_in_numbers_stay_inequalities(problem: Read) -> None:
    """W tan(α ± arctan μ) with 100 N, 20° and 0.3."""
    values = "{W: {value: 100 N}, alpha: {assume: acute, value: 20 deg}, mu: {value: 0.3}}"
    explained = report(problem(HELD.replace("{W: positive, alpha: acute, mu: positive}", values)), complete=False)
    page = " ".join(terminal.text(explained.derivation, explained.notation, 100).split())
    assert "P ≥ 5.767 N" in page
    assert "P ≤ 74.54 N" in page
    low, high = in_json.as_object(explained)["rest"]["in_numbers"]
    assert (low["number"], low["unit"]) == (pytest.approx(5.767287), "N")
    assert high["condition"].startswith("P <= 74.5356")


# Limits of load


WEDGE_LIMITS_OF_LOAD = """title: Block on a wedge
parameters: {PARAMETERS}
unknowns: [P]
coordinates: [x, y, u, v]
particles: {block: {position: x*i + y*j}, wedge: {position: u*i + v*j}}
constraints:
  wall: {equation: x <= 0, reaction: N_1}
  face: {equation: "(y - v)*cos(delta) >= (u - x)*sin(delta)", reaction: N_2}
  floor: {equation: v >= 0, reaction: N_3}
forces:
  weight: {on: block, vector: -W*j}
  push: {on: wedge, vector: P*i}
  f1: {friction: mu, static: mu, constraint: wall, on: block}
  f2: {friction: mu, static: mu, constraint: face, on: block}
  f3: {friction: mu, static: mu, constraint: floor, on: wedge}
find: equilibrium
"""


def extremes(w: float, delta: float, mu: float) -> tuple[float, float]:
    """The least and the greatest P, over all vertices of what is admissible: forces f_k and n_k as cones."""
    s, c = np.sin(delta), np.cos(delta)
    edges = [[(-1, mu), (-1, -mu)], [(s + mu * c, c - mu * s), (s - mu * c, c + mu * s)], [(mu, 1), (-mu, 1)]]
    found = []
    # wall and face hold the block; minus face, floor and P hold the wedge: weights >= 0 of six edges, and P
    columns = [[*e, 0, 0] for e in edges[0]] + [[*e, -e[0], -e[1]] for e in edges[1]] + [[0, 0, *e] for e in edges[2]]
    matrix = np.array([*columns, [0, 0, 1, 0]]).T
    for chosen in combinations(range(6), 3):
        part = matrix[:, [*chosen, 6]]
        if abs(np.linalg.det(part)) > 1e-12:
            *weights, p = np.linalg.solve(part, [0, w, 0, 0])
            if min(weights) > -1e-9:
                found.append(p)
    return min(found), max(found)


@pytest.mark.parametrize(("delta", "mu"), [("8 deg", 0.35)])
def test_a_wedge_with_three_rough_contacts(delta: str, mu: float, problem: Read) -> None:
    text = WEDGE_LIMITS_OF_LOAD.replace("PARAMETERS", f"W: 400 N, delta: {delta}, mu: {mu}")
    [rest] = [v.at_rest for v in solved(problem, text).views if v.at_rest is not None]
    numbers = {p.symbol: p.value for p in problem(text).parameters}
    least, greatest = extremes(400, float(sp.rad(int(delta.split()[0]))), mu)
    [case] = rest.cases
    p = sp.Symbol("P", real=True)
    limits = sorted(float(sp.solve((c.right - c.left).xreplace(numbers), p)[0]) for c in case)
    assert np.allclose(limits, [least, greatest])
    assert all((c.right - c.left).xreplace(numbers) > 0 for c in rest.where)


def test_each_case_has_the_sign_that_decides_which_bound_limits() -> None:
    """s >= 0, a - s >= 0, P + (a - b) s >= 0 and P <= 2: P >= 0 or P >= (b - a) a."""
    a, b, p = sp.Symbol("a", positive=True), sp.Symbol("b", positive=True), sp.Symbol("P", real=True)
    bounds = [
        Inequality((sp.S.One,), sp.S.Zero),
        Inequality((-sp.S.One,), a),
        Inequality((a - b,), p),
        Inequality((sp.S.Zero,), 2 - p),
    ]
    for case in limits_of_load(bounds, p, [], {}, Signs()):
        for x, y in ((1.0, 0.5), (0.5, 1.0)):
            at = {a: x, b: y}
            if all(e.xreplace(at) > 0 for e in case.where):
                least = max(float(-s.xreplace({**at, p: 0})) for s in case.slacks if s.diff(p).xreplace(at) > 0)
                # with s free to choose, P is only held by P + max (a - b) s >= 0
                assert abs(least - min(0.0, -(x - y) * x)) < 1e-9


def test_a_quotient_has_the_sign_of_its_divisor() -> None:
    """1/(2h tan α − 2x) ≥ 0 is x < h tan α; 1/(h − x) is never zero, and h − x = 0 would be false."""
    x, h, alpha = sp.Symbol("x", real=True), sp.Symbol("h", positive=True), sp.Symbol("alpha", positive=True)
    [c] = not_negative(1 / (2 * h * sp.tan(alpha) - 2 * x), SolvedFor(), Signs(frozenset()))
    assert c.relation == "<"
    assert sp.simplify(c.right - c.left - (h * sp.tan(alpha) - x)) == 0
    [negative] = not_negative(-3 / (h - x), SolvedFor(), Signs(frozenset()))
    assert (negative.left, negative.relation, negative.right) == (h, "<", x)
    [never] = vanishing(1 / (h - x), SolvedFor(), Signs(frozenset()))
    assert (never.left, never.relation, never.right) == (1 / (h - x), "=", 0)
