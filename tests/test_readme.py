"""The README is true: its problem file solves, its commands run, its error looks as it says."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner
from conftest import ROOT

from lagsolve.main import main

README = (ROOT / "README.md").read_text(encoding="utf-8")
[BEAD] = re.findall(r"```yaml\n(.*?)```", README, re.DOTALL)
COMMANDS = re.findall(r"^(lagsolve [^\n#]*?)\s*(?:#.*)?$", README, re.MULTILINE)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bead.yaml").write_text(BEAD, encoding="utf-8")
    return tmp_path


def test_there_are_commands() -> None:
    assert len(COMMANDS) >= 5


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_run(command: str, folder: Path) -> None:
    result = CliRunner().invoke(main, shlex.split(command)[1:])
    assert result.exit_code == 0, result.output + result.stderr
    assert result.output or "-o" in command
    for ending, beginning in {".tex": r"\documentclass", ".md": "# ", ".html": "<!DOCTYPE html>"}.items():
        if f"-o bead{ending}" in command:
            assert (folder / f"bead{ending}").read_text(encoding="utf-8").startswith(beginning)


@pytest.mark.usefixtures("folder")
def test_the_diagnosis_is_shown_as_printed() -> None:
    [(command, shown)] = re.findall(r"```\n\$ (lagsolve check [^\n]*)\n(.*?)```", README, re.DOTALL)
    result = CliRunner().invoke(main, shlex.split(command)[1:], env={"COLUMNS": "80"})
    assert (result.exit_code, result.stdout) == (1, shown)


def test_the_error_is_shown_as_printed(folder: Path) -> None:
    (folder / "bead.yaml").write_text(BEAD.replace("wire: y =", "wire: thta ="), encoding="utf-8")
    result = CliRunner().invoke(main, ["bead.yaml"])
    assert result.exit_code == 2
    [shown] = re.findall(r"```\n(error\[.*?)  = help", README, re.DOTALL)
    assert shown in result.stderr


def test_links_lead_somewhere() -> None:
    for target in re.findall(r"\]\(([^)#]+)\)", README):
        assert (ROOT / target).exists(), target
