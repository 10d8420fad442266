"""Wrong frequencies of small oscillations: which changed problem has them?

At an equilibrium q_0 a changed problem has M_ij = Σ μ_a J_ia J_ja and K_kj = −∂Q_k/∂q_j, and its frequencies satisfy
det(K − ω² M) = 0. The parts of M and K are numbers, at random values of the parameters, so that a changed problem costs
a determinant. What the frequencies of an answer satisfy twice, at values that share nothing, they satisfy always,
except with a negligible probability.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations, permutations
from random import Random

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.limits import MOST_FREQUENCIES, MOST_IN_SERIES, RANDOM_DIGITS, RANDOM_ZERO_DIGITS
from lagrange.answers.models.mechanics import AppliedForceKind, ForceShare, Inertia, Mechanics, called
from lagrange.answers.models.one_place import of_damping
from lagrange.answers.models.pairs import LIKELY
from lagrange.answers.models.search import Models
from lagrange.core.symbols import base, partial, t
from lagrange.mechanics.equilibrium.linearization import Linearization

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
    """The changed problem that has these frequencies, in a sentence; empty if none is found.

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
    whole = (v for v in models.variations if not v[1].component)
    parts = (v for v in models.variations if v[1].component)  # at an equilibrium often all of it
    for name, variation in (*whole, *parts):
        changed = variation.mechanics
        if name in _LIKELY and changed is not None and all(d.satisfied(squares, changed) for d in draws):
            return f"these are the frequencies {variation.clause}"
    if len(m.slots.coordinates) == 1 and len(squares) == 1 and (combined := _in_series(squares[0], m, draws)):
        return combined
    for coupling, words in (("inertia", "accelerations"), ("stiffness", "coordinates")):
        if all(d.satisfied(squares, m, without=coupling) for d in draws):
            return f"these are the frequencies without the coupling of the {words}"
    return ""


def _in_series(square: sp.Expr, m: Mechanics, draws: Sequence[RandomMatrices]) -> str:
    """Which springs of a system with one coordinate are combined the wrong way, in series or in parallel."""
    springs = [f for f in m.forces if f.kind in (AppliedForceKind.SPRING, AppliedForceKind.POTENTIAL)]
    if len(springs) > MOST_IN_SERIES:
        return ""
    letters = sorted({s for f in springs for e in f.shares for s in e.free_symbols} - {*m.slots.coordinates}, key=str)
    ways: list[tuple[str, Callable[[RandomMatrices], sp.Expr]]] = []
    for size in range(len(springs), 1, -1):
        for group in combinations(springs, size):
            names = ", ".join(called(f.name) for f in group)
            ways.append((f"with the springs {names} in series, and not side by side", _joined(group, springs)))
            if 1 < size < len(springs):
                others = ", ".join(called(f.name) for f in springs if f not in group)
                both = f"with {names} side by side and in series with {others}, and not all side by side"
                ways.append((both, _sides_joined(group, springs)))
    for a, b in combinations(letters, 2):
        ratio = a * b / (a + b) ** 2
        for said, c in (("in series, and not side by side", ratio), ("side by side, and not in series", 1 / ratio)):
            ways.append((f"with the springs {a} and {b} {said}", lambda d, c=c: d.stiffness(springs) * d.number(c)))  # type: ignore[misc]
    for clause, stiffness in ways:
        if all(d.is_frequency(square, m, stiffness(d), springs) for d in draws):
            return f"these are the frequencies {clause}"
    return ""


def _joined(group: Sequence[ForceShare], springs: Sequence[ForceShare]) -> Callable[[RandomMatrices], sp.Expr]:
    """The stiffness of all springs if those of a group are joined end to end."""

    def stiffness(d: RandomMatrices) -> sp.Expr:
        each = [d.stiffness([f]) for f in group]
        softer = 1 / sum(1 / k for k in each) if all(each) else sp.S.Zero
        return softer + d.stiffness([f for f in springs if f not in group])

    return stiffness


def _sides_joined(group: Sequence[ForceShare], springs: Sequence[ForceShare]) -> Callable[[RandomMatrices], sp.Expr]:
    """The stiffness if a group side by side is joined end to end with the others side by side."""

    def stiffness(d: RandomMatrices) -> sp.Expr:
        a, b = d.stiffness(group), d.stiffness([f for f in springs if f not in group])
        return a * b / (a + b) if a + b else sp.S.Zero

    return stiffness


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
        if any(abs(p) > _SMALL for p in pulls) and not self.is_linear(m):
            return False  # it is no equilibrium of the changed problem
        n = len(inertia)
        whole = leibniz_determinant(inertia)
        if abs(whole) <= _size(inertia) * _SMALL:
            return False
        # As many as there are coordinates are all roots of a polynomial, which n + 1 values tell from another one.
        tried = [self.random_number() for _ in range(n)] if len(roots) == n else roots
        for value in tried:
            matrix = [[stiffness[i][j] - value * inertia[i][j] for j in range(n)] for i in range(n)]
            expected = whole * sp.prod([r - value for r in roots]) if len(roots) == n else sp.S.Zero
            if abs(leibniz_determinant(matrix) - expected) > (_size(matrix) + abs(expected)) * _SMALL:
                return False
        return True

    def is_linear(self, m: Mechanics) -> bool:
        """Whether M and K are the same at all positions: then it does not matter where the equilibrium is."""
        slopes = (partial(s, q) for f in m.forces for s in f.shares for q in self.coordinates)
        parts = (c for i in m.inertias for column in i.columns for c in column)
        return all(e.free_symbols.isdisjoint(self.coordinates) for e in (*slopes, *parts))

    def stiffness(self, forces: Sequence[ForceShare]) -> sp.Expr:
        """K of some forces of a system with one coordinate."""
        return sum((self.of_force(f)[0][0] for f in forces), sp.S.Zero)

    def is_frequency(self, square: sp.Expr, m: Mechanics, stiffness: sp.Expr, springs: Sequence[ForceShare]) -> bool:
        """Whether ω² M is a stiffness of the springs with that of the other forces."""
        others = self.stiffness([f for f in m.forces if f not in springs])
        wanted = self.number(square) * self.sum([self.of_inertia(i) for i in m.inertias])[0][0]
        return bool(abs(wanted - stiffness - others) <= abs(wanted) * _SMALL)

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


def leibniz_determinant(matrix: Matrix) -> sp.Expr:
    """Leibniz' formula: four rows at most."""
    total = sp.S.Zero
    for order in permutations(range(len(matrix))):
        sign = (-1) ** sum(a > b for i, a in enumerate(order) for b in order[i + 1 :])
        total += sign * sp.prod([matrix[i][j] for i, j in enumerate(order)])
    return total


def of_damped(
    claims: Sequence[sp.Expr],
    right: Sequence[Sequence[sp.Expr]],
    linearizations: Sequence[Linearization],
    *,
    squared: bool,
) -> Iterator[str]:
    """What is wrong in claims about ω², or about the decay rates, of damped oscillations; sentences, or empty ones.

    right  those at each equilibrium
    """
    for linearization in linearizations:
        coordinates = linearization.configuration.slots.coordinates
        for s in linearization.at:
            if s is None or not 1 < len(s.system.mass) == len(coordinates):
                continue
            for j, q in enumerate(coordinates):
                mass, damping, stiffness = (x[j][j] for x in (s.system.mass, s.system.damping, s.system.stiffness))
                rate = damping / (2 * mass)
                alone = stiffness / mass - rate**2 if squared else rate
                if damping != 0 and any(_same(c, alone) for c in claims):
                    what = "frequency" if squared else "rate"
                    yield f"that is the {what} of {q} with the other coordinates held fast"
    yield from (of_damping(c, e, squared=squared) for each in right for c in claims for e in each)


def _same(a: sp.Expr, b: sp.Expr) -> bool:
    try:
        return is_zero(a - b) is True
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        return False
