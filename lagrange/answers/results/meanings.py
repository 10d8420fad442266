"""Other meanings of the letters of a right result: what a wrong one is, stated in symbols, if it is right with them.

A result in symbols follows from forces, arms, masses and coefficients of friction. Where one of these was taken for
another one, omitted, reversed or counted twice throughout, the wrong result is the right one with another expression
for a letter: μ → −μ is friction that acts the other way, ν → 0 a wall without friction, h → c an arm taken for another.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from itertools import combinations

import sympy as sp

from lagrange.core.records import record

Substitution = Mapping[sp.Basic, sp.Expr]


@record
class LetterMeaning:
    """What the letters of the right result are taken for; `clause` continues "this is the result"."""

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
