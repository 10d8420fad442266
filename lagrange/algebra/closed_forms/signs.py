"""The sign of an expression in symbols of known sign, and the conditions under which roots are real.

A product has the product of the signs of its factors, a sum of terms of one sign that sign. A sum with one square root
in it is decided by squares: where A and B √D have different signs, A + B √D has the sign of A times that of A² − B² D.
e^u is more than 1 for u > 0.
Parameters may have a range (`ranges`). An undecidable sign is None, and becomes a condition of whatever depends on it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from math import gcd, lcm
from random import Random

import sympy as sp

from lagrange.algebra.closed_forms.limits import LARGEST_SIGNED, SHORTEST_TRIED, TRIED_POINTS
from lagrange.algebra.closed_forms.shortest_form import in_sines
from lagrange.algebra.exact.expression_graph import DivisionByZeroError, Graph, UnsupportedError
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.real_points import RealPoint, Reals
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Bounded, range_of, sign_in_range


@record
class SignCondition:
    """lhs relation rhs, where the relation is one of ≥ ≤ > < ≠."""

    lhs: sp.Expr
    relation: str
    rhs: sp.Expr


def sign_of(expression: sp.Expr, positive: Iterable[sp.Expr] = ()) -> int | None:
    """+1, -1 or 0; None if it may be either. Each of `positive` is taken to be positive."""
    if expression == 0:
        return 0
    positive = tuple(positive)
    if takes_both_signs(expression, positive):
        return None
    known = tuple(f for p in positive for f in (p, -p))
    return _of_product(_factored(expression), known)


@lru_cache(maxsize=1000)
def _factored(expression: sp.Expr) -> sp.Expr:
    return sp.factor(expression) if count_operations(expression) <= LARGEST_SIGNED else expression


def _of_product(product: sp.Expr, known: tuple[sp.Expr, ...]) -> int | None:
    sign = 1
    unknown = []
    for factor in sp.Mul.make_args(product):
        base, exponent = factor.as_base_exp()
        if exponent.is_Integer and exponent % 2 == 0 and base.is_real:
            continue
        factor_sign = _of_factor(base if exponent.is_Rational else factor, known)
        if exponent.is_Rational and not exponent.is_Integer:
            factor_sign = 1  # a root is positive where it exists
        if factor_sign is None:
            unknown.append(base if exponent.is_Integer else factor)
        else:
            sign *= factor_sign
    together = _of_known_product(unknown, known) if unknown else 1
    return None if together is None else sign * together


def _of_known_product(factors: list[sp.Expr], known: tuple[sp.Expr, ...]) -> int | None:
    """The sign of several factors of which only the product is known: (a − b)/(c − d), where (a − b) (d − c) > 0."""
    if len(factors) > 1:
        for n, p in enumerate(known):
            if n % 2 == 0 and {*sp.Mul(*factors).free_symbols} <= p.free_symbols:
                ratio = _factored(sp.Mul(_factored(p), *(1 / f for f in factors)))
                if (sign := _of_product(ratio, ())) is not None:
                    return sign
    return None


def _of_factor(f: sp.Expr, known: tuple[sp.Expr, ...]) -> int | None:
    for n, p in enumerate(known):
        if f == p:
            return -1 if n % 2 else 1
    if f.is_positive or f.is_nonnegative:
        return 1
    if f.is_negative or f.is_nonpositive:
        return -1
    if (in_range := sign_in_range(f)) is not None:
        return in_range
    if not f.is_Add:
        return None
    signs = {_of_product(term, known) for term in f.args}
    if len(signs) == 1:
        return signs.pop()
    if (beyond := _of_more_than_known(f, known)) is not None:
        return beyond
    if known and (raised := _without_common_power(f)) != f and (same := _of_factor(raised, known)) is not None:
        return same  # 2 √U > √(2m) v, where 2 U > m v² is known: conditions are stated without roots
    growing = {e: 1 + sp.Dummy(positive=True) for e in f.atoms(sp.exp) if _of_product(e.args[0], known) == 1}
    if growing:
        return _of_product(_factored(sp.expand(f.xreplace(growing))), known)
    factors = (p for term in f.args for p in sp.Mul.make_args(term))
    roots = {p for p in factors if p.is_Pow and p.exp == sp.S.Half and not p.base.is_number}
    if len(roots) == len(f.args) == 2:
        return _of_two_roots(f, known)
    if roots:
        return _by_squares(f, roots.pop(), known) if len(roots) == 1 else None
    return _of_bounded(f) or _of_quadratic(f, known)


def _of_more_than_known(f: sp.Expr, known: tuple[sp.Expr, ...]) -> int | None:
    """The sign of a sum that is a known one and terms of its sign: k + 3 − c + d k, where k + 3 > c."""
    for n, p in enumerate(known):
        if p.is_Add and {*f.args} & {*p.args}:
            rest = f - p
            if all(term.is_nonnegative for term in sp.Add.make_args(rest)):
                return 1 if n % 2 == 0 else None
            if all(term.is_nonpositive for term in sp.Add.make_args(rest)):
                return -1 if n % 2 else None
    return None


def _of_bounded(f: sp.Expr) -> int | None:
    """The sign of a number and sines and cosines that cannot outweigh it: 1 − cos α, 3 − 2 |cos α|, 3 + sin² α."""
    number, rest = f.as_coeff_Add()
    most = sp.S.Zero
    for term in sp.Add.make_args(rest):
        c, factors = term.as_coeff_Mul()
        if not all(_is_at_most_one(factor) for factor in sp.Mul.make_args(factors)):
            return None
        most += abs(c)
    return None if most > abs(number) else 1 if number > 0 else -1


def _is_at_most_one(f: sp.Expr) -> bool:
    """Whether a factor lies between −1 and 1: the sine or cosine of anything, its modulus, its powers."""
    base, exponent = f.as_base_exp()
    if isinstance(base, sp.Abs):
        [base] = base.args
    return isinstance(base, sp.sin | sp.cos) and bool(exponent.is_Integer and exponent > 0)


@lru_cache(maxsize=1000)
def _of_quadratic(f: sp.Expr, known: tuple[sp.Expr, ...]) -> int | None:
    """The sign of a x² + b x + c without real roots."""
    if takes_both_signs(f, known[::2]):
        return None
    for x in sorted(f.free_symbols, key=str):
        if not f.is_polynomial(x) or sp.degree(f, x) != 2:
            continue
        a, b, c = sp.Poly(f, x).all_coeffs()
        if _of_product(_factored(sp.expand(b**2 - 4 * a * c)), known) == -1:
            return _of_product(_factored(a), known)
    return None


def _by_squares(f: sp.Expr, root: sp.Expr, known: tuple[sp.Expr, ...]) -> int | None:
    """The sign of A + B √D."""
    with_root = [term for term in f.args if term.has(root)]
    a = sp.Add(*(term for term in f.args if not term.has(root)))
    b = sp.Add(*(term / root for term in with_root))
    if a.has(root) or b.has(root) or a == 0:
        return None
    of_a, of_b = (_of_product(_factored(e), known) for e in (a, b))
    if of_b is None:
        return None
    if of_a == of_b:
        return of_a
    # A and B √D of different signs: the one with the larger square decides.
    square = _of_product(_factored(_in_sines(sp.expand(a**2 - b**2 * root.base))), known)
    if of_a is not None:
        return None if square is None else of_a * square
    if square == -1:
        return of_b
    # A has no known sign. If B √D outweighs even the terms of A that are against it, the sum has its sign.
    against = sp.Add(*(term for term in sp.Add.make_args(a) if _of_product(term, known) != of_b))
    if against in (0, a):
        return None
    rest = _of_product(_factored(sp.expand(b**2 * root.base - against**2)), known)
    return of_b if rest == 1 else None


def _of_two_roots(f: sp.Expr, known: tuple[sp.Expr, ...]) -> int | None:
    """The sign of A √B − C √D: that of A² B − C² D, where A and C have signs."""
    terms = [(t, _of_product(t, known)) for t in f.args]
    above = [t for t, sign in terms if sign == 1]
    below = [t for t, sign in terms if sign == -1]
    if len(above) != 1 or len(below) != 1:
        return None
    return _of_product(_factored(sp.expand(above[0] ** 2 - below[0] ** 2)), known)


def _in_sines(e: sp.Expr) -> sp.Expr:
    """An expanded sum with cos² α = 1 − sin² α: 9 cos² α + 4 sin² α − 9 is −5 sin² α."""
    squares = {c**2: 1 - sp.sin(c.args[0]) ** 2 for c in e.atoms(sp.cos)}
    return sp.expand(e.xreplace(squares)) if squares else e


def not_negative(expression: sp.Expr, positive: Iterable[sp.Expr] = ()) -> tuple[SignCondition, ...] | None:
    """The conditions under which an expression is ≥ 0: none, one (b > 0 of 1/b), or None if it is negative."""
    positive = tuple(positive)
    sign = sign_of(expression, positive)
    if sign is None:
        above, below = sp.fraction(expression)
        inverse = above.is_positive and below.free_symbols
        condition = _compared(below, ">", positive) if inverse else _compared(expression, "≥", positive)
        if condition.lhs.is_positive and condition.rhs == 0:  # a − b where √a > √b is known
            return ()
        return (condition,)
    return () if sign >= 0 else None


def between_minus_one_and_one(value: sp.Expr) -> tuple[SignCondition, ...] | None:
    """The conditions under which |value| ≤ 1; None if that never holds."""
    numerator, denominator = sp.fraction(sp.together(value))
    if sign_of(denominator) == -1:
        numerator, denominator = -numerator, -denominator
    if (squares := _difference_of_squares(numerator, denominator)) is not None:
        return not_negative(squares)
    if sign_of(denominator) is None:  # d² − n² ≥ 0 has one factor of known sign: a/(a − l) with l > 0
        for one, other in ((1, -1), (-1, 1)):
            sign = sign_of(denominator + one * numerator)
            if sign in (1, -1):
                return not_negative(sign * (denominator + other * numerator))
        numerator, denominator = value, sp.S.One
    below, above = not_negative(denominator - numerator), not_negative(denominator + numerator)
    if below is None or above is None:
        return None
    if below and above:
        return (SignCondition(sp.Abs(value), "≤", sp.S.One),)
    return (*below, *above)


def _difference_of_squares(numerator: sp.Expr, denominator: sp.Expr) -> sp.Expr | None:
    """d² − n² where d is a root, and no root is left: 4 R² − (a + b)² for (a − b)/(2 √(R² − a b)); otherwise None."""
    if not any(f.is_Pow and f.exp == sp.S.Half and f.base.is_Add for f in sp.Mul.make_args(denominator)):
        return None
    squares = sp.expand(denominator**2 - numerator**2)
    return None if any(not p.exp.is_Integer for p in squares.atoms(sp.Pow)) else squares


def always_holds(c: SignCondition) -> bool:
    """Whether a condition always holds: 2/3 |cos α| ≤ 1, 3 ≥ 2 cos α, sin α ≠ 1, e^a ≥ e^b for a ≥ b."""
    if c.relation in ("≤", "<"):
        return always_holds(SignCondition(c.rhs, {"≤": "≥", "<": ">"}[c.relation], c.lhs))
    if c.relation == "≥" and all(isinstance(e, sp.exp) or e == 1 for e in (c.lhs, c.rhs)):
        return sign_of(sp.log(c.lhs) - sp.log(c.rhs)) in (0, 1)
    if c.relation == "≠" and c.rhs in (1, -1) and isinstance(c.lhs, sp.sin | sp.cos):  # sin α ≠ 1 of an acute angle
        return sign_in_range((sp.cos if isinstance(c.lhs, sp.sin) else sp.sin)(c.lhs.args[0])) is not None
    return c.relation in (">", "≥") and sign_of(c.lhs - c.rhs) == 1


def different_from_zero(expression: sp.Expr) -> tuple[SignCondition, ...]:
    """The condition that an expression is not zero; none if its sign is known."""
    sign = sign_of(expression)
    return (_compared(expression, "≠"),) if sign is None else ()


def _compared(expression: sp.Expr, relation: str, positive: tuple[sp.Expr, ...] = ()) -> SignCondition:
    """e ≥ 0 with the negative terms brought to the other side: k l ≥ m g."""
    primitive = _without_positive_factors(expression, positive)
    primitive = _without_positive_factors(_without_common_power(primitive), positive)
    primitive = (_without_root if relation != "≠" else _zero_without_root)(primitive, positive)
    primitive = _as_angles(primitive, positive)
    terms = sp.Add.make_args(sp.expand(primitive))
    left = [term for term in terms if not term.could_extract_minus_sign()]
    right = [-term for term in terms if term.could_extract_minus_sign()]
    if not left:
        return SignCondition(sp.Add(*right), {"≥": "≤", "≠": "≠", ">": "<"}[relation], sp.S.Zero)
    return SignCondition(sp.Add(*left), relation, sp.Add(*right))


def _as_angles(e: sp.Expr, positive: tuple[sp.Expr, ...]) -> sp.Expr:
    """β − α for sin β − cos β tan α of acute angles: what has the sign of the sine or cosine of a sum of angles."""
    waves = e.atoms(sp.sin, sp.cos, sp.tan)
    if len(waves) < 2 or not all(isinstance(s, Bounded) for w in waves for s in w.free_symbols):
        return e
    form = textbook_form(_without_positive_factors(in_sines(e), positive))
    wave = next((f for f in sp.Mul.make_args(form) if isinstance(f, sp.sin | sp.cos)), None)
    ends = range_of(wave.args[0]) if wave is not None and wave.args[0].is_Add else None
    sign = None if wave is None else sign_of(form / wave, positive)
    if wave is None or ends is None or sign not in (1, -1):
        return e
    angle = wave.args[0] if isinstance(wave, sp.sin) else sp.pi / 2 - wave.args[0]
    low, high = (ends.low, ends.high) if isinstance(wave, sp.sin) else (sp.pi / 2 - ends.high, sp.pi / 2 - ends.low)
    widest = sp.Max(-low, high)
    return sign * angle if widest < sp.pi or (widest == sp.pi and all(ends.strict)) else e


def _without_common_power(e: sp.Expr) -> sp.Expr:
    """a − b as a^p − b^p, of the same sign, where a and b have roots and that has none: b > c for ∛b > ∛c."""
    terms = e.args if e.is_Add and len(e.args) == 2 else ()
    signs = [sign_of(term) for term in terms]
    if sorted(s or 0 for s in signs) != [-1, 1]:
        return e
    powers = [[f.as_base_exp() for f in sp.Mul.make_args(s * term)] for s, term in zip(signs, terms, strict=True)]
    if not all(p.is_Rational and base.is_positive for factors in powers for base, p in factors):
        return e
    exponents = [p for factors in powers for base, p in factors if not base.is_number]
    if all(p.is_Integer for p in exponents):
        return e
    whole = lcm(*(int(p.q) for p in exponents))
    raised = sp.Rational(whole, gcd(*(int(p * whole) for p in exponents)))
    sides = [s * sp.Mul(*(base ** (p * raised) for base, p in f)) for s, f in zip(signs, powers, strict=True)]
    return sp.Add(*sides)


def _without_root(e: sp.Expr, positive: tuple[sp.Expr, ...]) -> sp.Expr:
    """A + B √D as a shorter expression of the same sign, where there is one: 8r − a − √(a² + 32r²) as 2r − a.

    With B < 0 and D ≥ 0, A + B √D ≥ 0 holds if and only if A ≥ 0 and A² − B² D ≥ 0. Without its positive factors let
    the latter be P. If A − λ P is never negative for some λ > 0, then P ≥ 0 implies A ≥ 0, and P ≥ 0 is all there is
    to say; the same holds with > for ≥. With B > 0 all of this holds for the opposite expression.
    """
    if (parts := _parts_at_root(e, positive)) is None:
        return e
    a, of_b, squares = parts
    opposite = -of_b
    shorter = count_operations(squares) < count_operations(e)
    return opposite * squares if shorter and _outweighs(opposite * a, squares, positive) else e


def _zero_without_root(e: sp.Expr, positive: tuple[sp.Expr, ...]) -> sp.Expr:
    """A + B √D as a shorter expression with the same zeros: 16r² − a² − a √(a² + 32r²) as 2r − a.

    It vanishes where A² − B² D does and A does not have the sign of B. If A² − B² D is, up to factors that do not
    vanish, linear in a symbol, one look at the sign of A at its zero decides.
    """
    if (parts := _parts_at_root(e, positive)) is None:
        return e
    a, of_b, squares = parts
    if count_operations(squares) >= count_operations(e):
        return e
    for x in sorted(squares.free_symbols, key=str):
        if squares.is_polynomial(x) and sp.degree(squares, x) == 1:
            slope, rest = sp.Poly(squares, x).all_coeffs()
            if sign_of(slope, positive) in (-1, 1):
                return squares if sign_of(a.xreplace({x: -rest / slope}), positive) == -of_b else e
    return e


def _parts_at_root(e: sp.Expr, positive: tuple[sp.Expr, ...]) -> tuple[sp.Expr, int, sp.Expr] | None:
    """A, the sign of B, and A² − B² D without its positive factors, of A + B √D with D ≥ 0; None of anything else."""
    roots = {p for term in sp.Add.make_args(e) for p in sp.Mul.make_args(term) if p.is_Pow and p.exp == sp.S.Half}
    if not e.is_Add or len(roots) != 1:
        return None
    [root] = roots
    a, b = e.xreplace({root: sp.S.Zero}), sp.expand(e).coeff(root)
    if sp.expand(e - a - b * root) != 0 or a.has(root) or b.has(root) or sign_of(root.base, positive) not in (0, 1):
        return None
    of_b = sign_of(b, positive)
    if of_b not in (-1, 1):
        return None
    return a, of_b, _without_positive_factors(sp.expand(a**2 - b**2 * root.base), positive)


def _outweighs(a: sp.Expr, p: sp.Expr, positive: tuple[sp.Expr, ...]) -> bool:
    """Whether a − λ p is never negative for 1 or a quotient of coefficients as λ."""
    of_p = sp.expand(p).as_coefficients_dict()
    of_a = sp.expand(a).as_coefficients_dict()
    scales = [sp.S.One, *(of_a[m] / c for m, c in of_p.items() if m in of_a and of_a[m] * c > 0)]
    return any(sign_of(sp.expand(a - scale * p), positive) in (0, 1) for scale in scales)


def more_than_zero(expression: sp.Expr, positive: Iterable[sp.Expr] = ()) -> SignCondition:
    """The condition that an expression is > 0."""
    return _compared(expression, ">", tuple(positive))


def _without_positive_factors(expression: sp.Expr, positive: tuple[sp.Expr, ...]) -> sp.Expr:
    """The expression divided by all factors that are certainly positive, which leaves its sign unchanged."""
    known = tuple(f for p in positive for f in (p, -p))
    kept = []
    sign = 1
    for factor in sp.Mul.make_args(_factored(expression)):
        base, exponent = factor.as_base_exp()
        if exponent.is_Rational and not exponent.is_Integer:
            continue  # a root is positive where it exists
        factor_sign = _of_factor(base, known)
        if not exponent.is_Integer:  # of e^(−r/a), and of a power r^n of what is positive, likewise
            kept += [] if exponent.is_real and (base.is_positive or factor_sign == 1) else [factor]
            continue
        if exponent % 2 == 0:
            kept += [] if base.is_real else [factor]
        elif factor_sign is None:
            kept.append(base)
        else:
            sign *= factor_sign
    return sign * sp.Mul(*kept)


# -- Whether an expression takes both signs: decided at points, in a fraction of the time that its factors would take --
#
# Two points with values of different signs show that an expression has no sign of its own. Values of one sign show
# nothing: the factors must decide.


@lru_cache(maxsize=1000)
def takes_both_signs(expression: sp.Expr, positive: tuple[sp.Expr, ...] = ()) -> bool:
    """Whether an expression takes both signs at the points tried, at which each of `positive` is positive."""
    if count_operations(expression) < SHORTEST_TRIED:
        return False
    graph, reals, seen = Graph(), Reals(Random(1)), set()
    for number in range(TRIED_POINTS):
        point = RealPoint(graph, reals, signs=number)
        try:
            if any(point.is_zero(p) or point.value(p) < 0 for p in positive):
                continue
            if not point.is_zero(expression):
                seen.add(bool(point.value(expression) > 0))
        except (InadmissibleError, DivisionByZeroError):
            continue
        except UnsupportedError:
            return False
        if len(seen) == 2:
            return True
    return False


def sign_on(e: sp.Expr, known: Sequence[sp.Expr]) -> int | None:
    """The sign of an expression, given others that are positive; None if it is not determined."""
    if e == 0 or is_zero(e):
        return 0
    return sign_of(e, known)


def bases(x: sp.Expr) -> Iterator[tuple[sp.Expr, bool]]:
    """The factors of an expression without their exponents, those under roots among them; whether exponents are odd."""
    for factor in sp.Mul.make_args(sp.factor(x) if count_operations(x) <= LARGEST_SIGNED else x):
        base, exponent = factor.as_base_exp()
        if exponent.is_Rational and not exponent.is_Integer:
            yield from ((f, False) for f, _ in bases(base))
        elif not base.is_number:
            yield base, bool(exponent.is_odd)
