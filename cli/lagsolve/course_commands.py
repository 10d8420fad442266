"""The commands of a course: grade, variant."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import click

from lagsolve.command_group import complete_files, complete_problem_first, complete_problems, write_stderr
from lagsolve.exit_statuses import INTERRUPTED, OK, UNDECIDED

if TYPE_CHECKING:
    from collections.abc import Sequence

SECONDS = click.FloatRange(0, 86_400, min_open=True)
MEGABYTES = click.IntRange(256)
FORMATS = ("csv", "gradescope", "prairielearn", "moodle", "canvas")
OF_ONE = ("gradescope", "prairielearn")
"""Formats about one submission, whose files are all that is named."""


@click.command(short_help="Grade a folder of submissions to one PROBLEM or several.")
@click.argument(
    "problems", nargs=-1, required=True, metavar="PROBLEM... ANSWERS...", shell_complete=complete_problem_first
)
@click.option("--csv", metavar="FILE", help="Write the table as CSV; `-` is standard output.")
@click.option("--feedback", metavar="DIR", help="Write a page of Markdown for each submission.")
@click.option("--format", "format_", type=click.Choice(FORMATS), help="What a platform reads, instead of the table.")
@click.option("-o", "--output", metavar="FILE", help="Where --format is written to. Default: standard output.")
@click.option(
    "--hint", type=click.IntRange(1, 3), default=3, help="How much pages and remarks reveal. Default: 3, all."
)
@click.option(
    "--attempts", type=click.Choice(("best", "last")), help="Several attempts of a student: which one counts."
)
@click.option(
    "--roster", metavar="FILE", help="When each was handed in: your CSV, Moodle's, Canvas', Gradescope's JSON."
)
@click.option("--due", metavar="TIME", help="Mark what was handed in later: 2026-11-20T18:00+01:00.")
@click.option("--variants", is_flag=True, help="Grade each student's variant; the seed is the student.")
@click.option("--assignment", metavar="NAME", help="The column for --format canvas. Default: the title.")
@click.option("--statistics", metavar="FILE.html", help="Write a page about the class, and FILE.csv beside it.")
@click.option("--jobs", type=click.IntRange(1), metavar="N", help="Processes on this machine. Default: one per core.")
@click.option("--timeout", type=SECONDS, default=60.0, show_default=True, metavar="SECONDS", help="For one submission.")
@click.option("--memory", type=MEGABYTES, default=1024, show_default=True, metavar="MB", help="For one submission.")
@click.option("--dask", metavar="ADDRESS", help="Grade on the cluster of this scheduler, tcp://host:8786.")
def grade(
    problems: tuple[str, ...],
    csv: str | None,
    feedback: str | None,
    format_: str | None,
    output: str | None,
    hint: int,
    attempts: str | None,
    roster: str | None,
    due: str | None,
    variants: bool,
    assignment: str | None,
    statistics: str | None,
    jobs: int | None,
    timeout: float,
    memory: int,
    dask: str | None,
) -> None:
    """Compare many submissions with the derived equations of one PROBLEM or several.

    ANSWERS are files, or folders in which every file, and every folder with one student's files, is a submission. With
    several problems, a heading, a file name or a key of a YAML file says which of them an answer belongs to. With
    --csv or --feedback, a batch that was interrupted continues when the same command is given again.
    Exit status: 0 every submission has its verdict; 2 the batch cannot begin; 3 some submissions need a look, because
    they are undecided or exceed the limits; 130 interrupted by Ctrl-C.
    """
    if not timeout > 0:  # a NaN
        raise click.UsageError(f"--timeout {timeout} is not a number of seconds")
    if dask is not None and jobs is not None:
        raise click.UsageError("--jobs is for this machine; the cluster of --dask has its own number of processes")
    if output is not None and format_ is None:
        raise click.UsageError("-o goes with --format; --csv FILE writes the table")
    if assignment is not None and format_ != "canvas":
        raise click.UsageError("--assignment goes with --format canvas")
    if format_ in OF_ONE and (csv or feedback or statistics):
        raise click.UsageError(f"--format {format_} is about one submission: leave out --csv, --feedback, --statistics")
    if statistics is not None and not statistics.lower().endswith((".html", ".htm")):
        raise click.UsageError(f"--statistics {statistics}: the page about the class is a web page, such as class.html")
    from pathlib import Path

    from lagsolve.grading.assignments import labelled, sorted_out
    from lagsolve.grading.pool import Limits, available_cores
    from lagsolve.grading.run import GradingRun, InterruptedBatchError, all_results
    from lagsolve.grading.students import Attempts, Roster, read_roster, time_of
    from lagsolve.output import write_rows

    named, answers = sorted_out(problems)
    limit = None if due is None else time_of(due, "--due")
    table = Roster() if roster is None else read_roster(Path(roster), limit)
    for file in (output, statistics):
        _refuse_overwrite(file, (*named, *answers, *([roster] if roster else [])))
    written = [Path(f) for f in (output, statistics, roster) if f is not None]
    written += [Path(statistics).with_suffix(".csv")] if statistics else []
    run = GradingRun(
        labelled(named),
        answers,
        Limits(timeout, memory),
        jobs or available_cores(),
        dask,
        Path(csv) if csv not in (None, "-") else None,
        Path(feedback) if feedback else None,
        hint,
        format_ in OF_ONE,
        variants,
        format_ if format_ in ("moodle", "canvas") else table.kind,
        table,
        None if attempts is None else Attempts(attempts),
        tuple(written),
    )
    try:
        rows, outcomes = all_results(run)
    except InterruptedBatchError as interrupted:
        write_stderr(str(interrupted))
        sys.exit(INTERRUPTED)
    if due is not None and any(not r.submitted for r in rows):
        unknown = sum(not r.submitted for r in rows)
        write_stderr(f"note: of {unknown:,} of {len(rows):,} it is not known when they were handed in: see --roster")
    if statistics is not None:
        from lagsolve.grading.statistics import write_statistics

        write_statistics(Path(statistics), run, rows)
    if format_ is not None:
        from lagsolve.platforms.formats import written_as

        _write(written_as(format_, run, rows, outcomes, assignment), output)
    else:
        write_rows(rows, as_csv=csv == "-")
    sys.exit(UNDECIDED if any(r.verdict == "undecided" for r in rows) else OK)


def _refuse_overwrite(file: str | None, given: Sequence[str]) -> None:
    """Raises a usage error where a file that is written is one of those that were given to be read."""
    import os

    if (
        file is not None
        and os.path.exists(file)
        and any(os.path.exists(g) and os.path.samefile(file, g) for g in given)
    ):
        raise click.UsageError(f"{file} would be overwritten, and is read: name another file")


def _write(text: str, output: str | None) -> None:
    from lagsolve.output import write_stdout

    if output in (None, "-"):
        write_stdout(text)
        return
    from pathlib import Path

    from lagsolve.written_files import write_file

    write_file(Path(str(output)), text)


@click.command(short_help="Write the variant of a PROBLEM that a seed draws.")
@click.argument("problem", metavar="PROBLEM", shell_complete=complete_problems)
@click.option("--seed", required=True, metavar="TEXT", help="Of the student: the same seed draws the same values.")
@click.option("-o", "--output", metavar="FILE", shell_complete=complete_files, help="Write to a file.")
def variant(problem: str, seed: str, output: str | None) -> None:
    """Write the variant of a PROBLEM that a seed draws: the file, with the values that its `vary` allows.

    The same seed draws the same values on every machine and in every version. The variant is solved before it is
    written: where it has no answer, it is refused. `lagsolve grade PROBLEM ANSWERS --variants` grades each student's.

    Exit status: 0 written; 2 the file has mistakes, or no `vary`, or the values leave no answer; 130 interrupted.
    """
    from lagrange.api.classroom import variant as drawn
    from lagsolve.inputs import problem_source

    source = problem_source(problem)
    _refuse_overwrite(output, (source.name,))
    _write(drawn(source, seed).text, output)


COURSE_COMMANDS = (grade, variant)
