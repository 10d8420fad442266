"""Reading `let`, `particles` and `bodies`, which may refer to one another.

An abbreviation may use the position r_P of a particle, and a position an abbreviation or another position. Each entry
is read once, after those whose names it uses; entries that are defined by one another are an error.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial

import sympy as sp

from lagrange.algebra.fourier.vector_cleanup import tidied
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.problem.bodies import BodyBeingRead, mass_of, names_of_turning
from lagrange.problem.model import Body, Particle
from lagrange.problem.names import names_in
from lagrange.problem.nodes import Mapping as MappingNode
from lagrange.problem.nodes import Node, Scalar, scalars
from lagrange.problem.reading import Reading
from lagrange.problem.sections import Section, entries_of, mapping_of

_PARTICLE = "P: {mass: m, position: x*i + y*j}"
_BODY = "B: {mass: m, inertia: I_G, position: x*i + y*j, angle: theta}"


@record
class Things:
    """What the file says of masses, in its order."""

    particles: tuple[Particle, ...]
    bodies: tuple[Body, ...]
    abbreviations: Mapping[str, sp.Expr | Vector]


@record
class _Entry:
    """An entry that waits to be read: the names that it gives, and those that it uses."""

    key: Scalar
    gives: tuple[str, ...]
    uses: frozenset[str]
    read: Callable[[], None]


def read_things(root: Section, reading: Reading) -> Things:
    """The abbreviations go into the scope, particles and bodies are returned."""
    particles: dict[str, Particle] = {}
    bodies: dict[str, Body] = {}
    short: dict[str, sp.Expr | Vector] = {}
    entries = [
        *_abbreviations(root, reading, short),
        *_particles(root, reading, particles),
        *_bodies(root, reading, bodies),
    ]
    for entry in _in_order(entries, reading):
        try:
            entry.read()
        except ProblemError as error:
            reading.findings.report_all(error.diagnostics)
            reading.names.fail(*entry.gives)
    known = reading.things.known()
    return Things(
        tuple(particles[n] for n in known if n in particles), tuple(bodies[n] for n in known if n in bodies), short
    )


def _entries(root: Section, key: str, example: str, reading: Reading) -> tuple[tuple[Scalar, Node], ...]:
    node = root.section(key)
    if node is None:
        return ()
    entries = reading.findings.attempt(lambda: entries_of(node, f"`{key}`", f"{key}: {{{example}}}"))
    if entries is None:
        reading.names.fail_all(node)
    return entries or ()


def _abbreviations(root: Section, reading: Reading, found: dict[str, sp.Expr | Vector]) -> Iterator[_Entry]:
    for key, node in _entries(root, "let", 'n: "sin(theta)*i - cos(theta)*j"', reading):
        name = reading.names.declare(key, "an abbreviation")
        if name is not None:
            yield _Entry(key, (name,), _uses(node), partial(_read_abbreviation, name, node, reading, found))


def _read_abbreviation(name: str, node: Node, reading: Reading, found: dict[str, sp.Expr | Vector]) -> None:
    value = reading.value(node, f"`{name}`")
    if isinstance(value, Vector):
        value = value.map(tidied)
        reading.add_vectors({name: value})
    else:
        reading.add_scalars({name: value})
    found[name] = value


def _particles(root: Section, reading: Reading, found: dict[str, Particle]) -> Iterator[_Entry]:
    for key, node in _entries(root, "particles", _PARTICLE, reading):
        name = reading.things.declare(key, "a particle")
        if name is None:
            continue
        reading.points[name] = None
        reading.names.add(f"r_{name}", f"the position of `{name}`", key.span)
        yield _Entry(key, (f"r_{name}",), _uses(node), partial(_read_particle, name, key, node, reading, found))


def _read_particle(name: str, key: Scalar, node: Node, reading: Reading, found: dict[str, Particle]) -> None:
    mapping = mapping_of(node, f"the particle `{name}`", f"{name}: {{mass: m, position: x*i + y*j}}")
    section = Section(mapping, f"the particle `{name}`", ("mass", "position"), reading.findings)
    mass = reading.findings.attempt(lambda: mass_of(section.get("mass"), name, reading))
    position = reading.vector(section.required("position", key.span, "x*i + y*j"), f"the position of `{name}`")
    reading.points[name] = position
    reading.add_vectors({f"r_{name}": position})
    if mass is not None:
        found[name] = Particle(name, mass, position, key.span)


def _bodies(root: Section, reading: Reading, found: dict[str, Body]) -> Iterator[_Entry]:
    for key, node in _entries(root, "bodies", _BODY, reading):
        name = reading.things.declare(key, "a rigid body")
        if name is None:
            continue
        reading.points[name] = None
        reading.bodies.append(name)
        body = BodyBeingRead(name, key, node, reading)
        where, how = _parted(node)
        turning = names_of_turning(name, node)
        for vector, what in {f"r_{name}": f"the position of `{name}`", **turning}.items():
            reading.names.add(vector, what, key.span)
        yield _Entry(key, tuple(turning), how, partial(_read_turning, body, reading, found))
        yield _Entry(key, (f"r_{name}",), where, partial(_read_place, body, reading, found))


def _read_turning(body: BodyBeingRead, reading: Reading, found: dict[str, Body]) -> None:
    reading.add_vectors(body.turning())
    _complete(body, reading, found)


def _read_place(body: BodyBeingRead, reading: Reading, found: dict[str, Body]) -> None:
    position = body.position()
    reading.points[body.name] = position
    reading.add_vectors({f"r_{body.name}": position})
    _complete(body, reading, found)


def _complete(body: BodyBeingRead, reading: Reading, found: dict[str, Body]) -> None:
    """The body, once both of its parts are read."""
    position = reading.points[body.name]
    whole = None if position is None else body.at(position)
    if whole is not None:
        found[body.name] = whole


def _parted(node: Node) -> tuple[frozenset[str], frozenset[str]]:
    """The names that the position of a body uses, and those that the rest of it uses."""
    if not isinstance(node, MappingNode):
        return frozenset(), _uses(node)
    uses = [(key.text == "position", _uses(value)) for key, value in node.entries]
    place, rest = ([names for is_place, names in uses if is_place == wanted] for wanted in (True, False))
    return frozenset().union(*place), frozenset().union(*rest)


def _uses(node: Node) -> frozenset[str]:
    return frozenset(name for scalar in scalars(node) for name in names_in(scalar.text))


# -- order -----------------------------------------------------------------------------------------------------------


def _in_order(entries: list[_Entry], reading: Reading) -> list[_Entry]:
    """Each entry after those whose names it uses; entries that go round in a circle are reported and left out."""
    giver = {name: n for n, entry in enumerate(entries) for name in entry.gives}
    needs = [[giver[name] for name in sorted(entry.uses) if name in giver] for entry in entries]
    order: dict[int, None] = {}
    for start in range(len(entries)):
        path = {start: iter(needs[start])} if start not in order else {}
        while path:
            here = next(reversed(path))
            needed = next((n for n in path[here] if n not in order), None)
            if needed is None:
                order[here] = None
                del path[here]
            elif needed in path:
                around = list(path)
                _report_circle([entries[n] for n in around[around.index(needed) :]], reading)
            else:
                path[needed] = iter(needs[needed])
    return [entries[n] for n in order if not any(reading.names.has_failed(g) for g in entries[n].gives)]


def _report_circle(circle: list[_Entry], reading: Reading) -> None:
    """Reports entries that are defined by one another, at the first of them in the file."""
    ordered = sorted(circle, key=lambda e: e.key.span.start)
    for entry in ordered:
        reading.names.fail(*entry.gives)
    names = [f"`{entry.key.text}`" for entry in ordered]
    message = (
        f"{names[0]} is defined by itself"
        if len(names) == 1
        else f"{', '.join(names[:-1])} and {names[-1]} are defined by one another"
    )
    help_ = "write one of them without the others" if len(names) > 1 else "write it with other names"
    reading.findings.report(Diagnostic("circular-definition", message, ordered[0].key.span, help=help_))
