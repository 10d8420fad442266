"""Wrong answers to other questions than that for the equations of motion: equilibria, reactions, frequencies, numbers.

Forces enter these answers through their strengths: the weight W, the stiffness c, the free length l. So a changed
problem is the same problem with another meaning of a letter: an answer is right for a force twice as large if it is
right with c/2 for c, and right without a free length that it does not contain if it is right where l = 0. Both are
decided by the test that decides on the answer itself. A reaction may also be that of the system at rest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import combinations, permutations

import sympy as sp

from lagrange.algebra.exact.linear_algebra import RowSpace
from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    InadmissibleError,
    NoPointError,
    UnsupportedError,
)
from lagrange.answers.limits import MAX_LETTER_VARIATIONS
from lagrange.answers.models.mechanics import Variation
from lagrange.answers.models.search import Models, changed_space
from lagrange.answers.models.states import ModelState
from lagrange.core.symbols import Bounded, Slots, base, prime, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration


def letter_variations(
    answer: Sequence[sp.Expr],
    right: Iterable[sp.Expr],
    slots: Slots,
    known: Iterable[sp.Symbol] = (),
    lengths: Iterable[sp.Basic] = (),
) -> list[Variation]:
    """Other meanings of the letters of an answer, and special cases of letters that only the right conditions have.

    known    letters that are no parameters: unknown forces, multipliers
    lengths  letters of the geometry, which are rarely taken as negative: tried after the others
    """
    return list(_letters(answer, right, slots, {*known}, {*lengths}))[:MAX_LETTER_VARIATIONS]


def _letters(
    answer: Sequence[sp.Expr], right: Iterable[sp.Expr], slots: Slots, known: set[sp.Symbol], lengths: set[sp.Basic]
) -> Iterator[Variation]:
    fixed = {*slots.coordinates, *slots.prescribed, t}
    used, needed = (
        sorted({s for e in es for s in e.free_symbols if base(s) not in fixed and s not in known}, key=str)
        for es in (answer, right)
    )
    missing = [p for p in needed if p not in used]
    for p in missing:
        yield Variation(f"without {p}, as if {p} = 0", f"{p}", values={p: sp.S.Zero})
    for a, b in combinations(used, 2):  # m_1 and m_2
        if a.name.rstrip("0123456789") == b.name.rstrip("0123456789"):
            yield Variation(f"with {a} and {b} exchanged", f"where {a} and {b} belong", rule={a: b, b: a})
    for p in used:
        if isinstance(p, Bounded) and (p.low, p.high) == (0, 1):
            yield Variation(f"with 1 - {p} in place of {p}", f"what {p} is a part of", rule={p: 1 - p})
    for q in slots.coordinates:
        yield Variation(f"for {q} measured the other way", f"the sense of {q}", rule={q: -q})
        if any(q in w.free_symbols for e in answer for w in e.atoms(sp.sin, sp.cos, sp.tan)):
            clause = f"for {q} measured from the opposite direction"
            yield Variation(clause, f"the direction from which {q} is measured", rule={q: sp.pi - q})
    for p in sorted(used, key=lambda p: p in lengths):
        yield Variation(f"for {p} with the opposite sign", f"the sign of {p}", rule={p: -p})
    for p in used:
        for factor, stands in ((sp.Rational(1, 2), f"2*{p}"), (sp.Integer(2), f"{p}/2")):
            yield Variation(f"with {stands} in place of {p}", f"the factor of {p}", rule={p: factor * p})
    waves = {s for e in answer for w in e.atoms(sp.sin, sp.cos, sp.tan, sp.cot) for s in w.free_symbols}
    for q in sorted(waves, key=str):
        rule = {q: sp.pi / 2 - q}
        yield Variation(f"for {q} measured from the perpendicular direction (sine and cosine)", f"{q}", rule=rule)
        if q in slots.coordinates:
            rule = {q: q + sp.pi / 2}
            clause = f"for {q} measured from the perpendicular direction (sine and cosine, with a sign)"
            yield Variation(clause, f"{q}", rule=rule)
    for a, b in combinations(used, 2):
        yield Variation(f"with {a} and {b} exchanged", f"where {a} and {b} belong", rule={a: b, b: a})
    for a, b in permutations(needed, 2):
        if a in missing and b in used:
            yield Variation(f"with {b} in place of {a}", f"where {a} and {b} belong", values={a: b})


def explained_reaction(claim: sp.Expr, models: Models) -> str:
    """A sentence that identifies a wrong reaction; empty if it is not recognised."""
    try:
        states = models.states([claim])
        slots = models.system.configuration.slots
        own = claim.free_symbols
        for resting, clause in _at_rest(models.system.configuration):
            if own.isdisjoint(resting) and all(
                claim_holds(claim, Variation("", "", values=resting), at) for at in states
            ):
                return f"it is the reaction {clause}"
        if balanced := balanced_by_forces(claim, models, states):
            return balanced
        bound = geometry_of(models.system.configuration)
        variations = letter_variations([claim], models.system.equations, slots, models.system.multipliers, bound)
        likely = [v for v in variations if v.values or v.is_exchange]
        for variation in likely:
            if bound.isdisjoint(variation.values) and all(claim_holds(claim, variation, at) for at in states):
                return f"this is the reaction {variation.clause}"
        for number, (_, variation) in enumerate(models.variations):
            if variation.mechanics is None or variation.is_reduced:
                continue
            row, space = states[0].row(claim), models.space(number, variation)
            if row is not None and space is not None and row in space and _follows(claim, variation, states[1:]):
                return f"this is the reaction {variation.clause}"
        if multiple := _multiple_of_reaction(claim, models, states):
            return multiple
        for variation in variations:
            if variation not in likely and all(claim_holds(claim, variation, at) for at in states):
                return f"this is the reaction {variation.clause}"
        system = models.system
        own = {s for e in (*system.equations, *system.accelerated_constraints) for s in e.free_symbols}
        more = sorted(claim.free_symbols - own - bound, key=str)
        if more and not any(base(s) in (*slots.coordinates, *slots.prescribed, t) for s in more):
            return f"the reaction in an arbitrary state does not depend on {', '.join(map(str, more))}"
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError):
        pass
    return ""


def _multiple_of_reaction(claim: sp.Expr, models: Models, states: Sequence[ModelState]) -> str:
    """Whether a reaction is twice or half as large as the right one; a sentence, or empty."""
    forces = [m for m in models.system.multipliers if m in claim.free_symbols]
    for factor, how in ((sp.Rational(1, 2), "half"), (sp.Integer(2), "twice")) if len(forces) == 1 else ():
        [force] = forces
        right = Variation("", "", rule={force: factor * force})
        if all(claim_holds(claim, right, at) for at in states):
            return f"it is {how} as large as it should be"
    return ""


def _at_rest(configuration: Configuration) -> Iterator[tuple[dict[sp.Symbol, sp.Expr], str]]:
    """The system at rest, with prescribed motions at rest as well, and where an angle that the answer lacks is zero."""
    slots = configuration.slots
    driven = {prime(u, order): sp.S.Zero for u in slots.prescribed for order in (1, 2)}
    resting = {**dict.fromkeys(slots.velocities, sp.S.Zero), **driven}
    if any(row.drift.xreplace(resting) != 0 for row in configuration.rows):
        return
    if driven:
        names = " and ".join(map(str, slots.prescribed))
        yield driven, f"for a constant {names}: what {names}' and its derivative contribute is missing"
    constant = f" with constant {' and '.join(map(str, slots.prescribed))}" if driven else ""
    yield resting, f"at rest{constant}: what the velocities contribute is missing"
    bound = {s for row in configuration.rows for a in row.coefficients for s in a.free_symbols}
    for q in slots.coordinates:
        if q not in bound and any(
            q in w.free_symbols for p in configuration.points for w in _waves(p.position.fixed())
        ):
            yield {**resting, q: sp.S.Zero}, f"at rest where {q} = 0"
            yield {q: sp.S.Zero}, f"where {q} = 0"


def _waves(position: Vector) -> set[sp.Basic]:
    return {w for c in position.components for w in c.atoms(sp.sin, sp.cos)}


def balanced_by_forces(claim: sp.Expr, models: Models, states: Sequence[ModelState]) -> str:
    """Whether a reaction balances the other forces in one or two equations of motion, as if nothing were accelerated
    there, and nothing moved."""
    slots = models.system.configuration.slots
    count = len(models.system.equations)
    named = count == len(slots.coordinates)  # of a choice there may be equations of eliminated coordinates as well
    still = dict.fromkeys(slots.velocities, sp.S.Zero)
    for moving in (True, False):
        # A velocity in the equation of an eliminated coordinate is a part of its acceleration.
        if not claim.free_symbols.isdisjoint(still) and not (moving and named):
            continue
        resting = Variation("", "", values={} if moving else still)
        tried = [at if moving else _with_values(at, resting) for at in states]
        for number in (1, 2):
            for chosen in combinations(range(count), number):
                if all(at is not None and _is_balance(claim, chosen, at) for at in tried):
                    names = " and ".join(str(slots.coordinates[k]) for k in chosen) if named else "motion"
                    equations = "equation" if number == 1 and named else "equations"
                    at_rest = "" if moving else " and velocity"
                    where = f"in the {equations} of {names}, as if there were no acceleration{at_rest}"
                    return f"it balances the other forces {where}"
    return ""


def _is_balance(claim: sp.Expr, chosen: Sequence[int], at: ModelState) -> bool:
    """Whether a claim follows from some E_k, and from all of them, without accelerations."""
    count = len(at.slots.coordinates)
    row, zero = at.row(claim), at.point.number(0)
    rows = [[*at.derived[k][: -1 - count], *[zero] * count, at.derived[k][-1]] for k in chosen]
    accelerated = [any(not at.point.arithmetic.vanishes(x) for x in at.derived[k][-1 - count : -1]) for k in chosen]
    space = RowSpace(at.point.arithmetic, rows)
    impossible = [*[zero] * len(at.unknowns), at.point.number(1)]
    if row is None or not any(accelerated) or row not in space or impossible in space:
        return False
    return len(rows) == 1 or all(row not in RowSpace(at.point.arithmetic, [r]) for r in rows)


def _follows(claim: sp.Expr, variation: Variation, states: Sequence[ModelState]) -> bool:
    """Whether a claim follows from a changed system at some states."""
    spaces = [changed_space(variation, at) for at in states]
    rows = [at.row(claim) for at in states]
    return all(s is not None and r is not None and r in s for s, r in zip(spaces, rows, strict=True))


def _with_values(at: ModelState, variation: Variation) -> ModelState | None:
    """A state in the special case of a variation; None if there is none."""
    if not variation.values:
        return at
    try:
        changes = {s: at.point.value(e) for s, e in variation.values.items()}
        return ModelState(at.point.with_values(changes), at.system)
    except (DivisionByZeroError, InadmissibleError, AssertionError):
        return None


def geometry_of(configuration: Configuration) -> set[sp.Basic]:
    """The letters of constraints and positions: a rod of no length is no special case of a rod."""
    places = [c for p in configuration.points for c in p.position.fixed().components]
    tied = [e for row in configuration.rows for e in (*row.coefficients, row.drift, row.finite or sp.S.Zero)]
    return set().union(*(e.free_symbols for e in (*places, *tied, *configuration.expressed.values())))


def claim_holds(claim: sp.Expr, variation: Variation, at: ModelState) -> bool:
    """Whether a claim follows from the system with another meaning of a letter, or in a special case, at a state."""
    special = _with_values(at, variation)
    if special is None:
        return False
    at = special
    row = at.row(claim.xreplace(dict(variation.rule)))
    impossible = [at.point.number(0)] * len(at.unknowns) + [at.point.number(1)]
    return row is not None and impossible not in at.right and row in at.right


def explained_frequencies(claims: Sequence[sp.Expr]) -> Iterator[tuple[str, list[sp.Expr]]]:
    """Explanations of wrong frequencies, each with the frequencies that it implies."""
    nonzero = any(c != 0 for c in claims)
    for sentence, change in _MEANT if nonzero else ():
        yield sentence, [c if c == 0 else change(c) for c in claims]
    for variation in letter_variations(claims, (), Slots(())):
        if variation.rule:
            changed = [c.xreplace(dict(variation.rule)) for c in claims]
            yield f"these are the frequencies {variation.clause}", changed


_OTHER_QUANTITIES: tuple[tuple[str, Callable[[sp.Expr], sp.Expr]], ...] = (
    ("these are the squares of the frequencies", sp.sqrt),
    ("these are the frequencies over 2*pi, and the angular frequencies are asked for", lambda c: 2 * sp.pi * c),
    ("these are the periods and not the frequencies", lambda c: 2 * sp.pi / c),
    ("these are the inverses of the frequencies", lambda c: 1 / c),
)
_MEANT = (
    *_OTHER_QUANTITIES,
    ("these are twice the frequencies", lambda c: c / 2),
    ("these are half of the frequencies", lambda c: 2 * c),
    ("a factor sqrt(2) is missing", lambda c: sp.sqrt(2) * c),
    ("there is a factor sqrt(2) too many", lambda c: c / sp.sqrt(2)),
)
NUMBER_OF_MEANINGS = len(_OTHER_QUANTITIES)
"""How many of `explained_frequencies` are other quantities; the rest are factors, and other meanings of letters."""

NUMBER_WITH_FACTORS = len(_MEANT)
"""How many of them are other quantities or factors."""
