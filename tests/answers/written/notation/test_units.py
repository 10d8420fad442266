"""Units of LaTeX as plain text."""

from __future__ import annotations

from lagrange.answers.written.notation.units import plain_unit


def test_units_of_latex_as_text() -> None:
    assert plain_unit(r"\mathrm{m}/\mathrm{s}^{2}") == "m/s^2"
