"""Positions that a branch of equilibria states, found numerically.

A branch states its positions by relations and by equations that are not solved, f(q) = 0 beside the finite constraints,
where its conditions hold. Parameters are drawn until the conditions on them hold; the coordinates and unknown forces
follow by Newton's method from drawn places, confirmed to 45 digits. So any form of a relation is read as it is printed:
r³ = K/(3 n²), a root, tan α = 3/2 with a triangle that has to close. An undefined function is a drawn polynomial.

At such a position the forces balance if Q is a combination of the rows A of the constraints,

    Q = −Aᵀ λ     if and only if     Q − Σ u (u·Q) = 0 ,     u an orthonormal basis of the rows.

Equilibria that have no closed form, against an answer: points of them in numbers, tried in the answer's equations.

An answer may state such equilibria in a form of its own: tan α = 3/2 with the constraints of a linkage, where the
program has sin α and cos α with two equations left. Neither form can be reduced to the other in letters. So parameters
are drawn, positions are found to 45 digits (`StatedPlaces`), and at each of them one alternative must hold.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import chain, islice
from random import Random
from typing import Any

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.records import all_hold
from lagrange.core.symbols import Decimal, Unspecified
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import (
    BALANCED,
    CONDITION_MARGIN,
    DIFFERS,
    FARTHEST,
    MOST_STATED_DRAWS,
    MOST_STATED_PLACES,
    SEARCHED_OPERATIONS,
    STATED_SAMPLES,
    UNSOLVED_POINTS,
)
from lagrange.mechanics.equilibrium.searched.newton import (
    DIGITS,
    NoTapeError,
    Tape,
    confirmed,
    random_start,
    random_value,
    zero_near,
)

Number = Any


class StatedPlaces:
    """Positions where equations hold and conditions are met, at drawn parameters; the same in every run.

    symbols  of which a position has the values: unknowns, and then all parameters, those of `beside` among them

    Raises NoTapeError if an expression cannot be evaluated.
    """

    def __init__(
        self,
        equations: Sequence[sp.Expr],
        conditions: Sequence[SignCondition],
        unknowns: Sequence[sp.Symbol],
        turning: Collection[sp.Expr],
        beside: Sequence[sp.Expr] = (),
    ) -> None:
        differences = without_functions([c.lhs - c.rhs for c in conditions])
        equations = without_functions(equations)
        occurring = {s for x in (*equations, *differences, *without_functions(beside)) for s in x.free_symbols}
        self.random = Random(3)
        self.turning = turning
        self.unknowns = tuple(unknowns)
        self.parameters = sorted(occurring - {*unknowns}, key=str)
        self.symbols = (*self.unknowns, *self.parameters)
        self.equations = Tape([x for x in equations if x != 0], self.symbols)
        pairs = list(zip(conditions, differences, strict=True))
        before = [(c, x) for c, x in pairs if x.free_symbols.isdisjoint(unknowns)]
        after = [pair for pair in pairs if pair not in before]
        self.before = [c for c, _ in before], Tape([x for _, x in before], self.parameters)
        self.after = [c for c, _ in after], Tape([x for _, x in after], self.symbols)

    def __iter__(self) -> Iterator[list[Number]]:
        for _ in range(MOST_STATED_PLACES):
            numbers = self._numbers() if self.equations.carried_out < SEARCHED_OPERATIONS else None
            if numbers is None:
                return
            place = self._place(numbers)
            if place is not None:
                given = [*place, *map(mpmath.mpf, numbers)]
                if _hold(*self.after, given):
                    yield given

    def _numbers(self) -> list[float] | None:
        """Drawn parameters for which the conditions on them hold."""
        for n in range(MOST_STATED_DRAWS):
            numbers = [random_value(s, 1 + n % 3, self.random) for s in self.parameters]
            if _hold(*self.before, numbers):
                return numbers
        return None

    def _place(self, numbers: Sequence[float]) -> list[Number] | None:
        start = [random_start(u, self.unknowns, self.turning, self.random) for u in self.unknowns]
        guess = zero_near(lambda x: self.equations.values([*x, *numbers]), start, FARTHEST)
        if guess is None:
            return None
        return confirmed(lambda x: self.equations.values([*x, *map(mpmath.mpf, numbers)], DIGITS), guess)


def holds_in_numbers(e: Equilibrium, b: Branch) -> bool | None:
    """Whether the forces balance at positions of a branch that are found numerically; None: none is found."""
    rows = [list(row.coefficients) for row in e.binding]
    size = len(e.work.forces)
    tried = [*e.work.forces, *chain(*rows), *e.laws]
    equations = [*(r.residual for r in b.equations), *e.configuration.finite_constraints]
    unknowns = (*e.configuration.slots.coordinates, *e.forces, *e.multipliers)
    verdicts = []
    try:
        places = StatedPlaces(equations, b.conditions, unknowns, e.solution.letters.angles, tried)
        tape = Tape(without_functions(tried), places.symbols)
        with mpmath.workdps(60):
            for place in islice(places, STATED_SAMPLES):
                values = tape.values(place, DIGITS)
                forces, rest = values[:size], values[size:]
                table = [rest[n : n + size] for n in range(0, size * len(rows), size)]
                laws = rest[size * len(rows) :]
                verdicts.append(all_hold([_are_balanced(table, forces), *(is_small(x) for x in laws)]))
    except (NoTapeError, ValueError, ArithmeticError):
        return None
    return all_hold(verdicts) if verdicts else None


def _are_balanced(rows: Sequence[Sequence[Number]], forces: Sequence[Number]) -> bool | None:
    """Whether Q is a combination of the rows; None where their rank or the rest is too small to be sure."""
    basis: list[list[Number]] = []
    for row in rows:
        size = _length(row)
        rest = _beside([x / size for x in row], basis) if size else list(row)
        small = is_small(_length(rest))
        if small is None:
            return None
        if not small:
            basis.append([x / _length(rest) for x in rest])
    return is_small(_length(_beside(forces, basis)), _length(forces))


def _beside(v: Sequence[Number], basis: Sequence[Sequence[Number]]) -> list[Number]:
    """A vector without its parts along an orthonormal basis."""
    rest = list(v)
    for u in basis:
        part = sum(a * b for a, b in zip(u, rest, strict=True))
        rest = [a - part * b for a, b in zip(rest, u, strict=True)]
    return rest


def _length(v: Sequence[Number]) -> Number:
    return mpmath.sqrt(sum(x * x for x in v))


def is_small(x: Number, scale: Number = 0) -> bool | None:
    """Whether a number is zero to the digits of a confirmed position; None in between."""
    return True if abs(x) < BALANCED * (1 + scale) else False if abs(x) > DIFFERS * (1 + scale) else None


def _hold(conditions: Sequence[SignCondition], differences: Tape, given: Sequence[Number]) -> bool:
    """Whether conditions hold by a margin."""
    try:
        values = differences.values(given, DIGITS)
    except (ValueError, ArithmeticError):
        return False
    return all(
        abs(x) > CONDITION_MARGIN and (c.relation == "≠" or (x > 0) == (c.relation in "≥>"))
        for c, x in zip(conditions, values, strict=True)
    )


def without_functions(expressions: Sequence[sp.Expr]) -> list[sp.Expr]:
    """The expressions with a polynomial for each undefined function, always the same one."""

    def polynomial(f: Unspecified) -> sp.Expr:
        numbers = Random(f.name)
        letters = [sp.Dummy() for _ in f.arguments]
        total = sp.Add(*(sp.Rational(numbers.randint(2, 9), 5) * x for x in letters))
        value = total + total**2 / numbers.randint(5, 9) + sp.Rational(numbers.randint(1, 9), 7)
        for letter, order in zip(letters, f.orders, strict=True):
            value = value.diff(letter, order)
        return value.xreplace(dict(zip(letters, f.arguments, strict=True)))

    for _ in range(3):  # one may be an argument of another
        rule = {f: polynomial(f) for x in expressions for f in x.atoms(Unspecified)}
        expressions = [x.xreplace(rule) for x in expressions] if rule else expressions
    return list(expressions)


# Stated in numbers


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
    return all_hold(verdicts) if verdicts else None


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
