"""The journal, from which an interrupted batch continues."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path

import pytest

from lagrange.answers.equations import Verdict
from lagrange.answers.submissions import Submission
from lagsolve.grading.journal import Journal, key
from lagsolve.grading.table import TableRow


def row(name: str = "a.txt", remark: str = "", **more: object) -> TableRow:
    return replace(TableRow(name, Verdict.WRONG, 1, 2, 1, remark, 0.5, "a.md"), **more)  # type: ignore[arg-type]


def submission(name: str = "a", content: bytes = b"x", file: str = "f") -> Submission:
    return Submission(name, ((file, content),))


def test_the_key_is_of_everything_that_matters() -> None:
    others: list[Callable[[], str]] = [
        lambda: key(submission("b"), "problem", 1),
        lambda: key(submission(content=b"y"), "problem", 1),
        lambda: key(submission(file="g"), "problem", 1),
        lambda: key(Submission("a", (("f", b""), ("x", b""))), "problem", 1),
        lambda: key(Submission("a", (("f", b"x"),), ("note",)), "problem", 1),
        lambda: key(submission(), "another problem", 1),
        lambda: key(submission(), "problem", 2),
    ]
    assert key(submission(), "problem", 1) == key(submission(), "problem", 1)
    assert len({key(submission(), "problem", 1), *(other() for other in others)}) == 1 + len(others)


def test_a_journal_is_read_again_apart_from_half_a_line(tmp_path: Path) -> None:
    path = tmp_path / "marks.csv.journal"
    journal = Journal(path)
    rows = {f"k{n}": row(f"{n}.txt", "ünï") for n in range(3)}
    for k, r in rows.items():
        journal.add(k, r)
    journal.close(complete=False)
    text = path.read_text(encoding="utf-8")
    path.write_text(text + text.splitlines()[0][:-9], encoding="utf-8")
    again = Journal(path)
    assert [again.row(k) for k in (*rows, "k3")] == [*rows.values(), None]
    again.add("k3", row("3.txt"))
    again.close(complete=False)
    third = Journal(path)
    assert third.row("k3") == row("3.txt")
    third.close(complete=True)
    assert not path.exists()


@pytest.mark.parametrize(
    "line", ["", "{}", "[]", "1", "null", '{"key": "k", "row": {}}', '{"key": "k", "row": 1}', "\udcff"]
)
def test_what_is_no_journal_is_left_out(line: str, tmp_path: Path) -> None:
    path = tmp_path / "journal"
    path.write_bytes(line.encode("utf-8", "surrogateescape") + b"\n")
    journal = Journal(path)
    assert journal.row("k") is None
    journal.close(complete=True)


def test_without_a_path_nothing_is_kept() -> None:
    journal = Journal(None)
    journal.add("k", row())
    assert journal.row("k") is None
    journal.close(complete=False)


FORGED = {
    "more right than required": {"right": 3, "missing": -1},
    "a wrong difference": {"missing": 0},
    "no number": {"right": "2"},
    "a truth value": {"right": True},
    "a huge number": {"right": 10**30, "required": 10**30 + 1},
    "no time": {"seconds": float("nan")},
    "a negative time": {"seconds": -1},
    "an escape sequence": {"remark": "\x1b[2J"},
    "a remark of two lines": {"remark": "a\nb"},
    "a name that is no text": {"submission": 1},
    "no name": {"submission": ""},
    "no verdict": {"verdict": "excellent"},
    "another column": {"grade": 1},
}


@pytest.mark.parametrize("more", FORGED.values(), ids=FORGED)
def test_a_forged_row_is_not_used(more: dict[str, object], tmp_path: Path) -> None:
    path = tmp_path / "journal"
    good = asdict(row())
    lines = [{"key": "good", "row": good}, {"key": "forged", "row": good | more}]
    path.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    journal = Journal(path)
    assert (journal.row("good"), journal.row("forged"), journal.ignored) == (row(), None, 1)
    journal.close(complete=False)


def test_lines_that_no_reader_of_json_survives(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    deep, wide = "[" * 50_000, '{"key": "' + "x" * 1_000_000 + '"}'
    path.write_text(f"{deep}\n{'9' * 5000}\n{wide}\n", encoding="utf-8")
    journal = Journal(path)
    assert journal.ignored == 3
    journal.close(complete=False)


def test_a_journal_is_not_opened_through_a_link_or_a_pipe(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("mine\n")
    (tmp_path / "link").symlink_to("mine")
    os.mkfifo(tmp_path / "pipe")
    for name, said in (("link", "it is a link"), ("pipe", "it is not a regular file")):
        with pytest.raises(OSError, match=said):
            Journal(tmp_path / name)
    assert (tmp_path / "mine").read_text() == "mine\n"


def test_half_a_line_is_removed_and_not_counted(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    path.write_bytes(b'{"key": "k", "ro')
    journal = Journal(path)
    assert journal.ignored == 0
    journal.add("k", row())
    journal.close(complete=False)
    again = Journal(path)
    assert (again.row("k"), again.ignored) == (row(), 0)
    again.close(complete=True)
