"""Equations of an answer about a system at rest: positions of equilibrium, and reactions there.

Positions of equilibrium stated as numbers, where they have no closed form: θ = 0 or θ = 0.902.

Each stated number stands for all numbers that round to it. It is right if one of the positions found numerically is
among these, and the answer is complete if every position is stated. Angles count modulo 2π.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.equilibria import alternatives_of, check_equilibria
from lagrange.answers.limits import EXACT_POSITION
from lagrange.answers.reactions import StatedReactionsAtRest
from lagrange.answers.readings import Reading, decimals_in, read_answer
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import FIRST, AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written
from lagrange.answers.written.reading import read_as_written
from lagrange.answers.written.values import with_value_in_si
from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import Decimal
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium, is_balanced
from lagrange.mechanics.equilibrium.in_numbers import EquilibriaInNumbers, Position
from lagrange.mechanics.nearby.one_state import RestInNumbers
from lagrange.mechanics.results import Solution


def check_statics_answers(answer: Sequence[Fragment], solution: Solution) -> tuple[AnswerVerdict, bool, bool]:
    """The verdict on equations without motion; whether they are about equilibria, and about reactions there."""
    equilibria = [v.equilibrium for v in solution.views if v.equilibrium is not None]
    reference = reference_of_solution(solution)
    at_rest = reactions_at_rest(solution)
    readings = [(f, read_answer(f, reference.scope)) for f in answer] if at_rest else []
    about = [(f, r) for f, r in readings if at_rest and at_rest.mentions_reactions(r)]
    rest = [f for f in answer if all(f is not other for other, _ in about)]
    if not about or at_rest is None:
        verdict = check_equilibria(alternatives_of(answer), equilibria, reference)
        return compared_in_numbers(alternatives_of(answer), verdict, solution), True, False
    groups = _groups(answer, {id(f) for f, _ in about})
    of_force = {id(f): r for f, r in about}
    stated = tuple(
        at_rest.check(of_force[id(f)], _places(positions, reference)) for positions, forces in groups for f in forces
    )
    stated = _in_one_sense(stated, [r for _, r in about])
    together = _all_stated(stated)
    notes = tuple(n for _, r in about for n in r.notes)
    if not rest:
        return AnswerVerdict(together, stated, notes=notes), False, True
    listed = [a for positions, _ in groups if positions for a in alternatives_of(positions)]
    positions = check_equilibria(listed, equilibria, reference)
    both = next(
        (v for v in FIRST if v in (positions.verdict, together) and v is not Verdict.TRIVIAL), positions.verdict
    )
    equations, notes = (*positions.equations, *stated), (*positions.notes, *notes)
    return replace(positions, verdict=both, equations=equations, notes=notes), True, True


def _groups(answer: Sequence[Fragment], about: set[int]) -> list[tuple[list[Fragment], list[Fragment]]]:
    """The positions and the reactions there: a position after a reaction is another one, with its own reactions.

    about  the ids of the equations about reactions
    """
    groups: list[tuple[list[Fragment], list[Fragment]]] = [([], [])]
    for f in answer:
        if id(f) in about:
            groups[-1][1].append(f)
        elif groups[-1][0] and groups[-1][1]:
            groups.append(([f], []))
        else:
            groups[-1][0].append(f)
    return groups


def _places(positions: Sequence[Fragment], reference: Reference) -> list[list[sp.Expr]]:
    """The equations of each alternative among positions."""
    if not positions:
        return []
    readings = [[read_answer(f, reference.scope) for f in a] for a in alternatives_of(positions)]
    return [[e for r in a for e in r.components] for a in readings if not any(r.error for r in a)]


def _in_one_sense(stated: Sequence[EquationVerdict], readings: Sequence[Reading]) -> tuple[EquationVerdict, ...]:
    """The verdicts, in which a force that is right has the same sense wherever it is stated."""
    senses: dict[str, tuple[str, ...]] = {}
    judged = []
    for e, r in zip(stated, readings, strict=True):
        names = {s.name for c in r.components for s in c.free_symbols}
        for name in names if e.verdict is Verdict.EQUIVALENT else ():
            own = tuple(remark for remark in e.remarks if remark.startswith(f"`{name}`"))
            if senses.setdefault(name, own) != own:
                why = f"`{name}` has another sense here than in the answer before"
                e = EquationVerdict(e.text, Verdict.WRONG, why)
        judged.append(e)
    return tuple(judged)


def _all_stated(stated: Sequence[EquationVerdict]) -> Verdict:
    """The verdict on several equations; identities count only if there is nothing else."""
    verdicts = {v.verdict for v in stated}
    return next((v for v in (*FIRST[:-1], Verdict.EQUIVALENT) if v in verdicts), Verdict.TRIVIAL)


def reactions_at_rest(solution: Solution) -> StatedReactionsAtRest | None:
    """The reactions at the equilibria; None if there are no constraints."""
    if solution.law is None or solution.own.reactions_at_rest is None:
        return None
    reactions = [v.reactions_at_rest for v in solution.views if v.reactions_at_rest]
    found = [*_forces_in_numbers(solution)]
    return StatedReactionsAtRest(solution.law.newton, reactions, reference_of_solution(solution), found)


def _forces_in_numbers(solution: Solution) -> Iterator[Mapping[sp.Symbol, sp.Expr]]:
    """The named forces at each equilibrium in the file's coordinates, where these are all found in numbers."""
    own = solution.own
    if own.in_numbers is None or own.in_numbers.numerical is None:
        return
    positions = own.in_numbers.positions
    if solution.law is None or not own.in_numbers.numerical.complete or any(p.branch is not None for p in positions):
        return
    for p in positions:
        yield {name: x.formula for name, x in p.forces.items()}


# Positions in numbers


StatedNumbers = Mapping[sp.Symbol, tuple[float, float, sp.Expr]]


def compared_in_numbers(
    alternatives: Sequence[Sequence[Fragment]], verdict: AnswerVerdict, solution: Solution
) -> AnswerVerdict:
    """The verdict where positions were found numerically and the answer gives numbers; the old one otherwise."""
    if verdict.verdict not in (Verdict.WRONG, Verdict.UNDECIDED, Verdict.INCOMPLETE):
        return verdict
    reference = reference_of_solution(solution)
    for view in solution.views:
        in_numbers = view.in_numbers
        if in_numbers is None or in_numbers.numerical is None:
            continue
        readings = [[read_as_written(with_value_in_si(f, reference), reference.scope) for f in a] for a in alternatives]
        stated = [_stated(a, in_numbers.unknowns, dict(reference.values)) for a in readings]
        if any(s is None for s in stated):
            continue
        exact = [_is_exact(s or {}, view.equilibrium, dict(reference.values)) for s in stated]
        matches = [
            {n for n, p in enumerate(in_numbers.positions) if s and _is_at(s, p, in_numbers, exact=is_exact)}
            for s, is_exact in zip(stated, exact, strict=True)
        ]
        if not all(matches):
            return verdict
        covered = set[int]().union(*matches)
        missing = len(in_numbers.positions) - len(covered)
        equations = tuple(EquationVerdict(r.text, Verdict.EQUIVALENT) for a in readings for r in a)
        whole = Verdict.INCOMPLETE if missing else Verdict.EQUIVALENT
        whole = whole if missing or in_numbers.numerical.complete else Verdict.UNDECIDED
        return AnswerVerdict(whole, equations, missing=missing)
    return verdict


def compared_with_rest(
    alternatives: Sequence[Sequence[Fragment]], rest: RestInNumbers, solution: Solution
) -> AnswerVerdict:
    """The verdict where one position of a large system is known: right if it is stated, otherwise undecided."""
    reference = reference_of_solution(solution)
    readings = [read_as_written(with_value_in_si(f, reference), reference.scope) for a in alternatives for f in a]
    if errors := tuple(d for r in readings if r.error for d in r.error.diagnostics):
        return AnswerVerdict(Verdict.UNREADABLE, unreadable=errors, name="equilibrium")
    stated = _stated(readings, tuple(rest.position), dict(reference.values)) if len(alternatives) == 1 else None
    holds = stated is not None and all(
        abs(number - float(rest.position[u])) <= width + EXACT_POSITION * (1 + abs(number))
        for u, (number, width, _) in stated.items()
    )
    verdict = Verdict.EQUIVALENT if holds else Verdict.UNDECIDED
    equations = tuple(EquationVerdict(r.text, verdict) for r in readings)
    why = "" if holds else "this is not the position found near that of `initial`, and others were not looked for"
    return AnswerVerdict(verdict, equations, name="equilibrium", diagnosis=why)


def _stated(
    readings: Sequence[Reading], unknowns: Sequence[sp.Symbol], values: Mapping[sp.Symbol, sp.Expr]
) -> StatedNumbers | None:
    """The unknowns with their numbers, half a unit of the last place, and the numbers as written, exactly.

    None if the equations are not of this form.
    """
    stated: dict[sp.Symbol, tuple[float, float, sp.Expr]] = {}
    for r in readings:
        components = r.with_decimals or r.components
        unknown = {s for e in components for s in e.free_symbols} & {*unknowns}
        if len(components) != 1 or len(unknown) != 1:
            return None
        [e], [u] = components, unknown
        slope = e.diff(u)
        value = (-e.xreplace({u: sp.S.Zero}) / slope).xreplace(dict(values)) if slope.is_number and slope != 0 else None
        if value is None or any(not isinstance(s, Decimal) for s in value.free_symbols):
            return None
        width = as_written(sp.Add(*(abs(value.diff(d)) * d.half_width for d in decimals_in([value]))))
        number = as_written(value).evalf()
        if not number.is_Float and not number.is_Rational:
            return None
        stated[u] = (float(number), float(width), as_written(value))
    return stated


def _is_exact(stated: StatedNumbers, e: Equilibrium | None, values: Mapping[sp.Symbol, sp.Expr]) -> bool:
    """Whether the conditions of equilibrium hold exactly at the numbers as written: x = 4/3, y = -1."""
    if e is None or e.given:
        return False
    place = {**values, **{u: exact for u, (_, _, exact) in stated.items()}}
    known = {*e.configuration.slots.coordinates, *e.forces} <= place.keys()
    return known and is_balanced(e, lambda x: x.xreplace(place)) is True


def _is_at(stated: StatedNumbers, position: Position, in_numbers: EquilibriaInNumbers, *, exact: bool) -> bool:
    """Whether numbers are those of a position; of one found in numbers only if they are rounded, or hold exactly."""
    for u, (number, width, _) in stated.items():
        if u not in position.coordinates or (position.branch is None and width == 0 and not exact):
            return False
        off = number - position.coordinates[u].number
        if u in in_numbers.angles:
            turn = float(2 * sp.pi)
            off -= turn * round(off / turn)
        if abs(off) > width + EXACT_POSITION * (1 + abs(number)):
            return False
    return True
