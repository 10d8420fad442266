"""The shortest of a few forms of a value."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import shortest_form

alpha = sp.Symbol("alpha", real=True)
a, b, c = sp.symbols("a b c", positive=True)
sin, cos, tan = sp.sin, sp.cos, sp.tan


@pytest.mark.parametrize(
    ("long", "short"),
    [
        (cos(alpha) / sin(alpha), 1 / tan(alpha)),
        (sin(alpha) ** 2 / cos(alpha), sin(alpha) * tan(alpha)),
        (a * sin(alpha) ** 2 + a * cos(alpha) ** 2, a),
        (sp.sqrt(sin(alpha) ** 2 + cos(alpha) ** 2 + b), sp.sqrt(1 + b)),
        (a * b, a * b),
        ((a**2 + b**2) * cos(alpha) / (b * c), (a**2 + b**2) * cos(alpha) / (b * c)),  # and not (a²/b + b) cos α/c
        (b * (1 - a / c), b * (1 - a / c)),
        (b / (a * (a + b - a * cos(alpha) ** 2)), b / (a * (b + a * sin(alpha) ** 2))),
    ],
)
def test_the_form_is_shorter_and_has_the_same_value(long: sp.Expr, short: sp.Expr) -> None:
    found = shortest_form(long)
    assert found == short
    values = {alpha: 0.7, a: 1.3, b: 0.4, c: 1.9}
    assert float(found.subs(values)) == pytest.approx(float(long.subs(values)))
