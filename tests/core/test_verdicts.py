"""Kleene's logic of three values."""

from __future__ import annotations

import pytest

from lagrange.core.verdicts import all_hold


@pytest.mark.parametrize(
    ("verdicts", "expected"),
    [([], True), ([True, True], True), ([True, None], None), ([None, False, True], False), ([False], False)],
)
def test_undecided_is_not_false(verdicts: list[bool | None], expected: bool | None) -> None:
    assert all_hold(verdicts) is expected
