"""One equation in one unknown, solved in closed form: all real roots, with the conditions under which they exist.

    polynomials      see `polynomial_roots`
    angles           sin θ = a,  cos θ = a,  tan θ = a (homogeneous equations),  a sin θ + b cos θ = c,
                     and A(cos θ) + B(cos θ) sin θ = 0, squared, where the polynomial that results can be solved
    square roots     A + B √D = 0 is A² = B² D with −A/B ≥ 0

Everything is in the letters of `unit_circle`. What an equation is divided by is assumed not to be zero for the
parameters in general; the factors that contain an unknown are solved for themselves.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field
from typing import TypeAlias

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import (
    HIGHEST_DEGREE,
    factors,
    numerator,
    polynomial_roots,
    square_root,
    tidied,
)
from lagrange.algebra.closed_forms.signs import Condition, between_minus_one_and_one, not_negative
from lagrange.algebra.closed_forms.unit_circle import Angle, Letters, with_square
from lagrange.core.records import record

Values: TypeAlias = Mapping[sp.Symbol, sp.Expr]


@record
class Relation:
    """lhs = rhs, as it is stated: cos θ = b/a."""

    lhs: sp.Expr
    rhs: sp.Expr

    @property
    def residual(self) -> sp.Expr:
        """What vanishes."""
        return self.lhs - self.rhs


@record
class Root:
    """One solution of one equation.

    relations   as it is stated
    values      of the letters: one mapping, or two where it leaves a sign open: sin θ = ±√(1 − a²)
    conditions  under which it is real
    common      what holds of the letters whichever the sign: C = a, or S = C tan θ
    """

    relations: tuple[Relation, ...]
    values: tuple[Values, ...]
    conditions: tuple[Condition, ...] = ()
    common: Values = field(default_factory=dict)

    @property
    def on_it(self) -> Values:
        """`common`, which is all values where there is one point."""
        return self.values[0] if len(self.values) == 1 else self.common


def plain_roots(f: sp.Expr, x: sp.Symbol, letters: Letters) -> list[Root] | None:
    """The roots of f = 0 by an unknown that is no angle; f is an irreducible polynomial."""
    under = [r for r in letters.roots if r in f.free_symbols and x in _deep_symbols(r, letters)]
    if under:
        return _without_root(f, x, under[0], letters)
    values = polynomial_roots(f, x)
    if values is None:
        return None
    return [
        Root((Relation(x**v.power, v.shown if v.shown is not None else v.value),), ({x: v.value},), v.conditions)
        for v in values
    ]


def _deep_symbols(root: sp.Symbol, letters: Letters) -> set[sp.Symbol]:
    found = set(letters.roots[root].free_symbols)
    for r in found & letters.roots.keys():
        found |= _deep_symbols(r, letters)
    return found


def _linear_in(f: sp.Expr, letter: sp.Symbol, letters: Letters) -> tuple[sp.Expr, sp.Expr] | None:
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


def _without_root(f: sp.Expr, u: sp.Symbol, letter: sp.Symbol, letters: Letters) -> list[Root] | None:
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


def _with_square_root(r: Root, letter: sp.Symbol, parts: tuple[sp.Expr, sp.Expr], letters: Letters) -> Iterator[Root]:
    """The values of a root of the squared equation at which R = −A/B may be positive, by the conditions for that."""
    a, b = parts
    groups: dict[tuple[Condition, ...], list[Values]] = {}
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
    below = tidied(b.xreplace(dict(values)))
    return None if below == 0 else tidied(a.xreplace(dict(values)) / below)


# Angles


def angle_roots(f: sp.Expr, u: sp.Symbol, letters: Letters) -> list[Root] | None:
    """The roots of f = 0 by an angle; f is a polynomial in its cosine and sine."""
    angle = letters.angles[u]
    if u in f.free_symbols:
        return None
    under = [r for r in letters.roots if r in f.free_symbols and set(angle.letters) & _deep_symbols(r, letters)]
    if under:
        return _without_root(f, u, under[0], letters)
    forms = [pieces for form in _forms(f, angle) if (pieces := factors(form)) is not None]
    for squaring in (False, True):
        for pieces in forms:
            found = [_angle_factor(p, angle, letters, squaring) for p in pieces if set(angle.letters) & p.free_symbols]
            if all(r is not None for r in found):
                return [root for roots in found for root in roots or ()]
    return None


def _forms(f: sp.Expr, angle: Angle) -> Iterator[sp.Expr]:
    """The same polynomial on the circle: as it is, in the cosine, in the sine, homogeneous."""
    c, s = angle.letters
    yield f
    yield with_square(f, s, 1 - c**2)
    yield with_square(f, c, 1 - s**2)
    homogeneous = _homogeneous(f, c, s)
    if homogeneous is not None:
        yield homogeneous


def _homogeneous(f: sp.Expr, c: sp.Symbol, s: sp.Symbol) -> sp.Expr | None:
    """Every monomial with the highest degree, by C² + S² = 1; None where the degrees are even and odd."""
    terms = sp.Poly(f, c, s).terms()
    top = max(sum(powers) for powers, _ in terms)
    if top > HIGHEST_DEGREE or any((top - sum(powers)) % 2 for powers, _ in terms):
        return None
    parts = (a * c**m * s**n * (c**2 + s**2) ** ((top - m - n) // 2) for (m, n), a in terms)
    return sp.expand(sp.Add(*parts))


def _angle_factor(f: sp.Expr, angle: Angle, letters: Letters, squaring: bool) -> list[Root] | None:
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


def _of_one_function(f: sp.Expr, angle: Angle, function: type[sp.Expr]) -> list[Root] | None:
    """cos θ = a, or sin θ = a."""
    cosine = function is sp.cos
    letter, other = angle.letters if cosine else angle.letters[::-1]
    values = polynomial_roots(f, letter)
    if values is None:
        return None
    found: list[Root] = []
    for v in values:
        special = _special(v.value, angle, cosine)
        if special:
            found += special
            continue
        conditions = between_minus_one_and_one(v.value if v.shown is None else v.shown)
        if conditions is None:
            continue
        rest = square_root(1 - v.value**2)
        shown = Relation(function(angle.measure) ** v.power, v.shown if v.shown is not None else v.value)
        both = tuple({letter: v.value, other: sign * rest} for sign in (1, -1))
        found.append(Root((shown,), both, (*v.conditions, *conditions), {letter: v.value}))
    return found


def _special(value: sp.Expr, angle: Angle, cosine: bool) -> list[Root]:
    """Cosine or sine 0, 1, −1: the angles themselves."""
    pi = sp.pi
    measures = {
        (True, 1): (0,), (True, -1): (pi,), (True, 0): (pi / 2, -pi / 2),
        (False, 1): (pi / 2,), (False, -1): (-pi / 2,), (False, 0): (0, pi),
    }  # fmt: skip
    return [at_angle(angle, sp.Integer(0) + m) for m in measures.get((cosine, value), ())]


def at_angle(angle: Angle, measure: sp.Expr) -> Root:
    """θ itself; where θ/2 occurs it is told from θ + 2π, and −π from π."""
    c, s = angle.letters
    [unknown] = angle.measure.free_symbols
    share = angle.measure / unknown
    relation = Relation(unknown, between_minus_pi_and_pi(measure) / share)
    return Root((relation,), ({c: sp.cos(measure), s: sp.sin(measure)},))


def between_minus_pi_and_pi(angle: sp.Expr) -> sp.Expr:
    """An angle modulo 2π, if it is a multiple of π: above −π, up to π."""
    turns = angle / sp.pi
    if not turns.is_Rational:
        return angle
    turns = turns % 2
    return (turns - 2 if turns > 1 else turns) * sp.pi


def _of_tangent(f: sp.Expr, angle: Angle) -> list[Root] | None:
    """tan θ = a, from an equation homogeneous in cosine and sine."""
    c, s = angle.letters
    tangent = sp.Dummy("tan", real=True)
    values = polynomial_roots(sp.expand(f.xreplace({s: tangent, c: sp.S.One})), tangent)
    if values is None:
        return None
    found = []
    for v in values:
        above, below = sp.fraction(sp.together(v.value))
        length = square_root(above**2 + below**2)
        both = tuple({c: sign * below / length, s: sign * above / length} for sign in (1, -1))
        relation = Relation(sp.tan(angle.measure) ** v.power, v.shown if v.shown is not None else v.value)
        conditions = tuple(x for x in v.conditions if x.relation != "≠")  # tan θ may be infinite
        found.append(Root((relation,), both, conditions, {s: c * v.value}))
    return found


def _linear(f: sp.Expr, angle: Angle, letters: Letters) -> list[Root]:
    """a sin θ + b cos θ + d = 0."""
    c, s = angle.letters
    poly = sp.Poly(f, c, s)
    a, b, d = (sp.factor(poly.coeff_monomial(m)) for m in (s, c, 1))
    square = sp.factor(letters.shortest(a**2 + b**2))
    radicand = sp.factor(letters.shortest(square - d**2))
    conditions = not_negative(radicand)
    if conditions is None:
        return []
    root = square_root(radicand)
    found = []
    for sign in (1, -1):
        sine, cosine = (tidied(e / square) for e in (-a * d - sign * b * root, -b * d + sign * a * root))
        special = _known_point(cosine, sine, angle)
        relations = (Relation(sp.sin(angle.measure), sine), Relation(sp.cos(angle.measure), cosine))
        found.append(special or Root(relations, ({c: cosine, s: sine},), conditions))
    return found


def _known_point(cosine: sp.Expr, sine: sp.Expr, angle: Angle) -> Root | None:
    """The angle itself where its cosine and sine are 0, 1 or −1."""
    measures = {(1, 0): 0, (-1, 0): sp.pi, (0, 1): sp.pi / 2, (0, -1): -sp.pi / 2}
    found = measures.get((cosine, sine))
    return None if found is None else at_angle(angle, sp.Integer(0) + found)


def _squared(f: sp.Expr, angle: Angle) -> list[Root] | None:
    """A(C) + B(C) S = 0: A² = B² (1 − C²), then S = −A/B."""
    c, s = angle.letters
    poly = sp.Poly(with_square(f, s, 1 - c**2), s)
    a, b = poly.coeff_monomial(1), poly.coeff_monomial(s)
    pieces = factors(sp.expand(a**2 - b**2 * (1 - c**2)))
    if pieces is None:
        return None
    found: list[Root] = []
    for piece in pieces:
        if c not in piece.free_symbols:
            continue
        values = polynomial_roots(piece, c)
        if values is None:
            return None
        for v in values:
            sine = _quotient(-a, b, {c: v.value})
            both = [sine] if sine is not None else [sign * square_root(1 - v.value**2) for sign in (1, -1)]
            conditions = between_minus_one_and_one(v.value)
            for value in both if conditions is not None else ():
                relations = (Relation(sp.cos(angle.measure), v.value), Relation(sp.sin(angle.measure), value))
                special = _known_point(v.value, value, angle)
                found.append(
                    special or Root(relations, ({c: v.value, s: value},), (*v.conditions, *(conditions or ())))
                )
    return found


def one_unknown(f: sp.Expr, u: sp.Symbol, letters: Letters) -> list[Root] | None:
    """All roots of a polynomial equation f = 0 by one unknown; None where they are not found in closed form."""
    if u in letters.angles:
        return angle_roots(f, u, letters)
    pieces = factors(f)
    if pieces is None:
        return None
    found = [plain_roots(p, u, letters) for p in pieces if u in letters.unknowns_in(p)]
    if any(r is None for r in found):
        return None
    return [root for roots in found for root in roots or ()]
