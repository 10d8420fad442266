"""Which process runs which test: all tests of a problem run in one, which solves it once (`shared.py`).

Shipped problems are handed out in a few batches, so that what is tried with many at once, in TeX or in a browser, finds them
solved. A test function that names a shipped problem in its text runs with the batch of that problem: in another process it
would be solved once more.

With several processes (`--dist loadgroup`) xdist hands out groups of tests. Its own way, a mark `xdist_group`, does nothing
under pytest 9.2, where the name of a test can no longer be changed; so the group is read from the name.
"""

from __future__ import annotations

import re
import zlib
from collections import Counter
from collections.abc import Sequence
from functools import cache
from typing import Any

from xdist.scheduler import LoadScopeScheduling

from tests.support.paths import PROBLEMS, ROOT, SYSTEM_FILES
from tests.support.tiers import SECONDS

NAMES = sorted({p.stem for p in (*PROBLEMS.glob("*/*.yaml"), *SYSTEM_FILES.glob("*.yaml"))}, key=len, reverse=True)
PROBLEM = re.compile(rf"(?:^|[-/])({'|'.join(map(re.escape, NAMES))})(?:-|$)")
BATCHES = 8
_PLACES = {name: n for n, name in enumerate(sorted(p.stem for p in PROBLEMS.glob("*/*.yaml")))}
_BATCH = re.compile(r"[\[-](batch-\d+)[\]-]")
_CONSTANT = re.compile(r'^([A-Z_]+) = "(?:\w+/)?([\w-]+)"$', re.M)
_FUNCTION = re.compile(r"^def (test_\w+)(.*(?:\n(?![\w@#]).*)*)", re.M)
_WORD = re.compile(r'"(?:\w+/)?([a-z0-9-]+)(?:\.yaml)?"|\b([A-Z_]+)\b')
ALONE = 5.0
"""Seconds of a function from which on it is no part of a batch: other processes would wait for it."""
LITTLE = 0.01
"""Seconds of a test that is not in the list of slow ones."""


@cache
def group_of(test: str) -> str:
    """The problem that a test is parametrised by; where there is none, the function, whose tests may share something."""
    function, _, parameters = test.removesuffix("]").partition("[")
    found = PROBLEM.search(parameters)
    return found[1] if found else function


def part_of(test: str, parts: int) -> int:
    """Which part of several a slow test is in: all those of one problem in the same, which solves it once."""
    group = group_of(test)
    return zlib.crc32((test if group == test.partition("[")[0] else group).encode()) % parts


def batch_of(problem: str) -> int:
    """The batch of a shipped problem: those that are printed together in a format."""
    return _PLACES[problem] % BATCHES


@cache
def unit_of(test: str) -> str:
    """What one process runs: the tests of a batch of shipped problems, of a system, or of a function."""
    group = group_of(test)
    if group in _PLACES:
        return f"batch-{batch_of(group)}"
    if batch := _BATCH.search(test):
        return batch[1]
    file, _, function = group.partition("::")
    named = _named_in(file).get(function) if SECONDS.get(group, 0.0) < ALONE else None
    return group if named is None else f"batch-{batch_of(named)}"


@cache
def _named_in(file: str) -> dict[str, str]:
    """The shipped problem that each test function of a file names most often, as a text or by a constant of the file."""
    path = ROOT / "tests" / file
    text = path.read_text(encoding="utf-8") if path.is_file() else ""
    constants = {m[1]: m[2] for m in _CONSTANT.finditer(text) if m[2] in _PLACES}
    most: dict[str, str] = {}
    for function in _FUNCTION.finditer(text):
        words = (constants.get(m[2], m[1]) for m in _WORD.finditer(function[2]))
        if named := Counter(w for w in words if w in _PLACES).most_common(1):
            most[function[1]] = named[0][0]
    return most


def longest_first(tests: Sequence[str]) -> list[int]:
    """The order in which several processes take tests: those of a group together, and groups that take longest first.

    Otherwise a test of half a minute, which is a group by itself, may be the last, and the other processes wait for it.
    """
    functions = [test.partition("[")[0] for test in tests]
    number = Counter(functions)
    seconds: Counter[str] = Counter()
    for test, function in zip(tests, functions, strict=True):
        seconds[unit_of(test)] += SECONDS.get(function, 0.0) / number[function] + LITTLE
    first = {group: n for n, group in reversed([*enumerate(map(unit_of, tests))])}
    return sorted(range(len(tests)), key=lambda n: (-seconds[g := unit_of(tests[n])], first[g], n))


class ByProblem(LoadScopeScheduling):  # type: ignore[misc]
    """Hands out the tests of a group together, in the order in which they were collected."""

    def __init__(self, config: Any, log: Any) -> None:
        super().__init__(config, log)
        config.option.loadscopereorder = False

    def _split_scope(self, nodeid: str) -> str:
        return unit_of(nodeid)
