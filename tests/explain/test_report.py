"""Derivations as texts: every reference has its equation, and no equation is referred to before it appears."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest
from click.testing import CliRunner

import lagrange.explain.report as reports
from lagrange.core.effort import spend
from lagrange.document.derivation import Detail, Rule
from lagrange.explain.report import report
from lagrange.problem.loader import load
from lagrange.problem.model import Problem
from lagrange.render import html, json, terminal
from lagsolve.main import main
from tests.support.derivation_text import reading
from tests.support.paths import PROBLEMS, ROOT
from tests.support.shared import SHIPPED, reported


@pytest.mark.parametrize("name", SHIPPED)
def test_references_point_back_to_equations(name: str) -> None:
    derivation = reported(name).derivation
    labels: set[str] = set()
    for kind, name in reading(derivation):
        if kind == "label":
            assert name not in labels, f"{name} stands twice"
            labels.add(name)
        else:
            assert name in labels, f"{name} is referred to before it stands"


@pytest.mark.parametrize("name", SHIPPED)
def test_steps_come_in_the_order_of_the_textbook(name: str) -> None:
    steps = [s for s in reported(name).derivation.steps if s.rule is not Rule.RESULT]  # the head of a page
    order = list(Rule)
    again = (  # one for each choice
        Rule.GENERALIZED_COORDINATES,
        Rule.EQUATIONS_OF_MOTION,
        Rule.SOLVED_REACTIONS,
        Rule.CONSERVED,
        Rule.LINEARIZATION,
        Rule.QUASI_VELOCITIES,
    )
    first = [order.index(s.rule) for s in steps if s.rule not in again]
    assert first == sorted(first)
    assert steps[0].rule is Rule.STATEMENT
    assert steps[-1].rule is Rule.CHECKS
    assert all(s.title and s.body for s in steps)


BOTH = """
title: A plate that hangs and swings
parameters: [m, I, l, g]
coordinates: [x, y, theta]
bodies: {plate: {mass: m, inertia: I, position: "[x, y]", angle: theta}}
constraints: {across: x = l*sin(theta), down: y = -l*cos(theta)}
gravity: -g*j
find: [equilibrium, motion]
generalized_coordinates:
  angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: -l*cos(theta)}}
"""


def test_statics_and_motion_in_one_derivation_have_labels_of_their_own(problem: object) -> None:
    labels = [name for kind, name in reading(report(problem(BOTH)).derivation) if kind == "label"]  # type: ignore[operator]
    assert len(labels) == len(set(labels))
    assert {"delta-at-rest-angle-plate", "delta-angle-plate"} <= set(labels)


def test_little_detail_is_half_a_screen() -> None:
    """Classification, degrees of freedom, the final equations; the checks that held are counted."""
    found = reported("chapter6/ex11-ideal-pendulum")
    text = terminal.text(found.derivation, found.notation, 80, Detail.BRIEF)
    assert len(text.splitlines()) <= 32
    assert "θ̈ + (g/l) sin θ = 0" in text
    assert text.count("✓") == 1
    assert "more checks" in text


def test_what_a_format_does_not_show_is_not_made(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[str] = []
    for name in ("steps_of_page", "illustrated"):
        _note_calls(monkeypatch, name, made)
    found = report(load(str(SHIPPED["ex11-ideal-pendulum"])))
    json.render([found])
    html.render([(found.derivation, found.notation)], detail=Detail.FULL)
    assert made == ["illustrated"]
    terminal.text(found.derivation, found.notation, 80)
    html.render([(found.derivation, found.notation)])
    assert made == ["illustrated", "steps_of_page", "illustrated"]
    made.clear()
    found = report(load(str(SHIPPED["ex11-ideal-pendulum"])), complete=False)
    terminal.text(found.derivation, found.notation, 80)
    assert made == ["steps_of_page", "illustrated"]


def test_a_right_answer_loads_nothing_for_wrong_ones_nor_motion_anything_for_rest() -> None:
    code = (
        "import sys; from lagrange.problem.loader import load; from lagrange.explain.report import report;"
        "report(load('problems/chapter6/ex18-double-pendulum.yaml'), complete=False);"
        "print([m for m in sys.modules if m in ('lagrange.answers.diagnosis', 'lagrange.answers.models.search',"
        "'lagrange.answers.written.working', 'lagrange.algebra.closed_forms.branching',"
        "'lagrange.algebra.forms.derived_flag', 'lagrange.mechanics.constraints.rigid_bodies')"
        " or m.startswith('lagrange.mechanics.equilibrium.')])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True, timeout=120
    )
    assert done.stdout.strip() == "[]"


def _note_calls(monkeypatch: pytest.MonkeyPatch, name: str, made: list[str]) -> None:
    """Has a function of the module `report` put its name on a list whenever it is called."""
    called = getattr(reports, name)

    def noted(*values: Any, **named: Any) -> Any:
        made.append(name)
        return called(*values, **named)

    monkeypatch.setattr(reports, name, noted)


PENDULUM = "chapter6/ex18-double-pendulum"


def too_much(*_: Any, **__: Any) -> None:
    """In place of something that is explained."""
    spend(1e9)


@pytest.mark.parametrize("form", ["pretty", "latex", "html", "markdown", "json"])
def test_a_step_that_takes_too_much_work(form: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """All others are printed, in every format; exit status 3 and a message say what is missing."""
    monkeypatch.setattr(reports, "explain_works", too_much)
    found = CliRunner().invoke(main, ("ex18", "--format", form))
    assert found.exit_code == 3
    reason = "explanations and pictures, the work allowed for one problem is used up"
    assert f"given up at: {reason}" in found.stderr
    assert reason in " ".join(found.stdout.split())
    for title in ("Newton's law and the reactions", "Equations of motion", "Checks"):
        assert title.replace("'", "’") in found.stdout.replace("'", "’").replace("&#x27;", "’")


def test_what_refers_to_a_missing_step(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reports, "explain_works", too_much)
    explained = report(load(PROBLEMS / f"{PENDULUM}.yaml"))
    steps = [s for s in reported(PENDULUM).derivation.steps if s.rule is not Rule.WORKLESS]
    assert [s.title for s in explained.derivation.steps] == [s.title for s in steps]
    text = terminal.text(explained.derivation, explained.notation, 200)
    assert "an equation left out here" in text
    assert "(?)" not in text


def test_a_page_that_takes_too_much_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """The steps of the full derivation replace it."""
    monkeypatch.setattr(reports, "steps_of_page", too_much)
    explained = report(load(PROBLEMS / f"{PENDULUM}.yaml"), complete=False)
    assert explained.derivation.at(Detail.STEPS) is explained.derivation.steps
    rules = [s.rule for s in explained.derivation.steps]
    assert (rules[0], rules[-1]) == (Rule.STATEMENT, Rule.CHECKS)
    assert {Rule.WORKLESS, Rule.PRINCIPLE, Rule.EQUATIONS_OF_MOTION} <= {*rules}
    assert explained.solution.given_up.startswith("explanations and pictures, ")


def test_a_parameter_of_the_initial_state_may_be_meant_for_it(problem: Callable[[str], Problem]) -> None:
    cone = """
title: A bead in a cone
parameters: {m: positive, g: positive, alpha: acute, h: positive, omega: positive}
coordinates: [r, phi]
particles:
  bead: {mass: m, position: "r*sin(alpha)*(cos(phi)*i + sin(phi)*j) + r*cos(alpha)*k"}
gravity: -g*k
initial: {r: h/cos(alpha), r': 0, phi: 0, phi': omega}
ask: {circle: {quantity: omega, when: "r'' = 0"}}
"""
    [open_] = [d for d in report(problem(cone)).shortcomings if d.code == "undecided"]
    assert "and t = 0" in open_.help
    [asked] = report(problem(cone.replace("r'' = 0", "r'' = 0 and t = 0"))).solution.asked
    assert not asked.is_open
