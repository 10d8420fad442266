"""Solving the problems of one command line, once or again and again."""

from __future__ import annotations

import gc
from typing import TYPE_CHECKING

from lagrange.core.records import record
from lagsolve.output import Destination
from lagsolve.stages import stage_shown
from lagsolve.status import OK, UNDECIDED, complain, say

if TYPE_CHECKING:
    from lagrange.explain.report import Report


@record
class Task:
    """What is to be solved, how, and where the result goes."""

    problems: tuple[str, ...]
    choice: str | None
    method: str
    destination: Destination

    def carry_out(self) -> int:
        """Solves the problems and writes what is found; the exit status. Raises what `Destination.write` raises."""
        reports, status = [], OK
        for name in self.problems:
            found, outcome = self._solved(name)
            reports.append(found)
            status = max(status, outcome)
        if any(reports):
            self.destination.write(reports)
        return status

    def _solved(self, name: str) -> tuple[Report | None, int]:
        """What is found, and its exit status. Messages go to standard error, under the name where there are several."""
        heading = f"{name}:\n" if len(self.problems) > 1 else ""
        try:
            found = self._report(name)
        except Exception as error:
            return None, complain(error, heading)
        messages = (*found.notes, *found.shortcomings)
        if messages:
            say(heading + "\n".join(map(str, messages)))
        return found, OK if found.holds else UNDECIDED

    def _report(self, name: str) -> Report:
        gc.disable()
        with stage_shown():
            from lagrange.explain.report import report
            from lagrange.mechanics.dynamics.motion import Method
            from lagrange.problem.loader import read_problem
            from lagsolve.reading import problem_source

            look_for_garbage_seldom()
            problem = read_problem(problem_source(name))
            return report(problem, self.choice, complete=self.destination.is_complete, method=Method(self.method))


def look_for_garbage_seldom() -> None:
    """Once everything is imported, with garbage left alone: modules stay anyway, and most of what a run makes too.

    Looking for garbage as often as Python does would be a tenth of the time; a large problem must not fill the memory.
    """
    if not gc.get_freeze_count():
        gc.freeze()
        gc.set_threshold(200_000, 20, 50)
    gc.enable()
