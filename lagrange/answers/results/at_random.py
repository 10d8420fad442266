"""Whether changed equations may hold at an equilibrium, seen at random values of the parameters.

An equilibrium with roots in it, y = b W/√(4 P² − W²), is compared with a changed answer by solving that, which takes
long. What differs from zero at random values of the parameters does not hold, so that most changes are excluded
numerically, and those that remain are compared exactly.

Values of expressions in ordinary floating point: to tell soon that two of them differ.

Nothing is decided by them alone: what seems to agree is decided exactly.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import cached_property
from random import Random
from typing import Any

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.equilibrium_comparison import EquilibriumComparison
from lagrange.answers.limits import (
    BESIDE_LIMIT,
    BESIDE_ROUNDED_LIMIT,
    RANDOM_DIGITS,
    RANDOM_ZERO_DIGITS,
    SAMPLES_OF_A_SIDE,
    SECANT_STEPS,
)
from lagrange.answers.models.mechanics import Variation
from lagrange.answers.readings import Reading, without_displacements
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.core.floats import FUNCTIONS
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
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


# Approximate


def approximate(e: sp.Expr, point: Mapping[sp.Symbol, float]) -> float:
    """The value of an expression; nan if it has none there, or has a function that is not known here."""
    try:
        return _value(e, point)
    except (ArithmeticError, ValueError, KeyError, TypeError):
        return math.nan


def _value(e: sp.Expr, point: Mapping[sp.Symbol, float]) -> float:
    if e.is_Symbol:
        return point[e]
    if e.is_Number or not e.args:
        return float(e)
    values = [_value(a, point) for a in e.args]
    if e.is_Add:
        return math.fsum(values)
    if e.is_Mul:
        return math.prod(values)
    if e.is_Pow:
        result = values[0] ** values[1]
        return result if isinstance(result, float | int) else math.nan
    return FUNCTIONS[type(e)](*values)


def root_near(function: Callable[[float], float], start: float) -> float | None:
    """A zero of a function, by the secant rule; None if none is found."""
    a, b = start, start + 0.1
    fa, fb = function(a), function(b)
    for _ in range(SECANT_STEPS):
        if fb == fa or not math.isfinite(fb):
            return None
        a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
        fb = function(b)
        if abs(b - a) <= 1e-13 * (1 + abs(b)):
            return b
    return None


def beside_limit(
    condition: sp.Expr, state: Mapping[sp.Symbol, sp.Expr], fixed: Collection[sp.Symbol] = ()
) -> Iterator[dict[sp.Symbol, sp.Expr]]:
    """The state, moved to both sides of the limit of a condition: in each of its parameters that is not fixed.

    A limit that is wrong by more than the distance is found out at any such state, whatever the others are; at states
    drawn without regard to the limit, one that is wrong by 10 % seems right in a third of the runs. Limits that are
    given as decimals may be rounded to two digits.
    """
    decimal = any(not n.is_Integer and (not n.is_Rational or n.q >= 10) for n in condition.atoms(sp.Number))
    distance = BESIDE_ROUNDED_LIMIT if decimal else BESIDE_LIMIT
    numbers = {s: float(v) for s, v in state.items() if v.is_number}
    for s in sorted((condition.free_symbols & state.keys()) - {*fixed}, key=str):
        root = root_near(lambda v, s=s: approximate(condition, {**numbers, s: v}), numbers[s])  # type: ignore[misc]
        if root is not None and root > 0:
            yield from ({**state, s: sp.Float(root * (1 + side * distance))} for side in (1, -1))
