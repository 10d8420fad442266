"""T, V and the generalized forces, and what is told with them in every set of coordinates."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Dot, VectorSymbol, variation
from lagrange.core.vectors import Vector
from lagrange.document.derivation import Block, Equation, Part, Rule, Step, display, listed, math, paragraph, prose
from lagrange.explain.displacements import points_called
from lagrange.explain.motion import suffix_of
from lagrange.explain.newton import explain_friction, nature
from lagrange.explain.words import plural, spoken
from lagrange.mechanics.constraints.kinematics import Row
from lagrange.mechanics.dynamics.energies import Energies, is_weight
from lagrange.mechanics.dynamics.friction import Rubbing
from lagrange.mechanics.dynamics.motion import Law
from lagrange.mechanics.dynamics.multipliers import LagrangeMotion
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.energy_symbols import Letters
from lagrange.problem.model import Friction, Problem

ZERO = sp.S.Zero


@record
class Told:
    """What all parts of the explanation in one set of coordinates need.

    rubbed  the friction forces
    finite  names of constraints on velocities that come to finite relations
    """

    motion: LagrangeMotion
    letters: Letters
    law: Law
    problem: Problem
    rubbed: Sequence[Rubbing] = ()
    finite: frozenset[str] = frozenset()

    @property
    def found(self) -> Energies:
        """T, V and what follows."""
        return self.motion.principle

    @property
    def choice(self) -> str:
        """The name of the choice of coordinates; empty for the file's own."""
        return self.found.configuration.name

    @property
    def suffix(self) -> str:
        """What labels end in."""
        return suffix_of(self.found.configuration)

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """q."""
        return self.found.configuration.slots.coordinates

    @property
    def velocities(self) -> tuple[sp.Symbol, ...]:
        """q'."""
        return self.found.configuration.slots.velocities

    @property
    def rows(self) -> list[Row]:
        """The constraints that have multipliers."""
        return [self.found.configuration.rows[n] for n in self.motion.used]

    @property
    def function(self) -> sp.Symbol:
        """What is differentiated: L where there is a potential energy, T otherwise."""
        return self.letters.kinetic if self.found.potential == 0 else self.letters.lagrangian

    def reaction(self, row: Row) -> Reaction:
        """What keeps a constraint."""
        return next(r for r in self.law.newton.reactions if r.name == row.name)

    def title(self, words: str) -> str:
        """The title of a step."""
        return f"{words}: {spoken(self.choice)}" if self.choice else words


def explain_energies(told: Told) -> Step:
    """v² and ω, T, V, and the generalized forces of what has no potential energy."""
    body = [*_velocities(told), *_kinetic(told), *_potential(told), *_forces(told)]
    energies = "Kinetic and potential energy" if told.found.potential != 0 else "Kinetic energy"
    also = any(q != 0 for q in told.found.applied)
    return Step(Rule.ENERGIES, told.title(f"{energies}, generalized forces" if also else energies), tuple(body))


def _velocities(told: Told) -> list[Block]:
    """The velocities that are more than x' i + y' j, and all their squares; in a choice ω too."""
    found: list[Block] = []
    velocities, squares = told.found.velocities, told.found.squares
    whose = points_called(told.found.configuration)
    lines = [
        Equation((VectorSymbol(f"r_{name}'"), v), label=f"velocity{told.suffix}-{name}")
        for name, v in velocities.items()
        if not _is_evident(v)
    ]
    if lines:
        what = plural(len(lines), f"The velocity of the {whose} is", f"The velocities of the {whose} are")
        if len(lines) < len(velocities):
            names = listed(n for n, v in velocities.items() if not _is_evident(v))
            what = plural(len(lines), "The velocity of ", "The velocities of ")
            what += "".join(map(str, names)) + plural(len(lines), " is", " are")
        found += [prose(what), display(*lines)]
    if squares:
        one = "and its square is" if lines else f"The square of the velocity of the {whose} is"
        more = "and the squares are" if lines else f"The squares of the velocities of the {whose} are"
        one, more = ("The square of the velocity is", "The squares of the velocities are") if lines else (one, more)
        lines = [
            Equation((told.letters.speed(name) ** 2, square), label=f"square{told.suffix}-{name}")
            for name, square in squares.items()
        ]
        found += [prose(plural(len(lines), one, more)), display(*lines)]
    turning = [r for r in told.found.configuration.rotations if r.has_inertia]
    if told.choice and turning:
        spins = (
            Equation((VectorSymbol(f"omega_{r.name}"), r.angular_velocity), label=f"spin{told.suffix}-{r.name}")
            for r in turning
        )
        word = plural(len(turning), "The angular velocity is", "The angular velocities are")
        found += [prose(word), display(*spins)]
    return found


def _is_evident(velocity: Vector) -> bool:
    """Whether it is x' i + y' j."""
    return all(c == 0 or c.is_Symbol for c in velocity.components)


def _kinetic(told: Told) -> list[Block]:
    """T, by what it is the sum of."""
    found, letters = told.found, told.letters
    terms = [p.mass * letters.speed(p.name) ** 2 / 2 for p in found.configuration.points if p.name in found.squares]
    turning = [r for r in found.configuration.rotations if r.has_inertia]
    spins = [Dot(VectorSymbol(f"omega_{r.name}"), VectorSymbol(f"H_{r.name}")) / 2 for r in turning]
    parts = (
        " of the mass centres and of the rotations about them"
        if len(turning) > 1
        else (" of the mass centre and of the rotation about it")
    )
    what = f"The kinetic energy,{parts}, is" if terms and spins else "The kinetic energy is"
    if not terms and not spins:
        return [prose("Nothing has mass, and the kinetic energy is 0.")]
    line = Equation((letters.kinetic, sp.Add(*terms, *spins), found.kinetic), label=f"kinetic{told.suffix}")
    return [prose(what), display(line)]


def _potential(told: Told) -> list[Block]:
    """V, and of what."""
    if told.found.potential == 0:
        return []
    configuration = told.found.configuration
    weights = sum(is_weight(f, configuration) for f in configuration.loads)
    springs = configuration.springs
    fields = configuration.potential - sp.Add(*(s.energy for s in springs)) != 0
    whats = [plural(weights, "the weight", "the weights")] * bool(weights)
    whats += [plural(len(springs), "the spring", "the springs")] * bool(springs)
    whats += ["the given field"] * fields
    of = "".join(str(p) for p in listed(whats))
    return [
        prose(f"The potential energy of {of} is"),
        display(Equation((told.letters.potential, told.found.potential), label=f"potential{told.suffix}")),
    ]


def _forces(told: Told) -> list[Block]:
    """δW of what is not in V, and the Q_k that follow."""
    found, letters = told.found, told.letters
    acting = _acting(told)
    other = "other " if found.potential != 0 else ""
    if not acting:
        return [] if told.choice else [prose(f"No {other}force is applied: the generalized forces are 0.")]
    names = listed(acting)
    if all(q == 0 for q in found.applied):
        verb = plural(len(acting), "does", "do")
        return [prose(*_capital(names), f" {verb} no virtual work: the generalized forces are 0.")]
    work = sp.Add(*(q * variation(x) for q, x in zip(found.applied, told.coordinates, strict=True)))
    lines = [
        Equation((letters.force(x), q), label=f"generalized{told.suffix}-{x.name}")
        for q, x in zip(found.applied, told.coordinates, strict=True)
        if q != 0
    ]
    idle = [letters.force(x) for q, x in zip(found.applied, told.coordinates, strict=True) if q == 0]
    words: tuple[Part, ...] = (*_capital(names), plural(len(acting), " does", " do"), " the virtual work")
    if other:
        words = ("Not in ", math(letters.potential), plural(len(acting), " is ", " are "), *names,
                 plural(len(acting), ", which does", ", which do"), " the virtual work")  # fmt: skip
    rest: list[Block] = [prose(*listed(math(s) for s in idle), plural(len(idle), " is 0.", " are 0."))] if idle else []
    so = plural(len(lines), "so that the generalized force is", "so that the generalized forces are")
    return [prose(*words), display(Equation((work,), label=f"work{told.suffix}")), prose(so), display(*lines), *rest]


def explain_friction_first(told: Told) -> Step:
    """Which reaction the friction needs, before T and V."""
    natures = [s for r in told.rows for s in nature(told.reaction(r))]
    needed = plural(len(told.rubbed), "The friction needs its reaction", "The frictions need their reactions")
    body = [*([paragraph(*natures)] if natures else []), *explain_friction(told.rubbed)]
    body.append(prose(f"{needed}, found by Lagrange's equations with multipliers, which follow below."))
    return Step(
        Rule.REACTIONS, plural(len(told.rows), "The reaction and friction", "Reactions and friction"), tuple(body)
    )


def _acting(told: Told) -> list[str]:
    """What is applied and not in V."""
    configuration = told.found.configuration
    rubbing = {f.name for f in told.problem.forces if isinstance(f, Friction)}
    names = []
    for load in configuration.loads:
        if not is_weight(load, configuration):
            kind = "the friction" if load.name in rubbing else "the force"
            names.append(f"{kind} {spoken(load.name)}" if load.name != "weight" else "the weight")
    names += [f"the moment {spoken(m.name)}" for m in configuration.torques]
    names += [
        "the damper" if spoken(d.name) == "damper" else f"the damper {spoken(d.name)}" for d in configuration.dampers
    ]
    return list(dict.fromkeys(names))


def _capital(parts: Sequence[Part]) -> tuple[Part, ...]:
    first, *rest = parts
    return (f"{str(first)[0].upper()}{str(first)[1:]}", *rest)
