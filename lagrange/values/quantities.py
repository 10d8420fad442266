"""Results in numbers: an expression with the values of a problem substituted, and its unit.

    values.quantity(g/l)                      32.7, in 1/s^2
    values.quantity(l*theta'' + g*sin(theta)) 0.3*theta'' + 9.81*sin(theta): what has no value stays a symbol

Values are exact numbers in SI units, and put in exactly; a number is evaluated once, to far more digits than are
printed, and rounded last. Zero is recognised by the exact test, never because a number is small. A result that is not
real with these values has no quantity.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from decimal import ROUND_HALF_EVEN, Context, Decimal

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import with_whole_contents
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import UnitSymbol, base, t
from lagrange.core.units import NO_DIMENSION, Dimension, unit_called, unit_of
from lagrange.values.dimensions import dimension
from lagrange.values.limits import LARGEST_IN_NUMBERS, SPARE_DIGITS, WORKING_DIGITS

DIGITS = 4
"""The significant digits that are printed by default."""


class NotRealError(Exception):
    """An expression has no real value, with the values given."""


@record
class Quantity:
    """A result in numbers.

    formula  the expression with the values substituted, exactly
    unit     of SI; empty if it is not known, or a number
    """

    formula: sp.Expr
    unit: str = ""

    @property
    def is_number(self) -> bool:
        """Whether nothing is left open."""
        return bool(self.formula.is_number)

    @property
    def number(self) -> float:
        """The number, as accurate as a float is. Raises NotRealError."""
        return float(real_value(self.formula)) + 0.0  # never -0.0

    def formula_shown(self, digits: int = DIGITS) -> sp.Expr:
        """The number, or the formula with numbers in it, rounded. Raises NotRealError."""
        return rounded_in(self.formula, digits)

    def shown(self, digits: int = DIGITS) -> sp.Expr:
        """The quantity with its unit after a number other than 0. Raises NotRealError."""
        shown = self.formula_shown(digits)
        return with_unit(shown, self.unit) if self.is_number and self.unit and shown != 0 else shown


@record
class Values:
    """The values of a problem.

    numbers     exact, in SI units, by parameter
    parameters  all parameters, with and without values
    units       the dimensions of parameters and coordinates, as far as the units of the file determine them
    angles      the coordinates that are angles
    energies    symbols of energies: a number for them is in J, where that of a moment is in N m
    """

    numbers: Mapping[sp.Symbol, sp.Expr]
    parameters: frozenset[sp.Symbol]
    units: Mapping[sp.Symbol, Dimension]
    angles: frozenset[sp.Symbol] = frozenset()
    energies: frozenset[sp.Symbol] = frozenset()

    def with_energies(self, *letters: sp.Symbol) -> Values:
        """The values, with further letters of energies; unchanged where the file gives no units."""
        joule = unit_of("J")
        if not self.units or joule is None:
            return self
        units = {**self.units, **dict.fromkeys(letters, joule.dimension)}
        return replace(self, units=units, energies=self.energies.union(letters))

    def covers(self, *expressions: sp.Expr) -> bool:
        """Whether every parameter that occurs has a value."""
        return all(s in self.numbers for e in expressions for s in e.free_symbols & self.parameters)

    def put_in(self, expression: sp.Expr) -> sp.Expr:
        """The expression with the values, exactly."""
        return expression.xreplace(dict(self.numbers))

    def quantity(self, expression: sp.Expr, is_angle: bool = False) -> Quantity | None:
        """The expression in numbers; None if a parameter has no value, it is not real with these values, or huge.

        is_angle  whether a number without a dimension is an angle, in rad, and one in 1/s an angular velocity
        """
        if not self.covers(expression) or count_operations(expression) > LARGEST_IN_NUMBERS:
            return None
        formula = with_whole_contents(self.put_in(expression))
        if formula.has(sp.zoo, sp.nan, sp.oo, sp.I):
            return None
        if formula.is_number:
            try:
                real_value(formula)
            except NotRealError:
                return None
        return Quantity(formula, self.unit_of(expression, is_angle))

    def unit_of(self, expression: sp.Expr, is_angle: bool = False) -> str:
        """The unit of an expression; empty if the units given do not determine it."""
        if not self.units or not {base(s) for s in expression.free_symbols} & {t, *self.units}:
            return unit_called(NO_DIMENSION, is_angle) if is_angle and expression.is_number else ""
        unit = dimension(expression, self.units)
        if unit is not None and expression.free_symbols <= self.energies:
            return "J"
        return "" if unit is None else unit_called(unit, is_angle or self._is_angle(expression))

    def _is_angle(self, expression: sp.Expr) -> bool:
        """Whether it is a sum of coordinates that are angles, or of their velocities, with numbers before them."""
        inside = expression.args[0] if isinstance(expression, sp.Abs) else expression
        terms = (term.as_coeff_Mul()[1] for term in sp.Add.make_args(inside))
        return all(s.is_Symbol and base(s) in self.angles for s in terms)


def real_value(number: sp.Expr, digits: int = WORKING_DIGITS) -> sp.Float:
    """The value of a constant expression, exactly 0 where it is zero. Raises NotRealError."""
    if number.is_Rational:
        return sp.Float(number, digits)
    if not number.is_number or number.has(sp.zoo, sp.nan, sp.oo):
        raise NotRealError
    value = number.evalf(digits)
    real, imaginary = value.as_real_imag()
    if not real.is_Number or not imaginary.is_Number or real in (sp.oo, -sp.oo, sp.nan):
        raise NotRealError
    small = sp.Float(10) ** (10 - digits)
    if abs(imaginary) > small * (1 + abs(real)):
        raise NotRealError
    if abs(real) <= small:
        try:
            if is_zero(number):
                return sp.Float(0, digits)
        except DivisionByZeroError:
            raise NotRealError from None
    return sp.Float(real, digits)


def rounded(number: sp.Expr, digits: int = DIGITS) -> sp.Expr:
    """A constant to so many significant digits, with fewer where these are exact: 9.81, 0.3, 2. Raises NotRealError."""
    value = real_value(number, digits + SPARE_DIGITS)
    if value.is_zero:
        return sp.S.Zero
    exact = Decimal(str(value))  # all its digits
    near = Context(prec=digits, rounding=ROUND_HALF_EVEN).plus(exact)
    shortest = near.normalize()
    if number.is_Rational and sp.Rational(str(shortest)) == number:
        if number.is_Integer:
            return number
        return sp.Float(str(shortest), len(shortest.as_tuple().digits))
    return sp.Float(str(near), digits)


def is_exact(number: sp.Expr, shown: sp.Expr) -> bool:
    """Whether a rounded constant is the constant itself."""
    return bool(number.is_Rational and sp.Rational(str(shown)) == number) if shown.is_Number else False


def with_unit(number: sp.Expr, unit: str) -> sp.Expr:
    """The number and its unit."""
    return sp.Mul(number, UnitSymbol(unit, positive=True), evaluate=False)


def degrees(angle: sp.Expr, digits: int = DIGITS) -> sp.Expr:
    """An angle in rad as a rounded number of degrees. Raises NotRealError."""
    return with_unit(rounded(angle * 180 / sp.pi, digits), "°")


def rounded_in(e: sp.Expr, digits: int = DIGITS) -> sp.Expr:
    """The expression with its constants rounded: 3 √2 x'' + (981/100) sin θ is 4.243 x'' + 9.81 sin θ.

    Raises NotRealError if one of them is not real.
    """
    if e.is_number:
        return rounded(e, digits)
    if e.is_Add:
        return _sum(e, digits)
    if e.is_Mul:
        return _product(e, digits)
    if e.is_Pow:
        exponent = e.exp if e.exp.is_Rational else rounded_in(e.exp, digits)
        return sp.Pow(rounded_in(e.base, digits), exponent)
    if isinstance(e, sp.Function) and e.args:
        return e.func(*(rounded_in(a, digits) for a in e.args))
    return e


def _sum(e: sp.Expr, digits: int) -> sp.Expr:
    """Terms that differ in a constant factor only are added up exactly first."""
    coefficients: dict[sp.Expr, sp.Expr] = {}
    for term in e.args:
        constant, rest = _parts(term)
        coefficients[rest] = coefficients.get(rest, sp.S.Zero) + constant
    terms = []
    for rest, constant in coefficients.items():
        term = _times(constant, rest, digits)
        if term != 0:
            terms.append(term)
    return sp.Add(*terms)


def _product(e: sp.Expr, digits: int) -> sp.Expr:
    return _times(*_parts(e), digits)


def _parts(term: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """The constant factor, and the rest."""
    factors = sp.Mul.make_args(term)
    constant = sp.Mul(*(f for f in factors if f.is_number))
    return constant, sp.Mul(*(f for f in factors if not f.is_number))


def _times(constant: sp.Expr, rest: sp.Expr, digits: int) -> sp.Expr:
    number = rounded(constant, digits)
    if number == 0:
        return sp.S.Zero
    if rest == 1:
        return number
    factors = [rounded_in(f, digits) for f in sp.Mul.make_args(rest)]
    if number in (1, -1):
        return sp.Mul(*factors) if number == 1 else sp.Mul(sp.S.NegativeOne, *factors, evaluate=False)
    return sp.Mul(number, *factors, evaluate=False)
