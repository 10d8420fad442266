"""Terms of an answer, reduced modulo the derived equations at random states."""

from __future__ import annotations

import sympy as sp

from lagrange.answers.models.residues import equations_of, follows
from tests.support.shared import reference_of


def test_what_follows_and_what_does_not() -> None:
    candidate = next(c for c in reference_of("ex11-ideal-pendulum").candidates if c.choice == "angle")
    [equation] = candidate.system.equations
    at = candidate.residues.states([equation])
    theta = candidate.configuration.slots.coordinates[0]
    assert follows(3 * equation * sp.cos(theta), at)
    assert not follows(equation + theta, at)
    assert equations_of(candidate.system) == (equation,)
