"""The shipped library of problems: where it is, and finding a problem by name."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

HERE = Path(__file__).resolve().parent


def root() -> Path:
    """The folder of the library: inside the installed package, or beside `cli/` in a checkout."""
    installed = HERE / "problems"
    return installed if installed.is_dir() else HERE.parents[1] / "problems"


def entries() -> dict[str, Path]:
    """name -> file of every shipped problem; the name is `chapter6/ex11-ideal-pendulum`."""
    base = root()
    named = {p.relative_to(base).with_suffix("").as_posix(): p for p in base.glob("*/*.yaml")}
    return dict(sorted(named.items()))


def named(name: str) -> dict[str, Path]:
    """The problems that a name may mean: the whole name, its last part, or the beginning of that (`ex11`)."""
    known = entries()
    exact = {n: p for n, p in known.items() if f"/{n}".endswith(f"/{name}")}
    return exact or {n: p for n, p in known.items() if f"/{name}-" in f"/{n}"}


def path_of(name: str) -> Path:
    """The file of the one problem that a name means. Raises ProblemError where there is none, or several."""
    found = named(name)
    if len(found) == 1:
        return next(iter(found.values()))
    from lagrange.diagnostics import Diagnostic, ProblemError, nearest

    if found:
        message = f"`{name}` may be any of {', '.join(f'`{n}`' for n in found)}"
        raise ProblemError(Diagnostic("several-problems", message, help="write the whole name"))
    near = nearest(name, [n.rsplit("/", 1)[-1] for n in entries()])
    meant = f"did you mean `{near}`? " if near else ""
    help_ = f"{meant}`lagsolve list` shows the library, `lagsolve --help` the commands"
    raise ProblemError(Diagnostic("no-such-problem", f"there is no file and no shipped problem `{name}`", help=help_))


def containing(words: Sequence[str]) -> dict[str, Path]:
    """The problems in whose name or text every word occurs, small or capital letters alike."""
    wanted = [w.casefold() for w in words]
    texts = {n: f"{n}\n{p.read_text(encoding='utf-8')}".casefold() for n, p in entries().items()}
    return {n: p for n, p in entries().items() if all(w in texts[n] for w in wanted)}


def title_and_source(path: Path) -> tuple[str, str]:
    """What a problem is called, and where it is from."""
    import yaml

    document = yaml.load(path.read_text(encoding="utf-8"), Loader=getattr(yaml, "CBaseLoader", yaml.BaseLoader))
    return document["title"], document.get("source", "")
