"""Positions of rest in a few lines."""

from __future__ import annotations

from lagrange.document.derivation import Block, Math, Prose
from lagrange.explain.page.conclusions.positions import explain_rest
from lagrange.mechanics.meaning import meaning
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load
from tests.support.shared import SHIPPED


def rest_of(name: str) -> list[Block]:
    found = meaning(solve(load(str(SHIPPED[name]))))
    return [] if found is None else [*explain_rest(found.small)]


def words(block: Block) -> str:
    assert isinstance(block, Prose)
    return "".join(p if isinstance(p, str) else str(p.sides[0]) if isinstance(p, Math) else "" for p in block.parts)


def test_two_angles_have_one_stable_position_and_two_frequencies() -> None:
    rest, motion = rest_of("ex10-double-pendulum")
    assert words(rest) == ": theta1 and theta2, stable; three others are unstable."
    assert "omega_1**2 and omega_2**2" in words(motion)


def test_a_position_with_a_condition_for_stability() -> None:
    rest, motion = rest_of("bead-on-lemniscate")
    assert words(rest).count("stable where cos(s)") == 2
    assert "omega**2 where it is stable" in words(motion)


def test_no_rest_at_the_end_of_a_range() -> None:
    """Upright, at θ = 90°, the sliding ladder would be at rest; nothing is said of that."""
    found = meaning(solve(load(str(SHIPPED["sliding-ladder"]))))
    assert found is not None
    assert found.small is None
