"""The shipped problems and the textbook systems, each loaded and solved once in a process, for all tests.

What is found is frozen, so that tests may share it. All tests of one problem run in one process (`conftest.py` groups
them by it), so that with several processes, too, a problem is solved once.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from lagrange.answers.references import Reference, reference_of_solution
from lagrange.explain.report import Report, report
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.results import Solution
from lagrange.problem.loader import load
from lagrange.problem.model import Problem
from lagrange.programs.prepared import Prepared, prepared
from lagsolve.shipped import containing
from tests.support.paths import PROBLEMS, SYSTEM_FILES

SHIPPED = {p.stem: p for p in sorted(PROBLEMS.glob("*/*.yaml"))}
"""Name -> file of every shipped problem."""


def asking(question: str) -> list[str]:
    """The shipped problems that ask for `motion`, `equilibrium` or `constraints`, in formulas.

    Those of `large/` are not among them: their equations stand in abbreviations (tests/mechanics/nearby).

    Read from the YAML alone, since tests are collected by this, and loading every problem would take seconds in every
    process; `command/test_problem_commands.py` compares it with what the loader understands.
    """
    return [
        e.name.rpartition("/")[2] for e in containing(()) if question in e.asked and not e.name.startswith("large/")
    ]


def file_of(name: str | Path) -> Path:
    """The file of a problem: `ex11-ideal-pendulum`, `chapter6/ex11-ideal-pendulum`, a system of `truth/`, or a path."""
    if isinstance(name, Path):
        return name
    if name in SHIPPED:
        return SHIPPED[name]
    return PROBLEMS / f"{name}.yaml" if "/" in name else SYSTEM_FILES / f"{name}.yaml"


@cache
def _loaded(path: Path) -> Problem:
    return load(path)


@cache
def _reported(path: Path, method: Method, complete: bool) -> Report:
    return report(_loaded(path), method=method, complete=complete)


@cache
def _in_numbers(path: Path, choice: str | None) -> Prepared:
    return prepared(_loaded(path), choice)


def in_numbers(name: str | Path, choice: str | None = None) -> Prepared:
    """The first-order equations of a problem, and where its motion starts."""
    return _in_numbers(file_of(name), choice)


def loaded(name: str | Path) -> Problem:
    """A problem as it is read."""
    return _loaded(file_of(name))


def reported(name: str | Path, method: Method = Method.DALEMBERT, complete: bool = True) -> Report:
    """A problem solved and explained."""
    return _reported(file_of(name), method, complete)


def solved(name: str | Path, method: Method = Method.DALEMBERT, complete: bool = True) -> Solution:
    """A problem solved. It is explained at the same time, because some other test will want that."""
    return reported(name, method, complete).solution


@cache
def _reference(path: Path) -> Reference:
    return reference_of_solution(solved(path))


def reference_of(name: str | Path) -> Reference:
    """What answers to a problem of motion are compared with."""
    return _reference(file_of(name))
