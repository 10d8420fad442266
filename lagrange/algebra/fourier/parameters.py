"""Polynomials in parameters and coordinates, split the way they are written by hand.

    l1² m1 + l1² m2  =  l1² (m1 + m2) ,        m l² + 2 m l x + m x²  =  m (l + x)² ,

number, monomial and primitive part; the last is factored where that saves operations (l² - y² stays), and a
sum that does not factor is grouped: l1² (m1 + m2) + l2² m2. A bracket has more plus than minus signs; of as
many, a coordinate has the plus, k (r - l), then what comes first in the alphabet.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations
from math import floor

import sympy as sp

from lagrange.algebra.fourier.fourier import Element
from lagrange.algebra.fourier.generators import Basis
from lagrange.algebra.fourier.packing import common, divides, shared, unpack
from lagrange.algebra.fourier.polynomials import (
    Polynomial,
    common_number,
    factorization,
    multiplications,
    negated,
    square_of_two,
)
from lagrange.algebra.fourier.terms import Factors, Term, multiply, number_apart, sum_of

LONGEST = 24  # a longer polynomial is neither factored nor grouped


class Parameters:
    """Writes the polynomials of one ring; `write` is how the base of a root is written."""

    def __init__(self, basis: Basis, write: Callable[[Element], sp.Expr]) -> None:
        self._basis = basis
        self._write = write
        self._terms: dict[frozenset[tuple[int, Fraction]], Term] = {}
        self._monomials: dict[int, Term] = {}
        self._written: dict[int, Factors] = {}
        self._names: dict[int, tuple[tuple[str, int], ...]] = {}

    def factored(self, polynomial: Polynomial) -> Term:
        """The polynomial as one product."""
        key = frozenset(polynomial.items())
        term = self._terms.get(key)
        if term is None:
            term = self._terms[key] = self._factored(polynomial)
        return term

    def terms(self, polynomial: Polynomial) -> list[Term]:
        """The polynomial as one product if it has factors, and as a short sum of products if not."""
        whole = self.factored(polynomial)
        if len(polynomial) == 1 or len(whole.factors) > 1 or any(e != 1 for e in whole.factors.values()):
            return [whole]
        return self._grouped(polynomial)

    def monomial(self, packed: int) -> Term:
        """The powers of generators as SymPy writes them."""
        term = self._monomials.get(packed)
        if term is None:
            term = self._monomials[packed] = self._monomial(packed)
        return term

    def _monomial(self, packed: int) -> Term:
        factors: Factors = {}
        for index, exponent in unpack(packed):
            for expression, unit in self._generator(index).items():
                multiply(factors, expression, unit * exponent)
        number = Fraction(1)
        for root in [f for f in factors if f.is_Integer]:  # 2^(-1/2) is √2/2
            whole = floor(factors[root])
            multiply(factors, root, -whole)
            number *= Fraction(int(root)) ** whole
        return Term(number, factors)

    def _generator(self, index: int) -> Factors:
        """A symbol, or a root such as (1/2 · (2 M + 2 m sin²θ)) ** (1/2) with the number apart."""
        written = self._written.get(index)
        if written is None:
            generator = self._basis.generators[index]
            if generator.radical and generator.base is not None:
                number, rest = number_apart(self._write(generator.base))
                unit = Fraction(1, generator.order)
                written = {e: unit for e in (number, rest) if e != 1}
            else:
                written = {generator.expression: 1}
            self._written[index] = written
        return written

    def _factored(self, polynomial: Polynomial) -> Term:
        number, monomial, primitive = self._split(polynomial)
        term = self.monomial(monomial).scaled(number)
        if len(primitive) == 1:
            return Term(term.number * primitive[0], term.factors)
        known = self._known()
        sign, factors = (1, [(primitive, 1)]) if len(primitive) > LONGEST else factorization(primitive, known)
        for factor, exponent in factors:
            turned, oriented = (1, factor) if factor in known else self._oriented(factor)
            power: Factors = {sum_of(self._grouped(oriented)): exponent}
            term = term * Term(Fraction(turned**exponent), power)
        return Term(term.number * sign, term.factors)

    def _split(self, polynomial: Polynomial) -> tuple[Fraction, int, Polynomial]:
        number = common_number(polynomial.values())
        monomial = common(polynomial)
        return number, monomial, {m - monomial: c / number for m, c in polynomial.items()}

    def _oriented(self, polynomial: Polynomial) -> tuple[int, Polynomial]:
        """Minus one if most signs are minus; the polynomial without that sign."""
        if negated(polynomial) in self._known():
            return -1, negated(polynomial)
        balance = sum(1 if c > 0 else -1 for c in polynomial.values())
        if balance == 0:
            first = min(polynomial, key=lambda m: (not self._is_coordinate(m), self._name(m)))
            balance = 1 if polynomial[first] > 0 else -1
        return (1, polynomial) if balance > 0 else (-1, negated(polynomial))

    def _name(self, monomial: int) -> tuple[tuple[str, int], ...]:
        """What monomials are sorted by: the same in every ring."""
        name = self._names.get(monomial)
        if name is None:
            places = [(str(self._basis.generators[i].expression), -e) for i, e in unpack(monomial)]
            name = self._names[monomial] = tuple(sorted(places))
        return name

    def _grouped(self, polynomial: Polynomial) -> list[Term]:
        """The sum with squares of two terms, then that common factor taken out which saves most, again and again."""
        root = square_of_two(polynomial) if 2 < len(polynomial) <= LONGEST else None
        if root is not None:
            base = self.factored(root)
            square = Term(base.number**2, {f: 2 * e for f, e in base.factors.items()})
            within = {u + v for u in root for v in root}
            return [square, *self._grouped({m: c for m, c in polynomial.items() if m not in within})]
        best = self._best_group(polynomial)
        if best is None:
            return [self.monomial(m).scaled(c) for m, c in polynomial.items()]
        group = {m: c for m, c in polynomial.items() if divides(best, m)}
        rest = {m: c for m, c in polynomial.items() if m not in group}
        return [self.factored(group), *self._grouped(rest)]

    def _best_group(self, polynomial: Polynomial) -> int | None:
        if not 2 < len(polynomial) <= LONGEST:
            return None
        often = Counter(i for m in polynomial for i, e in unpack(m) if e > 0)
        several = [m for m in polynomial if any(often[i] > 1 for i, _ in unpack(m))]
        candidates = {shared(a, b) for a, b in combinations(several, 2)} - {0}
        if not candidates:
            return None
        return min(candidates, key=lambda f: (-self._saving(f, polynomial), not self._is_positive(f), self._name(f)))

    def _saving(self, factor: int, polynomial: Polynomial) -> int:
        numbers = [c for m, c in polynomial.items() if divides(factor, m)]
        return (len(numbers) - 1) * (multiplications(factor) + (common_number(numbers) != 1))

    def _is_coordinate(self, monomial: int) -> bool:
        """Whether it is one symbol that may have either sign."""
        places = unpack(monomial)
        return len(places) == 1 and places[0][1] == 1 and not self._is_positive(monomial)

    def _is_positive(self, monomial: int) -> bool:
        """Whether it is a product of positive parameters."""
        return all(self._basis.generators[i].expression.is_positive for i, _ in unpack(monomial))

    def _known(self) -> list[Polynomial]:
        """The polynomials under roots and in denominators, the way they are written there."""
        generators = (self._basis.generators[i] for i in self._basis.related)
        bases = [g.base for g in generators if g.radical and g.base is not None and not g.base.is_monomial]
        return [{m: a for m, _, a, _ in b.items()} for b in bases if not any(w for _, w in b.terms)]
