"""Files are written in one step, and an old one is kept when anything goes wrong."""

from __future__ import annotations

import errno
import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from lagrange.core.diagnostics import ProblemError
from lagsolve import written_files
from lagsolve.main import main
from lagsolve.written_files import write_file
from tests.support.paths import ROOT
from tests.support.processes import PATIENCE


@pytest.fixture
def old(tmp_path: Path) -> Path:
    path = tmp_path / "page.html"
    path.write_text("old", encoding="utf-8")
    return path


def refused(path: Path, text: str = "new", **more: bool) -> str:
    with pytest.raises(ProblemError) as error:
        write_file(path, text, **more)
    [finding] = error.value.diagnostics
    assert finding.code == "cannot-write"
    return finding.message


def test_permissions_are_kept_and_those_of_a_new_file_follow_the_mask(old: Path, tmp_path: Path) -> None:
    old.chmod(0o640)
    write_file(old, "new θ")
    assert (old.read_text(encoding="utf-8"), stat.S_IMODE(old.stat().st_mode)) == ("new θ", 0o640)
    before = os.umask(0o027)
    try:
        write_file(tmp_path / "new.txt", "x")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "new.txt").stat().st_mode) == 0o640
    assert sorted(os.listdir(tmp_path)) == ["new.txt", "page.html"]


def test_links(old: Path, tmp_path: Path) -> None:
    """The user's own link leads to the file that is written; one that lies in a folder of pages is replaced."""
    link = tmp_path / "link.html"
    link.symlink_to(old.name)
    write_file(link, "first")
    assert link.is_symlink()
    assert old.read_text() == "first"
    write_file(link, "second", follow=False)
    assert not link.is_symlink()
    assert (old.read_text(), link.read_text()) == ("first", "second")
    nowhere = tmp_path / "nowhere.html"
    nowhere.symlink_to("made.html")
    write_file(nowhere, "third")
    assert (tmp_path / "made.html").read_text() == "third"


def test_a_pipe_in_a_folder_of_pages_does_not_block(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "a.md")
    write_file(tmp_path / "a.md", "x", follow=False)
    assert (tmp_path / "a.md").read_text() == "x"


def test_what_is_no_regular_file_is_written_to() -> None:
    write_file(Path(os.devnull), "x")
    assert not Path(os.devnull).is_file()


FULL = """
import resource, sys
from pathlib import Path
from lagrange.core.diagnostics import ProblemError
from lagsolve.written_files import write_file
resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
try:
    write_file(Path(sys.argv[1]), "x" * 100_000)
except ProblemError as error:
    print(error.show())
"""


def test_a_full_disk_leaves_the_old_file(old: Path, tmp_path: Path) -> None:
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(map(str, (ROOT, ROOT / "cli")))}
    done = subprocess.run(
        [sys.executable, "-c", FULL, str(old)], env=environment, capture_output=True, timeout=PATIENCE, check=True
    )
    assert b"error[cannot-write]" in done.stdout
    assert b"File too large" in done.stdout
    assert old.read_text() == "old"
    assert os.listdir(tmp_path) == ["page.html"]


def test_an_interruption_leaves_the_old_file(old: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_file(old, "new")
    assert old.read_text() == "old"
    assert os.listdir(tmp_path) == ["page.html"]


@pytest.mark.parametrize("number", [errno.EACCES, errno.EROFS, errno.EBUSY])
def test_a_file_that_cannot_be_replaced_is_written_in_place(
    number: int, old: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A folder that may not be written, and a file that is mounted by itself. There is no new file there."""
    real = os.open

    def denied(path: str, *arguments: int) -> int:
        if os.path.basename(path).startswith(".lagsolve"):
            raise OSError(number, os.strerror(number))
        return real(path, *arguments)

    def busy(*_: object) -> None:
        raise OSError(number, os.strerror(number))

    if number == errno.EBUSY:
        monkeypatch.setattr(os, "replace", busy)
    else:
        monkeypatch.setattr(written_files.os, "open", denied)
    old.write_text("something longer")
    write_file(old, "new")
    assert old.read_text() == "new"
    assert os.strerror(number) in refused(tmp_path / "another.html")
    assert os.listdir(tmp_path) == ["page.html"]


def test_a_file_that_may_not_be_written_is_not_replaced(old: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)
    assert "Permission denied" in refused(old)
    assert old.read_text() == "old"


@pytest.mark.parametrize("name", ["no/folder.html", "n" * 300, "a\0b", "page.html/x"])
def test_where_nothing_can_be_written(name: str, old: Path, tmp_path: Path) -> None:
    assert "cannot be written: " in refused(tmp_path / name)
    assert old.read_text() == "old"


def test_the_command_says_what_it_cannot_write(tmp_path: Path) -> None:
    problem = tmp_path / "p.yaml"
    problem.write_text("title: T\ncoordinates: [x, y]\nconstraints: {a: x = y}\n")
    missing = tmp_path / "no" / "x.html"
    result = CliRunner().invoke(main, [str(problem), "-o", str(missing)])
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.startswith("error[cannot-write]")
    page = tmp_path / "x.html"
    page.write_text("old")
    page.chmod(0o600)
    assert CliRunner().invoke(main, [str(problem), "-o", str(page)]).exit_code == 0
    assert page.read_text(encoding="utf-8").endswith("</html>\n")
    assert stat.S_IMODE(page.stat().st_mode) == 0o600


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the system has no named pipes")
def test_a_pipe_from_which_nobody_reads_is_refused(tmp_path: Path) -> None:
    """It would be waited for, for ever; so would one in place of a figure beside a page."""
    os.mkfifo(tmp_path / "page.html")
    assert "no program reads from this pipe" in refused(tmp_path / "page.html")
    reader = os.open(tmp_path / "page.html", os.O_RDONLY | os.O_NONBLOCK)
    write_file(tmp_path / "page.html", "new")
    assert os.read(reader, 10) == b"new"
    os.close(reader)
    os.mkfifo(tmp_path / "page-1.svg")
    with pytest.raises(ProblemError, match="it is no figure"):
        written_files.write_figures(tmp_path, {"page-1.svg": "<svg/>"})


@pytest.mark.skipif(not Path("/dev/fd").exists(), reason="the system has no /dev/fd")
def test_a_pipe_without_a_name_is_written_to() -> None:
    """`-o >(...)`, and `-o /dev/stdout` before another command."""
    reader, writer = os.pipe()
    write_file(Path(f"/dev/fd/{writer}"), "new")
    assert os.read(reader, 10) == b"new"
    os.close(reader)
    os.close(writer)
