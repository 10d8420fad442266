"""Shorter names on a printed page, where nothing else could be meant.

With a single particle or body P the index says nothing: m r'' = F + R. With a single constraint the reaction needs none
either: T, N or λ. With several, words that all names share are dropped: T_upper for the tension of the upper rod, if
the other is the lower rod. Programs see the full names, JSON and the labels of equations for screen readers too.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from lagrange.mechanics.dynamics.newton import short_reactions
from lagrange.mechanics.results import Solution

VECTORS = ("r", "v", "F", "R", "omega", "H", "M", "Gamma", "pi", "Phi")
"""Position, velocity, forces, angular velocity and momentum, moments, virtual rotation, reactive force."""


def short_names(solution: Solution, taken: Collection[str]) -> dict[str, str]:
    """The shorter names by the full ones; `taken`: letters that the page uses for something else."""
    used = {*solution.problem.scope.names(), *taken}
    used |= {q.name for c in solution.choices for q in c.configuration.slots.coordinates}
    return {**dict(_of_vectors(solution, used)), **_of_reactions(solution, used)}


def _of_vectors(solution: Solution, used: Collection[str]) -> Iterator[tuple[str, str]]:
    """Of the only particle or body. A scalar of the same letter is not bold: r = r e_r."""
    configuration = solution.own.configuration
    names = {p.name for p in configuration.points} | {r.name for r in configuration.rotations}
    if len(names) != 1 or any(f.elsewhere for f in configuration.loads):
        return
    [name] = names
    scope = solution.problem.scope
    if not any(letter in scope.vectors for letter in VECTORS):
        yield from ((f"{letter}_{name}", letter) for letter in VECTORS)
    for rotation in configuration.rotations:
        for unit in dict.fromkeys((*rotation.angular_velocity.triad.names, *(f"e{n}_{name}" for n in (1, 2, 3)))):
            stem = unit.removesuffix(f"_{name}")
            if stem not in scope.vectors and stem not in used:
                yield unit, stem


def _of_reactions(solution: Solution, used: Collection[str]) -> dict[str, str]:
    if solution.law is None:
        return {}
    return {symbol.name: short for symbol, short in short_reactions(solution.law.newton, used)}
