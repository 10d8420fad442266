"""When linear inequalities have a solution: Fourier–Motzkin elimination with coefficients of known sign.

    c_i + Σ_j c_ij s_j ≥ 0 ,     i = 1 ... m ,

the c being functions of parameters and position. An unknown s is eliminated by combining each inequality that bounds it
from below, p s ≥ q with p > 0, with each that bounds it from above, u s ≤ v with u > 0, to u q ≤ p v. This needs the
signs of the coefficients. Where that of u is not known but v ≥ 0, and s ≥ 0 is among the inequalities, u s ≤ v may be
taken for an upper bound all the same: if u ≤ 0 it says nothing, and u q ≤ p v, q ≥ 0, says nothing either. Otherwise
the cases u > 0, u < 0 and u = 0 are taken one by one. At u = 0 a letter that u is linear in is replaced by its value
there; if the conditions of a case u > 0 are at u = 0 those found there, the case is one of u ≥ 0. So a condition is
strict exactly where its limit does not belong to what is admitted.

Signs are exact: of products and of sums of terms of one sign (`closed_forms.signs`). The sine and cosine of an angle
count as positive where the caller says so; which of these were needed is part of the result.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import permutations, product

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import without_known_magnitudes
from lagrange.mechanics.equilibrium.limits import LONGEST_SLACK, MOST_INEQUALITIES, MOST_MERGED


class NotEliminatedError(Exception):
    """The inequalities are too many, or a sign could not be decided in any number of cases that is allowed."""


@record
class Inequality:
    """constant + Σ coefficients[j] s_j ≥ 0."""

    coefficients: tuple[sp.Expr, ...]
    constant: sp.Expr


@dataclass
class Signs:
    """Signs of expressions of parameters and position.

    acute  angles whose sine and cosine count as positive: symbols, or θ/2
    known  further expressions that are positive
    used   the sines and cosines whose sign mattered
    """

    acute: Collection[sp.Expr] = ()
    known: tuple[sp.Expr, ...] = ()
    used: set[sp.Expr] = field(default_factory=set)
    found: dict[sp.Expr, tuple[int | None, tuple[sp.Expr, ...]]] = field(default_factory=dict)

    def of(self, e: sp.Expr) -> int | None:
        """+1, −1 or 0; None if it may be either."""
        if e == 0:
            return 0
        if e not in self.found:
            self.found[e] = self._sign(e)
        sign, atoms = self.found[e]
        self.used.update(atoms)
        return sign

    def _sign(self, e: sp.Expr) -> tuple[int | None, tuple[sp.Expr, ...]]:
        """The sign, and the sines and cosines that it needs."""
        forms = [*_forms(e), *(sp.cancel(sp.together(in_sines_and_cosines(e) / k)) for k in self.known)]
        for form in forms:
            sign = sign_of(form)
            if sign is not None:
                return sign, ()
        for form in forms:
            atoms = self._assumed(form)
            sign = sign_of(form, atoms) if atoms else None
            if sign is not None:
                return sign, atoms
        return None, ()

    def _assumed(self, e: sp.Expr) -> tuple[sp.Expr, ...]:
        return tuple(
            sorted((f for f in e.atoms(sp.sin, sp.cos) if f.args[0] in self.acute and sign_of(f) is None), key=str)
        )

    def assuming(self, positive: sp.Expr) -> Signs:
        """The same with one more expression that is positive; `used` is shared."""
        return Signs(self.acute, (*self.known, in_sines_and_cosines(positive)), self.used)


def _forms(e: sp.Expr) -> Iterator[sp.Expr]:
    """An expression in sines and cosines, with the square of either replaced by that of the other."""
    plain = in_sines_and_cosines(e)
    yield plain
    if count_operations(plain) > LONGEST_SLACK:
        return
    for one, other in ((sp.sin, sp.cos), (sp.cos, sp.sin)):
        rule = {f**2: 1 - other(f.args[0]) ** 2 for f in plain.atoms(one)}
        turned = sp.expand(plain).xreplace(rule)
        if turned != plain:
            yield sp.factor(sp.expand(turned))


@lru_cache(maxsize=4096)
def in_sines_and_cosines(e: sp.Expr) -> sp.Expr:
    """An expression over one denominator, in the sines and cosines of single angles: of θ/2 where it occurs."""
    if count_operations(e) > LONGEST_SLACK:
        return e
    plain = sp.expand_trig(e)
    plain = plain.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)).replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x))
    waves = plain.atoms(sp.sin, sp.cos)
    halves = {2 * f.args[0]: (sp.sin(f.args[0]), sp.cos(f.args[0])) for f in waves if (2 * f.args[0]).is_Symbol}
    whole = {f: halves[f.args[0]] for f in waves if f.args[0] in halves}
    plain = plain.xreplace({f: 2 * s * c if isinstance(f, sp.sin) else c**2 - s**2 for f, (s, c) in whole.items()})
    return sp.factor(sp.together(plain))


@lru_cache(maxsize=4096)
def shortest(e: sp.Expr) -> sp.Expr:
    """An expression over one denominator, factored; with sin² + cos² = 1 if that makes it shorter."""
    if e.is_number or e.is_Symbol or count_operations(e) > LONGEST_SLACK:
        return e
    best = in_sines_and_cosines(without_known_magnitudes(e))
    for one, other in ((sp.sin, sp.cos), (sp.cos, sp.sin)):
        rule = {f**2: 1 - other(f.args[0]) ** 2 for f in best.atoms(one)}
        over, under = (sp.expand(part) for part in sp.fraction(best))
        turned = sp.factor(sp.expand(over.xreplace(rule)) / sp.expand(under.xreplace(rule)))
        if count_operations(turned) < count_operations(best):
            best = turned
    even = sp.Mul(*(_of_one_degree(part) ** power for part, power in zip(sp.fraction(best), (1, -1), strict=True)))
    return even if count_operations(even) < count_operations(best) else best


def _of_one_degree(e: sp.Expr) -> sp.Expr:
    """A polynomial in sin α and cos α in factors that are seen if all its terms have one degree in the two.

    P cos² α − 2Q sin α cos α − μ P sin α cos α ... is (cos α − μ sin α) times another factor.
    """
    for angle in sorted({f.args[0] for f in e.atoms(sp.sin, sp.cos)}, key=str):
        s, c = sp.sin(angle), sp.cos(angle)
        if not e.is_polynomial(s, c):
            continue
        terms = sp.Poly(e, s, c).terms()
        degrees = {sum(powers) for powers, _ in terms}
        highest = max(degrees)
        if len(degrees) > 1 and all((highest - d) % 2 == 0 for d in degrees):
            square = s**2 + c**2
            e = sp.factor(sp.Add(*(k * s**m * c**n * square ** ((highest - m - n) // 2) for (m, n), k in terms)))
    return e


@record
class Case:
    """Slacks that are not negative, all of them, where the unknowns exist.

    positive    what must be positive besides
    zero        what must vanish besides
    unexamined  those of `positive` for which it is not known whether the unknowns exist where they vanish
    """

    slacks: tuple[sp.Expr, ...]
    positive: tuple[sp.Expr, ...] = ()
    zero: tuple[sp.Expr, ...] = ()
    unexamined: tuple[sp.Expr, ...] = ()


def solvable(inequalities: Sequence[Inequality], signs: Signs, most: int = 0) -> tuple[Case, ...]:
    """The cases in one of which the inequalities have a solution; none: they never have.

    most  coefficients of unknown sign of which both signs are tried

    A slack is not negative where the unknowns exist. Raises NotEliminatedError.
    """
    cases = [*_cases(list(inequalities), signs, most)]
    if 1 < len(cases) <= MOST_MERGED:
        cases = _merged([_reduced(c, signs) for c in cases], signs)
    return tuple(cases)


# -- cases without what the sign that defines them implies -------------------------------------------------------------


def _reduced(case: Case, signs: Signs) -> Case:
    """A case whose first slack A is the sign that it is the case of, and the others where A ≥ 0.

    A B ≥ 0 is B ≥ 0 there, if this holds where A = 0 as well.
    """
    if case.positive or case.zero or not case.slacks:
        return case
    side, *others = dict.fromkeys(case.slacks)
    kept = []
    for e in others:
        quotient = shortest(e / side)
        if count_operations(quotient) < count_operations(e) and is_implied(quotient, side, signs, at_limit=True):
            e = quotient
        if not is_implied(e, side, signs):
            kept.append(e)
    return replace(case, slacks=(side, *dict.fromkeys(kept)))


def is_implied(e: sp.Expr, side: sp.Expr, signs: Signs, at_limit: bool = False) -> bool:
    """Whether e ≥ 0 where side > 0, or where side = 0: with a letter written as its value at the limit and more."""
    try:
        limits = [*_where_it_vanishes(side, signs)]
    except NotEliminatedError:
        return False
    if at_limit:
        return all(p.signs.of(p.put(e)) in (0, 1) for p in limits)
    for p in limits:
        [(letter, value)] = p.rule.items()
        beyond = signs.of(_linear_in(letter, sp.fraction(side)[0])[0] or sp.S.Zero)
        there = e.xreplace({letter: value + (beyond or 0) * sp.Dummy(positive=True)})
        over, under = sp.fraction(sp.together(there))
        forms = (shortest(over), sp.expand(over))
        sense = signs.of(under)
        if not (beyond and sense and any(signs.of(sense * form) in (0, 1) for form in forms)):
            return False
    return bool(limits)


def _merged(cases: Sequence[Case], signs: Signs) -> list[Case]:
    """The cases, with A ≥ 0 and −A ≥ 0 as one where the conditions of the one are those of the other, or implied."""
    left = [*cases]
    for one, other in permutations(cases, 2):
        if one not in left or other not in left or any(c.positive or c.zero or not c.slacks for c in (one, other)):
            continue
        if shortest(one.slacks[0] + other.slacks[0]) != 0:
            continue
        ours, theirs = one.slacks[1:], other.slacks[1:]
        more = [e for e in ours if all(signs.of(shortest(e / t)) != 1 for t in theirs)]
        fewer = all(any(signs.of(shortest(t / e)) == 1 for e in ours) for t in theirs)
        if fewer and all(is_implied(e, other.slacks[0], signs) for e in more):
            left[left.index(one)] = replace(one, slacks=ours)
            left.remove(other)
    return left


def _cases(inequalities: list[Inequality], signs: Signs, depth: int) -> Iterator[Case]:
    if len(inequalities) > MOST_INEQUALITIES:
        raise NotEliminatedError
    width = max((len(i.coefficients) for i in inequalities), default=0)
    if not width:
        slacks = []
        for i in inequalities:
            sign = signs.of(i.constant)
            if sign == -1:
                return
            if sign is None:
                slacks.append(i.constant)
        yield Case(tuple(slacks))
        return
    open_: list[tuple[int, sp.Expr]] = []
    for j in range(width):
        column_signs = [signs.of(i.coefficients[j]) for i in inequalities]
        unsure = [i.coefficients[j] for i, s in zip(inequalities, column_signs, strict=True) if s is None]
        reduced = _without(inequalities, j, column_signs, signs)
        if reduced is not None:
            yield from _cases(reduced, signs, depth)
            return
        open_.append((len(set(unsure)), unsure[0]))
    if depth == 0:
        raise NotEliminatedError
    _, coefficient = min(open_, key=lambda o: o[0])
    strict = [
        (side, case)
        for side in (coefficient, -coefficient)
        for case in _cases(inequalities, signs.assuming(side), depth - 1)
    ]
    try:
        places = [*_where_it_vanishes(coefficient, signs)]
        between = [(p, [*_cases([p.of(i) for i in inequalities], p.signs, depth - 1)]) for p in places]
    except NotEliminatedError:
        for side, case in strict:
            yield replace(case, positive=(side, *case.positive), unexamined=(side, *case.unexamined))
        return
    reached: set[tuple[int, int]] = set()
    for side, case in strict:
        limits = {
            (n, m): _is_limit(case, zero, p) for n, (p, zeros) in enumerate(between) for m, zero in enumerate(zeros)
        }
        held = [
            any(limits[n, m] for m in range(len(zeros))) or p.excludes(case) for n, (p, zeros) in enumerate(between)
        ]
        if all(held) and any(limits.values()):
            reached |= {place for place, is_limit in limits.items() if is_limit}
            yield replace(case, slacks=(side, *case.slacks))
        else:
            yield replace(case, positive=(side, *case.positive))
    for n, (p, zeros) in enumerate(between):
        yield from (replace(z, zero=(p.factor, *z.zero)) for m, z in enumerate(zeros) if (n, m) not in reached)


@record
class _Zero:
    """Where a factor of a coefficient vanishes: `rule` gives one letter in terms of the others."""

    factor: sp.Expr
    rule: Mapping[sp.Symbol, sp.Expr]
    signs: Signs

    def put(self, e: sp.Expr) -> sp.Expr:
        """An expression there."""
        there = e.xreplace(dict(self.rule))
        return sp.radsimp(sp.expand(there)) if there.is_number else shortest(there)

    def of(self, i: Inequality) -> Inequality:
        """An inequality there."""
        return Inequality(tuple(map(self.put, i.coefficients)), self.put(i.constant))

    def excludes(self, case: Case) -> bool:
        """Whether a case is impossible there."""
        slacks, positive = ([self.signs.of(self.put(e)) for e in part] for part in (case.slacks, case.positive))
        return (
            -1 in slacks
            or -1 in positive
            or 0 in positive
            or any(self.signs.of(self.put(e)) in (1, -1) for e in case.zero)
        )

    def conditions(self, case: Case) -> list[tuple[str, sp.Expr]]:
        """The conditions of a case, without those that always hold."""
        slacks = [("≥", e) for e in map(self.put, case.slacks) if self.signs.of(e) not in (0, 1)]
        positive = [(">", e) for e in map(self.put, case.positive) if self.signs.of(e) != 1]
        return [*slacks, *positive, *(("=", e) for e in map(self.put, case.zero) if e != 0)]


def _where_it_vanishes(coefficient: sp.Expr, signs: Signs) -> Iterator[_Zero]:
    """Where the factors of unknown sign of a coefficient are zero. Raises NotEliminatedError if that is not seen."""
    over, _ = sp.fraction(sp.factor(sp.together(coefficient)))
    for factor in sp.Mul.make_args(over):
        base, _ = factor.as_base_exp()
        if signs.of(base) in (1, -1):
            continue
        if len(base.free_symbols) == 1 and (roots := _roots(base, *base.free_symbols)) is not None:
            for letter, root in roots:
                known = [shortest(k.xreplace({letter: root})) for k in signs.known]
                yield _Zero(base, {letter: root}, Signs(signs.acute, tuple(known), signs.used))
            continue
        for letter in sorted(base.free_symbols, key=str):
            rate, rest = _linear_in(letter, base)
            if rate is None or signs.of(rate) not in (1, -1):
                continue
            value = shortest(-rest / rate)
            if letter.is_positive and signs.of(value) in (0, -1):
                break  # it never vanishes
            rule = {letter: value}
            known = [shortest(k.xreplace(rule)) for k in signs.known]
            there = Signs(signs.acute, tuple(known), signs.used)
            yield _Zero(base, rule, there.assuming(value) if letter.is_positive and not value.is_number else there)
            break
        else:
            raise NotEliminatedError


def _roots(e: sp.Expr, letter: sp.Symbol) -> list[tuple[sp.Symbol, sp.Expr]] | None:
    """The roots of a quadratic with numbers for coefficients that the letter can have; None if it is none."""
    if not e.is_polynomial(letter) or sp.degree(e, letter) != 2:
        return None
    real = [r for r in sp.roots(e, letter) if r.is_real]
    return [(letter, r) for r in real if r.is_positive or not letter.is_positive]


def _linear_in(letter: sp.Symbol, e: sp.Expr) -> tuple[sp.Expr | None, sp.Expr]:
    """The slope and the rest of an expression that is linear in a letter; None if it is not."""
    expanded = sp.expand(e)
    rate = expanded.coeff(letter, 1)
    rest = sp.expand(expanded - rate * letter)
    return (None if letter in rest.free_symbols | rate.free_symbols else rate), rest


def _is_limit(case: Case, zero: Case, place: _Zero) -> bool:
    """Whether a case says there what one says that was found there."""
    first, second = place.conditions(case), place.conditions(zero)

    def within(some: list[tuple[str, sp.Expr]], others: list[tuple[str, sp.Expr]]) -> bool:
        return all(any(r == q and place.signs.of(shortest(a / b)) == 1 for q, b in others) for r, a in some)

    return within(first, second) and within(second, first)


def _without(
    inequalities: Sequence[Inequality], j: int, column_signs: Sequence[int | None], signs: Signs
) -> list[Inequality] | None:
    """The inequalities without the unknown s_j; None if a sign that matters is not known."""
    rest = [(_drop(i, j), i.coefficients[j], s) for i, s in zip(inequalities, column_signs, strict=True)]
    kept = [i for i, _, s in rest if s == 0]
    lower = [(i, c) for i, c, s in rest if s == 1]
    upper = [(i, -c) for i, c, s in rest if s == -1]
    unsure = [(i, -c) for i, c, s in rest if s is None]
    if unsure:
        alone = all(c == 0 for i, *_ in rest for c in i.coefficients)
        if not alone or any(signs.of(i.constant) not in (0, 1) for i, _ in unsure):
            return None
        # p s ≥ q with q = −constant: where q ≤ 0, s ≥ 0 says more
        bounds = [(i, p, signs.of(-i.constant)) for i, p in lower]
        if not any(s in (0, 1) for *_, s in bounds) or any(s is None for *_, s in bounds):
            return None
        lower = [(i, p) for i, p, s in bounds if s in (0, 1)]
    return [*kept, *(_combined(low, p, high, u) for (low, p), (high, u) in product(lower, [*upper, *unsure]))]


def _drop(i: Inequality, j: int) -> Inequality:
    return Inequality(tuple(c for k, c in enumerate(i.coefficients) if k != j), i.constant)


def _combined(low: Inequality, p: sp.Expr, high: Inequality, u: sp.Expr) -> Inequality:
    """p s + low ≥ 0 and high − u s ≥ 0 without s: u low + p high ≥ 0."""

    def both(a: sp.Expr, b: sp.Expr) -> sp.Expr:
        return shortest(u * a + p * b) if a != 0 or b != 0 else sp.S.Zero

    pairs = zip(low.coefficients, high.coefficients, strict=True)
    return Inequality(tuple(both(a, b) for a, b in pairs), both(low.constant, high.constant))
