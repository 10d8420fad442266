"""The names on a command line: the problems of an assignment, then the answers to them.

The first name is a problem and the last one an answer. A name between them is a problem if it is that of one
in the library, where there is no such file, or a YAML file with `coordinates`, as every problem file has and no file
of answers.
"""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Sequence
from pathlib import Path, PurePath

import click

from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.problem import library
from lagrange.problem.sources import read_source
from lagsolve.inputs import problem_source
from lagsolve.limits import MOST_PROBLEMS

_COORDINATES = re.compile(r"^(?:coordinates|[\"']coordinates[\"'])\s*:|^\s*\{.*\bcoordinates\s*:", re.MULTILINE)


def sorted_out(named: Sequence[str]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The problems and the answers of a command line."""
    if len(named) < 2:
        raise click.UsageError("Missing argument 'ANSWERS...': name a folder of answers after the problem.")
    number = 1
    while number < len(named) - 1 and _is_problem(named[number]):
        number += 1
    if number > MOST_PROBLEMS:
        raise click.UsageError(f"an assignment has {MOST_PROBLEMS} problems at most, and these are {number}")
    return tuple(named[:number]), tuple(named[number:])


def _is_problem(name: str) -> bool:
    if os.path.lexists(name):
        if not name.lower().endswith(library.EXTENSIONS) or not os.path.isfile(name) or os.path.islink(name):
            return False
        try:
            return _COORDINATES.search(read_source(Path(name)).text) is not None
        except ProblemError:
            return False
    return not library.is_file_name(name) and bool(library.named(name))


def labelled(named: Sequence[str]) -> tuple[tuple[str, Source], ...]:
    """The problems with their labels, which differ: the name in the library as it was typed, or that of the file.

    Raises ProblemError if one does not exist, or is named twice.
    """
    sources = [problem_source(name) for name in named]
    labels = [
        PurePath(source.name).stem if library.is_file_name(name) else PurePath(name).name
        for name, source in zip(named, sources, strict=True)
    ]
    twice = [label for label, times in Counter(labels).items() if times > 1]
    if twice:
        message = f"two problems are called `{twice[0]}`"
        raise ProblemError(Diagnostic("declared-twice", message, help="give their files different names"))
    return tuple(zip(labels, sources, strict=True))
