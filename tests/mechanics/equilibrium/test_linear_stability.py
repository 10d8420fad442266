"""Stability by the roots of the characteristic equation."""

from __future__ import annotations

import pytest
import sympy as sp

import lagrange
from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Detail
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.linear_stability import LinearSystem, has_uniform_motion, kind_of
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from tests.support import shared
from tests.support.linearized_systems import SYSTEMS, linear_equations, of, solved


def test_one_damped_coordinate() -> None:
    [s] = of(SYSTEMS["damped"]).at
    m, c, b = sp.symbols("m c b", positive=True)
    assert s is not None
    assert s.damped is not None
    assert s.damped.own == c / m
    assert sp.cancel(s.damped.square - (c / m - b**2 / (4 * m**2))) == 0
    assert sp.cancel(s.damped.rate - b / (2 * m)) == 0


def test_roots_that_may_be_equal_are_stable_where_they_are_not() -> None:
    """c/m and κ/J with a force between them one way only: at c J = κ m there is resonance."""
    found = shared.solved("skate-on-springs").own.linearization
    assert found is not None
    [s] = [s for s in found.at if s is not None]
    stability = s.judgement.stability
    assert stability.verdict is StabilityVerdict.CONDITIONAL
    assert [c.relation for c in stability.conditions] == ["≠"]
    assert {str(c.lhs) for f in s.frequencies for c in f.presupposed} == {"y"}


CAM = """
axes: {i: right, j: up}
parameters: [m, J, a, b, g]
coordinates: [x, y, theta]
bodies: {cam: {mass: m, inertia: J, position: x*i + y*j, angle: theta}}
constraints: {contact: y = sqrt(a^2*sin(theta)^2 + b^2*cos(theta)^2)}
gravity: -g*j
"""


def test_a_zero_root_beside_one_that_may_be_negative() -> None:
    """An ellipse on smooth ground may glide away; upright (y = a at θ = π/2) it falls over where a > b."""
    solution = solved(CAM, "find: [equilibrium, linearization]")
    found = linear_equations(solution)
    a, b = sp.symbols("a b", positive=True)
    theta, y = (sp.Symbol(n, real=True) for n in ("theta", "y"))
    assert solution.own.stability is not None
    for branch, s, second in zip(found.branches, found.at, solution.own.stability.verdicts, strict=True):
        at = {r.lhs: r.rhs for r in branch.relations}
        upright = at[theta] in (sp.pi / 2, -sp.pi / 2)
        assert at[y] == (a if upright else b)
        assert s is not None
        for stability in (s.judgement.stability, second):
            assert stability.verdict is StabilityVerdict.UNDECIDED
            [condition] = stability.unstable
            larger = condition.lhs if condition.relation == ">" else condition.rhs
            assert {condition.lhs, condition.rhs} == {a, b}
            assert larger == (a if upright else b)
    shown = report(read_problem(Source("cam", f"title: cam\n{CAM}find: linearization\n")))
    page = " ".join(terminal.text(shown.derivation, shown.notation, 80, Detail.STEPS).split())
    assert "is unstable where a > b. The root zero corresponds to a uniform motion" in page


SPUN_TOP = """
parameters: [m, A, C, g, l, Omega]
coordinates: [alpha, beta]
bodies:
  top: {mass: m, inertia: [A, A, C], position: l*e3_top, orientation: {axes: 123, angles: [alpha, beta, Omega*t]}}
gravity: -g*k
"""


def test_a_sleeping_top_by_one_condition() -> None:
    """Klein and Sommerfeld: C² Ω² > 4 (A + m l²) m g l, which implies the condition with 2 for 4."""
    found = linear_equations(solved(SPUN_TOP))
    m, A, C, g, l, Omega = sp.symbols("m A C g l Omega", positive=True)
    alpha, beta = (sp.Symbol(n, real=True) for n in ("alpha", "beta"))
    [upright] = [n for n, b in enumerate(found.branches) if {r.lhs: r.rhs for r in b.relations} == {alpha: 0, beta: 0}]
    s = found.at[upright]
    assert s is not None
    [condition] = s.judgement.stability.conditions
    assert condition.relation == ">"
    assert sp.expand(condition.lhs - condition.rhs - C**2 * Omega**2 + 4 * m * g * l * (A + m * l**2)) == 0
    for f in s.frequencies:  # without the common factor (A + m l²)²
        assert f.square is not None
        assert f.square.count_ops() < 50


def test_a_charge_at_rest_in_a_magnetic_field_does_not_drift() -> None:
    """All motions are circles: the double root p = 0 has two displacements and no uniform motion, unlike free masses."""
    at = sp.Matrix.zeros(2, 2)
    charge = linear_system(mass=sp.eye(2), damping=sp.Matrix([[0, -2], [2, 0]]), stiffness=at)
    free = linear_system(mass=sp.eye(2), damping=at, stiffness=sp.Matrix([[1, -1], [-1, 1]]))
    assert not has_uniform_motion(charge)
    assert has_uniform_motion(free)


def linear_system(**matrices: sp.Matrix) -> LinearSystem:
    tables = {name: tuple(map(tuple, m.tolist())) for name, m in matrices.items()}
    return LinearSystem(**tables, kind=kind_of(tables["damping"], True), symmetric=True, roots=None, frequencies=())


DRIFTING = """title: A system that can move as a whole
parameters: {m: positive, M: positive, k: positive, l: positive, c: real}
coordinates: [X, s]
lagrangian: "M*X'^2/2 + m*(X'^2 + s'^2 + X'*s')/2 - POTENTIAL"
find: [motion, equilibrium, linearization]
"""


@pytest.mark.parametrize(
    ("potential", "coordinates", "conditions"),
    [
        ("k*(s - l)^2/2", "X", 0),
        ("k*(s - X - l)^2/2", "X s", 0),  # the change of both together
        ("c*(s - l)^2/2", "X", 1),  # a minimum where c > 0
        ("k*(s - l)^2*(1 + X^2)/2", None, 0),  # singular only at the equilibrium: X is not free of V
        ("k*(s - l)^3/3", None, 0),  # no minimum
        ("k*(s - l)^2/2 + k*X^4", None, 0),
    ],
)
def test_stable_but_for_a_uniform_motion(potential: str, coordinates: str | None, conditions: int) -> None:
    """By the energy: V does not change along a direction, and has a strict minimum in the other coordinates."""
    view = solve(lagrange.loads(DRIFTING.replace("POTENTIAL", potential))).own
    assert view.linearization is not None
    assert view.stability is not None
    at = next(s for s in view.linearization.at if s is not None)
    for stability in (at.judgement.stability, view.stability.verdicts[0]):
        drift = stability.drift
        if coordinates is None:
            assert drift is None
            continue
        assert stability.verdict is StabilityVerdict.UNDECIDED or conditions
        assert drift is not None
        assert " ".join(q.name for q in drift.coordinates) == coordinates
        assert len(drift.conditions) == conditions
