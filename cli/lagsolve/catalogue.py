"""The library as a list: pages for a terminal, lines for a pipe.

On a terminal every topic has a heading, and a problem two lines: name and title; what is asked and the source, cut
where it is too long. At length it has its source in full, and before it what one learns from it. In a pipe a problem is
one line with five columns between tabs: name, title, what is asked, source, what it exercises; whatever happens to the
page, these stay.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping, Sequence

from lagsolve.library import Entry, Index

INDENT = 6
DEEP = " " * INDENT


def lines(found: Sequence[Entry]) -> str:
    """The problems for a pipe."""
    return "".join("\t".join((e.name, e.title, ", ".join(e.asked), e.source, e.exercises)) + "\n" for e in found)


def page(
    found: Sequence[Entry], says: Index, called: Mapping[str, str], width: int, *, whole: bool, styled: bool
) -> str:
    """The problems under their topics, for a terminal.

    called  name -> what a problem is called here
    whole   whether sources are given in full, with what each problem exercises
    styled  whether headings and names may be bold
    """
    topics = dict.fromkeys((*says.topics, *(e.topic for e in found)))
    parts = ((topic, [e for e in found if e.topic == topic]) for topic in topics)
    return "\n".join("\n".join(_part(t, es, says, called, width, whole, styled)) + "\n" for t, es in parts if es)


def _part(
    topic: str, found: Sequence[Entry], says: Index, called: Mapping[str, str], width: int, whole: bool, styled: bool
) -> Iterator[str]:
    """A topic: its heading and its problems."""
    heading = f"{topic}: {says.topics[topic]}" if says.topics.get(topic) else topic
    yield from (_bold(line, styled) for line in textwrap.wrap(heading, width))
    column = max(len(called[e.name]) for e in found) + 4
    for number, entry in enumerate(found):
        if whole and number:
            yield ""
        yield from _named(called[entry.name], entry.title, column, width, styled)
        if whole and entry.exercises:
            yield from _told(entry.exercises, width, whole)
        asked = ", ".join(entry.asked)
        yield from _told(f"{asked}; {entry.source}" if entry.source else asked, width, whole)


def _named(name: str, title: str, column: int, width: int, styled: bool) -> Iterator[str]:
    """Name and title on one line, or below one another."""
    if column + len(title) <= width:
        yield f"  {_bold(name, styled)}{' ' * (column - 2 - len(name))}{title}"
    else:
        yield f"  {_bold(name, styled)}"
        yield from _told(title, width, whole=True)


def _told(text: str, width: int, whole: bool) -> Iterator[str]:
    """Something about a problem: all of it, or what has room on one line."""
    broken = textwrap.wrap(text, max(1, width - INDENT), break_on_hyphens=False)
    if whole or len(broken) < 2:
        yield from (f"{DEEP}{line}" for line in broken)
    else:
        yield DEEP + textwrap.shorten(text, max(2, width - INDENT), placeholder=" …")


def _bold(text: str, styled: bool) -> str:
    return f"\x1b[1m{text}\x1b[0m" if styled else text
