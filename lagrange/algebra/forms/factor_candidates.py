"""What an integrating factor may be made of: functions that can be read off the coefficients of a form.

Textbook factors are products of powers of coordinates, of sines and cosines of the angles that occur, of the
irreducible factors of the coefficients, of x² + y², and of e^x, e^{x²}, e^{xy}. Each candidate enters log μ with an
unknown exponent:

    μ = Π g_k^{e_k} · exp(Σ c_k L_k).
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import sympy as sp

from lagrange.algebra.forms.one_forms import OneForm
from lagrange.core.expression_size import Measures
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified

MOST = 36
LARGEST_FACTORED = 120
MOST_TERMS = 60
MOST_GENERATORS = 10
FEW_VARIABLES = 4


@record
class Candidate:
    """g, to be raised to a power; or L in exp(L), where `exponential`."""

    function: sp.Expr
    exponential: bool = False

    def power(self, exponent: sp.Expr) -> sp.Expr:
        """g^e, or exp(e L)."""
        return sp.exp(exponent * self.function) if self.exponential else self.function**exponent


def candidates(omega: OneForm) -> list[Candidate]:
    """The candidates for one form, the simplest kinds first, not more than `MOST`."""
    found: dict[tuple[sp.Expr, bool], Candidate] = {}
    for function, exponential in _proposed(omega):
        if _moves(function, omega):
            primitive = function.as_content_primitive()[1]
            if primitive.could_extract_minus_sign():
                primitive = -primitive
            found.setdefault((primitive, exponential), Candidate(primitive, exponential))
        if len(found) >= MOST:
            break
    return list(found.values())


def _moves(e: sp.Expr, omega: OneForm) -> bool:
    return bool(e.free_symbols & omega.moving) or e.has(Unspecified)


def common_factor(omega: OneForm) -> sp.Expr:
    """What all coefficients have in common: x² + y² in (x² + y²)(y dx - x dy). Numbers and parameters do not count."""
    common: dict[sp.Expr, sp.Expr] | None = None
    for a in omega.coefficients:
        if a == 0:
            continue
        powers = factored(a).as_powers_dict()
        known = {g: e for g, e in powers.items() if e.is_Rational and _moves(g, omega)}
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
    for a in sorted(omega.coefficients, key=sp.count_ops):
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
    return sorted(set(expressions), key=lambda e: (sp.count_ops(e), sp.default_sort_key(e)))


def factored(e: sp.Expr) -> sp.Expr:
    """A product of irreducible factors, unless the expression is too large for that."""
    return sp.factor(e) if is_small(e) else e


def is_small(e: sp.Expr) -> bool:
    """Whether cancelling and factoring take little time."""
    if sp.count_ops(e) > LARGEST_FACTORED:
        return False
    roots = (p for p in e.atoms(sp.Pow) if not p.exp.is_Integer)
    if len(e.free_symbols | e.atoms(sp.Function, Unspecified).union(roots)) > MOST_GENERATORS:
        return False
    measure = Measures().of(e)
    return bool(measure.terms <= MOST_TERMS and measure.power <= 12 and measure.denominator <= 12)
