"""All tests of a problem are in one group, whatever else they are parametrised by."""

from __future__ import annotations

import pytest

from tests.support import grouping
from tests.support.grouping import (
    BATCHES,
    CHAPTER,
    NAMES,
    batch_of,
    group_of,
    longest_first,
    part_of,
    tried_with_many,
    unit_of,
)
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


def test_what_takes_a_fixture_of_its_module_is_one_unit_and_in_one_part() -> None:
    file = "animation/test_played.py"
    tests = [
        f"{file}::test_energy_and_constraints_are_kept[heavy-top]",
        f"{file}::test_energy_and_constraints_are_kept[rolling-disc]",
        f"{file}::test_a_slider_changes_the_parameter_and_the_motion",
    ]
    assert {unit_of(test) for test in tests} == {file}
    assert len({part_of(test, 1000) for test in tests}) == 1
    with_parameters = "problems/test_read_back.py::test_equations_can_be_read_again[heavy-top]"
    assert unit_of(with_parameters) == f"batch-{batch_of('heavy-top')}"


def test_what_is_tried_with_every_shipped_problem() -> None:
    each = [f"a.py::each[{name}-{n}]" for name in SHIPPED for n in range(2)]
    some = [f"a.py::some[{name}-{n}]" for name in [*SHIPPED][-30:] for n in range(2)]
    found = tried_with_many([*each, *some, "a.py::one"])
    assert found == {t for t in each if group_of(t) not in CHAPTER}
    assert {group_of(t) for t in each} - {group_of(t) for t in found} == CHAPTER
    assert {part_of(t, 4) for t in found} == {*range(4)}
    assert all(part_of(t, 40) % 4 == part_of(t, 4) for t in found)  # on the day of its slow tests a problem is solved


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
