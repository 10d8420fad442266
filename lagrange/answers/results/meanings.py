"""Right results for something else: other meanings of letters, other moments of inertia; and wrong dimensions.

Other meanings of the letters of a right result: what a wrong one is, stated in symbols, if it is right with them.

A result in symbols follows from forces, arms, masses and coefficients of friction. Where one of these was taken for
another one, omitted, reversed or counted twice throughout, the wrong result is the right one with another expression
for a letter: μ → −μ is friction that acts the other way, ν → 0 a wall without friction, h → c an arm taken for another.

Wrong values whose dimensions betray them: terms that cannot be added, or a length where a speed is asked for.

Wrong values and conditions that are right for bodies with other moments of inertia.

A quantity that is asked for, or the friction that rolling needs, contains the moment of inertia as a number: 2/5, 1/2.
So the problem is solved once more with a letter J for it, and the stated result is compared with the right one for
J = 0 (the rotation is ignored) and for the moments of inertia of other standard bodies.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from itertools import combinations

import sympy as sp

from lagrange.answers.limits import MOST_OTHER_BODIES, UNITS_OF_OTHER_BODIES
from lagrange.answers.models.kinetic import BODIES, RATIOS
from lagrange.answers.references import Identical
from lagrange.core.diagnostics import ProblemError
from lagrange.core.effort import allowed_for
from lagrange.core.records import record
from lagrange.core.units import unit_of_dimension
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.keys import Assumption
from lagrange.problem.model import Parameter, Problem
from lagrange.values.dimensions import mismatch

Substitution = Mapping[sp.Basic, sp.Expr]


@record
class LetterMeaning:
    """An interpretation of the letters in a correct result; `clause` continues "this is the result"."""

    clause: str
    rule: Substitution


def other_meanings(
    right: Collection[sp.Symbol], stated: Collection[sp.Symbol], coefficients: Collection[sp.Expr] = ()
) -> Iterator[LetterMeaning]:
    """The other meanings of the letters of a right result, the likeliest first.

    right, stated  the letters of the right result and of the one that is stated
    coefficients   those of friction
    """
    letters, used = sorted(right, key=lambda p: (p not in coefficients, str(p))), sorted(stated, key=str)
    for p in letters:
        if p in coefficients:
            yield LetterMeaning(f"for friction with the coefficient {p} that acts the other way", {p: -p})
    for p in letters:
        if p in stated and p in coefficients:
            yield LetterMeaning(f"with 1/{p} in place of {p}", {p: 1 / p})
    missing = [p for p in letters if p not in stated]
    for p in missing:
        what = f"without the friction that has the coefficient {p}" if p in coefficients else f"without {p}"
        yield LetterMeaning(f"{what}, as if {p} = 0", {p: sp.S.Zero})
    for p in missing:
        for q in used:
            yield LetterMeaning(f"with {q} in place of {p}", {p: q})
    for p, q in combinations(letters, 2):
        if p in stated and q in stated:
            yield LetterMeaning(f"with {p} and {q} exchanged", {p: q, q: p})
    for p in letters:
        if p in stated and p not in coefficients:
            yield LetterMeaning(f"with the opposite sign of {p}", {p: -p})
            yield LetterMeaning(f"with 2*{p} in place of {p}", {p: 2 * p})
            yield LetterMeaning(f"with {p}/2 in place of {p}", {p: p / 2})


def with_waves_exchanged(expressions: Collection[sp.Expr]) -> Iterator[LetterMeaning]:
    """Sine for cosine of one angle."""
    waves = {w.args[0] for e in expressions for w in e.atoms(sp.sin, sp.cos, sp.tan)}
    for angle in sorted(waves, key=str):
        if angle.is_Symbol:
            clause = (
                f"with sine and cosine of {angle} exchanged, as if it were measured from the perpendicular direction"
            )
            yield LetterMeaning(clause, {angle: sp.pi / 2 - angle})


# Dimensions


def wrong_dimension(claim: sp.Expr, units: Mapping[sp.Symbol, str], right: sp.Expr | None = None) -> str:
    """What is wrong with the dimensions of a value, in a sentence; empty if nothing is, or that is not known.

    right  a value of the dimension that is expected
    """
    inside = mismatch([claim], units)
    if inside is not None:
        first, second = (text(e, Notation()) for e in (inside.term, inside.other))
        return (
            f"its terms have different dimensions: {first} is in {unit_of_dimension(inside.dimension)}, "
            f"{second} in {unit_of_dimension(inside.expected)}"
        )
    if right is None or claim == 0 or right == 0 or (apart := mismatch([right, claim], units)) is None:
        return ""
    if mismatch([right], units) is not None:
        return ""  # a logarithm that was parted, log(m g + c v) - log(m g), has no dimension that could be compared
    stated, expected = apart.dimension, apart.expected
    if apart.term == right:
        stated, expected = expected, stated
    given, asked = unit_of_dimension(stated), unit_of_dimension(expected)
    return f"its dimension is wrong: it is in {given}, and what is asked for is in {asked}"


# Other bodies


Inertias = Mapping[sp.Symbol, sp.Expr]


def other_bodies(solution: Solution, question: str | None = None) -> tuple[Solution, list[tuple[str, Inertias]]] | None:
    """The problem solved with letters for its moments of inertia, and what these are in changed problems, each with
    the end of a sentence; None if there are none with numbers in them, or it cannot be solved so.

    question  the one that is wanted, by its name; None if none is: each takes as long as the motion
    """
    solved = _with_letters(Identical(solution), question)
    return None if solved is None else (solved[0], list(_changes(solved[1])))


@lru_cache(maxsize=8)
def _with_letters(
    same: Identical, question: str | None
) -> tuple[Solution, dict[str, tuple[sp.Symbol, sp.Expr]]] | None:
    problem: Problem = same.solution.problem
    letters = {}
    bodies = []
    for b in problem.bodies:
        if len(b.inertia) == 1 and b.inertia[0].free_symbols and not b.inertia[0].is_Symbol:
            letters[b.name] = sp.Symbol(f"J_of_{b.name}", positive=True), b.inertia[0]
            b = replace(b, inertia=(letters[b.name][0],))
        bodies.append(b)
    if not letters or len(letters) > MOST_OTHER_BODIES:
        return None
    more = tuple(Parameter(j, Assumption.POSITIVE) for j, _ in letters.values())
    asked = tuple(q for q in problem.questions if q.name == question)
    changed = replace(
        problem, bodies=tuple(bodies), parameters=(*problem.parameters, *more), questions=asked, answers=None
    )
    try:
        with allowed_for("comparing answers", UNITS_OF_OTHER_BODIES):
            return solve(changed), letters
    except ProblemError:
        return None


def _changes(letters: Mapping[str, tuple[sp.Symbol, sp.Expr]]) -> Iterator[tuple[str, Inertias]]:
    own: dict[sp.Symbol, sp.Expr] = dict(letters.values())
    for name, (j, _) in letters.items():
        yield f"without the rotation of `{name}`", {**own, j: sp.S.Zero}
    for name, (j, moment) in letters.items():
        for ratio in RATIOS:
            value = ratio * moment
            body = BODIES.get(value.as_coeff_Mul()[0]) if len(moment.free_symbols) == 2 else None
            if body is not None:
                clause = f"with the moment of inertia {text(value, Notation())} for `{name}`, which {body} has"
                yield clause, {**own, j: value}
