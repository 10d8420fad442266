"""How long a verdict takes, the problem being loaded: `make bench`.

Each answer of the table (`tests/answers/test_equations.py`) is judged once by a reference that has judged one other answer, as in
a marked pile of answers; a verdict is with its remarks and reasons, without the diagnosis, which has its own benchmark.
For comparison, what a user of SymPy would do: `simplify` and `.equals(0)` of the difference of the accelerations that
two systems give. All times are medians of five, a verdict's and its peers' in turn; ratios are medians of the ratios.
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

import sympy as sp
from sympy.core.cache import clear_cache

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from lagrange.answers.equations import check_equations
from lagrange.answers.examiner import reference
from lagrange.core.diagnostics import ProblemError, Source
from lagrange.problem.loader import read_problem
from tests.answers.test_equations import GIVEN, SOLVED, TABLE, fragments
from tests.support.answer_truth import read

COMPARED = ("3", "8", "15", "20", "38", "40", "42", "44")
"""Answers for which SymPy is asked, those that it reads as they are."""
GOAL = 2.0
RUNS = 5


def milliseconds(run: Callable[[], object]) -> float:
    """How long a call takes."""
    start = time.perf_counter()
    run()
    return (time.perf_counter() - start) * 1e3


def given(system: str) -> str:
    """The problem file with the equations outright."""
    coordinates, parameters, equations = GIVEN[system]
    listed = "".join(f'  - "{e}"\n' for e in equations)
    return f"title: {system}\ncoordinates: [{coordinates}]\nparameters: [{parameters}]\nequations:\n{listed}"


def verdicts(text_of: Callable[[str], str]) -> dict[str, float]:
    """row of the table -> milliseconds of its first verdict, the median of some runs."""
    found: dict[str, list[float]] = {}
    for _ in range(RUNS):
        references = {system: reference(read_problem(Source(system, text_of(system)))) for system in SOLVED}
        for against in references.values():
            check_equations(fragments("0 = 0"), against)
        for row, (system, answer, _) in TABLE.items():
            try:
                took = milliseconds(
                    lambda a=answer, r=references[system]: check_equations(fragments(a), r, diagnosing=False)
                )
            except ProblemError:
                continue
            found.setdefault(row, []).append(took)
    return {row: statistics.median(times) for row, times in found.items()}


def accelerations(system: str, equations: list[str]) -> list[sp.Expr]:
    """The accelerations that equations determine, by Cramer's rule, unsimplified."""
    names = [f"{q.strip()}''" for q in GIVEN[system][0].split(",")]
    left = [read(e.replace("2 theta", "2*theta")) for e in equations]
    unknowns = [sp.Symbol(n) for n in names]
    matrix = sp.Matrix([[e.diff(u) for u in unknowns] for e in left])
    right = sp.Matrix([-e.xreplace(dict.fromkeys(unknowns, sp.S.Zero)) for e in left])
    return list(matrix.adjugate() * right / matrix.det(method="berkowitz"))


def by_sympy(row: str, decide: Callable[[sp.Expr], object]) -> float:
    """What deciding about the differences from the right accelerations takes."""
    system, answer, _ = TABLE[row]
    ours, theirs = accelerations(system, GIVEN[system][2]), accelerations(system, answer.split(";"))
    clear_cache()
    return milliseconds(lambda: [decide(a - b) for a, b in zip(ours, theirs, strict=True)])


def verdict(row: str, text_of: Callable[[str], str]) -> float:
    """One verdict, the reference having judged another answer."""
    system, answer, _ = TABLE[row]
    against = reference(read_problem(Source(system, text_of(system))))
    check_equations(fragments("0 = 0"), against)
    return milliseconds(lambda: check_equations(fragments(answer), against, diagnosing=False))


def compared(row: str, text_of: Callable[[str], str]) -> tuple[float, ...]:
    """Medians of a verdict, of `simplify`, of `.equals`, and of the ratios of the two to the verdict."""
    found = [
        (verdict(row, text_of), by_sympy(row, sp.simplify), by_sympy(row, lambda d: d.equals(0))) for _ in range(RUNS)
    ]
    rows = [*zip(*found, strict=True), *zip(*((s / v, e / v) for v, s, e in found), strict=True)]
    return tuple(statistics.median(column) for column in rows)


def main() -> None:
    """Prints the table."""
    for name, text_of in (("solved problem", SOLVED.__getitem__), ("equations given", given)):
        times = verdicts(text_of)
        median, worst = statistics.median(times.values()), max(times, key=times.__getitem__)
        print(f"verdict, {name}: median {median:.2f} ms (goal {GOAL:g}), longest {times[worst]:.1f} ms ({worst})")
        print(f"  {'answer':8}{'verdict ms':>12}{'simplify ms':>13}{'1 to':>7}{'equals ms':>12}{'1 to':>7}")
        for row in COMPARED:
            ours, simplify, equals, first, second = compared(row, text_of)
            print(f"  {row:8}{ours:12.2f}{simplify:13.1f}{first:7.0f}{equals:12.1f}{second:7.0f}", flush=True)


if __name__ == "__main__":
    main()
