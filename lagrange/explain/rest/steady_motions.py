"""Steady motions: which coordinates are cyclic, the conditions, the linear equations about them at constant momenta.

Forced oscillations: the equilibrium, the forced linear equations, the steady state, resonance.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import prime, t
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    EquationKind,
    Part,
    Phrase,
    Purpose,
    Rule,
    Step,
    display,
    listed,
    math,
    paragraph,
    prose,
    series,
)
from lagrange.explain.limits import LONGEST_BESIDE_REST
from lagrange.explain.rest.oscillations import explain_about, explain_omitted, label_about_equilibrium
from lagrange.explain.words import are, branch_conditions, plural, suffix_of, title_in
from lagrange.mechanics.equilibrium.linearization import SmallOscillations
from lagrange.mechanics.equilibrium.response import ForcedEquations, Response, limiting_amplitudes
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.momenta.steady_motions import Family, SteadyMotions
from lagrange.mechanics.rewriting.factors import SIGN_OF_ROOT, both_roots

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


# Response


def explain_response(forced: ForcedEquations, response: Response | None) -> Step:
    """The step on forced oscillations in one set of coordinates; without the steady state where it is not known."""
    body = [*_equations(forced)]
    if response is not None:
        body += [*_steady_state(response), *_resonance(response)]
    return Step(Rule.RESPONSE, title_in("Forced oscillations", forced.configuration.name), tuple(body))


def _label(forced: ForcedEquations, kind: str) -> str:
    return f"{kind}{suffix_of(forced.configuration.name)}"


def _equations(forced: ForcedEquations) -> Iterator[Block]:
    """Where the system is at rest without the drive; the forced linear equations about it."""
    linear, b = forced.linearization, forced.branch
    coordinates = linear.configuration.slots.coordinates
    lines = [Equation((r.lhs, r.rhs)) for r in b.equations]
    others = len(linear.branches) > 1
    if lines:
        lines[-1] = Equation(lines[-1].sides, label=_label(forced, "undriven"), condition=branch_conditions(b))
        stable = forced.free.judgement.stability.verdict is StabilityVerdict.STABLE
        which = " The equilibrium that is stable is" if others and stable else " One of its equilibria is"
        yield prose("Without the drive the system can be at rest.", which if others else " Its equilibrium is")
        yield display(*lines)
    small = [math(x) for x in linear.displacements]
    yield paragraph(
        prose("Let ", *listed(small), plural(len(small), " be the small change of ", " be the small changes of "),
              *listed(math(q) for q in coordinates), "."),
        prose("The drive is small of the same order. To first order the equations of motion are"),
    )  # fmt: skip
    yield display(
        *(
            Equation(sides, label=_label(forced, f"forced-{n}"), kind=EquationKind.FORCED)
            for n, sides in enumerate(forced.sides, 1)
        ),
        boxed=True,
        detail=Detail.BRIEF,
    )


def _steady_state(response: Response) -> Iterator[Block]:
    """The motion with the frequency of the drive: amplitudes and lags, or the motion itself without damping."""
    forced, w = response.forced, response.drive.frequency
    moved = forced.linearization.displacements
    cosine, sine = sp.cos(w * t), sp.sin(w * t)
    if response.is_damped:
        yield prose("The free oscillations die out" if _dies_out(response) else "Beside the free oscillations",
                    ", and" if _dies_out(response) else ",",
                    " the system follows the drive with its frequency ", math(w), ". A sum of ", math(cosine), " and ",
                    math(sine), " satisfies the equations if the coefficients of each agree on both sides, which gives",
                    )  # fmt: skip
    else:
        yield prose("Beside the free oscillations, which nothing damps here, the system follows the drive with its "
                    "frequency ", math(w), ". Substituting a multiple of the drive gives")  # fmt: skip
    motions = enumerate(zip(moved, response.motions, strict=True), start=1)
    lines = [Equation((x, e), label=_label(forced, f"steady-{n}")) for n, (x, e) in motions]
    yield display(*lines, boxed=not response.is_damped)
    amplitudes = zip(response.letters, response.amplitudes, strict=True)
    yield prose(plural(len(moved), "The amplitude is", "The amplitudes are"))
    yield display(
        *(Equation((a, e), label=_label(forced, f"amplitude-{n}")) for n, (a, e) in enumerate(amplitudes, 1)),
        boxed=True,
        detail=Detail.BRIEF,
    )
    yield from _extremes(response)
    yield from _lags(response)


def _extremes(response: Response) -> Iterator[Block]:
    """What the amplitude tends to at low and at high frequency."""
    [letter, *_], w = response.letters, response.drive.frequency
    ends = zip(limiting_amplitudes(response), (ZERO, sp.oo), strict=True)
    clauses = [(math(letter, e, relation="→"), " as ", math(w, end, relation="→")) for e, end in ends if e is not None]
    if clauses:
        yield prose(*series(clauses), ".")


def _dies_out(response: Response) -> bool:
    return response.forced.free.judgement.asymptotic


def _lags(response: Response) -> Iterator[Block]:
    """The phase lag of each coordinate behind the drive."""
    known = [(s, e) for s, e in zip(response.lags, response.phases, strict=True) if e is not None]
    if not known:
        return
    drive = math(response.drive.law)
    if not response.is_damped:
        if any(e != 0 for _, e in known):
            yield prose("Where the coefficient of ", drive, " is positive the motion is in phase with it, where it is "
                        "negative in opposite phase.")  # fmt: skip
        return
    yield prose("Behind ", drive, plural(len(known), " it lags by the angle", " they lag by the angles"))
    lags = (Equation((s, e), label=_label(response.forced, f"lag-{s.name}")) for s, e in known)
    yield display(*lags, boxed=True, detail=Detail.BRIEF)


def _resonance(response: Response) -> Iterator[Block]:
    """The frequencies of resonance, and those at which a coordinate is at rest."""
    w = response.drive.frequency
    if response.resonances and response.is_damped:
        yield prose("The amplitude is greatest at")
        label = _label(response.forced, "resonance")
        yield display(Equation((w**2, response.greatest_at), label=label, condition=("if that is positive",)))
    elif response.resonances:
        count = len(response.resonances)
        words = plural(count, "a frequency of free oscillations", "frequencies of free oscillations")
        without = "resonance there is no steady state, and the amplitude grows without bound as it is approached."
        yield prose(
            "The denominator vanishes at ",
            Phrase(words, Purpose.NOUN),
            Phrase(f": at {without}", Purpose.AFTERMATH, f". At {without}"),
            purpose=Purpose.RESONANCE,
        )
        lines = [
            Equation(sides, label=_label(response.forced, f"resonance-{n}"), kind=EquationKind.RESONANCE)
            for n, sides in enumerate(response.at_resonance)
        ]
        both = both_roots(response.resonances)
        if both is not None:
            lines = [replace(lines[0], sides=(w**2, both), condition=("with ", math(SIGN_OF_ROOT), " = ±1"))]
        yield display(*lines)
    for q, places in zip(response.forced.configuration.slots.coordinates, response.rests, strict=True):
        lines = [
            Equation((w**2, place), label=_label(response.forced, f"rest-{q.name}-{n}"),
                     condition=() if place.is_positive else ("if that is positive",))
            for n, place in enumerate(places)
        ]  # fmt: skip
        if lines:
            yield prose(math(q), " stays at rest, although the system is driven, at")
            yield display(*lines)
            others = [math(*pair) for pair in response.beside(places[0]).items()] if len(places) == 1 else []
            if others and sum(count_operations(e) for e in response.beside(places[0]).values()) <= LONGEST_BESIDE_REST:
                yield prose("There ", *listed(others), ".", detail=Detail.BRIEF)
            if len(places) == 1 and response.is_between_resonances(places[0]):
                yield prose("One of the two resonances lies below this frequency, the other above it.")
