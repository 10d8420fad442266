"""What two displacements and both back leave, against going there step by step."""

from __future__ import annotations

from math import cos, sin

import pytest
import sympy as sp

from lagrange.algebra.forms.brackets import manoeuvre

x, y, theta = sp.symbols("x y theta", real=True)


def test_a_skate_that_turns_and_comes_back_has_moved_sideways() -> None:
    found = manoeuvre((sp.sin(theta), -sp.cos(theta), sp.S.Zero), (x, y, theta))
    assert found is not None
    assert found.first == (sp.cos(theta), sp.sin(theta), 0)
    assert found.second == (0, 0, 1)
    epsilon, heading = 1e-3, 0.7
    # forward, turn, back along the new heading, turn back
    end = (
        epsilon * (cos(heading) - cos(heading + epsilon)),
        epsilon * (sin(heading) - sin(heading + epsilon)),
    )
    expected = [float(e.subs(theta, heading)) * epsilon**2 for e in found.left_over]
    assert end == pytest.approx(expected[:2], rel=2e-3)
    assert expected[2] == 0


def test_nothing_is_said_of_forms_with_three_coefficients() -> None:
    assert manoeuvre((x, y, theta), (x, y, theta)) is None
