"""The page: result first, other choices folded, every label once, every reference to something that can be shown."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import CheckMark, Detail, Display, Rule
from lagrange.explain.report import EVERY_CHOICE, Report, report
from lagrange.problem.loader import load
from lagrange.render import html, latex, markdown, terminal
from tests.support.shared import SHIPPED, reported

CHAPTER = [name for name, path in SHIPPED.items() if path.parent.name == "chapter6"]
LONGEST = {"ex11-ideal-pendulum": 90}
"""Lines of 80 columns; the others have at most MOST."""
MOST = 160


def printed(r: Report, detail: Detail = Detail.STEPS) -> str:
    return terminal.text(r.derivation, r.notation, 80, detail)


@pytest.mark.parametrize("name", CHAPTER)
def test_a_page_has_every_label_once_and_no_dangling_reference(name: str) -> None:
    r = reported(name, complete=False)
    blocks = [b for s in r.derivation.page for b in s.body]
    labels = [e.label for b in blocks if isinstance(b, Display) for e in b.equations if e.label]
    assert len(labels) == len(set(labels))
    assert "(?)" not in printed(r)


@pytest.mark.parametrize("name", CHAPTER)
def test_a_page_is_short(name: str) -> None:
    assert len(printed(reported(name, complete=False)).splitlines()) <= LONGEST.get(name, MOST)


def test_the_result_comes_first_and_without_a_number() -> None:
    first, second, *_ = reported("ex11-ideal-pendulum", complete=False).derivation.page
    assert first.rule is Rule.RESULT
    assert not first.title
    assert second.rule is Rule.STATEMENT


def test_the_first_choice_is_shown_and_the_others_are_folded() -> None:
    r = reported("ex11-ideal-pendulum", complete=False)
    folded = {s.choice for s in r.derivation.page if s.folded}
    assert folded == {"depth"}
    page = printed(r)
    assert "--choice depth" in page
    assert "σ₁" not in page
    assert "<details><summary>" in html.render([(r.derivation, r.notation)])
    assert "<details><summary>" in markdown.render([(r.derivation, r.notation)])
    assert "\\sigma" not in latex.render([(r.derivation, r.notation)])


def test_every_choice_is_shown_where_all_are_asked_for() -> None:
    r = report(load(str(SHIPPED["ex11-ideal-pendulum"])), EVERY_CHOICE, complete=False)
    assert not any(s.folded for s in r.derivation.page)
    assert "σ₁" in printed(r)


def test_full_detail_is_the_whole_derivation() -> None:
    r = reported("ex11-ideal-pendulum", complete=False)
    assert r.derivation.at(Detail.FULL) == r.derivation.steps
    assert "λ" in printed(r, Detail.FULL)
    assert "λ" not in printed(r)


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


def test_forces_alike_are_in_one_sentence_and_each_body_once() -> None:
    page = " ".join(printed(reported("double-atwood", complete=False)).split())
    assert "F₁ on the single body, F on the lower body, F₂ on the left body and F₃ on the right body along −𝐣" in page
    assert "On the single body act" not in page
    assert page.count("what one loses, another gains") == 1


def test_what_is_folded_takes_its_equations_with_it() -> None:
    """The principle written out in the file's coordinates precedes the equations that need it."""
    steps = reported("ex18-double-pendulum", complete=False).derivation.page
    [folded] = [s for s in steps if s.folded and s.rule is Rule.EQUATIONS_OF_MOTION and not s.choice]
    labels = [e.label for b in folded.body if isinstance(b, Display) for e in b.equations]
    assert labels[0] == "written-out"
    [principle] = [s for s in steps if s.rule is Rule.PRINCIPLE]
    assert [e.label for b in principle.body if isinstance(b, Display) for e in b.equations] == ["principle"]


def test_what_reactions_are_and_their_work_are_one_paragraph() -> None:
    r = reported("governor", complete=False)
    printed = " ".join(
        terminal.text(r.derivation, r.notation, 80).split("The reaction does no")[1].split("Alembert")[0].split()
    )
    assert "an unknown multiplier S. In a virtual displacement the reaction does the work" in printed
