"""How long a verdict takes, the problem being loaded: `make bench`.

Each answer of the table (`test_answers_table`) is judged once by a reference that has judged one other answer, as in
a marked pile of answers; a verdict is with its remarks and reasons, without the diagnosis, which has its own benchmark.
Beside it stands what a student of SymPy would do, `simplify` of the difference of the accelerations that two systems
give.
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

import sympy as sp
from sympy.core.cache import clear_cache

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from answer_truth import read
from test_answers_table import GIVEN, SOLVED, TABLE, fragments

from lagrange.answers import check_equations
from lagrange.checking import reference
from lagrange.diagnostics import ProblemError, Source
from lagrange.loader import read_problem

COMPARED = ("3", "8", "15", "20", "38", "40", "42", "44")
"""Answers for which SymPy is asked, those that it reads as they are."""
GOAL = 5.0
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
    """row of the table -> milliseconds of its first verdict, the best of some runs."""
    found: dict[str, float] = {}
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
            found[row] = min(found.get(row, took), took)
    return found


def accelerations(system: str, equations: list[str]) -> list[sp.Expr]:
    """What equations say of the accelerations, by Cramer's rule, as it comes out."""
    names = [f"{q.strip()}''" for q in GIVEN[system][0].split(",")]
    left = [read(e.replace("2 theta", "2*theta")) for e in equations]
    unknowns = [sp.Symbol(n) for n in names]
    matrix = sp.Matrix([[e.diff(u) for u in unknowns] for e in left])
    right = sp.Matrix([-e.xreplace(dict.fromkeys(unknowns, sp.S.Zero)) for e in left])
    return list(matrix.adjugate() * right / matrix.det(method="berkowitz"))


def simplification(row: str) -> float:
    """What `simplify` of the differences from the right accelerations takes."""
    system, answer, _ = TABLE[row]
    ours, theirs = accelerations(system, GIVEN[system][2]), accelerations(system, answer.split(";"))
    clear_cache()
    return milliseconds(lambda: [sp.simplify(a - b) for a, b in zip(ours, theirs, strict=True)])


def main() -> None:
    """Prints the table."""
    for name, text_of in (("solved problem", SOLVED.__getitem__), ("equations given", given)):
        times = verdicts(text_of)
        median, worst = statistics.median(times.values()), max(times, key=times.__getitem__)
        print(f"verdict, {name}: median {median:.2f} ms (goal {GOAL:g}), longest {times[worst]:.1f} ms ({worst})")
        for row in COMPARED:
            simplify = simplification(row)
            print(
                f"  {row:>3}  verdict {times[row]:6.2f} ms   simplify {simplify:7.1f} ms   ratio {simplify / times[row]:6.1f}"
            )


if __name__ == "__main__":
    main()
