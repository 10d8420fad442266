"""Lagrange's equations: momenta and derivatives, why no constraint is put into T, and the multipliers that drop out."""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.symbols import Partial, Rate, VectorSymbol, prime, variation
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    Part,
    Prose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    paragraph,
    prose,
)
from lagrange.explain.displacements import conditions
from lagrange.explain.energies import Told
from lagrange.explain.motion import final_equations, scaling
from lagrange.explain.newton import nature
from lagrange.explain.words import plural, spoken

ZERO = sp.S.Zero
LONGEST = 60
"""Operations of an intermediate line that is still shown without being asked for."""


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
    letters, function, q = told.letters, told.function, told.letters.coordinate
    momentum, force, _ = letters.any
    bound = bool(told.found.configuration.rows)
    right = force if bound or any(q != 0 for q in told.found.applied) else ZERO
    with_potential: tuple[Part, ...] = ("Lagrange's equations for the coordinates ", math(q))
    if told.found.potential != 0:
        with_potential = ("With ", math(function, letters.kinetic - letters.potential), ", ", *with_potential)
    words = prose(*with_potential, ", and the generalized momenta in them, are")
    lines = (
        Equation((Rate(momentum) - Partial(function, q), right), label="lagrange"),
        Equation((momentum, Partial(function, prime(q))), label="momenta"),
    )
    reactions = _of_reactions(told)
    return [words, display(*lines), *([paragraph(*reactions)] if reactions else [])]


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
        if reaction.named:
            found.append(prose("With it ", math(reaction.multiplier, reaction.per_force * reaction.force), "."))
    return found


def _not_put_in(told: Told) -> list[Block]:
    """Why a constraint on velocities is not put into T before differentiating."""
    kinematic = [r for r in told.rows if r.finite is None]
    if not kinematic:
        return []
    names = listed(spoken(r.name) for r in kinematic)
    kinetic = math(told.letters.kinetic)
    one = len(kinematic) == 1
    if told.choice:
        words = " is made use of." if one else " are made use of."
        return [prose("Here too ", kinetic, " is differentiated before ", *names, words)]
    first = " binds velocities, and is not put into " if one else " bind velocities, and are not put into "
    broken = "the constraint" if one else "the constraints"
    excluded = "it excludes" if one else "they exclude"
    balanced = "its reaction balances" if one else "their reactions balance"
    last = (
        " The constraint comes in by its multiplier, and is used once the derivatives are taken."
        if one
        else " The constraints come in by their multipliers, and are used once the derivatives are taken."
    )
    sentences = [
        prose("The constraint " if one else "The constraints ", *names, first, kinetic,
              " before it is differentiated."),
        prose("A derivative by one velocity compares motions of which most break ", broken, ", and needs ", kinetic,
              f" for all of them. With the velocities that {excluded} taken out, the terms that {balanced} would be "
              "lost, and the equations would in general be wrong.", last),
    ]  # fmt: skip
    harmless = [r.name for r in kinematic if r.name in told.finite]
    if len(harmless) == len(kinematic):
        sentences[1] = prose(
            ("It comes to a finite relation, and could be replaced by it" if one else
             "They come to finite relations, and could be replaced by them"), ". One that does not, put into ", kinetic,
            ", would take away terms that its reaction balances, and "
            "in general give wrong equations.", last)  # fmt: skip
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
        begin = (
            "The others are"
            if still and len(momenta) > 1
            else "The other is"
            if still
            else plural(len(momenta), "The generalized momentum is", "The generalized momenta are")
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
        body += [
            prose(verb, math(function), " by ", *listed(those), plural(len(those), " is", " are")),
            display(*partials),
        ]
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
    q = letters.coordinate
    momentum, _, added = letters.any
    left = Rate(momentum) - Partial(told.function, q) - added
    return [
        prose("The angular velocity ", math(omega), " is given as it is, and its coefficients are no derivatives of "
              "angles: some coordinates are quasi-coordinates, which do not determine how the body is turned. For them "
              "Lagrange's expression has a term too much, ", math(added), ": the angular momentum times the rate of "
              "change of the coefficient of ", math(prime(q)), " in the angular velocity, less the "
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
        prose("Lagrange's equations " if told.choice else "With these, Lagrange's equations ", Ref("lagrange"), " are"),
        display(*lines),
    ]
    if left_out:
        names = listed(spoken(r.name) for n, r in enumerate(told.found.configuration.rows) if n not in told.motion.used)
        verb = plural(left_out, " follows from the others, and needs", " follow from the others, and need")
        begin = plural(left_out, "The constraint ", "The constraints ")
        body.append(prose(begin, *names, verb, " no multiplier of its own." if left_out == 1 else " no multipliers."))
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
        clauses = scaling(motion.equations)
        one = len(motion.equations) == 1
        scaled = (" (", *clauses, ")") if clauses else ()
        body.append(prose("Lagrange's equation " if one else "Lagrange's equations ", Ref("lagrange"),
                          " is therefore" if one else " are therefore", *scaled))  # fmt: skip
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
    clauses = scaling(motion.equations)
    scaled: tuple[Part, ...] = (" (", *clauses, ")") if clauses else ()
    if motion.multipliers is None:
        return [
            prose("Multiply each equation by the virtual displacement of its coordinate, with the solved displacements "
                  "of ", *dependent, " put in, and add: the reactions drop out. What multiplies ",
                  *listed(math(variation(told.coordinates[k])) for k in motion.elimination.independent),
                  " vanishes", *scaled, ":")
        ]  # fmt: skip
    reactions = [told.reaction(r) for r in told.rows]
    lines = [
        Equation((r.force, textbook_form(value / r.per_force) if r.per_force != 1 else value),
                 label=f"force-of{told.suffix}-{r.name}")
        for r, value in zip(reactions, motion.multipliers, strict=True)
    ]  # fmt: skip
    long = any(line.sides[1].count_ops() > LONGEST for line in lines if isinstance(line.sides[1], sp.Expr))
    of = plural(len(dependent), "The equation of ", "The equations of ")
    what = (
        "multiplier"
        if all(not r.named for r in reactions)
        else "tension"
        if all(r.named for r in reactions)
        else "reaction"
    )
    gives = plural(len(lines), f" gives the {what}", f" give the {what}s")
    if not free:
        return [
            prose(of, *dependent, *where, gives),
            display(*lines),
            prose("No coordinate is free: the constraints alone determine the motion."),
        ]
    others = plural(len(free), "the equation of ", "the equations of ")
    if not any(row.coefficients[k] != 0 for row in told.rows for k in motion.elimination.independent):
        clean = plural(len(free), " holds no multiplier, and is", " hold no multiplier, and are")
        return [
            prose(of, *dependent, *where, gives),
            display(*lines),
            prose(f"{others[0].upper()}{others[1:]}", *listed(free), clean, *scaled),
        ]
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
        prose(
            "With ", plural(len(lines), "this", "these"), " put into ", others, *listed(free), f", {ending}", *scaled
        ),
    ]
