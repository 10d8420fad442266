"""Lists of whole numbers packed in one: exponents of a monomial, coefficients of a frequency.

The value at place i is counted in units of 2^(32 i), so that multiplying monomials and adding frequencies
is adding whole numbers, and the sign of a frequency is the sign of its last place. Values may be negative.
Monagan and Pearce, *Polynomial division using dynamic arrays, heaps, and packed exponent vectors* (2007).
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

WIDTH = 32
LARGEST = 1 << 16  # larger values are not packed, so that sums of thousands of them do not overflow
_MASK = (1 << WIDTH) - 1
_HALF = 1 << (WIDTH - 1)


@lru_cache(maxsize=1 << 14)
def unpack(packed: int) -> tuple[tuple[int, int], ...]:
    """The places that are not zero: (index, value), in the order of the index."""
    places = []
    index = 0
    while packed:
        skip = ((packed & -packed).bit_length() - 1) // WIDTH
        packed >>= skip * WIDTH
        index += skip
        value = packed & _MASK
        if value >= _HALF:
            value -= 1 << WIDTH
        places.append((index, value))
        packed = (packed - value) >> WIDTH
        index += 1
    return tuple(places)


def pack(places: Iterable[tuple[int, int]]) -> int:
    """The whole number with these values at these places."""
    return sum(value << (WIDTH * index) for index, value in places)


def place(packed: int, index: int) -> int:
    """The value at one place."""
    return next((value for i, value in unpack(packed) if i == index), 0)


def lowest(monomials: Iterable[int]) -> int:
    """The largest monomial that leaves no negative exponent: 1/r of a/r + b, r of a r + b r²."""
    least: dict[int, int] | None = None
    for monomial in monomials:
        powers = dict(unpack(monomial))
        if least is None:
            least = powers
        else:
            found = {i: min(powers.get(i, 0), least.get(i, 0)) for i in powers.keys() | least.keys()}
            least = {i: e for i, e in found.items() if e}
    return pack(least.items()) if least else 0


def common(monomials: Iterable[int]) -> int:
    """What is written in front of a bracket: 1/r of a/r + b/r², but nothing of a/r + b."""
    powers = [dict(unpack(m)) for m in monomials]
    found = {}
    for i in powers[0]:
        exponents = [p.get(i, 0) for p in powers]
        if exponents[0] > 0:
            found[i] = max(min(exponents), 0)
        else:
            found[i] = min(max(exponents), 0)
    return pack(found.items())


def shared(a: int, b: int) -> int:
    """The greatest common divisor of two monomials, without negative powers."""
    return pack((i, e) for i, e in unpack(common((a, b))) if e > 0)


def divides(factor: int, monomial: int) -> bool:
    """Whether a monomial with positive exponents divides another."""
    powers = dict(unpack(monomial))
    return all(powers.get(i, 0) >= e for i, e in unpack(factor))
