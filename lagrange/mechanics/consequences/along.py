"""Whether an expression vanishes along every motion: whether it follows from the equations of motion.

An expression that is affine in the accelerations is a linear combination of the equations of motion, and of the
constraints differentiated, if it does not raise their rank at random states of motion.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.core.operations import count_operations
from lagrange.core.symbols import Unspecified
from lagrange.mechanics.consequences.limits import LONGEST_FOLLOWED
from lagrange.mechanics.dynamics.comparison import follow
from lagrange.mechanics.dynamics.equations import EquationsOfMotion


def is_short(motion: EquationsOfMotion) -> bool:
    """Whether the equations of motion are short enough, and contain no function that is not specified."""
    equations = [e.expression for e in motion.final]
    return not any(e.has(Unspecified) for e in equations) and sum(map(count_operations, equations)) <= LONGEST_FOLLOWED


def vanish_along(motion: EquationsOfMotion, claims: Sequence[sp.Expr]) -> bool:
    """Whether all of these vanish along every motion; False, too, where that is undecided."""
    configuration = motion.configuration
    known = [*(e.expression for e in motion.final), *configuration.accelerated_constraints]
    try:
        return follow(configuration, claims, known, configuration.slots.accelerations) is True
    except DivisionByZeroError:
        return False
