"""The shipped library as a list: what each problem is about, finding some by words, pages for a terminal.

A folder of the library is a topic. `index.yaml` beside the folders has a heading for each, and a sentence on what a
problem exercises; a library without it has the names of the folders. Names and files are in `lagrange.problem.library`.

On a terminal every topic has a heading, and a problem has two lines: name and title; questions and source, shortened if
they are too long. The long list has the full source, and before it what one learns from the problem. In a pipe a
problem is one line with five columns separated by tabs: name, title, questions, source, exercise; these columns stay
whatever happens to the page.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from lagrange.core.records import record
from lagrange.problem.library import entries, root


@record
class Entry:
    """One shipped problem, as it is listed.

    name       with its topic: `chapter6/ex11-ideal-pendulum`
    asked      the questions of `find`, or those that follow from the rest of the file
    exercises  what one learns from it; empty if the index does not have it
    """

    name: str
    title: str
    source: str
    asked: tuple[str, ...]
    exercises: str

    @property
    def topic(self) -> str:
        """The folder that contains it."""
        return self.name.rpartition("/")[0]


@record
class Index:
    """The contents of `index.yaml`: headings of the topics, in their order, and what problems exercise."""

    topics: Mapping[str, str]
    exercises: Mapping[str, str]

    def exercised(self, name: str) -> str:
        """What a problem exercises; the index may name it with or without its topic."""
        return self.exercises.get(name) or self.exercises.get(name.rpartition("/")[2], "")


def title_of(path: Path) -> str:
    """The title of a shipped problem, from the line that begins with `title:`; empty if there is none."""
    with path.open(encoding="utf-8") as lines:
        return next((line.partition(":")[2].strip().strip("\"'") for line in lines if line.startswith("title:")), "")


def index() -> Index:
    """The index; an empty one where there is none."""
    path = root() / "index.yaml"
    document = (_loaded(path.read_text(encoding="utf-8")) if path.is_file() else None) or {}
    parts = document.get("topics"), document.get("exercises")
    topics, exercises = ({k: " ".join(v.split()) for k, v in (part or {}).items()} for part in parts)
    return Index(topics, exercises)


def containing(words: Sequence[str], of: Index | None = None) -> tuple[Entry, ...]:
    """The problems in whose name, text, topic or exercise every word occurs, in upper or lower case."""
    return tuple(_containing([w.casefold() for w in words], of or index()))


def _containing(words: Sequence[str], of: Index) -> Iterator[Entry]:
    for name, path in entries().items():
        text = path.read_text(encoding="utf-8")
        searched = f"{name}\n{text}\n{of.topics.get(name.rpartition('/')[0], '')}\n{of.exercised(name)}".casefold()
        if all(word in searched for word in words):
            yield _entry(name, _loaded(text), of)


def _entry(name: str, document: Mapping[str, Any], of: Index) -> Entry:
    title, source = (" ".join(document.get(key, "").split()) for key in ("title", "source"))
    return Entry(name, title, source, _asked(document), of.exercised(name))


def _asked(document: Mapping[str, Any]) -> tuple[str, ...]:
    """The questions of `find`, or the loader's default: motion where there are masses, equilibrium where there are
    forces without masses, constraints otherwise.
    """
    find = document.get("find")
    if find:
        return (find,) if isinstance(find, str) else tuple(find)
    particles, bodies = (document.get(key) or {} for key in ("particles", "bodies"))
    masses = [thing.get("mass") for thing in (*particles.values(), *bodies.values())]
    if (
        any(mass not in (None, "0") for mass in masses)
        or bodies
        or document.get("equations")
        or document.get("lagrangian")
    ):
        return ("motion",)
    return ("equilibrium",) if document.get("forces") else ("constraints",)


def _loaded(text: str) -> Any:
    """YAML in which every value is text."""
    import yaml

    return yaml.load(text, Loader=getattr(yaml, "CBaseLoader", yaml.BaseLoader))


INDENT = 6
DEEP = " " * INDENT


def listed_for_pipe(entries: Sequence[Entry]) -> str:
    """The problems for a pipe."""
    return "".join("\t".join((e.name, e.title, ", ".join(e.asked), e.source, e.exercises)) + "\n" for e in entries)


def listed_by_topic(
    entries: Sequence[Entry], of: Index, called: Mapping[str, str], width: int, *, long: bool, styled: bool
) -> str:
    """The problems under their topics, for a terminal.

    called  name -> the name to print
    long    whether to give sources in full, with what each problem exercises
    styled  whether headings and names may be bold
    """
    topics = dict.fromkeys((*of.topics, *(e.topic for e in entries)))
    parts = ((topic, [e for e in entries if e.topic == topic]) for topic in topics)
    return "\n".join("\n".join(_part(t, es, of, called, width, long, styled)) + "\n" for t, es in parts if es)


def _part(
    topic: str, entries: Sequence[Entry], of: Index, called: Mapping[str, str], width: int, long: bool, styled: bool
) -> Iterator[str]:
    """A topic: its heading and its problems."""
    heading = f"{topic}: {of.topics[topic]}" if of.topics.get(topic) else topic
    yield from (_bold(line, styled) for line in textwrap.wrap(heading, width))
    column = max(len(called[e.name]) for e in entries) + 4
    for number, entry in enumerate(entries):
        if long and number:
            yield ""
        yield from _named(called[entry.name], entry.title, column, width, styled)
        if long and entry.exercises:
            yield from _indented(entry.exercises, width, long)
        asked = ", ".join(entry.asked)
        yield from _indented(f"{asked}; {entry.source}" if entry.source else asked, width, long)


def _named(name: str, title: str, column: int, width: int, styled: bool) -> Iterator[str]:
    """Name and title on one line, or the title below the name."""
    if column + len(title) <= width:
        yield f"  {_bold(name, styled)}{' ' * (column - 2 - len(name))}{title}"
    else:
        yield f"  {_bold(name, styled)}"
        yield from _indented(title, width, long=True)


def _indented(text: str, width: int, long: bool) -> Iterator[str]:
    """A text below the name of a problem: in full, or shortened to one line."""
    broken = textwrap.wrap(text, max(1, width - INDENT), break_on_hyphens=False)
    if long or len(broken) < 2:
        yield from (f"{DEEP}{line}" for line in broken)
    else:
        yield DEEP + textwrap.shorten(text, max(2, width - INDENT), placeholder=" …")


def _bold(text: str, styled: bool) -> str:
    return f"\x1b[1m{text}\x1b[0m" if styled else text
