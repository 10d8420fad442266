"""What a shell may complete: names of shipped problems, and files.

A shell completes files itself, if nothing else is offered: then it knows `~` and puts no blank behind a folder. So
where names of the library fit, files of the current folder that are problems stand beside them, and where none fits
the shell is told that a file is wanted.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

Completer = Callable[[click.Context, click.Parameter, str], "list[CompletionItem]"]


def shipped(_context: click.Context, _parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The shipped problems that begin so: by their last part, with the topic where one is begun."""
    from click.shell_completion import CompletionItem

    from lagsolve import library

    paths = library.entries()
    names = {name: name for name in paths} if "/" in incomplete else {s: n for n, s in library.short_names().items()}
    return [
        CompletionItem(written, help=library.title_of(paths[name]))
        for written, name in names.items()
        if written.startswith(incomplete)
    ]


def problems(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The shipped problems, and files."""
    from click.shell_completion import CompletionItem

    found = shipped(context, parameter, incomplete)
    if not found or incomplete.startswith((".", "/", "~")):
        return files(context, parameter, incomplete)
    from pathlib import Path

    near = sorted(str(p) for ending in ("*.yaml", "*.yml") for p in Path().glob(ending))
    return [*(CompletionItem(f, help="a file") for f in near if f.startswith(incomplete)), *found]


def files(_context: click.Context, _parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """A file, which the shell completes."""
    from click.shell_completion import CompletionItem

    return [CompletionItem(incomplete, type="file")]
