"""Odd surroundings: streams that cannot be written, variables that are no numbers, folders with modules, no memory."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from lagrange.answers.submissions import Graded
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import ProblemError, Source
from lagrange.render import terminal
from lagsolve import __main__ as program
from lagsolve import inputs
from lagsolve.command_group import report_error, write_stderr
from lagsolve.exit_statuses import UNDECIDED
from lagsolve.grading import run as grading
from lagsolve.grading.examine import _graded
from lagsolve.grading.journal import Journal
from lagsolve.grading.pool import Limits
from lagsolve.grading.run import GradingRun, graded
from lagsolve.grading.table import TableRow, table_text
from lagsolve.limits import PIPED_WIDTH, WIDEST
from lagsolve.output import terminal_width
from tests.support.paths import ROOT
from tests.support.processes import PATIENCE
from tests.support.sample_derivations import pendulum
from tests.support.shared import file_of


class Full:
    """A stream on a full disk."""

    encoding, errors = "utf-8", "strict"

    def write(self, _: str) -> int:
        raise OSError(28, "No space left on device")

    flush = write


def test_a_message_that_cannot_be_written_is_no_error(monkeypatch: pytest.MonkeyPatch) -> None:
    for stream in (Full(), None):
        monkeypatch.setattr(sys, "stderr", stream)
        write_stderr("lost")
        assert report_error(ValueError("lost")) == UNDECIDED


def test_standard_input_that_cannot_be_read(monkeypatch: pytest.MonkeyPatch) -> None:
    class Unreadable:
        class buffer:  # noqa: N801
            @staticmethod
            def read(_: int) -> bytes:
                raise OSError(9, "Bad file descriptor")

    monkeypatch.setattr(inputs.sys, "stdin", Unreadable)
    with pytest.raises(ProblemError, match="standard input cannot be read: Bad file descriptor"):
        inputs.problem_source("-")


def test_too_little_memory_is_said_in_words(capsys: pytest.CaptureFixture[str]) -> None:
    assert report_error(MemoryError()) == UNDECIDED
    said = capsys.readouterr().err
    assert said.startswith("error[out-of-memory]: there is not enough memory")
    failed: Future[Graded] = Future()
    failed.set_exception(MemoryError())
    judged = _graded(failed, last=True)
    assert judged is not None
    for text in (said, judged.headline):
        assert "MemoryError" not in text
        assert "mistake of lagsolve" not in text


@pytest.mark.parametrize(
    ("columns", "width"),
    [("²", PIPED_WIDTH), ("", PIPED_WIDTH), ("x", PIPED_WIDTH), ("-5", PIPED_WIDTH), ("9" * 12, WIDEST)],
)
def test_widths_that_are_none(columns: str, width: int, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("COLUMNS", "LINES"):
        monkeypatch.setenv(name, columns)
    assert terminal_width() == width
    assert "Ideal pendulum" in terminal.coloured(*pendulum(), 80)
    assert "a.txt" in table_text([TableRow("a.txt", Verdict.WRONG, 1, 2, 1, "", 0.5)], 80, on_terminal=False)


def test_nothing_is_imported_from_the_current_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    link = tmp_path / "link"
    link.symlink_to(".")
    monkeypatch.setattr(sys, "path", [str(tmp_path), "", str(link), "/usr/lib", str(ROOT)])
    program._import_nothing_from_here()
    assert sys.path == ["/usr/lib", str(ROOT)]
    monkeypatch.chdir(ROOT)  # where the program itself lies
    program._import_nothing_from_here()
    assert sys.path == ["/usr/lib", str(ROOT)]


def test_modules_among_the_submissions_are_not_run(tmp_path: Path) -> None:
    for name in ("click", "yaml", "sympy", "gmpy2", "textwrap", "json", "re", "typing", "dataclasses", "__future__"):
        (tmp_path / f"{name}.py").write_text("open('loaded', 'w')\nraise SystemExit(9)\n")
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(map(str, (ROOT, ROOT / "cli")))}
    done = subprocess.run(
        [sys.executable, "-m", "lagsolve", "list", "ice"],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        timeout=PATIENCE,
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"ex05-ice-skate" in done.stdout
    assert not (tmp_path / "loaded").exists()


# A batch whose table cannot be written


@pytest.fixture
def batch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> GradingRun:
    """Two submissions, graded in this process."""

    @contextmanager
    def in_this_process(run: GradingRun) -> Iterator[tuple[Any, Any, tuple[Any, ...], int]]:
        with ThreadPoolExecutor(1) as executor:
            yield (
                executor,
                lambda _, __: Graded(Verdict.EQUIVALENT, "equivalent", right=1, required=1),
                (run.sources,),
                1,
            )

    monkeypatch.setattr(grading, "_executor", in_this_process)
    answers = tmp_path / "answers"
    answers.mkdir()
    for name in ("a.txt", "b.txt"):
        (answers / name).write_text("theta'' + g/l*sin(theta) = 0\n")
    problem = file_of("ex11-ideal-pendulum")
    source = Source(str(problem), problem.read_text(encoding="utf-8"))
    return GradingRun((("ex11", source),), (str(answers),), Limits(60, 1024), 1, csv=tmp_path / "marks.csv")


def test_the_journal_stays_until_the_table_is_written(batch: GradingRun, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    assert batch.journal is not None
    with monkeypatch.context() as disk:
        disk.setattr(os, "replace", full)
        with pytest.raises(ProblemError, match=r"marks\.csv cannot be written: No space left on device"):
            graded(batch)
    kept = Journal(batch.journal)
    assert len(kept._known) == 2
    kept.close(complete=False)
    assert [row.verdict for row in graded(batch)] == ["equivalent", "equivalent"]
    assert not batch.journal.exists()


def test_a_batch_whose_journal_cannot_be_written(batch: GradingRun, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Journal, "add", full)
    with pytest.raises(ProblemError, match="journal cannot be written: No space left on device"):
        graded(batch)


def test_a_forged_line_of_the_journal_is_said(batch: GradingRun, capsys: pytest.CaptureFixture[str]) -> None:
    assert batch.journal is not None
    batch.journal.write_text('{"key": "k", "row": {"verdict": "equivalent"}}\nx\n', encoding="utf-8")
    assert len(graded(batch)) == 2
    said = capsys.readouterr().err
    assert said.startswith("note[journal-ignored]: ")
    assert "has 2 lines that no batch has written" in said


def test_a_journal_that_is_a_link_is_not_followed(batch: GradingRun, tmp_path: Path) -> None:
    assert batch.journal is not None
    (tmp_path / "mine").write_text("mine")
    batch.journal.symlink_to(tmp_path / "mine")
    with pytest.raises(ProblemError, match="it is a link, which is not followed"):
        graded(batch)
    assert (tmp_path / "mine").read_text() == "mine"


def test_a_template_is_not_left_half_written(tmp_path: Path) -> None:
    program = (
        "import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)); from lagsolve.main import main; main()"
    )
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(map(str, (ROOT, ROOT / "cli")))}
    called = [sys.executable, "-B", "-c", program, "new", str(tmp_path / "a.yaml")]
    done = subprocess.run(called, env=environment, capture_output=True, timeout=PATIENCE)
    assert done.returncode == 2
    assert b"error[cannot-write]" in done.stderr
    assert os.listdir(tmp_path) == []
