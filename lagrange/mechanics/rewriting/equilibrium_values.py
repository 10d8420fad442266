"""Linear equations about an equilibrium with the coordinate itself where its value is a root: r³ = K/(3n²).

With K = 3n² r³ put in, 3ξ₁'' − 2·3^(2/3) K^(1/3) n^(1/3) ξ₂' − 27n² ξ₁ = 0 becomes ξ₁'' − 2n r ξ₂' − 9n² ξ₁ = 0.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.rewriting.factors import without_constant_factors

if TYPE_CHECKING:  # a page without oscillations loads neither
    from lagrange.algebra.closed_forms.solution_sets import Branch
    from lagrange.mechanics.equilibrium.linearization import SmallOscillations


def by_coordinates(view: InCoordinates) -> InCoordinates | None:
    """The view with shorter linear equations, where the value of a coordinate is an odd root; None of any other."""
    linearization = view.linearization
    if linearization is None:
        return None
    at = tuple(
        s if s is None else _shorter(s, b) for b, s in zip(linearization.branches, linearization.at, strict=True)
    )
    return None if at == linearization.at else replace(view, linearization=replace(linearization, at=at))


def _shorter(s: SmallOscillations, branch: Branch) -> SmallOscillations:
    forms = [s.equations, *_in_coordinates(s.equations, branch)]
    best = min(forms, key=lambda equations: sum(map(count_operations, equations)))
    return s if best is s.equations else replace(s, equations=best)


def _in_coordinates(equations: tuple[sp.Expr, ...], branch: Branch) -> Iterator[tuple[sp.Expr, ...]]:
    """The equations with one parameter put in from qⁿ = value, n odd and the value positive; compared with the old."""
    for relation in branch.equations:
        q, n = relation.lhs.as_base_exp()
        if not (q.is_Symbol and n.is_Integer and n > 1 and n % 2 and relation.rhs.is_positive):
            continue
        root = relation.rhs ** (1 / n)
        place = sp.Dummy(q.name, positive=True)
        for p in sorted((x for x in relation.rhs.free_symbols if x.is_positive), key=str):
            number, exponent = (relation.rhs / p, 1) if not (relation.rhs / p).has(p) else (relation.rhs * p, -1)
            if number.has(p):
                continue
            value = (place**n / number) ** exponent
            put = [sp.expand(sp.powdenest(e.xreplace({p: value}))) for e in equations]
            moving = {x for e in equations for x in e.free_symbols if not x.is_positive}
            short = tuple(without_constant_factors(_divided(e), moving) for e in put)
            if all(_is_multiple(a.xreplace({place: root}), b) for a, b in zip(short, equations, strict=True)):
                yield tuple(e.xreplace({place: q}) for e in short)


def _divided(e: sp.Expr) -> sp.Expr:
    """Without the positive constants and numbers that all its terms share."""
    terms = sp.Add.make_args(e)
    shared = sp.gcd_terms(e) if len(terms) > 1 else e
    return sp.expand(sp.Mul(*(f for f in sp.Mul.make_args(shared) if not f.is_positive)))


def _is_multiple(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether the first is a positive constant times the second."""
    terms = [sp.Add.make_args(sp.expand(sp.powdenest(sp.expand(e)))) for e in (a, b)]
    if len(terms[0]) != len(terms[1]):
        return False
    ratios = set()
    for one in terms[0]:
        found = [sp.powsimp(one / other) for other in terms[1]]
        ratios.add(next((r for r in found if r.is_positive and all(x.is_positive for x in r.free_symbols)), None))
    return len(ratios) == 1 and None not in ratios
