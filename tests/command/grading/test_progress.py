"""The progress of a batch."""

from __future__ import annotations

import pytest

from lagsolve.grading.progress import Progress


def test_a_line_now_and_then(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    times = iter([0.0, 1.0, 100.0, 200.0])
    monkeypatch.setattr("lagsolve.grading.progress.time.monotonic", lambda: next(times))
    progress = Progress(1000)
    progress.step(1, graded=True)  # too soon
    progress.step(101, graded=True)
    progress.step(201, graded=True)
    progress.end()
    lines = capsys.readouterr().err.splitlines()
    assert lines == ["101 of 1,000 graded, 100 s, about 890 s more", "201 of 1,000 graded, 200 s, about 795 s more"]
