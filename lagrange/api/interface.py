"""The functions of `import lagrange`: load a problem, solve it, and check answers to it.

    problem = lagrange.load("ex11-ideal-pendulum")
    result = lagrange.solve(problem)
    lagrange.check(result, "l theta'' + g sin theta = 0").verdict

Everything that is wrong with a problem is raised as a `ProblemError`, whose text is what the command prints.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import IO

from lagrange.answers.examiner import Examiner
from lagrange.answers.references import reference_of_solution
from lagrange.answers.verdicts import Judgement, notation_of_problem
from lagrange.api.notebook import problem_in_html
from lagrange.api.result import Result
from lagrange.api.time_functions import answer_of
from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.explain.report import report
from lagrange.mechanics.dynamics.motion import Method
from lagrange.problem.library import is_file_name, path_of
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Answers, Problem
from lagrange.problem.sources import decode, read_source

Problem.in_html = staticmethod(problem_in_html)


def load(problem: str | os.PathLike[str] | IO[str] | IO[bytes]) -> Problem:
    """The problem of a file, or of the shipped library.

    problem  a path, an open file, or the name of a shipped problem: "ex11-ideal-pendulum", or the prefix "ex11"

    Raises ProblemError with all mistakes of the file, or if there is no such problem.
    """
    if isinstance(problem, str):
        return read_problem(_named(problem))
    if isinstance(problem, os.PathLike):
        return read_problem(read_source(Path(problem)))
    if not hasattr(problem, "read"):
        raise TypeError(f"`load` takes a path, an open file or a name, and not {type(problem).__name__}")
    read, name = problem.read(), str(getattr(problem, "name", "the file"))
    return read_problem(decode(read.encode() if isinstance(read, str) else read, name))


def _named(name: str) -> Source:
    """The text of a file, or else of a shipped problem."""
    if "\n" in name:
        message = "expected a file name or the name of a problem, got a text of several lines"
        raise ProblemError(
            Diagnostic("no-such-problem", message, help="`lagrange.loads` reads a problem from its text")
        )
    return read_source(Path(name) if is_file_name(name) else path_of(name))


def loads(text: str, name: str = "problem") -> Problem:
    """The problem in a text; `name` is its name in messages. Raises ProblemError with all its mistakes."""
    return read_problem(Source(name, text.replace("\r\n", "\n").replace("\r", "\n")))


def solve(problem: Problem, choice: str | None = None, *, method: str = "dalembert") -> Result:
    """A problem, solved, checked and explained.

    choice  only this choice of generalized coordinates
    method  how the equations of motion are derived: "dalembert", or "lagrange" for T, V and Lagrange's equations

    Raises ProblemError if the problem contradicts itself; UndecidedError and NotCoveredError, which are ProblemErrors,
    if it cannot be solved; ValueError if there is no such method. `holds` of the result tells whether all checks held.
    """
    _check_problem(problem, "solve")
    if method not in [*Method]:
        raise ValueError(f"there is no method `{method}`; the methods are {', '.join(Method)}")
    return Result(report(problem, choice, method=Method(method)))


def check(problem: Problem | Result, equations: object = None) -> Judgement:
    """The verdict on someone's equations.

    problem    the problem, or its result if it has been solved already
    equations  one, or a list, tuple or matrix of them: texts, plain or in LaTeX, and SymPy's `Eq`, or expressions that
               vanish, in symbols of the problem or in functions of time with `Derivative`. Lists in a list are
               alternatives for an equilibrium. None: the answers that the problem file states.

    An equation that cannot be read is part of the verdict. Raises ProblemError if the problem cannot be solved, or if
    there is nothing to compare.
    """
    if isinstance(problem, Result):
        examiner = Examiner(problem.problem, problem.solution)
    else:
        _check_problem(problem, "check")
        examiner = Examiner.of(problem)
    if equations is None:
        return examiner.check_own()
    solution = examiner.solution
    scope = examiner.reference.scope if solution is None else reference_of_solution(solution).scope
    notation = notation_of_problem(examiner.problem)
    if isinstance(equations, list | tuple) and equations and all(isinstance(e, list | tuple) for e in equations):
        alternatives = tuple(answer_of(part, scope, notation) for part in equations)
        return examiner.check_answers(Answers(equilibrium=alternatives))
    return examiner.check(answer_of(equations, scope, notation))


def _check_problem(problem: object, called: str) -> None:
    """Raises TypeError if this is no problem, but most likely its name."""
    if not isinstance(problem, Problem):
        meant = f": lagrange.{called}(lagrange.load({problem!r}))" if isinstance(problem, str | Path) else ""
        raise TypeError(f"`{called}` takes a problem, and not {type(problem).__name__}{meant}")
