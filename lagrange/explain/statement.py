"""The statement: what the system is, which symbols it has, where things are and what acts on them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

import sympy as sp

from lagrange.core.symbols import VectorSymbol
from lagrange.core.vectors import UNITS, Vector
from lagrange.document.derivation import Block, Equation, Part, Rule, Step, Table, display, listed, math, prose
from lagrange.explain.bodies import explain_links, explain_rotation, moments_on, triads_of_bodies
from lagrange.explain.words import plural, spoken
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.problem.model import Assumption, Coordinate, Friction, Parameter, Problem


def explain_statement(problem: Problem, configuration: Configuration, with_potential: bool = True) -> Step:
    """Description, symbols, positions, applied forces.

    with_potential  whether the potential energy of fields and springs is stated here, and not with the weights' later
    """
    body: list[Block] = []
    if problem.description:
        body.append(prose(problem.description))
    if problem.axes:
        words = [(UNITS[name], f" points {word}") for name, word in problem.axes.items()]
        body.append(prose(*_sentence(listed_pairs(words))))
    body += _symbols(problem)
    body += _functions(problem)
    body += _frame(problem)
    body += triads_of_bodies(problem, configuration)
    body += _abbreviations(problem)
    body += _positions(problem, configuration)
    body += _forces(configuration, [f for f in problem.forces if isinstance(f, Friction)], with_potential)
    return Step(Rule.STATEMENT, "The system", tuple(body))


def listed_pairs(pairs: Iterable[tuple[sp.Expr, str]]) -> tuple[Part, ...]:
    """`i points right and j points down`."""
    joined: list[Part] = []
    pairs = list(pairs)
    for n, (symbol, words) in enumerate(pairs):
        if n:
            joined.append(" and " if n == len(pairs) - 1 else ", ")
        joined += [math(symbol), words]
    return tuple(joined)


def _sentence(parts: Iterable[Part]) -> tuple[Part, ...]:
    return (*parts, ".")


def _symbols(problem: Problem) -> list[Block]:
    """A table of the symbols where the file says what they mean, sentences where it does not."""
    groups: list[Sequence[Coordinate | Parameter]] = [problem.coordinates, problem.parameters]
    said = [any(x.meaning or x.unit for x in group) for group in groups]
    found: list[Block] = [*_listed("coordinate", problem.coordinates)] if not said[0] else []
    found += _listed("parameter", problem.parameters) if not said[1] else []
    rows = [x for group, has in zip(groups, said, strict=True) if has for x in group]
    if rows:
        with_units = any(x.unit for x in rows)
        header: tuple[Part, ...] = ("symbol", "meaning", "unit") if with_units else ("symbol", "meaning")
        cells: list[tuple[Part, ...]] = []
        for x in rows:
            kind = "parameter" if isinstance(x, Parameter) else "coordinate"
            row: tuple[Part, ...] = (math(x.symbol), x.meaning or kind)
            cells.append((*row, raised(x.unit)) if with_units else row)
        found.append(Table(header, tuple(cells)))
    return [*found, *_assumptions(problem)]


def _listed(what: str, members: Sequence[Coordinate | Parameter]) -> list[Block]:
    """`The coordinates are x and y.`"""
    if not members:
        return []
    words = plural(len(members), f"The {what} is ", f"The {what}s are ")
    return [prose(words, *listed(math(x.symbol) for x in members), ".")]


_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def raised(unit: str) -> str:
    """A unit as it is printed: m/s^2 is m/s²."""
    return re.sub(r"\^(-?\d+)", lambda found: found[1].translate(_SUPERSCRIPTS), unit)


_ASSUMED = {
    Assumption.POSITIVE: "positive",
    Assumption.NONNEGATIVE: "positive or zero",
    Assumption.REAL: "of either sign",
    Assumption.SIGN: "+1 or −1",
}


def _assumptions(problem: Problem) -> list[Block]:
    kinds = {p.assume for p in problem.parameters}
    if not kinds:
        return []
    if kinds == {Assumption.POSITIVE}:
        if len(problem.parameters) == 1:
            return []
        return [prose("All parameters are positive.")]
    clauses: list[Part] = []
    for kind in Assumption:
        members = [p.symbol for p in problem.parameters if p.assume is kind]
        if members:
            clauses += [
                "; " if clauses else "",
                *listed(math(s) for s in members),
                " is " if len(members) == 1 else " are ",
            ]
            clauses.append(_ASSUMED[kind])
    return [prose(*clauses, ".")]


def _functions(problem: Problem) -> list[Block]:
    """The prescribed motions; the undefined functions, those of the same arguments together."""
    found: list[Block] = []
    prescribed = problem.slots.prescribed
    if prescribed:
        words = plural(len(prescribed), " is a prescribed function of time.", " are prescribed functions of time.")
        found.append(prose(*listed(math(u) for u in prescribed), words))
    for arguments in dict.fromkeys(f.arguments for f in problem.functions):
        members = [f.name for f in problem.functions if f.arguments == arguments]
        words = plural(len(members), " is an unspecified function of ", " are unspecified functions of ")
        found.append(prose(*_names(members), words, *_names(arguments), "."))
    return found


def _names(names: Iterable[str]) -> tuple[Part, ...]:
    return listed(math(sp.Symbol(n)) for n in names)


def _abbreviations(problem: Problem) -> list[Block]:
    """What the file writes for short: unit vectors, angular velocities."""
    if not problem.abbreviations:
        return []
    lines = (
        Equation((VectorSymbol(name) if isinstance(value, Vector) else sp.Symbol(name), value))
        for name, value in problem.abbreviations.items()
    )
    return [prose("For short, write"), display(*lines)]


def _frame(problem: Problem) -> list[Block]:
    """The unit vectors that turn."""
    found: list[Block] = []
    triad = problem.frame
    if triad is not None and triad.directions is not None:
        found.append(prose("The unit vectors of the frame turn with the coordinates:"))
        lines = []
        for n, unit in enumerate(triad.units):
            row = triad.directions[n, :]
            direction = Vector((row[0], row[1], row[2]))
            if unit.name not in UNITS:
                lines.append(Equation((unit, direction)))
        found.append(display(*lines))
    return found


def _body(configuration: Configuration, centre: MassPoint) -> Block:
    """Its mass, and where its mass centre is."""
    if configuration.is_pinned(centre):
        mass: tuple[Part, ...] = (", of mass ", math(centre.mass), ",") if centre.mass != 0 else ()
        return prose(f"The mass centre of the rigid body {centre.name}", *mass, " stays at")
    has: tuple[Part, ...] = ("the mass ", math(centre.mass)) if centre.mass != 0 else ("no mass",)
    return prose(f"The rigid body {centre.name} has ", *has, ". The position of its mass centre is")


def _positions(problem: Problem, configuration: Configuration) -> list[Block]:
    """Where the particles are. That a point has no mass is worth saying only where others have some."""
    found: list[Block] = []
    massless = ", a massless point," if any(p.mass != 0 for p in configuration.points) else ""
    bodies = {b.name: b for b in problem.bodies}
    turning = {r.name: r for r in configuration.rotations}
    for p in configuration.points:
        what: tuple[Part, ...] = (", of mass ", math(p.mass), ",") if p.mass != 0 else (massless,)
        position = Equation((VectorSymbol(f"r_{p.name}"), p.position), label=f"position-{p.name}")
        if p.name in bodies:
            found.append(_body(configuration, p))
            found += [display(position), *explain_rotation(bodies[p.name], turning[p.name])]
        else:
            found += [prose(f"The position of {p.name}", *what, " is"), display(position)]
    return found


def _forces(configuration: Configuration, frictions: Sequence[Friction], with_potential: bool) -> list[Block]:
    found: list[Block] = []
    rubbing = {f.name: f.constraint for f in frictions}
    for p in configuration.points:
        loads = [f for f in configuration.loads if f.on == p.name and not f.elsewhere]
        if not loads:
            continue
        names = [
            "its weight"
            if f.name == "weight"
            else f"the friction {f.name}"
            if f.name in rubbing
            else f"the force {f.name}"
            for f in loads
        ]
        total = sum((f.vector for f in loads), Vector.zero(p.position.triad))
        shown = total.along(p.position.triad)
        sides = (VectorSymbol(f"F_{p.name}"), total, shown) if shown != total else (VectorSymbol(f"F_{p.name}"), total)
        words = "The applied force on " if len(loads) == 1 else "The applied forces on "
        verb = " is " if len(loads) == 1 else " are "
        found += [
            prose(f"{words}{p.name}{verb}", *listed(names), ","),
            display(Equation(sides, label=f"force-{p.name}")),
        ]
        unknown = listed(dict.fromkeys(spoken(rubbing[f.name]) for f in loads if f.name in rubbing))
        if unknown:
            found.append(prose("The friction has the multiplier of the reaction of ", *unknown, " in it, found below."))
    for f in configuration.loads:
        if f.elsewhere:
            lines = (
                Equation((VectorSymbol(f"F_{f.name}"), f.vector)),
                Equation((VectorSymbol(f"r_{f.name}"), f.point)),
            )
            found += [prose(f"The force {f.name} on {f.on}, and the point where it acts, are"), display(*lines)]
    found += moments_on(configuration)
    found += explain_links(configuration)
    if configuration.potential != 0 and with_potential:
        of = "" if configuration.springs else " of the given fields"
        found += [
            prose(f"The potential energy{of} is"),
            display(Equation((sp.Symbol("V", real=True), configuration.potential), label="potential")),
        ]
    return found
