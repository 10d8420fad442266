"""Reduces constraints that are not linear in the velocities: φ(q, q', t) = 0 as alternatives of affine forms.

    (x' − y')² = 0             if and only if x' − y' = 0
    x'² + y'² = 0              if and only if x' = 0 and y' = 0, in real numbers
    exp(x' − y') = 1           if and only if x' − y' = 0
    x'² − c² y'² = 0           if and only if x' − c y' = 0 or x' + c y' = 0: two branches
    x'² + y'² − v² = 0         not equivalent to any linear forms

Such rules are applied to φ from outside inwards. The result is a list of alternatives; each is a list of functions that
all vanish, most of them affine in the velocities. A system is one alternative, and only its author can say which. A
factor without velocities, r in r (x' − y')² = 0, is assumed not to vanish, as in a Pfaffian form; where it can, it is
listed as excluded, to be stated. An alternative that is contained in another is omitted (x' = y' = 0 in x' = y'), and
so are one that contradicts itself (x' = 0 with x' = 1) and, within one alternative, whatever follows from the rest.
Affine forms are compared by rank.

All zeros are found by the exact test, signs by SymPy's assumptions; an unknown sign is never guessed. The work is
bounded: in depth, in the number of functions reduced, in the terms of polynomials.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import product

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero, rank
from lagrange.algebra.forms.limits import (
    DEEPEST_REDUCTION,
    MOST_ALTERNATIVES,
    MOST_BRANCH_GENERATORS,
    MOST_FACTORED_BRANCH_TERMS,
    MOST_REDUCED,
)
from lagrange.algebra.forms.velocity_polynomials import (
    Alternative,
    Alternatives,
    Polynomial,
    Reduction,
    SideCondition,
    Square,
    Why,
    degree,
    is_affine,
    is_definite,
    polynomial,
    polynomial_as_sum,
    squares,
    without_content,
)
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.symbols import Slots, base, t


def in_configuration(function: sp.Expr, slots: Slots) -> Alternatives:
    """The alternatives of f(q, t) = 0, by the same rules with q for q'. Raises DivisionByZeroError."""
    rates = dict(zip(slots.coordinates, slots.velocities, strict=True))
    back = {v: q for q, v in rates.items()}
    in_rates = alternatives(function.xreplace(rates), slots)
    members = tuple(
        Alternative(
            tuple(f.xreplace(back) for f in a.forms),
            tuple(
                Reduction(s.function.xreplace(back), s.why, tuple(f.xreplace(back) for f in s.forms)) for s in a.steps
            ),
        )
        for a in in_rates.members
    )
    return Alternatives(members, in_rates.endless)


def without_implied(candidates: Iterable[Alternative], slots: Slots) -> tuple[Alternative, ...]:
    """The alternatives that are not contained in another: x' = y' = 0 is part of x' = y'."""
    kept: list[Alternative] = []
    for alternative in candidates:
        regular = _independent(alternative, slots)
        if regular is None or any(_implies(regular, k, slots) for k in kept):
            continue
        kept = [k for k in kept if not _implies(k, regular, slots)]
        kept.append(regular)
    return tuple(kept)


def _independent(alternative: Alternative, slots: Slots) -> Alternative | None:
    """The alternative without affine forms that follow from the others; None if they contradict one another."""
    kept: list[sp.Expr] = []
    for form in alternative.forms:
        affine = [f for f in kept if is_affine(f, slots) and _is_kinematic(f, slots)]
        if is_affine(form, slots) and _is_kinematic(form, slots):
            joint = _rank([*affine, form], slots, with_constant=True)
            if joint == len(affine):
                continue
            if joint is not None and joint != _rank([*affine, form], slots, with_constant=False):
                return None
        kept.append(form)
    return Alternative(tuple(kept), alternative.steps)


def _implies(first: Alternative, second: Alternative, slots: Slots) -> bool:
    """Whether the affine forms of the second are combinations of those of the first."""
    if set(second.forms) <= set(first.forms):
        return True
    if not all(is_affine(f, slots) for f in (*first.forms, *second.forms)):
        return False
    return _rank([*first.forms, *second.forms], slots, with_constant=True) == len(first.forms)


def _is_kinematic(form: sp.Expr, slots: Slots) -> bool:
    return not form.free_symbols.isdisjoint(slots.velocities)


def _rank(forms: Sequence[sp.Expr], slots: Slots, *, with_constant: bool) -> int | None:
    at_rest = dict.fromkeys(slots.velocities, sp.S.Zero)
    rows = [[*(f.diff(v) for v in slots.velocities), *((f.xreplace(at_rest),) if with_constant else ())] for f in forms]
    try:
        return rank(rows)
    except DivisionByZeroError:
        return None


def alternatives(function: sp.Expr, slots: Slots) -> Alternatives:
    """The alternatives of φ(q, q', t) = 0, affine in the velocities where such forms exist.

    Raises DivisionByZeroError.
    """
    search = _Search(slots)
    zeros = search.zeros(function, DEEPEST_REDUCTION)
    return Alternatives(without_implied(zeros, slots), search.endless)


_ONE_TO_ONE: dict[type[sp.Expr], Callable[[sp.Expr], sp.Expr]] = {
    sp.exp: sp.log, sp.log: sp.exp, sp.atan: sp.tan, sp.asin: sp.sin, sp.acos: sp.cos,
    sp.sinh: lambda w: sp.log(w + sp.sqrt(w**2 + 1)),
    sp.tanh: lambda w: sp.log((1 + w) / (1 - w)) / 2,
}  # fmt: skip
"""Functions that take no value twice, with their inverses."""

_ZERO_ONLY_AT_ZERO = (sp.Abs, sp.sign, sp.sinh, sp.tanh, sp.atan, sp.asin)
_NEVER_ZERO = (sp.exp, sp.cosh)
_PERIODIC = (sp.sin, sp.cos, sp.tan)


@dataclass
class _Search:
    """Reduces at most MOST_REDUCED functions. `endless` is set where one has infinitely many zeros."""

    slots: Slots
    endless: bool = False
    taken: int = 0

    def zeros(self, f: sp.Expr, depth: int) -> list[Alternative]:
        """The alternatives of f = 0."""
        if not self._moves(f):
            return [] if self._never_zero(f) else [Alternative((f,))]
        if is_affine(f, self.slots):
            return [Alternative((f,))]
        rules = (self._of_product, self._of_power, self._of_function, self._of_sum)
        self.taken += 1
        if depth > 0 and self.taken <= MOST_REDUCED:
            for rule in rules:
                zeros = rule(f, depth - 1)
                if zeros is not None and len(zeros) <= MOST_ALTERNATIVES:
                    return zeros
        return [Alternative((f,))]

    # -- products, powers, functions -----------------------------------------------------------------------------------

    def _of_product(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        """u v/w = 0: a factor that can vanish does. Factors without velocities do not."""
        if not f.is_Mul:
            return None
        above = [a for a in f.args if not _is_reciprocal(a)]
        conditions = [(a.as_base_exp()[0], "≠") for a in f.args if _is_reciprocal(a) and not self._never_zero(a)]
        moving = [a for a in above if self._moves(a)]
        fixed = [a for a in above if not self._moves(a) and self._can_vanish(a)]
        zeros = {a: self.zeros(a, depth) for a in moving}
        vanishing = [a for a in moving if zeros[a]]
        if not vanishing:
            return [Alternative((a,), (Reduction(f, Why.FACTOR, (a,)),)) for a in fixed]
        excluded = tuple(a.as_base_exp()[0] for a in fixed)
        conditions += [(a, "≠") for a in excluded]
        why = Why.SPLIT if len(vanishing) > 1 else Why.QUOTIENT if len(above) < len(f.args) else Why.FACTOR
        return [
            _after(Reduction(f, why, _first(v, vanishing), tuple(conditions), excluded), a)
            for v in vanishing
            for a in zeros[v]
        ]

    def _of_power(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        """u^p = 0 with a positive number p: u = 0."""
        if not f.is_Pow or not f.exp.is_Number:
            return None
        if f.exp.is_negative:
            return []
        return self._next(f, Why.POWER, f.base, depth)

    def _of_function(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        """|u| = 0, sinh u = 0: u = 0. exp u is never zero. sin u is zero at multiples of π."""
        if isinstance(f, _NEVER_ZERO):
            return []
        if isinstance(f, _ZERO_ONLY_AT_ZERO):
            return self._next(f, Why.FUNCTION, f.args[0], depth)
        return self._inverted(f, sp.S.One, f, sp.S.Zero, depth)

    def _next(self, f: sp.Expr, why: Why, form: sp.Expr, depth: int, *conditions: SideCondition) -> list[Alternative]:
        """The condition `form` = 0, equivalent to f = 0, which is then reduced itself."""
        step = Reduction(f, why, (form,), conditions)
        return [_after(step, a) for a in self.zeros(form, depth)]

    # -- sums ----------------------------------------------------------------------------------------------------------

    def _of_sum(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        if not f.is_Add:
            return None
        rules = (self._over_one_denominator, self._never_negative, self._one_moving_term, self._equal_functions,
                 self._of_polynomial, self._root_alone, self._factored)  # fmt: skip
        return next((zeros for rule in rules if (zeros := rule(f, depth)) is not None), None)

    def _over_one_denominator(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        """u/v + w = 0: u + v w = 0, with v ≠ 0."""
        powers: dict[sp.Expr, sp.Expr] = {}
        for term in f.args:
            for factor in sp.Mul.make_args(term):
                if _is_reciprocal(factor) and self._moves(factor):
                    below, exponent = factor.as_base_exp()
                    powers[below] = max(powers.get(below, sp.S.Zero), -exponent)
        if not powers:
            return None
        common = sp.Mul(*(b**e for b, e in powers.items()))
        numerator = sp.Add(*(term * common for term in f.args))
        return self._next(f, Why.QUOTIENT, numerator, depth, *((b, "≠") for b in powers))

    def _never_negative(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        """A sum of terms of one sign vanishes if and only if each term does."""
        terms = sorted(f.args, key=self._first_velocity)
        if not (all(_is_nonnegative(a) for a in terms) or all(_is_nonnegative(-a) for a in terms)):
            return None
        return self._all_zero(f, Why.SQUARES, terms, depth)

    def _all_zero(self, f: sp.Expr, why: Why, forms: Sequence[sp.Expr], depth: int) -> list[Alternative] | None:
        """f = 0 if and only if all forms vanish: every combination of their alternatives."""
        before, each, periodic = self.endless, dict[sp.Expr, list[Alternative]](), list[sp.Expr]()
        for a in forms:
            self.endless = False
            each[a] = self.zeros(a, depth)
            periodic += [a] if self.endless else []
        self.endless = before
        combined = self._combinations(f, why, [each[a] for a in forms if a not in periodic], forms)
        if combined is None or not periodic:
            return combined
        # Of infinitely many zeros those count at which the other forms vanish: of sin² u + u² that at u = 0.
        there = [(alternative, [self._on(a, alternative) for a in periodic]) for alternative in combined]
        if len(periodic) < len(forms) and all(self._is_settled(v) for _, values in there for v in values):
            return [alternative for alternative, values in there if all(v == 0 or is_zero(v) for v in values)]
        self.endless = True
        return self._combinations(f, why, [each[a] for a in forms], forms)

    def _is_settled(self, value: sp.Expr | None) -> bool:
        """Whether it is zero or never vanishes."""
        return value is not None and not self._moves(value) and (is_zero(value) is True or not self._can_vanish(value))

    def _combinations(
        self, f: sp.Expr, why: Why, each: Sequence[Sequence[Alternative]], forms: Sequence[sp.Expr]
    ) -> list[Alternative] | None:
        combined: list[Alternative] = []
        for together in product(*each):
            if len(combined) > MOST_ALTERNATIVES:
                return None
            inside = [s for a in together for s in a.steps]
            step = Reduction(f, why, tuple(forms))
            combined.append(Alternative(tuple(dict.fromkeys(g for a in together for g in a.forms)), (step, *inside)))
        return combined

    def _one_moving_term(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        """c g(u) + rest = 0 where the rest has no velocity: g(u) = w, solved for u."""
        moving = [a for a in f.args if self._moves(a)]
        if len(moving) != 1:
            return None
        factors = sp.Mul.make_args(moving[0])
        active = [a for a in factors if self._moves(a)]
        c = sp.Mul(*(a for a in factors if a not in active))
        if all(isinstance(a, sp.exp) for a in active):
            active = [sp.exp(sp.Add(*(a.exp for a in active)))]
        if len(active) != 1:
            return None
        return self._inverted(f, c, active[0], sp.Add(*(a for a in f.args if a is not moving[0])), depth)

    def _inverted(self, f: sp.Expr, c: sp.Expr, g: sp.Expr, rest: sp.Expr, depth: int) -> list[Alternative] | None:
        """f = c g(u) + rest, so that g(u) = w = −rest/c."""
        w = sp.cancel(-rest / c)
        conditions = () if self._never_zero(c) else ((c, "≠"),)
        if g.is_Pow and g.exp.is_Rational:
            return self._root(f, g, w, depth, conditions)
        u = g.args[0] if g.args else None
        inverse = _ONE_TO_ONE.get(type(g))
        if inverse is not None:
            if (isinstance(g, sp.exp) and w.is_nonpositive) or (isinstance(g, sp.tanh) and _at_least_one(abs(w))):
                return []
            return self._next(f, Why.INVERSE, u - inverse(w), depth, *conditions)
        if isinstance(g, sp.Abs):
            return self._both_signs(f, u, w, depth, conditions)
        if isinstance(g, sp.cosh) and w == 1:
            return self._next(f, Why.INVERSE, u, depth, *conditions)
        if isinstance(g, sp.atan2):
            y, x = g.args
            across, along = y * sp.cos(w) - x * sp.sin(w), x * sp.cos(w) + y * sp.sin(w)
            return self._next(f, Why.DIRECTION, across, depth, *conditions, (along, "≥"))
        if isinstance(g, _PERIODIC):
            if not isinstance(g, sp.tan) and (_at_least_one(abs(w)) and abs(w) != 1):
                return []
            self.endless = True
            first = {sp.sin: (sp.asin(w), sp.pi - sp.asin(w)), sp.cos: (sp.acos(w), -sp.acos(w)), sp.tan: (sp.atan(w),)}
            values = [*first[type(g)], *((v + sp.pi) for v in first[type(g)] if isinstance(g, sp.tan))]
            if isinstance(g, sp.cos) and w == 1:
                values = [sp.S.Zero, 2 * sp.pi]
            return self._split(f, [u - v for v in dict.fromkeys(values)], depth, conditions)
        return None

    def _root(
        self, f: sp.Expr, g: sp.Expr, w: sp.Expr, depth: int, conditions: tuple[SideCondition, ...]
    ) -> list[Alternative] | None:
        """u^(n/m) = w: from even powers two branches, from odd ones and from roots one."""
        u, p = g.base, g.exp
        if w.is_zero:
            return self._next(f, Why.POWER, u, depth, *conditions)
        if p.q % 2 == 0:  # √u
            if w.is_negative:
                return []
            known = () if w.is_nonnegative else ((w, "≥"),)
            return self._next(f, Why.SQUARED, u**p.p - w**p.q, depth, *conditions, *known)
        if p.q != 1 or not is_affine(u, self.slots) or p == 2:
            return None
        if p % 2 == 0:
            return self._both_signs(f, u, w ** (1 / p), depth, conditions) if not w.is_negative else []
        root = w ** (1 / p) if w.is_positive else -((-w) ** (1 / p)) if w.is_negative else None
        return None if root is None else self._next(f, Why.INVERSE, u - root, depth, *conditions)

    def _both_signs(
        self, f: sp.Expr, u: sp.Expr, w: sp.Expr, depth: int, conditions: tuple[SideCondition, ...]
    ) -> list[Alternative]:
        """|u| = w: u = w or u = −w."""
        if w.is_negative:
            return []
        if w.is_zero:
            return self._next(f, Why.FUNCTION, u, depth, *conditions)
        known = () if w.is_nonnegative else ((w, "≥"),)
        return self._split(f, (u - w, u + w), depth, (*conditions, *known))

    def _split(
        self, f: sp.Expr, branches: Sequence[sp.Expr], depth: int, conditions: tuple[SideCondition, ...]
    ) -> list[Alternative]:
        """f = 0 if and only if one of the branches vanishes."""
        return [
            _after(Reduction(f, Why.SPLIT, _first(form, branches), conditions), a)
            for form in branches
            for a in self.zeros(form, depth)
        ]

    def _equal_functions(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        """g(u) − g(v) = 0 for a function that takes no value twice: u − v = 0."""
        if len(f.args) != 2:
            return None
        (c, a), (d, b) = (term.as_coeff_Mul() for term in f.args)
        if c + d != 0 or type(a) is not type(b) or type(a) not in _ONE_TO_ONE:
            return None
        return self._next(f, Why.INVERSE, a.args[0] - b.args[0], depth)

    # -- polynomials ---------------------------------------------------------------------------------------------------

    def _of_polynomial(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        """Multiplied out: linear after all, or a quadratic form."""
        velocities = [v for v in self.slots.velocities if f.has(v)]
        p = polynomial(f, velocities, is_zero)
        if p is None:
            return None
        if degree(p) > 2:
            return self._all_zero(f, Why.SQUARES, velocities, depth) if is_definite(p) else None
        if degree(p) < 2:
            return self._next(f, Why.EXPANDED, polynomial_as_sum(p, velocities), depth)
        return self._of_quadratic(f, p, velocities, depth)

    def _of_quadratic(
        self, f: sp.Expr, p: Polynomial, velocities: Sequence[sp.Symbol], depth: int
    ) -> list[Alternative] | None:
        """Σ d ℓ² = 0: every ℓ is zero if all d have one sign; two squares of opposite sign are a product."""
        terms = squares(p, velocities, is_zero)
        if terms is None:
            return None
        factors = [textbook_form(s.factor) for s in terms]
        pairs = zip(factors, terms, strict=True)
        forms = [without_content(s.form) if self._moves(s.form) else textbook_form(d) for d, s in pairs]
        if len(terms) == 1:
            return self._of_one_square(f, terms[0], forms[0], depth)
        if all(map(_is_nonnegative, factors)) or all(_is_nonnegative(-d) for d in factors):
            return self._all_zero(f, Why.SQUARES, forms, depth)
        if len(terms) > 2:
            return None
        (d, e), (a, b) = factors, [s.form for s in terms]
        if self._moves(b) and not (_is_nonnegative(d) or _is_nonnegative(-d)):
            d, e = sp.S.One, sp.cancel(e / d)
        ratio = _root_of_square(sp.cancel(-e / d))
        branches = tuple(without_content(a + s * ratio * b) for s in (-1, 1))
        known = () if sp.cancel(-e / d).is_nonnegative else ((textbook_form(-e / d), "≥"),)
        return self._split(f, branches, depth, known)

    def _of_one_square(self, f: sp.Expr, square: Square, form: sp.Expr, depth: int) -> list[Alternative]:
        """d ℓ² = c u² = 0, where ℓ is a multiple of u: u = 0, or else c = 0, which is excluded."""
        v = next((v for v in self.slots.velocities if square.form.has(v)), None)
        if v is None:
            return self._next(f, Why.POWER, form, depth)
        c = textbook_form(sp.cancel(square.factor * (square.form.diff(v) / form.diff(v)) ** 2))
        if not self._can_vanish(c):
            return self._next(f, Why.POWER, form, depth)
        step = Reduction(f, Why.POWER, (form,), ((c, "≠"),), (c,))
        return [_after(step, a) for a in self.zeros(form, depth)]

    def _factored(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        """Factors of a polynomial in velocities, exp u, and what else occurs."""
        velocities = [v for v in self.slots.velocities if f.has(v)]
        atoms = {a for a in f.atoms(sp.Function) if self._moves(a)}
        if not atoms and polynomial(f, velocities, is_zero) is None:
            return None
        if len(f.free_symbols) + len(atoms) > MOST_BRANCH_GENERATORS or _terms(f) > MOST_FACTORED_BRANCH_TERMS:
            return None
        try:
            number, factors = sp.factor_list(f)
        except sp.PolynomialError:
            return None
        if len(factors) < 2 and all(e == 1 for _, e in factors):
            return None
        return self._next(f, Why.FACTORED, sp.Mul(number, *(g**e for g, e in factors), evaluate=False), depth)

    def _root_alone(self, f: sp.Expr, depth: int) -> list[Alternative] | None:
        """√u + v = 0: u − v² = 0, if that is linear and f does vanish there. |u| + v = 0: u + v = 0 or u − v = 0."""
        for term in f.args:
            factors = sp.Mul.make_args(term)
            g = next((a for a in factors if self._moves(a)), sp.S.One)
            c = sp.Mul(*(a for a in factors if a is not g))
            if (isinstance(g, sp.Abs) or (g.is_Pow and g.exp == sp.S.Half)) and not self._moves(c):
                rest = sp.Add(*(a for a in f.args if a is not term))
                if isinstance(g, sp.Abs):
                    return self._split(f, (c * g.args[0] + rest, -c * g.args[0] + rest), depth, ())
                rest = sp.cancel(rest / c)
                zeros = self._next(f, Why.SQUARED, g.base - rest**2, depth, (-rest, "≥"))
                if any(not is_affine(e, self.slots) for a in zeros for e in a.forms):
                    return None
                return zeros if all(self._vanishes(f, a) for a in zeros) else None
        return None

    def _vanishes(self, f: sp.Expr, alternative: Alternative) -> bool:
        """Whether f is zero wherever the affine forms of an alternative are."""
        value = self._on(f, alternative)
        return value is not None and is_zero(value) is True

    def _on(self, f: sp.Expr, alternative: Alternative) -> sp.Expr | None:
        """f where the affine forms of an alternative vanish; None if they are not solved for velocities."""
        rule: dict[sp.Expr, sp.Expr] = {}
        for form in alternative.forms:
            form = form.xreplace(rule)
            if not is_affine(form, self.slots):
                return None
            v = next((v for v in self.slots.velocities if is_zero(form.diff(v)) is False), None)
            if v is None:
                return None
            value = sp.cancel(-form.xreplace({v: sp.S.Zero}) / form.diff(v))
            rule = {w: e.xreplace({v: value}) for w, e in rule.items()} | {v: value}
        return f.xreplace(rule)

    def _first_velocity(self, f: sp.Expr) -> int:
        """The place of the first velocity that occurs."""
        places = (n for n, v in enumerate(self.slots.velocities) if f.has(v))
        return next(places, len(self.slots.velocities))

    # -- what is known of a function -----------------------------------------------------------------------------------

    def _moves(self, f: sp.Expr) -> bool:
        """Whether a velocity occurs."""
        return not f.free_symbols.isdisjoint(self.slots.velocities)

    def _never_zero(self, f: sp.Expr) -> bool:
        """Whether it cannot be zero: a number, a positive function, or parameters, which are assumed generic."""
        if f.is_nonzero:
            return True
        moving = {*self.slots.coordinates, *self.slots.prescribed, t}
        constant = not any(base(s) in moving for s in f.free_symbols)
        return constant and is_zero(f) is False

    def _can_vanish(self, f: sp.Expr) -> bool:
        """Whether a function of q and t may be zero somewhere, as far as the same rules can tell."""
        if self._never_zero(f):
            return False
        rates = dict(zip(self.slots.coordinates, self.slots.velocities, strict=True))
        search = _Search(self.slots, taken=self.taken)
        can = bool(search.zeros(f.xreplace(rates), 1))
        self.taken = search.taken
        return can


def _first(one: sp.Expr, all_: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    return (one, *(f for f in all_ if f is not one))


def _after(step: Reduction, alternative: Alternative) -> Alternative:
    return Alternative(alternative.forms, (step, *alternative.steps))


def _is_reciprocal(factor: sp.Expr) -> bool:
    return bool(factor.is_Pow and factor.exp.is_Number and factor.exp.is_negative)


def _is_nonnegative(e: sp.Expr) -> bool:
    return bool(e.is_nonnegative)


def _at_least_one(w: sp.Expr) -> bool:
    return bool((w - 1).is_nonnegative)


def _root_of_square(w: sp.Expr) -> sp.Expr:
    """√w up to its sign: y for y²."""
    root = sp.sqrt(sp.factor(w))
    return root.replace(sp.Abs, lambda u: u)


def _terms(f: sp.Expr) -> int:
    """How many terms it has at most when multiplied out once."""
    return sum(sp.Mul(*(len(sp.Add.make_args(a)) for a in sp.Mul.make_args(term))) for term in sp.Add.make_args(f))
