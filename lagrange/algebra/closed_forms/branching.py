"""A system of equations solved in closed form, branch by branch.

A product that vanishes splits into branches, one for each factor; a coordinate or force that occurs linearly is
eliminated; an equation with one unknown left is solved (`single_equation`). Where the coefficient of what is eliminated
may vanish, that is a branch of its own. What cannot be solved in this way stays in its branch as an equation.

    sin θ (a cos θ − b) = 0      [θ = 0], [θ = π], [cos θ = b/a where a ≥ b]

A factor without unknowns is not zero for generic parameters. It makes a branch (`special`) where it can vanish and
nothing else is asked of the unknowns: W_1 a = W_2 b. The number of steps is bounded.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice, product

import sympy as sp

from lagrange.algebra.closed_forms.conditions import with_shortest_conditions
from lagrange.algebra.closed_forms.eliminations import State, linear, on_circle, parallel, turned, wave
from lagrange.algebra.closed_forms.existence import have_real_solution, real_branches, with_values
from lagrange.algebra.closed_forms.limits import (
    MOST_BRANCH_POINTS,
    MOST_BRANCHINGS,
    UNITS_OF_SOLUTIONS,
)
from lagrange.algebra.closed_forms.polynomial_roots import (
    factored_quotient,
    irreducible_factors,
    numerator,
    solved_for_powers,
    square_root,
    vanish_at_origin_alone,
    without_common_squares,
    zeros_of_even_sum,
)
from lagrange.algebra.closed_forms.signs import SignCondition, different_from_zero, not_negative, sign_of
from lagrange.algebra.closed_forms.single_equation import (
    Relation,
    Root,
    Values,
    one_unknown,
    plain_roots,
    trivial_solutions,
)
from lagrange.algebra.closed_forms.solution_sets import (
    Branch,
    SolutionSet,
    denominators,
    determined,
    merged_branches,
    plain_sides,
    resolved,
    split_at_divisors,
    verified,
    with_divisors,
    with_equal_angles,
    with_known_values,
    without_cancelled,
    without_repetitions,
)
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError, TrigLetters
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.effort import GivenUpError, allowed_for_a_search
from lagrange.core.expression_size import count_operations


class _TooLongError(Exception):
    """The search branches too often."""


def solutions(
    equations: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    first: Sequence[sp.Symbol] = (),
    *,
    known: Mapping[sp.Symbol, sp.Expr] | None = None,
    beside: Sequence[sp.Expr] = (),
    origin: Sequence[sp.Expr] = (),
) -> SolutionSet:
    """The solutions of a system, each of `equations` being zero.

    unknowns  what to solve for; other symbols are parameters
    first     unknowns to be eliminated before others: multipliers, forces
    known     angles that are given, θ = α, modulo 2π
    beside    other expressions that are to be taken at the solutions (`SolutionSet.at`)
    origin    the equations before they were multiplied by denominators: these must have values at a solution

    Raises NotAlgebraicError if a given angle has no letters.
    """
    letters = TrigLetters((*equations, *origin, *beside, *(sp.cos(u) for u in known or ())), unknowns)
    with allowed_for_a_search(UNITS_OF_SOLUTIONS) as allowance:
        try:
            return _solutions(equations, unknowns, first, known or {}, origin, letters)
        except (_TooLongError, GivenUpError) as stop:
            if isinstance(stop, GivenUpError) and allowance.left >= 0:
                raise  # the time is over, and not this allowance used up
    unsolved = (Branch((), left=tuple(equations)),)
    return SolutionSet(tuple(equations), tuple(unknowns), letters, unsolved, None)


def _solutions(
    equations: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    first: Sequence[sp.Symbol],
    known: Mapping[sp.Symbol, sp.Expr],
    origin: Sequence[sp.Expr],
    letters: TrigLetters,
) -> SolutionSet:
    """`solutions`. Raises _TooLongError, GivenUpError."""
    readable, strange = _read(equations, letters)
    divisors = denominators((*readable, *_read(origin, letters)[0]))
    search = _BranchSearch(letters, first)
    branches = list(search.branches(_given(known, without_common_squares(readable, unknowns), letters)))
    branches = [replace(b, left=(*b.left, *strange)) for b in real_branches(branches, letters)]
    if strange and len(unknowns) == 1 and not known:
        branches = _with_origin(branches, (*equations, *origin), unknowns[0], letters)

    def stated(some: Sequence[Branch]) -> list[Branch]:
        alike = merged_branches([with_known_values(b, letters, unknowns) for b in merged_branches(some)])
        parts = [with_equal_angles(part, letters, unknowns) for b in alike for part in determined(b, letters, unknowns)]
        return without_repetitions(with_shortest_conditions(parts))

    # Verified first: a branch without a point left must neither be merged with another one nor contain it.
    regular, singular = split_at_divisors(branches, divisors, letters)
    kept, verdict = verified(regular, readable, letters)
    kept = [without_cancelled(b, readable, letters) for b in kept]
    kept = [(with_values if b.left else with_divisors)(b, divisors, letters) for b in kept]
    return SolutionSet(
        tuple(equations), tuple(unknowns), letters, tuple(stated(kept)), verdict, tuple(stated(singular))
    )


def _with_origin(
    branches: Sequence[Branch], equations: Sequence[sp.Expr], u: sp.Symbol, letters: TrigLetters
) -> list[Branch]:
    """The branches, with u = 0 as a further one if it satisfies all equations: sin θ = c sin((1 + b/a) θ)."""
    try:
        is_solution = all(is_zero(e.xreplace({u: sp.S.Zero})) is True for e in equations)
    except DivisionByZeroError:  # u^(n − 1)
        is_solution = False
    if not is_solution:
        return [*branches]
    values: dict[sp.Symbol, sp.Expr] = {u: sp.S.Zero}
    if u in letters.angles:
        values |= dict(zip(letters.angles[u].letters, (sp.S.One, sp.S.Zero), strict=True))
    excluded = SignCondition(u, "≠", sp.S.Zero)
    others = (replace(b, conditions=(*b.conditions, excluded)) for b in branches)
    return [Branch((Relation(u, sp.S.Zero),), (), (values,), values), *others]


def _read(expressions: Sequence[sp.Expr], letters: TrigLetters) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """The expressions rewritten in letters, and those for which that is impossible."""
    readable, strange = [], []
    for e in expressions:
        try:
            readable.append(letters.read(e))
        except NotAlgebraicError:
            strange.append(e)
    return readable, strange


def _given(known: Mapping[sp.Symbol, sp.Expr], equations: tuple[sp.Expr, ...], letters: TrigLetters) -> State:
    """The state in which some angles are known."""
    values: dict[sp.Symbol, sp.Expr] = {}
    relations = []
    for u, angle in known.items():
        lettered = letters.angles[u]
        values[lettered.cosine], values[lettered.sine] = letters.pair(lettered.measure.xreplace({u: angle}))
        relations.append(Relation(u, angle))
    return State(equations, values, values, tuple(relations), solved=tuple(known))


class _BranchSearch:
    def __init__(self, letters: TrigLetters, first: Sequence[sp.Symbol]) -> None:
        self.letters = letters
        self.first = tuple(first)
        self.steps = 0

    def branches(self, state: State) -> Iterator[Branch]:
        """The branches of a state."""
        self.steps += 1
        if self.steps > MOST_BRANCHINGS:
            raise _TooLongError
        prepared = self._prepared(state)
        if prepared is None:
            return
        state = prepared
        if not state.equations:
            yield self._finished(state)
            return
        if (with_root := self._root_given(state)) is not None:
            yield from self.branches(with_root) if with_root.equations else ()
            return
        for n, e in enumerate(state.equations):
            pieces = self._pieces(e, state)
            if pieces is not None:
                for piece, special in pieces:
                    rest = (*state.equations[:n], *state.equations[n + 1 :])
                    relation = () if not special else (Relation(*plain_sides(self.letters.write(piece))),)
                    yield from self.branches(
                        replace(
                            state,
                            equations=rest if special else (*state.equations[:n], piece, *state.equations[n + 1 :]),
                            relations=(*state.relations, *relation),
                            special=state.special or special,
                        )
                    )
                return
        yield from self._solved(state)

    def _prepared(self, state: State) -> State | None:
        """The equations with the known values substituted, as polynomials; None if they are contradictory."""
        kept = []
        state = self._with_roots(state)
        if any(self._vanishes(a, state) for a in state.nonzero):
            return None
        for e in state.equations:
            changed = resolved(e, state.values) if state.values else e
            if changed.has(sp.zoo, sp.nan):
                return None
            parts = numerator(changed)
            if parts is None:
                state = replace(state, stuck=(*state.stuck, changed))
                continue
            if (e := self._without_squares(parts[0])) == 0:
                continue
            if not self.letters.unknowns_in(e):
                if zero := is_zero(self.letters.write(e)):
                    continue
                if zero is None:
                    state = replace(state, stuck=(*state.stuck, e))
                    continue
                relation = self._for_parameters(e)
                if relation is not None and relation in state.relations:
                    continue  # a symmetric system says it twice
                if relation is None or state.special:
                    return None
                state = replace(state, special=True, relations=(*state.relations, relation))
                continue
            zero_each = zeros_of_even_sum(e, sorted(self.letters.unknowns_in(e), key=str))
            kept += [x for x in zero_each or (e,) if x not in kept]
        return replace(state, equations=tuple(sorted(kept, key=lambda e: (count_operations(e), str(e)))))

    def _vanishes(self, divisor: sp.Expr, state: State) -> bool:
        """Whether a divisor is zero for the known values."""
        parts = numerator(resolved(divisor, state.values))
        if parts is None:
            return False
        reduced = self.letters.reduced(parts[0])
        if reduced.has(sp.zoo, sp.nan):
            return True  # values that were tried make what it contains infinite
        return bool(reduced == 0 or (not self.letters.unknowns_in(reduced) and is_zero(self.letters.write(reduced))))

    def _with_roots(self, state: State) -> State:
        """The state with the values substituted under roots too: √(x² + y²) is √x², another letter, where y = 0."""
        used = {s for e in state.equations for s in e.free_symbols}
        renamed: dict[sp.Symbol, sp.Expr] = {}
        for root in [r for r in self.letters.roots if r in used and r not in state.values]:
            radicand = self.letters.roots[root]
            if radicand.free_symbols.isdisjoint(state.values):
                continue
            changed = factored_quotient(resolved(radicand, state.values))
            if self.letters.unknowns_in(changed):
                renamed[root] = self.letters.root(changed)
            elif sign_of(size := square_root(changed)) == 1:
                renamed[root] = size
        return (
            replace(state, values={**state.values, **renamed}, common={**state.common, **renamed}) if renamed else state
        )

    def _root_given(self, state: State) -> State | None:
        """The state after √D = v is replaced by D = v² where v ≥ 0, and √D by v; no equations where v < 0.

        None if no equation of several unknowns is of this kind.
        """
        for n, e in enumerate(state.equations):
            for root in self.letters.roots:
                if root not in e.free_symbols or root in state.values or len(self.letters.unknowns_in(e)) < 2:
                    continue
                poly = sp.Poly(e, root)
                if poly.degree() != 1 or any(self.letters.unknowns_in(c) for c in poly.coeffs()):
                    continue
                value = factored_quotient(-poly.coeff_monomial(1) / poly.coeff_monomial(root))
                allowed = not_negative(value)
                if allowed is None:
                    return replace(state, equations=())
                rest = (*state.equations[:n], *state.equations[n + 1 :])
                return replace(
                    state,
                    equations=(*rest, self.letters.roots[root] - value**2),
                    values={**state.values, root: value},
                    common={**state.common, root: value},
                    conditions=(*state.conditions, *(c for c in allowed if c not in state.conditions)),
                )
        return None

    def _without_squares(self, e: sp.Expr) -> sp.Expr:
        """The shorter of the polynomial and its reduction by C² + S² = 1; 0 where it is zero."""
        if not e.is_polynomial(*(s for a in self.letters.angles.values() for s in a.letters), *self.letters.roots):
            return e
        reduced = self.letters.reduced(e)
        return reduced if reduced == 0 or not self.letters.unknowns_in(reduced) else e

    def _for_parameters(self, e: sp.Expr) -> Relation | None:
        """An equation between parameters alone, where these may satisfy it."""
        if e.is_number:
            return None
        pieces = irreducible_factors(e) or []
        # Only if exactly one factor can vanish is there one relation between the parameters to state.
        able = [p for p in pieces if p.is_Add and sign_of(p) is None]
        return Relation(*plain_sides(self.letters.write(able[0]))) if len(able) == 1 else None

    def _pieces(self, e: sp.Expr, state: State) -> list[tuple[sp.Expr, bool]] | None:
        """The factors of an equation that may vanish, if there are several, or if something can be divided out."""
        irreducible = irreducible_factors(e)
        if irreducible is None:
            return None
        irreducible = [self._without_equal_roots(p) for p in irreducible]
        # A factor without unknowns is generically not zero and may be divided by. That it might vanish is a branch of
        # its own, asked once at the start, when the equation is still the one that was given.
        pieces = [(p, False) for p in irreducible if self.letters.unknowns_in(p)]
        if not state.values and not state.special:
            for p in irreducible:
                if not self.letters.unknowns_in(p) and p.is_Add and sign_of(p) is None and not self._circular(p):
                    pieces.append((p, True))
        if len(pieces) == 1 and pieces[0][0] in (e, -e):
            return None
        return pieces

    def _without_equal_roots(self, e: sp.Expr) -> sp.Expr:
        """A − B for √A − √B: two distances are equal where their squares are."""
        terms = sp.Add.make_args(e)
        if len(terms) != 2 or not all(s in self.letters.roots for s in (terms[0], -terms[1])):
            terms = terms[::-1]
        if len(terms) != 2 or not all(s in self.letters.roots for s in (terms[0], -terms[1])):
            return e
        parts = numerator(self.letters.roots[terms[0]] - self.letters.roots[-terms[1]])
        return e if parts is None or parts[0] == 0 else parts[0]

    def _circular(self, e: sp.Expr) -> bool:
        return any(s in e.free_symbols for a in self.letters.angles.values() for s in a.letters)

    def _solved(self, state: State) -> Iterator[Branch]:
        """One more unknown found."""
        # Linear first, where the coefficient has no unknowns: no branch is made, and nothing is lost. Then an equation
        # in one unknown, then an angle that others give; a coefficient that may vanish comes last, as it doubles the
        # branches.
        for eliminated in linear(state, self.letters, self.first, with_unknowns=False):
            yield from self.branches(eliminated)
            return
        for n, e in enumerate(state.equations):
            unknowns = self.letters.unknowns_in(e)
            if len(unknowns) != 1:
                continue
            [u] = unknowns
            rest = (*state.equations[:n], *state.equations[n + 1 :])
            roots = self._roots(e, u)
            if roots is None:
                yield from self._mixed(e, u, rest, state)
                return
            # An unknown that occurs nowhere else need not be pursued with both signs: one branch serves, and the signs
            # are combined when its points are listed.
            alone = all(u not in self.letters.unknowns_in(other) for other in rest)
            for root in roots:
                for values in root.values[:1] if alone else root.values:
                    yield from self.branches(
                        replace(
                            state,
                            equations=rest,
                            signs=(*state.signs, root.values) if alone else state.signs,
                            values={**state.values, **values},
                            common={**state.common, **root.shared},
                            relations=(*state.relations, *root.relations),
                            conditions=(*state.conditions, *(c for c in root.conditions if c not in state.conditions)),
                            solved=(*state.solved, u),
                        )
                    )
            return
        fewer = (
            turned(state, self.letters)
            or self._of_powers(state)
            or wave(state, self.letters)
            or linear(state, self.letters, self.first, with_unknowns=True)
            or parallel(state, self.letters)
            or on_circle(state, self.letters)
        )
        for other in fewer:
            yield from self.branches(other)
        if fewer:
            return
        for values in trivial_solutions(state.equations, self.letters):
            yield from self.branches(self._taken(state, (), values))
        yield self._finished(replace(state, equations=(), stuck=(*state.stuck, *state.equations)))

    def _of_powers(self, state: State) -> list[State]:
        """The state with simpler equations for those linear in powers of unknowns, or homogeneous in two of them."""
        used = frozenset[sp.Symbol]().union(*(e.free_symbols for e in state.equations))
        unknowns = frozenset[sp.Symbol]().union(*map(self.letters.unknowns_in, state.equations))
        angles = {u for u in unknowns if u in self.letters.angles}
        if len(unknowns) < 2 or used & angles or used & self.letters.roots.keys():
            return []
        circular = {s for u in angles for s in self.letters.angles[u].letters}
        letters = sorted((unknowns - angles) | (circular & used), key=str)
        if not angles and vanish_at_origin_alone(state.equations, letters):
            return [replace(state, equations=tuple(letters))]
        less = without_common_squares(state.equations, letters)
        simpler = solved_for_powers(state.equations, letters) or (less if less != state.equations else None)
        return [] if simpler is None else [replace(state, equations=simpler)]

    def _taken(self, state: State, rest: tuple[sp.Expr, ...], values: Values) -> State:
        """The state in which some unknowns have trivial values, 0 or π."""
        relations = tuple(Relation(u, v) for u, v in values.items() if u in self.letters.unknowns)
        return replace(
            state,
            equations=rest,
            values={**state.values, **values},
            common={**state.common, **values},
            relations=(*state.relations, *relations),
            solved=(*state.solved, *(r.lhs for r in relations)),
        )

    def _roots(self, e: sp.Expr, u: sp.Symbol) -> list[Root] | None:
        angle = self.letters.angles.get(u)
        if angle is None or u not in e.free_symbols:
            return one_unknown(e, u, self.letters)
        if set(angle.letters) & e.free_symbols:
            return None
        roots = plain_roots(e, u, self.letters)
        if roots is None:
            return None
        completed = []
        for r in roots:
            [values] = r.values
            c, s = self.letters.pair(angle.measure.xreplace({u: self.letters.write(values[u])}))
            completed.append(replace(r, values=({**values, angle.cosine: c, angle.sine: s},)))
        return completed

    def _mixed(self, e: sp.Expr, u: sp.Symbol, rest: tuple[sp.Expr, ...], state: State) -> Iterator[Branch]:
        """An equation that is not solved, such as k θ = m g l sin θ; its root θ = 0 is still found."""
        left = replace(state, equations=rest, stuck=(*state.stuck, e), solved=(*state.solved, u))
        for values in trivial_solutions((e,), self.letters):
            yield from self.branches(self._taken(state, rest, values))
            left = replace(left, conditions=(*left.conditions, SignCondition(u, "≠", values[u])))
        yield from self.branches(left)

    def _finished(self, state: State) -> Branch:
        """The branch, its relations still in letters and as they were found."""
        values, common = dict(state.values), dict(state.common)
        for letter, radicand in self.letters.roots.items():
            if letter not in values:
                values[letter] = self._root_of(resolved(radicand, values)) if not state.signs else sp.sqrt(radicand)
            if letter not in common and not self.letters.unknowns_in(square := resolved(radicand, common)):
                common[letter] = self._root_of(square)
        points = []
        for chosen in islice(product(*state.signs), MOST_BRANCH_POINTS):
            for more in chosen:
                values |= more
            points.append({u: resolved(v, values) for u, v in values.items()})
        left = tuple(self.letters.write(e) for e in state.stuck)
        relations = tuple(dict.fromkeys(state.relations))
        conditions = (*state.conditions, *self._divided(state)) if left else state.conditions
        return Branch(relations, conditions, tuple(points), common, state.special, left)

    def _divided(self, state: State) -> Iterator[SignCondition]:
        """That divisors do not vanish, where equations in numbers are left.

        At an isolated root of these a divisor may vanish, and what was divided need not hold there. With parameters
        that happens for particular values of them only, and a curve of roots is stated with all its points.
        """
        symbols = {s for e in state.stuck for s in self.letters.write(e).free_symbols}
        if not symbols <= {*self.letters.unknowns} or len(state.stuck) < len(symbols - {*self.first}):
            return
        for a in state.nonzero:
            parts = numerator(resolved(a, state.values))
            for p in irreducible_factors(self.letters.shortest(parts[0])) or () if parts else ():
                unknowns = self.letters.unknowns_in(p)
                if not unknowns or not unknowns.isdisjoint(self.first):
                    continue
                if have_real_solution((*state.stuck, p), self.letters) is not False:
                    yield from different_from_zero(p)

    def _root_of(self, radicand: sp.Expr) -> sp.Expr:
        """The root, which is not negative: √((a − b)²) is not a − b."""
        root = square_root(radicand)
        sign = None if self.letters.unknowns_in(root) else sign_of(root)
        return sp.sqrt(radicand) if sign is None else sign * root
