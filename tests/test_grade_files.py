"""What is handed in, and what is handed out: folders read without trust, the CSV file, the pages, the journal."""

from __future__ import annotations

import csv
import io
import os
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from rich.cells import cell_len

from lagrange.answers.equations import EquationVerdict, Verdict
from lagrange.answers.grading import Graded, Submission
from lagrange.core.diagnostics import ProblemError
from lagsolve.grading.feedback import code, page, page_names, prose
from lagsolve.grading.journal import Journal, key
from lagsolve.grading.rows import HEADER, Row, csv_text, harmless, table_text
from lagsolve.grading.submissions import Entry, RefusedError, entries, shown


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "answers").mkdir()
    return tmp_path / "answers"


def named(*names: str | Path, own: tuple[Path, ...] = ()) -> list[str]:
    return [e.name for e in entries([str(n) for n in names], own)]


def read(path: Path) -> Submission:
    return Entry("x", path).read()


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
    with pytest.raises(RefusedError) as error:
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


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("Zoë 日本.txt", "Zoë 日本.txt"),
        ("a\nb\x1b[2J", "a\\x0ab\\x1b[2J"),
        ("\u202etxt.exe\u2028", "\\u202etxt.exe\\u2028"),
        ("caf\udce9", "caf\\xe9"),
        ("a\\x0ab", "a\\\\x0ab"),
        ("\U000e0041", "\\U000e0041"),
    ],
)
def test_names_are_shown_without_what_cannot_be_seen(name: str, text: str) -> None:
    assert shown(name) == text
    text.encode()


# CSV and table


def row(name: str = "a.txt", remark: str = "", **more: object) -> Row:
    return replace(Row(name, Verdict.WRONG, 1, 2, 1, remark, 0.5, "a.md"), **more)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "text",
    [
        "=1+1",
        "+1",
        "-1",
        "@SUM(A1)",
        '=HYPERLINK("http://x","a")',
        "\t=1",
        "  =1",
        "＝1",
        "x;=1",
        'x;"=1',
        "x\t@a",
        "\r=1",
    ],
)
def test_no_cell_is_a_formula(text: str) -> None:
    for cell in re.split(r"[;\t]", harmless(text)):
        assert not re.match(r"[\s\"']*[=+\-@＝]", cell.replace("'", "x"))
    [_, cells] = list(csv.reader(io.StringIO(csv_text([row(name=text, remark=text)]))))
    assert cells[0] == cells[5] == harmless(text)


def test_plain_cells_stay_as_they_are() -> None:
    for text in ("a.txt", "it is -1 times the right one", "x = 1", "a, b", 'say "yes"', "a; b"):
        assert harmless(text) == text


def test_the_csv_file() -> None:
    text = csv_text([row("ä,1", 'a "b"'), row("b", right=None, required=None, missing=None)])
    assert text.split("\r\n") == [
        "submission,verdict,right,required,missing,remark,seconds,feedback",
        '"ä,1",wrong,1,2,1,"a ""b""",0.5,a.md',
        "b,wrong,,,,,0.5,a.md",
        "",
    ]


def test_a_csv_file_is_known_by_its_header() -> None:
    assert csv_text([]).encode().startswith(HEADER)


def test_a_remark_is_one_line_and_not_long() -> None:
    graded = Graded(Verdict.WRONG, "wrong: no", (EquationVerdict("x", Verdict.WRONG, "first\n" + "y" * 1000),))
    assert Row.of("a", graded).remark == "first " + "y" * 294 + "..."


@pytest.mark.parametrize("width", [30, 60, 80, 120])
def test_the_table_fits_and_says_everything(width: int) -> None:
    rows = [
        row("anna_" * 20, "it does not follow from the equations of motion"),
        row("[bold]日本語[/bold].txt", "", verdict=Verdict.EQUIVALENT),
        row("c", "", right=None),
    ]
    text = table_text(rows, width, on_terminal=False)
    table, _, summary = text.strip().rpartition("\n\n")
    assert max(cell_len(line) for line in text.splitlines()) <= width
    assert " ".join(summary.split()) == "3 submissions: 1 equivalent, 2 wrong"
    assert "1/2" in text
    if width >= 80:
        assert "[bold]日本語[/bold].txt" in text
    assert re.sub(r"\s", "", table).count("anna_") + table.count("equivalent") >= 1
    assert "\x1b" not in text


# Pages


HOSTILE = "</code><script>alert(1)</script> ![x](http://x) [a](b) `code` ``more`` *b* # h | t"


def test_the_page_of_a_wrong_answer() -> None:
    equations = (
        EquationVerdict("theta'' = 0", Verdict.WRONG, "it does not follow from the equations of motion"),
        EquationVerdict("0 = 0", Verdict.TRIVIAL, "it is an identity", ("a remark",)),
    )
    graded = Graded(Verdict.WRONG, "wrong: not every equation follows", equations, ("note[x]: `a` read as b",), 0, 2)
    assert page("Ideal pendulum", "anna.txt", graded) == (
        "# Ideal pendulum\n\nSubmission: `anna.txt`\n\n**Wrong**: not every equation follows.\n\n"
        "0 of the 2 independent equations asked for are right.\n\n## Equation by equation\n\n"
        "- ✗ `theta'' = 0`: wrong\n  - it does not follow from the equations of motion\n"
        "- · `0 = 0`: trivial\n  - it is an identity\n  - a remark\n\n"
        "## How it was read\n\n```text\nnote[x]: `a` read as b\n```\n"
    )


def test_nothing_that_was_handed_in_is_marked_up() -> None:
    equation = EquationVerdict(HOSTILE, Verdict.UNREADABLE, HOSTILE, (HOSTILE,))
    text = page(
        HOSTILE, HOSTILE, Graded(Verdict.UNREADABLE, f"unreadable: {HOSTILE}", (equation,), (f"```\n{HOSTILE}",))
    )
    text = re.sub(r"^(`{3,})text\n.*?\n\1$", "", text, flags=re.DOTALL | re.MULTILINE)
    outside = re.sub(r"(?<![`\\])(`+)(?!`).*?(?<!`)\1(?!`)", "", text)
    assert "script" in outside
    assert not re.search(r"(?<!\\)[<\[]", outside)
    assert "](" not in outside.replace("\\]", "")


@pytest.mark.parametrize(
    ("text", "written"),
    [("a", "`a`"), ("`a", "`` `a ``"), ("a``b", "```a``b```"), ("a\nb", "`a b`"), ("", "` (nothing) `")],
)
def test_code_in_a_line(text: str, written: str) -> None:
    assert code(text) == written


def test_names_in_backticks_stay_code() -> None:
    assert prose("`x_1` is *not* declared ` <b>") == "`x_1` is \\*not\\* declared \\` \\<b\\>"


@pytest.mark.parametrize(
    "name",
    [
        "../../etc/passwd",
        "..",
        "/abs",
        "a/b",
        "C:\\x",
        "~root",
        "-rf",
        "=1",
        "a\nb",
        ".hidden",
        "CON ",
        "x" * 5000,
        "é" * 300,
        "日本",
    ],
)
def test_a_page_stays_in_its_folder(name: str, tmp_path: Path) -> None:
    file = page_names([name])[name]
    path = (tmp_path / file).resolve()
    assert path.parent == tmp_path.resolve()
    assert not file.startswith((".", "-", "~", "="))
    path.touch()


def test_no_two_submissions_have_the_same_page() -> None:
    names = ["a.txt", "A.TXT", "a/txt", "a?txt", "a_txt", "é", "e\u0301", "x" * 200 + "1", "x" * 200 + "2"]
    pages = page_names(names)
    assert len({p.casefold() for p in pages.values()}) == len(names)
    assert pages["a.txt"] == "a.txt.md"


# Journal


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
    rows = {f"k{n}": row(f"{n}.txt", "ünï\n") for n in range(3)}
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
