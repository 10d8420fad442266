"""Wrong frequencies of small oscillations: those of which changed problem?

At an equilibrium q_0 a changed problem has M_ij = Σ μ_a J_ia J_ja and K_kj = −∂Q_k/∂q_j, and its frequencies satisfy
det(K − ω² M) = 0. The parts of M and K are numbers, at random values of the parameters, so that a changed problem costs
a determinant. What the frequencies of an answer satisfy twice, at values that share nothing, they satisfy always, but
for a chance that nobody has to fear.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import permutations
from random import Random

import sympy as sp

from lagrange.answers.limits import MOST_FREQUENCIES, RANDOM_DIGITS, RANDOM_ZERO_DIGITS
from lagrange.answers.models.mechanics import ForceShare, Inertia, Mechanics
from lagrange.answers.models.pairs import LIKELY
from lagrange.answers.models.search import Models
from lagrange.core.symbols import base, partial, t

_LIKELY = LIKELY | {
    "carried weight left out",
    "mass left out",
    "kinetic energy of one part left out",
    "one half left out",
    "force with another factor",
    "mass of another part",
}
Matrix = list[list[sp.Expr]]

_SMALL = sp.Float(10) ** -RANDOM_ZERO_DIGITS


def explained_by_models(claims: Sequence[sp.Expr], models: Models, at: Callable[[sp.Expr], sp.Expr]) -> str:
    """Of which changed problem these are the frequencies, in a sentence; empty if that is not found.

    at  an expression with the values that the coordinates have at the equilibrium
    """
    m = models.mechanics
    if m is None or not models.is_free or m.slots.prescribed or len(m.slots.coordinates) > MOST_FREQUENCIES:
        return ""
    squares = [sp.expand(c**2) for c in claims]
    letters = {s for e in squares for s in e.free_symbols}
    if any(base(s) in m.slots.coordinates or s == t for s in letters):
        return ""
    draws = [RandomMatrices(m, at, seed) for seed in (1, 2)]
    if any(c != 0 for i in m.inertias for c in i.columns[-1]):  # what a moving frame adds to K is not among the parts
        fixed = all(d.satisfied(squares, m) for d in draws)
        return "these are the frequencies for a frame or support that does not move" if fixed else ""
    for name, variation in models.variations:
        changed = variation.mechanics
        if name in _LIKELY and changed is not None and all(d.satisfied(squares, changed) for d in draws):
            return f"these are the frequencies {variation.clause}"
    for coupling, words in (("inertia", "accelerations"), ("stiffness", "coordinates")):
        if all(d.satisfied(squares, m, without=coupling) for d in draws):
            return f"these are the frequencies without the coupling of the {words}"
    return ""


class RandomMatrices:
    """M and K of changed problems at random values of the parameters."""

    def __init__(self, m: Mechanics, at: Callable[[sp.Expr], sp.Expr], seed: int) -> None:
        self.coordinates = m.slots.coordinates
        self.rest = dict.fromkeys(m.slots.velocities, sp.S.Zero)
        self.at = at
        self.random = Random(seed)
        self.values: dict[sp.Symbol, sp.Rational] = {}
        self.known: dict[object, Matrix] = {}

    def satisfied(self, squares: Sequence[sp.Expr], m: Mechanics, without: str = "") -> bool:
        """Whether all these ω² are of a problem, and a problem has no others."""
        inertia = self.sum([self.of_inertia(i) for i in m.inertias])
        stiffness = self.sum([self.of_force(f) for f in m.forces])
        for matrix, name in ((inertia, "inertia"), (stiffness, "stiffness")):
            if name == without:
                for i in range(len(matrix)):
                    for j in range(len(matrix)):
                        matrix[i][j] = matrix[i][j] if i == j else sp.S.Zero
        roots = [self.number(s) for s in squares]
        if any(not r.is_number or r.is_finite is False for row in (*inertia, *stiffness, roots) for r in row):
            return False
        pulls = [
            sum((self.number(f.shares[k]) * self.number(f.factor) for f in m.forces), sp.S.Zero)
            for k in range(len(inertia))
        ]
        if any(abs(p) > _SMALL for p in pulls):
            return False  # it is no equilibrium of the changed problem
        n = len(inertia)
        whole = determinant(inertia)
        if abs(whole) <= _size(inertia) * _SMALL:
            return False
        # As many as there are coordinates are all roots of a polynomial, which n + 1 values tell from another one.
        tried = [self.random_number() for _ in range(n)] if len(roots) == n else roots
        for value in tried:
            matrix = [[stiffness[i][j] - value * inertia[i][j] for j in range(n)] for i in range(n)]
            expected = whole * sp.prod([r - value for r in roots]) if len(roots) == n else sp.S.Zero
            if abs(determinant(matrix) - expected) > (_size(matrix) + abs(expected)) * _SMALL:
                return False
        return True

    def random_number(self) -> sp.Rational:
        """A random positive number."""
        return sp.Rational(self.random.randint(200, 900), self.random.randint(200, 900))

    def number(self, e: sp.Expr) -> sp.Expr:
        """The value of an expression at the equilibrium."""
        e = self.at(e.xreplace(self.rest))
        for s in sorted(e.free_symbols, key=str):
            if s not in self.values:
                self.values[s] = self.random_number()
        return e.xreplace(self.values).evalf(RANDOM_DIGITS)

    def of_inertia(self, part: Inertia) -> Matrix:
        """g_ij with the factors of a model."""
        n = len(self.coordinates)
        g = self.known.get(part.geometry)
        if g is None:
            columns = [[self.number(c) for c in column] for column in part.columns]
            weights = [self.number(w) for w in part.weights]
            g = [
                [sum((weights[a] * columns[i][a] * columns[j][a] for a in range(3)), sp.S.Zero) for j in range(n)]
                for i in range(n)
            ]
            self.known[part.geometry] = g
        of_pair = dict(part.pairs)
        factor = self.number(part.factor)
        return [
            [
                sp.S.Zero
                if {i, j} & {*part.still}
                else g[i][j] * factor * of_pair.get((min(i, j), max(i, j)), sp.S.One)
                for j in range(n)
            ]
            for i in range(n)
        ]

    def of_force(self, force: ForceShare) -> Matrix:
        """−∂Q_k/∂q_j."""
        k = self.known.get(force.shares)
        if k is None:
            shares = [s.xreplace(self.rest) for s in force.shares]
            k = [[-self.number(partial(s, q)) for q in self.coordinates] for s in shares]
            self.known[force.shares] = k
        factor = self.number(force.factor)
        return [[factor * x for x in row] for row in k]

    def sum(self, parts: Sequence[Matrix]) -> Matrix:
        """The sum of some matrices."""
        n = len(self.coordinates)
        return [[sum((p[i][j] for p in parts), sp.S.Zero) for j in range(n)] for i in range(n)]


def _size(matrix: Matrix) -> sp.Expr:
    return sp.prod([sum(abs(x) for x in row) or 1 for row in matrix])


def determinant(matrix: Matrix) -> sp.Expr:
    """Leibniz' formula: four rows at most."""
    total = sp.S.Zero
    for order in permutations(range(len(matrix))):
        sign = (-1) ** sum(a > b for i, a in enumerate(order) for b in order[i + 1 :])
        total += sign * sp.prod([matrix[i][j] for i, j in enumerate(order)])
    return total
