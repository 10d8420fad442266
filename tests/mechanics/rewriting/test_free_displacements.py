"""Conditions on displacements satisfied by a parameter, where solving for one displacement would divide by zero."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.core.effort import allowed
from lagrange.core.symbols import variation
from lagrange.mechanics.rewriting.free_displacements import free_displacements
from tests.support.shared import solved


def test_the_displacements_of_a_skate_satisfy_its_condition_in_every_position() -> None:
    own = solved("ex05-ice-skate").own
    slots = own.configuration.slots
    made = free_displacements(own.elimination, slots, {"s"})
    assert made is not None
    assert made.pivots == ()
    assert made.free[0] == variation(sp.Symbol("u", real=True))  # s is taken
    displaced = {variation(q): value for q, value in made.values.items()}
    [row] = own.configuration.rows
    steps = [displaced.get(variation(q), variation(q)) for q in slots.coordinates]
    left = sp.Add(*(c * step for c, step in zip(row.coefficients, steps, strict=True)))
    assert sp.expand(left) == 0
    assert not any(sp.fraction(sp.together(e))[1].free_symbols for e in displaced.values())


def test_what_is_never_infinite_needs_no_parameter() -> None:
    own = solved("ex07-constant-coefficients").own
    assert free_displacements(own.elimination, own.configuration.slots, set()) is None


def test_the_heading_is_free_rather_than_a_wheel() -> None:
    own = solved("two-wheels-on-an-axle").own
    slots = own.configuration.slots
    made = free_displacements(own.elimination, slots, set())
    assert made is not None
    assert [d.name for d in made.free] == ["delta(s)", "delta(theta)"]
    steps = [made.values.get(q, variation(q)) for q in slots.coordinates]
    for row in own.configuration.rows:
        total = sp.Add(*(c * step for c, step in zip(row.coefficients, steps, strict=True)))
        assert sp.simplify(total) == 0


def test_long_denominators_are_not_multiplied_out() -> None:
    own = solved("ex05-ice-skate").own
    nested, below = sp.Symbol("x", real=True), sp.S.One
    for _ in range(20):
        nested = 2 + sp.log(nested)
        below *= nested
    long = replace(own.elimination, solution=((1 / below,),))
    with allowed(1_000):
        assert free_displacements(long, own.configuration.slots, set()) is None
