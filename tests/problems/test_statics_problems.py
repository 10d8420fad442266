"""The shipped problems of statics, by a calculation of their own.

The potential energy of each is written down again in plain Python, at numbers, from the figure and not from the file; its
stationary points are found by brute force (`solution_counts`) and are the equilibria that the program finds, all of
them and no more. Where a force is unknown, the number is worked out by hand.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from math import atan, cos, exp, hypot, isclose, pi, sin, sqrt, tan

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.core.symbols import Unspecified
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.stability import Stability, StabilityVerdict
from tests.support.shared import SHIPPED, reported, solved
from tests.support.solution_counts import roots

STATICS = [n for n, p in SHIPPED.items() if p.parent.name == "statics"]


@pytest.mark.parametrize("name", [*STATICS, "ex16-rod-on-two-planes"])
def test_answers_agree_and_checks_hold(name: str) -> None:
    result = reported(name)
    assert result.holds, result.shortcomings
    asked = {a.name for a in result.answers}
    assert asked >= {"degrees_of_freedom"}
    assert asked & {"equilibrium", "rest"}


def numbers(found: Equilibrium, values: dict[str, float]) -> list[dict[str, float]]:
    """The real equilibria at numbers: angles between −π and π."""
    symbols = {s.name: s for p in found.expressions for s in p.free_symbols}
    given = {symbols[n]: sp.Float(v) for n, v in values.items() if n in symbols}
    points = []
    for b in found.branches:
        if b.special or b.left:
            continue
        for point in b.points:
            there = {}
            for u in found.solution.unknowns:
                if u.name.startswith("lambda_"):
                    continue
                angle = found.solution.letters.angle_of(u) is not None
                parts = [
                    complex(found.solution.at(point, e).xreplace(given).evalf())
                    for e in ((sp.sin(u), sp.cos(u)) if angle else (u,))
                ]
                if any(abs(x.imag) > 1e-9 for x in parts):
                    there = {}
                    break
                there[u.name] = math.atan2(parts[0].real, parts[1].real) if angle else parts[0].real
            if there:
                points.append(there)
    return points


def stationary(energy: Callable[[float], float], left: float = -pi, right: float = pi) -> list[float]:
    """Where the derivative of an energy vanishes."""
    step = 1e-5

    def slope(x: float) -> float:
        return (energy(x + step) - energy(x - step)) / (2 * step)

    found: list[float] = []
    number = 1500
    grid = [left + (right - left) * (n + 0.377) / number for n in range(-1, number + 1)]
    for a, b in pairwise(grid):
        if slope(a) * slope(b) < 0:
            x, y = a, b
            for _ in range(60):
                middle = (x + y) / 2
                x, y = (x, middle) if slope(x) * slope(middle) <= 0 else (middle, y)
            apart = all(abs(cos(x - y) - 1) > 1e-9 for y in found)
            if apart and abs(slope(x)) < 1e-6 * (1 + abs(energy(x))):
                found.append(x)
    return found


def planes(v: dict[str, float]) -> Callable[[float], float]:
    """Rod AB on two planes: A at height z_A sin α, G at k l along the rod."""

    def energy(theta: float) -> float:
        up, across = v["l"] * sin(theta) / sin(v["alpha"]), v["l"] * cos(theta) / cos(v["alpha"])
        return v["W"] * ((across - up) / 2 * sin(v["alpha"]) + v["k"] * v["l"] * sin(theta))

    return energy


def unequal(v: dict[str, float]) -> Callable[[float], float]:
    """Heights of both ends from two linear equations, solved by determinants."""

    def energy(theta: float) -> float:
        a, b, x, y = v["alpha"], v["beta"], v["l"] * cos(theta), v["l"] * sin(theta)
        d = cos(a) * sin(b) + cos(b) * sin(a)
        s, u = (x * sin(b) - y * cos(b)) / d, (x * sin(a) + y * cos(a)) / d
        return v["W"] * (s * sin(a) + u * sin(b)) / 2

    return energy


ONE_ANGLE: list[tuple[str, dict[str, float], Callable[[dict[str, float]], Callable[[float], float]]]] = [
    ("ex16-rod-on-two-planes", {"W": 7, "l": 2, "k": 0.7, "alpha": 0.6}, planes),
    ("ex16-rod-on-two-planes", {"W": 7, "l": 2, "k": 0.2, "alpha": 1.1}, planes),
    ("rod-on-unequal-planes", {"W": 3, "l": 1.5, "alpha": 0.5, "beta": 0.9}, unequal),
    ("rod-in-bowl", {"a": 1.2, "r": 1, "W": 5}, lambda v: lambda t: -v["W"] * (v["r"] * sin(2 * t) - v["a"] * sin(t))),
    ("rod-in-bowl", {"a": 3, "r": 1, "W": 5}, lambda v: lambda t: -v["W"] * (v["r"] * sin(2 * t) - v["a"] * sin(t))),
    ("rod-over-peg", {"b": 2, "c": 0.7, "W": 4}, lambda v: lambda t: v["W"] * (v["b"] * sin(t) - v["c"] * tan(t))),
    ("rod-over-peg", {"b": 1, "c": 1.7, "W": 4}, lambda v: lambda t: v["W"] * (v["b"] * sin(t) - v["c"] * tan(t))),
    ("inverted-pendulum-springs", {"l": 2, "b": 1.5, "c": 10, "W": 4},
     lambda v: lambda t: v["W"] * v["l"] * cos(t) + v["c"] * (v["b"] * sin(t)) ** 2 / 2),
    ("inverted-pendulum-springs", {"l": 2, "b": 1.5, "c": 3, "W": 4},
     lambda v: lambda t: v["W"] * v["l"] * cos(t) + v["c"] * (v["b"] * sin(t)) ** 2 / 2),
    ("weight-on-wheel", {"m": 3, "M": 1, "r": 0.5, "g": 9.81},
     lambda v: lambda t: -v["g"] * v["r"] * (v["m"] * cos(t) + v["M"] * t)),
    ("weight-on-wheel", {"m": 1, "M": 1.5, "r": 0.5, "g": 9.81},
     lambda v: lambda t: -v["g"] * v["r"] * (v["m"] * cos(t) + v["M"] * t)),
    ("beads-on-hoop", {"m_1": 3, "m_2": 1, "r": 1, "beta": 0.8, "g": 9.81},
     lambda v: lambda t: -v["g"] * v["r"] * (v["m_1"] * cos(t - v["beta"]) + v["m_2"] * cos(t + v["beta"]))),
    ("balanced-lamp", {"l": 1, "h": 2, "c": 5, "W": 3},
     lambda v: lambda t: v["W"] * v["l"] * cos(t) + v["c"] * (v["l"] ** 2 * sin(t) ** 2 + (v["l"] * cos(t) - v["h"]) ** 2) / 2),
]  # fmt: skip


@pytest.mark.parametrize(
    ("name", "values", "energy"), ONE_ANGLE, ids=[f"{n} {list(v.values())}" for n, v, _ in ONE_ANGLE]
)
def test_one_angle_against_the_energy(
    name: str, values: dict[str, float], energy: Callable[[dict[str, float]], Callable[[float], float]]
) -> None:
    solution = solved(name)
    everywhere = [solution.own.equilibrium, *(c.equilibrium for c in solution.choices)]
    [limits] = [q.range for q in solution.problem.coordinates if q.symbol.name == "theta"] or [None]
    theirs = sorted(stationary(energy(values)))
    theirs = [t for t in theirs if limits is None or limits.low <= t <= limits.high]
    for found in everywhere:
        assert found is not None
        mine = sorted(p["theta"] for p in numbers(found, values))
        assert len(mine) == len(theirs)
        for x in mine:
            assert any(abs(cos(x - y) - 1) < 1e-7 for y in theirs), (mine, theirs)


def test_stable_where_the_energy_is_least() -> None:
    """The verdicts on stability, with their conditions, against the energy itself beside each equilibrium."""
    tried = {True: 0, False: 0}
    for name, values, make in ONE_ANGLE:
        solution = solved(name)
        found, stability = solution.own.equilibrium, solution.own.stability
        assert found is not None
        assert stability is not None
        energy = make(values)
        for b, s in zip(found.branches, stability.verdicts, strict=True):
            for p in numbers(replace(found, branches=(b,)), values):
                x = p["theta"]
                least = energy(x + 1e-3) + energy(x - 1e-3) > 2 * energy(x)
                assert said_to_be_stable(s, {**values, "theta": x}) is least, (name, x, s)
                tried[least] += 1
    assert min(tried.values()) >= 5


def said_to_be_stable(s: Stability, values: dict[str, float]) -> bool | None:
    """What a verdict says at numbers."""
    if s.verdict is StabilityVerdict.CONDITIONAL:
        return all(holds(c, values) for c in s.conditions)
    return {StabilityVerdict.STABLE: True, StabilityVerdict.UNSTABLE: False}.get(s.verdict)


def holds(c: SignCondition, values: dict[str, float]) -> bool:
    difference = c.lhs - c.rhs
    number = float(difference.xreplace({s: sp.Float(values[s.name]) for s in difference.free_symbols}))
    return number > 0 if c.relation == ">" else number < 0


def test_conditional_stability_of_the_post() -> None:
    """Upright, a weight of 4 N on a post of 2 m falls unless the spring has c b² > 8 N m."""
    stability = solved("inverted-pendulum-springs").own.stability
    assert stability is not None
    [condition] = stability.verdicts[0].conditions
    c, b, w, length = (sp.Symbol(n, positive=True) for n in ("c", "b", "W", "l"))
    assert condition.relation == ">"
    for stiffness, upright in ((3.5, False), (3.6, True)):
        at = {c: stiffness, b: 1.5, w: 4, length: 2}
        assert bool((condition.lhs - condition.rhs).xreplace(at) > 0) is upright
        energy = [4 * 2 * cos(t) + stiffness * (1.5 * sin(t)) ** 2 / 2 for t in (-0.01, 0, 0.01)]
        assert (energy[0] + energy[2] > 2 * energy[1]) is upright


def force(name: str, **values: float) -> float:
    """The unknown force that a problem asks for, at numbers."""
    found = solved(name).own.equilibrium
    assert found is not None
    [b] = found.branches
    [r] = b.relations
    assert r.lhs == sp.Symbol("P", real=True)
    return value(r.rhs, values)


def forces(name: str, **values: float) -> dict[str, float]:
    """All unknown forces that a problem asks for, at numbers."""
    found = solved(name).own.equilibrium
    assert found is not None
    [b] = found.branches
    return {r.lhs.name: value(r.rhs, values) for r in b.relations}


def value(e: sp.Expr, values: dict[str, float]) -> float:
    return float(e.xreplace({s: sp.Float(values[s.name]) for s in e.free_symbols}))


def test_ladder_by_moments() -> None:
    """Moments about the foot: the wall presses with N l cos φ = W l/2 sin φ, and P = N. 200 N at 30°: 57.735 N."""
    assert isclose(force("ladder", W=200, phi=pi / 6), 57.735, rel_tol=1e-4)


def test_lazy_tongs_by_energy() -> None:
    """W 6b cos θ δθ = P 2b sin θ δθ; at 45° P = 3 W."""
    assert isclose(force("lazy-tongs", W=10, b=0.3, theta=pi / 4), 30)
    height, width = (lambda t: 6 * 0.3 * sin(t)), (lambda t: 2 * 0.3 * cos(t))
    h = 1e-6
    ratio = (height(0.7 + h) - height(0.7 - h)) / (width(0.7 - h) - width(0.7 + h))
    assert isclose(force("lazy-tongs", W=10, b=0.3, theta=0.7), 10 * ratio, rel_tol=1e-8)


def test_slider_crank_by_the_motion_of_the_piston() -> None:
    """P dx = −Q r dθ, with x(θ) = r cos θ + √(l² − r² sin² θ) differentiated numerically."""
    r, length, theta, q = 0.2, 0.5, 0.9, 30

    def x(t: float) -> float:
        return r * cos(t) + sqrt(length**2 - r**2 * sin(t) ** 2)

    rate = (x(theta + 1e-6) - x(theta - 1e-6)) / 2e-6
    found = force("slider-crank", r=r, l=length, theta=theta, Q=q, x=x(theta))
    assert isclose(found, -q * r / rate, rel_tol=1e-7)


def test_roberval_balance_is_indifferent_to_the_place_on_the_pan() -> None:
    assert force("roberval-balance", W=12) == 12


def test_three_rods_by_moments() -> None:
    """Moments about each hinge of what hangs below it, W = 10, P = 8: tan θ = 16/50, 16/30, 16/10."""
    found = solved("three-rods").own.equilibrium
    assert found is not None
    points = numbers(found, {"W": 10, "P": 8, "l": 1})
    assert len(points) == 8
    down = [p for p in points if all(cos(v) > 0 for v in p.values())]
    [p] = down
    assert [round(p[f"theta_{n}"], 9) for n in (1, 2, 3)] == [round(atan(x), 9) for x in (0.32, 16 / 30, 1.6)]

    def energy(a: float, b: float, c: float) -> float:
        weights = 10 * (cos(a) / 2 + (cos(a) + cos(b) / 2) + (cos(a) + cos(b) + cos(c) / 2))
        return -weights - 8 * (sin(a) + sin(b) + sin(c))

    here = energy(p["theta_1"], p["theta_2"], p["theta_3"])
    around = [energy(p["theta_1"] + i, p["theta_2"] + j, p["theta_3"] + k)
              for i in (-0.1, 0, 0.1) for j in (-0.1, 0, 0.1) for k in (-0.1, 0, 0.1)]  # fmt: skip
    assert here == min(around)


def test_three_weights_by_the_triangle_of_forces() -> None:
    """Two tensions P at the angle with cos = W/2P to the vertical: P = 5, W = 6, b = 1 give the 3-4-5 triangle, y = 3/4."""
    found = solved("three-weights").own.equilibrium
    assert found is not None
    [p] = numbers(found, {"P": 5, "W": 6, "b": 1, "L": 3})
    assert isclose(p["y"], 0.75)
    theirs = roots(lambda y: 6 - 2 * 5 * y / hypot(1, y), -10, 10)
    assert len(theirs) == 1
    assert isclose(theirs[0], 0.75)
    assert numbers(found, {"P": 2, "W": 6, "b": 1, "L": 3}) == []


def test_masses_on_springs_by_hand() -> None:
    """(2 + 3)·10 N on 100 N/m: 0.5 m; 30 N on 60 N/m: 0.5 m."""
    found = solved("masses-on-springs").own.equilibrium
    assert found is not None
    [p] = numbers(found, {"m_1": 2, "m_2": 3, "c_1": 100, "c_2": 60, "b_1": 1, "b_2": 1, "g": 10})
    assert isclose(p["x_1"], 0.5)
    assert isclose(p["x_2"], 0.5)


def test_pendulum_in_wind_hangs_along_the_force() -> None:
    """F = 3, W = 4, l = 5: along (3, 0, 4), and against it."""
    found = solved("pendulum-in-wind").own.equilibrium
    assert found is not None
    points = [tuple(round(p[q], 9) for q in "xyz") for p in numbers(found, {"F": 3, "W": 4, "l": 5})]
    assert sorted(points) == [(-3, 0, -4), (3, 0, 4)]


def test_rocking_plank_is_stable_when_it_is_thin() -> None:
    """The height of G is (R + h) cos θ + R θ sin θ, by the figure: least at θ = 0 where h < R."""
    stability = solved("rocking-plank").own.stability
    assert stability is not None
    [condition] = stability.verdicts[0].conditions
    radius, half = sp.Symbol("R", positive=True), sp.Symbol("h", positive=True)
    for h in (0.8, 1.2):
        height = [(1 + h) * cos(t) + t * sin(t) for t in (-0.01, 0, 0.01)]
        least = height[1] < min(height[0], height[2])
        assert bool((condition.lhs - condition.rhs).xreplace({radius: 1, half: h}) > 0) is least


def test_bifilar_suspension_by_the_tension_of_the_strings() -> None:
    """Each string carries W/2 upward and is inclined: its horizontal pull W/2 · (chord)/z has the lever a cos(θ/2)."""
    a, length, theta, w = 0.3, 2.0, 0.8, 40.0
    chord = 2 * a * sin(theta / 2)
    z = sqrt(length**2 - chord**2)
    expected = 2 * (w / 2 * chord / z) * a * cos(theta / 2)
    assert isclose(forces("bifilar-suspension", W=w, a=a, theta=theta, z=z)["M"], expected, rel_tol=1e-12)


def test_lorry_on_a_bridge_by_moments() -> None:
    """Moments about the ends of 10 m, 60 kN in the middle and 40 kN at 2.5 m: 60 kN on the left, 40 kN on the right."""
    assert forces("lorry-on-a-bridge", l=10, b=2.5, B=60, W=40) == {"P": 60, "Q": 40}


def test_drawbridge_needs_no_force_with_the_right_curve() -> None:
    """Where the height of all weights is constant, Q f(u) = W l/2 cos θ + const, no force is needed: f is a parabola.

    With u = L − 2 l sin(θ/2), cos θ = 1 − (L − u)²/(2 l²), so that f = −W (L − u)²/(4 Q l) + const does it.
    """
    found = solved("drawbridge").own.equilibrium
    assert found is not None
    [b] = found.branches
    [r] = b.relations
    length, rope, w, q, theta = 3.0, 5.0, 20.0, 7.0, 0.9
    slope = w * (2 * length * sin(theta / 2)) / (2 * q * length)
    [partial] = [e for e in sp.preorder_traversal(r.rhs) if isinstance(e, Unspecified)]
    numbers = {"W": w, "Q": q, "theta": theta, "L": rope, "l": length}
    assert isclose(value(r.rhs.xreplace({partial: sp.Float(slope)}), numbers), 0, abs_tol=1e-12)
    assert isclose(value(r.rhs.xreplace({partial: sp.S.Zero}), numbers), w / 2 * sin(theta))


# -- friction: the forces at numbers, worked out from the free bodies --------------------------------------------------

AT_LIMIT = [
    ("rough-incline", 0, {"W": 100, "alpha": 0.6, "mu_s": 0.3}, {"P": 100 * tan(0.6 - atan(0.3))}),
    ("rough-incline", 1, {"W": 100, "alpha": 0.6, "mu_s": 0.3}, {"P": 100 * tan(0.6 + atan(0.3))}),
    # N_A + nu N_B = W, N_B = mu N_A; moments about the foot: W/2 tan θ = N_B + nu N_B tan θ
    ("ladder-on-rough-ground", 0, {"W": 90, "l": 2, "mu": 0.4, "nu": 0.25}, {"theta": atan(0.8 / 0.9)}),
    (
        "band-brake",
        0,
        {"M": 30, "r": 0.2, "a": 0.05, "l": 0.5, "mu": 0.3, "beta": 4},
        {"P": 30 / 0.2 * 0.05 / 0.5 / (exp(1.2) - 1)},
    ),
    # a moment either way: only with it slips the floor i, the wall −j; N_B = mu N_A, N_A + mu N_B = W
    ("cylinder-in-a-corner", 0, {"W": 40, "r": 0.3, "mu": 0.5}, {"M": 0.3 * 0.5 * (32 + 16)}),
    ("square-threaded-screw", 1, {"W": 5000, "r": 0.02, "alpha": 0.1, "mu": 0.15}, {"M": 100 * tan(0.1 + atan(0.15))}),
    ("square-threaded-screw", 0, {"W": 5000, "r": 0.02, "alpha": 0.1, "mu": 0.15}, {"M": 100 * tan(0.1 - atan(0.15))}),
    # the wedge: N_1 = W, and W tan(α + φ) on its inclined face
    ("wedge-that-lifts", 0, {"W": 70, "alpha": 0.2, "mu": 0.3}, {"P": 70 * (0.3 + tan(0.2 + atan(0.3)))}),
]


@pytest.mark.parametrize(("name", "number", "values", "wanted"), AT_LIMIT)
def test_friction_at_its_limit(name: str, number: int, values: dict[str, float], wanted: dict[str, float]) -> None:
    view = next(v for v in reversed(solved(name).views) if v.impending)
    found = numbers(view.impending[number].equilibrium, values)
    [(unknown, value)] = wanted.items()
    assert any(isclose(point[unknown], value, rel_tol=1e-9) for point in found)


@pytest.mark.parametrize(
    ("name", "values", "rests"),
    [
        ("collar-on-a-shaft", {"W": 5, "a": 1.0, "h": 0.5, "mu": 0.26}, True),  # 2 μ a > h
        ("collar-on-a-shaft", {"W": 5000, "a": 1.0, "h": 0.5, "mu": 0.24}, False),
        ("stacked-blocks", {"W_1": 10, "W_2": 30, "F": 3.9, "mu_1": 0.5, "mu_2": 0.1}, True),
        ("stacked-blocks", {"W_1": 10, "W_2": 30, "F": 4.1, "mu_1": 0.5, "mu_2": 0.1}, False),
        ("stacked-blocks", {"W_1": 10, "W_2": 30, "F": 3.9, "mu_1": 0.3, "mu_2": 0.1}, False),
        ("step-ladder", {"W": 9, "mu": 0.4, "theta_1": 0.67}, True),  # N = W, F = W/2 tan θ, tan θ ≤ 0.8
        ("step-ladder", {"W": 9, "mu": 0.4, "theta_1": 0.68}, False),
        ("ladder-on-rough-ground", {"W": 9, "l": 1, "mu": 0.4, "nu": 0.25, "theta": 0.72}, True),  # tan θ ≤ 8/9
        ("ladder-on-rough-ground", {"W": 9, "l": 1, "mu": 0.4, "nu": 0.25, "theta": 0.73}, False),
        ("crate-tips-or-slides", {"W": 100, "P": 29, "b": 0.4, "c": 0.7, "h": 1.3, "mu": 0.5}, True),  # tips at 30.8
        ("crate-tips-or-slides", {"W": 100, "P": 32, "b": 0.4, "c": 0.7, "h": 1.3, "mu": 0.5}, False),
        ("crate-tips-or-slides", {"W": 100, "P": 29, "b": 0.4, "c": 0.7, "h": 1.3, "mu": 0.28}, False),
    ],
)
def test_rest_at_numbers(name: str, values: dict[str, float], rests: bool) -> None:
    rest = next(v.at_rest for v in reversed(solved(name).views) if v.at_rest)
    holds = [
        all((c.right - c.left).xreplace({s: sp.Float(values[s.name]) for s in (c.right - c.left).free_symbols}) >= 0 for c in case)
        for case in rest.cases
    ]  # fmt: skip
    assert any(holds) is rests


def test_a_support_under_a_beam() -> None:
    """Moments about the left end, as numbers: the support bears everything at the centre of the weights."""
    found = solved("support-under-a-beam").own.equilibrium
    assert found is not None
    [point] = numbers(found, {"W": 100, "l": 4, "P": 30, "Q": 70, "a": 3, "y": 0, "theta": 0.3})
    assert isclose(point["N"], 200)
    assert isclose(point["s"], (100 * 2 + 70 * 3) / 200)
