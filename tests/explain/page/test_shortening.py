"""The form that single steps have on the page."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import CheckMark, Display, Rule
from tests.explain.page.test_arrangement import printed
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "apart"), [("ex11-ideal-pendulum", False), ("ex05-ice-skate", True), ("ex17-spherical-pendulum", True)]
)
def test_sections_on_constraints_stay_apart_where_something_is_to_be_found_out(name: str, apart: bool) -> None:
    rules = [s.rule for s in reported(name, complete=False).derivation.page]
    assert (Rule.CLASSIFICATION in rules) is apart


def test_checks_that_held_are_one_line() -> None:
    step = reported("ex11-ideal-pendulum", complete=False).derivation.page[-1]
    steps = [s for s in reported("ex11-ideal-pendulum", complete=False).derivation.page if s.rule is Rule.CHECKS]
    [mark] = [b for s in steps for b in s.body if isinstance(b, CheckMark)]
    assert mark.passed
    assert step.folded  # what is folded comes after the checks


def test_what_was_divided_by_stands_at_the_box_only_where_it_matters() -> None:
    """x ÿ − y ẍ − g x = 0 holds at x = 0 too; where sin θ = 0, an equation is lost."""

    def conditions(name: str) -> list[bool]:
        steps = [s for s in reported(name, complete=False).derivation.page if s.rule is Rule.EQUATIONS_OF_MOTION]
        boxes = [b for b in steps[0].body if isinstance(b, Display) and b.boxed]
        return [bool(e.condition) for b in boxes for e in b.equations]

    assert not any(conditions("ex11-ideal-pendulum"))
    assert any(conditions("ex17-spherical-pendulum"))


def test_the_law_is_displayed_in_vectors_and_tensions_stand_for_multipliers() -> None:
    page = printed(reported("ex11-ideal-pendulum", complete=False))
    assert "m 𝐫̈ = 𝐅 + 𝐑" in page
    assert "𝐑 = −(T/l) 𝐫" in page


def test_a_kinematic_constraint_shows_the_component_that_it_forbids() -> None:
    page = printed(reported("ex05-ice-skate", complete=False))
    assert "(ẋ 𝐢 + ẏ 𝐣)·𝐧 = 0" in page
    assert "no component along" not in printed(reported("rolling-disc", complete=False))
