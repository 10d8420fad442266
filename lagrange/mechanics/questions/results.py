"""The answers to questions, as records."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import field, replace
from enum import StrEnum
from typing import TypeVar

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition, sign_of
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import base
from lagrange.mechanics.questions.limits import LONGEST_CONDITION, LONGEST_MULTIPLIED_OUT
from lagrange.problem.model import Condition, Measured, Question


class How(StrEnum):
    """How a question was answered."""

    EXACT = "exact"
    NUMERICAL = "numerical"


class IntegralKind(StrEnum):
    """Where an integral comes from."""

    CONSERVED = "conserved"  # a conserved quantity of the motion
    WORK = "work"  # q'' = f(q) + g(q) q'^2, multiplied by an integrating factor and q', and integrated
    IMPULSE = "impulse"  # q'' = g(q) q', integrated over time
    SPEED = "speed"  # q'' = a(q'): q' dq'/a is dq
    CENTRE = "centre"  # m x' + M X' = 0, integrated over time: the mass centre stays where it is


class Route(StrEnum):
    """What determined the answer."""

    STATE = "state"  # the accelerations and reactions at the state that `when` gives
    INTEGRALS = "integrals"  # first integrals with their values at t = 0
    SOLUTION = "solution"  # the solution of the equations of motion as functions of time
    QUADRATURE = "quadrature"  # t = ∫ dq/q', with q' from the integrals
    ORBIT = "orbit"  # r as a function of the angle, round a centre
    NUMBERS = "numbers"  # numerical integration
    STABILITY = "stability"  # where an equilibrium that exists for every value of a parameter becomes unstable
    IMPACT = "impact"  # the impulses of reactions in an impact
    REST = "rest"  # the balance of forces and the constraints, in a position of equilibrium


class Reason(StrEnum):
    """Why a branch was omitted, or comes first."""

    INITIAL = "initial"  # it is the state at t = 0 itself
    START = "start"  # it does not begin with the initial state
    ARRIVAL = "arrival"  # a coordinate that reaches a value for the first time moves towards it
    TURNING = "turning"  # the motion starts in one direction, and goes on in it up to the first turning point
    SENSE = "sense"  # slip or a velocity would have the sense for which the equations do not hold
    PAST = "past"  # t would be negative
    LATER = "later"  # it comes later
    OPPOSITE = "opposite"  # it is that of the opposite sign, of a quantity that occurs in even powers only


@record
class UsedIntegral:
    """expression = value along the motion, the value from the initial state.

    number      of the conserved quantity, from 0; None if it was found for this question
    coordinate  whose equation of motion was integrated
    factor      the integrating factor
    equation    q'' as a function of q and q'
    """

    kind: IntegralKind
    expression: sp.Expr
    value: sp.Expr
    number: int | None = None
    coordinate: sp.Symbol | None = None
    factor: sp.Expr = sp.S.One
    equation: sp.Expr = sp.S.Zero


@record
class AnswerBranch:
    """lhs = rhs, the quantity or a function of it on the left, under some conditions.

    values      of the quantity at the points of the branch
    states      the coordinates, velocities and t at these points
    conditions  under which it exists
    provided    whether it was not decided that the motion gets there
    limit       whether it is only approached, for t → ∞
    """

    lhs: sp.Expr
    rhs: sp.Expr
    values: tuple[sp.Expr, ...]
    states: tuple[Mapping[sp.Symbol, sp.Expr], ...] = ()
    conditions: tuple[SignCondition, ...] = ()
    provided: bool = False
    limit: bool = False

    @property
    def beyond_square(self) -> tuple[SignCondition, ...]:
        """The conditions, without those that say only that the right side is not negative, if the left is a square."""
        if not isinstance(self.lhs, sp.Pow) or self.lhs.exp != 2 or self.rhs == 0:
            return self.conditions
        return tuple(c for c in self.conditions if not _says_that(c, self.rhs))

    @property
    def of_square(self) -> tuple[SignCondition, ...]:
        """What makes the square on the left not negative, without factors of known sign: cos θ > 0 for g/(l cos θ)."""
        if len(self.beyond_square) == len(self.conditions):
            return ()
        above, below = sp.fraction(sp.factor(sp.together(self.rhs)))
        open_ = {f for f in sp.Mul.make_args(above) if sign_of(f) != 1}
        strict = {f for f in sp.Mul.make_args(below) if sign_of(f) != 1}
        relation = "≥" if open_ else ">"
        return (SignCondition(sp.Mul(*open_, *strict), relation, sp.S.Zero),)

    def where_reached(self) -> AnswerBranch:
        """The branch without the conditions that the motion gets to a place: they say that a root in its value is real,
        or at length that the square of a velocity there is not negative, which is left to the reader.
        """
        under = [e.base for e in self.rhs.atoms(sp.Pow) if e.exp == sp.S.Half]
        kept = [c for c in self.conditions if not any(_says_that(c, u) for u in under)]
        squares = {v**2 for s in self.states for q, v in s.items() if base(q) != q and v != 0}
        long = [c for c in kept if count_operations(c.lhs - c.rhs) > LONGEST_CONDITION]
        left_open = {c for c in long if any(_says_that(c, s) for s in squares)}
        conditions = tuple(c for c in kept if c not in left_open)
        return replace(self, conditions=conditions, provided=self.provided or bool(left_open))

    def at(self, states: Sequence[Mapping[sp.Symbol, sp.Expr]]) -> AnswerBranch:
        """The part of the branch with some of its states, and with the values that the quantity has in these."""
        if len(states) == len(self.states):
            return self
        left = self.values
        if all(any(v in s.values() for v in left) for s in states):
            left = tuple(v for v in left if any(v in s.values() for s in states))
        elif len(left) == len(self.states):
            left = tuple(v for v, s in zip(left, self.states, strict=True) if any(s is kept for kept in states))
        rhs = left[0] if self.rhs in self.values and len(left) == 1 else self.rhs
        return replace(self, rhs=rhs, values=left, states=tuple(states))

    def excluded_by(self, values: Mapping[sp.Symbol, sp.Expr]) -> bool:
        """Whether values of the parameters violate one of the conditions."""
        pairs = [((c.lhs - c.rhs).xreplace(dict(values)), c.relation) for c in self.conditions]
        signs = [(sign_of(e), relation) for e, relation in pairs if e.is_number]
        excluded = {">": (-1, 0), "≥": (-1,), "<": (1, 0), "≤": (1,), "≠": (0,), "=": (1, -1)}
        return any(s in excluded[r] for s, r in signs)


def _says_that(c: SignCondition, expression: sp.Expr) -> bool:
    """Whether a condition says only that an expression is not negative."""
    return c.relation in "≥>" and bool(sp.factor((c.lhs - c.rhs) / expression).is_nonnegative)


_Value = TypeVar("_Value", sp.Expr, float)


def one_value(values: Sequence[_Value]) -> _Value | None:
    """The value that is meant by several: of a value and its opposite it is the positive one. None: they differ."""
    distinct, sizes = {*values}, {abs(v) for v in values}
    return distinct.pop() if len(distinct) == 1 else sizes.pop() if len(sizes) == 1 else None


@record
class Substituted:
    """A quantity of a question in terms of positions and velocities: N = m g cos θ − m R θ'².

    measured     an initial value that the file gives as a number with a unit
    hides_units  whether a term of it had one
    """

    symbol: sp.Expr
    value: sp.Expr
    measured: Measured | None = None
    hides_units: bool = False


@record
class InverseRadius:
    """1/r as a function of the angle φ, which satisfies d²(1/r)/dφ² = α − k/r."""

    radius: sp.Symbol
    angle: sp.Symbol
    constant: sp.Expr
    stiffness: sp.Expr
    value: sp.Expr


@record
class Asked:
    """The answer to a question.

    initial     the state at t = 0 as the file gives it
    senses      velocities whose modulus was taken with the sign that they have at first
    choice      the coordinates in which it was answered; empty for the file's own
    integrals   those that were used
    used        reactions and accelerations in the question, in terms of positions and velocities
    conditions  the equations of `when` after that
    quantity    the same for the quantity
    branches    all that it may be; empty if it was not found
    dropped     branches that are not meant, with the reason
    mirrored    whether the branches differ in the sense of the motion alone, and the initial state leaves that open,
                or none is given
    solutions   coordinates as functions of time
    missing     initial values that are not given and would be needed
    orbit       1/r as a function of the angle
    integrand   q, q' as a function of it, q_0 and q_1, where the time is an integral over q
    integral    the time as this integral, where it is no elementary function and letters are left
    open        coordinates and velocities on which the quantity depends, and which nothing determines
    turning     where the motion has come to rest before, from where it goes back with the other sense of friction
    opposite    a force that is counted in the sense opposite to that of its constraint
    needs       an extra of the package that is missing for a numerical answer
    verified    whether it satisfies all equations, exactly; None: undecided
    related     parameters that conditions give in terms of others, put into the answer
    """

    question: Question
    choice: str
    how: How | None
    route: Route
    integrals: tuple[UsedIntegral, ...] = ()
    used: tuple[Substituted, ...] = ()
    conditions: tuple[tuple[sp.Expr, sp.Expr], ...] = ()
    quantity: sp.Expr = sp.S.Zero
    branches: tuple[AnswerBranch, ...] = ()
    dropped: tuple[tuple[AnswerBranch, Reason], ...] = ()
    mirrored: bool = False
    solutions: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    orbit: InverseRadius | None = None
    missing: tuple[sp.Symbol, ...] = ()
    integrand: tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr] | None = None
    integral: sp.Integral | None = None
    open: tuple[sp.Symbol, ...] = ()
    initial: tuple[Substituted, ...] = ()
    senses: Mapping[sp.Expr, int] = field(default_factory=dict)
    turning: Substituted | None = None
    opposite: sp.Symbol | None = None
    needs: str = ""
    verified: bool | None = True
    related: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    @property
    def answered(self) -> bool:
        """Whether there is an answer in closed form or in numbers."""
        return bool(self.branches)

    @property
    def divided_by(self) -> tuple[SignCondition, ...]:
        """sin θ ≠ 0 for a factor of the one condition on the quantity: where it vanishes, any φ'² will do."""
        symbols = self.quantity.free_symbols - {self.question.by}
        equations = [a - b for a, b in self.conditions if (a - b).free_symbols & symbols]
        if self.route is not Route.STATE or self.question.by is None or len(equations) != 1:
            return ()
        if count_operations(equations[0]) > LONGEST_MULTIPLIED_OUT:
            return ()  # factoring it takes longer than all the rest of the page
        factors = sp.Mul.make_args(sp.factor(sp.fraction(sp.together(equations[0]))[0]))
        bases = (f.as_base_exp()[0] for f in factors if not f.free_symbols & symbols)
        open_ = (f for f in bases if self.question.by in f.free_symbols and sign_of(f) is None)
        return tuple(SignCondition(f, "≠", sp.S.Zero) for f in open_)

    @property
    def least(self) -> tuple[sp.Expr, str, sp.Expr] | None:
        """cos θ, > and k for the value k/cos θ that holds for sin θ ≠ 0: it is more than k. None for other forms."""
        if self.question.by is None or self.route is not Route.STATE or len(self.branches) != 1:
            return None
        [b] = self.branches
        varying = [f.as_base_exp() for f in sp.Mul.make_args(b.rhs) if self.question.by in f.free_symbols]
        if len(varying) != 1 or not isinstance(varying[0][0], sp.cos | sp.sin):
            return None
        [(wave, power)] = varying
        other = (sp.sin if isinstance(wave, sp.cos) else sp.cos)(*wave.args)
        k = b.rhs / wave**power
        if wave.args != (self.question.by,) or not power.is_negative or sign_of(k) != 1:
            return None
        return wave, ">" if other in (c.lhs for c in self.divided_by) else "≥", k

    @property
    def is_open(self) -> bool:
        """Whether there is no answer, not even as an integral."""
        return not self.branches and self.integral is None

    def excluded_by(self, values: Mapping[sp.Symbol, sp.Expr], moving: Collection[sp.Symbol]) -> bool:
        """Whether the motion never gets there with these values; a parameter that is asked for may have any value."""
        of_motion = any(base(s) in moving for s in self.question.quantity.free_symbols)
        return bool(self.branches) and of_motion and all(b.excluded_by(values) for b in self.branches)

    def within(self, values: Mapping[sp.Symbol, sp.Expr], moving: Collection[sp.Symbol]) -> Asked:
        """The answer without the branches that values exclude: weak damping alone where 4 m k > c²."""
        of_motion = any(base(s) in moving for s in self.question.quantity.free_symbols)
        kept = tuple(b for b in self.branches if not b.excluded_by(values)) if of_motion else ()
        return replace(self, branches=kept) if kept and len(kept) < len(self.branches) else self

    @property
    def has_bare_numbers(self) -> bool:
        """Whether a condition or an initial value is a number that may hide a unit, `t = 2`."""
        stated: list[Condition | Substituted] = [*self.question.when, *self.initial]
        measured = [s.measured for s in stated if s.measured]
        sides = [*(e for c in self.question.when for e in (c.lhs, c.rhs)), *(s.value for s in self.initial)]
        has_unit = any(any(m.dimension) for m in measured) or any(s.hides_units for s in stated)  # 300 rpm is 10π
        return has_unit or any(e.is_number and e != 0 and not (e / sp.pi).is_Rational for e in sides)
