"""Several values of one quantity in one line."""

from __future__ import annotations

import pytest

from lagrange.answers.written.listed_values import with_listed_values
from lagrange.core.diagnostics import Fragment


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("theta = 0, pi", "theta = 0 or theta = pi"),
        ("θ = 0 or π, or cos θ = W/c", "θ = 0 or θ = π or cos θ = W/c"),
        ("theta = ±acos(W/c)", "theta = +acos(W/c) or theta = -acos(W/c)"),
        ("theta = {0, pi}", "theta = 0 or theta = pi"),
        ("x = 0, y = l", "x = 0, y = l"),
        ("theta = 0, as expected", "theta = 0, as expected"),
    ],
)
def test_listed_values(text: str, read: str) -> None:
    assert with_listed_values(Fragment.of(text)).text == read
