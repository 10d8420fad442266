"""Possible and virtual displacements; the dependent ones in terms of the independent ones."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import DotProduct, VectorSymbol, differential, t, variation
from lagrange.document.derivation import (
    Block,
    Detail,
    Display,
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
from lagrange.explain.bodies import virtual_rotations
from lagrange.explain.constraint_systems import by_chetaev, virtual_conditions
from lagrange.explain.limits import LONGEST_DISPLACEMENT
from lagrange.explain.words import joined, plural, suffix_of, the
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.displacements import (
    Elimination,
    displaced,
    displaced_force,
    is_carried_as_a_whole,
    transport_velocity,
    virtual_displacement,
)
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.dynamics.newton import Normal


def explain_displacements(
    configuration: Configuration,
    elimination: Elimination,
    rates: Sequence[sp.Expr],
    normals: Sequence[Normal] = (),
) -> Step:
    """From dq to δq, the solved δq, and the rates `rates`, shape (n,), that only possible displacements have."""
    if not configuration.rows:
        words = "Every displacement at a fixed time is virtual."
        body = [prose(words), *of_points(configuration, elimination, at_once=True), *_by_time(configuration)]
        return Step(Rule.DISPLACEMENTS, "Virtual displacements", tuple(body))
    body = [*_subtracted(configuration)]
    if configuration.constrained.is_pfaffian and not any(r.drift != 0 for r in configuration.rows):
        whose = " for the coordinates" if _moving_points(configuration) else ""  # those of points may yet differ
        words = f", possible and virtual displacements are the same{whose}."
        body.append(prose("Since there is no term in ", math(differential(t)), words))
    body += by_chetaev(configuration)
    body += solved_displacements(elimination, configuration)
    body += of_points(configuration, elimination, at_once=True)
    body += _tangent(normals, len(configuration.rows))
    body += _drift(configuration, rates) if any(rates) else _by_time(configuration)
    return Step(Rule.DISPLACEMENTS, "Possible and virtual displacements", tuple(body))


def _tangent(normals: Sequence[Normal], rows: int) -> list[Block]:
    """∇f·dr + f_t dt = 0 and ∇f·δr = 0: virtual displacements are tangent to the surface as it is at the time.

    Nothing where other constraints (`rows` in all) bind the displacements too.
    """
    if not normals or len(normals) < rows:
        return []
    lines: list[Equation] = []
    for n in normals:
        gradient, name = n.gradient.as_sum(), n.row.name
        possible = DotProduct(gradient, VectorSymbol(f"d(r_{n.particle})"))
        virtual = DotProduct(gradient, VectorSymbol(f"delta(r_{n.particle})"))
        lines += [
            Equation((possible, n.rate * differential(t)), label=f"normal-possible-{name}"),
            Equation((virtual, sp.S.Zero), label=f"normal-{name}"),
        ]
    forms = listed(Ref(f"{kind}-{n.row.name}") for n in normals for kind in ("form", "virtual"))
    which = "The vector in brackets" if isinstance(normals[0].gradient.as_sum(), sp.Add) else "The first vector"
    whom = joined(dict.fromkeys(the(n.particle) for n in normals))
    where = plural(len(normals), f"{which} is the gradient, normal to the surface or curve on which {whom} is kept: ",
                   "The gradients are normal to the surfaces or curves on which " + whom
                   + plural(len({n.particle for n in normals}), " is", " are") + " kept: ")  # fmt: skip
    end = (
        "a virtual displacement is tangent to it as it is at that time, a possible one in general is not."
        if any(n.row.drift != 0 for n in normals)
        else f"possible and virtual displacements are tangent to {plural(len(normals), 'it', 'them')}."
    )
    return [prose("In vector form, ", *forms, " are"), display(*lines), prose(where + end)]


def _subtracted(configuration: Configuration) -> list[Block]:
    """Two possible displacements subtracted."""
    rows = [r for r in configuration.rows if r.nonlinear is None]
    if not rows:
        return []
    forms = listed(Ref(f"form-{r.name}") for r in rows)
    dt = math(differential(t))
    moving = any(r.drift != 0 for r in rows)
    words: tuple[Part, ...] = (
        "Possible displacements satisfy ", *forms, ". A virtual displacement is the difference of two of them in the "
        "same time ", dt, ", from the same position: ", "the terms in " if moving else "", *((dt,) if moving else ()),
        " drop out, and it satisfies" if moving else "it satisfies",
    )  # fmt: skip
    lines = virtual_conditions(rows, configuration.slots)
    return [prose(*words), display(*lines)]


def _drift(configuration: Configuration, rates: Sequence[sp.Expr]) -> list[Block]:
    """dr = δr + w dt: the part w dt that only possible displacements have."""
    slots = configuration.slots
    steps = {q: rate * differential(t) for q, rate in zip(slots.coordinates, rates, strict=True) if rate != 0}
    forms = [Ref(f"form-{r.name}") for r in configuration.rows]
    moving = [r for r in configuration.rows if r.drift != 0]
    carry = plural(len(moving), "the moving constraint carries", "the moving constraints carry")
    rates_of = {r.moves_with(slots) for r in moving}
    rate = rates_of.pop() if len(rates_of) == 1 else None
    differ: tuple[Part, ...] = ("Possible and virtual displacements differ",)
    if rate is not None:
        differ = (*differ, " unless ", math(rate, sp.S.Zero))
    fixed = [math(q) for q in slots.coordinates if q not in steps]
    rest: tuple[Part, ...] = ("with ", *listed(fixed), " fixed, ") if fixed else ()
    blocks: list[Block] = [
        prose(*differ, f", because {carry} the system along. For instance, ", *rest,
              *listed(forms), plural(len(forms), " is satisfied by", " are satisfied by"), purpose=Purpose.DRIFT),
        display(*(Equation((differential(q), step)) for q, step in steps.items())),
        prose("and every other possible displacement differs from this one by a virtual displacement:"),
    ]  # fmt: skip
    if configuration.points:
        return [*blocks, _of_moved_points(configuration, rates), *_relative(configuration, rates)]
    lines = (
        Equation(
            (differential(q), variation(q) + steps.get(q, sp.S.Zero)),
            label=f"possible-{q.name}",
            kind=EquationKind.POSSIBLE,
        )
        for q in slots.coordinates
    )
    return [*blocks, display(*lines)]


def _relative(configuration: Configuration, rates: Sequence[sp.Expr]) -> list[Block]:
    """v = v_R + w for a particle on a surface that translates with the velocity w(t).

    f(r, t) = 0 with ∂f/∂t + w·∇f = 0 for the same w everywhere is f(r + w dt, t + dt) = f(r, t).
    """
    slots = configuration.slots
    surface = {2: "curve", 3: "surface"}.get(len(slots.coordinates))
    if surface is None or len(configuration.points) != 1 or len(configuration.rows) != 1:
        return []
    [p], [row] = configuration.points, configuration.rows
    carried = transport_velocity(p, slots, rates).fixed()
    if not is_carried_as_a_whole(row, carried, rates, slots):
        return []
    absolute, relative = VectorSymbol(f"r_{p.name}'"), VectorSymbol("v_R")
    moves = prose(f"The {surface} is carried along with the velocity ", math(carried.as_sum()), ". Divided by ",
                  math(differential(t)), ", this says that ", math(absolute, relative + carried.as_sum()), ", where ",
                  math(relative), f", the velocity of {the(p.name)} relative to the {surface}, is tangent to it."
                  )  # fmt: skip
    return [moves]


def _by_time(configuration: Configuration) -> list[Block]:
    """The additional part of possible displacements, beyond the virtual one, where positions contain t."""
    moving = _moving_points(configuration)
    if not moving:
        return []
    positions = f"the {plural(len(moving), 'position', 'positions')} of {joined(the(p.name) for p in moving)}"
    words = prose(
        f"Time appears explicitly in {positions}: a possible displacement has a part besides the virtual one,"
    )
    return [words, _of_moved_points(configuration, [sp.S.Zero] * len(configuration.slots.coordinates))]


def _of_moved_points(configuration: Configuration, rates: Sequence[sp.Expr]) -> Block:
    """dr = δr + w dt of each particle."""
    lines = []
    for p in configuration.points:
        extra = transport_velocity(p, configuration.slots, rates) * differential(t)
        virtual = VectorSymbol(f"delta(r_{p.name})")
        total = virtual if extra.is_zero else virtual + extra.as_sum()
        lines.append(
            Equation((VectorSymbol(f"d(r_{p.name})"), total), label=f"possible-{p.name}", kind=EquationKind.POSSIBLE)
        )
    return display(*lines)


def _moving_points(configuration: Configuration) -> list[MassPoint]:
    """The particles whose position contains t."""
    slots = configuration.slots
    return [p for p in configuration.points if not p.position.frozen_derivative(slots).is_zero]


def displacements_in_choice(elimination: Elimination, configuration: Configuration) -> list[Block]:
    """The constraints left in a choice, on virtual displacements, and the dependent δq; nothing without constraints."""
    if not configuration.rows:
        return []
    rows = (virtual_displacement(r, configuration.slots) for r in configuration.rows)
    lines = (Equation((row, sp.S.Zero)) for row in rows)
    lead = prose("In a virtual displacement", purpose=Purpose.VIRTUAL)
    return [lead, display(*lines), *solved_displacements(elimination, configuration)]


def solved_displacements(elimination: Elimination, configuration: Configuration) -> list[Block]:
    """The dependent δq, and where the solution is valid; nothing if the constraints state it already."""
    slots = configuration.slots
    solved = elimination.solved(slots)
    free = [math(variation(slots.coordinates[k])) for k in elimination.independent]
    blocks: list[Block] = []
    if solved and not all(_is_evident(row) for row in configuration.rows):
        long = any(count_operations(value) > LONGEST_DISPLACEMENT for value in solved.values())
        pivots = pivot_conditions(elimination)
        where: tuple[Part, ...] = (Phrase(", where ", Purpose.WHERE), *pivots, ",") if pivots else ()
        ending = plural(len(solved), " gives a long expression.", " gives long expressions.") if long else " gives"
        blocks.append(prose("Solving for ", *listed(math(d) for d in solved), *where, ending, purpose=Purpose.SOLVING))
        lines = (Equation((d, e)) for d, e in solved.items())
        blocks.append(display(*lines, detail=Detail.FULL if long else Detail.STEPS))
    if not free:
        return [*blocks, prose("No displacement remains free.", purpose=Purpose.FREE)]
    remain = plural(len(free), " remains free.", " remain free.")
    return [*blocks, prose(*listed(free), remain, purpose=Purpose.FREE)]


def _is_evident(row: Row) -> bool:
    """Whether the row alone states that a displacement is zero: δr = 0."""
    nonzero = [a for a in row.coefficients if a != 0]
    return len(nonzero) == 1 and nonzero[0].is_number


def pivot_conditions(elimination: Elimination) -> tuple[Part, ...]:
    """The pivots that must not vanish: `y ≠ 0 and x_1 ≠ x_2`."""
    return listed(math(*_apart(p), relation="≠") for p in elimination.pivots)


def _apart(pivot: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """x_1 and x_2 of x_1 − x_2; otherwise the pivot and 0."""
    first, second = pivot.args if isinstance(pivot, sp.Add) and len(pivot.args) == 2 else (pivot, pivot)
    plus, minus = (first, second) if first.is_Symbol else (second, first)
    return (plus, -minus) if plus.is_Symbol and (-minus).is_Symbol else (pivot, sp.S.Zero)


def of_points(
    configuration: Configuration, elimination: Elimination, label: str = "", *, at_once: bool = False
) -> list[Block]:
    """δr of each particle and δπ of each body, without the δq that are zero.

    label    sets apart a second display of them
    at_once  whether both are in one display
    """
    slots = configuration.slots
    zero = {d: value for d, value in elimination.solved(slots).items() if value == 0}
    suffix = suffix_of(configuration.name)
    lines = [
        Equation((VectorSymbol(f"delta(r_{p.name})"), displaced(p, slots).xreplace(zero)),
                 label=f"delta{label}{suffix}-{p.name}", kind=EquationKind.DELTA)
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
        words = f"The virtual displacements of the {whose} and of the points where forces act are"
        lines += elsewhere
    elif at_once and turned:
        rotations = [e for b in turned if isinstance(b, Display) for e in b.equations]
        whats = plural(len(lines), "The virtual displacement", "The virtual displacements")
        turns = plural(len(rotations), "the virtual rotation", "the virtual rotations")
        words = f"{whats} of the {whose} and, formed like the angular velocity with δ for d/dt, {turns} are"
        return [prose(words), display(*lines, *rotations)]
    return [prose(words), display(*lines), *turned]


def points_called(configuration: Configuration) -> str:
    """`particle`, `mass centres`, ..."""
    particles = len(configuration.particles)
    centres = sum(not configuration.is_pinned(p) for p in configuration.points) - particles
    massless = all(p.mass == 0 for p in configuration.particles)
    kind = "point" if massless else "particle"
    words = [plural(particles, kind, f"{kind}s")] * bool(particles)
    return " and ".join(words + [plural(centres, "mass centre", "mass centres")] * bool(centres))
