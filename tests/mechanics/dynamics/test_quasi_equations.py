"""Equations of motion in quasi-velocities, against Kane and the literature."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import sympy as sp
from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, RigidBody, Vector, dynamicsymbols, inertia

from lagrange.algebra.exact.zero_test import rank
from lagrange.core.symbols import prime
from lagrange.mechanics.dynamics.quasi_equations import check_speeds
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from tests.support.quasi_velocities import SLED, equations_of, speeds_of, written
from tests.support.shared import solved

Read = Callable[[str], Problem]


def test_eulers_equations_come_out_without_angles() -> None:
    solution = solved("euler-rigid-body")
    assert written(solution) == [
        "A*p' - (B - C)*q*r = 0",
        "B*q' + (A - C)*p*r = 0",
        "C*r' - (A - B)*p*q = 0",
    ]
    theta = sp.Symbol("theta", real=True)
    assert equations_of(solution).conditions == (sp.sin(theta),)
    assert solution.holds


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
    assert agree(solved("rolling-disc"), list(fr + frstar), named(angles, u))


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
