"""Possible and virtual displacements, and how the dependent ones follow from the independent ones."""

from __future__ import annotations

import sympy as sp

from lagrange.derivation import Block, Detail, Equation, Part, Ref, Rule, Step, display, listed, math, prose
from lagrange.displacements import Elimination, displaced, displaced_force, virtual_displacement
from lagrange.kinematics import Configuration, Row
from lagrange.notation import VectorSymbol, differential, t, variation

LONGEST = 40
"""Operations of a solved displacement that are still shown without being asked for."""


def explain_displacements(configuration: Configuration, elimination: Elimination) -> Step:
    """From dq to δq, and the solved δq."""
    rows = configuration.rows
    if not rows:
        words = "No constraint binds the displacements: every one of them is virtual, with time frozen."
        return Step(
            Rule.DISPLACEMENTS,
            "Virtual displacements",
            (prose(words), *of_points(configuration, elimination)),
        )
    body = [*_subtracted(configuration), *_drift(configuration)]
    body += solved_displacements(elimination, configuration)
    body += of_points(configuration, elimination)
    return Step(Rule.DISPLACEMENTS, "Possible and virtual displacements", tuple(body))


def _subtracted(configuration: Configuration) -> list[Block]:
    """Two possible displacements subtracted."""
    slots, rows = configuration.slots, configuration.rows
    forms = listed(Ref(f"form-{r.name}") for r in rows)
    dt = math(differential(t))
    moving = any(r.drift != 0 for r in rows)
    words: tuple[Part, ...] = (
        "A possible displacement, in the time ", dt, ", satisfies ", *forms, ". Two possible displacements in the same "
        "time from the same position differ by a virtual displacement. ",
        *(("The terms with ", dt, " drop out of the difference: in a virtual displacement time is frozen,") if moving
          else ("Their difference satisfies",)),
    )  # fmt: skip
    lines = (Equation((virtual_displacement(r, slots), sp.S.Zero), label=f"virtual-{r.name}") for r in rows)
    return [prose(*words), display(*lines)]


def _drift(configuration: Configuration) -> list[Block]:
    """What a possible displacement has and a virtual one has not."""
    dt = math(differential(t))
    moving = [r for r in configuration.rows if r.drift != 0]
    if not moving:
        return [prose("There is no term with ", dt, ": possible and virtual displacements are the same.")]
    names = listed(Ref(f"form-{r.name}") for r in moving)
    found: list[Block] = []
    if configuration.points:
        lines = [
            Equation((VectorSymbol(f"d(r_{p.name})"), displaced(p, configuration.slots, differential)))
            for p in configuration.points
        ]
        found.append(prose("A possible displacement of the " + ("particle is" if len(lines) == 1 else "particles is")))
        found.append(display(*lines))
    found.append(
        prose("It has a part that no virtual displacement has, forced on it by the term with ", dt, " in ", *names,
              ": the constraint moves." if len(moving) == 1 else ": the constraints move.")
    )  # fmt: skip
    return found


def solved_displacements(elimination: Elimination, configuration: Configuration) -> list[Block]:
    """The dependent δq, and where the solution is valid; nothing where the constraints say it already."""
    slots = configuration.slots
    solved = elimination.solved(slots)
    free = [math(variation(slots.coordinates[k])) for k in elimination.independent]
    found: list[Block] = []
    if solved and not all(_is_evident(row) for row in configuration.rows):
        long = any(value.count_ops() > LONGEST for value in solved.values())
        pivots = conditions(elimination)
        where: tuple[Part, ...] = (", where ", *pivots) if pivots else ()
        begin, ending = ("They determine ", "; the long result is left out here.") if long else ("Solved for ", ",")
        found.append(prose(begin, *listed(math(d) for d in solved), *where, ending))
        lines = (Equation((d, e)) for d, e in solved.items())
        found.append(display(*lines, detail=Detail.FULL if long else Detail.STEPS))
    if not free:
        return [*found, prose("No displacement is left free.")]
    return [*found, prose(*listed(free), " remains free." if len(free) == 1 else " remain free.")]


def _is_evident(row: Row) -> bool:
    """Whether the row says by itself that a displacement is zero: δr = 0."""
    nonzero = [a for a in row.coefficients if a != 0]
    return len(nonzero) == 1 and nonzero[0].is_number


def conditions(elimination: Elimination) -> tuple[Part, ...]:
    """What must not vanish: `y ≠ 0 and x ≠ 0`."""
    return listed(math(p, sp.S.Zero, relation="≠") for p in elimination.pivots)


def of_points(configuration: Configuration, elimination: Elimination) -> list[Block]:
    """δr of each particle, without the δq that are zero."""
    slots = configuration.slots
    zero = {d: value for d, value in elimination.solved(slots).items() if value == 0}
    suffix = f"-{configuration.name}" if configuration.name else ""
    lines = [
        Equation((VectorSymbol(f"delta(r_{p.name})"), displaced(p, slots, variation).xreplace(zero)),
                 label=f"delta{suffix}-{p.name}")
        for p in configuration.points
    ]  # fmt: skip
    elsewhere = [
        Equation((VectorSymbol(f"delta(r_{f.name})"), displaced_force(f, slots).xreplace(zero)))
        for f in configuration.loads
        if f.elsewhere
    ]
    if not lines:
        return []
    words = (
        "The virtual displacement of the particle is"
        if len(lines) == 1
        else "The virtual displacements of the particles are"
    )
    if elsewhere:
        words = "The virtual displacements of the particles, and of where forces act, are"
        lines += elsewhere
    return [prose(words), display(*lines)]
