"""What an equation can be divided by.

    m r² sin²θ φ'' + 2 m r r' φ' sin²θ + 2 m r² θ' φ' sin θ cos θ  =  m r sin θ (r φ'' sin θ + ...) :

m is a positive parameter and cannot vanish; r sin θ can, so that dividing by it excludes the axis, which has to be
said. Velocities and accelerations are never divided by; as denominators they are multiplied out. Equations are taken
in textbook form (`textbook.py`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction

import sympy as sp

from lagrange.algebra.fourier.polynomials import common_number
from lagrange.algebra.fourier.terms import Exponent, Factors, Term, common_powers, exponent_of, multiply, sum_of
from lagrange.core.records import record
from lagrange.core.symbols import base


@record
class Factor:
    """What an equation is divided by: number · Π factor ** exponent.

    Kept apart, because SymPy multiplies 2 (m1 + m2) out and no longer cancels it against m1 + m2.
    """

    number: sp.Rational
    powers: tuple[tuple[sp.Expr, Exponent], ...]

    @property
    def parameters(self) -> sp.Expr:
        """The number and what cannot vanish, such as positive parameters: m in m r sin θ."""
        return _unexpanded(self.number, [f**e for f, e in self.powers if f.is_nonzero])

    @property
    def state(self) -> sp.Expr:
        """The rest, which may vanish: r sin θ in m r sin θ."""
        return sp.Mul(*(f**e for f, e in self.powers if not f.is_nonzero))

    @property
    def expression(self) -> sp.Expr:
        """The whole factor."""
        return _unexpanded(self.number, [f**e for f, e in self.powers])

    @property
    def nonzero(self) -> tuple[sp.Expr, ...]:
        """What must be assumed not to vanish, one by one: r, sin θ."""
        return tuple(f for f, e in self.powers if e > 0 and not f.is_nonzero)

    @property
    def numerator(self) -> Factor:
        """What is divided by: the number's numerator and the positive powers."""
        return Factor(sp.Integer(self.number.p), tuple((f, e) for f, e in self.powers if e > 0))

    @property
    def denominator(self) -> Factor:
        """What is multiplied by: the number's denominator and the negative powers."""
        return Factor(sp.Integer(self.number.q), tuple((f, -e) for f, e in self.powers if e < 0))

    def only(self, wanted: Callable[[sp.Expr], bool]) -> Factor:
        """The number and those of the factors for which `wanted` holds."""
        return Factor(self.number, tuple((f, e) for f, e in self.powers if wanted(f)))

    def divide(self, expression: sp.Expr) -> sp.Expr:
        """An expression of which this is the factor, divided by it, term by term."""
        return self._times(expression, -1)

    def multiply(self, expression: sp.Expr) -> sp.Expr:
        """An expression times this, term by term."""
        return self._times(expression, 1)

    def _times(self, expression: sp.Expr, exponent: int) -> sp.Expr:
        number = Fraction(self.number.p, self.number.q) ** exponent
        other = Term(number, {f: exponent * e for f, e in self.powers})
        return sum_of(as_term(summand) * other for summand in sp.Add.make_args(expression))


def _unexpanded(number: sp.Rational, factors: list[sp.Expr]) -> sp.Expr:
    """The product; 2 (m1 + m2) is not multiplied out."""
    product = sp.Mul(*factors)
    return sp.Mul(number, product, evaluate=False) if product.is_Add and number != 1 else number * product


def common_factor(expression: sp.Expr) -> Factor:
    """What all terms of an expression have in common, sign and velocities excepted.

    A denominator is in common if an acceleration has it, or if there are no accelerations: x'' y/x + y'' has
    the factor 1/x, r'' + k/r² none. The expression is taken as it is written: bring it to textbook form first.
    """
    if expression == 0:
        return Factor(sp.S.One, ())
    terms = [as_term(summand) for summand in sp.Add.make_args(expression)]
    powers = [term.factors for term in terms]
    leading = [d for d in powers if any(map(is_acceleration, d))] or powers
    common = common_powers(powers)
    for factor in dict.fromkeys(f for d in leading for f in d):
        common[factor] = min(common.get(factor, 0), *(d.get(factor, 0) for d in leading))
    number = common_number(term.number for term in terms)
    return Factor(sp.Rational(number), tuple((f, e) for f, e in common.items() if e and not (e > 0 and is_slot(f))))


def as_term(product: sp.Expr) -> Term:
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
    return Term(Fraction(int(number.p), int(number.q)), powers)


def normalised(expression: sp.Expr, leading: Iterable[sp.Symbol] = ()) -> sp.Expr:
    """The expression or its negative, whichever has its leading term positive.

    That is the term with the first acceleration of `leading` that occurs; without one, most of the terms with
    an acceleration; without any acceleration, most of all terms.
    """
    terms = sp.Add.make_args(expression)
    groups = [[term for term in terms if term.has(symbol)] for symbol in leading]
    groups += [[term for term in terms if any(is_acceleration(s) for s in term.free_symbols)], list(terms)]
    balance = next((b for b in map(_balance, groups) if b), 1)
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
