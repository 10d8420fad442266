"""Quasi-velocities: the kinematic equations, d'Alembert's principle in them, their refusals, answers that use them.

The equations of motion are compared with SymPy's KanesMethod, which has generalized speeds of its own.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.answers.equations import Verdict, check_equations
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment, NotCoveredError, ProblemError
from lagrange.core.symbols import prime
from lagrange.document.math_writer import text
from lagrange.explain.report import report
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from tests.support.quasi_velocities import SLED, equations_of, speeds_of, written
from tests.support.shared import reported, solved

Read = Callable[[str], Problem]


# -- what books print ------------------------------------------------------------------------------------------------


def test_the_sleigh_in_speed_and_rate_of_turning() -> None:
    solution = solved("sleigh")
    assert written(solution) == ["u' - a*omega^2 = 0", "(m*a^2 + I_G)*omega' + m*a*u*omega = 0"]
    kinematic = {str(v): text(e) for v, e in speeds_of(solution).velocities.kinematic.items()}
    assert kinematic == {"x'": "u*cos(theta)", "y'": "u*sin(theta)", "theta'": "omega"}
    assert equations_of(solution).conditions == ()


def test_the_rolling_disc_in_its_angular_velocity() -> None:
    solution = solved("rolling-disc")
    assert written(solution) == [
        "(m*R^2 + A)*omega_1' - A*omega_2^2*cot(theta) + (m*R^2 + C)*omega_2*omega_3 + m*g*R*cos(theta) = 0",
        "A*omega_2' + A*omega_1*omega_2*cot(theta) - C*omega_1*omega_3 = 0",
        "(m*R^2 + C)*omega_3' - m*R^2*omega_1*omega_2 = 0",
    ]


def test_the_six_equations_of_an_aircraft() -> None:
    solution = solved("aircraft")
    assert written(solution) == [
        "m*u' - m*v*r + m*w*q + m*g*sin(theta) - F = 0",
        "v' + u*r - w*p - g*cos(theta)*sin(phi) = 0",
        "w' - u*q + v*p - g*cos(theta)*cos(phi) = 0",
        "A*p' - (B - C)*q*r = 0",
        "B*q' + (A - C)*p*r = 0",
        "C*r' - (A - B)*p*q = 0",
    ]
    found = equations_of(solution)
    assert [str(c) for c in found.velocities["plane"].components] == ["u", "v", "w"]
    assert found.rates is not None
    assert found.conditions == (sp.cos(sp.Symbol("theta", real=True)),)


def test_the_angular_momentum_of_a_ball_stays_along_fixed_axes(problem: Read) -> None:
    solution = solve(problem(BALL))
    assert solution.holds
    R, v = sp.Symbol("R", positive=True), sp.Symbol("v", real=True)
    spin = equations_of(solution).spins["ball"]
    assert spin.triad.directions is None
    assert spin.components[0] == -v / R


BALL = """
title: A ball that rolls
parameters: [m, R, I]
coordinates: [x, y, phi, theta, psi]
bodies:
  ball: {mass: m, inertia: [I, I, I], position: x*i + y*j + R*k, orientation: {axes: 313, angles: [phi, theta, psi]}}
constraints: {rolling: "r_ball' + cross(omega_ball, -R*k) = 0"}
speeds: {u: x', v: y', w: "dot(omega_ball, k)"}
"""


# -- forms of quasi-velocities ---------------------------------------------------------------------------------------


def test_too_few_are_completed_by_velocities(problem: Read) -> None:
    solution = solve(problem(SLED + "speeds: {u: \"x'*cos(theta) + y'*sin(theta)\"}\n"))
    quasi = speeds_of(solution).velocities
    assert [q.name for q in quasi.completing] == ["theta"]
    assert written(solution) == ["u' - a*theta'^2 = 0", "(m*a^2 + I)*theta'' + m*a*theta'*u = 0"]
    assert solution.holds
    assert as_object(report(solution.problem))["speeds"]["completed_by"] == ["theta"]


def test_terms_without_velocities_and_moving_constraints(problem: Read) -> None:
    sled = """
title: A sled on a moving floe, pulled and braked
parameters: [m, I, a, k, c]
functions: {s: [t]}
coordinates: [x, y, theta]
bodies: {B: {mass: m, inertia: I, position: x*i + y*j + a*e1_B, angle: theta}}
constraints: {blade: "(x' - s')*sin(theta) - y'*cos(theta) = a*t"}
forces:
  spring: {spring: k, between: [B, 0*i]}
  brake: {damper: c, between: [B, a*j]}
  push: {on: B, vector: "m*a*e2_B - c*r_B'", at: x*i + y*j}
  motor: {on: B, moment: k*t*e_z}
speeds: {u: "(x' - s')*cos(theta) + y'*sin(theta) + t*x", w: theta' - t}
"""
    solution = solve(problem(sled))
    assert solution.holds
    quasi = speeds_of(solution).velocities
    assert any(quasi.drift)
    assert "s''" in " ".join(written(solution))


def test_in_choices_of_coordinates(problem: Read) -> None:
    pendulum = """
title: A spherical pendulum
parameters: [m, l, g]
coordinates: [x, y, z]
particles: {P: {mass: m, position: "[x, y, z]"}}
constraints: {rod: x^2 + y^2 + z^2 = l^2}
gravity: -g*k
speeds: {h: "x*y' - y*x'", w: z'}
generalized_coordinates:
  angles:
    coordinates: [theta, phi]
    substitute: {x: l*sin(theta)*cos(phi), y: l*sin(theta)*sin(phi), z: l*cos(theta)}
  flat: {coordinates: [x, y]}
"""
    solution = solve(problem(pendulum))
    assert solution.holds
    assert solution.own.in_speeds is None  # the choices have no constraint left
    angles, flat = solution.choices
    assert angles.in_speeds is not None
    assert flat.in_speeds is not None
    theta, l = sp.Symbol("theta", real=True), sp.Symbol("l", positive=True)
    h = sp.Symbol("h", real=True)
    assert angles.in_speeds.velocities.kinematic[sp.Symbol("phi'", real=True)] == h / (l**2 * sp.sin(theta) ** 2)
    assert angles.in_speeds.equations is not None
    assert prime(h) in angles.in_speeds.equations.expressions
    alone = solve(problem(pendulum.split("generalized")[0]))
    assert alone.holds
    assert alone.own.in_speeds is not None


def test_without_motion_there_are_the_kinematic_equations(problem: Read) -> None:
    solution = solve(problem(SLED + "find: constraints\nspeeds: {u: \"x'*cos(theta) + y'*sin(theta)\"}\n"))
    assert speeds_of(solution).equations is None
    assert solution.holds
    titles = [s.title for s in report(solution.problem).derivation.steps]
    assert "Quasi-velocity" in titles


# -- refusals --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("speeds", "names", "said"),
    [
        ("{u: x', v: y', w: theta'}", "`v`", "3 quasi-velocities, and 2 degrees of freedom"),
        ("{u: \"x'*sin(theta) - y'*cos(theta)\"}", "`u` is fixed by the constraints", "leave it out"),
        ("{u: theta', v: 2*theta'}", "`v`", "leave it out"),
        ("{u: \"x'*cos(theta)^2 + x'*sin(theta)^2 - x'\"}", "`u` is fixed", "leave it out"),
    ],
)
def test_dependent_ones_are_refused_by_name(problem: Read, speeds: str, names: str, said: str) -> None:
    with pytest.raises(ProblemError) as caught:
        solve(problem(f"{SLED}speeds: {speeds}\n"))
    [found] = caught.value.diagnostics
    assert found.code == "dependent-speeds"
    assert names in found.message
    assert said in (found.help or "")
    assert found.span is not None


@pytest.mark.parametrize("speed", ["x'^2", "x'*y'", "sqrt(x'^2 + y'^2)", "abs(x')", "1/x'"])
def test_what_is_not_linear_is_refused(problem: Read, speed: str) -> None:
    with pytest.raises(ProblemError) as caught:
        problem(f'{SLED}speeds: {{u: "{speed}"}}\n')
    codes = {d.code for d in caught.value.diagnostics}
    assert codes <= {"speed-not-linear", "undecided"}
    assert codes


def test_a_name_means_one_thing(problem: Read) -> None:
    for name in ("m", "x"):
        with pytest.raises(ProblemError, match="is "):
            problem(f"{SLED}speeds: {{{name}: theta'}}\n")


@pytest.mark.parametrize("size", [4, 6])
def test_what_would_fill_pages_is_given_up(problem: Read, size: int) -> None:
    """An inverse of a matrix of symbols has n! terms in every denominator."""
    names = [[f"c{i}{j}" for j in range(size)] for i in range(size)]
    speeds = {f"u{i}": " + ".join(f"{c}*q{j}'" for j, c in enumerate(row)) for i, row in enumerate(names)}
    text = f"""
title: Many
parameters: [m, {", ".join(c for row in names for c in row)}]
coordinates: [{", ".join(f"q{j}" for j in range(size))}]
particles: {{{", ".join(f"P{j}: {{mass: m, position: q{j}*i}}" for j in range(size))}}}
speeds: {{{", ".join(f'{u}: "{e}"' for u, e in speeds.items())}}}
"""
    with pytest.raises(NotCoveredError, match="pages"):
        solve(problem(text))


def test_beside_a_constraint_that_is_not_linear(problem: Read) -> None:
    text = """
title: T
parameters: [m, a]
coordinates: [x, y, z]
particles: {P: {mass: m, position: "[x, y, z]"}}
constraints: {c: "x'^2 + y'^2 = a^2*z'^2"}
speeds: {u: x'}
"""
    with pytest.raises(NotCoveredError):
        solve(problem(text))


# -- answers ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("equations", "verdict"),
    [
        (["u' = a*omega^2", "(I_G + m*a^2)*omega' = -m*a*u*omega"], Verdict.EQUIVALENT),
        (["u' = a*theta'^2", "(I_G + m*a^2)*theta'' = -m*a*u*theta'", "x' = u*cos(theta)"], Verdict.EQUIVALENT),
        (["x''*cos(theta) + y''*sin(theta) = a*omega^2", "(I_G + m*a^2)*omega' + m*a*u*omega = 0"], Verdict.EQUIVALENT),
        (["u' = -a*omega^2", "(I_G + m*a^2)*omega' = -m*a*u*omega"], Verdict.WRONG),
        (["u' = a*omega^2"], Verdict.INCOMPLETE),
        (["omega = theta'"], Verdict.TRIVIAL),
        (["u' = a*omega^2", "v' = 0"], Verdict.UNREADABLE),
    ],
)
def test_answers_in_quasi_velocities(equations: list[str], verdict: Verdict) -> None:
    reference = reference_of_solution(solved("sleigh"))
    assert check_equations([Fragment.of(e) for e in equations], reference).verdict is verdict


def test_what_is_printed_is_right() -> None:
    """The vectors in quasi-velocities are the velocities and accelerations where the constraints hold."""
    result = reported("two-wheeled-carriage")
    assert result.holds
    found = as_object(result)["speeds"]
    reference = reference_of_solution(result.solution)
    assert check_equations([Fragment.of(e) for e in found["equations"]], reference).verdict is Verdict.EQUIVALENT
    solved = [f"{u}' = {value}" for u, value in found["rates"].items()]
    assert check_equations([Fragment.of(e) for e in solved], reference).verdict is Verdict.EQUIVALENT
    kinematic = [f"{q}' = {value}" for q, value in found["kinematic"].items()]
    assert check_equations([Fragment.of(e) for e in kinematic], reference).verdict is Verdict.INCOMPLETE
    wrong = [e.replace("- b*omega", "- 2*b*omega") for e in kinematic]
    assert wrong != kinematic
    assert check_equations([Fragment.of(e) for e in wrong], reference).verdict is Verdict.WRONG


def test_definitions_are_read_short(problem: Read) -> None:
    """The components of ω along the axes, multiplied out by the file, are what Euler's kinematic equations have."""
    text_ = """
title: Suslov
parameters: {A: positive, C: positive, delta_0: real}
coordinates: [phi, theta, psi]
bodies: {top: {inertia: [A, A, C], position: "[0, 0, 0]", orientation: {axes: 313, angles: [phi, theta, psi]}}}
constraints: {no_spin: "dot(omega_top, sin(delta_0)*e1_top + cos(delta_0)*e3_top) = 0"}
speeds: {u: "dot(omega_top, cos(delta_0)*e1_top - sin(delta_0)*e3_top)", q: "dot(omega_top, e2_top)"}
"""
    u, q = problem(text_).speeds
    assert u.definition.count_ops() < 20
    assert str(q.definition) == "phi'*sin(theta)*cos(psi) - theta'*sin(psi)"
