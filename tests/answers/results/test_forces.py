"""A wrong equation that states one force of constraint: what that force would be.

Wrong equations that hold for one sense of the motion.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.examiner import Examiner, reference
from lagrange.answers.readings import read_answer
from lagrange.answers.references import Reference, ReferenceCandidate, reference_of_solution
from lagrange.answers.results.forces import explained_force, one_sense
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from tests.support.shared import loaded, solved


def pendulum() -> tuple[Reference, ReferenceCandidate, sp.Symbol, sp.Expr]:
    """The reference, the candidate in the file's coordinates, λ, and its value."""
    solution = solved("ex11-ideal-pendulum")
    reference = reference_of_solution(solution)
    candidate = reference.candidates[0]
    assert solution.own.dynamics is not None
    assert solution.own.dynamics.reactions is not None
    value = solution.own.dynamics.reactions.multipliers["rod"]
    [multiplier] = candidate.multipliers
    assert value is not None
    return reference, candidate, multiplier, value


@pytest.mark.parametrize(
    ("factor", "said"),
    [
        (2, "it is twice as large as it should be"),
        (3, "only a number is wrong in it: the force is 1/3 times as large"),
        (sp.Rational(7, 5), ""),  # no ratio that is a usual mistake
    ],
)
def test_a_multiple_of_the_force_is_named(factor: sp.Expr, said: str) -> None:
    reference, candidate, multiplier, value = pendulum()
    assert explained_force(multiplier - factor * value, candidate, reference) == said


def test_an_equation_of_motion_states_no_force() -> None:
    reference, candidate, multiplier, value = pendulum()
    acceleration = candidate.configuration.slots.accelerations[0]
    assert explained_force(multiplier - 2 * value + acceleration, candidate, reference) == ""
    assert explained_force(value, candidate, reference) == ""


# One sense


BLOCK = """
title: Block
coordinates: [x]
parameters: [m, k, mu, g]
equations: ["m*x'' + k*x + mu*m*g*sign(x') = 0"]
"""


@pytest.mark.parametrize(
    ("equation", "said"),
    [
        ("m*x'' + k*x + mu*m*g", "it holds only while x' > 0"),
        ("m*x'' + k*x - mu*m*g", "it holds only while -x' > 0"),
        ("m*x'' + k*x", ""),
        ("m*x'' + k*x + 2*mu*m*g", ""),
    ],
)
def test_the_sense_is_named(equation: str, said: str) -> None:
    against = reference(read_problem(Source("block", BLOCK)))
    [e] = read_answer(Fragment.of(f"{equation} = 0"), against.scope).components
    found = one_sense(against.candidates[0].read(e), against.candidates[0].system)
    assert found.startswith(said)
    assert bool(found) is bool(said)


@pytest.mark.parametrize(
    ("equation", "right"),
    [("m*y'' = m*g - c*y'^2", True), ("m*y'' = m*g + c*y'^2", False), ("m*y'' = m*g - 2*c*y'^2", False)],
)
def test_a_motion_that_keeps_its_sense(equation: str, right: bool) -> None:
    """A ball that is dropped falls: y' > 0 from the start on."""
    verdict = Examiner(loaded("fall-through-air"), solved("fall-through-air", complete=False)).check(
        [Fragment.of(equation)]
    )
    assert (verdict.verdict is Verdict.EQUIVALENT) is right


def test_a_motion_that_turns_back_has_two_senses() -> None:
    verdict = Examiner(loaded("ball-thrown-up"), solved("ball-thrown-up", complete=False)).check(
        [Fragment.of("m*y'' = -m*g - c*y'^2")]
    )
    assert verdict.verdict is Verdict.WRONG
