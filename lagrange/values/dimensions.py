"""Dimensional analysis: whether the terms of an equation have the same dimension.

The unit that a file gives to a symbol is a product of powers of units; its dimension is a vector of exponents of kg, m,
s, A, K. A time derivative lowers the exponent of s by one. A symbol without a unit has an unknown dimension, and
equations with such symbols are not judged, except that the argument of a sine, an exponential or a logarithm must be a
number.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import base, t
from lagrange.core.units import BASE, NO_DIMENSION, Dimension, unit_of
from lagrange.values.limits import LARGEST_COEFFICIENT

_SECOND: Dimension = tuple(sp.Integer(unit == "s") for unit in BASE)


@record
class Mismatch:
    """A term whose dimension differs from that of the others, and one of these."""

    term: sp.Expr
    dimension: Dimension
    other: sp.Expr
    expected: Dimension


class _Unknown(Exception):  # noqa: N818 - nothing is wrong
    """The dimension is not known."""


def dimension(expression: sp.Expr, known: Mapping[sp.Symbol, Dimension]) -> Dimension | None:
    """The dimension of an expression; None if it is not known, or the terms disagree."""
    try:
        return _dimension(expression, {t: _SECOND, **known})
    except (_Unknown, _Mismatched):
        return None


def dimensions_needed(
    stated: Sequence[tuple[sp.Expr, Dimension]], known: Mapping[sp.Symbol, Dimension]
) -> dict[sp.Symbol, Dimension] | None:
    """The dimensions that symbols need for each expression to have the dimension stated with it; None if none fit.

    Dimensions of products are linear in those of their factors: a term c a^p b^q with the dimension D gives
    p [a] + q [b] = D. A number in front may hide a unit (10 m for m g), and its term is passed over unless the number
    is small; so are terms that are no products of powers.
    """
    known = {t: _SECOND, **known}
    symbols: dict[sp.Symbol, int] = {}
    rows: list[tuple[dict[int, sp.Rational], Dimension]] = []
    for expression, expected in stated:
        for term in sp.Add.make_args(sp.expand(expression)):
            powers = _powers(term)
            if powers is None:
                continue
            row: dict[int, sp.Rational] = {}
            rest = list(expected)
            for symbol, power in powers.items():
                q = base(symbol)
                order = len(symbol.name) - len(q.name)
                rest = [n + power * order * (unit == "s") for n, unit in zip(rest, BASE, strict=True)]
                if q in known:
                    rest = [n - power * k for n, k in zip(rest, known[q], strict=True)]
                else:
                    at = symbols.setdefault(q, len(symbols))
                    row[at] = row.get(at, sp.S.Zero) + power
            rows.append((row, tuple(rest)))
    return _solved(rows, tuple(symbols))


def _powers(term: sp.Expr) -> dict[sp.Symbol, sp.Rational] | None:
    """The powers of the symbols in a product; None if it is none, or a number may hide a unit."""
    powers: dict[sp.Symbol, sp.Rational] = {}
    for factor in sp.Mul.make_args(term):
        b, exponent = factor.as_base_exp()
        if factor.is_Rational and abs(factor.p) <= LARGEST_COEFFICIENT:
            continue
        if isinstance(factor, sp.sin | sp.cos | sp.tan) or factor == sp.pi:
            continue
        if isinstance(b, sp.sin | sp.cos | sp.tan) or (b.is_Integer and abs(b) <= LARGEST_COEFFICIENT):
            continue
        if not b.is_Symbol or not exponent.is_Rational:
            return None
        powers[b] = powers.get(b, sp.S.Zero) + exponent
    return powers or None


def _solved(
    rows: Sequence[tuple[dict[int, sp.Rational], Dimension]], symbols: Sequence[sp.Symbol]
) -> dict[sp.Symbol, Dimension] | None:
    """The symbols whose dimension is determined; None if the equations contradict one another."""
    width, height = len(symbols), len(rows)
    if not rows:
        return {}
    table = [[row.get(n, sp.S.Zero) for n in range(width)] + list(rest) for row, rest in rows]
    pivots: list[int] = []
    for column in range(width):
        at = next((k for k in range(len(pivots), height) if table[k][column] != 0), None)
        if at is None:
            continue
        top = len(pivots)
        table[top], table[at] = table[at], table[top]
        table[top] = [x / table[top][column] for x in table[top]]
        for k in range(height):
            if k != top and table[k][column] != 0:
                table[k] = [x - table[k][column] * y for x, y in zip(table[k], table[top], strict=True)]
        pivots.append(column)
    if any(any(x != 0 for x in row[width:]) for row in table[len(pivots) :]):
        return None
    return {
        symbols[column]: tuple(row[width:])
        for column, row in zip(pivots, table, strict=False)
        if all(x == 0 for n, x in enumerate(row[:width]) if n != column)
    }


class _Mismatched(Exception):  # noqa: N818 - it brings a result
    def __init__(self, mismatch: Mismatch) -> None:
        super().__init__()
        self.mismatch = mismatch


def dimension_of_unit(unit: str) -> Dimension | None:
    """The dimension of a unit such as `kg m^2/s`; None if it is not understood."""
    known = unit_of(unit)
    return None if known is None else known.dimension


def dimensions_of_units(units: Mapping[sp.Symbol, str]) -> dict[sp.Symbol, Dimension]:
    """The dimensions of the symbols whose units are understood."""
    return {s: d for s, unit in units.items() if unit and (d := dimension_of_unit(unit)) is not None}


def mismatch(terms: Sequence[sp.Expr], units: Mapping[sp.Symbol, str]) -> Mismatch | None:
    """The term of a sum that does not agree with the others; None if they agree, or if that is not known."""
    known = dimensions_of_units(units)
    waves = (w for term in terms for w in term.atoms(sp.sin, sp.cos, sp.tan))
    angles = {base(s) for w in waves for s in w.args[0].free_symbols if base(s) not in known}
    known |= dict.fromkeys(angles - {t}, NO_DIMENSION) | {t: _SECOND}
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
    return dimensions[0][1] if dimensions else NO_DIMENSION


def _dimension(e: sp.Expr, known: Mapping[sp.Symbol, Dimension]) -> Dimension:
    if e.is_number:
        return NO_DIMENSION
    if isinstance(e, sp.Symbol):
        q = base(e)
        if q not in known:
            raise _Unknown
        order = len(e.name) - len(q.name)
        return tuple(n - order * (unit == "s") for n, unit in zip(known[q], BASE, strict=True))
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
        return NO_DIMENSION
    if isinstance(e, sp.asin | sp.acos | sp.atan | sp.sign):
        return NO_DIMENSION
    raise _Unknown


def _argument(e: sp.Expr, known: Mapping[sp.Symbol, Dimension]) -> None:
    """Checks that the argument of a function is a number; symbols without a unit are taken for angles."""
    angles = {s: NO_DIMENSION for s in e.free_symbols if s not in known and "'" not in s.name}
    dimension = _dimension(e, {**known, **angles})
    if dimension != NO_DIMENSION:
        raise _Mismatched(Mismatch(e, dimension, sp.S.One, NO_DIMENSION))
