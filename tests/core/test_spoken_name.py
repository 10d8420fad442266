"""A name that brings its words along."""

from __future__ import annotations

from lagrange.core.spoken_name import SpokenName


def test_a_name_with_words_is_the_name_in_every_other_respect() -> None:
    upper = SpokenName("P1", "upper particle")
    assert upper == "P1"
    assert {upper: 1}["P1"] == 1
    assert f"r_{upper}" == "r_P1"
    assert upper.words == "upper particle"
    assert SpokenName("P1").words == ""
