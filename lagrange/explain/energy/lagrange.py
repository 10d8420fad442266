"""Lagrange's equations: momenta, derivatives, multipliers; why no kinematic constraint is substituted into T."""

from __future__ import annotations

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Partial, TimeDerivative, VectorSymbol, prime, variation
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    EquationKind,
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
)
from lagrange.explain.displacements import pivot_conditions
from lagrange.explain.energy.energies import LagrangeExposition
from lagrange.explain.limits import LONGEST_INTERMEDIATE
from lagrange.explain.motion import final_equations, scaling, title_of_equations
from lagrange.explain.newton import nature
from lagrange.explain.words import capital, constraints_called, in_brackets, plural

ZERO = sp.S.Zero


def explain_lagrange(setup: LagrangeExposition) -> Step:
    """The equations, why no constraint is substituted before, momenta and derivatives; multipliers."""
    body = [*_general(setup), *_not_substituted(setup), *_derivatives(setup), *_quasi(setup)]
    if setup.rows:
        body += _with_multipliers(setup)
    else:
        body += _conserved(setup)
    return Step(Rule.LAGRANGE, setup.title("Lagrange's equations"), tuple(body))


def _general(setup: LagrangeExposition) -> list[Block]:
    """The equations for a coordinate q_k."""
    if setup.choice:
        return _without_multipliers(setup)
    letters, function, q = setup.letters, setup.function, setup.letters.coordinate
    momentum, force, _ = letters.any
    bound = bool(setup.energies.configuration.rows)
    right = force if bound or any(q != 0 for q in setup.energies.applied) else ZERO
    if any(s != 0 for s in setup.energies.of_masses):
        right += letters.of_masses(sp.Symbol(letters.index, real=True))
    with_potential: tuple[Part, ...] = ("Lagrange's equations for the coordinates ", math(q))
    if setup.energies.has_lagrangian and setup.energies.moving == 0 and not _is_outright(setup):
        with_potential = ("With ", math(function, letters.kinetic - letters.potential), ", ", *with_potential)
    others: tuple[Part, ...] = () if force not in right.free_symbols else (" with the generalized forces ", math(force))
    words = prose(*with_potential, *others, ", and the generalized momenta in them, are")
    lines = (
        Equation((TimeDerivative(momentum) - Partial(function, q), right), label="lagrange"),
        Equation((momentum, Partial(function, prime(q))), label="momenta"),
    )
    reactions = _of_reactions(setup)
    return [words, display(*lines), *([paragraph(*reactions)] if reactions else [])]


def _is_outright(setup: LagrangeExposition) -> bool:
    return setup.energies.configuration.is_outright


def _without_multipliers(setup: LagrangeExposition) -> list[Block]:
    """That no constraint is left in a choice."""
    if setup.energies.configuration.rows or not setup.problem.constraints:
        return []
    return [prose("No constraint is left on ", *listed(math(q) for q in setup.coordinates), ", so there are no "
                  "multipliers.")]  # fmt: skip


def _of_reactions(setup: LagrangeExposition) -> list[Prose]:
    """The generalized forces that constraints add on the right."""
    rows = setup.rows
    if not rows:
        return []
    multipliers = listed(math(setup.reaction(r).multiplier) for r in rows)
    refs = listed(Ref(f"virtual-{r.name}") for r in rows)
    sentences = [
        prose("The coordinates are subject to ", plural(len(rows), "a constraint, whose reaction adds a",
              "constraints, whose reactions add"), " generalized ", plural(len(rows), "force", "forces"),
              " on the right: the coefficient of each displacement in ", *refs, " times ",
              plural(len(rows), "an unknown multiplier ", "unknown multipliers "), *multipliers, ".")
    ]  # fmt: skip
    for r in [] if setup.friction_forces else rows:
        reaction = setup.reaction(r)
        is_explained = reaction.rod is not None or reaction.is_normal or reaction.given is not None
        if reaction.directions is not None and is_explained:
            sentences += nature(reaction)
        if reaction.named:
            multiplier = math(reaction.multiplier, reaction.per_force * reaction.force)
            sentences.append(prose("In terms of it ", multiplier, "."))
    return sentences


def _not_substituted(setup: LagrangeExposition) -> list[Block]:
    """Why a constraint on velocities is not substituted into T before differentiating."""
    kinematic = [r for r in setup.rows if r.finite is None]
    if not kinematic:
        return []
    called = constraints_called(r.name for r in kinematic)
    kinetic = math(setup.function if _is_outright(setup) else setup.letters.kinetic)
    one = len(kinematic) == 1
    if setup.choice:
        return [prose("Here too ", kinetic, f" is differentiated before {called} {'is' if one else 'are'} used.")]
    restricts = "restricts velocities and is" if one else "restrict velocities and are"
    violate, excluded = ("the constraint", "it excludes") if one else ("the constraints", "they exclude")
    balanced = "its reaction balances" if one else "their reactions balance"
    last = (
        " The constraint enters through its multiplier and is used once the derivatives have been taken."
        if one
        else " The constraints enter through their multipliers and are used once the derivatives have been taken."
    )
    before = Phrase(" before it is differentiated.", Purpose.REASON)
    first = prose(
        f"{capital(called)} {restricts} not substituted into ", kinetic, before, purpose=Purpose.NOT_SUBSTITUTED
    )
    if all(r.name in setup.finite for r in kinematic):
        second = prose(
            "It is equivalent to a finite relation and could be replaced by it." if one else
            "They are equivalent to finite relations and could be replaced by them.", " A constraint for which this is "
            "not so would, substituted into ", kinetic, ", remove terms that its reaction balances and in general give "
            "wrong equations.", last)  # fmt: skip
    else:
        second = prose(
            f"A derivative with respect to one velocity compares motions most of which violate {violate}, and needs ",
            kinetic, f" for all of them. If the velocities that {excluded} were eliminated first, the terms that "
            f"{balanced} would be lost, and the equations would in general be wrong.", last)  # fmt: skip
    return [paragraph(first, second)]


def _derivatives(setup: LagrangeExposition) -> list[Block]:
    """The momenta, their rates, the derivatives by the coordinates."""
    energies, letters, function = setup.energies, setup.letters, setup.function
    momenta = [
        Equation((letters.momentum(q), Partial(function, v), p), label=f"p{setup.suffix}-{q.name}")
        for q, v, p in zip(setup.coordinates, setup.velocities, energies.momenta, strict=True)
        if p != 0
    ]
    rates = [
        Equation((TimeDerivative(letters.momentum(q)), rate), label=f"rate{setup.suffix}-{q.name}")
        for q, p, rate in zip(setup.coordinates, energies.momenta, energies.rates, strict=True)
        if p != 0
    ]
    absent_velocities = [v for v, p in zip(setup.velocities, energies.momenta, strict=True) if p == 0]
    partials = [
        Equation((Partial(function, q), p), label=f"slope{setup.suffix}-{q.name}")
        for q, p in zip(setup.coordinates, energies.partials, strict=True)
        if p != 0
    ]
    absent = [q for q, p in zip(setup.coordinates, energies.partials, strict=True) if p == 0]
    long = any(count_operations(rate) > LONGEST_INTERMEDIATE for rate in energies.rates)
    body: list[Block] = []
    if absent_velocities:
        zero = [letters.momentum(q) for q, p in zip(setup.coordinates, energies.momenta, strict=True) if p == 0]
        ending = plural(len(zero), " does not appear in ", " do not appear in ")
        body.append(prose(*listed(map(math, absent_velocities)), ending, math(function), ", so ",
                          *listed(map(math, zero)), plural(len(zero), " is 0.", " are 0.")))  # fmt: skip
    if momenta:
        one, more = "The generalized momentum is", "The generalized momenta are"
        one, more = ("The other is", "The others are") if absent_velocities else (one, more)
        shown = Detail.FULL if long else Detail.STEPS
        its = plural(len(rates), "Its rate of change is", "Their rates of change are")
        body += [prose(plural(len(momenta), one, more)), display(*momenta)]
        body += [prose(its, detail=shown), display(*rates, detail=shown)]
    if absent:
        verb = plural(len(absent), " does not appear in ", " do not appear in ")
        body.append(prose(*listed(map(math, absent)), verb, math(function), plural(len(absent),
                          ", so the derivative with respect to it is 0.",
                          ", so the derivatives with respect to them are 0.")))  # fmt: skip
    if partials:
        those = [math(q) for q, p in zip(setup.coordinates, energies.partials, strict=True) if p != 0]
        verb = plural(len(those), "The derivative of ", "The derivatives of ")
        body += [
            prose(verb, math(function), " with respect to ", *listed(those), plural(len(those), " is", " are")),
            display(*partials),
        ]
    return body


def _quasi(setup: LagrangeExposition) -> list[Block]:
    """The terms that quasi-coordinates add."""
    energies, letters = setup.energies, setup.letters
    given = [r for r in energies.configuration.rotations if r.given and r.has_inertia]
    if not given:
        return []
    r = given[0]
    omega = VectorSymbol(f"omega_{r.name}")
    if not energies.has_quasi_coordinates:
        return [
            prose("The angular velocity ", math(omega), " is given directly. That it need not derive from angles that "
                  "determine the orientation of the body makes no difference here: the terms that quasi-coordinates "
                  "would add to Lagrange's equations (Boltzmann, Hamel) are 0 for each coordinate.")
        ]  # fmt: skip
    lines = [
        Equation((letters.addition(q), n), label=f"quasi{setup.suffix}-{q.name}")
        for q, n in zip(setup.coordinates, energies.quasi, strict=True)
        if n != 0
    ]
    q = letters.coordinate
    momentum, _, added = letters.any
    left = TimeDerivative(momentum) - Partial(setup.function, q) - added
    return [
        prose("The angular velocity ", math(omega), " is given directly, and its coefficients are not derivatives of "
              "angles: some coordinates are quasi-coordinates, which do not determine the orientation of the body. For "
              "them Lagrange's expression has one term too many, ", math(added), ": the angular momentum times the "
              "rate of change of the coefficient of ", math(prime(q)), " in the angular velocity, minus the derivative "
              "with respect to ", math(q), " of the part of ", math(setup.letters.kinetic), " due to the rotation of "
              "the body (Boltzmann, Hamel). Their left sides are ", math(left), ", with"),
        display(*lines),
    ]  # fmt: skip


def _with_multipliers(setup: LagrangeExposition) -> list[Block]:
    """One equation for each coordinate."""
    lines = [
        Equation((left, right), label=f"lagrange{setup.suffix}-{q.name}")
        for q, left, right in zip(setup.coordinates, setup.energies.left, setup.motion.right, strict=True)
    ]
    left_out = len(setup.energies.configuration.rows) - len(setup.rows)
    body: list[Block] = [
        prose(
            "Lagrange's equations " if setup.choice else "With these, Lagrange's equations ",
            Ref("lagrange"),
            " are",
        ),
        display(*lines),
    ]
    if left_out:
        rows = enumerate(setup.energies.configuration.rows)
        called = capital(constraints_called(r.name for n, r in rows if n not in setup.motion.used))
        body.append(prose(called, plural(left_out, " follows from the others and needs no multiplier of its own.",
                                         " follow from the others and need no multipliers.")))  # fmt: skip
    return body


def _conserved(setup: LagrangeExposition) -> list[Block]:
    """The constant momenta: of coordinates that appear only through their velocities, without generalized force."""
    energies = setup.energies
    constant = [
        q
        for q, *terms in zip(
            setup.coordinates, energies.partials, energies.applied, energies.of_masses, energies.quasi, strict=True
        )
        if all(term == 0 for term in terms)
    ]
    if not constant:
        return []
    momenta = listed(math(setup.letters.momentum(q)) for q in constant)
    forces = plural(len(constant), "The generalized force of ", "The generalized forces of ")
    verb = plural(len(constant), " is conserved.", " are conserved.")
    zero = plural(len(constant), " is zero too, so ", " are zero too, so ")
    return [prose(forces, *listed(math(q) for q in constant), zero, *momenta, verb)]


# -- equations of motion ---------------------------------------------------------------------------------------------


def explain_lagrange_motion(setup: LagrangeExposition) -> Step:
    """The equations without multipliers, in textbook form."""
    motion = setup.motion
    body: list[Block] = []
    if setup.rows:
        body += _eliminated(setup)
    else:
        clauses = scaling(motion.equations)
        one = len(motion.equations) == 1
        body.append(prose("Lagrange's equation " if one else "Lagrange's equations ", Ref("lagrange"),
                          " is therefore" if one else " are therefore", *in_brackets(clauses)))  # fmt: skip
    body += final_equations(motion, setup.problem)
    return Step(Rule.EQUATIONS_OF_MOTION, title_of_equations(motion, setup.problem), tuple(body))


def _eliminated(setup: LagrangeExposition) -> list[Block]:
    """The multipliers from the equations of the dependent coordinates, substituted into the others."""
    motion = setup.motion
    dependent = listed(math(setup.coordinates[d]) for d in motion.elimination.dependent)
    free = [math(setup.coordinates[k]) for k in motion.elimination.independent]
    pivots = pivot_conditions(motion.elimination)
    where: tuple[Part, ...] = (", where ", *pivots, ",") if pivots else ()
    scaled = in_brackets(scaling(motion.equations))
    if motion.forces is None:
        of = plural(len(free), "The coefficient of ", "The coefficients of ")
        return [
            prose("Multiply each equation by the virtual displacement of its coordinate, substitute for those of ",
                  *dependent, ", and add: the reactions drop out. ", of,
                  *listed(math(variation(setup.coordinates[k])) for k in motion.elimination.independent),
                  " must vanish", *scaled, ":")
        ]  # fmt: skip
    reactions = [setup.reaction(r) for r in setup.rows]
    lines = [
        Equation((r.force, value), label=f"force-of{setup.suffix}-{r.name}", kind=EquationKind.FORCE)
        for r, value in zip(reactions, motion.forces, strict=True)
    ]
    long = any(
        count_operations(line.sides[1]) > LONGEST_INTERMEDIATE for line in lines if isinstance(line.sides[1], sp.Expr)
    )
    names = {r.called for r in reactions}
    what = "reaction" if len(names) > 1 else names.pop()
    of = plural(len(motion.elimination.dependent), "The equation for ", "The equations for ")
    gives = plural(len(motion.elimination.dependent), " gives the ", " give the ")
    solved = (of, *dependent, *where, gives, plural(len(lines), what, f"{what}s"))
    others = plural(len(free), "the equation for ", "the equations for ")
    if not free:
        end = prose("No coordinate is free: the constraints alone determine the motion.")
    elif not any(row.coefficients[k] != 0 for row in setup.rows for k in motion.elimination.independent):
        clean = plural(len(free), " contains no multiplier and is", " contain no multiplier and are")
        end = prose(capital(others), *listed(free), clean, *scaled)
    elif long:
        ending = (" in long expressions. Substituted into ", others, *listed(free), ", these leave", *scaled)
        return [prose(*solved, *ending), display(*lines, detail=Detail.FULL)]
    else:
        end = prose("Substituting ", plural(len(lines), "this", "these"), " into ", others, *listed(free), " gives",
                    *scaled)  # fmt: skip
    return [prose(*solved), display(*lines), end]
