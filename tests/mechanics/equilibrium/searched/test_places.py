"""The search for equilibria that a list lacks: it must find each one that is taken away, and nothing else."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from random import Random

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.core.diagnostics import Source
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.searched.newton import zero_near
from lagrange.mechanics.equilibrium.searched.places import _Search, with_search
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.statics_texts import BEAD, CROSS_WIND, INCLINES, PENDULUM, SKATE, SPRING_ON_CIRCLE

TORSION = """
title: Rods with a torsion spring
coordinates: [phi, psi]
forces: {spring: {potential: 2*(phi - psi)^2}, weight: {potential: -5*cos(phi)}}
"""
NUT = """
title: A nut on a thread, held by a spring, with an arm that is heavy
parameters: [k, W, h]
coordinates: [theta, s]
forces: {field: {potential: "k*(s - h*theta)^2/2 - W*cos(theta)"}}
find: equilibrium
"""
THETA = sp.Symbol("theta", real=True)


PLANK = """
title: A plank that rocks on a cylinder
parameters: [m, g, R, h]
coordinates: [theta]
particles: {G: {mass: m, position: "[R*sin(theta) - R*theta*cos(theta) + h*sin(theta), R*cos(theta) + R*theta*sin(theta) + h*cos(theta)]"}}
gravity: -g*j
find: equilibrium
"""


@cache
def found(text: str) -> Equilibrium:
    e = solve(read_problem(Source("problem.yaml", text))).own.equilibrium
    assert e is not None
    assert e.all_found is not False
    return replace(e, all_found=None)


def without(e: Equilibrium, n: int) -> Equilibrium:
    return replace(e, branches=(*e.branches[:n], *e.branches[n + 1 :]), idle=())


@pytest.mark.parametrize("text", [BEAD, PENDULUM, SKATE, SPRING_ON_CIRCLE, CROSS_WIND, TORSION, NUT])
def test_nothing_is_missing(text: str) -> None:
    """A spring of length 0 and a pole of the chart satisfy the conditions too: they are no equilibria. Nor are angles
    that differ by full turns, both of them, other equilibria of two rods with a torsion spring between them. θ = 0 with s = h θ, for a nut, is θ = 2π too.
    """
    assert with_search(found(text)).all_found is True


@pytest.mark.parametrize("text", [BEAD, PENDULUM, SKATE, PLANK])
def test_each_equilibrium_that_is_taken_away_is_found(text: str) -> None:
    """Among them those of the skate that a division by sin θ loses, a line of them for every y."""
    e = found(text)
    assert len(e.branches) > 1
    for n, b in enumerate(e.branches):
        search = with_search(without(e, n))
        assert search.all_found is False, b.relations
        assert not search.solution.solved  # incomplete wherever it is used


def test_a_place_is_confirmed_with_the_parameters_that_it_is_compared_with() -> None:
    """l² of a float is rounded: a place at the distance l would differ in the sixteenth digit from y = l."""
    search = _Search(found(PENDULUM))
    numbers = [random.uniform(0.3, 0.7) for random in [Random(5)] for _ in search.parameters]
    length = numbers[[s.name for s in search.parameters].index("l")]
    tension = [zero_near(lambda x: search.tape.values([*x, *numbers]), [0.1, 0.9 * length, n], 60) for n in (-1, 1)]
    assert any(tension)
    assert not any(search._is_lost(search.tape, guess, numbers) for guess in tension if guess)


def test_a_condition_that_is_too_narrow() -> None:
    e = found(BEAD)
    [n] = [n for n, b in enumerate(e.branches) if b.conditions]
    [c] = e.branches[n].conditions
    turned = replace(e.branches[n], conditions=(replace(c, lhs=c.rhs, rhs=c.lhs),))
    assert with_search(replace(e, branches=(*e.branches[:n], turned, *e.branches[n + 1 :]))).all_found is False


def test_full_turns_do_not_matter() -> None:
    e = found(BEAD)
    turned = tuple(replace(b, relations=tuple(Relation(r.lhs, r.rhs + 2 * sp.pi) if r.lhs == THETA else r
                                              for r in b.relations)) for b in e.branches)  # fmt: skip
    assert turned != e.branches
    assert with_search(replace(e, branches=turned)).all_found is True


def test_where_nothing_can_be_searched() -> None:
    """An equilibrium for special parameters only: no zero is found, and nothing is printed."""
    assert with_search(found(INCLINES)).all_found is None


def test_a_run_that_loses_solutions_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    def lossy(*arguments: object, **more: object) -> object:
        whole = solutions(*arguments, **more)  # type: ignore[arg-type]
        return replace(whole, branches=whole.branches[:1])

    monkeypatch.setattr("lagrange.mechanics.equilibrium.equilibrium.solutions", lossy)
    solution = solve(read_problem(Source("problem.yaml", SKATE)))
    [check] = [c for c in solution.checks if c.name == "no place of rest found in numbers is missing"]
    assert check.passed is False
    assert solution.own.equilibrium is not None
    assert not solution.own.equilibrium.solution.solved
