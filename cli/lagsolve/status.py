"""Exit statuses, and errors shown as messages on standard error."""

from __future__ import annotations

import os
import sys

import click

OK, WRONG, UNREADABLE, UNDECIDED = 0, 1, 2, 3
INTERRUPTED, BROKEN_PIPE = 130, 141
"""128 and the signal's number, as a shell reports a program that SIGINT or SIGPIPE has ended."""

LONGEST = 300  # of somebody else's message


def say(text: str) -> None:
    """A message, on standard error."""
    click.echo(text, err=True)


def complain(error: Exception, heading: str = "") -> int:
    """Shows an error; the exit status that it calls for.

    An error that is not the user's is a mistake of this program: it is shown as one message, with its traceback only
    where LAGSOLVE_DEBUG is set in the environment.
    """
    from lagrange.core.diagnostics import Diagnostic, ProblemError

    if isinstance(error, ProblemError):
        say(heading + error.show())
        return error.exit_status
    if os.environ.get("LAGSOLVE_DEBUG"):
        import traceback

        say("".join(traceback.format_exception(error)))
    said = " ".join(f"{type(error).__name__}: {error}".split())
    shortened = said if len(said) <= LONGEST else f"{said[:LONGEST]}..."
    help_ = "please report it, with the problem file; LAGSOLVE_DEBUG=1 in the environment shows where it happened"
    say(heading + str(Diagnostic("internal", f"a mistake of lagsolve, not of yours: {shortened}", help=help_)))
    return UNDECIDED


def use_utf8() -> None:
    """Formulas need UTF-8, whatever the locale says."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure and (stream.encoding or "").lower().replace("-", "") != "utf8":
            reconfigure(encoding="utf-8", errors=stream.errors)
