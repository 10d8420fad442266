"""The rule by which a seed draws values is a promise: these numbers never change."""

from __future__ import annotations

from collections import Counter

import pytest

from lagrange.problem.variants.drawing import drawn_place

FROZEN = [  # made with `printf 'lagsolve variant 1\0anna\0m' | sha256sum`, the remainder by hand
    ("anna", "m", 2, 1),
    ("anna", "l", 9, 2),
    ("ben", "m", 2, 0),
    ("ben", "l", 9, 2),
    ("12345", "theta_0", 10_000, 3354),
    ("Zoë", "k", 7, 6),
    ("学生", "k", 7, 1),
    ("anna", "l", 1, 0),
]


@pytest.mark.parametrize(("seed", "name", "number", "place"), FROZEN)
def test_a_seed_draws_what_it_has_always_drawn(seed: str, name: str, number: int, place: int) -> None:
    assert drawn_place(seed, name, number) == place


def test_two_ways_of_writing_a_name_are_one_seed() -> None:
    assert drawn_place("Zoe\u0308", "k", 10_000) == drawn_place(" Zoë\n", "k", 10_000)
    assert drawn_place("Zoe", "k", 10_000) != drawn_place("Zoë", "k", 10_000)
    drawn_place("caf\udce9", "k", 7)  # a byte of a file name that is no text


def test_no_value_is_preferred() -> None:
    count = Counter(drawn_place(f"s{n}", "m", 4) for n in range(4000))
    assert sorted(count) == [0, 1, 2, 3]
    assert max(abs(n - 1000) for n in count.values()) < 150  # five standard deviations
