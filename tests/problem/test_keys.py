"""docs/problem-files.md: its tables of keys are what `lagrange.problem.keys` declares."""

from __future__ import annotations

from lagrange.problem.keys import FORMS
from lagrange.problem.yaml.kinds import AnyOf, Keys, Kind, ListOf, Named, OneOf
from tests.support.paths import ROOT

PAGE = (ROOT / "docs" / "problem-files.md").read_text(encoding="utf-8")
BEGIN, END = "<!-- keys: begin -->\n", "<!-- keys: end -->\n"


def written(kind: Kind) -> str:
    """A kind of value in words."""
    match kind:
        case str():
            return kind
        case OneOf(words=words):
            return " or ".join(", ".join(f"`{word}`" for word in words).rsplit(", ", 1))
        case ListOf(item=item, least=least, most=most):
            number = {(2, 2): "two ", (3, 3): "three "}.get((least, most), "")
            return f"list of {number}{plural(item)}"
        case Named(value=value):
            return f"name: {written(value)}"
        case AnyOf(kinds=(one, ListOf(item=item, least=0, most=None))) if one == item:
            return f"{written(one)}; or a list of these"
        case AnyOf(kinds=kinds):
            return ", or ".join(written(k) for k in kinds if k != "nothing")
        case Keys(title=title):
            return title


def plural(kind: Kind) -> str:
    if isinstance(kind, ListOf):
        return written(kind).replace("list", "lists", 1)
    assert isinstance(kind, str)
    return f"{kind}s"


def tables() -> str:
    """All forms, each with a row for each key; required keys are bold."""
    parts = []
    for form in FORMS:
        name = form.title[0].upper() + form.title[1:]
        rows = [
            f"| {f'**`{key.name}`**' if key.required else f'`{key.name}`'} | {written(key.kind)} | {key.meaning} |\n"
            for key in form.keys
        ]
        parts.append(f"| {name} | value | |\n|---|---|---|\n{''.join(rows)}")
    return "\n".join(parts)


def test_the_page_has_the_declared_keys() -> None:
    assert BEGIN in PAGE
    assert END in PAGE
    on_page = PAGE[PAGE.index(BEGIN) + len(BEGIN) : PAGE.index(END)]
    assert on_page == tables(), f"put this between the two comments of docs/problem-files.md:\n\n{tables()}"


def test_every_form_is_listed_once_and_no_key_twice_in_one() -> None:
    assert len({form.title for form in FORMS}) == len(FORMS)
    for form in FORMS:
        assert len(set(form.names)) == len(form.names), form.title


def test_a_required_key_has_an_example() -> None:
    assert [key.name for form in FORMS for key in form.keys if key.required and not key.example] == []
