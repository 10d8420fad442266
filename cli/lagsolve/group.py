"""How the command line behaves as a whole: the default command, the page of help, errors without a traceback."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import click

from lagsolve.status import BROKEN_PIPE, INTERRUPTED, complain, use_utf8

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

COMMANDS = ("solve", "check", "grade", "list", "show", "new", "schema", "completion")
"""In the order in which the page of help has them."""

FLAGS = ("-h", "--help", "--version")


class CommandLine(click.Group):
    """Commands, of which `solve` need not be named."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Puts `solve` in front where no command is named; `help COMMAND` is `COMMAND --help`."""
        if args[:1] == ["help"]:
            args = [*(name for name in args[1:2] if name in self.commands), "--help"]
        if args and args[0] not in self.commands and args[0] not in FLAGS:
            args = ["solve", *args]
        return super().parse_args(ctx, args)

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002
        """The commands, those first that are needed first."""
        return [c for c in COMMANDS if c in self.commands]

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """What may begin the command line: a command, or what may follow `solve`.

        That a file is wanted comes first: bash forgets what stands before it.
        """
        solving = click.Context(self.commands["solve"], parent=ctx, info_name="solve")
        if incomplete.startswith("-"):
            options = (*super().shell_complete(ctx, incomplete), *solving.command.shell_complete(solving, incomplete))
            return list({option.value: option for option in options}.values())
        [problems] = (p for p in solving.command.params if p.name == "problems")
        return [*problems.shell_complete(solving, incomplete), *super().shell_complete(ctx, incomplete)]

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
