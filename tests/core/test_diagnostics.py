"""The place of a diagnostic, and how it is shown."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Source, Span, nearest

TEXT = "first\nsecond line\r\n\nlast"


def test_positions_are_counted_from_one() -> None:
    source = Source("a.yaml", TEXT)
    for offset in range(len(TEXT) + 1):
        before = TEXT[:offset]
        assert source.position(offset) == (before.count("\n") + 1, offset - (before.rfind("\n") + 1) + 1)


def test_lines_are_without_their_ends() -> None:
    source = Source("a.yaml", TEXT)
    assert [source.line(n) for n in (1, 2, 3, 4, 5)] == ["first", "second line", "", "last", ""]


def test_a_piece_of_a_fragment_is_a_piece_of_its_source() -> None:
    source = Source("a.yaml", "key: x + y")
    fragment = Fragment("x + y", Span(source, 5, 10), 5)
    span = fragment.span(4, 5)
    assert source.text[span.start : span.end] == "y"


def test_what_is_shown_has_file_line_column_and_caret() -> None:
    source = Source("a.yaml", "title: T\nx: y + z\n")
    shown = ProblemError(Diagnostic("unknown-name", "there is no `z`", Span(source, 16, 17), help="declare it")).show()
    lines = shown.splitlines()
    assert lines[0] == "error[unknown-name]: there is no `z`"
    assert "a.yaml:2:8" in lines[1]
    [line] = [n for n, text in enumerate(lines) if text.endswith("x: y + z")]
    assert lines[line + 1].index("^") == lines[line].index("z")
    assert lines[-1].endswith("help: declare it")


@pytest.mark.parametrize(("name", "found"), [("thetta", "theta"), ("them", "them"), ("qqqqq", None)])
def test_the_nearest_name(name: str, found: str | None) -> None:
    assert nearest(name, ["theta", "phi", "them"]) == found
