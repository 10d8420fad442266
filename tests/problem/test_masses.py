"""Particles and bodies."""

from __future__ import annotations

import pickle

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.core.vectors import Vector
from tests.support.problem_texts import HEAD, read

x, y, theta = (sp.Symbol(n, real=True) for n in ("x", "y", "theta"))
v, w, om = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'"))
m, l, g, k, c, F, R, mu, A, C, I_G = sp.symbols("m l g k c F R mu A C I_G", positive=True)


def vector(*components: sp.Expr | int) -> Vector:
    p, q, r = (sp.sympify(e) for e in components)
    return Vector((p, q, r))


def test_abbreviations_and_positions_may_use_one_another() -> None:
    problem = read(f"{HEAD}let: {{n: sin(theta)*i, h: r_P'}}\nparticles: {{P: {{mass: m, position: l*n}}}}\n")
    assert problem.particles[0].position == vector(l * sp.sin(theta), 0, 0)
    assert problem.scope.vectors["h"] == vector(l * sp.cos(theta) * om, 0, 0)


def test_particles() -> None:
    problem = read(
        HEAD + "particles:\n  P: {mass: m, position: x*i + y*j}\n  Q: {mass: 2 m, position: [x, y]}\n"
        '  S: {position: "[x, y]"}\n  Z: {mass: 0, position: r_P + l*j}\n'
    )
    assert [(p.name, p.mass) for p in problem.particles] == [("P", m), ("Q", 2 * m), ("S", 0), ("Z", 0)]
    assert {p.position for p in problem.particles[:3]} == {vector(x, y, 0)}
    assert problem.particles[3].position == vector(x, y + l, 0)


def test_the_radius_of_a_gear_may_have_the_name_of_its_position() -> None:
    """A parameter or coordinate keeps its name, and the vector has none; a note says so."""
    problem = read(
        "title: T\nparameters: [m, r_P, omega_B]\ncoordinates: [x, r_B, theta]\n"
        "particles: {P: {mass: m, position: r_P*i + x*j}, Q: {mass: m, position: r_Q0}}\n"
        "bodies: {B: {mass: m, inertia: m*r_P^2, position: r_B*i, angle: theta}}\nlet: {r_Q0: r_P*r_B*e1_B}\n"
    )
    r_p, r_b = sp.Symbol("r_P", positive=True), sp.Symbol("r_B", real=True)
    assert problem.particles[0].position == vector(r_p, x, 0)
    assert problem.bodies[0].position == vector(r_b, 0, 0)
    assert not {"r_P", "r_B", "omega_B"} & {*problem.scope.vectors}
    assert {"r_Q", "e1_B"} <= {*problem.scope.vectors}
    assert [d.message for d in problem.notes if d.code == "read-as"] == [
        "`r_P` is a parameter here, not the position of `P`",
        "`r_B` is a coordinate here, not the position of `B`",
        "`omega_B` is a parameter here, not the angular velocity of `B`",
    ]


def test_bodies() -> None:
    problem = read(
        HEAD + "let: {e1: cos(theta)*i + sin(theta)*j, e2: -sin(theta)*i + cos(theta)*j}\nbodies:\n"
        "  rod: {mass: m, inertia: I_G, position: x*i + y*j, angle: theta}\n"
        "  top: {mass: m, inertia: [A, A, C], position: [x, y, 0], orientation: {axes: 313, angles: [x, y, theta]}}\n"
        "  coin: {mass: m, inertia: [A, A, C], position: r_rod, axes: [e1, e2, e_z], angular_velocity: theta'*e_z}\n"
        'constraints: {roll: "r_rod\' + cross(omega_rod, R*e2_rod) = 0"}\n'
    )
    rod, top, coin = problem.bodies
    assert (rod.inertia, rod.angle, rod.position) == ((I_G,), theta, vector(x, y, 0))
    assert (top.inertia, top.sequence, top.angles) == ((A, A, C), "313", (x, y, theta))
    assert coin.angular_velocity == vector(0, 0, om)
    assert coin.axes[0] == vector(sp.cos(theta), sp.sin(theta), 0)
    rolls = {c.name: c.function for c in problem.constraints}
    assert sp.simplify(rolls["roll.1"] - (v - R * om * sp.cos(theta))) == 0
    assert sp.simplify(rolls["roll.2"] - (w - R * om * sp.sin(theta))) == 0


IN_SPACE = HEAD + (
    "bodies: {{B: {{mass: m, inertia: {inertia}, position: x*i, orientation: {{axes: 313, angles: [x, y, theta]}}}}}}\n"
)


def test_a_matrix_of_inertia() -> None:
    [body] = read(IN_SPACE.format(inertia="[[A, -m*l^2, R], [-l^2*m, A, 0], [R, 0, C]]")).bodies
    assert body.inertia == (A, A, C)
    assert body.products == (0, R, -m * l**2)
    assert read(IN_SPACE.format(inertia="[[A, 0, 0], [0, A, 0], [0, 0, C]]")).bodies[0].products == (0, 0, 0)


@pytest.mark.parametrize(
    ("inertia", "code", "said"),
    [
        ("[[A, R, 0], [l, A, 0], [0, 0, C]]", "inertia", "elements 12 and 21 differ"),
        ("[[A, R], [R, A]]", "inertia", "not 2"),
        ("[[A, R, 0], [R, A], [0, 0, C]]", "inertia", "three rows of three"),
        ("[A, [R], C]", "inertia", "three rows of three"),
        ("[[A, x, 0], [x, A, 0], [0, 0, C]]", "not-constant", "`x` varies"),
        ("[[-A, 0, 0], [0, A, 0], [0, 0, C]]", "negative", "is negative"),
        ("[[1, 2, 0], [2, 1, 0], [0, 0, 1]]", "impossible-inertia", "negative energy"),
        ("[[0, l, 0], [l, A, 0], [0, 0, C]]", "impossible-inertia", "negative energy"),
    ],
)
def test_what_is_no_tensor_of_inertia(inertia: str, code: str, said: str) -> None:
    with pytest.raises(ProblemError) as refused:
        read(IN_SPACE.format(inertia=inertia))
    found = refused.value.diagnostics[0]
    assert found.code == code
    assert said in found.message
    assert found.help


@pytest.mark.parametrize(
    ("inertia", "noted"),
    [("[1, 1, 3]", True), ("[1, 1, 2]", False), ("[m, m, 3*m]", True), ("[A, A, C]", False),
     ("[[2, 1, 0], [1, 2, 0], [0, 0, 5]]", True), ("[[2, 1, 0], [1, 2, 0], [0, 0, 4]]", False)],
)  # fmt: skip
def test_a_moment_that_exceeds_the_sum_of_the_others_is_noted(inertia: str, noted: bool) -> None:
    """The principal moments of the matrices are 1, 3, 5 and 1, 3, 4."""
    problem = read(IN_SPACE.format(inertia=inertia))
    assert ("impossible-inertia" in [d.code for d in problem.notes]) is noted


@pytest.mark.parametrize(
    ("body", "find", "accepted"),
    [
        ("mass: m, ", "equilibrium", True),
        ("", "equilibrium", True),
        ("", "motion", True),
        ("mass: m, ", "motion", False),
    ],
)
def test_inertia_is_needed_for_the_motion_of_a_mass_only(body: str, find: str, accepted: bool) -> None:
    text = (
        "title: T\nparameters: [m, g]\ncoordinates: [x, theta]\n"
        f"bodies: {{B: {{{body}position: x*i, angle: theta}}}}\ngravity: -g*j\nfind: {find}\n"
    )
    if accepted:
        [body_read] = read(text).bodies
        assert body_read.inertia == (0,)
    else:
        with pytest.raises(ProblemError, match="the body `B` has no `inertia`"):
            read(text)


def test_words_for_particles_and_bodies_go_with_their_names_to_the_forces_on_them() -> None:
    problem = read(
        HEAD + "particles: {P: {name: upper  particle, mass: m, position: x*i}}\nbodies:\n"
        "  rod: {name: long rod, mass: m, inertia: I_G, position: y*j, angle: theta}\n"
        "forces: {push: {on: P, vector: F*i}, twist: {on: rod, moment: F*l*k}}\n"
    )
    names = [*(p.name for p in problem.masses), *(f.on for f in problem.forces)]  # type: ignore[union-attr]
    assert names == ["P", "rod", "P", "rod"]
    assert [getattr(n, "words", "") for n in names] == ["upper particle", "long rod"] * 2
    assert [p.name for p in pickle.loads(pickle.dumps(problem.particles))] == ["P"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (f'"{"a" * 61}"', "longer than 60"),
        ('"the\\nball"', "several lines"),
        ('"\u202eball"', "control character"),
        ('"1 2"', "no letter"),
        ("Other", "`Q` and `P` are both called `Other`"),
        ('""', "no letter"),
        ("[a, b]", "is one value"),
    ],
)
def test_words_that_are_no_name(words: str, said: str) -> None:
    with pytest.raises(ProblemError) as refused:
        read(HEAD + f"particles:\n  Q: {{name: other, position: y*j}}\n  P: {{name: {words}, position: x*i}}\n")
    [found] = refused.value.diagnostics
    assert said in found.message
    assert found.help
