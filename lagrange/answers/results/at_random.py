"""Whether changed equations may hold at an equilibrium, seen at random values of the parameters.

An equilibrium with roots in it, y = b W/√(4 P² − W²), is compared with a changed answer by solving that, which takes
long. What differs from zero at random values of the parameters does not hold, so that most changes are put aside by
numbers, and those that are left are compared exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from random import Random

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.answers.equilibrium_comparison import EquilibriumComparison
from lagrange.answers.limits import RANDOM_DIGITS, RANDOM_ZERO_DIGITS
from lagrange.answers.models.variation import Variation
from lagrange.answers.readings import without_displacements
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium

_SMALL = sp.Float(10) ** -(RANDOM_ZERO_DIGITS // 2)


class AtRandom:
    """The equilibria at random values of the parameters.

    wrong  the equations of each wrong alternative
    """

    def __init__(self, wrong: Sequence[Sequence[sp.Expr]], equilibrium: Equilibrium) -> None:
        self.wrong = wrong
        self.equilibrium = equilibrium
        self.random = Random(1)
        self.values: dict[sp.Symbol, sp.Rational] = {}

    @cached_property
    def comparison(self) -> EquilibriumComparison:
        """The equilibria in closed form."""
        return EquilibriumComparison(self.equilibrium, {}, [[tuple(a)] for a in self.wrong])

    def may_hold(self, variation: Variation) -> bool:
        """Whether all alternatives may hold with another meaning of their letters, each at one of the equilibria."""
        if self.comparison.left or not self.comparison.points:
            return True
        rule, special = dict(variation.rule), dict(variation.values)
        return all(
            any(all(self._may_vanish(e.xreplace(rule), p, special) for e in a) for _, p in self.comparison.points)
            for a in self.wrong
        )

    def _may_vanish(self, e: sp.Expr, point: dict[sp.Symbol, sp.Expr], special: dict[sp.Symbol, sp.Expr]) -> bool:
        configuration = self.equilibrium.configuration
        try:
            stated = without_displacements(configuration.rewritten(e), configuration)
            values = [self.comparison.solution.at(point, part).xreplace(special) for part in stated]
        except (NotAlgebraicError, DivisionByZeroError):
            return True
        for value in values:
            number = value.xreplace({s: self._drawn(s) for s in value.free_symbols}).evalf(RANDOM_DIGITS)
            if number.is_number and number.is_finite and abs(number) > _SMALL:
                return False
        return True

    def _drawn(self, s: sp.Symbol) -> sp.Rational:
        if s not in self.values:
            self.values[s] = sp.Rational(self.random.randint(200, 900), self.random.randint(200, 900))
        return self.values[s]
