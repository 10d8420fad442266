"""The texts that the command line names: problems and answers."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Source, nearest
from lagrange.problem.loader import read_source
from lagrange.problem.yaml_nodes import MAX_BYTES, decode
from lagsolve import library
from lagsolve.group import COMMANDS
from lagsolve.status import say


def problem_source(name: str) -> Source:
    """The text of a problem: a file, standard input, or a problem of the library.

    Says so where a problem of the library is taken and a file may have been meant. Raises ProblemError where there is
    none.
    """
    if name == "-":
        return _standard_input()
    path = problem_path(name)
    _say_which(name, path)
    meant = _meant(path)
    if meant:
        found = Diagnostic("no-such-file", f"there is no file {path}", help=f"did you mean {meant}?")
        raise ProblemError(found)
    return read_source(path)


def problem_path(name: str) -> Path:
    """The file of a problem: the file of that name, or that of a problem of the library.

    Raises ProblemError where the library has none, or several; a file need not be there.
    """
    named_as_file = name.endswith((".yaml", ".yml")) or os.path.exists(name)
    if named_as_file and not (os.path.isdir(name) and library.named(name)):
        return Path(name)
    if not library.named(name):
        raise ProblemError(_no_problem(name))
    try:
        return library.path_of(name)
    except ProblemError as several:
        beside = _file_beside(name)
        help_ = f", or `{beside}` for the file of that name" if beside else ""
        raise ProblemError(replace(d, help=d.help + help_) for d in several.diagnostics) from None


def _say_which(name: str, path: Path) -> None:
    """A note where a name stands for a problem of the library, and there is a file of that name as well."""
    beside = _file_beside(name)
    if not beside or path == Path(name):
        return
    message = f"`{name}` is the problem `{path.stem}` of the library; there is a file `{beside}` too"
    say(str(Diagnostic("file-beside", message, help=f"to solve the file, write `{beside}`").as_note()))


def _file_beside(name: str) -> str:
    """The file that a name without its ending may mean; empty where there is none."""
    return next((file for file in (f"{name}.yaml", f"{name}.yml") if os.path.isfile(file)), "")


def _meant(path: Path) -> str:
    """Of a file that is not there: the one beside it that may be meant, or the shipped problem; empty where none is."""
    if os.path.lexists(path):
        return ""
    if library.named(path.stem) and path.parent == Path():
        return f"`{path.stem}`, which is a problem of the library"
    near = nearest(path.name, _problem_files(path.parent))
    return f"`{path.parent / near}`" if near else ""


def _problem_files(folder: Path) -> list[str]:
    """The names of the problem files in a folder; none where it cannot be read."""
    try:
        return [name for name in os.listdir(folder) if name.endswith((".yaml", ".yml"))]
    except (OSError, ValueError):
        return []


def _no_problem(name: str) -> Diagnostic:
    """That there is nothing of that name, and what may have been meant: a problem, a file, a command."""
    known = {short: f"`{short}`" for short in library.short_names().values()}
    known |= {file: f"`{file}`" for file in _problem_files(Path())}
    known |= {command: f"the command `{command}`" for command in COMMANDS}
    near = f"{name}.yaml" if f"{name}.yaml" in known else nearest(name, known)
    meant = f"did you mean {known[near]}? " if near else ""
    help_ = library.topic_hint(name) or f"{meant}`lagsolve list` shows the library, `lagsolve --help` the commands"
    return Diagnostic("no-such-problem", f"there is no file and no shipped problem `{name}`", help=help_)


def answer_fragments(file: str | None, equations: Sequence[str]) -> tuple[Fragment, ...]:
    """The equations of an answer: those given one by one, then those in a file, as its ending says.

    Raises ProblemError.
    """
    fragments = [Fragment.of(text, f"equation {n}") for n, text in enumerate(equations, start=1)]
    if file is not None:
        from lagrange.answers.answer_files import equations_in_file

        source = _standard_input() if file == "-" else read_source(Path(file))
        fragments += equations_in_file(source, Path(file).suffix)
    return tuple(fragments)


def _standard_input() -> Source:
    if sys.stdin is None:
        raise ProblemError(Diagnostic("no-standard-input", "standard input is closed", help="name a file"))
    return decode(sys.stdin.buffer.read(MAX_BYTES + 1), "<stdin>")
