"""The checks in numbers: they hold for what is right, and see what is not."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.core.diagnostics import Source
from lagrange.core.effort import allowed
from lagrange.mechanics.equilibrium.sampled_checks import check_oscillations, check_stability
from lagrange.mechanics.equilibrium.stability import SecondVariation, Stability, StabilityVerdict
from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.linearized_systems import solved
from tests.support.statics_texts import BEAD

a, b, k, F = sp.symbols("a b k F", positive=True)
SPRING = """
title: v
parameters: [k, a, F]
coordinates: [phi, psi]
forces: {v: {potential: "k*(phi - psi)^2/2 + a*F*sin(phi)"}}
find: equilibrium
"""
CIRCLE = """
title: v
parameters: [k, F]
coordinates: [x, y]
constraints: {wire: x^2 + y^2 = k^2}
forces: {v: {potential: "F*y"}}
find: equilibrium
"""
PLANK = """
title: v
parameters: [R, h, W]
coordinates: [theta]
forces: {v: {potential: "W*R*theta*sin(theta) + W*(R + h)*cos(theta)"}}
find: equilibrium
"""


def own(text: str) -> InCoordinates:
    return solve(read_problem(Source("problem.yaml", text))).own


def passed(view: InCoordinates, *verdicts: Stability) -> list[bool | None]:
    """Whether the check holds with the first verdicts replaced."""
    assert view.equilibrium is not None
    assert view.stability is not None
    changed = (*verdicts, *view.stability.verdicts[len(verdicts) :])
    second = SecondVariation(view.stability.coordinates, view.stability.matrix, changed)
    return [c.passed for c in check_stability(view.equilibrium, second)]


def stable_where(*conditions: SignCondition) -> Stability:
    return Stability(StabilityVerdict.CONDITIONAL, (sp.S.One,), conditions)


STABLE = Stability(StabilityVerdict.STABLE, (sp.S.One,))
UNSTABLE = Stability(StabilityVerdict.UNSTABLE, (-sp.S.One,))


def test_a_negative_minor_that_is_ignored() -> None:
    """At φ = ψ = π/2 the minors are k − a F and −a F k: stable where k > a F is false."""
    view = own(SPRING)
    assert passed(view) == [True]
    assert passed(view, stable_where(SignCondition(k, ">", a * F))) == [False]
    assert passed(view, STABLE) == [False]
    assert passed(view, UNSTABLE, UNSTABLE) == [False]


def test_a_condition_that_is_too_weak_too_strong_or_reversed() -> None:
    """The bead at θ = 0 is stable where b > a."""
    view = own(BEAD)
    assert passed(view, stable_where(SignCondition(b, ">", a))) == [True]
    for wrong in (SignCondition(2 * b, ">", a), SignCondition(b, ">", 2 * a), SignCondition(a, ">", b)):
        assert passed(view, stable_where(wrong)) == [False]


def test_multipliers_are_needed() -> None:
    """V = F y on a circle has no curvature of its own: λ gives it. The lowest point is stable."""
    view = own(CIRCLE)
    assert view.stability is not None
    assert passed(view) == [True]
    turned = [STABLE if s.verdict is StabilityVerdict.UNSTABLE else UNSTABLE for s in view.stability.verdicts]
    assert passed(view, *turned) == [False]


def test_an_equilibrium_at_which_nothing_is_tried_is_undecided() -> None:
    """The other equilibria do not replace one that is stated to exist only for parameters that were not drawn."""
    view = own(BEAD)
    assert view.equilibrium is not None
    branches = [
        replace(b, conditions=(SignCondition(-a, ">", b_.lhs),)) if (b_ := next(iter(b.conditions), None)) else b
        for b in view.equilibrium.branches
    ]
    assert any(b.conditions for b in branches)
    assert passed(replace(view, equilibrium=replace(view.equilibrium, branches=tuple(branches)))) == [None]


def test_stability_on_unsolved_branches() -> None:
    """A plank on a cylinder: R θ cos θ = h sin θ has no closed form, and is tried on its curve."""
    view = own(PLANK)
    assert view.stability is not None
    assert view.equilibrium is not None
    assert any(b.left for b in view.equilibrium.branches)
    assert passed(view) == [True]
    assert passed(
        view, view.stability.verdicts[0], stable_where(SignCondition(sp.Symbol("R", positive=True), ">", 0))
    ) == [False]


TWICE = """
coordinates: [x, y]
particles: {P: {mass: 1, position: x*i + y*j}}
forces: {v: {potential: "sqrt(14)*(x^2 + y^2)/2"}}
"""


@pytest.mark.parametrize("multiplicity", [1, 2, 3])
def test_a_double_frequency_that_is_listed_once(multiplicity: int) -> None:
    linear = solved(TWICE).own.linearization
    assert linear is not None
    [s] = linear.at
    assert s is not None
    [f] = s.system.frequencies
    changed = replace(s, system=replace(s.system, frequencies=(replace(f, multiplicity=multiplicity, modes=()),)))
    checks = {c.name: c.passed for c in check_oscillations(replace(linear, at=(changed,)))}
    assert checks["the frequencies have the stated multiplicities"] is (multiplicity == 2)
    assert checks["the stiffness has the stated signs"] is True


def test_determinants_of_long_entries_are_not_multiplied_out() -> None:
    """A top whose precession is prescribed: it took half a minute for three rows."""
    linear = own(TOP).linearization
    assert linear is not None
    with allowed(5000):
        assert all(c.passed for c in check_oscillations(linear) if "multiplicities" in c.name)


TOP = """
title: Top
axes: {k: up}
parameters: [A, C, Omega, m, l, g]
coordinates: [phi, theta, psi]
bodies:
  top: {mass: m, inertia: [A, A, C], position: l*e3_top, orientation: {axes: 313, angles: [Omega*t + phi, theta, psi]}}
gravity: -g*k
find: linearization
"""


def test_the_second_variation_beside_a_jump() -> None:
    """V = k (|x| − l)²/2 + F |x|: k at x = ±(l − F/k), where sign(x) is constant."""
    view = own(
        "title: T\nparameters: [k, l, F]\ncoordinates: [x]\nparticles: {P: {position: x*i}}\n"
        "forces: {s: {spring: k, between: [O, P], length: l}, f: {on: P, vector: -F*sign(x)*i}}\nfind: equilibrium\n"
    )
    assert passed(view) == [True]
