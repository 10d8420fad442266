"""Dimensional analysis: whether the terms of an equation have the same dimension.

The unit that a file gives to a symbol is a product of powers of units; its dimension is a vector of exponents of kg, m,
s, A, K. A time derivative lowers the exponent of s by one. A symbol without a unit has an unknown dimension, and
equations with such symbols are not judged, except that the argument of a sine, an exponential or a logarithm must be a
number.

Dimensions that follow from homogeneity: the terms of a sum have one dimension, the argument of a sine has none.

The dimension of an expression is a product of powers of the units kg, m, s, A, K and of the unknown dimensions of
symbols. The exponents of factors add, and a time derivative takes 1 from that of s. Two terms of a sum give one linear
equation between exponents,

    [a] + [b] − [c] = 0        for a b + c ,

which determines one unknown more, or nothing new. An equation that contradicts those before it is passed over: numbers
may hide units (10 m for a weight), and a term with a large number in front is not judged at all.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Mapping, Sequence
from fractions import Fraction

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Sign, Unspecified, base, t
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


def has_bare_number(sides: Iterable[sp.Expr], known: Mapping[sp.Symbol, Dimension]) -> bool:
    """Whether a comparison is one of a bare number with what has a unit, as 160 > m g."""
    terms = [x for side in sides for x in sp.Add.make_args(sp.expand(side))]
    has_unit = any(dimension(x, known) not in (None, NO_DIMENSION) for x in terms)
    return has_unit and any(x.is_number and x != 0 for x in terms)


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
                rest = [n + power * order * int(unit == "s") for n, unit in zip(rest, BASE, strict=True)]
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


# Homogeneity


UnitExponents = dict[Hashable, Fraction]
"""Exponents of units, by name, and of unknown dimensions, by a symbol or the name of an undefined function."""

_OF_A_NUMBER = (sp.sin, sp.cos, sp.tan, sp.exp, sp.log, sp.sinh, sp.cosh, sp.tanh, sp.asin, sp.acos, sp.atan)


class Homogeneity:
    """What is known of dimensions, and what sums add to it."""

    def __init__(self, known: Mapping[sp.Symbol, Dimension]) -> None:
        self._known: dict[Hashable, UnitExponents] = {
            s: {u: Fraction(int(n.p), int(n.q)) for u, n in zip(BASE, d, strict=True) if n} for s, d in known.items()
        }
        self._known[t] = {"s": Fraction(1)}
        self._found: dict[sp.Expr, UnitExponents | None] = {}

    def equal(self, *sides: sp.Expr) -> None:
        """Learns that all these have one dimension."""
        self.alike(self.exponents(e) for e in sides)

    def alike(self, terms: Iterable[UnitExponents | None]) -> UnitExponents | None:
        """Learns that these dimensions are one, and returns it; None if none is known, or they contradict."""
        first, agree = None, True
        for term in terms:
            if first is None:
                first = term
            elif term is not None:
                agree = self._learned(exponents_of_product((first, 1), (term, -1))) and agree
        return first if agree else None

    def dimension(self, e: sp.Expr) -> Dimension | None:
        """The dimension of an expression; None if it does not follow."""
        found = self.exponents(e)
        whole = None if found is None else self._with_known(found)
        if whole is None or any(not isinstance(key, str) or key not in BASE for key in whole):
            return None
        return tuple(sp.Rational(n.numerator, n.denominator) for n in (whole.get(u, Fraction(0)) for u in BASE))

    def exponents(self, e: sp.Expr) -> UnitExponents | None:
        """The exponents of an expression, each part looked at once; None if there is nothing to go by."""
        if e not in self._found:
            self._found[e] = self._exponents(e)
        return self._found[e]

    def _exponents(self, e: sp.Expr) -> UnitExponents | None:
        if e.is_number:
            small = all(abs(n.p) <= LARGEST_COEFFICIENT for n in e.atoms(sp.Rational)) and not e.has(sp.Float)
            return {} if small and e != 0 else None
        if isinstance(e, Sign):
            return {}
        if isinstance(e, sp.Symbol):
            q = base(e)
            return exponents_of_product(({q: Fraction(1)}, 1), ({"s": Fraction(1)}, len(q.name) - len(e.name)))
        if isinstance(e, sp.Add | sp.Max | sp.Min):
            return self.alike([self.exponents(a) for a in e.args])
        if isinstance(e, sp.Mul):
            parts = [self.exponents(a) for a in e.args]
            known = [p for p in parts if p is not None]
            return exponents_of_product(*((p, 1) for p in known)) if len(known) == len(parts) else None
        if isinstance(e, sp.Pow) and e.exp.is_Rational:
            below = self.exponents(e.base)
            return None if below is None else exponents_of_product((below, Fraction(int(e.exp.p), int(e.exp.q))))
        if isinstance(e, sp.Abs):
            return self.exponents(e.args[0])
        if isinstance(e, Unspecified):
            return self._of_function(e)
        if isinstance(e, sp.sign | sp.atan2):
            self.alike([self.exponents(a) for a in e.args])
            return {}
        if isinstance(e, (*_OF_A_NUMBER, sp.Pow)):
            for a in e.args:
                self.alike([{}, self.exponents(a)])
            return {}
        return None

    def _of_function(self, f: Unspecified) -> UnitExponents | None:
        """That of the function itself, divided by those of the arguments with respect to which it is differentiated."""
        places = [self.exponents(a) for a in f.arguments]
        if any(place is None and order for place, order in zip(places, f.orders, strict=True)):
            return None
        slopes = ((place or {}, -int(order)) for place, order in zip(places, f.orders, strict=True))
        return exponents_of_product(({f.name + "()": Fraction(1)}, 1), *slopes)

    def _with_known(self, e: UnitExponents) -> UnitExponents:
        return exponents_of_product(*((self._known.get(key, {key: Fraction(1)}), n) for key, n in e.items()))

    def _learned(self, zero: UnitExponents) -> bool:
        """Solves an equation for one of its unknowns; whether it agrees with what is known."""
        rest = self._with_known(zero)
        unknown = next((key for key in rest if not isinstance(key, str) or key not in BASE), None)
        if unknown is None:
            return not rest
        share = rest.pop(unknown)
        rule = exponents_of_product((rest, -1 / share))
        for key, value in self._known.items():
            if unknown in value:
                n = value.pop(unknown)
                self._known[key] = exponents_of_product((value, 1), (rule, n))
        self._known[unknown] = rule
        return True


def exponents_of_product(*factors: tuple[UnitExponents, Fraction | int]) -> UnitExponents:
    """The exponents of a product of powers."""
    out: UnitExponents = {}
    for exponents, power in factors:
        for key, n in exponents.items():
            total = out.get(key, Fraction(0)) + power * n
            if total:
                out[key] = total
            else:
                out.pop(key, None)
    return out
