"""The command `lagsolve`: solve (the default) and check; others are in `course_`, `program_` and `problem_commands`.

The result goes to standard output and everything else to standard error. Exit status: 0 done, and every check held;
1 an answer is not right; 2 something cannot be read, or contradicts itself; 3 undecided, not completed, a check failed.

Nothing is imported before it is needed: `--help` loads click and little else, `list` and `show` do not load SymPy.
"""

from __future__ import annotations

import gc
import sys
from typing import TYPE_CHECKING

import click

from lagsolve.command_group import CommandLine, complete_files, complete_problems, write_stderr
from lagsolve.course_commands import COURSE_COMMANDS, MEGABYTES, SECONDS
from lagsolve.exit_statuses import status_of_verdict
from lagsolve.limits import CHECK_MEGABYTES, CHECK_SECONDS
from lagsolve.problem_commands import COMMANDS
from lagsolve.program_commands import COMMANDS as PROGRAMS

if TYPE_CHECKING:
    from collections.abc import Callable

    from lagrange.answers.examiner import Examiner
    from lagrange.answers.verdicts import Judgement
    from lagrange.problem.model import Problem

FORMATS = ("pretty", "latex", "markdown", "html", "json")
METHODS = ("dalembert", "lagrange")
READERS = ("github", "myst", "quarto")
VECTORS = ("bold", "underlined", "arrow")
DIGITS = click.IntRange(1, 14)


@click.group(
    "lagsolve",
    cls=CommandLine,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="""\b
A first problem of your own:
  lagsolve new bead.yaml     write a template, or a copy with --from ex11
  lagsolve bead.yaml         solve it; with --watch whenever you save it

Exit status of solving: 0 done, and every check held; 2 the command line or a file cannot be read, or contradicts
itself; 3 not completed, undecided, or a check failed. Of check: 0 equivalent; 1 wrong, incomplete or trivial; 2
unreadable; 3 undecided. Of both: 130 interrupted by Ctrl-C.

To read a file named like a command, write `./check`.""",
)
@click.version_option(package_name="lagsolve", prog_name="lagsolve")
def main() -> None:
    """Derive the equations of motion of a mechanical system, step by step, and check them.

    PROBLEM is a file, `-` for standard input, or the name of a bundled problem (`ex11-ideal-pendulum`, or an
    unambiguous prefix such as `ex11`).
    """


@main.command(short_help="The default: derive and check the equations of each PROBLEM.")
@click.argument("problems", nargs=-1, required=True, metavar="PROBLEM...", shell_complete=complete_problems)
@click.option("--format", "format_", type=click.Choice(FORMATS), help="Default: pretty, or by the extension of -o.")
@click.option(
    "-o",
    "--output",
    metavar="FILE",
    shell_complete=complete_files,
    help="Write to a file: .tex .md .html .json .txt",
)
@click.option("--fragment", is_flag=True, help="LaTeX without a preamble, to \\input in your own notes.")
@click.option("--static", is_flag=True, help="A web page without a figure that moves, and without scripts.")
@click.option("--detail", type=click.Choice(("brief", "steps", "full")), default="steps", show_default=True)
@click.option("--method", type=click.Choice(METHODS), default="dalembert", show_default=True)
@click.option(
    "--choice", metavar="NAME", help="Only this choice of generalized coordinates; `all` shows every choice in full."
)
@click.option("--vectors", type=click.Choice(VECTORS), help="How vectors are set in LaTeX and Markdown. Default: bold.")
@click.option("--for", "reader", type=click.Choice(READERS), help="Whose Markdown: labels, blocks. Default: github.")
@click.option("--worksheet", is_flag=True, help="The statement, the figure, and room for each part.")
@click.option("--solution", is_flag=True, help="The solution with the numbers of the worksheet.")
@click.option("--beamer", is_flag=True, help="LaTeX frames for a talk.")
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE", help="A parameter's value; may be repeated.")
@click.option("--digits", type=DIGITS, default=4, show_default=True, metavar="N", help="Of results in numbers.")
@click.option("--timeout", type=SECONDS, metavar="SECONDS", help="Of processor time. Default: so many operations.")
@click.option("--memory", type=MEGABYTES, metavar="MB", help="Give up beyond so much. Default: no limit.")
@click.option("--watch", is_flag=True, help="Solve again whenever a file is saved, until Ctrl-C.")
def solve(
    problems: tuple[str, ...],
    format_: str | None,
    output: str | None,
    fragment: bool,
    static: bool,
    detail: str,
    method: str,
    choice: str | None,
    vectors: str | None,
    reader: str | None,
    worksheet: bool,
    solution: bool,
    beamer: bool,
    settings: tuple[str, ...],
    digits: int,
    timeout: float | None,
    memory: int | None,
    watch: bool,
) -> None:
    """Derive and check the equations of each PROBLEM.

    With --watch, solve again whenever one of the files is saved. --set 'l=30 cm' gives or replaces the value of a
    parameter; where all parameters of a result have values, it is printed in numbers too. Of a problem that is given up
    what is known is printed; with --timeout it may take as long as you say.

    Exit status: 0 done, and every check held; 2 the command line or a file cannot be read, or contradicts itself; 3 not
    completed, undecided, or a check failed; 130 interrupted by Ctrl-C.
    """
    from lagsolve.output import Destination, Layout
    from lagsolve.solve_task import SolveTask

    if watch and "-" in problems:
        raise click.UsageError("--watch needs a file: standard input cannot be read again")
    if problems.count("-") > 1:
        raise click.UsageError("standard input cannot be two problems")
    layout = Layout(worksheet, solution, beamer, reader or "github", static)
    destination = Destination.of(format_, output, fragment, detail, vectors, layout)
    destination.refuse_overwrite(problems)
    task = SolveTask(problems, choice, method, destination, settings, digits, timeout, memory)
    if watch:
        from lagsolve.solve_task import watch_for_ever

        watch_for_ever(task)
    sys.exit(task.run())


@main.command()
@click.argument("problem", metavar="PROBLEM", shell_complete=complete_problems)
@click.argument("answer_file", required=False, metavar="[ANSWER_FILE]", shell_complete=complete_files)
@click.option("-e", "--equation", "equations", multiple=True, help="An equation of the answer; may be repeated.")
@click.option("--format", "format_", type=click.Choice(("pretty", "json")), default="pretty", show_default=True)
@click.option(
    "--hint", type=click.IntRange(1, 3), help="How much to reveal about a wrong equation. Default: 3, everything."
)
@click.option("--reveal", is_flag=True, help="Print the derived equations too.")
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE", help="A parameter's value; may be repeated.")
@click.option(
    "--timeout", type=SECONDS, default=CHECK_SECONDS, show_default=True, metavar="SECONDS", help="Of processor time."
)
@click.option("--memory", type=MEGABYTES, default=CHECK_MEGABYTES, show_default=True, metavar="MB")
def check(
    problem: str,
    answer_file: str | None,
    equations: tuple[str, ...],
    format_: str,
    hint: int | None,
    reveal: bool,
    settings: tuple[str, ...],
    timeout: float,
    memory: int,
) -> None:
    """Compare equations of motion with the derived ones.

    Give the equations with -e, or in ANSWER_FILE, one per line (`#` begins a comment, `-` is standard input); for a
    .tex or .md file the mathematics is read. They may be in LaTeX. A .yaml file may answer the other questions too,
    with the keys of `answers` in a problem file. Without either, the answers in the problem file are compared.

    Exit status: 0 equivalent; 1 wrong, incomplete or trivial; 2 unreadable; 3 undecided; 130 interrupted by Ctrl-C.
    """
    if problem == answer_file == "-":
        raise click.UsageError("standard input cannot be both PROBLEM and ANSWER_FILE")
    from lagsolve.progress_line import stage_shown
    from lagsolve.time_and_memory import bounded

    gc.disable()
    with stage_shown() as on_stage, bounded(timeout, memory):
        from lagrange.answers.examiner import Examiner
        from lagrange.problem.loader import read_problem
        from lagsolve.inputs import problem_source, settings_read
        from lagsolve.output import write_verdict
        from lagsolve.solve_task import look_for_garbage_seldom

        look_for_garbage_seldom()
        on_stage("reading the problem")
        asked = read_problem(problem_source(problem), settings_read(settings))
        checked = _checking(asked, answer_file, equations)
        examiner = Examiner.of(asked, on_stage)
        on_stage("comparing answers")
        result = checked(examiner)
        score = examiner.score(result) if asked.points else None
    if hint is not None:
        result = result.at_hint_level(hint)
    for message in (*asked.notes, *result.messages):
        write_stderr(str(message))
    write_verdict(result, format_, examiner.revealed(result) if reveal else (), score)
    sys.exit(status_of_verdict(result.verdict))


def _checking(problem: Problem, answer_file: str | None, equations: tuple[str, ...]) -> Callable[[Examiner], Judgement]:
    """What checks the equations, a file with all answers, or, if neither is given, the problem file's own.

    The files are read before the problem is solved; what a text says depends on what the problem asks for.
    """
    from lagrange.problem.library import EXTENSIONS
    from lagsolve.inputs import answer_source, stated_answers, stated_equations

    if answer_file is not None and answer_file.lower().endswith(EXTENSIONS):
        answers, more = stated_answers(answer_file, problem), stated_equations(equations)
        return lambda examiner: examiner.check_answers(answers, more)
    if answer_file is None and not equations:
        return lambda examiner: examiner.check_own()
    given = stated_equations(equations)
    if answer_file is None:
        return lambda examiner: examiner.check(given)
    from pathlib import PurePath

    from lagrange.answers.submissions import answer_to

    source, ending = answer_source(answer_file), PurePath(answer_file).suffix
    return lambda examiner: examiner.check((*given, *answer_to(examiner, source, ending)))


for command in (*PROGRAMS, *COMMANDS, *COURSE_COMMANDS):
    main.add_command(command)
