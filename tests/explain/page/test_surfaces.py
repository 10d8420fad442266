"""A particle on a surface of any form: the equations in vectors are those of Newton, and no equation is lost."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.symbols import prime
from lagrange.document.derivation import Display, Rule
from lagrange.explain.page.surfaces import on_surface
from lagrange.render import terminal
from tests.support.shared import reported

ON_SURFACES = ["ex02-fixed-surface", "ex12-smooth-surface", "ex13-moving-surface", "ex15-rough-surface"]


def page(name: str) -> str:
    r = reported(name, complete=False)
    return terminal.text(r.derivation, r.notation, 80)


@pytest.mark.parametrize("name", ON_SURFACES)
def test_the_motion_is_a_vector_equation_without_a_condition(name: str) -> None:
    assert ") × ∇f = 0" in page(name) or "] × ∇f = 0" in page(name)
    assert "∂f/∂X ≠ 0" not in page(name)
    assert "(?)" not in page(name)


@pytest.mark.parametrize("name", ON_SURFACES[:3])
def test_the_components_follow_from_newtons_law(name: str) -> None:
    """With m r'' = F + λ ∇f each of them is an identity in λ, whatever component of ∇f vanishes."""
    solution = reported(name, complete=False).solution
    steps = [s for s in reported(name, complete=False).derivation.page if s.rule is Rule.EQUATIONS_OF_MOTION]
    lines = [e for s in steps for b in s.body if isinstance(b, Display) for e in b.equations]
    components = [e for e in lines if (e.label or "").startswith("motion-component")]
    assert len(components) == 3
    assert solution.law is not None
    [body], [r] = solution.law.newton.bodies, solution.law.newton.reactions
    mass, row = body.particle.mass, solution.own.configuration.rows[0]
    loads = [f.vector.fixed().components for f in solution.law.configuration.loads]
    force = [sp.Add(*(f[n] for f in loads)) for n in range(3)]
    coordinates = solution.own.configuration.slots.coordinates
    law = {prime(q, 2): (force[n] + r.multiplier * row.coefficients[n]) / mass for n, q in enumerate(coordinates)}
    assert all(is_zero((e.sides[0] - e.sides[1]).xreplace(law)) is True for e in components)


def test_other_systems_are_left_as_they_are() -> None:
    for name in ("ex01-horizontal-surface", "ex11-ideal-pendulum", "ladder"):
        assert on_surface(reported(name, complete=False).solution) is None


def test_friction_counts_as_an_applied_force_with_its_magnitude() -> None:
    written = page("ex15-rough-surface")
    assert "N = |𝐑| = |λ| |∇f|" in written
    assert "m 𝐫̈ = 𝐅 + 𝐑 − (μ N/|𝐫̇|) 𝐫̇" in written
    assert "𝐅·𝐫̇ − μ N |𝐫̇|" in written
