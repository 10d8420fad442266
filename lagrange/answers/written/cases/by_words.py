r"""The sense of a motion that a word or a lone sign gives: as a condition, or as the sign of the velocity.

    m x'' = -k x - mu m g  (moving right)       m x'' = -k x - mu m g  (x' > 0)
    m x'' + k x = ∓ mu m g                      m x'' + k x = - sign(x') mu m g

The velocity is that of the one acceleration in the line. To the right is the positive sense of a coordinate. The upper
sign of a ∓ is for a positive velocity; which case comes first in a ± is not known, and it stays as it is.
"""

from __future__ import annotations

import re
from unicodedata import normalize

_ACCELERATION = re.compile(
    r"(?P<primed>[^\W\d_]\w{0,12})(?:''|″)|\\ddot\s*\{?\s*(?P<latex>\\?[A-Za-z]{1,12}(?:_\w)?)\s*\}?|(?P<dotted>[^\W\d_])\u0308"
)
_MOVING = re.compile(
    r"\b(?:(?:it|the\s+\w{1,12})\s+)?(?:is\s+|when\s+|while\s+)?(?:moving|moves|motion|slides|sliding)\s+(?:to\s+the\s+)?(?P<to>right|left)(?:wards?)?\b",
    re.IGNORECASE,
)
_MINUS_PLUS = re.compile(r"∓|\\mp(?![A-Za-z])")
_TOLD = re.compile(r"[<>≤≥]|\\[lg](?:t|eq?)(?![A-Za-z])")
"""A condition stands there in signs already."""
_UPPER = re.compile(r"\b(?:upper|lower)\b", re.IGNORECASE)


def with_senses(text: str) -> str:
    """The text with conditions for words like `moving right`, and without ∓ where a velocity has its sign."""
    moving = _MOVING.search(text) is not None
    alone = _MINUS_PLUS.search(text) is not None and not _UPPER.search(text)
    if not moving and not alone:
        return text
    return "".join(_of_line(line, alone) for line in text.splitlines(keepends=True))


def _of_line(line: str, alone: bool) -> str:
    names = {m["primed"] or m["latex"] or m["dotted"] for m in _ACCELERATION.finditer(normalize("NFD", line))}
    if len(names) != 1:
        return line
    latex = "\\" in line
    [name] = names
    rate = rf"\dot{{{name}}}" if latex else f"{name}'"
    if not _TOLD.search(line):
        line = _MOVING.sub(lambda m: f"{rate} {'>' if m['to'].lower() == 'right' else '<'} 0", line)
    if alone and len(_MINUS_PLUS.findall(line)) == 1:
        sign = rf"- \operatorname{{sgn}}\left({rate}\right)\cdot " if latex else f"- sign({rate})*"
        line = _MINUS_PLUS.sub(lambda _: sign, line)
    return line
