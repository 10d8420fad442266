"""docs/simulation.md: its commands run."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from lagsolve.main import main
from tests.support.paths import ROOT

PAGE = (ROOT / "docs" / "simulation.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^lagsolve (.*)$", PAGE, re.MULTILINE)


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_run(command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(main, shlex.split(command))
    assert result.exit_code == 0, result.output
    written = re.search(r"-o (\S+)", command)
    assert written is None or (tmp_path / written[1]).stat().st_size > 500


def test_there_are_commands() -> None:
    assert len(COMMANDS) == 5
