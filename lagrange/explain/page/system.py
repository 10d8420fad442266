"""The system as a page introduces it: symbols in a sentence, positions and forces together.

What generalized coordinates measure, in a sentence: `θ is the angle from j to OP, positive towards i`.

Bodies on the page: several in a plane introduced together, and what is the same about all axes written once.

Where all moments of inertia of a body are equal, H = J ω with one number J, and J is factored out of dH/dt and of the
law of angular momentum.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.inertia import NO_PRODUCTS
from lagrange.core.symbols import VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Display,
    Equation,
    EquationKind,
    Mathematics,
    Part,
    Phrase,
    Prose,
    Purpose,
    Step,
    Table,
    display,
    listed,
    math,
    paired,
    paragraph,
    prose,
    series,
)
from lagrange.explain.limits import FEWEST_TOGETHER, MOST_SYMBOLS, SHORT_SIDE
from lagrange.explain.page.texts import set_text
from lagrange.explain.statement import ranges_of
from lagrange.explain.words import capital, constraints_called, in_words, introduced, joined, plural, spoken, the
from lagrange.mechanics.constraints.coordinates import Angle, angles, of_mass_centre
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.mechanics.rewriting.factors import vector_with_factor, with_factor
from lagrange.problem.keys import Assumption


def explain_system(solution: Solution, step: Step) -> Step:
    """The statement with its symbols in a sentence, and with positions and forces in one display."""
    body = step.body
    n = next((n for n, b in enumerate(body) if isinstance(b, Table)), None)
    if n is not None and len(body[n].rows) <= MOST_SYMBOLS:  # type: ignore[union-attr]
        sentence, covered = _symbols(solution)
        rest = body[n + 1 + covered :]
        before = list(body[:n])
        if len(before) > 1 and isinstance(before[-1], Prose) and isinstance(before[-2], Prose):
            before[-2:] = [paragraph(before[-2], before[-1], sentence)]
        else:
            before.append(sentence)
        body = (*before, *rest)
    body = introduced_together(solution, body)
    measures = explain_measures(solution, solution.own)
    return replace(step, body=(*_together(solution, body), *([measures] if measures is not None else ())))


def _symbols(solution: Solution) -> tuple[Prose, int]:
    """`Coordinates: x (distance to the right of O). Parameters, all positive: ...`, and how many paragraphs that is."""
    problem = solution.problem
    clauses: list[Part] = []
    for kind, members in (("coordinate", problem.coordinates), ("parameter", problem.parameters)):
        if not any(m.meaning or m.unit for m in members):
            continue
        named = ((math(m.symbol), *((" (", *set_text(m.meaning, problem), ")") if m.meaning else ())) for m in members)
        parameters = [m for m in problem.parameters if m.range is None]
        positive = kind == "parameter" and all(p.assume is Assumption.POSITIVE for p in parameters)
        some = f", {'both' if len(members) == 2 else 'all'} positive" if len(members) > 1 else ", positive"
        clauses += [" " if clauses else "", f"{plural(len(members), kind, kind + 's').capitalize()}: "]
        clauses += [*series(named, ", "), some if positive and parameters == [*members] else "", "."]
    free = [p for p in problem.parameters if p.range is None]
    plain = bool(free) and len(free) == len(problem.parameters) and all(p.assume is Assumption.POSITIVE for p in free)
    stated = plain and (len(free) > 1) and any(m.meaning or m.unit for m in problem.parameters)
    ranges = ranges_of(problem) if stated else []  # otherwise they stand beside the signs
    limits = [f" {plural((len(ranges) + 1) // 2, 'Range', 'Ranges')}: ", *ranges, "."] if ranges else []
    return prose(*clauses, *limits), int(stated)


def _together(solution: Solution, body: tuple[Block, ...]) -> tuple[Block, ...]:
    """Positions and applied forces of particles in one display."""
    configuration = solution.own.configuration
    points = configuration.points
    if configuration.rotations or not points or any(f.elsewhere for f in configuration.loads):
        return body
    labels = {f"position-{p.name}" for p in points} | {f"force-{p.name}" for p in points}
    lines = [e for b in body for e in getattr(b, "equations", ()) if e.label in labels]
    at = [n for n, b in enumerate(body) if any(e.label in labels for e in getattr(b, "equations", ()))]
    if not at or at != list(range(at[0], at[-1] + 1, 2)):  # each display has its sentence before it
        return body
    weights = all(f.name == "weight" for f in configuration.loads) and bool(configuration.loads)
    forces = any(e.kind is EquationKind.FORCE for e in lines)
    also = (" and weight" if len(points) == 1 else " and weights") if weights else " and applied force"
    opening, closing = (", of mass ", ",") if len(points) < 3 else (" (of mass ", ")")
    masses = ((introduced(p.name), *((opening, math(p.mass), closing) if p.mass != 0 else ())) for p in points)
    loaded = [p.name for p in points if any(e.label == f"force-{p.name}" for e in lines)]
    end: tuple[Part, ...] = ()
    if forces and len(loaded) < len(points):
        force = plural(len(loaded), "weight", "weights") if weights else plural(len(loaded), "force", "forces")
        comma = "" if points[-1].mass != 0 and len(points) < 3 else ","
        end, forces = (f"{comma} and the {force} on {joined(map(the, loaded))}",), False
    noun = "The displacement" if _are_displacements(solution) else "The position"
    what = plural(len(points), noun, f"{noun}s") + (also if forces else "")
    verb = " are" if forces or end or len(points) > 1 else " is"
    lead = prose(what, " of ", *series(masses), *end, verb)
    if not end and all(p.mass != 0 and "mass" not in the(p.name) for p in points):
        lead = prose(*_with_masses(points), f"; {plural(len(points), 'its', 'their')} {what[4:]}", verb)
    shown = paired(lines) if len(points) == 1 and are_short(lines) else lines
    return (*body[: at[0] - 1], lead, display(*shown), *body[at[-1] + 1 :])


def _with_masses(points: Sequence[MassPoint]) -> Iterator[Part]:
    """`The particle P has the mass m`; `The particles A and B have the masses m_1 and m_2`, or `the mass m each`."""
    names = [introduced(p.name) for p in points]
    bare = all(name == spoken(p.name) and is_letter(p.name) for name, p in zip(names, points, strict=True))
    called = f"the {plural(len(points), 'particle', 'particles')} {joined(names)}" if bare else joined(names)
    masses = list(dict.fromkeys(p.mass for p in points))
    yield capital(called)
    if len(masses) == 1:
        yield plural(len(points), " has the mass ", " each have the mass ")
        yield math(masses[0])
    else:
        yield " have the masses "
        yield from listed(math(p.mass) for p in points)


def are_short(equations: Sequence[Equation]) -> bool:
    """Whether two of them have room in a line."""
    components = (s.as_sum() if isinstance(s, Vector) else s for e in equations for s in e.sides)
    return all(count_operations(c) <= SHORT_SIDE for c in components)


# Coordinates


def explain_measures(solution: Solution, view: InCoordinates) -> Prose | None:
    """What the coordinates of a choice are that the file has not explained; None if this was not found."""
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
        return prose(*map(math, chosen), f" can be chosen freely; the {many} coordinates above cannot, since ",
                     related)  # fmt: skip
    relation = "finite relation" if view.configuration.rows else "relation"
    return prose(f"These {few} coordinates are independent, with no {relation} between them; the {many} above "
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


# Bodies


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
    shown = {e.kind for b in body if isinstance(b, Display) for e in b.equations}
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
    every: list[Equation] = [e for n in places for e in blocks[n].equations]  # type: ignore[union-attr]
    lines = [e for e in every if not _is_no_spin(e)] or every
    lines.sort(key=lambda e: e.kind is not EquationKind.POSITION)
    gone = {m for n in places for m in (n - 1, n)}
    before = [b for n, b in enumerate(blocks) if n < places[0] - 1]
    after = [b for n, b in enumerate(blocks) if n > places[0] and n not in gone]
    return [*before, lead, display(*lines), *after]


def _is_no_spin(e: Equation) -> bool:
    """Whether it says that a body does not turn, which its angle 0 says already."""
    value = e.sides[-1]
    return e.kind is EquationKind.SPIN and isinstance(value, Vector) and value.is_zero


def _about_centres(solution: Solution, *, some: bool = False) -> str:
    """` about the mass centres`; nothing if a body has no mass, and so no such point; if `some`, where none has."""
    bodies = {b.name for b in solution.problem.bodies}
    massive = [p.mass != 0 for p in solution.own.configuration.points if p.name in bodies]
    return " about the mass centres" if (any(massive) if some else all(massive)) else ""


def _bodies(solution: Solution, kinds: Collection[EquationKind | None]) -> Prose:
    """What moves, with masses, angles and moments of inertia, and which `kinds` of equations follow."""
    configuration, problem = solution.own.configuration, solution.problem
    bodies = {b.name: b for b in problem.bodies}
    masses = {p.name: p.mass for p in configuration.points}
    axes = {r.name: r.angular_velocity.triad.units for r in configuration.rotations}
    alike: dict[object, tuple[tuple[Part, ...], list[str]]] = {}
    for name, b in bodies.items():
        turned: tuple[Part, ...] = ("not turned",) if b.angle == 0 else ("turned through ", math(b.angle or sp.S.Zero))
        parts: list[tuple[Part, ...]] = [turned] if b.angle is not None else []
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
    also = [placed] * (EquationKind.POSITION in kinds) + ["angular velocities"]
    momenta = [f"angular momenta{_about_centres(solution)}"] * (EquationKind.MOMENTUM in kinds)
    what = Phrase(joined([*also, *momenta]), Purpose.MOMENTA, joined(also))
    return prose(*beside, "The bodies are rigid: ", *series(clauses, last), ". The ", what, " are")


def _are_displacements(solution: Solution) -> bool:
    """Whether each point is counted from a place of its own: by a coordinate that is a displacement."""
    meanings: Mapping[sp.Basic, str] = {q.symbol: q.meaning for q in solution.problem.coordinates}
    places = [{s for c in p.position.components for s in c.free_symbols} for p in solution.own.configuration.points]
    return all(len(used) == 1 and all(meanings.get(s, "").startswith("displacement") for s in used) for used in places)


def alike_about_all_axes(solution: Solution, step: Step) -> Step:
    """A step with H = J ω and J factored out where a body has one moment of inertia J about all axes."""
    moments = {
        r.name: r.inertia.moments[0]
        for r in solution.own.configuration.rotations
        if r.has_inertia and r.inertia.is_isotropic
    }
    if not moments:
        return step
    return step.map(lambda e: _with_one_moment(e, moments))


def _with_one_moment(e: Equation, moments: Mapping[str, sp.Expr]) -> Equation:
    moment = moments.get(e.about)
    if moment is None:
        return e
    first, *others = e.sides
    if e.kind is EquationKind.MOMENTUM:
        return replace(e, sides=(first, moment * VectorSymbol(f"omega_{e.about}")))
    if e.kind is EquationKind.MOMENTUM_RATE:
        return replace(e, sides=(first, *(_divided(s, moment) for s in others)))
    if e.kind is EquationKind.TURNING and isinstance(first, sp.Expr):
        return replace(e, sides=(with_factor(first, moment), *others))
    return e


def _divided(side: Mathematics, moment: sp.Expr) -> Mathematics:
    return vector_with_factor(side, moment) if isinstance(side, Vector) else side
