"""Stated frequencies of small oscillations: are they right, and all of them?

A list has the ω of one equilibrium: each a root of its characteristic equation, by exact substitution, so that this
needs no closed form; as many different ones as there are, the frequency 0 left out or not. A root ω² that is negative
whatever the parameters is no frequency, and is left out. Several lists are those of several equilibria. A list is tried
at every equilibrium, in every set of coordinates, and the best verdict counts.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.exact.exact import DivisionByZeroError, is_zero
from lagrange.answers.equations import Verdict
from lagrange.answers.references import Reference
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import read_value
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations

_BEST = (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.UNDECIDED, Verdict.WRONG)


def check_frequencies(
    stated: Sequence[Sequence[Fragment]], found: Sequence[Linearization], reference: Reference
) -> Verdict:
    """The verdict on all lists together."""
    at = [s for f in found for s in f.at if s is not None and s.oscillates and s.characteristic is not None]
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
    """How many different frequencies each factor has, zero left out, and roots ω² that are known to be negative."""
    factors = {f.factor: f for f in s.frequencies}
    growing = {(f.factor, f.square) for f in s.frequencies if f.square is not None and sign_of(f.square) == -1}
    for f in factors.values():
        if f.factor != f.letter:
            yield int(sp.degree(f.factor, f.letter)) - sum(factor == f.factor for factor, _ in growing)
