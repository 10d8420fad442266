"""Momenta and angular momenta that follow from symmetries."""

from __future__ import annotations

from functools import cache

import sympy as sp

from lagrange.algebra.fourier.textbook_form import Textbook
from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Prose, Rule
from lagrange.explain.report import report
from lagrange.mechanics.dynamics.conservation import Conserved
from lagrange.mechanics.dynamics.energy_functions import energy_functions
from lagrange.mechanics.dynamics.noether import SymmetryKind, candidates, symmetries
from lagrange.mechanics.results import Solution
from lagrange.problem.loader import read_problem
from tests.support.conserved import GIVEN_FORCE, differences, of, read
from tests.truth.test_textbook_systems import solution_of


@cache
def solved(name: str) -> Solution:
    return solution_of(name).solution


def kinds(found: Conserved) -> list[tuple[str, str]]:
    return [(i.quantity.value, i.because.value) for i in found.integrals]


def test_a_force_across_the_radius_has_no_potential_and_no_angular_momentum() -> None:
    found = of(GIVEN_FORCE.replace("-kappa*(x*i + y*j)", "kappa*(x*j - y*i)"))
    assert not found.integrals
    assert found.energy is not None
    assert not found.energy.hidden


MAGNET = """
title: Charges in a magnetic field
parameters: [m, q, B, k]
coordinates: [x, y, X, Y]
particles:
  P: {mass: m, position: x*i + y*j}
  Q: {mass: m, position: X*i + Y*j}
forces:
  on_P: {on: P, vector: "q*B*(y'*i - x'*j)"}
  on_Q: {on: Q, vector: "q*B*(Y'*i - X'*j)"}
  repulsion: {potential: "k/sqrt((x - X)^2 + (y - Y)^2)"}
"""


def words_of(text: str) -> str:
    """The prose of the step."""
    shown = report(read_problem(Source("p.yaml", text)))
    [step] = [s for s in shown.derivation.steps if s.rule is Rule.CONSERVED]
    return "".join(p for b in step.body if isinstance(b, Prose) for p in b.parts if isinstance(p, str))


def test_two_charges_have_momenta_and_an_angular_momentum_in_a_magnetic_field() -> None:
    """Landau and Lifshitz II, § 21: the generalized momenta of both in the gauges where what is displaced is symmetric."""
    found = of(MAGNET)
    assert [k for k, _ in kinds(found)] == ["momentum", "momentum", "angular-momentum", "energy"]
    assert {b for k, b in kinds(found) if k != "energy"} == {"rate"}
    assert all(i.constant and i.multipliers for i in found.integrals)
    assert differences(
        found,
        "m*(v_x + v_X) - q*B*(y + Y)",
        "m*(v_y + v_Y) + q*B*(x + X)",
        "m*(x*v_y - y*v_x + X*v_Y - Y*v_X) + q*B*(x^2 + y^2 + X^2 + Y^2)/2",
        "m*(v_x^2 + v_y^2 + v_X^2 + v_Y^2)/2 + k/sqrt((x - X)^2 + (y - Y)^2)",
    ) == [0, 0, 0, 0]


def test_an_electric_field_takes_angular_momentum_away_and_leaves_the_difference_along_it() -> None:
    found = of(MAGNET.replace("k/sqrt((x - X)^2 + (y - Y)^2)", "k*(y + Y)"))
    assert {k for k, _ in kinds(found)} == {"momentum", "energy"}
    left = differences(found, "m*v_x - q*B*y", "m*v_X - q*B*Y", "m*(v_y - v_Y) + q*B*(x - X)",
                       "m*(v_x^2 + v_y^2 + v_X^2 + v_Y^2)/2 + k*(y + Y)")  # fmt: skip
    assert left[:2] == [0, 0]
    assert left[3] == 0
    assert left[2] in (0, sp.expand(read("-2*m*(v_y - v_Y) - 2*q*B*(x - X)")))  # or its negative


BALANCED = """
title: A particle on a turntable, held by a spring that balances the centrifugal force
parameters: [m, omega]
coordinates: [x, y]
let: {e: cos(omega*t)*i + sin(omega*t)*j, n: -sin(omega*t)*i + cos(omega*t)*j}
particles: {P: {mass: m, position: x*e + y*n}}
forces: {spring: {spring: m*omega^2, between: [P, 0*i]}}
"""


def test_a_momentum_of_a_coordinate_that_occurs_in_the_energies_is_not_called_cyclic() -> None:
    """m x' − 2 m ω y, because x'' − 2 ω y' = 0; but L has m ω (x y' − y x')."""
    found = of(BALANCED)
    assert ("momentum", "gauge") not in kinds(found)
    assert differences(of(BALANCED), *(
        "m*(x*v_y - y*v_x) + m*omega*(x^2 + y^2)", "m*v_x - 2*m*omega*y", "m*v_y + 2*m*omega*x",
        "m*(v_x^2 + v_y^2)/2", "m*((v_x - omega*y)^2 + (v_y + omega*x)^2)/2 + m*omega^2*(x^2 + y^2)/2",
    )) == [0, 0, 0, 0, 0]  # fmt: skip
    assert "cyclic, and the force" not in words_of(BALANCED)


def test_a_momentum_is_found_whatever_parameters_are_drawn() -> None:
    """Of some R and a no rod of the length a fits in the field that is drawn: then others are drawn."""
    motion = solved("three_on_a_ring").own.motion
    assert motion is not None
    configuration = motion.configuration
    energies = energy_functions(configuration, Textbook(motion.principle.ring))
    found = candidates(energies, [])
    for seed in range(12):
        configuration.states.fields.random.seed(seed)
        assert {s.kind for s in symmetries(found, configuration)} == {SymmetryKind.TRANSLATION}, seed


def _row(ends: str) -> str:
    """Thirteen masses on a line: more than the coordinates up to which a gauge symmetry is looked for."""
    n = range(1, 14)
    lines = ["title: row", f"parameters: [k, {', '.join(f'm{k}' for k in n)}]"]
    lines += [f"coordinates: [{', '.join(f'x{k}' for k in n)}]", "particles:"]
    lines += [f"  P{k}: {{mass: m{k}, position: x{k}*i}}" for k in n]
    springs = " + ".join(f"(x{k + 1} - x{k})^2" for k in n[:-1])
    return "\n".join([*lines, f"forces: {{V: {{potential: 'k*({springs}{ends})/2'}}}}", ""])


def test_many_displacements_that_all_change_the_potential_are_ruled_out_before_their_conditions_are_written() -> None:
    configuration = of(_row(" + x1^2")).motion.configuration
    principle = of(_row(" + x1^2")).motion.principle
    energies = energy_functions(configuration, Textbook(principle.ring))
    assert [c.kind for c in candidates(energies, [])] == [SymmetryKind.TIME]


def test_a_symmetry_of_many_coordinates_is_found_as_one_of_few_is() -> None:
    assert ("momentum", "translation") in kinds(of(_row("")))
