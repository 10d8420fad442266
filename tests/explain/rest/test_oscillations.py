"""The prose about small oscillations."""

from __future__ import annotations

import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Detail, Display
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from tests.support import shared
from tests.support.linearized_systems import linear_equations, solved

SPRUNG_CART = """
title: Cart with a spring and a pendulum
parameters: [M, m, g, l, c]
coordinates: [x, theta]
particles:
  A: {mass: M, position: x*i}
  B: {mass: m, position: r_A + l*sin(theta)*i - l*cos(theta)*j}
forces: {pull: {potential: c*x^2/2}}
gravity: -g*j
find: [motion, linearization]
"""


def test_a_long_mode_has_lines_of_its_own() -> None:
    """−ω² (M + m) ξ₁ − ω² m l ξ₂ + c ξ₁ = 0 holds for what each pair of lines says."""
    steps = report(read_problem(Source("cart", SPRUNG_CART))).derivation.steps
    displays = (b for step in steps for b in step.body if isinstance(b, Display))
    roots = next(d for d in displays if any(str(e.sides[0]).startswith("omega_1") for e in d.equations))
    assert [str(e.sides[0]) for e in roots.equations] == ["omega_1**2", "xi_2/xi_1", "omega_2**2", "xi_2/xi_1"]
    M, m, g, l, c = sp.symbols("M m g l c", positive=True)
    values = {M: 3, m: 2, g: 10, l: sp.Rational(1, 2), c: 7}
    for square, ratio in zip(roots.equations[::2], roots.equations[1::2], strict=True):
        w, r = (e.sides[1].subs(values) for e in (square, ratio))
        assert sp.radsimp(sp.expand(-w * 5 - w * r + 7)) == 0


def test_brief_names_the_small_changes_where_they_are_used() -> None:
    shown = shared.reported("ziegler-column")
    brief = terminal.text(shown.derivation, shown.notation, 80, Detail.BRIEF)
    assert "Let ξ₁ and ξ₂ be the small changes of θ and ψ from equilibrium.\n" in brief


TILTED = """
parameters: [m, c, l, g, Omega, alpha]
coordinates: [s]
particles: {P: {mass: m, position: s*sin(alpha)*(cos(Omega*t)*i + sin(Omega*t)*j) + s*cos(alpha)*k}}
gravity: -g*k
forces: {spring: {potential: c*(s - l)^2/2}}
"""


def test_what_is_divided_by_is_said_with_angles_of_parameters_in_it() -> None:
    """s (c − m Ω² sin² α) = c l − m g cos α on a wire that turns, inclined by α: c ≠ m Ω² sin² α."""
    [branch] = linear_equations(solved(TILTED)).branches
    m, c, Omega, alpha = sp.symbols("m c Omega alpha", positive=True)
    [condition] = branch.conditions
    assert condition.relation == "≠"
    assert sp.expand(condition.lhs - condition.rhs - c + m * Omega**2 * sp.sin(alpha) ** 2) == 0


def test_small_oscillations_of_a_spinning_body_name_its_steady_motions() -> None:
    text = (
        "title: Top\nparameters: [m, g, l, A, C]\ncoordinates: [phi, theta, psi]\nbodies: {top: {mass: m, inertia: "
        "[A, A, C], position: l*e3_top, orientation: {axes: 313, angles: [phi, theta, psi]}}}\ngravity: -g*k\n"
        "find: linearization\n"
    )
    found = report(read_problem(Source("top.yaml", text)), complete=False)
    page = " ".join(terminal.text(found.derivation, found.notation, 80).split())
    assert "There are steady motions as well, in which φ̇ and ψ̇ are constant and not zero." in page


DOOR = """
title: Door on a tilted line
parameters: {m: positive, b: positive, g: {value: 9.81 m/s^2}, beta: acute}
gravity: -g*(cos(beta)*k + sin(beta)*i)
coordinates: {phi: angle of the door}
bodies: {door: {mass: m, inertia: m*b^2/12, position: b/2*(cos(phi)*i + sin(phi)*j), angle: phi}}
find: [motion, equilibrium, linearization]
"""


def test_equilibria_are_listed_once() -> None:
    """The linear equations are about those that the principle of virtual work has given."""
    found = report(read_problem(Source("door", DOOR)))
    labels = [
        e.label
        for s in found.derivation.steps
        for b in s.body
        if isinstance(b, Display)
        for e in b.equations
        if e.label
    ]
    assert {"equilibrium-1", "equilibrium-2"} <= {*labels}
    assert not any(x.startswith("at-rest") for x in labels)
    page = terminal.text(found.derivation, found.notation, 80)
    assert "At rest the equation of motion is satisfied at (9) and (10)." in page
    assert "(?)" not in page
