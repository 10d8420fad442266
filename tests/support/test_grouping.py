"""All tests of a problem are in one group, whatever else they are parametrised by."""

from __future__ import annotations

import pytest

from tests.support.grouping import NAMES, group_of


@pytest.mark.parametrize(
    ("test", "group"),
    [
        ("a.py::test_a[ex11-ideal-pendulum]", "ex11-ideal-pendulum"),
        ("a.py::test_b[chapter6/ex11-ideal-pendulum]", "ex11-ideal-pendulum"),
        ("b.py::test_c[ex11-ideal-pendulum-80.txt]", "ex11-ideal-pendulum"),
        ("b.py::test_c[80-heavy-top]", "heavy-top"),
        ("b.py::test_c[heavy_top-angles]", "heavy_top"),
        ("b.py::test_c[ladders-and-more]", "b.py::test_c"),
        ("b.py::test_c[x = 0]", "b.py::test_c"),
        ("b.py::test_d", "b.py::test_d"),
    ],
)
def test_group(test: str, group: str) -> None:
    assert group_of(test) == group


def test_every_problem_has_its_own_group() -> None:
    assert all(group_of(f"a.py::test[{name}]") == name for name in NAMES)
