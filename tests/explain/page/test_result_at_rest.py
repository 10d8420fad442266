"""The lines of the result about rest."""

from __future__ import annotations

from lagrange.document.derivation import Rule
from lagrange.explain.page.result_at_rest import result_at_rest
from tests.support.shared import solved


def test_equilibria_have_a_line_and_a_motion_has_none() -> None:
    view = next(v for v in solved("inverted-pendulum-springs").views if v.equilibrium is not None)
    lines = dict(result_at_rest(view))
    assert len(lines[Rule.EQUILIBRIUM]) >= 2
    assert not any(equations for _, equations in result_at_rest(solved("ex11-ideal-pendulum").choices[0]))
