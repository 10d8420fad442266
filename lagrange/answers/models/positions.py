"""Wrong positions of rest beside the derived ones, where these are known as a value of a sine, cosine or tangent.

    tan(theta) = cot(beta) - cot(alpha)      of      2 tan(theta) = cot(alpha) - cot(beta)

The values are compared as those of a question are: the letters exchanged, a number, a term, a special case.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.limits import LONGEST_SQUARE
from lagrange.answers.models.questions import explained_value
from lagrange.answers.verdicts import Subject
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium

_WAVES = (sp.sin, sp.cos, sp.tan)


def explained_position(wrong: Sequence[sp.Expr], e: Equilibrium, subject: Subject) -> str:
    """What one wrong equation for a position is instead, in a sentence; empty if not found.

    wrong  its terms on one side
    """
    coordinates = {*e.configuration.slots.coordinates}
    for branch in e.branches if len(wrong) == 1 else ():
        for relation in branch.relations:
            if not (isinstance(relation.lhs, _WAVES) and relation.lhs.args[0] in coordinates):
                continue
            right = _by_sines(relation.rhs)
            claim = _value(wrong[0], relation.lhs)
            if claim is None or (claim.free_symbols | right.free_symbols) & coordinates:
                continue
            if max(sp.count_ops(claim), sp.count_ops(right)) > LONGEST_SQUARE:
                continue
            try:
                if why := next(_differences(claim, right, relation.lhs, subject), ""):
                    return why
            except (DivisionByZeroError, NoPointError, UnsupportedError):
                continue
    return ""


def _value(equation: sp.Expr, wave: sp.Expr) -> sp.Expr | None:
    """The value of a sine, cosine or tangent of a coordinate by an equation; None if it does not give one."""
    q = wave.args[0]
    if (slope := sp.diff(equation, q)).is_number and slope != 0:
        angle = sp.expand(q - equation / slope)
        return _by_sines(wave.func(angle)) if angle.is_number else None
    stand_in = sp.Dummy()
    with_it = equation.xreplace(
        {wave: stand_in, sp.cot(q): 1 / stand_in} if isinstance(wave, sp.tan) else {wave: stand_in}
    )
    with_it = sp.numer(sp.together(with_it))
    slope = sp.diff(with_it, stand_in)
    if slope == 0 or {stand_in, q} & slope.free_symbols or q in with_it.free_symbols:
        return None
    return _by_sines(-with_it.xreplace({stand_in: sp.S.Zero}) / slope)


def _by_sines(e: sp.Expr) -> sp.Expr:
    """The same with sines and cosines of single angles, one fraction."""
    e = e.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)).replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x))
    return sp.cancel(sp.together(sp.expand_trig(e)))


def _differences(claim: sp.Expr, right: sp.Expr, wave: sp.Expr, subject: Subject) -> Iterator[str]:
    letters = sorted(right.free_symbols, key=str)
    for p, q in combinations([s for s in letters if s in claim.free_symbols], 2):
        if is_zero(claim - right.xreplace({p: q, q: p})) is True:
            yield f"these are the {subject.many} with {p} and {q} exchanged"
    if is_zero(claim + right) is True:
        yield f"{text(wave, Notation())} has the wrong sign"
    if claim != 0 and (why := explained_value(claim, right, set())):
        yield f"in the value of {text(wave, Notation())}: {why}"
    for p in (s for s in letters if s not in claim.free_symbols):
        above = sp.expand(sp.numer(sp.together(right - claim)))
        slope = sp.diff(above, p)
        if slope != 0 and p not in slope.free_symbols:
            special = sp.cancel(-above.xreplace({p: sp.S.Zero}) / slope)
            if special.is_number:
                yield f"these are the {subject.many} for {p} = {text(special, Notation())} alone"
