"""The shipped library of problems: what each is about, finding some by words. Names are in `lagrange.library`.

A folder of the library is a topic. `index.yaml` beside the folders has a heading for each, and a sentence on what a
problem exercises; a library without it has the folders' names.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from lagrange.core.records import record
from lagrange.problem.library import entries, named, path_of, root, short_names, topic_hint

__all__ = ["Entry", "Index", "containing", "entries", "index", "named", "path_of", "short_names", "topic_hint"]
QUESTIONS = ("constraints", "equilibrium", "motion", "linearization")


@record
class Entry:
    """One shipped problem, as it is listed.

    name       with its topic: `chapter6/ex11-ideal-pendulum`
    asked      what is to be found, as `find` says, or what follows where the file does not say it
    exercises  what one learns from it; empty where the index has nothing
    """

    name: str
    title: str
    source: str
    asked: tuple[str, ...]
    exercises: str

    @property
    def topic(self) -> str:
        """The folder that it stands in."""
        return self.name.rpartition("/")[0]


@record
class Index:
    """What `index.yaml` says: headings of the topics, in their order, and what problems exercise."""

    topics: Mapping[str, str]
    exercises: Mapping[str, str]

    def exercised(self, name: str) -> str:
        """What a problem exercises. The index may name it with its topic or without."""
        return self.exercises.get(name) or self.exercises.get(name.rpartition("/")[2], "")


def title_of(path: Path) -> str:
    """The title of a shipped problem, read from its line; empty where it has no such line."""
    with path.open(encoding="utf-8") as lines:
        return next((line.partition(":")[2].strip().strip("\"'") for line in lines if line.startswith("title:")), "")


def index() -> Index:
    """What the index says; nothing where there is none."""
    path = root() / "index.yaml"
    said = _loaded(path.read_text(encoding="utf-8")) if path.is_file() else None
    parts = (said or {}).get("topics"), (said or {}).get("exercises")
    topics, exercises = ({k: " ".join(v.split()) for k, v in (part or {}).items()} for part in parts)
    return Index(topics, exercises)


def containing(words: Sequence[str], says: Index | None = None) -> tuple[Entry, ...]:
    """The problems in whose name, text, topic or exercise every word occurs, small or capital letters alike."""
    says = says or index()
    return tuple(_found([w.casefold() for w in words], says))


def _found(wanted: Sequence[str], says: Index) -> Iterator[Entry]:
    for name, path in entries().items():
        text = path.read_text(encoding="utf-8")
        searched = f"{name}\n{text}\n{says.topics.get(name.rpartition('/')[0], '')}\n{says.exercised(name)}".casefold()
        if all(word in searched for word in wanted):
            yield _entry(name, _loaded(text), says)


def _entry(name: str, document: Mapping[str, Any], says: Index) -> Entry:
    title, source = (" ".join(document.get(key, "").split()) for key in ("title", "source"))
    return Entry(name, title, source, _asked(document), says.exercised(name))


def _asked(document: Mapping[str, Any]) -> tuple[str, ...]:
    """`find`, or what the loader takes for it: motion where there are masses, equilibrium where there are forces
    without masses, constraints otherwise.
    """
    find = document.get("find")
    if find:
        return (find,) if isinstance(find, str) else tuple(find)
    particles, bodies = (document.get(key) or {} for key in ("particles", "bodies"))
    masses = [thing.get("mass") for thing in (*particles.values(), *bodies.values())]
    if any(mass not in (None, "0") for mass in masses) or bodies or document.get("equations"):
        return ("motion",)
    return ("equilibrium",) if document.get("forces") else ("constraints",)


def _loaded(text: str) -> Any:
    """YAML in which every value is text."""
    import yaml

    return yaml.load(text, Loader=getattr(yaml, "CBaseLoader", yaml.BaseLoader))
