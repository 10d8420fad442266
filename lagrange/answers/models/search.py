"""The search for a model that explains a wrong answer.

First the answer as a whole: do all its equations follow from one changed system? Then each wrong equation by itself:
is it an equation of a changed system, up to a factor; or is there a group of terms in a derived equation E_k, of one
physical origin, whose change makes it right? Of a group g (a weight, a spring, the velocity terms, what a product of
velocities contributes) the factor need not be guessed. If

    a  ≡  Σ_j s_j E_j + x g      modulo the constraints,

g has the factor 1 + x/s_k in the answer: 0 where it is missing, −1 where it has the wrong sign.

Variations are made lazily, in the order of the table, and kept with the reference, so that the next answer to the
problem finds them there. The budget is one of work, counted in rows: every machine says the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import product
from typing import Any

import sympy as sp

from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.linear_algebra import NumberRow, RowSpace
from lagrange.algebra.exact.prime_field import reconstructed
from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    InadmissibleError,
    NoPointError,
    Point,
    UnsupportedError,
)
from lagrange.answers.limits import BRANCHING_STATES, MAX_MODEL_WORK, REAL_STATES, STATES
from lagrange.answers.models.mechanics import Mechanics, Variation
from lagrange.answers.models.states import ModelState, TermGroup, term_groups
from lagrange.answers.models.table import MODELS
from lagrange.answers.slips import terms_of
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, base, t
from lagrange.mechanics.dynamics.comparison import System, random_state, symbols_of

unusable = (InadmissibleError, DivisionByZeroError, NoPointError, UnsupportedError, AssertionError)


@record
class Explanation:
    """The change of the problem that makes a wrong answer, or one equation of it, right.

    name      of the model, or of the kind of mistake in one equation
    cause     the mistake in a few words, the same for all who made it
    sentence  what the answer is, in words
    place     continues "look at"
    whole     whether it explains all equations of the answer together
    """

    name: str
    cause: str
    sentence: str
    place: str
    whole: bool


class Models:
    """The variations of one system, made on first use, and the states at which answers are compared with them.

    values  those that letters of the system have at these states: numbers of the file, or the state at the start
    """

    def __init__(self, system: System, values: dict[sp.Symbol, sp.Expr], mechanics: Callable[[], Mechanics | None]):
        self.system = system
        self.values = values
        self._mechanics = mechanics
        self._states: list[ModelState] = []
        self._pairs: Lazily | None = None

    @cached_property
    def mechanics(self) -> Mechanics | None:
        """The parts of the system; None if they do not add up to its equations, so that no model applies."""
        try:
            mechanics = self._mechanics()
            if mechanics is None:
                return None
            at = self.states(())[0]
            rows = at.rows(mechanics)
            right = at.space(rows)
        except (*unusable, ValueError):
            return None
        agree = all(r in right for r in at.derived) and all(r in at.right for r in rows)
        multipliers = self.system.multipliers[: len(self.system.configuration.rows)]
        return replace(mechanics, multipliers=multipliers) if agree else None

    @cached_property
    def variations(self) -> Lazily:
        """All variations with the names of their models, in the order of the table."""
        return Lazily(self._made())

    def _made(self) -> Iterator[tuple[str, Variation]]:
        if self.mechanics is not None:
            for model in MODELS:
                for variation in model.changes(self.mechanics):
                    yield model.name, variation

    @cached_property
    def groups(self) -> tuple[TermGroup, ...]:
        """The groups of terms of the derived equations."""
        return tuple(term_groups(self.mechanics)) if self.mechanics is not None else ()

    def states(self, equations: Sequence[sp.Expr]) -> list[ModelState]:
        """States at which all these equations are defined; the same ones for all answers where that is possible."""
        if self._states and all(s.row(e) is not None for s in self._states for e in equations):
            return self._states
        self._states = self._drawn(equations)
        self._spaces.clear()
        return self._states

    def _drawn(self, equations: Sequence[sp.Expr]) -> list[ModelState]:
        configuration = self.system.configuration
        symbols = symbols_of((*equations, *self.system.equations))

        def at(point: Point) -> ModelState:
            moving = random_state(point, configuration, symbols)
            numbers = {s: moving.value(v) for s, v in self.values.items()}
            if numbers:
                moving = moving.with_values(numbers)
            drawn = ModelState(moving, self.system)
            for e in equations:
                moving.affine([e], drawn.unknowns)
            return drawn

        surface = configuration.states
        if not any(surface.graph.marks[surface.graph.node(e)] for e in (*equations, *self.system.equations)):
            return surface.sampled(at, STATES)
        return [*surface.sampled(at, BRANCHING_STATES), *surface.sampled(at, REAL_STATES, real=True)]

    @cached_property
    def _spaces(self) -> dict[int, RowSpace | None]:
        """The row space of each variation at the first state."""
        return {}

    def space(self, number: int, variation: Variation) -> RowSpace | None:
        """The row space of a variation at the first state; None if it has none."""
        if number not in self._spaces:
            at = self._states[0]
            self._spaces[number] = _space_by_rule(variation, at) if variation.rule else changed_space(variation, at)
        return self._spaces[number]

    @cached_property
    def is_free(self) -> bool:
        """Whether the coordinates are independent: then any values of them are a state, and a rule can be inverted."""
        return not self.system.configuration.rows

    def pairs(self, made: Callable[[], Iterator[tuple[str, Variation]]]) -> Iterator[tuple[str, Variation, RowSpace]]:
        """Variations by two mistakes, made on first use, with their row spaces at the first state."""
        if self._pairs is None:
            self._pairs = Lazily(made())
        for number, (name, variation) in enumerate(self._pairs):
            space = self.space(-1 - number, variation)
            if space is not None:
                yield name, variation, space


class Lazily:
    """Items of an iterator, each made once."""

    def __init__(self, items: Iterator[tuple[str, Variation]]) -> None:
        self._items = items
        self._made: list[tuple[str, Variation]] = []

    def __iter__(self) -> Iterator[tuple[str, Variation]]:
        number = 0
        while True:
            if number == len(self._made):
                item = next(self._items, None)
                if item is None:
                    return
                self._made.append(item)
            yield self._made[number]
            number += 1


def changed_rows(variation: Variation, at: ModelState) -> list[NumberRow] | None:
    """The rows of the changed equations at a state; None if they are not defined there."""
    try:
        if variation.mechanics is not None:
            m, quasi = variation.mechanics, variation.quasi
            return at.rows(m) if quasi is None else at.quasi_rows(m, quasi)
        if variation.values:
            changes = {s: at.point.value(e) for s, e in variation.values.items()}
            return ModelState(at.point.with_values(changes), at.system).derived
        return at.derived
    except unusable:
        return None


def changed_space(variation: Variation, at: ModelState) -> RowSpace | None:
    """The row space of the changed equations; None if they contradict one another, or are those of the problem."""
    rows = changed_rows(variation, at)
    if rows is None:
        return None
    space = at.space(rows, variation.mechanics)
    width = len(at.unknowns)
    impossible = [at.point.number(0)] * width + [at.point.number(1)]
    if impossible in space:
        return None
    return space


def _space_by_rule(variation: Variation, at: ModelState) -> RowSpace | None:
    """The row space of the derived equations with the inverse of a rule, in which an answer lies if, with the rule, it
    follows from the derived ones."""
    inverse = inverted(variation.rule)
    if inverse is None:
        return None
    rows = [at.row(e.xreplace(inverse)) for e in at.system.equations]
    return None if None in rows else at.space([r for r in rows if r is not None])


def follows_from_rest(row: NumberRow, variation: Variation, at: ModelState) -> bool:
    """Whether an equation follows from a variation only because all its accelerations vanish there, or a force does.

    Then its coefficients may be any, and it is explained only if it is one of the equations itself.
    """
    vanishes, number = at.point.arithmetic.vanishes, at.point.number
    columns = [j for j, x in enumerate(row) if not vanishes(x)]
    if variation.rule or len(columns) < 2:
        return False
    rows = changed_rows(variation, at) or []
    space = at.space(rows, variation.mechanics)
    last, forces = len(row) - 1, range(len(at.unknowns) - len(at.slots.coordinates))

    def vanish(j: int) -> bool:
        return [number(int(i == j)) for i in range(len(row))] in space

    at_rest = columns[-1] < last and all(map(vanish, columns))
    # Of a steady constraint a force that is absent from the equation matters as well: it was not counted there.
    unloaded = any(vanish(j) for j in forces if variation.is_steady or j in columns)
    return (at_rest or unloaded) and not any(row in at.space([own], variation.mechanics) for own in rows)


def inverted(rule: Mapping[sp.Basic, sp.Basic]) -> dict[sp.Basic, sp.Basic] | None:
    """The inverse of a rule that exchanges symbols, or replaces each by a multiple of itself and others that stay."""
    inverse: dict[sp.Basic, sp.Basic] = {}
    for symbol, meant in rule.items():
        if meant.is_Symbol:
            inverse[meant] = symbol
            continue
        factor = sp.expand(meant).coeff(symbol)
        rest = sp.expand(meant - factor * symbol)
        if factor == 0 or (factor.free_symbols | rest.free_symbols) & {*rule}:
            return None
        inverse[symbol] = (symbol - rest) / factor
    return inverse


def said_of_all(name: str, variation: Variation, number: int) -> Explanation:
    """A variation as the explanation of an answer with a number of equations."""
    these = "these are the equations" if number > 1 else "this is the equation"
    return Explanation(name, variation.clause, f"{these} {variation.clause}", variation.place, True)


def explained(equations: Sequence[sp.Expr], wrong: Sequence[int], models: Models) -> tuple[Explanation | None, ...]:
    """The explanation of each wrong equation of an answer; the same one for all if one explains the whole answer.

    wrong  the indices of the wrong equations
    """
    nothing = (None,) * len(wrong)
    try:
        if models.mechanics is None:
            return nothing
        states = models.states(equations)
        search = _Search(equations, models, states)
        whole = search.variation(range(len(equations)), combined=True)
        if whole is not None:
            return (said_of_all(*whole, len(equations)),) * len(wrong)
        # Wrong lines of the working, a velocity or an energy, need not follow from what the equations do.
        accelerations = {*models.system.configuration.slots.accelerations}
        moving = [n for n, e in enumerate(equations) if not e.free_symbols.isdisjoint(accelerations)]
        part = search.variation(moving, combined=True) if 0 < len(moving) < len(equations) else None
        if part is not None:
            said = said_of_all(*part, len(moving))
            return tuple(said if n in moving else search.equation(n) for n in wrong)
        return tuple(search.equation(n) for n in wrong)
    except unusable:
        return nothing


class _Search:
    """The search for an explanation of one answer."""

    def __init__(self, equations: Sequence[sp.Expr], models: Models, states: Sequence[ModelState]) -> None:
        self.equations = equations
        self.models = models
        self.states = states
        self.used = {base(s) for e in equations for s in e.free_symbols}
        self.work = MAX_MODEL_WORK
        self.rows = [at for e in equations if (at := states[0].row(e)) is not None]

    def variation(self, which: Sequence[int], *, combined: bool) -> tuple[str, Variation] | None:
        """The first variation from which these equations follow; not `combined`: each is a multiple of one of its
        own."""
        if len(self.rows) < len(self.equations):
            return None
        work = self.work
        for number, (name, variation) in enumerate(self.models.variations):
            work -= self._cost
            if work < 0:
                return None
            if (not combined and variation.is_reduced) or (variation.is_steady and not self._accelerated(which)):
                continue
            if (
                self._fits(number, variation, which)
                and self._holds(variation, which, combined)
                and not any(follows_from_rest(self.rows[n], variation, self.states[0]) for n in which)
            ):
                return name, variation
        return None

    def _accelerated(self, which: Sequence[int]) -> bool:
        """Whether one of these equations contains an acceleration, and is more than the value of a force."""
        accelerations = self.models.system.configuration.slots.accelerations
        return any(not self.equations[n].free_symbols.isdisjoint(accelerations) for n in which)

    @cached_property
    def _functions(self) -> set[Unspecified]:
        """The unspecified functions of the answer, at their arguments."""
        return {f for e in self.equations for f in e.atoms(Unspecified)}

    @cached_property
    def _cost(self) -> int:
        return len(self.models.system.equations) * (len(self.states[0].unknowns) + 1)

    def _fits(self, number: int, variation: Variation, which: Sequence[int]) -> bool:
        """Whether the equations follow from a variation at the first state."""
        if variation.rule:
            if not any(s in self.used or s in self._functions for s in variation.rule):
                return False
            if self.models.is_free and (space := self.models.space(number, variation)) is not None:
                return all(self.rows[n] in space for n in which)
            rows = [self.states[0].row(self.equations[n].xreplace(dict(variation.rule))) for n in which]
            return all(r is not None and r in self.states[0].right for r in rows)
        if variation.values and not self._is_special(variation, which):
            return False
        space = self.models.space(number, variation)
        return space is not None and all(self.rows[n] in space for n in which)

    def _is_special(self, variation: Variation, which: Sequence[int]) -> bool:
        """Whether these equations lack the symbols to which values are given, and the constraints lack them as well."""
        configuration = self.models.system.configuration
        tied = [e for r in configuration.rows for e in (*r.coefficients, r.drift, r.finite or sp.S.Zero)]
        bound = set().union(*(e.free_symbols for e in (*tied, *configuration.expressed.values())))
        own = {s for n in which for s in self.equations[n].free_symbols}
        return not any(s in own or s in bound for s in variation.values) and all(
            e.free_symbols <= own for e in variation.values.values()
        )

    def _holds(self, variation: Variation, which: Sequence[int], combined: bool) -> bool:
        """Whether the equations follow from a variation at all states."""
        for at in self.states:
            rows = [at.row(self.equations[n].xreplace(dict(variation.rule))) for n in which]
            if any(r is None for r in rows):
                return False
            if combined:
                space = changed_space(variation, at)
                if space is None or any(r not in space for r in rows if r is not None):
                    return False
                continue
            own = changed_rows(variation, at)
            m = variation.mechanics
            if own is None or not all(any(r in at.space([e], m) for e in own) for r in rows if r is not None):
                return False
        return True

    def equation(self, n: int) -> Explanation | None:
        """The explanation of one equation."""
        group = self._group(n)
        if group is not None:
            return group
        own = self.variation([n], combined=False)
        if own is None:
            return self._one_for_another(n) or self._foreign(n)
        name, variation = own
        return Explanation(name, variation.clause, f"this is an equation {variation.clause}", variation.place, False)

    def _one_for_another(self, n: int) -> Explanation | None:
        """The explanation that one parameter replaces another throughout an equation: l_1 for l_2."""
        system, used = self.models.system, self.equations[n].free_symbols
        slots = system.configuration.slots
        unknowns = {*slots.coordinates, *slots.prescribed, *system.multipliers, t}
        for k, derived in enumerate(system.equations[: len(slots.coordinates)]):
            own = sorted((s for s in derived.free_symbols if base(s) not in unknowns), key=str)
            for lost, taken in product((s for s in own if s not in used), (s for s in used if base(s) not in unknowns)):
                changed = derived.xreplace({lost: taken})
                if all(self._is_multiple(n, changed, at) for at in self.states):
                    clause = f"with {taken} in place of {lost} throughout"
                    said = f"this is the equation of {slots.coordinates[k]} {clause}"
                    return Explanation("one parameter for another", clause, said, f"the terms with {taken}", False)
        return None

    def _is_multiple(self, n: int, equation: sp.Expr, at: ModelState) -> bool:
        """Whether an equation of the answer is a multiple of another one, apart from the constraints, at a state."""
        row, other = at.row(self.equations[n]), at.row(equation)
        return row is not None and other is not None and row in at.space([other])

    def _foreign(self, n: int) -> Explanation | None:
        """The explanation by a parameter that the problem has and its equations of motion have not: the coefficient of
        friction where nothing slips."""
        system = self.models.system
        own = {s for e in (*system.equations, *system.accelerated_constraints) for s in e.free_symbols}
        slots = self.models.system.configuration.slots
        moving = {*slots.coordinates, *slots.prescribed, t}
        # What stands beside a force only may come from its name: T for 2 l lambda.
        rest = self.equations[n].xreplace(dict.fromkeys(system.multipliers, sp.S.Zero))
        more = sorted((s for s in rest.free_symbols - own if base(s) not in moving), key=str)
        accelerated = self.equations[n].free_symbols & {*slots.accelerations}
        if not more or not accelerated or any(s in self.states[0].unknowns for s in more):
            return None
        names = ", ".join(map(str, more))
        said = f"it depends on {names}, and the motion does not"
        return Explanation("parameter that does not matter", said, said, f"the terms with {names}", False)

    def _group(self, n: int) -> Explanation | None:
        """The first group of terms whose change makes an equation right."""
        at = self.states[0]
        residue = at.right.residue(self.rows[n])
        for group in self.models.groups:
            for k, own in enumerate(group.rows(at)):
                factor = self._factor(n, residue, own, k, at)
                if factor is None or factor not in group.factors:
                    continue
                if all(self._is_right(n, group, k, factor, other) for other in self.states):
                    slots = self.models.system.configuration.slots
                    sentence, place = group.said(factor, slots.coordinates[k])
                    return Explanation(group.name, sentence, sentence, place, False)
        return None

    def _factor(self, n: int, residue: NumberRow, own: NumberRow, k: int, at: ModelState) -> sp.Rational | None:
        """The factor 1 + x/s_k that a group has in equation n, a multiple of E_k apart from the group; None if it is
        none."""
        vanishes, reduce, inverse = (
            at.point.arithmetic.vanishes,
            at.point.arithmetic.reduce,
            at.point.arithmetic.inverse,
        )
        left = at.right.residue(own)
        pivot = next((i for i, x in enumerate(left) if not vanishes(x)), None)
        if pivot is None:
            return None
        x = reduce(residue[pivot] * inverse(left[pivot]))
        if not all(vanishes(reduce(a - x * b)) for a, b in zip(residue, left, strict=True)):
            return None
        rest = [reduce(a - x * b) for a, b in zip(self.rows[n], own, strict=True)]
        columns = [*at.derived, *at.constraints]
        shares = at.point.solution([list(c) for c in zip(*columns, strict=True)], rest)
        if shares is None or vanishes(shares[k]):
            return None
        if any(not vanishes(s) for j, s in enumerate(shares[: len(at.derived)]) if j != k):
            return None
        return _rational(reduce(1 + x * inverse(shares[k])), at) if self._is_scale(shares[k], n, k, at) else None

    def _is_scale(self, scale: Any, n: int, k: int, at: ModelState) -> bool:
        """Whether a number is the ratio of a term of equation n to one of E_k."""
        own, derived = (terms_of(e) or () for e in (self.equations[n], self.models.system.equations[k]))
        reduce, vanishes = at.point.arithmetic.reduce, at.point.arithmetic.vanishes
        return any(vanishes(reduce(at.point.value(a) - scale * b)) for b in map(at.point.value, derived) for a in own)

    def _is_right(self, n: int, group: TermGroup, k: int, factor: sp.Rational, at: ModelState) -> bool:
        """Whether an equation follows if a group has another factor in E_k."""
        row, reduce = at.row(self.equations[n]), at.point.arithmetic.reduce
        own = group.rows(at)[k]
        c = at.point.number(int(factor.p - factor.q), int(factor.q))
        rows = [*at.derived]
        rows[k] = [reduce(a + c * b) for a, b in zip(rows[k], own, strict=True)]
        return row is not None and row in at.space(rows)


def _rational(value: Any, at: ModelState) -> sp.Rational | None:
    """A value as a fraction of small numbers; None if it is none."""
    if isinstance(at.point, FieldPoint):
        fraction = reconstructed(value, at.point.p, 100)
        return None if fraction is None else sp.Rational(fraction.numerator, fraction.denominator)
    candidates = (0, -1, 2, sp.Rational(1, 2), -2, 3)
    numbers = (sp.Rational(c) for c in candidates)
    return next((c for c in numbers if at.point.arithmetic.vanishes(value - at.point.number(int(c.p), int(c.q)))), None)
