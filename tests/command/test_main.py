"""The command line: what it takes, what it prints where, its exit status.

`check` has a test file of its own, and so have runs that need a process of their own.
"""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from rich.cells import cell_len

from lagrange.core.diagnostics import UndecidedError
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem import library
from lagsolve.command_group import COMMANDS
from lagsolve.main import main
from tests.support.paths import PROBLEMS

SKATE = "ex05-ice-skate"
PENDULUM = "ex11-ideal-pendulum"
RIGHT = "theta'' + g/l*sin(theta) = 0"

OSCILLATOR = """\
title: Oscillator
parameters: [m, k]
coordinates: [x]
particles: {P: {mass: m, position: x*e_x}}
forces: {spring: {on: P, vector: -k*x*e_x}}
"""
REFERENCE = "title: r\nparameters: [m, k]\ncoordinates: [x]\nequations: [\"m*x'' + k*x = 0\"]\n"
CONTRADICTION = "title: c\ncoordinates: [x, y]\nconstraints: {a: x = 0, b: x = 1}\n"


def run(*arguments: str, text: str | None = None, env: dict[str, str] | None = None) -> Result:
    """Runs the command. No run may end in an exception, whatever it is asked."""
    surroundings = {"COLUMNS": None, "NO_COLOR": None, "FORCE_COLOR": None, "LAGSOLVE_DEBUG": None} | (env or {})
    result = CliRunner().invoke(main, arguments, input=text, env=surroundings)
    assert result.exception is None or isinstance(result.exception, SystemExit)
    return result


def widest(text: str) -> int:
    return max(cell_len(line) for line in text.splitlines())


@pytest.fixture
def file(here: Path) -> Callable[[str], str]:
    """Writes a problem file; its name."""

    def written(text: str, name: str = "problem.yaml") -> str:
        (here / name).write_text(text, encoding="utf-8")
        return name

    return written


@pytest.fixture(scope="module")
def skate() -> str:
    return run(SKATE).stdout


# Which problem


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize("name", ["chapter6/ex05-ice-skate", "ex05-ice-skate", "chapter6/ex05", "ex05"])
def test_names_of_the_library(name: str, skate: str) -> None:
    result = run(name)
    assert (result.exit_code, result.stdout, result.stderr) == (0, skate, "")
    assert "Ice skate" in skate


def test_a_path_and_standard_input(skate: str) -> None:
    path = PROBLEMS / "chapter6" / f"{SKATE}.yaml"
    assert run(str(path)).stdout == skate
    assert run("-", text=path.read_text(encoding="utf-8")).stdout == skate
    assert run("solve", str(path)).stdout == skate


def test_a_file_comes_before_the_library_but_a_folder_does_not(
    file: Callable[..., str], here: Path, skate: str
) -> None:
    (here / "chapter6").mkdir()
    (here / "ex05").mkdir()
    assert run("ex05").stdout == skate
    file(OSCILLATOR, SKATE)
    assert "Oscillator" in run(SKATE).stdout


@pytest.mark.parametrize("name", ["check", "list", "solve", "grade"])
def test_a_file_with_the_name_of_a_command(name: str, file: Callable[..., str]) -> None:
    file(OSCILLATOR, name)
    assert "Oscillator" in run(f"./{name}").stdout
    assert "Oscillator" in run("--", name).stdout
    assert "`./check`" in run("--help").stdout


def test_a_name_that_means_several(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for name in ("a/ex1-b.yaml", "b/ex1-b.yaml", "b/ex1-c.yaml"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(OSCILLATOR, encoding="utf-8")
    monkeypatch.setattr("lagrange.problem.library.root", lambda: tmp_path)
    assert set(library.named("ex1")) == {"a/ex1-b", "b/ex1-b", "b/ex1-c"}
    assert set(library.named("ex1-b")) == {"a/ex1-b", "b/ex1-b"}
    assert set(library.named("b/ex1-b")) == {"b/ex1-b"}
    assert set(library.named("ex")) == set(library.named("x1-b")) == set()
    result = run("ex1-b")
    assert result.exit_code == 2
    assert "`ex1-b` may be any of `a/ex1-b`, `b/ex1-b`" in result.stderr


@pytest.mark.usefixtures("here")
def test_a_misspelt_name_is_answered_by_the_nearest() -> None:
    result = run("ex11-ideal-pendulm")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "did you mean `ex11-ideal-pendulum`?" in result.stderr


# Formats and destinations


def test_a_web_page_moves_unless_it_is_to_be_static() -> None:
    moving, static = (run(SKATE, "--format", "html", *more).stdout for more in ((), ("--static",)))
    assert "data-moving" in moving
    assert "<script" not in static


def test_formats() -> None:
    assert json.loads(run(SKATE, "--format", "json").stdout)["degrees_of_freedom"] == 2
    document = run("--format", "latex", SKATE).stdout
    assert document.startswith("\\documentclass")
    fragment = run(SKATE, "--format", "latex", "--fragment").stdout
    assert fragment == run("--fragment", SKATE).stdout
    assert "\\begin{document}" not in fragment
    assert "\\section*{Ice skate" in fragment
    assert run(SKATE, "--format", "markdown").stdout.startswith("# Ice skate\n")
    assert run(SKATE, "--format", "html").stdout.startswith("<!DOCTYPE html>\n")


def test_vectors_are_set_as_asked() -> None:
    for format_ in ("latex", "markdown"):
        bold, underlined, arrow = (
            run("ex11", "--format", format_, "--vectors", v).stdout for v in ("bold", "underlined", "arrow")
        )
        assert bold == run("ex11", "--format", format_).stdout
        assert r"\mathbf{r}" in bold
        assert underlined == bold.replace(r"\mathbf{", r"\underline{").replace(r"\boldsymbol{", r"\underline{")
        assert r"\ddot{\vec{r}}" in arrow
        assert r"\mathbf" not in underlined + arrow


def test_output_takes_the_format_from_the_ending(here: Path, skate: str) -> None:
    for name, form in [
        ("a.tex", "latex"),
        ("A.TEX", "latex"),
        ("a.json", "json"),
        ("a.txt", "pretty"),
    ]:
        result = run(SKATE, "-o", name)
        assert (result.exit_code, result.stdout, result.stderr) == (0, "", "")
        assert (here / name).read_text(encoding="utf-8") == run(SKATE, "--format", form).stdout
    run(SKATE, "-o", "b.tex", "--format", "json")
    assert (here / "b.tex").read_text() == (here / "a.json").read_text()
    run(SKATE, "-o", "c", "--format", "pretty", env={"COLUMNS": "40"})
    assert (here / "c").read_text(encoding="utf-8") == skate
    assert run(SKATE, "-o", "-").stdout == skate
    assert not (here / "-").exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["-o", "a.doc"], "does not determine the format"),
        (["-o", "."], "is a folder"),
        (["-o", "no/such/folder/a.tex"], "cannot be written: No such file or directory"),
        (["-o", "problem.yaml", "--format", "latex"], "would overwrite the problem file"),
        (["--fragment", "--format", "json"], "--fragment goes with --format latex"),
        (["--fragment", "--format", "markdown"], "--fragment goes with --format latex"),
        (["--fragment", "-o", "a.html"], "--fragment goes with --format latex"),
        (["--static", "--format", "latex"], "--static goes with --format html"),
        (["--vectors", "arrow"], "--vectors goes with --format latex or markdown"),
        (["--format", "docx"], "'docx' is not one of"),
        (["--method", "magic"], "'magic' is not one of"),
        (["--watch", "-"], "--watch needs a file"),
        (["--detail", "all"], "'all' is not one of"),
        (["--nonsense"], "No such option"),
        (["-", "-"], "standard input cannot be two problems"),
        (["--choice", "angel"], "the problem has no choice `angel`"),
    ],
)
def test_what_the_command_line_cannot_mean(arguments: list[str], said: str, file: Callable[..., str]) -> None:
    text = file(OSCILLATOR)
    result = run(text, *arguments)
    assert (result.exit_code, result.stdout) == (2, "")
    assert said in result.stderr
    assert Path(text).read_text() == OSCILLATOR


def test_no_arguments_are_answered_by_the_three_most_useful_commands() -> None:
    """Each of these runs; the help is printed on request only."""
    result = run()
    assert (result.exit_code, result.stderr) == (0, "")
    commands = re.findall(r"^  (lagsolve .*?)(?:  .*)?$", result.stdout, re.MULTILINE)
    assert [c.split()[1] for c in commands] == ["ex11", "new", "check"]
    assert run(*shlex.split(commands[2])[1:]).stdout.startswith("equivalent")
    assert "Usage: lagsolve PROBLEM..." in run("--help").output


def test_method_detail_and_choice() -> None:
    full, steps, brief = (
        run(PENDULUM, "--method", "dalembert", "--detail", d).stdout for d in ("full", "steps", "brief")
    )
    assert len(full) >= len(steps) > len(brief)
    both = json.loads(run(PENDULUM, "--format", "json").stdout)["choices"]
    assert [c["name"] for c in both] == ["angle", "depth"]
    for name in ("angle", "depth"):
        result = run(PENDULUM, "--choice", name, "--format", "json")
        assert result.exit_code == 0, result.stderr
        assert [c["name"] for c in json.loads(result.stdout)["choices"]] == [name]


@pytest.mark.parametrize(
    ("stated", "compared"), [("m*g*y/l + m*(x'^2 + y'^2)/l", True), ("m*g*cos(theta) + m*l*theta'^2", False)]
)
def test_answers_in_coordinates_of_a_choice_that_is_left_out(
    stated: str, compared: bool, file: Callable[..., str]
) -> None:
    """They are read, and a note says that they are not compared; the exit status does not count them."""
    own = run("show", PENDULUM).stdout
    beginning, rod, _ = own.rpartition("    rod: ")
    text = file(f'{beginning}{rod}"{stated}"\n')
    result = run(text, "--choice", "depth", "--format", "json")
    assert result.exit_code == 0, result.stderr
    assert "note[not-compared]" in result.stderr
    assert "`equations`" in result.stderr
    assert ("`reactions: rod`" in result.stderr) != compared
    answers = [a["name"] for a in json.loads(result.stdout)["answers"]]
    assert answers == ["degrees_of_freedom", "classification", "integrable", *["reactions"] * compared]
    whole = run(text, "--format", "json")
    assert (whole.exit_code, whole.stderr) == (0, "")
    assert [a["name"] for a in json.loads(whole.stdout)["answers"]][-2:] == ["equations", "reactions"]


def test_lagranges_equations_as_the_method() -> None:
    result = run(PENDULUM, "--method", "lagrange")
    assert (result.exit_code, result.stderr) == (0, "")
    assert "Lagrange's equations" in result.stdout
    assert "D'Alembert's principle\n" not in result.stdout
    found = json.loads(run(PENDULUM, "--method", "lagrange", "--format", "json").stdout)
    assert found["method"] == "lagrange"
    assert found["lagrange"]["kinetic_energy"] == "m*(x'^2 + y'^2)/2"
    assert found["choices"][0]["lagrange"]["momenta"] == {"theta": "m*l^2*theta'"}
    assert r"p_{\theta}" in run(PENDULUM, "--method", "lagrange", "--format", "latex").stdout


def test_lagranges_equations_where_nothing_moves() -> None:
    result = run("ladder", "--method", "lagrange")
    assert result.exit_code == 0
    assert "note[method-without-motion]" in result.stderr
    assert result.stdout == run("ladder").stdout


# Several problems


def test_several_problems(skate: str) -> None:
    assert run(SKATE, PENDULUM).stdout == f"{skate}\n{run(PENDULUM).stdout}"
    found = json.loads(run(SKATE, PENDULUM, "--format", "json").stdout)
    assert [f["problem"]["title"] for f in found] == ["Ice skate", "Ideal pendulum"]
    assert run(SKATE, PENDULUM, "--format", "latex").stdout.count("\\section*{") == 2


def test_one_of_several_fails(skate: str) -> None:
    result = run("nonsense", SKATE)
    assert (result.exit_code, result.stdout) == (2, skate)
    assert result.stderr.startswith("nonsense:\nerror[no-such-problem]")
    result = run("nonsense", SKATE, "--format", "json")
    assert result.exit_code == 2
    nothing, found = json.loads(result.stdout)
    assert nothing is None
    assert found["problem"]["title"] == "Ice skate"


def test_nothing_is_written_where_nothing_was_solved(here: Path) -> None:
    assert run("nonsense", "rubbish", "--format", "json").stdout == ""
    assert run("nonsense", "-o", "a.json").exit_code == 2
    assert not (here / "a.json").exists()


# Widths


@pytest.mark.parametrize("columns", [20, 60, 80, 120, 100_000])
def test_nothing_is_wider_than_the_terminal(columns: int) -> None:
    env = {"COLUMNS": str(columns)}
    for arguments in ([PENDULUM], ["check", PENDULUM, "-e", "theta'' + g/l*sin(theta) + " * 9 + "theta'' = 0"]):
        assert 0 < widest(run(*arguments, env=env).stdout) <= columns


def test_without_a_terminal_lines_have_80_columns() -> None:
    assert 70 < widest(run(PENDULUM).stdout) <= 80


# What goes where, and exit statuses


def test_notes_go_to_standard_error(file: Callable[..., str]) -> None:
    result = run(file(OSCILLATOR.replace("-k*x*e_x", "-k/m x e_x")), "--format", "json")
    assert result.exit_code == 0
    assert "note[read-as]" in result.stderr
    assert json.loads(result.stdout)["choices"] == []


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "empty-file"),
        ("title: [", "not-yaml"),
        ("- a\n- b\n", "not-a-mapping"),
        ("title: only\n", "missing-key"),
        (OSCILLATOR.replace("-k*x", "-k*y"), "unknown-symbol"),
        (CONTRADICTION, "contradictory-constraints"),
        (OSCILLATOR + "answers: {equations: [\"m*x'' = q\"]}\n", "unknown-symbol"),
    ],
)
def test_status_2_what_cannot_be_read_or_contradicts_itself(text: str, code: str, file: Callable[..., str]) -> None:
    for result in (run(file(text)), run("-", text=text)):
        assert (result.exit_code, result.stdout) == (2, "")
        assert result.stderr.startswith(f"error[{code}]")


def test_status_2_files(here: Path) -> None:
    (here / "binary.yaml").write_bytes(b"\xff\xfe\x00")
    (here / "huge.yaml").write_bytes(b"#" * (1 << 21))
    (here / "folder.yaml").mkdir()
    for name, said in [
        ("binary.yaml", "is not UTF-8 text"),
        ("huge.yaml", "is larger than"),
        ("folder.yaml", "is a folder"),
        ("absent.yaml", "there is no file absent.yaml"),
        ("n" * 5000, "there is no file"),
    ]:
        result = run(name)
        assert (result.exit_code, result.stdout) == (2, "")
        assert said in result.stderr


@pytest.mark.parametrize("text", [OSCILLATOR + "unknowns: [F]\nfind: linearization\n", REFERENCE])
def test_status_3_what_is_not_covered(text: str, file: Callable[..., str]) -> None:
    result = run(file(text))
    assert (result.exit_code, result.stdout) == (3, "")
    assert result.stderr.startswith("error[not-covered]")


def test_status_3_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    def undecided(*_: object, **__: object) -> None:
        raise UndecidedError("whether the constraints are independent")

    monkeypatch.setattr("lagrange.explain.report.solve", undecided)
    result = run(SKATE)
    assert (result.exit_code, result.stdout) == (3, "")
    assert "could not be decided whether the constraints are independent" in result.stderr


@pytest.mark.parametrize(("passed", "said"), [(False, "did not hold"), (None, "could not be decided")])
def test_status_3_a_check_that_failed(passed: bool | None, said: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def solved(*arguments: object, **options: object) -> Solution:
        return replace(solve(*arguments, **options), checks=(Check("the sun rises", passed, "by looking", "angle"),))

    monkeypatch.setattr("lagrange.explain.report.solve", solved)
    result = run(SKATE)
    assert result.exit_code == 3
    assert "the sun rises" in result.stdout
    assert f"error[check-failed]: a check {said}: the sun rises (angle)" in result.stderr


def test_status_3_an_answer_in_the_file_that_is_wrong(file: Callable[..., str]) -> None:
    answers = "answers: {degrees_of_freedom: 2, equations: [\"m*x'' = k*x\"]}\n"
    result = run(file(OSCILLATOR + answers))
    assert result.exit_code == 3
    assert "k x = 0" in result.stdout
    assert "`degrees_of_freedom` is wrong" in result.stderr
    assert "`equations` is wrong" in result.stderr


MISTAKES = [RuntimeError("boom\nbang"), RecursionError(), ZeroDivisionError("x" * 10_000)]


@pytest.mark.parametrize("mistake", MISTAKES, ids=lambda e: type(e).__name__)
@pytest.mark.parametrize(
    ("command", "where"),
    [
        ([SKATE], "lagrange.explain.report.report"),
        ([SKATE], "lagrange.render.terminal.coloured"),
        (["check", SKATE], "lagrange.answers.examiner.Examiner.check_own"),
        (["list"], "lagsolve.shipped.containing"),
        (["show", SKATE], "lagrange.problem.library.path_of"),
    ],
)
def test_a_mistake_of_the_program_is_a_message(
    command: list[str], where: str, mistake: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(*_: object, **__: object) -> None:
        raise mistake

    monkeypatch.setattr(where, fails)
    result = run(*command)
    assert (result.exit_code, result.stdout) == (3, "")
    assert result.stderr.startswith(f"error[internal]: a mistake of lagsolve, not of yours: {type(mistake).__name__}")
    assert "please report it" in result.stderr
    assert len(result.stderr.splitlines()) == 2
    assert len(result.stderr) < 700
    result = run(*command, env={"LAGSOLVE_DEBUG": "1"})
    assert result.exit_code == 3
    assert "Traceback" in result.stderr


def test_an_interruption_is_no_traceback(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("lagrange.explain.report.report", interrupted)
    result = run(SKATE)
    assert (result.exit_code, result.stdout, result.stderr) == (130, "", "interrupted\n")


# list, show, help, version


def test_show() -> None:
    path = PROBLEMS / "chapter6" / f"{SKATE}.yaml"
    assert run("show", "ex05").stdout == path.read_text(encoding="utf-8")
    assert run("-", text=run("show", "ex05").stdout).exit_code == 0
    result = run("show", "ex5")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "no-such-problem" in result.stderr


@pytest.mark.parametrize("flag", ["-h", "--help"])
def test_help(flag: str) -> None:
    result = run(flag)
    assert (result.exit_code, result.stderr) == (0, "")
    for word in ("lagsolve PROBLEM...", "--format", "--detail", "--choice", "--watch", "--version", "Exit status"):
        assert word in result.stdout
    listed = re.findall(r"^  (\w+)  +[A-Z].*[.]$", result.stdout.partition("Commands:")[2], re.MULTILINE)
    assert tuple(listed) == COMMANDS
    assert set(COMMANDS) == set(main.commands)
    for command in COMMANDS:
        page = run(command, flag).stdout
        assert page.startswith(f"Usage: lagsolve {command}")
        assert run("help", command).stdout == page
        with_status = ("solve", "check", "grade", "simulate", "export", "variant")
        assert ("Exit status" in page) == (command in with_status)
    assert run("help").stdout == run("help", "nonsense").stdout == result.stdout


def test_a_misspelt_command_is_answered_by_the_nearest() -> None:
    assert "did you mean the command `check`?" in run("chekc", "ex11").stderr


def test_version() -> None:
    from importlib.metadata import version

    assert run("--version").stdout == f"lagsolve, version {version('lagsolve')}\n"


def test_values_on_the_command_line() -> None:
    done = run(
        "ex11", "--choice", "angle", "--set", "l=30 cm", "--set", "g=10 m/s^2", "--set", "g=9.81 m/s^2", "--digits", "3"
    )
    assert done.exit_code == 0
    assert "θ̈ + 32.7 sin θ = 0" in done.stdout
    assert run("ex11", "--set", "q=3").exit_code == 2
    assert "unknown-parameter" in run("ex11", "--set", "q=3").stderr
    assert run("ex11", "--digits", "0").exit_code == 2
    right = run("check", "ex11", "--set", "l=2", "-e", "theta'' + g/2*sin(theta) = 0")
    assert right.exit_code == 0
