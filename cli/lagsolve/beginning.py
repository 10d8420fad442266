"""`lagsolve new`: a problem file to start from, written where no file is."""

from __future__ import annotations

import os
import shlex
from pathlib import Path

import click

from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagsolve import library
from lagsolve.output import put
from lagsolve.status import say
from lagsolve.template import TEMPLATE

ENDINGS = (".yaml", ".yml")


def create(file: str, name: str | None) -> None:
    """Writes the template, or a copy of the shipped problem `name`, and says what to type next.

    Raises ProblemError where nothing can be written there, or there is no such problem; never writes over a file.
    """
    content = TEMPLATE.encode() if name is None else library.path_of(name).read_bytes()
    if file == "-":
        put(content.decode())
        return
    path = _place(file)
    try:
        with path.open("xb") as target:
            target.write(content)
    except FileExistsError:
        help_ = "nothing was written: give the new file another name, or remove the old one first"
        raise ProblemError(Diagnostic("file-exists", f"{path} is there already", help=help_)) from None
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        reason = getattr(error, "strerror", None) or str(error)
        help_ = "choose another place, or check that you may write there"
        raise ProblemError(Diagnostic("cannot-write", f"{path} cannot be written: {reason}", help=help_)) from None
    what = "a template to change" if name is None else f"a copy of `{name}` to change"
    say(f"{path} is {what}; to solve it, and again whenever you save it:\n  lagsolve {_argument(path)} --watch")


def _place(file: str) -> Path:
    """Where the file goes: its name with the ending .yaml, in a folder that is there."""
    path = Path(file)
    if file.endswith("/") or os.path.isdir(path):
        help_ = f"name a file in it, such as {path / 'problem.yaml'}"
        raise ProblemError(Diagnostic("is-a-folder", f"{file} is a folder", help=help_))
    if path.suffix.lower() not in ENDINGS:
        if path.suffix and path.stem:
            better = shlex.quote(str(path.with_suffix(".yaml")))
            raise click.UsageError(f"a problem file ends in .yaml, and not in {path.suffix}: lagsolve new {better}")
        path = path.with_name(f"{path.name}.yaml")
    if not os.path.isdir(path.parent):
        help_ = f"make it first: mkdir -p {shlex.quote(str(path.parent))}"
        raise ProblemError(Diagnostic("no-such-folder", f"there is no folder {path.parent}", help=help_))
    return path


def _argument(path: Path) -> str:
    """A path as it is typed in a shell."""
    return shlex.quote(f"./{path}" if str(path).startswith("-") else str(path))
