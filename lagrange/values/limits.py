"""The limits of numerical work: how many digits, how many boxes."""

from __future__ import annotations

WORKING_DIGITS = 30
"""Digits to which constants are evaluated; SymPy raises its working precision until they are correct."""

SPARE_DIGITS = 20
"""Digits beyond those printed, so that rounding them is not decided by an error."""
