"""A quantity determined by equations: integrals with their values, constraints, and the conditions of a question.

The equations are solved for the state in closed form, branch by branch (`algebra.closed_forms`), and the quantity is
taken at the points of each branch. A velocity that occurs in even powers only is eliminated as its square w, which
must not be negative; both signs of the velocity are then points. Values that conditions give outright (θ = π) are
substituted first, so that an angle keeps its number of turns. Where a coordinate occurs in one exponential or tangent
only, e^(−a x), tan a x or cosh a x, that is the unknown, y, and x = −log(y)/a: for x between the places where it is
infinite; of cosh a x = y there are two, sinh a x = ± √(y² − 1), where y > 1.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient, square_root
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, not_negative, sign_of
from lagrange.algebra.closed_forms.single_equation import Relation, Values
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet
from lagrange.algebra.closed_forms.unit_circle import CIRCULAR, NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.mechanics.questions.limits import LONGEST_EQUATION, MOST_POINTS, MOST_UNKNOWNS
from lagrange.mechanics.questions.results import AnswerBranch

State = Mapping[sp.Symbol, sp.Expr]


@record
class Eliminated:
    """The branches of a quantity.

    branches  those that were found
    never     whether the equations have no solution for generic parameters
    free      unknowns on which the quantity depends although the equations leave them open
    solved    whether all branches are in closed form
    verified  whether all points satisfy the equations, exactly; None: undecided
    """

    branches: tuple[AnswerBranch, ...] = ()
    never: bool = False
    free: frozenset[sp.Symbol] = frozenset()
    solved: bool = False
    verified: bool | None = True


def eliminated(
    equations: Sequence[sp.Expr],
    quantity: sp.Expr,
    unknowns: Sequence[sp.Symbol],
    velocities: Sequence[sp.Symbol],
    called: sp.Expr,
) -> Eliminated:
    """The quantity where all equations, each zero, hold; `called` is what stands on the left of its values."""
    given, equations = _substituted(_with_differences(equations, unknowns), unknowns)
    if any(is_zero(e) is False for e in equations if e.free_symbols.isdisjoint(unknowns) and not _may_vanish(e)):
        return Eliminated(never=True, solved=True)
    wanted = quantity.xreplace(given)
    equations = [e for e in equations if not e.free_symbols.isdisjoint(unknowns)]
    equations = _related(equations, wanted, unknowns)
    squares = {v: sp.Symbol(f"{v.name}^2", real=True) for v in velocities if _is_even(v, equations)}
    rule = {v**n: w ** (n // 2) for v, w in squares.items() for n in (2, 4, 6, 8)}
    equations = [sp.expand(e).xreplace(rule) if squares else e for e in equations]
    used = set().union(*(e.free_symbols for e in equations), wanted.free_symbols)
    sought = [squares.get(u, u) for u in unknowns if squares.get(u, u) in used or u in used]
    if len(sought) > MOST_UNKNOWNS or any(count_operations(e) > LONGEST_EQUATION for e in equations):
        return Eliminated()
    if not equations:
        return _outright(wanted, given, unknowns, called)
    equations = _linear_squares(equations, [*squares.values()])
    try:
        solved = solutions(equations, sought, first=tuple(squares.values()), beside=(wanted,))
    except (NotAlgebraicError, DivisionByZeroError):
        return Eliminated()
    elimination = _of_branches(solved, wanted, given, unknowns, squares, called)
    if elimination.branches or elimination.never:
        return elimination
    return _through_one_function(equations, wanted, given, unknowns, called) or elimination


def _through_one_function(
    equations: Sequence[sp.Expr], wanted: sp.Expr, given: State, unknowns: Sequence[sp.Symbol], called: sp.Expr
) -> Eliminated | None:
    """The quantity where it is the only unknown, in e^(c x), tan(c x) or cosh(c x); None if it is not."""
    used = set().union(*(e.free_symbols for e in equations)) & {*unknowns}
    if used != {wanted} or not isinstance(wanted, sp.Symbol) or wanted != called:
        return None
    waves = {f for e in equations for f in e.atoms(sp.exp, sp.tan, sp.cosh) if wanted in f.free_symbols}
    rates = {f.args[0] / wanted for f in waves}
    if len({f.func for f in waves}) != 1 or any(wanted in r.free_symbols for r in rates):
        return None
    rate = min(rates, key=lambda r: (abs(r.as_coeff_Mul()[0]), str(r)))
    grows, swings = (all(isinstance(f, kind) for f in waves) for kind in (sp.exp, sp.cosh))
    letter = sp.Dummy("y", positive=True) if grows or swings else sp.Dummy("y", real=True)
    powers = {f: f.args[0] / wanted / rate for f in waves}
    if not all(n.is_Integer and (grows or n == 1) for n in powers.values()):
        return None
    plain = [sp.numer(sp.together(e.xreplace({f: letter**n for f, n in powers.items()}))) for e in equations]
    if any(wanted in e.free_symbols for e in plain):
        return None
    elimination = eliminated(plain, letter, [letter], [], letter)
    branches = []
    for b in elimination.branches:
        [value] = b.values
        sign = sign_of(value)
        if grows and sign in (0, -1):
            continue
        conditions = (*b.conditions, more_than_zero(value)) if grows and sign is None else b.conditions
        if swings:
            square = factored_quotient(value**2 - 1)
            if sign == -1 or sign_of(square) == -1:
                continue
            conditions = (*b.conditions, *([] if sign_of(square) == 1 else [more_than_zero(square)]))
            root = _real_root(square, conditions)
            stated = [(sp.sinh(rate * wanted), side * root, side * sp.asinh(root) / rate) for side in (1, -1)]
        else:
            place = (sp.log(value) if grows else sp.atan(value)) / rate
            stated = [(called, place, place)]
        for lhs, rhs, place in stated:
            branches.append(AnswerBranch(lhs, rhs, (place,), ({**given, wanted: place},), conditions))
    return replace(elimination, branches=tuple(branches), never=elimination.solved and not branches)


def _may_vanish(e: sp.Expr) -> bool:
    """Whether an equation between parameters may hold for some."""
    return bool(e.free_symbols)


def _outright(wanted: sp.Expr, given: State, unknowns: Sequence[sp.Symbol], called: sp.Expr) -> Eliminated:
    free = wanted.free_symbols & {*unknowns}
    if free:
        return Eliminated(free=frozenset(free), solved=True)
    value = shortest_form(wanted)
    return Eliminated((AnswerBranch(called, value, (value,), (given,)),), solved=True)


def _substituted(
    equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """Values that equations give outright, u − a = 0 with a free of unknowns, and the other equations with them."""
    given: dict[sp.Symbol, sp.Expr] = {}
    waiting = list(equations)
    for _ in range(len(waiting)):
        for e in waiting:
            outright = _value(e, unknowns)
            if outright is None:
                continue
            symbol, value = outright
            given[symbol] = value
            waiting = [f.xreplace({symbol: value}) for f in waiting if f is not e]
            break
        else:
            break
    return given, waiting


def _with_differences(equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> Sequence[sp.Expr]:
    """The equations where one of them gives a difference of unknowns that is in logarithms: log(y − x) as log d."""
    logs = {f for e in equations for f in e.atoms(sp.log, sp.exp) if len(f.free_symbols & {*unknowns}) > 1}
    for e in equations if logs else ():
        slopes = {u: e.diff(u) for u in unknowns if u in e.free_symbols}
        if len(slopes) < 2 or not all(c.is_number for c in slopes.values()):
            continue
        u, c = next(iter(slopes.items()))
        rule = {f: f.xreplace({u: sp.expand(u - e / c)}) for f in logs}
        known = {f: x.func(sp.expand(x.args[0])) for f, x in rule.items() if isinstance(x, sp.log | sp.exp)}
        known = {f: x for f, x in known.items() if x.free_symbols.isdisjoint(unknowns)}
        if known:
            return [f.xreplace(known) for f in equations]
    return equations


def _value(e: sp.Expr, unknowns: Sequence[sp.Symbol]) -> tuple[sp.Symbol, sp.Expr] | None:
    occurring = [u for u in unknowns if u in e.free_symbols]
    if len(occurring) != 1:
        return None
    [u] = occurring
    slope = e.diff(u)
    if u in slope.free_symbols or (not slope.is_number and not slope.is_positive):
        return None
    return (u, sp.cancel(-e.xreplace({u: sp.S.Zero}) / slope)) if slope != 0 else None


def _related(equations: Sequence[sp.Expr], wanted: sp.Expr, unknowns: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """The equations that are connected with the quantity through unknowns; all, where one has none of these."""
    reached = wanted.free_symbols & {*unknowns}
    kept: list[sp.Expr] = []
    waiting = list(equations)
    while True:
        more = [e for e in waiting if e.free_symbols & reached]
        if not more:
            return kept if kept else list(equations)
        kept += more
        waiting = [e for e in waiting if e not in more]
        reached |= set().union(*(e.free_symbols & {*unknowns} for e in more))


def _is_even(v: sp.Symbol, equations: Iterable[sp.Expr]) -> bool:
    """Whether a velocity occurs in the equations, and there in even powers only."""
    occurring = [sp.expand(e) for e in equations if v in e.free_symbols]
    if not occurring or not all(e.is_polynomial(v) for e in occurring):
        return False
    return all(n % 2 == 0 and n <= 8 for e in occurring for (n,), _ in sp.Poly(e, v).terms())


def _linear_squares(equations: Sequence[sp.Expr], squares: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """The equations with squares of velocities eliminated where an equation has one alone, with a definite factor."""
    equations = list(equations)
    for w in squares:
        for e in equations:
            slope = sp.factor_terms(sp.expand(e).coeff(w, 1))
            if slope == 0 or any(x in e.free_symbols for x in squares if x != w):
                continue
            if sp.expand(e).coeff(w, 2) != 0 or not _is_definite(slope):
                continue
            value = (
                sp.cancel(-sp.expand(e).coeff(w, 0) / slope)
                if not slope.is_number
                else -sp.expand(e).coeff(w, 0) / slope
            )
            equations = [w - value, *(f.xreplace({w: value}) for f in equations if f is not e)]
            break
    return equations


def _is_definite(slope: sp.Expr) -> bool:
    return sign_of(slope) in (1, -1)


def _of_branches(
    solved: SolutionSet,
    wanted: sp.Expr,
    given: State,
    unknowns: Sequence[sp.Symbol],
    squares: Mapping[sp.Symbol, sp.Symbol],
    called: sp.Expr,
) -> Eliminated:
    branches: list[AnswerBranch] = []
    free: set[sp.Symbol] = set()
    regular = [b for b in solved.branches if not b.special]
    complete = solved.solved
    for b in regular:
        if b.left:
            continue
        for conditions, states in _states(b, solved, given, unknowns, squares).items():
            if conditions is None:
                complete = False
                continue
            pairs: list[tuple[sp.Expr, State]] = []
            for state in states:
                value = _at(wanted, state, solved)
                if value is None:
                    complete = False
                    continue
                open_ = value.free_symbols & {*unknowns}
                free |= open_
                if not open_:
                    pairs.append((value, {s: solved.letters.write(v) for s, v in state.items()}))
            branches += _stated(b, called, pairs, conditions)
    never = not branches and not free and complete and solved.verified is True
    return Eliminated(tuple(_without_repetitions(branches)), never, frozenset(free), complete, solved.verified)


def _states(
    b: Branch, solved: SolutionSet, given: State, unknowns: Sequence[sp.Symbol], squares: Mapping[sp.Symbol, sp.Symbol]
) -> dict[tuple[SignCondition, ...] | None, list[dict[sp.Symbol, sp.Expr]]]:
    """The states of a branch, both signs of the velocities among them, grouped by their conditions."""
    groups: dict[tuple[SignCondition, ...] | None, list[dict[sp.Symbol, sp.Expr]]] = {}
    for point in b.points[:MOST_POINTS]:
        conditions = list(b.conditions)
        signed: list[tuple[sp.Symbol, tuple[sp.Expr, ...]]] = []
        state: dict[sp.Symbol, sp.Expr] = dict(given)
        possible = True
        for v, w in squares.items():
            try:
                value = factored_quotient(solved.at(point, w))
            except NotAlgebraicError:
                groups.setdefault(None, [])
                return groups
            if value.free_symbols & {*unknowns, *squares.values()}:
                continue
            allowed = not_negative(value)
            if allowed is None:
                possible = False
                break
            conditions += [c for c in allowed if c not in conditions]
            root = sp.S.Zero if value == 0 else _real_root(value, conditions)
            signed.append((v, (root, -root) if root != 0 else (root,)))
        if not possible:
            continue
        for u in unknowns:
            if u in given or u in squares:
                continue
            coordinate = _coordinate(u, b, point, solved)
            if coordinate is not None:
                state[u] = coordinate
        state |= {s: value for s, value in point.items() if s not in squares.values() and s not in unknowns}
        for roots in product(*(roots for _, roots in signed)):
            whole = {**state, **dict(zip([v for v, _ in signed], roots, strict=True))}
            groups.setdefault(tuple(conditions), []).append(whole)
    return groups


def _real_root(value: sp.Expr, conditions: Sequence[SignCondition]) -> sp.Expr:
    """√ of what the conditions make positive, with factors that they make negative turned: √(a − b), not i √(b − a)."""
    positive = [c.lhs - c.rhs for c in conditions if c.relation in (">", "≥")]
    factors = sp.Mul.make_args(value)
    turned = [f for f in factors if f.as_base_exp()[0].is_Add and sign_of(f.as_base_exp()[0], positive) == -1]
    powers = [f.as_base_exp() for f in turned]
    if not turned or not all(e.is_Integer for _, e in powers):
        return square_root(value)
    sign = sp.S.NegativeOne ** sp.Add(*(e for _, e in powers))
    rest = sp.Mul(sign, *(f for f in factors if f not in turned), *((-b) ** abs(e) for b, e in powers if e > 0))
    return square_root(rest) / sp.Mul(*(square_root((-b) ** -e) for b, e in powers if e < 0))


def _coordinate(u: sp.Symbol, b: Branch, point: Values, solved: SolutionSet) -> sp.Expr | None:
    """An unknown at a point: an angle from its cosine and sine; None if it is open."""
    stated = {r.lhs: r.rhs for r in b.relations}
    if u in stated and not stated[u].free_symbols & {*solved.unknowns}:
        return stated[u]
    angle = solved.letters.angle_of(u)
    if angle is None or angle.cosine not in point or angle.sine not in point:
        value = point.get(u)
        if value is None:
            return None
        try:
            value = solved.at(point, u)
        except NotAlgebraicError:
            return None
        return None if value.free_symbols & {*solved.unknowns} else value
    try:
        cosine, sine = (solved.at(point, f(angle.measure)) for f in (sp.cos, sp.sin))
    except NotAlgebraicError:
        return None
    share = u / angle.measure
    if sine.is_number and cosine.is_number:
        if sine == 0:
            return (sp.S.Zero if cosine == 1 else sp.pi) * share
        return (1 if sine > 0 else -1) * sp.acos(cosine) * share
    if (side := sign_of(sine)) in (1, -1):
        return sp.Integer(side) * sp.acos(shortest_form(cosine)) * share
    return sp.atan2(sine, cosine) * share


def _at(wanted: sp.Expr, state: State, solved: SolutionSet) -> sp.Expr | None:
    """The quantity at a state."""
    letters = {s: v for s, v in state.items() if s not in wanted.free_symbols or s in solved.letters.roots}
    direct = wanted.xreplace({s: v for s, v in state.items() if s in wanted.free_symbols and not _in_circle(s, wanted)})
    try:
        value = solved.at(letters, direct)
    except NotAlgebraicError:
        return None
    return shortest_form(factored_quotient(value))


def _in_circle(s: sp.Symbol, e: sp.Expr) -> bool:
    return any(s in f.free_symbols for f in e.atoms(*CIRCULAR))


def _stated(
    b: Branch, called: sp.Expr, pairs: Sequence[tuple[sp.Expr, State]], conditions: tuple[SignCondition, ...]
) -> Iterator[AnswerBranch]:
    """A branch as it is stated: as a relation of the quantity, cos θ = 2/3, or a value for each."""
    if not pairs:
        return
    values = tuple(dict.fromkeys(value for value, _ in pairs))
    relation = _relation(b.relations, called)
    if relation is not None:
        states = tuple(state for _, state in pairs)
        measure = relation.lhs.args[0]
        same = _independent_of_turning(states, measure, called)
        if (angles := _angles_alike(relation)) and (same or isinstance(relation.lhs, sp.cos)):
            share = called / measure
            for angle in angles:
                turned = {str(called): angle * share, **{str(f(measure)): f(angle) for f in (sp.cos, sp.sin)}}
                kept = states[: len(states) // 2] if same and len(states) > 1 else states[:1]
                there = tuple({x: turned.get(str(x), v) for x, v in {**s, called: angle * share}.items()} for s in kept)
                yield AnswerBranch(called, angle * share, (angle * share,), there, conditions)
            return
        yield AnswerBranch(relation.lhs, relation.rhs, values, states, conditions)
        return
    for value in values:
        yield AnswerBranch(called, value, (value,), tuple(s for v, s in pairs if v == value), conditions)


def _angles_alike(relation: Relation) -> tuple[sp.Expr, ...]:
    """θ = α or −α where cos θ = cos α, θ = α or π − α where sin θ = sin α; empty for any other relation."""
    if not isinstance(relation.lhs, sp.cos | sp.sin) or relation.rhs.func != relation.lhs.func:
        return ()
    [angle] = relation.rhs.args
    return (angle, -angle if isinstance(relation.lhs, sp.cos) else sp.pi - angle)


def _independent_of_turning(states: Sequence[State], measure: sp.Expr, called: sp.Symbol) -> bool:
    """Whether the two angles with one cosine, or with one sine, differ in nothing else."""
    own = {str(e) for e in (called, sp.sin(measure), sp.cos(measure))}
    rest = [{s: v for s, v in state.items() if str(s) not in own} for state in states]
    half = len(rest) // 2
    return len(rest) == 1 or (len(rest) % 2 == 0 and rest[:half] == rest[half:])


def _relation(relations: Sequence[Relation], wanted: sp.Expr) -> Relation | None:
    """The relation of an angle that is the quantity, where it is stated by its cosine, sine or tangent."""
    if not wanted.is_Symbol:
        return None
    own = [r for r in relations if wanted in r.lhs.free_symbols]
    if len(own) == 1 and own[0].lhs != wanted and wanted not in own[0].rhs.free_symbols and own[0].lhs.has(*CIRCULAR):
        return own[0]
    return None


def _without_repetitions(branches: Sequence[AnswerBranch]) -> list[AnswerBranch]:
    """The branches without repetitions, compared by their statements."""
    kept: dict[object, AnswerBranch] = {}
    for b in branches:
        key = (b.lhs, b.rhs, b.conditions)
        known = kept.get(key)
        if known is None:
            kept[key] = b
        else:
            values = (*known.values, *(v for v in b.values if v not in known.values))
            kept[key] = AnswerBranch(b.lhs, b.rhs, values, (*known.states, *b.states), b.conditions)
    return list(kept.values())
