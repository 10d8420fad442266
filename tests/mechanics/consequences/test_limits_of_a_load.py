"""Which limit comes first as a push grows, against the balance of moments in numbers."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.document.derivation import Rule
from lagrange.mechanics.consequences.limits_of_a_load import first_limit, for_one_load
from lagrange.mechanics.equilibrium.loads import load_parameters
from tests.support.derivation_text import said_in
from tests.support.shared import solved


def test_a_crate_slides_first_on_a_smoother_floor() -> None:
    """It slides at P = μ W and tips at P = W b/h, by the moments about its front edge."""
    rest = solved("crate-tips-or-slides").own.at_rest or solved("crate-tips-or-slides").choices[0].at_rest
    assert rest is not None
    first = first_limit(rest)
    assert first is not None
    assert (first.load.name, first.coefficient.name, first.force.name, first.constraint) == ("P", "mu", "N_A", "back")
    b, h, weight = 0.5, 1.1, 10.0
    critical = float(
        first.critical.xreplace({s: sp.Float({"b": b, "h": h}[s.name]) for s in first.critical.free_symbols})
    )
    for mu in (0.2, 0.4, 0.5, 0.9):
        slides, tips = mu * weight, weight * b / h
        assert (slides < tips) is (mu < critical)
    assert critical == pytest.approx(b / h)
    [conditions] = rest.cases
    stated = for_one_load(conditions, load_parameters(rest.configuration))
    assert [str(c.left) for c in stated] == ["P", "P"]
    assert "it slips first if" in said_in("crate-tips-or-slides", Rule.FRICTION_AT_REST)
