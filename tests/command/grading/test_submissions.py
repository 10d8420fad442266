"""What is handed in, and what is handed out: folders read without trust, the CSV file, the pages, the journal.

Several problems in one submission: what belongs to which, and what happens where nothing says so.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from lagrange.answers.submissions import Submission
from lagrange.core.diagnostics import ProblemError, Source
from lagsolve.grading.submissions import (
    AssignedProblem,
    UnreadSubmission,
    UnreadSubmissionError,
    divided,
    named_submissions,
)


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


def test_what_changes_while_it_is_read_is_not_graded(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A student's editor saves while the batch runs: half of an old answer and half of a new one is neither."""
    path, real, changes = folder / "a.txt", os.fstat, [0, 1]
    path.write_bytes(b"x'' = 0\n")

    def appended(descriptor: int) -> os.stat_result:
        """Something is appended after the first look."""
        status = real(descriptor)
        if changes.pop():
            with path.open("ab") as file:
                file.write(b"y'' = 0\n")
        return status

    monkeypatch.setattr("os.fstat", appended)
    assert refused(path) == "was changed while it was read"
    monkeypatch.undo()
    opened = os.open

    def replaced(place: Path, flags: int) -> int:
        """Another file has its name by the time that it is opened."""
        (folder / "b.txt").write_bytes(b"z'' = 0\n")
        os.replace(folder / "b.txt", path)
        return opened(place, flags)

    monkeypatch.setattr("os.open", replaced)
    assert refused(path) == "was replaced while it was read"
    monkeypatch.undo()
    assert read(path).files == (("a.txt", b"z'' = 0\n"),)


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


# Division


ASKED = (
    AssignedProblem("ex11", "Ideal pendulum", Source("problems/chapter6/ex11-ideal-pendulum.yaml", "")),
    AssignedProblem("bead", "Bead on a parabola", Source("bead.yaml", "")),
)


def parts(*files: tuple[str, str], asked: tuple[AssignedProblem, ...] = ASKED) -> list[str] | str:
    """What each problem gets: the lines that are not empty, of all its files."""
    found = divided(Submission("s", tuple((name, text.encode()) for name, text in files)), asked)
    if isinstance(found, str):
        return found
    assert [part.problem for part in found] == list(range(len(asked)))
    texts = ("\n".join(content.decode() for _, content in part.files) for part in found)
    return [" | ".join(line.strip() for line in text.split("\n") if line.strip()) for text in texts]


HEADINGS = [
    ("## Problem 1", "## Problem 2"),
    ("Exercise 11", "Problem 2:"),
    ("Ex. 11: the pendulum", "bead"),
    (r"\section*{Ideal pendulum}", r"\subsection{Bead on a parabola}"),
    ("**ex11**", "**Part b)**"),
    ("<h2>Question 1</h2>", "<h2>Question 2</h2>"),
    ("(a)", "(b)"),
    ("1.", "2."),
    ("### ex11-ideal-pendulum", "# BEAD #"),
    ("PROBLEM #1", "problem 2 - the bead"),
]


@pytest.mark.parametrize(("first", "second"), HEADINGS)
def test_a_heading_says_which_problem_follows(first: str, second: str) -> None:
    text = f"Anna, 1234\n\n{first}\n\ntheta'' = 0\n{second}\nx'' = 1\ny = x^2\n"
    name = "answer.html" if "<h2>" in first else "answer.tex" if "\\" in first else "answer.md"
    pendulum, bead = parts((name, text))
    assert "theta'' = 0" in pendulum
    assert "x''" not in pendulum
    assert "x'' = 1 | y = x^2" in bead.replace("<br>", "")


def test_the_answer_may_stand_behind_the_heading() -> None:
    assert parts(("a.txt", "Problem 2: x'' = 1\nex11: theta'' = 0\n")) == ["theta'' = 0", "x'' = 1"]


@pytest.mark.parametrize(
    "line", ["Problem 3", "part = 1", "x'' = 2 problem 2", "p1 = m*v", "q2 = x", "bead = 1", "the bead slides"]
)
def test_what_is_no_heading(line: str) -> None:
    pendulum, bead = parts(("a.txt", f"Problem 1\ntheta'' = 0\n{line}\n"))
    assert pendulum.startswith("theta'' = 0")
    assert bead == ""


def test_lines_keep_their_numbers() -> None:
    found = divided(Submission("s", (("a.txt", b"Problem 2\nx''=1\nProblem 1\ntheta'' = 0"),)), ASKED)
    assert not isinstance(found, str)
    assert [
        part.files[0][1].decode().split("\n").index(line)
        for part, line in zip(found, ("theta'' = 0", "x''=1"), strict=True)
    ] == [3, 1]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("ex11.txt", "bead.tex"),
        ("problem1.txt", "problem2.md"),
        ("1.txt", "2.txt"),
        ("anna-ex11.txt", "anna_bead.txt"),
        ("a", "b"),
    ],
)
def test_the_name_of_a_file(first: str, second: str) -> None:
    assert parts((first, "theta'' = 0"), (second, "x'' = 1")) == ["theta'' = 0", "x'' = 1"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "ex11: {degrees_of_freedom: 1}\nbead:\n  equations: ['x=1']\n",
            ["answers: {degrees_of_freedom: 1}", "answers: | equations: ['x=1']"],
        ),
        ('bead: ["x = 1"]\nproblem 1: "theta = 0"\n', ['equations: "theta = 0"', 'equations: ["x = 1"]']),
        (
            "{ex11: {degrees_of_freedom: 1}, bead: ['x = 1']}",
            ["answers: {degrees_of_freedom: 1}", "equations: ['x = 1']"],
        ),
    ],
)
def test_a_key_of_a_yaml_file(text: str, expected: list[str]) -> None:
    assert parts(("a.yaml", text)) == expected


def test_where_nothing_says_which_problem_it_is() -> None:
    assert "no heading, file name or key says which problem it answers: `ex11`, `bead`" in parts(("anna.txt", "x = 1"))
    found = divided(Submission("s", (("ex11.txt", b"x=1"), ("scratch.txt", b"y=1"))), ASKED)
    assert not isinstance(found, str)
    assert found[0].notes == ("scratch.txt: no heading, file name or key says which problem it answers",)
    assert found[1].files == ()


@pytest.mark.parametrize("content", [b"\xff\xfe\x00", b"a: [", b"x: 1\nx: 2", b"", b"\x00"])
@pytest.mark.parametrize("name", ["a.yaml", "a.txt", "a.html"])
def test_nothing_that_is_handed_in_raises(content: bytes, name: str) -> None:
    divided(Submission("s", ((name, content),)), ASKED)


def test_one_problem_takes_everything() -> None:
    submission = Submission("s", (("anna.txt", b"Problem 7\nx = 1"),))
    assert divided(submission, ASKED[:1]) == (submission,)


def test_a_file_of_a_million_lines_is_not_looked_through() -> None:
    """Each problem gets it whole, and refuses it, within the limits of a submission."""
    content = b"Problem 1\n" * (1 << 16)
    found = divided(Submission("s", (("a.txt", content),)), ASKED)
    assert not isinstance(found, str)
    assert [part.files for part in found] == [(("a.txt", content),)] * 2
