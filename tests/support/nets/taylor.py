"""Truncated Taylor series in several variables: derivatives of whatever is evaluated with them, to rounding error.

    f(q₀ + u) = Σ c_α u^α ,   |α| ≤ K ,   α = (α₁, …, αₙ)

A sum adds coefficients, a product convolves them, and f(a + w), w without a constant term, is Σ f⁽ᵏ⁾(a) wᵏ/k!. With K = 2
the coefficients are the value, the gradient and half of the Hessian.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache
from itertools import product
from typing import Any

import numpy as np

Array = Any
Exponents = tuple[int, ...]


class Space:
    """The exponents of series in `size` variables up to `order`, and which pairs of them are multiplied."""

    def __init__(self, size: int, order: int) -> None:
        self.size, self.order = size, order
        self.exponents: list[Exponents] = sorted(
            (e for e in product(range(order + 1), repeat=size) if sum(e) <= order), key=lambda e: (sum(e), e[::-1])
        )
        self.place = {e: n for n, e in enumerate(self.exponents)}
        pairs = [
            (a, b, self.place[total])
            for a, p in enumerate(self.exponents)
            for b, q in enumerate(self.exponents)
            if (total := tuple(x + y for x, y in zip(p, q, strict=True))) in self.place
        ]
        self.left, self.right, self.into = (np.array(column) for column in zip(*pairs, strict=True))
        self.units = [self.place[unit(k, size)] for k in range(size)] if order else []
        self.slopes = [self._slope(k) for k in range(size)]

    def _slope(self, k: int) -> tuple[Array, Array, Array]:
        """∂/∂u_k of a series: which coefficients are multiplied by what, and the positions of the products."""
        terms = [(n, e) for n, e in enumerate(self.exponents) if e[k]]
        lower = [self.place[tuple(x - (j == k) for j, x in enumerate(e))] for _, e in terms]
        return np.array([n for n, _ in terms], int), np.array([e[k] for _, e in terms]), np.array(lower, int)


def unit(k: int, size: int) -> Exponents:
    """The exponents of the k-th variable alone."""
    return tuple(int(j == k) for j in range(size))


@cache
def space(size: int, order: int) -> Space:
    """The one space of this size and order."""
    return Space(size, order)


class Taylor:
    """A series; arithmetic with numbers and with series of the same space."""

    __array_ufunc__ = None

    def __init__(self, at: Space, coefficients: Array) -> None:
        self.at, self.coefficients = at, coefficients

    @property
    def value(self) -> float:
        return float(self.coefficients[0])

    @property
    def gradient(self) -> Array:
        return self.coefficients[self.at.units]

    @property
    def hessian(self) -> Array:
        n = self.at.size
        matrix = np.zeros((n, n))
        for i in range(n):
            for j in range(n):
                exponents = tuple(x + y for x, y in zip(unit(i, n), unit(j, n), strict=True))
                matrix[i, j] = self.coefficients[self.at.place[exponents]] * (2 if i == j else 1)
        return matrix

    def derivative(self, k: int) -> Taylor:
        """∂/∂u_k; the terms of the highest order are lost and count as zero."""
        terms, factors, places = self.at.slopes[k]
        result = np.zeros_like(self.coefficients)
        result[places] = factors * self.coefficients[terms]
        return Taylor(self.at, result)

    def of(self, derivatives: Sequence[float]) -> Taylor:
        """f of this series, from f, f′, f″, … at its value."""
        rest = self.coefficients.copy()
        rest[0] = 0
        power, total = Taylor(self.at, rest * 0), np.zeros_like(rest)
        power.coefficients[0] = 1
        small = Taylor(self.at, rest)
        for n, d in enumerate(derivatives):
            if n:
                power = power * small
            total = total + power.coefficients * (d / math.factorial(n))
        return Taylor(self.at, total)

    def _of(self, other: Any) -> Taylor:
        if isinstance(other, Taylor):
            return other
        coefficients = np.zeros_like(self.coefficients)
        coefficients[0] = other
        return Taylor(self.at, coefficients)

    def __add__(self, other: Any) -> Any:
        if isinstance(other, np.ndarray):
            return np.array([self + x for x in other], dtype=object)
        return Taylor(self.at, self.coefficients + self._of(other).coefficients)

    __radd__ = __add__

    def __neg__(self) -> Taylor:
        return Taylor(self.at, -self.coefficients)

    def __sub__(self, other: Any) -> Any:
        return self + (-other)

    def __rsub__(self, other: Any) -> Any:
        return (-self) + other

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, np.ndarray):
            return np.array([self * x for x in other], dtype=object)
        if not isinstance(other, Taylor):
            return Taylor(self.at, self.coefficients * other)
        at = self.at
        terms = self.coefficients[at.left] * other.coefficients[at.right]
        return Taylor(at, np.bincount(at.into, terms, len(at.exponents)))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        return self * (other**-1 if isinstance(other, Taylor) else 1 / other)

    def __rtruediv__(self, other: Any) -> Any:
        return (self**-1) * other

    def __pow__(self, exponent: Any) -> Taylor:
        if isinstance(exponent, Taylor):
            if np.any(exponent.coefficients[1:]):
                return function(math.exp, "exp", exponent * function(math.log, "log", self))
            exponent = exponent.value
        if exponent == int(exponent) and 0 <= exponent <= 12:
            result = self._of(1.0)
            for _ in range(int(exponent)):
                result = result * self
            return result
        a, derivatives, factor = self.value, [], 1.0
        for k in range(self.at.order + 1):
            derivatives.append(factor * _power(a, exponent - k) if factor else 0.0)
            factor *= exponent - k
        return self.of(derivatives)

    def __rpow__(self, base: float) -> Taylor:
        return function(math.exp, "exp", self * math.log(base))


def _power(a: float, exponent: float) -> float:
    """aⁿ; nan for a fractional power of a negative number, and for a pole."""
    if (a == 0 and exponent < 0) or (a < 0 and exponent != int(exponent)):
        return math.nan
    return float(a**exponent)


def _cycle(values: Sequence[float], order: int) -> list[float]:
    return [values[k % len(values)] for k in range(order + 1)]


def function(plain: Callable[[float], float], name: str, x: Any) -> Any:
    """A function of the language, of a number or a series; nan outside its domain."""
    a = x.value if isinstance(x, Taylor) else float(x)
    try:
        value = plain(a)
    except (ValueError, OverflowError, ZeroDivisionError):
        value = math.nan
    if not isinstance(x, Taylor):
        return value
    order = x.at.order
    match name:
        case "sin":
            return x.of(_cycle([math.sin(a), math.cos(a), -math.sin(a), -math.cos(a)], order))
        case "cos":
            return x.of(_cycle([math.cos(a), -math.sin(a), -math.cos(a), math.sin(a)], order))
        case "sinh":
            return x.of(_cycle([math.sinh(a), math.cosh(a)], order))
        case "cosh":
            return x.of(_cycle([math.cosh(a), math.sinh(a)], order))
        case "exp":
            return x.of([value] * (order + 1))
        case "log":
            return x.of([value, *((-1) ** (k - 1) * math.factorial(k - 1) / a**k for k in range(1, order + 1))])
        case "sqrt":
            return x**0.5
        case "abs":
            return x.of([value, math.copysign(1, a) if a else math.nan, *[0.0] * (order - 1)][: order + 1])
        case "sign":
            return x.of([value, *[0.0] * order])
        case "asin" | "acos" | "atan" if order <= 2:
            s = math.nan if name != "atan" and abs(a) >= 1 else math.sqrt(abs(1 - a * a))
            slopes = {
                "asin": (1 / s, a / s**3),
                "acos": (-1 / s, -a / s**3),
                "atan": (1 / (1 + a * a), -2 * a / (1 + a * a) ** 2),
            }
            return x.of([value, *slopes[name]][: order + 1])
    raise NotImplementedError(name)


def variables(values: Sequence[float], order: int) -> list[Taylor]:
    """The variables q₀ + u as series about q₀ = `values`."""
    at = space(len(values), order)
    series = []
    for k, v in enumerate(values):
        coefficients = np.zeros(len(at.exponents))
        coefficients[0] = v
        if order:
            coefficients[at.units[k]] = 1
        series.append(Taylor(at, coefficients))
    return series
