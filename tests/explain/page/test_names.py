"""Names on a page: short where nothing else could be meant, in full for programs.

A denominator that several results share has a letter, and the same value.
"""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp

from lagrange.document.derivation import Display, Equation, Rule, Step, display
from lagrange.explain.page.names import with_named_denominators
from lagrange.explain.report import report
from lagrange.mechanics.meaning import meaning
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
        ("rolling-disc", ("𝛚 = ", "𝐧₁ = cos φ 𝐢", "λ₁ and λ₂", "δπ₁ = δθ"), ("𝛚_disc", "𝐧₁_disc", "λ_rolling", "δπ_ω")),
        ("furuta-pendulum", ("𝐞₂ = ", "𝐫_rod"), ("𝐞₂_rod",)),
        ("governor", ("The position of the first ball, of mass m, is 𝐫₁ =",), ("_one", "_other")),
        ("step-ladder", ("F₁ along", "λ_hinge₁"), ("F_rub", "hinge.1")),
    ],
)
def test_an_index_that_says_nothing_is_dropped(name: str, has: tuple[str, ...], has_not: tuple[str, ...]) -> None:
    written = " ".join(page(name).split())
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


# Denominators


a, b, c, d, x, y = sp.symbols("a b c d x y", real=True)
LONG = a * b * c + a**2 * d + b**2 * d + c * d * (a + b)


def box(*equations: Equation, taken: tuple[str, ...] = ()) -> tuple[Equation, ...]:
    step = with_named_denominators(Step(Rule.SOLVED_REACTIONS, "", (display(*equations, boxed=True),)), taken)
    [block] = step.body
    assert isinstance(block, Display)
    return block.equations


def test_a_shared_denominator_is_named_and_stands_in_the_box() -> None:
    lines = (Equation((x, a / LONG)), Equation((y, b * (a + c) / LONG)))
    named = box(*lines)
    letter, value = named[-1].sides
    assert (letter.name, value) == ("Delta", LONG)
    assert [e.sides[1].xreplace({letter: value}) for e in named[:-1]] == [e.sides[1] for e in lines]


def test_a_short_one_or_one_that_is_not_shared_is_not_named() -> None:
    for lines in (
        (Equation((x, a / (b + c))), Equation((y, b / (b + c)))),
        (Equation((x, a / LONG)), Equation((y, b / (LONG + 1)))),
    ):
        assert box(*lines) == lines


def test_the_letter_is_free() -> None:
    assert box(Equation((x, a / LONG)), Equation((y, b / LONG)), taken=("Delta",))[-1].sides[0].name == "D"


def test_constant_accelerations_solve_the_equations() -> None:
    said = meaning(reported("double-atwood", complete=False).solution)
    assert said is not None
    assert said.view.motion is not None
    assert len(said.constant) == 2
    assert all(sp.cancel(e.expression.xreplace(dict(said.constant))) == 0 for e in said.view.motion.final)


def test_nothing_is_solved_where_accelerations_depend_on_the_position() -> None:
    said = meaning(reported("ex10-double-pendulum", complete=False).solution)
    assert said is not None
    assert not said.constant
