"""On which side of O the parts of a system are drawn, where their relations leave it open and words or loads tell.

What hangs is below, a bowl opens upwards, a wheel is in front of its kerb, and what turns in space is seen well.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.pictures.floats import FloatValues, value
from lagrange.problem.model import AppliedForce, Problem

BOWL = re.compile(r"\bbowl|hemispher|\btrough|\bgroove|\bcup\b", re.IGNORECASE)
_HANGS = re.compile(r"\bhang|\bsuspended|\bpendulum", re.IGNORECASE)
_ON_ROPE = re.compile(
    r"\bhang|\bsuspended|\bhoist|\bwinch|\bwindlass|\bcrane|\blifts\b|\bweights?\b.*\brope", re.IGNORECASE
)
_UPRIGHT = re.compile(r"\binvert|\bupright|\bstand|\babove", re.IGNORECASE)
_KERB = re.compile(r"\b(kerb|curb)s?\b", re.IGNORECASE)


def below(problem: Problem, configuration: Configuration, points: Sequence[Vector]) -> Iterator[sp.Symbol]:
    """The coordinates upwards of what is in a bowl, or hangs, where its relation does not tell above O from below."""
    down, text = problem.gravity, f"{problem.title} {problem.description}"
    if down is None or not (BOWL.search(text) or (_HANGS.search(text) and not _UPRIGHT.search(text))):
        return
    for s in configuration.slots.coordinates:
        even = [f for f in configuration.finite_constraints if sp.sympify(f, strict=True).has(s)]
        upward = any((p.partial(s).dot(down.fixed())).could_extract_minus_sign() for p in points)
        if upward and even and all(sp.expand(f - sp.sympify(f, strict=True).xreplace({s: -s})) == 0 for f in even):
            yield s


def heights_of_hanging(problem: Problem, configuration: Configuration) -> Iterator[sp.Symbol]:
    """The coordinates that count upwards the places of particles that hang, as far as the words tell."""
    down, text = problem.gravity, f"{problem.title} {problem.description}"
    if down is None or not _ON_ROPE.search(text) or _UPRIGHT.search(text):
        return
    places = [(q.symbol, p) for q in problem.coordinates for p in configuration.points if p.mass != 0]
    for s, p in places:
        turning = any(r.name == p.name for r in configuration.rotations)
        way = p.position.partial(s) if s in configuration.slots.coordinates else Vector.zero()
        upward = way.dot(down.fixed())
        others = any(not o.position.partial(s).is_zero for o in configuration.points if o.name != p.name)
        along = not any(c != 0 and d == 0 for c, d in zip(way.components, down.fixed().components, strict=True))
        own = len(p.position.as_sum().free_symbols & {*configuration.slots.coordinates}) == 1
        if not turning and not others and along and own and upward.could_extract_minus_sign() and not way.is_zero:
            yield s


def before_a_kerb(
    problem: Problem, points: Sequence[Vector], values: Mapping[sp.Symbol, float]
) -> Iterator[tuple[sp.Symbol, float]]:
    """A kerb h lower than the centre of its wheel, which is on the side from which it is pulled."""
    if not _KERB.search(f"{problem.title} {problem.description}"):
        return
    radii = [v for s, v in values.items() if s.name in ("r", "R")]
    yield from ((s, 0.45 * min(radii)) for s in values if s.name == "h" and radii)
    for q in (q.symbol for q in problem.coordinates):
        ways = [p.partial(q) for p in points if not p.partial(q).is_zero]
        pulls = [f.vector.fixed() for f in problem.forces if isinstance(f, AppliedForce)]
        sizes = [value(w.dot(f), {**values, **dict.fromkeys(w.dot(f).free_symbols - {*values}, 1.0)})
                 for w in ways for f in pulls if problem.gravity is None and f.components[1] == 0]  # fmt: skip
        if q in values and sum(sizes) > 0:
            yield q, -abs(values[q])


def views(
    configuration: Configuration, points: Sequence[Vector], angles: set[sp.Symbol], parameters: set[sp.Symbol]
) -> Iterator[tuple[sp.Symbol, Callable[[FloatValues], float]]]:
    """Values with which a system in space is seen well.

    What turns by Ω t is seen from the side, and a helix z = b φ has a pitch with which it winds.
    """
    if not any(p.components[2] != 0 for p in points) or all(p.components[1] == 0 for p in points):
        return
    turns = {f.args[0] / t for p in points for c in p.components for f in c.atoms(TrigonometricFunction)}
    for rate in turns & parameters:
        yield t, lambda values, rate=rate: 1.25 / values[rate]  # type: ignore[misc]
    heights = {p.components[2] for p in points}
    relations = [sp.sympify(f, strict=True) for f in configuration.finite_constraints]
    relations = [f for f in relations if any(f.free_symbols & h.free_symbols for h in heights)]
    for term in {term for e in (*heights, *relations) for term in sp.Add.make_args(sp.expand(e))}:
        pitch = term.free_symbols & parameters
        turning = term.free_symbols & angles
        if len(pitch) == len(turning) == 1 and term.free_symbols == pitch | turning and not term.atoms(sp.Function):
            [symbol] = pitch
            yield symbol, lambda values, symbol=symbol: 0.25 * values[symbol]  # type: ignore[misc]
