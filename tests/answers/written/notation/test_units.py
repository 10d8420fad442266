"""Units of LaTeX as plain text."""

from __future__ import annotations

from lagrange.answers.written.notation.units import plain_unit, units_in_si
from tests.support.scopes import PLANE


def test_units_of_latex_as_text() -> None:
    assert plain_unit(r"\mathrm{m}/\mathrm{s}^{2}") == "m/s^2"


def test_feet_and_inches_may_be_spelled_out() -> None:
    for word, short in (("inches", "in"), ("feet", "ft")):
        [(_, _, written)], [(_, _, usual)] = (units_in_si(f"y = 12 {unit}", PLANE) for unit in (word, short))
        assert written == usual != ""
