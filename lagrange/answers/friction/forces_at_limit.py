"""Equations of an answer about the forces of impending motion: N_B = μ N_A, N_A + ν N_B = W.

With friction at its limit the reactions follow from the balance of forces. Substituted into an equation of an answer,
they leave an identity (the equation is right, and says nothing about the position), an equation that holds at every
equilibrium, such as that of moments (it is right), or one that does not (it is wrong).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.equilibrium_comparison import EquilibriumComparison
from lagrange.answers.force_names import other_readings
from lagrange.answers.limits import MOST_FRICTION_SIGNS
from lagrange.answers.readings import GivenEquation, Reading, decimals_in, read_answer
from lagrange.answers.references import Reference
from lagrange.answers.written.decimals import numbers_rounding_to
from lagrange.core.diagnostics import Fragment
from lagrange.core.records import record
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.equilibrium.friction.impending_motion import ImpendingMotion
from lagrange.mechanics.equilibrium.friction.linear_inequalities import shortest


@record
class ForcesPutIn:
    """One alternative of an answer with the reactions of a motion put in.

    positions  its equations without reactions
    balance    what the equations with reactions state about the position
    holds      whether the latter hold at every equilibrium; None: undecided
    """

    positions: tuple[Fragment, ...]
    balance: tuple[Fragment, ...]
    holds: bool | None


def forces_put_in(
    alternative: Sequence[Fragment], motion: ImpendingMotion, newton: Newton | None, reference: Reference
) -> ForcesPutIn:
    """The alternative with the meanings of its names of forces that make it right, if there are such."""
    names = names_of_forces(motion, newton)
    readings = [(f, read_answer(f, reference.scope)) for f in alternative]
    about = [(f, r) for f, r in readings if r.error is None and _used(r) & names]
    positions = tuple(f for f, r in readings if all(r is not other for _, other in about))
    if not about or newton is None:
        return ForcesPutIn(tuple(alternative), (), True)
    used = set().union(*(_used(r) for _, r in about)) & names
    tried: ForcesPutIn | None = None
    for rule in _meanings(used, motion, newton):
        put_in = _put_in(about, positions, rule, motion, reference)
        if put_in.holds:
            return put_in
        tried = tried if tried is not None and (tried.holds is None or put_in.holds is False) else put_in
    assert tried is not None
    return tried


def _used(reading: Reading) -> set[sp.Symbol]:
    return set().union(*(e.free_symbols for e in reading.components))


def names_of_forces(motion: ImpendingMotion, newton: Newton | None) -> set[sp.Symbol]:
    """The names of reactions and of the friction forces, which may stand in equations about forces."""
    reactions = newton.reactions if newton is not None else ()
    named = {s for r in reactions for s in (r.multiplier, r.given, r.symbol) if s is not None}
    return named | {s for c in motion.contacts for s in c.components}


def _meanings(used: set[sp.Symbol], motion: ImpendingMotion, newton: Newton) -> Iterator[Mapping[sp.Symbol, sp.Expr]]:
    """The values of the names, those of the derivation first; a friction force may have either direction."""
    forces = {r.name: motion.pressed[r.name] for r in newton.reactions if r.name in motion.pressed}
    values: dict[sp.Symbol, sp.Expr] = {}
    for r in newton.reactions:
        if r.name in forces:
            multiplier = r.per_force * forces[r.name]
            values |= {r.multiplier: multiplier, r.force: forces[r.name]}
            values |= {} if r.symbol is None or r.single is None else {r.symbol: r.single.factor * multiplier}
    friction = {
        c.components[0]: motion.senses[c.name] * (c.sign or 1) * c.coefficient * c.normal * forces[c.reaction.name]
        for c in motion.contacts
        if len(c.components) == 1 and c.reaction.name in forces
    }
    rubbing = [s for s in friction if s in used]
    others = [reading.ratios for reading in other_readings(newton, {s.name for s in used})]
    for ratios in ({}, *others):
        meant = {s: ratios.get(s, sp.S.One) * v for s, v in values.items()}
        for signs in [*product((1, -1), repeat=len(rubbing))][:MOST_FRICTION_SIGNS]:
            yield {**meant, **friction, **{s: n * friction[s] for s, n in zip(rubbing, signs, strict=True)}}


def _put_in(
    about: Sequence[tuple[Fragment, Reading]],
    positions: tuple[Fragment, ...],
    rule: Mapping[sp.Symbol, sp.Expr],
    motion: ImpendingMotion,
    reference: Reference,
) -> ForcesPutIn:
    configuration, values = motion.equilibrium.configuration, dict(reference.values)
    balance: list[Fragment] = []
    verdicts: list[bool | None] = []
    for f, r in about:
        exact = tuple(_in_position(e, rule, configuration) for e in r.components)
        written = tuple(_in_position(e, rule, configuration) for e in r.with_decimals or r.components)
        try:
            if all(is_zero(e) for e in exact) or all(is_zero(e.xreplace(values)) for e in exact):
                continue
        except DivisionByZeroError:
            return ForcesPutIn(positions, (), None)
        verdicts.append(_holds([e.xreplace(values) for e in written], motion, reference))
        if not r.with_decimals:
            balance.append(GivenEquation.of_reading_at(replace(r, components=exact, sides=()), f))
    holds = False if False in verdicts else None if None in verdicts else True
    return ForcesPutIn(positions, tuple(balance), holds)


def _in_position(e: sp.Expr, rule: Mapping[sp.Symbol, sp.Expr], configuration: Configuration) -> sp.Expr:
    return shortest(configuration.rewritten(e.xreplace(dict(rule))))


def _holds(residuals: Sequence[sp.Expr], motion: ImpendingMotion, reference: Reference) -> bool | None:
    """Whether expressions vanish at every equilibrium; None if that is not known."""
    comparison = EquilibriumComparison(motion.equilibrium, dict(reference.values), [[tuple(residuals)]])
    if not comparison.points or comparison.left:
        return None
    verdicts: list[bool | None] = []
    for _, point in comparison.points:
        for e in residuals:
            try:
                value = comparison.solution.at(point, e)
                close = decimals_in([value]) and numbers_rounding_to([value]) is not None
                verdicts.append(True if close else is_zero(value))
            except (NotAlgebraicError, DivisionByZeroError):
                verdicts.append(None)
    return False if False in verdicts else None if None in verdicts else True
