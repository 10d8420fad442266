"""Coordinates that are distances: r of polar, cylindrical and spherical coordinates.

In x = r cos φ, y = r sin φ nothing says that r is positive: (−r, φ + π) is the same place as (r, φ). The distance from
the origin is |r|, and Newton's attraction G/(r |r|). Books take r > 0, which leaves no place out, and write G/r². So an
answer that is right where r > 0 is right, and it is said where.

A coordinate is a radius where every place with r < 0 has another name with r > 0: the positions stay what they are when
r changes its sign and some angles become φ + π, or π − θ. Bodies must not be turned by that.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, product

import sympy as sp

from lagrange.algebra.exact.exact import is_zero
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import System

MOST_ANGLES = 6
"""Coordinates beside a radius, of which one or two are turned."""


def radii(system: System) -> tuple[sp.Symbol, ...]:
    """The radii whose sign the equations of a system depend on."""
    signed = {s for e in system.equations for part in _magnitudes(e) for s in part.free_symbols}
    coordinates = system.configuration.slots.coordinates
    return tuple(q for q in coordinates if q in signed and _is_radius(q, system.configuration))


def where_positive(e: sp.Expr, positive: Sequence[sp.Symbol]) -> sp.Expr:
    """What an expression is where some coordinates are positive: |r| and √(r² cos² φ + r² sin² φ) are r there."""
    there = {q: sp.Symbol(q.name, positive=True) for q in positive}
    e = e.xreplace(there)
    roots = [p for p in _magnitudes(e) if not p.free_symbols.isdisjoint(there.values())]
    e = e.xreplace({p: textbook_form(p) for p in roots if not isinstance(p, sp.sign)})
    return e.xreplace({symbol: q for q, symbol in there.items()})


def _magnitudes(e: sp.Expr) -> Iterator[sp.Expr]:
    """What depends on a sign: magnitudes, and square roots."""
    yield from e.atoms(sp.Abs, sp.sign)
    yield from (p for p in e.atoms(sp.Pow) if p.exp.is_Rational and not p.exp.is_Integer)


def _is_radius(r: sp.Symbol, configuration: Configuration) -> bool:
    """Whether every place with r < 0 is one with r > 0 too."""
    others = [q for q in configuration.slots.coordinates if q != r]
    places = [c for p in configuration.points for c in p.position.fixed().components]
    if len(others) > MOST_ANGLES or not any(r in c.free_symbols for c in places):
        return False
    coordinates = configuration.slots.coordinates
    turning = {
        q for b in configuration.rotations for q, w in zip(coordinates, b.partials, strict=True) if not w.is_zero
    }
    angles = [q for q in others if q not in turning and any(_is_turned_by(c, q) for c in places)]
    return r not in turning and any(_stay(places, {r: -r, **turned}) for turned in _turns(angles))


def _is_turned_by(e: sp.Expr, q: sp.Symbol) -> bool:
    return any(q in w.free_symbols for w in e.atoms(sp.sin, sp.cos))


def _turns(angles: Sequence[sp.Symbol]) -> Iterator[dict[sp.Symbol, sp.Expr]]:
    """φ + π or π − θ, of one angle or two."""
    for number in (1, 2):
        for chosen in combinations(angles, number):
            for signs in product((1, -1), repeat=number):
                yield {q: sp.pi + sign * q for q, sign in zip(chosen, signs, strict=True)}


def _stay(places: Sequence[sp.Expr], rule: Mapping[sp.Symbol, sp.Expr]) -> bool:
    given = dict(rule)
    return all(is_zero(c.xreplace(given) - c) is True for c in places)
