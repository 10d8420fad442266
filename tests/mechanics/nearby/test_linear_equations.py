"""The equations to first order about a state.

Taylor series about a state.

The state about which a motion is linearized.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.core.symbols import Slots
from lagrange.mechanics.nearby.checks import check_linear_motion
from lagrange.mechanics.nearby.linear_equations import Expansions
from lagrange.mechanics.nearby.linear_motion import linear_motion
from tests.mechanics.nearby.test_linear_motion import DISC, PENDULUM, problem_of


def test_the_reaction_has_its_share_in_the_stiffness(tmp_path) -> None:
    problem, configuration = problem_of(tmp_path, PENDULUM)
    found = linear_motion(problem, configuration)
    [block] = found.blocks
    assert (block.mass, block.damping) == (((2,),), ((7,),))
    assert block.stiffness == ((sp.Rational(35, 3),),)  # s + m g/l
    assert check_linear_motion(problem, configuration, found)[0].passed


# Expansions


x, y = sp.symbols("x y", real=True)
SLOTS = Slots((x, y))


def test_values_at_a_state() -> None:
    values = {x: sp.Rational(1, 3), y: sp.Rational(2), **dict.fromkeys(SLOTS.velocities, sp.Integer(1))}
    about = Expansions(SLOTS, values)
    assert abs(float(about.value(x * y)) - 2 / 3) < 1e-15


# Reference


def test_velocities_that_nothing_determines(tmp_path) -> None:
    text = DISC.replace("phi': 0, theta': 0, ", "")
    with pytest.raises(ProblemError) as error:
        linear_motion(*problem_of(tmp_path, text))
    assert error.value.diagnostics[0].code == "undetermined-motion"
