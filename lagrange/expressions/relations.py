"""Inequalities `left >= right`: the equation of their limit, and the side that they permit."""

from __future__ import annotations

import re
from dataclasses import replace

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError

_SIDES = {">=": 1, "≥": 1, "⩾": 1, "<=": -1, "≤": -1, "⩽": -1}
_SIDES |= {rf"\{name}": side for side, end in ((1, "ge"), (-1, "le")) for name in (end, f"{end}q", f"{end}qslant")}
_STRICT = {">": 1, "<": -1}
_INEQUALITY = re.compile(r"[<>]=?|[≤≥⩽⩾]|\\[gl]e(?:q(?:slant)?)?(?![A-Za-z])")


def is_inequality(fragment: Fragment) -> bool:
    """Whether a text has one of the signs of an inequality."""
    return _INEQUALITY.search(fragment.text) is not None


def limit_of(fragment: Fragment, what: str, strict: bool = False) -> tuple[Fragment, int | None]:
    """The equation at the limit of an inequality, and its side: +1 for left ≥ right, −1 for ≤; an equation has None.

    strict  whether `<` and `>` are read as `<=` and `>=`

    Raises ProblemError if there are several relations.
    """
    signs = [*_INEQUALITY.finditer(fragment.text)]
    if not signs:
        return fragment, None
    first = signs[0]
    place = fragment.span(first.start(), first.end())
    if len(signs) > 1 or "=" in fragment.text[: first.start()] + fragment.text[first.end() :]:
        help_ = "write each by itself"
        if apart := re.search(r"[<>]\s+=", fragment.text):
            help_ = f"write `{apart[0][0]}=` without a space"
        raise ProblemError(Diagnostic("inequality", f"{what} has several relations", place, help=help_))
    if first[0] in _STRICT and not strict:
        message = f"`{first[0]}` excludes contact itself"
        help_ = f"write `{first[0]}=`: while there is contact, the two sides are equal"
        raise ProblemError(Diagnostic("inequality", message, place, help=help_))
    text = f"{fragment.text[: first.start()]}{'=':<{len(first[0])}}{fragment.text[first.end() :]}"
    return replace(fragment, text=text), (_SIDES | _STRICT)[first[0]]
