"""Conditions on positive parameters, all of which hold, in their shortest form.

Polynomials whose terms differ by powers of one monomial t, such as k R/(m g), are polynomials in t > 0. Between their
real roots no sign changes, so that the conditions hold in certain intervals of t, found exactly:

    4 m² g² + 3 k² R² ≥ 8 m g k R,  k R ≥ m g        (t − 2) (3 t − 2) ≥ 0, t ≥ 1        k R ≥ 2 m g .

Otherwise a product A B is split where the other conditions give one factor its sign, or where A + B has a sign,

    A B ≥ 0, A + B ≥ 0        A ≥ 0, B ≥ 0 ,

and a condition is dropped that others imply, being a sum of multiples of them and of terms of one sign.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import combinations, pairwise
from math import gcd

import sympy as sp

from lagrange.algebra.closed_forms.limits import (
    HIGHEST_CONDITION_DEGREE,
    LARGEST_FACTORED,
    MOST_COMBINED,
    MOST_CONDITIONS,
)
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, not_negative, sign_of, sign_on
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record

OPPOSITE = {"≥": "≤", ">": "<", "≤": "≥", "<": ">", "≠": "≠"}


@record
class _Bound:
    """polynomial relation 0; the relation is ≥, > or ≠, and `stated` how it was given."""

    polynomial: sp.Expr
    relation: str
    stated: SignCondition | None = None


def further_conditions(
    conditions: Sequence[SignCondition], known: Sequence[SignCondition] = ()
) -> tuple[SignCondition, ...] | None:
    """What the conditions add to those `known`, as few and short as possible; None if they contradict each other.

    Conditions that are no polynomials in positive parameters are left as they are, but that p > 0 makes p ≠ 0 needless.
    """
    positive = [positive_part(c) for c in (*conditions, *known) if c.relation in "<>"]
    conditions = [_without_modulus(c, positive) for c in conditions] if positive else conditions
    asked, others = _bounds(conditions)
    given, _ = _bounds(known)
    if len(others) > 1:
        others = [b.stated or _written(b) for b in _without_equality([_unresolved(c) for c in others])]
    if not asked:
        return tuple(others)
    if len(asked) + len(given) > MOST_CONDITIONS:
        return tuple(conditions)
    shorter = _on_one_line(asked, given)
    if shorter is None:
        try:
            shorter = _implied(asked, given)
        except _ExcludedError:
            return None
    elif not shorter and isinstance(shorter, _Nowhere):
        return None
    stated = [b.stated or _written(b) for b in shorter]
    return tuple(dict.fromkeys((*stated, *others)))


def _without_modulus(c: SignCondition, positive: Sequence[sp.Expr]) -> SignCondition:
    """N |1/D| ≤ 1 as D ≥ N, where other conditions decide the sign of D: k R ≥ 2 W where k R > W."""
    moduli = c.lhs.atoms(sp.Abs)
    if not moduli or c.relation != "≤":
        return c
    signs = {m: sign_on(m.args[0], positive) for m in moduli}
    above, below = sp.fraction(sp.together(c.lhs.xreplace({m: (sign or 0) * m.args[0] for m, sign in signs.items()})))
    side = sign_on(below, positive)
    if not all(signs.values()) or side not in (1, -1):
        return c
    further = not_negative(side * (below * c.rhs - above), positive)
    return further[0] if further else c


def with_shortest_conditions(branches: Sequence[Branch]) -> list[Branch]:
    """The branches whose conditions do not exclude each other, with the shortest form of these."""
    kept = []
    for b in branches:
        shorter = further_conditions(b.conditions)
        if shorter is not None:
            kept.append(
                b if shorter == b.conditions else replace(b, conditions=shorter, implied=(*b.implied, *b.conditions))
            )
    return kept


def only_excludes_equality(conditions: Sequence[SignCondition], known: Sequence[SignCondition]) -> bool:
    """Whether conditions with > say no more than those known with ≥, apart from equality."""
    weaker = {">": "≥", "<": "≤"}
    weakened = (replace(c, relation=weaker.get(c.relation, c.relation)) for c in conditions if c.relation != "≠")
    return all(further_conditions([c], known) == () for c in weakened)


class _ExcludedError(Exception):
    """Conditions that exclude each other."""


class _Nowhere(tuple[_Bound, ...]):
    """No value satisfies the conditions."""

    __slots__ = ()


def _bounds(conditions: Sequence[SignCondition]) -> tuple[list[_Bound], list[SignCondition]]:
    """The conditions as polynomials, and those that are not polynomial."""
    read: list[_Bound] = []
    others = []
    for c in conditions:
        polynomials = _polynomials(c)
        if polynomials is None:
            others.append(c)
            continue
        relation = {"≤": "≥", "<": ">"}.get(c.relation, c.relation)
        alone = len(polynomials) == 1
        read += [_Bound(p, relation, c if alone else None) for p in polynomials]
    return read, others


def _unresolved(c: SignCondition) -> _Bound:
    """A condition that is no polynomial, with everything on the left."""
    difference = sp.expand((c.lhs - c.rhs) * (-1 if c.relation in "≤<" else 1))
    return _Bound(difference, {"≤": "≥", "<": ">"}.get(c.relation, c.relation), c)


def _polynomials(c: SignCondition) -> list[sp.Expr] | None:
    """What must be ≥ 0, > 0 or ≠ 0, as polynomials in positive parameters; of |N/D| ≤ 1 D − N and D + N."""
    difference = (c.lhs - c.rhs) * (-1 if c.relation in "≤<" else 1)
    if count_operations(difference) > LARGEST_FACTORED or not all(s.is_positive for s in difference.free_symbols):
        return None
    cases = [difference]
    moduli = difference.atoms(sp.Abs)
    if moduli:
        if len(moduli) > 1 or c.relation not in "≤<":
            return None
        [modulus] = moduli
        if sp.expand(difference).coeff(modulus).is_positive is not False:
            return None
        cases = [difference.xreplace({modulus: s * modulus.args[0]}) for s in (1, -1)]
    polynomials = []
    for e in cases:
        above, below = sp.fraction(sp.together(e))
        if not below.is_polynomial(*below.free_symbols):
            return None  # √(1 + μ²) below
        if below.is_number:
            below_sign = 1
        else:
            factors = sp.factor_list(below)[1]
            if not all(n % 2 == 0 or f.is_positive for f, n in factors):
                return None
            below_sign = 1 if sp.factor_list(below)[0] > 0 else -1
        p = sp.expand(above * below_sign * (1 if not below.is_number else sp.sign(below)))
        p = _squared(p)
        if not p.is_polynomial(*p.free_symbols) or not p.free_symbols or p.atoms(sp.Pow) - _powers(p):
            return None
        polynomials.append(p)
    return polynomials


def _squared(p: sp.Expr) -> sp.Expr:
    """W² − 2Q², which has the sign of W − √2 Q; other sums as they are."""
    terms = sp.Add.make_args(p)
    if len(terms) != 2 or not any(x.is_number for x in p.atoms(sp.Pow)):
        return p
    [greater, less] = sorted(terms, key=lambda x: bool(x.is_negative))
    return greater**2 - less**2 if greater.is_positive and less.is_negative else p


def _powers(p: sp.Expr) -> set[sp.Expr]:
    return {x for x in p.atoms(sp.Pow) if x.exp.is_Integer and x.exp > 0 and x.base.is_Symbol}


def _written(b: _Bound) -> SignCondition:
    """Positive terms on the left, negative ones on the right."""
    terms = sp.Add.make_args(sp.expand(b.polynomial))
    left = [t for t in terms if not t.could_extract_minus_sign()]
    right = [-t for t in terms if t.could_extract_minus_sign()]
    if not left:
        return SignCondition(sp.Add(*right), OPPOSITE[b.relation], sp.S.Zero)
    return SignCondition(sp.Add(*left), b.relation, sp.Add(*right))


# -- one monomial ------------------------------------------------------------------------------------------------------


@record
class _Line:
    """The monomials `above`/`below` = t, in which all polynomials are polynomials."""

    above: sp.Expr
    below: sp.Expr
    polynomials: tuple[sp.Poly, ...]


def _line(polynomials: Sequence[sp.Expr]) -> _Line | None:
    """The polynomials in one monomial; None if there is none."""
    symbols = sorted({s for p in polynomials for s in p.free_symbols}, key=str)
    terms = [sp.Poly(p, *symbols).terms() for p in polynomials]
    direction: tuple[int, ...] | None = None
    for own in terms:
        first = own[0][0]
        for powers, _ in own[1:]:
            step = tuple(int(a - b) for a, b in zip(powers, first, strict=True))
            size = gcd(*step)
            primitive = tuple(x // size for x in step)
            if direction is None:
                direction = primitive
            if primitive not in (direction, tuple(-x for x in direction)):
                return None
    if direction is None:
        return None
    t = sp.Dummy("t", positive=True)
    k = next(n for n, x in enumerate(direction) if x)
    written = []
    for own in terms:
        least = min(powers[k] * (1 if direction[k] > 0 else -1) for powers, _ in own)
        exponents = [
            ((powers[k] * (1 if direction[k] > 0 else -1) - least) // abs(direction[k]), c) for powers, c in own
        ]
        if max(n for n, _ in exponents) > HIGHEST_CONDITION_DEGREE:
            return None
        try:
            written.append(sp.Poly(sp.Add(*(c * t**n for n, c in exponents)), t, domain="QQ"))
        except (sp.PolynomialError, sp.CoercionFailed):
            return None
    above = sp.Mul(*(s**x for s, x in zip(symbols, direction, strict=True) if x > 0))
    below = sp.Mul(*(s**-x for s, x in zip(symbols, direction, strict=True) if x < 0))
    return _Line(above, below, tuple(written))


def _on_one_line(asked: Sequence[_Bound], given: Sequence[_Bound]) -> tuple[_Bound, ...] | None:
    """The bounds of t that all conditions leave, and what may not be there; None if this is no interval."""
    line = _line([b.polynomial for b in (*asked, *given)])
    if line is None:
        return None
    bounds = list(zip((*asked, *given), line.polynomials, strict=True))
    inner = [(b, p) for b, p in bounds if b.relation != "≠"]
    interval = _interval(inner)
    if interval is None:
        return None
    if interval == ():
        return _Nowhere()
    before = _interval([(b, p) for b, p in inner if b in given])
    low, high = _ends(interval)
    points = [(b, [r for r in _roots(p) if _within(r, low, high)]) for b, p in bounds if b.relation == "≠"]
    missing = [b for b, roots in points if b in asked and any(r not in (low[0], high[0]) for r in roots)]
    excluded = {r for _, roots in points for r in roots}
    low = (low[0], low[1] and low[0] not in excluded)
    high = (high[0], high[1] and high[0] not in excluded)
    known_low, known_high = _ends(before) if before else ((sp.S.Zero, False), (sp.oo, False))
    if any(not r.is_Rational and r.has(sp.CRootOf) for r in (low[0], high[0])):
        return None
    kept = []
    if low != known_low and low[0] != 0:
        kept.append(_bound(line, low, lower=True))
    if high != known_high and high[0] != sp.oo:
        kept.append(_bound(line, high, lower=False))
    return (*kept, *missing)


_End = tuple[sp.Expr, bool]
"""A value of t, and whether it is included."""


def _bound(line: _Line, end: _End, lower: bool) -> _Bound:
    value, below = sp.fraction(sp.together(sp.radsimp(end[0])))
    greater, less = below * line.above, value * line.below
    relation = "≥" if end[1] else ">"
    sides = (greater, less) if lower else (less, greater)
    return _Bound(sides[0] - sides[1], relation, SignCondition(sides[0], relation, sides[1]))


def _roots(p: sp.Poly) -> list[sp.Expr]:
    """The positive real roots, each once, in order."""
    return [r for r in dict.fromkeys(p.real_roots()) if r > 0]


def _within(r: sp.Expr, low: _End, high: _End) -> bool:
    return bool((r > low[0] or (r == low[0] and low[1])) and (r < high[0] or (r == high[0] and high[1])))


def _ends(cells: tuple[_End, ...] | None) -> tuple[_End, _End]:
    assert cells
    return cells[0], cells[1]


def _interval(bounds: Sequence[tuple[_Bound, sp.Poly]]) -> tuple[_End, ...] | None:
    """The ends of the interval of t in which all hold; () where none does, None if it is not one interval."""
    roots = sorted({r for _, p in bounds for r in _roots(p)}, key=lambda r: r.evalf(40))
    if any(a.evalf(40) == b.evalf(40) for a, b in pairwise(roots)):
        return None
    own = [set(_roots(p)) for _, p in bounds]
    places = _between(roots)
    signs = [[p(x) > 0 for x in places] for _, p in bounds]
    # Cells in order: the open interval before each root, the root, ..., the last open interval.
    cells: list[bool] = []
    for n in range(len(places)):
        cells.append(all(s[n] for s in signs))
        if n < len(roots):
            root = roots[n]
            at = (
                b.relation == "≥" if root in zeros else s[n]
                for (b, _), zeros, s in zip(bounds, own, signs, strict=True)
            )
            cells.append(all(at))
    true = [n for n, holds in enumerate(cells) if holds]
    if not true:
        return ()
    if true[-1] - true[0] + 1 != len(true) or (len(true) == 1 and true[0] % 2):
        return None
    first, last = true[0], true[-1]
    low = (roots[first // 2], True) if first % 2 else (roots[first // 2 - 1] if first else sp.S.Zero, False)
    high = (roots[last // 2], True) if last % 2 else (roots[last // 2] if last < len(cells) - 1 else sp.oo, False)
    return low, high


def _between(roots: Sequence[sp.Expr]) -> list[sp.Rational]:
    """A rational number before, between and after the roots, all positive."""
    near = [sp.Rational(str(r.evalf(30))) for r in roots]
    if not near:
        return [sp.S.One]
    return [near[0] / 2, *((a + b) / 2 for a, b in pairwise(near)), near[-1] + 1]


# -- several -----------------------------------------------------------------------------------------------------------


def _implied(asked: Sequence[_Bound], given: Sequence[_Bound], in_cases: bool = True) -> tuple[_Bound, ...]:
    """The conditions, with products split where signs are known, and without those implied by others.

    in_cases  whether a factor of several conditions may be taken to be positive, and negative
    """
    asked = _without_equality(asked)
    for _ in range(len(asked) + 2):
        changed = _split(asked, given)
        if changed is None:
            break
        asked = changed
    kept = [*dict.fromkeys(_without_equality(asked))]
    for b in sorted(kept, key=lambda b: (b.relation != "≠", -count_operations(b.polynomial))):
        rest = [o for o in kept if o != b]
        if _follows(b, [*rest, *given]):
            kept = rest
        elif b.relation != "≠" and _follows(_Bound(-b.polynomial, ">" if b.relation == "≥" else "≥"), [*rest, *given]):
            raise _ExcludedError
    return (_by_cases(kept, given) if in_cases else None) or tuple(kept)


def _without_equality(asked: Sequence[_Bound]) -> list[_Bound]:
    """p ≥ 0 and p ≠ 0 as the one condition p > 0."""
    different = {sign * b.polynomial for b in asked if b.relation == "≠" for sign in (1, -1)}
    strict = [_Bound(b.polynomial, ">") if b.relation == "≥" and b.polynomial in different else b for b in asked]
    positive = {sign * b.polynomial for b in strict if b.relation == ">" for sign in (1, -1)}
    return [b for b in strict if b.relation != "≠" or b.polynomial not in positive]


def _by_cases(asked: Sequence[_Bound], given: Sequence[_Bound]) -> tuple[_Bound, ...] | None:
    """The conditions where a factor that several of them share, and that is not zero, can have one sign only.

    (d k − 6) D ≥ 0 and (c + 3 − d k − k) D ≥ 0 with D = k + 3 − c: no sign of D will do.
    """
    powers = [dict(sp.factor_list(b.polynomial)[1]) for b in asked]
    own = [{f for f, n in p.items() if n % 2} for b, p in zip(asked, powers, strict=True) if b.relation != "≠"]
    not_zero = {f for b, p in zip(asked, powers, strict=True) if b.relation in "≠>" for f in p}
    shared = {f for one, other in combinations(own, 2) for f in one & other if f in not_zero}
    for f in sorted(shared, key=str):
        possible = []
        for sign in (1, -1):
            case = [_Bound(sign * f, ">")]
            for b, p in zip(asked, powers, strict=True):
                rest = sp.cancel(b.polynomial / f ** p.get(f, 0))
                known = sign ** (p.get(f, 0) % 2)
                if not rest.is_number:
                    case.append(_Bound(sp.expand(known * rest), b.relation) if f in p else b)
                elif b.relation != "≠" and known * rest < 0:
                    break
            else:
                try:
                    possible.append(_implied(case, given, in_cases=False))
                except _ExcludedError:
                    continue
        if not possible:
            raise _ExcludedError
        if len(possible) == 1:
            return possible[0]
    return None


def _follows(b: _Bound, known: Sequence[_Bound]) -> bool:
    """Whether a condition follows from others: a sum of them, times monomials, and of terms that are positive."""
    signs = (b.polynomial, -b.polynomial) if b.relation == "≠" else (b.polynomial,)
    return any(_least(p, known) >= (1 if b.relation == "≥" else 2) for p in signs)


def _least(p: sp.Expr, known: Sequence[_Bound]) -> int:
    """2 if a polynomial is provably positive, 1 if provably nonnegative, 0 otherwise."""
    given = [k for k in known if k.relation != "≠"]
    symbols = sorted({s for e in (p, *(k.polynomial for k in given)) for s in e.free_symbols}, key=str)
    if not symbols:
        return 2 if p.is_positive else 1 if p == 0 else 0
    rows = [(_terms(k.polynomial, symbols), k.relation == ">") for k in given]
    least = 0
    for factor in (sp.S.One, *symbols):
        if factor not in (1, *p.free_symbols) and not any(factor in k.polynomial.free_symbols for k in given):
            continue
        least = max(least, _combined(_terms(p * factor, symbols), rows, MOST_COMBINED))
        if least == 2:
            break
    return least


_Terms = dict[tuple[int, ...], sp.Rational]


def _terms(p: sp.Expr, symbols: Sequence[sp.Symbol]) -> _Terms:
    return dict(sp.Poly(p, *symbols).terms())


def _combined(p: _Terms, known: Sequence[tuple[_Terms, bool]], steps: int, strict: bool = False) -> int:
    """As `_least`, for p and `steps` multiples of what is known, by monomials, that may be taken from it."""
    p = {m: c for m, c in p.items() if c != 0}
    negative = next((m for m in sorted(p) if p[m].is_negative is not False), None)
    if negative is None:
        return 2 if strict or p else 1
    least = 0
    for terms, is_strict in known if steps else ():
        for m, c in terms.items():
            powers = tuple(x - y for x, y in zip(negative, m, strict=True))
            if not c.is_negative or min(powers) < 0:
                continue
            rest = dict(p)
            for n, d in terms.items():
                place = tuple(x + y for x, y in zip(n, powers, strict=True))
                rest[place] = rest.get(place, sp.S.Zero) - d * p[negative] / c
            least = max(least, _combined(rest, known, steps - 1, strict or is_strict))
            if least == 2:
                return 2
    return least


def _split(asked: Sequence[_Bound], given: Sequence[_Bound]) -> list[_Bound] | None:
    """The conditions after one product has been replaced by its factors of unknown sign; None if none can be."""
    for n, b in enumerate(asked):
        others = [*asked[:n], *asked[n + 1 :]]
        number, powers = sp.factor_list(b.polynomial)
        if not powers or (len(powers) == 1 and powers[0][1] == 1):
            continue
        sign = 1 if number > 0 else -1
        open_factors: list[sp.Expr] = []
        weak = False
        for f, exponent in powers:
            positive, negative = _least(f, [*others, *given]), _least(-f, [*others, *given])
            if 2 in (positive, negative):
                sign *= -1 if negative == 2 and exponent % 2 else 1
            elif exponent % 2:
                open_factors.append(f)
            else:
                weak = True
        if not open_factors and not weak and b.relation != "≠":
            if sign < 0:
                raise _ExcludedError
            return others
        if weak or len(open_factors) == len(powers) > 2 or not open_factors:
            continue
        if len(open_factors) == 1:
            return [*asked[:n], _Bound(sign * open_factors[0], b.relation), *asked[n + 1 :]]
        if len(open_factors) == 2 and b.relation != "≠":
            one, other = open_factors
            for s in (1, -1):
                # A B ≥ 0 with A + B > 0, or −A − B > 0: both have that sign. A B ≤ 0 is A (−B) ≥ 0.
                first, second = s * one, s * sign * other
                if _sum_is_positive(first, second, [*others, *given]):
                    return [*asked[:n], _Bound(first, b.relation), _Bound(second, b.relation), *asked[n + 1 :]]
        elif len(open_factors) < len(powers) and b.relation != "≠":
            product = sp.expand(sign * sp.Mul(*open_factors))
            if count_operations(product) < count_operations(b.polynomial):
                return [*asked[:n], _Bound(product, b.relation), *asked[n + 1 :]]
    return None


def _sum_is_positive(a: sp.Expr, b: sp.Expr, known: Sequence[_Bound]) -> bool:
    """Whether a + λ b is not negative for some λ > 0: where it is zero, a b is not positive."""
    of_a, of_b = sp.expand(a).as_coefficients_dict(), sp.expand(b).as_coefficients_dict()
    scales = {sp.S.One, *(-of_a[m] / c for m, c in of_b.items() if m in of_a and of_a[m] * c < 0)}
    return any(_least(sp.expand(a + scale * b), known) for scale in scales)


# -- Under which conditions on the parameters several expressions are positive, each where those before it are ---------
#
# A condition that another implies is dropped: of e > 2a and e > 4a, with a > 0, the second is kept.


class NeverPositiveError(Exception):
    """Some expressions are positive for no values of the parameters."""


def conditions_for(expressions: Iterable[sp.Expr], known: Sequence[sp.Expr]) -> tuple[SignCondition, ...] | None:
    """The conditions under which all expressions are positive; None if they are too long to be of use.

    Raises NeverPositiveError if they cannot be, one being negative where those before it are positive.
    """
    known = list(known)
    conditions = []
    for e in expressions:
        sign = sign_on(e, known)
        if sign in (-1, 0):
            raise NeverPositiveError
        if sign is None:
            condition = more_than_zero(e, known)
            conditions.append(condition)
            known.append(sp.factor(condition.lhs - condition.rhs) * (-1 if condition.relation == "<" else 1))
    if any(count_operations(c.lhs - c.rhs) > LARGEST_FACTORED for c in conditions):
        return None
    kept = _without_weaker(conditions)
    return tuple(SignCondition(shortest_form(c.lhs), c.relation, shortest_form(c.rhs)) for c in kept)


def _without_weaker(conditions: Sequence[SignCondition]) -> list[SignCondition]:
    """The conditions without those implied by another one: of e > 2a and e > 4a, with a > 0, the second.

    Raises NeverPositiveError if two of them exclude each other.
    """
    above = [positive_part(c) for c in conditions]
    if any(sign_of(sp.expand(x + y)) in (-1, 0) for x, y in combinations(above, 2)):
        raise NeverPositiveError
    kept = list(range(len(conditions)))
    for n in range(len(conditions)):
        others = [k for k in kept if k != n]
        known = [above[k] for k in others]
        if any(sign_of(sp.expand(above[n] - p)) in (0, 1) for p in known) or (known and _is_implied(above[n], known)):
            kept = others
    return [conditions[k] for k in kept]


def _is_implied(e: sp.Expr, known: Sequence[sp.Expr]) -> bool:
    """Whether the factors of e show that it is positive where others are: (a − b) (a − 2b) where a > 2b."""
    sign = 1 if count_operations(e) <= LARGEST_FACTORED else 0
    for f in sp.Mul.make_args(sp.factor(e)) if sign else ():
        above = [s for s in (1, -1) if any(sign_of(sp.expand(s * f - p)) in (0, 1) for p in known)]
        sign *= above[0] if above else sign_of(f) or 0
    return sign == 1


def positive_part(c: SignCondition) -> sp.Expr:
    """The expression that a condition requires to be positive."""
    return (c.lhs - c.rhs) * (-1 if c.relation == "<" else 1)


def where_positive(expressions: Iterable[sp.Expr], known: Sequence[sp.Expr]) -> tuple[SignCondition, ...]:
    """Conditions one of which must hold for one of the expressions to be positive: without those that imply another."""
    conditions: list[SignCondition] = []
    for e in expressions:
        try:
            conditions += conditions_for([e], known) or ()
        except NeverPositiveError:
            continue
    conditions = list(dict.fromkeys(conditions))
    implied = (
        any(sign_of(sp.expand(positive_part(other) - positive_part(c))) == 1 for other in conditions if other != c)
        for c in conditions
    )
    return tuple(c for c, weaker in zip(conditions, implied, strict=True) if not weaker)
