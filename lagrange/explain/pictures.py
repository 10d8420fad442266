"""What is said of pictures: their captions, and what they show in words for those who do not see them."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.document.derivation import Part, listed, math
from lagrange.explain.words import spoken
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.solution import Solution

CAPTION_OF_SYSTEM: tuple[Part, ...] = ("The system in a general position.",)
"""Below the picture of the system."""


def caption_of_choice(symbols: Sequence[Part]) -> tuple[Part, ...]:
    """Below the picture of the system in other coordinates."""
    return (
        ("The system with the coordinates ", *listed(symbols), ".")
        if len(symbols) > 1
        else (
            "The system with the coordinate ",
            *symbols,
            ".",
        )
    )


def caption_of_free_bodies(newton: Newton) -> tuple[Part, ...]:
    """Below the free-body diagrams."""
    bodies = newton.bodies or ()
    what = "The free body" if len(bodies) == 1 else "The free bodies"
    if not any(b.bound for b in bodies):
        return (f"{what}.",)
    if len([r for b in bodies for r in b.bound]) == 1:
        return (f"{what}; the unknown force is drawn as it acts where it is positive.",)
    return (f"{what}; unknown forces are drawn as they act where they are positive.",)


def system_in_words(solution: Solution) -> str:
    """`Drawing of the system: P1, P2; upper rod, lower rod.`"""
    things = [p.name for p in solution.problem.masses]
    links = [s.name for s in solution.configuration.links]
    constraints = [c.name for c in solution.problem.constraints]
    everything = "; ".join(", ".join(map(spoken, group)) for group in (things, links, constraints) if group)
    return f"Drawing of the system: {everything}."


def free_bodies_in_words(newton: Newton) -> str:
    """`Free-body diagrams. P1: weight, upper rod.`"""
    said = []
    for b in newton.bodies or ():
        acting = [*(spoken(n) if n else "field" for n in b.loads), *(f"reaction of {spoken(r.name)}" for r in b.bound)]
        said.append(f"{spoken(b.name)}: {', '.join(acting)}." if acting else f"{spoken(b.name)}.")
    return " ".join(["Free-body diagrams.", *said])


def symbols_of(coordinates: Sequence[sp.Symbol]) -> tuple[Part, ...]:
    """Coordinates as parts of a sentence."""
    return tuple(math(q) for q in coordinates)
