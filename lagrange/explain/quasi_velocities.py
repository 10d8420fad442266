"""Quasi-velocities: their definitions, the kinematic equations, the equations of motion in them."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import VectorSymbol, prime, variation
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    EquationKind,
    Part,
    Phrase,
    Purpose,
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
from lagrange.explain.words import are, capital, joined, must_vanish, plural, suffix_of, title_in
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.quasi_equations import QuasiEquations, QuasiVelocityForm
from lagrange.mechanics.dynamics.quasi_velocities import QuasiVelocities, quasi_variation
from lagrange.problem.model import Problem

ZERO = sp.S.Zero


def explain_speeds(form: QuasiVelocityForm, problem: Problem, first: bool, stated: bool = True) -> Step:
    """The quasi-velocities in one set of coordinates.

    first   whether these are the file's own, or the first choice that has them
    stated  whether the page states d'Alembert's principle
    """
    quasi, equations = form.velocities, form.equations
    body = [*_definitions(quasi), *_determined(quasi)]
    if equations is not None:
        body += _vectors(equations, problem, first)
        body += _principle(equations, stated)
        body += _final(equations, form.configuration)
    noun = plural(len(quasi.definitions), "quasi-velocity", "quasi-velocities")
    title = f"Equations of motion in the {noun}" if equations is not None else noun.capitalize()
    return Step(Rule.QUASI_VELOCITIES, title_in(title, quasi.configuration.name), tuple(body))


def _definitions(quasi: QuasiVelocities) -> list[Block]:
    """u = ..."""
    suffix = suffix_of(quasi.configuration.name)
    lines = (
        Equation((u, e), label=f"speed{suffix}-{u.name}", kind=EquationKind.SPEED) for u, e in quasi.definitions.items()
    )
    words = plural(len(quasi.definitions), "the quasi-velocity is", "the quasi-velocities are")
    in_these = "in these coordinates " if quasi.configuration.name else ""
    return [prose(capital(in_these + words)), display(*lines)]


def _determined(quasi: QuasiVelocities) -> list[Block]:
    """q' = B u + b."""
    suffix = suffix_of(quasi.configuration.name)
    rows = quasi.configuration.rows
    blocks: list[Block] = []
    if quasi.completing:
        others = [math(prime(q)) for q in quasi.completing]
        verb = plural(len(others), " completes the set.", " complete the set.")
        blocks.append(prose("There are more degrees of freedom than quasi-velocities: ", *listed(others), verb))
    determine = plural(len(quasi.symbols), "it determines", "they determine")
    with_rows = plural(len(rows), "together with the constraint ", "together with the constraints ") if rows else ""
    where: tuple[Part, ...] = ()
    if quasi.pivots:
        where = (", where ", *listed(math(p, ZERO, relation="≠") for p in quasi.pivots), ",")
    lines = [
        Equation((v, e), label=f"kinematic{suffix}-{v.name}", kind=EquationKind.KINEMATIC)
        for v, e in quasi.kinematic.items()
    ]
    which = "the other " if quasi.completing else "all " if len(lines) > 1 else "the "
    words = f"{with_rows}{determine} {which}{plural(len(lines), 'velocity', 'velocities')}"
    return [*blocks, prose(capital(words), *where, " by"), display(*lines)]


def _vectors(equations: QuasiEquations, problem: Problem, first: bool) -> list[Block]:
    """The unit vectors not needed before; v, ω and H; a and dH/dt."""
    quasi = equations.quasi
    configuration, suffix = quasi.configuration, suffix_of(quasi.configuration.name)
    used = [v.triad for v in (*equations.velocities.values(), *equations.spins.values())]
    known = directions_of(stated_triads(configuration), problem)
    blocks: list[Block] = []
    new = [e for name, e in directions_of(used, problem).items() if name not in known] if first else []
    if new:
        begins = Phrase("With the unit vectors", instead="With the unit vector")
        blocks += [prose(begins, purpose=Purpose.DEFINITIONS), display(*new)]
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
    if not lines:  # a Lagrangian that is given has no bodies
        return blocks
    words = joined(whats) + are(lines).rstrip()
    blocks += [prose(words if new else capital(f"{words} then")), display(*lines)]
    a = {f"r_{name}''": vector for name, vector in equations.accelerations.items()}
    rates = {f"H_{name}'": vector for name, vector in equations.momentum_rates.items()}
    lines = [
        Equation((VectorSymbol(name), vector), label=f"changed-in-speeds{suffix}-{name}")
        for name, vector in {**a, **rates}.items()
    ]
    if lines:
        blocks += [prose("Differentiation gives"), display(*lines)]
    return blocks


def _principle(equations: QuasiEquations, stated: bool) -> list[Block]:
    """δπ_u, and the principle with them."""
    quasi, suffix = equations.quasi, suffix_of(equations.quasi.configuration.name)
    lines = [
        Equation(sides, label=f"quasi-variation{suffix}-{u.name}", kind=EquationKind.QUASI_VARIATION)
        for u, sides in zip(quasi.definitions, quasi.virtual.items(), strict=True)
    ]
    free = [math(quasi_variation(u)) for u in quasi.definitions]
    free += [math(variation(q)) for q in quasi.completing]
    role = plural(len(free), " plays the role of ", " play the role of ")
    symbols = listed(math(s) for s in quasi.symbols)
    law: tuple[Part, ...] = ("d'Alembert's principle ", *((Ref("principle"), " ") if stated else ()), "reads")
    if not quasi.configuration.points and not quasi.configuration.rotations:  # the Lagrangian is given
        law = ("Lagrange's equations, each multiplied by the virtual displacement of its coordinate, add up to",)
    return [
        prose("In a virtual displacement, with time frozen, ", *listed(free), role, *symbols, ":"),
        display(*lines),
        prose("With these, ", *law),
        display(Equation((equations.statement, ZERO), label=f"written-out-in-speeds{suffix}")),
        must_vanish(free, scaling(equations.equations), ending="arbitrary in every virtual displacement"),
    ]


def _final(equations: QuasiEquations, configuration: Configuration) -> list[Block]:
    """The boxed equations, the kinematic ones and the finite constraints after them."""
    quasi, suffix = equations.quasi, suffix_of(equations.quasi.configuration.name)
    lines = [
        Equation(
            (e.expression, ZERO),
            label=f"motion-in-speeds{suffix}-{e.coordinate.name}",
            kind=EquationKind.MOTION_IN_SPEEDS,
        )
        for e in equations.equations
    ]
    lines += [Equation((v, e)) for v, e in quasi.kinematic.items()]
    lines += [Equation((r.finite, ZERO)) for r in configuration.rows if r.finite is not None]
    return [display(*lines, boxed=True, detail=Detail.BRIEF)]
