"""Particles and bodies."""

from __future__ import annotations

import sympy as sp

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
