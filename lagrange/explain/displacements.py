"""Possible and virtual displacements, and how the dependent ones follow from the independent ones."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.symbols import Dot, VectorSymbol, differential, t, variation
from lagrange.document.derivation import Block, Detail, Equation, Part, Ref, Rule, Step, display, listed, math, prose
from lagrange.explain.bodies import virtual_rotations
from lagrange.explain.nonlinear import by_chetaev
from lagrange.explain.words import plural
from lagrange.mechanics.constraints.displacements import (
    Elimination,
    carried_along,
    displaced,
    displaced_force,
    virtual_displacement,
)
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint, Row, is_pfaffian
from lagrange.mechanics.dynamics.newton import Normal

LONGEST = 40
"""Operations of a solved displacement that are still shown without being asked for."""


def explain_displacements(
    configuration: Configuration,
    elimination: Elimination,
    carried: Sequence[sp.Expr],
    normals: Sequence[Normal] = (),
) -> Step:
    """From dq to δq, the solved δq, and what possible displacements have beyond them: `carried`, shape (n,)."""
    if not configuration.rows:
        words = "No constraint binds the displacements: every one of them is virtual, with time frozen."
        body = [prose(words), *of_points(configuration, elimination), *_by_time(configuration)]
        return Step(Rule.DISPLACEMENTS, "Virtual displacements", tuple(body))
    body = [*_subtracted(configuration)]
    if is_pfaffian(configuration.rows) and not any(r.drift != 0 for r in configuration.rows):
        body.append(prose("There is no term with ", math(differential(t)), ": ", *_same(configuration)))
    body += by_chetaev(configuration)
    body += solved_displacements(elimination, configuration)
    body += of_points(configuration, elimination)
    body += _tangent(normals)
    body += _drift(configuration, carried) if any(carried) else _by_time(configuration)
    return Step(Rule.DISPLACEMENTS, "Possible and virtual displacements", tuple(body))


def _tangent(normals: Sequence[Normal]) -> list[Block]:
    """∇f·dr + f_t dt = 0 and ∇f·δr = 0: virtual displacements are tangent to the surface as it is at the time."""
    found: list[Block] = []
    for n in normals:
        name, form, virtual = n.row.name, Ref(f"form-{n.row.name}"), Ref(f"virtual-{n.row.name}")
        gradient = n.gradient.as_sum()
        possible = Dot(gradient, VectorSymbol(f"d(r_{n.particle})"))
        moving = n.row.drift != 0
        lines = (
            Equation((possible, textbook_form(-n.row.drift) * differential(t)), label=f"normal-possible-{name}"),
            Equation((Dot(gradient, VectorSymbol(f"delta(r_{n.particle})")), sp.S.Zero), label=f"normal-{name}"),
        )
        which = "The vector in brackets" if isinstance(gradient, sp.Add) else "The first vector"
        where = f"{which} is the gradient, normal to the surface or curve that {n.particle} is kept on: "
        end = (
            "a virtual displacement is tangent to it as it is at the time, a possible one in general is not."
            if moving
            else "possible and virtual displacements are tangent to it."
        )
        found += [prose("In vectors, ", form, " and ", virtual, " are"), display(*lines), prose(where + end)]
    return found


def _subtracted(configuration: Configuration) -> list[Block]:
    """Two possible displacements subtracted."""
    slots = configuration.slots
    rows = [r for r in configuration.rows if r.nonlinear is None]
    if not rows:
        return []
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


def _same(configuration: Configuration) -> tuple[Part, ...]:
    """Possible and virtual displacements of the coordinates are the same; those of points may yet differ."""
    same = "possible and virtual displacements are the same."
    return (f"for the coordinates, {same}",) if _moving_points(configuration) else (same,)


def _drift(configuration: Configuration, carried: Sequence[sp.Expr]) -> list[Block]:
    """dr = δr + w dt: what a possible displacement has and a virtual one has not."""
    slots = configuration.slots
    steps = {q: rate * differential(t) for q, rate in zip(slots.coordinates, carried, strict=True) if rate != 0}
    forms = [Ref(f"form-{r.name}") for r in configuration.rows]
    moving = [r for r in configuration.rows if r.drift != 0]
    carry = plural(len(moving), "the moving constraint carries", "the moving constraints carry")
    rest = "with the other coordinates at rest, " if len(steps) < len(slots.coordinates) else ""
    found: list[Block] = [
        prose(f"Possible and virtual displacements are not the same: {carry} the system along. For instance, {rest}",
              *listed(forms), plural(len(forms), " is satisfied by", " are satisfied by")),
        display(*(Equation((differential(q), step)) for q, step in steps.items())),
        prose("and every other possible displacement differs from this one by a virtual displacement:"),
    ]  # fmt: skip
    if configuration.points:
        return [*found, _of_moved_points(configuration, carried)]
    lines = (
        Equation((differential(q), variation(q) + steps.get(q, sp.S.Zero)), label=f"possible-{q.name}")
        for q in slots.coordinates
    )
    return [*found, display(*lines)]


def _by_time(configuration: Configuration) -> list[Block]:
    """What possible displacements have beyond virtual ones where positions contain t."""
    moving = _moving_points(configuration)
    if not moving:
        return []
    names = listed(p.name for p in moving)
    verb = plural(len(moving), "the position of ", "the positions of ")
    words = prose("Time occurs in ", verb, *names, ": a possible displacement has a part beside the virtual one,")
    return [words, _of_moved_points(configuration, [sp.S.Zero] * len(configuration.slots.coordinates))]


def _of_moved_points(configuration: Configuration, carried: Sequence[sp.Expr]) -> Block:
    """dr = δr + w dt of each particle."""
    lines = []
    for p in configuration.points:
        extra = carried_along(p, configuration.slots, carried) * differential(t)
        virtual = VectorSymbol(f"delta(r_{p.name})")
        total = virtual if extra.is_zero else virtual + extra.as_sum()
        lines.append(Equation((VectorSymbol(f"d(r_{p.name})"), total), label=f"possible-{p.name}"))
    return display(*lines)


def _moving_points(configuration: Configuration) -> list[MassPoint]:
    """The particles whose position contains t."""
    slots = configuration.slots
    return [p for p in configuration.points if not p.position.frozen_derivative(slots).is_zero]


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


def of_points(configuration: Configuration, elimination: Elimination, label: str = "") -> list[Block]:
    """δr of each particle, without the δq that are zero. `label` tells where they are shown once more."""
    slots = configuration.slots
    zero = {d: value for d, value in elimination.solved(slots).items() if value == 0}
    suffix = f"-{configuration.name}" if configuration.name else ""
    lines = [
        Equation((VectorSymbol(f"delta(r_{p.name})"), displaced(p, slots).xreplace(zero)),
                 label=f"delta{label}{suffix}-{p.name}")
        for p in configuration.points if not configuration.is_pinned(p)
    ]  # fmt: skip
    turned = virtual_rotations(configuration, dict(zero), label)
    elsewhere = [
        Equation((VectorSymbol(f"delta(r_{f.name})"), displaced_force(f, slots).xreplace(zero)))
        for f in configuration.loads
        if f.elsewhere
    ]
    if not lines:
        return turned
    whose = points_called(configuration)
    words = plural(
        len(lines), f"The virtual displacement of the {whose} is", f"The virtual displacements of the {whose} are"
    )
    if elsewhere:
        words = f"The virtual displacements of the {whose}, and of where forces act, are"
        lines += elsewhere
    return [prose(words), display(*lines), *turned]


def points_called(configuration: Configuration) -> str:
    """`particle`, `mass centres`, ..."""
    particles = len(configuration.particles)
    centres = sum(not configuration.is_pinned(p) for p in configuration.points) - particles
    words = [plural(particles, "particle", "particles")] * bool(particles)
    return " and ".join(words + [plural(centres, "mass centre", "mass centres")] * bool(centres))
