"""Dimensional analysis: whether the terms of an equation have the same dimension.

The unit that a file gives to a symbol is a product of powers of units; its dimension is a vector of exponents of kg, m,
s, A, K. A time derivative lowers the exponent of s by one. A symbol without a unit has an unknown dimension, and
equations with such symbols are not judged, except that the argument of a sine, an exponential or a logarithm must be a
number.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import base, t

Dimension = tuple[sp.Rational, ...]
_BASE = ("kg", "m", "s", "A", "K")
_NONE: Dimension = (sp.S.Zero,) * len(_BASE)


def _of(**powers: int) -> Dimension:
    return tuple(sp.Integer(powers.get(unit, 0)) for unit in _BASE)


_UNITS = {
    "1": _NONE, "rad": _NONE, "deg": _NONE, "°": _NONE, "sr": _NONE, "%": _NONE,
    "kg": _of(kg=1), "g": _of(kg=1), "t": _of(kg=1), "m": _of(m=1), "cm": _of(m=1), "mm": _of(m=1), "km": _of(m=1),
    "s": _of(s=1), "min": _of(s=1), "h": _of(s=1), "ms": _of(s=1), "Hz": _of(s=-1),
    "N": _of(kg=1, m=1, s=-2), "kN": _of(kg=1, m=1, s=-2), "J": _of(kg=1, m=2, s=-2), "Nm": _of(kg=1, m=2, s=-2),
    "W": _of(kg=1, m=2, s=-3), "Pa": _of(kg=1, m=-1, s=-2), "A": _of(A=1), "C": _of(A=1, s=1), "K": _of(K=1),
    "V": _of(kg=1, m=2, s=-3, A=-1), "T": _of(kg=1, s=-2, A=-1), "Ω": _of(kg=1, m=2, s=-3, A=-2),
    "F": _of(kg=-1, m=-2, s=4, A=2), "H": _of(kg=1, m=2, s=-2, A=-2),
}  # fmt: skip
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_PART = re.compile(r"\s*([*/·⋅ ]?)\s*\(?([A-Za-zΩ°%]+|1)\s*(?:\^?\s*\(?(-?\d+)\)?)?\)?")


@record
class Mismatch:
    """A term whose dimension differs from that of the others, and one of these."""

    term: sp.Expr
    dimension: Dimension
    other: sp.Expr
    expected: Dimension


class _Unknown(Exception):  # noqa: N818 - nothing is wrong
    """The dimension is not known."""


class _Mismatched(Exception):  # noqa: N818 - it brings a result
    def __init__(self, mismatch: Mismatch) -> None:
        super().__init__()
        self.mismatch = mismatch


def dimension_of_unit(unit: str) -> Dimension | None:
    """The dimension of a unit such as `kg m^2/s`; None if it is not understood."""
    text = re.sub(r"([A-Za-z])([⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)", lambda x: f"{x[1]}^{x[2].translate(_SUPERSCRIPTS)}", unit.strip())
    total, at, below = list(_NONE), 0, False
    while at < len(text):
        part = _PART.match(text, at)
        if part is None or part.end() == at or part[2] not in _UNITS:
            return None
        below = part[1] == "/" or (below and part[1] not in ("*", "·", "⋅"))
        power = int(part[3] or 1) * (-1 if below else 1)
        total = [a + power * b for a, b in zip(total, _UNITS[part[2]], strict=True)]
        below = below and part[1] == "/"
        at = part.end()
    return tuple(total)


def written(dimension: Dimension) -> str:
    """`kg m/s^2`; `1` for a number."""
    above = [u if n == 1 else f"{u}^{n}" for u, n in zip(_BASE, dimension, strict=True) if n > 0]
    below = [u if n == -1 else f"{u}^{-n}" for u, n in zip(_BASE, dimension, strict=True) if n < 0]
    if not below:
        return " ".join(above) or "1"
    return f"{' '.join(above) or '1'}/{below[0] if len(below) == 1 else '(' + ' '.join(below) + ')'}"


def mismatch(terms: Sequence[sp.Expr], units: Mapping[sp.Symbol, str]) -> Mismatch | None:
    """The term of a sum that does not agree with the others; None if they agree, or if that is not known."""
    known = {s: d for s, unit in units.items() if unit and (d := dimension_of_unit(unit)) is not None}
    waves = (w for term in terms for w in term.atoms(sp.sin, sp.cos, sp.tan))
    angles = {base(s) for w in waves for s in w.args[0].free_symbols if base(s) not in known}
    known |= dict.fromkeys(angles - {t}, _NONE) | {t: _of(s=1)}
    try:
        _sum(terms, known)
    except _Unknown:
        return None
    except _Mismatched as error:
        return error.mismatch
    return None


def _sum(terms: Iterable[sp.Expr], known: Mapping[sp.Symbol, Dimension]) -> Dimension:
    """The dimension of a sum. Raises _Mismatched at the first term that differs from the majority."""
    dimensions = [(term, _dimension(term, known)) for term in terms if term != 0]
    counts = Counter(d for _, d in dimensions)
    if len(counts) > 1:
        usual = max(counts, key=lambda d: (counts[d], d == dimensions[0][1]))
        term, dimension = next((t, d) for t, d in dimensions if d != usual)
        other = next(t for t, d in dimensions if d == usual)
        raise _Mismatched(Mismatch(term, dimension, other, usual))
    return dimensions[0][1] if dimensions else _NONE


def _dimension(e: sp.Expr, known: Mapping[sp.Symbol, Dimension]) -> Dimension:
    if e.is_number:
        return _NONE
    if isinstance(e, sp.Symbol):
        q = base(e)
        if q not in known:
            raise _Unknown
        order = len(e.name) - len(q.name)
        return tuple(n - order * (unit == "s") for n, unit in zip(known[q], _BASE, strict=True))
    if isinstance(e, sp.Add):
        return _sum(e.args, known)
    if isinstance(e, sp.Mul):
        parts = [_dimension(a, known) for a in e.args]
        return tuple(sp.Add(*column) for column in zip(*parts, strict=True))
    if isinstance(e, sp.Pow) and e.exp.is_Rational:
        return tuple(n * e.exp for n in _dimension(e.base, known))
    if isinstance(e, sp.Abs):
        return _dimension(e.args[0], known)
    if isinstance(e, sp.sin | sp.cos | sp.tan | sp.exp | sp.log | sp.sinh | sp.cosh | sp.tanh):
        _argument(e.args[0], known)
        return _NONE
    raise _Unknown


def _argument(e: sp.Expr, known: Mapping[sp.Symbol, Dimension]) -> None:
    """Checks that the argument of a function is a number; symbols without a unit are taken for angles."""
    angles = {s: _NONE for s in e.free_symbols if s not in known and "'" not in s.name}
    dimension = _dimension(e, {**known, **angles})
    if dimension != _NONE:
        raise _Mismatched(Mismatch(e, dimension, sp.S.One, _NONE))
