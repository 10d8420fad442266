"""Small words that several parts of a derivation use."""

from __future__ import annotations

from dataclasses import replace

from lagrange.document.derivation import Detail, Prose


def spoken(name: str) -> str:
    """A name of the file in running text: `upper_rod` is upper rod, `no_slip.2` is no slip 2."""
    return name.replace("_", " ").replace(".", " ").strip()


def brief(block: Prose, short: Prose) -> Prose:
    """A paragraph that is shown even where little detail is wanted, `short` in its place."""
    return replace(block, detail=Detail.BRIEF, short=short.parts)


def plural(number: int, one: str, more: str) -> str:
    """The word for one, or for more."""
    return one if number == 1 else more


_WORDS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")


def in_words(number: int, what: str) -> str:
    """`one relation`, `two relations`, `no relation`."""
    word = _WORDS[number] if number < len(_WORDS) else str(number)
    return f"{word} {what}{'s' if number > 1 else ''}"


def counted(number: int, what: str) -> str:
    """`1 coordinate`, `2 coordinates`."""
    return f"{number} {what}{'' if number == 1 else 's'}"
