"""Names of shipped problems: whole, their last part, or the beginning of it."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import ProblemError
from lagrange.problem.library import entries, named, path_of, short_names, topic_hint
from tests.support.paths import PROBLEMS


def test_every_problem_has_an_entry() -> None:
    found = entries()
    assert sorted(found.values()) == sorted(PROBLEMS.glob("*/*.yaml"))
    assert all(path == PROBLEMS / f"{name}.yaml" for name, path in found.items())


@pytest.mark.parametrize("name", ["chapter6/ex11-ideal-pendulum", "ex11-ideal-pendulum", "ex11"])
def test_three_ways_to_name_a_problem(name: str) -> None:
    assert path_of(name) == PROBLEMS / "chapter6" / "ex11-ideal-pendulum.yaml"


def test_a_short_name_means_its_problem_and_no_other() -> None:
    for name, short in short_names().items():
        assert named(short) == {name: entries()[name]}


def test_a_beginning_ends_with_a_word() -> None:
    assert named("ex1") == {}
    assert {n.rpartition("/")[2] for n in named("ex15")} == {"ex15-rough-incline", "ex15-rough-surface"}


@pytest.mark.parametrize(
    ("name", "code", "says"),
    [
        ("ex15", "several-problems", "ex15-rough-surface"),
        ("ladderr", "no-such-problem", "`ladder`"),
        ("statics", "no-such-problem", "topic"),
    ],
)
def test_a_name_that_means_no_problem(name: str, code: str, says: str) -> None:
    with pytest.raises(ProblemError) as refused:
        path_of(name)
    [diagnostic] = refused.value.diagnostics
    assert diagnostic.code == code
    assert says in f"{diagnostic.message} {diagnostic.help}"


def test_only_topics_are_topics() -> None:
    assert topic_hint("statics/")
    assert topic_hint("ladder") == ""
