"""How many examples Hypothesis and the other random tests try; `pytest --times 10` tries ten times as many."""

from __future__ import annotations

from hypothesis import settings

QUICK = 25
_factor = 1


def try_times(factor: int) -> None:
    """From now on so many times as many."""
    global _factor
    _factor = factor


def times(number: int) -> int:
    """The number of random cases of a test."""
    return _factor * number


def examples(number: int) -> int:
    """That of a test by Hypothesis: no more than 25 under the profile `quick`, which `make test` uses."""
    return min(number, QUICK) if settings.get_current_profile_name() == "quick" else times(number)
