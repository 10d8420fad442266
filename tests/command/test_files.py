"""The commands about problem files: list, show, new, completion. `schema` has a test file of its own."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest
from click.shell_completion import BashComplete, get_completion_class
from click.testing import CliRunner, Result
from rich.cells import cell_len

from lagrange.core.diagnostics import ProblemError, Source
from lagrange.explain.report import report
from lagrange.problem import library
from lagrange.problem.keys import PROBLEM
from lagrange.problem.loader import load, read_problem
from lagsolve import shipped
from lagsolve.main import main
from lagsolve.new_file import TEMPLATE
from lagsolve.shipped import Entry, Index
from tests.support.paths import PROBLEMS, ROOT
from tests.support.processes import PATIENCE

UNUSED = re.compile(r"^( *)#(?=\w+:)", re.MULTILINE)
"""A key that is commented out."""


def run(*arguments: str, env: dict[str, str] | None = None) -> Result:
    """Runs the command. No run may end in an exception, whatever it is asked."""
    result = CliRunner().invoke(main, arguments, env={"COLUMNS": None} | (env or {}))
    assert result.exception is None or isinstance(result.exception, SystemExit)
    return result


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder, which is the current one."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


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
    assert shipped.page(shipped.containing(()), shipped.index(), {"b/a": "a"}, 40, long=False, styled=False) == (
        "b\n  a  A\n      constraints\n"
    )


def test_short_names_mean_one_problem_each() -> None:
    for name, short in library.short_names().items():
        assert list(library.named(short)) == [name]


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
    return shipped.page(entries, Index({"b": "Of b"}, {}), called, width, long=long, styled=styled)


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
    text = shipped.page(entries, shipped.index(), called, width, long=long, styled=False)
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
    assert problem.notes == ()
    if re.search("equilibrium|frequencies", LINES[number]):
        problem = read_problem(Source("template", text.replace("find: motion", "find: linearization")))
    shortcomings = [str(s) for s in report(problem, complete=False).shortcomings]
    assert all("answers, `equations` is wrong" in s for s in shortcomings), shortcomings  # another force acts


def test_all_keys_may_be_used_together() -> None:
    try:
        read_problem(Source("template", UNUSED.sub(r"\1", TEMPLATE)))
    except ProblemError as error:
        pytest.fail(error.show())


# Names that are not there


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("pearl", "did you mean `pearl.yaml`?"),
        ("bed.yaml", "did you mean `bead.yaml`?"),
        ("./bed.yaml", "did you mean `bead.yaml`?"),
        ("folder/woool.yaml", "did you mean `folder/wool.yaml`?"),
        ("ex11.yaml", "did you mean `ex11`, which is a problem of the library?"),
        ("nowhere/x.yaml", "check the name"),
        ("statics", "`lagsolve list statics` shows its problems"),
        ("statics/", "`lagsolve list statics` shows its problems"),
    ],
)
def test_what_a_name_may_mean(name: str, said: str, here: Path) -> None:
    (here / "folder").mkdir()
    for file in ("bead.yaml", "pearl.yaml", "folder/wool.yaml"):
        (here / file).write_text(TEMPLATE)
    result = run(name)
    assert (result.exit_code, result.stdout) == (2, "")
    assert said in result.stderr


def test_a_file_whose_name_is_that_of_a_shipped_problem(here: Path) -> None:
    """A name without its ending is the library's, and standard error says that the file was not meant."""
    (here / "ex11.yaml").write_text(TEMPLATE)
    (here / "bead.yml").write_text(TEMPLATE)
    shipped = run("ex11", "--detail", "brief")
    assert shipped.exit_code == 0
    assert "note[file-beside]: `ex11` is the problem `ex11-ideal-pendulum` of the library" in shipped.stderr
    assert "write `ex11.yaml`" in shipped.stderr
    for name in ("ex11.yaml", "./ex11.yaml", "ex12"):
        assert "file-beside" not in run(name, "--detail", "brief").stderr
    several = run("bead")
    assert (several.exit_code, several.stdout) == (2, "")
    assert several.stderr.endswith("write the whole name, or `bead.yml` for the file of that name\n")


# Shell completion


def completions(*words: str, shell: str = "bash") -> list[tuple[str, str]]:
    """What click's protocol offers for the last word: pairs of kind and value."""
    kind = get_completion_class(shell)
    assert kind is not None
    offered = kind(main, {}, "lagsolve", "_LAGSOLVE_COMPLETE").get_completions(list(words[:-1]), words[-1])
    return [(item.type, item.value) for item in offered]


@pytest.mark.usefixtures("here")
def test_a_shell_completes_shipped_problems() -> None:
    assert completions("ex11") == [("plain", "ex11-ideal-pendulum")]
    assert completions("chapter6/ex11") == [("plain", "chapter6/ex11-ideal-pendulum")]
    many = [value for _, value in completions("ex1")]
    assert many == [n.rpartition("/")[2] for n in library.entries() if n.startswith("chapter6/ex1")]
    for words in (
        ("solve",),
        ("check",),
        ("show",),
        ("ex05",),
        ("grade",),
        ("new", "a.yaml", "--from"),
        ("ex05", "--fragment"),
    ):
        assert ("plain", "ex11-ideal-pendulum") in completions(*words, "ex1")


@pytest.mark.usefixtures("here")
def test_a_shell_completes_commands_and_options() -> None:
    assert completions("li") == [("file", "li"), ("plain", "list")]  # in bash a file after others would hide them
    assert ("plain", "solve") in completions("s")
    assert {("plain", f) for f in ("--format", "--watch", "--version", "--help")} <= set(completions("--"))
    assert ("plain", "--detail") in completions("ex11", "--d")
    assert completions("ex11", "--format", "m") == [("plain", "markdown")]
    assert completions("--format", "m") == [("plain", "markdown")]
    assert completions("completion", "z") == [("plain", "zsh")]
    assert ("plain", "--hint") in completions("check", "ex11", "--")


def test_a_shell_completes_files(here: Path) -> None:
    (here / "example.yaml").touch()
    (here / "examples").mkdir()
    assert completions("exa") == [("file", "exa")]
    assert completions("./ex") == [("file", "./ex")]
    assert completions("ex")[0] == ("plain", "example.yaml")
    for words in (("ex11", "-o"), ("check", "ex11"), ("grade", "ex11"), ("new",)):
        assert completions(*words, "a") == [("file", "a")]


@pytest.mark.usefixtures("here")
def test_help_and_version_complete_too() -> None:
    assert ("plain", "grade") in completions("help", "gra")
    assert completions("--version", "x") is not None


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_prints_clicks_own_script(shell: str) -> None:
    kind = get_completion_class(shell)
    assert kind is not None
    result = run("completion", shell)
    assert (result.exit_code, result.stderr) == (0, "")
    assert result.stdout == kind(main, {}, "lagsolve", "_LAGSOLVE_COMPLETE").source()
    assert f"_LAGSOLVE_COMPLETE={shell}_complete" in result.stdout


SHELLS = {
    "bash": """COMP_WORDS=({words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); _lagsolve_completion lagsolve 2>/dev/null
        printf '%s\\n' "${{COMPREPLY[@]}}" """,
    "fish": "complete -C '{words}' | string replace -r '\\t.*' ''",
    "zsh": """words=({words}); CURRENT=${{#words}}
        compadd() {{ print -rl -- ${{(P)argv[-1]}} }}
        _describe() {{ print -rl -- ${{(P)argv[3]%%:*}} }}
        _lagsolve_completion""",
}


@pytest.mark.parametrize("shell", SHELLS)
def test_a_real_shell_completes(shell: str, tmp_path: Path) -> None:
    if not shutil.which(shell):
        pytest.skip(f"there is no {shell}")
    BashComplete._check_version()
    command = tmp_path / "bin" / "lagsolve"
    command.parent.mkdir()
    command.write_text(f'#!/bin/sh\nexec {sys.executable} -m lagsolve "$@"\n')
    command.chmod(0o755)
    (tmp_path / "script").write_text(run("completion", shell).stdout)
    begin = "compdef() { }; zmodload zsh/parameter 2>/dev/null; " if shell == "zsh" else ""
    program = f"{begin}source {tmp_path}/script; {SHELLS[shell].format(words='lagsolve ex1')}"
    env = os.environ | {
        "PATH": f"{command.parent}:{os.environ['PATH']}",
        "HOME": str(tmp_path),
        "PYTHONPATH": f"{ROOT}:{ROOT / 'cli'}",
    }
    flags = {"bash": ["--norc"], "zsh": ["-f"], "fish": ["--no-config"]}[shell]
    done = subprocess.run(
        [shell, *flags, "-c", program],
        env=env,
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
        timeout=PATIENCE,
    )
    expected = [n.rpartition("/")[2] for n in library.entries() if n.startswith("chapter6/ex1")]
    assert done.stdout.split() == expected, done.stderr
