"""Bodies on the page: several in a plane introduced together, and what is the same about all axes written once.

Where all moments of inertia of a body are equal, H = J ω with one number J, and J is factored out of dH/dt and of the
law of angular momentum.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.inertia import NO_PRODUCTS
from lagrange.core.symbols import VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.document.builders import display, listed, math, prose, series
from lagrange.document.derivation import Block, Display, Equation, Mathematics, Part, Prose, Step
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.limits import FEWEST_TOGETHER
from lagrange.explain.words import capital, introduced, joined, plural
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.factors import vector_with_factor, with_factor


def introduced_together(solution: Solution, body: Sequence[Block]) -> tuple[Block, ...]:
    """The statement with several bodies introduced together, and what acts on any; as it is for fewer."""
    configuration, problem = solution.own.configuration, solution.problem
    several = len(problem.bodies) >= FEWEST_TOGETHER and len(problem.bodies) == len(configuration.rotations)
    plain = all(b.angle is not None or (b.axes and b.products == NO_PRODUCTS) for b in problem.bodies)
    points = [p.name for p in configuration.points]
    introducing = {f"{kind}-{name}" for name in points for kind in ("position", "spin", "momentum")}
    weighed = [
        n for n in points
        if [f.name for f in configuration.loads if f.on == n and not f.elsewhere] == ["weight"]
    ]  # fmt: skip
    moments = [r.name for r in configuration.rotations if not configuration.loads_beside(r.name)]
    shown = {e.label for b in body if isinstance(b, Display) for e in b.equations}
    groups: list[tuple[set[str], Prose]] = [(introducing, _bodies(solution, shown))] if several and plain else []
    groups += [
        ({f"force-{n}" for n in weighed}, prose(plural(len(weighed), "The weight is", "The weights are"))),
        ({f"moment-{n}" for n in moments}, prose("The applied moments are")),
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
    lines.sort(key=lambda e: not (e.label or "").startswith("position"))
    gone = {m for n in places for m in (n - 1, n)}
    before = [b for n, b in enumerate(blocks) if n < places[0] - 1]
    after = [b for n, b in enumerate(blocks) if n > places[0] and n not in gone]
    return [*before, lead, display(*lines), *after]


def _about_centres(solution: Solution, *, some: bool = False) -> str:
    """` about the mass centres`; nothing where a body has no mass, and so no such point; if `some`, where none has."""
    bodies = {b.name for b in solution.problem.bodies}
    massive = [p.mass != 0 for p in solution.own.configuration.points if p.name in bodies]
    return " about the mass centres" if (any(massive) if some else all(massive)) else ""


def _bodies(solution: Solution, labels: Collection[str | None]) -> Prose:
    """What moves, with masses, angles and moments of inertia, and which of `labels` follow."""
    configuration, problem = solution.own.configuration, solution.problem
    bodies = {b.name: b for b in problem.bodies}
    masses = {p.name: p.mass for p in configuration.points}
    axes = {r.name: r.angular_velocity.triad.units for r in configuration.rotations}
    alike: dict[object, tuple[tuple[Part, ...], list[str]]] = {}
    for name, b in bodies.items():
        parts: list[tuple[Part, ...]] = [("turned through ", math(b.angle))] if b.angle is not None else []
        parts += [("of mass ", math(masses[name]))] if masses[name] != 0 else []
        if b.axes and len(set(b.inertia)) > 1:
            moments, about = listed(map(math, b.inertia)), listed(map(math, axes[name]))
            parts.append(("with the moments of inertia ", *moments, " about ", *about))
        elif b.inertia[0] != 0:
            parts.append(("with the moment of inertia ", math(b.inertia[0])))
        given = (b.angle, masses[name], b.inertia, b.axes)
        alike.setdefault(given, (series(parts, ", "), []))[1].append(introduced(name))
    clauses: list[tuple[Part, ...]] = [
        (joined(names), " (", *(("each ",) if len(names) > 1 else ()), *parts, ")") for parts, names in alike.values()
    ]
    particles: list[tuple[Part, ...]] = [
        (introduced(p.name), *((" (of mass ", math(p.mass), ")") if p.mass != sp.S.Zero else ()))
        for p in configuration.particles
    ]
    beside: tuple[Part, ...] = (capital(plural(len(particles), "the particle is ", "the particles are ")),
                                *series(particles), ". ") if particles else ()  # fmt: skip
    last = ", and " if any(len(names) > 1 for _, names in alike.values()) else " and "
    centres = "mass centres" if _about_centres(solution) else "bodies"
    placed = f"positions of the {'particles and ' if particles else ''}{centres}"
    kinds = {(label or "").partition("-")[0] for label in labels}
    also = [placed] * ("position" in kinds) + ["angular velocities"]
    momenta = [f"angular momenta{_about_centres(solution)}"] * ("momentum" in kinds)
    what = Phrase(joined([*also, *momenta]), Purpose.MOMENTA, joined(also))
    return prose(*beside, "The bodies are rigid: ", *series(clauses, last), ". The ", what, " are")


def alike_about_all_axes(solution: Solution, step: Step) -> Step:
    """A step with H = J ω and J factored out where a body has one moment of inertia J about all axes."""
    moments = {
        r.name: r.inertia.moments[0]
        for r in solution.own.configuration.rotations
        if r.has_inertia and r.inertia.is_isotropic
    }
    if not moments:
        return step
    blocks = (
        replace(b, equations=tuple(_with_one_moment(e, moments) for e in b.equations)) if isinstance(b, Display) else b
        for b in step.body
    )
    return replace(step, body=tuple(blocks))


def _with_one_moment(e: Equation, moments: Mapping[str, sp.Expr]) -> Equation:
    label = e.label or ""
    for name, moment in moments.items():
        if label == f"momentum-{name}":
            return replace(e, sides=(e.sides[0], moment * VectorSymbol(f"omega_{name}")))
        if label.startswith("momentum-rate") and label.endswith(f"-{name}"):
            return replace(e, sides=(e.sides[0], *(_divided(s, moment) for s in e.sides[1:])))
        if label.startswith(f"turning-{name}-") and isinstance(e.sides[0], sp.Expr):
            return replace(e, sides=(with_factor(e.sides[0], moment), *e.sides[1:]))
    return e


def _divided(side: Mathematics, moment: sp.Expr) -> Mathematics:
    return vector_with_factor(side, moment) if isinstance(side, Vector) else side
