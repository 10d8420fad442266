"""The shipped problems by name: `chapter6/ex11-ideal-pendulum`, `ex11-ideal-pendulum`, or an unambiguous prefix `ex11`.

Only files of a topic's folder are problems; `index.yaml` beside the folders is not. Names of files and of problems do
not overlap: what ends in .yaml or .yml is a file, and so is what exists under that name.
"""

from __future__ import annotations

import os
from pathlib import Path

EXTENSIONS = (".yaml", ".yml")
_PACKAGE = Path(__file__).resolve().parents[1]


def root() -> Path:
    """The folder of the library: beside `lagrange/` in a checkout, in the command's package where it is installed."""
    checkout = _PACKAGE.parent / "problems"
    installed = _PACKAGE.parent / "lagsolve" / "problems"
    return installed if installed.is_dir() else checkout


def entries() -> dict[str, Path]:
    """name -> file of every shipped problem; the name is `chapter6/ex11-ideal-pendulum`."""
    base = root()
    files = {p.relative_to(base).with_suffix("").as_posix(): p for p in base.glob("*/**/*.yaml")}
    return dict(sorted(files.items()))


def named(name: str) -> dict[str, Path]:
    """The problems that a name may mean: the whole name, its last part, or a prefix of that (`ex11`)."""
    known = entries()
    exact = {n: p for n, p in known.items() if f"/{n}".endswith(f"/{name}")}
    return exact or {n: p for n, p in known.items() if f"/{name}-" in f"/{n}"}


def is_file_name(name: str) -> bool:
    """Whether a name means a file and not a shipped problem. A folder may have the name of a problem."""
    return (name.endswith(EXTENSIONS) or os.path.exists(name)) and not (os.path.isdir(name) and named(name))


def short_names() -> dict[str, str]:
    """name -> the shortest that means this problem and no other: its last part, where no two problems share it."""
    known = list(entries())
    last = [n.rpartition("/")[2] for n in known]
    return {n: short if last.count(short) == 1 else n for n, short in zip(known, last, strict=True)}


def path_of(name: str) -> Path:
    """The file of the one problem that a name means. Raises ProblemError if there is none, or several."""
    candidates = named(name)
    if len(candidates) == 1:
        return next(iter(candidates.values()))
    from lagrange.core.diagnostics import Diagnostic, ProblemError, nearest

    if candidates:
        message = f"`{name}` may be any of {', '.join(f'`{n}`' for n in candidates)}"
        raise ProblemError(Diagnostic("several-problems", message, help="write the whole name"))
    near = nearest(name, short_names().values())
    meant = f"did you mean `{near}`? " if near else ""
    help_ = topic_hint(name) or f"{meant}`lagsolve list` shows the library"
    raise ProblemError(Diagnostic("no-such-problem", f"there is no shipped problem `{name}`", help=help_))


def topic_hint(name: str) -> str:
    """What to do where the name is that of a topic; empty if it is not."""
    topic = name.rstrip("/")
    topics = {n.rpartition("/")[0] for n in entries()}
    return f"`{topic}` is a topic: `lagsolve list {topic}` shows its problems" if topic in topics else ""
