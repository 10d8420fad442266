"""The places of pictures in a derivation, and their captions."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Picture
from lagrange.explain.report import report
from lagrange.problem.loader import load, read_problem
from lagrange.render import html, json, latex, terminal
from tests.support.paths import PROBLEMS
from tests.support.shared import reported


def test_nothing_is_drawn_for_the_terminal_and_for_programs(monkeypatch: pytest.MonkeyPatch) -> None:
    found = report(load(PROBLEMS / "chapter6/ex11-ideal-pendulum.yaml"))
    monkeypatch.setattr("lagrange.pictures.systems.general_pose", lambda *_: pytest.fail("a picture is drawn"))
    assert any(isinstance(b, Picture) for s in found.derivation.steps for b in s.body)
    terminal.text(found.derivation, found.notation, 80)
    json.render([found])
    with pytest.raises(pytest.fail.Exception):
        latex.render([(found.derivation, found.notation)])


def test_a_page_has_figures_with_words() -> None:
    name = "motion/coupled-oscillators"
    page = html.render([(reported(name).derivation, reported(name).notation)])
    assert page.count("<figure>") == page.count("<figcaption>") == 2
    assert "<title>Drawing of the system: P, Q; left, middle, right, oil.</title>" in page


def test_a_picture_that_takes_too_much_work_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lagrange.explain.illustrations.UNITS_OF_A_PICTURE", 1)
    text = (PROBLEMS / "chapter6/ex11-ideal-pendulum.yaml").read_text(encoding="utf-8")
    other = read_problem(Source("case.yaml", text.replace("theta", "chi")))  # whose expressions nobody has drawn before
    found = report(other, complete=False)
    page = html.render([(found.derivation, found.notation)])
    assert "Drawing of the system" not in page
    assert "<h2" in page


def test_the_applied_forces_are_in_the_figure_where_free_bodies_cannot_be_drawn() -> None:
    text = (
        "title: Drum\naxes: {i: right, j: up}\nparameters: [r, P, T, J]\ncoordinates: [phi]\n"
        "bodies: {drum: {inertia: J, position: 0*i, angle: phi, shape: {disc: r}}}\nforces:\n"
        "  held: {on: drum, at: -r*i, vector: -T*j}\n  pulled: {on: drum, at: r*i, vector: -P*j}\n"
    )
    found = report(read_problem(Source("case.yaml", text)), complete=False)
    drawn = [b.draw() for s in found.derivation.steps for b in s.body if isinstance(b, Picture)]
    [scene] = [scene for scene in drawn if scene is not None]
    assert {"P", "T"} <= {str(label.content) for label in scene.labels}
