"""Untrusted text made safe to print: every text from a file that is shown goes through this module.

What a file says may contain characters that steer a terminal (escape sequences, also in their one-character C1 forms),
reverse the order in which a line is read, hide between two letters, or cannot be written at all (half of a pair of
surrogates). Nothing of the kind leaves the program:

    visible      messages: each such character is a box, so that columns and carets stay where they are
    one_line     the same in one line, and of bounded length: a sentence of a message, a cell of a table
    printable    pages: one line; control and format characters are dropped, since titles come with soft hyphens
    json_text    JSON: written as `\\u001b`, so that nothing is lost
"""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache
from typing import Any

from lagrange.core.limits import MOST_IN_A_LINE

HIDDEN = frozenset(("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"))
"""The categories of Unicode that are not shown: control, format, surrogate, private use, unassigned, separators."""

BOX = "\N{WHITE SQUARE}"


@lru_cache(maxsize=4096)
def is_hidden(char: str) -> bool:
    """Whether a character is one of those that are not printed as they are."""
    return unicodedata.category(char) in HIDDEN


def visible(text: str) -> str:
    """Text of several lines, with a box for whatever is not shown; ends of lines and tabs stay."""
    if text.isprintable():  # then it has none of them, and this is most of what there is
        return text
    return "".join(BOX if c not in "\n\t" and is_hidden(c) else c for c in text)


def one_line(text: str) -> str:
    """Text as a sentence: boxes, blanks for ends of lines and tabs, and an end where it is absurdly long."""
    shortened = text if len(text) <= MOST_IN_A_LINE else f"{text[:MOST_IN_A_LINE]} ..."
    return visible(re.sub(r"\r?\n[ \t]*|\t", " ", shortened))


def printable(text: str) -> str:
    """Text on one line of a page, without control and format characters; boxes for whatever else is not shown.

    A no-break space stays: no line is broken there.
    """
    spaced = (" " if c.isspace() and c != "\u00a0" else c for c in text)
    kept = (c for c in spaced if unicodedata.category(c) not in ("Cc", "Cf"))
    return "".join(BOX if is_hidden(c) else c for c in kept)


def json_text(value: Any, indent: int | None = None) -> str:
    """A value as JSON in which every hidden character is escaped."""
    import json  # messages do without

    written = json.dumps(value, ensure_ascii=False, indent=indent)
    if written.isascii() and "\x7f" not in written:
        return written
    # Outside of its strings JSON has no characters but ASCII, so what is replaced here is inside of one.
    return "".join(_escaped(c) if c != "\n" and is_hidden(c) else c for c in written)


def _escaped(char: str) -> str:
    units = char.encode("utf-16-be", "surrogatepass")
    return "".join(f"\\u{units[n]:02x}{units[n + 1]:02x}" for n in range(0, len(units), 2))
