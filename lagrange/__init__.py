"""Analytical mechanics step by step: constraints, virtual displacements, d'Alembert's principle.

    import lagrange

    problem = lagrange.load("ex11-ideal-pendulum")  # a file, or the name of a shipped problem
    result = lagrange.solve(problem)
    result["angle"].equations  # (l*theta'' + g*sin(theta),)
    lagrange.check(result, "l theta'' + g sin theta = 0").verdict  # equivalent

docs/python.md has the rest. Nothing is imported before it is used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from lagrange.answers import Verdict
    from lagrange.diagnostics import NotCoveredError, ProblemError, UndecidedError
    from lagrange.formulation import Formulation
    from lagrange.interface import check, load, loads, solve
    from lagrange.judgement import Judgement
    from lagrange.numerical import RightHandSide
    from lagrange.problem import Problem
    from lagrange.result import Result

__all__ = [
    "Formulation",
    "Judgement",
    "NotCoveredError",
    "Problem",
    "ProblemError",
    "Result",
    "RightHandSide",
    "UndecidedError",
    "Verdict",
    "check",
    "load",
    "loads",
    "solve",
]

_HOMES = {
    "answers": ("Verdict",),
    "diagnostics": ("NotCoveredError", "ProblemError", "UndecidedError"),
    "formulation": ("Formulation",),
    "interface": ("check", "load", "loads", "solve"),
    "judgement": ("Judgement",),
    "numerical": ("RightHandSide",),
    "problem": ("Problem",),
    "result": ("Result",),
}


def __getattr__(name: str) -> Any:
    """A public name, imported when it is first used."""
    for home, names in _HOMES.items():
        if name in names:
            found = getattr(import_module(f"lagrange.{home}"), name)
            globals()[name] = found
            return found
    raise AttributeError(f"module 'lagrange' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
