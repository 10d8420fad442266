"""Names of forces in equations about impending motion."""

from __future__ import annotations

from lagrange.answers.friction.forces_at_limit import names_of_forces
from tests.support.shared import solved


def test_reactions_and_friction_have_names() -> None:
    solution = solved("ladder-on-rough-ground")
    motions = [m for v in solution.views for m in getattr(v, "impending", ()) or ()]
    newton = solution.law.newton if solution.law is not None else None
    names = [names_of_forces(m, newton) for m in motions]
    assert newton is not None or motions
    assert all(names)
