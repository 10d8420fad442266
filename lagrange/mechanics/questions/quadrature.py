"""The time between two places, t = ∫ dq/q', where q' is a known function of q.

The integral is taken from a table (`algebra.forms.antiderivatives`), by parts of a product and of a power of one sum;
it is verified by differentiation. A motion that begins at rest has a root in the denominator, whose integral has a
limit there. None means not in the table.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient
from lagrange.algebra.closed_forms.solution_sets import shortest_form
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.algebra.forms.antiderivatives import antiderivative
from lagrange.mechanics.questions.limits import LONGEST_INTEGRATED


def time_between(q: sp.Symbol, speed: sp.Expr, start: sp.Expr, end: sp.Expr, way: int) -> sp.Expr | None:
    """The positive time in which q goes from `start` to `end` in the direction `way`; None where it is not found."""
    place = sp.Dummy(q.name, positive=True)
    # |q'| is integrated over the distance already covered, so that its roots are real.
    away = start + way * place
    size = sp.factor((way * speed).xreplace({q: away}))
    if size.count_ops() > LONGEST_INTEGRATED:
        return None
    length = way * (end - start)
    for form in _forms(1 / size):
        found = _integral(form, place)
        if found is None:
            continue
        try:
            values = [factored_quotient(found.xreplace({place: x})) for x in (length, sp.S.Zero)]
            if any(v.has(sp.zoo, sp.nan, sp.oo) for v in values):
                continue
            if is_zero(found.diff(place) - 1 / size) is True:
                return shortest_form(factored_quotient(values[0] - values[1]))
        except DivisionByZeroError:
            continue
    return None


def _forms(e: sp.Expr) -> Iterator[sp.Expr]:
    yield sp.powsimp(e)
    yield sp.expand(e)
    yield sp.powdenest(e, force=False)


def _integral(e: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    share, rest = e.as_independent(x, as_Add=False)
    base, exponent = rest.as_base_exp()
    if base.is_polynomial(x) and sp.degree(base, x) == 1 and exponent.is_Rational and exponent != -1:
        return share * base ** (exponent + 1) / ((exponent + 1) * base.diff(x))
    found = antiderivative(rest, x)
    return None if found is None else share * found
