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
from functools import lru_cache

import sympy as sp

from lagrange.core.records import record

Dimension = tuple[sp.Rational, ...]
BASE = ("kg", "m", "s", "A", "K")
NO_DIMENSION: Dimension = (sp.S.Zero,) * len(BASE)
HIGHEST_POWER = 20
"""Of a unit: no quantity has a higher one, and 1e9^9999 takes memory."""


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


def _unit(factor: object, angle: bool = False, **powers: int) -> Unit:
    dimension = tuple(sp.Integer(powers.get(name, 0)) for name in BASE)
    return Unit(sp.Rational(str(factor)), dimension, angle)


_WITH_PREFIX = {
    "g": _unit("1/1000", kg=1), "m": _unit(1, m=1), "s": _unit(1, s=1), "A": _unit(1, A=1), "K": _unit(1, K=1),
    "Hz": _unit(1, s=-1), "N": _unit(1, kg=1, m=1, s=-2), "J": _unit(1, kg=1, m=2, s=-2),
    "W": _unit(1, kg=1, m=2, s=-3), "Pa": _unit(1, kg=1, m=-1, s=-2), "C": _unit(1, A=1, s=1),
    "V": _unit(1, kg=1, m=2, s=-3, A=-1), "T": _unit(1, kg=1, s=-2, A=-1), "Ω": _unit(1, kg=1, m=2, s=-3, A=-2),
    "F": _unit(1, kg=-1, m=-2, s=4, A=2), "H": _unit(1, kg=1, m=2, s=-2, A=-2), "Nm": _unit(1, kg=1, m=2, s=-2),
    "rad": _unit(1, angle=True),
}  # fmt: skip

_PREFIXES = {
    "p": -12, "n": -9, "u": -6, "µ": -6, "μ": -6, "m": -3, "c": -2, "d": -1, "h": 2, "k": 3, "M": 6, "G": 9, "T": 12,
}  # fmt: skip

_POUND_FORCE = sp.Rational("0.45359237") * sp.Rational("9.80665")
_DEGREE = Unit(sp.pi / 180, NO_DIMENSION, is_angle=True)
_TURN = Unit(2 * sp.pi, NO_DIMENSION, is_angle=True)

_WITHOUT_PREFIX = {
    "1": NUMBER, "%": _unit("1/100"), "sr": _unit(1), "t": _unit(1000, kg=1),
    "min": _unit(60, s=1), "h": _unit(3600, s=1),
    "deg": _DEGREE, "°": _DEGREE, "rev": _TURN, "rpm": Unit(sp.pi / 30, _unit(1, s=-1).dimension, is_angle=True),
    "ft": _unit("0.3048", m=1), "in": _unit("0.0254", m=1), "mph": _unit("0.44704", m=1, s=-1),
    "lb": Unit(_POUND_FORCE, _unit(1, kg=1, m=1, s=-2).dimension),
    "lbf": Unit(_POUND_FORCE, _unit(1, kg=1, m=1, s=-2).dimension),
    "slug": Unit(_POUND_FORCE / sp.Rational("0.3048"), _unit(1, kg=1).dimension),
}  # fmt: skip

_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_TOKEN = re.compile(r"\s*(?:([A-Za-zΩ°%µμ]+|1(?![\d.]))|(\*\*|\^)\s*(-?\d+|\(\s*-?\d+\s*\))|([*/·⋅()]))")
# Numbers are atomic, (?>...), so that the 1e3 of a bare number is not taken for 1 e3, nor 2*pi for 2 and a unit.
_NUMERAL = (
    r"(?>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|(?:pi(?![A-Za-z])|π)|(?:sqrt|√)?\([-+*/^.\d\s]*\d[-+*/^.\d\s]*\)|√\d+)"
)
_ARITHMETIC = (
    rf"[-+−]?{_NUMERAL}(?>\s*(?:\*\*|[-+−*/·^])\s*[-+−]?{_NUMERAL}(?!\s*/\s*[A-Za-z(])|\s*(?:pi(?![A-Za-z])|π))*"
)
_NUMBER_AND_UNIT = re.compile(
    rf"\s*((?>{_ARITHMETIC}))(?:\s*\*(?!\*))?\s*((?:1\s*)?/\s*[A-Za-z(].*|[A-Za-z°%µμΩ].*)", re.S
)


def split_number(text: str) -> tuple[str, str] | None:
    """`9.81 m/s^2` as its number and its unit; None if there is no number with something after it.

    The number may be arithmetic, `2*pi rad/s`, and the unit a factor, `9.81*m/s^2`.
    """
    match = _NUMBER_AND_UNIT.fullmatch(text)
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
    while at < len(superscripts):
        token = _TOKEN.match(superscripts, at)
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
        """A product; None where it is no unit. `/m` is 1/m."""
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
        return unit.power(exponent) if abs(exponent) <= HIGHEST_POWER else None


def _named(name: str) -> Unit | None:
    known = _WITHOUT_PREFIX.get(name) or _WITH_PREFIX.get(name)
    if known is not None or len(name) < 2 or name[0] not in _PREFIXES:
        return known
    unit = _WITH_PREFIX.get(name[1:])
    return (
        None
        if unit is None
        else Unit(unit.factor * sp.Integer(10) ** _PREFIXES[name[0]], unit.dimension, unit.is_angle)
    )


def written(dimension: Dimension) -> str:
    """The unit of SI with a dimension, `kg m/s^2`; `1` for a number."""
    above = [u if n == 1 else f"{u}^{n}" for u, n in zip(BASE, dimension, strict=True) if n > 0]
    below = [u if n == -1 else f"{u}^{-n}" for u, n in zip(BASE, dimension, strict=True) if n < 0]
    if not below:
        return " ".join(above) or "1"
    return f"{' '.join(above) or '1'}/{below[0] if len(below) == 1 else '(' + ' '.join(below) + ')'}"


def unit_called(dimension: Dimension, is_angle: bool = False) -> str:
    """The unit of SI with a dimension, `N m` or `s^-1`; rad for an angle, and empty for a number."""
    called = in_si(Unit(sp.S.One, dimension, is_angle))
    if called == "1":
        return ""
    inverse = re.fullmatch(r"1/(\w+)(?:\^(\d+))?", called)
    return f"{inverse[1]}^-{inverse[2] or 1}" if inverse else called


_NAMED = {u.dimension: name for name in ("W", "N m", "N s/m", "N/m", "N") if (u := unit_of(name)) is not None}


def in_si(unit: Unit) -> str:
    """The unit of SI with the dimension of a unit, as engineers write it: N for kN, rad for deg, rad/s for rpm."""
    plain = _NAMED.get(unit.dimension) or written(unit.dimension)
    if not unit.is_angle:
        return plain
    return "rad" + plain.removeprefix("1") if plain.startswith("1") else plain
