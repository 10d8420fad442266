"""Completion by a shell, and the help."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from click.shell_completion import BashComplete, get_completion_class

from lagrange.problem import library
from lagsolve.main import main
from tests.command.test_problem_commands import run
from tests.support.paths import ROOT
from tests.support.processes import PATIENCE


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
