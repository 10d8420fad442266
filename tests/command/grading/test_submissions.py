"""What is handed in, and what is handed out: folders read without trust, the CSV file, the pages, the journal."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from lagrange.answers.submissions import Submission
from lagrange.core.diagnostics import ProblemError
from lagsolve.grading.submissions import UnreadSubmission, UnreadSubmissionError, named_submissions


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "answers").mkdir()
    return tmp_path / "answers"


def named(*names: str | Path, own: tuple[Path, ...] = ()) -> list[str]:
    return [e.name for e in named_submissions([str(n) for n in names], own)]


def read(path: Path) -> Submission:
    return UnreadSubmission("x", path).read()


# Submissions


def test_files_and_folders_are_submissions_and_hidden_ones_are_not(folder: Path) -> None:
    for name in ("b.txt", "a.tex", ".hidden", "carol/answer.txt", ".git/config"):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).touch()
    assert named(folder) == ["a.tex", "b.txt", "carol"]
    assert named(folder / "b.txt", folder) == ["a.tex", "b.txt", "carol"]


def test_the_same_name_in_two_folders(tmp_path: Path) -> None:
    for name in ("one/a.txt", "two/a.txt", "two/b.txt"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    assert named(tmp_path / "one", tmp_path / "two") == [f"{tmp_path}/one/a.txt", f"{tmp_path}/two/a.txt", "b.txt"]


def test_the_files_of_the_grading_itself_are_no_submissions(folder: Path) -> None:
    for name in ("a.txt", "problem.yaml", "marks.csv"):
        (folder / name).touch()
    (folder / "pages").mkdir()
    assert named(folder, own=tuple(folder / n for n in ("problem.yaml", "marks.csv", "pages"))) == ["a.txt"]


@pytest.mark.parametrize("name", ["missing", "a\0b"])
def test_what_does_not_exist_is_an_error_of_the_command_line(name: str, folder: Path) -> None:
    with pytest.raises(ProblemError, match="cannot be read"):
        named(folder / name)


def test_an_empty_folder(folder: Path) -> None:
    with pytest.raises(ProblemError, match="no submission"):
        named(folder)


def test_somebodys_folder(folder: Path) -> None:
    files = {"2.txt": b"two", "1.TEX": b"one", "scan.pdf": b"%PDF", "notes": b"three"}
    for name, content in files.items():
        (folder / name).write_bytes(content)
    (folder / "deeper.txt").mkdir()
    found = read(folder)
    assert found.files == (("1.TEX", b"one"), ("2.txt", b"two"), ("notes", b"three"))
    assert found.notes == ("not looked into: deeper.txt, scan.pdf",)


def refused(path: Path) -> str:
    with pytest.raises(UnreadSubmissionError) as error:
        read(path)
    return str(error.value)


def test_links_are_not_followed(folder: Path) -> None:
    (folder / "secret").write_text("theirs")
    (folder / "link.txt").symlink_to(folder / "secret")
    (folder / "broken.txt").symlink_to(folder / "nowhere")
    (folder / "linked").symlink_to(folder, target_is_directory=True)
    (folder / "somebody").mkdir()
    (folder / "somebody" / "answer.txt").symlink_to(folder / "secret")
    for name in ("link.txt", "broken.txt", "linked"):
        assert refused(folder / name) == "is a link, which is not followed"
    assert refused(folder / "somebody") == "has a file answer.txt that is a link, which is not followed"
    assert named(folder / "linked") == ["linked"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the system has no named pipes")
def test_what_is_no_file_is_not_opened(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    os.mkfifo(folder / "pipe.txt")
    monkeypatch.setattr("os.open", lambda *_: pytest.fail("opened"))
    assert refused(folder / "pipe.txt") == "is a pipe, which is not opened"
    assert refused(Path("/dev/zero")) == "is a device, which is not opened"


def test_what_is_too_large_is_not_read(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with (folder / "large").open("wb") as file:
        file.truncate(50 << 20)
    (folder / "many").mkdir()
    for n in range(51):
        (folder / "many" / f"{n}.txt").touch()
    (folder / "together").mkdir()
    for n in range(3):
        (folder / "together" / f"{n}.txt").write_bytes(bytes(400_000))
    assert "more than 50 files" in refused(folder / "many")
    assert "has a file 2.txt that has 400,000 bytes" in refused(folder / "together")
    monkeypatch.setattr("os.open", lambda *_: pytest.fail("opened"))
    assert refused(folder / "large").startswith("has 52,428,800 bytes")


def test_a_file_that_grows_or_changes_while_it_is_read(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    small, large, other = folder / "small", folder / "large", folder / "other"
    small.touch()
    other.touch()
    large.write_bytes(bytes((1 << 20) + 1))
    really = os.lstat
    of_small = really(small)
    monkeypatch.setattr("os.lstat", lambda path, **_: of_small if Path(path) == other else really(path))
    assert refused(other) == "was replaced while it was read"
    of_large = os.stat_result((*of_small[:1], really(large).st_ino, really(large).st_dev, *of_small[3:]))
    monkeypatch.setattr("os.lstat", lambda *_, **__: of_large)
    assert refused(large).startswith("has more than 1,048,576 bytes")


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="may read everything")
def test_a_file_that_may_not_be_read(folder: Path) -> None:
    (folder / "a.txt").touch(mode=0)
    assert refused(folder / "a.txt") == "cannot be read: Permission denied"


def test_a_file_that_has_gone(folder: Path) -> None:
    assert refused(folder / "a.txt") == "cannot be read: No such file or directory"


# Journal


def submission(name: str = "a", content: bytes = b"x", file: str = "f") -> Submission:
    return Submission(name, ((file, content),))
