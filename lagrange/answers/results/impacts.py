"""Wrong velocities just after an impact, impulses and losses of energy: what was done instead.

The velocities satisfy M (q' − q'_0) = Ĵ + Aᵀ λ and A q' + a = 0. A changed problem has another M: the moment of inertia
of another body, a mass or a rotation that is omitted. Its velocities are numbers at random values of the letters.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.limits import MOST_STRUCK, RANDOM_ZERO_DIGITS
from lagrange.answers.models.frequencies import RandomMatrices
from lagrange.answers.models.mechanics import Inertia, Mechanics, mechanics_of
from lagrange.answers.models.questions import explained_value
from lagrange.answers.models.table import MODELS
from lagrange.answers.results.meanings import other_meanings
from lagrange.mechanics.momenta.impact import ImpulsiveMotion
from lagrange.problem.model import Problem

_SMALL = sp.Float(10) ** -RANDOM_ZERO_DIGITS


def explained_impact(
    name: str,
    claim: sp.Expr,
    value: sp.Expr,
    motion: ImpulsiveMotion,
    problem: Problem,
    vanishes: Callable[[sp.Expr], bool | None],
) -> str:
    """A sentence that identifies a stated velocity, impulse or energy loss; empty if it is not recognised.

    value     the right one
    vanishes  whether an expression is zero in the position of the impact
    """
    try:
        return next(_reasons(name, claim, value, motion, problem, vanishes), "")
    except (DivisionByZeroError, NoPointError, UnsupportedError, ZeroDivisionError):
        return ""


def explained_statement(
    equation: sp.Expr, motion: ImpulsiveMotion, problem: Problem, values: Mapping[sp.Symbol, sp.Rational]
) -> str:
    """What is stated by a wrong equation with one of the unknowns of an impact, in a sentence; empty if not found.

    values  of parameters in the file
    """
    slots = motion.slots
    names = (f"{q}'" for q in slots.coordinates)
    unknowns = dict(zip(slots.velocities, zip(names, motion.velocities, strict=True), strict=True))
    unknowns |= {i.symbol: (i.name, i.value) for i in motion.impulses if i.value is not None}
    e = motion.at(equation)
    [*used] = e.free_symbols & unknowns.keys()
    if len(used) != 1:
        return ""
    slope = e.diff(used[0])
    claim = sp.together(-e.xreplace({used[0]: sp.S.Zero}) / slope) if slope != 0 else sp.nan
    if slope.has(used[0]):  # a square of a velocity
        bend = e.diff(used[0], 2)
        if bend.has(used[0]) or sp.expand(slope - bend * used[0]) != 0:
            return ""
        claim = sp.sqrt(sp.together(-2 * e.xreplace({used[0]: sp.S.Zero}) / bend))
    if claim.has(sp.nan, sp.zoo, sp.I):
        return ""
    name, value = unknowns[used[0]]
    return explained_impact(
        name, claim, value, motion, problem, lambda e: motion.surface.is_zero(e.xreplace(dict(values)))
    )


def _reasons(
    name: str,
    claim: sp.Expr,
    value: sp.Expr,
    motion: ImpulsiveMotion,
    problem: Problem,
    vanishes: Callable[[sp.Expr], bool | None],
) -> Iterator[str]:
    before, after = motion.kinetic
    plain = name.strip().removesuffix("'")
    velocities = {q.name: v for q, v in zip(motion.slots.coordinates, motion.before, strict=True)}
    if name == "energy_lost":
        for energy, when in ((before, "before"), (after, "after")):
            if energy != 0 and vanishes(claim - energy):
                yield f"this is the whole kinetic energy just {when} the impact, and not what is lost"
        if claim == 0 and value != 0:
            yield "some kinetic energy is lost here: it is conserved only where nothing sticks and all is elastic"
        if vanishes(claim + value):
            yield "its sign is wrong: what is lost is positive"
    elif plain in velocities:
        if vanishes(claim - velocities[plain]):
            yield "this is the velocity just before the impact"
        if (
            before != 0
            and value != 0
            and vanishes(claim**2 * after - value**2 * before)
            and not vanishes(before - after)
        ):
            yield "the kinetic energy is taken to be conserved, but some of it is lost in this impact"
        if value != 0 and vanishes(claim - 2 * value + velocities[plain]) and _is_inelastic(motion):
            yield "this is the velocity after an elastic impact"
        if (why := _of_another_inertia(plain, claim, motion, problem)) is not None:
            yield f"this is the velocity {why}"
    if value != 0 and vanishes(claim + value):
        yield "its sign is wrong"
    if plain not in velocities and name != "energy_lost":
        for p in mechanics_of(motion.configuration, problem).particles:
            for component in _momentum(p, motion):
                if component != 0 and any(vanishes(claim - sign * component) for sign in (1, -1)):
                    yield f"this is the whole momentum of `{p.name}` just before, as if its mass centre came to rest"
    if why := explained_value(claim, value, set()):
        yield why
    for meaning in other_meanings(value.free_symbols, claim.free_symbols):
        if vanishes(claim - value.xreplace(dict(meaning.rule))):
            yield f"this is the result {meaning.clause}"
    for p in sorted(value.free_symbols - claim.free_symbols, key=str):
        if vanishes(claim - value.xreplace({p: sp.S.One})):
            yield f"this is the result for {p} = 1"


def _momentum(p: Inertia, motion: ImpulsiveMotion) -> Iterator[sp.Expr]:
    """The components of the momentum of a particle or mass centre just before the impact."""
    for a in range(3):
        rates = (column[a] * v for column, v in zip(p.columns[:-1], motion.before, strict=True))
        yield motion.at(p.weights[a] * sp.Add(*rates))


def _is_inelastic(motion: ImpulsiveMotion) -> bool:
    """Whether the constraints hold just after, and no blow is given beside them."""
    still = dict(zip(motion.slots.velocities, motion.before, strict=True))
    after = dict(zip(motion.slots.velocities, motion.velocities, strict=True))
    forms = [row.velocity_form(motion.slots) for row in motion.rows]
    struck = (motion.at(e.xreplace(still)) for e in motion.balance)
    return all(is_zero(motion.at(f.xreplace(after))) is True for f in forms) and all(is_zero(b) is True for b in struck)


def _of_another_inertia(name: str, claim: sp.Expr, motion: ImpulsiveMotion, problem: Problem) -> str | None:
    """The changed inertia that gives a velocity, as the end of a sentence."""
    m = mechanics_of(motion.configuration, problem)
    n = len(m.slots.coordinates)
    if n > MOST_STRUCK:
        return None
    number = [q.name for q in m.slots.coordinates].index(name)
    draws = [_Draw(m, motion, seed) for seed in (1, 2)]
    claims = [d.numbers.number(claim) for d in draws]
    for k, q in enumerate(m.slots.coordinates):
        if motion.before[k] != 0 and all(
            (v := d.velocity(m, number, without=k)) is not None and _close(v, c)
            for d, c in zip(draws, claims, strict=True)
        ):
            return f"without {q}' just before the impact"
    for group in dict.fromkeys(row.name.partition(".")[0] for row in motion.rows):
        left = [j for j, row in enumerate(motion.rows) if row.name.partition(".")[0] != group]
        if all(
            (v := d.velocity(m, number, rows=left)) is not None and _close(v, c)
            for d, c in zip(draws, claims, strict=True)
        ):
            return f"without `{group}`, as if nothing were held there"
    if point := _about_another_point(m, motion, number, claims, draws):
        return point
    for changed, clause in _with_other_inertias(m):
        if all(
            (v := d.velocity(changed, number)) is not None and _close(v, c) for d, c in zip(draws, claims, strict=True)
        ):
            return clause
    return _from_the_right_momentum(m, motion, number, claims, draws)


def _with_other_inertias(m: Mechanics) -> Iterator[tuple[Mechanics, str]]:
    """The system with each mistake in an inertia, and the end of the sentence that names the mistake."""
    for model in MODELS:
        for variation in model.changes(m):
            changed = variation.mechanics
            if changed is not None and changed.inertias != m.inertias and changed.kept == m.kept:
                yield changed, variation.clause


def _about_another_point(
    m: Mechanics, motion: ImpulsiveMotion, number: int, claims: list[sp.Expr], draws: list[_Draw]
) -> str | None:
    """The changed inertia that gives a velocity from the right momentum, as the end of a sentence.

    Where one degree of freedom is left, u' = p/I with I = 2 T/u'²: the momentum about the hinge may be the right one,
    and I that about the mass centre.
    """
    if any(abs(a) > _SMALL for d in draws for a in d.drift):
        return None
    turning = replace(m, inertias=tuple(i for i in m.inertias if i.turning))
    by_itself = len({i.name for i in m.inertias}) == 1 and any(number in i.moving for i in turning.inertias)
    if len(motion.equations) != 1 and not by_itself:
        return None
    points = [(sp.S.One, "the mass centre")]
    points += [(sp.Integer(4), f"an end of `{i.name}`") for i in turning.inertias if by_itself and _is_uniform(i, m)]
    for factor, point in points:
        if all(
            _close(c * factor * d.energy(turning), d.after[number] * d.energy(m))
            for d, c in zip(draws, claims, strict=True)
        ):
            return f"for the moment of inertia about {point}, but here the body turns about another point"
    return None


def _from_the_right_momentum(
    m: Mechanics, motion: ImpulsiveMotion, number: int, claims: list[sp.Expr], draws: list[_Draw]
) -> str | None:
    """The same for any other change of I."""
    if len(motion.equations) != 1 or any(abs(a) > _SMALL for d in draws for a in d.drift):
        return None
    for name in dict.fromkeys(i.name for i in m.inertias):
        others = replace(m, inertias=tuple(i for i in m.inertias if i.name != name))
        if all(_close(c * d.energy(others), d.after[number] * d.energy(m)) for d, c in zip(draws, claims, strict=True)):
            return f"without the inertia of `{name}` just after the impact"
    for changed, clause in _with_other_inertias(m):
        if all(
            _close(c * d.energy(changed), d.after[number] * d.energy(m)) for d, c in zip(draws, claims, strict=True)
        ):
            return f"from the right momentum just before, and an inertia {clause}"
    return None


def _is_uniform(r: Inertia, m: Mechanics) -> bool:
    """Whether a body is a rod with the moment of inertia m l²/3 about its middle, where 2 l is its length."""
    ends, places = dict(m.ends).get(r.name, ()), dict(m.places)
    centre = next((p for p in m.particles if p.name == r.name), None)
    if len(ends) != 2 or centre is None or r.name not in places:
        return False
    half = [(end - places[r.name].map(m.configuration.rewritten)).fixed() for end in ends]
    return all(is_zero(3 * r.weights[2] - centre.weights[0] * h.dot(h)) is True for h in half)


class _Draw:
    """The impact at random values of the letters."""

    def __init__(self, m: Mechanics, motion: ImpulsiveMotion, seed: int) -> None:
        self.numbers = RandomMatrices(m, lambda e: motion.at(e), seed)
        still = dict(zip(motion.slots.velocities, motion.before, strict=True))
        self.before = [self.numbers.number(v) for v in motion.before]
        self.blows = [-self.numbers.number(e.xreplace(still)) for e in motion.balance]
        self.rows = [[self.numbers.number(a) for a in row.coefficients] for row in motion.rows]
        after = dict(zip(motion.slots.velocities, motion.velocities, strict=True))
        self.after = [self.numbers.number(v) for v in motion.velocities]
        # With a restitution the right velocities have A q' ≠ −a, and so have those of another inertia.
        self.drift = [-sum((a * self.numbers.number(after[v]) for a, v in zip(row, after, strict=True)), sp.S.Zero)
                      for row in self.rows]  # fmt: skip

    def energy(self, m: Mechanics) -> sp.Expr:
        """Twice the kinetic energy just after the impact, with the inertia of a changed problem."""
        mass = self.numbers.sum([self.numbers.of_inertia(i) for i in m.inertias])
        v = self.after
        return sum((v[i] * v[j] * g for i, row in enumerate(mass) for j, g in enumerate(row[: len(v)])), sp.S.Zero)

    def velocity(
        self, m: Mechanics, number: int, without: int | None = None, rows: list[int] | None = None
    ) -> sp.Expr | None:
        """A velocity just after with the inertia of a changed problem, or without one of the velocities just before;
        None if it is not determined.

        rows  the constraints that act; all of them if not given
        """
        before = [sp.S.Zero if k == without else v for k, v in enumerate(self.before)]
        chosen = range(len(self.rows)) if rows is None else rows
        held, drift = [self.rows[j] for j in chosen], [self.drift[j] for j in chosen]
        n, r = len(self.before), len(held)
        mass = self.numbers.sum([self.numbers.of_inertia(i) for i in m.inertias])
        right = [
            j + sum((g * v for g, v in zip(row, before, strict=True)), sp.S.Zero)
            for j, row in zip(self.blows, mass, strict=True)
        ]
        system = [[*mass[i], *(-held[j][i] for j in range(r)), right[i]] for i in range(n)]
        system += [[*held[j], *[sp.S.Zero] * r, -drift[j]] for j in range(r)]
        if any(not x.is_number or not x.is_finite for row in system for x in row):
            return None
        return _solved(system, number)


def _solved(rows: list[list[sp.Expr]], number: int) -> sp.Expr | None:
    """One of the unknowns of linear equations [A | b] in numbers, by elimination; None if it is not determined."""
    work = [[*row] for row in rows]
    pivots: dict[int, int] = {}
    for column in range(len(rows[0]) - 1):
        free = [n for n in range(len(work)) if n not in pivots.values()]
        best = max(free, key=lambda n: abs(work[n][column]), default=None)
        if best is None or abs(work[best][column]) < _SMALL:
            continue
        pivots[column] = best
        work[best] = [x / work[best][column] for x in work[best]]
        for n, row in enumerate(work):
            if n != best and row[column] != 0:
                work[n] = [x - row[column] * y for x, y in zip(row, work[best], strict=True)]
    if number not in pivots:
        return None
    others = [x for c, x in enumerate(work[pivots[number]][:-1]) if c != number and abs(x) > _SMALL]
    return None if others else work[pivots[number]][-1]


def _close(a: sp.Expr, b: sp.Expr) -> bool:
    return bool(a.is_number and b.is_number and abs(a - b) <= _SMALL * (1 + abs(b)))
