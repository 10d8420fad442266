"""The README is true: its problem file solves, its commands run, what it shows is what is printed.

Every line of a block of commands is run, or listed in `NOT_RUN` with the reason. What docs/other-programs.md says of SymPy is asked of SymPy.
"""

from __future__ import annotations

import importlib
import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from lagsolve.main import main
from tests.support import picture
from tests.support.paths import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")
[BEAD] = re.findall(r"```yaml\n(.*?)```", README, re.DOTALL)
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```", README, re.DOTALL | re.MULTILINE)
LINES = [re.split(r"\s+# ", line)[0].strip() for kind, text in BLOCKS if kind == "sh" for line in text.splitlines()]
SHOWN = [text for kind, text in BLOCKS if not kind]
NOT_RUN = {
    "make demo": "makes an environment over the network; the command that it runs is `lagsolve ex11-ideal-pendulum`",
    "make test": "runs this test",
    "make test-all": "runs this test",
    "pip install .": "test_packaging installs the wheel and runs the command",
    "pipx install .": "pip in an environment of its own, as in test_packaging",
    "lagsolve bead.yaml --watch": "never ends; command/test_solve_task.py runs it",
}
COMMANDS = [line for line in LINES if line not in NOT_RUN]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bead.yaml").write_text(BEAD, encoding="utf-8")
    (tmp_path / "answers").mkdir()
    (tmp_path / "answers" / "anna.txt").write_text("x'' + 2*a*x*y'' + 2*a*g*x = 0\ny = a*x^2\n", encoding="utf-8")
    return tmp_path


def run(command: str) -> tuple[int, str, str]:
    """Exit status, standard output, standard error."""
    command, _, redirected = command.partition(" > ")
    words = shlex.split(command)
    assert words[0] == "lagsolve"
    jobs = ["--jobs", "1"] * ("grade" in words)
    result = CliRunner().invoke(main, [*words[1:], *jobs], env={"COLUMNS": "80"})
    if redirected:
        Path(redirected).write_text(result.stdout, encoding="utf-8")
    return result.exit_code, result.stdout, result.stderr


def test_all_commands_are_run() -> None:
    assert set(NOT_RUN) <= set(LINES)
    assert len(COMMANDS) >= 12
    assert all(line.startswith("lagsolve ") for line in COMMANDS)
    elsewhere = [line for kind, text in BLOCKS if kind != "sh" for line in text.splitlines() if "lagsolve " in line]
    assert all(line.startswith("$ lagsolve check ") for line in elsewhere)


@pytest.mark.parametrize("target", [line for line in NOT_RUN if line.startswith("make ")])
def test_targets_exist(target: str) -> None:
    assert re.search(rf"^{target.split()[1]}:", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_run(command: str, folder: Path) -> None:
    status, printed, said = run(command)
    assert status == 0, printed + said
    assert not said or command.startswith("lagsolve new ")
    written = re.search(r"(?:-o|--csv|new|>) (\S+)", command)
    assert printed or written
    if written:
        text = (folder / written[1]).read_text(encoding="utf-8")
        beginning = {".tex": r"\documentclass", ".md": "# ", ".html": "<!DOCTYPE html>", ".csv": "submission,"}
        beginning |= {".yaml": "", ".json": "{", ".svg": "<?xml", ".c": "// dy/dt of"}
        assert text.startswith("% lagsolve" if "--fragment" in command else beginning[Path(written[1]).suffix])


@pytest.mark.usefixtures("folder")
def test_the_diagnosis_is_shown_as_printed() -> None:
    [(command, shown)] = re.findall(r"^\$ (lagsolve check [^\n]*)\n(.*)", "".join(SHOWN), re.DOTALL | re.MULTILINE)
    assert run(command) == (1, shown, "")


def test_the_error_is_shown_as_printed(folder: Path) -> None:
    (folder / "bead.yaml").write_text(BEAD.replace("wire: y =", "wire: thta ="), encoding="utf-8")
    assert run("lagsolve bead.yaml") == (2, "", SHOWN[0])


@pytest.mark.usefixtures("folder")
def test_the_source_of_the_notes_is_shown_as_written() -> None:
    [shown] = [text for kind, text in BLOCKS if kind == "latex"]
    _, written, _ = run("lagsolve bead.yaml --fragment --detail brief")
    assert shown in written


@pytest.mark.usefixtures("folder")
def test_the_lines_of_python_run(capsys: pytest.CaptureFixture[str]) -> None:
    [code] = [text for kind, text in BLOCKS if kind == "python"]
    exec(compile(code, "README.md", "exec"), {})
    assert capsys.readouterr().out.endswith("equivalent\n")


def test_a_shell_can_complete() -> None:
    for shell in ("bash", "--help"):
        assert run(f"lagsolve completion {shell}")[0] == 0


def test_every_key_of_the_file_is_explained() -> None:
    explained = re.findall(r"`(\w+)`", " ".join(re.findall(r"^\| (`.*?) \|", README, re.MULTILINE)))
    assert explained == re.findall(r"^(\w+):", BEAD, re.MULTILINE)


def test_the_picture_is_what_is_printed() -> None:
    """`make picture` draws it anew."""
    printed = [line.plain.rstrip() for line in picture.pictured()]
    svg = picture.PICTURE.read_text(encoding="utf-8")
    assert picture.text_of(svg) == printed
    assert picture.text_of(picture.drawn()) == printed
    assert f"docs/pictures/{picture.PICTURE.name}" in README
    assert "url(" not in svg
    assert re.findall(r"https?://[^\"]*", svg) == ["http://www.w3.org/2000/svg"]


def test_a_line_of_the_picture_is_a_line_of_the_output() -> None:
    printed = {line.plain for line in picture.output()}
    command, *others = (line.plain for line in picture.pictured())
    assert command == f"$ {picture.COMMAND}"
    assert {line for line in others if line not in printed} <= {"", picture.LEFT_OUT.plain}


def test_what_is_said_of_sympy() -> None:
    mechanics = importlib.import_module("sympy.physics.mechanics")
    lagrange, kane = mechanics.LagrangesMethod, mechanics.KanesMethod
    assert callable(lagrange.solve_multipliers)
    assert callable(lagrange.linearize)
    assert callable(kane.linearize)
    assert {"PinJoint", "TorqueActuator"} <= set(dir(mechanics))
    assert callable(importlib.import_module("sympy.physics.biomechanics").MusculotendonDeGroote2016)
    public = {name for c in (lagrange, kane, mechanics.System) for name in dir(c) if not name.startswith("_")}
    assert not [name for name in public if re.search("integrab|check|verif|equilib|conserv|derivation", name)]


PAGES = [
    *sorted((ROOT / "docs").glob("*.md")),
    *(ROOT / f"{name}.md" for name in ("README", "CONTRIBUTING", "SECURITY")),
]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_links_lead_somewhere(page: Path) -> None:
    text = re.sub(r"^```.*?^```|`[^`\n]*`", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    for target in re.findall(r"\]\((?!\w+:)([^)]+)\)|src=\"([^\"]+)\"", text):
        name, _, anchor = "".join(target).partition("#")
        linked = page.parent / name if name else page
        assert linked.exists(), target
        headings = re.findall(r"^#+ (.*)", linked.read_text(encoding="utf-8"), re.MULTILINE) if anchor else []
        assert not anchor or anchor in {re.sub(r"[^\w -]", "", h.lower()).replace(" ", "-") for h in headings}, target


def test_every_page_is_in_the_readme() -> None:
    assert {f"docs/{page.name}" for page in PAGES if page.parent.name == "docs"} <= set(
        re.findall(r"\]\((docs/[^)#]+)\)", README)
    )
