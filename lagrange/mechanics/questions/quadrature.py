"""The time between two places, t = ∫ dq/q', where q' is a known function of q.

The integral is taken from a table (`algebra.forms.antiderivatives`), by parts of a product and of a power of one sum;
it is verified by differentiation. In the field of a centre, q'² is a quotient of polynomials and the integral that of a
polynomial over the root of a quadratic, as in Kepler's equation. A motion that begins at rest has a root in the
denominator, whose integral has a limit there. None means not in the table.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, sign_of
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.algebra.forms.antiderivatives import antiderivative
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, prime, t
from lagrange.mechanics.questions.branches import sign_of_value
from lagrange.mechanics.questions.forms import under_one_root
from lagrange.mechanics.questions.limits import ACCURATE, LONGEST_INTEGRATED, NODE_DIGITS, SHARE_DIGITS


def time_between(q: sp.Symbol, speed: sp.Expr, start: sp.Expr, end: sp.Expr, way: int) -> sp.Expr | None:
    """The positive time in which q goes from `start` to `end` in the direction `way`; None if it is not found."""
    place = sp.Dummy(q.name, positive=True)
    # |q'| is integrated over the distance already covered, so that its roots are real.
    away = start + way * place
    size = sp.factor((way * speed).xreplace({q: away}))
    if count_operations(size) > LONGEST_INTEGRATED:
        return None
    length = way * (end - start)
    for form in _forms(1 / size):
        time = _integral(form, place)
        if time is None:
            continue
        try:
            values = [factored_quotient(time.xreplace({place: x})) for x in (length, sp.S.Zero)]
            if any(v.has(sp.zoo, sp.nan, sp.oo) for v in values):
                continue
            if is_zero(time.diff(place) - 1 / size) is True:
                return shortest_form(factored_quotient(values[0] - values[1]))
        except DivisionByZeroError:
            continue
    time = _through_half_angle(q, speed**2, start, end)
    if time is None:
        time = _over_root_of_quadratic(q, speed**2, (start, end), way)
    changed = in_sine(q, speed**2, start, end) if time is None else None
    if changed is not None:
        time = _over_root_of_quadratic(changed.letter, changed.square, changed.ends, way)
    return time


def toward(speeds: Iterable[sp.Expr], q: sp.Symbol, ends: tuple[sp.Expr, sp.Expr], way: int | None) -> sp.Expr | None:
    """The first of several velocities, functions of q, that leads from the start in the direction `way`; None where
    there is none, or no way.

    Where its sign is not known everywhere, as of v/(L − a q), that at the start counts; from rest, that half way.
    """
    for v in speeds if way in (1, -1) else ():
        sign = sign_of_value(v)
        for place in (ends[0], (ends[0] + ends[1]) / 2):
            if sign is None:
                there = v.xreplace({q: place})
                sign = None if there.has(sp.zoo, sp.nan, sp.oo) else sign_of_value(there) or None
        if sign in (way, None):
            return v
    return None


def speed_stated(
    when: Sequence[sp.Expr],
    accelerations: Mapping[sp.Symbol, sp.Expr],
    initial: Mapping[sp.Symbol, sp.Expr],
    slots: Slots,
) -> tuple[sp.Symbol, sp.Expr, sp.Expr, sp.Expr] | None:
    """v, v' as a function of v alone, v_0 and v_1, where the condition is v = v_1; None if it is no such motion."""
    moving = {*slots.coordinates, *slots.velocities, t}
    speeds = when[0].free_symbols & {*slots.velocities} if len(when) == 1 else set()
    if len(speeds) != 1:
        return None
    [v] = speeds
    rate, slope = accelerations.get(prime(v)), sp.expand(when[0]).coeff(v, 1)
    if rate is None or v not in initial or rate.free_symbols & moving != {v} or slope.free_symbols & moving:
        return None
    end = sp.cancel(v - when[0] / slope)
    return None if end.free_symbols & moving else (v, rate, initial[v], end)


def time_between_speeds(
    v: sp.Symbol, rate: sp.Expr, start: sp.Expr, end: sp.Expr, weight: sp.Expr = sp.S.One
) -> sp.Expr | None:
    """∫ w dv/v' from one speed to another, for one sense of v; None if it is not found."""
    size = sp.Dummy(v.name, positive=True)
    sense = 1 if sign_of(start) == 1 or (start == 0 and sign_of(end) == 1) else -1
    if sign_of(sense * start) not in (0, 1) or sign_of(sense * end) not in (0, 1):
        return None
    inverse = sp.factor(sense * (weight / rate).xreplace({v: sense * size}))
    if count_operations(inverse) > LONGEST_INTEGRATED or (time := _integral(inverse, size)) is None:
        return None
    values = [factored_quotient(time.xreplace({size: sense * x})) for x in (end, start)]
    if any(x.has(sp.zoo, sp.nan, sp.oo) for x in values) or is_zero(time.diff(size) - inverse) is not True:
        return None
    return shortest_form(factored_quotient(values[0] - values[1]))


def taken_between_speeds(
    v: sp.Symbol,
    rate: sp.Expr,
    start: sp.Expr,
    end: sp.Expr,
    values: Mapping[sp.Symbol, sp.Expr],
    is_time: bool = True,
) -> tuple[sp.Expr, tuple[SignCondition, ...]] | None:
    """The same time, or the way ∫ v dv/v', with the condition that v goes from one to the other; None if it is not
    found.
    """
    way = sign_of(rate.xreplace({v: start}))
    if way is None or (taken := time_between_speeds(v, rate, start, end, sp.S.One if is_time else v)) is None:
        return None
    is_later = sign_of_value(way * (end - start).xreplace(dict(values))) == 1
    return taken, () if is_later else (more_than_zero(way * (end - start)),)


def number_between(
    q: sp.Symbol, speed: sp.Expr, start: sp.Expr, end: sp.Expr, values: Mapping[sp.Symbol, sp.Expr]
) -> sp.Float | None:
    """The time in numbers, where all parameters have values; None if one is missing, or it is not accurate.

    A motion that begins or ends at rest has a singularity 1/√x there, which this rule (tanh-sinh) integrates.
    """
    share = sp.Dummy("u", positive=True)  # of the way, from 0 to 1: precise near the start, where the root vanishes
    way = end - start
    e = (way / speed).xreplace({q: start + way * share}).xreplace(dict(values))
    if not e.free_symbols <= {share}:
        return None

    def integrand(x: mpmath.mpf) -> mpmath.mpf:
        value = e.xreplace({share: sp.Float(str(x), NODE_DIGITS)}).evalf(NODE_DIGITS)
        if not value.is_Float:
            raise ValueError
        return mpmath.mpf(str(value))

    with mpmath.workdps(NODE_DIGITS // 2):
        try:
            number, error = mpmath.quad(integrand, [0, 1], error=True, maxdegree=6)
        except (ValueError, ZeroDivisionError):
            return None
        return sp.Float(str(number), 6) if error < abs(number) * ACCURATE else None


def share_between(q: sp.Symbol, speed: sp.Expr, start: sp.Expr, end: sp.Expr) -> sp.Expr | None:
    """The time as a number times a product of letters, where all of these come in front of the integral over the share
    of the way that is covered, as in a field whose force is a power of the distance; None if they do not.
    """
    share = sp.Dummy("u", positive=True)
    way = end - start
    squared = (way / speed.xreplace({q: start + way * share})) ** 2
    if count_operations(squared) > LONGEST_INTEGRATED:
        return None
    squared = sp.factor(sp.together(squared))
    letters, numbers = squared.as_independent(share, as_Add=False)
    if numbers.free_symbols != {share} or sign_of(letters) not in (1, -1):
        return None
    if sign_of(letters) == -1:
        letters, numbers = -letters, -numbers
    number = number_between(share, 1 / sp.sqrt(numbers), sp.S.Zero, sp.S.One, {})
    if number is None:
        return None
    constant, product = sp.factor(letters).as_coeff_Mul()
    return (number * sp.sqrt(constant)).evalf(SHARE_DIGITS) * factored_quotient(sp.sqrt(product))


def not_elementary(
    integrand: tuple[sp.Symbol, sp.Expr, sp.Expr, sp.Expr], way: int, values: Mapping[sp.Symbol, sp.Expr]
) -> tuple[sp.Expr | None, sp.Integral]:
    """The time in numbers, where that is possible, and as an integral over 1/|q'| from the smaller place to the larger.

    integrand  q, q' as a function of it, q_0 and q_1
    """
    q, speed, start, end = integrand
    number = number_between(*integrand, values)
    low, high = (start, end) if way == 1 else (end, start)
    whole = sp.Integral(sp.Pow(under_one_root(way * speed), -1, evaluate=False), (q, low, high))
    return share_between(*integrand) if number is None else number, whole


def _through_half_angle(q: sp.Symbol, square: sp.Expr, start: sp.Expr, end: sp.Expr) -> sp.Expr | None:
    """∫ dq/√f with S = sin(q/2) or cos(q/2) as variable, where it is ∫ dS/√(B (S_0² − S²)) = acos(S/S_0)/√B.

    So on a cycloid, where S is proportional to the arc: the time to its lowest point is the same from everywhere.
    """
    letter = sp.Dummy(positive=True)
    for function, cosine in ((sp.sin, 1 - 2 * letter**2), (sp.cos, 2 * letter**2 - 1)):
        in_letter = sp.expand_trig(square).xreplace({sp.cos(q): cosine})
        if q in in_letter.free_symbols:
            continue
        places = [sp.sin(x / 2) if function is sp.sin else sp.cos(x / 2) for x in (start, end)]
        rate = sp.cancel(sp.together(in_letter * (1 - letter**2) / 4))  # (dS/dt)²
        if not rate.is_polynomial(letter) or sp.degree(rate, letter) != 2 or rate.coeff(letter, 1) != 0:
            continue
        stiffness = sp.factor(-sp.expand(rate).coeff(letter, 2))
        energy = sp.expand(rate).coeff(letter, 0)
        if is_zero(energy - stiffness * places[0] ** 2) is not True or sign_of(stiffness) != 1:
            continue  # from rest, so that S = S_0 cos(√B t), whatever the sign of S_0
        return shortest_form(sp.acos(sp.cancel(places[1] / places[0])) / sp.sqrt(stiffness))
    return None


@record
class InSine:
    """S, (dS/dt)² as a function of it, and its values at both ends."""

    letter: sp.Symbol
    square: sp.Expr
    ends: tuple[sp.Expr, sp.Expr]


def in_sine(q: sp.Symbol, square: sp.Expr, start: sp.Expr, end: sp.Expr) -> InSine | None:
    """q'² = f(q) with S = sin(c q) as variable: (dS/dt)² = c² (1 − S²) f, as in the well U_0 tan²(a x), whose period is
    elementary (Landau and Lifshitz, Mechanics, § 11).

    None where f is no rational function of S and cos²(c q), or S does not increase between the ends.
    """
    rates = {f.args[0].diff(q) for f in square.atoms(sp.sin, sp.cos, sp.tan, sp.cot)}
    if len(rates) != 1 or count_operations(square) > LONGEST_INTEGRATED:
        return None
    [rate] = rates
    rising = all(sign_of(sp.cos(rate * x)) in (0, 1) for x in (start, end)) and sign_of(rate) == 1
    letter, cosine = sp.Dummy("S", real=True), sp.Dummy()
    plain = square.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)).replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x))
    plain = plain.xreplace({sp.sin(rate * q): letter, sp.cos(rate * q): cosine})
    parts = sp.fraction(sp.together(plain))
    if not rising or q in plain.free_symbols or not all(p.is_polynomial(cosine) for p in parts):
        return None
    terms = [sp.Poly(p, cosine).terms() for p in parts]
    if any(n % 2 for several in terms for (n,), _ in several):
        return None
    above, below = (sp.Add(*(c * (1 - letter**2) ** (n // 2) for (n,), c in several)) for several in terms)
    changed = sp.factor(sp.together(rate**2 * (1 - letter**2) * above / below))
    return InSine(letter, changed, (sp.sin(rate * start), sp.sin(rate * end)))


def _over_root_of_quadratic(q: sp.Symbol, square: sp.Expr, ends: tuple[sp.Expr, sp.Expr], way: int) -> sp.Expr | None:
    """q'² = k N/D: with N D = S² T and D/S = a q + b, T = ρ² − (q − c)², the time is

    ∫ (D/S) dq/√(k T) = [−a √T − (a c + b) acos((q − c)/ρ)]/√k .
    """
    quotient = sp.fraction(sp.together(square))
    if not all(e.is_polynomial(q) for e in quotient):
        return None
    over, under = (sp.factor_list(e, q) for e in sp.fraction(sp.cancel(quotient[0] / quotient[1])))
    k, odd, rest = sp.cancel(over[0] / under[0]), sp.S.One, sp.S.One
    for factor, power in (*over[1], *((f, -n) for f, n in under[1])):
        if q not in factor.free_symbols:
            k *= factor**power
            continue
        odd *= factor ** (power % 2)
        rest *= factor ** ((power % 2 - power) // 2)  # D/S
    if not odd.is_polynomial(q) or not rest.is_polynomial(q):
        return None
    root, linear = sp.Poly(odd, q), sp.Poly(rest, q)
    leading = root.LC()
    signs = {sign_of(rest.xreplace({q: x})) for x in ends} - {0}
    sign = signs.pop() if len(signs) == 1 else None
    if root.degree() != 2 or linear.degree() > 1 or sign_of(-k * leading) != 1 or sign is None:
        return None
    k, center = -k * leading, sp.cancel(-root.coeff_monomial(q) / (2 * leading))
    radius = sp.sqrt(sp.factor(center**2 - root.coeff_monomial(1) / leading))
    a, b = linear.coeff_monomial(q), linear.coeff_monomial(1)

    def at(x: sp.Expr) -> sp.Expr:
        height = sp.sqrt(sp.factor(-odd.xreplace({q: x}) / leading))
        return -a * height - (a * center + b) * sp.acos(sp.cancel((x - center) / radius))

    return shortest_form(way * sign * (at(ends[1]) - at(ends[0])) / sp.sqrt(sp.factor(k)))


def _forms(e: sp.Expr) -> Iterator[sp.Expr]:
    yield sp.powsimp(e)
    yield sp.expand(e)
    yield sp.powdenest(e, force=False)


def _integral(e: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    share, rest = e.as_independent(x, as_Add=False)
    base, exponent = rest.as_base_exp()
    if base.is_polynomial(x) and sp.degree(base, x) == 1 and exponent.is_Rational and exponent != -1:
        return share * base ** (exponent + 1) / ((exponent + 1) * base.diff(x))
    integral = antiderivative(rest, x)
    return None if integral is None else share * integral
