"""What answers and equations say beside the quantity that was asked for.

*The way fallen.* At the place where contact ends, or a tension vanishes, a heavy point is lower than at the start by a
length in which only lengths are left: R/3 on a sphere, whatever m and g.

*The velocity before an impact.* An answer u = A − B v² about the motion after it gives v = √((A − u)/B); with A = 1 and
u = cos θ it is √(2/B) sin(θ/2).

*Reactions in a steady state.* In R(q, q') the velocities are those of the answer; if no coordinate is left, R is what
it is in every such state.

*Closed orbits.* To first order the disturbed steady motion is periodic in space if the ratio of its frequency to the
rate of revolution, √(ω²/φ'²), is rational; that is of interest where it is the same for all of the steady motions.

*Driven momenta.* Of a coordinate that is in neither T nor V the equation of motion is dp/dt = Q.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import base, partial, prime
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.limits import LONGEST_DRIVE, LONGEST_INVERTED, LONGEST_WAY, LONGEST_WITH_UNITS
from lagrange.mechanics.questions.results import AnswerBranch, Asked, Route
from lagrange.mechanics.results import InCoordinates, Solution


@record
class Fallen:
    """A particle or body is then lower than at the start by a length; `is_body`: of a body its mass centre is."""

    name: str
    way: sp.Expr
    is_body: bool


@record
class Inverted:
    """The velocity before an impact, from what was asked for."""

    velocity: sp.Symbol
    value: sp.Expr


def fallen_way(solution: Solution, asked: Asked) -> Fallen | None:
    """How far the only heavy point has fallen where a reaction vanishes; None if that is no plain length."""
    reactions = {c.reaction for c in solution.problem.constraints}
    if not any(c.lhs in reactions and c.rhs == 0 for c in asked.question.when) or len(asked.question.when) != 1:
        return None
    view = next((v for v in solution.views if v.name == asked.choice), None)
    states = [s for b in asked.branches if not b.conditions for s in b.states]
    height = None if view is None else _height(view)
    if height is None or not states or not asked.initial or any(b.limit for b in asked.branches):
        return None
    name, h = height
    start = {v.symbol: v.value for v in asked.initial if isinstance(v.symbol, sp.Symbol)}
    ways = {sp.cancel(sp.expand(h.xreplace(start) - h.xreplace(dict(s)))) for s in states}
    coordinates = {*view.configuration.slots.coordinates} if view is not None else set()
    if len(ways) != 1 or any(w.free_symbols & coordinates for w in ways):
        return None
    [way] = ways
    is_length = bool(way.is_positive) and count_operations(way) <= LONGEST_WAY and not way.has(sp.cos, sp.sin)
    bodies = {r.name for r in view.configuration.rotations} if view is not None else set()
    return Fallen(name, sp.factor(way), name in bodies) if is_length else None


def _height(view: InCoordinates) -> tuple[str, sp.Expr] | None:
    """The only heavy point, and how high it is."""
    points = [p for p in view.configuration.points if p.mass != 0]
    weights = [f for f in view.configuration.loads if f.name == "weight"]
    if len(points) != 1 or len(weights) != 1 or weights[0].on != points[0].name:
        return None
    place, down = (v.fixed().components for v in (points[0].position, weights[0].vector))
    along = [n for n, c in enumerate(down) if c != 0]
    if len(along) != 1:
        return None
    [n] = along
    sign = 1 if down[n].is_negative else -1 if down[n].is_positive else 0
    return (points[0].name, sign * place[n]) if sign else None


def velocity_before(solution: Solution, asked: Asked) -> Inverted | None:
    """The velocity before an impact in terms of where the motion after it turns."""
    impact = solution.problem.impact
    if impact is None or len(asked.branches) != 1 or asked.question.by is not None:
        return None
    turns = all(c.rhs == 0 and c.lhs != base(c.lhs) for c in asked.question.when)
    [branch] = asked.branches
    given = [v.value for v in impact.before if v.symbol != base(v.symbol) and v.value.is_Symbol and v.value.is_positive]
    if not turns or not asked.question.when or len({*given}) != 1 or count_operations(branch.rhs) > LONGEST_INVERTED:
        return None
    return _inverted(branch, given[0])


def _inverted(branch: AnswerBranch, v: sp.Symbol) -> Inverted | None:
    rhs = sp.expand(branch.rhs)
    square = sp.factor(rhs.coeff(v, 2))
    rest = sp.expand(rhs - sp.expand(square) * v**2)
    if square == 0 or rest.has(v) or branch.lhs.has(v):
        return None
    if isinstance(branch.lhs, sp.cos) and rest == 1 and (-square).is_positive:  # 1 − cos θ = 2 sin²(θ/2)
        return Inverted(v, sp.sqrt(-2 / square) * sp.Abs(sp.sin(branch.lhs.args[0] / 2)))
    if isinstance(branch.lhs, sp.Symbol) and rest == 0 and square.is_positive:
        return Inverted(v, sp.sqrt(branch.lhs / square))
    return None


def steady_reactions(solution: Solution, asked: Asked) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """The reactions in the steady state asked about, if they are the same at every position."""
    zero = {c.lhs: sp.S.Zero for c in asked.question.when if c.rhs == 0}
    if asked.route is not Route.STATE or len(asked.branches) != 1 or len(zero) < len(asked.question.when) or not zero:
        return
    [branch] = asked.branches
    square = branch.lhs
    if not (isinstance(square, sp.Pow) and square.exp == 2 and isinstance(square.base, sp.Symbol)):
        return
    view = next((v for v in solution.views if v.name == asked.choice), solution.own)
    known = None if view.dynamics is None else view.dynamics.reactions
    values = {} if known is None else known.values
    for symbol in dict.fromkeys(c.reaction for c in solution.problem.constraints):
        value = values.get(symbol, sp.S.Zero)
        if not value.has(square.base):
            continue
        steady = sp.expand(sp.expand_trig(sp.expand(value.xreplace(zero)).subs(square, branch.rhs)))
        angles = sorted({f.args[0] for f in steady.atoms(sp.sin)}, key=str)
        steady = sp.factor(sp.together(sp.expand(steady).subs({sp.sin(a) ** 2: 1 - sp.cos(a) ** 2 for a in angles})))
        moving = {s for s in steady.free_symbols if s in {*value.free_symbols} and s.name.endswith("'")}
        if not moving and not steady.has(sp.sin, sp.cos) and count_operations(steady) <= LONGEST_WAY:
            yield symbol, steady


def closing_ratio(view: InCoordinates) -> tuple[sp.Symbol, sp.Expr] | None:
    """ω/φ' of all steady motions about φ; None if it differs between them, or there are several."""
    steady = view.steady
    if steady is None or len(steady.cyclic) != 1 or len(steady.families) != 1:
        return None
    [phi], [family] = steady.cyclic, steady.families
    places = [c for p in view.configuration.points for c in p.position.fixed().components]
    if not any(c.has(sp.cos(phi)) or c.has(sp.sin(phi)) for c in places):
        return None
    about = family.about
    pairs = [(b, s) for b, s in zip(about.branches, about.at, strict=True) if s is not None]
    if len(pairs) != 1 or len(pairs[0][1].free) != 1:
        return None
    square = about.square_where_stable(*pairs[0])
    if square is None:
        return None
    letters = about.equilibrium.solution.letters  # in which the sine of an acute angle is positive
    ratio = sp.cancel(square / prime(phi) ** 2)
    read = letters.write(ratio)
    moving = {*view.configuration.slots.coordinates, *view.configuration.slots.velocities}
    return None if read.free_symbols & moving or read.is_number else (phi, letters.write(sp.sqrt(ratio)))


def driven_momenta(view: InCoordinates) -> Iterator[tuple[sp.Symbol, sp.Expr, sp.Expr]]:
    """q, p and Q for coordinates that are in neither T nor V, where dp/dt = Q: the angular momentum grows at L.

    Only where p depends on the other coordinates: otherwise the equation of motion says the same.
    """
    configuration = view.configuration
    slots = configuration.slots
    if view.motion is None or configuration.rows or slots.prescribed or not configuration.loads + configuration.torques:
        return
    if view.in_speeds is not None or configuration.velocity_part != 0:
        return
    lagrangian = lagrange_equations(configuration)
    if count_operations(lagrangian.kinetic) > LONGEST_WITH_UNITS:
        return
    for q, v, left in zip(slots.coordinates, slots.velocities, lagrangian.left, strict=True):
        if not all(is_zero(partial(e, q)) for e in (lagrangian.kinetic, lagrangian.potential)):
            continue
        momentum = textbook_form(partial(lagrangian.kinetic, v))
        force = textbook_form(slots.time_derivative(partial(lagrangian.kinetic, v)) - left)
        others = {*slots.coordinates} - {q}
        moving = force.free_symbols & {q, *slots.accelerations, *slots.velocities} - {v}
        if force != 0 and not moving and momentum.free_symbols & others and count_operations(force) <= LONGEST_DRIVE:
            yield q, momentum, force
