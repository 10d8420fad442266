"""An impact checked by second routes: each check passes on what was derived, and fails on a planted fault."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from lagrange.mechanics.momenta.impact import ImpulsiveMotion
from lagrange.mechanics.momenta.impact_checks import check_impact
from tests.support.shared import solved

CONSTRAINTS = "the velocities after the impact satisfy the constraints"
MOMENTA = "the impulses change the momenta ∂T/∂q' by the right amount"
ENERGY = "the kinetic energy changes by the work of the impulses"
BODIES = "momentum and moment of momentum of each body agree with its impulses"
CARNOT = "the energy lost is that of the lost velocities (Carnot)"


def failed(motion: ImpulsiveMotion) -> set[str]:
    checks = check_impact(motion, solved("disc-against-a-step").problem)
    assert {c.name for c in checks} == {CONSTRAINTS, MOMENTA, ENERGY, BODIES, CARNOT}
    return {c.name for c in checks if c.passed is False}


def faster(motion: ImpulsiveMotion) -> ImpulsiveMotion:
    return replace(motion, velocities=tuple(2 * v for v in motion.velocities))


def turning_alone(motion: ImpulsiveMotion) -> ImpulsiveMotion:
    return replace(motion, velocities=(*motion.velocities[:2], 2 * motion.velocities[2]))


def half_the_blow(motion: ImpulsiveMotion) -> ImpulsiveMotion:
    first, *others = motion.impulses
    assert first.value is not None
    assert first.multiplier is not None
    weaker = replace(first, value=first.value / 2, multiplier=first.multiplier / 2)
    return replace(motion, impulses=(weaker, *others))


def more_lost(motion: ImpulsiveMotion) -> ImpulsiveMotion:
    return replace(motion, energy_lost=2 * motion.energy_lost)


def test_what_was_derived_passes() -> None:
    motion = solved("disc-against-a-step").impact
    assert motion is not None
    assert not failed(motion)
    assert all(c.passed is True for c in check_impact(motion, solved("disc-against-a-step").problem))


@pytest.mark.parametrize(
    ("spoilt", "expected"),
    [
        (faster, {MOMENTA, BODIES}),
        (turning_alone, {CONSTRAINTS, MOMENTA, BODIES}),
        (half_the_blow, {MOMENTA, BODIES}),
        (more_lost, {ENERGY, CARNOT}),
    ],
)
def test_a_planted_fault_is_found(spoilt: Callable[[ImpulsiveMotion], ImpulsiveMotion], expected: set[str]) -> None:
    motion = solved("disc-against-a-step").impact
    assert motion is not None
    assert expected <= failed(spoilt(motion))
