"""What is wrong with an equation: the one change that makes it right.

The equation is a sum of terms t_1 + t_2 + ...; at a random state each is a row [A | b], affine in the unknowns, and
what is left of it when the derived equations are taken off, modulo their row space, is its residue r_i (`benches`). The
equation follows just when Σ r_i = 0. So

    a term has a wrong factor f       where  Σ r_j = (1 − f) r_i ,   f = −1 a wrong sign, f = 0 a term too many;
    a term c T is missing             where  Σ r_j = −c r_T ,        T a term of the derived equations;
    a term should be another, t_i'    where  Σ r_j = r_i − r_i' .

f and c are numbers at one state; they are sought among simple factors, and what is found is tried at a second state
that shares nothing with the first, by exact arithmetic (at several where there are branches). Where no single change is
enough, the group of terms that differs is named, if it is one: those with accelerations, those with velocities, the
others.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from enum import Enum
from functools import cached_property
from typing import Any

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, InadmissibleError, NoPointError, UnsupportedError
from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.prime_field import reconstructed
from lagrange.answers.benches import Bench, benches, equations_of, follows
from lagrange.answers.edits import NUMBERS, Slip, cleared, factors, terms_of, variants
from lagrange.core.records import record
from lagrange.core.symbols import base, t
from lagrange.mechanics.dynamics.comparison import System, affine_rows


class Group(Enum):
    """What kind of term it is."""

    INERTIA = "inertia"  # an acceleration occurs
    VELOCITY = "velocity"
    FORCE = "force"


@record
class Diagnosis:
    """The one change that makes an equation right; without a slip only the group of terms that differs.

    term     as the answer has it; None where it is missing
    right    what it should be; None where there should be nothing
    factor   right / term, where it is a wrong factor
    times    what the equation was multiplied by, so that it has these terms
    """

    group: Group | None
    slip: Slip | None = None
    term: sp.Expr | None = None
    right: sp.Expr | None = None
    factor: sp.Expr | None = None
    times: sp.Expr = sp.S.One


def diagnosed(equation: sp.Expr, system: System) -> Diagnosis | None:
    """What is wrong with an equation, linear in the accelerations, that does not follow; None: not found."""
    try:
        for form, times in _forms(equation):
            found = _Search(form, system).change()
            if found is not None:
                return _named(found, times, system)
        group = _Search(equation, system).group()
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError):
        return None
    return None if group is None else Diagnosis(group)


def in_letters(found: Diagnosis, equation: sp.Expr, values: Mapping[sp.Symbol, sp.Rational]) -> Diagnosis:
    """The same change of an equation in which parameters are letters; as it is, where no one term becomes that term.

    values  the numbers that were put in before it was diagnosed
    """
    if found.term is None or found.times != 1:
        return found
    numbers = dict(values)
    same = [term for term in terms_of(equation) or () if terms_of(term.xreplace(numbers)) == (found.term,)]
    share = same[0] / found.term if len(same) == 1 else sp.S.Zero
    alone = found.slip is Slip.NUMBER and abs(share.as_coeff_Mul()[0] * found.term.as_coeff_Mul()[0]) == 1
    if share == 0 or alone or not share.free_symbols <= set(numbers):
        return found
    return replace(found, term=same[0], right=None if found.right is None else found.right * share)


def group_of(term: sp.Expr, system: System) -> Group:
    """The kind of a term."""
    slots = system.configuration.slots
    if term.free_symbols & {*slots.accelerations}:
        return Group.INERTIA
    moving = {*slots.velocities, *(s for s in term.free_symbols if base(s) in slots.prescribed and base(s) != s)}
    return Group.VELOCITY if term.free_symbols & moving else Group.FORCE


def _forms(equation: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The equation as it is, and without denominators that are sums."""
    yield equation, sp.S.One
    without = cleared(equation)
    if without is not None:
        yield without


def _named(found: Diagnosis, times: sp.Expr, system: System) -> Diagnosis:
    """With the group of the term."""
    term = found.term if found.term is not None else found.right
    assert term is not None
    return Diagnosis(group_of(term, system), found.slip, found.term, found.right, found.factor, times)


class _Search:
    """One equation against one system."""

    def __init__(self, equation: sp.Expr, system: System) -> None:
        self.equation = equation
        self.system = system
        self.slots = system.configuration.slots
        self.terms = terms_of(equation) or ()
        used = set().union(*(e.free_symbols for e in (equation, *system.equations)))
        moving = {*self.slots.coordinates, *self.slots.prescribed, t}
        unknowns = {*system.multipliers}
        self.parameters = sorted((s for s in used if base(s) not in moving and s not in unknowns), key=str)
        waves = set().union(*(e.atoms(sp.sin, sp.cos, sp.tan) for e in (equation, *system.equations)))
        self.angles = sorted({_positive(w.args[0]) for w in waves}, key=lambda a: (a.count_ops(), str(a)))
        self.benches = sorted(benches((equation,), system), key=lambda bench: follows(equation, [bench]))

    def change(self) -> Diagnosis | None:
        """The likeliest change that makes the equation right."""
        bench = self.benches[0]
        residues = [bench.residue(term) for term in self.terms]
        rows = [r for r in residues if r is not None]
        if not rows or len(rows) < len(residues):
            return None
        reduce = bench.moving.arithmetic.reduce
        total = [reduce(sum(column)) for column in zip(*rows, strict=True)]
        if bench.vanishes(total):
            return None
        for candidates in (self._by_number, self._by_another, self._by_missing):
            found = sorted(candidates(rows, total), key=lambda pair: pair[0])
            for _, diagnosis in found:
                if self._holds(diagnosis):
                    return diagnosis
        return None

    def group(self) -> Group | None:
        """The group of terms that differs, if it is one, at all states."""
        if self.system.multipliers or self.system.configuration.rows:
            return None
        found = [self._differences(bench) for bench in self.benches]
        known = [f for f in found if f is not None]
        if len(known) < len(found):
            return Group.INERTIA
        at_rest, moving = (any(side) for side in zip(*known, strict=True))
        if at_rest and moving:
            return None
        return Group.FORCE if at_rest else Group.VELOCITY if moving else None

    def _differences(self, bench: Bench) -> tuple[bool, bool] | None:
        """Whether the terms without velocities differ at a state, and whether those with; None: the accelerations."""
        rows = affine_rows(bench.moving, (self.equation, *equations_of(self.system)), bench.unknowns)
        c = bench.moving.solution(
            [list(column) for column in zip(*(r[:-1] for r in rows[1:]), strict=True)], rows[0][:-1]
        )
        if c is None:
            return None
        still = bench.moving.with_values(dict.fromkeys(self.slots.velocities, bench.moving.number(0)))
        rest = affine_rows(still, (self.equation, *equations_of(self.system)), bench.unknowns)
        reduce, vanishes = bench.moving.arithmetic.reduce, bench.moving.arithmetic.vanishes
        at_rest = reduce(rest[0][-1] - sum(x * row[-1] for x, row in zip(c, rest[1:], strict=True)))
        moving = reduce(rows[0][-1] - sum(x * row[-1] for x, row in zip(c, rows[1:], strict=True)))
        return not vanishes(at_rest), not vanishes(reduce(moving - at_rest))

    # Candidates: (cost, diagnosis), found at the first state

    def _by_number(self, residues: Sequence[list[Any]], total: list[Any]) -> Iterator[tuple[float, Diagnosis]]:
        """A wrong sign, or a wrong number in front of a term."""
        for term, residue in zip(self.terms, residues, strict=True):
            wanted = self._wanted(residue, total)
            number = None if wanted is None else self._as_number(wanted)
            if number is None or number == 0:
                continue
            odd = number not in _USUAL and not _is_decimal(term)
            cost = 0.0 if number == -1 else 1.0 + 2.0 * odd - 0.5 * _is_decimal(term)
            # where a number stands already, it is the wrong one
            cost += 0.2 * (term.as_coeff_Mul()[0] in (1, -1)) + 0.1 * bool(self._is_inertia(term))
            yield (
                cost,
                Diagnosis(None, _kind_of_factor(term, number, self.slots.velocities), term, number * term, number),
            )

    def _by_another(self, residues: Sequence[list[Any]], total: list[Any]) -> Iterator[tuple[float, Diagnosis]]:
        """A term that should be another, or has a factor too many or too few."""
        bench = self.benches[0]
        reduce = bench.moving.arithmetic.reduce
        for term, residue in zip(self.terms, residues, strict=True):
            for n, (slip, variant) in enumerate(variants(term, self.slots, self.parameters, self.angles)):
                found = bench.residue(variant)
                if found is None:
                    continue
                left = [reduce(a - b + c) for a, b, c in zip(total, residue, found, strict=True)]
                if bench.vanishes(left):
                    yield _COSTS[slip] + 0.001 * n, Diagnosis(None, slip, term, variant)
            wanted = self._wanted(residue, total)
            if wanted is None or bench.moving.arithmetic.vanishes(wanted):
                continue
            for cost, factor in self._factors_of(wanted, term):
                slip = _kind_of_factor(term, factor, self.slots.velocities)
                cost += 1.5 * self._is_inertia(term) - 0.5 * (slip in (Slip.INVERTED, Slip.NUMBER))
                yield cost, Diagnosis(None, slip, term, factor * term, factor)

    def _wanted(self, residue: list[Any], total: list[Any]) -> Any | None:
        """The factor that a term should have; None where no factor makes the equation right."""
        ratio = self.benches[0].ratio(total, residue)
        return None if ratio is None else self.benches[0].moving.arithmetic.reduce(1 - ratio)

    def _is_inertia(self, term: sp.Expr) -> bool:
        return not term.free_symbols.isdisjoint(self.slots.accelerations)

    def _by_missing(self, residues: Sequence[list[Any]], total: list[Any]) -> Iterator[tuple[float, Diagnosis]]:
        """A term of the derived equations that is missing; a term too many."""
        bench = self.benches[0]
        for term, mine in zip(self.terms, residues, strict=True):
            wanted = self._wanted(mine, total)
            if wanted is not None and bench.moving.arithmetic.vanishes(wanted) and len(self.terms) > 1:
                yield 4.6, Diagnosis(None, Slip.EXTRA, term)
        reduce = bench.moving.arithmetic.reduce
        for term in self._vocabulary:
            residue = bench.residue(term)
            ratio = None if residue is None else bench.ratio(total, residue)
            if ratio is None:
                continue
            for cost, factor in self._scales_of(reduce(-ratio), term):
                yield 4.0 + cost, Diagnosis(None, Slip.MISSING, None, factor * term)

    def _holds(self, diagnosis: Diagnosis) -> bool:
        """Whether the change makes the equation right at the other states too, and leaves an equation of motion."""
        changed = self.equation - (diagnosis.term or 0) + (diagnosis.right or 0)
        if not sp.expand(changed).free_symbols & {*self.slots.accelerations}:
            return False
        for bench in self.benches:
            parts = [*(x for x in self.terms if x != diagnosis.term), diagnosis.right]
            residues = [bench.residue(x) for x in parts if x is not None]
            if not residues or any(r is None for r in residues):
                return False
            sums = [bench.moving.arithmetic.reduce(sum(c)) for c in zip(*residues, strict=True)]
            if not bench.vanishes(sums):
                return False
        return True

    # Factors

    def _factors_of(self, wanted: Any, term: sp.Expr) -> Iterator[tuple[float, sp.Expr]]:
        """The simple factors that have a value at the first state, with their costs."""
        bench = self.benches[0]
        number = self._as_number(wanted)
        if number is not None:
            yield 1.0, number
            return
        arithmetic = bench.moving.arithmetic
        for n, factor in enumerate(self._simple_factors):
            value = self._values[n]
            if value is None or factor.is_number:
                continue
            left = arithmetic.reduce(wanted * value[1])
            number = self._as_number(left)
            if number is not None and (number in _USUAL or _is_decimal(term)):
                yield 2.0 + 0.02 * n / len(self._simple_factors) + (0.0 if number == 1 else 1.0), number * factor

    def _scales_of(self, wanted: Any, term: sp.Expr) -> Iterator[tuple[float, sp.Expr]]:
        """What a missing term is multiplied by: as the terms of the equation are multiples of the derived ones."""
        bench = self.benches[0]
        for factor, value in self._scales:
            if bench.moving.arithmetic.vanishes(bench.moving.arithmetic.reduce(value - wanted)):
                yield 0.0, factor
                return
        found = sorted(self._factors_of(wanted, term), key=lambda pair: pair[0])
        for cost, factor in found[:1]:
            yield 1.5 + cost, factor

    def _as_number(self, value: Any) -> sp.Rational | None:
        """The small fraction that a value is."""
        point = self.benches[0].moving
        if isinstance(point, FieldPoint):
            found = reconstructed(value, point.p, _LARGEST)
            return None if found is None else sp.Rational(found.numerator, found.denominator)
        return next(
            (n for n in (sp.S.One, *NUMBERS) if point.arithmetic.vanishes(value - point.number(n.p, n.q))), None
        )

    @cached_property
    def _simple_factors(self) -> list[sp.Expr]:
        return factors(self.parameters, self.slots, self.angles)

    @cached_property
    def _values(self) -> list[tuple[Any, Any] | None]:
        """Each factor's value at the first state, and its inverse."""
        bench = self.benches[0]
        arithmetic = bench.moving.arithmetic
        found: list[tuple[Any, Any] | None] = []
        for factor in self._simple_factors:
            value = bench.value(factor)
            usable = value is not None and not arithmetic.vanishes(value)
            found.append((value, arithmetic.inverse(value)) if usable else None)
        return found

    @cached_property
    def _scales(self) -> list[tuple[sp.Expr, Any]]:
        """t/T for the terms of the equation and of the derived ones, where that is simple."""
        bench = self.benches[0]
        moving = {*self.slots.coordinates, *self.slots.velocities, *self.slots.accelerations}
        found: dict[sp.Expr, Any] = {}
        for mine in self.terms:
            for theirs in self._vocabulary:
                scale = mine / theirs
                # of what moves only a factor of the whole equation is taken in: that of terms with accelerations
                moves = bool(scale.free_symbols & moving) and not self._is_inertia(theirs)
                if (
                    scale in found
                    or moves
                    or scale.free_symbols & {*self.slots.accelerations}
                    or scale.count_ops() > 12
                ):
                    continue
                value = bench.value(scale)
                if value is not None:
                    found[scale] = value
        return list(found.items())

    @cached_property
    def _vocabulary(self) -> list[sp.Expr]:
        """The terms of the derived equations."""
        found: dict[sp.Expr, None] = {}
        for e in self.system.equations:
            found |= dict.fromkeys(x for x in terms_of(e) or ())
        return list(found)


_LARGEST = 2000
_USUAL = frozenset((sp.S.One, *NUMBERS))
_COSTS = {
    Slip.FUNCTION: 1.2,
    Slip.SMALL_ANGLE: 1.4,
    Slip.EXACT_ANGLE: 2.6,
    Slip.ANGLE: 1.6,
    Slip.DOT: 2.0,
    Slip.COORDINATE: 1.8,
    Slip.PARAMETER: 1.9,
}


def _is_decimal(term: sp.Expr) -> bool:
    """Whether a number in it looks measured: 9.81, 0.33, 10."""
    number = term.as_coeff_Mul()[0]
    return bool(number.is_Rational) and (number.q >= 10 or abs(number.p) >= 10)


def _kind_of_factor(term: sp.Expr, factor: sp.Expr, velocities: Sequence[sp.Symbol]) -> Slip:
    """What a wrong factor is called."""
    if factor == -1:
        return Slip.SIGN
    number, rest = factor.as_coeff_Mul()
    if _is_decimal(term) and (rest != 1 or abs(abs(factor) - 1) < sp.Rational(1, 20)):
        return Slip.NUMBER
    root = sp.sqrt(rest)
    if number == 1 and (term * root).count_ops() < term.count_ops() and _is_quotient(root):
        return Slip.INVERTED
    return Slip.POWER if rest.free_symbols & {*velocities} else Slip.FACTOR


def _positive(angle: sp.Expr) -> sp.Expr:
    return -angle if angle.could_extract_minus_sign() else angle


def _is_quotient(factor: sp.Expr) -> bool:
    return isinstance(factor, sp.Mul) and len(factor.args) == 2 and any(f.as_base_exp()[1] == -1 for f in factor.args)
