"""Products of powers of SymPy expressions, and what an equation can be divided by.

A product is a number and a dictionary factor -> exponent, the last step before an expression is made:

    m r² sin²θ φ'' + 2 m r r' φ' sin²θ + 2 m r² θ' φ' sin θ cos θ  =  m r sin θ (r φ'' sin θ + ...) .

m is a positive parameter and cannot vanish; r sin θ can, so that dividing by it excludes the axis, a condition that has
to be stated. Velocities and accelerations are never divided by; in denominators they are multiplied out. Equations are
taken in textbook form (`textbook_form`).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import lru_cache

import sympy as sp

from lagrange.algebra.fourier.limits import LONGEST_FACTORED
from lagrange.algebra.fourier.polynomials import common_number, factorization, pack, unpack
from lagrange.core.records import record
from lagrange.core.symbols import base, never_vanishes

Exponent = int | Fraction  # Python's numbers: SymPy's are ten times as slow to add and compare
Factors = dict[sp.Expr, Exponent]  # what is multiplied -> exponent


@record
class PowerProduct:
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

    def scaled(self, number: Fraction) -> PowerProduct:
        """The product times a number."""
        return PowerProduct(self.number * number, self.factors)

    def __mul__(self, other: PowerProduct) -> PowerProduct:
        return PowerProduct(self.number * other.number, multiplied(self.factors, other.factors))

    def __truediv__(self, other: PowerProduct) -> PowerProduct:
        return PowerProduct(self.number / other.number, quotient_of_powers(self.factors, other.factors))


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


def quotient_of_powers(a: Factors, b: Factors) -> Factors:
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
    powers = dict(factors)
    for cosine, below in factors.items():
        if below < 0 and below.denominator == 1 and isinstance(cosine, sp.cos):
            sine = sp.sin(cosine.args[0])
            above = factors.get(sine, 0)
            if above > 0 and above.denominator == 1:
                power = min(above, -below)
                for factor, e in ((sine, -power), (cosine, power), (sp.tan(cosine.args[0]), power)):
                    multiply(powers, factor, e)
    return powers


def with_one_exponential(factors: Factors) -> Factors:
    """exp(b x_1) exp(−b x_2) written as exp(b (x_1 − x_2))."""
    exponentials = [f for f in factors if type(f) is sp.exp]
    if len(exponentials) < 2:
        return factors
    powers = {f: e for f, e in factors.items() if type(f) is not sp.exp}
    powers[sp.exp(sp.factor_terms(sp.Add(*(f.exp * sp.Rational(factors[f]) for f in exponentials))))] = 1
    return powers


def number_apart(expression: sp.Expr) -> tuple[sp.Rational, sp.Expr]:
    """2 M + 2 m as 2 and M + m."""
    summands = [summand.as_coeff_Mul() for summand in sp.Add.make_args(expression)]
    number = sp.Rational(common_number(Fraction(int(c.p), int(c.q)) for c, _ in summands))
    return number, sp.Add(*(c / number * e for c, e in summands))


def sum_of(terms: Iterable[PowerProduct]) -> sp.Expr:
    """The sum."""
    return sp.Add(*(term.to_sympy() for term in terms))


def are_summands(terms: Collection[PowerProduct]) -> bool:
    """Whether SymPy keeps the sum as these products, one term each, and identifies none of them with another.

    It multiplies 2 (a + b) out, joins powers and like terms, and turns the sign of a base; then the answer is no.
    """
    return len({frozenset(term.factors.items()) for term in terms}) == len(terms) > 0 and all(map(_is_summand, terms))


def _is_summand(term: PowerProduct) -> bool:
    sums = 0
    for factor, exponent in term.factors.items():
        if factor.is_Add and exponent == 1:
            sums += 1
        elif not (factor.is_Symbol or isinstance(factor, sp.sin | sp.cos)) or exponent < 0 or exponent.denominator != 1:
            return False
    return term.number != 0 and 0 < len(term.factors) > sums <= 1


def factored_sum(terms: list[PowerProduct]) -> PowerProduct | None:
    """A sum without common factors as a product, if that takes fewer operations."""
    exponents = [e for term in terms for e in term.factors.values()]
    if not 2 < len(terms) <= LONGEST_FACTORED or not all(e > 0 and e.denominator == 1 for e in exponents):
        return None
    factors = list(dict.fromkeys(f for term in terms for f in term.factors))
    places = {f: i for i, f in enumerate(factors)}
    polynomial = {pack((places[f], int(e)) for f, e in term.factors.items()): term.number for term in terms}
    sign, factors_found = factorization(polynomial)
    if len(polynomial) < len(terms) or (len(factors_found) == 1 and factors_found[0][1] == 1):
        return None
    product = PowerProduct(Fraction(sign), {})
    for p, exponent in factors_found:
        members = [PowerProduct(c, {factors[i]: e for i, e in unpack(m)}) for m, c in p.items()]
        turned = _sign(members)
        total = sum_of(term.scaled(Fraction(turned)) for term in members)
        product = product * PowerProduct(Fraction(turned**exponent), {total: exponent})
    return product


def _sign(terms: list[PowerProduct]) -> int:
    """The sign of most terms; of the shortest, where as many are minus as plus."""
    balance = sum(1 if term.number > 0 else -1 for term in terms)
    if balance == 0:
        first = min(
            terms, key=lambda term: (len(term.factors), str(PowerProduct(Fraction(1), term.factors).to_sympy()))
        )
        balance = 1 if first.number > 0 else -1
    return 1 if balance > 0 else -1


@record
class CommonFactor:
    """The factor that an equation is divided by: number · Π factor ** exponent.

    Kept apart, because SymPy multiplies 2 (m1 + m2) out and no longer cancels it against m1 + m2.
    """

    number: sp.Rational
    powers: tuple[tuple[sp.Expr, Exponent], ...]

    @property
    def parameters(self) -> sp.Expr:
        """The number and what cannot vanish, such as positive parameters: m in m r sin θ."""
        return _unexpanded(self.number, [f**e for f, e in self.powers if never_vanishes(f)])

    @property
    def state(self) -> sp.Expr:
        """The factors that may vanish: r sin θ in m r sin θ."""
        return sp.Mul(*(f**e for f, e in self.powers if not never_vanishes(f)))

    @property
    def expression(self) -> sp.Expr:
        """The whole factor."""
        return _unexpanded(self.number, [f**e for f, e in self.powers])

    @property
    def nonzero(self) -> tuple[sp.Expr, ...]:
        """The factors assumed not to vanish, one by one: r, sin θ."""
        return tuple(f for f, e in self.powers if e > 0 and not never_vanishes(f))

    @property
    def numerator(self) -> CommonFactor:
        """The divisor: the number's numerator and the positive powers."""
        return CommonFactor(sp.Integer(self.number.p), tuple((f, e) for f, e in self.powers if e > 0))

    @property
    def denominator(self) -> CommonFactor:
        """The multiplier: the number's denominator and the negative powers."""
        return CommonFactor(sp.Integer(self.number.q), tuple((f, -e) for f, e in self.powers if e < 0))

    def only(self, wanted: Callable[[sp.Expr], bool]) -> CommonFactor:
        """The number and those of the factors for which `wanted` holds."""
        return CommonFactor(self.number, tuple((f, e) for f, e in self.powers if wanted(f)))

    def divide(self, expression: sp.Expr) -> sp.Expr:
        """An expression of which this is the factor, divided by it, term by term."""
        return self._times(expression, -1)

    def multiply(self, expression: sp.Expr) -> sp.Expr:
        """An expression times this, term by term."""
        return self._times(expression, 1)

    def _times(self, expression: sp.Expr, exponent: int) -> sp.Expr:
        return self._product(map(as_term, sp.Add.make_args(expression)), exponent)

    def divide_terms(self, terms: Iterable[PowerProduct]) -> sp.Expr:
        """The sum of these products divided by it, term by term."""
        return self._product(terms, -1)

    def _product(self, terms: Iterable[PowerProduct], exponent: int) -> sp.Expr:
        number = Fraction(self.number.p, self.number.q) ** exponent
        other = PowerProduct(number, {f: exponent * e for f, e in self.powers})
        return sum_of(term * other for term in terms)


def _unexpanded(number: sp.Rational, factors: list[sp.Expr]) -> sp.Expr:
    """The product; 2 (m1 + m2) is not multiplied out."""
    product = sp.Mul(*factors)
    return sp.Mul(number, product, evaluate=False) if product.is_Add and number != 1 else number * product


def common_factor(expression: sp.Expr) -> CommonFactor:
    """The factor common to all terms of an expression, sign and velocities excepted.

    A denominator is in common if an acceleration has it, or if there are no accelerations: x'' y/x + y'' has
    the factor 1/x, r'' + k/r² none. The expression is taken as it is written: bring it to textbook form first.
    """
    if expression == 0:
        return CommonFactor(sp.S.One, ())
    return common_factor_of([as_term(summand) for summand in sp.Add.make_args(expression)])


def common_factor_of(terms: Sequence[PowerProduct]) -> CommonFactor:
    """The common factor of the sum of these products."""
    powers = [term.factors for term in terms]
    # Only a denominator that an acceleration has as well is multiplied out: r'' + k/r² stays.
    leading = [d for d in powers if any(map(is_acceleration, d))] or powers
    common = common_powers(powers)
    for factor in dict.fromkeys(f for d in leading for f in d):
        common[factor] = min(common.get(factor, 0), *(d.get(factor, 0) for d in leading))
    number = common_number(term.number for term in terms)
    return CommonFactor(
        sp.Rational(number), tuple((f, e) for f, e in common.items() if e and not (e > 0 and is_slot(f)))
    )


@lru_cache(maxsize=1 << 12)  # an equation is taken apart to find its common factor, and again to divide by it
def as_term(product: sp.Expr) -> PowerProduct:
    """Number and rational powers of a product; tan w is sin w/cos w."""
    number, rest = product.as_coeff_Mul()
    if not number.is_Rational:
        number, rest = sp.S.One, product
    powers: Factors = {}
    for factor in sp.Mul.make_args(rest):
        below, exponent = factor.as_base_exp()
        if isinstance(factor, sp.exp):
            exponent, angle = factor.exp.as_coeff_Mul()
            multiply(powers, sp.exp(angle), exponent_of(exponent))
        elif not exponent.is_Rational:
            multiply(powers, factor, 1)
        elif isinstance(below, sp.tan):
            multiply(powers, sp.sin(below.args[0]), exponent_of(exponent))
            multiply(powers, sp.cos(below.args[0]), -exponent_of(exponent))
        else:
            multiply(powers, below, exponent_of(exponent))
    powers.pop(sp.S.One, None)
    return PowerProduct(Fraction(int(number.p), int(number.q)), powers)


def normalised(expression: sp.Expr, leading: Iterable[sp.Symbol] = ()) -> sp.Expr:
    """The expression or its negative, whichever has its leading term positive.

    That is the term with the first acceleration of `leading` that occurs; without one, most of the terms with
    an acceleration; without any acceleration, most of all terms.
    """
    terms = sp.Add.make_args(expression)

    def groups() -> Iterator[list[sp.Expr]]:
        yield from ([term for term in terms if term.has(symbol)] for symbol in leading)
        yield [term for term in terms if any(is_acceleration(s) for s in term.free_symbols)]
        yield list(terms)

    balance = next((b for b in map(_balance, groups()) if b), 1)
    return expression if balance > 0 else sp.Add(*(-term for term in terms))


def _balance(terms: Iterable[sp.Expr]) -> int:
    return sum(-1 if term.as_coeff_Mul()[0].is_negative else 1 for term in terms)


def is_displacement(expression: sp.Expr) -> bool:
    """Whether it is a differential or a virtual displacement: d(x), delta(x)."""
    return isinstance(expression, sp.Symbol) and str(expression.name).startswith(("delta(", "d("))


def is_slot(expression: sp.Expr) -> bool:
    """Whether it is a velocity, an acceleration or a displacement, which is not divided by."""
    return isinstance(expression, sp.Symbol) and (base(expression) != expression or is_displacement(expression))


def is_acceleration(expression: sp.Expr) -> bool:
    """Whether it is a symbol q''."""
    return isinstance(expression, sp.Symbol) and str(expression.name).endswith("''")
