"""Whether equations that are not solved have a real solution.

Never     terms of one sign cannot cancel; nor can sines and cosines outweigh a larger constant;
          a cos β + b cos γ = p with a sin β + b sin γ = q is a triangle with the sides |a|, |b| and √(p² + q²),

              (|a| − |b|)² ≤ p² + q² ≤ (|a| + |b|)² ;

          with numbers a polynomial of one unknown has no root (Sturm), or no box of the unknowns can contain a
          solution: an interval without 0 excludes a box, and others are halved (`intervals`).
Somewhere a polynomial of one unknown has a root, one of odd degree with letters as well, or a continuous function of
          one angle takes both signs.

An unknown without a bound is x in [−1, 1] and x = ±1/y with y in [0, 1]. All of this is bounded, and None is undecided.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, product

import sympy as sp

from lagrange.algebra.closed_forms.intervals import (
    EVERYTHING,
    EmptyIntervalError,
    Interval,
    circle,
    enclosure,
    outward,
    square_root,
)
from lagrange.algebra.closed_forms.limits import (
    HIGHEST_COUNTED_DEGREE,
    MOST_BOXED_UNKNOWNS,
    MOST_BOXES,
    QUARTER_TURNS,
    SCANNED,
)
from lagrange.algebra.closed_forms.polynomial_roots import irreducible_factors, numerator
from lagrange.algebra.closed_forms.signs import SignCondition, different_from_zero, not_negative, sign_of
from lagrange.algebra.closed_forms.single_equation import Values, one_unknown, trivial_solutions
from lagrange.algebra.closed_forms.solution_sets import Branch, resolved
from lagrange.algebra.closed_forms.unit_circle import LetteredAngle, NotAlgebraicError, TrigLetters
from lagrange.algebra.exact.zero_test import is_zero

IntervalBox = dict[sp.Symbol, Interval]


def have_real_solution(equations: Sequence[sp.Expr], letters: TrigLetters) -> bool | None:
    """Whether some real values of the letters satisfy all equations, given in letters; None: undecided."""
    if any(_never_zero(e, letters) for e in equations):
        return False
    if any(_never_zero(sp.expand(e + s * f), letters) for e, f in combinations(equations, 2) for s in (1, -1)):
        return False
    if any(not_closed is None for not_closed in map(_closing, _triangles(equations, letters))):
        return False
    counted = _counted(equations, letters)
    if counted is not None:
        return counted
    if len(equations) == 1 and (_has_odd_degree(equations[0], letters) or _takes_both_signs(equations[0], letters)):
        return True
    return False if _excluded(equations, letters) else None


def real_branches(branches: Sequence[Branch], letters: TrigLetters) -> list[Branch]:
    """The branches without those that have no real point; of others, what is necessary, and whether they have one."""
    kept = []
    for b in branches:
        if not b.left or b.special:
            kept.append(b)
            continue
        try:
            equations = [letters.read(e) for e in b.left]
        except NotAlgebraicError:  # an unknown under the fourth root
            kept.append(b)
            continue
        exists = have_real_solution(equations, letters)
        if exists is not False:
            triangles = [t for t in _triangles(equations, letters) if _same_sign(t) is not None]
            closing = [c for t in triangles for c in _closing(t) or ()]
            exists = exists or (len(equations) == 2 and len(triangles) == 1)  # under these conditions
            conditions = tuple(dict.fromkeys((*b.conditions, *closing)))
            only_closing = all(c.relation == "≠" for c in b.conditions)
            occupied = exists is True and not b.conditions
            kept.append(replace(b, conditions=conditions, occupied=occupied, closing=only_closing))
    return kept


def with_values(b: Branch, divisors: Sequence[sp.Expr], letters: TrigLetters) -> Branch:
    """A branch with unsolved equations, and that no divisor vanishes, where the equations may hold there as well."""
    try:
        equations = [letters.read(e) for e in b.left]
    except NotAlgebraicError:
        return b
    conditions = list(b.conditions)
    for d in divisors:
        for p in _zeros(resolved(d, b.common), letters):
            if _may_vanish_at(p, equations, letters):
                conditions += different_from_zero(letters.shortest(p))
    written = (replace(c, lhs=letters.write(c.lhs), rhs=letters.write(c.rhs)) for c in conditions)
    conditions = list(dict.fromkeys(written))
    exists = b.occupied and len(conditions) == len(b.conditions)
    exists = exists or _holds_trivially(equations, conditions, letters)
    if not exists and len(equations) == 1 and all(c.relation == "≠" for c in conditions):
        avoided = [letters.read(c.lhs - c.rhs) for c in conditions]
        exists = _crosses_zero(equations[0], avoided, letters)
        beyond_zero = len(letters.unknowns) == 1 and all(a in letters.unknowns for a in avoided)
        exists = exists or (beyond_zero and _takes_both_signs(equations[0], letters, first=1))
    return replace(b, conditions=tuple(conditions), occupied=exists)


def _holds_trivially(equations: Sequence[sp.Expr], conditions: Sequence[SignCondition], letters: TrigLetters) -> bool:
    """Whether the equations hold where every unknown is 0, or π: then there is a solution, although it is not new."""
    excluded = [letters.read(c.lhs - c.rhs) for c in conditions if c.relation == "≠"]
    if len(excluded) < len(conditions):
        return False
    return any(
        all(is_zero(letters.write(resolved(x, {**values, **_roots_at(values, letters)}))) is False for x in excluded)
        for values in trivial_solutions(equations, letters)
    )


def _zeros(divisor: sp.Expr, letters: TrigLetters) -> Iterator[sp.Expr]:
    """The factors with unknowns that vanish where a divisor does; for a root those of its radicand."""
    parts = numerator(divisor)
    for p in irreducible_factors(letters.shortest(parts[0])) or () if parts else ():
        if p in letters.roots:
            yield from _zeros(letters.roots[p], letters)
        elif letters.unknowns_in(p):
            yield p


def _may_vanish_at(p: sp.Expr, equations: Sequence[sp.Expr], letters: TrigLetters) -> bool:
    """Whether a factor may be zero where the equations hold."""
    if have_real_solution([*equations, p], letters) is False:
        return False
    unknowns = letters.unknowns_in(p)
    roots = one_unknown(p, next(iter(unknowns)), letters) if len(unknowns) == 1 else None
    if roots is None:
        return True
    for root in roots:
        for values in root.values:
            at = [letters.write(resolved(e, {**values, **_roots_at(values, letters)})) for e in equations]
            if not any(is_zero(e) is False for e in at):
                return True
    return False


def _roots_at(values: Values, letters: TrigLetters) -> Values:
    """The values of the root letters."""
    known: dict[sp.Symbol, sp.Expr] = {}
    for r, radicand in letters.roots.items():
        value = resolved(radicand, {**values, **known})
        if not value.free_symbols & letters.roots.keys():
            known[r] = sp.sqrt(sp.expand(value))
    return known


# -- signs -------------------------------------------------------------------------------------------------------------


def _never_zero(e: sp.Expr, letters: TrigLetters) -> bool:
    """Whether the terms have one sign, or a constant outweighs sines and cosines."""
    terms = sp.Add.make_args(sp.expand(e))
    for sign in (1, -1):
        signed = [sign * t for t in terms]
        if all(t.is_nonnegative for t in signed) and any(t.is_positive for t in signed):
            return True
    bounded = {s for a in letters.angles.values() for s in a.letters}
    constant, most = sp.S.Zero, sp.S.Zero
    for t in terms:
        coefficient, rest = t.as_independent(*bounded, as_Add=False)
        if rest == 1:
            constant += t
            continue
        if letters.unknowns_in(coefficient) or not rest.is_polynomial(*bounded):
            return False
        of_coefficient = _strict(coefficient)
        if of_coefficient is None:
            return False
        most += of_coefficient * coefficient
    if letters.unknowns_in(constant):
        return False
    return any(_strict(s * constant - most) == 1 for s in (1, -1))


def _strict(e: sp.Expr) -> int | None:
    """The sign of an expression without unknowns that is not zero; None if that is open."""
    e = sp.expand(e)
    return 1 if e.is_positive else -1 if e.is_negative else None


# -- triangles ---------------------------------------------------------------------------------------------------------

_Triangle = tuple[sp.Expr, sp.Expr, sp.Expr]
"""Two sides, and the square of the third one."""


def _triangles(equations: Sequence[sp.Expr], letters: TrigLetters) -> Iterator[_Triangle]:
    for e, f in combinations(equations, 2):
        for g, h in ((e, f), (f, e)):
            t = _triangle(g, h, letters)
            if t is not None:
                yield t
                break


def _triangle(e: sp.Expr, f: sp.Expr, letters: TrigLetters) -> _Triangle | None:
    """a cos β + b cos γ = p and a sin β + b sin γ = q, up to factors ±1 of b in one equation, which is −γ for γ."""
    unknowns = letters.unknowns_in(e) | letters.unknowns_in(f)
    angles = [letters.angles[u] for u in unknowns if u in letters.angles]
    if len(unknowns) != 2 or len(angles) != 2:
        return None
    of_e, of_f = ({s for a in angles for s in a.letters} & x.free_symbols for x in (e, f))
    cosines, sines = {a.cosine for a in angles}, {a.sine for a in angles}
    if of_e != cosines or of_f != sines:
        return None
    try:
        first, second = (sp.Poly(x, *(s for a in angles for s in a.letters)) for x in (e, f))
    except sp.PolynomialError:
        return None
    if first.total_degree() != 1 or second.total_degree() != 1:
        return None
    across = [first.coeff_monomial(a.cosine) for a in angles]
    up = [second.coeff_monomial(a.sine) for a in angles]
    if letters.unknowns_in(sp.Add(*across, *up)):
        return None
    scale = up[0] / across[0]
    for sign in (1, -1):
        if sp.cancel(up[1] - sign * scale * across[1]) == 0:
            p, q = first.coeff_monomial(1), sp.cancel(second.coeff_monomial(1) / scale)
            return across[0], across[1], sp.expand(p**2 + q**2)
    return None


def _same_sign(t: _Triangle) -> int | None:
    """The sign of the product of two sides; None if that is open."""
    return sign_of(sp.factor(t[0] * t[1]))


def _closing(t: _Triangle) -> tuple[SignCondition, ...] | None:
    """The triangle inequalities; None if they are never met."""
    a, b, square = t
    # Up to its sign the product ab is what (|a| ± |b|)² contain: both signs are covered by both inequalities.
    sign = _same_sign(t)
    if sign is None:
        return ()
    conditions: list[SignCondition] = []
    for difference in (square - (a - sign * b) ** 2, (a + sign * b) ** 2 - square):
        allowed = not_negative(sp.factor(sp.expand(difference)))
        if allowed is None:
            return None
        conditions += allowed
    return tuple(conditions)


# -- one unknown -------------------------------------------------------------------------------------------------------


def _counted(equations: Sequence[sp.Expr], letters: TrigLetters) -> bool | None:
    """Whether polynomials of one unknown, with rational numbers, have a common real root."""
    unknowns = frozenset[sp.Symbol]().union(*map(letters.unknowns_in, equations))
    if len(unknowns) != 1:
        return None
    [u] = unknowns
    t = sp.Dummy("t", real=True)
    angle = letters.angles.get(u)
    values: Mapping[sp.Symbol, sp.Expr] = {u: t}
    if angle is not None:
        if any(u in e.free_symbols for e in equations):
            return None
        values = {angle.cosine: (1 - t**2) / (1 + t**2), angle.sine: 2 * t / (1 + t**2)}
        opposite = {angle.cosine: sp.S.NegativeOne, angle.sine: sp.S.Zero}  # t is infinite
        if all(sp.expand(e.xreplace(opposite)) == 0 for e in equations):
            return True
    polynomials = []
    for e in equations:
        if e.free_symbols & letters.roots.keys():
            return None
        parts = numerator(e.xreplace(dict(values)))
        try:
            polynomial = sp.Poly(parts[0], t, domain="QQ") if parts else None
        except (sp.PolynomialError, sp.CoercionFailed):  # a parameter, or an irrational number
            return None
        if polynomial is None or polynomial.degree() > HIGHEST_COUNTED_DEGREE:
            return None
        if not polynomial.is_zero:
            polynomials.append(polynomial)
    if not polynomials:
        return None
    common = polynomials[0]
    for p in polynomials[1:]:
        common = common.gcd(p)
    return bool(common.count_roots() > 0)


def _has_odd_degree(e: sp.Expr, letters: TrigLetters) -> bool:
    """Whether it is of odd degree in an unknown, with coefficients that stay bounded: k (θ − θ_0) + W l cos θ."""
    if e.free_symbols & letters.roots.keys():
        return False
    for u in e.free_symbols & {*letters.unknowns}:
        if u.is_nonnegative or u.is_nonpositive or not e.is_polynomial(u, *letters.unknowns_in(e)):
            continue
        p = sp.Poly(e, u)
        if p.degree() % 2 and not letters.unknowns_in(p.LC()) and _strict(p.LC()) is not None:
            return True
    return False


def _takes_both_signs(e: sp.Expr, letters: TrigLetters, first: int = 0) -> bool:
    """Whether a continuous function of one angle is positive at one quarter turn and negative at another.

    first  the first quarter turn that counts where the angle also occurs outside sines and cosines
    """
    unknowns = letters.unknowns_in(e)
    angle = letters.angles.get(*unknowns) if len(unknowns) == 1 else None
    if angle is None:
        return False
    [u] = unknowns
    roots = _roots_used(e.free_symbols, letters)
    if not all(_is_positive(letters.roots[r], angle, letters) for r in roots):
        return False
    for r in reversed(roots):
        e = e.xreplace({r: sp.sqrt(letters.roots[r])})
    if any(p.exp.is_negative and {u, *angle.letters} & p.free_symbols for p in e.atoms(sp.Pow)):
        return False
    if not e.is_polynomial(u):
        return False
    quarter = sp.pi / 2 / angle.measure.coeff(u)
    turns = range(first, QUARTER_TURNS + 1) if u in e.free_symbols else range(4)
    on_circle = ((1, 0), (0, 1), (-1, 0), (0, -1))
    values = (
        e.xreplace({u: n * quarter, **dict(zip(angle.letters, map(sp.Integer, on_circle[n % 4]), strict=True))})
        for n in turns
    )
    return {1, -1} <= {_strict(v) for v in values}


def _is_positive(e: sp.Expr, angle: LetteredAngle, letters: TrigLetters) -> bool:
    """Whether a polynomial of one angle is positive everywhere: it is at one point, and has no root."""
    if letters.unknowns_in(e) and not (_never_zero(e, letters) or _counted([e], letters) is False):
        return False
    return _strict(e.xreplace({angle.cosine: sp.S.One, angle.sine: sp.S.Zero})) == 1


def _crosses_zero(e: sp.Expr, avoided: Sequence[sp.Expr], letters: TrigLetters) -> bool:
    """Whether a function of one unknown, with numbers, changes its sign where it is continuous, others not being 0."""
    used = frozenset[sp.Symbol]().union(*(x.free_symbols for x in (e, *avoided)))
    roots = [(r, letters.roots[r]) for r in _roots_used(used, letters)]
    unknowns = letters.unknowns_in(e)
    if len(unknowns) != 1:
        return False
    [u] = unknowns
    angle = letters.angles.get(u)
    letters_of_u = {u, *(angle.letters if angle else ())}
    if not used.union(*(d.free_symbols for _, d in roots)) <= letters_of_u | {r for r, _ in roots}:
        return False

    def lies(x: sp.Expr, low: float, high: float) -> Interval:
        """An interval of a function, from `low` to `high` in quarter turns of the angle, or of the unknown."""
        values: IntervalBox = {u: (low, high)}
        if angle is not None:
            values = dict(zip(angle.letters, circle(low, high), strict=True))
            share = float(angle.measure.coeff(u))
            values[u] = outward(low * math.pi / 2 / share - 1e-12, high * math.pi / 2 / share + 1e-12)
        for r, radicand in roots:
            values[r] = square_root(enclosure(radicand, values))
            if values[r][0] == 0 and low < high:  # it need not be real everywhere between
                return EVERYTHING
        return enclosure(x, values)

    last: tuple[float, int] | None = None
    for n in range(-SCANNED, SCANNED + 1):
        place = n * 7 / 64  # quarter turns are seldom among these
        try:
            low, high = lies(e, place, place)
            sign = 1 if low > 0 else -1 if high < 0 else 0
            if last is not None and sign * last[1] == -1:
                between = [lies(x, last[0], place) for x in (*avoided, e)]
                if all(a > 0 or b < 0 for a, b in between[:-1]) and between[-1] != EVERYTHING:
                    return True
            last = (place, sign) if sign else None
        except (EmptyIntervalError, ValueError, KeyError, OverflowError):
            last = None
    return False


# -- boxes -------------------------------------------------------------------------------------------------------------


def _excluded(equations: Sequence[sp.Expr], letters: TrigLetters) -> bool:
    """Whether no box of the unknowns contains a solution, found within a bounded number of boxes."""
    used = frozenset[sp.Symbol]().union(*(e.free_symbols for e in equations))
    unknowns = sorted(frozenset[sp.Symbol]().union(*map(letters.unknowns_in, equations)), key=str)
    if not 0 < len(unknowns) <= MOST_BOXED_UNKNOWNS:
        return False
    lettered = {u: letters.angles[u] for u in unknowns if u in letters.angles and u not in used}
    plain = [u for u in unknowns if u not in letters.angles]
    owned = {*plain, *(s for a in lettered.values() for s in a.letters)}
    roots = _roots_used(used, letters)
    if len(lettered) + len(plain) < len(unknowns):
        return False
    if not {s for r in roots for s in letters.roots[r].free_symbols} | used <= owned | {*roots}:
        return False
    radicands = [(r, letters.roots[r]) for r in roots]
    left = MOST_BOXES
    for choice in product((0, 1, -1), repeat=len(plain)):
        signs = dict(zip(plain, choice, strict=True))
        written = _in_chart(equations, [e for _, e in radicands], signs)
        if written is None:
            return False
        left = _boxes_left(written, radicands, letters, lettered, signs, left)
        if left <= 0:
            return False
    return True


def _roots_used(used: Iterable[sp.Symbol], letters: TrigLetters) -> list[sp.Symbol]:
    """The root letters that occur, those under others first."""
    roots: list[sp.Symbol] = []
    for r in sorted({*used} & letters.roots.keys(), key=str):
        for inner in [*_roots_used(letters.roots[r].free_symbols, letters), r]:
            roots += [inner] if inner not in roots else []
    return roots


def _in_chart(
    equations: Sequence[sp.Expr], radicands: Sequence[sp.Expr], signs: Mapping[sp.Symbol, int]
) -> list[sp.Expr] | None:
    """The equations with x = ±1/y, y ≥ 0, where a sign is given, times a power of y; None if that has roots."""
    written = list(equations)
    for x, s in signs.items():
        if not s:
            continue
        if any(x in r.free_symbols for r in radicands):
            return None
        for k, e in enumerate(written):
            try:
                poly = sp.Poly(e, x)
            except sp.PolynomialError:
                return None
            n = poly.degree()
            written[k] = sp.Add(*(c * s**m * x ** (n - m) for (m,), c in poly.terms()))
    return written


def _boxes_left(
    equations: Sequence[sp.Expr],
    radicands: Sequence[tuple[sp.Symbol, sp.Expr]],
    letters: TrigLetters,
    turned: Iterable[sp.Symbol],
    signs: Mapping[sp.Symbol, int],
    left: int,
) -> int:
    """How many boxes are left after all of one chart are excluded; 0 where they are not."""
    start: IntervalBox = dict.fromkeys(turned, (-2.0, 2.0))
    start |= {x: (0.0 if s else -1.0, 1.0) for x, s in signs.items()}
    heap = [start]
    while heap:
        left -= 1
        box = heap.pop()
        if left <= 0:
            return 0
        if _is_without(equations, radicands, letters, box, signs):
            continue
        widest = max(box, key=lambda u: box[u][1] - box[u][0])
        low, high = box[widest]
        if high - low < 1e-6:
            return 0
        # Not at the middle: solutions are often at round places, and would lie on the edges of boxes.
        middle = low + (high - low) * 0.4921875
        heap += [{**box, widest: (low, middle)}, {**box, widest: (middle, high)}]
    return left


def _is_without(
    equations: Sequence[sp.Expr],
    radicands: Sequence[tuple[sp.Symbol, sp.Expr]],
    letters: TrigLetters,
    box: IntervalBox,
    signs: Mapping[sp.Symbol, int],
) -> bool:
    values: IntervalBox = {u: box[u] for u in signs}
    for u, (low, high) in box.items():
        if u not in signs:
            angle = letters.angles[u]
            values[angle.cosine], values[angle.sine] = circle(low, high)
    try:
        for r, radicand in radicands:
            values[r] = square_root(enclosure(radicand, values))
        for e in equations:
            low, high = enclosure(e, values)
            if low > 0 or high < 0 or math.isnan(low):
                return not math.isnan(low)
    except EmptyIntervalError:
        return True
    except (ValueError, KeyError, OverflowError):
        return False
    return False
