"""Gravity and applied forces."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError, Source
from lagrange.core.vectors import Vector
from lagrange.problem.loader import read_problem
from lagrange.problem.model import (
    AppliedForce,
    AppliedMoment,
    Damper,
    Friction,
    Potential,
    Spring,
)
from tests.support.problem_texts import ALL, HEAD, read

x, y, theta = (sp.Symbol(n, real=True) for n in ("x", "y", "theta"))
m, l, g, k, c, F, R, mu, A, C, I_G = sp.symbols("m l g k c F R mu A C I_G", positive=True)


def vector(*components: sp.Expr | int) -> Vector:
    p, q, r = (sp.sympify(e) for e in components)
    return Vector((p, q, r))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("g*j", (0, g, 0)),
        ("-g*e_y", (0, -g, 0)),
        ("[0, -g]", (0, -g, 0)),
        ("'[0, 0, -g]'", (0, 0, -g)),
        ("0", (0, 0, 0)),
    ],
)
def test_gravity(text: str, expected: tuple[sp.Expr, ...]) -> None:
    assert read(f"{HEAD}gravity: {text}\n").gravity == vector(*expected)


def test_forces() -> None:
    problem = read(
        ALL
        + """forces:
  push: {on: P, vector: F*i, at: r_P + l*j}
  plain: {on: B, vector: "[0, F]"}
  torque: {on: B, moment: F*e_z}
  spring: {spring: k, between: [P, Q], length: l}
  loose: {spring: k, between: [P, l*j]}
  damper: {damper: c, between: [B, "[1, 2]"]}
  field: {potential: k*x^2/2}
  rub: {friction: mu, constraint: rod, on: P}
  full: {friction: mu, constraint: rod, on: P, surface_velocity: F*i, slip: positive, contact: negative}
"""
    )
    push, plain, torque, spring, loose, damper, field, rub, full = problem.forces
    assert isinstance(push, AppliedForce)
    assert (push.on, push.vector, push.at) == ("P", vector(F, 0, 0), vector(x, y + l, 0))
    assert isinstance(plain, AppliedForce)
    assert (plain.on, plain.vector, plain.at) == ("B", vector(0, F, 0), None)
    assert isinstance(torque, AppliedMoment)
    assert (torque.on, torque.moment) == ("B", vector(0, 0, F))
    assert isinstance(spring, Spring)
    assert (spring.stiffness, spring.length, spring.ends) == (k, l, (vector(x, y, 0), vector(y, 0, 0)))
    assert isinstance(loose, Spring)
    assert (loose.length, loose.ends[1]) == (0, vector(0, l, 0))
    assert isinstance(damper, Damper)
    assert (damper.coefficient, damper.ends) == (c, (vector(x, 0, 0), vector(1, 2, 0)))
    assert isinstance(field, Potential)
    assert field.energy == k * x**2 / 2
    assert isinstance(rub, Friction)
    assert (rub.coefficient, rub.constraint, rub.on, rub.slip, rub.contact) == (mu, "rod", "P", None, None)
    assert isinstance(full, Friction)
    assert (full.surface_velocity, full.slip, full.contact) == (vector(F, 0, 0), 1, -1)


@pytest.mark.parametrize("spring", ["spring: c*x, between: [P, 0*i]", "spring: c, between: [P, 0*i], length: l*x"])
def test_a_spring_is_the_same_wherever_it_is(spring: str) -> None:
    """V = c x (d − l)²/2 is no spring: its force is not c x (d − l), and a check did not hold."""
    head = "title: T\nparameters: [m, c, l]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\n"
    text = f"{head}forces: {{s: {{{spring}}}}}\n"
    with pytest.raises(ProblemError) as caught:
        read_problem(Source("p.yaml", text))
    [finding] = caught.value.diagnostics
    assert finding.code == "not-allowed-here"
    assert "potential" in finding.help


def test_an_impulse_says_what_acts() -> None:
    """It ended with an AssertionError about `static` (the fuzzers' seed 65670288)."""
    text = (
        "title: Blow\nparameters: [m, J]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\n"
        "impact: {before: {x': 0}, impulses: {blow: {on: P}}}\nfind: impact\n"
    )
    with pytest.raises(ProblemError, match="the impulse `blow` does not say what acts"):
        read_problem(Source("blow", text))
