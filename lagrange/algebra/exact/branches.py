"""Which signs a value depends on, and whether a sample of points has met them all.

Roots √A_1, ..., √A_k whose radicands are independent modulo squares make one irreducible variety: what is
zero at one generic point of it is zero at all, with every choice of signs (Kummer). They are independent as
soon as no product of some of the A_i has been a square at every point tried, that is, as soon as the
Legendre symbols at several points, as vectors over F_2, have rank k. What the rank falls short of (√(x²), √A
√B √(A B), nested roots) are ambiguous signs: the canonical root is ±R with a sign that changes from point to
point at random. |a|, sign(a) and `Sign` symbols have a sign that can be read at the point: there, all
patterns that occur must have been met.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.graph import Nodes, Op
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.core.symbols import Sign

_CHANCES = 20
_MOST_SIGNS = 5


class Branches:
    """The signs that some nodes depend on.

    ambiguous  how many signs of roots cannot be read at a point
    walls      nodes that change their sign where one of the signs changes
    """

    def __init__(self, graph: Nodes, nodes: Sequence[int], draw: Callable[[], FieldPoint]) -> None:
        needed = [n for n in graph.needed(nodes) if n in graph.branching]
        self._graph = graph
        self._readable = [n for n in needed if graph.operations[n] != Op.ROOT]
        symbols = 0
        for n in nodes:
            symbols |= graph.symbols[n]
        self._signs: list[sp.Symbol] = [s for s, bit in graph.bits.items() if isinstance(s, Sign) and bit & symbols]
        radicands = {graph.data[n][0] for n in needed if graph.operations[n] == Op.ROOT}
        plain = sorted(n for n in radicands if not graph.branching.intersection(graph.order(n)))
        self.ambiguous = len(radicands) - _independent(plain, draw)
        changing = [graph.data[n][0] for n in self._readable]
        self.walls = [*changing, *(sorted(radicands) if self.ambiguous else ())]
        self._patterns: dict[int, None] = {}
        self._met = 0

    @property
    def signs(self) -> int:
        """How many signs there are, of both kinds."""
        return self.ambiguous + len(self._readable) + len(self._signs)

    def meet(self, point: Point) -> None:
        """Count a point."""
        self._met += 1
        negative = [self._is_negative_at(point, n) for n in self._readable]
        negative += [point.input(s) != point.number(1) for s in self._signs]
        self._patterns[sum(bit << n for n, bit in enumerate(negative))] = None

    def _is_negative_at(self, point: Point, node: int) -> bool:
        """The sign of the argument, read from |a| or sign(a)."""
        if self._graph.operations[node] == Op.SIGN:
            return bool(point.at(node) != point.number(1))
        return bool(point.at(node) != point.at(self._graph.data[node][0]))

    @property
    def met(self) -> int:
        """How many points have been counted."""
        return self._met

    @property
    def each_met(self) -> bool:
        """Whether every sign that can be read has been met both ways, though not with every other one."""
        readable = len(self._readable) + len(self._signs)
        changed = 0
        for p in self._patterns:
            changed |= p ^ next(iter(self._patterns))
        return changed == (1 << readable) - 1

    def complete(self, at_least: int) -> bool:
        """Whether the points met will do: every pattern has occurred, and each ambiguous sign by chance."""
        most = _CHANCES << min(self.signs, _MOST_SIGNS)
        if self._met >= max(most, at_least):
            return True
        if self._met < at_least or (self.ambiguous and self._met < _CHANCES << min(self.ambiguous, _MOST_SIGNS)):
            return False
        return self._all_patterns_met()

    def _all_patterns_met(self) -> bool:
        readable = len(self._readable) + len(self._signs)
        patterns = list(self._patterns)
        if len(patterns) == 1 << readable:
            return True
        # Signs may depend on one another, |x| on |x y| |y|: what occurs is an affine space over F_2.
        dimension = _rank([p ^ patterns[0] for p in patterns])
        return self._met >= _CHANCES + readable and len(patterns) == 1 << dimension


def _independent(radicands: Sequence[int], draw: Callable[[], FieldPoint]) -> int:
    """The rank of the Legendre symbols of the radicands at several points."""
    vectors: list[int] = []
    best = 0
    for _ in range(_CHANCES + len(radicands)):
        if best == len(radicands):
            break
        point = draw()
        try:
            negative = [point.field.sign(point.at(n)) == -1 for n in radicands]
        except InadmissibleError:
            continue
        vectors.append(sum(bit << n for n, bit in enumerate(negative)))
        best = _rank(vectors)
    return best


def _rank(vectors: Sequence[int]) -> int:
    """The rank over F_2 of rows given as the bits of integers."""
    basis: list[int] = []
    for v in vectors:
        for b in basis:
            v = min(v, v ^ b)
        if v:
            basis.append(v)
    return len(basis)
