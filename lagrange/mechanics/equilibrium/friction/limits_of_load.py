"""The limits between which one unknown force must lie for a system with several rough contacts to be at rest.

With the equations of balance solved, all bounds are linear in the forces s that remain and in the force P:

    c_i + p_i P + Σ_j a_ij s_j ≥ 0 ,     i = 1 ... m .

If y ≥ 0 and Σ_i y_i a_ij = 0 for every j, then Σ y_i c_i + P Σ y_i p_i ≥ 0 limits P, from above or from below (Farkas).
A set of as many bounds as there are s, and one, has one such y: its minors. The sharpest of these limits is attained if
the forces at which these bounds are equalities satisfy all the others; then P may have every value between the two
limits, since what is admissible is convex.

These sets are chosen at sampled numbers: acute angles and coefficients of friction that are not large, or the values of
the file. That y and the other bounds are not negative is then proved symbolically, as far as it holds for all angles;
the rest becomes conditions under which these are the limits. Different numbers may lead to different sets: these are
the cases of the result. Elimination by pairs (`linear_inequalities`) would need the signs of all coefficients on the
way; with three contacts these have dozens of cases.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations

import sympy as sp

from lagrange.core.records import record
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Inequality, Signs, shortest
from lagrange.mechanics.equilibrium.limits import DRAWS_OF_LIMITS, MOST_BOUND_SETS, MOST_REGIMES, SMALL_BOUND
from lagrange.mechanics.equilibrium.searched.tape import NoTapeError, Tape

Row = tuple[float, ...]
Point = Callable[[sp.Expr], float]


@record
class LoadLimits:
    """slack ≥ 0 for each limit; `where`: what must be positive for these to be the limits."""

    slacks: tuple[sp.Expr, ...]
    where: tuple[sp.Expr, ...]


def limits_of_load(
    inequalities: Sequence[Inequality],
    load: sp.Symbol,
    friction: Sequence[sp.Expr],
    values: Mapping[sp.Symbol, sp.Expr],
    signs: Signs,
) -> list[LoadLimits]:
    """The limits of a force that occurs in the constants of the bounds, in each case that is seen.

    friction  the coefficients of friction
    values    numbers for parameters
    """
    rows = [(*i.coefficients, rate, shortest(i.constant.xreplace({load: sp.S.Zero})))
            for i in inequalities for rate in [shortest(i.constant.diff(load))]]  # fmt: skip
    if any(load in e.free_symbols for row in rows for e in row):
        return []
    open_ = len(rows[0]) - 2
    sets = [*combinations(range(len(rows)), open_ + 1)]
    if len(sets) > MOST_BOUND_SETS:
        return []
    return [_in_letters(rows, both, point, load, signs) for both, point in _seen(rows, sets, friction, values)]


def _in_letters(
    rows: Sequence[Sequence[sp.Expr]], both: Sequence[tuple[int, ...]], point: Point, load: sp.Symbol, signs: Signs
) -> LoadLimits:
    """The limits from sets of bounds, and what makes them the limits."""
    open_ = len(rows[0]) - 2
    slacks: list[sp.Expr] = []
    where: list[sp.Expr] = []
    for chosen in both:
        minors = [shortest(_minor([rows[n][:open_] for n in chosen if n != left])) for left in chosen]
        weights = [m if k % 2 == 0 else -m for k, m in enumerate(minors)]
        sense = sp.Integer(1 if sum(map(point, weights)) > 0 else -1)
        weights = [shortest(sense * w) for w in weights]
        rate = shortest(sp.Add(*(w * rows[n][-2] for w, n in zip(weights, chosen, strict=True))))
        rest = shortest(sp.Add(*(w * rows[n][-1] for w, n in zip(weights, chosen, strict=True))))
        slacks.append(shortest(rest + rate * load))
        needed = [w for w in weights if w != 0]
        whole = _minor([rows[n][: open_ + 1] for n in chosen])
        for other in range(len(rows)):
            if other not in chosen:
                full = _minor([rows[n] for n in (*chosen, other)])
                ratio = shortest(full / whole)
                needed += [ratio] if ratio != 0 else []
        for e in needed:
            where += _factors_to_keep(e, point, signs)
    kept = [*dict.fromkeys(where)]
    for e in tuple(kept):
        others = [k for k in kept if k != e]
        if others and _follows(e, others, signs):
            kept.remove(e)
    return LoadLimits(tuple(slacks), tuple(kept))


def _minor(rows: Sequence[Sequence[sp.Expr]]) -> sp.Expr:
    return sp.Matrix([[*row] for row in rows]).det(method="berkowitz") if rows else sp.S.One


def _factors_to_keep(e: sp.Expr, point: Point, signs: Signs) -> Iterator[sp.Expr]:
    """The factors of unknown sign, each with the sign that makes it positive at the numbers; e is positive there."""
    above, below = sp.fraction(sp.together(e))
    for factor in (*sp.Mul.make_args(sp.factor(above)), *sp.Mul.make_args(sp.factor(below))):
        base, power = factor.as_base_exp()
        if power.is_Integer and power % 2 == 0:
            continue
        if signs.of(base) in (1, -1):
            continue
        yield base if point(base) > 0 else -base


def _follows(e: sp.Expr, others: Sequence[sp.Expr], signs: Signs) -> bool:
    """Whether a condition e > 0 is weaker than another one."""
    return any(signs.of(sp.expand(e - other)) in (0, 1) for other in others)


def _seen(
    rows: Sequence[Sequence[sp.Expr]],
    sets: Sequence[tuple[int, ...]],
    friction: Sequence[sp.Expr],
    values: Mapping[sp.Symbol, sp.Expr],
) -> list[tuple[tuple[tuple[int, ...], ...], Point]]:
    """The sets of bounds that limit the force at drawn numbers at which rest is possible, the most frequent first."""
    symbols = sorted({s for row in rows for e in row for s in e.free_symbols}, key=str)
    angles = {s for row in rows for e in row for f in e.atoms(sp.sin, sp.cos, sp.tan) for s in f.free_symbols}
    rough = {s for e in friction for s in e.free_symbols}
    try:
        tape = Tape([e.xreplace(dict(values)) for row in rows for e in row], symbols)
    except NoTapeError:
        return []
    seen: dict[tuple[tuple[int, ...], ...], list[Point]] = {}
    draw = random.Random(18)
    width = len(rows[0])
    for _ in range(DRAWS_OF_LIMITS):
        numbers = [
            float(values[s]) if s in values
            else draw.uniform(0.05, 0.3) if s in rough
            else draw.uniform(0.1, 0.6) if s in angles
            else draw.uniform(0.5, 2)
            for s in symbols
        ]  # fmt: skip
        try:
            flat = tape.values(numbers)
        except (ValueError, ArithmeticError):
            continue
        table = [tuple(flat[n : n + width]) for n in range(0, len(flat), width)]
        both = _sharpest(table, sets)
        if both is not None:
            at = dict(zip(symbols, numbers, strict=True))

            def point(e: sp.Expr, at: Mapping[sp.Symbol, float] = at) -> float:
                return float(e.xreplace(dict(values)).xreplace({s: sp.Float(x) for s, x in at.items()}).evalf())

            seen.setdefault(tuple(both), []).append(point)
    often = sorted(seen.items(), key=lambda item: -len(item[1]))[:MOST_REGIMES]
    return [(both, points[0]) for both, points in often]


def _sharpest(table: Sequence[Row], sets: Sequence[tuple[int, ...]]) -> list[tuple[int, ...]] | None:
    """The sets that give the greatest lower and the least upper limit; None where rest is impossible, or nothing is."""
    best: dict[int, tuple[float, tuple[int, ...]]] = {}
    open_ = len(table[0]) - 2
    for chosen in sets:
        weights = _weights([table[n][:open_] for n in chosen])
        if weights is None:
            continue
        rate = sum(w * table[n][-2] for w, n in zip(weights, chosen, strict=True))
        rest = sum(w * table[n][-1] for w, n in zip(weights, chosen, strict=True))
        if abs(rate) < SMALL_BOUND:
            if rest < -SMALL_BOUND:
                return None
            continue
        side, limit = (1, -rest / rate) if rate > 0 else (-1, rest / -rate)
        if side not in best or side * (limit - best[side][0]) > SMALL_BOUND * (1 + abs(limit)):
            best[side] = (limit, chosen)
    if not best or (len(best) == 2 and best[1][0] > best[-1][0]):
        return None
    return [chosen for _, chosen in (best[s] for s in (1, -1) if s in best)]


def _weights(rows: Sequence[Row]) -> list[float] | None:
    """The minors with alternating signs, scaled, where none is negative; None otherwise."""
    minors = [_determinant([r for k, r in enumerate(rows) if k != left]) * (-1) ** left for left in range(len(rows))]
    size = max(map(abs, minors))
    if size < SMALL_BOUND:
        return None
    scaled = [m / size for m in minors]
    if min(scaled) < -SMALL_BOUND:
        scaled = [-m for m in scaled]
    return None if min(scaled) < -SMALL_BOUND else scaled


def _determinant(rows: Sequence[Row]) -> float:
    if not rows:
        return 1.0
    work, result = [[*r] for r in rows], 1.0
    for k in range(len(work)):
        n = max(range(k, len(work)), key=lambda n: abs(work[n][k]))
        if work[n][k] == 0:
            return 0.0
        if n != k:
            work[n], work[k], result = work[k], work[n], -result
        result *= work[k][k]
        for n in range(k + 1, len(work)):
            ratio = work[n][k] / work[k][k]
            work[n] = [a - ratio * b for a, b in zip(work[n], work[k], strict=True)]
    return result
