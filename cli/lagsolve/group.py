"""How the command line behaves as a whole: the default command, the page of help, errors without a traceback."""

from __future__ import annotations

import sys
from typing import Any

import click

from lagsolve.status import BROKEN_PIPE, INTERRUPTED, complain, use_utf8

NOT_YET = {
    "new": "writing a commented template",
    "schema": "a JSON Schema of problem files",
}
FLAGS = ("-h", "--help", "--version")


class CommandLine(click.Group):
    """Commands, of which `solve` need not be named."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Puts `solve` in front where no command is named."""
        if args and args[0] in NOT_YET:
            ctx.fail(f"`lagsolve {args[0]}` ({NOT_YET[args[0]]}) is not there yet")
        if args and args[0] not in self.commands and args[0] not in FLAGS:
            args = ["solve", *args]
        return super().parse_args(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        """Runs a command. Whatever goes wrong is shown as a message, and has its exit status."""
        use_utf8()
        try:
            return super().invoke(ctx)
        except (click.ClickException, click.exceptions.Exit, click.Abort):
            raise  # click shows these
        except KeyboardInterrupt:
            click.echo("interrupted", err=True)
            sys.exit(INTERRUPTED)
        except BrokenPipeError:
            sys.exit(BROKEN_PIPE)
        except Exception as error:
            sys.exit(complain(error))

    def format_usage(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Both forms of the command line."""
        formatter.write_usage(ctx.command_path, "PROBLEM... [OPTIONS]")
        formatter.write_usage(ctx.command_path, "COMMAND [ARGS]...", prefix="       ")

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """The options of the default command as well."""
        options = [p for p in self.commands["solve"].params if isinstance(p, click.Option)]
        with formatter.section("Options of solving"):
            formatter.write_dl([r for o in options if (r := o.get_help_record(ctx))])
        super().format_options(ctx, formatter)
