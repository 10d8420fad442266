"""Stated frequencies of small oscillations: are they right, and all of them?

A list has the frequencies ω of one equilibrium. Each must be a root of the characteristic equation, by exact
substitution, so that no closed form is needed; all different ones must be there, with or without the frequency 0. A
root ω² that is negative for all values of the parameters is no frequency. Several lists belong to several equilibria.
A list is tried at every equilibrium, in every set of coordinates, and the best verdict counts.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import read_value
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations

_BEST = (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.UNDECIDED, Verdict.WRONG)


def check_frequencies(
    stated: Sequence[Sequence[Fragment]], linearizations: Sequence[Linearization], reference: Reference
) -> Verdict:
    """The verdict on all lists together."""
    at = [s for f in linearizations for s in f.at if s is not None and s.oscillates and s.characteristic is not None]
    if not at:
        return Verdict.UNDECIDED
    try:
        lists = [[_read(f, reference) for f in fragments] for fragments in stated]
    except ProblemError:
        return Verdict.UNREADABLE
    values = dict(reference.values)
    verdicts = [min((_verdict(claims, s, values) for s in at), key=_BEST.index) for claims in lists]
    return max(verdicts, key=_BEST.index)


def _read(fragment: Fragment, reference: Reference) -> sp.Expr:
    value = read_value(fragment, reference.scope, [])
    if isinstance(value, Vector):
        raise ProblemError(Diagnostic("vector-for-scalar", "a frequency is a number, not a vector", fragment.whole))
    return value


def _verdict(claims: Sequence[sp.Expr], s: SmallOscillations, values: dict[sp.Symbol, sp.Rational]) -> Verdict:
    """The verdict on one list at one equilibrium."""
    claims = [c.xreplace(values) for c in claims]
    assert s.characteristic is not None
    polynomial = s.characteristic.xreplace(values)
    try:
        right = [is_zero(polynomial.xreplace({s.unknown: c})) for c in claims]
        if None in right or False in right:
            return Verdict.WRONG if False in right else Verdict.UNDECIDED
        nonzero = [c for c in claims if is_zero(c) is False]
        same = [is_zero(a**2 - b**2) for a, b in combinations(nonzero, 2)]
    except DivisionByZeroError:
        return Verdict.WRONG
    if None in same:
        return Verdict.UNDECIDED
    repeated = sum(v is True for v in same)
    return Verdict.EQUIVALENT if len(nonzero) - repeated == sum(_degrees(s)) else Verdict.INCOMPLETE


def _degrees(s: SmallOscillations) -> Iterator[int]:
    """The number of different frequencies of each factor, without zero and roots ω² known to be negative."""
    factors = {f.factor: f for f in s.frequencies}
    growing = {(f.factor, f.square) for f in s.frequencies if f.square is not None and sign_of(f.square) == -1}
    for f in factors.values():
        if f.factor != f.letter:
            yield int(sp.degree(f.factor, f.letter)) - sum(factor == f.factor for factor, _ in growing)
