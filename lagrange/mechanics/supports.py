"""The forces at two smooth supports of a rigid rod at rest, whose coordinates have its ends on them.

A coordinate that runs along a support leaves the force of the support out of the equations. It is found from the rod
as a whole. Points of which each keeps its distance from the others are points of one rigid body; a point whose position
r(q) depends on a single coordinate q is kept on a curve, and a smooth curve exerts a force R n, normal to ∂r/∂q. With
two such points, in a plane,

    R_1 n_1 + R_2 n_2 + Σ F = 0

determines both forces. The balance of moments, Σ r × F + R_1 r_1 × n_1 + R_2 r_2 × n_2 = 0, is then one more equation
than there are unknowns: it must hold at every equilibrium that virtual work has found; where it does not, no force is
stated.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Bounded, range_of, sign_in_range
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.equilibrium.stability import on_branch
from lagrange.mechanics.results import InCoordinates, Solution


@record
class Support:
    """The force R n of a smooth support on a point.

    coordinate  along the support
    normal      the unit vector n, on the side to which the support pushes, as far as the sign of R is known
    size        R
    """

    point: str
    coordinate: sp.Symbol
    normal: Vector
    size: sp.Expr


@record
class Supports:
    """Both forces, and the names of the points that are one rigid body."""

    at: tuple[Support, Support]
    rigid: tuple[str, ...]


def supports(solution: Solution) -> Supports | None:
    """The forces at two supports of a rigid rod; None of any other system."""
    own, chosen = solution.own, solution.chosen
    configuration = own.configuration
    if chosen.equilibrium is None or own.dynamics is not None or not _is_rod(configuration, chosen.configuration):
        return None
    guided = [(p, q) for p in configuration.points if (q := _sole_coordinate(p, configuration)) is not None]
    if len(guided) != 2 or guided[0][1] == guided[1][1]:
        return None
    normals = [_normal(p, q) for p, q in guided]
    load = sum((f.vector for f in configuration.loads), Vector.zero()).fixed().components
    if any(n is None for n in normals):
        return None
    (a, b), (c, d) = (n.fixed().components[:2] for n in normals if n is not None)
    determinant = textbook_form(a * d - b * c)
    if is_zero(determinant) is not False:
        return None
    sizes = (
        _shortest(load[1] * c - load[0] * d, determinant),
        _shortest(load[0] * b - load[1] * a, determinant),
    )
    at = [
        _pushing(Support(p.name, q, n, s)) for (p, q), n, s in zip(guided, normals, sizes, strict=True) if n is not None
    ]
    if not _turns_nothing(chosen, configuration, at):
        return None
    return Supports((at[0], at[1]), tuple(p.name for p in configuration.points))


def angle_bound(s: Support, q: sp.Symbol, solution: Solution) -> tuple[sp.Expr, bool] | None:
    """Where c sin(φ ± q) ≥ 0 with a positive c ends: ∓φ, and whether from above; None of any other function."""
    chosen = solution.choices[0]
    value = chosen.configuration.rewritten(s.coordinate)
    sines = [f for f in sp.Mul.make_args(value) if isinstance(f, sp.sin) and f.has(q)]
    limits = chosen.configuration.ranges.get(q)
    if len(sines) != 1 or limits is None:
        return None
    [sine] = sines
    rest = value / sine
    slope = sine.args[0].diff(q)
    if rest.has(q) or sign_of(rest) != 1 or slope not in (1, -1):
        return None
    offset = sine.args[0].xreplace({q: sp.S.Zero})
    ends = range_of(offset + slope * Bounded(q.name, limits.low, limits.high))
    if ends is None or ends.low < -sp.pi or ends.high > sp.pi or not all(ends.strict):
        return None
    return (-offset / slope, slope == -1)


def angle_condition(
    chosen: InCoordinates, q: sp.Symbol, low: sp.Expr, high: sp.Expr
) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """low ≤ q ≤ high for the only equilibrium tan q = a/b, as b tan low ≤ a ≤ b tan high: the tangent grows.

    None if the bounds are not between −π/2 and π/2, b is not positive, or there is another equilibrium.
    """
    rest = chosen.equilibrium
    if rest is None or len(rest.branches) != 1 or len(rest.branches[0].relations) != 1:
        return None
    [relation] = rest.branches[0].relations
    ends = (-low, high)
    if relation.lhs != sp.tan(q) or any(sign_in_range(w(e)) != 1 for e in ends for w in (sp.sin, sp.cos)):
        return None
    below = {sp.tan(e): sp.Dummy(positive=True) for e in ends}
    a, b = sp.fraction(sp.together(relation.rhs.xreplace(below)))
    back = {d: w for w, d in below.items()}
    if not b.is_positive:
        return None
    return tuple(e.xreplace(back) for e in (-b * below[sp.tan(-low)], a, b * below[sp.tan(high)]))


def _is_rod(own: Configuration, chosen: Configuration) -> bool:
    """Whether all points are in the plane of i and j, keep their distances, and have all the forces."""
    if own.rotations or own.links or own.potential != 0 or own.torques or len(own.points) < 2:
        return False
    if any(f.elsewhere for f in own.loads) or any(p.position.fixed().components[2] != 0 for p in own.points):
        return False
    for p, r in combinations(chosen.points, 2):
        apart = p.position.fixed() - r.position.fixed()
        square = sp.Add(*(x**2 for x in apart.components))
        if not all(chosen.surface.is_zero(square.diff(q)) for q in chosen.slots.coordinates):
            return False
    return not chosen.rows


def _sole_coordinate(p: MassPoint, configuration: Configuration) -> sp.Symbol | None:
    """The only coordinate on which the position of a point depends."""
    slots = configuration.slots
    moving = [q for q in slots.coordinates if any(x.has(q) for x in p.position.fixed().components)]
    return moving[0] if len(moving) == 1 else None


def _normal(p: MassPoint, q: sp.Symbol) -> Vector | None:
    """The unit vector normal to ∂r/∂q; None unless q is a length along the curve."""
    x, y, _ = p.position.fixed().components
    along = (x.diff(q), y.diff(q))
    if is_zero(along[0] ** 2 + along[1] ** 2 - 1) is not True:
        return None
    return Vector((-along[1], along[0], sp.S.Zero))


def _shortest(above: sp.Expr, below: sp.Expr) -> sp.Expr:
    """A quotient of sines and cosines, with sin 2α as one sine or as a product, whichever is shorter."""
    above = textbook_form(above)
    forms = [above / b for b in (below, sp.expand_trig(below))]
    return min(map(shortest_form, (*forms, *map(sp.cancel, forms))), key=lambda e: count_operations(e))


def _pushing(s: Support) -> Support:
    """The force with the normal on the side to which it pushes."""
    if sign_of(s.size) != -1:
        return s
    return Support(s.point, s.coordinate, s.normal * sp.S.NegativeOne, -s.size)


def _turns_nothing(chosen: InCoordinates, own: Configuration, at: Sequence[Support]) -> bool:
    """Whether the moments balance at every equilibrium."""
    e = chosen.equilibrium
    if e is None or not e.branches or any(b.left or b.special for b in e.branches):
        return False
    where = {p.name: p.position.fixed().components for p in chosen.configuration.points}
    forces = [(f.on, f.vector.fixed().components) for f in own.loads]
    forces += [(s.point, (s.normal * s.size).fixed().components) for s in at]
    moment = sp.Add(*(where[n][0] * f[1] - where[n][1] * f[0] for n, f in forces))
    values = [on_branch(b, moment, e) for b in e.branches]
    return all(v is not None and is_zero(v) is True for v in values)
