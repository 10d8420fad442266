"""The texts that the command line names: problems and answers, in files, on standard input, or in the library."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Source, nearest
from lagrange.problem import library
from lagrange.problem.limits import MAX_BYTES
from lagrange.problem.sources import decode, read_source
from lagsolve.command_group import COMMANDS, write_stderr

if TYPE_CHECKING:
    from lagrange.problem.model import Answers, Problem


def problem_source(name: str) -> Source:
    """The text of a problem: a file, standard input, or a problem of the library.

    A note says so where a problem of the library is taken and a file may have been meant. Raises ProblemError where
    there is no such problem.
    """
    if name == "-":
        return _standard_input()
    path = problem_path(name)
    _note_file_beside(name, path)
    meant = _meant_by_missing(path)
    if meant:
        raise ProblemError(Diagnostic("no-such-file", f"there is no file {path}", help=f"did you mean {meant}?"))
    return read_source(path)


def problem_path(name: str) -> Path:
    """The file of a problem: the file of that name, or that of a problem of the library.

    Raises ProblemError if the library has none, or several; a file need not exist.
    """
    if library.is_file_name(name):
        return Path(name)
    if not library.named(name):
        raise ProblemError(_no_problem(name))
    try:
        return library.path_of(name)
    except ProblemError as several:
        beside = _file_beside(name)
        help_ = f", or `{beside}` for the file of that name" if beside else ""
        raise ProblemError(replace(d, help=d.help + help_) for d in several.diagnostics) from None


def _note_file_beside(name: str, path: Path) -> None:
    """A note where a name stands for a problem of the library, and there is a file of that name as well."""
    beside = _file_beside(name)
    if not beside or path == Path(name):
        return
    message = f"`{name}` is the problem `{path.stem}` of the library; there is a file `{beside}` too"
    write_stderr(str(Diagnostic("file-beside", message, help=f"to solve the file, write `{beside}`").as_note()))


def _file_beside(name: str) -> str:
    """The file that a name without its extension may mean; empty if there is none."""
    return next((file for file in (f"{name}{e}" for e in library.EXTENSIONS) if os.path.isfile(file)), "")


def _meant_by_missing(path: Path) -> str:
    """What may be meant by a file that does not exist: one beside it, or a problem of the library; empty if nothing."""
    if os.path.lexists(path):
        return ""
    if library.named(path.stem) and path.parent == Path():
        return f"`{path.stem}`, which is a problem of the library"
    near = nearest(path.name, _problem_files(path.parent))
    return f"`{path.parent / near}`" if near else ""


def _problem_files(folder: Path) -> list[str]:
    """The names of the problem files in a folder; none if it cannot be read."""
    try:
        return [name for name in os.listdir(folder) if name.endswith(library.EXTENSIONS)]
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


def answer_source(file: str) -> Source:
    """The text of an answer: a file, or standard input. Raises ProblemError."""
    return _standard_input() if file == "-" else read_source(Path(file))


def stated_equations(equations: Sequence[str]) -> tuple[Fragment, ...]:
    """The equations of an answer that are given one by one."""
    return tuple(Fragment.of(text, f"equation {n}") for n, text in enumerate(equations, start=1))


def settings_read(settings: Sequence[str]) -> tuple[Fragment, ...]:
    """The texts NAME=VALUE of `--set`, each a source of its own for messages."""
    return tuple(Fragment.of(text, "--set") for text in settings)


def stated_answers(file: str, problem: Problem) -> Answers:
    """The answers in a YAML file with the keys of `answers`. Raises ProblemError."""
    from lagrange.problem.stated_answers import read_answers

    return read_answers(read_source(Path(file)), problem)


def _standard_input() -> Source:
    if sys.stdin is None:
        raise ProblemError(Diagnostic("no-standard-input", "standard input is closed", help="name a file"))
    try:
        return decode(sys.stdin.buffer.read(MAX_BYTES + 1), "<stdin>")
    except OSError as error:
        message = f"standard input cannot be read: {error.strerror}"
        raise ProblemError(Diagnostic("no-standard-input", message, help="name a file")) from None
