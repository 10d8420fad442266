"""The texts that the command line names: problems and answers."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path

from lagrange.diagnostics import Diagnostic, Fragment, ProblemError, Source
from lagrange.loader import read_source
from lagrange.yaml_nodes import MAX_BYTES, decode
from lagsolve import library


def problem_source(name: str) -> Source:
    """The text of a problem: a file, standard input, or a problem of the library.

    Raises ProblemError where there is none.
    """
    if name == "-":
        return _standard_input()
    named_as_file = name.endswith((".yaml", ".yml")) or os.path.exists(name)
    if named_as_file and not (os.path.isdir(name) and library.named(name)):
        return read_source(Path(name))
    return read_source(library.path_of(name))


def answer_fragments(file: str | None, equations: Sequence[str]) -> tuple[Fragment, ...]:
    """The equations of an answer: those given one by one, then those in a file, as its ending says.

    Raises ProblemError.
    """
    fragments = [Fragment.of(text, f"equation {n}") for n, text in enumerate(equations, start=1)]
    if file is not None:
        from lagrange.answer_files import equations_in_file

        source = _standard_input() if file == "-" else read_source(Path(file))
        fragments += equations_in_file(source, Path(file).suffix)
    return tuple(fragments)


def _standard_input() -> Source:
    if sys.stdin is None:
        raise ProblemError(Diagnostic("no-standard-input", "standard input is closed", help="name a file"))
    return decode(sys.stdin.buffer.read(MAX_BYTES + 1), "<stdin>")
