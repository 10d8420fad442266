"""The commands that make a motion of a problem: simulate it, and export its equations as source."""

from __future__ import annotations

import gc
import os
import sys
from typing import TYPE_CHECKING

import click

from lagsolve.command_group import complete_files, complete_problems, write_stderr
from lagsolve.course_commands import SECONDS
from lagsolve.exit_statuses import OK, UNDECIDED

if TYPE_CHECKING:
    from lagrange.explain.report import Report
    from lagrange.mechanics.solution import OnStage
    from lagrange.problem.model import Problem
    from lagrange.programs.prepared import Prepared
    from lagrange.programs.simulation import Simulation

LANGUAGES = ("python", "c", "matlab", "julia")
PLOTS = (".svg", ".png", ".pdf")
PAGE = ".html"


@click.command(short_help="Integrate the motion of a PROBLEM: a table, a plot.")
@click.argument("problem", metavar="PROBLEM", shell_complete=complete_problems)
@click.option("--until", type=float, metavar="SECONDS", help="How long the motion is followed. Default: by its speed.")
@click.option(
    "--set",
    "settings",
    multiple=True,
    metavar="NAME=VALUE",
    help="A parameter, an initial value (theta=30 deg, theta'=0), or a function of time; may be repeated.",
)
@click.option("--choice", metavar="NAME", help="The coordinates. Default: independent ones, if there are any.")
@click.option("--samples", type=click.IntRange(2, 1_000_000), metavar="N", help="Lines of the table. Default: by time.")
@click.option(
    "-o", "--output", metavar="FILE", shell_complete=complete_files, help=".csv .svg .png .pdf .html; - is CSV."
)
@click.option("--timeout", type=SECONDS, metavar="SECONDS", help="Give up after so long. Default: no limit.")
def simulate(
    problem: str,
    until: float | None,
    settings: tuple[str, ...],
    choice: str | None,
    samples: int | None,
    output: str | None,
    timeout: float | None,
) -> None:
    """Integrate the equations of motion of PROBLEM from its initial state.

    Constraints are kept, the conditions of questions under `ask` are reported when they first hold, and the drift of
    what should be conserved is printed. Whatever the file gives no number for gets one, which is marked as assumed.

    \b
    lagsolve simulate ex18 --set "phi1=60 deg" --until 20 -o motion.svg
    lagsolve simulate pole-on-cart --set "u=0.1*sin(3*t)" -o motion.csv

    Exit status: 0 done; 2 the command line or the file cannot be read, or contradicts itself; 3 the motion could not be
    followed to the end, or what is conserved has drifted; 130 interrupted by Ctrl-C. Needs the extra `sim`.
    """
    import math

    if until is not None and not (until > 0 and math.isfinite(until)):
        raise click.UsageError(f"--until {until:g} is not a positive time")
    ending = _ending(problem, output, (".csv", *PLOTS, PAGE))
    from lagsolve.progress_line import stage_shown
    from lagsolve.time_and_memory import bounded

    with stage_shown() as on_stage, bounded(timeout, None):
        libraries = ("numpy", "scipy", *(("matplotlib",) if ending in PLOTS else ()))
        made, solved = _prepared(problem, settings, choice, on_stage, libraries, complete=True, page=ending == PAGE)
        from lagrange.core.effort import allowed_for
        from lagrange.programs.prepared import longest_time
        from lagrange.programs.simulation import simulated

        on_stage("integrating")
        end = until or longest_time(made.states, made.start)
        with allowed_for("integrating the motion", math.inf):
            result = simulated(made.states, made.start, end, questions=made.problem.questions, samples=samples)
        from lagsolve.simulation_report import report_text

        text = report_text(result, end, made.sampled, by_default=until is None)
        if output is not None:
            on_stage("writing")
            if solved is not None:
                _write_page(solved, result, output)
            else:
                _write(result, output, ending)
    from lagsolve.output import write_stdout

    for note in made.problem.notes:
        write_stderr(str(note))
    (write_stderr if output == "-" else write_stdout)(text if output == "-" else text + "\n")
    failed = _failed(made)
    if failed:
        write_stderr(failed)
    sys.exit(OK if result.is_accurate and not failed else UNDECIDED)


@click.command(short_help="Write the equations of a PROBLEM as source code.")
@click.argument("problem", metavar="PROBLEM", shell_complete=complete_problems)
@click.option("--to", "target", type=click.Choice(LANGUAGES), help="Default: by the extension of -o.")
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE", help="A value of the file that is written.")
@click.option("--choice", metavar="NAME", help="The coordinates. Default: independent ones, if there are any.")
@click.option("-o", "--output", metavar="FILE", shell_complete=complete_files, help="Default: standard output.")
def export(problem: str, target: str | None, settings: tuple[str, ...], choice: str | None, output: str | None) -> None:
    """Write a self-contained source file with f(t, y, p) = dy/dt for an integrator.

    y has the coordinates and then the velocities (or the quasi-velocities of the file), p the parameters; the header of
    the file lists them with their meanings. Names are made legal: theta' is theta_dot. In C the function is
    void f(double t, const double *y, const double *p, double *out). The MATLAB file runs in Octave too.

    \b
    lagsolve export ex18 --to c -o double_pendulum.c

    Exit status: 0 done; 2 the command line or the file cannot be read; 3 there is no such program.
    """
    ending = _ending(problem, output, (".py", ".c", ".m", ".jl") if target is None else ())
    target = target or {".py": "python", ".c": "c", ".m": "matlab", ".jl": "julia"}.get(ending)
    if target is None:
        raise click.UsageError("say which language: --to python, c, matlab or julia")
    from pathlib import Path

    from lagsolve.progress_line import stage_shown

    with stage_shown() as on_stage:
        made, _ = _prepared(problem, settings, choice, on_stage, (), complete=False)
        from lagrange.programs.languages import RESERVED, Target, legal_name
        from lagrange.programs.source import source_file

        on_stage("writing")
        stem = legal_name(Path(output).stem) if output not in (None, "-") and target == "matlab" else ""
        name = stem if stem and stem not in RESERVED else "f"
        text = source_file(made.states, made.start, Target(target), name)
    for note in made.problem.notes:
        write_stderr(str(note))
    if output in (None, "-"):
        from lagsolve.output import write_stdout

        write_stdout(text)
    else:
        from lagsolve.written_files import write_file

        write_file(Path(str(output)), text)
    failed = _failed(made)
    if failed:
        write_stderr(failed)
    sys.exit(UNDECIDED if failed else OK)


def _ending(problem: str, output: str | None, known: tuple[str, ...]) -> str:
    """The extension of the file that is written. Raises a usage error where it means nothing, or is the problem's."""
    if output in (None, "-"):
        return ".csv" if ".csv" in known else ""
    from pathlib import Path

    path = Path(str(output))
    if path.is_dir():
        raise click.UsageError(f"{path} is a folder; -o names a file")
    if path.exists() and os.path.exists(problem) and os.path.samefile(problem, path):
        raise click.UsageError(f"-o {path} would overwrite the problem file")
    ending = path.suffix.lower()
    if known and ending not in known:
        raise click.UsageError(f"the extension of {path} is not one of {' '.join(known)}")
    return ending


def _prepared(
    name: str,
    settings: tuple[str, ...],
    choice: str | None,
    on_stage: OnStage,
    libraries: tuple[str, ...],
    *,
    complete: bool,
    page: bool = False,
) -> tuple[Prepared, Report | None]:
    """The problem with its equations of motion, and what the command line sets; if `complete`, samples of functions.

    page  whether a page will show the motion: then its derivation comes second, solved once for both
    """
    gc.disable()
    from lagrange.problem.loader import read_problem
    from lagrange.programs.prepared import prepared, prepared_solution, require, require_masses, with_initial
    from lagrange.programs.starting import settings_of
    from lagsolve.inputs import problem_source, settings_read
    from lagsolve.solve_task import look_for_garbage_seldom

    look_for_garbage_seldom()
    require(*libraries)
    on_stage("reading the problem")
    source = problem_source(name)
    problem = read_problem(source)
    given = settings_of(problem, settings_read(settings))
    if given.parameters:
        problem = read_problem(source, given.parameters)
    if not page:
        return prepared(problem, choice, given, on_stage, complete=complete), None
    require_masses(problem)
    on_stage("solving")
    solved = _solved_for_page(with_initial(problem, given), choice)
    return prepared_solution(problem, solved.solution, choice, given, complete=complete), solved


def _write(result: Simulation, output: str, ending: str) -> None:
    from pathlib import Path

    if ending in PLOTS:
        from lagrange.programs.plots import plot_file
        from lagsolve.written_files import write_file

        write_file(Path(output), plot_file(result, ending))
        return
    from lagrange.programs.tables import csv_text

    if output == "-":
        from lagsolve.output import write_stdout

        write_stdout(csv_text(result))
    else:
        from lagsolve.written_files import write_file

        write_file(Path(output), csv_text(result))


def _solved_for_page(problem: Problem, choice: str | None) -> Report:
    """The derivation of the page, whose equations are also those that are integrated."""
    from dataclasses import replace

    from lagrange.core.diagnostics import ProblemError
    from lagrange.explain.report import report
    from lagrange.problem.model import Find

    try:
        return report(problem, choice or None, complete=False)
    except ProblemError:  # a steady motion that the file asks about need not begin as the command line says
        find = tuple(f for f in problem.find if f not in (Find.LINEARIZATION, Find.STEADY))
        return report(replace(problem, find=find), choice or None, complete=False)


def _write_page(solved: Report, result: Simulation, output: str) -> None:
    """The page of the problem, on which the figure goes through the motion that was computed."""
    from pathlib import Path

    from lagrange.animation.moving import moving_figure
    from lagrange.render import html
    from lagsolve.written_files import write_file

    moving = moving_figure(solved.solution, result)
    write_file(Path(output), html.render([(solved.derivation, solved.notation)], moving=[moving]))


def _failed(made: Prepared) -> str:
    """The checks of the derivation that did not hold, as a message; empty if there are none."""
    names = [check.name for check in made.solution.checks if check.passed is False]
    return f"these checks of the derivation did not hold: {'; '.join(names)}" if names else ""


COMMANDS = (simulate, export)
