"""Derivations of the ring: ∂/∂q, d/dt.

A derivation D is linear and obeys the product rule, so that it is given by what it does to symbols. A
generator with g^n = base has D g = D base/(n g^(n-1)), a function that is left alone the derivative that
SymPy gives, and an angle w

    D (A cos w + B sin w) = (B cos w - A sin w) D w .
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.fourier.fourier import Element, Terms
from lagrange.algebra.fourier.generators import UNIT
from lagrange.algebra.fourier.packing import WIDTH, unpack

if TYPE_CHECKING:
    from lagrange.algebra.fourier.trigonometry import Ring

Rate = Callable[[sp.Symbol], Element | None]


class Derivation:
    """A linear map with the product rule, given by what it does to symbols; None stands for 0."""

    def __init__(self, ring: Ring, rate: Rate) -> None:
        self._ring = ring
        self._rate = rate
        self._generators: dict[int, Element] = {}
        self._angles: dict[int, Element] = {}

    def __call__(self, element: Element) -> Element:
        """The derivative."""
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
                terms.append(ring.from_sympy(generator.expression.diff(symbol)) * rate)
        return ring.total(terms)
