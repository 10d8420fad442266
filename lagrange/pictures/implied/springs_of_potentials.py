"""Springs that a file gives by their energy alone, k/2 x₁² + k/2 (x₂ − x₁)² + k/2 x₂²: a chain between walls.

A quadratic energy of distances along one line is that of one network of springs: −∂²V/∂x_i∂x_j is the stiffness
between two bodies, and what is left of ∂²V/∂x_i² after these is the stiffness between a body and the wall. If the
energy is least where all distances are 0, these are displacements from rest, and the places of rest are drawn side by
side. If it contains lengths, the distances are those of the bodies as they stand.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from itertools import pairwise

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.constraints.springs_dampers import StretchedSpring
from lagrange.pictures.implied.side_by_side import at_zero, shifted
from lagrange.problem.model import Potential, Problem

_SPRING = re.compile(r"\bspring|\belastic\b|\bbungee|\brubber", re.IGNORECASE)
_BOTH_SIDES = re.compile(r"\bbetween\b|\b(both|either|opposite) (side|end|wall)s?\b|\bwalls\b", re.IGNORECASE)
_FROM_BELOW = re.compile(r"\b(stand|rest|lie|fall|drop|land)\w* on\b|\bfloor|\bground|\bfoundation", re.IGNORECASE)
_HANGS = re.compile(r"\bhang|\bceiling|\bsuspended", re.IGNORECASE)
SPACING = sp.Rational(19, 10)
"""Between places of rest; the lengths of a picture are about 2."""
_SHOWN = (0.5, 0.8, 0.65, 0.75)
"""Displacements that are drawn: less than half of that."""


@record
class Chain:
    """Springs in series.

    coordinates  of the bodies in their order
    between      the stiffness between neighbours
    first, last  stiffness from a wall to the first body, and from the last body to a wall; 0 if there is none
    has_lengths  whether the coordinates are counted from the wall, and not from rest
    """

    coordinates: tuple[sp.Symbol, ...]
    between: tuple[sp.Expr, ...]
    first: sp.Expr
    last: sp.Expr
    has_lengths: bool


@record
class DrawnSprings:
    """Springs, with the configuration whose bodies are moved apart for them.

    shown  the displacements with which it is drawn
    """

    configuration: Configuration
    springs: tuple[StretchedSpring, ...] = ()
    shown: Mapping[sp.Symbol, float] = field(default_factory=dict)


def springs_of_potentials(problem: Problem, configuration: Configuration) -> DrawnSprings:
    """The springs of which the file gives the energy, if it does not draw them itself."""
    text = f"{problem.title} {problem.description}"
    figure, nothing = problem.figure, DrawnSprings(configuration)
    draws = figure.lines or figure.circles or figure.curves or not _SPRING.search(text)
    chain = None if draws else _chain(problem, configuration)
    if chain is None:
        return nothing
    if len(chain.coordinates) == 1 and chain.has_lengths:
        return replace(nothing, springs=_turning_spring(configuration, chain))
    held = [_held(configuration, q) for q in chain.coordinates]
    points = [p for p in held if p is not None]
    ways = [p.position.fixed().partial(q) for p, q in zip(points, chain.coordinates, strict=False)]
    if len(points) < len(held) or any(w != ways[0] or w.dot(w) != 1 for w in ways):
        return nothing
    way = ways[0] * _sense(problem, ways[0], text)
    at_rest = [at_zero(p.position.fixed(), q) for p, q in zip(points, chain.coordinates, strict=True)]
    if len({*at_rest}) not in (1, len(points)) or (chain.has_lengths and (way != ways[0] or chain.last != 0)):
        return nothing
    apart = not chain.has_lengths and len(points) > 1 and len({*at_rest}) == 1
    shifts = [way * (SPACING * n if apart else 0) for n in range(len(points))]
    walls = (
        at_rest[0] - (Vector.zero() if chain.has_lengths else way * SPACING),
        at_rest[-1] + shifts[-1] + way * SPACING,
    )
    moved = {
        p.name: shift
        for q, shift in zip(chain.coordinates, shifts, strict=True)
        for p in configuration.points
        if not p.position.fixed().partial(q).is_zero
    }
    names = [p.name for p in points]
    links: list[tuple[str | Vector, str | Vector, sp.Expr]] = [
        (walls[0], names[0], chain.first),
        *((a, b, k) for (a, b), k in zip(pairwise(names), chain.between, strict=True)),
        (names[-1], walls[1], chain.last),
    ]
    drawn = shifted(configuration, moved)
    springs = tuple(_spring(drawn, n, *link) for n, link in enumerate(links) if link[2] != 0)
    shown = {} if chain.has_lengths else dict(zip(chain.coordinates, _SHOWN * 2, strict=False))
    bound = set().union(*(sp.sympify(f, strict=True).free_symbols for f in configuration.finite_constraints))
    return DrawnSprings(drawn, springs, {q: x for q, x in shown.items() if q not in bound})


def _turning_spring(configuration: Configuration, chain: Chain) -> tuple[StretchedSpring, ...]:
    """A spring from a fixed place, of which the coordinate is the length."""
    [q], coordinates = chain.coordinates, {*configuration.slots.coordinates}
    for p in configuration.points:
        way = p.position.fixed().partial(q)
        start = p.position.fixed().map(lambda c: c.subs(q, 0))
        unit = not way.is_zero and textbook_form(way.dot(way)) == 1 and not way.as_sum().has(q)
        if unit and p.mass != 0 and not start.as_sum().free_symbols & coordinates:
            return (_spring(configuration, 0, start, p.name, chain.first),)
    return ()


def _spring(
    configuration: Configuration, number: int, first: str | Vector, second: str | Vector, stiffness: sp.Expr
) -> StretchedSpring:
    places = {p.name: p.position.fixed() for p in configuration.points}
    a, b = (places[end] if isinstance(end, str) else end for end in (first, second))
    name = f"{number}th spring of a potential"
    return StretchedSpring(name, stiffness, sp.S.Zero, (first, second), a - b, sp.S.Zero)


def _held(configuration: Configuration, q: sp.Symbol) -> MassPoint | None:
    """The only body that a coordinate alone moves."""
    coordinates = {*configuration.slots.coordinates}
    alone = [p for p in configuration.points if p.position.fixed().as_sum().free_symbols & coordinates == {q}]
    massive = [p for p in alone if p.mass != 0] or alone
    return massive[0] if len(massive) == 1 else None


def _sense(problem: Problem, way: Vector, text: str) -> int:
    """1 if the chain goes on in the sense of its coordinates, −1 if in the other: what hangs does so downwards."""
    down = problem.gravity
    falls = way.dot(down.fixed()) if down is not None else -way.components[1]
    upright = [n for n, c in enumerate(way.components) if c != 0]
    if down is None and (upright != [1] or problem.axes.get("j", "up") not in ("up", "down")):
        return 1
    if down is None and problem.axes.get("j") == "down":
        falls = -falls
    if falls == 0 or sp.sympify(falls, strict=True).free_symbols & {q.symbol for q in problem.coordinates}:
        return 1
    downward = -1 if falls.could_extract_minus_sign() else 1
    return -downward if _FROM_BELOW.search(text) and not _HANGS.search(text) else downward


def _chain(problem: Problem, configuration: Configuration) -> Chain | None:
    """The springs whose energy is the given one, if they are in series."""
    coordinates = configuration.slots.coordinates
    energies = [f.energy for f in problem.forces if isinstance(f, Potential)]
    terms = [e for energy in energies for e in sp.Add.make_args(sp.expand(energy)) if e.free_symbols & {*coordinates}]
    used = [q for q in coordinates if any(e.has(q) for e in terms)]
    total = sp.Add(*terms)
    if not used or not total.is_polynomial(*used) or sp.Poly(total, *used).total_degree() != 2:
        return None
    curvature = {(p, q): sp.expand(total.diff(p, q)) for p in used for q in used}
    springs = {(p, q): -curvature[p, q] for p in used for q in used if p != q and curvature[p, q] != 0}
    walls = {q: sp.expand(curvature[q, q] - sp.Add(*(k for (p, _), k in springs.items() if p == q))) for q in used}
    if any(e.could_extract_minus_sign() for k in (*springs.values(), *walls.values()) for e in sp.Add.make_args(k)):
        return None
    bound = {symbol for k in (*springs.values(), *walls.values()) for symbol in k.free_symbols}
    linear = [total.diff(q).xreplace(dict.fromkeys(used, sp.S.Zero)) for q in used]
    has_lengths = any(bound & e.free_symbols for slope in linear for e in sp.Add.make_args(sp.expand(slope)))
    order = _in_series(used, springs, [q for q in used if walls[q] != 0])
    if order is None or bound & {*coordinates}:
        return None
    between = tuple(springs[p, q] for p, q in pairwise(order))
    first, last = walls[order[0]], walls[order[-1]]
    if len(order) == 1:
        first, last = _on_both_sides(first, f"{problem.title} {problem.description}")
    return Chain(order, between, first, last, has_lengths)


def _in_series(
    used: Sequence[sp.Symbol], springs: Mapping[tuple[sp.Symbol, sp.Symbol], sp.Expr], held: Sequence[sp.Symbol]
) -> tuple[sp.Symbol, ...] | None:
    """The coordinates along a chain of springs, of which only the ends may be held; None if it has branches."""
    neighbours = {q: [p for p in used if (p, q) in springs] for q in used}
    ends = [q for q in used if len(neighbours[q]) < 2]
    starts = [q for q in ends if q in held] or ends
    if not starts or any(len(n) > 2 for n in neighbours.values()) or not {*held} <= {*ends}:
        return None
    order = [starts[0]]
    while further := [q for q in neighbours[order[-1]] if q not in order]:
        order.append(further[0])
    return tuple(order) if len(order) == len(used) else None


def _on_both_sides(stiffness: sp.Expr, text: str) -> tuple[sp.Expr, sp.Expr]:
    """The springs before and behind a single body: two, if the text has it between two and the stiffness is a sum."""
    terms = sp.Add.make_args(stiffness)
    if _BOTH_SIDES.search(text) and len(terms) == 2:
        return terms[0], terms[1]
    if _BOTH_SIDES.search(text) and stiffness.as_coeff_Mul()[0] == 2:
        return stiffness / 2, stiffness / 2
    return stiffness, sp.S.Zero
