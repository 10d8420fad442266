"""Whether changed equations may hold at an equilibrium, seen at random values of the parameters.

An equilibrium with roots in it, y = b W/√(4 P² − W²), is compared with a changed answer by solving that, which takes
long. What differs from zero at random values of the parameters does not hold, so that most changes are excluded
numerically, and those that remain are compared exactly.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from random import Random
from typing import Any

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.equilibrium_comparison import EquilibriumComparison
from lagrange.answers.limits import RANDOM_DIGITS, RANDOM_ZERO_DIGITS, SAMPLES_OF_A_SIDE
from lagrange.answers.models.variation import Variation
from lagrange.answers.readings import Reading, without_displacements
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.document.math_writer import text
from lagrange.document.notation import Notation
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

    def _may_vanish(self, e: sp.Expr, point: Mapping[Any, Any], special: dict[sp.Symbol, sp.Expr]) -> bool:
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


def with_sign_of_root(verdict: AnswerVerdict, reading: Reading, equilibria: Sequence[Equilibrium]) -> AnswerVerdict:
    """The verdict on one wrong equation, which may be right where it is positive."""
    if len(reading.components) != 1:
        return verdict
    remark = next(filter(None, (_right_on_one_side(reading.components[0], e) for e in equilibria)), "")
    if not remark:
        return verdict
    right = EquationVerdict(reading.text, Verdict.EQUIVALENT, remarks=(remark,))
    return AnswerVerdict(Verdict.EQUIVALENT, (right,))


def _right_on_one_side(stated: sp.Expr, equilibrium: Equilibrium) -> str:
    """Where a stated force w is right whose square is that of the derived √u, in a remark; empty if nowhere.

    S = W sin(π/4 − φ/2) is √(W² (1 − sin φ)/2) where it is positive. A force that is −√u everywhere is wrong.
    """
    forces = [f for f in equilibrium.forces if f in stated.free_symbols]
    comparison = EquilibriumComparison(equilibrium, {}, [[(stated,)]])
    if len(forces) != 1 or len(comparison.points) != 1 or comparison.left:
        return ""
    [force] = forces
    slope = stated.diff(force)
    if force in slope.free_symbols or slope == 0:
        return ""
    claim = -stated.xreplace({force: sp.S.Zero}) / slope
    [(_, point)] = comparison.points
    try:
        value = comparison.solution.at(point, force)
        under_roots = [p for p in value.atoms(sp.Pow) if abs(p.exp) == sp.S.Half and p.base.has(sp.sin, sp.cos)]
        if not under_roots or is_zero(sp.expand(value**2) - claim**2) is not True:
            return ""
    except (NotAlgebraicError, DivisionByZeroError, NoPointError, UnsupportedError):
        return ""
    random = Random(1)
    for _ in range(SAMPLES_OF_A_SIDE):
        state = {s: sp.Rational(random.randint(1, 1500), 1000) for s in sorted((value - claim).free_symbols, key=str)}
        if bool(abs((value - claim).xreplace(state).evalf(RANDOM_DIGITS)) < _SMALL):
            return f"right where {text(claim, Notation())} > 0, which is taken to be meant"
    return ""
