"""Cleaning up after vector products: sin² + cos² = 1, and differences of coordinates.

A file says `cross(omega, r)` or `dot(r', n)`; the components come out with sin²φ sin θ + cos²φ sin θ, or with sin θ
sin(θ + φ) + cos θ cos(θ + φ), which no one would write by hand. An expression with such products is brought to textbook
form, which is kept where it is shorter; any other stays as the file has it. So does a product of many rotations: the
wheel of a bicycle is turned through five angles, which are hundreds of waves, and no shorter for it.

A function of x₂ − x₁ alone does not change when both grow alike, ∂e/∂x₁ + ∂e/∂x₂ = 0; then e is e(0, x₂ − x₁).
cos w/sin w is written cot w, where it is to be read and not computed with. Only short expressions are treated:
multiplied out, (x + y + z)^20 has 231 terms, and a file can write much longer ones.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations
from math import prod

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero, vanishes
from lagrange.algebra.fourier.limits import (
    FEW_ANGLES,
    HIGHEST_MULTIPLE,
    LARGEST_CLEANED,
    LARGEST_COUNT,
    MOST_CLEANED_TERMS,
    MOST_CLEANED_WAVES,
)
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import Sizes, count_operations
from lagrange.core.symbols import partial


def is_short(expression: sp.Expr) -> bool:
    """Whether multiplying out and factoring take little time."""
    measure = Sizes().of(expression)
    return measure.size <= LARGEST_CLEANED and measure.widest <= MOST_CLEANED_TERMS and not is_many_waves(expression)


def is_many_waves(expression: sp.Expr) -> bool:
    """Whether an expression in several angles may be more waves, as a Fourier sum, than anybody would read."""
    angles = {s for f in expression.atoms(sp.sin, sp.cos) for s in f.free_symbols}
    return len(angles) > FEW_ANGLES and _waves(expression, {}) > MOST_CLEANED_WAVES


def cleaned_up(expression: sp.Expr) -> sp.Expr:
    """The textbook form; an expression of many waves as it is, or 0 if it is zero."""
    if not is_many_waves(expression):
        return textbook_form(expression)
    return sp.S.Zero if vanishes(expression) else expression


def _waves(e: sp.Expr, known: dict[sp.Expr, float]) -> float:
    """An upper bound on the number of waves e^{iw} in an expression; each distinct part is counted once."""
    if e not in known:
        parts = [_waves(a, known) for a in e.args] if e.is_Add or e.is_Mul else []
        if isinstance(e, sp.sin | sp.cos):
            count = 2.0
        elif e.is_Pow and e.exp.is_Integer and e.exp.is_positive:
            count = _waves(e.base, known) ** min(int(e.exp), HIGHEST_MULTIPLE)
        else:
            count = sum(parts) if e.is_Add else prod(parts)
        known[e] = min(count, LARGEST_COUNT)
    return known[e]


def tidied(expression: sp.Expr) -> sp.Expr:
    """The expression, shorter where sin² + cos² = 1 or cos(a − b) = cos a cos b + sin a sin b makes it so."""
    if not is_short(expression) or _degree(expression, sp.sin) < 2 or _degree(expression, sp.cos) < 2:
        return expression
    form = textbook_form(expression)
    return form if count_operations(form) < count_operations(expression) else expression


def _degree(expression: sp.Expr, function: type[sp.Function]) -> int:
    """How many sines, or cosines, are multiplied in one term, at most."""
    if isinstance(expression, function):
        return 1
    if expression.is_Add:
        return max(_degree(term, function) for term in expression.args)
    if expression.is_Mul:
        return sum(_degree(f, function) for f in expression.args)
    if expression.is_Pow and expression.exp.is_Integer and expression.exp > 0:
        return int(expression.exp) * _degree(expression.base, function)
    return 0


def ordered_differences(product: sp.Expr) -> sp.Expr:
    """−a (r − R) as a (R − r): differences of two symbols with the letter first that is first in the alphabet."""
    factors = list(sp.Mul.make_args(product))
    for n, f in enumerate(factors):
        base, exponent = f.as_base_exp()
        terms = sp.Add.make_args(base)
        if len(terms) != 2 or exponent not in (1, -1) or not all((t if t.is_Symbol else -t).is_Symbol for t in terms):
            continue
        plus = [t for t in terms if t.is_Symbol]
        minus = [-t for t in terms if not t.is_Symbol]
        if len(plus) == 1 and str(minus[0]) < str(plus[0]):
            factors[n] = (minus[0] - plus[0]) ** exponent
            factors.append(sp.S.NegativeOne)
    return sp.Mul(*factors)


def in_differences(expression: sp.Expr, coordinates: Iterable[sp.Symbol]) -> sp.Expr:
    """x₁² − 2x₁ x₂ + x₂² as (x₂ − x₁)², factored, where that is shorter. Rational functions of the coordinates only."""
    if not is_short(expression):
        return expression
    used = [q for q in coordinates if q in expression.free_symbols]
    if not expression.is_rational_function(*used):
        return expression
    rest, differences = expression, {}
    for a, b in combinations(used, 2):
        if {a, b} <= rest.free_symbols and is_zero(partial(rest, a) + partial(rest, b)):
            difference = sp.Dummy(real=True)
            rest = rest.xreplace({a: sp.S.Zero, b: difference})
            differences[difference] = b - a
    result = sp.factor(rest).xreplace(differences) if differences else expression
    return result if count_operations(result) < count_operations(expression) else expression


def with_cotangents(expression: sp.Expr) -> sp.Expr:
    """cos w/sin w written as cot w, in every product."""
    if not expression.args or not expression.has(sp.sin):
        return expression
    arguments = [with_cotangents(a) for a in expression.args]
    rebuilt = expression if arguments == list(expression.args) else expression.func(*arguments)
    if not rebuilt.is_Mul:
        return rebuilt
    powers = dict(f.as_base_exp() for f in rebuilt.args)
    for sine, below in list(powers.items()):
        if isinstance(sine, sp.sin) and below.is_Integer and below < 0:
            cosine = sp.cos(sine.args[0])
            above = powers.get(cosine, sp.S.Zero)
            if above.is_Integer and above > 0:
                common = min(above, -below)
                powers |= {sine: below + common, cosine: above - common, sp.cot(sine.args[0]): common}
    return sp.Mul(*(b**e for b, e in powers.items()))
