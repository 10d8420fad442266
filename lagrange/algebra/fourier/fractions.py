"""Quotients of Fourier sums in lowest terms.

With u = tan(θ/2) a Fourier sum is a polynomial in u over a power of 1 + u²:

    cos θ = (1 − u²)/(1 + u²) ,    sin θ = 2u/(1 + u²) ,

so that the greatest common divisor of two sums is one of polynomials with whole coefficients. The cofactors are
translated back by u²/(1 + u²) = ½ (1 − cos θ), u/(1 + u²) = ½ sin θ and 1/(1 + u²) = ½ (1 + cos θ). SymPy's `cancel`
treats sin θ and cos θ as independent and does not see that C + m R² − m R² sin²θ divides by C + m R² cos²θ.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import sympy as sp

from lagrange.algebra.fourier.division import exact_quotient
from lagrange.algebra.fourier.elements import Basis, Element
from lagrange.algebra.fourier.limits import (
    HIGHEST_HALF_ANGLE,
    LONGEST_CANCELLED,
    MOST_HALF_ANGLE_TERMS,
    MOST_QUOTIENT_OPERATIONS,
    MULTIPLIED_IN_A_UNIT,
)
from lagrange.algebra.fourier.polynomials import lowest, pack, polynomials_in, unpack
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.algebra.fourier.terms import PowerProduct, common_factor
from lagrange.algebra.fourier.textbook_form import Textbook
from lagrange.core.effort import remembered, spend
from lagrange.core.operations import count_operations


def lowest_terms(numerator: Element, denominator: Element) -> tuple[Element, Element] | None:
    """Two elements with the same quotient and nothing in common; None where nothing is, or where they are too long."""
    if not numerator or max(len(numerator), len(denominator)) > LONGEST_CANCELLED:
        return None
    # Without the monomials no negative power is left for the polynomials; they are put back at the end.
    low = [lowest(m for m, _ in e.terms) for e in (numerator, denominator)]
    pair = [e.over_monomial(m) for e, m in zip((numerator, denominator), low, strict=True)]
    tangents = _HalfAngles(pair)
    if max(tangents.highest, default=0) > HIGHEST_HALF_ANGLE:
        return None
    left = [tangents.polynomial(e) for e in pair]
    if max(map(len, left)) > MOST_HALF_ANGLE_TERMS:
        return None
    common, *left = left[0].cofactors(left[1])
    if common.is_ground and not tangents.is_lower(left):
        return None
    above, below = tangents.elements(left)
    number = Fraction(pair[1].denominator, pair[0].denominator)
    return (above * number).over_monomial(-low[0]), below.over_monomial(-low[1])


def in_lowest_terms(value: sp.Expr) -> sp.Expr:
    """A quotient, in textbook form, without common factors that only show by sin² + cos² = 1; the value itself where
    there are none, or where the result were no shorter.
    """
    if not any(e.has(sp.sin, sp.cos) for e in _denominators(value)):
        return value
    ring = FourierRing()
    above, below = _fraction(value, ring)
    reduced = None if below is None else lowest_terms(above, below)
    if reduced is None:
        return value
    textbook = Textbook(ring)
    n, d = (textbook.form(e) for e in reduced)
    shorter: sp.Expr = textbook.form(ring.from_sympy(n) / ring.from_sympy(d))
    return shorter if count_operations(shorter) < count_operations(value) else value


def as_one_quotient(value: sp.Expr) -> sp.Expr:
    """A value with sums below the line as one quotient of two sums; itself where that were no shorter."""
    if not _denominators(value) or value in remembered().get(one_quotient, ()):
        return value
    ring = FourierRing()
    above, below = _fraction(value, ring)
    if below is None:
        return value
    reduced = lowest_terms(above, below)
    shorter = _written(*(reduced or (above, below)), Textbook(ring), turn=reduced is None)
    return shorter if count_operations(shorter) < count_operations(value) else value


def one_quotient(above: Element, below: Element, textbook: Textbook) -> sp.Expr | None:
    """Two elements that have nothing in common as one quotient of two sums, where there are several velocities above.

    None where their coefficients, each over the denominator, may be shorter. As long as the allowance lasts,
    `as_one_quotient` knows that it is one.
    """
    coefficients = textbook.coefficients(above)
    if len(coefficients) < 2 or not _are_without_roots((above, below)):
        return None
    low = lowest(m for e in (above, below) for m, _ in e.terms)
    above, below = above.over_monomial(low), below.over_monomial(low)
    sums = [f for f in textbook.product(below).factors if f.is_Add]
    if len(sums) != 1 or any(exact_quotient(c, below) for c in coefficients):
        return None
    written = _written(above, below, textbook, turn=True)
    if count_operations(written) > MOST_QUOTIENT_OPERATIONS:
        return None
    remembered().setdefault(one_quotient, set()).add(written)
    return written


def _written(above: Element, below: Element, textbook: Textbook, turn: bool) -> sp.Expr:
    numerator = textbook.form(above)
    factor = common_factor(numerator)
    rest = factor.divide(numerator)
    terms = sp.Add.make_args(rest)
    sign = -1 if all(term.could_extract_minus_sign() for term in terms) else 1
    denominator = textbook.product(below)
    if turn:
        denominator = _with_its_sign(denominator)
    front = PowerProduct(sign * Fraction(factor.number.p, factor.number.q), dict(factor.powers)) / denominator
    return front.to_sympy() * sp.Add(*(sign * term for term in terms))


def _with_its_sign(product: PowerProduct) -> PowerProduct:
    """−(a − b − c) as b + c − a: a determinant has the sign that it came with, which often is that of its value."""
    turned = next((f for f, e in product.factors.items() if f.is_Add and e == 1), None)
    if product.number > 0 or turned is None:
        return product
    factors = {sp.Add(*(-term for term in f.args)) if f is turned else f: e for f, e in product.factors.items()}
    return PowerProduct(-product.number, factors)


def _fraction(value: sp.Expr, ring: FourierRing) -> tuple[Element, Element | None]:
    """Numerator and denominator as elements; the latter None where there are roots, or where they are too long."""
    if count_operations(value) > MOST_QUOTIENT_OPERATIONS:
        return ring.zero, None
    above, below = (ring.from_sympy(e) for e in sp.fraction(sp.together(value)))
    return above, below if below and _are_without_roots((above, below)) else None


def _are_without_roots(elements: Sequence[Element]) -> bool:
    """Whether elements of one ring divide by nothing but symbols."""
    related = elements[0].basis.related
    return all(e > 0 for element in elements for m, _ in element.terms for i, e in unpack(m) if i in related)


def is_quotient_of_sums(value: sp.Expr) -> bool:
    """Whether there is a sum below its line."""
    return value.is_Mul and any(f.is_Pow and f.base.is_Add and f.exp.is_negative for f in value.args)


def _denominators(value: sp.Expr) -> list[sp.Expr]:
    """The sums that are divided by."""
    return [p.base for p in value.atoms(sp.Pow) if p.exp.is_negative and p.base.is_Add]


class _HalfAngles:
    """The generators of some elements and the tangents u of half their angles, as variables of polynomials."""

    def __init__(self, elements: list[Element]) -> None:
        keys = [key for e in elements for key in e.terms]
        self._basis: Basis = elements[0].basis
        self._generators = sorted({i for m, _ in keys for i, _ in unpack(m)})
        self._angles = sorted({i for _, w in keys for i, _ in unpack(w)})
        self.highest = [max(abs(self._turns(w)[k]) for _, w in keys) for k in range(len(self._angles))]
        self._ring = polynomials_in(len(self._generators) + len(self._angles), sp.ZZ)
        self._tangents = self._ring.gens[len(self._generators) :]

    def _turns(self, frequency: int) -> list[int]:
        """A frequency as whole multiples of the angles."""
        places = dict(unpack(frequency))
        return [places.get(i, 0) // self._basis.steps[i] for i in self._angles]

    def polynomial(self, element: Element) -> Any:
        """The element times its denominator and the highest powers of all 1 + u²."""
        total = self._ring.zero
        for (monomial, frequency), (a, b) in element.terms.items():
            powers = dict(unpack(monomial))
            cosine, sine = self._wave(self._turns(frequency))
            place = (*(powers.get(i, 0) for i in self._generators), *(0 for _ in self._angles))
            total += self._ring.from_dict({place: sp.ZZ(1)}) * (a * cosine + b * sine)
            spend((len(cosine) + len(sine)) / MULTIPLIED_IN_A_UNIT)
        return total

    def _wave(self, turns: list[int]) -> tuple[Any, Any]:
        """cos w and sin w: the parts of Π (1 ± i u)^2|n| (1 + u²)^(highest − |n|)."""
        re, im = self._ring.one, self._ring.zero
        for n, u, highest in zip(turns, self._tangents, self.highest, strict=True):
            turned = u if n > 0 else -u
            for _ in range(2 * abs(n)):
                re, im = re - im * turned, im + re * turned
            left = (1 + u**2) ** (highest - abs(n))
            re, im = re * left, im * left
        return re, im

    def elements(self, polynomials: list[Any]) -> list[Element]:
        """Polynomials, divided by the same powers of 1 + u², as elements."""
        over = self._over(polynomials)
        return [self._element(p, over) for p in polynomials]

    def is_lower(self, polynomials: list[Any]) -> bool:
        """Whether they have a power of 1 + cos θ in common, which is nothing but 2/(1 + u²)."""
        return any(n < highest for n, highest in zip(self._over(polynomials), self.highest, strict=True))

    def _over(self, polynomials: list[Any]) -> list[int]:
        """The least powers of 1 + u² over which both are Fourier sums."""
        return [(max(p.degree(u) for p in polynomials) + 1) // 2 for u in self._tangents]

    def _element(self, polynomial: Any, over: list[int]) -> Element:
        cut = len(self._generators)
        summands = []
        for exponents, number in polynomial.terms():
            summand = self._basis.number(int(number)).over_monomial(
                -pack(zip(self._generators, exponents[:cut], strict=True))
            )
            for i, e, n in zip(self._angles, exponents[cut:], over, strict=True):
                turn = pack([(i, self._basis.steps[i])])
                cosine, sine = self._basis.circle(turn), self._basis.circle(turn, sine=True)
                half = Fraction(1, 2)
                minus, plus = (1 - cosine) * half, (1 + cosine) * half
                summand = summand * (sine * half) ** (e % 2) * minus ** (e // 2) * plus ** (n - (e + 1) // 2)
            summands.append(summand)
        return self._basis.total(summands)
