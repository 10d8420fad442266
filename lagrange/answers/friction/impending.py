"""The equilibria of an answer with friction at its limit: each alternative belongs to a direction of slip.

An answer is right if each of its alternatives is an equilibrium for some direction, and complete if it has all of them
for every direction.

Equations of an answer about the forces of impending motion: N_B = μ N_A, N_A + ν N_B = W.

With friction at its limit the reactions follow from the balance of forces. Substituted into an equation of an answer,
they leave an identity (the equation is right, and says nothing about the position), an equation that holds at every
equilibrium, such as that of moments (it is right), or one that does not (it is wrong).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.equilibria import check_equilibria
from lagrange.answers.equilibrium_comparison import EquilibriumComparison
from lagrange.answers.limits import MOST_FRICTION_SIGNS, UNITS_OF_EXPLAINING
from lagrange.answers.readings import GivenEquation, Reading, decimals_in, other_readings, read_answer
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.answers.written.decimals import numbers_rounding_to
from lagrange.core.diagnostics import Fragment
from lagrange.core.effort import within
from lagrange.core.records import all_hold, record
from lagrange.document.math_writer import text
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.equilibrium.friction.impending_motion import ImpendingMotion
from lagrange.mechanics.equilibrium.friction.linear_inequalities import shortest
from lagrange.mechanics.results import Solution

_RIGHT = (Verdict.EQUIVALENT, Verdict.INCOMPLETE)


def check_impending_answers(
    alternatives: Sequence[Sequence[Fragment]],
    motions: Sequence[ImpendingMotion],
    reference: Reference,
    solution: Solution,
) -> AnswerVerdict:
    """The verdict in one set of coordinates; `motions` has each direction of slip."""
    newton = solution.law.newton if solution.law is not None else None
    alternatives = [[_without_logarithm(f, motions, reference) for f in a] for a in alternatives]
    put_in = [[forces_put_in(a, m, newton, reference) for a in alternatives] for m in motions]
    own = [[_positions(p, m, reference) for p in row] for row, m in zip(put_in, motions, strict=True)]
    table = [
        [_judged(p, a, m, reference) for p, a in zip(row, stated, strict=True)]
        for row, stated, m in zip(put_in, own, motions, strict=True)
    ]
    unreadable = next((v for row in table for v in row if v.verdict is Verdict.UNREADABLE), None)
    if unreadable is not None:
        return unreadable
    right = [
        [v.verdict in _RIGHT and not _foreign(p.positions, m, reference) for v, p in zip(row, stated, strict=True)]
        for row, stated, m in zip(table, put_in, motions, strict=True)
    ]
    if all(any(column) for column in zip(*right, strict=True)):
        complete = True
        for row, stated, m in zip(right, own, motions, strict=True):
            kept = [a for a, is_right in zip(stated, row, strict=True) if is_right]
            kept = [a for a in kept if a]
            complete = complete and bool(kept)
            complete = complete and check_equilibria(kept, [m.equilibrium], reference).verdict is Verdict.EQUIVALENT
        return AnswerVerdict(Verdict.EQUIVALENT if complete else Verdict.INCOMPLETE)
    columns = [[row[n].verdict for row in table] for n, _ in enumerate(alternatives)]
    by_motion = [[(row[n], m) for row, m in zip(put_in, motions, strict=True)] for n, _ in enumerate(alternatives)]
    wrong = [
        a
        for a, column, stated in zip(alternatives, columns, by_motion, strict=True)
        if all(v is Verdict.WRONG for v in column) or any(_foreign(p.positions, m, reference) for p, m in stated)
    ]
    if not wrong:
        return AnswerVerdict(Verdict.UNDECIDED)
    return AnswerVerdict(Verdict.WRONG, diagnosis=_explained(wrong, motions, reference, solution))


def _without_logarithm(f: Fragment, motions: Sequence[ImpendingMotion], reference: Reference) -> Fragment:
    """β = log(Q/P)/μ, of an unknown in the law of a belt, as exp(μ β) = Q/P; any other equation unchanged."""
    components = [e for e in read_answer(f, reference.scope).components if isinstance(e, sp.Expr) and e.has(sp.log)]
    for e, m in product(components, motions):
        growths = {p.args[0] for law in m.equilibrium.laws for p in law.atoms(sp.exp)}
        for growth, unknown in product(growths, m.equilibrium.forces):
            rate, rest = sp.expand(e).as_independent(unknown, as_Add=True)[::-1]
            slope, value = rate / unknown, -rest * unknown / rate if rate != 0 else sp.nan
            grown = sp.exp(sp.expand(growth.xreplace({unknown: value})))
            if unknown in growth.free_symbols - slope.free_symbols and not grown.has(sp.exp, sp.log, sp.nan):
                return Fragment.of(f"exp({text(growth)}) = {text(grown)}")
    return f


def _positions(forces: ForcesPutIn, motion: ImpendingMotion, reference: Reference) -> list[Fragment]:
    """The equations of one alternative about positions; those about forces where they are right together with these."""
    stated = [*forces.positions, *forces.balance]
    if not stated:
        return []
    if forces.balance:
        verdict = check_equilibria([stated], [motion.equilibrium], reference).verdict
        if verdict is Verdict.WRONG:  # they hold at the equilibrium, and elsewhere
            stated = [*forces.positions]
    place = [Fragment.of(f"{q} = {text(v)}") for q, v in motion.held.items()]
    return [*stated, *place, *_forces_beside(stated, motion, reference)] if stated else []


def _judged(
    forces: ForcesPutIn, stated: Sequence[Fragment], motion: ImpendingMotion, reference: Reference
) -> AnswerVerdict:
    """The verdict on one alternative for one direction of slip; without positions it is incomplete."""
    if forces.holds is False:
        return AnswerVerdict(Verdict.WRONG)
    verdict = (
        check_equilibria([stated], [motion.equilibrium], reference) if stated else AnswerVerdict(Verdict.INCOMPLETE)
    )
    if forces.holds is None and verdict.verdict in _RIGHT:
        return AnswerVerdict(Verdict.UNDECIDED)
    return verdict


def _explained(
    wrong: Sequence[Sequence[Fragment]],
    motions: Sequence[ImpendingMotion],
    reference: Reference,
    solution: Solution,
) -> str:
    """What wrong limits are instead, in a sentence; empty if that is not found."""
    return within(UNITS_OF_EXPLAINING, lambda: _found_explanation(wrong, motions, reference, solution)) or ""


def _found_explanation(
    wrong: Sequence[Sequence[Fragment]],
    motions: Sequence[ImpendingMotion],
    reference: Reference,
    solution: Solution,
) -> str:
    from lagrange.answers.results.conditions import (
        ONLY_A_NUMBER,
        StatedCondition,
        explained_by_another_solution,
        explained_limits,
    )

    stated = [
        StatedCondition(f.text, c, True)
        for a in wrong
        for f in a
        for c in read_answer(f, reference.scope).components
        if isinstance(c, sp.Expr)
    ]
    relations = [r for m in motions for b in m.equilibrium.branches for r in b.relations]
    coefficients = {c.coefficient for m in motions for c in m.contacts}
    derived = [r.lhs - r.rhs for r in relations]
    reason = explained_limits(stated, derived, coefficients)
    if not reason and len(stated) > 1:  # the two limits of a range, each with the same mistake
        each = [explained_limits([s], derived, coefficients) for s in stated]
        reason = "; ".join(dict.fromkeys(f"`{s.text}`: {why}" for s, why in zip(stated, each, strict=True) if why))
    if not reason or ONLY_A_NUMBER in reason:
        return explained_by_another_solution(stated, solution) or reason
    return reason


def _foreign(alternative: Sequence[Fragment], motion: ImpendingMotion, reference: Reference) -> bool:
    """Whether an answer contains a parameter on which nothing depends here, the kinetic friction for the static one.

    One with a value may stand for its number, W sin α = 20 cos α.
    """
    stated = {s for f in alternative for e in read_answer(f, reference.scope).components for s in e.free_symbols}
    equilibrium = motion.equilibrium
    used = {s for e in equilibrium.expressions for s in e.free_symbols} | {
        s for b in equilibrium.branches for s in _symbols(b)
    }
    return not stated & {*reference.parameters.values()} <= used | reference.values.keys()


def one_a_line(judged: Sequence[Fragment], solution: Solution) -> list[tuple[Fragment, ...]]:
    """Alternatives, each consisting of one equation for positions and all equations for forces."""
    motions = [m for v in solution.views for m in v.impending or ()]
    newton = solution.law.newton if solution.law is not None else None
    names = set().union(*(names_of_forces(m, newton) for m in motions))
    scope = reference_of_solution(solution).scope
    about = [f for f in judged if any(e.free_symbols & names for e in read_answer(f, scope).components)]
    return [(*about, f) for f in judged if all(f is not other for other in about)]


def by_directions(judged: Sequence[Fragment], solution: Solution) -> list[tuple[Fragment, ...]]:
    """Balances and limits sorted by the direction of slip for which they hold; empty if one holds for none.

    About to slide up, P cos α - W sin α - μ N = 0, and about to slide down, P cos α - W sin α + μ N = 0.
    """
    newton = solution.law.newton if solution.law is not None else None
    reference = reference_of_solution(solution)
    made: list[tuple[Fragment, ...]] = []
    for m in next((v.impending for v in solution.views if v.impending), ()):
        names = names_of_forces(m, newton)
        about: list[Fragment] = []
        positions: list[Fragment] = []
        alone = [forces_put_in((f,), m, newton, reference) for f in judged]
        given = [f for f, p in zip(judged, alone, strict=True) if p.holds and not (p.positions or p.balance)]
        for f in judged:  # with N = ..., by which the sense of N is known
            put_in = forces_put_in((*given, *([f] if f not in given else [])), m, newton, reference)
            if _judged(put_in, _positions(put_in, m, reference), m, reference).verdict in _RIGHT:
                is_force = any(e.free_symbols & names for e in read_answer(f, reference.scope).components)
                (about if is_force else positions).append(f)
        made += [(*about, f) for f in positions] or [tuple(about)]
    used = {id(f) for a in made for f in a}
    return [a for a in made if a] if all(id(f) in used for f in judged) else []


def _forces_beside(alternative: Sequence[Fragment], motion: ImpendingMotion, reference: Reference) -> list[Fragment]:
    """T = m g for an unknown force that an answer does not mention: it may state the limit alone."""
    if any(read_answer(f, reference.scope).error is not None for f in alternative):
        return []  # what is not understood may be about that force
    words = {w for f in alternative for w in re.findall(r"[^\W\d]\w*", f.text)}
    # P_min is another name of P
    words |= {s.name for f in alternative if isinstance(f, GivenEquation) for e in f.reading.components for s in _of(e)}
    equilibrium = motion.equilibrium
    if len(equilibrium.branches) != 1 or not (words & {s.name for b in equilibrium.branches for s in _symbols(b)}):
        return []
    relations = [
        r for r in equilibrium.branches[0].relations if r.lhs in equilibrium.forces and r.lhs.name not in words
    ]
    return [Fragment.of(f"{text(r.lhs)} = {text(r.rhs)}") for r in relations]


def _of(e: sp.Expr) -> set[sp.Symbol]:
    return {s for s in e.free_symbols if isinstance(s, sp.Symbol)}


def _symbols(b: Branch) -> set[sp.Symbol]:
    return set().union(*(r.lhs.free_symbols | r.rhs.free_symbols for r in b.relations))


# Forces at limit


@record
class ForcesPutIn:
    """One alternative of an answer, with the reactions of a motion substituted.

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
    """The names of reactions and friction forces that may occur in equations for forces."""
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
    holds = all_hold(verdicts)
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
    return all_hold(verdicts)
