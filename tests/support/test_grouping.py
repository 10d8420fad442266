"""All tests of a problem are in one group, whatever else they are parametrised by."""

from __future__ import annotations

import pytest

from tests.support import grouping
from tests.support.grouping import BATCHES, NAMES, batch_of, group_of, longest_first, part_of, unit_of
from tests.support.shared import SHIPPED


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


def test_a_batch_of_problems_is_one_unit() -> None:
    batch = f"batch-{batch_of('heavy-top')}"
    assert unit_of("a.py::test_a[heavy-top]") == unit_of(f"b.py::test_b[brief-{batch}]") == batch
    assert unit_of(f"b.py::test_b[{batch}-brief]") == unit_of(f"b.py::test_b[{batch}]") == batch
    assert unit_of("a.py::test_a[heavy_top]") == "heavy_top"
    assert {batch_of(name) for name in SHIPPED} == {*range(BATCHES)}


def test_a_function_that_names_a_problem_runs_with_its_batch(monkeypatch: pytest.MonkeyPatch) -> None:
    pendulum = f"batch-{batch_of('ex11-ideal-pendulum')}"
    named = "truth/test_lagrange_method.py::test_each_method_is_checked_by_the_other"
    by_constant = "answers/written/test_judging.py::test_an_equation_of_motion_has_an_acceleration_or_a_reaction"
    assert unit_of(named) == unit_of(by_constant) == pendulum
    own = "support/test_grouping.py::test_every_problem_has_its_own_group"
    assert unit_of(own) == own
    assert unit_of("no/test_file.py::test_a") == "no/test_file.py::test_a"
    monkeypatch.setattr(grouping, "SECONDS", {named: 20.0})
    unit_of.cache_clear()
    assert unit_of(named) == named
    unit_of.cache_clear()


def test_the_longest_group_comes_first_and_groups_stay_together(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(grouping, "SECONDS", {"a.py::long": 20.0, "b.py::half": 6.0, "c.py::little": 2.0})
    other = next(name for name in SHIPPED if batch_of(name) != batch_of("heavy-top"))
    tests = [
        "c.py::little",
        "b.py::half[heavy-top]",
        "z.py::none",
        f"b.py::half[{other}]",
        "a.py::long",
        "y.py::x[heavy-top]",
    ]
    assert longest_first(tests) == [4, 1, 5, 3, 0, 2]


def test_all_tests_of_a_problem_are_in_one_part_and_others_are_spread() -> None:
    assert len({part_of(f"{file}.py::test_a[heavy-top]", 20) for file in "abcdefgh"}) == 1
    assert len({part_of(f"a.py::test_a[{n}]", 20) for n in range(500)}) == 20
    assert {part_of(f"a.py::test_a[{n}]", 20) for n in NAMES} == {*range(20)}
