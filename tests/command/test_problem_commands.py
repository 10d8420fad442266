"""The commands about problem files: list, show, new, completion. `schema` has a test file of its own."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from rich.cells import cell_len

from lagrange.problem import library
from lagsolve import shipped
from lagsolve.main import main
from lagsolve.new_file import TEMPLATE
from lagsolve.shipped import Entry, Index


def run(*arguments: str, env: dict[str, str] | None = None) -> Result:
    """Runs the command. No run may end in an exception, whatever it is asked."""
    result = CliRunner().invoke(main, arguments, env={"COLUMNS": None} | (env or {}))
    assert result.exception is None or isinstance(result.exception, SystemExit)
    return result


# list


def test_into_a_pipe_a_problem_is_a_line_whatever_the_width() -> None:
    listed = run("list")
    assert (listed.exit_code, listed.stderr) == (0, "")
    rows = [line.split("\t") for line in listed.stdout.splitlines()]
    assert [row[0] for row in rows] == list(library.entries())
    assert {len(row) for row in rows} == {5}
    assert "\tIdeal pendulum\tmotion\tChapter 6, Ex. 11\t" in listed.stdout
    for same in (run("list", env={"COLUMNS": "30"}), run("list", "--long")):
        assert same.stdout == listed.stdout


LONG = "A. Nobody, An Inordinately Long Title of a Book on Mechanics, volume 2, chapter 17, problem 4"
ENTRIES = [
    Entry(
        "a/one", "The first", LONG, ("motion", "linearization"), "A sentence that says what one learns from this one."
    ),
    Entry("a/two-with-a-long-name-of-its-own", "The second, whose title is rather long as well", "", ("motion",), ""),
    Entry("b/three", "The third", "Somebody", ("equilibrium",), ""),
]


def page(width: int, long: bool = False, styled: bool = False, entries: Sequence[Entry] = ENTRIES) -> str:
    called = {e.name: e.name.rpartition("/")[2] for e in entries}
    return shipped.listed_by_topic(entries, Index({"b": "Of b"}, {}), called, width, long=long, styled=styled)


def test_a_page_has_headings_in_the_order_of_the_index() -> None:
    assert page(80) == (
        "b: Of b\n"
        "  three  The third\n"
        "      equilibrium; Somebody\n"
        "\n"
        "a\n"
        "  one                              The first\n"
        "      motion, linearization; A. Nobody, An Inordinately Long Title of a Book …\n"
        "  two-with-a-long-name-of-its-own\n"
        "      The second, whose title is rather long as well\n"
        "      motion\n"
    )
    whole = page(80, long=True)
    assert "The first\n      A sentence" in whole
    assert "\n\n  two-with" in whole
    assert " ".join(LONG.split()) in " ".join(whole.split())
    assert "A sentence that says what one learns from this one." in whole
    assert "\x1b[1mthree\x1b[0m" in page(80, styled=True)
    assert "\x1b" not in page(80)


@pytest.mark.parametrize("width", [20, 40, 60, 80, 120, 1000])
@pytest.mark.parametrize("long", [True, False])
def test_no_page_is_wider_than_the_terminal(width: int, long: bool) -> None:
    entries = shipped.containing(())
    called = library.short_names()
    text = shipped.listed_by_topic(entries, shipped.index(), called, width, long=long, styled=False)
    longest = max(len(n) for n in called.values()) + 2  # a name is not broken
    assert max(cell_len(line) for line in text.splitlines()) <= max(width, longest)


# show


def test_show_says_that_it_knows_shipped_problems_only(here: Path) -> None:
    (here / "mine.yaml").write_text(TEMPLATE)
    result = run("show", "mine.yaml")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "there is no shipped problem `mine.yaml`" in result.stderr
    assert "`lagsolve list statics` shows its problems" in run("show", "statics").stderr


# new


# Names that are not there


# Shell completion
