"""Exact forms and their potentials, and exterior forms as dictionaries from increasing indices to coefficients.

If Σ a_i dq_i + a_t dt = df, then f = ∫ a_1 dq_1 + g with a g that does not contain q_1, and ∂g/∂q_2 = a_2 − ∂f_1/∂q_2
gives the next part, until nothing is left. Any order of the variables will do, so that a coefficient whose
antiderivative is not in the table waits until the others have removed their part of it. A prescribed motion u is
integrated in t as an undefined function u(t) with the derivatives u', u''. The result is verified by differentiation.
Constants are cleared: x dx + y dy = 0 has the finite form x² + y² = const.

An exterior form is Σ a_I dq_I with I = (i < j < ...). A product moves each differential to its place and changes sign
with every exchange; it is zero where a differential occurs twice:

    dω = Σ_{i<j} (∂_i a_j − ∂_j a_i) dq_i ∧ dq_j      for ω = Σ a_i dq_i .
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero, vanishes
from lagrange.algebra.forms.antiderivatives import antiderivative, multiplied_out
from lagrange.algebra.forms.limits import LARGEST_INTEGRAND
from lagrange.core.expression_size import count_operations
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import Slots, Unspecified, base, partial, t

Pairs = list[tuple[sp.Symbol, sp.Expr]]


@record
class PartialsComparison:
    """∂a/∂k = ∂b/∂i, for the coefficients a of di and b of dk; `equal` is None if it is undecided."""

    variables: tuple[sp.Symbol, sp.Symbol]
    coefficients: tuple[sp.Expr, sp.Expr]
    derivatives: tuple[sp.Expr, sp.Expr]
    equal: bool | None


@record
class Exactness:
    """All pairs of partial derivatives of one form; `exact` is None if it depends on an undecided pair."""

    comparisons: tuple[PartialsComparison, ...]
    exact: bool | None

    @property
    def differing(self) -> tuple[PartialsComparison, ...]:
        """The pairs that differ."""
        return tuple(c for c in self.comparisons if c.equal is False)


def exactness(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> Exactness:
    """Every pair of partial derivatives of a form compared, as the chapter does it; not those of 0 with 0.

    form       (k,) coefficients of the differentials of `variables` (k,), t among them if there is a dt
    """
    comparisons = []
    for (q, a), (r, b) in combinations(zip(variables, form, strict=True), 2):
        if a == b == 0:
            continue
        left, right = differentiated(a, r, slots), differentiated(b, q, slots)
        equal = True if left == right else compared(left - right)
        comparisons.append(PartialsComparison((q, r), (a, b), (left, right), equal))
    return Exactness(tuple(comparisons), all_hold(c.equal for c in comparisons))


def compared(difference: sp.Expr) -> bool | None:
    """Whether a difference is zero; None: undecided."""
    try:
        return is_zero(difference)
    except DivisionByZeroError:
        return None


def potential(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> sp.Expr | None:
    """A function whose differential is `form` times a constant, as a person would write it; None: not found.

    form       (k,) coefficients of the differentials of `variables` (k,), t among them if there is a dt
    """
    f = potential_of(form, variables, slots)
    return None if f is None else without_constant_factor(f, variables, slots)


def potential_of(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> sp.Expr | None:
    """A function f with df = `form`, verified; None if none is found."""
    # u' and u'' as derivatives of one function u(t): the table then integrates c(q) u' dt.
    timed = _as_functions_of_time(form, slots)
    rule = {s: u for s, u in timed.items() if u != s}
    back = {u: s for s, u in rule.items()}
    waiting = [(v, sp.sympify(a, strict=True).xreplace(rule)) for v, a in zip(variables, form, strict=True)]
    integral = _successively(waiting)
    if integral is None:
        return None
    f = integral.xreplace(back)
    # With bars first. They bring signs into the derivatives, which may leave the comparison undecided.
    positive = f.replace(sp.log, lambda e: sp.log(e.args[0] if isinstance(e, sp.Abs) else e))
    for candidate in (f, positive) if positive != f else (f,):
        differences = (differentiated(candidate, v, slots) - a for v, a in zip(variables, form, strict=True))
        if all(vanishes(d) for d in differences):
            return candidate
    return None


def differentiated(e: sp.Expr, v: sp.Symbol, slots: Slots) -> sp.Expr:
    """∂e/∂v; by t, prescribed motions go on."""
    return slots.frozen_derivative(e) if v == t else partial(e, v)


def without_constant_factor(f: sp.Expr, variables: Sequence[sp.Symbol], slots: Slots) -> sp.Expr:
    """The function f without the constant factor that all its terms have, and not all of them negative."""
    moving = {*variables, *slots.prescribed}
    factors = [c for c in sp.Mul.make_args(sp.factor_terms(f)) if not varies(c, moving)]
    common = sp.Mul(*(abs(c) if c.is_Rational else c for c in factors))
    if common == 0:
        return f
    terms = [_without_minus(sp.factor_terms(term / common)) for term in sp.Add.make_args(f)]
    if all(term.could_extract_minus_sign() for term in terms):
        terms = [-term for term in terms]
    return sp.Add(*terms)


def _without_minus(term: sp.Expr) -> sp.Expr:
    """The angle -atan2(y, x) as atan2(x, y), which is a quarter turn from it; other terms as they are."""
    number, angle = term.as_coeff_Mul()
    return -number * sp.atan2(*reversed(angle.args)) if number < 0 and isinstance(angle, sp.atan2) else term


def varies(e: sp.Expr, moving: set[sp.Symbol]) -> bool:
    """Whether an expression contains one of the symbols, or a derivative of it."""
    return any(base(s) in moving for s in e.free_symbols)


def _successively(waiting: Pairs) -> sp.Expr | None:
    f, done = sp.S.Zero, list[sp.Symbol]()
    while waiting:
        # The first coefficient that can be integrated; the others wait until it has removed its part of them.
        for v, a in waiting:
            rest = _remainder(a, sp.diff(f, v), done)
            part = None if rest is None else _part(rest, v, [b for w, b in waiting if w != v])
            if part is None and rest is not None and f != 0:
                steady = _steady(rest, v)
                part = None if steady is None else steady * v
            if part is not None:
                break
        else:
            return None
        f += part
        done.append(v)
        waiting = [pair for pair in waiting if pair[0] != v]
    return f


def _part(a: sp.Expr, v: sp.Symbol, others: Sequence[sp.Expr]) -> sp.Expr | None:
    """∫ a dv; a square where a is linear and, up to a factor, another coefficient too: (x1 - x2)²/2."""
    rate = sp.diff(a, v)
    if rate.is_Rational and rate != 0 and a != rate * v:
        content, inner = a.as_content_primitive()
        if any(b.as_content_primitive()[1] in (inner, -inner) for b in others):
            return content * inner**2 / (2 * sp.diff(inner, v))
    return antiderivative(a, v)


def _remainder(a: sp.Expr, taken: sp.Expr, done: Sequence[sp.Symbol]) -> sp.Expr | None:
    """a - taken, which does not depend on `done` if the form is exact, written without them."""
    rest = a - taken
    if not rest.free_symbols & set(done):
        return rest
    if count_operations(rest) <= LARGEST_INTEGRAND and vanishes(rest):
        return sp.S.Zero
    # The rest may still be written with variables on which it does not depend: any number may take their place.
    rest = multiplied_out(rest)
    for v in done:
        if v in rest.free_symbols:
            rest = at_some_value(rest, v)
            if rest is None:
                return None
    return rest


def _is_sign_of_size(e: sp.Expr) -> bool:
    return isinstance(e, sp.sign) and isinstance(e.args[0], sp.Abs)


def _steady(e: sp.Expr, v: sp.Symbol) -> sp.Expr | None:
    """The expression without v, if it does not depend on it: sin² v + cos² v is 1. None if it does."""
    rate = sp.diff(e, v)
    if count_operations(rate) > LARGEST_INTEGRAND or not vanishes(rate):
        return None
    value = at_some_value(e, v)
    if value is not None and value.is_number and not value.is_Rational and value.is_finite:
        near = sp.Rational(str(sp.N(value, 20))).limit_denominator(60)
        return near if vanishes(e - near) else value
    return value


def at_some_value(e: sp.Expr, v: sp.Symbol) -> sp.Expr | None:
    """The expression at a number v for which it is finite and real: all of it, where it does not depend on v."""
    for number in (0, 1, 2, sp.Rational(1, 2)):
        value = e.subs(v, number).replace(_is_sign_of_size, lambda _: sp.S.One)
        if not value.has(sp.nan, sp.zoo, sp.oo, -sp.oo, sp.I):
            return value
    return None


def _as_functions_of_time(form: Sequence[sp.Expr], slots: Slots) -> dict[sp.Symbol, sp.Expr]:
    """The slots u, u', ... that occur, each with the function u(t) or the derivative that it means."""
    rule: dict[sp.Symbol, sp.Expr] = {}
    for symbol in {s for a in form for s in sp.sympify(a, strict=True).free_symbols}:
        u = base(symbol)
        if u in slots.prescribed:
            function = Unspecified.of(u.name, ("t",), t)
            for order in range(len(symbol.name) - len(u.name) + 1):
                rule[sp.Symbol(u.name + "'" * order, real=True) if order else u] = function
                function = function.partial(0)
    return rule


ExteriorForm = Mapping[tuple[int, ...], sp.Expr]


def one_form(coefficients: Sequence[sp.Expr]) -> ExteriorForm:
    """Σ a_i dq_i."""
    return {(i,): a for i, a in enumerate(coefficients) if a != 0}


def exterior_derivative(coefficients: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> ExteriorForm:
    """dω = Σ (∂_i a_j − ∂_j a_i) dq_i ∧ dq_j of a form Σ a_i dq_i."""
    pairs = combinations(enumerate(variables), 2)
    curl = {
        (i, j): differentiated(coefficients[j], q, slots) - differentiated(coefficients[i], r, slots)
        for (i, q), (j, r) in pairs
    }
    return {pair: a for pair, a in curl.items() if a != 0}


def wedge(left: ExteriorForm, right: ExteriorForm) -> ExteriorForm:
    """left ∧ right."""
    total: dict[tuple[int, ...], list[sp.Expr]] = {}
    for i, a in left.items():
        for j, b in right.items():
            if not set(i) & set(j):
                total.setdefault(tuple(sorted(i + j)), []).append(_sign(i + j) * a * b)
    return {k: sp.Add(*terms) for k, terms in total.items()}


def _sign(indices: tuple[int, ...]) -> int:
    """The sign of the permutation that sorts the indices."""
    wrong = sum(indices[a] > indices[b] for a in range(len(indices)) for b in range(a + 1, len(indices)))
    return -1 if wrong % 2 else 1
