"""How the command line behaves as a whole: default command, help page, errors, shell completion.

Errors are shown as messages on standard error, without a traceback; the exit status follows from the kind of error
(`exit_statuses`).

A shell completes files itself if nothing else is offered; it then knows `~` and adds no space after a folder. So where
names of the library match, problem files of the current folder are offered with them, and where none matches the shell
is asked to complete a file name.
"""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import click

from lagsolve.exit_statuses import BROKEN_PIPE, INTERRUPTED, OK, UNDECIDED, status_of_error

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem


def write_stderr(text: str) -> None:
    """A message, on standard error. If that is closed or full, only the exit status is left to say it."""
    from lagrange.core.printable import visible

    with suppress(OSError, ValueError):
        click.echo(visible(text), err=True)


def abandon_stdout() -> None:
    """Discards what is left in the buffer, so that Python does not complain about it when it exits."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def report_error(error: Exception, heading: str = "") -> int:
    """Shows an error, and returns its exit status.

    An error that is not the user's is a bug: it is shown as one message, with its traceback only if LAGSOLVE_DEBUG is
    set in the environment.
    """
    from lagrange.core.diagnostics import Diagnostic, ProblemError
    from lagsolve.limits import LONGEST_INTERNAL_ERROR

    if isinstance(error, ProblemError):
        write_stderr(heading + error.show())
        return status_of_error(error)
    if isinstance(error, MemoryError):
        help_ = "close other programs, or ask for less: `--detail brief`, one choice of coordinates, a smaller system"
        write_stderr(heading + str(Diagnostic("out-of-memory", "there is not enough memory for this", help=help_)))
        return UNDECIDED
    if os.environ.get("LAGSOLVE_DEBUG"):
        import traceback

        write_stderr("".join(traceback.format_exception(error)))
    text = " ".join(f"{type(error).__name__}: {error}".split())
    shortened = text if len(text) <= LONGEST_INTERNAL_ERROR else f"{text[:LONGEST_INTERNAL_ERROR]}..."
    help_ = "please report it, with the problem file; LAGSOLVE_DEBUG=1 in the environment shows where it happened"
    write_stderr(heading + str(Diagnostic("internal", f"a mistake of lagsolve, not of yours: {shortened}", help=help_)))
    return status_of_error(error)


def use_utf8() -> None:
    """Formulas need UTF-8, whatever the locale says."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure and (stream.encoding or "").lower().replace("-", "") != "utf8":
            reconfigure(encoding="utf-8", errors=stream.errors)


COMMANDS = ("solve", "check", "grade", "simulate", "export", "variant", "list", "show", "new", "schema", "completion")
"""In the order of the help page."""

FIRST_STEPS = """\
lagsolve derives the equations of motion of a mechanical system, step by step, and checks them.

  lagsolve ex11                  an example: the ideal pendulum (-o page.html for a web page)
  lagsolve new mine.yaml         a problem of your own to start from; lagsolve mine.yaml solves it
  lagsolve check ex11 -e "l theta'' + g sin theta = 0"
                                 are these equations right, and if not, what is wrong?

lagsolve list has more examples, lagsolve --help everything else.
"""
"""What the command prints that is called without anything."""

FLAGS = ("-h", "--help", "--version")


class CommandLine(click.Group):
    """The commands; `solve` need not be named."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Prepends `solve` where no command is named; `help COMMAND` is `COMMAND --help`."""
        if not args and not ctx.resilient_parsing:  # a shell that completes has no arguments yet
            click.echo(FIRST_STEPS, nl=False)
            ctx.exit(OK)
        if args[:1] == ["help"]:
            args = [*(name for name in args[1:2] if name in self.commands), "--help"]
        if args and args[0] not in self.commands and args[0] not in FLAGS:
            args = ["solve", *args]
        return super().parse_args(ctx, args)

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002
        """The commands in the order of `COMMANDS`."""
        return [c for c in COMMANDS if c in self.commands]

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Completions of the first argument: a command, or whatever may follow `solve`.

        The request to complete a file comes first: bash drops what precedes it.
        """
        solving = click.Context(self.commands["solve"], parent=ctx, info_name="solve")
        if incomplete.startswith("-"):
            options = (*super().shell_complete(ctx, incomplete), *solving.command.shell_complete(solving, incomplete))
            return list({option.value: option for option in options}.values())
        [problems] = (p for p in solving.command.params if p.name == "problems")
        return [*problems.shell_complete(solving, incomplete), *super().shell_complete(ctx, incomplete)]

    def make_context(self, *values: Any, **named: Any) -> click.Context:
        """The arguments, read; `--help` and `--version` print what they have to print here."""
        try:
            return super().make_context(*values, **named)
        except BrokenPipeError:
            abandon_stdout()
            sys.exit(BROKEN_PIPE)

    def invoke(self, ctx: click.Context) -> Any:
        """Runs a command. Any error is shown as a message, and determines the exit status."""
        use_utf8()
        try:
            return super().invoke(ctx)
        except click.ClickException as error:
            from lagrange.core.printable import visible

            vars(error)["message"] = visible(error.message)  # it may repeat the name of a file
            raise
        except (click.exceptions.Exit, click.Abort):
            raise  # click shows these
        except KeyboardInterrupt:
            write_stderr("interrupted")
            sys.exit(INTERRUPTED)
        except BrokenPipeError:
            sys.exit(BROKEN_PIPE)
        except Exception as error:
            sys.exit(report_error(error))

    def format_usage(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Both forms of the command line."""
        formatter.write_usage(ctx.command_path, "PROBLEM... [OPTIONS]")
        formatter.write_usage(ctx.command_path, "COMMAND [ARGS]...", prefix="       ")

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """The options, those of the default command included."""
        options = [p for p in self.commands["solve"].params if isinstance(p, click.Option)]
        with formatter.section("Options of solving"):
            formatter.write_dl([r for o in options if (r := o.get_help_record(ctx))])
        super().format_options(ctx, formatter)


def complete_names(_context: click.Context, _parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The shipped problems with this prefix: by their last part, or with the topic if the prefix has one."""
    from click.shell_completion import CompletionItem

    from lagrange.problem import library
    from lagsolve.shipped import title_of

    paths = library.entries()
    names = {name: name for name in paths} if "/" in incomplete else {s: n for n, s in library.short_names().items()}
    return [
        CompletionItem(written, help=title_of(paths[name]))
        for written, name in names.items()
        if written.startswith(incomplete)
    ]


def complete_problems(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The shipped problems, and files."""
    from click.shell_completion import CompletionItem

    names = complete_names(context, parameter, incomplete)
    if not names or incomplete.startswith((".", "/", "~")):
        return complete_files(context, parameter, incomplete)
    from pathlib import Path

    near = sorted(str(p) for pattern in ("*.yaml", "*.yml") for p in Path().glob(pattern))
    return [*(CompletionItem(f, help="a file") for f in near if f.startswith(incomplete)), *names]


def complete_problem_first(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """A problem as the first of several arguments, then files."""
    complete = complete_files if context.params.get(parameter.name or "") else complete_problems
    return complete(context, parameter, incomplete)


def complete_files(_context: click.Context, _parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """A file, which the shell completes."""
    from click.shell_completion import CompletionItem

    return [CompletionItem(incomplete, type="file")]
