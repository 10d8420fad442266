"""One unknown fewer: what is eliminated from a system before an equation of one unknown is solved.

linear      x from a(y) x + b(y) = 0; where a vanishes, that is a state of its own
turned      θ from θ = ψ + α
parallel    β = α and β = α + π from sin(α − β) = 0
on_circle   θ from a cos θ = p(ψ), a sin θ = q(ψ): p² + q² = a²
wave        sin θ from a₁(y) sin θ + b₁(y) = 0 and a₂(y) sin θ + b₂(y) = 0: a₁ b₂ = a₂ b₁
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient, irreducible_factors
from lagrange.algebra.closed_forms.signs import SignCondition, different_from_zero
from lagrange.algebra.closed_forms.single_equation import Relation, Values, pair_of_sum, parallel_angles
from lagrange.algebra.closed_forms.unit_circle import TrigLetters
from lagrange.core.records import record


@record
class State:
    """A place in the search; `nonzero` are divisors with unknowns: another state takes the place where they vanish."""

    equations: tuple[sp.Expr, ...]
    values: Values = field(default_factory=dict)
    common: Values = field(default_factory=dict)
    relations: tuple[Relation, ...] = ()
    conditions: tuple[SignCondition, ...] = ()
    special: bool = False
    stuck: tuple[sp.Expr, ...] = ()
    solved: tuple[sp.Symbol, ...] = ()
    signs: tuple[tuple[Values, ...], ...] = ()
    nonzero: tuple[sp.Expr, ...] = ()


def linear(state: State, letters: TrigLetters, first: Sequence[sp.Symbol], with_unknowns: bool) -> list[State]:
    """The states after eliminating an unknown that occurs linearly; none if there is no such unknown."""
    plain = [u for u in letters.unknowns if u not in letters.angles and u not in state.solved]
    plain.sort(key=lambda u: u not in first)
    for u in plain:
        for n, e in enumerate(state.equations):
            parts = _as_linear(e, u, letters)
            if parts is None:
                continue
            a, b = parts
            if bool(letters.unknowns_in(a)) is not with_unknowns:
                continue
            rest = (*state.equations[:n], *state.equations[n + 1 :])
            value = factored_quotient(-b / a)
            states = [
                replace(
                    state,
                    equations=rest,
                    values={**state.values, u: value},
                    common={**state.common, u: value},
                    relations=(*state.relations, Relation(u, value)),
                    conditions=(*state.conditions, *_nonzero(a, letters)),
                    solved=(*state.solved, u),
                )
            ]
            if with_unknowns:
                [divided] = states
                vanishing = replace(state, equations=(*rest, a, b))
                return [replace(divided, nonzero=(*state.nonzero, a)), vanishing]
            return states
    return []


def turned(state: State, letters: TrigLetters) -> list[State]:
    """The state after eliminating an angle that another one gives, θ = ψ + α."""
    circular = {s for a in letters.angles.values() for s in a.letters}
    for n, e in enumerate(state.equations):
        if not e.free_symbols.isdisjoint(circular):
            continue
        for u in [u for u in letters.unknowns if u in letters.angles and u not in state.solved]:
            parts = _as_linear(e, u, letters)
            if parts is None or letters.unknowns_in(parts[0]):
                continue
            value = factored_quotient(-parts[1] / parts[0])
            pair = pair_of_sum(letters.angles[u].measure.xreplace({u: value}), letters)
            if pair is None:
                continue
            taken = _with_angle(state, n, Relation(u, value), pair, letters)
            return [replace(taken, conditions=(*state.conditions, *_nonzero(parts[0], letters)))]
    return []


def _with_angle(state: State, n: int, relation: Relation, pair: Sequence[sp.Expr], letters: TrigLetters) -> State:
    """The state in which equation n gives an angle; `pair` has its cosine and sine."""
    u = relation.lhs
    values = {u: relation.rhs, **dict(zip(letters.angles[u].letters, pair, strict=True))}
    return replace(
        state,
        equations=(*state.equations[:n], *state.equations[n + 1 :]),
        values={**state.values, **values},
        common={**state.common, **values},
        relations=(*state.relations, relation),
        solved=(*state.solved, u),
    )


def parallel(state: State, letters: TrigLetters) -> list[State]:
    """The states with α = β and α = β + π in place of sin(α − β) = 0, or with −β of sin(α + β) = 0."""
    for n, e in enumerate(state.equations):
        found = parallel_angles(e, [u for u in letters.unknowns if u not in state.solved], letters)
        if found is not None:
            a, b, sign = found
            values = [(sign * b, 1), (sign * b + sp.pi, -1)]
            cosine, sine = letters.angles[b].letters
            return [_with_angle(state, n, Relation(a, v), (k * cosine, k * sign * sine), letters) for v, k in values]
    return []


def _nonzero(coefficient: sp.Expr, letters: TrigLetters) -> list[SignCondition]:
    """The conditions under which what is divided by does not vanish: k l ≠ m g."""
    pieces = [letters.shortest(p) for p in irreducible_factors(coefficient) or [] if p.is_Add]
    sums = [p for p in pieces if p.is_Add]
    return [c for p in sums if not letters.unknowns_in(p) for c in different_from_zero(p)]


def _as_linear(e: sp.Expr, u: sp.Symbol, letters: TrigLetters) -> tuple[sp.Expr, sp.Expr] | None:
    """a, b with e = a u + b."""
    if u not in e.free_symbols or any(u in letters.unknowns_in(r) for r in letters.roots if r in e.free_symbols):
        return None
    try:
        poly = sp.Poly(e, u)
    except sp.PolynomialError:
        return None
    return (poly.coeff_monomial(u), poly.coeff_monomial(1)) if poly.degree() == 1 else None


def wave(state: State, letters: TrigLetters) -> list[State]:
    """The state with an equation in one unknown beside two equations that are linear in one wave of an angle.

    A rod with both ends on a circle: y² − 2a y sin θ + a² = R² and y² + 2b y sin θ + b² = R² give y.
    """
    circular = [(u, f) for u, a in letters.angles.items() if u not in state.solved for f in a.letters]
    for first, second in combinations(state.equations, 2):
        for u, f in circular:
            one, other = _as_linear(first, f, letters), _as_linear(second, f, letters)
            if one is None or other is None:
                continue
            (a, b), (c, d) = one, other
            crossed = sp.expand(a * d - b * c)
            others = letters.unknowns_in(crossed)
            if crossed == 0 or len(others) != 1 or u in others or any(crossed == e for e in state.equations):
                continue
            if not _is_quadratic(crossed, letters):
                continue  # roots of cubics say less than the equations
            return [replace(state, equations=(crossed, *state.equations))]
    return []


def on_circle(state: State, letters: TrigLetters) -> list[State]:
    """The state after eliminating an angle whose cosine and sine two equations give, where one other angle is left.

    Two rods between fixed hinges: 2 cos α = 1 + 3 cos β and 2 sin α = 3 sin β. With letters only where what remains is
    as short as l cos β = a for rods of equal length: otherwise the equations, and when their triangle closes
    (`existence`), say more.
    """
    for pair in combinations(state.equations, 2):
        for u in [u for u in letters.unknowns if u in letters.angles and u not in state.solved]:
            given = _given_point(pair, u, letters)
            if given is None:
                continue
            cosine, sine = given
            closing = letters.shortest(sp.expand(cosine**2 + sine**2 - 1))
            others = letters.unknowns_in(closing)
            circular = {s for s in closing.free_symbols if s in letters.of_unknowns}
            in_numbers = circular == closing.free_symbols
            if len(others) > 1 or not (in_numbers or _gives_one_term(closing, circular)):
                continue
            angle = letters.angles[u]
            values = dict(zip(angle.letters, given, strict=True))
            stated = Relation(sp.cos(angle.measure), cosine), Relation(sp.sin(angle.measure), sine)
            return [
                replace(
                    state,
                    equations=(*(e for e in state.equations if e not in pair), closing),
                    values={**state.values, **values},
                    common={**state.common, **values},
                    relations=(*state.relations, *stated),
                    solved=(*state.solved, u),
                )
            ]
    return []


def _is_quadratic(e: sp.Expr, letters: TrigLetters) -> bool:
    """Whether all factors of a polynomial in one unknown are of the second degree at most."""
    unknowns = sorted((x for x in e.free_symbols if letters.unknowns_in(x)), key=str)
    factors = irreducible_factors(e)
    return factors is not None and all(sp.Poly(f, *unknowns).total_degree() <= 2 for f in factors)


def _gives_one_term(closing: sp.Expr, circular: set[sp.Symbol]) -> bool:
    """Whether an equation gives one cosine or sine as a product: a² = a l cos β."""
    if len(circular) != 1 or sp.Poly(closing, *circular).degree() != 1:
        return False
    rate, rest = sp.Poly(closing, *circular).all_coeffs()
    return not any(part.is_Add for part in sp.fraction(sp.cancel(rest / rate)))


def _given_point(pair: Sequence[sp.Expr], u: sp.Symbol, letters: TrigLetters) -> tuple[sp.Expr, sp.Expr] | None:
    """The cosine and sine of an angle by two equations linear in them, solved without a pivot that may vanish."""
    own = letters.angles[u].letters
    roots = [r for r in letters.roots if any(r in e.free_symbols for e in pair) and u in letters.unknowns_in(r)]
    if roots or any(u in e.free_symbols for e in pair):
        return None
    polynomials = [sp.Poly(e, *own) for e in pair]
    if any(p.total_degree() != 1 for p in polynomials):
        return None
    (a, b, p), (c, d, q) = ([f.coeff_monomial(m) for m in (*own, 1)] for f in polynomials)
    determinant = sp.expand(a * d - b * c)
    if letters.unknowns_in(sp.Add(a, b, c, d)) or determinant == 0 or different_from_zero(determinant):
        return None
    return sp.cancel((b * q - d * p) / determinant), sp.cancel((c * p - a * q) / determinant)
