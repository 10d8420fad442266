"""Values in a file of answers as people write them in a form: `two`, `6 - 1 = 5`, `holonomic and scleronomic`, `yes`.

In a problem file these are mistakes; in a file of answers they are read.
"""

from __future__ import annotations

import re

_NUMBERS = {
    "zero": 0, "no": 0, "none": 0, "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7,
    "null": 0, "keine": 0, "ein": 1, "eins": 1, "einen": 1, "zwei": 2, "drei": 3, "vier": 4, "fünf": 5, "sechs": 6,
}  # fmt: skip
_ONLY = (
    r"(?i)\s*\$?\s*(?:[A-Za-z]{1,3}\s*=|DOFs?\s*[:=]?|there\s+(?:are|is))?\s*(?P<chain>(?:[0-9]{1,2}|[^\W\d_]+)(?:\s*(?:[-−–+*·=]|\\cdot)\s*[0-9]{1,2})*)"
    r"\s*\$?\s*(?:degrees?(?:[ -]of[ -]freedom)?|DOFs?|Freiheitsgrade?)?\s*\.?\s*"
)
_NEGATED = r"(?i)(?:not|non|nicht|an|no)[\s-]*"
_STEMS = (
    ("holonom", "holonomic", "nonholonomic"),
    ("acatastat", "acatastatic", "catastatic"),
    ("akatastat", "acatastatic", "catastatic"),
    ("catastat", "catastatic", "acatastatic"),
    ("katastat", "catastatic", "acatastatic"),
    ("scleronom", "scleronomic", "rheonomic"),
    ("skleronom", "scleronomic", "rheonomic"),
    ("rheonom", "rheonomic", "scleronomic"),
)
_SEPARATOR = r"(?i)\s*(?:[,;/&+]|\band\b|\bund\b|\bet\b|\bbut\b|\baber\b)\s*"
_TRUE = frozenset({"true", "yes", "y", "ja", "oui", "integrable", "holonomic", "1"})
_FALSE = frozenset({"false", "no", "n", "nein", "non", "not integrable", "nonintegrable", "nonholonomic", "0"})


def whole_number_in(text: str) -> int | None:
    """The whole number that a text states, of a chain of equations the last; None if it states none."""
    match = re.fullmatch(_ONLY, text)
    if match is None:
        return None
    parts = re.split(r"=", match["chain"])
    terms = re.split(r"\s*([-−–+]|\*|·|\\cdot)\s*", parts[-1].strip())
    if not all(x.isdigit() or x.lower() in _NUMBERS for x in terms[::2]):
        return None
    total, *values = [int(x) if x.isdigit() else _NUMBERS[x.lower()] for x in terms[::2]]
    for sign, value in zip(terms[1::2], values, strict=True):
        total = total + value if sign == "+" else total - value if sign in "-−–" else total * value
    return total


def classes_in(text: str) -> tuple[str, ...]:
    """The classes that a text names; none if there is anything else in it."""
    classes = []
    for part in filter(None, re.split(_SEPARATOR, text.strip(" ."))):
        negated = re.match(_NEGATED, part)
        word = part[negated.end() :] if negated else part
        meant = [(a, b) for stem, a, b in _STEMS if re.fullmatch(rf"{stem}[a-z]{{0,5}}", word, re.IGNORECASE)]
        if not meant:
            return ()
        classes.append(meant[0][1] if negated else meant[0][0])
    return tuple(classes)


def truth_in(text: str) -> bool | None:
    """Whether a text says yes or no; None if neither."""
    word = text.strip(" .").lower()
    return True if word in _TRUE else False if word in _FALSE else None
