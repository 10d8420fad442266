"""Arithmetic in a random prime field that imitates the reals: roots, signs, angles.

The prime is p = k·M − 1 near 2^89 with M = 2^5·3^2·5·7·11·13·17·19·23 and k drawn at random in every process, so that
nobody can write an equation that is zero mod p without being zero. Then

    p ≡ 3 (mod 4):    −1 is no square, "square" imitates "positive", √a is the root that is itself a square;
    primes ≤ 23       are squares, so that √2, √3, ... exist and √2·√3 = √6;
    gcd((p−1)/2, n)   is 1 for n composed of small odd primes, so that a^{1/n} is unique among the squares;
    x² + y² = 1       is a cyclic group of order p + 1, the elements x + iy of norm 1: the circle. π/n is exact where 2n
                      divides M. Random angles are from the part of order k: there θ/2, θ/3, ... are unique.

References: Schwartz 1980, Zippel 1979 (a polynomial of degree d that is not zero vanishes at a random point with a
probability of d/p at most); Gauss for the roots of unity.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cache, cached_property
from math import gcd, isqrt, prod

import sympy as sp

M = 2**5 * 9 * 5 * 7 * 11 * 13 * 17 * 19 * 23
ALWAYS_SQUARES = frozenset({2, 3, 5, 7, 11, 13, 17, 19, 23})
# The prime powers of M: a fraction of a turn is a sum of one fraction for each of them.
_PARTS = (32, 9, 5, 7, 11, 13, 17, 19, 23)
# 89 bits take three digits of 30 bits in CPython, as 61 bits do, so that the larger field costs nothing.
_BITS = 89
# Bits of an exponent looked up at once. Random angles are drawn often: 12 products instead of some 80.
_WINDOW = 5
_SMALL_PRIMES = prod(sp.primerange(2, 1000))
_ODD_SMALL_PRIMES = _SMALL_PRIMES // 2
_LEAST_PRIMES = prod(sp.primerange(2, 50))
_LEAST_ODD_PRIMES = _LEAST_PRIMES // 2

Circle = tuple[int, int]


class InadmissibleError(Exception):
    """This point is not admissible (it needs the root of a non-square); another one may be.

    node  the node of a graph at which that came up, if it is known
    """

    node: int | None = None


class ZeroDivisorError(InadmissibleError):
    """At this point a denominator vanishes."""


class PrimeField:
    """The integers mod p, with canonical roots and a unit circle. Residues are ints in 0 ... p − 1."""

    exact = True

    def __init__(self, p: int, rng: random.Random) -> None:
        self.p = p
        self.k = (p + 1) // M
        self.random = rng
        self._half = (p - 1) // 2
        self._exponents: dict[tuple[int, int], int] = {}
        self._numbers: dict[tuple[int, int], int] = {}
        self._unity_cache: dict[tuple[int, int], Circle] = {}
        self._unity_parts: dict[int, Circle] = {}

    @classmethod
    def draw(cls, rng: random.Random, squares: Iterable[int] = ()) -> PrimeField:
        """A random field in which the given integers are squares, in addition to all primes up to 23."""
        wanted = tuple(squares)
        low = 2 ** (_BITS - 1) // M
        while True:
            k = rng.randrange(low + 1, 2 * low)
            p = k * M - 1
            # k without small factors: small fractions of random angles exist and are unique. (p − 1)/2 without small
            # odd ones: so are odd roots.
            if gcd(k, _LEAST_PRIMES) != 1 or gcd(p >> 1, _LEAST_ODD_PRIMES) != 1:  # nearly always, and soon seen
                continue
            if gcd(k, _SMALL_PRIMES) != 1 or gcd(p >> 1, _ODD_SMALL_PRIMES) != 1:
                continue
            if any(_jacobi(n, p) != 1 for n in wanted) or not sp.isprime(p):
                continue
            return cls(p, rng)

    # Numbers.

    def number(self, numerator: int, denominator: int = 1) -> int:
        """The residue of a fraction."""
        key = (numerator, denominator)
        if key not in self._numbers:
            self._numbers[key] = numerator * self.inverse(denominator % self.p) % self.p
        return self._numbers[key]

    def reduce(self, x: int) -> int:
        """The canonical residue."""
        return x % self.p

    def less(self, row: Sequence[int], factor: int, other: Sequence[int]) -> list[int]:
        """row − factor · other: what elimination spends its time on."""
        p = self.p
        return [(x - factor * y) % p for x, y in zip(row, other, strict=True)]

    def inverse(self, x: int) -> int:
        """1/x. Raises ZeroDivisorError."""
        if x % self.p == 0:
            raise ZeroDivisorError
        return pow(x, -1, self.p)

    def vanishes(self, x: int) -> bool:
        """Whether x is 0."""
        return x % self.p == 0

    def sample(self) -> int:
        """A random residue, not 0."""
        return self.random.randrange(1, self.p)

    def sign(self, x: int) -> int:
        """The Legendre symbol: 1 for squares, −1 for others, 0 for 0."""
        power = pow(x, self._half, self.p)
        return power if power < 2 else -1

    def power(self, x: int, numerator: int, denominator: int) -> int:
        """x^(n/d) for a square x, itself a square. Raises InadmissibleError for others, ZeroDivisorError."""
        x %= self.p
        if x == 0:
            if numerator < 0:
                raise ZeroDivisorError
            return 0
        key = (numerator, denominator)
        if key not in self._exponents:
            if gcd(denominator, self._half) != 1:
                raise InadmissibleError
            self._exponents[key] = numerator * pow(denominator, -1, self._half) % self._half
        value = pow(x, self._exponents[key], self.p)
        # Of x and −x one is a square, and only that one has a root: see whether it is x.
        squared = value if denominator == 2 and numerator == 1 else pow(x, (self.p + 1) >> 2, self.p)
        if squared * squared % self.p != x:
            raise InadmissibleError
        return value

    def root(self, x: int) -> int:
        """√x, the root that is a square. Raises InadmissibleError when x has none."""
        return self.power(x, 1, 2)

    # The circle.

    def times(self, a: Circle, b: Circle) -> Circle:
        """The point whose angle is the sum of the angles."""
        p = self.p
        return (a[0] * b[0] - a[1] * b[1]) % p, (a[0] * b[1] + a[1] * b[0]) % p

    def circle_power(self, a: Circle, n: int) -> Circle:
        """The point with n times the angle."""
        if n < 0:
            a, n = (a[0], -a[1] % self.p), -n
        result: Circle = (1, 0)
        while n:
            if n & 1:
                result = self.times(result, a)
            n >>= 1
            if n:
                a = self.times(a, a)
        return result

    def random_circle(self) -> Circle:
        """A random point of the part of order k."""
        exponent = self.random.randrange(1, self.k)
        result: Circle = (1, 0)
        for row in self._windows:
            result = self.times(result, row[exponent & ((1 << _WINDOW) - 1)])
            exponent >>= _WINDOW
        return result

    def circle_fraction(self, a: Circle, n: int, d: int) -> Circle:
        """The point with n/d times the angle, for a point of `random_circle`."""
        if d == 1:
            return self.circle_power(a, n)
        if gcd(d, self.k) != 1:
            raise InadmissibleError
        return self.circle_power(a, n * pow(d, -1, self.k) % self.k)

    def circle_root(self, a: Circle, d: int) -> Circle:
        """A point with 1/d of the angle, for any point of the circle. Raises InadmissibleError."""
        # Halves by cos(θ/2) = √((1 + cos θ)/2); odd parts by inverting d modulo the order, where the point has them.
        while d % 2 == 0:
            cosine = self.root((1 + a[0]) * self.number(1, 2))
            a, d = (cosine, a[1] * self.inverse(2 * cosine) % self.p), d // 2
        if d == 1:
            return a
        order = self.p + 1
        while (common := gcd(order, d)) != 1:
            order //= common
        if self.circle_power(a, order) != (1, 0):
            raise InadmissibleError
        return self.circle_power(a, pow(d, -1, order))

    def unity(self, n: int, d: int) -> Circle:
        """The point of the angle 2π·n/d. Raises InadmissibleError unless d divides M."""
        key = (n % d, d)
        if key not in self._unity_cache:
            if M % d:
                raise InadmissibleError
            result: Circle = (1, 0)
            for q in _PARTS:
                share = gcd(d, q)
                if share > 1:
                    # n/d = Σ a_q/share_q (mod 1), one fraction for each prime.
                    a = n * pow(d // share, -1, share) % share
                    result = self.times(result, self.circle_power(self._unity_part(q), a * (q // share)))
            self._unity_cache[key] = result
        return self._unity_cache[key]

    def _unity_part(self, q: int) -> Circle:
        if q not in self._unity_parts:
            self._unity_parts[q] = self._matched_root_of_unity(q)
        return self._unity_parts[q]

    def _random_norm_one(self) -> Circle:
        """Any point of the circle: (z/z̄) for a random z."""
        x, y = self.sample(), self.sample()
        scale = self.inverse(x * x + y * y)
        return (x * x - y * y) * scale % self.p, 2 * x * y * scale % self.p

    @cached_property
    def _windows(self) -> list[list[Circle]]:
        """Row w holds g^(j·2^(5w)), j = 0 ... 31, for a g of the part of order k."""
        g = self.circle_power(self._random_norm_one(), M)
        table = []
        for _ in range(-(-self.k.bit_length() // _WINDOW)):
            row: list[Circle] = [(1, 0)]
            for _ in range((1 << _WINDOW) - 1):
                row.append(self.times(row[-1], g))
            table.append(row)
            g = self.times(row[-1], g)
        return table

    def _matched_root_of_unity(self, q: int) -> Circle:
        """e^{2πi/q} for a prime power q of M, chosen to agree with the canonical roots of numbers.

        q = 32: cos 2π/32 is a square, and so on up to e^{2πi/4} = i. Odd q: Gauss's sum Σ (a/q) e^{2πia/q} is
        √q or i√q.
        """
        prime = 2 if q == 32 else 3 if q == 9 else q
        z: Circle = (1, 0)
        while self.circle_power(z, q // prime) == (1, 0):
            z = self.circle_power(self._random_norm_one(), (self.p + 1) // q)
        if prime == 2:
            return self._matched_power_of_two(z)
        if not self._gauss_sum_is_root(self.circle_power(z, q // prime), prime):
            z = self.circle_power(z, next(n for n in range(2, prime) if _jacobi(n, prime) == -1))
        if prime % 4 == 1 and self.sign(z[1]) == -1:
            z = (z[0], -z[1] % self.p)  # the conjugate has the same sum; 0 < sin 2π/5 decides
        return z

    def _matched_power_of_two(self, z: Circle) -> Circle:
        """The odd power of z with i = (0, 1) and cos π/4, cos π/8, cos π/16 squares."""
        for n in range(1, 32, 2):
            w = self.circle_power(z, n)
            chain = [w]
            for _ in range(3):
                chain.append(self.times(chain[-1], chain[-1]))
            if chain[3] == (0, 1) and all(self.sign(c[0]) == 1 for c in chain[:3]):
                return w
        raise AssertionError("no primitive 32nd root of unity agrees with the canonical roots")

    def _gauss_sum_is_root(self, z: Circle, prime: int) -> bool:
        total = [0, 0]
        w: Circle = (1, 0)
        for a in range(1, prime):
            w = self.times(w, z)
            total[0] += _jacobi(a, prime) * w[0]
            total[1] += _jacobi(a, prime) * w[1]
        return total[prime % 4 == 3] % self.p == self.root(prime)


class Fields:
    """Random fields, drawn when first needed. A seed makes them repeatable: for tests only."""

    def __init__(self, seed: int | None = None) -> None:
        # From the system's source: with a prime that could be predicted, p·θ could be added to an equation unseen.
        self.random = random.Random(seed) if seed is not None else random.SystemRandom()
        self._drawn: dict[tuple[int, frozenset[int]], PrimeField] = {}

    def field(self, number: int = 0, squares: frozenset[int] = frozenset()) -> PrimeField:
        """The field of this number in which `squares` are squares. Up to 64 are kept."""
        key = (number, squares)
        if key not in self._drawn:
            if len(self._drawn) >= 64:
                self._drawn.pop(next(iter(self._drawn)))
            self._drawn[key] = PrimeField.draw(random.Random(self.random.getrandbits(128)), squares)
        return self._drawn[key]


@cache
def process_fields() -> Fields:
    """The random fields of this process, different in every process."""
    return Fields()


def reconstructed(residue: int, p: int, bound: int | None = None) -> Fraction | None:
    """The fraction n/d ≡ residue (mod p) with |n|, d ≤ bound (default: the cube root of p), or None.

    At most one exists up to √(p/2). With the default, a random residue passes with probability p^(−1/3).
    """
    # Wang's rational reconstruction: Euclid's algorithm for p and the residue, stopped once the remainder is small.
    limit = round(p ** (1 / 3)) if bound is None else bound
    limit = min(limit, isqrt(p // 2))
    a, b = p, residue % p
    u, v = 0, 1
    while b > limit:
        quotient = a // b
        a, b = b, a - quotient * b
        u, v = v, u - quotient * v
    if v == 0 or abs(v) > limit or gcd(b, abs(v)) != 1:
        return None
    return Fraction(b, v)


def _jacobi(a: int, n: int) -> int:
    """The Jacobi symbol (a/n) for odd n > 0."""
    a %= n
    sign = 1
    while a:
        while a % 2 == 0:
            a //= 2
            if n % 8 in (3, 5):
                sign = -sign
        a, n = n, a
        if a % 4 == 3 and n % 4 == 3:
            sign = -sign
        a %= n
    return sign if n == 1 else 0
