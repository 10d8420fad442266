"""T, V and the generalized forces, where Lagrange's method begins.

Hamilton's function on a page and in JSON.
"""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule, Step
from lagrange.render.json import as_object
from tests.support.derivation_text import said_in, words
from tests.support.paths import PROBLEMS
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("blade-from-a-lagrangian", Rule.ENERGIES, "The Lagrangian is given. The derivation begins with it: "),
        ("oscillating-circuit", Rule.ENERGIES, "so the generalized force is"),
    ],
)
def test_what_is_said_of_the_energies(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)


# Hamilton


ROUTH = PROBLEMS / "motion" / "spherical-pendulum-by-routh.yaml"
TUBE = PROBLEMS / "motion" / "bead-in-a-turning-tube.yaml"


def step_of(path) -> Step:
    [step] = [s for s in reported(path).derivation.steps if s.rule is Rule.HAMILTON]
    return step


def test_what_is_constant_is_said_with_its_reason() -> None:
    said = words(step_of(ROUTH))
    assert "It is the energy T + V." in said
    assert "φ does not appear in H, so p_φ is constant." in said
    assert "For θ alone, Routh's function" in said


def test_a_function_that_is_not_the_energy_is_called_so() -> None:
    said = words(step_of(TUBE))
    assert "It is not the energy T + V: the positions contain time" in said
    assert "it is constant" in said
    assert "Routh" not in said


def test_json_has_all_of_it() -> None:
    found = as_object(reported(ROUTH))["hamiltonian"]
    assert found["momenta"] == {"theta": "m*l^2*theta'", "phi": "m*l^2*phi'*sin(theta)^2"}
    assert found["equations"][-1] == "p_phi' = 0"
    assert found["cyclic"] == ["phi"]
    assert "routhian" in found
    assert as_object(reported(TUBE))["hamiltonian"]["is_energy"] is False
