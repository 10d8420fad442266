"""Geometric constraints in an order in which they can be solved one after the other.

    f_1 fixes s_1,   f_2 fixes s_2 once s_1 is known,   ...

The order is found from its end: a coordinate that occurs in one constraint only can be solved for last, whatever the
others are, and so can k coordinates that occur in k constraints only (x, y of a joint held by two rods). Removing these
constraints shortens the problem and excludes nothing. Linear equations are preferred to quadratic ones. Where no
coordinate serves, a parameter may (the length of a rod), then the value of an undefined function.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import combinations, islice
from typing import TypeVar

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, Graph, Op, UnsupportedError
from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.limits import (
    BLOCK_TRIALS,
    CHOICES_OF_UNKNOWNS,
    DRAWS,
    LARGEST_BLOCK,
    LONGEST_RULE,
    MOST_COMBINATIONS,
    MOST_FAILED_BLOCKS,
    MOST_SHARED_ROOTS,
    MOST_TRIED_BLOCKS,
)
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.solved_blocks import ContradictoryError, NotSolvableError, SolvedBlock
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import partial, t

Places = tuple[int, ...]
Unknowns = tuple[sp.Expr, ...]
Fresh = Callable[[Graph], FieldPoint]
AnyPoint = TypeVar("AnyPoint", bound=Point)


@record
class SolutionOrder:
    """Constraints in the order in which they are solved.

    blocks  to be solved one after the other
    rules   symbols that a linear equation gives, expressed by symbols that none gives: x = R(θ + φ)
    roots   how many square roots are taken on the way: each has two branches
    """

    blocks: tuple[SolvedBlock, ...]
    rules: Mapping[sp.Symbol, sp.Expr]
    roots: int = 0

    @cached_property
    def own(self) -> tuple[tuple[sp.Symbol, ...], ...]:
        """For each block the symbols that occur neither in one before it nor among its unknowns."""
        met: set[sp.Symbol] = set()
        own = []
        for block in self.blocks:
            symbols = {s for f in block.constraints for s in f.free_symbols}
            own.append(tuple(sorted(symbols - met - {*block.unknowns}, key=str)))
            met |= symbols
        return tuple(own)

    def solved(self, point: AnyPoint) -> tuple[AnyPoint, int]:
        """A point on the surface, made from a random one, and how many roots that took.

        Where a root does not exist, only the symbols of that block are drawn again. Raises UnsolvedBlockError.
        """
        roots = 0
        for n, (block, own) in enumerate(zip(self.blocks, self.own, strict=True)):
            # Each root exists at half of the points. Twelve rods in a row would take 2^12 draws of the whole point, but
            # only two or so of each block's own symbols.
            for _ in range(BLOCK_TRIALS if own else 1):
                try:
                    roots += block.solve(point)
                    break
                except InadmissibleError:
                    point = point.redrawn(own)
                except (NotSolvableError, ContradictoryError):
                    raise UnsolvedBlockError(n) from None
            else:
                raise UnsolvedBlockError(n)
        return point, roots

    def drawn(self, fresh: Callable[[], AnyPoint], draws: int) -> AnyPoint | None:
        """A point on the surface, or None after so many attempts."""
        for _ in range(draws):
            try:
                return self.solved(fresh())[0]
            except UnsolvedBlockError:
                continue
        return None


class UnsolvedBlockError(Exception):
    """A block was not solved."""

    def __init__(self, block: int) -> None:
        super().__init__(block)
        self.block = block


def triangular_order(
    constraints: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol], fresh: Fresh
) -> SolutionOrder | None:
    """The constraints in a triangular order, or None when none was found.

    fresh  draws a random point of the space without constraints, on which solutions are tried
    """
    if not constraints:
        return SolutionOrder((), {})
    try:
        search = _OrderSearch(Graph(), constraints, coordinates, fresh)
        while (blocks := search.peeled()) is not None:
            order = SolutionOrder(tuple(blocks), _explicit(blocks, coordinates))
            if _roots_of_shared(order) > MOST_SHARED_ROOTS:
                return None
            roots, failing = _tried(order, fresh)
            if failing is None:
                if coordinates and any(u not in coordinates for b in blocks for u in b.unknowns):
                    # x = 0 with x = a fixes the parameter a: a contradiction for all but one a.
                    return None if contradiction(constraints, coordinates, fresh) else replace(order, roots=roots)
                return replace(order, roots=roots)
            # A block that is solvable on its own may fail where the earlier ones hold: never again, and search anew.
            search.banned.add(failing)
    except (UnsupportedError, DivisionByZeroError):
        pass
    return None


def contradiction(constraints: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol], fresh: Fresh) -> Places:
    """Places of a minimal set of constraints that exclude one another, or () if none was found."""

    def excluded(places: Sequence[int]) -> bool:
        return _contradicts(SolvedBlock(tuple(constraints[n] for n in places), tuple(coordinates)), fresh)

    places = list(range(len(constraints)))
    try:
        if not excluded(places):
            return ()
        # Without any that is not needed: the ones reported are all to blame.
        for n in list(places):
            fewer = [m for m in places if m != n]
            if excluded(fewer):
                places = fewer
    except (UnsupportedError, DivisionByZeroError):
        return ()
    return tuple(places)


def _explicit(blocks: Sequence[SolvedBlock], coordinates: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """Explicit solutions s = E for coordinates that occur linearly in their constraint, if E is short."""
    rules: dict[sp.Symbol, sp.Expr] = {}
    for block in blocks:
        if len(block.unknowns) != 1 or len(block.constraints) != 1 or block.unknowns[0] not in coordinates:
            continue
        [f], [s] = block.constraints, block.unknowns
        slope = partial(f, s)
        if slope == 0 or slope.has(s):
            continue
        value = (-f.xreplace({s: sp.S.Zero}) / slope).xreplace(rules)
        if count_operations(value) <= LONGEST_RULE:
            rules[s] = value
    return rules


def _contradicts(block: SolvedBlock, fresh: Fresh) -> bool:
    graph = Graph()
    for _ in range(BLOCK_TRIALS):
        try:
            block.solve(fresh(graph))
        except ContradictoryError:
            return True
        except InadmissibleError:
            continue
        except NotSolvableError:
            return False
        return False
    return False


def _roots_of_shared(order: SolutionOrder) -> int:
    """The number of constraints with roots of already fixed values; k such roots exist at 2^-k of a field's points."""
    blocks = zip(order.blocks, order.own, strict=True)
    return sum(not own and any(_has_root(f) for f in b.constraints) for b, own in blocks)


def _has_root(f: sp.Expr) -> bool:
    return any(p.exp.is_Rational and not p.exp.is_Integer and p.free_symbols for p in f.atoms(sp.Pow))


def _tried(order: SolutionOrder, fresh: Fresh) -> tuple[int, SolvedBlock | None]:
    """How many roots drawing a point takes, and the block at which it always fails, if one does."""
    # The block at which the luckiest draw failed is to blame: those before it have been solved.
    graph = Graph(order.rules)
    furthest = redrawn = 0
    for _ in range(DRAWS):
        try:
            return order.solved(fresh(graph))[1], None
        except UnsolvedBlockError as failure:
            furthest = max(furthest, failure.block)
            redrawn += bool(order.own[failure.block])
        if redrawn == MOST_FAILED_BLOCKS:
            break
    return 0, order.blocks[furthest]


class _OrderSearch:
    """Removes constraints from the end."""

    def __init__(
        self, graph: Graph, constraints: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol], fresh: Fresh
    ) -> None:
        self.graph = graph
        self.constraints = constraints
        self.coordinates = coordinates
        self.fresh = fresh
        self.nodes = [graph.node(f) for f in constraints]
        self.banned: set[SolvedBlock] = set()
        self._tried = 0

    def peeled(self) -> list[SolvedBlock] | None:
        """Blocks that were solvable each on its own."""
        remaining = list(range(len(self.nodes)))
        blocks: list[SolvedBlock] = []
        while remaining:
            last = self._last_block(remaining)
            if last is None:
                return None
            places, block = last
            blocks.append(block)
            remaining = [n for n in remaining if n not in places]
        return blocks[::-1]

    def _last_block(self, remaining: list[int]) -> tuple[Places, SolvedBlock] | None:
        """As few constraints as possible, with as many unknowns that occur in them alone."""
        # The smaller the block, the fewer its roots and the surer its solution. All that remain at once come last.
        sizes = list(range(1, min(len(remaining), LARGEST_BLOCK) + 1))
        if len(remaining) > LARGEST_BLOCK:
            sizes.append(len(remaining))
        for size in sizes:
            block = self._best(self._candidates(remaining, size, self._coordinates))
            if block:
                return block
        return self._best(self._candidates(remaining, 1, self._parameters)) or self._best(
            self._candidates(remaining, 1, self._functions)
        )

    def _candidates(
        self, remaining: list[int], size: int, unknowns: Callable[[int], Sequence[sp.Expr]]
    ) -> Iterator[tuple[Places, Unknowns]]:
        where: dict[sp.Expr, list[int]] = {}
        for n in remaining:
            for u in unknowns(n):
                where.setdefault(u, []).append(n)
        # Of five hundred constraints only those matter that have an unknown in common with few others, or none at all.
        inside = {n for places in where.values() for n in places}
        relevant = {n for places in where.values() if len(places) <= size for n in places}
        if size == len(remaining) or (size == 1 and len(inside) < len(remaining)):
            relevant.update(remaining)
        for places in islice(combinations(sorted(relevant), size), MOST_COMBINATIONS):
            own = [u for u, occurrences in where.items() if set(occurrences) <= {*places}]
            # Fewer unknowns than constraints suffice where constraints are redundant: tried on all that are
            # left, and on a constraint without coordinates, which may be an identity.
            if len(own) >= size or len(places) == len(remaining) or inside.isdisjoint(places):
                for chosen in islice(combinations(own, min(size, len(own))), CHOICES_OF_UNKNOWNS):
                    yield places, chosen

    def _best(self, candidates: Iterator[tuple[Places, Unknowns]]) -> tuple[Places, SolvedBlock] | None:
        """The first that is linear, else the first that is solved at all."""
        best: tuple[Places, SolvedBlock] | None = None
        for places, unknowns in candidates:
            block = SolvedBlock(tuple(self.constraints[n] for n in places), unknowns)
            if block in self.banned or self._tried >= MOST_TRIED_BLOCKS:
                continue
            self._tried += 1
            roots = self._roots_needed(block)
            # Without a root there is one branch, and every point is admissible.
            if roots == 0:
                return places, block
            if roots is not None and best is None:
                best = places, block
        return best

    def _roots_needed(self, block: SolvedBlock) -> int | None:
        """How many roots a block takes, tried where no other constraint is satisfied; None: not solved."""
        for _ in range(BLOCK_TRIALS):
            try:
                return block.solve(self.fresh(self.graph))
            except InadmissibleError:
                continue
            except (NotSolvableError, ContradictoryError):
                return None
        return None

    def _has(self, place: int, unknown: sp.Expr) -> bool:
        node = self.nodes[place]
        if isinstance(unknown, sp.Symbol):
            return bool(self.graph.symbols[node] & self.graph.bit(unknown))
        return self.graph.node(unknown) in self.graph.order(node)

    def _coordinates(self, place: int) -> list[sp.Expr]:
        return [q for q in self.coordinates if self._has(place, q)]

    def _parameters(self, place: int) -> list[sp.Expr]:
        """Parameters of a constraint on coordinates; one on parameters alone is not for us to satisfy."""
        if self.coordinates and not self._coordinates(place):
            return []
        known = {*self.coordinates, t}
        return [s for s in self.graph.bits if s not in known and self._has(place, s)]

    def _functions(self, place: int) -> list[sp.Expr]:
        graph = self.graph
        order = graph.order(self.nodes[place])
        return [graph.expressions[n] for n in order if graph.operations[n] == Op.UNSPECIFIED]
