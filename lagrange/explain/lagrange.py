"""Lagrange's equations: T, V, the generalized forces and momenta, the equations, and the multipliers that drop out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from lagrange.derivation import Block, Detail, Equation, Part, Prose, Ref, Rule, Step, display, listed, math, paragraph, prose
from lagrange.dynamics import Law
from lagrange.energies import Energies, is_weight
from lagrange.explain.displacements import conditions, points_called
from lagrange.explain.motion import final_equations, scaling, suffix_of
from lagrange.explain.newton import explain_friction, nature
from lagrange.explain.words import plural, spoken
from lagrange.friction import Rubbing
from lagrange.kinematics import Row
from lagrange.letters import Letters
from lagrange.multipliers import LagrangeMotion
from lagrange.newton import Reaction
from lagrange.notation import Dot, Partial, Rate, VectorSymbol, variation
from lagrange.problem import Friction, Problem
from lagrange.textbook import textbook_form
from lagrange.vectors import Vector

ZERO = sp.S.Zero
LONGEST = 60
"""Operations of an intermediate line that is still shown without being asked for."""


@dataclass(frozen=True)
class Told:
    """What all parts of the explanation in one set of coordinates need.

    rubbed  the friction forces
    finite  names of constraints on velocities that come to finite relations
    """

    motion: LagrangeMotion
    letters: Letters
    law: Law
    problem: Problem
    rubbed: Sequence[Rubbing] = ()
    finite: frozenset[str] = frozenset()

    @property
    def found(self) -> Energies:
        """T, V and what follows."""
        return self.motion.principle

    @property
    def choice(self) -> str:
        """The name of the choice of coordinates; empty for the file's own."""
        return self.found.configuration.name

    @property
    def suffix(self) -> str:
        """What labels end in."""
        return suffix_of(self.found.configuration)

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """q."""
        return self.found.configuration.slots.coordinates

    @property
    def velocities(self) -> tuple[sp.Symbol, ...]:
        """q'."""
        return self.found.configuration.slots.velocities

    @property
    def rows(self) -> list[Row]:
        """The constraints that have multipliers."""
        return [self.found.configuration.rows[n] for n in self.motion.used]

    @property
    def function(self) -> sp.Symbol:
        """What is differentiated: L where there is a potential energy, T otherwise."""
        return self.letters.kinetic if self.found.potential == 0 else self.letters.lagrangian

    def reaction(self, row: Row) -> Reaction:
        """What keeps a constraint."""
        return next(r for r in self.law.newton.reactions if r.name == row.name)

    def title(self, words: str) -> str:
        """The title of a step."""
        return f"{words}: {spoken(self.choice)}" if self.choice else words


# -- energies --------------------------------------------------------------------------------------------------------


def explain_energies(told: Told) -> Step:
    """v² and ω, T, V, and the generalized forces of what has no potential energy."""
    body = [*_velocities(told), *_kinetic(told), *_potential(told), *_forces(told)]
    energies = "Kinetic and potential energy" if told.found.potential != 0 else "Kinetic energy"
    also = any(q != 0 for q in told.found.applied)
    return Step(Rule.ENERGIES, told.title(f"{energies}, generalized forces" if also else energies), tuple(body))


def _velocities(told: Told) -> list[Block]:
    """The velocities that are more than x' i + y' j, and all their squares; in a choice ω too."""
    found: list[Block] = []
    velocities, squares = told.found.velocities, told.found.squares
    whose = points_called(told.found.configuration)
    lines = [
        Equation((VectorSymbol(f"r_{name}'"), v), label=f"velocity{told.suffix}-{name}")
        for name, v in velocities.items()
        if not _is_evident(v)
    ]
    if lines:
        what = plural(len(lines), f"The velocity of the {whose} is", f"The velocities of the {whose} are")
        if len(lines) < len(velocities):
            names = listed(n for n, v in velocities.items() if not _is_evident(v))
            what = plural(len(lines), "The velocity of ", "The velocities of ")
            what += "".join(map(str, names)) + plural(len(lines), " is", " are")
        found += [prose(what), display(*lines)]
    if squares:
        one = "and its square is" if lines else f"The square of the velocity of the {whose} is"
        more = "and the squares are" if lines else f"The squares of the velocities of the {whose} are"
        one, more = ("The square of the velocity is", "The squares of the velocities are") if lines else (one, more)
        lines = [
            Equation((told.letters.speed(name) ** 2, square), label=f"square{told.suffix}-{name}")
            for name, square in squares.items()
        ]
        found += [prose(plural(len(lines), one, more)), display(*lines)]
    turning = [r for r in told.found.configuration.rotations if r.has_inertia]
    if told.choice and turning:
        spins = (
            Equation((VectorSymbol(f"omega_{r.name}"), r.angular_velocity), label=f"spin{told.suffix}-{r.name}")
            for r in turning
        )
        word = plural(len(turning), "The angular velocity is", "The angular velocities are")
        found += [prose(word), display(*spins)]
    return found


def _is_evident(velocity: Vector) -> bool:
    """Whether it is x' i + y' j."""
    return all(c == 0 or c.is_Symbol for c in velocity.components)


def _kinetic(told: Told) -> list[Block]:
    """T, by what it is the sum of."""
    found, letters = told.found, told.letters
    terms = [p.mass * letters.speed(p.name) ** 2 / 2 for p in found.configuration.points if p.name in found.squares]
    turning = [r for r in found.configuration.rotations if r.has_inertia]
    spins = [Dot(VectorSymbol(f"omega_{r.name}"), VectorSymbol(f"H_{r.name}")) / 2 for r in turning]
    parts = " of the mass centres and of the rotations about them" if len(turning) > 1 else (
        " of the mass centre and of the rotation about it"
    )
    what = f"The kinetic energy,{parts}, is" if terms and spins else "The kinetic energy is"
    if not terms and not spins:
        return [prose("Nothing has mass, and the kinetic energy is 0.")]
    line = Equation((letters.kinetic, sp.Add(*terms, *spins), found.kinetic), label=f"kinetic{told.suffix}")
    return [prose(what), display(line)]


def _potential(told: Told) -> list[Block]:
    """V, and of what."""
    if told.found.potential == 0:
        return []
    configuration = told.found.configuration
    weights = sum(is_weight(f, configuration) for f in configuration.loads)
    springs = configuration.springs
    fields = configuration.potential - sp.Add(*(s.energy for s in springs)) != 0
    whats = [plural(weights, "the weight", "the weights")] * bool(weights)
    whats += [plural(len(springs), "the spring", "the springs")] * bool(springs)
    whats += ["the given field"] * fields
    of = "".join(str(p) for p in listed(whats))
    return [
        prose(f"The potential energy of {of} is"),
        display(Equation((told.letters.potential, told.found.potential), label=f"potential{told.suffix}")),
    ]


def _forces(told: Told) -> list[Block]:
    """δW of what is not in V, and the Q_k that follow."""
    found, letters = told.found, told.letters
    acting = _acting(told)
    other = "other " if found.potential != 0 else ""
    if not acting:
        return [] if told.choice else [prose(f"No {other}force is applied: the generalized forces are 0.")]
    names = listed(acting)
    if all(q == 0 for q in found.applied):
        verb = plural(len(acting), "does", "do")
        return [prose(*_capital(names), f" {verb} no virtual work: the generalized forces are 0.")]
    work = sp.Add(*(q * variation(x) for q, x in zip(found.applied, told.coordinates, strict=True)))
    lines = [
        Equation((letters.force(x), q), label=f"generalized{told.suffix}-{x.name}")
        for q, x in zip(found.applied, told.coordinates, strict=True)
        if q != 0
    ]
    idle = [letters.force(x) for q, x in zip(found.applied, told.coordinates, strict=True) if q == 0]
    words: tuple[Part, ...] = (*_capital(names), plural(len(acting), " does", " do"), " the virtual work")
    if other:
        words = ("Not in ", math(letters.potential), plural(len(acting), " is ", " are "), *names,
                 plural(len(acting), ", which does", ", which do"), " the virtual work")  # fmt: skip
    rest: list[Block] = [prose(*listed(math(s) for s in idle), plural(len(idle), " is 0.", " are 0."))] if idle else []
    so = plural(len(lines), "so that the generalized force is", "so that the generalized forces are")
    return [prose(*words), display(Equation((work,), label=f"work{told.suffix}")), prose(so), display(*lines), *rest]


def explain_friction_first(told: Told) -> Step:
    """Which reaction the friction needs, before T and V."""
    natures = [s for r in told.rows for s in nature(told.reaction(r))]
    needed = plural(len(told.rubbed), "The friction needs its reaction", "The frictions need their reactions")
    body = [*([paragraph(*natures)] if natures else []), *explain_friction(told.rubbed)]
    body.append(prose(f"{needed}, found by Lagrange's equations with multipliers, which follow below."))
    return Step(Rule.REACTIONS, plural(len(told.rows), "The reaction and friction", "Reactions and friction"), tuple(body))


def _acting(told: Told) -> list[str]:
    """What is applied and not in V."""
    configuration = told.found.configuration
    rubbing = {f.name for f in told.problem.forces if isinstance(f, Friction)}
    names = []
    for load in configuration.loads:
        if not is_weight(load, configuration):
            kind = "the friction" if load.name in rubbing else "the force"
            names.append(f"{kind} {spoken(load.name)}" if load.name != "weight" else "the weight")
    names += [f"the moment {spoken(m.name)}" for m in configuration.torques]
    names += ["the damper" if spoken(d.name) == "damper" else f"the damper {spoken(d.name)}" for d in configuration.dampers]
    return list(dict.fromkeys(names))


def _capital(parts: Sequence[Part]) -> tuple[Part, ...]:
    first, *rest = parts
    return (f"{str(first)[0].upper()}{str(first)[1:]}", *rest)


# -- Lagrange's equations --------------------------------------------------------------------------------------------


def explain_lagrange(told: Told) -> Step:
    """The equations, why no constraint is put in before, momenta and derivatives; the equations with multipliers."""
    body = [*_general(told), *_not_put_in(told), *_derivatives(told), *_quasi(told)]
    if told.rows:
        body += _with_multipliers(told)
    else:
        body += _conserved(told)
    return Step(Rule.LAGRANGE, told.title("Lagrange's equations"), tuple(body))


def _general(told: Told) -> list[Block]:
    """The equations for a coordinate q_k."""
    if told.choice:
        return _without_multipliers(told)
    letters, function = told.letters, told.function
    q = sp.Symbol("q_k", real=True)
    momentum, force = letters.momentum(sp.Symbol("k")), letters.force(sp.Symbol("k"))
    bound = bool(told.found.configuration.rows)
    right = force if bound or any(q != 0 for q in told.found.applied) else ZERO
    left = sp.Add(Rate(momentum), -Partial(function, q), evaluate=False)
    with_potential: tuple[Part, ...] = (
        ("With ", math(function, letters.kinetic - letters.potential), ", ") if told.found.potential != 0 else ()
    )
    velocity = sp.Symbol("q_k'", real=True)
    sentences = [
        prose(*with_potential, "Lagrange's equations for the coordinates ", math(q), " and their generalized momenta ",
              math(momentum, Partial(function, velocity)), " are ", math(left, right), ".")
    ]  # fmt: skip
    return [paragraph(*sentences, *_of_reactions(told))]


def _without_multipliers(told: Told) -> list[Block]:
    """That a choice has satisfied the constraints."""
    if told.found.configuration.rows or not told.problem.constraints:
        return []
    bound = plural(len(told.coordinates), " is bound by no constraint", " are bound by no constraint")
    return [prose(*listed(math(q) for q in told.coordinates), f"{bound}, so that there are no multipliers.")]


def _of_reactions(told: Told) -> list[Prose]:
    """What constraints add to the right side."""
    rows = told.rows
    if not rows:
        return []
    multipliers = listed(math(told.reaction(r).multiplier) for r in rows)
    refs = listed(Ref(f"virtual-{r.name}") for r in rows)
    found = [
        prose("The coordinates are bound by ", plural(len(rows), "a constraint, whose reaction adds a", "constraints, "
              "whose reactions add"), " generalized ", plural(len(rows), "force", "forces"), " on the right: the "
              "coefficient of each displacement in ", *refs, plural(len(rows), " times an unknown multiplier ",
              " times unknown multipliers "), *multipliers, ".")
    ]  # fmt: skip
    for r in [] if told.rubbed else rows:
        reaction = told.reaction(r)
        if reaction.directions is not None and (reaction.rod is not None or reaction.is_normal):
            found += nature(reaction)
    return found


def _not_put_in(told: Told) -> list[Block]:
    """Why a constraint on velocities is not put into T before differentiating."""
    kinematic = [r for r in told.found.configuration.rows if r.finite is None]
    if not kinematic:
        return []
    names = listed(spoken(r.name) for r in kinematic)
    kinetic = math(told.letters.kinetic)
    one = len(kinematic) == 1
    if told.choice:
        words = " is made use of." if one else " are made use of."
        return [prose("Here too ", kinetic, " is differentiated before ", *names, words)]
    first = (" binds velocities, and is not put into " if one else " bind velocities, and are not put into ")
    broken = "the constraint" if one else "the constraints"
    excluded = "it excludes" if one else "they exclude"
    balanced = "its reaction balances" if one else "their reactions balance"
    last = (
        " The constraint comes in by its multiplier, and is used once the derivatives are taken."
        if one
        else " The constraints come in by their multipliers, and are used once the derivatives are taken."
    )
    sentences = [
        prose("The constraint " if one else "The constraints ", *names, first, kinetic, " before it is differentiated."),
        prose("A derivative by one velocity compares motions of which most break ", broken, ", and needs ", kinetic,
              f" for all of them. With the velocities that {excluded} taken out, the terms that {balanced} would be "
              "lost, and the equations be wrong.", last),
    ]  # fmt: skip
    harmless = [r.name for r in kinematic if r.name in told.finite]
    if len(harmless) == len(kinematic):
        sentences[1] = prose(
            ("It comes to a finite relation" if one else "They come to finite relations"), ", and so could be put in "
            "with that; a constraint that does not would give wrong equations, because the terms that its reaction "
            "balances would be lost.", last)  # fmt: skip
    return [paragraph(*sentences)]


def _derivatives(told: Told) -> list[Block]:
    """The momenta, their rates, the derivatives by the coordinates."""
    found, letters, function = told.found, told.letters, told.function
    momenta = [
        Equation((letters.momentum(q), Partial(function, v), p), label=f"p{told.suffix}-{q.name}")
        for q, v, p in zip(told.coordinates, told.velocities, found.momenta, strict=True)
        if p != 0
    ]
    rates = [
        Equation((Rate(letters.momentum(q)), rate), label=f"rate{told.suffix}-{q.name}")
        for q, p, rate in zip(told.coordinates, found.momenta, found.rates, strict=True)
        if p != 0
    ]
    still = [v for v, p in zip(told.velocities, found.momenta, strict=True) if p == 0]
    partials = [
        Equation((Partial(function, q), p), label=f"slope{told.suffix}-{q.name}")
        for q, p in zip(told.coordinates, found.partials, strict=True)
        if p != 0
    ]
    absent = [q for q, p in zip(told.coordinates, found.partials, strict=True) if p == 0]
    long = any(rate.count_ops() > LONGEST for rate in found.rates)
    body: list[Block] = []
    if still:
        gone = listed(math(letters.momentum(q)) for q, p in zip(told.coordinates, found.momenta, strict=True) if p == 0)
        ending = plural(len(still), " does not occur in ", " do not occur in ")
        body.append(prose(*listed(math(v) for v in still), ending, math(function), ": ", *gone,
                          plural(len(still), " is 0.", " are 0.")))  # fmt: skip
    if momenta:
        begin = "The others are" if still and len(momenta) > 1 else "The other is" if still else plural(
            len(momenta), "The generalized momentum is", "The generalized momenta are"
        )
        shown = Detail.FULL if long else Detail.STEPS
        its = plural(len(rates), "and its rate of change", "and their rates of change")
        body += [prose(begin), display(*momenta), prose(its, detail=shown), display(*rates, detail=shown)]
    names = listed(math(q) for q in absent)
    if absent:
        verb = plural(len(absent), " does not occur in ", " do not occur in ")
        body.append(prose(*names, verb, math(function), ": the derivative by it is 0." if len(absent) == 1 else
                          ": the derivatives by them are 0."))  # fmt: skip
    if partials:
        those = [math(q) for q, p in zip(told.coordinates, found.partials, strict=True) if p != 0]
        verb = plural(len(those), "The derivative of ", "The derivatives of ")
        body += [prose(verb, math(function), " by ", *listed(those), plural(len(those), " is", " are")), display(*partials)]
    return body


def _quasi(told: Told) -> list[Block]:
    """What quasi-coordinates add."""
    found, letters = told.found, told.letters
    given = [r for r in found.configuration.rotations if r.given and r.has_inertia]
    if not given:
        return []
    r = given[0]
    omega = VectorSymbol(f"omega_{r.name}")
    if not found.has_quasi_coordinates:
        return [
            prose("The angular velocity ", math(omega), " is given as it is. That it need not come from angles that "
                  "determine how the body is turned makes no difference here: what quasi-coordinates would add to "
                  "Lagrange's equations (Boltzmann, Hamel) is 0 for each coordinate.")
        ]  # fmt: skip
    lines = [
        Equation((letters.addition(q), n), label=f"quasi{told.suffix}-{q.name}")
        for q, n in zip(told.coordinates, found.quasi, strict=True)
        if n != 0
    ]
    k, q = sp.Symbol("k"), sp.Symbol("q_k", real=True)
    added = letters.addition(k)
    left = sp.Add(Rate(letters.momentum(k)), -Partial(told.function, q), -added, evaluate=False)
    return [
        prose("The angular velocity ", math(omega), " is given as it is, and its coefficients are no derivatives of "
              "angles: some coordinates are quasi-coordinates, which do not determine how the body is turned. For them "
              "Lagrange's expression has a term too much, ", math(added), ": the angular momentum times the rate of "
              "change of the coefficient of ", math(sp.Symbol("q_k'", real=True)), " in the angular velocity, less the "
              "derivative of ", math(told.letters.kinetic), " by ", math(q), " as far as the body's rotation goes "
              "(Boltzmann, Hamel). Their left sides are ", math(left), ", with"),
        display(*lines),
    ]  # fmt: skip


def _with_multipliers(told: Told) -> list[Block]:
    """One equation for each coordinate."""
    lines = [
        Equation((left, _right(told, k)), label=f"lagrange{told.suffix}-{q.name}")
        for k, (q, left) in enumerate(zip(told.coordinates, told.found.left, strict=True))
    ]
    left_out = len(told.found.configuration.rows) - len(told.rows)
    body: list[Block] = [
        prose("Lagrange's equations are" if told.choice else "With these, Lagrange's equations are"),
        display(*lines),
    ]
    if left_out:
        names = listed(spoken(r.name) for n, r in enumerate(told.found.configuration.rows) if n not in told.motion.used)
        verb = plural(left_out, " follows from the others, and needs", " follow from the others, and need")
        body.append(prose(*names, verb, " no multiplier of its own." if left_out == 1 else " no multipliers."))
    return body


def _right(told: Told, k: int) -> sp.Expr:
    """Q_k + Σ λ_j a_jk, a named tension in place of its multiplier."""
    terms = [told.found.applied[k]]
    for row in told.rows:
        reaction = told.reaction(row)
        factor = row.coefficients[k]
        if reaction.per_force != 1:
            factor = textbook_form(factor * reaction.per_force)
        terms.append(factor * reaction.force)
    return sp.Add(*terms)


def _conserved(told: Told) -> list[Block]:
    """Momenta of coordinates that occur nowhere but by their velocities, and on which nothing acts."""
    found = told.found
    constant = [
        q
        for q, p, force, n in zip(told.coordinates, found.partials, found.applied, found.quasi, strict=True)
        if p == 0 and force == 0 and n == 0
    ]
    if not constant:
        return []
    momenta = listed(math(told.letters.momentum(q)) for q in constant)
    verb = plural(len(constant), " is conserved.", " are conserved.")
    return [prose("No force acts on ", *listed(math(q) for q in constant), " either: ", *momenta, verb)]


# -- equations of motion ---------------------------------------------------------------------------------------------


def explain_lagrange_motion(told: Told) -> Step:
    """The equations without multipliers, in textbook form."""
    motion = told.motion
    body: list[Block] = []
    if told.rows:
        body += _eliminated(told)
    else:
        clauses = scaling(motion)
        body.append(prose("Lagrange's equations are therefore" if len(motion.equations) > 1 else
                          "Lagrange's equation is therefore", *((" (", *clauses, ")") if clauses else ())))  # fmt: skip
    body += final_equations(motion, told.problem)
    title = plural(len(motion.equations), "Equation of motion", "Equations of motion")
    if told.problem.choices and not told.choice:
        title += " in the given coordinates"
    return Step(Rule.EQUATIONS_OF_MOTION, told.title(title), tuple(body))


def _eliminated(told: Told) -> list[Block]:
    """The multipliers from the equations of the dependent coordinates, put into the others."""
    motion = told.motion
    dependent = listed(math(told.coordinates[d]) for d in motion.elimination.dependent)
    free = [math(told.coordinates[k]) for k in motion.elimination.independent]
    pivots = conditions(motion.elimination)
    where: tuple[Part, ...] = (", where ", *pivots, ",") if pivots else ()
    clauses = scaling(motion)
    scaled: tuple[Part, ...] = (" (", *clauses, ")") if clauses else ()
    if motion.multipliers is None:
        return [
            prose("Multiply each equation by the virtual displacement of its coordinate, with the solved displacements "
                  "of ", *dependent, " put in, and add: the reactions drop out. What multiplies each free "
                  "displacement vanishes", *scaled, ":")
        ]  # fmt: skip
    reactions = [told.reaction(r) for r in told.rows]
    lines = [
        Equation((r.force, textbook_form(value / r.per_force) if r.per_force != 1 else value),
                 label=f"force-of{told.suffix}-{r.name}")
        for r, value in zip(reactions, motion.multipliers, strict=True)
    ]  # fmt: skip
    long = any(line.sides[1].count_ops() > LONGEST for line in lines if isinstance(line.sides[1], sp.Expr))
    of = plural(len(dependent), "The equation of ", "The equations of ")
    what = "multiplier" if all(not r.named for r in reactions) else "tension" if all(r.named for r in reactions) else "reaction"
    gives = plural(len(lines), f" gives the {what}", f" give the {what}s")
    if not free:
        return [
            prose(of, *dependent, *where, gives),
            display(*lines),
            prose("No coordinate is free: the constraints alone determine the motion."),
        ]
    others = plural(len(free), "the equation of ", "the equations of ")
    ending = plural(len(free), "it becomes", "they become")
    if long:
        return [
            prose(of, *dependent, *where, gives, ", in long expressions. Put into ", others, *listed(free),
                  " these leave", *scaled),
            display(*lines, detail=Detail.FULL),
        ]  # fmt: skip
    return [
        prose(of, *dependent, *where, gives),
        display(*lines),
        prose("With ", plural(len(lines), "this", "these"), " put into ", others, *listed(free), f", {ending}", *scaled),
    ]
