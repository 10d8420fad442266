r"""The width of LaTeX in ems, estimated: enough to see whether an equation fits on a line.

Letters have their widths in Computer Modern; relations and signs have the space around them; a fraction is
as wide as the wider of its parts, indices are set at seven tenths. Errors stay within a few percent of a
line.
"""

from __future__ import annotations

import re

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|[^\s]", re.DOTALL)
_LETTERS = {"m": 0.88, "w": 0.72, "i": 0.35, "j": 0.41, "l": 0.3, "f": 0.55, "t": 0.36, "r": 0.46, "s": 0.47}
_COMMANDS = {
    r"\quad": 1.0,
    r"\qquad": 2.0,
    r"\,": 0.17,
    r"\;": 0.28,
    r"\cdot": 0.72,
    r"\wedge": 1.1,
    r"\neq": 1.34,
    r"\le": 1.34,
    r"\ge": 1.34,
    r"\approx": 1.34,
    r"\equiv": 1.34,
    r"\to": 1.56,
    r"\propto": 1.34,
    r"\partial": 0.6,
    r"\lvert": 0.28,
    r"\rvert": 0.28,
    r"\omega": 0.65,
    r"\psi": 0.67,
    r"\left": 0.2,
    r"\right": 0.2,
    r"\infty": 1.0,
}
_TRANSPARENT = frozenset(
    {r"\dot", r"\ddot", r"\dddot", r"\mathbf", r"\mathit", r"\mathrm", r"\boldsymbol", r"\boxed", r"\emph"}
)
_FUNCTION = re.compile(r"\\(?:arc)?(?:sin|cos|tan)h?\Z|\\(?:cot|sec|csc|ln|exp)\Z")


def ems(code: str) -> float:
    """The width of a piece of LaTeX, math or text."""
    tokens = _TOKEN.findall(code)
    width, _ = _row(tokens, 0)
    return width


def _row(tokens: list[str], at: int) -> tuple[float, int]:
    """The width of what stands up to the end of a group, and where that is."""
    width = 0.0
    while at < len(tokens) and tokens[at] != "}":
        if tokens[at] in "^_":
            scripts = []
            while at < len(tokens) and tokens[at] in "^_":
                script, at = _atom(tokens, at + 1)
                scripts.append(0.72 * script)
            width += max(scripts) + 0.05
        else:
            more, at = _atom(tokens, at)
            width += more
    return width, at


def _atom(tokens: list[str], at: int) -> tuple[float, int]:
    if at >= len(tokens):
        return 0.0, at
    token = tokens[at]
    at += 1
    if token == "{":
        width, at = _row(tokens, at)
        return width, at + 1
    if token in (r"\frac", r"\tfrac"):
        above, at = _atom(tokens, at)
        below, at = _atom(tokens, at)
        return (0.75 if token == r"\tfrac" else 1.0) * max(above, below) + 0.24, at
    if token == r"\sqrt":
        inner, at = _atom(tokens, at)
        return inner + 0.9, at
    if token in (r"\text", r"\operatorname"):
        inner, at = _atom(tokens, at)
        return 1.15 * inner + 0.2, at
    if token in _TRANSPARENT:
        return _atom(tokens, at)
    return _width(token), at


def _width(token: str) -> float:
    if token in _COMMANDS:
        return _COMMANDS[token]
    if _FUNCTION.match(token):
        return 0.46 * (len(token) - 1) + 0.17
    if token.startswith("\\"):
        return 0.6
    if token in "+-":
        return 1.22
    if token in "=<>":
        return 1.34
    if token in "()[]|":
        return 0.39
    if token in ",.:;":
        return 0.4
    if token.isdigit():
        return 0.5
    if token == "$":
        return 0.0
    return _LETTERS.get(token, 0.77 if token.isupper() else 0.53)
