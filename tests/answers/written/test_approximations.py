"""What stands beside a result: its unit, and its value rounded."""

from __future__ import annotations

import pytest

from lagrange.answers.written.approximations import exact_results
from lagrange.core.diagnostics import Fragment


@pytest.mark.parametrize(
    ("lines", "kept"),
    [
        (["cos θ = 2/3, i.e. θ ≈ 48.19°"], ["cos θ = 2/3"]),
        (["(a) v = 1", "(b) T = 2"], ["v = 1", "T = 2"]),
        (["(a) x'' = 1"], ["(a) x'' = 1"]),
        ([r"\cos\theta=\frac23\Rightarrow\theta\approx 48"], [r"\cos\theta=\frac23"]),
        ([r"\omega_+ = 1"], [r"\omega_{plus} = 1"]),
    ],
)
def test_what_stands_beside_a_result(lines: list[str], kept: list[str]) -> None:
    assert [f.text.strip() for f in exact_results([Fragment.of(line) for line in lines])] == kept
