"""Names on a page: short where nothing else could be meant, in full for programs."""

from __future__ import annotations

from pathlib import Path

import pytest

from lagrange.explain.report import report
from lagrange.problem.loader import load
from lagrange.render import html, json, latex, terminal
from tests.support.shared import SHIPPED, reported


def page(name: str) -> str:
    r = reported(name, complete=False)
    return terminal.text(r.derivation, r.notation, 80)


@pytest.mark.parametrize(
    ("name", "has", "has_not"),
    [
        ("ex11-ideal-pendulum", ("m 𝐫̈ = 𝐅 + 𝐑", "T = (m/l)"), ("𝐫_P", "T_rod")),
        ("ex17-spherical-pendulum", ("𝐫 = r 𝐞_r", "𝐑 = −T 𝐞_r"), ("𝐫_P", "T_length")),
        ("ex18-double-pendulum", ("𝐫_P₁", "T_upper =", "T_lower ="), ("T_upper_rod",)),
        ("ex01-horizontal-surface", ("λ = −F_z",), ("λ_plane",)),
        ("rolling-disc", ("𝛚 = ", "𝐧₁ = cos φ 𝐢"), ("𝛚_disc", "𝐧₁_disc")),
    ],
)
def test_an_index_that_says_nothing_is_dropped(name: str, has: tuple[str, ...], has_not: tuple[str, ...]) -> None:
    written = page(name)
    assert [text for text in has if text not in written] == []
    assert [text for text in has_not if text in written] == []


def test_latex_and_web_pages_have_the_same_names() -> None:
    r = reported("ex11-ideal-pendulum", complete=False)
    assert r"m \ddot{\mathbf{r}} = \mathbf{F} + \mathbf{R}" in latex.render([(r.derivation, r.notation)])
    assert "<mtext>rod</mtext>" not in html.render([(r.derivation, r.notation)])


def test_programs_and_screen_readers_have_the_names_that_are_read_back() -> None:
    r = reported("ex11-ideal-pendulum")
    assert "T_rod" in json.render([r])
    assert 'aria-label="m*r_P\'&#x27; = F_P + R_P"'.replace("'&#x27;", "&#x27;&#x27;") in html.render(
        [(r.derivation, r.notation)]
    )


def test_a_letter_that_the_file_uses_is_not_taken(tmp_path: Path) -> None:
    """A pendulum with a parameter T has the tension T_rod; a scalar r stands beside the vector r, which is bold."""
    text = SHIPPED["ex11-ideal-pendulum"].read_text(encoding="utf-8").split("answers:")[0]
    file = tmp_path / "pendulum.yaml"
    file.write_text(text.replace("parameters:", "parameters:\n  T: {assume: positive, meaning: a time}", 1))
    r = report(load(str(file)), complete=False)
    assert "T_rod = (m/l)" in terminal.text(r.derivation, r.notation, 80)
