"""Steady motions: which coordinates are cyclic, the conditions, the linear equations about them at constant momenta."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.symbols import prime
from lagrange.document.builders import display, listed, math, paragraph, prose
from lagrange.document.derivation import Block, Detail, Equation, Part, Rule, Step
from lagrange.explain.rest.oscillations import explain_about, explain_omitted, label_about_equilibrium
from lagrange.explain.words import are, branch_conditions, plural, title_in
from lagrange.mechanics.equilibrium.linearization import SmallOscillations
from lagrange.mechanics.momenta.steady_motions import Family, SteadyMotions

ZERO = sp.S.Zero


def explain_steady(steady: SteadyMotions) -> Step:
    """The step on steady motions in one set of coordinates."""
    body = [*_conditions(steady), *_branches(steady)]
    if any(s is not None for f in steady.families for s in f.about.at):
        body.append(_at_constant_momenta(steady))
    for n, (family, b, s) in enumerate(_solutions(steady), start=1):
        body += explain_about(n, b, s, family.about, "steady motion", family.relations(b))
    for family in steady.families:
        body += explain_omitted(family.about, "steady motion", "steady motions")
    return Step(Rule.STEADY, title_in("Steady motions", steady.motion.configuration.name), tuple(body))


def _solutions(steady: SteadyMotions) -> Iterator[tuple[Family, Branch, SmallOscillations | None]]:
    for family in steady.families:
        for b, s in zip(family.about.branches, family.about.at, strict=True):
            yield family, b, s


def _conditions(motions: SteadyMotions) -> Iterator[Block]:
    """Which coordinates are cyclic, and what the equations of motion require of the others."""
    about = motions.families[0].about
    cyclic = [math(q) for q in motions.cyclic]
    rates = [math(prime(q)) for q in motions.cyclic]
    others = [math(q) for q in about.configuration.slots.coordinates]
    verb = plural(len(cyclic), " does not appear in the equations of motion, only its velocity does: it is cyclic.",
                  " do not appear in the equations of motion, only their velocities do: they are cyclic.")  # fmt: skip
    rest: tuple[Part, ...] = (", and ", *listed(others), are(others), "constant too") if others else ()
    steady = prose("In a steady motion ", *listed(rates), are(rates), "constant", *rest, ".")
    shown = list(dict.fromkeys(c.expression for c in motions.general.conditions))
    if not shown:
        yield paragraph(prose(*listed(cyclic), verb), steady, prose("The equations of motion then hold."))
        return
    if _is_contradictory(motions):
        which = plural(len(others), "The equation of motion of ", "The equations of motion of ")
        never = " cannot then hold: there are no steady motions."
        yield paragraph(prose(*listed(cyclic), verb), steady, prose(which, *listed(others), never))
        return
    become = plural(
        len(shown),
        "The equation of motion of the other coordinate becomes",
        "The equations of motion of the others become",
    )
    yield paragraph(prose(*listed(cyclic), verb), steady, prose(become))
    yield display(
        *(Equation((c, ZERO), label=label_about_equilibrium(about, "steady", n)) for n, c in enumerate(shown, 1))
    )


def _is_contradictory(steady: SteadyMotions) -> bool:
    """Whether a condition reads 1 = 0, as where a particle falls: it is not printed."""
    return (
        steady.complete and not [*_solutions(steady)] and any(c.expression.is_number for c in steady.general.conditions)
    )


def _branches(steady: SteadyMotions) -> Iterator[Block]:
    """The solutions of the conditions, and the positions omitted."""
    solutions = [*_solutions(steady)]
    if _is_contradictory(steady):
        return
    if not solutions:
        nowhere = "They cannot be satisfied: there are no steady motions."
        open_ = "Solutions were not found in closed form."
        yield prose(nowhere if steady.complete else open_, detail=Detail.BRIEF)
    else:
        yield prose(
            "This holds for" if steady.complete else "This holds, perhaps besides other solutions not found, for"
        )
    coordinates = {*steady.form.configuration.slots.coordinates}
    for n, (family, b, _) in enumerate(solutions, start=1):
        lines = [Equation((r.lhs, r.rhs)) for r in family.relations(b)]
        if not lines:
            yield prose("all values of the coordinates.")
            continue
        label = label_about_equilibrium(family.about, "at-rest", n)
        anywhere = ("in any position",) if family.rates and not b.equations and _without(family, coordinates) else ()
        lines[-1] = Equation(lines[-1].sides, label=label, condition=branch_conditions(b) or anywhere)
        yield display(*lines, boxed=True, detail=Detail.BRIEF)
    poles = dict.fromkeys(b.equations for b in steady.general.poles)
    places = [part for pole in poles for part in (", or where ", *listed(math(r.lhs, r.rhs) for r in pole))]
    if poles:
        yield prose("Where ", *places[1:], ", the coordinates fail.")


def _without(family: Family, coordinates: set[sp.Symbol]) -> bool:
    """Whether the constant rates are the same in all positions."""
    return not any(e.free_symbols & coordinates for e in family.rates.values())


def _at_constant_momenta(steady: SteadyMotions) -> Block:
    """ξ, and what becomes of the cyclic velocities."""
    about = steady.families[0].about
    coordinates = about.configuration.slots.coordinates
    small = [*listed(math(x) for x in about.displacements)]
    be = prose("Let ", *small, plural(len(coordinates), " be a small change of ", " be small changes of "),
               *listed(math(q) for q in coordinates), ".")  # fmt: skip
    rates = [*listed(math(prime(q)) for q in steady.cyclic)]
    momenta = plural(len(steady.cyclic), "the momentum of ", "the momenta of ")
    kept = plural(len(steady.cyclic), " keeps its value", " keep their values")
    change = plural(len(steady.cyclic), "the momentum", "the momenta")
    if steady.motion.configuration.rows:
        held = prose(*rates, plural(len(steady.cyclic), " changes", " change"), " with ", *small, " so that ",
                     plural(len(steady.cyclic), "its equation of motion holds", "their equations of motion hold"),
                     ", which to first order can be integrated.")  # fmt: skip
        return paragraph(be, held, prose("Terms of second order are neglected."))
    held = prose(*rates, plural(len(steady.cyclic), " changes", " change"), " with ", *small, " so that ", momenta,
                 *listed(math(q) for q in steady.cyclic), kept, f": a change of {change} leads to another steady "
                 "motion nearby.")  # fmt: skip
    return paragraph(be, held, prose("Terms of second order are neglected."))
