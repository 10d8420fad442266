"""Three-valued verdicts: True, False, or None where a question is undecided."""

from __future__ import annotations

from collections.abc import Iterable


def all_hold(verdicts: Iterable[bool | None]) -> bool | None:
    """Whether all verdicts are True: False if one is False, otherwise None if one is undecided (Kleene)."""
    known = set(verdicts)
    return False if False in known else None if None in known else True
