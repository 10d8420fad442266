"""Exterior forms as dictionaries: increasing indices -> coefficient.

Σ a_I dq_I with I = (i < j < ...). A product moves each differential to its place and changes sign with every exchange;
a differential that occurs twice gives zero.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.forms.potentials import differentiated
from lagrange.core.symbols import Slots

Form = Mapping[tuple[int, ...], sp.Expr]


def one_form(coefficients: Sequence[sp.Expr]) -> Form:
    """Σ a_i dq_i."""
    return {(i,): a for i, a in enumerate(coefficients) if a != 0}


def exterior_derivative(coefficients: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> Form:
    """dω = Σ (∂_i a_j − ∂_j a_i) dq_i ∧ dq_j of a form Σ a_i dq_i."""
    pairs = combinations(enumerate(variables), 2)
    curl = {
        (i, j): differentiated(coefficients[j], q, slots) - differentiated(coefficients[i], r, slots)
        for (i, q), (j, r) in pairs
    }
    return {pair: a for pair, a in curl.items() if a != 0}


def wedge(left: Form, right: Form) -> Form:
    """left ∧ right."""
    total: dict[tuple[int, ...], list[sp.Expr]] = {}
    for i, a in left.items():
        for j, b in right.items():
            if not set(i) & set(j):
                total.setdefault(tuple(sorted(i + j)), []).append(_sign(i + j) * a * b)
    return {k: sp.Add(*terms) for k, terms in total.items()}


def _sign(indices: tuple[int, ...]) -> int:
    """+1 or −1: the number of pairs that stand in the wrong order is even or odd."""
    wrong = sum(indices[a] > indices[b] for a in range(len(indices)) for b in range(a + 1, len(indices)))
    return -1 if wrong % 2 else 1
