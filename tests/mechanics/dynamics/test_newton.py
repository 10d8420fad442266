"""Newton's law with reactions: their directions, what they are, the count of unknowns, their work."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.displacements import eliminate
from lagrange.mechanics.dynamics.checks import multiplier_system
from lagrange.mechanics.dynamics.comparison import compare
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.newton import works_of_reactions
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from tests.support.shared import asking, solved

Read = Callable[[str], Problem]

x, y, z, u, v, X = sp.symbols("x y z u v X", real=True)
l, m, g = sp.symbols("l m g", positive=True)


def solution(problem: Read, text: str) -> Solution:
    return solve(problem(f"title: Example\n{text}"))


def one_particle(problem: Read, constraint: str, more: str = "") -> Solution:
    text = "parameters: [m, l, g, a, b]\ncoordinates: [x, y, z]\nparticles: {P: {mass: m, position: '[x, y, z]'}}\n"
    return solution(problem, f"{text}functions: {{w: [t]}}\nconstraints: {{c: {{equation: '{constraint}'{more}}}}}\n")


def same(vector: Vector | None, *components: sp.Expr) -> bool:
    assert vector is not None
    return all(is_zero(a - b) is True for a, b in zip(vector.fixed().components, components, strict=True))


def left_sides(problem: Read, coordinates: str, position: str, constraint: str) -> list[sp.Expr]:
    found = solution(
        problem,
        f"parameters: [m, a]\ncoordinates: {coordinates}\nparticles: {{P: {{mass: m, position: '{position}'}}}}\n"
        f'constraints: {{c: "{constraint}"}}\n',
    )
    return [left for left, _ in found.law.newton.equations]


def test_the_law_along_circles_of_latitude_has_no_magnitude(problem: Read) -> None:
    """Along ∂r/∂φ, of length a |sin θ|, whose sense is free."""
    _, along = left_sides(
        problem,
        "[theta, phi]",
        "[a*sin(theta)*cos(phi), a*sin(theta)*sin(phi), a*cos(theta)]",
        "sin(theta) = a*phi",
    )
    theta, theta_rate, rate, second = sp.symbols("theta theta' phi' phi''", real=True)
    a = sp.Symbol("a", positive=True)
    assert along == m * (a * second * sp.sin(theta) + 2 * a * theta_rate * rate * sp.cos(theta))


@pytest.mark.parametrize(
    ("position", "expected"),
    [
        ("[a*(phi + sin(phi)), a*(1 - cos(phi)), 0]", lambda c, s, u, w: 2 * w * c - u**2 * s),
        ("[a*(phi - sin(phi)), a*(1 - cos(phi)), 0]", lambda c, s, u, w: 2 * w * s + u**2 * c),
    ],
)
def test_the_law_along_a_cycloid_has_no_root(problem: Read, position: str, expected: Callable[..., sp.Expr]) -> None:
    phi, rate, second = sp.symbols("phi phi' phi''", real=True)
    a = sp.Symbol("a", positive=True)
    along, _ = left_sides(problem, "[phi, s]", position, "s = a*sin(phi/2)")
    assert sp.expand(along - m * a * expected(sp.cos(phi / 2), sp.sin(phi / 2), rate, second)) == 0


# -- directions --------------------------------------------------------------------------------------------------------


def test_direction_in_cartesian_coordinates_is_the_gradient(problem: Read) -> None:
    [reaction] = one_particle(problem, "x^2*y + z = 1").law.newton.reactions
    assert same(reaction.on("P"), 2 * x * y, x**2, sp.S.One)


def test_direction_with_skew_coordinates(problem: Read) -> None:
    """r = (u + v) i + (u − 2v) j: u = (2X + Y)/3, v = (X − Y)/3, so that u v has the gradient by X and Y below."""
    found = solution(
        problem,
        "parameters: [m]\ncoordinates: [u, v]\nparticles: {P: {mass: m, position: '[u + v, u - 2*v]'}}\n"
        "constraints: {c: u*v = 1}\n",
    )
    a, b = u + v, u - 2 * v  # X and Y
    [reaction] = found.law.newton.reactions
    assert same(reaction.on("P"), (4 * a - b) / 9, (-a - 2 * b) / 9, sp.S.Zero)


def test_direction_in_spherical_coordinates(problem: Read) -> None:
    found = solution(
        problem,
        "parameters: [m, l]\ncoordinates: [r, theta, phi]\nframe: {type: spherical, coordinates: [r, theta, phi]}\n"
        "particles: {P: {mass: m, position: r*e_r}}\nconstraints: {a: r = l, b: phi = theta}\n",
    )
    r, theta = sp.symbols("r theta", real=True)
    rod, spiral = found.law.newton.reactions
    assert rod.on("P").components == (1, 0, 0)
    assert [
        is_zero(c - e) for c, e in zip(spiral.on("P").components, (0, -1 / r, 1 / (r * sp.sin(theta))), strict=True)
    ] == [True] * 3


def test_direction_with_relative_coordinates(problem: Read) -> None:
    """r2 = r1 + (u, v): the rod u² + v² = l² acts on both, oppositely."""
    found = solution(
        problem,
        "parameters: [m, l]\ncoordinates: [x, y, u, v]\n"
        "particles: {A: {mass: m, position: '[x, y]'}, B: {mass: m, position: 'r_A + u*i + v*j'}}\n"
        "constraints: {rod: u^2 + v^2 = l^2}\n",
    )
    [reaction] = found.law.newton.reactions
    assert same(reaction.on("A"), -2 * u, -2 * v, sp.S.Zero)
    assert same(reaction.on("B"), 2 * u, 2 * v, sp.S.Zero)
    assert reaction.rod.ends == ("A", "B")


def test_a_rod_pulls_along_itself_where_coordinates_bear_a_part_of_it(problem: Read) -> None:
    """A runs on the x axis, B on the y axis: the form knows 2x and 2y, the rod is along (x, −y)."""
    found = solution(
        problem,
        "parameters: [m, l]\ncoordinates: [x, y]\n"
        "particles: {A: {mass: m, position: x*i}, B: {mass: m, position: y*j}}\nconstraints: {rod: x^2 + y^2 = l^2}\n",
    )
    [reaction] = found.law.newton.reactions
    assert same(reaction.on("A"), 2 * x, -2 * y, sp.S.Zero)
    assert same(reaction.on("B"), -2 * x, 2 * y, sp.S.Zero)
    assert [c.right for b in found.law.newton.bodies for c in b.components] == [
        2 * x * reaction.multiplier,
        2 * y * reaction.multiplier,
    ]


def test_a_coordinate_that_moves_no_particle(problem: Read) -> None:
    """A massless wheel: 0 = −R λ for its angle."""
    found = solution(
        problem,
        "parameters: [m, R, F]\ncoordinates: [x, phi]\nparticles: {P: {mass: m, position: x*i}}\n"
        "forces: {push: {on: P, vector: F*i}}\nconstraints: {roll: x' = R*phi'}\n",
    )
    newton = found.law.newton
    [reaction] = newton.reactions
    radius = sp.Symbol("R", positive=True)
    assert newton.idle == {sp.Symbol("phi", real=True): -radius * reaction.multiplier}
    assert found.own.dynamics.reactions.multipliers == {"roll": 0}


def test_forces_on_a_coordinate_that_moves_no_particle(problem: Read) -> None:
    """An actuator and a spring in a leg of length s: 0 = F − K s + λ a_s."""
    found = solution(
        problem,
        "parameters: [m, F, K]\ncoordinates: [x, y, s]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
        "forces: {push: {generalized: {s: F}}, spring: {potential: K*s^2/2}}\nconstraints: {leg: x^2 + y^2 = s^2}\n",
    )
    F, K, s = sp.Symbol("F", positive=True), sp.Symbol("K", positive=True), sp.Symbol("s", real=True)
    [(idle, right)] = found.law.newton.idle.items()
    [reaction] = found.law.newton.reactions
    assert idle == s
    assert sp.expand(right - (F - K * s - 2 * s * reaction.multiplier)) == 0


# -- what a reaction is ------------------------------------------------------------------------------------------------


def test_the_name_of_a_reaction_is_a_force(problem: Read) -> None:
    [named] = one_particle(problem, "x^2 + y^2 + z^2 = l^2", ", reaction: T").law.newton.reactions
    tension = sp.Symbol("T", real=True)
    assert (named.force, named.multiplier.name, named.per_force) == (tension, "lambda_c", -1 / (2 * l))
    assert same(named.per_unit("P"), -x / l, -y / l, -z / l)
    [unnamed] = one_particle(problem, "x^2 + y^2 + z^2 = l^2").law.newton.reactions
    assert (unnamed.force.name, unnamed.tension.name) == ("lambda_c", "T_c")
    [surface] = one_particle(problem, "z = x*y", ", reaction: N").law.newton.reactions
    assert (surface.force.name, surface.multiplier.name) == ("N", "lambda_c")
    size = sp.sqrt(x**2 + y**2 + 1)
    assert same(surface.per_unit("P"), -y / size, -x / size, 1 / size)
    [plane] = one_particle(problem, "z = 0", ", reaction: N").law.newton.reactions
    assert plane.force == plane.multiplier == sp.Symbol("N", real=True)


# -- counting ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("constraints", "before", "after"),
    [
        ("a: z = 0", (6, 4), (4, 4)),
        ("a: z = 0, b: x = y", (6, 5), (5, 5)),
        ("a: z = 0, b: 2*z = 0", (6, 4), (5, 4)),
        ("a: \"z' = x*y'\"", (6, 4), (4, 4)),
    ],
    ids=["surface", "line", "redundant", "kinematic"],
)
def test_unknowns_and_equations(
    problem: Read, constraints: str, before: tuple[int, int], after: tuple[int, int]
) -> None:
    found = solution(
        problem,
        "parameters: [m]\ncoordinates: [x, y, z]\nparticles: {P: {mass: m, position: '[x, y, z]'}}\n"
        f"constraints: {{{constraints}}}\n",
    )
    newton = found.law.newton
    assert (newton.before.unknowns, newton.before.equations) == before
    assert (newton.after.unknowns, newton.after.equations) == after
    assert newton.before.missing == found.classification.degrees_of_freedom


def test_a_particle_without_reaction_adds_no_unknown_components(problem: Read) -> None:
    found = solution(
        problem,
        "parameters: [m]\ncoordinates: [x, y, u, v]\n"
        "particles: {A: {mass: m, position: '[x, y]'}, B: {mass: m, position: '[u, v]'}}\nconstraints: {a: x = y}\n",
    )
    assert (found.law.newton.before.unknowns, found.law.newton.before.equations) == (6, 5)


# -- work --------------------------------------------------------------------------------------------------------------


DUMBBELL = """parameters: [m, l]
coordinates: [x, y, u, v]
particles: {A: {mass: m, position: '[x, y]'}, B: {mass: m, position: '[u, v]'}}
constraints: {rod: (x - u)^2 + (y - v)^2 = l^2}
"""


def test_a_rod_works_on_each_end_and_not_on_both(problem: Read) -> None:
    [work] = solution(problem, DUMBBELL).works
    assert work.vanishes is True
    assert set(work.working) == {"A", "B"}


def test_a_reaction_in_another_direction_is_found_to_work(problem: Read) -> None:
    """The test for zero is one: with a reaction that is turned, it says no."""
    found = solution(problem, DUMBBELL)
    configuration = found.own.configuration
    elimination = eliminate(configuration.rows, 4, configuration.surface)
    [reaction] = found.law.newton.reactions
    turned = replace(reaction, directions={"A": Vector((y - v, u - x, sp.S.Zero)), "B": reaction.on("B")})
    [work] = works_of_reactions(replace(found.law.newton, reactions=(turned,)), configuration, elimination)
    assert work.vanishes is False


def test_work_in_a_possible_displacement(problem: Read) -> None:
    """A lift that rises with w(t): R·dr = λ w' dt."""
    [work] = one_particle(problem, "z = w").works
    w, dt = sp.Symbol("w'", real=True), sp.Symbol("d(t)", real=True)
    assert work.vanishes is True
    assert is_zero(work.possible - work.reaction.multiplier * w * dt) is True


def test_work_where_the_position_is_driven_too(problem: Read) -> None:
    """r = (s + w, y) with s = 0: the form has no dt, and still the particle is carried with w'."""
    found = solution(
        problem,
        "parameters: [m]\nfunctions: {w: [t]}\ncoordinates: [x, y]\n"
        "particles: {P: {mass: m, position: '[x + w, y]'}}\nconstraints: {c: x = 0}\n",
    )
    [work] = found.works
    assert work.reaction.row.drift == 0
    w, dt = sp.Symbol("w'", real=True), sp.Symbol("d(t)", real=True)
    assert is_zero(work.possible - work.reaction.multiplier * w * dt) is True


# -- rigid bodies ------------------------------------------------------------------------------------------------------

LADDER = """
parameters: [m, l, I, g]
coordinates: [x, y, theta]
bodies: {rod: {mass: m, inertia: I, position: x*i + y*j, angle: theta}}
constraints:
  floor: {equation: y - l*sin(theta) = 0, reaction: N}
  wall: {equation: x - l*cos(theta) = 0, reaction: W}
gravity: -g*j
forces: {push: {on: rod, vector: F*i, at: r_rod + l*e1_rod}, turn: {on: rod, moment: M*k}}
"""


def test_a_body_has_forces_and_moments(problem: Read) -> None:
    """Euler's laws by hand: the floor pushes N up at the left end, at −l (cos θ, sin θ) from the middle."""
    text = LADDER.replace("[m, l, I, g]", "[m, l, I, g, F, M]")
    newton = solution(problem, text).law.newton
    theta = sp.Symbol("theta", real=True)
    positive = {s: sp.Symbol(s, positive=True) for s in "IFM"}
    normal, wall = (r.multiplier for r in newton.reactions)
    [body] = newton.bodies
    floor = {r.name: h for r, h in body.moments}["floor"]
    assert same(floor, sp.S.Zero, sp.S.Zero, -l * sp.cos(theta))
    right = [c.right for c in body.laws]
    expected = [
        positive["F"] + wall,
        normal - m * g,
        positive["M"] - positive["F"] * l * sp.sin(theta) - normal * l * sp.cos(theta) + wall * l * sp.sin(theta),
    ]
    assert all(is_zero(a - b) is True for a, b in zip(right, expected, strict=True))
    assert [c.inertia for c in body.laws][2] == positive["I"] * sp.Symbol("theta''", real=True)


def test_components_of_a_body_are_counted(problem: Read) -> None:
    newton = solution(problem, LADDER.split("forces:")[0]).law.newton
    assert (newton.before.unknowns, newton.before.equations) == (6, 5)
    assert (newton.after.unknowns, newton.after.equations) == (5, 5)


def test_a_body_in_space(problem: Read) -> None:
    """A sphere on a table, without slip: the force at the contact −R k has the moment −R k × (X i + Y j + Z k)."""
    found = solution(
        problem,
        "parameters: [m, R, I, g]\ncoordinates: [x, y, z, phi, theta, psi]\n"
        "bodies: {ball: {mass: m, inertia: [I, I, I], position: '[x, y, z]', "
        "orientation: {axes: 313, angles: [phi, theta, psi]}}}\n"
        'constraints: {table: z = R, slip: "r_ball\' + cross(omega_ball, -R*k) = 0"}\ngravity: -g*k\n',
    )
    newton = found.law.newton
    [body] = newton.bodies
    assert len(body.components) == len(body.turning) == 3
    radius = sp.Symbol("R", positive=True)
    for reaction in newton.reactions:
        if reaction.name.startswith("slip"):
            arm = Vector((sp.S.Zero, sp.S.Zero, -radius))
            assert same(
                reaction.moments.get("ball", Vector.zero()) - arm.cross(reaction.directions["ball"].fixed()),
                *[sp.S.Zero] * 3,
            )
    assert all(w.vanishes for w in found.works)
    assert all(c.passed for c in found.checks)


def test_the_moment_of_a_reaction_works(problem: Read) -> None:
    """A disc on a driven axle φ = ω t: the work in a possible displacement is λ ω dt, by its moment alone."""
    found = solution(
        problem,
        "parameters: [m, I, omega]\ncoordinates: [x, phi]\n"
        "bodies: {disc: {mass: m, inertia: I, position: x*i, angle: phi}}\nconstraints: {axle: phi = omega*t}\n",
    )
    [work] = found.works
    assert work.vanishes is True
    [body] = found.law.newton.bodies
    assert body.reactions == ()
    omega, dt = sp.Symbol("omega", positive=True), sp.Symbol("d(t)", real=True)
    assert is_zero(work.possible.diff(dt) - work.reaction.multiplier * omega) is True


@pytest.mark.parametrize("name", asking("motion"))
def test_newtons_laws_are_lagranges_equations_with_multipliers(name: str) -> None:
    """For every shipped problem: the free bodies' equations and Lagrange's have the same solutions."""
    found = solved(name)
    newton, configuration = found.law.newton, found.law.configuration
    if newton.equations is None or found.law.frictions:
        pytest.skip("its coordinates give no free bodies, or there is friction")
    laws = [(a - b).xreplace(newton.single_forces) for a, b in newton.equations]
    multipliers = tuple(r.multiplier for r in newton.reactions)
    system = multiplier_system(configuration, lagrange_equations(configuration).left, multipliers)
    assert compare(laws, replace(system, multipliers=multipliers)).agree
