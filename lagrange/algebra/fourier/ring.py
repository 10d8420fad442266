"""The ring of Fourier sums: from SymPy into it, and its derivations ∂/∂q and d/dt.

Mechanics in Cartesian positions and angles is polynomial in coordinates, velocities, parameters and the sines and
cosines of sums of angles. In that ring (`elements`) every sum has one form, so that equality is looked up, not proved:

    ring = FourierRing()
    x = ring.from_sympy(l * sin(theta))
    v = ring.time_derivative(slots)(x)  # l θ' cos θ
    ring.dot((v, w), (v, w))  # exact, and no trigonometric identity is needed

An angle is any monomial under a sine: θ, ω t, a parameter α; multiples of π are split off and evaluated. tan w is
sin w/cos w. What is not polynomial becomes a generator. A derivation D is linear and obeys the product rule, so that it
is given by its action on symbols; a generator with g^n = base has D g = D base/(n g^(n−1)), and an angle w has
D (A cos w + B sin w) = (B cos w − A sin w) D w.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from fractions import Fraction
from math import comb, prod

import sympy as sp

from lagrange.algebra.fourier.division import without_denominator
from lagrange.algebra.fourier.elements import UNIT, Basis, Element, Number, Terms
from lagrange.algebra.fourier.limits import HIGHEST_MULTIPLE, LARGEST_TRIAL_DIVISOR, LONGEST_POWER
from lagrange.algebra.fourier.polynomials import LARGEST, WIDTH, pack, unpack, value_at_place
from lagrange.algebra.fourier.product_to_sum import Factoring
from lagrange.core.symbols import Sign, Slots, base, partial, prime, t

__all__ = ["Element", "FourierRing", "RingDerivation"]

RateOfSymbol = Callable[[sp.Symbol], Element | None]


class RingDerivation:
    """A linear map with the product rule, given by its action on symbols; None means 0."""

    def __init__(self, ring: FourierRing, rate: RateOfSymbol) -> None:
        self._ring = ring
        self._rate = rate
        self._generators: dict[int, Element] = {}
        self._angles: dict[int, Element] = {}

    def __call__(self, element: Element) -> Element:
        """The derivative."""
        # Collected by generator and by angle: their rates may be long, and are multiplied once each.
        lowered: dict[int, Terms] = {}
        turned: dict[int, Terms] = {}
        for (m, w), (a, b) in element.terms.items():
            for i, e in unpack(m):
                if self._generator(i):
                    lowered.setdefault(i, {})[m - (1 << (WIDTH * i)), w] = (a * e, b * e)
            for j, f in unpack(w):
                if self._angle(j):
                    turned.setdefault(j, {})[m, w] = (b * f, -a * f)
        ring, denominator = self._ring, element.denominator
        parts = [ring.element(terms, denominator) * self._generator(i) for i, terms in lowered.items()]
        parts += [ring.element(terms, denominator * UNIT) * self._angle(j) for j, terms in turned.items()]
        return ring.total(parts)

    def _generator(self, index: int) -> Element:
        rate = self._generators.get(index)
        if rate is None:
            rate = self._generators[index] = self._generator_rate(index)
        return rate

    def _angle(self, index: int) -> Element:
        rate = self._angles.get(index)
        if rate is None:
            rate = self._angles[index] = self(self._ring.from_sympy(self._ring.angles[index]))
        return rate

    def _generator_rate(self, index: int) -> Element:
        ring = self._ring
        generator = ring.generators[index]
        if generator.expression.is_Symbol and generator.base is None:
            return self._rate(generator.expression) or ring.zero
        if generator.base is not None:
            inner = self(generator.base)
            return inner * ring.power_of(index, 1 - generator.order) / generator.order if inner else ring.zero
        terms = []
        for symbol in sorted(generator.expression.free_symbols, key=lambda s: str(s.name)):
            rate = self._rate(symbol)
            if rate:
                terms.append(ring.from_sympy(partial(generator.expression, symbol)) * rate)
        return ring.total(terms)


class FourierRing(Basis):
    """The ring of one problem. Elements of different rings do not mix."""

    def __init__(self) -> None:
        super().__init__()
        self.factoring = Factoring(self)
        self._read: dict[sp.Expr, Element] = {}
        self._partials: dict[sp.Symbol, RingDerivation] = {}

    def inverse(self, element: Element) -> Element:
        """1/element; 1/sin 2θ is 1/(2 sin θ cos θ), the reciprocal of a product a product of reciprocals."""
        # One generator for each factor: 1/sin 2θ and 1/cos θ then have a common denominator, and cancel.
        atoms, rest = self.factoring.atoms(element)
        inverses = [super(FourierRing, self).inverse(self.circle(a.frequency, a.sine)) for a in atoms]
        if rest.is_monomial:
            return prod(inverses, start=rest**-1)
        return prod(inverses, start=super().inverse(rest))

    def from_sympy(self, expression: sp.Expr | Element | Number) -> Element:
        """The element that an expression denotes."""
        if isinstance(expression, Element):
            if expression.basis is not self:
                raise ValueError("an element of another ring")
            return expression
        if isinstance(expression, int | Fraction):
            return self.number(expression)
        element = self._read.get(expression)
        if element is None:
            element = self._read[expression] = self._reading(expression)
        return element

    def _reading(self, e: sp.Expr) -> Element:
        if e.is_Rational:
            return self.number(Fraction(int(e.p), int(e.q)))
        if e.is_Symbol:
            return self._symbol(e)
        if e.is_Add:
            return self.total(self.from_sympy(a) for a in e.args)
        if e.is_Mul:
            product = self.one
            for a in e.args:
                product = product * self.from_sympy(a)
            return product
        if isinstance(e, sp.Pow) and e.exp.is_Rational:
            return self._power(e)
        return self._function(e)

    def _symbol(self, symbol: sp.Symbol) -> Element:
        if isinstance(symbol, Sign):
            return self.power_of(self.related_place(symbol, 2, self.one))
        return self.power_of(self.place_of(symbol))

    def _opaque(self, expression: sp.Expr) -> Element:
        return self.power_of(self.place_of(expression))

    def _power(self, e: sp.Pow) -> Element:
        p, q = int(e.exp.p), int(e.exp.q)
        if e.base.is_Integer:
            return self._number_root(int(e.base), Fraction(p, q))
        element = self.from_sympy(e.base)
        if not element:
            return self._opaque(e)
        n = abs(p) // q
        # The terms of a power are counted before it is multiplied out.
        too_long = not element.is_monomial and (n > HIGHEST_MULTIPLE or comb(len(element) + n, n) > LONGEST_POWER)
        if too_long or abs(p) > LARGEST // 16:
            return self._opaque(e)
        try:
            return element**p if q == 1 else self._root(element, p, q)
        except OverflowError:
            return self._opaque(e)

    def _number_root(self, number: int, exponent: Fraction) -> Element:
        """A rational power of an integer, by its primes: √6 is √2 √3, so that √2 √3 - √6 is 0."""
        product = self.one
        # Trial division only: to factor a number of sixty digits may take forever. What is left counts as one prime.
        factors = sp.factorint(number, limit=LARGEST_TRIAL_DIVISOR, use_rho=False, use_pm1=False, use_ecm=False)
        for prime_factor, multiplicity in factors.items():
            total = exponent * multiplicity
            if total.denominator == 1:
                product = product * Fraction(prime_factor) ** int(total)
            elif prime_factor < 0:
                product = product * self._opaque(sp.Pow(prime_factor, sp.Rational(total)))
            else:
                index = self.root_place(self.number(prime_factor), total.denominator)
                product = product * self.power_of(index, total.numerator)
        return product

    def _root(self, element: Element, p: int, q: int) -> Element:
        """element ** (p/q), with factors known to be positive extracted from the root."""
        # √(m² x) is m √x for a positive m; √(x²) is |x| and stays under the root.
        number, monomial = element.content()
        outside = {i: e for i, e in unpack(monomial) if self.generators[i].expression.is_positive}
        inside = element.over_monomial(pack(outside.items())) / number
        if inside == -self.one:
            inside, number = self.one, -number
        product = self._number_root(number.numerator, Fraction(p, q)) * self._number_root(
            number.denominator, Fraction(-p, q)
        )
        for i, e in outside.items():
            product = product * self._generator_root(i, Fraction(e * p, q))
        if inside.is_number:
            return product
        return product * self.power_of(self.root_place(inside, q), p)

    def _generator_root(self, index: int, exponent: Fraction) -> Element:
        if exponent.denominator == 1:
            return self.power_of(index, int(exponent))
        place = self.root_place(self.power_of(index), exponent.denominator)
        return self.power_of(place, exponent.numerator)

    def _function(self, e: sp.Expr) -> Element:
        if not e.args:
            return self._opaque(e)
        argument = e.args[0]
        if isinstance(e, sp.cos | sp.sin):
            return self._circular(e.func, argument)
        if isinstance(e, sp.tan | sp.sec):
            above = self.from_sympy(sp.sin(argument)) if isinstance(e, sp.tan) else self.one
            return above / self.from_sympy(sp.cos(argument))
        if isinstance(e, sp.cot | sp.csc):
            above = self.from_sympy(sp.cos(argument)) if isinstance(e, sp.cot) else self.one
            return above / self.from_sympy(sp.sin(argument))
        if isinstance(e, sp.sinh):
            cosh = self.from_sympy(sp.cosh(argument))
            return self.power_of(self.related_place(e, 2, cosh * cosh - 1))
        if isinstance(e, sp.tanh):
            return self.from_sympy(sp.sinh(argument)) / self.from_sympy(sp.cosh(argument))
        if isinstance(e, sp.exp):
            return self._exponential(argument)
        return self._opaque(e)

    def _exponential(self, argument: sp.Expr) -> Element:
        product = self.one
        for summand in sp.Add.make_args(sp.expand_mul(argument)):
            number, rest = summand.as_coeff_Mul()
            if not number.is_Rational or abs(number.p) > LARGEST:
                number, rest = sp.S.One, summand
            # e^{x/2} is the generator, of which e^x is a power: only so are they related.
            index = self.place_of(sp.exp(rest / number.q))
            product = product * self.power_of(index, int(number.p))
        return product

    def _circular(self, function: type[sp.Function], argument: sp.Expr) -> Element:
        """cos or sin of a sum of angles and a multiple of π."""
        frequency, turns = 0, sp.S.Zero
        for summand in (argument,) if argument.is_Symbol else sp.Add.make_args(sp.expand_mul(argument)):
            number, angle = summand.as_coeff_Mul()
            if angle == sp.pi and number.is_Rational:
                turns += number
            else:
                frequency += self._frequency(number, angle)
        cosine, sine = self.circle(frequency), self.circle(frequency, sine=True)
        if not turns:
            return cosine if function is sp.cos else sine
        c, s = self._constant(sp.cos, turns), self._constant(sp.sin, turns)
        return c * cosine - s * sine if function is sp.cos else s * cosine + c * sine

    def _frequency(self, number: sp.Expr, angle: sp.Expr) -> int:
        if sp.pi in angle.args:  # in sin(2π t/T) the angle is 2π t/T and not twice π t/T
            number, angle = number / 2, 2 * angle
        if not (number.is_Rational and abs(number.p) <= HIGHEST_MULTIPLE):
            number, angle = sp.S.One, number * angle
        elif UNIT % number.q:
            number, angle = sp.Integer(number.p), angle / number.q
        return int(number * UNIT) << (WIDTH * self.angle_place(angle, int(number.q)))

    def _constant(self, function: type[sp.Function], turns: sp.Rational) -> Element:
        value = function(turns * sp.pi)
        return self._opaque(value) if isinstance(value, sp.cos | sp.sin) else self.from_sympy(value)

    def dot(self, a: Sequence[Element], b: Sequence[Element]) -> Element:
        """Σ a_i b_i."""
        return self.total(x * y for x, y in zip(a, b, strict=True) if x and y)

    def is_zero(self, element: Element) -> bool:
        """Whether the element is zero, its denominators multiplied out.

        True is certain. False is certain if the functions that are left alone are independent.
        """
        return not self._cleared(element)

    def numerator(self, element: Element) -> Element:
        """The element multiplied by the lowest powers of those denominators that are sums or trigonometric.

        y'' + y² y''/(l² - y²) becomes l² y''. Powers of symbols, 1/r, are left.
        """
        for index in self.related:
            element = without_denominator(element, index)
        return element

    def _cleared(self, element: Element) -> Element:
        for index in self.related:
            least = min((value_at_place(m, index) for m, _ in element.terms), default=0)
            if least < 0:
                element = element.over_monomial(least << (WIDTH * index))
        return element

    def partial(self, symbol: sp.Symbol) -> RingDerivation:
        """∂/∂symbol."""
        derivation = self._partials.get(symbol)
        if derivation is None:
            derivation = self._partials[symbol] = RingDerivation(self, lambda s: self.one if s == symbol else None)
        return derivation

    def time_derivative(self, slots: Slots) -> RingDerivation:
        """d/dt: q -> q' -> q''."""
        return self._motion(frozenset((*slots.coordinates, *slots.prescribed)))

    def frozen_derivative(self, slots: Slots) -> RingDerivation:
        """∂/∂t at a frozen configuration; prescribed motions go on."""
        return self._motion(frozenset(slots.prescribed))

    def _motion(self, moving: frozenset[sp.Symbol]) -> RingDerivation:
        def rate(symbol: sp.Symbol) -> Element | None:
            if symbol == t:
                return self.one
            return self.from_sympy(prime(symbol)) if base(symbol) in moving else None

        return RingDerivation(self, rate)

    def collect(self, element: Element, symbols: Iterable[sp.Symbol]) -> dict[tuple[int, ...], Element]:
        """The coefficients of the products of powers of the symbols, by the exponents.

        Raises ValueError if a symbol occurs under a root, in a denominator or in a function.
        """
        chosen = tuple(symbols)
        places = [self.find(s) for s in chosen]
        inside = self._inside(element) & set(chosen)
        if inside:
            raise ValueError(f"not polynomial in {', '.join(sorted(s.name for s in inside))}")
        parts = element.by_exponents([p for p in places if p is not None])
        return {tuple(dict(unpack(m)).get(-1 if p is None else p, 0) for p in places): e for m, e in parts.items()}

    def linear(self, element: Element, symbols: Sequence[sp.Symbol]) -> tuple[list[Element], Element]:
        """The coefficients of the symbols, and the rest: element = Σ coefficient · symbol + rest.

        Raises ValueError if the element is not linear in the symbols.
        """
        coefficients, rest = [self.zero] * len(symbols), self.zero
        for exponents, part in self.collect(element, symbols).items():
            if not any(exponents):
                rest = part
            elif sum(map(abs, exponents)) == 1 and sum(exponents) == 1:
                coefficients[exponents.index(1)] = part
            else:
                raise ValueError("not linear in " + ", ".join(s.name for s in symbols))
        return coefficients, rest

    def by_degree(self, element: Element, symbols: Collection[sp.Symbol]) -> dict[int, Element]:
        """The terms by their total degree in the symbols.

        Raises ValueError if a symbol occurs under a root, in a denominator that is a sum, or in a function.
        """
        inside = self._inside(element) & set(symbols)
        if inside:
            raise ValueError(f"not polynomial in {', '.join(sorted(s.name for s in inside))}")
        places = {self.find(s) for s in symbols}
        split: dict[int, Terms] = {}
        for (monomial, frequency), value in element.terms.items():
            degree = sum(e for i, e in unpack(monomial) if i in places)
            split.setdefault(degree, {})[monomial, frequency] = value
        return {degree: self.element(terms, element.denominator) for degree, terms in split.items()}

    def free_symbols(self, element: Element) -> set[sp.Symbol]:
        """The symbols that occur."""
        places = {i for m, _ in element.terms for i, _ in unpack(m)}
        free: set[sp.Symbol] = self._inside(element)
        return free.union(*(self.generators[i].expression.free_symbols for i in places))

    def _inside(self, element: Element) -> set[sp.Symbol]:
        """The symbols in angles and in generators that are not symbols."""
        places = {i for m, _ in element.terms for i, _ in unpack(m)}
        angles = {i for _, w in element.terms for i, _ in unpack(w)}
        expressions = [e for e in (self.generators[i].expression for i in places) if not e.is_Symbol]
        expressions += [self.angles[i] for i in angles]
        return set().union(*(e.free_symbols for e in expressions))
