"""`lagsolve new`: templates and copies."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

from lagrange.core.diagnostics import ProblemError, Source
from lagrange.explain.report import report
from lagrange.problem.keys import PROBLEM
from lagrange.problem.loader import read_problem
from lagsolve.new_file import TEMPLATE
from tests.command.test_problem_commands import run
from tests.support.paths import PROBLEMS

UNUSED = re.compile(r"^( *)#(?=\w+:)", re.MULTILINE)
"""A key that is commented out."""


def test_new_writes_a_template_that_solves(here: Path) -> None:
    result = run("new", "bead.yaml")
    assert (result.exit_code, result.stdout) == (0, "")
    assert (here / "bead.yaml").read_text(encoding="utf-8") == TEMPLATE
    assert result.stderr.endswith("\n  lagsolve bead.yaml --watch\n")
    solved = run("bead.yaml")
    assert (solved.exit_code, solved.stderr) == (0, "")
    assert "✓" in solved.stdout
    assert "✗" not in solved.stdout
    assert run("new", "-").stdout == TEMPLATE
    assert run("check", "bead.yaml").exit_code == 0


def test_new_copies_a_shipped_problem_exactly(here: Path) -> None:
    result = run("new", "bead", "--from", "ex11")
    assert result.exit_code == 0
    assert "bead.yaml is a copy of `ex11`" in result.stderr
    original = (PROBLEMS / "chapter6" / "ex11-ideal-pendulum.yaml").read_bytes()
    assert (here / "bead.yaml").read_bytes() == original
    assert run("new", "-", "--from", "ex11").stdout == original.decode()
    assert os.listdir(here) == ["bead.yaml"]


def test_new_writes_over_nothing(here: Path) -> None:
    (here / "bead.yaml").write_text("mine")
    (here / "gone.yaml").symlink_to("elsewhere.yaml")
    for name in ("bead.yaml", "bead", "gone.yaml"):
        result = run("new", name)
        assert (result.exit_code, result.stdout) == (2, "")
        assert result.stderr.startswith("error[file-exists]")
        assert "nothing was written" in result.stderr
    assert (here / "bead.yaml").read_text() == "mine"
    assert not (here / "elsewhere.yaml").exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["mechanics/bead.yaml"], "there is no folder mechanics"),
        (["folder"], "name a file in it, such as folder/problem.yaml"),
        (["folder/"], "name a file in it"),
        (["nofolder/"], "nofolder/ is a folder"),
        (["."], "is a folder"),
        (["bead.txt"], "lagsolve new bead.yaml"),
        (["my bead.tex"], "lagsolve new 'my bead.yaml'"),
        (["n" * 300], "cannot be written: File name too long"),
        (["a\0b"], "cannot be written"),
        ([""], "is a folder"),
        (["a.yaml", "--from", "nonsense"], "there is no shipped problem `nonsense`"),
        (["a.yaml", "--from", "ex11-ideal-pendulm"], "did you mean `ex11-ideal-pendulum`?"),
        ([], "Missing argument 'FILE'"),
    ],
)
def test_where_new_cannot_write(arguments: list[str], said: str, here: Path) -> None:
    (here / "folder").mkdir()
    result = run("new", *arguments)
    assert (result.exit_code, result.stdout) == (2, "")
    assert said in result.stderr
    assert os.listdir(here) == ["folder"]


@pytest.mark.parametrize(
    ("file", "typed"),
    [("a b", "'a b.yaml'"), ("./-x.yml", "./-x.yml"), ("x.YAML", "x.YAML"), ("folder/x", "folder/x.yaml")],
)
def test_new_says_what_to_type_next(file: str, typed: str, here: Path) -> None:
    (here / "folder").mkdir()
    assert run("new", file).stderr.endswith(f"\n  lagsolve {typed} --watch\n")


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize("name", ["check", "completion", "help", "new"])
def test_new_files_with_the_name_of_a_command(name: str) -> None:
    assert run("new", name).exit_code == 0
    assert run(f"{name}.yaml", "--detail", "brief").exit_code == 0


LINES = TEMPLATE.splitlines()


def test_the_template_has_every_key() -> None:
    keys = set(re.findall(r"^#?(\w+):", TEMPLATE, re.MULTILINE))
    assert keys == set(PROBLEM.names) - {"equations", "lagrangian"}
    assert "`equations: [...]`" in TEMPLATE
    assert "`lagrangian: ...`" in TEMPLATE
    assert max(map(len, LINES)) <= 80


@pytest.mark.parametrize("number", [n for n, line in enumerate(LINES) if UNUSED.match(line)])
def test_a_key_that_is_not_in_use_may_be_used(number: int) -> None:
    text = "\n".join([*LINES[:number], UNUSED.sub(r"\1", LINES[number]), *LINES[number + 1 :]])
    problem = read_problem(Source("template", text))
    assert not [note for note in problem.notes if note.code != "unused-parameter"]
    if re.search("equilibrium|frequencies", LINES[number]):
        problem = read_problem(Source("template", text.replace("find: motion", "find: linearization")))
    shortcomings = [str(s) for s in report(problem, complete=False).shortcomings]
    assert all("answers, `equations` is wrong" in s for s in shortcomings), shortcomings  # another force acts


def test_all_keys_may_be_used_together() -> None:
    try:
        read_problem(Source("template", UNUSED.sub(r"\1", TEMPLATE)))
    except ProblemError as error:
        pytest.fail(error.show())
