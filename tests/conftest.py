"""What all tests share: which of them are run, which process runs which, and how a problem is read from text.

A test belongs to one of four tiers (`support/tiers.py`):

    (no mark)  tables, one solve of every shipped problem, its checks, reading back, golden files
    truth      second routes on all systems, laws, mutations, the other method, how work grows
    process    child processes, TeX, pandoc, Chromium, Dask
    slow       what else takes long, as measured

`pytest` runs what it is asked to run. `make test` runs the first tier, one short test of each slow function, and a
fortieth of the others, another one every day (`--part today`). Of the first tier, too, what is tried with every shipped
problem is tried with those of chapter 6 and a quarter of the others, so that these are solved every fourth day.
`make test-all` runs everything.
"""

from __future__ import annotations

import gc
import os

os.environ["SYMPY_CACHE_SIZE"] = "30000"  # a process meets the same expressions again; read when SymPy is imported

from collections import Counter
from collections.abc import Callable, Iterator
from datetime import date
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings

from lagrange.core.diagnostics import Source
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from tests.support.chance import QUICK, try_times
from tests.support.grouping import ByProblem, longest_first, part_of, tried_with_many
from tests.support.tiers import renew, representatives, tier_of

HERE = Path(__file__).parent
PARTS = 40
QUARTERS = 4
PROCESSOR = "processor seconds"


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--renew", action="store_true", help="write the golden files anew instead of comparing")
    parser.addoption(
        "--renew-slow", action="store_true", help="write the list of slow tests anew; for a run of all tests"
    )
    parser.addoption("--times", metavar="N", type=int, default=1, help="try N times as many random examples")
    parser.addoption(
        "--part",
        metavar="N",
        help="of the tests marked `truth`, `process` or `slow`, run part N, modulo `--parts`, only, or that of `today`; of "
        f"those of every shipped problem part N modulo {QUARTERS}; "
        f"of more than {QUARTERS} parts Hypothesis tries at most {QUICK} examples",
    )
    parser.addoption("--parts", metavar="N", type=int, default=PARTS, help=f"how many parts there are ({PARTS})")


def pytest_configure(config: pytest.Config) -> None:
    os.environ.pop("SYMPY_CACHE_SIZE", None)  # child processes are as a user has them
    try_times(config.getoption("--times"))
    gc.set_threshold(
        200_000, 50, 100
    )  # the solved problems stay in memory, and need not be looked through again and again
    settings.register_profile("quick", max_examples=QUICK)
    said = config.getoption("--part")
    if said is None:
        return
    if said == "today":
        said = str(date.today().toordinal())
    if not said.isdecimal():
        raise pytest.UsageError(f"--part is `today` or a number, not `{said}`")
    parts = config.getoption("--parts")
    if parts < 2:
        raise pytest.UsageError(f"--parts is at least 2, not {parts}")
    config.option.part = str(int(said) % parts)  # so that processes that begin after midnight take the same
    if parts > QUARTERS:
        settings.load_profile("quick")


@pytest.hookimpl(trylast=True)
def pytest_sessionstart(session: pytest.Session) -> None:
    if session.config.getoption("--renew-slow") and not hasattr(session.config, "workerinput"):
        session.config.pluginmanager.register(_Clock())


class _Clock:
    """Notes how long each test takes, in whichever process, and writes the list of slow ones at the end."""

    def __init__(self) -> None:
        self.seconds: Counter[str] = Counter()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.when == "call":
            noted = [seconds for name, seconds in report.user_properties if name == PROCESSOR]
            self.seconds[report.nodeid.removeprefix("tests/")] += sum(noted)  # type: ignore[arg-type]

    def pytest_sessionfinish(self) -> None:
        renew(self.seconds)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_setup(item: pytest.Item) -> Iterator[None]:
    """A fixture that is made once is counted with the test that it is made for."""
    return (yield from _timed(item))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Iterator[None]:
    return (yield from _timed(item))


def _timed(item: pytest.Item) -> Iterator[None]:
    """Notes processor seconds, those of child processes too: unlike time, they are nearly the same on a busy machine."""
    started = sum(os.times()[:4])
    try:
        return (yield)
    finally:
        item.user_properties.append((PROCESSOR, sum(os.times()[:4]) - started))


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    part, parts = (terminalreporter.config.getoption(f"--{name}") for name in ("part", "parts"))
    if part is not None:
        terminalreporter.line(
            f"of the slow tests part {part} of 0 to {parts - 1} was run (--part {part} --parts {parts} runs it again)"
        )


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    part, number, left_out = config.getoption("--part"), config.getoption("--parts"), set()
    names = [_name(item) for item in items]
    always = representatives(names) if part is not None else set()
    many = tried_with_many(names) if part is not None else set()
    for item, name in zip(items, names, strict=True):
        tier = tier_of(name)
        if tier is not None:
            item.add_marker(tier)
        parts = 1 if name in always else number if tier is not None else min(QUARTERS, number) if name in many else 1
        if part is not None and part_of(name, parts) != int(part) % parts:
            left_out.add(item)
    if left_out:
        config.hook.pytest_deselected(items=[*left_out])
        names = [name for item, name in zip(items, names, strict=True) if item not in left_out]
        items[:] = [item for item in items if item not in left_out]
    if hasattr(config, "workerinput"):
        items[:] = [items[n] for n in longest_first(names)]


def _name(item: pytest.Item) -> str:
    return _below(item.path) + item.nodeid[item.nodeid.index("::") :]


@cache
def _below(path: Path) -> str:
    return path.relative_to(HERE).as_posix()


@pytest.hookimpl(optionalhook=True)  # there is none with `-p no:xdist`
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    if config.getoption("dist") != "loadgroup":
        return None
    return ByProblem(config, log)


@pytest.fixture
def problem() -> Callable[[str], Problem]:
    """Reads a problem from YAML text."""
    return lambda text: read_problem(Source("problem.yaml", text))
