"""The second route of equilibria: what is stated, in numbers, in the forces as they were. It must catch false branches."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.diagnostics import Source
from lagrange.core.records import all_hold
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.stated_equilibria import stated_equilibria
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.statics_texts import BEAD, CROSS_WIND, FOUR_BAR, POLE, SKATE, SPRING_ON_CIRCLE, STRAIGHT_SPRING

THETA, PHI, BETA, X, Y = (sp.Symbol(n, real=True) for n in ("theta", "phi", "beta", "x", "y"))


def stated_equilibria_hold(e: Equilibrium) -> bool | None:
    """Whether what is stated of every branch implies equilibrium; None if one of them could not be tried."""
    tried = stated_equilibria(e)
    return all_hold(t.holds for t in tried) if tried else None


@cache
def found(text: str) -> Equilibrium:
    e = solve(read_problem(Source("problem.yaml", text))).own.equilibrium
    assert e is not None
    return e


def stating(e: Equilibrium, *relations: tuple[sp.Expr, object], left: tuple[sp.Expr, ...] = ()) -> Equilibrium:
    """The equilibrium with one branch, stated so."""
    return replace(e, branches=(Branch(tuple(Relation(a, sp.sympify(b)) for a, b in relations), left=left),))


@pytest.mark.parametrize("text", [BEAD, SPRING_ON_CIRCLE, STRAIGHT_SPRING, POLE, CROSS_WIND, SKATE])
def test_what_is_stated_holds(text: str) -> None:
    assert stated_equilibria_hold(found(text)) is True


def test_a_root_under_a_root() -> None:
    """y = √|x| holds at x = −c, y = √c."""
    text = """
title: A wire with a cusp
parameters: [c]
coordinates: [x, y]
constraints: {wire: y = sqrt(abs(x))}
forces: {weight: {potential: y + c/y}}
find: equilibrium
"""
    assert stated_equilibria_hold(found(text)) is True


def test_a_force_without_value() -> None:
    """A spring of length 0, on a circle and on a line, and a pole of the potential."""
    assert stated_equilibria_hold(stating(found(SPRING_ON_CIRCLE), (THETA, 0))) is False
    assert stated_equilibria_hold(stating(found(STRAIGHT_SPRING), (X, 0))) is False
    assert stated_equilibria_hold(stating(found(POLE), (THETA, sp.pi))) is False


def test_signs_that_belong_together() -> None:
    """tan θ = −√2 and tan φ = 1: only where cos φ < 0."""
    e = found(CROSS_WIND)
    assert stated_equilibria_hold(stating(e, (sp.tan(THETA), -sp.sqrt(2)), (sp.tan(PHI), 1))) is False
    assert stated_equilibria_hold(stating(e, (sp.tan(THETA), -sp.sqrt(2)), (PHI, -3 * sp.pi / 4))) is True


def test_an_unsolved_branch_that_lacks_a_condition() -> None:
    """β = 0 and the two constraints: the moments need not balance there."""
    e = found(FOUR_BAR)
    closed = tuple(f.xreplace({BETA: sp.S.Zero}) for f in e.configuration.finite_constraints)
    assert stated_equilibria_hold(stating(e, (BETA, 0), left=closed)) is False


def test_a_wrong_value_and_a_wrong_condition() -> None:
    """cos θ = b/a where b ≤ a; with a/b there is no equilibrium where a ≤ b."""
    a, b = sp.symbols("a b", positive=True)
    e = found(BEAD)
    assert stated_equilibria_hold(stating(e, (sp.cos(THETA), a / b))) is False
    right = Branch((Relation(sp.cos(THETA), b / a),), (SignCondition(a, "≥", b),))
    assert stated_equilibria_hold(replace(e, branches=(right,))) is True


def test_positions_left_open() -> None:
    """A skate on a spring: y = −x cot θ with any x and θ; x = 0 alone is no equilibrium."""
    e = found(SKATE)
    assert stated_equilibria_hold(stating(e, (Y, -X / sp.tan(THETA)))) is True
    assert stated_equilibria_hold(stating(e, (X, 0))) is False


ROLLING = """
title: v
parameters: [k, R]
coordinates: [x, theta]
constraints: {c: "x = R*theta"}
forces: {v: {potential: "k*(x - R*sin(theta))^2"}}
find: equilibrium
"""
COUPLED = """
title: v
parameters: [W, c]
coordinates: [theta, phi]
forces: {v: {potential: "W*(theta^2/2 + cos(theta) + phi^2/2 + cos(phi)) + c*(cos(theta) - 1)*(cos(phi) - 1)"}}
find: equilibrium
"""


def test_an_angle_that_a_constraint_has_outside_of_sines() -> None:
    """x = R θ where cos θ = 1: one branch, of which x = 0 at θ = 0 is a part, and the reaction there is 0."""
    view = solve(read_problem(Source("problem.yaml", ROLLING))).own
    e = view.equilibrium
    assert e is not None
    assert [{str(r.lhs): str(r.rhs) for r in b.relations} for b in e.branches if not b.left] == [
        {"x": "R*theta", "theta": "0"}
    ]
    assert e.turned(e.branches[0]) == (THETA,)
    assert stated_equilibria_hold(e) is True
    assert view.reactions_at_rest is not None
    assert view.reactions_at_rest.at[0] is not None
    assert view.reactions_at_rest.at[0].verified is True


def test_unsolved_equations_that_are_the_conditions_themselves() -> None:
    """Two pendulums at their critical stiffness: the only real solution is θ = φ = 0, which no iteration reaches."""
    assert stated_equilibria_hold(found(COUPLED)) is True
    less = replace(
        found(COUPLED), branches=(replace(found(COUPLED).branches[-1], left=found(COUPLED).branches[-1].left[:1]),)
    )
    assert stated_equilibria_hold(less) is not True
