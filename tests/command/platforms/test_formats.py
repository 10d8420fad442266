"""What `grade --format` writes, and for how many submissions."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.command.platforms.test_gradescope import RIGHT
from tests.command.test_main import run


@pytest.mark.parametrize("format_", ["gradescope", "prairielearn"])
def test_these_formats_are_about_one_submission(format_: str, submission: Path) -> None:
    (submission / "a").write_text(RIGHT)
    for more, said in (
        (["submission"], "a single submission"),
        (["--csv", "m.csv"], "leave out"),
    ):
        assert said in run("grade", "ex11", "submission", *more, "--format", format_).stderr
    assert run("grade", "ex11", "nowhere", "--format", format_).exit_code == 2
