"""Branches that the program finds, at numbers, to be compared with brute force."""

from __future__ import annotations

from random import Random

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet

POSITIVE = {
    n: sp.Symbol(n, positive=True)
    for n in ["a", "b", "c", "d", "f", "g", "h", "k", "l", "m", "n", "p", "r", "w", "W", "M"]
}
ALPHA = {n: sp.Symbol(n, positive=True) for n in ("alpha", "beta")}


def values_of(expressions: list[sp.Expr], unknowns: list[sp.Symbol], random: Random) -> dict[sp.Symbol, sp.Rational]:
    symbols = sorted({s for e in expressions for s in e.free_symbols} - {*unknowns}, key=str)
    found = {s: sp.Rational(random.randint(20, 300), 100) for s in symbols}
    return found | {s: sp.Rational(random.randint(20, 130), 100) for s in symbols if s.name in ALPHA}


def coordinates(found: SolutionSet, b: Branch, unknowns: list[sp.Symbol], values: dict[sp.Symbol, sp.Rational]):
    """The unknowns at the real points of a branch: (cos, sin) of an angle, the number of another."""
    for point in b.points:
        numbers = []
        for u in unknowns:
            of_u = (sp.cos(u), sp.sin(u)) if found.letters.angle_of(u) else (u,)
            numbers += [found.at(point, e).xreplace(values).evalf(30) for e in of_u]
        if all(n.is_number and abs(sp.im(n)) < 1e-20 for n in numbers):
            yield [mpmath.mpf(str(sp.re(n))) for n in numbers]


def is_met(b: Branch, values: dict[sp.Symbol, sp.Rational]) -> bool:
    """Whether the conditions of a branch hold."""
    relations = {"≥": lambda a: a >= 0, "≤": lambda a: a <= 0, ">": lambda a: a > 0, "≠": lambda a: a != 0}
    differences = ((c.relation, (c.lhs - c.rhs).xreplace(values).evalf(30)) for c in b.conditions)
    return all(d.is_real and relations[r](d) for r, d in differences)


def apart(points: list[list[mpmath.mpf]]) -> list[list[mpmath.mpf]]:
    kept: list[list[mpmath.mpf]] = []
    for p in points:
        if not any(near(p, q) for q in kept):
            kept.append(p)
    return kept


def near(p: list[mpmath.mpf], q: list[mpmath.mpf]) -> bool:
    return all(abs(a - b) < 1e-5 * (1 + abs(a)) for a, b in zip(p, q, strict=True))


def predicted(found: SolutionSet, unknowns: list[sp.Symbol], values: dict[sp.Symbol, sp.Rational]) -> list:
    """The real points of all branches; a branch has some exactly where its conditions hold."""
    points = []
    for b in found.branches:
        if b.special:
            continue
        there = list(coordinates(found, b, unknowns, values))
        assert bool(there) == is_met(b, values), (b.relations, b.conditions, values)
        points += there
    return apart(points)
