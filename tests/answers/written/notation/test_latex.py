"""LaTeX with other commands than those that are read."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.written.notation.latex import (
    over_as_fraction,
    power_groups,
    products_with_numbers,
    rewritten_latex,
)
from lagrange.answers.written.reading import read_as_written
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.edits import Draft
from tests.support.scopes import PLANE
from tests.support.shared import loaded


@pytest.mark.parametrize(
    ("edits", "text", "written"),
    [
        (over_as_fraction, r"{a \over b}", r"\frac{a}{b}"),
        (power_groups, "x^(1/2)", "x^{1/2}"),
        (products_with_numbers, r"\dot x^2\,4c", r"\dot x^2\,\cdot 4c"),
        (products_with_numbers, "x_2 + 4c", "x_2 + 4c"),
    ],
)
def test_edits(edits, text: str, written: str) -> None:
    draft = Draft(Fragment.of(text))
    draft.apply(edits(text))
    assert draft.text.replace(" ", "") == written.replace(" ", "")


@pytest.mark.parametrize("text", [r"m\,\ddot{x} = {-k x \over 1}", r"m \ddot x &= -kx \\", r"\boxed{m\ddot x=-k\,x}"])
def test_the_meaning_is_kept(text: str) -> None:
    assert (
        read_as_written(Fragment.of(text), PLANE).components
        == read_as_written(Fragment.of("m x'' = -k x"), PLANE).components
    )
    assert rewritten_latex(Fragment.of(r"\ddot x = a"), PLANE).text == r"\ddot x = a"


@pytest.mark.parametrize(
    "written",
    [
        r"\ddot x = \frac{\partial f}{\partial x}\left(g + x\right)",
        r"\ddot x = \frac{df}{dx}(g + x)",
        r"\ddot x = f'(x)(g + x)",
        "x'' = f'(x)*(g + x)",
    ],
)
def test_brackets_after_a_derivative_are_a_factor(written: str) -> None:
    scope = loaded("bead-on-any-wire").scope
    [plain] = read_as_written(Fragment.of("x'' = diff(f, x)*(g + x)"), scope).components
    assert sp.expand(read_as_written(Fragment.of(written), scope).components[0] - plain) == 0


@pytest.mark.parametrize(
    "written", [r"\ddot x = \frac{d^2 f}{dx^2}", r"\ddot x = f''(x)", r"\ddot x = f''", "x'' = f''(x)"]
)
def test_second_derivatives_of_functions(written: str) -> None:
    scope = loaded("bead-on-any-wire").scope
    [plain] = read_as_written(Fragment.of("x'' = diff(diff(f, x), x)"), scope).components
    assert sp.expand(read_as_written(Fragment.of(written), scope).components[0] - plain) == 0
