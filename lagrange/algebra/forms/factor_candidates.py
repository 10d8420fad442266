"""Candidates for the factors of an integrating factor, read off the coefficients of a form; values of the form.

Textbook factors are products of powers of coordinates, of sines and cosines of the angles that occur, of the
irreducible factors of the coefficients, of x² + y², and of e^x, e^{x²}, e^{xy}. Each candidate enters log μ with an
unknown exponent, μ = Π g_k^{e_k} · exp(Σ c_k L_k). A factor μ makes ω = Σ a_i dq_i exact when d(μω) = 0, that is, with
θ = d(log μ),

    θ ∧ ω = −dω,      θ_i a_j − θ_j a_i = −(∂_i a_j − ∂_j a_i).

Where ω ∧ dω = 0, the pairs (p, j) with one fixed p for which a_p ≠ 0 imply the others. The condition on log μ is
therefore linear, with n − 1 equations at each point. All points lie in one prime field, so that their rows can be
reduced together; a variable can be kept while the others are drawn again.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from functools import cached_property
from itertools import combinations
from typing import Any, TypeVar

import sympy as sp

from lagrange.algebra.exact.limits import DRAWS
from lagrange.algebra.exact.linear_algebra import NumberRow, row_reduced
from lagrange.algebra.exact.zero_test import InadmissibleError, NoPointError, Point, Surface, reconstructed
from lagrange.algebra.forms.exact_forms import differentiated
from lagrange.algebra.forms.limits import (
    FEW_VARIABLES,
    LARGEST_EXPONENT,
    LARGEST_FACTORED,
    MOST_FACTOR_CANDIDATES,
    MOST_FACTORED_TERMS,
    MOST_GENERATORS,
)
from lagrange.core.expression_size import Sizes, count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, Unspecified, base, t

T = TypeVar("T")


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
        """All symbols but parameters: the variables, and prescribed motions with their rates."""
        symbols = {s for a in self.coefficients for s in a.free_symbols}
        return {*self.variables, t, *(s for s in symbols if base(s) in self.slots.prescribed)}

    @cached_property
    def parameters(self) -> tuple[sp.Symbol, ...]:
        """The symbols that do not move."""
        symbols = {s for a in self.coefficients for s in a.free_symbols} - self.moving
        return tuple(sorted(symbols, key=str))


class SampledValues:
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
        """The result of `use` for values at a new point that agrees with `kept` in the symbols `keep`."""
        symbols = [s for s in self._symbols if s not in keep]
        start = kept or self._first
        for _ in range(DRAWS):
            point = start.redrawn(symbols)
            try:
                return use([point.at(n) for n in self._nodes], point), point
            except InadmissibleError:
                continue
        raise NoPointError

    def reduced(self, rows: Sequence[Sequence[Any]]) -> tuple[list[NumberRow], list[int]]:
        """`linear_algebra.row_reduced` over the field."""
        return row_reduced(self._first.arithmetic, rows)

    def number(self, residue: Any) -> sp.Rational | None:
        """The small fraction with this residue, or None."""
        fraction = reconstructed(residue, self._first.arithmetic.p, LARGEST_EXPONENT)
        return None if fraction is None else sp.Rational(fraction.numerator, fraction.denominator)


@record
class FactorCandidate:
    """g, to be raised to a power; or L in exp(L), where `in_exponent`."""

    function: sp.Expr
    in_exponent: bool = False

    def power(self, exponent: sp.Expr) -> sp.Expr:
        """g^e, or exp(e L)."""
        return sp.exp(exponent * self.function) if self.in_exponent else self.function**exponent


def factor_candidates(omega: OneForm) -> list[FactorCandidate]:
    """The candidates for one form, the simplest kinds first, not more than `MOST_FACTOR_CANDIDATES`."""
    candidates: dict[tuple[sp.Expr, bool], FactorCandidate] = {}
    for function, in_exponent in _proposed(omega):
        if _varies(function, omega):
            primitive = function.as_content_primitive()[1]
            if primitive.could_extract_minus_sign():
                primitive = -primitive
            candidates.setdefault((primitive, in_exponent), FactorCandidate(primitive, in_exponent))
        if len(candidates) >= MOST_FACTOR_CANDIDATES:
            break
    return list(candidates.values())


def _varies(e: sp.Expr, omega: OneForm) -> bool:
    return bool(e.free_symbols & omega.moving) or e.has(Unspecified)


def common_divisor(omega: OneForm) -> sp.Expr:
    """The factor common to all coefficients: x² + y² in (x² + y²)(y dx - x dy). Numbers and parameters do not count."""
    common: dict[sp.Expr, sp.Expr] | None = None
    for a in omega.coefficients:
        if a == 0:
            continue
        powers = factored(a).as_powers_dict()
        known = {g: e for g, e in powers.items() if e.is_Rational and _varies(g, omega)}
        common = known if common is None else {g: min(e, known[g]) for g, e in common.items() if g in known}
    return sp.Mul(*(g**e for g, e in (common or {}).items()))


def _proposed(omega: OneForm) -> Iterator[tuple[sp.Expr, bool]]:
    variables = omega.variables
    occurring = [v for v in variables if any(v in a.free_symbols for a in omega.coefficients)]
    for v in occurring:
        yield v, False
    for v in variables:
        yield v, True
    yield from ((f, False) for f in _factors(omega))
    yield from _arguments(omega)
    for p, q in combinations(occurring[:FEW_VARIABLES], 2):
        yield p**2 + q**2, False
    for v in variables[:FEW_VARIABLES]:
        yield v**2, True
    for p, q in combinations(variables[:FEW_VARIABLES], 2):
        yield p * q, True


def _factors(omega: OneForm) -> Iterator[sp.Expr]:
    """The irreducible factors of numerators and denominators, prescribed motions and undefined functions."""
    for a in sorted(omega.coefficients, key=count_operations):
        for f in sp.Mul.make_args(factored(a)):
            yield f.as_base_exp()[0] if not isinstance(f, sp.exp) else sp.S.One
    symbols = {s for a in omega.coefficients for s in a.free_symbols}
    yield from sorted(symbols & omega.moving - {*omega.variables}, key=str)
    yield from _sorted(f for a in omega.coefficients for f in a.atoms(Unspecified))


def _arguments(omega: OneForm) -> Iterator[tuple[sp.Expr, bool]]:
    """Sines and cosines of the angles, exponents of e, bases of roots, logarithms."""
    functions = _sorted(f for a in omega.coefficients for f in a.atoms(sp.Function, sp.exp, sp.Pow))
    for f in functions:
        match f:
            case sp.sin() | sp.cos() | sp.tan() | sp.cot() | sp.sec() | sp.csc():
                yield sp.cos(f.args[0]), False
                yield sp.sin(f.args[0]), False
            case sp.sinh() | sp.cosh() | sp.tanh():
                yield sp.cosh(f.args[0]), False
                yield sp.sinh(f.args[0]), False
            case sp.exp():
                for term in sp.Add.make_args(f.args[0]):
                    yield term, True
            case sp.log():
                yield f, False
            case sp.Pow() if not f.exp.is_Integer:
                yield f.base, False


def _sorted(expressions: Iterator[sp.Expr]) -> list[sp.Expr]:
    return sorted(set(expressions), key=lambda e: (count_operations(e), sp.default_sort_key(e)))


def factored(e: sp.Expr) -> sp.Expr:
    """A product of irreducible factors, unless the expression is too large for that."""
    return sp.factor(e) if is_quick_to_factor(e) else e


def is_quick_to_factor(e: sp.Expr) -> bool:
    """Whether cancelling and factoring take little time."""
    if count_operations(e) > LARGEST_FACTORED:
        return False
    roots = (p for p in e.atoms(sp.Pow) if not p.exp.is_Integer)
    if len(e.free_symbols | e.atoms(sp.Function, Unspecified).union(roots)) > MOST_GENERATORS:
        return False
    measure = Sizes().of(e)
    return bool(measure.terms <= MOST_FACTORED_TERMS and measure.power <= 12 and measure.denominator <= 12)
