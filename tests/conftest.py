"""Shared by all tests: the folder of shipped problems, reading a problem from text, the option to renew golden files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from lagrange.core.diagnostics import Source
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem

ROOT = Path(__file__).parents[1]
PROBLEMS = ROOT / "problems"


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--renew", action="store_true", help="write the golden files anew instead of comparing")


@pytest.fixture
def problem() -> Callable[[str], Problem]:
    """Reads a problem from YAML text."""
    return lambda text: read_problem(Source("problem.yaml", text))
