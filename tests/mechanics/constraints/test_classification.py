"""All constraints together: rank, redundancy, hidden relations."""

from __future__ import annotations

from lagrange.mechanics.constraints.classification import classify
from tests.algebra.forms.test_nonlinear_constraints import HEAD, read
from tests.support.shared import loaded


def test_velocities_that_the_constraints_determine_make_finite_relations() -> None:
    """x² + y² = a², x'² + y'² = v²: a point that runs around a circle."""
    problem = read("x^2 + y^2 = a^2", "x'^2 + y'^2 = v^2", head=HEAD.replace("x, y, z, theta", "x, y"))
    found = classify(problem)
    assert (found.holonomic, found.scleronomic, found.integrable_rank) == (True, False, 2)


def test_linear_constraints_keep_their_finite_relations_beside_others() -> None:
    found = classify(read("theta = x", "z' = x*x'", "x'^2 + y'^2 = v^2"))
    assert (found.rank, found.integrable_rank, found.configuration_dimension) == (3, 2, 2)


def test_a_constraint_given_twice_is_redundant() -> None:
    assert classify(read("x'^2 + y'^2 = v^2", "3*x'^2 + 3*y'^2 = 3*v^2")).redundant == ("c2",)


def test_a_surface_that_may_be_at_rest_makes_the_system_rheonomic_only_if_it_moves() -> None:
    rate = classify(loaded("ex13-moving-surface")).rheonomic_with
    assert rate is not None
    assert rate.name == "u"
    assert classify(loaded("ex17-spherical-pendulum")).rheonomic_with is None
