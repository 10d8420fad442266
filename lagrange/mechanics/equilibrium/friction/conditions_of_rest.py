"""Conditions of rest as they are written: tan α ≤ μ_s, and not m g sin α − μ_s m g cos α ≤ 0.

Factors of known sign are divided out. A condition that is linear in an unknown force, or in one coefficient of
friction, or in a load, is solved for it; otherwise terms with a minus sign are taken to the left. If all terms have the
same degree in sin θ and cos θ, they are divided by cos θ and written in tan θ.

The limits between which one unknown force must lie for a system with several rough contacts to be at rest.

With the equations of balance solved, all bounds are linear in the forces s that remain and in the force P:

    c_i + p_i P + Σ_j a_ij s_j ≥ 0 ,     i = 1 ... m .

If y ≥ 0 and Σ_i y_i a_ij = 0 for every j, then Σ y_i c_i + P Σ y_i p_i ≥ 0 limits P, from above or from below (Farkas).
A set of as many bounds as there are s, and one, has one such y: its minors. The sharpest of these limits is attained if
the forces at which these bounds are equalities satisfy all the others; then P may have every value between the two
limits, since what is admissible is convex.

These sets are chosen at sampled numbers: acute angles and coefficients of friction that are not large, or the values of
the file. That y and the other bounds are not negative is then proved symbolically, as far as it holds for all angles;
the rest becomes conditions under which these are the limits. Different numbers may lead to different sets: these are
the cases of the result. Elimination by pairs (`linear_inequalities`) would need the signs of all coefficients on the
way; with three contacts these have dozens of cases.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import with_differences_of_squares, without_leading_minus
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import sign_in_range
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Inequality, Signs, is_implied, shortest
from lagrange.mechanics.equilibrium.limits import DRAWS_OF_LIMITS, MOST_BOUND_SETS, MOST_REGIMES, SMALL_BOUND
from lagrange.mechanics.equilibrium.searched.newton import NoTapeError, Tape


@record
class RestCondition:
    """left ≤ right; left < right or left = right if `relation` says so."""

    left: sp.Expr
    right: sp.Expr
    relation: str = "≤"

    @property
    def admits_limit(self) -> bool:
        """Whether it may hold where both sides are equal."""
        return self.relation != "<"


def bounded_by(
    friction: Sequence[sp.Expr], pressed: sp.Expr, coefficient: sp.Expr, signed: bool, signs: Signs
) -> list[RestCondition] | None:
    """|F| ≤ μ N, or μ |N| unless `signed`; None if it never holds."""
    friction, pressed = [_without_moduli(f) for f in friction], _without_moduli(pressed)
    sign = signs.of(pressed)
    if signed and sign == -1:
        return None
    size = friction[0] if len(friction) == 1 else sp.sqrt(shortest(sp.Add(*(f**2 for f in friction))))
    sense = signs.of(size)
    if sense == 0:
        return not_negative(pressed, SolvedFor(), signs) if signed else []
    size = size * sense if sense is not None else sp.Abs(size)
    if sign in (1, -1):
        return [RestCondition(_ratio(size, pressed * sign, signs), coefficient)]
    inside = size.args[0] if isinstance(size, sp.Abs) else size
    for factor in (f for f in sp.Mul.make_args(pressed) if f.is_positive):  # m g |sin θ| ≤ μ m g cos θ
        shorter = sp.cancel(inside / factor)
        if count_operations(shorter) < count_operations(inside):
            inside, pressed = sp.factor(shorter), pressed / factor
    size = sp.Abs(inside) if isinstance(size, sp.Abs) else inside
    if not signed:
        return [RestCondition(size, coefficient * sp.Abs(pressed))]
    below = sp.fraction(pressed)[1]
    if sense is not None and below.free_symbols and signs.of(below) in (1, -1):
        return not_negative(coefficient * pressed - size, SolvedFor(), signs)
    return [RestCondition(size, coefficient * pressed)]


def _ratio(size: sp.Expr, pressed: sp.Expr, signs: Signs) -> sp.Expr:
    """|F|/N with what is positive in front of the modulus."""
    moduli = [f for f in sp.Mul.make_args(size) if isinstance(f, sp.Abs)]
    if not moduli:
        return with_differences_of_squares(_in_tangents(shortest(size / pressed)))
    outside: list[sp.Expr] = []
    inside: list[sp.Expr] = []
    bare = size.xreplace({m: m.args[0] for m in moduli})
    number, factors = shortest(bare / pressed).as_coeff_Mul()
    for factor in sp.Mul.make_args(factors):
        (outside if signs.of(factor.as_base_exp()[0]) == 1 else inside).append(factor)
    return sp.Abs(number) * _in_tangents(sp.Mul(*outside)) * sp.Abs(_in_tangents(sp.Mul(*inside)))


def _without_moduli(e: sp.Expr) -> sp.Expr:
    """cos α for |cos α| where α is acute."""
    moduli = {m: sign_in_range(m.args[0]) for m in e.atoms(sp.Abs)}
    known = {m: sense * m.args[0] for m, sense in moduli.items() if sense is not None}
    return shortest(e.xreplace(known)) if known else e


@record
class SolvedFor:
    """What conditions are solved for: unknown forces first, then coefficients of friction, then loads."""

    forces: tuple[sp.Expr, ...] = ()
    coefficients: tuple[sp.Expr, ...] = ()
    loads: tuple[sp.Expr, ...] = ()


def positive(slack: sp.Expr, wanted: SolvedFor, signs: Signs) -> list[RestCondition]:
    """slack > 0, as it is written; nothing if it always holds."""
    return [replace(c, relation="<") for c in not_negative(slack, wanted, signs)]


def vanishing(e: sp.Expr, wanted: SolvedFor, signs: Signs) -> list[RestCondition]:
    """e = 0, as it is written, with a letter that it is solved for on the left."""
    numerator = sp.fraction(sp.together(e))[0]
    if numerator.is_number and not e.is_number:
        return [RestCondition(e, sp.S.Zero, "=")]  # 1/(h − x): it never holds
    solved = (_letter_first(c) for c in not_negative(numerator, wanted, signs))
    return [replace(c, relation="=") for c in solved]


def _letter_first(c: RestCondition) -> RestCondition:
    """The sides exchanged where the right one is a letter, or the left one a number."""
    return replace(c, left=c.right, right=c.left) if c.right.is_Symbol or c.left.is_number else c


def not_negative(slack: sp.Expr, wanted: SolvedFor, signs: Signs) -> list[RestCondition]:
    """slack ≥ 0, as it is written; nothing if it always holds."""
    reduced = _without_signed_factors(shortest(_without_moduli(slack)), signs)
    if reduced is None or signs.of(reduced) in (0, 1):
        return []
    over, under = sp.fraction(reduced)
    if over.is_number and not under.is_number:  # x < h tan θ for 1/(h tan θ − x) ≥ 0
        return positive(sp.sign(over) * sp.expand(under).primitive()[1], wanted, signs)
    for group in (wanted.forces, wanted.coefficients, wanted.loads):
        symbols = [c for c in dict.fromkeys(group) if c.is_Symbol and c in reduced.free_symbols]
        solved = _solved_for(symbols[0], reduced, signs) if len(symbols) == 1 else None
        if solved is not None:
            return [solved]
        if len(symbols) == 1 and group is wanted.forces:
            collected = _collected(symbols[0], _homogeneous(sp.expand(reduced), signs), wanted.coefficients, signs)
            if collected is not None:
                return [collected]
    written = _homogeneous(sp.expand(reduced), signs)
    for tangent in sorted(written.atoms(sp.tan), key=str):
        collected = (
            _collected(tangent, written, wanted.coefficients, signs) if _is_on_both_sides(tangent, written) else None
        )
        if collected is not None:
            return [collected]
    for tangent in sorted(written.atoms(sp.tan), key=str):
        rough = not _linear(tangent, written)[0].free_symbols.isdisjoint(wanted.coefficients)
        solved = _solved_for(tangent, written, signs) if rough else None
        if solved is not None:
            return [solved]
    terms = sp.Add.make_args(written)
    minus = [t for t in terms if t.could_extract_minus_sign()]
    left, right = sp.Add(*(-t for t in minus)), sp.Add(*(t for t in terms if t not in minus))
    return [RestCondition(sp.factor(left), sp.factor(right))]


def _solved_for(symbol: sp.Expr, reduced: sp.Expr, signs: Signs) -> RestCondition | None:
    """A condition that is linear in a symbol, with a rate of known sign, solved for it; None if it is not."""
    rate, rest = _linear(symbol, reduced)
    sense = signs.of(rate)
    if symbol in rest.free_symbols or sense not in (1, -1):
        limit = solved_for_exponent(reduced, symbol)
        if limit is None or any(signs.of(part) != 1 for part in (limit.slope, limit.growth, limit.ratio)):
            return None
        return RestCondition(limit.value, symbol)
    bound = with_differences_of_squares(without_leading_minus(_in_tangents(shortest(-rest / rate))))
    return RestCondition(bound, symbol) if sense == 1 else RestCondition(symbol, bound)


def value_of_letter(e: sp.Expr, letter: sp.Expr, values: Mapping[sp.Symbol, sp.Expr], signs: Signs) -> sp.Expr | None:
    """The letter for which e = 0; None where e is not linear in it, or its coefficient may vanish.

    It does not where the rest has a sign, since the two add up to zero, or with the values.
    """
    rate, rest = _linear(letter, sp.fraction(sp.together(e))[0])
    if letter in rate.free_symbols | rest.free_symbols:
        return None
    if signs.of(rest) not in (1, -1) and is_zero(rate.xreplace(dict(values))) is not False:
        return None
    return with_differences_of_squares(without_leading_minus(_in_tangents(sp.factor(-rest) / sp.factor(rate))))


@record
class InExponent:
    """slope (e^(growth x) − ratio) = 0, solved for x."""

    slope: sp.Expr
    growth: sp.Expr
    ratio: sp.Expr

    @property
    def value(self) -> sp.Expr:
        """log(ratio)/growth, as for the coefficient of a belt: log(T_1/T_2)/β."""
        return sp.log(self.ratio) / self.growth


def solved_for_exponent(e: sp.Expr, symbol: sp.Expr) -> InExponent | None:
    """The exponent where the symbol is in one exponential only, in which e is linear; None if it is not."""
    powers = [f for f in e.atoms(sp.exp) if symbol in f.free_symbols]
    if len(powers) != 1:
        return None
    letter = sp.Dummy(positive=True)
    slope, rest = _linear(letter, e.xreplace({powers[0]: letter}))
    growth = powers[0].args[0] / symbol
    if slope == 0 or {symbol, letter} & (slope.free_symbols | rest.free_symbols | growth.free_symbols):
        return None
    return InExponent(slope, growth, sp.factor(-rest / slope))


def _linear(symbol: sp.Expr, e: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """The coefficient of a symbol and the rest, which still has it where the expression is not linear."""
    expanded = sp.expand(e)
    rate = expanded.coeff(symbol, 1)
    return rate, sp.expand(expanded - rate * symbol)


def _collected(symbol: sp.Expr, e: sp.Expr, coefficients: Sequence[sp.Expr], signs: Signs) -> RestCondition | None:
    """e ≥ 0 as A P ≤ B or B ≤ A P, the sign of A being unknown; None if it is not linear in P, or in tan θ.

    Of A and −A that which is positive for little friction is written: B ≤ (cos β − μ sin β) P.
    """
    rate, rest = _linear(symbol, e)
    if rest.has(symbol):
        return None
    smooth = signs.of(rate.xreplace(dict.fromkeys(coefficients, sp.S.Zero)))
    if smooth == 1 or (not smooth and rest.could_extract_minus_sign()):
        return RestCondition(sp.factor(-rest), sp.factor(rate) * symbol)
    return RestCondition(sp.factor(-rate) * symbol, sp.factor(rest))


def _is_on_both_sides(tangent: sp.Expr, e: sp.Expr) -> bool:
    """Whether tan θ ≤ 2μ + μ ν tan θ can be collected, (1 − μ ν) tan θ ≤ 2μ."""
    rate, rest = _linear(tangent, e)
    signs = {t.could_extract_minus_sign() for t in sp.Add.make_args(rate)}
    return rest != 0 and not rest.has(tangent) and len(signs) == 2


def without_weaker(conditions: Sequence[RestCondition], signs: Signs) -> tuple[RestCondition, ...]:
    """The conditions without bounds on a symbol that another bound on it implies."""
    kept = [c for c in dict.fromkeys(conditions) if c.relation != "≤" or replace(c, relation="<") not in conditions]
    for weak in tuple(kept):
        if weak.relation == "=":
            continue
        if any(c is not weak and _is_stricter(c, weak, signs) for c in kept):
            kept.remove(weak)
    return tuple(kept)


def joined_cases(cases: Sequence[tuple[RestCondition, ...]], signs: Signs) -> tuple[tuple[RestCondition, ...], ...]:
    """The cases without conditions that another one, of one condition, makes needless: p or (not p and q) is p or q."""
    left = list(dict.fromkeys(cases))
    for alone in [case[0] for case in left if len(case) == 1]:
        for n, case in enumerate(left):
            if case == (alone,):
                continue
            if alone.relation == "=":
                continue
            kept = [c for c in case if not _is_opposite(c, alone)]
            for d in tuple(kept):
                others = [c for c in kept if c is not d]
                if d.relation != "=" and others and any(_implies(c, alone, d, signs) for c in others):
                    kept = others
            left[n] = tuple(kept)
    left = [*dict.fromkeys(left)]
    weaker = (any(o != case and implies_all(case, o, signs) for o in left) for case in left)
    return tuple(case for case, needless in zip(left, weaker, strict=True) if not needless)


def implies_all(case: Sequence[RestCondition], others: Sequence[RestCondition], signs: Signs) -> bool:
    """Whether each of the other conditions is one of a case, or a weaker bound on the same letter."""
    return all(any(c == o or _is_stricter(c, o, signs) for c in case) for o in others)


def _is_stricter(c: RestCondition, other: RestCondition, signs: Signs) -> bool:
    """Whether a bound on a letter is stricter than another one: √3 ≤ μ than 2 − √3 ≤ μ."""
    if "=" in (c.relation, other.relation):
        return False
    if c.right == other.right and c.right.is_Symbol:
        return signs.of(shortest(c.left - other.left)) == 1
    if c.left == other.left and c.left.is_Symbol:
        return signs.of(shortest(other.right - c.right)) == 1
    return _is_stricter_in_tangents(c, other, signs)


def _is_stricter_in_tangents(c: RestCondition, other: RestCondition, signs: Signs) -> bool:
    """The same of tangents of acute angles: 1 ≤ μ (tan β − 2 tan θ) than tan θ < tan β."""
    angles = sorted((c.left - c.right).atoms(sp.tan) | (other.left - other.right).atoms(sp.tan), key=str)
    if not angles or any(signs.of(x) != 1 for x in angles) or other.left.is_Symbol or other.right.is_Symbol:
        return False
    letters = {x: sp.Symbol(f"t_{n}", positive=True) for n, x in enumerate(angles)}
    strict, weak = (sp.expand((e.right - e.left).xreplace(letters)) for e in (c, other))
    if not all(e.is_polynomial(*e.free_symbols) for e in (strict, weak)) or strict.is_number:
        return False
    return is_implied(weak, strict, signs)


def _is_opposite(c: RestCondition, other: RestCondition) -> bool:
    """Whether one of the two always holds."""
    both = "=" not in (c.relation, other.relation) and (c.admits_limit or other.admits_limit)
    return both and (c.left, c.right) == (other.right, other.left)


def _implies(c: RestCondition, other: RestCondition, failed: RestCondition, signs: Signs) -> bool:
    """Whether a condition implies another one where a third fails.

    What is not negative where left > right of the third is not negative at left = right, but what is positive may
    vanish there.
    """
    if c.relation == "=":
        return False
    signs = signs.assuming(failed.left - failed.right)
    if c.right == other.right:
        sense = signs.of(shortest(c.left - other.left))
    elif c.left == other.left:
        sense = signs.of(shortest(other.right - c.right))
    else:
        return False
    if other.admits_limit or not c.admits_limit:
        return sense in (0, 1)
    return sense == 1 and failed.admits_limit


def _without_signed_factors(slack: sp.Expr, signs: Signs) -> sp.Expr | None:
    """The factors whose sign is not known, with the sign of the others; None if none is left and it is positive."""
    over, under = sp.fraction(slack)
    sign, kept = 1, []
    for factor, power in (*((f, 1) for f in sp.Mul.make_args(over)), *((f, -1) for f in sp.Mul.make_args(under))):
        base, exponent = factor.as_base_exp()
        if exponent.is_Integer and exponent % 2 == 0:
            continue
        known = signs.of(base)
        if known is None:
            kept.append(base**power)
        else:
            sign *= known or 1
    return _in_tangents(sp.Mul(sign, *kept)) if kept else None if sign > 0 else sp.S.NegativeOne


def _homogeneous(e: sp.Expr, signs: Signs) -> sp.Expr:
    """A sum whose terms have the same degree in sin θ and cos θ, divided by a power of cos θ > 0."""
    for angle in sorted({f.args[0] for f in e.atoms(sp.sin, sp.cos)}, key=str):
        s, c = sp.sin(angle), sp.cos(angle)
        if signs.of(c) != 1 or not e.is_polynomial(s, c):
            continue
        poly = sp.Poly(e, s, c)
        degrees = {sum(m) for m in poly.monoms()}
        if len(degrees) == 1 and degrees != {0} and len(poly.monoms()) > 1:
            x = sp.tan(angle)
            e = sp.expand(sp.Add(*(k * x ** m[0] for m, k in poly.terms())))
    return e


def _in_tangents(e: sp.Expr) -> sp.Expr:
    """sin θ/cos θ as tan θ, in each product and quotient."""
    e = e.replace(sp.Abs, lambda x: sp.Abs(_in_tangents(x)))
    for angle in sorted({f.args[0] for f in e.atoms(sp.sin, sp.cos)}, key=str):
        s, c = sp.sin(angle), sp.cos(angle)
        over, under = sp.fraction(sp.together(e))
        if not (over.is_polynomial(s, c) and under.is_polynomial(s, c)):
            continue
        top, bottom = sp.Poly(over, s, c), sp.Poly(under, s, c)
        degrees = {sum(m) for m in top.monoms()}, {sum(m) for m in bottom.monoms()}
        if len(degrees[0]) == len(degrees[1]) == 1 and degrees[0] == degrees[1] != {0}:
            x = sp.tan(angle)
            numerator = sp.Add(*(k * x ** m[0] for m, k in top.terms()))
            denominator = sp.Add(*(k * x ** m[0] for m, k in bottom.terms()))
            e = sp.factor(numerator / denominator)
    return e


# Limits of load


Row = tuple[float, ...]
Point = Callable[[sp.Expr], float]


@record
class LoadLimits:
    """slack ≥ 0 for each limit; `where`: what must be positive for these to be the limits."""

    slacks: tuple[sp.Expr, ...]
    where: tuple[sp.Expr, ...]


def limits_of_load(
    inequalities: Sequence[Inequality],
    load: sp.Symbol,
    friction: Sequence[sp.Expr],
    values: Mapping[sp.Symbol, sp.Expr],
    signs: Signs,
) -> list[LoadLimits]:
    """The limits of a force that occurs in the constants of the bounds, in each case that is seen.

    friction  the coefficients of friction
    values    numbers for parameters
    """
    rows = [(*i.coefficients, rate, shortest(i.constant.xreplace({load: sp.S.Zero})))
            for i in inequalities for rate in [shortest(i.constant.diff(load))]]  # fmt: skip
    if any(load in e.free_symbols for row in rows for e in row):
        return []
    open_ = len(rows[0]) - 2
    sets = [*combinations(range(len(rows)), open_ + 1)]
    if len(sets) > MOST_BOUND_SETS:
        return []
    return [_in_letters(rows, both, point, load, signs) for both, point in _seen(rows, sets, friction, values)]


def _in_letters(
    rows: Sequence[Sequence[sp.Expr]], both: Sequence[tuple[int, ...]], point: Point, load: sp.Symbol, signs: Signs
) -> LoadLimits:
    """The limits from sets of bounds, and what makes them the limits."""
    open_ = len(rows[0]) - 2
    slacks: list[sp.Expr] = []
    where: list[sp.Expr] = []
    for chosen in both:
        minors = [shortest(_minor([rows[n][:open_] for n in chosen if n != left])) for left in chosen]
        weights = [m if k % 2 == 0 else -m for k, m in enumerate(minors)]
        sense = sp.Integer(1 if sum(map(point, weights)) > 0 else -1)
        weights = [shortest(sense * w) for w in weights]
        rate = shortest(sp.Add(*(w * rows[n][-2] for w, n in zip(weights, chosen, strict=True))))
        rest = shortest(sp.Add(*(w * rows[n][-1] for w, n in zip(weights, chosen, strict=True))))
        slacks.append(shortest(rest + rate * load))
        needed = [w for w in weights if w != 0]
        whole = _minor([rows[n][: open_ + 1] for n in chosen])
        for other in range(len(rows)):
            if other not in chosen:
                full = _minor([rows[n] for n in (*chosen, other)])
                ratio = shortest(full / whole)
                needed += [ratio] if ratio != 0 else []
        for e in needed:
            where += _factors_to_keep(e, point, signs)
    kept = [*dict.fromkeys(where)]
    for e in tuple(kept):
        others = [k for k in kept if k != e]
        if others and _follows(e, others, signs):
            kept.remove(e)
    return LoadLimits(tuple(slacks), tuple(kept))


def _minor(rows: Sequence[Sequence[sp.Expr]]) -> sp.Expr:
    return sp.Matrix([[*row] for row in rows]).det(method="berkowitz") if rows else sp.S.One


def _factors_to_keep(e: sp.Expr, point: Point, signs: Signs) -> Iterator[sp.Expr]:
    """The factors of unknown sign, each with the sign that makes it positive at the numbers; e is positive there."""
    above, below = sp.fraction(sp.together(e))
    for factor in (*sp.Mul.make_args(sp.factor(above)), *sp.Mul.make_args(sp.factor(below))):
        base, power = factor.as_base_exp()
        if power.is_Integer and power % 2 == 0:
            continue
        if signs.of(base) in (1, -1):
            continue
        yield base if point(base) > 0 else -base


def _follows(e: sp.Expr, others: Sequence[sp.Expr], signs: Signs) -> bool:
    """Whether a condition e > 0 is weaker than another one."""
    return any(signs.of(sp.expand(e - other)) in (0, 1) for other in others)


def _seen(
    rows: Sequence[Sequence[sp.Expr]],
    sets: Sequence[tuple[int, ...]],
    friction: Sequence[sp.Expr],
    values: Mapping[sp.Symbol, sp.Expr],
) -> list[tuple[tuple[tuple[int, ...], ...], Point]]:
    """The sets of bounds that limit the force at drawn numbers at which rest is possible, the most frequent first."""
    symbols = sorted({s for row in rows for e in row for s in e.free_symbols}, key=str)
    angles = {s for row in rows for e in row for f in e.atoms(sp.sin, sp.cos, sp.tan) for s in f.free_symbols}
    rough = {s for e in friction for s in e.free_symbols}
    try:
        tape = Tape([e.xreplace(dict(values)) for row in rows for e in row], symbols)
    except NoTapeError:
        return []
    seen: dict[tuple[tuple[int, ...], ...], list[Point]] = {}
    draw = random.Random(18)
    width = len(rows[0])
    for _ in range(DRAWS_OF_LIMITS):
        numbers = [
            float(values[s]) if s in values
            else draw.uniform(0.05, 0.3) if s in rough
            else draw.uniform(0.1, 0.6) if s in angles
            else draw.uniform(0.5, 2)
            for s in symbols
        ]  # fmt: skip
        try:
            flat = tape.values(numbers)
        except (ValueError, ArithmeticError):
            continue
        table = [tuple(flat[n : n + width]) for n in range(0, len(flat), width)]
        both = _sharpest(table, sets)
        if both is not None:
            at = dict(zip(symbols, numbers, strict=True))

            def point(e: sp.Expr, at: Mapping[sp.Symbol, float] = at) -> float:
                return float(e.xreplace(dict(values)).xreplace({s: sp.Float(x) for s, x in at.items()}).evalf())

            seen.setdefault(tuple(both), []).append(point)
    often = sorted(seen.items(), key=lambda item: -len(item[1]))[:MOST_REGIMES]
    return [(both, points[0]) for both, points in often]


def _sharpest(table: Sequence[Row], sets: Sequence[tuple[int, ...]]) -> list[tuple[int, ...]] | None:
    """The sets that give the greatest lower and the least upper limit; None where rest is impossible, or nothing is."""
    best: dict[int, tuple[float, tuple[int, ...]]] = {}
    open_ = len(table[0]) - 2
    for chosen in sets:
        weights = _weights([table[n][:open_] for n in chosen])
        if weights is None:
            continue
        rate = sum(w * table[n][-2] for w, n in zip(weights, chosen, strict=True))
        rest = sum(w * table[n][-1] for w, n in zip(weights, chosen, strict=True))
        if abs(rate) < SMALL_BOUND:
            if rest < -SMALL_BOUND:
                return None
            continue
        side, limit = (1, -rest / rate) if rate > 0 else (-1, rest / -rate)
        if side not in best or side * (limit - best[side][0]) > SMALL_BOUND * (1 + abs(limit)):
            best[side] = (limit, chosen)
    if not best or (len(best) == 2 and best[1][0] > best[-1][0]):
        return None
    return [chosen for _, chosen in (best[s] for s in (1, -1) if s in best)]


def _weights(rows: Sequence[Row]) -> list[float] | None:
    """The minors with alternating signs, scaled, where none is negative; None otherwise."""
    minors = [_determinant([r for k, r in enumerate(rows) if k != left]) * (-1) ** left for left in range(len(rows))]
    size = max(map(abs, minors))
    if size < SMALL_BOUND:
        return None
    scaled = [m / size for m in minors]
    if min(scaled) < -SMALL_BOUND:
        scaled = [-m for m in scaled]
    return None if min(scaled) < -SMALL_BOUND else scaled


def _determinant(rows: Sequence[Row]) -> float:
    if not rows:
        return 1.0
    work, result = [[*r] for r in rows], 1.0
    for k in range(len(work)):
        n = max(range(k, len(work)), key=lambda n: abs(work[n][k]))
        if work[n][k] == 0:
            return 0.0
        if n != k:
            work[n], work[k], result = work[k], work[n], -result
        result *= work[k][k]
        for n in range(k + 1, len(work)):
            ratio = work[n][k] / work[k][k]
            work[n] = [a - ratio * b for a, b in zip(work[n], work[k], strict=True)]
    return result
