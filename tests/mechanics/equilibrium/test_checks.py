"""The checks of equilibria: each passes on what was derived, and fails on a planted fault."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.mechanics.equilibrium.checks import check_equilibrium
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from tests.support.shared import solved

FORCES = "Lagrange's equations have the same generalized forces at rest"
SUBSTITUTED = "every equilibrium satisfies the conditions"
SEARCHED = "no place of rest found in numbers is missing"


def at_rest(name: str) -> Equilibrium:
    resting = solved(name).own.equilibrium
    assert resting is not None
    return resting


def passed(resting: Equilibrium) -> dict[str, bool | None]:
    return {c.name: c.passed for c in check_equilibrium(resting, resting)}


@pytest.mark.parametrize("name", ["roberval-balance", "inverted-pendulum-springs"])
def test_what_was_derived_passes(name: str) -> None:
    checks = passed(at_rest(name))
    assert {FORCES, SUBSTITUTED} <= checks.keys()
    assert {*checks.values()} == {True}


@pytest.mark.parametrize("name", ["roberval-balance", "inverted-pendulum-springs"])
def test_virtual_work_with_twice_the_forces_fails(name: str) -> None:
    resting = at_rest(name)
    work = replace(resting.work, forces=tuple(2 * f for f in resting.work.forces))
    assert passed(replace(resting, work=work))[FORCES] is False


@pytest.mark.parametrize("name", ["roberval-balance", "inverted-pendulum-springs", "slider-crank", "drawbridge"])
def test_an_equilibrium_that_is_stated_elsewhere_fails(name: str) -> None:
    """A cosine, a quotient in a closed triangle, the slope of any curve."""
    resting = at_rest(name)
    [(k, relation)] = [(k, r) for k, b in enumerate(resting.branches) for r in b.relations if r.rhs.free_symbols]
    moved = replace(resting.branches[k], relations=(replace(relation, rhs=relation.rhs / 2),))
    branches = (*resting.branches[:k], moved, *resting.branches[k + 1 :])
    assert passed(replace(resting, branches=branches))[SUBSTITUTED] is False


def test_what_was_read_before_does_not_matter() -> None:
    """An answer's acos(W l/(c b²)) beside W is no angle of the equilibria."""
    resting = at_rest("inverted-pendulum-springs")
    [(k, moved)] = [(k, r) for k, b in enumerate(resting.branches) for r in b.relations if r.rhs.free_symbols]
    beside = resting.solution.letters.copy()
    beside.read(sp.sin(sp.acos(moved.rhs)) + sp.sin(sp.Symbol("W", positive=True)))
    wrong = replace(resting.branches[k], relations=(replace(moved, rhs=moved.rhs / 2),))
    solution = replace(resting.solution, letters=beside)
    branches = (*resting.branches[:k], wrong, *resting.branches[k + 1 :])
    assert passed(replace(resting, branches=branches, solution=solution))[SUBSTITUTED] is False


def test_a_branch_of_which_nothing_is_tried_is_undecided() -> None:
    """A condition that no parameters meet: the other branches do not stand in for this one."""
    resting = at_rest("inverted-pendulum-springs")
    [(k, b)] = [(k, b) for k, b in enumerate(resting.branches) if b.conditions]
    never = replace(b, conditions=(SignCondition(-b.conditions[0].lhs, ">", b.conditions[0].rhs),))
    branches = (*resting.branches[:k], never, *resting.branches[k + 1 :])
    assert passed(replace(resting, branches=branches))[SUBSTITUTED] is None


def test_what_a_search_has_missed_or_solving_could_not_verify_is_said() -> None:
    resting = at_rest("inverted-pendulum-springs")
    assert passed(replace(resting, all_found=False))[SEARCHED] is False
    unverified = replace(resting, solution=replace(resting.solution, verified=False))
    assert passed(unverified)[SUBSTITUTED] is False
