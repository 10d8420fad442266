"""The equations with multipliers beside the elimination, and the conditions under which the eliminated ones hold."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp
from conftest import PROBLEMS
from second_route import Rigid, constants, moving, newton_euler, rotation, slots, t

from lagrange.algebra.exact.exact import is_zero
from lagrange.answers.equations import Verdict, check_equations
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import prime
from lagrange.explain.report import Report, report
from lagrange.mechanics.dynamics.equations import WithMultipliers
from lagrange.mechanics.solution import Solution, solve
from lagrange.problem.loader import load
from lagrange.problem.model import Problem
from lagrange.render.json import as_object

Read = Callable[[str], Problem]


def with_multipliers(solution: Solution, choice: str = "") -> WithMultipliers:
    dynamics = next(c.dynamics for c in solution.choices if c.name == choice) if choice else solution.dynamics
    assert dynamics is not None
    assert dynamics.with_multipliers is not None
    return dynamics.with_multipliers


def test_the_rolling_disc_by_newton_and_euler() -> None:
    """Equation by equation, λ included, with what is written out in i, j, k from R' Rᵀ."""
    x, y, phi, theta, psi = moving("x y phi theta psi")
    m, R, A, C, g = constants("m R A C g")
    turned = rotation("z", phi) * rotation("x", theta) * rotation("z", psi)
    disc = Rigid(m, (x, y, R * sp.sin(theta)), turned, (A, A, C), force=(0, 0, -m * g))
    arm = rotation("z", phi) * rotation("x", theta) * sp.Matrix([0, -R, 0])
    slip = sp.diff(sp.Matrix(disc.at), t) + disc.omega.cross(arm)
    kinematic = {"1": slip[0], "2": slip[1]}
    route = newton_euler("x y phi theta psi", [disc], kinematic=kinematic)
    solution = solve(load(PROBLEMS / "motion" / "rolling-disc.yaml"))
    found = with_multipliers(solution)
    known = {s.name: s for pair in found.equations for e in pair for s in e.free_symbols}
    known |= {f"lambda_{n}": s for n, s in zip("12", found.multipliers, strict=True)}
    for (left, right), other in zip(found.equations, route.equations, strict=True):
        theirs = slots(other.doit())
        theirs = theirs.xreplace({s: known.get(s.name, sp.Symbol(s.name, real=True)) for s in theirs.free_symbols})
        assert is_zero(left - right - theirs) is True
        assert is_zero(left + right - theirs) is not (right != 0)


CARRIED = """
title: A skate that is pulled, on a floor
parameters: [m, I, a, F]
coordinates: [x, y, z, theta]
bodies: {B: {mass: m, inertia: I, position: x*i + y*j + z*k + a*e1_B, angle: theta}}
constraints:
  floor: z = 0
  blade: "y'*cos(theta) = x'*sin(theta)"
forces: {pull: {on: B, vector: F*i}}
generalized_coordinates:
  flat: {coordinates: [x, y, theta]}
  own: {coordinates: [X, Y, theta], substitute: {x: X*cos(theta) - Y*sin(theta), y: X*sin(theta) + Y*cos(theta), z: "0"}}
"""


def test_a_choice_keeps_the_multiplier_of_the_constraint_that_it_keeps(problem: Read) -> None:
    solution = solve(problem(CARRIED))
    assert solution.holds
    assert [s.name for s in with_multipliers(solution).multipliers] == ["lambda_floor", "lambda_blade"]
    flat = with_multipliers(solution, "flat")
    [blade] = flat.multipliers
    x, y, theta = sp.symbols("x y theta", real=True)
    m, inertia, a, pull = sp.symbols("m I a F", positive=True)
    sin, cos = sp.sin(theta), sp.cos(theta)
    ax, ay, alpha, w = prime(x, 2), prime(y, 2), prime(theta, 2), prime(theta)
    by_hand = (
        m * (ax - a * alpha * sin - a * w**2 * cos) - pull + blade * sin,
        m * (ay + a * alpha * cos - a * w**2 * sin) - blade * cos,
        inertia * alpha + m * a * (ay * cos - ax * sin + a * alpha) + pull * a * sin,
    )
    assert [is_zero(left - right - e) for (left, right), e in zip(flat.equations, by_hand, strict=True)] == [True] * 3


def shown(result: Report) -> str:
    lines = [e for s in as_object(result)["steps"] for b in s["body"] for e in b.get("equations", ())]
    return " ".join(e.get("label", "") for e in lines)


def test_they_are_printed_where_they_are_not_newtons_equations(problem: Read) -> None:
    printed = shown(report(problem(CARRIED)))
    assert "multiplied-theta" not in printed  # the list of free bodies has them
    assert "multiplied-flat-theta" in printed
    assert "multiplied-own-X" in printed
    particle = report(load(PROBLEMS / "chapter6" / "ex11-ideal-pendulum.yaml"))
    assert "multiplied" not in shown(particle)
    assert as_object(particle)["equations_with_multipliers"] == [
        "m*x'' = 2*x*lambda_rod",
        "m*y'' - m*g = 2*y*lambda_rod",
    ]
    assert "equations_with_multipliers" not in as_object(particle)["choices"][0]


def test_in_json_each_system_with_constraints_has_them_and_they_are_right(problem: Read) -> None:
    result = report(problem(CARRIED))
    found = as_object(result)
    reference = reference_of_solution(result.solution)
    for system in (found, *found["choices"]):
        texts = system["equations_with_multipliers"]
        assert check_equations([Fragment.of(e) for e in texts], reference).verdict is Verdict.EQUIVALENT
        n = next(n for n, e in enumerate(texts) if "lambda_blade" in e)
        wrong = [*texts[:n], texts[n].replace("lambda_blade", "(-lambda_blade)"), *texts[n + 1 :]]
        assert check_equations([Fragment.of(e) for e in wrong], reference).verdict is not Verdict.EQUIVALENT


def test_conditions_are_the_pivots_and_what_was_divided_by(problem: Read) -> None:
    found = as_object(report(problem(CARRIED)))
    assert found["conditions"] == ["cos(theta) ≠ 0"]
    text = """
title: Planar motion
parameters: [m]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
"""
    assert as_object(report(problem(text)))["conditions"] == ["r ≠ 0"]
    assert as_object(report(problem(text.replace("r*e_r", "r*i + phi*j"))))["conditions"] == []
