"""Degrees of freedom and classification, as they are written in sentences.

    6 - 1 = 5 degrees of freedom      DOF = 2      f = 6 - 1 = 5      Freiheitsgrade: 5
    holonomic, scleronomic            not holonomic                   nicht holonom

Numbers are added and subtracted; of several numbers of degrees of freedom the last one counts.
"""

from __future__ import annotations

import re

from lagrange.answers.limits import LONGEST_IN_WORDS
from lagrange.core.diagnostics import Fragment
from lagrange.problem.model import Answers

_FREEDOM = (
    r"(?:\bD\.?O\.?F\.?s?\b|\bdof\b|degrees?[- ]of[- ]freedom"
    r"|Freiheitsgrade?n?|degrés?\s+de\s+liberté|grados?\s+de\s+libertad)"
)
_WORDS = {"one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "single": 1, "zero": 0, "no": 0}
_WORDS |= {
    "ein": 1,
    "einen": 1,
    "zwei": 2,
    "drei": 3,
    "vier": 4,
    "fünf": 5,
    "sechs": 6,
    "deux": 2,
    "trois": 3,
    "cinq": 5,
}
_COUNT = rf"(?:[0-9]{{1,2}}|\b(?:{'|'.join(_WORDS)})\b)"
_BEFORE = re.compile(
    rf"(?<![\^\w.{{])(?P<count>{_COUNT})[ \t]*(?:\$|\\\))?\s*(?:(?:independent|Stück)\s+)?{_FREEDOM}", re.IGNORECASE
)
_AFTER = re.compile(
    rf"{_FREEDOM}\W{{0,4}}\s*(?:\([^()]{{0,20}}\)\s*)?(?:[:=]|is|are|ist|sind|beträgt|est)?\s*"
    rf"(?P<sum>[^\n.;,]{{0,60}}?=\s*)?(?:\$|\\\()?\s*(?:f\s*=\s*)?(?P<count>{_COUNT}(?:\s*[-−–+]\s*[0-9]{{1,2}})*)(?P<result>\s*=\s*[0-9]{{1,2}})?(?![0-9.])",
    re.IGNORECASE,
)
_LETTER = re.compile(
    r"(?<![A-Za-z\\_])(?:f|n|s)\s*=\s*(?P<chain>[0-9]{1,2}(?:\s*(?:\\cdot|[-−–+·*=])\s*[0-9]{1,2})*)(?![0-9.A-Za-z/*^])"
)
_CLASS = re.compile(
    r"(?P<not>\b(?:not|nicht|non|no|pas)\b[\s-]*|\b(?:an|nicht|non)-?)?(?P<word>holonom|scleronom|skleronom|rheonom|catastati|acatastati|akatastati|katastati)",
    re.IGNORECASE,
)
_NAMES = {
    "holonom": ("holonomic", "nonholonomic"),
    "scleronom": ("scleronomic", "rheonomic"),
    "skleronom": ("scleronomic", "rheonomic"),
    "rheonom": ("rheonomic", "scleronomic"),
    "catastati": ("catastatic", "acatastatic"),
    "katastati": ("catastatic", "acatastatic"),
    "acatastati": ("acatastatic", "catastatic"),
    "akatastati": ("acatastatic", "catastatic"),
}
_MOVING = re.compile(r"['\u0307\u0308δ^²]|dot|[xyz]_?[0-9]")


def stated_in_words(text: str) -> Answers:
    """The number of degrees of freedom and the classes that a text states."""
    text = text[:LONGEST_IN_WORDS]
    classes: dict[str, None] = {}
    for m in _CLASS.finditer(text):
        positive, negative = _NAMES[m["word"].lower()]
        classes[negative if m["not"] else positive] = None
    for pair in (("holonomic", "nonholonomic"), ("scleronomic", "rheonomic"), ("catastatic", "acatastatic")):
        if all(word in classes for word in pair):  # `z = R is the only holonomic one` is about single constraints
            classes = {word: None for word in classes if word not in pair}
    return Answers(degrees_of_freedom=_freedom(text), classification=tuple(classes))


def is_about_freedom(fragment: Fragment) -> bool:
    """Whether an equation is about numbers of degrees of freedom, of coordinates or of constraints alone."""
    beside = f"{fragment.text} {getattr(fragment, 'beside', '')}"
    turned = f"{getattr(fragment, 'beside', '')} {fragment.text}"
    return (_freedom(beside) is not None or _freedom(turned) is not None) and _MOVING.search(fragment.text) is None


def _freedom(text: str) -> int | None:
    counts: list[tuple[int, int]] = []
    for m in _BEFORE.finditer(text):
        counts.append((m.start(), _number(m["count"])))
    for m in _AFTER.finditer(text):
        if not any(abs(at - m.start()) < len(m[0]) and at < m.start() for at, _ in counts):
            counted = _sum(m["count"])
            counts.append((m.start(), int(m["result"].strip(" =")) if m["result"] else counted))
    if not counts:
        counts = [(m.start(), _sum(m["chain"].split("=")[-1])) for m in _LETTER.finditer(text)]
    return max(counts)[1] if counts else None


def _number(word: str) -> int:
    return int(word) if word.isdigit() else _WORDS[word.lower()]


def _sum(text: str) -> int:
    """The value of `6 - 1`."""
    signs = re.split(r"\s*([-−–+])\s*", text.strip())
    value = _number(signs[0]) if signs[0].isdigit() or signs[0].lower() in _WORDS else 0
    for sign, number in zip(signs[1::2], signs[2::2], strict=True):
        value += int(number) if sign == "+" else -int(number)
    return value
