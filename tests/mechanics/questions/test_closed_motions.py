"""Solutions in closed form: the equation and the initial values, in numbers at some instants.

The motion from the initial state, where nothing is asked.
"""

from __future__ import annotations

import pytest
import sympy as sp
from scipy.integrate import solve_ivp

import lagrange
from lagrange.core.symbols import prime, t
from lagrange.mechanics.questions.closed_motions import closed_motions
from lagrange.mechanics.solution import solve
from tests.mechanics.questions.test_questions import Read

x = sp.Symbol("x", real=True)
v, a = prime(x), prime(x, 2)
k, c, f, w, p, q = sp.symbols("k c f w p q", positive=True)
NUMBERS = {k: 4.0, c: 0.7, f: 1.3, w: 1.1, p: 0.3, q: 0.9}

CASES = [
    (f, 1),
    (f * t**2 - w * t, 1),
    (f * sp.sin(w * t + 1), 1),
    (-k * x, 1),
    (k * x, 1),
    (-k * x + f + w * t, 1),
    (-c * v, 1),
    (f - c * v, 1),
    (-c * v + t, 1),
    (-k * x - c * v, 3),
    (-k * x - c * v + f * sp.cos(w * t), 3),
    (-k * x + f * sp.cos(w * t), 2),
    (-(w**2) * x + f * sp.cos(w * t), 1),
    (f - c * v**2, 1),
    (-f - c * v**2, 1),
    (-c * v**2, 1),
    (k / (f - w * t) - c, 1),
    ((f - w * v) / (c + w * t), 1),
    (f - 3 * w * v / (c + w * t), 1),
    (f * sp.exp(-c * t), 1),
    (-k * x + f * sp.exp(-c * t), 1),
    (-k * x - f * w * sp.exp(-w * t) + sp.exp(w * t), 1),
    (f * sp.exp(-w * t) - c * v, 2),
    (f * sp.exp(-c * t) - c * v, 1),
    (-(w**2) * x - 2 * w * v + f * sp.exp(-w * t), 1),
    (f - v / (1 + t**2), 0),
    (f - c * t * v, 0),
    (-k * sp.sin(x), 0),
    (-k * x**3, 0),
    (f - c * v**3, 0),
]


@pytest.mark.parametrize(("acceleration", "number"), CASES)
def test_the_solution_satisfies_the_equation_and_begins_as_it_should(acceleration: sp.Expr, number: int) -> None:
    found = closed_motions({a: acceleration}, {x: p, v: q}, {x})
    assert len(found) == number
    for motion in found:
        numbers = dict(NUMBERS)
        if k not in acceleration.free_symbols and any(r.relation == "=" for r in motion.conditions):
            numbers |= {c: NUMBERS[w]}
        elif any(r.relation == "=" for r in motion.conditions):
            numbers |= {k: 0.7**2 / 4} if c in acceleration.free_symbols else {k: 1.1**2}
        elif any((r.lhs - r.rhs).subs(numbers) < 0 for r in motion.conditions if r.relation == ">"):
            numbers[k] = 0.05
        s = motion.solutions[x]
        residual = s.diff(t, 2) - acceleration.xreplace({x: s, v: s.diff(t)})
        for time in (0.2, 0.5):
            assert abs(complex(residual.subs({**numbers, t: time}).evalf())) < 1e-9
        assert complex(s.subs({**numbers, t: 0}).evalf()).real == pytest.approx(0.3)
        assert complex(s.diff(t).subs({**numbers, t: 0}).evalf()).real == pytest.approx(0.9)


# From start


THROWN = """
title: Stone
parameters: [m, g, v]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
gravity: -g*j
initial: {x: 0, y: 0, x': v, y': 0}
"""


def test_a_thrown_stone() -> None:
    start = solve(lagrange.loads(THROWN), complete=False).from_start
    assert start is not None
    found = {q.name: str(e) for m in start.motions for q, e in m.solutions.items()}
    assert found == {"x": "t*v", "y": "-g*t**2/2"}


def test_without_an_initial_state_nothing_is_known() -> None:
    text = THROWN.replace("initial: {x: 0, y: 0, x': v, y': 0}\n", "")
    assert solve(lagrange.loads(text), complete=False).from_start is None


@pytest.mark.parametrize("law", ["-c*sqrt(x')", "-c*x'*sqrt(x')", "-c*x'^3", "c/x'"])
def test_a_resistance_as_a_power_of_the_speed(problem: Read, law: str) -> None:
    """The speed and the way as functions of time against an integration; a boat with −c √x' stops at 2 m √v/c."""
    text = f"""title: Boat
parameters: {{m: positive, c: positive, v: positive}}
coordinates: [x]
particles: {{boat: {{mass: m, position: x*i}}}}
forces: {{water: {{on: boat, vector: "({law})*i"}}}}
initial: {{x: 0, x': v}}
ask: {{speed: {{quantity: "x'", by: t}}, way: {{quantity: x, by: t}}}}
"""
    speed, way = solve(problem(text), complete=False).asked
    numbers = {sp.Symbol("m", positive=True): 2, sp.Symbol("c", positive=True): 3, sp.Symbol("v", positive=True): 4}
    powers = {"-c*sqrt(x')": (-1, 0.5), "-c*x'*sqrt(x')": (-1, 1.5), "-c*x'^3": (-1, 3), "c/x'": (1, -1)}
    sign, power = powers[law]
    motion = solve_ivp(lambda _, y: [y[1], sign * 1.5 * y[1] ** power], (0, 1), [0, 4], rtol=1e-10, atol=1e-12)
    for asked, expected in zip((way, speed), motion.y[:, -1], strict=True):
        [b] = asked.branches
        assert float(b.rhs.subs(numbers).subs(t, 1)) == pytest.approx(expected, rel=1e-7)
    lasts = [c for c in speed.branches[0].conditions if t in c.lhs.free_symbols]
    assert [c.rhs.subs(numbers) for c in lasts] == ([sp.Rational(8, 3)] if law == "-c*sqrt(x')" else [])
