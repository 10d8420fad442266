"""The equilibria as they are stated, tried numerically.

Solving multiplies, squares and divides, and states a branch by a few relations: tan θ = a and the conditions beside it.
Here that is read as a reader would. Rational numbers are chosen for the parameters so that the stated conditions hold,
and for the coordinates left open; the relations then give all the positions that they admit, both angles with
cos θ = b/a among them. At each of these the forces must have a value and balance,

    Q = −Aᵀ λ for some λ,     f = 0 ,

with Q and A as the principle of virtual work has them, before anything is multiplied. The numbers are algebraic and
the tests exact. Of a branch with unsolved equations generic points are taken on the surface that they define. A branch
that is read in neither way has its positions sought numerically (`searched.stated_places`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from random import Random
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.closed_forms.single_equation import Relation, Values
from lagrange.algebra.closed_forms.solution_sets import Branch, denominators, resolved
from lagrange.algebra.closed_forms.unit_circle import CIRCULAR, LetteredAngle, NotAlgebraicError, TrigLetters
from lagrange.algebra.exact.zero_test import DivisionByZeroError, Surface, is_zero, rank
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import Sign
from lagrange.mechanics.equilibrium.limits import MOST_STATED_DRAWS, MOST_UNSOLVED, STATED_SAMPLES
from lagrange.mechanics.equilibrium.searched.stated_places import holds_in_numbers

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium


class _NotReadError(Exception):
    """A branch is not stated in a form that gives its positions in numbers."""


@record
class Tried:
    """The verdict of the positions sampled from one branch.

    holds    whether the forces balance at all of them; None: no position was found, or none could be decided
    exactly  whether the positions are algebraic numbers; otherwise they have 45 digits
    """

    holds: bool | None
    exactly: bool


def stated_equilibria(e: Equilibrium) -> list[Tried]:
    """Whether what is stated implies equilibrium, at sampled points, branch by branch."""
    random = Random(1)
    tried = [(b, _tried(e, b, random)) for b in e.branches if not b.special]
    return [t for b, t in tried if t.holds is not None or not b.may_be_empty]


def rests_on_decimals(tried: Sequence[Tried]) -> bool:
    """Whether some of what was tried rests on numbers with finitely many digits."""
    return any(t.holds is not None and not t.exactly for t in tried)


def _tried(e: Equilibrium, b: Branch, random: Random) -> Tried:
    # A branch of which no position is decided says nothing: other branches do not stand in for it.
    exact = list(_verdicts(e, b, random))
    return Tried(all_hold(exact), True) if exact else Tried(holds_in_numbers(e, b), False)


def _verdicts(e: Equilibrium, b: Branch, random: Random) -> Iterator[bool]:
    """The verdicts on the points sampled from one branch, those that could be decided."""
    if b.left:
        verdict = _on_surface(e, b)
        yield from () if verdict is None else (verdict,)
        return
    finite = e.configuration.finite_constraints
    if e.given and finite:
        return  # a random position does not satisfy them
    for _ in range(STATED_SAMPLES):
        try:
            for point in _sample(e, b, random):
                verdict = _balanced(e, point)
                yield from () if verdict is None else (verdict,)
        except (_NotReadError, NotAlgebraicError):
            return


def _sample(e: Equilibrium, b: Branch, random: Random) -> Iterator[Values]:
    """The positions that a branch states for random parameters that meet its conditions. Raises _NotReadError."""
    letters, coordinates = e.solution.letters.copy(), frozenset(e.configuration.slots.coordinates)
    read = [(letters.read(c.lhs - c.rhs), c.relation) for c in b.conditions]
    relations = [Relation(r.lhs, letters.read(r.rhs)) for r in b.relations]
    given = _determined(relations, letters)
    bare = chain(e.work.forces, e.configuration.finite_constraints, (a for r in e.binding for a in r.coefficients))
    used = [*(letters.read(x) for x in bare), *(x for x, _ in read), *(r.rhs for r in relations)]
    for _ in range(MOST_STATED_DRAWS):
        numbers = _numbers(used, given, letters, coordinates, random)
        if all(_is_met(_value(x, numbers, letters), relation) for x, relation in read):
            yield from _positions(relations, numbers, letters)
            return
    raise _NotReadError


def _determined(relations: Sequence[Relation], letters: TrigLetters) -> set[sp.Symbol]:
    """The letters that the relations give."""
    given: set[sp.Symbol] = set()
    for r in relations:
        for u in r.lhs.free_symbols:
            given |= {u, *(letters.angles[u].letters if u in letters.angles else ())}
    return given


def _numbers(
    used: Sequence[sp.Expr],
    given: set[sp.Symbol],
    letters: TrigLetters,
    coordinates: frozenset[sp.Symbol],
    random: Random,
) -> dict[sp.Symbol, sp.Expr]:
    """Rational numbers for the letters that are not given; an angle is a rational point of the circle."""
    needed = {s for x in used for s in x.free_symbols}
    for _ in range(3):
        needed |= {s for root in needed & letters.roots.keys() for s in letters.roots[root].free_symbols}
    numbers: dict[sp.Symbol, sp.Expr] = {}
    angles = [a for a in letters.angles.values() if not (needed | given).isdisjoint(a.letters)]
    for angle in angles:
        if given.isdisjoint(angle.letters):
            # A parameter is an acute angle, a coordinate any angle.
            t = sp.Rational(random.randint(1, 9), 10)
            if angle.measure.free_symbols & coordinates:
                t = random.choice((t, -t, 1 / t, -1 / t))
            numbers |= {angle.cosine: (1 - t**2) / (1 + t**2), angle.sine: 2 * t / (1 + t**2)}
    for s in sorted(needed - numbers.keys() - given - letters.roots.keys(), key=str):
        if any(s in a.measure.free_symbols for a in angles):
            raise _NotReadError  # an angle beside its own sine
        size = sp.Rational(random.randint(1, 24), random.randint(1, 8))
        size = sp.S.One if isinstance(s, Sign) else size
        numbers[s] = size if s.is_nonnegative or random.random() < 0.5 else -size
    return numbers


def _value(x: sp.Expr, values: Values, letters: TrigLetters) -> sp.Expr:
    """An expression in letters at given values of these."""
    value = resolved(x, values)
    for root in sorted(value.free_symbols & letters.roots.keys(), key=str):
        radicand = resolved(letters.roots[root], values)
        if not radicand.free_symbols:
            value = value.xreplace({root: sp.sqrt(radicand)})
    return value


def _is_met(difference: sp.Expr, relation: str) -> bool:
    """Whether a condition holds by a margin."""
    value = difference.evalf(30) if difference.is_number else sp.nan
    if not value.is_real or abs(value) < sp.Float("1e-10"):
        return False
    return relation == "≠" or bool((value > 0) == (relation in "≥>"))


def _positions(relations: Sequence[Relation], values: Values, letters: TrigLetters) -> Iterator[Values]:
    """All positions that relations admit, real ones only, each as values of letters. Raises _NotReadError."""
    if not relations:
        yield values
        return
    for r in relations:
        value = _value(r.rhs, values, letters)
        if value.free_symbols:
            continue
        angle = _angle_of(r, letters)
        own = [o for o in relations if o is r or (angle is not None and _angle_of(o, letters) == angle)]
        rest = [o for o in relations if o not in own]
        for more in _values(own, value, values, letters):
            yield from _positions(rest, {**values, **more}, letters)
        return
    raise _NotReadError


def _angle_of(r: Relation, letters: TrigLetters) -> LetteredAngle | None:
    """The angle of which a relation gives a sine, cosine or tangent."""
    function = r.lhs.as_base_exp()[0]
    if not isinstance(function, CIRCULAR):
        return None
    return next((a for a in letters.angles.values() if a.measure == function.args[0]), None)


def _values(own: Sequence[Relation], value: sp.Expr, values: Values, letters: TrigLetters) -> Iterator[Values]:
    """The values that one relation gives, or a sine and a cosine together."""
    [first, *others] = own
    base, exponent = first.lhs.as_base_exp()
    if exponent != 1:
        if not exponent.is_Integer or exponent % 2 == 0:
            raise _NotReadError
        value = sp.real_root(value, exponent)
    angle = _angle_of(first, letters)
    if angle is None:
        if not base.is_Symbol:
            raise _NotReadError
        circle = letters.angles.get(base)
        pair = letters.pair(circle.measure.xreplace({base: value})) if circle else ()
        yield {base: value, **dict(zip(circle.letters if circle else (), pair, strict=True))}
        return
    if others:
        both = {type(o.lhs): _value(o.rhs, values, letters) for o in own}
        if set(both) != {sp.sin, sp.cos}:
            raise _NotReadError
        yield {angle.cosine: both[sp.cos], angle.sine: both[sp.sin]}
        return
    for sign in (1, -1):
        if isinstance(base, sp.tan):
            cosine = sign / sp.sqrt(1 + value**2)
            yield {angle.cosine: cosine, angle.sine: value * cosine}
        elif (rest := 1 - value**2).is_nonnegative:
            letter, other = angle.letters if isinstance(base, sp.cos) else angle.letters[::-1]
            yield {letter: value, other: sign * sp.sqrt(rest)}


def _balanced(e: Equilibrium, point: Values) -> bool | None:
    """Whether the forces have a value at a point and balance, and the finite constraints hold; None: undecided."""
    solution, rows = e.solution, e.binding

    def at(x: sp.Expr) -> sp.Expr:
        return solution.at(point, x)

    for divisor in denominators([solution.letters.read(q) for q in e.work.forces]):
        if is_zero(at(solution.letters.write(divisor))) is not False:
            return False
    forces = [at(q) for q in e.work.forces]
    if any(q.free_symbols for q in forces):
        return None
    try:
        verdicts = [is_zero(at(f)) for f in e.configuration.finite_constraints]
        return all_hold([*verdicts, _in_row_space([[at(a) for a in row.coefficients] for row in rows], forces)])
    except DivisionByZeroError:
        return False


def _in_row_space(matrix: list[list[sp.Expr]], forces: list[sp.Expr], on: Surface | None = None) -> bool | None:
    """Whether Q is a combination of the rows of A; without rows, whether it is zero."""
    if not matrix:
        return all_hold([is_zero(q, on) for q in forces])
    ranks = rank(matrix, on), rank([*matrix, forces], on)
    return None if None in ranks else ranks[0] == ranks[1]


def _are_the_conditions(e: Equilibrium, b: Branch) -> bool:
    """Whether unsolved equations are the conditions of equilibrium themselves, which no denominator multiplies."""
    if e.binding or len(e.conditions) < len(e.work.forces):
        return False
    return all(
        not c.below.powers and any(is_zero(c.expression - x) or is_zero(c.expression + x) for x in b.left)
        for c in e.conditions
    )


def _on_surface(e: Equilibrium, b: Branch) -> bool | None:
    """Whether the forces balance at generic points of the surface that unsolved equations define; None: undecided."""
    if _are_the_conditions(e, b):
        return True
    coordinates = e.configuration.slots.coordinates
    equations = [r.residual for r in b.equations]
    stated = {s for x in equations for s in x.free_symbols}
    # In a prime field a root has either sign, and an inequality has no meaning.
    if stated & {*e.multipliers} or any(not p.exp.is_Integer for x in equations for p in x.atoms(sp.Pow)):
        return None
    if len(b.left) > MOST_UNSOLVED or (not b.closing and any(c.relation != "≠" for c in b.conditions)):
        return None
    surface = Surface(equations, (*coordinates, *e.forces))
    try:
        matrix = [list(row.coefficients) for row in e.binding]
        return _in_row_space(matrix, list(e.work.forces), surface)
    except DivisionByZeroError:
        return False
