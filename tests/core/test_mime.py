"""The forms of an object in one bundle."""

from __future__ import annotations

from lagrange.core.mime import Shown, mime_bundle


class Bob(Shown):
    def __repr__(self) -> str:
        return "<bob>"

    def _repr_html_(self) -> str:
        return "<b>bob</b>"

    def _repr_latex_(self) -> None:
        return None


def test_every_form_that_there_is() -> None:
    assert Bob()._repr_mimebundle_() == {"text/plain": "<bob>", "text/html": "<b>bob</b>"}


def test_only_what_is_asked_for() -> None:
    assert mime_bundle(Bob(), include={"text/html", "text/latex"}) == {"text/html": "<b>bob</b>"}
    assert mime_bundle(Bob(), exclude={"text/html"}) == {"text/plain": "<bob>"}
