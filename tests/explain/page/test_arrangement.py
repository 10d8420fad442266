"""The page: result first, other choices folded, every label once, every reference to something that can be shown."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Detail, Display, Rule, Step
from lagrange.explain.page import arrangement
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


def test_forces_alike_are_in_one_sentence_and_each_body_once() -> None:
    page = " ".join(printed(reported("double-atwood", complete=False)).split())
    forces = (
        "F₁ on the single weight, F on the moving pulley, F₂ on the left weight and F₃ on the right weight along −𝐣"
    )
    assert forces in page
    assert "On the single weight act" not in page
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


def test_every_pass_over_the_page_has_a_place_and_a_reason() -> None:
    passes = (*arrangement._SHORTENING, *arrangement._FINISHING)
    assert len({reason for _, reason in passes}) == len(passes)
    assert all(reason for _, reason in passes)


def test_passes_are_taken_in_their_order() -> None:
    solution = reported("ex11-ideal-pendulum", complete=False).solution
    first = (lambda _, steps: steps[:1], "only the first")
    second = (lambda _, steps: [*steps, *steps], "then twice")
    step = Step(Rule.RESULT, "", ())
    assert arrangement._through((first, second), solution, [step, step]) == [step, step]
    assert arrangement._through((second, first), solution, [step, step]) == [step]
