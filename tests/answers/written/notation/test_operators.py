"""D and d/dt before what they differentiate."""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.operators import with_operators
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.edits import Draft


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("m D^2 r - m r (D phi)^2", "m diff(diff(r, t), t) - m r (diff(phi, t))^2"),
        ("2 D r D phi", "2 diff(r, t) diff(phi, t)"),
        ("Dx + D²θ", "diff(x, t) + diff(diff(θ, t), t)"),
        ("D(m r^2 D phi)", "diff((m r^2 diff(phi, t)), t)"),
        ("(m D^2 + b D + c) x", "(m diff(diff(x, t), t) + b diff(x, t) + c x)"),
    ],
)
def test_the_operator_d(text: str, written: str) -> None:
    draft = Draft(Fragment.of(text))
    with_operators(draft, frozenset({"x"}))
    assert draft.text == written
