"""Forces from single laws, one after another, against the general solution and a law by hand."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.mechanics.nearby.forces_in_turn import forces_in_turn
from lagrange.mechanics.rewriting.constant_accelerations import constant_accelerations
from tests.support.shared import solved


@pytest.mark.parametrize("name", ["planetary-gear"])
def test_tooth_forces(name: str) -> None:
    solution = solved(name, complete=False)
    view = solution.chosen
    accelerations = constant_accelerations(view)
    assert solution.law is not None
    forces = forces_in_turn(solution.law, solution.own, view, accelerations)
    assert forces is not None
    said = {s.name: e for s, e in forces.items()}
    names = {s.name: s for e in said.values() for s in e.free_symbols}
    moment = names["M_0"] - names["J_0"] * names["alpha''"]
    assert sp.expand(said["F_1"] * names["r"] - moment) == 0  # of the sun wheel: J₀ α'' = M₀ − r F₁
    turning = names["J_1"] * names["psi''"] - names["s"] * (said["F_2"] - names["F_1"])
    assert sp.expand(turning) == 0  # of the planet: J₁ ψ'' = s (F₂ − F₁)


@pytest.mark.parametrize("name", ["planetary-gear"])
def test_wrong_accelerations_are_noticed(name: str) -> None:
    solution = solved(name, complete=False)
    wrong = {a: 2 * e for a, e in constant_accelerations(solution.chosen).items()}
    assert solution.law is not None
    assert forces_in_turn(solution.law, solution.own, solution.chosen, wrong) is None
