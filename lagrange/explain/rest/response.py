"""Forced oscillations: the equilibrium, the forced linear equations, the steady state, resonance."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import t
from lagrange.document.builders import display, listed, math, paragraph, prose, series
from lagrange.document.derivation import Block, Detail, Equation, Rule, Step
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.words import branch_conditions, plural, suffix_of, title_in
from lagrange.mechanics.equilibrium.driven.response import ForcedEquations, Response, limiting_amplitudes
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.rewriting.factors import SIGN_OF_ROOT, both_roots

ZERO = sp.S.Zero


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
        *(Equation(sides, label=_label(forced, f"forced-{n}")) for n, sides in enumerate(forced.sides, 1)),
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
    """By how much each coordinate lags behind the drive."""
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
    yield display(*(Equation((s, e), label=_label(response.forced, f"lag-{s.name}")) for s, e in known))


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
            Equation((w**2, e), label=_label(response.forced, f"resonance-{n}"))
            for n, e in enumerate(response.resonances)
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
