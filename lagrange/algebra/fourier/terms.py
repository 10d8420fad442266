"""Products of powers of SymPy expressions, as dictionaries: the last step before an expression is made."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

import sympy as sp

from lagrange.algebra.fourier.packing import pack, unpack
from lagrange.algebra.fourier.polynomials import common_number, factorization
from lagrange.core.records import record

LONGEST = 24  # a longer sum is not factored

Exponent = int | Fraction  # Python's numbers: SymPy's are ten times as slow to add and compare
Factors = dict[sp.Expr, Exponent]  # what is multiplied -> exponent


@record
class Term:
    """number · Π factor ** exponent."""

    number: Fraction
    factors: Factors

    def to_sympy(self) -> sp.Expr:
        """The product; sin w/cos w is written tan w, and a product of exponential functions as one."""
        factors = with_one_exponential(with_tangents(self.factors))
        powers = [f if e == 1 else f ** sp.Rational(e) for f, e in factors.items()]
        if self.number == 1:
            return powers[0] if len(powers) == 1 else sp.Mul(*powers)
        return sp.Mul(sp.Rational(self.number.numerator, self.number.denominator), *powers)

    def scaled(self, number: Fraction) -> Term:
        """The product times a number."""
        return Term(self.number * number, self.factors)

    def __mul__(self, other: Term) -> Term:
        return Term(self.number * other.number, multiplied(self.factors, other.factors))

    def __truediv__(self, other: Term) -> Term:
        return Term(self.number / other.number, divided(self.factors, other.factors))


def exponent_of(number: sp.Rational) -> Exponent:
    """SymPy's number as Python's."""
    return int(number.p) if number.q == 1 else Fraction(int(number.p), int(number.q))


def multiply(factors: Factors, factor: sp.Expr, exponent: Exponent) -> None:
    """One more power, into a dictionary of powers."""
    total = factors.get(factor, 0) + exponent
    if total:
        factors[factor] = total
    else:
        factors.pop(factor, None)


def multiplied(a: Factors, b: Factors) -> Factors:
    """The powers of a product."""
    product = dict(a)
    for factor, exponent in b.items():
        multiply(product, factor, exponent)
    return product


def divided(a: Factors, b: Factors) -> Factors:
    """The powers of a quotient."""
    return multiplied(a, {factor: -exponent for factor, exponent in b.items()})


def common_powers(dictionaries: list[Factors]) -> Factors:
    """The powers that all have in common; of negative ones the least negative, if all are negative."""
    common: Factors = {}
    for factor in dictionaries[0]:
        exponents = [d.get(factor, 0) for d in dictionaries]
        if min(exponents) > 0:
            common[factor] = min(exponents)
        elif max(exponents) < 0:
            common[factor] = max(exponents)
    return common


def with_tangents(factors: Factors) -> Factors:
    """sin w/cos w written as tan w."""
    if all(e > 0 for e in factors.values()):
        return factors
    found = dict(factors)
    for cosine, below in factors.items():
        if below < 0 and below.denominator == 1 and isinstance(cosine, sp.cos):
            sine = sp.sin(cosine.args[0])
            above = factors.get(sine, 0)
            if above > 0 and above.denominator == 1:
                power = min(above, -below)
                for factor, e in ((sine, -power), (cosine, power), (sp.tan(cosine.args[0]), power)):
                    multiply(found, factor, e)
    return found


def with_one_exponential(factors: Factors) -> Factors:
    """exp(b x_1) exp(−b x_2) written as exp(b (x_1 − x_2))."""
    exponentials = [f for f in factors if type(f) is sp.exp]
    if len(exponentials) < 2:
        return factors
    found = {f: e for f, e in factors.items() if type(f) is not sp.exp}
    found[sp.exp(sp.factor_terms(sp.Add(*(f.exp * sp.Rational(factors[f]) for f in exponentials))))] = 1
    return found


def number_apart(expression: sp.Expr) -> tuple[sp.Rational, sp.Expr]:
    """2 M + 2 m as 2 and M + m."""
    summands = [summand.as_coeff_Mul() for summand in sp.Add.make_args(expression)]
    number = sp.Rational(common_number(Fraction(int(c.p), int(c.q)) for c, _ in summands))
    return number, sp.Add(*(c / number * e for c, e in summands))


def sum_of(terms: Iterable[Term]) -> sp.Expr:
    """The sum."""
    return sp.Add(*(term.to_sympy() for term in terms))


def factored_sum(terms: list[Term]) -> Term | None:
    """A sum without common factors as a product, if that takes fewer operations."""
    exponents = [e for term in terms for e in term.factors.values()]
    if not 2 < len(terms) <= LONGEST or not all(e > 0 and e.denominator == 1 for e in exponents):
        return None
    factors = list(dict.fromkeys(f for term in terms for f in term.factors))
    places = {f: i for i, f in enumerate(factors)}
    polynomial = {pack((places[f], int(e)) for f, e in term.factors.items()): term.number for term in terms}
    sign, found = factorization(polynomial)
    if len(polynomial) < len(terms) or (len(found) == 1 and found[0][1] == 1):
        return None
    product = Term(Fraction(sign), {})
    for p, exponent in found:
        members = [Term(c, {factors[i]: e for i, e in unpack(m)}) for m, c in p.items()]
        turned = _sign(members)
        total = sum_of(term.scaled(Fraction(turned)) for term in members)
        product = product * Term(Fraction(turned**exponent), {total: exponent})
    return product


def _sign(terms: list[Term]) -> int:
    """The sign of most terms; of the shortest, where as many are minus as plus."""
    balance = sum(1 if term.number > 0 else -1 for term in terms)
    if balance == 0:
        first = min(terms, key=lambda term: (len(term.factors), str(Term(Fraction(1), term.factors).to_sympy())))
        balance = 1 if first.number > 0 else -1
    return 1 if balance > 0 else -1
