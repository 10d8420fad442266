"""The system as a page introduces it: symbols in a sentence, positions and forces together."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from lagrange.core.operations import count_operations
from lagrange.core.vectors import Vector
from lagrange.document.builders import display, listed, math, paired, paragraph, prose, series
from lagrange.document.derivation import Block, Equation, Part, Prose, Step, Table
from lagrange.explain.limits import MOST_SYMBOLS, SHORT_SIDE
from lagrange.explain.page.bodies import introduced_together
from lagrange.explain.page.coordinates import explain_measures, is_letter
from lagrange.explain.page.texts import set_text
from lagrange.explain.words import capital, introduced, joined, plural, spoken, the
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Assumption


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
    return prose(*clauses), int(stated)


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
    forces = any((e.label or "").startswith("force") for e in lines)
    also = (" and weight" if len(points) == 1 else " and weights") if weights else " and applied force"
    opening, closing = (", of mass ", ",") if len(points) < 3 else (" (of mass ", ")")
    masses = ((introduced(p.name), *((opening, math(p.mass), closing) if p.mass != 0 else ())) for p in points)
    loaded = [p.name for p in points if any(e.label == f"force-{p.name}" for e in lines)]
    end: tuple[Part, ...] = ()
    if forces and len(loaded) < len(points):
        force = plural(len(loaded), "weight", "weights") if weights else plural(len(loaded), "force", "forces")
        comma = "" if points[-1].mass != 0 and len(points) < 3 else ","
        end, forces = (f"{comma} and the {force} on {joined(map(the, loaded))}",), False
    what = plural(len(points), "The position", "The positions") + (also if forces else "")
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
