"""Newton's law with reactions: their directions, what they are, the count of unknowns, their work."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
import sympy as sp

from lagrange.displacements import eliminate
from lagrange.exact import is_zero
from lagrange.problem import Problem
from lagrange.solution import Solution, solve
from lagrange.vectors import Vector
from lagrange.workless import works_of_reactions

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
    assert found.dynamics.reactions.multipliers == {"roll": 0}


@pytest.mark.parametrize(
    "text",
    [
        # B hangs from A, both placed by angles: A's angle moves B
        "coordinates: [a, b]\nparticles: {A: {mass: m, position: '[l*sin(a), l*cos(a)]'}, "
        "B: {mass: m, position: 'r_A + l*sin(b)*i + l*cos(b)*j'}}\nconstraints: {c: a = b}\n",
        # the force acts beside the particle
        "coordinates: [x, y]\nparticles: {A: {mass: m, position: '[x, y]'}}\nconstraints: {c: x = y}\n"
        "forces: {push: {on: A, vector: g*i, at: '[2*x, y]'}}\n",
    ],
    ids=["placed together", "a force elsewhere"],
)
def test_no_free_bodies_where_coordinates_do_not_give_them(problem: Read, text: str) -> None:
    newton = solution(problem, f"parameters: [m, l, g]\n{text}").law.newton
    assert newton.bodies is None
    assert newton.equations is None
    assert [r.directions for r in newton.reactions] == [None]


# -- what a reaction is ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("constraint", "length", "factor"),
    [
        ("x^2 + y^2 + z^2 = l^2", l, -2 * l),
        ("l^2 = x^2 + y^2 + z^2", l, 2 * l),
        ("sqrt(x^2 + y^2 + z^2) = l", l, -1),
        ("(x^2 + y^2 + z^2)/(2*l) = l/2", l, -1),
        ("x^2 + y^2 + z^2 = 2*a*x", sp.Symbol("a", positive=True), -2 * sp.Symbol("a", positive=True)),
        ("(x - w)^2 + y^2 + (z - l)^2 = l^2", l, -2 * l),
    ],
)
def test_distance_constraints_are_recognised(problem: Read, constraint: str, length: sp.Expr, factor: sp.Expr) -> None:
    [reaction] = one_particle(problem, constraint).law.newton.reactions
    assert reaction.rod is not None
    assert is_zero(reaction.rod.length - length) is True
    assert is_zero(reaction.rod.factor - factor) is True


@pytest.mark.parametrize(
    "constraint",
    [
        "x^2 + 2*y^2 + z^2 = l^2",
        "x^2 + y^2 = l^2",
        "z = x^2/l",
        "x + y + z = l",
        "x^2 + y^2 - z^2 = l^2",
        "x*y*z = l^3",
    ],
)
def test_other_constraints_are_not(problem: Read, constraint: str) -> None:
    [reaction] = one_particle(problem, constraint).law.newton.reactions
    assert reaction.rod is None
    assert reaction.is_normal


def test_a_string_over_a_pulley_is_no_rod(problem: Read) -> None:
    found = solution(
        problem,
        "parameters: [m, L]\ncoordinates: [x, y]\nparticles: {A: {mass: m, position: x*i}, B: {mass: m, position: y*i}}\n"
        "constraints: {rod: x + y = L}\n",
    )
    [reaction] = found.law.newton.reactions
    assert reaction.rod is None
    assert not reaction.is_normal


def test_the_name_of_a_reaction_is_a_tension_or_a_multiplier(problem: Read) -> None:
    [named] = one_particle(problem, "x^2 + y^2 + z^2 = l^2", ", reaction: T").law.newton.reactions
    tension = sp.Symbol("T", real=True)
    assert (named.force, named.multiplier.name, named.per_force) == (tension, "lambda_c", -1 / (2 * l))
    assert same(named.per_unit("P"), -x / l, -y / l, -z / l)
    [unnamed] = one_particle(problem, "x^2 + y^2 + z^2 = l^2").law.newton.reactions
    assert (unnamed.force.name, unnamed.tension.name) == ("lambda_c", "T_c")
    [surface] = one_particle(problem, "z = x*y", ", reaction: N").law.newton.reactions
    assert surface.force == surface.multiplier == sp.Symbol("N", real=True)


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
    configuration = found.configuration
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
