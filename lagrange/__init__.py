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
    from lagrange.answers.verdicts import Judgement, Verdict
    from lagrange.api.classroom import grade
    from lagrange.api.formulation import Formulation
    from lagrange.api.interface import check, load, loads, solve
    from lagrange.api.numerical import RightHandSide
    from lagrange.api.result import Result
    from lagrange.core.diagnostics import NotCoveredError, ProblemError, UndecidedError
    from lagrange.problem.model import Problem

    __version__: str

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
    "__version__",
    "check",
    "grade",
    "load",
    "loads",
    "solve",
]

_HOMES = {
    "answers.verdicts": ("Judgement", "Verdict"),
    "core.diagnostics": ("NotCoveredError", "ProblemError", "UndecidedError"),
    "api.classroom": ("grade",),
    "api.formulation": ("Formulation",),
    "api.interface": ("check", "load", "loads", "solve"),
    "api.numerical": ("RightHandSide",),
    "problem.model": ("Problem",),
    "api.result": ("Result",),
}


def __getattr__(name: str) -> Any:
    """A public name, imported when it is first used."""
    if name == "__version__":
        globals()[name] = _version()
        return globals()[name]
    for home, names in _HOMES.items():
        if name in names:
            value = getattr(import_module(f"lagrange.{home}"), name)
            globals()[name] = value
            return value
    raise AttributeError(f"module 'lagrange' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)


def _version() -> str:
    """The version of the distribution; "0+unknown" where these files are used without being installed."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("lagsolve")
    except PackageNotFoundError:
        return "0+unknown"
