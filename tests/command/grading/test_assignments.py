"""The names on a command line."""

from __future__ import annotations

import click
import pytest

from lagsolve.grading.assignments import labelled, sorted_out


def test_problems_before_answers() -> None:
    assert sorted_out(["ex11", "answers"]) == (("ex11",), ("answers",))
    assert sorted_out(["ex11", "ex05", "answers"]) == (("ex11", "ex05"), ("answers",))
    with pytest.raises(click.UsageError, match="ANSWERS"):
        sorted_out(["ex11"])


def test_labels_are_the_names_as_typed() -> None:
    assert [label for label, _ in labelled(["ex11", "ex05"])] == ["ex11", "ex05"]
