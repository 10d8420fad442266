"""Numbers that nobody has given."""

from __future__ import annotations

import sympy as sp

from lagrange.programs.defaults import angles_in


def test_angles_are_what_is_turned():
    a, b, c = sp.symbols("a b c", real=True)
    assert angles_in([sp.sin(2 * a + b) * c]) == {a, b}
