"""The solutions of a system of equations, branch by branch: how they are kept, verified, put together and written.

Every point of a branch is put back into the equations, exactly, and one that does not satisfy them is dropped (squaring
brings such points in). Points that are stated alike, θ with cos θ = b/a, make one branch. A branch that another one
contains is dropped. How branches are found: `branching`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace

import sympy as sp

from lagrange.algebra.closed_forms.closed_form import Relation, Values
from lagrange.algebra.closed_forms.presentation import shown
from lagrange.algebra.closed_forms.signs import Condition
from lagrange.algebra.closed_forms.unit_circle import Letters
from lagrange.algebra.exact.exact import DivisionByZeroError, is_zero
from lagrange.core.records import record

MOST_POINTS = 130
"""More points of a branch are not verified one by one: it is undecided whether they all satisfy the equations."""


@record
class Branch:
    """Some of the solutions.

    relations   what determines the unknowns, in the order in which to read it
    conditions  under which it exists
    points      the values of all letters (`unit_circle`) at each of its points; free unknowns are not in it
    common      what holds of the letters at all of them
    special     whether it exists for particular parameters only
    left        equations that could not be solved, each zero
    """

    relations: tuple[Relation, ...]
    conditions: tuple[Condition, ...] = ()
    points: tuple[Values, ...] = ()
    common: Values = field(default_factory=dict)
    special: bool = False
    left: tuple[sp.Expr, ...] = ()

    @property
    def equations(self) -> tuple[Relation, ...]:
        """The relations, and what could not be solved."""
        return (*self.relations, *(Relation(e, sp.S.Zero) for e in self.left))


@record
class SolutionSet:
    """All solutions of a system.

    equations  of the system, each zero
    verified   whether every point satisfies every equation, exactly; None where that is undecided
    """

    equations: tuple[sp.Expr, ...]
    unknowns: tuple[sp.Symbol, ...]
    letters: Letters
    branches: tuple[Branch, ...]
    verified: bool | None = True

    @property
    def solved(self) -> bool:
        """Whether all of it is in closed form."""
        return all(not b.left for b in self.branches)

    def at(self, point: Values, e: sp.Expr) -> sp.Expr:
        """An expression at a point of a branch. Raises NotAlgebraicError."""
        there = resolved(self.letters.read(e), point)
        for root in [r for r in self.letters.roots if r in there.free_symbols]:
            there = there.xreplace({root: sp.sqrt(self.letters.write(resolved(self.letters.roots[root], point)))})
        return self.letters.write(there)


def resolved(e: sp.Expr, values: Values) -> sp.Expr:
    """An expression with the values put in, and in these again."""
    for _ in range(len(values) + 1):
        if not e.free_symbols & values.keys():
            break
        e = e.xreplace(dict(values))
    return e


def sides(e: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """a − b as a and b."""
    terms = sp.Add.make_args(sp.expand(e))
    left = [t for t in terms if not t.could_extract_minus_sign()]
    right = [-t for t in terms if t.could_extract_minus_sign()]
    return sp.Add(*left), sp.Add(*right)


def verified(
    found: Sequence[Branch], equations: Sequence[sp.Expr], letters: Letters
) -> tuple[list[Branch], bool | None]:
    """The branches whose points satisfy the equations, and whether that could be decided of all."""
    kept = []
    verdict: bool | None = True
    for b in found:
        if b.special or b.left:
            kept.append(b)
            continue
        verdicts = [_satisfies(p, equations, letters) for p in b.points]
        if None in verdicts or len(b.points) == MOST_POINTS or {True, False} <= {*verdicts}:
            verdict = None
        points = tuple(p for p, holds in zip(b.points, verdicts, strict=True) if holds is not False)
        if points:
            kept.append(replace(b, points=points))
    return kept, verdict


def _satisfies(point: Values, equations: Sequence[sp.Expr], letters: Letters) -> bool | None:
    """Whether a point satisfies the equations and lies on the circles and under the roots that it belongs to."""
    checked = [resolved(e, point) for e in equations]
    for a in letters.angles.values():
        if a.cosine in point:
            checked.append(resolved(a.cosine**2 + a.sine**2 - 1, point))
    checked += [resolved(r**2 - radicand, point) for r, radicand in letters.roots.items() if r in point]
    verdicts = []
    for e in checked:
        try:
            bad = e.has(sp.zoo, sp.nan, sp.oo)
            verdicts.append(False if bad else is_zero(letters.write(e)))
        except DivisionByZeroError:
            verdicts.append(False)
    return False if False in verdicts else None if None in verdicts else True


def merged(found: Sequence[Branch]) -> list[Branch]:
    """Branches that are stated alike as one."""
    groups: dict[object, Branch] = {}
    for b in found:
        key = (b.relations, b.conditions, b.special, b.left)
        known = groups.get(key)
        points = (*known.points, *(p for p in b.points if p not in known.points)) if known else b.points
        groups[key] = replace(b, points=points[:MOST_POINTS])
    return list(groups.values())


def written(b: Branch, letters: Letters, unknowns: Sequence[sp.Symbol]) -> Branch:
    """The branch with what is known put into its relations, in the order of the unknowns, without letters.

    Angles stay in them where they have several values: z = l sin θ beside tan θ = a.
    """
    owner = letters.of_unknowns
    several = {s for u in unknowns if u in letters.angles for s in letters.angles[u].letters}
    several = {s for s in several if s not in b.common or b.common[s].free_symbols & several}
    known = {s: v for s, v in b.common.items() if s not in several}
    for root, radicand in letters.roots.items():
        there = resolved(radicand, known)
        if root not in known and there != radicand and not letters.unknowns_in(there):
            known[root] = sp.sqrt(letters.write(there))

    def place(r: Relation) -> int:
        used = [unknowns.index(owner[s]) for s in letters.read(r.lhs).free_symbols if s in owner]
        return min(used, default=-1)

    relations = [
        Relation(letters.write(r.lhs), shown(letters.write(resolved(r.rhs, known))))
        for r in sorted(b.relations, key=place)
    ]
    conditions = [
        Condition(
            shown(letters.write(resolved(c.lhs, known))), c.relation, shown(letters.write(resolved(c.rhs, known)))
        )
        for c in b.conditions
    ]
    return replace(b, relations=tuple(relations), conditions=_joined(conditions))


def _joined(conditions: Sequence[Condition]) -> tuple[Condition, ...]:
    """Each condition once; a ≥ b and a ≠ b are a > b."""
    found: dict[tuple[sp.Expr, sp.Expr], set[str]] = {}
    for c in conditions:
        found.setdefault((c.lhs, c.rhs), set()).add(c.relation)
    joined = []
    for (lhs, rhs), relations in found.items():
        for weak, strict in (("≥", ">"), ("≤", "<")):
            if {weak, "≠"} <= relations:
                relations = relations - {weak, "≠"} | {strict}
        joined += [Condition(lhs, relation, rhs) for relation in sorted(relations)]
    return tuple(joined)


def without_repetitions(found: Sequence[Branch]) -> list[Branch]:
    """Without branches that others contain, and without special ones that say more than a relation of parameters."""
    generic = [b for b in found if not b.special]
    if generic:
        found = [b for b in found if not b.special or len(b.relations) == 1]
    kept = []
    for n, b in enumerate(found):
        own = set(b.relations)
        wider = (
            set(o.relations) <= own and not o.left and (set(o.relations) != own or m < n) and len(o.points) >= 1
            for m, o in enumerate(found)
            if m != n
        )
        if b.special or not any(wider):
            kept.append(b)
    return kept


def parameters_given(
    equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]
) -> tuple[list[sp.Expr], dict[sp.Symbol, sp.Expr]]:
    """Equations between parameters alone, solved for one of these: W_1 a = W_2 b."""
    values: dict[sp.Symbol, sp.Expr] = {}
    kept = []
    for e in equations:
        e = e.xreplace(values)
        symbols = sorted(e.free_symbols, key=str)
        if not symbols or e.free_symbols & {*unknowns}:
            kept.append(e)
            continue
        above, _ = sp.fraction(sp.together(e))
        for s in symbols:
            rate = sp.expand(above).diff(s)
            if rate != 0 and s not in rate.free_symbols:
                values[s] = sp.factor(s - above / rate)
                break
        else:
            kept.append(e)
    return kept, values
