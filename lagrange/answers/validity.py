"""Conditions under which a right answer is equivalent to the equations of motion: factors that must not vanish.

An equation of an answer is a combination Σ c_k E_k of the derived ones, with c_k that depend on the state. If all of
them vanish it is empty; if one has a pole it is not defined, or restricts the motion further:

    θ' (m l² θ'' + m g l sin θ) = 0     c = θ',              valid where θ' ≠ 0
    θ'' / sin θ + g/l = 0               c = 1/(m l² sin θ),  valid where sin θ ≠ 0

Which c_k are zero is found at a random state. For a multiple of one E_k, the factor is the ratio of two coefficients;
for several equations that mix the E_k it is the determinant of their coefficients over that of the derived equations,
det(C A) / det A = det C, as long as the determinants are small. A factor is named only if it can vanish at a real point
of the constraint surface.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    InadmissibleError,
    NoPointError,
    Point,
    Surface,
    UnsupportedError,
    has_real_point,
)
from lagrange.algebra.fourier.terms import Factors, as_term, common_powers, multiplied, number_apart, quotient_of_powers
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.answers.limits import (
    MAX_CONDITIONS,
    MAX_DETERMINANT,
    MAX_EXPANDED_TERMS,
    MAX_KEPT_FACTORS,
    MAX_NAMED_SIZE,
)
from lagrange.answers.verdicts import Reason, Why
from lagrange.core.determinants import expanded_determinant
from lagrange.core.expression_size import Sizes
from lagrange.core.records import record
from lagrange.core.symbols import partial, symbols_in
from lagrange.document.math_writer import text
from lagrange.mechanics.dynamics.comparison import System, symbols_of

if TYPE_CHECKING:
    from lagrange.algebra.closed_forms.solution_sets import Branch

_BELOW: dict[type, type] = {sp.tan: sp.cos, sp.sec: sp.cos, sp.cot: sp.sin, sp.csc: sp.sin}


@record
class NonzeroCondition:
    """The condition that `factor` must not vanish, because an equation is multiplied by it.

    factor    None if it is too long to be named, or to find out whether it can vanish
    divided   the equation is divided by it instead
    together  it is a factor of the determinant of all equations, which do not determine the accelerations at its zeros
    """

    factor: sp.Expr | None
    divided: bool = False
    together: bool = False


class Factorizations:
    """The factors of expressions in the equations of one system, kept from one answer to the next.

    never  the factors by which the derived equations divide
    """

    def __init__(self, system: System) -> None:
        self.system = system
        self.measures = Sizes()
        self._known: dict[sp.Expr, Factors] = {}
        self.never = {f for e in system.equations for f in self.below(e)}

    def size(self, e: sp.Expr) -> int:
        """The number of nodes of an expression."""
        return self.measures.of(e).size

    def powers(self, e: sp.Expr) -> Factors:
        """The factors of an expression."""
        if e not in self._known:
            powers: Factors = {}
            for factor, exponent in as_term(e).factors.items():
                inside = self._pieces(factor)
                powers = multiplied(powers, {f: exponent * p for f, p in inside.items()})
            self._known[e] = powers
        return self._known[e]

    def below(self, e: sp.Expr) -> Iterator[sp.Expr]:
        """The factors by which an expression divides, as it is written."""
        stack, seen = [e], {e}
        while stack:
            part = stack.pop()
            if isinstance(part, sp.Pow) and part.exp.is_Rational and part.exp.is_negative:
                yield from self.powers(part.base)
            elif type(part) in _BELOW:
                yield from self.powers(_BELOW[type(part)](part.args[0]))
            stack += [a for a in part.args if a not in seen]
            seen.update(part.args)

    def forget_much(self) -> None:
        """Forgets what other answers had, if that is much."""
        if len(self._known) > MAX_KEPT_FACTORS:
            self._known.clear()
            self.measures = Sizes()

    def _pieces(self, e: sp.Expr) -> Factors:
        """The factors of an expression that is no product, brought to textbook form unless it is long."""
        measure = self.measures.of(e)
        if e.is_Symbol or measure.widest > MAX_EXPANDED_TERMS or measure.size > 4 * MAX_NAMED_SIZE:
            return {e: 1}
        form = textbook_form(e)
        if form == 0 or not form.is_Add:
            return {_signed(f): p for f, p in as_term(form).factors.items()}
        terms = [as_term(summand).factors for summand in form.args]
        shared = common_powers(terms)
        _, rest = number_apart(sp.Add(*(sp.Mul(s, *(f**-p for f, p in shared.items())) for s in form.args)))
        return multiplied(shared, {_signed(rest): 1})


def validity_conditions(
    equations: Sequence[sp.Expr], known: Factorizations, *, complete: bool = True
) -> list[tuple[NonzeroCondition, ...]]:
    """The conditions for each of several independent equations, each zero, that follow from a system.

    known     the system, with the factors that are known of it
    complete  there are no other equations, which might determine the accelerations where these do not

    Empty if they cannot be found within bounds.
    """
    system = known.system
    known.forget_much()
    try:
        one, other = system.configuration.states.sampled(lambda p: _combinations(p, equations, system), 2)
    except (NoPointError, UnsupportedError, DivisionByZeroError):
        return [()] * len(equations)
    combinations = [replace(a, constant=a.values == b.values) for a, b in zip(one, other, strict=True)]
    every = _Validity(equations, known, combinations).conditions()
    return [tuple(c for c in own if complete or not c.together) for own in every]


@record
class _Combination:
    """An equation as a combination of constraints and derived equations.

    parts    the numbers of the derived equations with nonzero coefficients
    pure     whether all constraints have the coefficient 0
    columns  the numbers of the unknowns in the equation
    values   the coefficients, if they are certain
    constant whether the coefficients are numbers: then nothing that could vanish is multiplied or divided by
    """

    parts: tuple[int, ...]
    pure: bool
    columns: frozenset[int]
    values: tuple[Any, ...] = ()
    constant: bool = False


def _combinations(point: Point, equations: Sequence[sp.Expr], system: System) -> list[_Combination]:
    """Each equation as a combination, at one state."""
    constraints = system.accelerated_constraints
    unknowns = _unknowns(system)
    moving = system.moving(point, symbols_of((*equations, *system.equations, *constraints)))
    known = system.rows(moving, ())
    rows = moving.affine(equations, unknowns)
    if rows is None:
        raise UnsupportedError("not linear")
    transposed: list[list[Any]] = [list(column) for column in zip(*known, strict=True)]
    vanishes = moving.arithmetic.vanishes
    combinations = []
    for row in rows:
        c = moving.solution(transposed, row)
        if c is None:
            raise InadmissibleError
        used = [n for n, x in enumerate(c) if not vanishes(x)]
        parts = tuple(n - len(constraints) for n in used if n >= len(constraints))
        columns = frozenset(j for j, x in enumerate(row[:-1]) if not vanishes(x))
        combinations.append(_Combination(parts, len(parts) == len(used), columns, tuple(c)))
    return combinations


def _unknowns(system: System) -> tuple[sp.Symbol, ...]:
    return (*system.multipliers, *system.configuration.slots.accelerations)


class _Validity:
    """The conditions for one answer against one system."""

    def __init__(
        self, equations: Sequence[sp.Expr], known: Factorizations, combinations: Sequence[_Combination]
    ) -> None:
        self.equations = equations
        self.known = known
        self.system = known.system
        self.combinations = combinations
        self.unknowns = _unknowns(known.system)

    def conditions(self) -> list[tuple[NonzeroCondition, ...]]:
        """The conditions for each equation; those on the determinant are given with the last that it mixes."""
        factors = [self._own(e, c) for e, c in zip(self.equations, self.combinations, strict=True)]
        mixed = [n for n, c in enumerate(self.combinations) if not self._is_multiple(c)]
        open_ones = any(not self.combinations[n].constant for n in mixed)
        rest = quotient_of_powers(self._determinant(mixed), _product(factors[n] for n in mixed)) if open_ones else {}
        every = []
        for n, e in enumerate(self.equations):
            own = {f: NonzeroCondition(f, divided=power < 0) for f, power in factors[n].items()}
            own = {f: NonzeroCondition(f, divided=True) for f in self.known.below(e)} | own
            if n in mixed[-1:]:
                own = {f: NonzeroCondition(f, divided=power < 0, together=power > 0) for f, power in rest.items()} | own
            named = (replace(c, factor=None) if self._is_long(f) else c for f, c in [*own.items()][:MAX_CONDITIONS])
            every.append(tuple(dict.fromkeys(c for c in named if c.factor is None or self._counts(c.factor))))
        return every

    def _is_multiple(self, c: _Combination) -> bool:
        return c.pure and len(c.parts) == 1

    def _own(self, equation: sp.Expr, c: _Combination) -> Factors:
        """The factor of one equation: for a multiple of E_k the ratio to it, otherwise what its coefficients share."""
        own = {} if c.constant else {j: self._coefficient(equation, j) for j in sorted(c.columns)}
        if not own:
            return {}
        if self._is_multiple(c):
            derived = {j: self._coefficient(self.system.equations[c.parts[0]], j) for j in own}
            j = min(own, key=lambda j: self.known.size(own[j]) + self.known.size(derived[j]))
            return quotient_of_powers(self.known.powers(own[j]), self.known.powers(derived[j]))
        shared = _common(self.known.powers(a) for a in own.values())
        for k in c.parts:
            coefficients = (self._coefficient(self.system.equations[k], j) for j in range(len(self.unknowns)))
            shared_in_derived = _common(self.known.powers(a) for a in coefficients if a != 0)
            shared = {f: p for f, p in shared.items() if p > 0 and f not in shared_in_derived}
        return shared

    def _determinant(self, mixed: Sequence[int]) -> Factors:
        """The factors of det C for a complete answer; a multiple of one E_k counts as E_k, which leaves the mixed rows.

        If the answer has eliminated the multipliers, their columns are omitted, and det C is known up to factors of
        det A.
        """
        rows = [e if n in mixed else self.system.equations[self.combinations[n].parts[0]]
                for n, e in enumerate(self.equations)]  # fmt: skip
        rows += self.system.accelerated_constraints
        columns = list(range(len(self.unknowns)))
        head = len(self.system.multipliers)  # the first columns
        eliminated = head and not any(self.unknowns[j] in e.free_symbols for e in rows for j in range(head))
        if eliminated:
            columns = columns[head:]
        if len(rows) != len(columns) or len(columns) > MAX_DETERMINANT:
            return {}
        own = self.known.powers(self._expanded(rows, columns))
        derived = [*self.system.equations, *self.system.accelerated_constraints]
        if len(derived) != len(self.unknowns) or len(derived) > MAX_DETERMINANT + 1:
            return {f: p for f, p in own.items() if p > 0}
        of_derived = self.known.powers(self._expanded(derived, range(len(self.unknowns))))
        if eliminated:
            return {f: p for f, p in own.items() if p > 0 and f not in of_derived}
        return quotient_of_powers(own, of_derived)

    def _expanded(self, rows: Sequence[sp.Expr], columns: Iterable[int]) -> sp.Expr:
        """The determinant of the coefficients of some unknowns."""
        return expanded_determinant([[self._coefficient(e, j) for j in columns] for e in rows])

    def _coefficient(self, equation: sp.Expr, column: int) -> sp.Expr:
        """∂e/∂u for e affine in u, written as e is, with nothing multiplied out."""
        u = self.unknowns[column]
        if u not in symbols_in(equation):
            return sp.S.Zero
        return partial(equation, u)

    def _is_long(self, factor: sp.Expr) -> bool:
        return self.known.size(factor) > MAX_NAMED_SIZE and factor not in self.known.never

    def _counts(self, factor: sp.Expr) -> bool:
        """Whether a factor can vanish at a real point at which the derived equations are defined."""
        if factor.is_nonzero or factor in self.known.never:
            return False
        configuration = self.system.configuration
        if not configuration.rows and (factor.is_Symbol or _is_wave(factor)):
            return True
        slots = configuration.slots
        rates = factor.free_symbols & {*slots.velocities}
        if not rates | factor.free_symbols & {*slots.coordinates} or (factor.is_Symbol and rates):
            return True
        rows = [r.velocity_form(slots) for r in configuration.rows] if rates else []
        unknowns = (*slots.coordinates, *slots.velocities) if rates else slots.coordinates
        try:
            return has_real_point(Surface((*configuration.finite_constraints, *rows, factor), unknowns))
        except (UnsupportedError, DivisionByZeroError):
            return False


def _common(powers: Iterable[Factors]) -> Factors:
    listed = list(powers)
    return common_powers(listed) if listed else {}


def _product(factors: Iterable[Factors]) -> Factors:
    product: Factors = {}
    for f in factors:
        product = multiplied(product, f)
    return product


def _signed(e: sp.Expr) -> sp.Expr:
    """A sum up to sign."""
    return -e if e.is_Add and e.could_extract_minus_sign() else e


def _is_wave(e: sp.Expr) -> bool:
    """Whether this is a sine or cosine of something that varies."""
    return isinstance(e, sp.sin | sp.cos) and bool(e.free_symbols)


def also_holds(b: Branch) -> Why:
    """Where an answer holds without equilibrium: on a branch of its solutions."""
    if not b.relations:
        return Why(Reason.HOLDS_WITHOUT)
    stated = " and ".join(f"{text(r.lhs)} = {text(r.rhs)}" for r in b.relations)
    return Why(Reason.HOLDS_WHERE, stated)
