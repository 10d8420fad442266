"""The parts of a system, added up, against the derived equations of every shipped problem.

The words of a variation.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.models.mechanics import Variation, called, written
from lagrange.answers.references import ReferenceCandidate
from lagrange.api.interface import check, loads
from lagrange.api.result import Result
from lagrange.core.symbols import Slots
from lagrange.explain.report import report
from tests.support.shared import asking, reference_of


def candidates(name: str) -> list[ReferenceCandidate]:
    return [c for c in reference_of(name).candidates if c.mechanics is not None]


GIVEN_OUTRIGHT = {"oscillating-circuit", "relativistic-oscillator", "blade-from-a-lagrangian"}
"""Problems with a `lagrangian:`, whose kinetic energy has no parts."""


@pytest.mark.parametrize("name", [n for n in asking("motion") if n not in GIVEN_OUTRIGHT])
def test_the_parts_add_up_to_the_derived_equations(name: str) -> None:
    assert all(c.models.mechanics is not None for c in candidates(name))


def test_a_generalized_force_has_the_name_of_the_file() -> None:
    text = "title: T\nparameters: [m, c]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\n"
    text += 'forces: {drag: {generalized: {x: "-c*x\'"}}}\n'
    verdict = check(Result(report(loads(text))), ["m*x'' = c*x'"])
    assert "the force `drag` acting the other way" in str(verdict.equations)


# Variation


theta = sp.Symbol("theta", real=True)
SLOTS = Slots((theta,))


def test_as_it_may_be_typed() -> None:
    assert called("rod") == "`rod`"
    assert written(SLOTS.velocities[0] ** 2 * sp.sin(theta), SLOTS) in ("theta'^2*sin(theta)", "sin(theta)*theta'^2")
    assert dict(Variation("c", "p").rule) == {}
