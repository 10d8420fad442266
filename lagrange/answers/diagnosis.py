"""Diagnosis of a wrong equation: the one change that makes it right.

The equation is a sum of terms t_1 + t_2 + ...; at a random state each is a row [A | b], affine in the unknowns. The
residue r_i of a term is its row reduced modulo the row space of the derived equations (`ResidueState`). Residues are
linear, and the equation follows if and only if Σ r_i = 0. So

    a term has a wrong factor f       if  Σ r_j = (1 − f) r_i ,   f = −1 a wrong sign, f = 0 a term too many;
    a term c T is missing             if  Σ r_j = −c r_T ,        T a term of the derived equations;
    a term should be another, t_i'    if  Σ r_j = r_i − r_i' ,

and the sum for a changed equation costs next to nothing. f and c are numbers at one state; they are sought among simple
factors, and each candidate is tested at a second state that shares no random number with the first, by exact
arithmetic. Roots and absolute values are on a random branch at each state: then more states are taken, real ones among
them, so X
If no single change is enough, the equation is compared with c E for each derived equation E and simple factors c. If
it differs least for one of them, and there in one group of terms only, that group is named: the terms with
accelerations, those with velocities, the others.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import replace
from enum import Enum
from functools import cached_property
from itertools import product
from typing import Any

import sympy as sp

from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.prime_field import reconstructed
from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    InadmissibleError,
    NoPointError,
    UnsupportedError,
)
from lagrange.answers.limits import MAX_BESIDE, MAX_NUMERATOR, MAX_SCALE_OPERATIONS
from lagrange.answers.models.residues import Residues, ResidueState, follows
from lagrange.answers.slips import (
    NUMBERS,
    Slip,
    cleared,
    factors,
    is_decimal,
    is_divided,
    kind_of_factor,
    lengths_in,
    terms_of,
    variants,
)
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import base, t
from lagrange.mechanics.dynamics.comparison import System, affine_rows


class Group(Enum):
    """The kind of a term."""

    INERTIA = "inertia"  # an acceleration occurs
    VELOCITY = "velocity"
    FORCE = "force"
    MOTION = "motion"  # an acceleration or a velocity: what the kinetic energy contributes


@record
class Diagnosis:
    """The one change that makes an equation right; without a slip, only the group of terms that differs.

    absent  whether the equation has no terms of this group at all
    alone   whether it has no terms of other groups
    term    the term in the answer; None if it is missing
    right   what it should be; None if there should be no such term
    factor  right / term, for a wrong factor
    times   the factor by which the equation was multiplied first, so that it has these terms
    """

    group: Group | None
    slip: Slip | None = None
    term: sp.Expr | None = None
    right: sp.Expr | None = None
    factor: sp.Expr | None = None
    times: sp.Expr = sp.S.One
    absent: bool = False
    alone: bool = False


def diagnosed(
    equation: sp.Expr, system: System, *, beside: bool = False, residues: Residues | None = None
) -> Diagnosis | None:
    """The diagnosis of an equation, linear in the accelerations, that does not follow; None: not found.

    beside    whether a model explains the equation already: then only short searches are made
    residues  the states of the system, kept from one answer to the next
    """
    residues = residues or Residues(system)
    try:
        if beside:
            search = _Search(equation, residues)
            if len(search.terms) * len(search.parameters) ** 2 > MAX_BESIDE:
                return None
            change = search.change(direct=True)
            if change is None or (change.factor is not None and search.is_all_inertia(change)):
                return None  # a factor of an acceleration stands for one of all other terms, which the cause has named
            return _with_group(change, sp.S.One, system)
        for form, times in _forms(equation):
            diagnosis = _Search(form, residues).change()
            if diagnosis is not None:
                return _with_group(diagnosis, times, system)
        search = _Search(equation, residues)
        group = search.group()
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError):
        return None
    if group is None:
        return None
    present = {group_of(term, system) for term in search.terms}
    return Diagnosis(group, absent=group is not Group.MOTION and group not in present, alone=present <= {group})


def in_symbols(diagnosis: Diagnosis, equation: sp.Expr, values: Mapping[sp.Symbol, sp.Rational]) -> Diagnosis:
    """The same change, of the equation with symbols for parameters; unchanged if no one term becomes the changed one.

    values  the numbers that were substituted before the diagnosis
    """
    if diagnosis.term is None or diagnosis.times != 1:
        return diagnosis
    numbers = dict(values)
    same = [term for term in terms_of(equation) or () if terms_of(term.xreplace(numbers)) == (diagnosis.term,)]
    share = same[0] / diagnosis.term if len(same) == 1 else sp.S.Zero
    # A wrong number that came from a parameter's value alone is no number of the answer.
    alone = diagnosis.slip is Slip.NUMBER and abs(share.as_coeff_Mul()[0] * diagnosis.term.as_coeff_Mul()[0]) == 1
    if share == 0 or alone or not share.free_symbols <= set(numbers):
        return diagnosis
    return replace(diagnosis, term=same[0], right=None if diagnosis.right is None else diagnosis.right * share)


def group_of(term: sp.Expr, system: System) -> Group:
    """The kind of a term."""
    slots = system.configuration.slots
    if term.free_symbols & {*slots.accelerations}:
        return Group.INERTIA
    moving = {*slots.velocities, *(s for s in term.free_symbols if base(s) in slots.prescribed and base(s) != s)}
    return Group.VELOCITY if term.free_symbols & moving else Group.FORCE


def _forms(equation: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The equation as it is, and cleared of denominators that are sums; each with what it was multiplied by."""
    yield equation, sp.S.One
    without = cleared(equation)
    if without is not None:
        yield without


def _with_group(diagnosis: Diagnosis, times: sp.Expr, system: System) -> Diagnosis:
    term = diagnosis.term if diagnosis.term is not None else diagnosis.right
    assert term is not None
    return replace(diagnosis, group=group_of(term, system), times=times)


Change = tuple[sp.Expr | None, sp.Expr | None]
"""A term, or None if it is missing, and what it should be, or None if it does not belong there."""
EquationRow = tuple[sp.Expr, list[Any]]
"""A term and its residue."""


class _Search:
    """The search for one change of an equation that makes it follow from a system."""

    def __init__(self, equation: sp.Expr, residues: Residues) -> None:
        self.equation = equation
        self.system = system = residues.system
        self.slots = system.configuration.slots
        self.terms = terms_of(equation) or ()
        self.brackets = tuple(e for e in sp.Add.make_args(equation) if e not in self.terms)
        used = set().union(*(e.free_symbols for e in (equation, *system.equations)))
        moving = {*self.slots.coordinates, *self.slots.prescribed, t}
        unknowns = {*system.multipliers}
        self.parameters = sorted((s for s in used if base(s) not in moving and s not in unknowns), key=str)
        self._accelerations = {*self.slots.accelerations}
        self._moving = {*self.slots.coordinates, *self.slots.velocities, *self.slots.accelerations}
        waves = set().union(*(e.atoms(sp.sin, sp.cos, sp.tan) for e in (equation, *system.equations)))
        self.angles = sorted({_positive(w.args[0]) for w in waves}, key=lambda a: (count_operations(a), str(a)))
        # On some branches the equation may be right. Changes are sought at the first state, where it is wrong.
        self.states = sorted(residues.states((equation,)), key=lambda state: follows(equation, [state]))
        self._scales: dict[sp.Expr, list[tuple[sp.Expr, Any]]] = {}
        self._only: Set[Change] | None = None
        self._known_values: dict[sp.Expr, Any | None] = {}
        self._known_ratios: dict[tuple[sp.Expr, sp.Expr], sp.Expr | None] = {}

    def change(self, *, direct: bool = False) -> Diagnosis | None:
        """The likeliest change that makes the equation right; None if none is found.

        direct  whether it has to make the equation a multiple of a derived one, term by term
        """
        state = self.states[0]
        residues = [state.residue(term) for term in self.terms]
        rows = [r for r in residues if r is not None]
        if not rows or len(rows) < len(residues):
            return None
        reduce = state.point.arithmetic.reduce
        total = [reduce(sum(column)) for column in zip(*rows, strict=True)]
        if state.vanishes(total):
            return None
        change = self._first(rows, total, only=self._direct) if self._direct else None
        return change if change is not None or direct else self._first(rows, total)

    def _first(
        self, rows: Sequence[list[Any]], total: list[Any], *, only: Set[Change] | None = None
    ) -> Diagnosis | None:
        """The likeliest change that holds; `only`: among these, so that other terms need not be tried."""
        own = [
            (term, row)
            for term, row in zip(self.terms, rows, strict=True)
            if only is None or any(term == lost for lost, _ in only)
        ]
        self._only = only
        for candidates in (self._by_number, self._by_another, self._by_missing):
            for _, diagnosis in sorted(candidates(own, total), key=lambda pair: pair[0]):
                if self._may_be(diagnosis.term, diagnosis.right) and self._holds(diagnosis):
                    return diagnosis
        return None

    def _may_be(self, term: sp.Expr | None, right: sp.Expr | None) -> bool:
        """Whether this change is one of those that are looked for."""
        return self._only is None or (term, right) in self._only

    @cached_property
    def _direct(self) -> set[Change]:
        """The changes, term and right, that make the equation a multiple of a derived one, term by term.

        They explain more than those that make it a combination of several: 3 F for F, where m s'' = 2 F and m s'' is
        missing.
        """
        own, multipliers = {*self.terms}, {*self.system.multipliers}
        changes: set[Change] = set()
        for derived in self.system.equations:
            for scale in dict.fromkeys(
                s for pair in self._close_pairs(derived) if (s := self._ratio(*pair)) is not None
            ):
                scaled = [scale * term for term in terms_of(derived) or ()]
                other = {*((terms_of(sp.Add(*scaled)) or ()) if scale.has(sp.Add) else scaled)}
                lost, gained = own - other, other - own
                has_multiplier = any(g.free_symbols & multipliers for g in gained)
                if max(len(lost), len(gained)) == 1 and not has_multiplier:
                    changes.add((next(iter(lost), None), next(iter(gained), None)))
        return changes

    def _close_pairs(self, derived: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
        """The pairs of a term and one of a derived equation whose ratio may make the two equal up to one term.

        Most ratios do not, which their values at a state tell sooner than the terms do.
        """
        state, others = self.states[0], terms_of(derived) or ()
        reduce, inverse = state.point.arithmetic.reduce, state.point.arithmetic.inverse
        values = [self._value_of(term) for term in (*self.terms, *others)]
        pairs = product(range(len(self.terms)), range(len(self.terms), len(values)))
        if not isinstance(state.point, FieldPoint) or any(v is None or v == 0 for v in values):
            yield from product(self.terms, others)
            return
        own = {*values[: len(self.terms)]}
        most = min(len(self.terms), len(others))
        for n, m in pairs:
            term, other = self.terms[n], others[m - len(self.terms)]
            c = reduce(values[n] * inverse(values[m]))
            common = own & {reduce(c * v) for v in values[len(self.terms) :]}
            if len(common) >= most - 1 or _has_sums(term) or _has_sums(other):
                yield term, other

    def group(self) -> Group | None:
        """The group of terms in which the equation differs from the multiple c E of a derived one that is nearest.

        The nearest has most terms in common, and of those that have, the simplest factor. None if it differs in several
        groups, or if another one that is as near differs in others; with multipliers or constraints a derived equation
        is one of many, and None as well.
        """
        if self.system.multipliers or self.system.configuration.rows or not self.terms:
            return None
        own = {*self.terms}
        multiples: dict[tuple[int, int], list[tuple[sp.Expr, sp.Expr]]] = {}
        for derived in self.system.equations:
            for scale, _ in self._scales_to(derived):
                other = {sp.expand(scale * term) for term in terms_of(derived) or ()}
                differing = max(len(own - other), len(other - own))
                simplicity = min(count_operations(factor) for factor in (scale, -scale))
                multiples.setdefault((differing, simplicity), []).append((derived, scale))
        nearest = multiples[min(multiples)] if multiples else []
        groups = {self._only_difference(derived, scale) for derived, scale in nearest}
        return groups.pop() if len(groups) == 1 else None

    def _only_difference(self, derived: sp.Expr, scale: sp.Expr) -> Group | None:
        """The group of terms in which the equation differs from a multiple of a derived one, if it is one group."""
        if scale.free_symbols & {*self._rates}:
            return None
        differing: set[Group] = set()
        for state in self.states:
            c = state.value(scale)
            if c is None:
                return None
            differing |= self._differences(state, derived, c)
        # With other accelerations it may come from several equations, and its forces be those of this one by chance.
        same = {*self.slots.accelerations} & (self.equation.free_symbols ^ derived.free_symbols) == set()
        of_forces = [term for term in terms_of(derived) or () if group_of(term, self.system) is Group.FORCE]
        driven = self._is_driven or scale.has(sp.sin, sp.cos, sp.tan) or self.system.configuration.velocity_part != 0
        if same and of_forces and not driven and differing == {Group.INERTIA, Group.VELOCITY}:
            return Group.MOTION
        return differing.pop() if len(differing) == 1 else None

    @cached_property
    def _is_driven(self) -> bool:
        """Whether something is moved in a given way: then terms without velocities come from T as well."""
        configuration = self.system.configuration
        vectors = [p.position for p in configuration.points] + [e for r in configuration.rotations for e in r.axes]
        given = {t, *self.slots.prescribed}
        return any(not c.free_symbols.isdisjoint(given) for v in vectors for c in v.fixed().components)

    @cached_property
    def _rates(self) -> tuple[sp.Symbol, ...]:
        """The velocities, and the derivatives of prescribed motions."""
        used = set().union(*(e.free_symbols for e in (self.equation, *self.system.equations)))
        prescribed = (s for s in used if base(s) in self.slots.prescribed and base(s) != s)
        return (*self.slots.velocities, *sorted(prescribed, key=str))

    def _differences(self, state: ResidueState, derived: sp.Expr, c: Any) -> set[Group]:
        """The groups of terms in which the equation differs from c times a derived one, at one state.

        What is left at zero velocities, without the accelerations, are the forces; the rest is in velocity terms.
        """
        resting = state.point.with_values(dict.fromkeys(self._rates, state.point.number(0)))
        reduce, vanishes = state.point.arithmetic.reduce, state.point.arithmetic.vanishes
        (*inertia, moving), (*_, at_rest) = (
            [reduce(a - c * b) for a, b in zip(*affine_rows(p, (self.equation, derived), state.unknowns), strict=True)]
            for p in (state.point, resting)
        )
        differs = {
            Group.INERTIA: not all(map(vanishes, inertia)),
            Group.VELOCITY: not vanishes(reduce(moving - at_rest)),
            Group.FORCE: not vanishes(at_rest),
        }
        return {group for group, different in differs.items() if different}

    # Candidates: (cost, diagnosis), sought at the first state. Several changes may make the same equation right.
    # The change of lowest cost that holds at all states is named; a common slip costs less than a rare one.

    def _by_number(self, terms: Sequence[EquationRow], total: list[Any]) -> Iterator[tuple[float, Diagnosis]]:
        """A wrong sign or a wrong numerical coefficient, of a term or of a sum in brackets."""
        for term, residue in (*terms, *self._bracketed):
            wanted = self._wanted(residue, total)
            number = None if wanted is None else self._as_number(wanted)
            if number is None or number == 0:
                continue
            odd = number not in _USUAL and not is_decimal(term)
            cost = 0.0 if number == -1 else 1.0 + 2.0 * odd - 0.5 * is_decimal(term)
            # A term that has a number already is likelier to have a wrong one.
            cost += 0.2 * (term.as_coeff_Mul()[0] in (1, -1)) + 0.1 * bool(self._is_inertia(term))
            slip = kind_of_factor(term, number, self.slots.velocities)
            yield cost, Diagnosis(None, slip, term, number * term, number)

    def _by_another(self, terms: Sequence[EquationRow], total: list[Any]) -> Iterator[tuple[float, Diagnosis]]:
        """A term that should be another one, or has a factor too many or too few."""
        state = self.states[0]
        reduce = state.point.arithmetic.reduce
        for term, residue in terms:
            for n, (slip, variant) in enumerate(variants(term, self.slots, self.parameters, self.angles)):
                replaced = state.residue(variant) if self._may_be(term, variant) else None
                if replaced is None or state.vanishes(replaced):
                    continue
                if state.vanishes(reduce(a - b + c) for a, b, c in zip(total, residue, replaced, strict=True)):
                    yield _COSTS[slip] + 0.001 * n, Diagnosis(None, slip, term, variant)
            wanted = self._wanted(residue, total)
            if wanted is None or state.point.arithmetic.vanishes(wanted):
                continue
            yield from self._with_factor(term, wanted)
        for term, residue in self._bracketed if self._only is None else ():
            wanted = self._wanted(residue, total)
            if wanted is not None and not state.point.arithmetic.vanishes(wanted):
                yield from self._with_factor(term, wanted)

    def _with_factor(self, term: sp.Expr, wanted: Any) -> Iterator[tuple[float, Diagnosis]]:
        """A term or bracket with a factor of this value at the first state."""
        for cost, factor in self._factors_of(wanted, term):
            slip = kind_of_factor(term, factor, self.slots.velocities)
            cost += 1.5 * self._is_inertia(term) - 0.5 * (slip in (Slip.INVERTED, Slip.NUMBER))
            yield cost, Diagnosis(None, slip, term, factor * term, factor)

    @cached_property
    def _bracketed(self) -> list[EquationRow]:
        """The sums in brackets, with their residues."""
        return [(e, r) for e in self.brackets if (r := self.states[0].residue(e)) is not None]

    def _wanted(self, residue: list[Any], total: list[Any]) -> Any | None:
        """The value of the factor that a term should have; None if no factor makes the equation right."""
        ratio = self.states[0].ratio(total, residue)
        return None if ratio is None else self.states[0].point.arithmetic.reduce(1 - ratio)

    def is_all_inertia(self, change: Diagnosis) -> bool:
        """Whether a term with an acceleration changes, by letters, or as the only one that has an acceleration."""
        if change.term is None or change.factor is None or not self._is_inertia(change.term):
            return False
        return not change.factor.is_number or sum(map(self._is_inertia, self.terms)) == 1

    def _is_inertia(self, term: sp.Expr) -> bool:
        return not term.free_symbols.isdisjoint(self._accelerations)

    def _by_missing(self, terms: Sequence[EquationRow], total: list[Any]) -> Iterator[tuple[float, Diagnosis]]:
        """A term too many, or a term of the derived equations that is missing."""
        state = self.states[0]
        for term, own in terms:
            wanted = self._wanted(own, total)
            if wanted is not None and state.point.arithmetic.vanishes(wanted) and len(self.terms) > 1:
                yield 4.6, Diagnosis(None, Slip.EXTRA, term)
        reduce = state.point.arithmetic.reduce
        for derived in (*self.system.equations, *self.system.accelerated_constraints):
            for term in terms_of(derived) or ():
                residue = state.residue_kept(term)
                ratio = None if residue is None else state.ratio(total, residue)
                if ratio is None:
                    continue
                for cost, factor in self._scales_of(reduce(-ratio), term, derived):
                    # A factor that moves is one that other terms have: the whole equation was multiplied by it.
                    has_own = cost == 0 and not self._direct
                    if not self._is_divided and is_divided(factor * term):
                        continue  # a term of equations solved for something, which was not forgotten
                    is_fixed = factor.free_symbols.isdisjoint(self._moving)
                    if has_own or is_fixed or (None, factor * term) in self._direct:
                        yield 4.0 + cost, Diagnosis(None, Slip.MISSING, None, factor * term)

    def _holds(self, diagnosis: Diagnosis) -> bool:
        """Whether the change makes the equation correct at all states and still an equation of motion."""
        changed = self.equation - (diagnosis.term or 0) + (diagnosis.right or 0)
        if not sp.expand(changed).free_symbols & {*self._accelerations, *self.system.multipliers}:
            return False
        for state in self.states:
            taken = None if diagnosis.term is None else -diagnosis.term
            parts = [*self.terms, taken, diagnosis.right]
            residues = [state.residue(x) for x in parts if x is not None]
            if any(r is None for r in residues):
                return False
            sums = [state.point.arithmetic.reduce(sum(c)) for c in zip(*residues, strict=True)]
            if not state.vanishes(sums):
                return False
        return True

    # Factors

    def _factors_of(self, wanted: Any, term: sp.Expr) -> Iterator[tuple[float, sp.Expr]]:
        """The simple factors that have this value at the first state, with their costs."""
        state = self.states[0]
        number = self._as_number(wanted)
        if number is not None:
            yield 1.0, number
            return
        arithmetic = state.point.arithmetic
        odd, of_inertia = is_decimal(term), self._is_inertia(term)
        for n, number in self._matching(wanted, arithmetic, odd):
            factor = self._simple_factors[n]
            # A factor of three parts and a number, or a negative one of an acceleration, explains nothing.
            if number != 1 and (len(sp.Mul.make_args(factor)) > 2 or (of_inertia and number < 0)):
                continue
            yield 2.0 + 0.02 * n / len(self._simple_factors) + (0.0 if number == 1 else 1.0), number * factor

    def _matching(self, wanted: Any, arithmetic: Any, odd: bool) -> list[tuple[int, sp.Rational]]:
        """The simple factors that are `wanted` up to a number, with that number: a usual one, unless it is `odd`."""
        if isinstance(self.states[0].point, FieldPoint) and not odd:
            # wanted = number · factor for a usual number: so the factor has one of these values.
            usual = ((arithmetic.reduce(wanted * self.states[0].point.number(n.q, n.p)), n) for n in _USUAL)
            return sorted((m, n) for value, n in usual for m in self._by_value.get(value, ()))
        matching = []
        for n, value in enumerate(self._values):
            if value is not None and not self._simple_factors[n].is_number:
                number = self._as_number(arithmetic.reduce(wanted * arithmetic.inverse(value)))
                if number is not None and (odd or number in _USUAL):
                    matching.append((n, number))
        return matching

    @cached_property
    def _by_value(self) -> dict[Any, list[int]]:
        """The simple factors that are no numbers, by their values at the first state."""
        return self.states[0].values_of(self._simple_factors)[1]

    def _scales_of(self, wanted: Any, term: sp.Expr, derived: sp.Expr) -> Iterator[tuple[float, sp.Expr]]:
        """The factor of a missing term of a derived equation, with its cost; factors of other terms come first."""
        state = self.states[0]
        known, others = self._value_of, terms_of(derived) or ()
        for own, other in product(self.terms, others):
            # wanted = own/other, as values first: most ratios have another one.
            a, b = known(own), known(other)
            differs = a is not None and b is not None and state.point.arithmetic.reduce(a - wanted * b)
            if not (differs and not state.point.arithmetic.vanishes(differs)):
                factor = self._ratio(own, other)
                value = None if factor is None else state.value(factor)
                if value is not None and state.point.arithmetic.vanishes(state.point.arithmetic.reduce(value - wanted)):
                    yield 0.0, factor
                    return
        for cost, factor in sorted(self._factors_of(wanted, term), key=lambda pair: pair[0])[:1]:
            yield 1.5 + cost, factor

    def _value_of(self, term: sp.Expr) -> Any | None:
        """The value of a term at the first state."""
        if term not in self._known_values:
            self._known_values[term] = self.states[0].value(term)
        return self._known_values[term]

    def _as_number(self, value: Any) -> sp.Rational | None:
        """A value as a fraction of small numbers; None if it is none."""
        point = self.states[0].point
        if isinstance(point, FieldPoint):
            fraction = reconstructed(value, point.p, MAX_NUMERATOR)
            return None if fraction is None else sp.Rational(fraction.numerator, fraction.denominator)
        return next(
            (n for n in (sp.S.One, *NUMBERS) if point.arithmetic.vanishes(value - point.number(n.p, n.q))), None
        )

    @cached_property
    def _is_divided(self) -> bool:
        """Whether one of the terms is divided by a sum."""
        return any(map(is_divided, self.terms))

    @cached_property
    def _simple_factors(self) -> tuple[sp.Expr, ...]:
        lengths = lengths_in(self.system.equations)
        return factors(tuple(self.parameters), self.slots, tuple(self.angles), lengths)

    @cached_property
    def _values(self) -> list[Any | None]:
        """Each factor's value at the first state; None if it has none, or vanishes."""
        return self.states[0].values_of(self._simple_factors)[0]

    def _scales_to(self, derived: sp.Expr) -> list[tuple[sp.Expr, Any]]:
        """The simple ratios of a term of the equation to one of a derived equation, with their values."""
        if derived not in self._scales:
            self._scales[derived] = self._ratios_to(derived)
        return self._scales[derived]

    def _ratios_to(self, derived: sp.Expr) -> list[tuple[sp.Expr, Any]]:
        scales: dict[sp.Expr, Any] = {}
        for own, term in product(self.terms, terms_of(derived) or ()):
            scale = self._ratio(own, term)
            if scale is not None and scale not in scales:
                scales[scale] = self.states[0].value(scale)
        return [(scale, value) for scale, value in scales.items() if value is not None]

    def _ratio(self, own: sp.Expr, term: sp.Expr) -> sp.Expr | None:
        """The ratio of a term to one of a derived equation; None if it is not simple enough for a factor."""
        if (own, term) not in self._known_ratios:
            scale = own / term
            # A ratio that moves is taken only from terms with accelerations, as a factor of the whole equation.
            moves = not scale.free_symbols.isdisjoint(self._moving) and not self._is_inertia(term)
            accelerated = not scale.free_symbols.isdisjoint(self._accelerations)
            simple = not (moves or accelerated or count_operations(scale) > MAX_SCALE_OPERATIONS)
            self._known_ratios[own, term] = scale if simple else None
        return self._known_ratios[own, term]


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


def _has_sums(term: sp.Expr) -> bool:
    """Whether sums are factors of a term, so that a multiple of it may have several terms."""
    return any(f.as_base_exp()[0].is_Add for f in sp.Mul.make_args(term))


def _positive(angle: sp.Expr) -> sp.Expr:
    return -angle if angle.could_extract_minus_sign() else angle
