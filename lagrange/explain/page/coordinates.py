"""What generalized coordinates measure, in a sentence: `θ is the angle from j to OP, positive towards i`."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.document.builders import listed, math, prose
from lagrange.document.derivation import Part, Prose
from lagrange.explain.words import constraints_called, in_words, joined, plural, the
from lagrange.mechanics.constraints.measures import Angle, angles, of_mass_centre
from lagrange.mechanics.results import InCoordinates, Solution


def explain_measures(solution: Solution, view: InCoordinates) -> Prose | None:
    """What the coordinates of a choice are that the file has not explained; None where this was not found."""
    known = {q.symbol for q in solution.problem.coordinates if q.meaning or not view.is_own}
    new = [q for q in view.configuration.slots.coordinates if q not in known]
    sentences = [*_centre(of_mass_centre(view.configuration, new)), *_angles(angles(view.configuration, new), solution)]
    parts: list[Part] = []
    for sentence in sentences:
        parts += [" " if parts else "", *sentence]
    return prose(*parts) if parts else None


def explain_independence(solution: Solution, view: InCoordinates) -> Prose | None:
    """How many coordinates of a choice are independent, where this is the question: no motion, no rest is asked for."""
    own, chosen = solution.own, view.configuration.slots.coordinates
    number, size = len(chosen), len(own.configuration.slots.coordinates)
    asked = ((v.dynamics, v.equilibrium, v.at_rest) for v in solution.views)
    derived = any(result is not None for results in asked for result in results)
    if (
        derived
        or solution.impact is not None
        or number != solution.classification.configuration_dimension
        or not view.coordinates.satisfied
    ):
        return None
    names = constraints_called(view.coordinates.satisfied)
    related = f"{names} {plural(len(view.coordinates.satisfied), 'relates', 'relate')} them."
    many, few = (in_words(n, "of").split()[0] for n in (size, number))
    if number == 1:
        return prose(*map(math, chosen), f" can be chosen freely; the {many} coordinates of the file cannot, since ",
                     related)  # fmt: skip
    relation = "finite relation" if view.configuration.rows else "relation"
    return prose(f"These {few} coordinates are independent, with no {relation} between them; the {many} of the file "
                 "are not, since ", related)  # fmt: skip


def _centre(symbols: tuple[sp.Symbol, ...]) -> Iterator[tuple[Part, ...]]:
    if symbols:
        verb = plural(len(symbols), " is the coordinate of", " are the coordinates of")
        yield (*listed(math(q) for q in symbols), f"{verb} the mass centre.")


def _angles(angles: tuple[Angle, ...], solution: Solution) -> Iterator[tuple[Part, ...]]:
    """One sentence for angles of the same kind."""
    rest = list(angles)
    while rest:
        first = rest[0]
        alike = [a for a in rest if (a.zero, a.towards, a.projected) == (first.zero, first.towards, first.projected)]
        rest = [a for a in rest if a not in alike]
        lines = joined(line(a.start, a.end) for a in alike)
        if first.projected is not None:
            lines = f"the projection of {lines}"
        names = listed(math(a.symbol) for a in alike)
        are = plural(len(alike), " is the angle from ", " are the angles from ")
        sense: tuple[Part, ...] = (", positive towards ", math(first.towards)) if first.towards is not None else ()
        yield (*names, are, *_axis(first.zero, solution), " to ", lines, *sense, ".")


def _axis(axis: Vector, solution: Solution) -> tuple[Part, ...]:
    """`the downward vertical` where gravity is along it, `the upward vertical`, or the unit vector."""
    gravity = solution.problem.gravity
    if gravity is not None and gravity.fixed().cross(axis).is_zero:
        down = sum(c * a for c, a in zip(gravity.fixed().components, axis.components, strict=True))
        if down.is_positive or down.is_negative:
            return (f"the {'downward' if down.is_positive else 'upward'} vertical",)
    return (math(axis),)


def is_letter(name: str) -> bool:
    """Whether a name is one letter, with a digit perhaps, so that `OP` and `P1P2` can be read: not so `OAB`."""
    return len(name) == 1 or (len(name) == 2 and name[1].isdigit())


def line(start: str, end: str) -> str:
    """`OP`, `AB`, or `the line from the block to the ball`."""
    first = start or "O"
    if is_letter(first) and is_letter(end):
        return f"{first}{end}"
    return f"the line from {the(start) if start else 'O'} to {the(end)}"
