"""Wrong equations that hold for one sense of the motion."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import reference
from lagrange.answers.readings import read_answer
from lagrange.answers.results.one_sense import one_sense
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem

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
