"""Possible and virtual displacements: what moving constraints add, dq = δq + w dt."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.explain.report import report
from lagrange.mechanics.solution import solve

x, y, z, s, r, theta, t = sp.symbols("x y z s r theta t", real=True)
omega, v, a, b, m = sp.symbols("omega v a b m", positive=True)


# title: (problem, w in the order of the coordinates)
CARRIED = {
    "the surface of Ex. 9 moves along i": (
        "parameters: {u: real, c: real}\ncoordinates: [x, y, z]\nfunctions: {f: [X, Y, Z]}\n"
        "constraints: {surface: 'f(x - u*t, y, z) = c'}",
        (sp.Symbol("u", real=True), 0, 0),
    ),
    "a wire that is raised": (
        "parameters: [a, v]\ncoordinates: [x, y]\nconstraints: {wire: y = a*x^2 + v*t}",
        (0, v),
    ),
    "a driven length": (
        "parameters: [a, b, omega]\ncoordinates: [r, theta]\nconstraints: {length: r = a + b*cos(omega*t)}",
        (-b * omega * sp.sin(omega * t), 0),
    ),
    "a skate on ice that moves, and a turn": (
        "parameters: [v, omega]\ncoordinates: [x, y, theta]\n"
        "constraints: {blade: (x' - v)*sin(theta) = y'*cos(theta), turn: theta' = omega}",
        (v, 0, omega),
    ),
    "prescribed by u(t)": (
        "coordinates: [x, y]\nfunctions: {u: [t]}\nconstraints: {point: x = u}",
        (sp.Symbol("u'", real=True), 0),
    ),
    "nothing moves": ("parameters: [a]\ncoordinates: [x, y]\nconstraints: {circle: x^2 + y^2 = a^2}", (0, 0)),
}


@pytest.mark.parametrize(("text", "expected"), CARRIED.values(), ids=CARRIED.keys())
def test_the_simplest_motion_that_the_constraints_force(problem, text, expected):
    solution = solve(problem(f"title: A problem\n{text}"))
    assert solution.transport_rates == tuple(map(sp.sympify, expected))


@pytest.mark.parametrize(("text", "expected"), CARRIED.values(), ids=CARRIED.keys())
def test_it_satisfies_the_constraints(problem, text, expected):
    """By substitution into f: along q(t) = q_0 + w t, to first order, f stays what it is."""
    del expected
    solution = solve(problem(f"title: A problem\n{text}"))
    slots = solution.problem.slots
    rule = dict(zip(slots.velocities, solution.transport_rates, strict=True))
    for constraint in solution.problem.constraints:
        f = constraint.function
        rate = f if constraint.kinematic else slots.time_derivative(f)
        assert is_zero(rate.xreplace(rule))


def written(problem, text: str) -> str:
    steps = report(problem(f"title: A problem\n{text}")).derivation.steps
    [step] = [s for s in steps if s.rule == "displacements"]
    return str(step)


TURNING_WIRE = "parameters: [m, omega]\ncoordinates: [s]\nparticles: {P: {mass: m, position: '[s*cos(omega*t), 0]'}}"


def test_a_position_that_contains_t_is_said_to_move(problem):
    assert "a possible displacement has a part besides the virtual one" in written(problem, TURNING_WIRE)
    assert "besides the virtual one" not in written(problem, TURNING_WIRE.replace("omega*t", "omega"))


def test_possible_and_virtual_are_called_the_same_only_where_they_are(problem):
    for text, carried in CARRIED.values():
        same = "possible and virtual displacements are the same" in written(problem, text)
        assert same is not any(carried)


def test_a_surface_has_a_normal_and_dr_is_tangent_to_it_where_it_stands(problem):
    """Ex. 8 and 9: dr·∇f = u ∂f/∂X dt and δr·∇f = 0, the vectors put in by components."""
    text = "coordinates: [x, y, z]\nfunctions: {f: [X, Y, Z]}\nparticles: {P: {position: '[x, y, z]'}}\n"
    for constraint, drift in (("f(x, y, z) = c", 0), ("f(x - u*t, y, z) = c", sp.Symbol("u", real=True))):
        found = problem(f"title: A problem\n{text}parameters: {{u: real, c: real}}\nconstraints: {{s: '{constraint}'}}")
        solution = solve(found)
        [normal] = solution.normals
        [row] = solution.classification.rows
        assert normal.gradient.fixed().components == row.coefficients
        assert is_zero(row.drift + drift * row.coefficients[0])
        steps = report(found).derivation.steps
        [step] = [s for s in steps if s.rule == "displacements"]
        assert ("tangent to it as it is at that time" in str(step)) is (drift != 0)


@pytest.mark.parametrize(
    "text",
    [
        "coordinates: [x, y, theta]\nparticles: {P: {position: '[x, y]'}}\nconstraints: {s: x = sin(theta)}",
        "coordinates: [x, y]\nparticles: {P: {position: x*i}, Q: {position: y*i}}\nconstraints: {s: x = y}",
        "coordinates: [x, y]\nparticles: {P: {position: '[x, y]'}}\nconstraints: {s: x' = y*y'}",
    ],
    ids=["another coordinate", "two particles", "velocities"],
)
def test_what_binds_more_than_one_particle_has_no_normal(problem, text):
    assert solve(problem(f"title: A problem\nfind: constraints\n{text}")).normals == ()


PLATE = """title: plate on two hinges and a cable
parameters: [W, a, b, h]
coordinates: [x, y, z, alpha, beta, gamma]
bodies: {plate: {position: "[x, y, z]", orientation: {axes: 123, angles: [alpha, beta, gamma]}}}
let:
  p_A: r_plate - a/2*e1_plate - b/2*e2_plate
  p_B: r_plate + a/2*e1_plate - b/2*e2_plate
  p_C: r_plate + a/2*e1_plate + b/2*e2_plate
constraints:
  A_x: "dot(p_A, i) = 0"
  A_y: "dot(p_A, j) = 0"
  A_z: "dot(p_A, k) = 0"
  B_y: "dot(p_B, j) = 0"
  B_z: "dot(p_B, k) = 0"
  cable: norm(p_C - h*k) = sqrt(a^2 + b^2 + h^2)
find: constraints
"""


def test_what_is_held_altogether_has_no_displacement_however_long_its_forms(problem):
    """The edge AB lies on the x axis, the cable stops the turning about it: six constraints, six coordinates."""
    solution = solve(problem(PLATE))
    elimination = solution.own.elimination
    assert solution.classification.degrees_of_freedom == 0
    assert elimination.is_closed
    assert elimination.independent == ()
    assert elimination.solution == ((),) * 6
