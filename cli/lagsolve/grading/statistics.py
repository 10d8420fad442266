"""What a class got wrong: a page for the teacher, in one file without scripts, and the same numbers as CSV.

It counts students, and contains no name, no individual mark and no text of a student. For each problem there are the
verdicts, the distribution of the points, and the mistakes, each with how many made it. Only the attempt that counts for
the marks is included. A mistake that only one person made is not named, because those who know the class could tell
whose it is.
"""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Iterator, Sequence
from html import escape
from pathlib import Path

from lagrange.answers.verdicts import Verdict
from lagrange.core.printable import printable
from lagsolve.grading.examine import problem_of
from lagsolve.grading.run import GradingRun
from lagsolve.grading.students import rows_that_count
from lagsolve.grading.table import ORDER, TableRow, cell
from lagsolve.limits import BINS, FEWEST_NAMED, MOST_MISTAKES_LISTED
from lagsolve.written_files import write_file

_SHADES = {
    Verdict.EQUIVALENT: "#2c6e3f",
    Verdict.INCOMPLETE: "#7fae6b",
    Verdict.TRIVIAL: "#b9b29f",
    Verdict.WRONG: "#b3261e",
    Verdict.UNREADABLE: "#8a8478",
    Verdict.UNDECIDED: "#6f4fa3",
}

_STYLE = """
body { font: 1rem/1.5 Georgia, serif; color: #1c1b1a; background: #fffefb; max-width: 46rem; margin: 2rem auto;
  padding: 0 1.2rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; border-top: 1px solid #d9d5cb; padding-top: 1rem; margin-top: 2rem; }
table { border-collapse: collapse; } td, th { text-align: left; padding: .2rem .8rem .2rem 0; vertical-align: top; }
td.n, th.n { text-align: right; } svg { max-width: 100%; height: auto; } .quiet { color: #6b6862; }
text { font: 13px Georgia, serif; fill: #1c1b1a; }
"""

Cluster = tuple[str, int]


def write_statistics(path: Path, run: GradingRun, rows: Sequence[TableRow]) -> None:
    """Writes the page, and beside it the CSV file. Raises ProblemError."""
    titles = {label: problem_of(source).title for label, source in run.problems}
    counted = rows_that_count(rows)
    write_file(path, page(titles, counted))
    write_file(path.with_suffix(".csv"), table(titles, counted))


def mistakes(rows: Sequence[TableRow]) -> tuple[list[Cluster], int]:
    """The mistakes that several made, the most frequent first, and how many one person alone made."""
    count = Counter(mistake for row in rows for mistake in row.mistakes.split("; ") if mistake)
    named = [(mistake, n) for mistake, n in count.most_common() if n >= FEWEST_NAMED]
    return named[:MOST_MISTAKES_LISTED], len(count) - len(named)


def table(titles: dict[str, str], rows: Sequence[TableRow]) -> str:
    """The numbers as CSV: what is counted, of which problem, how many, of how many."""
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(("problem", "what", "which", "number", "of"))
    for label in titles:
        asked = [row for row in rows if row.problem == label]
        verdicts = Counter(row.verdict for row in asked)
        lines = [("verdict", v.value, verdicts[v]) for v in ORDER if verdicts[v]]
        lines += [("points", f"{low} to {high} %", n) for low, high, n in _bins(asked)]
        lines += [("mistake", mistake, n) for mistake, n in mistakes(asked)[0]]
        lines += [("late", "", late)] if (late := sum(bool(row.late) for row in asked)) else []
        writer.writerows([cell(value) for value in (label, *line, len(asked))] for line in lines)
    return text.getvalue()


def page(titles: dict[str, str], rows: Sequence[TableRow]) -> str:
    """The page."""
    heading = ", ".join(titles.values())
    people = len({row.student for row in rows})
    lines = [
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{_text(heading)}: the class</title><style>{_STYLE}</style></head><body>",
        f"<h1>{_text(heading)}</h1>",
        f"<p>{people:,} {'person' if people == 1 else 'people'} handed something in.</p>",
    ]
    for label, title in titles.items():
        asked = [row for row in rows if row.problem == label]
        if len(titles) > 1:
            lines.append(f"<h2>{_text(label)}: {_text(title)}</h2>")
        lines += _of_problem(asked)
    return "\n".join([*lines, "</body></html>", ""])


def _of_problem(rows: Sequence[TableRow]) -> Iterator[str]:
    if not rows:
        yield "<p>Nobody answered it.</p>"
        return
    yield from _verdicts(rows)
    yield from _points(rows)
    named, others = mistakes(rows)
    if named:
        yield "<h3>Mistakes that several made</h3>"
        yield "<table><thead><tr><th class=n>how many</th><th class=n>of</th><th>mistake</th></tr></thead><tbody>"
        for mistake, n in named:
            yield f"<tr><td class=n>{n:,}</td><td class=n>{len(rows):,}</td><td>{_text(mistake)}</td></tr>"
        yield "</tbody></table>"
    if others:
        verb, each = ("mistake was", "") if others == 1 else ("mistakes were", " each")
        yield f'<p class="quiet">{others:,} other {verb} made by one person{each}, and not listed.</p>'
    if late := sum(bool(row.late) for row in rows):
        yield f"<p>{late:,} of {len(rows):,} were handed in late.</p>"


def _verdicts(rows: Sequence[TableRow]) -> Iterator[str]:
    """A bar of the verdicts, with a legend."""
    count = Counter(row.verdict for row in rows)
    present = [(verdict, count[verdict]) for verdict in ORDER if count[verdict]]
    listed = ", ".join(f"{n:,} {verdict.value}" for verdict, n in present)
    yield f'<svg role="img" viewBox="0 0 640 34" width="640" height="34"><title>Verdicts: {listed}</title>'
    left = 0.0
    for verdict, n in present:
        width = 640 * n / len(rows)
        yield f'<rect x="{left:.1f}" y="0" width="{width:.1f}" height="34" fill="{_SHADES[verdict]}"/>'
        if width > 24:
            yield f'<text x="{left + width / 2:.1f}" y="22" text-anchor="middle" style="fill:#fff">{n:,}</text>'
        left += width
    yield "</svg>"
    marks = (f'<span style="color:{_SHADES[v]}">■</span> {n:,} {v.value}' for v, n in present)
    yield f"<p>{' &nbsp; '.join(marks)}</p>"


def _bins(rows: Sequence[TableRow]) -> list[tuple[int, int, int]]:
    """How many have between 0 and 10 % of the points, ..., between 90 and 100 %: (from, to, number)."""
    shares = [row.points / row.possible for row in rows if row.points is not None and row.possible]
    places = Counter(min(BINS - 1, int(share * BINS + 1e-9)) for share in shares)
    step = 100 // BINS
    return [(n * step, (n + 1) * step, places[n]) for n in range(BINS)] if shares else []


def _points(rows: Sequence[TableRow]) -> Iterator[str]:
    """A histogram of the points."""
    bins = _bins(rows)
    if not bins:
        return
    scores = [row.points / row.possible for row in rows if row.points is not None and row.possible]
    mean, highest = sum(scores) / len(scores), max(n for _, _, n in bins)
    yield f"<h3>Points</h3><p>Mean {100 * mean:.0f} % of the points.</p>"
    shares = ", ".join(f"{n} with {low} to {high} %" for low, high, n in bins if n)
    yield f'<svg role="img" viewBox="-14 0 668 190" width="668" height="190"><title>Points: {shares}</title>'
    for place, (_, _, n) in enumerate(bins):
        height = 140 * n / highest
        x = 10 + place * 62
        if n:
            yield f'<rect x="{x}" y="{160 - height:.1f}" width="56" height="{height:.1f}" fill="#5d7a94"/>'
            yield f'<text x="{x + 28}" y="{154 - height:.1f}" text-anchor="middle">{n:,}</text>'
    yield '<line x1="8" y1="160" x2="632" y2="160" stroke="#1c1b1a"/>'
    for place in range(0, BINS + 1, 2):
        yield f'<text x="{7 + place * 62}" y="180" text-anchor="middle">{place * 100 // BINS} %</text>'
    yield "</svg>"


def _text(text: str) -> str:
    return escape(" ".join(printable(text).split()))
