"""Lines in runs of one style each."""

from __future__ import annotations

from lagrange.render.styled_text import Styled

LINE = Styled.assemble("two ", ("bold", "bold"), " words  ")


def test_a_part_keeps_the_styles_of_its_runs() -> None:
    assert LINE.plain == "two bold words  "
    assert LINE[2:6].runs == (("o ", ""), ("bo", "bold"))
    assert LINE[6:].runs == (("ld", "bold"), (" words  ", ""))
    assert LINE[:] is LINE
    assert not LINE[3:3]


def test_lines_are_joined_stripped_and_added() -> None:
    assert LINE.stripped().plain == "two bold words"
    comma = Styled(", ", "dim")
    assert comma.joined([Styled("a"), Styled("b")]).runs == (("a", ""), (", ", "dim"), ("b", ""))
    assert comma.joined([]).runs == ()
    assert (Styled("a") + Styled() + Styled("b", "bold")).runs == (("a", ""), ("b", "bold"))
