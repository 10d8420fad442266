"""Quasi-velocities: their definitions, the kinematic equations, the equations of motion in them."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import VectorSymbol, prime, variation
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    Part,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    prose,
)
from lagrange.explain.bodies import directions_of, stated_triads
from lagrange.explain.displacements import points_called
from lagrange.explain.motion import scaling
from lagrange.explain.words import plural, spoken
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.quasi_equations import QuasiEquations
from lagrange.mechanics.dynamics.quasi_velocities import QuasiVelocities, quasi_variation
from lagrange.mechanics.dynamics.quasi_verification import InSpeeds
from lagrange.problem.model import Problem

ZERO = sp.S.Zero


def explain_speeds(found: InSpeeds, problem: Problem, first: bool, stated: bool = True) -> Step:
    """The quasi-velocities in one set of coordinates.

    first   whether these are the file's own, or the first choice that has them
    stated  whether d'Alembert's principle stands on the page
    """
    quasi, equations = found.velocities, found.equations
    body = [*_definitions(quasi), *_determined(quasi)]
    if equations is not None:
        body += _vectors(equations, problem, first)
        body += _principle(equations, stated)
        body += _final(equations, found.configuration)
    noun = plural(len(quasi.definitions), "quasi-velocity", "quasi-velocities")
    title = f"Equations of motion in the {noun}" if equations is not None else noun.capitalize()
    return Step(Rule.QUASI_VELOCITIES, f"{title}{_where(quasi)}", tuple(body))


def _where(quasi: QuasiVelocities) -> str:
    name = quasi.configuration.name
    return f": {spoken(name)}" if name else ""


def _suffix(quasi: QuasiVelocities) -> str:
    name = quasi.configuration.name
    return f"-{name}" if name else ""


def _definitions(quasi: QuasiVelocities) -> list[Block]:
    """u = ..."""
    suffix = _suffix(quasi)
    lines = (Equation((u, e), label=f"speed{suffix}-{u.name}") for u, e in quasi.definitions.items())
    words = plural(len(quasi.definitions), "the quasi-velocity is", "the quasi-velocities are")
    in_these = "In these coordinates " if quasi.configuration.name else ""
    said = f"{in_these}{words}"
    return [prose(f"{said[0].upper()}{said[1:]}"), display(*lines)]


def _determined(quasi: QuasiVelocities) -> list[Block]:
    """q' = B u + b."""
    suffix = _suffix(quasi)
    rows = quasi.configuration.rows
    found: list[Block] = []
    if quasi.completing:
        others = [math(prime(q)) for q in quasi.completing]
        verb = plural(len(others), " completes ", " complete ") + plural(len(quasi.definitions), "it", "them")
        few = plural(len(quasi.definitions), "There are more degrees of freedom than this one: ",
                     "There are more degrees of freedom than these: ")  # fmt: skip
        found.append(prose(few, *listed(others), verb, "."))
    determine = plural(len(quasi.symbols), "it determines", "they determine")
    with_rows = plural(len(rows), "Together with the constraint ", "Together with the constraints ") if rows else ""
    where: tuple[Part, ...] = ()
    if quasi.pivots:
        where = (", where ", *listed(math(p, ZERO, relation="≠") for p in quasi.pivots), ",")
    lines = [Equation((v, e), label=f"kinematic{suffix}-{v.name}") for v, e in quasi.kinematic.items()]
    which = "the other " if quasi.completing else "all " if len(lines) > 1 else "the "
    said = f"{with_rows}{determine} {which}{plural(len(lines), 'velocity', 'velocities')}"
    found.append(prose(f"{said[0].upper()}{said[1:]}", *where, " by"))
    found.append(display(*lines))
    return found


def _vectors(equations: QuasiEquations, problem: Problem, first: bool) -> list[Block]:
    """The unit vectors that were not needed before; v, ω and H; a and dH/dt."""
    quasi = equations.quasi
    configuration, suffix = quasi.configuration, _suffix(quasi)
    used = [v.triad for v in (*equations.velocities.values(), *equations.spins.values())]
    known = directions_of(stated_triads(configuration), problem)
    found: list[Block] = []
    new = [e for name, e in directions_of(used, problem).items() if name not in known] if first else []
    if new:
        found += [prose("With the unit vectors"), display(*new)]
    v = {f"r_{name}'": vector for name, vector in equations.velocities.items()}
    w = {f"omega_{name}": vector for name, vector in equations.spins.items()}
    h = {f"H_{name}": vector for name, vector in equations.momenta.items()}
    lines = [
        Equation((VectorSymbol(name), vector), label=f"in-speeds{suffix}-{name}")
        for name, vector in {**v, **w, **h}.items()
    ]
    whose = points_called(configuration)
    whats = [plural(len(v), f"the velocity of the {whose}", f"the velocities of the {whose}")] * bool(v)
    whats += [plural(len(w), "the angular velocity", "the angular velocities")] * bool(w)
    whats += [plural(len(h), "the angular momentum", "the angular momenta")] * bool(h)
    words = "".join(str(p) for p in listed(whats))
    verb = plural(len(lines), "is", "are")
    found += [prose(f"{words[0].upper()}{words[1:]} {verb} then"), display(*lines)]
    a = {f"r_{name}''": vector for name, vector in equations.accelerations.items()}
    rates = {f"H_{name}'": vector for name, vector in equations.momentum_rates.items()}
    lines = [
        Equation((VectorSymbol(name), vector), label=f"changed-in-speeds{suffix}-{name}")
        for name, vector in {**a, **rates}.items()
    ]
    if lines:
        found += [prose("and, differentiated,"), display(*lines)]
    return found


def _principle(equations: QuasiEquations, stated: bool) -> list[Block]:
    """δπ_u, and the principle with them."""
    quasi, suffix = equations.quasi, _suffix(equations.quasi)
    lines = [
        Equation(sides, label=f"quasi-variation{suffix}-{u.name}")
        for u, sides in zip(quasi.definitions, quasi.virtual.items(), strict=True)
    ]
    free = [math(quasi_variation(u)) for u in quasi.definitions]
    free += [math(variation(q)) for q in quasi.completing]
    takes = plural(len(free), " takes the place of ", " take the place of ")
    words: tuple[Part, ...] = (
        "In a virtual displacement, time frozen, ",
        *listed(free),
        takes,
        *listed(math(s) for s in quasi.symbols),
        ":",
    )
    verb = plural(
        len(free),
        " is free, so that what multiplies it vanishes",
        " are free in every virtual displacement, so that what multiplies each of them vanishes",
    )
    divided = scaling(equations.equations)
    return [
        prose(*words),
        display(*lines),
        prose("With these, d'Alembert's principle ", *((Ref("principle"), " ") if stated else ()), "reads"),
        display(Equation((equations.statement, ZERO), label=f"written-out-in-speeds{suffix}")),
        prose(*listed(free), verb, *((" (", *divided, ")") if divided else ()), ":"),
    ]


def _final(equations: QuasiEquations, configuration: Configuration) -> list[Block]:
    """The boxed equations, the kinematic ones and the finite constraints after them."""
    quasi, suffix = equations.quasi, _suffix(equations.quasi)
    lines = [
        Equation((e.expression, ZERO), label=f"motion-in-speeds{suffix}-{e.coordinate.name}")
        for e in equations.equations
    ]
    lines += [Equation((v, e)) for v, e in quasi.kinematic.items()]
    lines += [Equation((r.finite, ZERO)) for r in configuration.rows if r.finite is not None]
    return [display(*lines, boxed=True, detail=Detail.BRIEF)]
