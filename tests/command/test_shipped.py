"""The shipped library, its list and its short names."""

from __future__ import annotations

from pathlib import Path

import pytest

from lagrange.problem import library
from lagrange.problem.loader import load
from lagsolve import shipped
from lagsolve.shipped import Entry, Index
from tests.command.test_problem_commands import run
from tests.support.paths import PROBLEMS


def test_the_list_says_what_is_asked_as_the_loader_understands_it() -> None:
    asked = {e.name: e.asked for e in shipped.containing(())}
    assert asked == {name: tuple(load(path).find) for name, path in library.entries().items()}


def test_words_are_sought_in_name_text_topic_and_exercise(monkeypatch: pytest.MonkeyPatch) -> None:
    names = [line.split("\t")[0] for line in run("list", "ICE", "sideways", "chapter6/").stdout.splitlines()]
    assert names == ["chapter6/ex05-ice-skate"]
    says = Index({"statics": "All about zyzzyva"}, {"sleigh": "quux and more", "motion/heavy-top": "quux"})
    monkeypatch.setattr(shipped, "index", lambda: says)
    assert {e.topic for e in shipped.containing(["ZYZZYVA"])} == {"statics"}
    found = shipped.containing(["quux"])
    assert [(e.name, e.exercises) for e in found] == [("motion/heavy-top", "quux"), ("motion/sleigh", "quux and more")]
    none = run("list", "xyzzy")
    assert (none.exit_code, none.stdout) == (0, "")
    assert "`xyzzy`; the topics are chapter6 constraints forced impacts lagrangians large motion" in none.stderr


def test_the_index_is_no_problem_and_has_the_topics() -> None:
    assert (PROBLEMS / "index.yaml").is_file()
    assert not [name for name in library.entries() if "index" in name]
    says = shipped.index()
    assert set(says.topics) == {name.partition("/")[0] for name in library.entries()}
    assert set(says.exercises) <= set(library.entries()) | {n.rpartition("/")[2] for n in library.entries()}


def test_a_library_without_an_index(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "a.yaml").write_text("title: A\ncoordinates: [x]\n")
    monkeypatch.setattr(shipped, "root", lambda: tmp_path)
    monkeypatch.setattr("lagrange.problem.library.root", lambda: tmp_path)
    assert shipped.index() == Index({}, {})
    assert shipped.containing(()) == (Entry("b/a", "A", "", ("constraints",), ""),)
    assert shipped.listed_by_topic(
        shipped.containing(()), shipped.index(), {"b/a": "a"}, 40, long=False, styled=False
    ) == ("b\n  a  A\n      constraints\n")


def test_short_names_mean_one_problem_each() -> None:
    for name, short in library.short_names().items():
        assert list(library.named(short)) == [name]
