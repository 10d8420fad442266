"""The manual page of the command, from its help: `python -m lagsolve.man_page > lagsolve.1` (`make man`)."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator

import click

import lagrange
from lagsolve.command_group import COMMANDS
from lagsolve.main import main


def man_page() -> str:
    """The page in the language of man(7)."""
    return "\n".join(_lines()) + "\n"


def _lines() -> Iterator[str]:
    yield f'.TH LAGSOLVE 1 "" "lagsolve {lagrange.__version__}" "User Commands"'
    yield from (".SH NAME", r"lagsolve \- derive and check the equations of motion of a mechanical system")
    yield from (
        ".SH SYNOPSIS",
        ".B lagsolve",
        r"\fIPROBLEM\fR... [\fIOPTIONS\fR]",
        ".br",
        ".B lagsolve",
        r"\fICOMMAND\fR [\fIARGS\fR]...",
    )
    yield from (".SH DESCRIPTION", *_paragraphs(main.help or ""))
    for name in COMMANDS:
        command = main.commands[name]
        context = click.Context(command, info_name=f"lagsolve {name}")
        yield f".SH {'SOLVING' if name == 'solve' else escape(name.upper())}"
        yield rf"\fB{escape(context.command_path)}\fR {escape(' '.join(command.collect_usage_pieces(context)))}"
        yield from (".PP", *_paragraphs(command.help or ""))
        for option in (p for p in command.params if isinstance(p, click.Option)):
            record = option.get_help_record(context)
            if record is not None:
                yield from (".TP", rf"\fB{escape(record[0])}\fR", escape(" ".join(record[1].split())))
    yield from (".SH NOTES", *_paragraphs(main.epilog or ""))


def _paragraphs(text: str) -> Iterator[str]:
    """The paragraphs of a help text; one that begins with \\b keeps its lines."""
    for n, paragraph in enumerate(re.split(r"\n\s*\n", text.strip())):
        yield from (".PP",) if n else ()
        if paragraph.lstrip().startswith("\b"):
            yield from (
                ".nf",
                *(escape(line.rstrip()) for line in paragraph.replace("\b", "").strip("\n").splitlines()),
                ".fi",
            )
        else:
            yield escape(" ".join(paragraph.split()))


def escape(text: str) -> str:
    """Text as man shows it: a backslash, a hyphen to be copied, and no request at the beginning of a line."""
    text = text.replace("\\", r"\e").replace("-", r"\-")
    return rf"\&{text}" if text.startswith((".", "'")) else text


if __name__ == "__main__":
    sys.stdout.write(man_page())
