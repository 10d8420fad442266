"""A name that brings its words along."""

from __future__ import annotations

from lagrange.core.called import Called


def test_a_name_with_words_is_the_name_in_every_other_respect() -> None:
    upper = Called("P1", "upper particle")
    assert upper == "P1"
    assert {upper: 1}["P1"] == 1
    assert f"r_{upper}" == "r_P1"
    assert upper.words == "upper particle"
    assert Called("P1").words == ""
