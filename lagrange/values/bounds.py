"""Inequalities in numbers: with the values of a problem, W (tan α − μ)/(1 + μ tan α) ≤ P is P ≥ 5.767 N.

An inequality in which one symbol remains, or one sine, cosine, tangent or exponential of it, is solved for it if it is
linear in it, or a polynomial with one or two positive roots (the second part of this module). For an acute angle a
bound of its sine or tangent is one of the angle in the same sense, and of its cosine in the opposite one. A magnitude
bounds on both sides: |k s − m g sin α| ≤ μ m g cos α is 47 mm ≤ s ≤ 149 mm. A denominator is multiplied out where it is
positive. If nothing is left, the inequality holds or it does not.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.core.records import record
from lagrange.values.limits import MOST_DEGREES
from lagrange.values.quantities import NotRealError, Quantity, Values, real_value

_REVERSED = {"≤": "≥", "≥": "≤"}
_STRICT = {"≤": "<", "≥": ">"}
_INVERSE = {sp.sin: sp.asin, sp.cos: sp.acos, sp.tan: sp.atan}


@record
class AngleBound:
    """symbol relation value, in rad; where `relation` is ≤, `low` is a lower bound beside it."""

    symbol: sp.Symbol
    relation: str
    value: sp.Expr
    low: sp.Expr | None = None


@record
class Bound:
    """What an inequality says with the values: left relation bound.

    left     a symbol, or a function of one, tan θ; with nothing left to be bounded, the left side in numbers
    bound    a number, or the right side in numbers
    low      where `relation` is ≤, a lower bound beside it
    angle    the bound of θ itself, if θ is acute
    holds    whether it holds, where nothing is left in it; otherwise None
    """

    left: Quantity | sp.Expr
    relation: str
    bound: Quantity
    angle: AngleBound | None = None
    holds: bool | None = None
    low: Quantity | None = None


def bound_with(left: sp.Expr, right: sp.Expr, values: Values, relation: str = "≤") -> Bound | None:
    """left ≤ right, or <, with the values; None if they change nothing, it is not real with them, or an equation."""
    if relation == "=":
        return None
    bound = _bound_with(left, right, values)
    if relation == "≤" or bound is None:
        return bound
    if bound.holds is not None:
        return replace(bound, relation="<", holds=bound.holds and real_value(values.put_in(right - left)) > 0)
    angle = bound.angle and replace(bound.angle, relation=_STRICT[bound.angle.relation])
    return replace(bound, relation=_STRICT[bound.relation], angle=angle)


def _bound_with(left: sp.Expr, right: sp.Expr, values: Values) -> Bound | None:
    difference = right - left
    if not difference.free_symbols & values.numbers.keys():
        return None
    below, above = (values.quantity(e) for e in (left, right))
    in_numbers = values.put_in(difference)
    if in_numbers.has(sp.zoo, sp.nan, sp.oo):
        return None
    try:
        if not in_numbers.free_symbols:
            holds = bool(real_value(in_numbers) >= 0)
            return None if below is None or above is None else Bound(below, "≤", above, holds=holds)
        solved = _without_magnitude(difference, values)
    except NotRealError:
        return None
    if solved is not None or below is None or above is None:
        return solved
    return Bound(below, "≤", above)


def _without_magnitude(difference: sp.Expr, values: Values) -> Bound | None:
    """difference ≥ 0, in which a |L| with a negative factor stands for both L and −L, solved."""
    difference = _over_positive(difference, values)
    sizes = [f for f in difference.atoms(sp.Abs) if values.put_in(f).free_symbols]
    if not sizes:
        return _solved(difference, values.put_in(difference), values)
    letter = sp.Dummy(real=True)
    slope = sp.expand(values.put_in(difference).subs(values.put_in(sizes[0]), letter)).coeff(letter, 1)
    if len(sizes) > 1 or not slope.is_number or real_value(slope) >= 0:
        return None
    inside = sizes[0].args[0]
    cases = [difference.xreplace({sizes[0]: side * inside}) for side in (1, -1)]
    cases = [e for e in cases if not _always_holds(values.put_in(e))]
    solved = [_solved(e, values.put_in(e), values) for e in cases]
    if len(cases) == 1:
        return solved[0]
    below, above = ([b for b in solved if b is not None and b.relation == r] for r in "≥≤")
    if len(below) != 1 or len(above) != 1 or below[0].left != above[0].left:
        return None
    if real_value(below[0].bound.formula) > real_value(above[0].bound.formula):
        return None
    angles = [b.angle for b in (*below, *above) if b.angle is not None]
    if not angles:
        return replace(above[0], low=below[0].bound)
    if len(angles) == 1 or angles[0].relation == angles[1].relation:
        return None
    low, high = sorted(angles, key=lambda a: a.relation != "≥")
    return replace(above[0], low=below[0].bound, angle=replace(high, low=low.value))


def _over_positive(difference: sp.Expr, values: Values) -> sp.Expr:
    """The numerator of an expression whose denominator is positive with the values; otherwise the expression."""
    over, under = sp.fraction(sp.together(difference))
    in_numbers = values.put_in(under)
    waves = in_numbers.atoms(sp.sin, sp.cos, sp.tan)  # of acute angles, as everywhere here
    in_numbers = in_numbers.xreplace({f: sp.Dummy(positive=True) for f in waves if f.args[0].is_Symbol})
    letters = in_numbers.free_symbols
    if in_numbers == 0 or not all(s.is_positive for s in letters) or not in_numbers.is_polynomial(*letters):
        return difference
    rates = sp.Poly(in_numbers, *letters).coeffs() if letters else [in_numbers]
    if not all(r.is_number for r in rates):
        return difference
    signs = {real_value(r) > 0 for r in rates}
    return difference if len(signs) > 1 else over if signs.pop() else -over


def _solved(difference: sp.Expr, in_numbers: sp.Expr, values: Values) -> Bound | None:
    """difference ≥ 0 solved for the one quantity that is left; None if there are several, or it is not linear."""
    if len(in_numbers.free_symbols) != 1:
        return None
    [symbol] = in_numbers.free_symbols
    functions = [f for f in in_numbers.atoms(sp.sin, sp.cos, sp.tan) if f.args[0] == symbol]
    if not functions and (growth := _growth(symbol, in_numbers)) is not None:
        return _solved_for_exponent(symbol, growth, in_numbers)
    letter = sp.Dummy(real=True)
    wanted = functions[0] if len(functions) == 1 else symbol
    number, formula = (sp.expand(sp.together(e).xreplace({wanted: letter})) for e in (in_numbers, difference))
    slope, rest = number.coeff(letter, 1), number.coeff(letter, 0)
    if sp.expand(number - slope * letter - rest) != 0 or not slope.is_number or not rest.is_number:
        return _solved_for_power(symbol, in_numbers, values)
    sign = real_value(slope)
    if sign == 0:
        return None
    bound = values.quantity(sp.factor(-formula.coeff(letter, 0) / formula.coeff(letter, 1)))
    bound = Quantity(-rest / slope) if bound is None or not bound.is_number else bound
    relation = "≥" if sign > 0 else "≤"
    return Bound(wanted, relation, bound, _angle(wanted, relation, bound.formula))


def _always_holds(e: sp.Expr) -> bool:
    """Whether e ≥ 0 for every positive value of the one quantity that is left."""
    if len(e.free_symbols) != 1:
        return False
    ends = ends_of_one(e, *e.free_symbols)
    return ends is not None and ends.low is None and ends.high is None


def _solved_for_power(symbol: sp.Symbol, e: sp.Expr, values: Values) -> Bound | None:
    """e ≥ 0 that is not linear in the one quantity: 48 m/s for m v²/R, an angle for tan θ or sines with cosines."""
    limits = ends_of_one(e, symbol)
    if limits is None or (limits.low is None and limits.high is None):
        return None
    unit = values.unit_of(symbol) if limits.wanted == symbol else ""
    low, high = (None if end is None else Quantity(end, unit) for end in (limits.low, limits.high))
    bound, relation = (low, "≥") if high is None else (high, "≤")
    assert bound is not None
    angle = _angle(limits.wanted, relation, bound.formula)
    if angle is not None and low is not None and high is not None:
        other = _angle(limits.wanted, "≥", low.formula)
        ends = sorted((angle, other), key=lambda a: a.relation != "≥") if other is not None else []
        angle = replace(ends[1], low=ends[0].value) if ends else None
    return Bound(limits.wanted, relation, bound, angle, low=low if high is not None else None)


def _growth(symbol: sp.Symbol, e: sp.Expr) -> sp.Expr | None:
    """k, where the symbol occurs in e^(k x) only."""
    powers = [f for f in e.atoms(sp.exp) if symbol in f.free_symbols]
    if len(powers) != 1 or symbol in e.xreplace({powers[0]: sp.S.One}).free_symbols:
        return None
    rate = powers[0].args[0] / symbol
    return None if symbol in rate.free_symbols else rate


def _solved_for_exponent(symbol: sp.Symbol, growth: sp.Expr, e: sp.Expr) -> Bound | None:
    """A e^(k x) + B ≥ 0 as a bound of x: μ ≥ log(T_1/T_2)/β for a belt."""
    letter = sp.Dummy(positive=True)
    linear = sp.expand(e.xreplace({sp.exp(growth * symbol): letter}))
    slope, rest = linear.coeff(letter, 1), linear.coeff(letter, 0)
    if linear != sp.expand(slope * letter + rest) or slope == 0 or real_value(-rest / slope) <= 0:
        return None
    relation = "≥" if real_value(slope * growth) > 0 else "≤"
    return Bound(symbol, relation, Quantity(sp.log(-rest / slope) / growth))


def _angle(wanted: sp.Expr, relation: str, bound: sp.Expr) -> AngleBound | None:
    """θ ≥ 56.6° for tan θ ≥ 1.517 and 0 < θ < π/2; None if it says nothing in between."""
    if wanted.is_Symbol or real_value(bound) <= 0:
        return None
    if not isinstance(wanted, sp.tan) and real_value(bound) >= 1:
        return None
    turned = isinstance(wanted, sp.cos)
    return AngleBound(wanted.args[0], _REVERSED[relation] if turned else relation, _INVERSE[wanted.func](bound))


# -- Inequalities in one quantity that are not linear in it: A v² − B ≥ 0, A − B/tan θ ≥ 0, A sin θ − B cos θ ≥ 0 ------
#
# The quantity u > 0 is the symbol itself, if that is positive, or a function of it: of an acute angle the sine, the
# cosine, the tangent. Sines and cosines that occur in the same power throughout, A sin θ − B cos θ, are divided by
# that
# of the cosine, which is positive, and leave the tangent. Multiplied by its denominator where that is a power of u,
# the
# inequality is p(u) ≥ 0 with a polynomial p. With one simple positive root u_1 it says u ≥ u_1 or u ≤ u_1; with two,
# that u lies between them or outside, of which only the former is one statement.


@record
class NumberRange:
    """low ≤ wanted ≤ high; None if there is no such end. Without both, the inequality holds always."""

    wanted: sp.Expr
    low: sp.Expr | None
    high: sp.Expr | None


def ends_of_one(e: sp.Expr, symbol: sp.Symbol) -> NumberRange | None:
    """e ≥ 0 with numbers for all but one symbol; None if it is no statement of this kind."""
    waves = {f.func: f for f in e.atoms(sp.sin, sp.cos, sp.tan) if f.args[0] == symbol}
    letter = sp.Dummy(positive=True)
    if not waves:
        wanted = symbol
        if not symbol.is_positive:
            return None
    elif len(waves) == 1:
        [wanted] = waves.values()
    else:
        wanted = sp.tan(symbol)
        e = _by_tangent(e.xreplace({wanted: sp.sin(symbol) / sp.cos(symbol)}), symbol)
    above, below = sp.fraction(sp.together(e.xreplace({wanted: letter})))
    if (above.free_symbols | below.free_symbols) - {letter}:
        return None
    scale, power = sp.expand(below).as_independent(letter)
    if not above.is_polynomial(letter) or not (power == letter or power == 1 or power.as_base_exp()[0] == letter):
        return None
    function = sp.Poly(sp.expand(above / scale), letter)
    if not 0 < function.degree() <= MOST_DEGREES:
        return None
    return _where_positive(function, wanted)


def _by_tangent(e: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """The expression, over a power of the cosine, in tangents only; as it is where no power does that."""
    s, c, tangent = sp.Dummy(positive=True), sp.Dummy(positive=True), sp.tan(symbol)
    above, below = sp.fraction(sp.together(e.xreplace({sp.sin(symbol): s, sp.cos(symbol): c})))
    forms = [sp.Poly(part, s, c) if part.is_polynomial(s, c) else None for part in (above, below)]
    if any(f is None or not f.is_homogeneous for f in forms):
        return e
    return (above / below).subs({s: tangent, c: 1})


def _where_positive(function: sp.Poly, wanted: sp.Expr) -> NumberRange | None:
    """Where a polynomial is not negative for a positive quantity."""
    roots = sorted(set(map(real_value, _positive_roots(function))))
    grows = real_value(function.LC()) > 0
    if not roots and grows and _is_simple(function):
        return NumberRange(wanted, None, None)
    if len(roots) == 1:
        return NumberRange(wanted, roots[0], None) if grows else NumberRange(wanted, None, roots[0])
    if len(roots) == 2 and not grows:
        return NumberRange(wanted, roots[0], roots[1])
    return None


def _positive_roots(function: sp.Poly) -> list[sp.Expr]:
    """Its positive roots; none if some root is not simple, so that the sign changes at each."""
    if not _is_simple(function):
        return []
    return [sp.re(r) for r in function.nroots(n=30) if abs(sp.im(r)) < sp.Float("1e-20") and sp.re(r) > 0]


def _is_simple(function: sp.Poly) -> bool:
    return all(count == 1 or part.total_degree() == 0 for part, count in function.sqf_list()[1])
