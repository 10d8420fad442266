"""Positions that a branch of equilibria states, found in numbers.

A branch states its positions by relations and by equations that are not solved, f(q) = 0 beside the finite constraints,
where its conditions hold. Parameters are drawn until the conditions on them hold; the coordinates and unknown forces
follow by Newton's method from drawn places, confirmed to 45 digits. So any form of a relation is read as it stands:
r³ = K/(3 n²), a root, tan α = 3/2 with a triangle that has to close. An undefined function is a drawn polynomial.

At such a position the forces balance if Q is a combination of the rows A of the constraints,

    Q = −Aᵀ λ     if and only if     Q − Σ u (u·Q) = 0 ,     u an orthonormal basis of the rows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from random import Random
from typing import Any

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.symbols import Unspecified
from lagrange.core.verdicts import all_hold
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import MOST_STATED_DRAWS, SEARCHED_OPERATIONS, STATED_SAMPLES
from lagrange.mechanics.equilibrium.searched.drawing import drawn, drawn_place
from lagrange.mechanics.equilibrium.searched.newton import confirmed, zero_near
from lagrange.mechanics.equilibrium.searched.tape import DIGITS, NoTapeError, Tape

FARTHEST = 60.0
MARGIN, AGREES, DIFFERS = 1e-6, 1e-25, 1e-9
"""A condition holds by a margin; forces balance to so many digits at a confirmed position, or fail by so much."""

Number = Any


class StatedPlaces:
    """The positions of one branch at which some expressions are wanted; the same in every run.

    Raises NoTapeError where an expression cannot be evaluated.
    """

    def __init__(self, e: Equilibrium, b: Branch, wanted: Sequence[sp.Expr]) -> None:
        random = Random(3)
        equations = [r.residual for r in b.equations] + [*e.configuration.finite_constraints]
        conditions = [c.lhs - c.rhs for c in b.conditions]
        sampled = _without_functions([*equations, *conditions, *wanted], random)
        equations, rest = sampled[: len(equations)], sampled[len(equations) :]
        conditions, wanted = rest[: len(conditions)], rest[len(conditions) :]
        self.random = random
        self.angles = e.solution.letters.angles
        self.coordinates = e.configuration.slots.coordinates
        occurring = {s for x in sampled for s in x.free_symbols}
        self.unknowns = (*self.coordinates, *(s for s in (*e.forces, *e.multipliers) if s in occurring))
        self.parameters = sorted(occurring - {*self.unknowns}, key=str)
        symbols = (*self.unknowns, *self.parameters)
        self.equations = Tape([x for x in equations if x != 0], symbols)
        of_parameters = [(c, x) for c, x in zip(b.conditions, conditions, strict=True) if not self._is_open(x)]
        of_all = [(c, x) for c, x in zip(b.conditions, conditions, strict=True) if self._is_open(x)]
        self.before = [c for c, _ in of_parameters], Tape([x for _, x in of_parameters], self.parameters)
        self.after = [c for c, _ in of_all], Tape([x for _, x in of_all], symbols)
        self.wanted = Tape(wanted, symbols)

    def _is_open(self, x: sp.Expr) -> bool:
        return not x.free_symbols.isdisjoint(self.unknowns)

    def values(self, number: int = STATED_SAMPLES) -> Iterator[list[Number]]:
        """What is wanted, at up to so many positions, to sixty digits; raises what a value that is missing raises."""
        found = 0
        for _ in range(MOST_STATED_DRAWS):
            if found == number or self.equations.carried_out > SEARCHED_OPERATIONS:
                return
            numbers = self._numbers()
            if numbers is None:
                return
            place = self._place(numbers)
            if place is None:
                continue
            with mpmath.workdps(60):
                given = [*place, *map(mpmath.mpf, numbers)]
                if _hold(*self.after, given):
                    found += 1
                    yield self.wanted.values(given, DIGITS)

    def _numbers(self) -> list[float] | None:
        """Drawn parameters for which the conditions on them hold."""
        for n in range(MOST_STATED_DRAWS):
            numbers = [drawn(s, 1 + n % 3, self.random) for s in self.parameters]
            if _hold(*self.before, numbers):
                return numbers
        return None

    def _place(self, numbers: Sequence[float]) -> list[Number] | None:
        start = [drawn_place(u, self.coordinates, self.angles, self.random) for u in self.unknowns]
        guess = zero_near(lambda x: self.equations.values([*x, *numbers]), start, FARTHEST)
        if guess is None:
            return None
        return confirmed(lambda x: self.equations.values([*x, *map(mpmath.mpf, numbers)], DIGITS), guess)


def holds_in_numbers(e: Equilibrium, b: Branch) -> bool | None:
    """Whether the forces balance at positions of a branch that are found in numbers; None: none is found."""
    rows = [list(row.coefficients) for row in e.binding]
    size = len(e.work.forces)
    try:
        places = StatedPlaces(e, b, [*e.work.forces, *chain(*rows), *e.laws])
        verdicts = []
        for values in places.values():
            forces, rest = values[:size], values[size:]
            table = [rest[n : n + size] for n in range(0, size * len(rows), size)]
            laws = rest[size * len(rows) :]
            verdicts.append(all_hold([_are_balanced(table, forces), *(_is_small(abs(x), 1) for x in laws)]))
    except (NoTapeError, ValueError, ArithmeticError):
        return None
    return all_hold(verdicts) if verdicts else None


def _are_balanced(rows: Sequence[Sequence[Number]], forces: Sequence[Number]) -> bool | None:
    """Whether Q is a combination of the rows; None where their rank or the rest is too small to be sure."""
    with mpmath.workdps(60):
        basis: list[list[Number]] = []
        for row in rows:
            size = _length(row)
            rest = _beside([x / size for x in row], basis) if size else list(row)
            small = _is_small(_length(rest), 1)
            if small is None:
                return None
            if not small:
                basis.append([x / _length(rest) for x in rest])
        return _is_small(_length(_beside(forces, basis)), _length(forces))


def _beside(v: Sequence[Number], basis: Sequence[Sequence[Number]]) -> list[Number]:
    """A vector without its parts along an orthonormal basis."""
    rest = list(v)
    for u in basis:
        part = sum(a * b for a, b in zip(u, rest, strict=True))
        rest = [a - part * b for a, b in zip(rest, u, strict=True)]
    return rest


def _length(v: Sequence[Number]) -> Number:
    return mpmath.sqrt(sum(x * x for x in v))


def _is_small(x: Number, scale: Number) -> bool | None:
    """Whether a number is zero to the digits of a confirmed position; None in between."""
    return True if x < AGREES * (1 + scale) else False if x > DIFFERS * (1 + scale) else None


def _hold(conditions: Sequence[SignCondition], differences: Tape, given: Sequence[Number]) -> bool:
    """Whether conditions hold by a margin."""
    try:
        values = differences.values(given, DIGITS)
    except (ValueError, ArithmeticError):
        return False
    return all(
        abs(x) > MARGIN and (c.relation == "≠" or (x > 0) == (c.relation in "≥>"))
        for c, x in zip(conditions, values, strict=True)
    )


def _without_functions(expressions: Sequence[sp.Expr], random: Random) -> list[sp.Expr]:
    """The expressions with a polynomial of the second degree for each undefined function, and its derivatives."""
    seed = random.randint(1, 10**6)

    def polynomial(f: Unspecified) -> sp.Expr:
        numbers = Random(f"{f.name} {seed}")
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
