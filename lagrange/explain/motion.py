"""D'Alembert's principle, generalized coordinates, equations of motion."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from lagrange.core.symbols import Dot, VectorSymbol, variation
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
    paragraph,
    prose,
)
from lagrange.explain.bodies import laws, terms_of_bodies, terms_of_dampers
from lagrange.explain.displacements import of_points, solved_displacements
from lagrange.explain.words import plural, spoken
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates
from lagrange.mechanics.constraints.displacements import virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import DalembertMotion, EquationOfMotion, EquationsOfMotion, WithMultipliers
from lagrange.problem.model import Problem

ZERO = sp.S.Zero


def explain_principle(motion: DalembertMotion) -> Step:
    """The principle, the accelerations, and the principle written out."""
    body = [
        _multiplied(motion.configuration),
        display(Equation((_principle(motion.configuration), ZERO), label="principle")),
        *_accelerations(motion),
        prose("Written out, it reads"),
        display(Equation((motion.principle.statement, ZERO), label="written-out")),
    ]
    return Step(Rule.PRINCIPLE, "D'Alembert's principle", tuple(body))


def _multiplied(configuration: Configuration) -> Block:
    """How the principle follows from Newton's law."""
    if not configuration.rows:
        said = laws(configuration, ", multiplied")
        terms = len([p for p in configuration.points if not configuration.is_pinned(p)]) + len(configuration.rotations)
        one = " and added up, reads" if terms > 1 or not configuration.rotations else ", reads"
        ending = ", added up, read" if " and " in said else one
        return prose(f"There are no reactions. {said[0].upper()}{said[1:]}{ending}")
    return prose(
        f"Multiply {laws(configuration, ', inertia equal to applied force and reaction,')}, and add: the reactions "
        "drop out by ",
        Ref("virtual-work"),
        ", and d'Alembert's principle remains:",
    )


def _principle(configuration: Configuration) -> sp.Expr:
    """Σ (m r'' − F)·δr + Σ (dH/dt − M)·δπ, and δV where there is a potential."""
    terms = []
    for p in configuration.points:
        if configuration.is_pinned(p):
            continue
        acting = any(f.on == p.name and not f.elsewhere for f in configuration.loads)
        force = VectorSymbol(f"F_{p.name}") if acting else ZERO
        moved = VectorSymbol(f"delta(r_{p.name})")
        if p.mass != 0:
            terms.append(Dot(p.mass * VectorSymbol(f"r_{p.name}''") - force, moved))
        elif acting:
            terms.append(-Dot(force, moved))
    for load in configuration.loads:
        if load.elsewhere:
            terms.append(-Dot(VectorSymbol(f"F_{load.name}"), VectorSymbol(f"delta(r_{load.name})")))
    potential = variation(sp.Symbol("V", real=True)) if configuration.potential != 0 else ZERO
    return sp.Add(*terms, *terms_of_bodies(configuration), *terms_of_dampers(configuration), potential)


def _accelerations(motion: DalembertMotion) -> list[Block]:
    accelerations = motion.principle.accelerations
    suffix = suffix_of(motion.configuration)
    lines = [
        Equation((VectorSymbol(f"r_{name}''"), a), label=f"acceleration{suffix}-{name}")
        for name, a in accelerations.items()
    ]
    rates = [
        Equation((VectorSymbol(f"H_{name}'"), rate), label=f"momentum-rate{suffix}-{name}")
        for name, rate in motion.principle.momentum_rates.items()
    ]
    whats = [plural(len(lines), "the acceleration", "the accelerations")] * bool(lines)
    turning = plural(len(rates), "rate of change of the angular momentum", "rates of change of the angular momenta")
    whats += [f"the {turning}"] * bool(rates)
    if not whats:
        return []
    words = " and ".join(whats)
    verb = "is" if len(lines) + len(rates) == 1 else "are"
    return [prose(f"{words[0].upper()}{words[1:]} {verb}"), display(*lines, *rates)]


def suffix_of(configuration: Configuration) -> str:
    """What labels in a choice of coordinates end in."""
    return f"-{configuration.name}" if configuration.name else ""


def explain_equations(motion: DalembertMotion, problem: Problem, multiplied: WithMultipliers | None = None) -> Step:
    """The equations in the file's own coordinates; `multiplied`: also those with multipliers."""
    body: list[Block] = []
    if motion.configuration.rows:
        body += _with_the_solved(motion)
    body += _conclusion(motion)
    body += final_equations(motion, problem)
    body += _with_multipliers(motion, multiplied)
    title = plural(len(motion.equations), "Equation of motion", "Equations of motion")
    return Step(
        Rule.EQUATIONS_OF_MOTION,
        f"{title} in the given coordinates" if problem.choices else title,
        tuple(body),
    )


def _with_the_solved(motion: DalembertMotion) -> list[Block]:
    """The principle with the dependent displacements put in."""
    configuration = motion.configuration
    suffix = suffix_of(configuration)
    solved = [variation(configuration.slots.coordinates[d]) for d in motion.elimination.dependent]
    return [
        prose("With ", *listed(math(d) for d in solved), " put in, ", Ref(f"written-out{suffix}"), " becomes"),
        display(Equation((motion.reduced, ZERO), label=f"reduced{suffix}")),
    ]


def _conclusion(motion: EquationsOfMotion) -> list[Block]:
    """The independent δq are arbitrary, so each bracket vanishes; what is divided by."""
    slots = motion.configuration.slots
    free = [math(variation(slots.coordinates[k])) for k in motion.elimination.independent]
    if not free:
        return [prose("No displacement is free: the constraints alone determine the motion.")]
    arbitrary = (
        " is arbitrary, so what multiplies it vanishes"
        if len(free) == 1
        else " are independent, so what multiplies each of them vanishes"
    )
    clauses = scaling(motion.equations)
    return [prose(*listed(free), arbitrary, *((" (", *clauses, ")") if clauses else ()), ":")]


def scaling(equations: Sequence[EquationOfMotion]) -> tuple[Part, ...]:
    """`multiplying by x and dividing by m r, where r ≠ 0`."""
    multiplied = _distinct(e.factor.denominator.expression for e in equations)
    divided = _distinct(e.factor.numerator.expression for e in equations)
    excluded = _distinct(f for e in equations for f in e.factor.nonzero)
    clauses: list[tuple[Part, ...]] = []
    if multiplied:
        clauses.append(("multiplying by ", *listed(math(f) for f in multiplied)))
    if divided:
        clauses.append(("dividing by ", *listed(math(f) for f in divided)))
    if any(e.reversed for e in equations):
        clauses.append(("changing the sign",))
    words: list[Part] = []
    for n, clause in enumerate(clauses):
        words += [("" if n == 0 else " and " if n == len(clauses) - 1 else ", "), *clause]
    if excluded:
        words += [", where ", *listed(math(f, ZERO, relation="≠") for f in excluded)]
    return tuple(words)


def _distinct(factors: Iterable[sp.Expr]) -> list[sp.Expr]:
    return [f for f in dict.fromkeys(factors) if f != 1]


def final_equations(motion: EquationsOfMotion, problem: Problem) -> list[Block]:
    """The boxed equations, with the constraints that complete them."""
    configuration = motion.configuration
    suffix = suffix_of(configuration)
    lines = [Equation((e.expression, ZERO), label=f"motion{suffix}-{e.coordinate.name}") for e in motion.final]
    lines += [_constraint(configuration, r.name, problem) for r in motion.completing]
    return [*_put_in(motion), display(*lines, boxed=True, detail=Detail.BRIEF)]


def label_of(motion: EquationsOfMotion, equation: EquationOfMotion) -> str:
    """The label of an equation as it comes from the principle, before eliminated velocities are put in."""
    return f"{'open' if motion.closed else 'motion'}{suffix_of(motion.configuration)}-{equation.coordinate.name}"


def _put_in(motion: EquationsOfMotion) -> list[Block]:
    """The equations as they come from the principle, and the velocities and accelerations that are put into them."""
    if motion.closed is None:
        return []
    closed, name = motion.closed, motion.configuration.name
    before = [Equation((e.expression, ZERO), label=label_of(motion, e)) for e in motion.equations]
    rates = [Equation(pair) for pair in closed.rates.items()]
    refs = listed(Ref(f"rate-{name}-{n}") for n in closed.used)
    gives = plural(len(closed.used), " gives", " give")
    clauses = scaling(closed.equations)
    left = plural(len(before), "This leaves", "These leave")
    return [
        display(*before),
        prose(*refs, gives, ", solved for the velocities and differentiated,"),
        display(*rates),
        prose("Put in, ", f"{left[0].lower()}{left[1:]}", *((" (", *clauses, ")") if clauses else ()), ":"),
    ]


def _with_multipliers(motion: EquationsOfMotion, multiplied: WithMultipliers | None) -> list[Block]:
    """The equations with multipliers, in which no displacement is eliminated."""
    if multiplied is None:
        return []
    coordinates, suffix = motion.configuration.slots.coordinates, suffix_of(motion.configuration)
    dependent = listed(math(variation(coordinates[d])) for d in motion.elimination.dependent)
    symbols = listed(math(s) for s in multiplied.multipliers)
    one = len(multiplied.multipliers) == 1
    words: tuple[Part, ...] = (
        "With multipliers nothing is eliminated. ",
        "The constraint on the displacements, times a multiplier " if one else
        "The constraints on the displacements, times multipliers ",
        *symbols,
        ", is subtracted from " if one else ", are subtracted from ",
        Ref(f"written-out{suffix}"),
        ", the multiplier" if one else ", the multipliers",
        " so chosen that what multiplies ",
        *(() if len(motion.elimination.dependent) == 1 else ("each of ",)),
        *dependent,
        " vanishes. The other displacements are free, so that for every coordinate"
        if motion.elimination.independent else " vanishes:",
    )  # fmt: skip
    pairs = zip(coordinates, multiplied.equations, strict=True)
    lines = [Equation(sides, label=f"multiplied{suffix}-{q.name}") for q, sides in pairs]
    return [prose(*words), display(*lines)]


def _constraint(configuration: Configuration, name: str, problem: Problem) -> Equation:
    """A constraint that completes the equations, as the file has it where the coordinates are its own."""
    row = next(r for r in configuration.rows if r.name == name)
    if not configuration.expressed:
        constraint = next(c for c in problem.constraints if c.name == name)
        return Equation((constraint.lhs, constraint.rhs), label=f"with{suffix_of(configuration)}-{name}")
    shown = row.velocity_form(configuration.slots) if row.finite is None else row.finite
    return Equation((shown, ZERO), label=f"with{suffix_of(configuration)}-{name}")


def explain_choice(coordinates: GeneralizedCoordinates) -> Step:
    """The substitution, that it satisfies the constraints, that its coordinates are independent."""
    choice, configuration = coordinates.choice, coordinates.configuration
    noun = plural(len(choice.coordinates), "coordinate", "coordinates")
    chosen = listed(math(q) for q in choice.coordinates)
    body: list[Block] = [prose(f"As generalized {noun} take ", *chosen, ":" if configuration.expressed else ".")]
    if configuration.expressed:
        body.append(
            display(
                *(Equation((q, e), label=f"choice-{choice.name}-{q.name}") for q, e in configuration.expressed.items())
            )
        )
    sentences = []
    if coordinates.signs:
        signs = listed(math(s) for s in coordinates.signs)
        each = plural(len(coordinates.signs), " is +1 or −1", " are +1 or −1 each")
        branches = plural(
            len(coordinates.signs), "both branches of the square root", f"all {coordinates.branches} branches"
        )
        real = listed(math(r, ZERO, relation="≥") for r in coordinates.radicands)
        sentences.append(prose(*signs, f"{each}: {branches} are carried at once. They are real where ", *real, "."))
    if coordinates.satisfied:
        names = listed(spoken(n) for n in coordinates.satisfied)
        one, more = " is satisfied identically.", " are satisfied identically."
        sentences.append(prose("The constraint " if len(coordinates.satisfied) == 1 else "The constraints ", *names,
                               plural(len(coordinates.satisfied), one, more)))  # fmt: skip
    if len(choice.coordinates) > 1:
        words = " are independent: the derivatives of the old coordinates by them are linearly independent."
        sentences.append(prose(*chosen, words))
    if sentences:
        body.append(paragraph(*sentences))
    body += _remaining(coordinates)
    return Step(Rule.GENERALIZED_COORDINATES, f"Generalized {noun}: {spoken(choice.name)}", tuple(body))


def _remaining(coordinates: GeneralizedCoordinates) -> list[Block]:
    """The constraints that the choice does not satisfy by itself."""
    configuration, name = coordinates.configuration, coordinates.choice.name
    found: list[Block] = []
    if configuration.rows:
        names = listed(spoken(r.name) for r in configuration.rows)
        verb = plural(len(configuration.rows), "remains, and reads", "remain, and read")
        lines = (
            Equation((r.velocity_form(configuration.slots), ZERO), label=f"rate-{name}-{r.name}")
            for r in configuration.rows
        )
        found += [prose("Of the constraints, ", *names, f" {verb}"), display(*lines)]
    if coordinates.through_rates:
        names = listed(math(q) for q in coordinates.through_rates)
        verb = plural(len(coordinates.through_rates), "is", "are")
        found.append(prose(*names, f" {verb} eliminated through the velocities."))
    return found


def explain_motion_in_choice(
    coordinates: GeneralizedCoordinates,
    motion: DalembertMotion,
    problem: Problem,
    multiplied: WithMultipliers | None = None,
) -> Step:
    """The principle and the equations in a choice of coordinates."""
    configuration = motion.configuration
    name = coordinates.choice.name
    body: list[Block] = []
    if configuration.rows:
        rows = (virtual_displacement(r, configuration.slots) for r in configuration.rows)
        body += [prose("In a virtual displacement"), display(*(Equation((row, ZERO)) for row in rows))]
        body += solved_displacements(motion.elimination, configuration)
    body += [
        *_accelerations(motion),
        *of_points(configuration, motion.elimination),
        prose("and d'Alembert's principle ", Ref("principle"), " reads"),
        display(Equation((motion.principle.statement, ZERO), label=f"written-out-{name}")),
    ]
    if configuration.rows:
        body += _with_the_solved(motion)
    body += _conclusion(motion)
    body += final_equations(motion, problem)
    body += _with_multipliers(motion, multiplied)
    title = plural(len(motion.equations), "Equation of motion", "Equations of motion")
    return Step(Rule.EQUATIONS_OF_MOTION, f"{title}: {spoken(name)}", tuple(body))
