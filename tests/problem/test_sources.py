"""The text of a file: what is no file is refused, and what changes while it is read is read again."""

from __future__ import annotations

import os
import socket
from pathlib import Path

import pytest

from lagrange.core.diagnostics import ProblemError
from lagrange.expressions.limits import MAX_CHARACTERS
from lagrange.problem import load_context, sources
from lagrange.problem.limits import MAX_BYTES
from lagrange.problem.load_context import canonical, derivatives_in, names_in
from lagrange.problem.sources import read_source


def refused(path: Path) -> str:
    with pytest.raises(ProblemError) as error:
        read_source(path)
    return error.value.show().splitlines()[0]


@pytest.mark.timeout(20)
def test_what_is_no_file_is_refused_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    os.mkfifo("pipe")
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind("socket")
    Path("link").symlink_to("pipe")
    for name in ("pipe", "link"):
        assert refused(Path(name)).startswith(f"error[unreadable-file]: {name} cannot be read: it is a pipe")
    assert "it is a socket" in refused(Path("socket"))
    assert "it is a device" in refused(Path("/dev/zero"))
    assert refused(Path()).startswith("error[is-a-folder]")
    assert refused(Path("a\0b")).startswith("error[unreadable-file]")
    assert refused(Path("loop" * 100)).startswith("error[unreadable-file]")


def test_what_the_caller_has_opened_is_read() -> None:
    """As a shell does for `<(...)`."""
    reader, writer = os.pipe()
    os.write(writer, b"title: T\r\n")
    os.close(writer)
    try:
        assert read_source(Path(f"/dev/fd/{reader}")).text == "title: T\n"
    finally:
        os.close(reader)


def test_a_file_that_is_written_to_while_it_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "p.yaml"
    path.write_bytes(b"a" * 10)
    real, times = os.fstat, [0]

    def changing(descriptor: int) -> os.stat_result:
        """Something is appended between any two looks, as often as `times` says."""
        if times[0]:
            times[0] -= 1
            with path.open("ab") as file:
                file.write(b"b")
        return real(descriptor)

    monkeypatch.setattr(sources.os, "fstat", changing)
    times[0] = 3
    assert read_source(path).text == "a" * 10 + "b" * 3
    times[0] = 100
    assert "it changes while it is read" in refused(path)


def test_a_large_file_is_not_read_to_its_end(tmp_path: Path) -> None:
    path = tmp_path / "large.yaml"
    with path.open("wb") as file:
        file.truncate(1 << 40)  # sparse
    assert refused(path).startswith("error[file-too-large]")
    path.write_bytes(b"#" * MAX_BYTES)
    assert len(read_source(path).text) == MAX_BYTES


def test_a_text_that_is_no_expression_is_not_taken_apart(monkeypatch: pytest.MonkeyPatch) -> None:
    """A megabyte would become half a million tokens before it is refused as too long."""
    monkeypatch.setattr(load_context, "tokens", lambda _: pytest.fail("it was read"))
    text = "a " * MAX_CHARACTERS
    assert names_in(text) == derivatives_in(text) == ()
    assert canonical(text) == text
