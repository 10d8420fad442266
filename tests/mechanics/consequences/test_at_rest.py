"""Forces at rest without a dependent coordinate, and the curve for which one vanishes."""

from __future__ import annotations

import math

import pytest

from lagrange.mechanics.consequences.at_rest import dead_centres, shape, without_dependent
from tests.support.shared import solved


def test_the_counterweight_of_a_drawbridge() -> None:
    """With that curve the potential energy of bridge and counterweight is the same at every angle."""
    found = shape(solved("drawbridge").chosen)
    assert found is not None
    assert found.whole is not None
    values = {"l": 3.0, "W": 5.0, "Q": 2.0, "L": 7.0}

    def energy(theta: float) -> float:
        u = values["L"] - 2 * values["l"] * math.sin(theta / 2)
        f = float(found.whole.subs({s: {**values, "u": u}[s.name] for s in found.whole.free_symbols}))
        return values["W"] * values["l"] / 2 * math.cos(theta) - values["Q"] * f

    assert energy(0.3) == pytest.approx(energy(1.1)) == pytest.approx(energy(2.0))


def test_the_moment_on_a_bifilar_suspension() -> None:
    """dV/dθ for V = −W z(θ), by a difference."""
    found = without_dependent(solved("bifilar-suspension").chosen)
    assert found is not None
    l, a, W, theta, h = 2.0, 0.7, 3.0, 0.8, 1e-5
    z = [math.sqrt(l**2 - 2 * a**2 * (1 - math.cos(x))) for x in (theta - h, theta + h)]
    values = {"l": l, "a": a, "W": W, "theta": theta}
    moment = float(found.value.subs({s: values[s.name] for s in found.value.free_symbols}))
    assert moment == pytest.approx(-W * (z[1] - z[0]) / (2 * h), rel=1e-6)


@pytest.mark.parametrize("name", ["ladder", "slider-crank", "roberval-balance"])
def test_nothing_of_that_kind_elsewhere(name: str) -> None:
    assert without_dependent(solved(name).chosen) is None
    assert shape(solved(name).chosen) is None


def test_no_force_on_the_piston_holds_a_crank_at_its_dead_centre() -> None:
    """At θ = 0 the piston is at x = r ± l and moves only with θ², so Q r δθ is the only work of first order."""
    resting = solved("slider-crank").own.equilibrium
    assert resting is not None
    [(wave, moved, force)] = dead_centres(resting)
    assert (str(wave), moved.name, force.name) == ("sin(theta)", "x", "P")
    levers = solved("drawbridge")
    assert all(not [*dead_centres(v.equilibrium)] for v in levers.views if v.equilibrium is not None)
