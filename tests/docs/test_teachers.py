"""docs/teachers.md is true: its submissions are graded as it says."""

from __future__ import annotations

import re
import shlex
from dataclasses import fields
from pathlib import Path

import pytest

from lagsolve.grading.table import TableRow
from tests.command.test_main import run
from tests.support.paths import ROOT

PAGE = (ROOT / "docs" / "teachers.md").read_text(encoding="utf-8")


def test_the_table_is_the_one_on_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "answers").mkdir()
    files = re.findall(r"^(answers/\w+\.txt)  +(.+)$", PAGE, re.MULTILINE)
    assert len(files) == 4
    for name, text in files:
        Path(name).write_text(text)
    [command] = re.findall(r"^lagsolve (grade .* --feedback pages)$", PAGE, re.MULTILINE)
    result = run(*shlex.split(command), "--jobs", "1", env={"COLUMNS": "90"})
    assert result.exit_code == 0
    assert f"```\n{result.stdout}```" in PAGE
    assert len(list(Path("pages").iterdir())) == len(files)


def test_the_columns_are_named() -> None:
    section = PAGE.partition("## What comes out")[2].partition("\n## ")[0]
    named = re.findall(r"^\| (`.*?) \|", section, re.MULTILINE)
    assert re.findall(r"\w+", " ".join(named)) == [f.name for f in fields(TableRow)]
