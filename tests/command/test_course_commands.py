"""`lagsolve grade` with several problems, variants, attempts and hints, and `lagsolve variant`, as commands."""

from __future__ import annotations

import csv
import os
from pathlib import Path

import pytest

from tests.command.test_main import run

pytestmark = pytest.mark.skipif(os.name != "posix", reason="limits and signals are those of POSIX")

RIGHT, WRONG = "theta'' + g/l*sin(theta) = 0\n", "l*theta'' = g*sin(theta)\n"
OTHER = "title: Other\ncoordinates: [x]\nequations: [\"x'' = 2\"]\n"
VARIED = """title: Pendulum
parameters: {m: {unit: kg}, l: {unit: m}, g: {value: 9.81 m/s^2}}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}
gravity: g*j
vary: {m: [1 kg, 2 kg], l: {from: 20 cm, to: 1 m, step: 10 cm}}
"""


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "answers").mkdir()
    (tmp_path / "other.yaml").write_text(OTHER)
    (tmp_path / "varied.yaml").write_text(VARIED)
    return tmp_path


def rows(file: str = "marks.csv") -> list[dict[str, str]]:
    with Path(file).open(encoding="utf-8", newline="") as text:
        return list(csv.DictReader(text))


def test_several_problems_with_attempts_and_hints(here: Path) -> None:
    answers = here / "answers"
    (answers / "anna-1.md").write_text(f"# Problem 1\n{WRONG}\n# Problem 2\nx'' = 2\n")
    (answers / "anna-2.md").write_text(f"# ex11\n{RIGHT}\n")
    (answers / "ben.yaml").write_text("other: [\"x'' = 2\"]\n")
    (answers / "carl").mkdir()
    (answers / "carl" / "ex11.txt").write_text(RIGHT)
    (answers / "dora.txt").write_text(RIGHT)
    (answers / "link").symlink_to("/etc/passwd")
    Path("times.csv").write_text("submission,time\nanna-1.md,2026-11-20T17:00\nanna-2.md,2026-11-20T19:30\n")
    more = ("--attempts", "best", "--roster", "times.csv", "--due", "2026-11-20T18:00", "--hint", "1")
    result = run(
        "grade", "ex11", "other.yaml", "answers", "--csv", "marks.csv", "--feedback", "pages",
        "--statistics", "class.html", *more, "--jobs", "1", env={"COLUMNS": "120"},
    )  # fmt: skip
    assert result.exit_code == 0
    assert "of 8 of 12 it is not known when they were handed in" in result.stderr
    found = {(r["submission"], r["problem"]): r for r in rows()}
    assert len(found) == 12
    assert {key: (r["verdict"], r["points"], r["possible"], r["counts"]) for key, r in found.items()} == {
        ("anna-1.md", "ex11"): ("wrong", "0", "1", ""),
        ("anna-1.md", "other"): ("equivalent", "1", "1", "yes"),
        ("anna-2.md", "ex11"): ("equivalent", "1", "1", "yes"),
        ("anna-2.md", "other"): ("incomplete", "0", "1", ""),
        ("ben.yaml", "ex11"): ("incomplete", "0", "1", "yes"),
        ("ben.yaml", "other"): ("equivalent", "1", "1", "yes"),
        ("carl", "ex11"): ("equivalent", "1", "1", "yes"),
        ("carl", "other"): ("incomplete", "0", "1", "yes"),
        ("dora.txt", "ex11"): ("unreadable", "0", "1", "yes"),
        ("dora.txt", "other"): ("unreadable", "0", "1", "yes"),
        ("link", "ex11"): ("unreadable", "0", "1", "yes"),
        ("link", "other"): ("unreadable", "0", "1", "yes"),
    }
    assert (found["anna-2.md", "ex11"]["late"], found["anna-2.md", "ex11"]["attempt"]) == ("1 h 30 min", "2")
    assert "`ex11`, `other`" in found["dora.txt", "ex11"]["remark"]
    assert found["anna-1.md", "ex11"]["remark"] == "it does not follow from the equations of motion"
    assert "gravity" in found["anna-1.md", "ex11"]["mistakes"]  # which is for the teacher
    pages = {p.name: p.read_text() for p in Path("pages").iterdir()}
    assert sorted(pages) == sorted(r["feedback"] for r in found.values())
    assert "gravity" not in pages["anna-1.md ex11.md"]
    assert "6 submissions to 2 problems" in result.stdout
    assert "anna" not in Path("class.html").read_text() + Path("class.csv").read_text()


def test_an_interrupted_batch_of_several_problems_goes_on(here: Path) -> None:
    (here / "answers" / "anna.md").write_text(f"# Problem 1\n{RIGHT}\n# Problem 2\nx'' = 2\n")
    Path("marks.csv").mkdir()  # so that the table cannot be written, and the journal stays
    command = ("grade", "ex11", "other.yaml", "answers", "--feedback", "pages", "--jobs", "1")
    assert run(*command, "--csv", "marks.csv").exit_code == 2
    journal = Path("pages/.journal").read_text().splitlines()
    assert len(journal) == 2
    Path("pages/.journal").write_text("\n".join(line.replace('"points": 1', '"points": 0') for line in journal) + "\n")
    Path("marks.csv").rmdir()
    assert run(*command, "--csv", "-").stdout.count(",0,1,") == 2  # both rows are those of the journal
    assert not Path("pages/.journal").exists()


def test_each_student_is_graded_against_their_own_values(here: Path) -> None:
    """Anna's length is 0.4 m, Ben's too (the seed draws place 2 of 9), that of seed `s0` is another one."""
    lengths = {}
    for seed in ("anna", "s0"):
        assert run("variant", "varied.yaml", "--seed", seed, "-o", f"{seed}.yaml").exit_code == 0
        lengths[seed] = Path(f"{seed}.yaml").read_text().split("l = ")[1].split(" cm")[0]
    assert lengths["anna"] == "40"
    assert lengths["s0"] != "40"
    for student in ("anna", "ben", "carl"):
        (here / "answers" / f"{student}.txt").write_text("theta'' + 9.81/0.4*sin(theta) = 0\n")
    Path("seeds.csv").write_text("student,seed\ncarl,s0\n")
    command = (
        "grade",
        "varied.yaml",
        "answers",
        "--variants",
        "--roster",
        "seeds.csv",
        "--csv",
        "marks.csv",
        "--jobs",
        "1",
    )
    assert run(*command).exit_code == 0
    assert [r["verdict"] for r in rows()] == ["equivalent", "equivalent", "wrong"]


def test_a_variant_is_a_file_that_solves(here: Path) -> None:  # noqa: ARG001
    first, second = (run("variant", "varied.yaml", "--seed", "anna").stdout for _ in range(2))
    assert first == second
    assert "vary" not in first
    Path("anna.yaml").write_text(first)
    assert run("anna.yaml").exit_code == 0


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["variant", "ex11", "--seed", "a"], "has no `vary`"),
        (["variant", "varied.yaml"], "--seed"),
        (["variant", "varied.yaml", "--seed", "a", "-o", "varied.yaml"], "would be overwritten"),
        (["grade", "varied.yaml", "answers", "--format", "csv", "-o", "varied.yaml"], "would be overwritten"),
        (["variant", "varied.yaml", "--seed", "a", "-o", "nowhere/a.yaml"], "cannot be written"),
        (["grade", "ex11", "answers", "--variants"], "none of the problems has `vary`"),
        (["grade", "ex11", "answers", "-o", "x"], "--format"),
        (["grade", "ex11", "answers", "--assignment", "x"], "--format canvas"),
        (["grade", "ex11", "answers", "--due", "soon"], "is not a time"),
        (["grade", "ex11", "answers", "--roster", "other.yaml"], "is not a table of students"),
        (["grade", "ex11", "ex11", "answers"], "two problems are called"),
        (["grade", "ex11", "answers", "--statistics", "class.pdf"], "is a web page"),
        (["grade", *["ex11"] * 17, "answers"], "16 problems at most"),
        (["grade", "ex11"], "Missing argument 'ANSWERS...'"),
    ],
)
def test_what_a_command_line_cannot_ask_for(arguments: list[str], said: str, here: Path) -> None:
    (here / "answers" / "a").write_text(RIGHT)
    before = VARIED
    result = run(*arguments, *(["--jobs", "1"] if arguments[0] == "grade" else []))
    assert result.exit_code == 2
    assert said in result.stderr
    assert Path("varied.yaml").read_text() == before


def test_a_yaml_file_of_answers_is_no_problem(here: Path) -> None:
    (here / "anna.yaml").write_text(f'equations: ["{RIGHT.strip()}"]\n')
    (here / "ben.yaml").write_text("degrees_of_freedom: 2\n")
    result = run("grade", "ex11", "anna.yaml", "ben.yaml", "--csv", "marks.csv", "--jobs", "1")
    assert result.exit_code == 0
    assert [(r["submission"], r["verdict"]) for r in rows()] == [("anna.yaml", "equivalent"), ("ben.yaml", "wrong")]
