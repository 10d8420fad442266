"""Several bodies in a plane, introduced together: positions, angles, moments of inertia; then weights; then moments."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.document.builders import display, math, prose, series
from lagrange.document.derivation import Block, Display, Equation, Part, Prose
from lagrange.explain.words import capital, joined, plural, the
from lagrange.mechanics.results import Solution

FEWEST = 2
"""The fewest bodies that are introduced together."""


def introduced_together(solution: Solution, body: Sequence[Block]) -> tuple[Block, ...]:
    """The statement with particles and planar bodies introduced together; as it is for fewer, or bodies in space."""
    configuration, problem = solution.own.configuration, solution.problem
    planar = all(b.angle is not None for b in problem.bodies)
    if len(problem.bodies) < FEWEST or not planar or len(problem.bodies) != len(configuration.rotations):
        return tuple(body)
    points = [p.name for p in configuration.points]
    introducing = {f"{kind}-{name}" for name in points for kind in ("position", "spin", "momentum")}
    weighed = [
        n for n in points
        if [f.name for f in configuration.loads if f.on == n and not f.elsewhere] == ["weight"]
    ]  # fmt: skip
    moments = [r.name for r in configuration.rotations if not configuration.loads_beside(r.name)]
    groups: list[tuple[set[str], Prose]] = [
        (introducing, _bodies(solution)),
        ({f"force-{n}" for n in weighed}, prose(plural(len(weighed), "The weight is", "The weights are"))),
        ({f"moment-{n}" for n in moments}, prose("The applied moments about the mass centres are")),
    ]
    blocks = list(body)
    for labels, lead in groups:
        blocks = _gathered(blocks, labels, lead)
    return tuple(blocks)


def _gathered(blocks: Sequence[Block], labels: set[str], lead: Prose) -> list[Block]:
    """The displays with these labels as one, under one sentence, in the place of the first."""
    places = [n for n, b in enumerate(blocks) if isinstance(b, Display) and {e.label for e in b.equations} <= labels]
    if len(places) < 2 or any(n == 0 or not isinstance(blocks[n - 1], Prose) for n in places):
        return list(blocks)
    lines: list[Equation] = [e for n in places for e in blocks[n].equations]  # type: ignore[union-attr]
    gone = {m for n in places for m in (n - 1, n)}
    before = [b for n, b in enumerate(blocks) if n < places[0] - 1]
    after = [b for n, b in enumerate(blocks) if n > places[0] and n not in gone]
    return [*before, lead, display(*lines), *after]


def _bodies(solution: Solution) -> Prose:
    """What moves, with masses, angles and moments of inertia."""
    configuration, problem = solution.own.configuration, solution.problem
    bodies = {b.name: b for b in problem.bodies}
    masses = {p.name: p.mass for p in configuration.points}
    clauses: list[tuple[Part, ...]] = []
    for name, b in bodies.items():
        parts: list[tuple[Part, ...]] = [("turned through ", math(b.angle))] if b.angle is not None else []
        parts += [("of mass ", math(masses[name]))] if masses[name] != 0 else []
        if b.inertia[0] != 0:
            parts.append(("with the moment of inertia ", math(b.inertia[0])))
        clauses.append((f"{the(name)} (", *series(parts, ", "), ")"))
    particles: list[tuple[Part, ...]] = [
        (the(p.name), *((" (of mass ", math(p.mass), ")") if p.mass != sp.S.Zero else ()))
        for p in configuration.particles
    ]
    beside: tuple[Part, ...] = (capital(plural(len(particles), "the particle is ", "the particles are ")),
                                *series(particles), ". ") if particles else ()  # fmt: skip
    also = ["positions of the mass centres", "angular velocities", "angular momenta about the mass centres"]
    if particles:
        also[0] = "positions of the particles and mass centres"
    return prose(*beside, "The bodies are rigid: ", *series(clauses), f". The {joined(also)} are")
