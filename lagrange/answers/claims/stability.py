"""Claims of stability: of a position that a sentence names by its equations, or by no more than a word.

    r = k a/(k − m Ω²), which is stable if k > m Ω²       the equilibrium at θ = 0 is stable because of the friction
    The inclined positions are stable.

The state is found in numbers at random values of the parameters, and the exponents of the small motions about it are
compared with the claim. Of a claim that names no position it is enough that it is true at one of them.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.answers.claims.near_rest import NearRest, near_rest
from lagrange.answers.claims.sentences import Relation, Sentence
from lagrange.answers.claims.trying import Outcome, Values, holds, samples, tried
from lagrange.answers.questions.stability_in_text import AMBIGUOUS, REVERSED, WORD, WRONG_STABILITY
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import EquationVerdict, Verdict
from lagrange.core.records import record
from lagrange.core.symbols import base, prime, symbols_in
from lagrange.mechanics.results import Solution

_INCLINED = re.compile(
    r"\b(?:inclined?|tilted|oblique|slanted|deflected|off[- ]axis|schief|schräg|geneigt\w*|ausgelenkt\w*)\b", re.I
)
_SMALL = re.compile(r"\b(?:small|large|slow|fast|weak|strong|enough|sufficient|klein|groß|langsam|schnell)\w*", re.I)
_OTHERWISE = re.compile(r"otherwise|\belse\b|if\s+not|sonst", re.IGNORECASE)
_STEADY = re.compile(r"steady|circ(?:le|ular)|orbit|kreis|station[aä]r|gleichförmig", re.IGNORECASE)
_UNSTABLE = "it is unstable: the exponents of small motions about it have a positive real part"
_STABLE = "it is stable: no small motion about it grows"


@record
class _Claim:
    """Stable, or unstable, where all conditions are positive, at the position where the equations vanish."""

    stable: bool
    conditions: tuple[sp.Expr, ...]
    position: tuple[sp.Expr, ...]


def on_stability(sentence: Sentence, solution: Solution, reference: Reference) -> EquationVerdict | None:
    """The verdict on what a sentence says of stability; None if it says nothing that can be judged."""
    claims = _claims(sentence, reference)
    if not claims:
        return None
    used = {s for c in claims for e in (*c.conditions, *c.position) for s in symbols_in(e)}
    system = near_rest(solution, used)
    if system is None:
        return None
    outcomes = [_outcome(c, sentence, system, reference) for c in claims]
    if any(
        o is Outcome.FALSE or (o is Outcome.SOMETIMES and c.conditions) for o, c in zip(outcomes, claims, strict=True)
    ):
        wrong = next(c for o, c in zip(outcomes, claims, strict=True) if o is not Outcome.TRUE)
        reversed_ = all(o is Outcome.FALSE for o in outcomes)
        why = _UNSTABLE if wrong.stable else _STABLE
        why = (
            (REVERSED if reversed_ and "exist" not in sentence.words else WRONG_STABILITY) if wrong.conditions else why
        )
        return EquationVerdict.of(sentence.shown, Verdict.WRONG, why)
    if all(o is Outcome.TRUE for o in outcomes):
        return EquationVerdict.of(sentence.shown, Verdict.EQUIVALENT, "")
    return None


def _claims(sentence: Sentence, reference: Reference) -> list[_Claim]:
    """The claims in a sentence; none if one of them cannot be read."""
    matches = [*WORD.finditer(sentence.text)]
    if not matches or AMBIGUOUS.search(sentence.text) or _SMALL.search(sentence.words):
        return []
    first_condition = min((r.start for r in sentence.inequalities), default=len(sentence.text))
    before = first_condition < matches[0].start()
    claims: list[_Claim] = []
    position: tuple[sp.Expr, ...] = ()
    bounds = [0, *(m.end() for m in matches)]
    for n, match in enumerate(matches):
        stop = matches[n + 1].start() if n + 1 < len(matches) else len(sentence.text)
        span = (bounds[n], match.start()) if before else (match.end(), stop)
        conditions = [r.positive(reference.scope) for r in sentence.inequalities if span[0] <= r.start < span[1]]
        if any(c is None for c in conditions):
            return []
        own = [
            r for r in sentence.equations if bounds[n] <= r.start < (stop if n + 1 == len(matches) else match.start())
        ]
        stated = _position(own, reference)
        if stated is None:
            return []
        position = stated or position
        stable = not (match["not"] or match["word"].lower() == "labil")
        if not conditions and _OTHERWISE.search(sentence.text[bounds[n] : stop]) and claims:
            continue  # unstable otherwise
        claims.append(_Claim(stable, tuple(c for c in conditions if c is not None), position))
    return claims


def _position(relations: Sequence[Relation], reference: Reference) -> tuple[sp.Expr, ...] | None:
    """What vanishes at a position; None if an equation is about something else, or cannot be read."""
    components: list[sp.Expr] = []
    slots = reference.scope.slots
    for r in relations:
        reading = r.reading(reference.scope)
        if reading.error is not None:
            return None
        used = {s for e in reading.components for s in symbols_in(e)}
        if used <= {*slots.prescribed}:
            continue  # F = 0: what is prescribed is found with the position
        rates = {prime(q) for q in slots.coordinates}
        if not used & {*slots.coordinates} or not used <= {*slots.coordinates, *reference.parameters.values(), *rates}:
            return None
        components += reading.components
    return tuple(components)


def _outcome(claim: _Claim, sentence: Sentence, system: NearRest, reference: Reference) -> Outcome:
    rewritten = system.view.configuration.rewritten
    conditions = [rewritten(c) for c in claim.conditions]
    position = [rewritten(e) for e in claim.position]
    everything = [*system.balance, *conditions, *position, *(e for m in system.matrices for e in m)]
    symbols = {s for e in everything for s in symbols_in(e)} - {*system.coordinates} - {*system.unknown}
    mentioned = {s for e in (*conditions, *position) for s in symbols_in(e)}
    steady = _STEADY.search(sentence.text) is not None
    symbols = {s for s in symbols if base(s) == s or s in mentioned or (steady and base(s) in system.cyclic)}
    inclined = not position and _INCLINED.search(sentence.text) is not None

    def trial(values: Values) -> Iterator[bool | None]:
        found = []
        for state in system.states(values, position):
            if inclined and all(abs(math.sin(2 * state[q])) < 1e-6 for q in system.unknown if q in system.angles):
                continue
            stated, stable = holds(conditions, state) if conditions else True, system.is_stable(state)
            if stated is not None and stable is not None:
                found.append(stable is (claim.stable if stated else not claim.stable))
        if position or inclined:
            yield from found
        elif found:  # it may be about any of them
            yield any(found)

    fixed = [c for c in conditions if {*c.free_symbols} <= symbols]
    return tried(samples(symbols, fixed, reference.values), trial)
