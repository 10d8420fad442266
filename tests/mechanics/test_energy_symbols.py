"""Which letters the energies get where T, V and Q are taken."""

from __future__ import annotations

from collections.abc import Callable

from lagrange.answers.references import reference_of_solution
from lagrange.explain.report import report
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.energy_symbols import energy_symbols
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from tests.support.lagrange_motions import TAKEN
from tests.support.printed_equations import equations_in, unreadable

Read = Callable[[str], Problem]


def test_letters_that_a_problem_has_used(problem: Read) -> None:
    found = report(problem(TAKEN), method=Method.LAGRANGE)
    named = energy_symbols(found.solution)
    assert (named.kinetic.name, named.potential.name, named.lagrangian.name) == ("K", "U", "Lambda")
    x, y = found.solution.problem.slots.coordinates
    assert (named.momentum(x).name, named.force(y).name, named.speed("P").name) == ("P_x", "K_y", "u_P")
    reference = reference_of_solution(found.solution)
    assert [f for e in equations_in(as_object(found)) for f in unreadable(e, reference)] == []
    assert found.holds
