"""What a notebook gets in one piece: every form that an object can be shown in, by its MIME type.

Jupyter asks for `_repr_mimebundle_` first, with the types that it wants, and then for each form that was not in it.
"""

from __future__ import annotations

from collections.abc import Collection

FORMS = {"text/html": "_repr_html_", "text/latex": "_repr_latex_", "text/markdown": "_repr_markdown_"}


def mime_bundle(
    shown: object, include: Collection[str] | None = None, exclude: Collection[str] | None = None
) -> dict[str, str]:
    """The forms of an object; `include` and `exclude` are MIME types, None: all, none."""
    wanted = [m for m in ("text/plain", *FORMS) if (include is None or m in include) and m not in (exclude or ())]
    bundle = {}
    for mime in wanted:
        form = shown.__repr__ if mime == "text/plain" else getattr(shown, FORMS[mime], None)
        text = form() if form is not None else None
        if text is not None:
            bundle[mime] = text
    return bundle


class Shown:
    """An object that a notebook shows in all its forms."""

    __slots__ = ()

    def _repr_mimebundle_(
        self, include: Collection[str] | None = None, exclude: Collection[str] | None = None
    ) -> dict[str, str]:
        return mime_bundle(self, include, exclude)
