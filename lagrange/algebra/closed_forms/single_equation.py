"""One equation in one unknown, solved in closed form: all real roots, with the conditions under which they exist.

    polynomials      see `polynomial_roots`
    angles           sin θ = a,  cos θ = a,  tan θ = a (homogeneous equations),  a sin θ + b cos θ = c,
                     and A(cos θ) + B(cos θ) sin θ = 0, squared, where the polynomial that results can be solved
    square roots     A + B √D = 0 is A² = B² D with −A/B ≥ 0

Everything is in the letters of `unit_circle`. What an equation is divided by is assumed not to be zero for generic
parameters; factors that contain an unknown are solved separately. Of equations that are not solved, the trivial
solutions are tried, every unknown 0, or π where it is an angle:

    c (2a − b) = l P sin a,  c (b − a) = l P sin b      a = b = 0
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from itertools import combinations, product
from typing import TypeAlias

import sympy as sp

from lagrange.algebra.closed_forms.limits import HIGHEST_DEGREE, MOST_TRIVIAL_UNKNOWNS
from lagrange.algebra.closed_forms.polynomial_roots import (
    factored_quotient,
    irreducible_factors,
    numerator,
    other_wave,
    polynomial_roots,
    square_root,
)
from lagrange.algebra.closed_forms.signs import SignCondition, between_minus_one_and_one, not_negative
from lagrange.algebra.closed_forms.unit_circle import LetteredAngle, NotAlgebraicError, TrigLetters, with_square
from lagrange.core.records import record

Values: TypeAlias = Mapping[sp.Symbol, sp.Expr]


@record
class Relation:
    """lhs = rhs, as it is stated: cos θ = b/a."""

    lhs: sp.Expr
    rhs: sp.Expr

    @property
    def residual(self) -> sp.Expr:
        """The left side minus the right side."""
        return self.lhs - self.rhs

    @property
    def positive(self) -> tuple[sp.Symbol, ...]:
        """What is positive because the left side is a square: r in φ'² = K/(m r³), and in r^n with any real n."""
        if not (isinstance(self.lhs, sp.Pow) and self.lhs.exp == 2 and self.lhs.base.is_real):
            return ()
        if powers := {p.base for p in self.rhs.atoms(sp.Pow) if p.base.is_Symbol and not p.exp.is_number}:
            return tuple(sorted(powers, key=str))
        factors = [f.as_base_exp() for f in sp.Mul.make_args(sp.factor(self.rhs))]
        open_ = [(x, n) for x, n in factors if not (x**n).is_positive]
        is_one = len(open_) == 1 and open_[0][0].is_Symbol and open_[0][1].is_Integer and open_[0][1] % 2 == 1
        return (open_[0][0],) if is_one else ()


@record
class Root:
    """One solution of one equation.

    relations   as it is stated
    values      of the letters: one mapping, or two where it leaves a sign open: sin θ = ±√(1 − a²)
    conditions  under which it is real
    common      relations of the letters that hold for either sign: C = a, or S = C tan θ
    """

    relations: tuple[Relation, ...]
    values: tuple[Values, ...]
    conditions: tuple[SignCondition, ...] = ()
    common: Values = field(default_factory=dict)

    @property
    def shared(self) -> Values:
        """`common`, or all values if there is only one point."""
        return self.values[0] if len(self.values) == 1 else self.common


def plain_roots(f: sp.Expr, x: sp.Symbol, letters: TrigLetters) -> list[Root] | None:
    """The roots of f = 0 by an unknown that is no angle; f is an irreducible polynomial."""
    under = [r for r in letters.roots if r in f.free_symbols and x in _deep_symbols(r, letters)]
    if under:
        return _without_root(f, x, under[0], letters)
    values = polynomial_roots(f, x)
    if values is None:
        return None
    return [
        Root((Relation(x**v.power, v.stated if v.stated is not None else v.value),), ({x: v.value},), v.conditions)
        for v in values
    ]


def _deep_symbols(root: sp.Symbol, letters: TrigLetters) -> set[sp.Symbol]:
    symbols = set(letters.roots[root].free_symbols)
    for r in symbols & letters.roots.keys():
        symbols |= _deep_symbols(r, letters)
    return symbols


def _linear_in(f: sp.Expr, letter: sp.Symbol, letters: TrigLetters) -> tuple[sp.Expr, sp.Expr] | None:
    """A, B with f = A + B R."""
    poly = sp.Poly(f, letter)
    square = letters.roots[letter]
    a = b = sp.S.Zero
    for (n,), c in poly.terms():
        if n % 2:
            b += c * square ** (n // 2)
        else:
            a += c * square ** (n // 2)
    return sp.expand(a), sp.expand(b)


def _without_root(f: sp.Expr, u: sp.Symbol, letter: sp.Symbol, letters: TrigLetters) -> list[Root] | None:
    """A + B R = 0: the roots of A² = B² D at which −A/B is not negative."""
    parts = _linear_in(f, letter, letters)
    if parts is None:
        return None
    a, b = parts
    squared = numerator(a**2 - b**2 * letters.roots[letter])
    if squared is None:
        return None
    roots = one_unknown(squared[0], u, letters)
    if roots is None:
        return None
    return [root for r in roots for root in _with_square_root(r, letter, (a, b), letters)]


def _with_square_root(
    r: Root, letter: sp.Symbol, parts: tuple[sp.Expr, sp.Expr], letters: TrigLetters
) -> Iterator[Root]:
    """The values of a root of the squared equation at which R = −A/B may be positive, grouped by the conditions."""
    a, b = parts
    groups: dict[tuple[SignCondition, ...], list[Values]] = {}
    for values in r.values:
        value = _quotient(-a, b, values)
        value = square_root(letters.roots[letter].xreplace(dict(values))) if value is None else value
        allowed = not_negative(value)
        if allowed is not None:
            groups.setdefault(allowed, []).append({**values, letter: value})
    for conditions, kept in groups.items():
        relations = r.relations
        if len(kept) < len(r.values):  # the relation alone would have the other sign as well
            other = next(s for s, v in kept[0].items() if s in r.values[0] and any(w[s] != v for w in r.values))
            relations = (*relations, Relation(other, kept[0][other]))
        common = dict(r.common)
        if len({k[letter] for k in kept}) == 1:
            common[letter] = kept[0][letter]
        yield Root(relations, tuple(kept), (*r.conditions, *conditions), common)


def _quotient(a: sp.Expr, b: sp.Expr, values: Values) -> sp.Expr | None:
    below = factored_quotient(b.xreplace(dict(values)))
    return None if below == 0 else factored_quotient(a.xreplace(dict(values)) / below)


# Angles


def angle_roots(f: sp.Expr, u: sp.Symbol, letters: TrigLetters) -> list[Root] | None:
    """The roots of f = 0 by an angle; f is a polynomial in its cosine and sine."""
    angle = letters.angles[u]
    if u in f.free_symbols:
        return None
    under = [r for r in letters.roots if r in f.free_symbols and set(angle.letters) & _deep_symbols(r, letters)]
    if under:
        return _without_root(f, u, under[0], letters)
    forms = [pieces for form in _forms(f, angle) if (pieces := irreducible_factors(form)) is not None]
    # Squaring adds roots that have to be sorted out again: only when no form of the equation can do without.
    for squaring in (False, True):
        for pieces in forms:
            roots_of_pieces = [
                _angle_factor(p, angle, letters, squaring) for p in pieces if set(angle.letters) & p.free_symbols
            ]
            if all(r is not None for r in roots_of_pieces):
                return [root for roots in roots_of_pieces for root in roots or ()]
    return None


def _forms(f: sp.Expr, angle: LetteredAngle) -> Iterator[sp.Expr]:
    """The same polynomial on the circle: as it is, in the cosine, in the sine, homogeneous."""
    c, s = angle.letters
    # In one of these forms the polynomial may factor, or contain one function only.
    yield f
    yield with_square(f, s, 1 - c**2)
    yield with_square(f, c, 1 - s**2)
    homogeneous = _homogeneous(f, c, s)
    if homogeneous is not None:
        yield homogeneous


def _homogeneous(f: sp.Expr, c: sp.Symbol, s: sp.Symbol) -> sp.Expr | None:
    """Every monomial with the highest degree, by C² + S² = 1; None if the degrees are even and odd."""
    terms = sp.Poly(f, c, s).terms()
    top = max(sum(powers) for powers, _ in terms)
    if top > HIGHEST_DEGREE or any((top - sum(powers)) % 2 for powers, _ in terms):
        return None
    parts = (a * c**m * s**n * (c**2 + s**2) ** ((top - m - n) // 2) for (m, n), a in terms)
    return sp.expand(sp.Add(*parts))


def _angle_factor(f: sp.Expr, angle: LetteredAngle, letters: TrigLetters, squaring: bool) -> list[Root] | None:
    c, s = angle.letters
    if s not in f.free_symbols:
        return _of_one_function(f, angle, sp.cos)
    if c not in f.free_symbols:
        return _of_one_function(f, angle, sp.sin)
    terms = sp.Poly(f, c, s).terms()
    degrees = {sum(powers) for powers, _ in terms}
    if len(degrees) == 1:
        return _of_tangent(f, angle)
    if max(degrees) == 1:
        return _linear(f, angle, letters)
    return _squared(f, angle) if squaring else None


def _of_one_function(f: sp.Expr, angle: LetteredAngle, function: type[sp.Expr]) -> list[Root] | None:
    """cos θ = a, or sin θ = a."""
    cosine = function is sp.cos
    letter, other = angle.letters if cosine else angle.letters[::-1]
    values = polynomial_roots(f, letter)
    if values is None:
        return None
    roots: list[Root] = []
    for v in values:
        special = _special(v.value, angle, cosine)
        if special:
            roots += special
            continue
        conditions = between_minus_one_and_one(v.value if v.stated is None else v.stated)
        if conditions is None:
            continue
        rest = other_wave(v.value)
        relation = Relation(function(angle.measure) ** v.power, v.stated if v.stated is not None else v.value)
        both = tuple({letter: v.value, other: sign * rest} for sign in (1, -1))
        roots.append(Root((relation,), both, (*v.conditions, *conditions), {letter: v.value}))
    return roots


def _special(value: sp.Expr, angle: LetteredAngle, cosine: bool) -> list[Root]:
    """Cosine or sine 0, 1, −1: the angles themselves."""
    pi = sp.pi
    measures = {
        (True, 1): (0,), (True, -1): (pi,), (True, 0): (pi / 2, -pi / 2),
        (False, 1): (pi / 2,), (False, -1): (-pi / 2,), (False, 0): (0, pi),
    }  # fmt: skip
    return [at_angle(angle, sp.Integer(0) + m) for m in measures.get((cosine, value), ())]


def at_angle(angle: LetteredAngle, measure: sp.Expr) -> Root:
    """θ itself; where θ/2 occurs it is distinguished from θ + 2π, and −π from π."""
    c, s = angle.letters
    [unknown] = angle.measure.free_symbols
    share = angle.measure / unknown
    relation = Relation(unknown, between_minus_pi_and_pi(measure) / share)
    return Root((relation,), ({c: sp.cos(measure), s: sp.sin(measure)},))


def root_at(angle: LetteredAngle, values: Values) -> Root:
    """An angle given by both cosine and sine: as a share of π where it is one."""
    cosine, sine = (values[s] for s in angle.letters)
    if cosine.is_number and sine.is_number:
        measure = sp.atan2(sine, cosine)
        if (measure / sp.pi).is_Rational:
            return at_angle(angle, measure)
    return Root((Relation(sp.sin(angle.measure), sine), Relation(sp.cos(angle.measure), cosine)), (values,))


def between_minus_pi_and_pi(angle: sp.Expr) -> sp.Expr:
    """An angle modulo 2π, if it is a multiple of π: above −π, up to π."""
    turns = angle / sp.pi
    if not turns.is_Rational:
        return angle
    turns = turns % 2
    return (turns - 2 if turns > 1 else turns) * sp.pi


def _of_tangent(f: sp.Expr, angle: LetteredAngle) -> list[Root] | None:
    """tan θ = a, from an equation homogeneous in cosine and sine."""
    c, s = angle.letters
    tangent = sp.Dummy("tan", real=True)
    values = polynomial_roots(sp.expand(f.xreplace({s: tangent, c: sp.S.One})), tangent)
    if values is None:
        return None
    roots = []
    for v in values:
        above, below = sp.fraction(sp.together(v.value))
        length = square_root(above**2 + below**2)
        both = tuple({c: sign * below / length, s: sign * above / length} for sign in (1, -1))
        relation = Relation(sp.tan(angle.measure) ** v.power, v.stated if v.stated is not None else v.value)
        conditions = tuple(x for x in v.conditions if x.relation != "≠")  # tan θ may be infinite
        roots.append(Root((relation,), both, conditions, {s: c * v.value}))
    return roots


def _linear(f: sp.Expr, angle: LetteredAngle, letters: TrigLetters) -> list[Root]:
    """a sin θ + b cos θ + d = 0."""
    c, s = angle.letters
    poly = sp.Poly(f, c, s)
    a, b, d = (sp.factor(poly.coeff_monomial(m)) for m in (s, c, 1))
    # The line a S + b C + d = 0 meets the circle on either side of its foot (S, C) = −d (a, b)/(a² + b²).
    square = sp.factor(letters.shortest(a**2 + b**2))
    radicand = sp.factor(letters.shortest(square - d**2))
    conditions = not_negative(radicand)
    if conditions is None:
        return []
    root = square_root(radicand)
    roots = []
    for sign in (1, -1):
        sine, cosine = (factored_quotient(e / square) for e in (-a * d - sign * b * root, -b * d + sign * a * root))
        special = _known_point(cosine, sine, angle)
        relations = (Relation(sp.sin(angle.measure), sine), Relation(sp.cos(angle.measure), cosine))
        roots.append(special or Root(relations, ({c: cosine, s: sine},), conditions))
    return roots


def _known_point(cosine: sp.Expr, sine: sp.Expr, angle: LetteredAngle) -> Root | None:
    """The angle itself where its cosine and sine are 0, 1 or −1."""
    measures = {(1, 0): 0, (-1, 0): sp.pi, (0, 1): sp.pi / 2, (0, -1): -sp.pi / 2}
    measure = measures.get((cosine, sine))
    return None if measure is None else at_angle(angle, sp.Integer(0) + measure)


def _squared(f: sp.Expr, angle: LetteredAngle) -> list[Root] | None:
    """A(C) + B(C) S = 0: A² = B² (1 − C²), then S = −A/B."""
    c, s = angle.letters
    poly = sp.Poly(with_square(f, s, 1 - c**2), s)
    a, b = poly.coeff_monomial(1), poly.coeff_monomial(s)
    pieces = irreducible_factors(sp.expand(a**2 - b**2 * (1 - c**2)))
    if pieces is None:
        return None
    roots: list[Root] = []
    for piece in pieces:
        if c not in piece.free_symbols:
            continue
        values = polynomial_roots(piece, c)
        if values is None:
            return None
        for v in values:
            sine = _quotient(-a, b, {c: v.value})
            both = [sine] if sine is not None else [sign * other_wave(v.value) for sign in (1, -1)]
            conditions = between_minus_one_and_one(v.value)
            for value in both if conditions is not None else ():
                relations = (Relation(sp.cos(angle.measure), v.value), Relation(sp.sin(angle.measure), value))
                special = _known_point(v.value, value, angle)
                roots.append(
                    special or Root(relations, ({c: v.value, s: value},), (*v.conditions, *(conditions or ())))
                )
    return roots


def one_unknown(f: sp.Expr, u: sp.Symbol, letters: TrigLetters) -> list[Root] | None:
    """All roots of a polynomial equation f = 0 by one unknown; None if they are not found in closed form."""
    if u in letters.angles:
        return angle_roots(f, u, letters)
    pieces = irreducible_factors(f)
    if pieces is None:
        return None
    roots_of_pieces = [plain_roots(p, u, letters) for p in pieces if u in letters.unknowns_in(p)]
    if any(r is None for r in roots_of_pieces):
        return None
    return [root for roots in roots_of_pieces for root in roots or ()]


def trivial_solutions(equations: Sequence[sp.Expr], letters: TrigLetters) -> Iterator[Values]:
    """The values of unknowns, and of their letters, with which all equations (in letters) vanish."""
    occurring = frozenset[sp.Symbol]().union(*map(letters.unknowns_in, equations))
    unknowns = [u for u in letters.unknowns if u in occurring]
    if len(unknowns) > MOST_TRIVIAL_UNKNOWNS:
        return
    for place in product(*((sp.S.Zero, sp.pi) if u in letters.angles else (sp.S.Zero,) for u in unknowns)):
        values: dict[sp.Symbol, sp.Expr] = {}
        for u, value in zip(unknowns, place, strict=True):
            values[u] = value
            if u in letters.angles:
                angle = letters.angles[u]
                measure = angle.measure.xreplace({u: value})
                values |= {angle.cosine: sp.cos(measure), angle.sine: sp.sin(measure)}
        if all(sp.expand(e.xreplace(values)) == 0 for e in equations):
            yield values


def parallel_angles(
    e: sp.Expr, unknowns: Sequence[sp.Symbol], letters: TrigLetters
) -> tuple[sp.Symbol, sp.Symbol, int] | None:
    """The angles of a multiple of sin(α − β), with +1, or of sin(α + β), with −1, an equation in letters; else None."""
    angles = [u for u in unknowns if u in letters.angles and letters.angles[u].measure == u]
    for (a, b), sign in product(combinations(angles, 2), (1, -1)):
        (cos_a, sin_a), (cos_b, sin_b) = letters.angles[a].letters, letters.angles[b].letters
        share = sp.expand(e).coeff(sin_a * cos_b)
        if share.is_number and share != 0 and sp.expand(e - share * (sin_a * cos_b - sign * cos_a * sin_b)) == 0:
            return a, b, sign
    return None


def pair_of_sum(angle: sp.Expr, letters: TrigLetters) -> tuple[sp.Expr, sp.Expr] | None:
    """Cosine and sine of an angle in the letters of the unknowns; None where it is no sum of multiples of them."""
    for term in sp.Add.make_args(sp.expand(angle)):
        unknown = letters.unknowns_in(term)
        if unknown and not (term.as_coeff_Mul()[1] in unknown and term.as_coeff_Mul()[1] in letters.angles):
            return None
    try:
        return letters.pair(angle)
    except NotAlgebraicError:
        return None
