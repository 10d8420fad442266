"""Equations that cannot be read, and why: undeclared names, or the method quoted without its Lagrangian."""

from __future__ import annotations

import re

from lagrange.answers.readings import Reading
from lagrange.expressions.characters import GREEK
from lagrange.expressions.scope import Scope

_ENERGY = r"(?:[LTVUEH]|\\?L|ℒ|𝓛|\\(?:mathcal|mathscr|mathfrak|cal)\s*\{?\s*[LTVU]\s*\}?)"
_QUOTED = re.compile(
    rf"(?:[d∂]|\\partial|\\mathrm\s*\{{\s*d\s*\}}|\bdiff\(|\bD\[|\bDerivative\(|\\p?dv\s*\{{)"
    rf"\s*\(?\{{?\s*(?P<name>{_ENERGY})(?:\(t\)|\[t\])?\s*\}}?\)?\s*(?:/|,|\}}\s*\{{|\{{)"
)


def quotes_the_method(reading: Reading | None, text: str, scope: Scope) -> bool:
    """Whether an unreadable line has derivatives of a Lagrangian, or an energy, that is not given anywhere."""
    if reading is None or reading.error is None:
        return False
    names = [m["name"][-2:].strip("{} ")[-1:] for m in _QUOTED.finditer(text)]
    return bool(names) and all(scope.scalar("L" if n in "ℒ𝓛" else n) is None for n in names)


def undeclared(reading: Reading | None, text: str) -> list[str]:
    """The undeclared names for which an equation could not be read; none if there is another reason."""
    if reading is None or reading.error is None:
        return []
    names = []
    for d in reading.error.diagnostics:
        match = re.match(r"`(\w+)` is (?:not declared|neither a function)", d.message)
        if d.code not in ("unknown-symbol", "unknown-function") or match is None:
            return []
        if d.code == "unknown-function" and not _multiplies(match[1], text):
            return []
        names.append(match[1])
    return names


def _multiplies(name: str, text: str) -> bool:
    """Whether a name before a parenthesis may be a factor, as in `S(x - a)`: a letter, and not applied to a number."""
    letters = {name, *(c for c, n in GREEK.items() if n == name)}
    calls = re.findall(rf"(?:{'|'.join(map(re.escape, letters))})\s*\(([^()]*)\)?", text)
    return (len(name) <= 3 or len(letters) > 1) and not any(re.fullmatch(r"\s*(?:\d+|t)\s*", c) for c in calls)


def is_name(text: str) -> bool:
    """Whether a text may be a name."""
    return bool(text) and (text[0].isalpha()) and text.replace("_", "").isalnum()
