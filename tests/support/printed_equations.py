"""The equations of a problem in JSON, and whether they can be read again."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

from lagrange.answers.references import Reference
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.expressions.reader import read_equation

EQUATIONS = ("equation", "equations", "possible_displacements", "virtual_displacements", "newton", "equilibrium")


def equations_in(found: Any) -> Iterator[str]:
    """The equations of a JSON object, wherever in it they are."""
    if isinstance(found, dict):
        for key, value in found.items():
            if key == "steps":
                yield from (e["text"] for s in value for b in s["body"] for e in b.get("equations", ()) if "text" in e)
            elif key in EQUATIONS and not isinstance(value, int):  # the count of unknowns has a number
                yield from texts(value)
            else:
                yield from equations_in(value)
    elif isinstance(found, list):
        for item in found:
            yield from equations_in(item)


def texts(value: Any) -> Iterator[str]:
    """A text, or those in lists of lists of them."""
    if isinstance(value, str):
        yield value
    else:
        for item in value:
            yield from texts(item)


def unreadable(text: str, reference: Reference) -> list[str]:
    """Why an equation cannot be read back, if so. One with several signs = is read as one for each."""
    sides = text.split(" = ")
    faults = []
    for left, right in pairwise(sides):
        try:
            read_equation(Fragment.of(f"{left} = {right}"), reference.scope)
        except ProblemError as error:
            faults.append(f"cannot be read back: {text}: {error}")
    return faults
