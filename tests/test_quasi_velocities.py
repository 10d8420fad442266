"""Quasi-velocities: the kinematic equations, d'Alembert's principle in them, their refusals, answers that use them.

The equations of motion are compared with SymPy's KanesMethod, which has generalized speeds of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import pytest
import sympy as sp
from conftest import PROBLEMS
from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, RigidBody, Vector, dynamicsymbols, inertia

from lagrange.algebra.exact.exact import rank
from lagrange.answers.equations import Verdict, check_equations
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment, NotCoveredError, ProblemError
from lagrange.core.symbols import prime
from lagrange.document.math_writer import text
from lagrange.explain.report import notation_of, report
from lagrange.mechanics.dynamics.quasi_equations import QuasiEquations
from lagrange.mechanics.dynamics.quasi_verification import InSpeeds, check_speeds
from lagrange.mechanics.solution import Solution, solve
from lagrange.problem.loader import load
from lagrange.problem.model import Problem
from lagrange.render.json import as_object

Read = Callable[[str], Problem]

SLED = """
title: A sled
parameters: [m, I, a]
coordinates: [x, y, theta]
bodies: {B: {mass: m, inertia: I, position: x*i + y*j + a*e1_B, angle: theta}}
constraints: {blade: "y'*cos(theta) = x'*sin(theta)"}
"""


def shipped(name: str) -> Solution:
    return solve(load(PROBLEMS / "motion" / f"{name}.yaml"))


def speeds_of(solution: Solution) -> InSpeeds:
    assert solution.in_speeds is not None
    return solution.in_speeds


def equations_of(solution: Solution) -> QuasiEquations:
    found = speeds_of(solution).equations
    assert found is not None
    return found


def written(solution: Solution) -> list[str]:
    notation = notation_of(solution)
    return [f"{text(e, notation)} = 0" for e in equations_of(solution).expressions]


# -- what books print ------------------------------------------------------------------------------------------------


def test_eulers_equations_come_out_without_angles() -> None:
    solution = shipped("euler-rigid-body")
    assert written(solution) == [
        "A*p' - (B - C)*q*r = 0",
        "B*q' + (A - C)*p*r = 0",
        "C*r' - (A - B)*p*q = 0",
    ]
    theta = sp.Symbol("theta", real=True)
    assert equations_of(solution).conditions == (sp.sin(theta),)
    assert solution.holds


def test_the_sleigh_in_speed_and_rate_of_turning() -> None:
    solution = shipped("sleigh")
    assert written(solution) == ["u' - a*omega^2 = 0", "(m*a^2 + I_G)*omega' + m*a*u*omega = 0"]
    kinematic = {str(v): text(e) for v, e in speeds_of(solution).velocities.kinematic.items()}
    assert kinematic == {"x'": "u*cos(theta)", "y'": "u*sin(theta)", "theta'": "omega"}
    assert equations_of(solution).conditions == ()


def test_the_rolling_disc_in_its_angular_velocity() -> None:
    solution = shipped("rolling-disc")
    assert written(solution) == [
        "(m*R^2 + A)*omega_1' - A*omega_2^2*cot(theta) + (m*R^2 + C)*omega_2*omega_3 + m*g*R*cos(theta) = 0",
        "A*omega_2' + A*omega_1*omega_2*cot(theta) - C*omega_1*omega_3 = 0",
        "(m*R^2 + C)*omega_3' - m*R^2*omega_1*omega_2 = 0",
    ]


def test_the_six_equations_of_an_aircraft() -> None:
    solution = shipped("aircraft")
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


# -- the second route ------------------------------------------------------------------------------------------------


def agree(solution: Solution, equations: Sequence[sp.Expr], names: Mapping[sp.Basic, str]) -> bool:
    """Whether equations in generalized speeds have the same solutions for their rates: exactly, by the rank."""
    ours = equations_of(solution)
    known = {s.name: s for e in ours.expressions for s in e.free_symbols}
    rule = {old: known.get(name, sp.Symbol(name, real=True)) for old, name in names.items()}
    plain = [e.xreplace(rule) for e in equations]
    plain = [e.xreplace({s: known[s.name] for s in e.free_symbols if s.name in known}) for e in plain]
    rates = [prime(u) for u in ours.quasi.definitions]
    assert not any(e.has(sp.Derivative) for e in plain)

    def rows(group: Sequence[sp.Expr]) -> list[list[sp.Expr]]:
        still = dict.fromkeys(rates, sp.S.Zero)
        return [[*(e.diff(r) for r in rates), e.xreplace(still)] for e in group]

    one, other = rows(ours.expressions), rows(plain)
    return rank(one) == rank(other) == rank([*one, *other]) == len(rates)


def named(q: Sequence[sp.Expr], u: Sequence[sp.Expr]) -> dict[sp.Basic, str]:
    t = dynamicsymbols._t
    names: dict[sp.Basic, str] = {f: f.func.__name__ for f in (*q, *u)}
    return names | {sp.diff(f, t): f"{f.func.__name__}'" for f in u}


HEAVY = """
title: A heavy body that turns about a fixed point
parameters: [m, g, A, B, C, a, b, c]
coordinates: [phi, theta, psi]
bodies:
  B:
    mass: m
    inertia: [A, B, C]
    position: a*e1_B + b*e2_B + c*e3_B
    orientation: {axes: 313, angles: [phi, theta, psi]}
gravity: -g*k
speeds: {p: "dot(omega_B, e1_B)", q: "dot(omega_B, e2_B)", r: "dot(omega_B, e3_B)"}
"""


def test_a_heavy_body_against_kane(problem: Read) -> None:
    angles, u = dynamicsymbols("phi theta psi"), dynamicsymbols("p q r")
    m, g, A, B, C, a, b, c = sp.symbols("m g A B C a b c", positive=True)
    frame, origin = ReferenceFrame("N"), Point("O")
    origin.set_vel(frame, 0)
    own = frame.orientnew("B", "Body", angles, "313")
    turning = own.ang_vel_in(frame)
    kinematic = [turning.dot(e) - s for e, s in zip(own, u, strict=True)]
    own.set_ang_vel(frame, sum((s * e for e, s in zip(own, u, strict=True)), Vector(0)))
    centre = origin.locatenew("G", a * own.x + b * own.y + c * own.z)
    centre.v2pt_theory(origin, frame, own)
    body = RigidBody("body", centre, own, m, (inertia(own, A, B, C), centre))
    method = KanesMethod(frame, list(angles), list(u), kinematic)
    fr, frstar = method.kanes_equations([body], [(centre, -m * g * frame.z)])
    solution = solve(problem(HEAVY))
    assert solution.holds
    theirs = list(fr + frstar)
    assert agree(solution, theirs, named(angles, u))
    assert not agree(solution, [theirs[0] + m * u[0] * u[1], *theirs[1:]], named(angles, u))


def test_the_sled_against_kane(problem: Read) -> None:
    (x, y, theta), (u, w, side) = dynamicsymbols("x y theta"), dynamicsymbols("u w side")
    m, moment, a = sp.symbols("m I a", positive=True)
    t = dynamicsymbols._t
    frame, origin = ReferenceFrame("N"), Point("O")
    own = frame.orientnew("B", "Axis", [theta, frame.z])
    own.set_ang_vel(frame, w * frame.z)
    origin.set_vel(frame, u * own.x + side * own.y)
    centre = origin.locatenew("G", a * own.x)
    centre.v2pt_theory(origin, frame, own)
    body = RigidBody("body", centre, own, m, (inertia(own, 0, 0, moment), centre))
    kinematic = [
        x.diff(t) - u * sp.cos(theta) + side * sp.sin(theta),
        y.diff(t) - u * sp.sin(theta) - side * sp.cos(theta),
        theta.diff(t) - w,
    ]
    method = KanesMethod(frame, [x, y, theta], [u, w], kinematic, u_dependent=[side], velocity_constraints=[side])
    fr, frstar = method.kanes_equations([body], [])
    theirs = [e.xreplace({side.diff(t): 0, side: 0}) for e in fr + frstar]
    solution = solve(problem(SLED + "speeds: {u: \"x'*cos(theta) + y'*sin(theta)\", w: theta'}\n"))
    assert agree(solution, theirs, named((x, y, theta), (u, w)))


def test_the_rolling_disc_against_kane() -> None:
    angles, u = dynamicsymbols("phi theta psi"), dynamicsymbols("omega_1 omega_2 omega_3")
    m, R, A, C, g = sp.symbols("m R A C g", positive=True)
    t = dynamicsymbols._t
    frame = ReferenceFrame("N")
    lean = frame.orientnew("L", "Body", [angles[0], angles[1], 0], "313")
    lean.set_ang_vel(frame, u[0] * lean.x + u[1] * lean.y + u[1] * sp.cot(angles[1]) * lean.z)
    disc = lean.orientnew("D", "Axis", [angles[2], lean.z])
    disc.set_ang_vel(frame, u[0] * lean.x + u[1] * lean.y + u[2] * lean.z)
    contact = Point("P")
    contact.set_vel(frame, 0)
    centre = contact.locatenew("G", R * lean.y)
    centre.set_vel(frame, disc.ang_vel_in(frame).cross(R * lean.y))
    body = RigidBody("disc", centre, disc, m, (inertia(lean, A, A, C), centre))
    kinematic = [
        angles[0].diff(t) - u[1] / sp.sin(angles[1]),
        angles[1].diff(t) - u[0],
        angles[2].diff(t) - u[2] + u[1] * sp.cot(angles[1]),
    ]
    method = KanesMethod(frame, list(angles), list(u), kinematic)
    fr, frstar = method.kanes_equations([body], [(centre, -m * g * frame.z)])
    assert agree(shipped("rolling-disc"), list(fr + frstar), named(angles, u))


def test_the_check_sees_a_wrong_equation_and_wrong_velocities(problem: Read) -> None:
    loaded = problem(SLED + "speeds: {u: \"x'*cos(theta) + y'*sin(theta)\", w: theta'}\n")
    found = speeds_of(solve(loaded))
    assert [c.passed for c in check_speeds(found, loaded)] == [True, True]
    equations = found.equations
    assert equations is not None
    first, second = equations.equations
    u, w = sp.symbols("u w", real=True)
    bent = replace(equations, equations=(replace(first, expression=first.expression + u * w), second))
    assert [c.passed for c in check_speeds(replace(found, equations=bent), loaded)] == [True, False]
    doubled = replace(found.velocities, partials=tuple(tuple(2 * c for c in r) for r in found.velocities.partials))
    assert check_speeds(replace(found, velocities=doubled), loaded)[0].passed is False


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
    assert solution.in_speeds is None  # the choices have no constraint left
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
    assert alone.in_speeds is not None


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
    reference = reference_of_solution(shipped("sleigh"))
    assert check_equations([Fragment.of(e) for e in equations], reference).verdict is verdict


def test_what_is_printed_is_right() -> None:
    """The vectors in quasi-velocities are the velocities and accelerations where the constraints hold."""
    result = report(load(PROBLEMS / "motion" / "two-wheeled-carriage.yaml"))
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
