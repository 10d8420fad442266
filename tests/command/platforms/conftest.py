"""What tests of platforms share."""

from __future__ import annotations

from pathlib import Path

import pytest


@pytest.fixture
def submission(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of one submission, in the current folder."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "submission").mkdir()
    return tmp_path / "submission"
