"""Dimensions that follow from homogeneity: the terms of a sum have one dimension, the argument of a sine has none.

The dimension of an expression is a product of powers of the units kg, m, s, A, K and of the unknown dimensions of
symbols. The exponents of factors add, and a time derivative takes 1 from that of s. Two terms of a sum give one linear
equation between exponents,

    [a] + [b] − [c] = 0        for a b + c ,

which determines one unknown more, or nothing new. An equation that contradicts those before it is passed over: numbers
may hide units (10 m for a weight), and a term with a large number in front is not judged at all.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from fractions import Fraction

import sympy as sp

from lagrange.core.symbols import Sign, Unspecified, base, t
from lagrange.core.units import BASE, Dimension
from lagrange.values.limits import LARGEST_COEFFICIENT

UnitExponents = dict[Hashable, Fraction]
"""Of units, by their names, and of unknown dimensions, by a symbol or the name of an undefined function."""

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
        """Learns that these dimensions are one, and returns it; None where none is known, or they contradict."""
        first, agree = None, True
        for term in terms:
            if first is None:
                first = term
            elif term is not None:
                agree = self._learned(exponents_of_product((first, 1), (term, -1))) and agree
        return first if agree else None

    def dimension(self, e: sp.Expr) -> Dimension | None:
        """The dimension of an expression; None where it does not follow."""
        found = self.exponents(e)
        whole = None if found is None else self._with_known(found)
        if whole is None or any(not isinstance(key, str) or key not in BASE for key in whole):
            return None
        return tuple(sp.Rational(n.numerator, n.denominator) for n in (whole.get(u, Fraction(0)) for u in BASE))

    def exponents(self, e: sp.Expr) -> UnitExponents | None:
        """The exponents of an expression, each part looked at once; None where there is nothing to go by."""
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
