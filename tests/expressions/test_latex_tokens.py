"""Signs between factors: spaces, dots, primes, carets."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.expressions.latex_layout import piece
from lagrange.expressions.latex_names import NOTHING, SPACES
from lagrange.expressions.reader import Scope, read_value
from tests.support.expression_texts import same, scope

SCOPE = scope(
    "k", "omega", "omega_0", "I", "alpha", "L", "M", "m_12", "b2", "theta_1_B", "F_C", "ab", "a", "b", "ba", "rho"
)


def latex(text: str) -> Fragment:
    return piece(Fragment.of(text), 0, len(text))


def value(text: str, known: Scope = SCOPE, notes: list[Diagnostic] | None = None) -> object:
    return read_value(latex(text), known, notes, latex=True)


def means(text: str, plain: str, known: Scope = SCOPE) -> bool:
    return same(value(text, known), read_value(Fragment.of(plain), known))  # type: ignore[arg-type]


x, theta, phi = (sp.Symbol(n, real=True) for n in ("x", "theta", "phi"))
thetadd = sp.Symbol("theta''", real=True)
m, l, g = (sp.Symbol(n, positive=True) for n in ("m", "l", "g"))


@pytest.mark.parametrize(
    "space", [*(f"\\{s}" for s in SPACES if s != "hspace"), *(f"\\{n}" for n in NOTHING), "~", "{}", " ", "\n"]
)
def test_each_space_means_nothing_between_factors(space: str) -> None:
    assert means(f"m{space} x{space} + y{space}", "m*x + y")
    if space != "{}":
        assert means(rf"\sin{space} \theta{space} \cos\theta", "sin(theta)*cos(theta)")


def test_dots_are_not_products_and_primes_are_not_dropped() -> None:
    """What the usual reader of LaTeX makes of these."""
    assert value(r"\ddot\theta") == thetadd
    assert value(r"\theta''") == thetadd
    assert value(r"\ddot\theta") != sp.Symbol("ddot") * theta


def refused(text: str, known: Scope = SCOPE) -> tuple[Diagnostic, ...]:
    with pytest.raises(ProblemError) as caught:
        value(text, known)
    return caught.value.diagnostics


def test_the_caret_covers_what_is_meant() -> None:
    def marked(text: str) -> str:
        span = refused(text)[0].span
        assert span is not None
        return text[span.start : span.end]

    assert marked(r"x + \ddot{\theta}_{3}^2 + y") == r"\ddot{\theta}_{3}"
    assert marked(r"x + \omega^2_7") == r"\omega"
    assert marked(r"m g \foo{x}") == r"\foo"
    assert marked(r"\frac{x}{\frac{q}{2}}") == "q"
    assert marked(r"x + \left(y \right]") == r"\right]"
    assert marked("x % q {\n + q_1") == "q_1"
    assert marked(r"x + \mathrm{rood}^2") == r"\mathrm{rood}"
