"""Words on stability, and conditions, beside an equation."""

from __future__ import annotations

import pytest

from lagrange.answers.written.remarks import CONDITIONAL, STABILITY


@pytest.mark.parametrize(
    ("text", "remark"),
    [
        ("theta = 0, stable for W < c h", ", stable for W < c h"),
        ("theta = pi is unstable", " is unstable"),
        ("theta = 0 (stable if c b^2 > W l)", "(stable if c b^2 > W l)"),
        ("x = a unstabled", None),  # another word
        ("x = 2 a", None),
    ],
)
def test_words_on_stability(text: str, remark: str | None) -> None:
    match = STABILITY.search(text)
    assert (match and match[0].rstrip()) == remark


def test_a_condition_of_existence() -> None:
    match = CONDITIONAL.search("cos(theta) = W/(c b) (only if W < c b)")
    assert match is not None
    assert match[0] == "(only if W < c b)"
    assert CONDITIONAL.search("x = (a + b) (c - d)") is None
