"""The page of a large system."""

from __future__ import annotations

from types import SimpleNamespace

from lagrange.explain.rest.large_systems import result_of_large_system
from tests.mechanics.nearby.test_linear_motion import bicycle


def test_the_page_of_the_bicycle_begins_with_these_speeds() -> None:
    solution = SimpleNamespace(linear_motion=bicycle()[2], classification=SimpleNamespace(degrees_of_freedom=3))
    [step] = result_of_large_system(solution)
    [head] = step.body
    words = "".join(p if isinstance(p, str) else str([float(x) for x in p.sides if x.is_number]) for p in head.parts)
    assert words.startswith("Three degrees of freedom; small deviations from the steady motion decay if [4.292")
    assert "6.024" in words
