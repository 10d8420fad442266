"""The shipped problems by name: `chapter6/ex11-ideal-pendulum`, `ex11-ideal-pendulum`, `ex11` where that is clear."""

from __future__ import annotations

from pathlib import Path

HERE = Path(__file__).resolve().parent


def root() -> Path:
    """The folder of the library: beside `lagrange/` in a checkout, in the command's package where it is installed."""
    checkout = HERE.parent / "problems"
    installed = HERE.parent / "lagsolve" / "problems"
    return installed if installed.is_dir() else checkout


def entries() -> dict[str, Path]:
    """name -> file of every shipped problem; the name is `chapter6/ex11-ideal-pendulum`."""
    base = root()
    named = {p.relative_to(base).with_suffix("").as_posix(): p for p in base.glob("*/**/*.yaml")}
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
