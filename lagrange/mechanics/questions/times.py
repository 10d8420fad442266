"""The time at which a condition holds, for motions in closed form.

    powers of t                         the roots of a polynomial
    A cos ωt + B sin ωt + C = 0         the first root after t = 0, where the signs determine it
    e^{λt}, cosh λt, sinh λt            a polynomial in E = e^{λt}, or e^{rt} times one; t = log(E)/λ
    A log(u(t)) + B = 0                 u(t) = e^{−B/A}

Roots that are certainly not positive are not listed.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import (
    factored_quotient,
    irreducible_factors,
    numerator,
    polynomial_roots,
)
from lagrange.algebra.closed_forms.signs import (
    SignCondition,
    between_minus_one_and_one,
    more_than_zero,
    sign_of,
)
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import t
from lagrange.mechanics.questions.branches import sign_of_value
from lagrange.mechanics.questions.forms import with_whole_logarithms
from lagrange.mechanics.questions.limits import LONGEST_EQUATION
from lagrange.mechanics.questions.results import AnswerBranch


@record
class TimeRoot:
    """A time, and the conditions under which it is real and positive; `certain` where it is positive in any case."""

    value: sp.Expr
    conditions: tuple[SignCondition, ...] = ()
    certain: bool = False


def times(equation: sp.Expr, positive: bool = True) -> list[TimeRoot] | None:
    """The positive roots, of a periodic function the first; None if they are not found in closed form.

    positive  whether roots of unknown sign get the condition that they are positive; what is negative is never a root
    """
    if count_operations(equation) > LONGEST_EQUATION:
        return None
    above, _ = sp.fraction(sp.together(equation))
    for form in (sp.expand(equation), sp.expand(above)):
        roots = _without_logarithm(form)
        if roots is not None:
            if positive:
                return [r for r in map(_positive, roots) if r is not None]
            return [r for r in roots if _sign(r) != -1]
    return None


def _sign(root: TimeRoot) -> int | None:
    """The sign of a real root; the square roots in it are not negative."""
    sign = 1 if root.certain else sign_of_value(root.value)
    return sign_of_value(_without_square_roots(root.value)) if sign is None else sign


def _positive(root: TimeRoot) -> TimeRoot | None:
    """The root with the condition that it is positive, where that is open; None if it is not."""
    sign = _sign(root)
    if sign in (0, -1):
        return None
    if sign is None:
        excess = _excess_in_logarithm(root.value)
        if sign_of(excess) in (0, -1):
            return None
        condition = more_than_zero(excess)
        if condition not in root.conditions:
            return TimeRoot(root.value, (*root.conditions, condition))
    return root


def after_start(b: AnswerBranch, time: sp.Expr, parameter: sp.Symbol) -> AnswerBranch | None:
    """The part of a branch, of a parameter that is asked for, in which a time is not certainly before or at the start.

    A ball that is thrown at right angles to a slope moves at right angles to it at t = 0, where it is on the slope too.
    """
    kept = []
    in_angles = sp.expand_trig(time)
    for state in b.states:
        named = {str(s): e for s, e in state.items()}
        rule = {f: named[str(f)] for f in (parameter, sp.cos(parameter), sp.sin(parameter)) if str(f) in named}
        functions = {f: e for f, e in rule.items() if f != parameter}
        value = factored_quotient(in_angles.xreplace(functions).xreplace(rule))
        if is_zero(value) is not True and sign_of_value(value) != -1:
            kept.append(state)
    return b.at(kept) if kept or not b.states else None


def _without_square_roots(value: sp.Expr) -> sp.Expr:
    """What has the sign of a real product: its factors without the roots √e and 1/√e, which are not negative.

    With i among the factors one root is that of a negative number: i/√e = 1/√(−e), i √e = −√(−e).
    """
    half = (sp.S.Half, -sp.S.Half)
    roots = [f for f in sp.Mul.make_args(value) if f.is_Pow and f.exp in half]
    rest = sp.Mul(*(f for f in sp.Mul.make_args(value) if f not in roots))
    if not rest.has(sp.I):
        return rest
    negative = [f for f in roots if not f.base.is_positive]
    return -sp.I * rest * (-2 * negative[0].exp) if len(negative) == 1 else value


def _excess_in_logarithm(value: sp.Expr) -> sp.Expr:
    """What has the sign of a value: E − 1 for c log E, where c has a sign; the value itself for any other."""
    logs = list(value.atoms(sp.log))
    share = value / logs[0] if len(logs) == 1 else sp.S.Zero
    sign = None if share.has(sp.log) else sign_of(share)
    if sign not in (1, -1):
        return value
    above, below = sp.fraction(sp.together(logs[0].args[0]))
    excess = sign * sp.factor(above - below)
    return excess if sign_of(below) == 1 else excess / below


def _without_logarithm(e: sp.Expr) -> list[TimeRoot] | None:
    logs = [f for f in e.atoms(sp.log) if t in f.free_symbols]
    if len(logs) > 1:
        return None
    if logs:
        [log] = logs
        slope = e.coeff(log, 1)
        rest = sp.expand(e - slope * log)
        if t in (slope.free_symbols | rest.free_symbols) or slope == 0:
            return None
        return _without_logarithm(sp.expand(log.args[0] - sp.exp(factored_quotient(-rest / slope))))
    if e.has(sp.cos, sp.sin) and any(t in f.free_symbols for f in e.atoms(sp.cos, sp.sin)):
        return _of_waves(e)
    if any(t in f.free_symbols for f in e.atoms(sp.exp, sp.cosh, sp.sinh)):
        return _of_exponentials(e)
    return _of_polynomial(e)


def _of_polynomial(e: sp.Expr) -> list[TimeRoot] | None:
    if not e.is_polynomial(t):
        return None
    parts = numerator(e)
    pieces = irreducible_factors(parts[0]) if parts is not None else None
    if pieces is None:
        return None
    roots: list[TimeRoot] = []
    for piece in pieces:
        if t not in piece.free_symbols:
            continue
        values = polynomial_roots(piece, t)
        if values is None:
            return None
        roots += [TimeRoot(v.value, v.conditions) for v in values]
    return roots


def _of_waves(e: sp.Expr) -> list[TimeRoot] | None:
    """A cos ωt + B sin ωt + C = 0, and a product of this with what has no roots."""
    common = sp.factor_terms(e)
    factors_with_time = [f for f in sp.Mul.make_args(common) if t in f.free_symbols and not isinstance(f, sp.exp)]
    if len(factors_with_time) != 1:
        return None
    e = sp.expand(factors_with_time[0].as_base_exp()[0])
    waves = [f for f in e.atoms(sp.cos, sp.sin) if t in f.free_symbols]
    frequencies = {sp.expand(f.args[0]) for f in waves}
    if len(frequencies) != 1:
        return None
    [phase] = frequencies
    w = phase.diff(t)
    if phase.xreplace({t: sp.S.Zero}) != 0 or t in w.free_symbols or sign_of(w) not in (1, -1):
        return None
    a, b = e.coeff(sp.cos(phase), 1), e.coeff(sp.sin(phase), 1)
    c = sp.expand(e - a * sp.cos(phase) - b * sp.sin(phase))
    if any(t in x.free_symbols for x in (a, b, c)):
        return None
    return _first_of_wave(sp.factor(a), sp.factor(b), sp.factor(c), sp.Abs(w))


def _first_of_wave(a: sp.Expr, b: sp.Expr, c: sp.Expr, w: sp.Expr) -> list[TimeRoot] | None:
    """The first positive root of a cos ωt + b sin ωt + c = 0."""
    if b == 0:
        ratio = factored_quotient(-c / a)
        conditions = between_minus_one_and_one(ratio)
        if conditions is None:
            return []
        if ratio == 1:
            return [TimeRoot(2 * sp.pi / w)]
        return [TimeRoot(sp.acos(ratio) / w, conditions)]
    if a == 0 and c == 0:
        return [TimeRoot(sp.pi / w)]
    if a == 0:
        ratio = factored_quotient(-c / b)
        conditions = between_minus_one_and_one(ratio)
        if conditions is None:
            return []
        sign = sign_of_value(ratio)
        if sign is None:
            return None
        return [TimeRoot((sp.asin(ratio) if sign > 0 else sp.pi - sp.asin(ratio)) / w, conditions)]
    if c == 0:
        tangent = factored_quotient(-a / b)
        sign = sign_of_value(tangent)
        if sign is None:
            return None
        return [TimeRoot((sp.atan(tangent) if sign > 0 else sp.pi + sp.atan(tangent)) / w)]
    if is_zero(a + c):  # it holds at t = 0: a (cos − 1) + b sin = 0, tan(ωt/2) = b/a
        tangent = factored_quotient(b / a)
        sign = sign_of_value(tangent)
        if sign is None:
            return None
        return [TimeRoot(2 * (sp.atan(tangent) if sign > 0 else sp.pi + sp.atan(tangent)) / w)]
    return None


def _of_exponentials(e: sp.Expr) -> list[TimeRoot] | None:
    """A sum of c e^{rt} that is a polynomial in E = e^{λt} and 1/E, as it stands or divided by one of e^{rt}."""
    e = sp.expand(e.replace(lambda f: isinstance(f, sp.cosh | sp.sinh), lambda f: f.rewrite(sp.exp, deep=False)))
    shares: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(e):
        share, rest = term.as_independent(t, as_Add=False)
        exponent = sp.expand(rest.args[0]) if isinstance(rest, sp.exp) else sp.S.Zero if rest == 1 else None
        if exponent is None or t in exponent.diff(t).free_symbols or exponent.xreplace({t: sp.S.Zero}) != 0:
            return None
        rate = exponent.diff(t)
        shares[rate] = shares.get(rate, sp.S.Zero) + share
    if not any(shares):  # the exponentials cancel, as in cosh² − sinh²
        return [] if is_zero(e) is False else None
    for base in dict.fromkeys((sp.S.Zero, *shares)):
        rates = {r: sp.expand(r - base) for r in shares}
        first = min((r for r in rates.values() if r != 0), key=lambda r: (count_operations(r), str(r)))
        ratios = {r: sp.cancel(difference / first) for r, difference in rates.items()}
        if all(q.is_Integer for q in ratios.values()):
            letter = sp.Dummy("E", positive=True)
            polynomial = sp.Add(*(share * letter ** ratios[r] for r, share in shares.items()))
            pieces = irreducible_factors(sp.expand(sp.fraction(sp.together(polynomial))[0]))
            return None if pieces is None else _logarithms(pieces, letter, first)
    return None


def _logarithms(pieces: list[sp.Expr], letter: sp.Symbol, rate: sp.Expr) -> list[TimeRoot] | None:
    roots: list[TimeRoot] = []
    for piece in pieces:
        if letter not in piece.free_symbols:
            continue
        values = polynomial_roots(piece, letter)
        if values is None:
            return None
        for v in values:
            sign = sign_of_value(v.value)
            if sign in (0, -1):
                continue
            below = () if sign == 1 else (more_than_zero(v.value),)
            conditions = tuple(dict.fromkeys((*v.conditions, *below)))
            time = with_whole_logarithms(factored_quotient, _logarithm(v.value) / rate)
            roots.append(TimeRoot(time, conditions))
        if len(values) == 2 and len(roots) == 2 and is_zero(values[0].value * values[1].value - 1):
            larger = sign_of_value(values[0].value - values[1].value)
            rising = sign_of(rate)
            if larger in (1, -1) and rising in (1, -1):  # E and 1/E: times of opposite signs
                kept = roots[0] if larger == rising else roots[1]
                roots = [TimeRoot(kept.value, kept.conditions, certain=True)]
    return roots


def _logarithm(value: sp.Expr) -> sp.Expr:
    """The logarithm of a positive value; log(a/b)/2 for that of √a/√b, where a and b may both be negative."""
    above, below = ([f.base for f in sp.Mul.make_args(part) if f.is_Pow and f.exp == sp.S.Half]
                    for part in sp.fraction(value))  # fmt: skip
    if not any(e.is_Add for e in above) or not any(e.is_Add for e in below):
        return sp.log(value)
    letters = {s: sp.Dummy(s.name, positive=True) for s in value.free_symbols if s.is_positive}  # √c is a letter
    back = {letter: sp.sqrt(s) for s, letter in letters.items()}
    square = sp.factor(sp.cancel(sp.together((value**2).xreplace({s: letter**2 for s, letter in letters.items()}))))
    square = square.xreplace(back)
    return sp.log(value) if square.has(*(sp.sqrt(e) for e in (*above, *below) if e.is_Add)) else sp.log(square) / 2


def fades(e: sp.Expr) -> bool:
    """Whether a function of time vanishes in the limit t → ∞, and only there, because exponentials decay."""
    limit = limit_in_time(e)
    return limit is not None and is_zero(limit) is True


def limit_in_time(e: sp.Expr) -> sp.Expr | None:
    """The limit for t → ∞ of a function of decaying exponentials, tanh x among them; None for others.

    e^{−rt} is a letter that becomes zero: waves and powers of t beside it do not matter, but must not stand alone.
    """
    if count_operations(e) > LONGEST_EQUATION:
        return None
    e = e.replace(lambda f: isinstance(f, sp.cosh | sp.sinh | sp.tanh), lambda f: f.rewrite(sp.exp, deep=False))
    waves = [f for f in e.atoms(sp.exp) if t in f.free_symbols]
    letters: dict[sp.Expr, sp.Expr] = {}
    for f in waves:
        rate = sp.factor(f.args[0].diff(t))
        sign = sign_of(rate)
        if t in rate.free_symbols or sign not in (1, -1) or f.args[0].xreplace({t: sp.S.Zero}) != 0:
            return None
        decay = sp.expand(sign * rate)
        letter = letters.setdefault(decay, sp.Dummy(positive=True))
        e = e.xreplace({f: letter ** (-sign)})
    above, below = sp.fraction(sp.cancel(sp.together(e))) if letters else (e, sp.S.One)
    gone = dict.fromkeys(letters.values(), sp.S.Zero)
    if t in below.free_symbols or not letters or below.xreplace(gone) == 0:
        return None
    limit = above.xreplace(gone) / below.xreplace(gone)
    bounded = above.xreplace(dict.fromkeys(above.atoms(sp.cos, sp.sin), sp.S.One))
    return limit if t not in limit.free_symbols and bounded.is_polynomial(t, *gone) else None


def in_order(roots: list[TimeRoot]) -> Iterator[TimeRoot]:
    """The first of several roots where the order is known; all of them otherwise."""
    for r in roots:
        if all(o is r or sign_of_value(o.value - r.value) in (0, 1) for o in roots):
            yield r
            return
    yield from roots


def keeps_sign(rate: sp.Expr, sense: int, root: TimeRoot) -> bool:
    """Whether a velocity keeps the sign of the start, with which |q'| was replaced, up to a time."""
    turns = times(rate)
    if turns is None:
        return False
    if all(sign_of_value(turn.value - root.value) in (0, 1) for turn in turns):
        return True
    return sign_of_value(sense * rate.xreplace({t: root.value})) in (0, 1)
