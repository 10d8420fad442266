"""How much work something is, in the units of the budget: the same on every machine."""

from __future__ import annotations

from collections.abc import Callable

from lagrange.core.effort import allowed


def units(work: Callable[[], object]) -> float:
    """The units of the budget that some work takes."""
    with allowed(10**9) as allowance:
        work()
    return allowance.units - allowance.left
