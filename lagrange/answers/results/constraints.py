"""A wrong equation for a constraint: which one change makes it right.

Sine and cosine of an angle exchanged, the sign of a term, two coordinates exchanged, a factor 2. Each change is made in
the equation as it was read, and tested as the equation itself was.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.answers.limits import MOST_CHANGES
from lagrange.core.symbols import base, differential, prime, variation
from lagrange.document.math_writer import text


def explained_constraint(
    components: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol], holds: Callable[[sp.Expr], bool]
) -> str:
    """What is wrong with an equation, in a sentence; empty if no change makes it right."""
    if len(components) != 1:
        return ""
    (e,) = components
    for n, (sentence, changed) in enumerate(_changes(e, coordinates)):
        if n >= MOST_CHANGES:
            break
        try:
            if changed != 0 and holds(changed):
                return sentence
        except DivisionByZeroError:
            continue
    return ""


def _changes(e: sp.Expr, coordinates: Sequence[sp.Symbol]) -> Iterator[tuple[str, sp.Expr]]:
    terms = sp.Add.make_args(sp.expand(e))
    if len(terms) > 1:
        for term in terms:
            yield f"one change makes it right: the sign of the term {text(term)}", e - 2 * term
    angles = sorted({w.args[0] for w in e.atoms(sp.sin, sp.cos, sp.tan)}, key=str)
    for a in angles:
        rule = {sp.sin(a): sp.cos(a), sp.cos(a): sp.sin(a), sp.tan(a): sp.cot(a)}
        exchanged = e.xreplace(rule)
        yield f"it would be right with sine and cosine of {text(a)} exchanged", exchanged
        for term in sp.Add.make_args(sp.expand(exchanged))[1:]:
            yield (
                f"it would be right with sine and cosine of {text(a)} exchanged, and one sign changed",
                exchanged - 2 * term,
            )
    used = [q for q in coordinates if any(base(s) == q or s in (differential(q), variation(q)) for s in e.free_symbols)]
    for a, b in combinations(used, 2):
        rule = {kind(x): kind(y) for x, y in ((a, b), (b, a)) for kind in (base, prime, differential, variation)}
        yield f"it would be right with {text(a)} and {text(b)} exchanged", e.xreplace(rule)
    for term in terms if len(terms) > 1 else ():
        yield f"one change makes it right: {text(2 * term)} in place of {text(term)}", e + term
        yield f"one change makes it right: {text(term / 2)} in place of {text(term)}", e - term / 2
