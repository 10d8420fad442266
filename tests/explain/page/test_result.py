"""The box at the head: what the problem asks, with the stability of equilibria beside them."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Detail, Display, Rule, Step
from lagrange.explain.report import Report
from lagrange.render import terminal
from tests.support.shared import reported


def box(r: Report) -> str:
    first: Step = r.derivation.page[0]
    assert first.rule is Rule.RESULT
    [display] = [b for b in first.body if isinstance(b, Display)]
    assert display.boxed
    page = terminal.text(r.derivation, r.notation, 120)
    return page[: page.index(" 1  ")]


@pytest.mark.parametrize(
    ("name", "contained"),
    [
        ("ex16-rod-on-two-planes", ("One degree of freedom; the equilibrium", "tan θ = (2k − 1)/tan α    unstable")),
        ("rod-in-bowl", ("the equilibrium:", "where 2r ≥ a")),
        ("inverted-pendulum-springs", ("the equilibria", "stable where b² c > l W")),
        ("leaving-a-sphere", ("what is asked", "cos θ = 2/3", "θ ≈ 48.19°")),
        ("released-pendulum", ("T = m g (3 − 2 cos α)    when θ = 0",)),
        ("ladder-on-rough-ground", ("the conditions of rest", "tan θ = 2μ/(1 − μ ν)    at the limit")),
        ("cylinder-on-rough-incline", ("⅓ tan α ≤ μ_s",)),
        ("conical-pendulum", ("steady motions", "cos θ = g/(l φ̇²)")),
        ("double-pendulum-small-oscillations", ("small oscillations", "ω₁² = g (2 − √2)/l", "stable")),
        ("spherical-pendulum-by-routh", ("Hamilton's function", "H = p_θ²")),
    ],
)
def test_the_box_contains_what_is_asked(name: str, contained: tuple[str, ...]) -> None:
    found = box(reported(name, complete=False))
    for line in contained:
        assert line in found


@pytest.mark.parametrize("name", ["ex16-rod-on-two-planes", "beads-on-hoop"])
def test_brief_pages_say_what_is_stable(name: str) -> None:
    r = reported(name, complete=False)
    page = terminal.text(r.derivation, r.notation, 80, Detail.BRIEF)
    assert "stable" in page[page.index(" 1  ") :]


def test_stability_of_the_linear_equations_alone_is_called_so() -> None:
    assert "stable to first order where P <" in box(reported("ziegler-column", complete=False))
