"""Wrong limits of a rope on a rough drum: which of the slips with T = S exp(mu beta) was made.

The coefficient and the angle of contact occur as the product mu beta alone. So the common slips all give mu another
factor: ln for log to base ten, degrees or turns for radians, an angle twice or half as large. Without the exponential,
T = S (1 + mu beta) is the law of a short arc, used for the whole one.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

import sympy as sp

from lagrange.answers.results.meanings import LetterMeaning

_SLIPS = (
    ("with the logarithm to base ten in place of the natural one", sp.log(10)),
    ("with the angle of contact in degrees, and not in radians", 180 / sp.pi),
    ("with the number of turns in place of the angle of contact in radians", 1 / (2 * sp.pi)),
    ("for twice the angle of contact", sp.Integer(2)),
    ("for half of the angle of contact", sp.Rational(1, 2)),
    ("for four times the angle of contact", sp.Integer(4)),
    ("for a quarter of the angle of contact", sp.Rational(1, 4)),
)


def belt_meanings(derived: Collection[sp.Expr], coefficients: Collection[sp.Expr]) -> Iterator[LetterMeaning]:
    """What the coefficient of a belt, or its law, is taken for; none where there is no belt."""
    powers = {w for e in derived for w in e.atoms(sp.exp)}
    logarithms = {w for e in derived for w in e.atoms(sp.log)}
    short = {w: 1 + w.args[0] for w in powers} | {w: w.args[0] - 1 for w in logarithms}
    for mu in sorted(coefficients, key=str):
        linear = any(mu in e.free_symbols for e in derived if e.atoms(sp.log) & logarithms)
        if linear or any(mu in w.free_symbols for w in powers):
            for clause, factor in _SLIPS:
                yield LetterMeaning(clause, {mu: factor * mu})
            yield LetterMeaning("with 1 + mu*beta in place of exp(mu*beta), as for a short arc", short)


def in_logarithms(slack: sp.Expr) -> sp.Expr:
    """A slack a exp(u) - b as u - log(b/a), in which the coefficient of a belt is linear; others as they are."""
    powers = sorted(slack.atoms(sp.exp), key=str)
    if len(powers) != 1:
        return slack
    letter = sp.Dummy(positive=True)
    linear = sp.expand(slack.xreplace({powers[0]: letter}))
    rate, rest = linear.coeff(letter, 1), linear.coeff(letter, 0)
    ratio = -rest / rate if rate != 0 else sp.S.Zero
    if ratio == 0 or letter in (rate.free_symbols | rest.free_symbols) or sp.expand(linear - rate * letter - rest) != 0:
        return slack
    return powers[0].args[0] - sp.log(ratio)
