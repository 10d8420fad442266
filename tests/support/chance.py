"""How many examples Hypothesis tries."""

from __future__ import annotations

from hypothesis import settings

QUICK = 25


def examples(number: int) -> int:
    """The number of examples of a test: this, or no more than 25 under the profile `quick`, which `make test` uses."""
    return min(number, QUICK) if settings.get_current_profile_name() == "quick" else number
