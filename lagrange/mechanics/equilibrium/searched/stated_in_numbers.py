"""Equilibria that have no closed form, against an answer: points of them in numbers, tried in the answer's equations.

An answer may state such equilibria in a form of its own: tan α = 3/2 with the constraints of a linkage, where the
program has sin α and cos α with two equations left. Neither form can be reduced to the other in letters. So parameters
are drawn, positions are found to 45 digits (`StatedPlaces`), and at each of them one alternative must hold.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import islice

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.core.symbols import Decimal
from lagrange.mechanics.equilibrium.limits import UNSOLVED_POINTS
from lagrange.mechanics.equilibrium.searched.stated_places import StatedPlaces, is_small, without_functions
from lagrange.mechanics.equilibrium.searched.tape import DIGITS, NoTapeError, Tape


def are_covered(
    equations: Sequence[sp.Expr],
    conditions: Sequence[SignCondition],
    unknowns: Sequence[sp.Symbol],
    turning: Collection[sp.Expr],
    alternatives: Sequence[Sequence[sp.Expr]],
) -> bool | None:
    """Whether one of several systems holds at every point found of a surface where conditions are met; None: undecided.

    turning  the unknowns that are angles
    """
    asked = [x for system in alternatives for x in system]
    if any(isinstance(s, Decimal) for x in asked for s in x.free_symbols):
        return None
    verdicts = []
    try:
        places = StatedPlaces(equations, conditions, unknowns, turning, asked)
        tapes = [Tape(without_functions(system), places.symbols) for system in alternatives]
        with mpmath.workdps(60):
            for place in islice(places, UNSOLVED_POINTS):
                verdicts.append(_one_holds(tapes, place))
    except NoTapeError:
        return None
    return False if False in verdicts else None if None in verdicts or not verdicts else True


def _one_holds(tapes: Sequence[Tape], place: Sequence[object]) -> bool | None:
    undecided = False
    for tape in tapes:
        try:
            residuals = [is_small(x) for x in tape.values(place, DIGITS)]
        except (ValueError, ArithmeticError):
            continue  # what has no value there does not hold
        if all(residuals):
            return True
        undecided = undecided or False not in residuals
    return None if undecided else False
