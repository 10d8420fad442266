"""A random system: its problem file, and the same system as potential, masses and constraints in numbers.

The numbers come from the texts of positions and energies, read by `evaluate` and differentiated by `taylor`; nothing of `lagrange` is used.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from tests.support.nets.evaluate import difference, evaluate, python_name
from tests.support.nets.taylor import Taylor, variables

Array = Any
AXES = "ijk"


@dataclass
class System:
    """What a problem file says, kept as texts.

    coordinates  in their order; `angles` are those that count modulo 2π, `box` is half the width searched for the others
    parameters   positive symbols, apart from those in `real`
    particles    name: (mass, components of the position); mass "0" for a massless point
    bodies       name: (mass, inertia about k, components of the position of the mass centre, angle)
    named        the constraints whose reaction has a name: {constraint: name}
    keepers      what keeps a constraint, where the file says it: {constraint: word of `by`}
    anchors      of constraints that keep a distance: the particle, and where the other end is
    constraints  name: equation between coordinates
    values       what the file gives as the value of a parameter, a number with its unit
    forms        name: {coordinate: coefficient}, a kinematic constraint
    terms        of V: weights, springs, constant forces, potentials
    turns_as_a_whole  whether all coordinates together count modulo 2π
    choices      of generalized coordinates: the same system in them, and the substitution
    """

    family: str
    coordinates: list[str]
    angles: set[str] = field(default_factory=set)
    box: float = 4.0
    parameters: list[str] = field(default_factory=list)
    real: set[str] = field(default_factory=set)
    particles: dict[str, tuple[str, tuple[str, ...]]] = field(default_factory=dict)
    bodies: dict[str, tuple[str, str, tuple[str, ...], str]] = field(default_factory=dict)
    constraints: dict[str, str] = field(default_factory=dict)
    named: dict[str, str] = field(default_factory=dict)
    keepers: dict[str, str] = field(default_factory=dict)
    anchors: dict[str, tuple[str, tuple[str, ...]]] = field(default_factory=dict)
    values: dict[str, str] = field(default_factory=dict)
    dampers: list[tuple[str, tuple[str, ...], tuple[str, ...]]] = field(default_factory=list)
    forms: dict[str, dict[str, str]] = field(default_factory=dict)
    gravity: str = ""
    forces: list[str] = field(default_factory=list)
    terms: list[str] = field(default_factory=list)
    find: str = "[equilibrium]"
    turns_as_a_whole: bool = False
    choices: dict[str, tuple[System, dict[str, str]]] = field(default_factory=dict)

    # What a system consists of

    def particle(self, name: str, mass: str, *components: str) -> None:
        self.particles[name] = (mass, components)

    def weigh(self, g: str, axis: int = 1) -> None:
        """Gravity g against an axis, for all particles there are."""
        self.gravity = f"-({g})*{AXES[axis]}"
        for mass, r in [*self.particles.values(), *((m, r) for m, _, r, _ in self.bodies.values())]:
            if mass != "0":
                self.terms.append(f"({mass})*({g})*({r[axis]})")

    def push(self, on: str, *components: str) -> None:
        vector = " + ".join(f"({c})*{AXES[n]}" for n, c in enumerate(components) if c != "0")
        self.forces.append(f"F{len(self.forces)}: {{on: {on}, vector: '{vector}'}}")
        self.terms += [f"-({c})*({x})" for c, x in zip(components, self.particles[on][1], strict=False) if c != "0"]

    def push_at(self, on: str, at: Sequence[str], *components: str) -> None:
        """A constant force at a point of a body."""
        vector, point = (" + ".join(f"({c})*{AXES[n]}" for n, c in enumerate(v) if c != "0") for v in (components, at))
        self.forces.append(f"F{len(self.forces)}: {{on: {on}, vector: '{vector}', at: '{point}'}}")
        self.terms += [f"-({c})*({x})" for c, x in zip(components, at, strict=False) if c != "0"]

    def damper(self, strength: str, a: Sequence[str], b: str) -> None:
        """Between a place and a particle."""
        start = " + ".join(f"({c})*{AXES[n]}" for n, c in enumerate(a))
        self.forces.append(f"F{len(self.forces)}: {{damper: '{strength}', between: ['{start}', {b}]}}")
        self.dampers.append((strength, tuple(a), self.particles[b][1]))

    def spring(self, stiffness: str, a: str | Sequence[str], b: str, length: str = "0") -> None:
        """Between a point or a particle and a particle."""
        start = self.particles[a][1] if isinstance(a, str) else tuple(a)
        end = self.particles[b][1]
        written = a if isinstance(a, str) else "'" + " + ".join(f"({c})*{AXES[n]}" for n, c in enumerate(a)) + "'"
        rest = f", length: {length}" if length != "0" else ""
        self.forces.append(f"F{len(self.forces)}: {{spring: '{stiffness}', between: [{written}, {b}]{rest}}}")
        square = " + ".join(f"(({x}) - ({y}))^2" for x, y in zip(start, end, strict=True))
        energy = f"({square})" if length == "0" else f"(sqrt({square}) - ({length}))^2"
        self.terms.append(f"({stiffness})/2*{energy}")

    def choose(self, name: str, coordinates: list[str], substitute: dict[str, str], angles: set[str]) -> None:
        """A choice of generalized coordinates, in which the finite constraints hold by themselves. The last to be called."""

        def put(text: str) -> str:
            return re.sub(r"[^\W\d]\w*", lambda m: f"({substitute[m[0]]})" if m[0] in substitute else m[0], text)

        chart = replace(
            self, coordinates=coordinates, angles=angles, constraints={}, named={}, choices={},
            particles={p: (m, tuple(put(c) for c in r)) for p, (m, r) in self.particles.items()},
            terms=[put(t) for t in self.terms],
            dampers=[(c, a, tuple(put(x) for x in b)) for c, a, b in self.dampers],
        )  # fmt: skip
        self.choices[name] = (chart, substitute)

    def field(self, potential: str) -> None:
        self.forces.append(f"F{len(self.forces)}: {{potential: '{potential}'}}")
        self.terms.append(potential)

    # As a file

    @property
    def text(self) -> str:
        lines = [f"title: {self.family}"]
        if self.parameters:
            assumed = {p: "real" if p in self.real else "positive" for p in self.parameters}
            valued = {p: f"{{assume: {a}, value: {v}}}" for p, a in assumed.items() if (v := self.values.get(p))}
            lines.append(f"parameters: {{{', '.join(f'{p}: {a}' for p, a in (assumed | valued).items())}}}")
        lines.append(f"coordinates: [{', '.join(self.coordinates)}]")
        if self.particles:
            lines.append("particles:")
            for name, (mass, r) in self.particles.items():
                position = " + ".join(f"({c})*{AXES[n]}" for n, c in enumerate(r) if c != "0") or "0*i"
                massive = f"mass: {mass}, " if mass != "0" else ""
                lines.append(f"  {name}: {{{massive}position: '{position}'}}")
        if self.bodies:
            lines.append("bodies:")
            for name, (mass, inertia, r, angle) in self.bodies.items():
                position = " + ".join(f"({c})*{AXES[n]}" for n, c in enumerate(r) if c != "0") or "0*i"
                lines.append(
                    f"  {name}: {{mass: {mass}, inertia: {inertia}, position: '{position}', angle: '{angle}'}}"
                )
        if self.constraints or self.forms:
            lines.append("constraints:")
            for name, equation in self.constraints.items():
                reaction = f", reaction: {self.named[name]}" if name in self.named else ""
                reaction += f", by: {self.keepers[name]}" if name in self.keepers else ""
                lines.append(
                    f"  {name}: {{equation: '{equation}'{reaction}}}" if reaction else f"  {name}: '{equation}'"
                )
            for name, form in self.forms.items():
                lines.append(f"  {name}: '{' + '.join(f'({a})*{q}{chr(39) * 2}' for q, a in form.items())} = 0'")
        if self.gravity:
            lines.append(f"gravity: '{self.gravity}'")
        if self.forces:
            lines += ["forces:", *(f"  {f}" for f in self.forces)]
        if self.choices:
            lines.append("generalized_coordinates:")
            for name, (chart, substitute) in self.choices.items():
                pairs = ", ".join(f"{q}: '{e}'" for q, e in substitute.items() if q not in chart.coordinates)
                lines.append(f"  {name}: {{coordinates: [{', '.join(chart.coordinates)}], substitute: {{{pairs}}}}}")
        lines.append(f"find: {self.find}")
        return "\n".join(lines) + "\n"

    # In numbers

    def names(self, q: Sequence[Any], parameters: Mapping[str, float]) -> dict[str, Any]:
        return dict(parameters) | dict(zip(self.coordinates, q, strict=True))

    def energy(self, q: Sequence[float], parameters: Mapping[str, float], order: int = 2) -> Taylor:
        names = self.names(variables(q, order), parameters)
        total = names[self.coordinates[0]] * 0
        for term in self.terms:
            total = total + evaluate(term, names)
        return total

    def finite(self, q: Sequence[float], parameters: Mapping[str, float]) -> list[Taylor]:
        names = self.names(variables(q, 2), parameters)
        return [difference(c, names) for c in self.constraints.values()]

    def rows(self, q: Sequence[float], parameters: Mapping[str, float]) -> list[list[Any]]:
        """The coefficients of the kinematic constraints, as series."""
        xs = variables(q, 2)
        names = self.names(xs, parameters)
        return [
            [xs[0] * 0 + evaluate(form.get(x, "0"), names) for x in self.coordinates] for form in self.forms.values()
        ]

    def positions(self, q: Sequence[float], parameters: Mapping[str, float]) -> list[tuple[float, list[Taylor]]]:
        """(mass, position) of every particle."""
        xs = variables(q, 2)
        names = self.names(xs, parameters)
        return [
            (float(evaluate(mass, dict(parameters))), [xs[0] * 0 + evaluate(c, names) for c in r])
            for mass, r in self.particles.values()
        ]

    def mass_matrix(self, q: Sequence[float], parameters: Mapping[str, float]) -> Array:
        total = np.zeros((len(q), len(q)))
        for mass, r in self.positions(q, parameters):
            for component in r:
                total += mass * np.outer(component.gradient, component.gradient)
        return total

    def scope(self, q: Sequence[float], parameters: Mapping[str, float]) -> dict[str, Any]:
        """Names for what the program prints."""
        return {python_name(n): v for n, v in self.names([float(x) for x in q], parameters).items()}


def turned(x: float) -> float:
    """An angle in (−π, π]."""
    return math.pi - (math.pi - x) % (2 * math.pi)
