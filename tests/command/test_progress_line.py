"""The line that says what is being done."""

from __future__ import annotations

import io
import sys
import threading
from collections import deque

import pytest

from lagsolve import progress_line


def test_the_line_shows_the_latest_stage(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    written: list[str] = []
    stages = deque(["starting"], maxlen=1)

    def wait(_: float) -> bool:
        stages.append("equilibria" if not written else "stability")
        return len(written) == 2

    progress_line._follow(stages, wait, written.append)
    assert [w[:4] for w in written] == ["\r\x1b[K"] * 3
    assert written[0].startswith("\r\x1b[Kequilibria ... ")
    assert written[1].startswith("\r\x1b[Kstability ... ")
    assert written[-1] == "\r\x1b[K"
    written.clear()
    progress_line._follow(stages, lambda _: True, written.append)
    assert written == []  # what is done soon is not mentioned


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("stream", "term", "threads"), [(io.StringIO, "xterm", 0), (Terminal, "xterm", 1), (Terminal, "dumb", 0)]
)
def test_there_is_a_thread_on_a_terminal_only(
    stream: type[io.StringIO], term: str, threads: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stderr", stream())
    monkeypatch.setenv("TERM", term)
    monkeypatch.setattr(progress_line, "PATIENCE", 3600.0)
    before = threading.active_count()
    with progress_line.stage_shown():
        assert threading.active_count() == before + threads
    assert threading.active_count() == before
    assert sys.stderr.getvalue() == ""  # type: ignore[attr-defined]
