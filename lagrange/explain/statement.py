"""The statement: description, symbols, positions, applied forces and moments.

Notes on a problem that can be solved but may not be what was meant.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

import sympy as sp

from lagrange.core.diagnostics import Diagnostic
from lagrange.core.symbols import Partial, TimeDerivative, Unspecified, VectorSymbol, prime, t
from lagrange.core.vectors import UNITS, Vector
from lagrange.document.derivation import (
    Block,
    Equation,
    EquationKind,
    Part,
    Prose,
    Purpose,
    Rule,
    Step,
    Table,
    display,
    listed,
    math,
    paragraph,
    prose,
    series,
)
from lagrange.explain.bodies import (
    explain_exchanged_mass,
    explain_links,
    explain_rotation,
    moments_on,
    triads_of_bodies,
    turns_about_axis,
    unit_vectors,
)
from lagrange.explain.page.texts import set_text
from lagrange.explain.words import (
    are,
    capital,
    constraints_called,
    friction_called,
    introduced,
    load_called,
    plural,
    the,
)
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.dynamics.principle import written_forces
from lagrange.mechanics.energy_symbols import lagrangian_letter
from lagrange.mechanics.results import Solution
from lagrange.problem.keys import Assumption, Find
from lagrange.problem.model import Body, Coordinate, Friction, Parameter, Problem

_ADJECTIVES = ("horizontal", "vertical")
"""Words for an axis that do not say which way it points."""

_WEIGHT = re.compile(r"weight(?:_?\d+)?")
"""Of several bodies the file may number them."""


def explain_statement(problem: Problem, configuration: Configuration, with_potential: bool = True) -> Step:
    """Description, symbols, positions, applied forces.

    with_potential  whether the potential energy of fields and springs is stated here, rather than later with T
    """
    body: list[Block] = []
    if problem.description:
        body.append(prose(*set_text(problem.description, problem)))
    if problem.axes:
        axes = (
            (math(UNITS[name]), f" {'is' if word in _ADJECTIVES else 'points'} {word}")
            for name, word in problem.axes.items()
        )
        body.append(prose(*series(axes), "."))
    body += _symbols(problem)
    body += _sought(problem, configuration)
    body += _functions(problem)
    body += _frame(problem)
    body += triads_of_bodies(problem, configuration)
    body += _abbreviations(problem)
    body += _positions(problem, configuration)
    body += _forces(problem, configuration, with_potential)
    return Step(Rule.STATEMENT, "The system", tuple(body))


def _symbols(problem: Problem) -> list[Block]:
    """A table of the symbols if the file gives their meanings, otherwise sentences."""
    groups: list[Sequence[Coordinate | Parameter]] = [problem.coordinates, problem.parameters]
    explained = [any(x.meaning or x.unit for x in group) for group in groups]
    blocks: list[Block] = [*_listed("coordinate", problem.coordinates)] if not explained[0] else []
    assumed = _assumptions(problem)
    if not explained[1] and any(p.range is None for p in problem.parameters):
        blocks, assumed = [*blocks, *_listed_with_assumptions(problem)], []
    elif not explained[1]:
        blocks += _listed("parameter", problem.parameters)
    rows = [x for group, has_meanings in zip(groups, explained, strict=True) if has_meanings for x in group]
    if rows:
        with_units = any(x.unit for x in rows)
        header: tuple[Part, ...] = ("symbol", "meaning", "unit") if with_units else ("symbol", "meaning")
        cells: list[tuple[Part, ...]] = []
        for x in rows:
            kind = "parameter" if isinstance(x, Parameter) else "coordinate"
            row: tuple[Part, ...] = (math(x.symbol), x.meaning or kind)
            cells.append((*row, raised(x.unit)) if with_units else row)
        blocks.append(Table(header, tuple(cells)))
    return [*blocks, *assumed]


def _listed(what: str, members: Sequence[Coordinate | Parameter]) -> list[Block]:
    """`The coordinates are x and y.`"""
    if not members:
        return []
    words = plural(len(members), f"The {what} is ", f"The {what}s are ")
    return [prose(words, *listed(math(x.symbol) for x in members), ".")]


def _listed_with_assumptions(problem: Problem) -> list[Block]:
    """`The parameters m and g are positive; α is acute.`"""
    free = [p for p in problem.parameters if p.range is None]
    words = plural(len(free), "The parameter ", "The parameters ")
    ranges = ranges_of(problem)
    return [prose(words, *_by_kind(free), "; " if ranges else "", *ranges, ".")]


_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def raised(unit: str) -> str:
    """A unit as it is printed: m/s^2 is m/s²."""
    return re.sub(r"\^(-?\d+)", lambda match: match[1].translate(_SUPERSCRIPTS), unit)


_ASSUMED = {
    Assumption.POSITIVE: "positive",
    Assumption.NONNEGATIVE: "positive or zero",
    Assumption.REAL: "of either sign or zero",
    Assumption.SIGN: "+1 or −1",
    Assumption.ACUTE: "acute",
}


def _assumptions(problem: Problem) -> list[Block]:
    free = [p for p in problem.parameters if p.range is None]
    kinds = {p.assume for p in free}
    clauses, ranges = _of_kinds(problem, free, kinds), ranges_of(problem)
    return [prose(*clauses, "; " if clauses and ranges else "", *ranges, ".")] if clauses or ranges else []


def ranges_of(problem: Problem) -> list[Part]:
    """`−π/2 ≤ θ ≤ π/2`, for each parameter and coordinate with a range."""
    ranges = [(p.symbol, p.range) for p in problem.parameters] + [(q.symbol, q.range) for q in problem.coordinates]
    return [*listed(math(r.low, symbol, r.high, relation="≤") for symbol, r in ranges if r is not None)]


def _of_kinds(problem: Problem, free: Sequence[Parameter], kinds: set[Assumption]) -> list[Part]:
    """What is assumed of the parameters without a range."""
    if not kinds:
        return []
    if kinds == {Assumption.POSITIVE}:
        if len(free) == 1:
            return [] if len(problem.parameters) == 1 else [math(free[0].symbol), " is positive"]
        every = "All parameters are" if len(free) == len(problem.parameters) else "All other parameters are"
        return [f"{every} positive"]
    return _by_kind(free)


def _by_kind(free: Sequence[Parameter]) -> list[Part]:
    """`m and g are positive; α is acute`"""
    clauses: list[Part] = []
    for kind in Assumption:
        members = [p.symbol for p in free if p.assume is kind]
        if members:
            clauses += ["; " if clauses else "", *listed(math(s) for s in members), are(members), _ASSUMED[kind]]
    return clauses


def _sought(problem: Problem, configuration: Configuration) -> list[Block]:
    """`The forces P and Q are to be found.`"""
    if not problem.unknowns:
        return []
    forces = {u for u in problem.unknowns if any(_is_size_in(u, f.vector) for f in configuration.loads)}
    moments = {u for u in problem.unknowns if any(_is_size_in(u, f.vector) for f in configuration.torques)}
    kinds = ["force" if u in forces else "moment" if u in moments else "" for u in problem.unknowns]
    same = kinds[0] if len({*kinds}) == 1 else ""
    named = [
        (math(u),) if same or not kind else (f"the {kind} ", math(u))
        for u, kind in zip(problem.unknowns, kinds, strict=True)
    ]
    several = plural(len(named), "", "s")
    opening = (f"The {same}{several} ",) if same else ()
    first, *others = series(named)
    words = (*opening, first, *others) if same or not isinstance(first, str) else (capital(first), *others)
    return [prose(*words, plural(len(named), " is", " are"), " to be found.")]


def _is_size_in(u: sp.Symbol, v: Vector) -> bool:
    """Whether it is a force or a moment itself, times numbers and directions, and not P in a moment l P."""
    factors = [c.coeff(u) for c in v.components if c.has(u)]
    angles = {s for c in factors for f in c.atoms(sp.sin, sp.cos) for s in f.free_symbols}
    return bool(factors) and all(c != 0 and c.free_symbols <= angles for c in factors)


def _functions(problem: Problem) -> list[Block]:
    """The prescribed motions; the undefined functions, those of the same arguments together."""
    blocks: list[Prose] = []
    prescribed = problem.slots.prescribed
    if prescribed:
        words = plural(len(prescribed), " is a prescribed function of time.", " are prescribed functions of time.")
        blocks.append(prose(*listed(math(u) for u in prescribed), words))
    for arguments in dict.fromkeys(f.arguments for f in problem.functions):
        members = [f.name for f in problem.functions if f.arguments == arguments]
        words = plural(len(members), " is an unspecified function of ", " are unspecified functions of ")
        values = _at_which(problem, members, arguments)
        where = ("; here ", *listed(math(sp.Symbol(n), e) for n, e in values)) if values else ()
        blocks.append(prose(*_names(members), words, *_names(arguments), *where, "."))
    return [paragraph(*blocks)] if blocks else []


def _at_which(problem: Problem, members: Sequence[str], names: Sequence[str]) -> list[tuple[str, sp.Expr]]:
    """X = x - u t, Y = y: what the arguments are in the constraints, if they are the same everywhere."""
    used = {f.args[3:] for c in problem.constraints for f in c.function.atoms(Unspecified) if f.name in members}
    values = [*zip(names, next(iter(used)), strict=True)] if len(used) == 1 else []
    return values if any(n.lower() != str(e).lower() for n, e in values) else []


def _names(names: Iterable[str]) -> tuple[Part, ...]:
    return listed(math(sp.Symbol(n)) for n in names)


def _abbreviations(problem: Problem) -> list[Block]:
    """The abbreviations of the file: unit vectors, angular velocities."""
    if not problem.abbreviations:
        return []
    lines = (
        Equation((VectorSymbol(name) if isinstance(value, Vector) else sp.Symbol(name), value))
        for name, value in problem.abbreviations.items()
    )
    return [prose("For brevity, write", purpose=Purpose.DEFINITIONS), display(*lines)]


def _frame(problem: Problem) -> list[Block]:
    """The unit vectors that turn."""
    blocks: list[Block] = []
    triad = problem.frame
    if triad is not None and triad.directions is not None:
        blocks.append(prose("The unit vectors of the frame turn with the coordinates:"))
        blocks.append(
            display(
                *(Equation((unit, v)) for unit, v in unit_vectors(triad) if any(c.free_symbols for c in v.components))
            )
        )
    return blocks


def _body(configuration: Configuration, centre: MassPoint, bodies: Mapping[str, Body]) -> Block:
    """Its mass, and where its mass centre is."""
    called = introduced(centre.name)
    if configuration.is_pinned(centre):
        mass: tuple[Part, ...] = (" of mass ", math(centre.mass)) if centre.mass != 0 else ()
        if turns_about_axis(bodies, configuration, centre.name):
            return prose(f"{capital(called)} is a rigid body that turns about a fixed axis through")
        if centre.mass == 0:
            return prose(f"{capital(called)}, a rigid body, is held at")
        return prose(f"The mass centre of {called}, a rigid body", *mass, ", stays at")
    weighed = any(f.on == centre.name and f.name == "weight" for f in configuration.loads)
    if centre.mass == 0:
        return prose(f"{capital(called)} is rigid{'' if weighed else ' and has no mass'}. Its position is")
    return prose(f"{capital(called)} is rigid and has the mass ", math(centre.mass),
                 ". The position of its mass centre is")  # fmt: skip


def _positions(problem: Problem, configuration: Configuration) -> list[Block]:
    """The positions. That a point has no mass is mentioned only where others have some."""
    blocks: list[Block] = []
    massless = ", a massless point," if any(p.mass != 0 for p in configuration.points) else ""
    bodies = {b.name: b for b in problem.bodies}
    turning = {r.name: r for r in configuration.rotations}
    for p in configuration.points:
        what: tuple[Part, ...] = (", of mass ", math(p.mass), ",") if p.mass != 0 else (massless,)
        position = Equation(
            (VectorSymbol(f"r_{p.name}"), p.position), label=f"position-{p.name}", kind=EquationKind.POSITION
        )
        if p.name in bodies:
            blocks.append(_body(configuration, p, bodies))
            hinged = turns_about_axis(bodies, configuration, p.name)
            rotating = explain_rotation(bodies[p.name], turning[p.name], hinged=hinged)
            first = rotating[0]
            if hinged and p.position.is_zero and isinstance(first, Prose):
                words = prose(f"{capital(introduced(p.name))} is a rigid body that turns about a fixed axis through O.")
                blocks[-1:] = [paragraph(words, first), *rotating[1:]]
            else:
                blocks += [display(position), *rotating]
        else:
            blocks += [prose(f"The position of {introduced(p.name)}", *what, " is"), display(position)]
    return [*blocks, *explain_exchanged_mass(configuration)]


def _forces(problem: Problem, configuration: Configuration, with_potential: bool) -> list[Block]:
    blocks: list[Block] = []
    rough = {f.name: f.constraints for f in problem.forces if isinstance(f, Friction)}
    said: set[str] = set()
    slots = problem.slots
    known = {*slots.coordinates, *slots.velocities, *(p.symbol for p in problem.parameters), *problem.unknowns, t}
    for p in configuration.points:
        loads = [f for f in configuration.loads if f.on == p.name and not f.elsewhere]
        if not loads:
            continue
        here = [f.name for f in loads if f.name in rough]
        names = [friction_called(f.name, here) if f.name in rough else force_called(f.name) for f in loads]
        total = sum((f.vector for f in loads), Vector.zero(p.position.triad))
        shown = total.along(p.position.triad)
        sides = (VectorSymbol(f"F_{p.name}"), total, shown) if shown != total else (VectorSymbol(f"F_{p.name}"), total)
        applied = plural(len(loads), "The force applied to", "The forces applied to")
        blocks += [
            prose(f"{applied} {the(p.name)}{are(loads)}", *listed(names), ":"),
            display(Equation(sides, label=f"force-{p.name}", kind=EquationKind.FORCE)),
        ]
        unknown = dict.fromkeys(c for f in loads for c in rough.get(f.name, ()))
        if unknown and not unknown.keys() <= said:
            said |= unknown.keys()
            inside = {s for component in total.fixed().components for s in component.free_symbols}
            forces = sorted((s for s in inside - known if not s.name.startswith("lambda_")), key=str)
            named = [math(s) for s in forces] if len(forces) == len(unknown) else []
            what = plural(len(unknown), "the reaction of ", "the reactions of ") + constraints_called(unknown)
            with_names = (*listed(named), ", ") if named else ()
            words = (*with_names, f"{what}, found below.")
            blocks.append(prose("The friction contains ", *words, purpose=Purpose.FRICTION_INSIDE))
    for f in configuration.loads:
        if f.elsewhere:
            lines = (
                Equation((VectorSymbol(f"F_{f.name}"), f.vector)),
                Equation((VectorSymbol(f"r_{f.name}"), f.point)),
            )
            called = capital(load_called(f.name))
            blocks += [prose(f"{called} on {the(f.on)} and its point of application are"), display(*lines)]
    blocks += moments_on(configuration, rough)
    blocks += explain_links(configuration)
    blocks += _beside_energies(problem, configuration)
    if configuration.potential != 0 and with_potential and not configuration.is_outright:
        blocks += [
            prose("The potential energy is"),
            display(Equation((configuration.potential_letter, configuration.potential), label="potential")),
        ]
    return blocks


def _beside_energies(problem: Problem, configuration: Configuration) -> list[Block]:
    """A given Lagrangian; potentials with velocities and generalized forces, with the Q_k that they amount to."""
    X = configuration.velocity_part
    if configuration.is_outright:
        L = lagrangian_letter(problem.scope.names())
        given = Equation((L, X - configuration.potential), label="given-lagrangian")
        return [prose("The Lagrangian is given:"), display(given)]
    forces = written_forces(configuration)
    pairs = zip(configuration.slots.coordinates, forces, strict=False)
    lines = [Equation((given_force(q), f), label=f"given-{q.name}") for q, f in pairs if f != 0]
    if not lines:
        return []
    words: Prose = prose(plural(len(lines), "A generalized force is given", "Generalized forces are given"))
    blocks: list[Block] = []
    if X != 0:
        U = Equation((sp.Symbol("U", real=True), configuration.velocity_potential), label="velocity-potential")
        blocks = [prose("The forces that depend on velocities derive from the potential"), display(U)]
        also = ", beside those that are given" if configuration.generalized else ""
        q = configuration.slots.coordinates[0]
        letter = U.sides[0]
        force = sp.Add(TimeDerivative(Partial(letter, prime(q))), -Partial(letter, q), evaluate=False)
        words = prose("It gives each coordinate a generalized force, ", math(force), " for ", math(q), also, ":")
    return [*blocks, words, display(*lines)]


def given_force(coordinate: sp.Symbol) -> sp.Symbol:
    """Q_x, a generalized force that is given, or comes from a potential that depends on velocities."""
    return sp.Symbol(f"Q_{coordinate.name}", real=True)


def force_called(name: str) -> str:
    """`its weight`, `the push`, `the wind force`."""
    return "its weight" if _WEIGHT.fullmatch(name) else load_called(name)


# Remarks


def remarks(solution: Solution, method: Method) -> tuple[Diagnostic, ...]:
    """Notes on angles and friction, and if a method was chosen but no equations of motion are asked for."""
    problem = solution.problem
    configuration = solution.own.configuration
    found = (*_below_kinetic(problem), *_in_radians(problem, configuration), *_open_senses(problem, configuration))
    if method is Method.DALEMBERT or Find.MOTION in problem.find:
        return found
    message = f"`--method {method}` makes no difference here: no equations of motion are asked for"
    help_ = "equilibrium is found by the principle of virtual work; `find: motion` asks for equations of motion"
    return (*found, Diagnostic("method-without-motion", message, help=help_).as_note())


def _below_kinetic(problem: Problem) -> Iterator[Diagnostic]:
    """A note on each static friction coefficient below the kinetic one, if the file gives their values."""
    values = problem.given_values
    for f in problem.forces:
        if not isinstance(f, Friction) or f.static is None:
            continue
        if (f.coefficient - f.static).xreplace(values).is_positive:
            message = f"the friction `{f.name}` is smaller at rest than in motion"
            help_ = "`static:` is usually the larger coefficient; have the two been exchanged?"
            yield Diagnostic("static-below-kinetic", message, f.span, help=help_).as_note()


def _open_senses(problem: Problem, configuration: Configuration) -> Iterator[Diagnostic]:
    """A note on each spring along a line whose direction the file leaves undetermined."""
    spans = {f.name: f.span for f in problem.forces}
    for s in configuration.springs:
        if s.distance.has(sp.Abs) and s.length != 0:
            message = f"the spring `{s.name}` may lie on either side of its first end, so the equations contain sgn"
            help_ = "`sense: positive` (or `negative`) says on which side of the first end the second one is"
            yield Diagnostic("spring-sense", message, spans[s.name], help=help_).as_note()


def _in_radians(problem: Problem, configuration: Configuration) -> Iterator[Diagnostic]:
    """A note on each bare number above 2π that occurs only in sines and cosines: probably meant as degrees."""
    large = [p for p in problem.parameters if p.value is not None and not p.measured and abs(p.value) > 2 * sp.pi]
    if not large:
        return
    vectors = [p.position for p in configuration.points] + [f.vector for f in configuration.loads]
    written = [c for v in vectors for c in v.fixed().components]
    written += [e for r in configuration.rows for e in (*r.coefficients, r.finite) if e is not None]
    arguments = {w for e in written for w in e.atoms(sp.sin, sp.cos, sp.tan)}
    outside = {s for e in written for s in e.xreplace({w: sp.Dummy() for w in arguments}).free_symbols}
    for p in large:
        if p.symbol not in outside and any(w.args[0] == p.symbol for w in arguments):
            message = f"the angle `{p.symbol.name}` is {p.value} radians: an angle without a unit is in radians"
            help_ = f"if degrees are meant, write `{p.symbol.name}: {p.value} deg`"
            yield Diagnostic("angle-in-radians", message, p.value_span, help=help_).as_note()
