"""Units of measurement: the factor to SI and the dimension of `kg m^2/s`, and numbers with units.

A unit is a product of powers of named units. Its dimension is the vector of exponents of kg, m, s, A, K, and its factor
is exact: 1 ft = 0.3048 m, 1 lb (force) = 0.453 592 37 kg · 9.806 65 m/s², 1° = π/180. Angles have the dimension of a
number. Of the unit names, those of SI may have a prefix.

    product = factor { [* · space] factor | / factor }        factor = (name | 1 | "(" product ")") [ power ]

After a division, juxtaposition is ambiguous: `J/kg K` is J/(kg K) to some and (J/kg) K to others, and is no unit here.
Reference: BIPM, The International System of Units (2019); NIST Special Publication 811, appendix B.
"""

from __future__ import annotations

import re
from functools import cache, lru_cache

import sympy as sp

from lagrange.core.diagnostics import nearest
from lagrange.core.limits import HIGHEST_POWER_OF_UNIT
from lagrange.core.records import record
from lagrange.core.unit_names import PREFIXES, WITH_PREFIX, WITHOUT_PREFIX

Dimension = tuple[sp.Rational, ...]
BASE = ("kg", "m", "s", "A", "K")
NO_DIMENSION: Dimension = (sp.S.Zero,) * len(BASE)


@record
class Unit:
    """A unit: how many units of SI it is, and its dimension."""

    factor: sp.Expr
    dimension: Dimension
    is_angle: bool = False

    def power(self, exponent: int) -> Unit:
        """unit^exponent."""
        return Unit(self.factor**exponent, tuple(exponent * n for n in self.dimension), self.is_angle)

    def times(self, other: Unit) -> Unit:
        """The product of two units."""
        dimension = tuple(a + b for a, b in zip(self.dimension, other.dimension, strict=True))
        return Unit(self.factor * other.factor, dimension, self.is_angle or other.is_angle)


NUMBER = Unit(sp.S.One, NO_DIMENSION)


_ANGLES = ("rad", "deg", "°", "rev", "rpm")

_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
# Compiled when a unit is read first: patterns take as long as all of the table.
_TOKEN = r"\s*(?:([A-Za-zΩ°%µμ]+|1(?![\d.]))|(\*\*|\^)\s*(-?\d+|\(\s*-?\d+\s*\))|([*/·⋅()]))"
# Numbers are atomic, (?>...), so that the 1e3 of a bare number is not taken for 1 e3, nor 2*pi for 2 and a unit.
_NUMERAL = (
    r"(?>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|(?:pi(?![A-Za-z])|π)|(?:sqrt|√)?\([-+*/^.\d\s]*\d[-+*/^.\d\s]*\)|√\d+)"
)
_ARITHMETIC = (
    rf"[-+−]?{_NUMERAL}(?>\s*(?:\*\*|[-+−*/·^])\s*[-+−]?{_NUMERAL}(?!\s*/\s*[A-Za-z(])|\s*(?:pi(?![A-Za-z])|π))*"
)
_NUMBER_AND_UNIT = rf"(?s)\s*((?>{_ARITHMETIC}))(?:\s*\*(?!\*))?\s*((?:1\s*)?/\s*[A-Za-z(].*|[A-Za-z°%µμΩ].*)"


def near_unit(text: str) -> str | None:
    """The unit probably intended by the first unknown name in a text: `deg` for `degg`; None if there is none."""
    names = [n for n in re.findall(r"[A-Za-zΩ°µμ]+", text) if _named(n) is None]
    return nearest(names[0], [*WITH_PREFIX, *WITHOUT_PREFIX]) if names and len(names[0]) > 2 else None


def split_number(text: str) -> tuple[str, str] | None:
    """`9.81 m/s^2` as its number and its unit; None if there is no number with something after it.

    The number may be arithmetic, `2*pi rad/s`, and the unit a factor, `9.81*m/s^2`.
    """
    match = re.fullmatch(_NUMBER_AND_UNIT, text)
    return (match[1].replace("−", "-"), match[2].strip()) if match else None


def has_unit(text: str) -> bool:
    """Whether a text is a number with a known unit: `7.5 cm`."""
    parts = split_number(text)
    return parts is not None and unit_of(parts[1]) is not None


@lru_cache(maxsize=1 << 10)
def unit_of(text: str) -> Unit | None:
    """The unit that a text denotes; None if it is not known, or ambiguous."""
    superscripts = re.sub(
        r"(?<=[A-Za-zΩ°µμ)])([⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)", lambda x: f"^{x[1].translate(_SUPERSCRIPTS)}", text.strip()
    )
    tokens, at = [], 0
    pattern = re.compile(_TOKEN)
    while at < len(superscripts):
        token = pattern.match(superscripts, at)
        if token is None:
            return None
        tokens.append(token)
        at = token.end()
    reader = _Reader(tokens)
    unit = reader.product() if tokens else None
    return unit if reader.at == len(tokens) else None


class _Reader:
    """Reads a product of units from tokens: (name), (operator, power) or (symbol)."""

    def __init__(self, tokens: list[re.Match[str]]) -> None:
        self.tokens = tokens
        self.at = 0

    def product(self) -> Unit | None:
        """A product; None if it is no unit. `/m` is 1/m."""
        total = NUMBER if self._symbol() == "/" else self._factor()
        divided = False
        while total is not None and self.at < len(self.tokens) and self._symbol() != ")":
            symbol = self._symbol()
            if symbol in ("*", "·", "⋅", "/"):
                self.at += 1
            elif divided:
                return None
            divided = symbol == "/"
            factor = self._factor()
            if factor is None:
                return None
            total = total.times(factor.power(-1) if symbol == "/" else factor)
        return total

    def _symbol(self) -> str | None:
        return self.tokens[self.at][4] if self.at < len(self.tokens) else None

    def _factor(self) -> Unit | None:
        if self.at == len(self.tokens):
            return None
        token = self.tokens[self.at]
        self.at += 1
        if token[4] == "(":
            unit = self.product()
            if unit is None or self._symbol() != ")":
                return None
            self.at += 1
        else:
            unit = _named(token[1]) if token[1] else None
        if unit is None or self.at == len(self.tokens) or not self.tokens[self.at][2]:
            return unit
        exponent = int(self.tokens[self.at][3].strip("() "))
        self.at += 1
        return unit.power(exponent) if abs(exponent) <= HIGHEST_POWER_OF_UNIT else None


def _named(name: str) -> Unit | None:
    known, prefix = WITHOUT_PREFIX.get(name) or WITH_PREFIX.get(name), 0
    if known is None and name[0] in PREFIXES:
        known, prefix, name = WITH_PREFIX.get(name[1:]), PREFIXES[name[0]], name[1:]
    if known is None:
        return None
    text, powers = known
    factor = sp.Integer(10) ** prefix
    for part in text.split("*"):
        numerator, _, denominator = part.partition("/")
        factor *= sp.pi if part == "pi" else sp.Rational(numerator) / sp.Rational(denominator or 1)
    return Unit(factor, tuple(map(sp.Integer, powers)) + NO_DIMENSION[len(powers) :], name in _ANGLES)


def unit_of_dimension(dimension: Dimension) -> str:
    """The unit of SI with a dimension, `kg m/s^2`; `1` for a number."""
    above = [u if n == 1 else f"{u}^{n}" for u, n in zip(BASE, dimension, strict=True) if n > 0]
    below = [u if n == -1 else f"{u}^{-n}" for u, n in zip(BASE, dimension, strict=True) if n < 0]
    if not below:
        return " ".join(above) or "1"
    return f"{' '.join(above) or '1'}/{below[0] if len(below) == 1 else '(' + ' '.join(below) + ')'}"


def unit_called(dimension: Dimension, is_angle: bool = False) -> str:
    """The unit of SI with a dimension, `N m` or `s^-1`; rad for an angle, and empty for a number."""
    called = si_unit(Unit(sp.S.One, dimension, is_angle))
    if called == "1":
        return ""
    inverse = re.fullmatch(r"1/(\w+)(?:\^(\d+))?", called)
    return f"{inverse[1]}^-{inverse[2] or 1}" if inverse else called


def si_unit(unit: Unit) -> str:
    """The unit of SI with the dimension of a unit, as engineers write it: N for kN, rad for deg, rad/s for rpm."""
    plain = _named_dimensions().get(unit.dimension) or unit_of_dimension(unit.dimension)
    if not unit.is_angle:
        return plain
    return "rad" + plain.removeprefix("1") if plain.startswith("1") else plain


@cache
def _named_dimensions() -> dict[Dimension, str]:
    names = ("C", "V", "W", "T", "F", "H", "V/m", "Pa", "N m", "N s/m", "N/m", "N")
    return {u.dimension: name for name in names if (u := unit_of(name)) is not None}
