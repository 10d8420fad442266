"""docs/problem-files.md: every example loads, and those that ask for something that is there are solved."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest

from lagrange.explain.report import report
from lagrange.problem.model import Problem
from tests.support.paths import ROOT

EXAMPLES = re.findall(r"```yaml\n(.*?)```", (ROOT / "docs" / "problem-files.md").read_text(encoding="utf-8"), re.DOTALL)


def test_there_are_examples() -> None:
    assert len(EXAMPLES) >= 6


@pytest.mark.parametrize("text", EXAMPLES, ids=lambda text: text.split("\n")[0])
def test_an_example_loads_and_its_checks_hold(text: str, problem: Callable[[str], Problem]) -> None:
    loaded = problem(text)
    if not loaded.equations:
        assert report(loaded).holds
