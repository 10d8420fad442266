"""A form ω = Σ a_i dq_i with its derivatives, and their values at many points of one prime field.

A factor μ makes ω exact when d(μω) = 0, that is, with θ = d(log μ),

    θ ∧ ω = -dω,      θ_i a_j - θ_j a_i = -(∂_i a_j - ∂_j a_i).

Where ω ∧ dω = 0, the pairs (p, j) with one fixed p for which a_p ≠ 0 imply the others. So what is asked of log μ is
linear, and n - 1 equations hold at each point. All points lie in one field, so that their rows can be reduced
together; a variable can be kept while the others are drawn again.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from functools import cached_property
from typing import Any, TypeVar

import sympy as sp

from lagrange.algebra.exact.exact import InadmissibleError, NoPointError, Point, Surface, reconstructed
from lagrange.algebra.exact.linear_algebra import Row, row_reduced
from lagrange.algebra.forms.potentials import differentiated
from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, t

T = TypeVar("T")

LARGEST_FRACTION = 60
_DRAWS = 200


@record
class OneForm:
    """Σ a_i dq_i, without the variables that do not occur.

    coefficients  (k,)
    variables     (k,), t among them where it occurs
    """

    coefficients: tuple[sp.Expr, ...]
    variables: tuple[sp.Symbol, ...]
    slots: Slots

    @classmethod
    def of(cls, form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> OneForm:
        """The form in those variables that occur in it."""
        occurring = {s for a in form for s in a.free_symbols}
        if any(base(s) in slots.prescribed for s in occurring):
            occurring.add(t)
        pairs = [(a, v) for a, v in zip(form, variables, strict=True) if a != 0 or v in occurring]
        return cls(tuple(a for a, _ in pairs), tuple(v for _, v in pairs), slots)

    @property
    def size(self) -> int:
        """The number of variables."""
        return len(self.variables)

    def rate(self, e: sp.Expr, k: int) -> sp.Expr:
        """∂e/∂q_k."""
        return differentiated(e, self.variables[k], self.slots)

    @cached_property
    def rates(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """∂_k a_i, shape (k, k): row i, column k."""
        return tuple(tuple(self.rate(a, k) for k in range(self.size)) for a in self.coefficients)

    def curl(self, i: int, j: int) -> sp.Expr:
        """∂_i a_j - ∂_j a_i."""
        return self.rates[j][i] - self.rates[i][j]

    def times(self, factor: sp.Expr) -> tuple[sp.Expr, ...]:
        """The coefficients of μω."""
        return tuple(factor * a for a in self.coefficients)

    @property
    def moving(self) -> set[sp.Symbol]:
        """What is no parameter: the variables, and prescribed motions with their rates."""
        symbols = {s for a in self.coefficients for s in a.free_symbols}
        return {*self.variables, t, *(s for s in symbols if base(s) in self.slots.prescribed)}

    @cached_property
    def parameters(self) -> tuple[sp.Symbol, ...]:
        """The symbols that do not move."""
        symbols = {s for a in self.coefficients for s in a.free_symbols} - self.moving
        return tuple(sorted(symbols, key=str))


class Values:
    """The values of some expressions at random points of one prime field.

    Raises UnsupportedError and DivisionByZeroError (on construction), NoPointError.
    """

    def __init__(self, expressions: Sequence[sp.Expr]) -> None:
        surface = Surface()
        self._nodes = [surface.graph.node(e) for e in expressions]
        self._symbols = tuple(surface.graph.bits)
        self._first = surface.point()

    @property
    def point(self) -> Point:
        """A point of the field."""
        return self._first

    def drawn(self, use: Callable[[list[Any], Point], T], kept: Point | None = None, keep: Collection[sp.Symbol] = ()
              ) -> tuple[T, Point]:  # fmt: skip
        """What `use` says of the values at a new point, where the symbols `keep` are as at the point `kept`."""
        symbols = [s for s in self._symbols if s not in keep]
        start = kept or self._first
        for _ in range(_DRAWS):
            point = start.redrawn(symbols)
            try:
                return use([point.at(n) for n in self._nodes], point), point
            except InadmissibleError:
                continue
        raise NoPointError

    def reduced(self, rows: Sequence[Sequence[Any]]) -> tuple[list[Row], list[int]]:
        """`elimination.row_reduced` over the field."""
        return row_reduced(self._first.arithmetic, rows)

    def number(self, residue: Any) -> sp.Rational | None:
        """The small fraction that a residue stands for, or None."""
        found = reconstructed(residue, self._first.arithmetic.p, LARGEST_FRACTION)
        return None if found is None else sp.Rational(found.numerator, found.denominator)
