"""The commands about problem files, none of which needs SymPy: list, show, new, schema, completion."""

from __future__ import annotations

import sys

import click

from lagsolve.command_group import complete_files, complete_names, write_stderr

PLATFORMS = ("gradescope", "prairielearn", "moodle", "coderunner")
"""For which `new --for` writes files."""


@click.command("list", short_help="List the shipped problems, or those that have every WORD.")
@click.argument("words", nargs=-1, metavar="[WORD]...")
@click.option("--long", "long", is_flag=True, help="Full sources, and what each problem exercises.")
def list_(words: tuple[str, ...], long: bool) -> None:
    """List the shipped problems, or those in which every WORD occurs.

    The words are looked up in name, text, topic and exercise of a problem. In a pipe each problem is one line: name,
    title, questions, source and exercise, separated by tabs.
    """
    from lagrange.problem import library
    from lagsolve import shipped
    from lagsolve.output import styled, terminal_width, write_stdout

    index = shipped.index()
    entries = shipped.containing(words, index)
    if not entries:
        known = " ".join(dict.fromkeys(n.partition("/")[0] for n in library.entries()))
        write_stderr(f"no shipped problem has {' and '.join(f'`{w}`' for w in words)}; the topics are {known}")
    elif sys.stdout is None or not sys.stdout.isatty():
        write_stdout(shipped.listed_for_pipe(entries))
    else:
        called = library.short_names()
        write_stdout(shipped.listed_by_topic(entries, index, called, terminal_width(), long=long, styled=styled()))
        first = called[entries[0].name]
        write_stderr(
            f"\nlagsolve {first}\n    solves this one, lagsolve new mine.yaml --from NAME writes a copy to change\n"
            f"lagsolve list --long\n    tells more about each, lagsolve list WORD... finds those that contain the words"
        )


@click.command()
@click.argument("name", shell_complete=complete_names)
def show(name: str) -> None:
    """Print the problem file NAME of the library."""
    from lagrange.problem import library
    from lagsolve.output import write_stdout

    write_stdout(library.path_of(name).read_text(encoding="utf-8"))


@click.command(short_help="Write a problem file to start from, with every key explained.")
@click.argument("file", metavar="FILE", shell_complete=complete_files)
@click.option("--from", "name", metavar="NAME", shell_complete=complete_names, help="A copy of this shipped problem.")
@click.option("--for", "platform", type=click.Choice(PLATFORMS), help="What a teaching platform needs to grade it.")
def new(file: str, name: str | None, platform: str | None) -> None:
    """Write a problem file to start from: a template with every key explained, or a copy of a shipped problem.

    FILE gets the extension .yaml if it has none; `-` is standard output. An existing file is left alone.

    \b
    With --for, what a platform needs, for a problem of the library or a file of yours:
    lagsolve new autograder --from ex11 --for gradescope       a folder to be zipped
    lagsolve new pendulum --from ex11 --for prairielearn       a folder with a question
    lagsolve new pendulum.xml --from mine.yaml --for moodle    a question for Moodle; coderunner likewise
    """
    if platform is not None:
        if name is None:
            raise click.UsageError("--for needs a problem: --from NAME, of the library or a file")
        from lagsolve.inputs import problem_source
        from lagsolve.platforms.starters import create_for

        create_for(platform, file, problem_source(name))
        return
    from lagsolve.new_file import create

    create(file, name)


@click.command(short_help="Print a JSON Schema of problem files, for editors.")
def schema() -> None:
    """Print a JSON Schema of problem files, for editors that complete keys and mark mistakes.

    \b
    lagsolve schema > lagsolve.schema.json
    and at the top of a problem file, for editors that use yaml-language-server:
    # yaml-language-server: $schema=lagsolve.schema.json
    """
    import json

    from lagsolve.json_schema import problem_schema
    from lagsolve.output import write_stdout

    write_stdout(json.dumps(problem_schema(), ensure_ascii=False, indent=2) + "\n")


@click.command(short_help="Print a script that completes the command line in a shell.")
@click.argument("shell", type=click.Choice(("bash", "zsh", "fish")))
def completion(shell: str) -> None:
    """Print a script that makes a shell complete commands, options, shipped problems and files.

    \b
    bash  echo 'eval "$(lagsolve completion bash)"' >> ~/.bashrc
    zsh   echo 'eval "$(lagsolve completion zsh)"' >> ~/.zshrc      (after compinit)
    fish  lagsolve completion fish > ~/.config/fish/completions/lagsolve.fish
    """
    from click.shell_completion import get_completion_class

    from lagsolve.output import write_stdout

    kind = get_completion_class(shell)
    assert kind is not None  # click has these three
    write_stdout(kind(click.get_current_context().find_root().command, {}, "lagsolve", "_LAGSOLVE_COMPLETE").source())


COMMANDS = (list_, show, new, schema, completion)
