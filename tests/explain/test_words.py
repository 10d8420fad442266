"""Numbers and lists in words."""

from __future__ import annotations

from lagrange.explain.words import in_words, spoken


def test_numbers_and_names_in_words() -> None:
    assert [in_words(n, "relation") for n in (0, 1, 2, 13)] == [
        "no relation", "one relation", "two relations", "13 relations",
    ]  # fmt: skip
    assert spoken("upper_rod") == "upper rod"
    assert spoken("no_slip.2") == "no slip 2"
