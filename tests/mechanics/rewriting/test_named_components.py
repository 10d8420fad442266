"""Newton's law along named unit vectors."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.mechanics.rewriting.named_components import in_named_components
from lagrange.mechanics.rewriting.named_directions import Directions, unit_directions
from tests.support.shared import solved

DOWN = "cylinder-on-wedge"


def test_a_cylinder_on_a_wedge_along_the_slope() -> None:
    """m (X'' cos α + s'') = m g sin α + F: the normal force has no part in it; and the vectors add up to the same."""
    solution = solved(DOWN, complete=False)
    law = solution.law
    assert law is not None
    assert law.newton.bodies is not None
    body = next(b for b in law.newton.bodies if b.name == "cylinder")
    named = in_named_components(body, unit_directions(solution.problem))
    N, F = (r.force for r in law.newton.reactions)
    assert [{*c.right.free_symbols} & {N, F} for c in named.components] == [{F}, {N}]
    for axis in range(3):
        for part in ("inertia", "applied", "reaction"):
            before, after = (
                sp.Add(*(getattr(c, part) * c.along.fixed().components[axis] for c in b.components))
                for b in (body, named)
            )
            assert sp.simplify(before - after) == 0


def test_what_is_no_shorter_stays() -> None:
    law = solved(DOWN, complete=False).law
    assert law is not None
    assert law.newton.bodies is not None
    wedge, *_ = law.newton.bodies
    tilted: Directions = {"n": Vector((sp.Rational(3, 5), sp.Rational(4, 5), sp.S.Zero))}
    assert in_named_components(wedge, tilted) is wedge
    assert in_named_components(replace(wedge, components=()), tilted).components == ()
