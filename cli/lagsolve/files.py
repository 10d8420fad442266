"""The commands about problem files, none of which needs SymPy: list, show, new, schema, completion."""

from __future__ import annotations

import sys

import click

from lagsolve.completing import files, shipped
from lagsolve.status import say


@click.command("list", short_help="List the shipped problems, or those that have every WORD.")
@click.argument("words", nargs=-1, metavar="[WORD]...")
@click.option("--long", "whole", is_flag=True, help="Sources in full, and what each problem exercises.")
def list_(words: tuple[str, ...], whole: bool) -> None:
    """List the shipped problems, or those in which every WORD occurs.

    A problem is found by its name, its text, its topic and what it exercises. Into a pipe each problem is one line:
    name, title, what is asked, source and what it exercises, with tabs between them.
    """
    from lagsolve import catalogue, library
    from lagsolve.output import put, styled, terminal_width

    says = library.index()
    found = library.containing(words, says)
    if not found:
        known = " ".join(dict.fromkeys(n.partition("/")[0] for n in library.entries()))
        say(f"no shipped problem has {' and '.join(f'`{w}`' for w in words)}; the topics are {known}")
    elif sys.stdout is None or not sys.stdout.isatty():
        put(catalogue.lines(found))
    else:
        called = library.short_names()
        put(catalogue.page(found, says, called, terminal_width(), whole=whole, styled=styled()))
        first = called[found[0].name]
        say(
            f"\nlagsolve {first}\n    solves this one, lagsolve new mine.yaml --from NAME writes a copy to change\n"
            f"lagsolve list --long\n    says more of each, lagsolve list WORD... finds those that have the words"
        )


@click.command()
@click.argument("name", shell_complete=shipped)
def show(name: str) -> None:
    """Print the problem file NAME of the library."""
    from lagsolve import library
    from lagsolve.output import put

    put(library.path_of(name).read_text(encoding="utf-8"))


@click.command(short_help="Write a problem file to start from, with every key explained.")
@click.argument("file", metavar="FILE", shell_complete=files)
@click.option("--from", "name", metavar="NAME", shell_complete=shipped, help="A copy of this shipped problem.")
def new(file: str, name: str | None) -> None:
    """Write a problem file to start from: a template with every key explained, or a copy of a shipped problem.

    FILE gets the ending .yaml if it has none; `-` is standard output. A file that is there already is left alone.
    """
    from lagsolve.beginning import create

    create(file, name)


@click.command(short_help="Print a JSON Schema of problem files, for editors.")
def schema() -> None:
    """Print a JSON Schema of problem files, with which an editor completes keys and marks mistakes.

    \b
    lagsolve schema > lagsolve.schema.json
    and at the top of a problem file, for editors that use yaml-language-server:
    # yaml-language-server: $schema=lagsolve.schema.json
    """
    import json

    from lagsolve.output import put
    from lagsolve.schema import problem_schema

    put(json.dumps(problem_schema(), ensure_ascii=False, indent=2) + "\n")


@click.command(short_help="Print a script that completes the command line in a shell.")
@click.argument("shell", type=click.Choice(("bash", "zsh", "fish")))
def completion(shell: str) -> None:
    """Print a script with which a shell completes commands, options, shipped problems and files.

    \b
    bash  echo 'eval "$(lagsolve completion bash)"' >> ~/.bashrc
    zsh   echo 'eval "$(lagsolve completion zsh)"' >> ~/.zshrc      (behind compinit)
    fish  lagsolve completion fish > ~/.config/fish/completions/lagsolve.fish
    """
    from click.shell_completion import get_completion_class

    from lagsolve.output import put

    kind = get_completion_class(shell)
    assert kind is not None  # click has these three
    put(kind(click.get_current_context().find_root().command, {}, "lagsolve", "_LAGSOLVE_COMPLETE").source())


COMMANDS = (list_, show, new, schema, completion)
