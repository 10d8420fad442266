"""The solutions of a system of equations, branch by branch: how they are stored, verified, merged and stated.

Every point of a branch is substituted back into the equations, exactly, and one that does not satisfy them is dropped:
squaring, and multiplying by a denominator, introduce such points. Where a denominator vanishes the equations have no
value; these points are kept apart (`SolutionSet.excluded`). Points that are stated alike, θ with cos θ = b/a, make one
branch. A branch contained in another one is dropped. How branches are found: `branching`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import combinations
from math import gcd

import sympy as sp

from lagrange.algebra.closed_forms.limits import MOST_BRANCH_POINTS
from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient, irreducible_factors, shortest_value
from lagrange.algebra.closed_forms.shortest_form import by_stated_root, shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, always_holds, different_from_zero, sign_of
from lagrange.algebra.closed_forms.single_equation import Relation, Values, root_at
from lagrange.algebra.closed_forms.unit_circle import CIRCULAR, NotAlgebraicError, TrigLetters
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import sign_in_range


@record
class Branch:
    """Some of the solutions.

    relations   equations that determine the unknowns, in the order in which to read them
    conditions  under which it exists
    points      the values of all letters (`unit_circle`) at each of its points; free unknowns are not in it
    common      values of letters that hold at all of them
    special     whether it exists for particular parameters only
    left        equations that could not be solved, each zero
    occupied    whether these are known to have a real solution
    closing     whether conditions other than ≠ follow from the equations left: that a triangle closes
    implied     conditions that hold besides and are not stated here: they follow from the others, ranges or contact
    """

    relations: tuple[Relation, ...]
    conditions: tuple[SignCondition, ...] = ()
    points: tuple[Values, ...] = ()
    common: Values = field(default_factory=dict)
    special: bool = False
    left: tuple[sp.Expr, ...] = ()
    occupied: bool = False
    closing: bool = False
    implied: tuple[SignCondition, ...] = ()

    @property
    def may_be_empty(self) -> bool:
        """Whether it is asserted only if its unsolved equations have a real solution, which is left open."""
        return bool(self.left) and not self.occupied

    @property
    def equations(self) -> tuple[Relation, ...]:
        """The relations, and what could not be solved."""
        return (*self.relations, *(_by_tangents(e, self.left) or Relation(e, sp.S.Zero) for e in self.left))


@record
class SolutionSet:
    """All solutions of a system.

    equations  of the system, each zero
    verified   whether every point satisfies every equation, exactly; None if that is undecided
    excluded   where an equation multiplied by its denominator holds, but the denominator vanishes: no solutions
    """

    equations: tuple[sp.Expr, ...]
    unknowns: tuple[sp.Symbol, ...]
    letters: TrigLetters
    branches: tuple[Branch, ...]
    verified: bool | None = True
    excluded: tuple[Branch, ...] = ()

    @property
    def solved(self) -> bool:
        """Whether all of it is in closed form."""
        return all(not b.left for b in self.branches)

    def at(self, point: Values, e: sp.Expr) -> sp.Expr:
        """An expression at a point of a branch. Raises NotAlgebraicError."""
        # Few sines and symbols occur in many terms: each is evaluated by itself, and the terms are put together once.
        values = {part: self._part_at(point, part) for part in parts(e)}
        return e.xreplace({part: value for part, value in values.items() if value != part})

    def _part_at(self, point: Values, part: sp.Expr) -> sp.Expr:
        return self.letters.write(self._with_roots(resolved(self.letters.read(part), point), point))

    def _with_roots(self, value: sp.Expr, point: Values) -> sp.Expr:
        """A value with the letters of roots replaced; roots may be nested, √|x|."""
        for root in [r for r in self.letters.roots if r in value.free_symbols]:
            radicand = self._with_roots(resolved(self.letters.roots[root], point), point)
            value = value.xreplace({root: sp.sqrt(self.letters.write(radicand))})
        return value


def _by_tangents(e: sp.Expr, left: Sequence[sp.Expr]) -> Relation | None:
    """tan α = 3 tan β for sin α cos β − 3 cos α sin β = 0, if another equation excludes cos α = cos β = 0."""
    angles = sorted({w.args[0] for w in e.atoms(sp.sin, sp.cos)}, key=str)
    if len(angles) != 2 or not all(angle.is_Symbol for angle in angles):
        return None
    alpha, beta = angles
    whole = sp.expand(e)
    rates = [whole.coeff(sp.sin(u)).coeff(sp.cos(v)) for u, v in ((alpha, beta), (beta, alpha))]
    products = sp.sin(alpha) * sp.cos(beta), sp.sin(beta) * sp.cos(alpha)
    is_bilinear = sp.expand(whole - rates[0] * products[0] - rates[1] * products[1]) == 0
    if not is_bilinear or any(r.has(alpha, beta) or sign_of(r) not in (1, -1) for r in rates):
        return None
    upright = {sp.cos(alpha): sp.S.Zero, sp.cos(beta): sp.S.Zero}
    others = (sp.expand(other).xreplace(upright) for other in left if other != e)
    if not any(not o.has(alpha, beta) and sign_of(o) in (1, -1) for o in others):
        return None
    one, other = sp.factor(-rates[1] / rates[0]), sp.factor(-rates[0] / rates[1])
    if sp.fraction(one)[1] == 1 or sp.fraction(other)[1] != 1:
        return Relation(sp.tan(alpha), one * sp.tan(beta))
    return Relation(sp.tan(beta), other * sp.tan(alpha))


def agree(
    own: SolutionSet,
    p: Values,
    other: SolutionSet,
    q: Values,
    functions: Sequence[sp.Expr],
    values: Mapping[sp.Symbol, sp.Expr] | None = None,
) -> bool:
    """Whether functions have the same values at points of two solutions; of the second for given parameters."""
    try:
        return all(is_zero(own.at(p, f) - other.at(q, f).xreplace(dict(values or {}))) for f in functions)
    except (NotAlgebraicError, DivisionByZeroError):
        return False


def known_positive(b: Branch, strict: bool = False) -> list[sp.Expr]:
    """Expressions that are positive on a branch, or zero at its ends: by the conditions for its existence, and cos θ
    where it is stated to be positive, cos³ θ = 2a/l.

    strict  only those that cannot be zero
    """
    above = (">",) if strict else (">", "≥")
    below = ("<",) if strict else ("<", "≤")
    conditions = dict.fromkeys((*b.conditions, *b.implied))
    known = [c.lhs - c.rhs for c in conditions if c.relation in above]
    for c in conditions:
        if c.relation in below:
            within = c.lhs.args[0] if isinstance(c.lhs, sp.Abs) else None
            known += [c.rhs - c.lhs] if within is None else [c.rhs - within, c.rhs + within]
    known = [sp.factor(p) for p in known] + [*_positive_waves(b)]
    numerators = (above for above, below in map(sp.fraction, known) if below != 1 and sign_of(below) == 1)
    return [*known, *numerators]


def _positive_waves(b: Branch) -> Iterator[sp.Expr]:
    """The sines, cosines and tangents of which an odd power is stated to be positive."""
    for r in b.relations:
        base, power = r.lhs.as_base_exp()
        if isinstance(base, CIRCULAR) and power.is_Integer and power % 2 == 1 and sign_of(r.rhs) == 1:
            yield base


def at_numbers(b: Branch, expression: sp.Expr, unknowns: Sequence[sp.Symbol]) -> sp.Expr | None:
    """An expression without letters, cos((1 + b/a) θ), where a branch has numbers for the unknowns; otherwise None."""
    value = expression.xreplace({r.lhs: r.rhs for r in b.relations if r.lhs in unknowns and r.rhs.is_number})
    is_known = value.free_symbols.isdisjoint(unknowns) and not value.has(sp.zoo, sp.nan, sp.oo)
    return sp.factor(value) if is_known else None


def parts(e: sp.Expr) -> Iterator[sp.Expr]:
    """The symbols, functions and roots of which an expression consists by sums, products and whole powers."""
    seen: set[sp.Expr] = set()
    left = [e]
    while left:
        part = left.pop()
        if part in seen:
            continue
        seen.add(part)
        if part.is_Add or part.is_Mul:
            left.extend(part.args)
        elif part.is_Pow and part.exp.is_Integer:
            left.append(part.base)
        elif part.is_Symbol or part.args:
            yield part


def resolved(e: sp.Expr, values: Values) -> sp.Expr:
    """An expression with the values substituted, repeatedly, as values may contain letters themselves."""
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


def plain_sides(e: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """a − b as a and b; h and √3 r for 3r² − h², the letters being positive."""
    left, right = sides(e)
    factors = [f.as_base_exp() for side in (left, right) for f in sp.Mul.make_args(side) if not f.is_number]
    powers = [int(p) for base, p in factors if base.is_positive and p.is_Integer]
    if not factors or len(powers) < len(factors) or gcd(*powers) == 1:
        return left, right
    root = sp.Rational(1, gcd(*powers))
    left, right = left**root, right**root
    return (right, left) if right.is_Symbol else (left, right)


def denominators(equations: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """The expressions, in letters, that some equations divide by."""
    powers = (p for e in equations for p in sp.ordered(e.atoms(sp.Pow)) if p.exp.is_negative)
    return tuple(dict.fromkeys(p.base for p in powers if not p.base.is_number))


def split_at_divisors(
    branches: Sequence[Branch], divisors: Sequence[sp.Expr], letters: TrigLetters
) -> tuple[list[Branch], list[Branch]]:
    """The branches where no divisor vanishes, and those where one does."""
    kept: list[Branch] = []
    excluded: list[Branch] = []
    for b in branches:
        if b.special:
            kept.append(b)
            continue
        singular = [any(_vanishes(d, p, letters) for d in divisors) for p in b.points]
        for part, place in ((kept, False), (excluded, True)):
            points = tuple(p for p, at_pole in zip(b.points, singular, strict=True) if at_pole is place)
            if points:
                part.append(replace(b, points=points))
    return kept, excluded


def with_divisors(b: Branch, divisors: Sequence[sp.Expr], letters: TrigLetters) -> Branch:
    """The branch with the conditions on parameters under which no divisor vanishes."""
    conditions = list(b.conditions)
    for d in divisors:
        value = resolved(d, b.common)
        if b.special or b.left or not letters.unknowns_in(d) or letters.unknowns_in(value):
            continue
        above, _ = sp.fraction(sp.together(value))
        conditions += [c for p in _vanishing_factors(above) for c in different_from_zero(p)]
    return replace(b, conditions=tuple(dict.fromkeys(conditions)))


def without_cancelled(b: Branch, equations: Sequence[sp.Expr], letters: TrigLetters) -> Branch:
    """The branch without conditions p ≠ 0 that its values do not need: what was divided by p has cancelled.

    x = k (y − 2a)/(m ω² − k) with y = 2a k/(2k − m ω²) is 2a k/(2k − m ω²), at k = m ω² too: there the equations hold.
    """
    if b.left or b.special or not any(c.relation == "≠" for c in b.conditions):
        return b
    points = [{u: factored_quotient(resolved(v, p)) for u, v in p.items()} for p in b.points]

    def is_needed(c: SignCondition) -> bool:
        difference = sp.expand(c.lhs - c.rhs)
        linear = [s for s in sorted(difference.free_symbols, key=str) if s not in difference.diff(s).free_symbols]
        if c.relation != "≠" or not linear or any(v.atoms(sp.Abs) or has_root(v) for p in points for v in p.values()):
            return True
        s = linear[0]
        place = {s: sp.cancel(s - difference / difference.diff(s))}
        there = [{u: sp.cancel(v.xreplace(place)) for u, v in p.items()} for p in points]
        if any(v.has(sp.zoo, sp.nan) for p in there for v in p.values()):
            return True
        try:
            return not all(is_zero(letters.write(resolved(e.xreplace(place), p))) for e in equations for p in there)
        except DivisionByZeroError:  # the equations have no value there
            return True

    conditions = tuple(c for c in b.conditions if is_needed(c))
    return b if conditions == b.conditions else replace(b, conditions=conditions, points=tuple(points))


def is_one_with_root(equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> bool:
    """Whether it is one equation, with a square root of a sum without unknowns."""
    roots = (p for e in equations for p in e.atoms(sp.Pow) if abs(p.exp) == sp.S.Half and p.base.is_Add)
    return len(equations) == 1 and any(p.free_symbols.isdisjoint(unknowns) for p in roots)


def has_root(e: sp.Expr) -> bool:
    """Whether a root occurs in an expression."""
    return any(not p.exp.is_Integer for p in e.atoms(sp.Pow))


def _vanishing_factors(e: sp.Expr) -> list[sp.Expr]:
    """The sums of which one is zero where an expression is; of √(a² − 2 a b + b²), the length of a spring, a − b."""
    return [q for p in irreducible_factors(e) or () for q in irreducible_factors(p) or () if q.is_Add]


def _vanishes(divisor: sp.Expr, point: Values, letters: TrigLetters) -> bool:
    try:
        return bool(is_zero(letters.write(resolved(divisor, point))))
    except DivisionByZeroError:
        return False


def verified(
    branches: Sequence[Branch], equations: Sequence[sp.Expr], letters: TrigLetters
) -> tuple[list[Branch], bool | None]:
    """The branches whose points satisfy the equations, and whether that could be decided of all."""
    # A branch is found by steps that are right generically: squaring A = −B √D admits the other sign of the root, and a
    # denominator that was multiplied out may vanish. Substitution settles each point without comparing forms.
    kept = []
    verdict: bool | None = True
    for b in branches:
        if b.special or b.left:
            kept.append(b)
            continue
        verdicts = [_satisfies(p, equations, letters) for p in b.points]
        if None in verdicts or len(b.points) == MOST_BRANCH_POINTS:
            verdict = None
        points = tuple(p for p, holds in zip(b.points, verdicts, strict=True) if holds is not False)
        if points:
            kept.append(replace(b, points=points))
    return kept, verdict


def _satisfies(point: Values, equations: Sequence[sp.Expr], letters: TrigLetters) -> bool | None:
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
    return all_hold(verdicts)


def merged_branches(branches: Sequence[Branch]) -> list[Branch]:
    """Branches that are stated alike as one."""
    groups: dict[object, Branch] = {}
    for b in branches:
        key = (b.relations, b.conditions, b.special, b.left)
        known = groups.get(key)
        points = (*known.points, *(p for p in b.points if p not in known.points)) if known else b.points
        groups[key] = replace(b, points=points[:MOST_BRANCH_POINTS])
    return list(groups.values())


def with_known_values(b: Branch, letters: TrigLetters, unknowns: Sequence[sp.Symbol]) -> Branch:
    """The branch with known values substituted in its relations, in the order of the unknowns, without letters.

    Angles stay in them where they have several values: z = l sin θ beside tan θ = a.
    """
    owner = letters.of_unknowns
    several = {s for u in unknowns if u in letters.angles for s in letters.angles[u].letters}
    several = {s for s in several if s not in b.common or b.common[s].free_symbols & several}
    # A root whose radicand has no unknowns left is a number or a root of parameters.
    known = {s: v for s, v in b.common.items() if s not in several}
    for root, radicand in letters.roots.items():
        square = resolved(radicand, known)
        if root not in known and square != radicand and not letters.unknowns_in(square):
            known[root] = sp.sqrt(letters.write(square))

    def place(r: Relation) -> int:
        used = [unknowns.index(owner[s]) for s in letters.read(r.lhs).free_symbols if s in owner]
        return min(used, default=-1)

    def value(e: sp.Expr) -> sp.Expr:
        return shortest_value(letters.write(resolved(e, known)))

    relations = [Relation(letters.write(r.lhs), value(r.rhs)) for r in sorted(b.relations, key=place)]
    relations = [Relation(r.lhs, by_stated_roots(r.rhs, relations)) for r in relations]
    conditions = [
        SignCondition(
            shortest_form(letters.write(resolved(c.lhs, known))),
            c.relation,
            shortest_form(letters.write(resolved(c.rhs, known))),
        )
        for c in b.conditions
    ]
    return replace(b, relations=tuple(relations), conditions=_joined(conditions))


def by_stated_roots(e: sp.Expr, relations: Sequence[Relation]) -> sp.Expr:
    """A value by the sine, cosine or tangent of which a power is stated, instead of roots, where that is shorter."""
    for r in relations:
        if isinstance(r.lhs.as_base_exp()[0], CIRCULAR) and e != r.rhs:
            e = by_stated_root(e, r.lhs, r.rhs)
    return e


def determined(b: Branch, letters: TrigLetters, unknowns: Sequence[sp.Symbol]) -> list[Branch]:
    """Branches that state the points of one, and no others.

    A cosine, sine or tangent leaves the sign of the other function open, so that k angles state 2^k points. Where the
    branch has fewer, signs belong together: tan θ = √2 with tan φ = 1 only if cos φ > 0. The fewest angles are then
    given outright, φ = π/4, or by both cosine and sine.
    """
    angles = _of_two_signs(b, letters, unknowns)
    if b.special or len(b.points) >= 2 ** len(angles):
        return [b]
    for number in range(1, len(angles) + 1):
        for fixed in combinations(angles, number):
            parts: dict[object, list[Values]] = {}
            for p in b.points:
                parts.setdefault(tuple(p[s] for u in fixed for s in letters.angles[u].letters), []).append(p)
            if all(len(part) == 2 ** (len(angles) - number) for part in parts.values()):
                return [_with_angles(b, part, fixed, letters, unknowns) for part in parts.values()]
    return [b]


def with_equal_angles(b: Branch, letters: TrigLetters, unknowns: Sequence[sp.Symbol]) -> Branch:
    """β = α instead of sin β = sin α, where cos α and cos β have one value; and with sine and cosine exchanged."""
    plain = [u for u in unknowns if u in letters.angles and letters.angles[u].measure == u]
    for u, v in combinations(plain, 2):
        for one, other in ((sp.cos, sp.sin), (sp.sin, sp.cos)):
            values = {r.lhs: r.rhs for r in b.relations}
            equal = next((w for w in ((u, v), (v, u)) if values.get(other(w[0])) == other(w[1])), None)
            if equal is None or one(u) not in values or values[one(u)] != values.get(one(v)):
                continue
            kept = (r for r in b.relations if r.lhs not in (one(v), other(equal[0])))
            b = replace(b, relations=(*kept, Relation(v, u)))
    return b


def _of_two_signs(b: Branch, letters: TrigLetters, unknowns: Sequence[sp.Symbol]) -> list[sp.Symbol]:
    """The angles that are given by one function of theirs."""
    stated = [f.args[0] for r in b.relations for f in [r.lhs.as_base_exp()[0]] if isinstance(f, CIRCULAR)]
    return [u for u in unknowns if u in letters.angles and stated.count(letters.angles[u].measure) == 1]


def with_shares_of_pi(
    b: Branch, letters: TrigLetters, unknowns: Sequence[sp.Symbol], inside: Callable[[sp.Symbol, sp.Expr], bool]
) -> Branch:
    """The branch with angles that are the same share of π at all its points given outright: θ = π/4 for tan θ = 1.

    inside  whether an angle may have a value, and no other one full turns further
    """
    stated = {r.lhs for r in b.relations}
    for u in unknowns:
        angle = letters.angles.get(u)
        if angle is None or u in stated or any(s not in p for p in b.points for s in angle.letters):
            continue
        places = {tuple(p[s] for s in angle.letters) for p in b.points}
        if len(places) != 1 or any(v.free_symbols for place in places for v in place):
            continue
        relations = root_at(angle, b.points[0]).relations
        if len(relations) == 1 and relations[0].lhs == u and inside(u, relations[0].rhs):
            b = _with_angles(b, b.points, (u,), letters, unknowns)
            value = {u: relations[0].rhs}
            b = replace(b, relations=tuple(replace(r, rhs=r.rhs.xreplace(value)) for r in b.relations))
    return b


def _with_angles(
    b: Branch,
    points: Sequence[Values],
    angles: Sequence[sp.Symbol],
    letters: TrigLetters,
    unknowns: Sequence[sp.Symbol],
) -> Branch:
    """Some points of a branch, at which some angles have one value each."""
    relations = [Relation(r.lhs, letters.read(r.rhs)) for r in b.relations]
    common = dict(b.common)
    for u in angles:
        angle = letters.angles[u]
        values = {s: points[0][s] for s in angle.letters}
        own = [
            r
            for r in relations
            if r.lhs.has(*CIRCULAR) and angle.measure in [f.args[0] for f in r.lhs.atoms(*CIRCULAR)]
        ]
        relations = [r for r in relations if r not in own] + list(root_at(angle, values).relations)
        common |= values
    return with_known_values(
        replace(b, relations=tuple(relations), points=tuple(points), common=common), letters, unknowns
    )


def _joined(conditions: Sequence[SignCondition]) -> tuple[SignCondition, ...]:
    """Each condition once, without what always holds; a ≥ b and a ≠ b are a > b."""
    relations_between: dict[tuple[sp.Expr, sp.Expr], set[str]] = {}
    conditions = [c for c in conditions if not always_holds(c)]
    for c in sorted(conditions, key=lambda c: c.relation == "≠"):
        turned = c.relation == "≠" and (c.rhs, c.lhs) in relations_between
        pair = (c.rhs, c.lhs) if turned else (c.lhs, c.rhs)
        relations_between.setdefault(pair, set()).add(c.relation)
    joined = []
    for (lhs, rhs), relations in relations_between.items():
        for weak, strict in (("≥", ">"), ("≤", "<")):
            if {weak, "≠"} <= relations:
                relations = relations - {weak, "≠"} | {strict}
        joined += [SignCondition(lhs, relation, rhs) for relation in sorted(relations)]
    return tuple(joined)


def without_repetitions(branches: Sequence[Branch]) -> list[Branch]:
    """The branches that no other contains; special ones only if they are a relation of parameters and nothing else."""
    generic = [b for b in branches if not b.special]
    if generic:
        branches = [b for b in branches if not b.special or len(b.relations) == 1]
    kept = []
    for n, b in enumerate(branches):
        own = _states(b)
        wider = (
            _states(o) <= own and (_states(o) != own or m < n) and len(o.points) >= 1
            for m, o in enumerate(branches)
            if m != n
        )
        if b.special or not any(wider):
            kept.append(b)
    return kept


def is_part(b: Branch, wider: Branch, solution: SolutionSet) -> bool:
    """Whether every point of a branch satisfies the relations of another one, which have a value there."""
    if wider.left or not b.points:
        return False
    for r in wider.relations:
        try:
            sides = [solution.letters.read(e) for e in (r.lhs, r.rhs)]
        except NotAlgebraicError:
            return False
        for p in b.points:
            if any(_vanishes(d, p, solution.letters) for d in denominators(sides)):
                return False
            if not is_zero(solution.letters.write(resolved(sides[0] - sides[1], p))):
                return False
    return True


def _states(b: Branch) -> set[object]:
    """The relations and conditions that a branch imposes on unknowns and parameters."""
    return {*b.relations, *b.conditions, *b.left}


def parameters_given(
    equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]
) -> tuple[list[sp.Expr], dict[sp.Symbol, sp.Expr]]:
    """Equations between parameters alone, solved for one of these: W_1 a = W_2 b, or tan α = 0.3 for an acute α."""
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
            angle = next(((s, a) for s in symbols if (a := _acute_angle(above, s)) is not None), None)
            values |= dict([angle]) if angle is not None else {}
            kept += [e] if angle is None else []
    return kept, values


def _acute_angle(e: sp.Expr, s: sp.Symbol) -> sp.Expr | None:
    """The value of an acute angle at which an expression a sin s + b cos s + c vanishes, two of a, b, c at most."""
    if sign_in_range(sp.sin(s)) != 1 or sign_in_range(sp.cos(s)) != 1:
        return None
    sine, cosine = sp.Dummy(positive=True), sp.Dummy(positive=True)
    waves = {sp.tan(s): sine / cosine, sp.cot(s): cosine / sine, sp.sin(s): sine, sp.cos(s): cosine}
    form = sp.expand(sp.fraction(sp.together(e.xreplace(waves)))[0])
    a, b = form.diff(sine), form.diff(cosine)
    if s in form.free_symbols or (a.free_symbols | b.free_symbols) & {sine, cosine}:
        return None
    c = sp.expand(form - a * sine - b * cosine)
    if a != 0 and c == 0:
        angle = sp.atan(-b / a)
    elif a != 0 and b == 0:
        angle = sp.asin(-c / a)
    elif b != 0 and a == 0:
        angle = sp.acos(-c / b)
    else:
        return None
    return None if angle.is_nonpositive or angle.is_extended_real is False or angle.has(sp.I) else angle
