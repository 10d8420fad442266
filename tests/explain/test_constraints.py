"""The prose about the forms of constraints."""

from __future__ import annotations

import pytest

from lagrange.core.symbols import Wedge
from lagrange.document.derivation import Rule
from lagrange.explain.report import names_of
from tests.support.derivation_text import mathematics, words
from tests.support.shared import SHIPPED, reported


@pytest.mark.parametrize("name", SHIPPED)
def test_a_form_has_a_name_that_nothing_else_has(name: str) -> None:
    result = reported(name)
    taken = names_of(result.solution.problem)
    for step in result.derivation.steps:
        products = [e for m in mathematics(step) if hasattr(m, "atoms") for e in m.atoms(Wedge)]
        names = {str(s) for e in products for s in e.args if "(" not in str(s)}
        assert not names & taken


def test_the_ball_rolls_with_omega_and_its_forms_are_called_otherwise() -> None:
    steps = reported("constraints/rolling-ball").derivation.steps
    [integrability] = [s for s in steps if s.rule is Rule.INTEGRABILITY]
    assert "eta" in {str(s) for m in mathematics(integrability) for s in m.free_symbols}


def test_frobenius_theorem_is_explained_once() -> None:
    """A disc has two constraints that are not integrable, a car with a trailer three."""
    for name, count in (("upright-disc", 2), ("car-with-trailer", 3)):
        steps = reported(name).derivation.steps
        [integrability] = [s for s in steps if s.rule is Rule.INTEGRABILITY]
        text = words(integrability)
        assert text.count("by Frobenius' theorem one does") == 1
        assert text.count("is not exact either") == count - 1
        products = [e for m in mathematics(integrability) for e in m.atoms(Wedge)]
        assert len({str(e) for e in products if len(e.args) == 3}) == count
