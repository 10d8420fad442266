"""Rigid bodies, springs, dampers, varying masses: how they are stated, and their share in d'Alembert's principle."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.symbols import DotProduct, VectorSymbol, prime, t, variation
from lagrange.core.vectors import FIXED, UNITS, Triad, Vector, names_before_last
from lagrange.document.derivation import (
    Block,
    Equation,
    EquationKind,
    Matrices,
    Part,
    Phrase,
    Purpose,
    display,
    listed,
    math,
    paragraph,
    prose,
    series,
)
from lagrange.explain.words import friction_called, load_called, plural, qualified, suffix_of, the
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.constraints.springs_dampers import DamperForce, StretchedSpring
from lagrange.mechanics.constraints.variable_mass import REACTIVE, VariableMass, validities
from lagrange.problem.model import Body, Problem

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.rigid_bodies import Rotation

ZERO = sp.S.Zero
ORDINALS = ("first", "second", "third")


# -- the statement ---------------------------------------------------------------------------------------------------


def triads_of_bodies(problem: Problem, configuration: Configuration) -> list[Block]:
    """The unit vectors that turn with bodies, in i, j, k, each once."""
    lines = directions_of(stated_triads(configuration), problem)
    words = Phrase("The unit vectors that turn with the bodies are", instead="A unit vector that turns with a body is")
    return [prose(words, purpose=Purpose.DEFINITIONS), display(*lines.values())] if lines else []


def stated_triads(configuration: Configuration) -> tuple[Triad, ...]:
    """The triads that the statement uses."""
    positions = (p.position.triad for p in configuration.points)
    ends = (end.triad for link in configuration.links for end in link.ends if isinstance(end, Vector))
    return (*positions, *(r.angular_velocity.triad for r in configuration.rotations), *ends)


def directions_of(triads: Iterable[Triad], problem: Problem) -> dict[str, Equation]:
    """The unit vectors of some triads in i, j, k, by name, except those defined by the file or its frame."""
    known = {*UNITS, *problem.abbreviations}
    lines: dict[str, Equation] = {}
    for triad in dict.fromkeys(triads):
        if triad not in (FIXED, problem.frame):
            lines |= {unit.name: Equation((unit, v)) for unit, v in unit_vectors(triad) if unit.name not in known}
    return lines


def unit_vectors(triad: Triad) -> Iterator[tuple[sp.Symbol, Vector]]:
    """The unit vectors of a triad that turns, each in i, j, k."""
    assert triad.directions is not None
    for n, unit in enumerate(triad.units):
        row = triad.directions[n, :]
        yield unit, Vector((row[0], row[1], row[2]))


def turns_about_axis(bodies: Mapping[str, Body], configuration: Configuration, name: str) -> bool:
    """Whether a body has no mass in the file and turns about a fixed axis: its inertia is that about the axis."""
    body = bodies.get(name)
    place = next((p for p in configuration.points if p.name == name), None)
    return (
        body is not None
        and body.angle is not None
        and place is not None
        and place.mass == 0
        and (configuration.is_pinned(place))
    )


def explain_rotation(body: Body, rotation: Rotation, *, hinged: bool = False) -> list[Block]:
    """Moments of inertia, angular velocity, angular momentum of a body; `hinged`: about a fixed axis."""
    name = body.name
    lines = [
        Equation(
            (VectorSymbol(f"omega_{name}"), rotation.angular_velocity), label=f"spin-{name}", kind=EquationKind.SPIN
        )
    ]
    if rotation.has_inertia:
        lines.append(
            Equation(
                (VectorSymbol(f"H_{name}"), rotation.momentum),
                label=f"momentum-{name}",
                kind=EquationKind.MOMENTUM,
                about=name,
            )
        )
    about = "about it" if hinged else "about the mass centre"
    both = Phrase(plural(len(lines), " is", f" and its angular momentum {about} are"), Purpose.MOMENTA, " is")
    if rotation.inertia.is_principal:
        return [prose(*_inertia(body, rotation, hinged), " Its angular velocity", both), display(*lines)]
    turns = _turns(body)
    units = listed(math(e) for e in rotation.angular_velocity.triad.units)
    tensor = Matrices(((VectorSymbol(f"J_{name}"), rotation.inertia.rows),))
    return [
        prose(*turns, f"{' ' if turns else ''}Its tensor of inertia about the mass centre, along ", *units, ", is"),
        tensor,
        prose("Its angular velocity", both),
        display(*lines),
    ]


def _inertia(body: Body, rotation: Rotation, hinged: bool) -> tuple[Part, ...]:
    if not rotation.has_inertia:
        return _turns(body)
    if body.angle is not None:
        moment = math(body.inertia[0])
        axis = "this axis" if hinged else "the axis of rotation through the mass centre"
        return (
            *_turns(body),
            f" Its moment of inertia about {axis} is ",
            moment,
            ".",
        )
    units = rotation.angular_velocity.triad.units
    moments = listed(math(m) for m in rotation.inertia.moments)
    about = listed(math(e) for e in units)
    turns = _turns(body)
    if rotation.inertia.is_isotropic:
        return (*turns, f"{' ' if turns else ''}Its moment of inertia about every axis through the mass centre is ",
                math(rotation.inertia.moments[0]), ".")  # fmt: skip
    parts = (
        *turns,
        f"{' ' if turns else ''}Its moments of inertia about the axes ",
        *about,
        " through the mass centre are ",
        *moments,
    )
    before = set(names_before_last(body.name))
    if any(e.name in before for e in units) and body.angles[-1] != 0:
        own = listed(math(e) for e in units if e.name in before)
        return (*parts, "; two of them are equal, so ", *own, " need not take part in the last rotation.")
    return (*parts, ".")


def _turns(body: Body) -> tuple[Part, ...]:
    """The angles through which a body is turned; a turn by zero is none."""
    if body.angle is not None:
        return ("It is turned through the angle ", math(body.angle), ".")
    if not body.sequence:
        return ()
    turns = [(axis, angle) for axis, angle in zip(body.sequence, body.angles, strict=True) if angle != 0]
    if not turns:
        return ("It is not turned.",)
    steps: list[Part] = []
    for n, (axis, angle) in enumerate(turns):
        new = "the new " if n else "its "
        steps += [("" if n == 0 else " and then " if n == len(turns) - 1 else ", ") + "by ", math(angle)]
        steps.append(f" about {new}{ORDINALS[int(axis) - 1]} axis")
    return ("It is turned ", *steps, ".")


def moments_on(configuration: Configuration, rough: Collection[str] = ()) -> list[Block]:
    """The applied moment on each body, about its mass centre; `rough`: the names of the friction forces."""
    blocks: list[Block] = []
    for r in configuration.rotations:
        moments = configuration.moments_on(r.name)
        if not moments:
            continue
        beside = configuration.loads_beside(r.name)
        own = any(m.on == r.name for m in configuration.torques)
        if beside:
            verb = plural(len(beside), " acts at", " act at")
            lines = (Equation((VectorSymbol(f"r_{f.name}"), f.point), label=f"point-{f.name}") for f in beside)
            names = (friction_called(f.name, rough) if f.name in rough else load_called(f.name) for f in beside)
            one = len(beside) == len([f for f in configuration.loads if f.on == r.name]) == 1
            blocks += [prose(*(("It",) if one else ("Of these, ", *listed(names))), verb), display(*lines)]
        words = "The moment of the applied forces" if beside else "The applied moment"
        also = ", applied moments included," if beside and own else ""
        moment = Equation(
            (VectorSymbol(f"M_{r.name}"), configuration.moment_on(r.name)),
            label=f"moment-{r.name}",
            kind=EquationKind.MOMENT,
        )
        pinned = any(p.name == r.name and p.mass == 0 and configuration.is_pinned(p) for p in configuration.points)
        about = "" if pinned and not beside else " about its mass centre"
        blocks += [prose(f"{words} on {the(r.name)}{about}{also} is"), display(moment)]
    return blocks


EXTENSION = "Its extension, the distance between its ends,"
"""Of a spring with the natural length zero, as where coordinates are measured from equilibrium."""


def explain_links(configuration: Configuration) -> list[Block]:
    """The springs and dampers, their lengths, and the forces with which they pull."""
    blocks: list[Block] = []
    for s in configuration.springs:
        length = s.length_symbol
        free: tuple[Part, ...] = (" and natural length ", math(s.length)) if s.length != 0 else ()
        if s.length != 0 and s.distance.is_Symbol:  # a coordinate
            blocks += [
                prose(f"The {qualified('spring', s.name)}, of stiffness ", math(s.stiffness), *free, ",", *_joins(s),
                      ". Its length is ", math(s.distance), ", and the force with which it pulls its ends together is"),
                display(Equation((s.pull,), label=f"pull-{s.name}")),
            ]  # fmt: skip
            continue
        blocks += [
            prose(f"The {qualified('spring', s.name)}, of stiffness ", math(s.stiffness), *free, ",", *_joins(s),
                  f". {'Its length' if s.length != 0 else EXTENSION} and the force with which it pulls its ends "
                  "together are"),
            display(Equation((length, s.distance), label=f"length-{s.name}"),
                    Equation((s.stiffness * (length - s.length), s.pull), label=f"pull-{s.name}")),
        ]  # fmt: skip
    for d in configuration.dampers:
        length = d.length_symbol
        either = "" if d.distance.is_Pow else ", up to its sign,"
        blocks += [
            prose(f"The {qualified('damper', d.name)}, of coefficient ", math(d.coefficient), ",", *_joins(d),
                  f". The distance between its ends{either} and the force with which it pulls its ends together are"),
            display(Equation((length, d.distance), label=f"length-{d.name}"),
                    Equation((d.pull_at(prime(length)), d.pull), label=f"pull-{d.name}")),
        ]  # fmt: skip
    return blocks


def explain_exchanged_mass(configuration: Configuration) -> list[Block]:
    """The velocity with which mass leaves or joins a particle, the reactive force, and the range of validity."""
    blocks: list[Block] = []
    for m in configuration.variable_masses:
        called = the(m.name)
        goes, carries = ("leaves", "away from") if m.leaves else ("joins", "to")
        at_rate: tuple[Part, ...] = (f"Mass {goes} {called} at the rate ", math(m.exchanged))
        if m.is_smooth:
            blocks.append(prose(*at_rate, f", with the velocity of {called} itself, and exerts no force on it.",
                                *_while(m, configuration)))  # fmt: skip
            continue
        rule = "the rate of change of its mass times the velocity of that mass relative to it"
        force = next(f.vector for f in configuration.loads if f.on == m.name and f.name == REACTIVE)
        blocks += [
            paragraph(prose(*at_rate, *_velocity(m), "."), prose(
                f"This mass carries momentum {carries} {called}. The momentum of both together changes only by the "
                f"impulse of the other forces. For {called} alone this amounts to a reactive force, {rule} "
                "(Meshchersky):")),
            display(Equation(_reactive(m, force), label=f"reactive-{m.name}")),
        ]  # fmt: skip
        if holds := _while(m, configuration):
            blocks.append(prose(*holds))
    return blocks


def _velocity(m: VariableMass) -> tuple[Part, ...]:
    """The velocity with which mass leaves or joins."""
    if m.velocity.is_zero:
        return (" and is at rest from then on" if m.leaves else "; until then it is at rest",)
    return (", with the velocity ", math(m.velocity), " relative to it" if m.relative else "")


def _reactive(m: VariableMass, force: Vector) -> tuple[sp.Expr | Vector, ...]:
    """Φ = (dm/dt) (u − v), evaluated."""
    phi = VectorSymbol(f"Phi_{m.name}")
    if m.relative:
        return phi, force
    between = m.rate * (m.velocity.as_sum() - VectorSymbol(f"r_{m.name}'"))
    return phi, between, force


def _while(m: VariableMass, configuration: Configuration) -> tuple[Part, ...]:
    """`The equations hold as long as mass joins, k ẋ > 0, and the mass is positive, x > 0.`"""
    clauses: list[tuple[Part, ...]] = []
    if m.has_one_sense:
        clauses.append((f"mass {'leaves' if m.leaves else 'joins'}, ", math(m.exchanged, ZERO, relation=">"), ","))
    for v in validities([m], configuration.slots):
        if v.symbol is None:
            clauses.append(("the mass is positive",))
        elif not (v.symbol == t and v.above and v.bound.is_nonpositive):
            where = math(v.symbol, v.bound, relation=">" if v.above else "<")
            clauses.append(("the mass is positive, ", where))
    if not clauses:
        return ()
    alone = clauses[0][:-1] if len(clauses) == 1 and m.has_one_sense else ()
    parts = alone or series(clauses)
    return (" The equations hold as long as " if m.is_smooth else "The equations hold as long as ", *parts, ".")


def _joins(link: StretchedSpring | DamperForce) -> tuple[Part, ...]:
    first, second = (the(e) if isinstance(e, str) else math(e) for e in _ends(link))
    return (" joins ", first, " and ", second)


def _ends(link: StretchedSpring | DamperForce) -> Iterable[str | Vector | sp.Symbol]:
    for end in link.ends:
        yield sp.Symbol("O") if isinstance(end, Vector) and end.is_zero else end


# -- displacements and the principle ---------------------------------------------------------------------------------


def virtual_rotations(configuration: Configuration, zero: dict[sp.Basic, sp.Basic], label: str = "") -> list[Block]:
    """δπ of each body, without the δq that are zero."""
    if not configuration.rotations:
        return []
    suffix = suffix_of(configuration.name)
    steps = [variation(q).xreplace(zero) for q in configuration.slots.coordinates]
    lines = [
        Equation(
            (VectorSymbol(f"delta(pi_{r.name})"), r.virtual(steps)),
            label=f"rotation{label}{suffix}-{r.name}",
            kind=EquationKind.ROTATION,
        )
        for r in configuration.rotations
        if configuration.rows or not r.angular_velocity.is_zero
    ]
    if not lines:
        return []
    whose = plural(len(lines), "rotation of the body", "rotations of the bodies")
    verb = plural(len(lines), "is", "are")
    like = "formed like the angular velocity, with δ for d/dt"
    return [prose(f"The virtual {whose}, {like}, {verb}"), display(*lines)]


def terms_of_bodies(configuration: Configuration) -> list[sp.Expr]:
    """(dH/dt − M)·δπ of each body."""
    terms = []
    for r in configuration.rotations:
        rate = VectorSymbol(f"H_{r.name}'") if r.has_inertia else ZERO
        moment = VectorSymbol(f"M_{r.name}") if configuration.moments_on(r.name) else ZERO
        if rate - moment != 0:
            terms.append(DotProduct(rate - moment, VectorSymbol(f"delta(pi_{r.name})")))
    return terms


def terms_of_dampers(configuration: Configuration) -> list[sp.Expr]:
    """c d' δd of each damper."""
    return [d.pull_at(prime(d.length_symbol)) * variation(d.length_symbol) for d in configuration.dampers]


def law_times_displacement(configuration: Configuration, insertion: str) -> tuple[Part, ...]:
    """What is multiplied by what: `Newton's law for each particle<insertion> by its virtual displacement`."""
    bodies, particles = configuration.rotations, configuration.particles
    if not bodies:
        one = len(particles) == 1
        whom, whose = ("", "the") if one else (" for each particle", "its")
        return (f"Newton's law{whom}{insertion} by {whose} virtual displacement",)
    whom = "each particle and mass centre" if particles else plural(len(bodies), "the mass centre", "each mass centre")
    of = plural(len(bodies), f"_{bodies[0].name}", "")
    turning: tuple[Part, ...] = ("the law of the angular momentum ", math(VectorSymbol(f"H{of}")))
    turning += () if len(bodies) == 1 else (" for each body",)
    law = "" if any_moving(configuration) else insertion
    rotation = (f"{law} by {plural(len(bodies), 'the', 'its')} virtual rotation ", math(VectorSymbol(f"delta(pi{of})")))
    if not any_moving(configuration):
        return (*turning, *rotation)
    return (f"Newton's law for {whom}{insertion} by its virtual displacement, and ", *turning, *rotation)


def any_moving(configuration: Configuration) -> bool:
    """Whether some particle or mass centre can move."""
    return any(not configuration.is_pinned(p) for p in configuration.points)
