"""D'Alembert's principle, generalized coordinates, equations of motion; in full detail their matrix form."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import DotProduct, VectorSymbol, variation
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    EquationKind,
    Matrices,
    Part,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    paragraph,
    prose,
    series,
)
from lagrange.explain.bodies import any_moving, law_times_displacement, terms_of_bodies, terms_of_dampers
from lagrange.explain.displacements import displacements_in_choice, of_points
from lagrange.explain.limits import LONGEST_ACCELERATIONS, LONGEST_VARIATION
from lagrange.explain.statement import given_force
from lagrange.explain.words import (
    are,
    capital,
    constraints_called,
    in_brackets,
    must_vanish,
    plural,
    substituting,
    suffix_of,
    title_in,
)
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import (
    DalembertMotion,
    EquationOfMotion,
    EquationsOfMotion,
    WithEliminatedRates,
    WithMultipliers,
)
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.dynamics.principle import given_forces
from lagrange.problem.model import Problem

ZERO = sp.S.Zero
"""Before the principle in coordinates."""


def explain_principle(motion: DalembertMotion) -> Step:
    """The principle, the accelerations, and the principle written out."""
    body = [
        _multiplied(motion.configuration),
        display(Equation((_principle(motion.configuration), ZERO), label="principle")),
        *accelerations_of(motion),
        prose("Written out, it reads", purpose=Purpose.WRITTEN_OUT),
        display(Equation((motion.principle.statement, ZERO), label="written-out")),
    ]
    return Step(Rule.PRINCIPLE, "D'Alembert's principle", tuple(body))


def _multiplied(configuration: Configuration) -> Block:
    """How the principle follows from Newton's law."""
    given = _potential_work(configuration)
    if not configuration.rows:
        first, *laws = law_times_displacement(configuration, ", multiplied")
        terms = len([p for p in configuration.points if not configuration.is_pinned(p)]) + len(configuration.rotations)
        one = " and summed, reads" if terms > 1 else ", reads"
        ending = ", summed, read" if len(configuration.rotations) and any_moving(configuration) else one
        return prose(_no_reactions(configuration), *(given or (" ",)), capital(str(first)), *laws, ending)
    terms = len([p for p in configuration.points if not configuration.is_pinned(p)]) + len(configuration.rotations)
    add = ", and add" if terms > 1 else ""
    drop = plural(len(configuration.rows), "the reaction drops", "the reactions drop")
    multiplied = law_times_displacement(configuration, "")
    dropped = (f"{add}: {drop} out by ", Ref("virtual-work"), ", and d'Alembert's principle remains:")
    return prose(*given[1:], "Multiply ", *multiplied, *dropped)


def _potential_work(configuration: Configuration) -> tuple[Part, ...]:
    """`The forces with the potential V do the virtual work −δV, where δV = c (r − l) δr.`"""
    if configuration.potential == 0:
        return ()
    potential, changed = configuration.potential_letter, configuration.potential_variation
    short = changed != 0 and count_operations(changed) <= LONGEST_VARIATION
    what = (", where ", math(variation(potential), changed)) if short else ()
    work = math(-variation(potential))
    return (" ", "The forces with the potential ", math(potential), " do the virtual work ", work, *what, ". ")


def _no_reactions(configuration: Configuration) -> str:
    """Why no reaction appears where no constraint is left."""
    if not configuration.satisfies_constraints_itself:
        return "Nothing constrains the motion, so there are no reactions."
    return (
        "The coordinates satisfy the constraints by themselves: the reactions that maintain these do no virtual work, "
        "and drop out."
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
            terms.append(DotProduct(p.mass * VectorSymbol(f"r_{p.name}''") - force, moved))
        elif acting:
            terms.append(-DotProduct(force, moved))
    for load in configuration.loads:
        if load.elsewhere:
            terms.append(-DotProduct(VectorSymbol(f"F_{load.name}"), VectorSymbol(f"delta(r_{load.name})")))
    potential = variation(configuration.potential_letter) if configuration.potential != 0 else ZERO
    coordinates = configuration.slots.coordinates
    given = zip(coordinates, given_forces(configuration), strict=False)
    terms += [-given_force(q) * variation(q) for q, f in given if f != 0]
    return sp.Add(*terms, *terms_of_bodies(configuration), *terms_of_dampers(configuration), potential)


def accelerations_of(motion: DalembertMotion) -> list[Block]:
    """The accelerations of the points and the rates of change of the angular momenta, as the principle uses them."""
    accelerations = motion.principle.accelerations
    suffix = suffix_of(motion.configuration.name)
    lines = [
        Equation((VectorSymbol(f"r_{name}''"), a), label=f"acceleration{suffix}-{name}", kind=EquationKind.ACCELERATION)
        for name, a in accelerations.items()
    ]
    rates = [
        Equation(
            (VectorSymbol(f"H_{name}'"), rate),
            label=f"momentum-rate{suffix}-{name}",
            kind=EquationKind.MOMENTUM_RATE,
            about=name,
        )
        for name, rate in motion.principle.momentum_rates.items()
    ]
    whats = [plural(len(lines), "the acceleration", "the accelerations")] * bool(lines)
    turning = plural(len(rates), "rate of change of the angular momentum", "rates of change of the angular momenta")
    whats += [f"the {turning}"] * bool(rates)
    if not whats:
        return []
    subject = Phrase(capital(" and ".join(whats)), Purpose.SUBJECT, ", ".join(whats))
    verb = " is" if len(lines) + len(rates) == 1 else " are"
    return [prose(subject, verb, purpose=Purpose.KINEMATICS), display(*lines, *rates)]


def explain_equations(motion: DalembertMotion, problem: Problem, multiplied: WithMultipliers | None = None) -> Step:
    """The equations in the file's own coordinates; `multiplied`: also those with multipliers."""
    body = [*_derived(motion, problem), *_with_multipliers(motion, multiplied)]
    return Step(Rule.EQUATIONS_OF_MOTION, title_of_equations(motion, problem), tuple(body))


def title_of_equations(motion: EquationsOfMotion, problem: Problem) -> str:
    """The title of the equations of motion in a choice, or in the file's own coordinates."""
    title, choice = (
        plural(len(motion.equations), "Equation of motion", "Equations of motion"),
        motion.configuration.name,
    )
    return f"{title} in the given coordinates" if problem.choices and not choice else title_in(title, choice)


def _derived(motion: DalembertMotion, problem: Problem) -> list[Block]:
    """From the principle, as written out, to the equations: the dependent δq substituted, the free δq arbitrary."""
    coordinates, suffix = motion.configuration.slots.coordinates, suffix_of(motion.configuration.name)
    body: list[Block] = []
    if motion.configuration.rows:
        solved = [math(variation(coordinates[d])) for d in motion.elimination.dependent]
        if motion.closed is not None and motion.closed.at_once:
            body.append(_at_once(motion, motion.closed, solved))
        else:
            body.append(substituting(solved, Ref(f"written-out{suffix}")))
            body.append(display(Equation((motion.reduced, ZERO), label=f"reduced{suffix}", kind=EquationKind.REDUCED)))
    free = [math(variation(coordinates[k])) for k in motion.elimination.independent]
    if free:
        at_once = motion.closed is not None and motion.closed.at_once
        body.append(must_vanish(free, scaling(motion.final if at_once else motion.equations)))
    else:
        body.append(prose("No displacement is free: the constraints alone determine the motion."))
    return [*body, *final_equations(motion, problem)]


def _at_once(motion: DalembertMotion, closed: WithEliminatedRates, displacements: Sequence[Part]) -> Prose:
    """`Substitute for δψ in (22); by (17), ψ̇ = ṡ/R and ψ̈ = s̈/R.`"""
    refs = listed(Ref(f"rate-{motion.configuration.name}-{n}") for n in closed.used)
    rates = listed(math(*pair) for pair in closed.rates.items())
    written = Ref(f"written-out{suffix_of(motion.configuration.name)}")
    return prose("Substitute for ", *listed(displacements), " in ", written, "; by ", *refs, ", ", *rates, ".")


def scaling(equations: Sequence[EquationOfMotion]) -> tuple[Part, ...]:
    """`multiplying by x and dividing by m r, where r ≠ 0`."""
    multiplied = _distinct(e.factor.denominator.expression for e in equations)
    divided = _distinct(e.factor.numerator.expression for e in equations)
    excluded = _distinct(f for e in equations for f in e.factor.nonzero)
    clauses: list[tuple[Part, ...]] = []
    factors = {(e.factor.denominator.expression, e.factor.numerator.expression) for e in equations}
    if len(factors) > 1:  # no factor is that of every equation
        taken = _distinct(e.factor.numerator.expression / e.factor.denominator.expression for e in equations)
        clauses.append((f"without the {plural(len(taken), 'factor', 'factors')} ", *listed(math(f) for f in taken)))
        multiplied, divided = [], []
    if multiplied:
        clauses.append(("multiplying by ", *listed(math(f) for f in multiplied)))
    if divided:
        clauses.append(("dividing by ", *listed(math(f) for f in divided)))
    if any(e.reversed for e in equations):
        clauses.append(("reversing the sign",))
    where: tuple[Part, ...] = (", where ", *listed(math(f, ZERO, relation="≠") for f in excluded)) if excluded else ()
    return (*series(clauses), *where)


def _distinct(factors: Iterable[sp.Expr]) -> list[sp.Expr]:
    return [f for f in dict.fromkeys(factors) if f != 1]


def final_equations(motion: EquationsOfMotion, problem: Problem) -> list[Block]:
    """The boxed equations, with the constraints that complete them."""
    configuration = motion.configuration
    suffix = suffix_of(configuration.name)
    lines = [
        Equation(e.sides, label=f"motion{suffix}-{e.coordinate.name}", kind=EquationKind.MOTION) for e in motion.final
    ]
    lines += [_constraint(configuration, r.name, problem) for r in motion.completing]
    return [*_substituted_rates(motion), display(*lines, boxed=True, detail=Detail.BRIEF)]


def label_from_principle(motion: EquationsOfMotion, equation: EquationOfMotion) -> str:
    """The label of an equation as it comes from the principle, before eliminated velocities are substituted."""
    is_open = motion.closed is not None and not motion.closed.at_once
    return f"{'open' if is_open else 'motion'}{suffix_of(motion.configuration.name)}-{equation.coordinate.name}"


def _substituted_rates(motion: EquationsOfMotion) -> list[Block]:
    """The equations as they come from the principle, and the velocities and accelerations to substitute in them."""
    if motion.closed is None or motion.closed.at_once:
        return []
    closed, name = motion.closed, motion.configuration.name
    before = [Equation((e.expression, ZERO), label=label_from_principle(motion, e)) for e in motion.equations]
    rates = [Equation(pair) for pair in closed.rates.items()]
    refs = listed(Ref(f"rate-{name}-{n}") for n in closed.used)
    return [
        display(*before),
        prose("Solving ", *refs, " for the velocities, and differentiating, gives", purpose=Purpose.RATES),
        display(*rates),
        prose("Substituting these leaves", *in_brackets(scaling(closed.equations)), ":"),
    ]


def _with_multipliers(motion: EquationsOfMotion, multiplied: WithMultipliers | None) -> list[Block]:
    """The equations with multipliers, in which no displacement is eliminated."""
    if multiplied is None:
        return []
    coordinates, suffix = motion.configuration.slots.coordinates, suffix_of(motion.configuration.name)
    dependent = listed(math(variation(coordinates[d])) for d in motion.elimination.dependent)
    symbols = listed(math(s) for s in multiplied.multipliers)
    one = len(multiplied.multipliers) == 1
    words: tuple[Part, ...] = (
        "With multipliers instead, nothing is eliminated. The ",
        "constraint on the displacements, times a multiplier " if one else
        "constraints on the displacements, times multipliers ",
        *symbols, Phrase(", is" if one else ", are", Purpose.VERB), " subtracted from ", Ref(f"written-out{suffix}"),
        ", the multiplier being chosen so that the " if one else ", the multipliers being chosen so that the ",
        plural(len(motion.elimination.dependent), "coefficient of ", "coefficients of "), *dependent,
        plural(len(motion.elimination.dependent), " vanishes", " vanish"),
        Phrase(". The other displacements are free, so for every coordinate", Purpose.EVERY_COORDINATE)
        if motion.elimination.independent else ":",
    )  # fmt: skip
    pairs = zip(coordinates, multiplied.equations, strict=True)
    lines = [Equation(sides, label=f"multiplied{suffix}-{q.name}") for q, sides in pairs]
    return [prose(*words, purpose=Purpose.MULTIPLIERS), display(*lines)]


def _constraint(configuration: Configuration, name: str, problem: Problem) -> Equation:
    """A constraint that completes the equations, as the file has it where the coordinates are its own."""
    row = next(r for r in configuration.rows if r.name == name)
    if not configuration.expressed:
        constraint = next(c for c in problem.constraints if c.name == name)
        return Equation(
            (constraint.lhs, constraint.rhs),
            label=f"with{suffix_of(configuration.name)}-{name}",
            kind=EquationKind.COMPLETING,
        )
    shown = row.velocity_form(configuration.slots) if row.finite is None else row.finite
    return Equation((shown, ZERO), label=f"with{suffix_of(configuration.name)}-{name}", kind=EquationKind.COMPLETING)


def explain_choice(coordinates: GeneralizedCoordinates) -> Step:
    """The substitution, that it satisfies the constraints, that its coordinates are independent."""
    choice, configuration = coordinates.choice, coordinates.configuration
    noun = plural(len(choice.coordinates), "coordinate", "coordinates")
    chosen = listed(math(q) for q in choice.coordinates)
    satisfying: tuple[Part, ...] = ()
    if coordinates.satisfied:
        verb = plural(len(coordinates.satisfied), "holds", "hold")
        satisfying = (f" {constraints_called(coordinates.satisfied)} {verb} identically",)
    ending = ":" if configuration.expressed else "."
    called = Phrase(f" as generalized {noun}", Purpose.NOUN)
    beginning = ("With ", *chosen, called, *satisfying)
    if not satisfying:
        beginning = ("Take ", *chosen, plural(len(choice.coordinates), f" as the generalized {noun}", called))
    body: list[Block] = [prose(*beginning, ending)]
    if configuration.expressed:
        body.append(
            display(
                *(
                    Equation((q, e), label=f"choice-{choice.name}-{q.name}", kind=EquationKind.CHOICE)
                    for q, e in configuration.expressed.items()
                )
            )
        )
    sentences = []
    if coordinates.signs:
        signs = listed(math(s) for s in coordinates.signs)
        each = plural(len(coordinates.signs), " is +1 or −1", " are +1 or −1 each")
        kept = plural(len(coordinates.signs), "both signs of the square root", f"all {coordinates.branches} branches")
        real = listed(math(r, ZERO, relation="≥") for r in coordinates.radicands)
        they = plural(len(coordinates.signs), "It is", "They are")
        sentences.append(prose(*signs, f"{each}: {kept} are kept. {they} real where ", *real, "."))
    if sentences:
        body.append(paragraph(*sentences))
    if len(choice.coordinates) > 1:
        words = " are independent: so are the derivatives of the old coordinates with respect to them."
        body.append(prose(*chosen, words, detail=Detail.FULL))
    body += _remaining(coordinates)
    return Step(Rule.GENERALIZED_COORDINATES, title_in(f"Generalized {noun}", choice.name), tuple(body))


def _remaining(coordinates: GeneralizedCoordinates) -> list[Block]:
    """The constraints that the choice does not satisfy identically."""
    configuration, name = coordinates.configuration, coordinates.choice.name
    blocks: list[Block] = []
    if configuration.rows:
        called = capital(constraints_called(r.name for r in configuration.rows))
        verb = plural(len(configuration.rows), "remains and reads", "remain and read")
        lines = (
            Equation(
                (r.velocity_form(configuration.slots), ZERO),
                label=f"rate-{name}-{r.name}",
                kind=EquationKind.REMAINING_RATE,
            )
            for r in configuration.rows
        )
        blocks += [prose(f"{called} {verb}"), display(*lines)]
    if coordinates.through_rates:
        names = listed(math(q) for q in coordinates.through_rates)
        rates = plural(len(coordinates.through_rates), "its velocity", "their velocities")
        how = f"{are(coordinates.through_rates)}eliminated through {rates}."
        blocks.append(prose(*names, how, purpose=Purpose.ELIMINATED))
    return blocks


def explain_motion_in_choice(
    motion: DalembertMotion, problem: Problem, multiplied: WithMultipliers | None = None
) -> Step:
    """The principle and the equations in a choice of coordinates."""
    body = [
        *displacements_in_choice(motion.elimination, motion.configuration),
        *accelerations_of(motion),
        *of_points(motion.configuration, motion.elimination),
        prose("and d'Alembert's principle ", Ref("principle"), " reads", purpose=Purpose.PRINCIPLE),
        display(Equation((motion.principle.statement, ZERO), label=f"written-out-{motion.configuration.name}")),
        *_derived(motion, problem),
        *_with_multipliers(motion, multiplied),
    ]
    return Step(Rule.EQUATIONS_OF_MOTION, title_of_equations(motion, problem), tuple(body))


def explain_matrix_form(motion: Motion, choice: str = "") -> Step | None:
    """M q'' = f, A q'' = b if there are constraints, q'' if solved for; None if there is nothing to show."""
    form = motion.matrices
    slots = form.configuration.slots
    mass, force = VectorSymbol("M"), VectorSymbol("f")
    left = sp.Mul(mass, VectorSymbol("q''"), evaluate=False)
    many = len(slots.coordinates) > 1
    body: list[Block] = []
    if many:
        q = listed(math(c) for c in slots.coordinates)
        named = [(mass, form.mass), (force, tuple((e,) for e in form.force))]
        words = [
            "In matrix form, with ",
            math(VectorSymbol("q")),
            " for ",
            *q,
            ", the equations are ",
            math(left, force),
        ]
        if form.constraint_matrix:
            names = VectorSymbol("A"), VectorSymbol("b")
            named += [(names[0], form.constraint_matrix), (names[1], tuple((e,) for e in form.constraint_vector))]
            bound = sp.Mul(names[0], VectorSymbol("q''"), evaluate=False)
            words += [", apart from the reactions, which add the transpose of ", math(names[0]), " times their "
                      "multipliers on the right, and the constraints, differentiated until accelerations appear, are ",
                      math(bound, names[1])]  # fmt: skip
        body += [prose(*words, ", where", detail=Detail.FULL), Matrices(tuple(named), Detail.FULL)]
    solved = motion.accelerations
    long = sum(count_operations(e) for e in solved.values()) > LONGEST_ACCELERATIONS
    what = plural(len(solved), "acceleration", "accelerations")
    if solved and long:
        body.append(prose(f"Solved for the {what}, they are long and left to the JSON output.", detail=Detail.FULL))
    elif solved:
        verb = "Solved for the" if many else "The equation, solved for the"
        body.append(prose(f"{verb} {what}:", detail=Detail.FULL))
        suffix = suffix_of(choice)
        lines = (Equation((a, e), label=f"solved{suffix}-{a.name}") for a, e in solved.items())
        body.append(display(*lines, detail=Detail.FULL))
    title = "Matrix form" if many else "Solved for the acceleration"
    if not body:
        return None
    return Step(Rule.EQUATIONS_OF_MOTION, title_in(title, choice), tuple(body))
