"""Formulas that stand in a sentence without any marks: `the bowl z = c (x^2 + y^2) is smooth`.

A formula is a run of declared names, functions, numbers, signs and brackets between words that are none of these; it
has an equals sign, a power, a product sign or a function of something. A number with a compound unit, 9.81 m/s^2, is
one too. The words a, A and I begin no formula, and what is left open at an end does not belong to it.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from itertools import pairwise

from lagrange.core.units import unit_of
from lagrange.expressions.bounded_arithmetic import SCALAR_FUNCTIONS

_TOKEN = re.compile(r"\s+|\d+(?:\.\d+)?|[A-Za-z]\w*'{0,2}|\*\*|[-+*/^=()]|.", re.DOTALL)
_UNIT = re.compile(r"\s*([A-Za-z]+(?:[/*][A-Za-z]+|\^-?\d+)*)(?![\w'^/*])")
_ARTICLES = frozenset({"a", "A", "I"})
_OPERATORS = frozenset("+-*/^=") | {"**"}
_TELLING = frozenset("*^=") | {"**"}
_BRACKETS = frozenset("()")

Piece = tuple[int, str]
"""Where it begins, and its text."""


def formulas_in(text: str, names: Collection[str]) -> Iterator[tuple[int, int]]:
    """Where formulas begin and end, in order."""
    for run, cut in _runs(text, names):
        for piece in _closed(run):
            kept = _without_brackets_around(_without_ends(piece))
            if _reads_as_formula(kept) and not (cut and any(word == "=" for _, word in kept)):
                yield kept[0][0], kept[-1][0] + len(kept[-1][1])


def _runs(text: str, names: Collection[str]) -> Iterator[tuple[list[Piece], bool]]:
    """The longest stretches that have only mathematics in them, and whether an undeclared letter ends one of them."""
    run: list[Piece] = []
    end = 0
    before = ""
    while end < len(text):
        token = _TOKEN.match(text, end)
        assert token is not None  # the last alternative takes any character
        start, word, end = end, token[0], token.end()
        if word.isspace():
            continue
        unit = _unit_after(text, end, names) if word[0].isdigit() else None
        if unit is not None and (unit[1] or (run and run[-1][1] == "=")):
            yield [*run, (start, text[start : unit[0]])], _is_letter(before)
            run, before, end = [], "", unit[0]
            continue
        touching = word == "(" and start > 0 and text[start - 1].isalnum() and not run  # f(x) of an unknown f
        if not touching and _is_mathematical(word, names):
            run.append((start, word))
            continue
        yield run, _is_letter(before) or _is_letter(word)
        run, before = [], word
    yield run, _is_letter(before)


def _is_letter(word: str) -> bool:
    """An undeclared symbol, so that what is beside it is part of a longer formula: v, T', omega_0."""
    name = word.rstrip("'")
    return name not in _ARTICLES and (len(name) == 1 or "_" in name) and name[0].isalpha()


def _is_mathematical(word: str, names: Collection[str]) -> bool:
    name = word.rstrip("'")
    return word in _OPERATORS or word in _BRACKETS or word[0].isdigit() or name in names or word in SCALAR_FUNCTIONS


def _unit_after(text: str, start: int, names: Collection[str]) -> tuple[int, bool] | None:
    """The end of a unit after a number, and whether the unit is compound; m may be a mass."""
    match = _UNIT.match(text, start)
    if match is None or unit_of(match[1]) is None or {*re.findall(r"[A-Za-z]+", match[1])} <= {*names}:
        return None
    return match.end(), not match[1].isalpha()


def _closed(run: list[Piece]) -> Iterator[list[Piece]]:
    """The parts of a run between brackets that are not closed, or not opened, in it."""
    opened: list[int] = []
    alone: list[int] = []
    for n, (_, word) in enumerate(run):
        if word == "(":
            opened.append(n)
        elif word == ")":
            if opened:
                opened.pop()
            else:
                alone.append(n)
    first = 0
    for n in sorted([*alone, *opened]):
        yield run[first:n]
        first = n + 1
    yield run[first:]


def _without_ends(run: list[Piece]) -> list[Piece]:
    """The run without signs that join it to a word, and without an article."""
    while run and run[-1][1] in _OPERATORS:
        run = run[:-1]
    while run and run[0][1] in _OPERATORS - {"-"}:
        run = run[1:]
    if len(run) > 1 and run[0][1] in _ARTICLES and run[1][1] not in _OPERATORS:
        return _without_ends(run[1:])
    return run


def _without_brackets_around(run: list[Piece]) -> list[Piece]:
    """`y = x` of `(y = x)`; (a + b) (c + d) = 0 keeps its own."""
    depth = 0
    for n, (_, word) in enumerate(run):
        depth += (word == "(") - (word == ")")
        if depth == 0 and n < len(run) - 1:
            return run
    return run[1:-1] if len(run) > 1 and any(word == "=" for _, word in run) else run


def _reads_as_formula(run: list[Piece]) -> bool:
    words = [word for _, word in run]
    called = any(w in SCALAR_FUNCTIONS and following == "(" for w, following in pairwise(words))
    valued = len(words) == 1 and " " in words[0].strip()
    return called or valued or (len(words) > 1 and any(w in _TELLING for w in words))
