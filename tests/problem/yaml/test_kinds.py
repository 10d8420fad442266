"""What a value in a problem file may be."""

from __future__ import annotations

from lagrange.problem.yaml.kinds import AnyOf, Key, Keys, ListOf, one_or_list, or_nothing, three

FORM = Keys(
    "a particle", (Key("mass", "expression", "Its mass.", required=True), Key("at", "text", "Where.", example="here"))
)


def test_a_form_knows_its_keys() -> None:
    assert list(FORM.names) == ["mass", "at"]
    assert FORM.example("at") == "here"


def test_short_kinds() -> None:
    assert or_nothing("text") == AnyOf(("text", "nothing"))
    assert three("number") == ListOf("number", 3, 3)
    assert isinstance(one_or_list("text"), AnyOf)
