"""The equations to first order about a state."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.nearby.checks import check_linear_motion
from lagrange.mechanics.nearby.linear_motion import linear_motion
from tests.mechanics.nearby.test_linear_motion import PENDULUM, problem_of


def test_the_reaction_has_its_share_in_the_stiffness(tmp_path) -> None:
    problem, configuration = problem_of(tmp_path, PENDULUM)
    found = linear_motion(problem, configuration)
    [block] = found.blocks
    assert (block.mass, block.damping) == (((2,),), ((7,),))
    assert block.stiffness == ((sp.Rational(35, 3),),)  # s + m g/l
    assert check_linear_motion(problem, configuration, found)[0].passed
