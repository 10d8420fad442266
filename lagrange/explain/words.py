"""Small words that several parts of a derivation use."""

from __future__ import annotations

from dataclasses import replace

from lagrange.derivation import Detail, Prose


def spoken(name: str) -> str:
    """A name of the file in running text: `upper_rod` is upper rod."""
    return name.replace("_", " ").strip()


def brief(block: Prose) -> Prose:
    """A paragraph that is shown even where little detail is wanted."""
    return replace(block, detail=Detail.BRIEF)


def plural(number: int, one: str, more: str) -> str:
    """The word for one, or for more."""
    return one if number == 1 else more


def counted(number: int, what: str) -> str:
    """`1 coordinate`, `2 coordinates`."""
    return f"{number} {what}{'' if number == 1 else 's'}"
