"""Seconds that solving takes, checks included: every shipped problem, and pendulums of n links.

    PYTHONPATH=.:cli python tests/bench/speed.py [--chains] [--problems] [NAME ...]

In one process, with SymPy and the program imported before; seconds of processor time, every problem up to three times,
the least of them counted. `printed` is what the command works out for a page, `complete` what JSON wants too. A chain is n
particles of any masses on rods of any lengths, in the plane: `angles`, positions given through n angles, and
`distances`, 2n Cartesian coordinates with n distance constraints and the angles as a choice.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator

from lagrange.diagnostics import Source
from lagrange.loader import read_problem
from lagrange.report import report
from lagsolve import library

LINKS = (2, 4, 8, 16)
RUNS = 3
BAR = 2.0
"""Seconds after which a problem is not run again."""


def chain(n: int, distances: bool) -> str:
    """The problem file of a chain of n links; y points down."""
    links = range(1, n + 1)
    lengths, masses = [f"l{k}" for k in links], [f"m{k}" for k in links]
    angles = [f"theta{k}" for k in links]
    lines = [f"title: Chain of {n} links", "axes: {i: right, j: down}"]
    lines.append(f"parameters: [{', '.join([*masses, *lengths, 'g'])}]")
    sums = {
        k: tuple(
            " + ".join(f"{r}*{f}({a})" for r, a in zip(lengths[:k], angles[:k], strict=True)) for f in ("sin", "cos")
        )
        for k in links
    }
    if distances:
        lines.append(f"coordinates: [{', '.join(f'x{k}, y{k}' for k in links)}]")
        lines.append("particles:")
        lines += [f"  P{k}: {{mass: m{k}, position: x{k}*i + y{k}*j}}" for k in links]
        lines.append("constraints:")
        lines += [
            f"  rod{k}: (x{k} - x{k - 1})^2 + (y{k} - y{k - 1})^2 = l{k}^2" if k > 1 else "  rod1: x1^2 + y1^2 = l1^2"
            for k in links
        ]
        lines += ["generalized_coordinates:", "  angles:", f"    coordinates: [{', '.join(angles)}]", "    substitute:"]
        lines += [f"      {c}{k}: {sums[k][n]}" for k in links for n, c in enumerate("xy")]
    else:
        lines.append(f"coordinates: [{', '.join(angles)}]")
        lines.append("particles:")
        lines += [f"  P{k}: {{mass: m{k}, position: '[{sums[k][0]}, {sums[k][1]}]'}}" for k in links]
    return "\n".join([*lines, "gravity: g*j", ""])


def problems(names: list[str]) -> Iterator[tuple[str, str]]:
    """Shipped problems: name and text."""
    for name, path in library.entries().items():
        if not names or name in names:
            yield name, path.read_text(encoding="utf-8")


def chains() -> Iterator[tuple[str, str]]:
    """The chains: name and text."""
    for distances in (False, True):
        for n in LINKS:
            yield f"chain of {n}, by {'distances' if distances else 'angles'}", chain(n, distances)


def seconds(name: str, text: str, *, complete: bool) -> tuple[float, bool, int]:
    """The least time of some runs, whether all checks held, and how many there were."""
    best, holds, count = float("inf"), True, 0
    for _ in range(RUNS):
        started = time.process_time()
        found = report(read_problem(Source(name, text)), complete=complete)
        best = min(best, time.process_time() - started)
        holds, count = found.holds, len(found.solution.checks)
        if best > BAR:
            break
    return best, holds, count


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description="Times of solving.")
    parser.add_argument("--chains", action="store_true")
    parser.add_argument("--problems", action="store_true")
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    everything = not (given.chains or given.problems or given.names)
    rows: list[tuple[str, str]] = []
    if given.problems or given.names or everything:
        rows += problems(given.names)
    if given.chains or everything:
        rows += chains()
    seconds("warm", chain(2, True), complete=True)  # what is imported on demand
    print(f"{'problem':44}{'printed':>8}{'complete':>10}{'checks':>8}")
    for name, text in rows:
        shown, *_ = seconds(name, text, complete=False)
        whole, holds, count = seconds(name, text, complete=True)
        print(f"{name:44}{shown:8.2f}{whole:10.2f}{count:8}{'' if holds else '   does not hold'}", flush=True)


if __name__ == "__main__":
    main()
