"""The prose about a system that cannot move."""

from __future__ import annotations

from lagrange.document.derivation import Display, Rule
from tests.support.derivation_text import words
from tests.support.shared import reported


def test_where_nothing_is_free() -> None:
    steps = reported("constraints/servo").derivation.steps
    [freedom] = [s for s in steps if s.rule is Rule.DEGREES_OF_FREEDOM]
    assert "the constraints alone determine the position" in words(freedom)


def test_the_velocity_relative_to_a_surface_that_is_carried_along() -> None:
    for name, carried in (("ex09-moving-surface", True), ("ex08-displacements-on-a-surface", False)):
        steps = reported(name).derivation.steps
        [step] = [s for s in steps if s.rule is Rule.DISPLACEMENTS]
        assert ("relative to the surface, is tangent to it" in words(step)) is carried


def test_displacements_and_rotations_are_in_one_display() -> None:
    steps = reported("motion/heavy-top").derivation.steps
    [body] = [s.body for s in steps if s.rule is Rule.DISPLACEMENTS]
    [block] = [b for b in body if isinstance(b, Display)]
    assert [e.label for e in block.equations] == ["delta-top", "rotation-top"]


def test_they_differ_only_where_something_moves() -> None:
    steps = reported("ex09-moving-surface").derivation.steps
    [step] = [s for s in steps if s.rule is Rule.DISPLACEMENTS]
    assert "differ unless u, because the moving constraint" in words(step)
