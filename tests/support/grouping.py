"""Which process runs which test: all tests of a problem run in one, which solves it once (`shared.py`).

Shipped problems are handed out in a few batches, so that what is tried with many at once, in TeX or in a browser, finds them
solved. A test function that names a shipped problem in its text runs with the batch of that problem: in another process it
would be solved once more. But what takes a fixture of its module stays together: the fixture would be made anew, a browser
begun, in every process and wherever a test of another module came between.

With several processes (`--dist loadgroup`) xdist hands out groups of tests. Its own way, a mark `xdist_group`, does nothing
under pytest 9.2, where the name of a test can no longer be changed; so the group is read from the name.
"""

from __future__ import annotations

import ast
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
CHAPTER = frozenset(p.stem for p in PROBLEMS.glob("chapter6/*.yaml"))
MANY = 40
_BATCH = re.compile(r"[\[-](batch-\d+)[\]-]")
_CONSTANT = re.compile(r'^([A-Z_]+) = "(?:\w+/)?([\w-]+)"$', re.M)
_FUNCTION = re.compile(r"^def (test_\w+)(.*(?:\n(?![\w@#]).*)*)", re.M)
_FIXTURE = re.compile(r'^@pytest\.fixture\(scope="module"\)\ndef (\w+)', re.M)
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
    """Which part of several a test is in: those of one problem in the same, which solves it once, and those of a fixture."""
    function = test.partition("[")[0]
    group = file if function in _sharing(file := function.partition("::")[0]) else group_of(test)
    return zlib.crc32((test if group == function else group).encode()) % parts


def tried_with_many(tests: Sequence[str]) -> set[str]:
    """The tests of functions that are tried with more than `MANY` shipped problems, save those with one of chapter 6."""
    problems = {test: group for test in tests if (group := group_of(test)) in _PLACES}
    number = Counter(f for f, _ in {(test.partition("[")[0], group) for test, group in problems.items()})
    return {t for t, problem in problems.items() if problem not in CHAPTER and number[t.partition("[")[0]] > MANY}


def batch_of(problem: str) -> int:
    """The batch of a shipped problem: those that are printed together in a format."""
    return _PLACES[problem] % BATCHES


@cache
def unit_of(test: str) -> str:
    """What one process runs: the tests of a fixture of a module, a batch of shipped problems, a system, or a function."""
    function = test.partition("[")[0]
    if function in _sharing(file := function.partition("::")[0]):
        return file
    group = group_of(test)
    if group in _PLACES:
        return f"batch-{batch_of(group)}"
    if batch := _BATCH.search(test):
        return batch[1]
    named = _named_in(file).get(group.partition("::")[2]) if SECONDS.get(group, 0.0) < ALONE else None
    return group if named is None else f"batch-{batch_of(named)}"


@cache
def _text_of(file: str) -> str:
    path = ROOT / "tests" / file
    return path.read_text(encoding="utf-8") if path.is_file() else ""


@cache
def _sharing(file: str) -> frozenset[str]:
    """The test functions of a file that take a fixture which is made once for the module."""
    text = _text_of(file)
    fixtures = {*_FIXTURE.findall(text)}
    if not fixtures:
        return frozenset()
    functions = [f for f in ast.parse(text).body if isinstance(f, ast.FunctionDef)]
    return frozenset(f"{file}::{f.name}" for f in functions if fixtures & {a.arg for a in f.args.args})


@cache
def _named_in(file: str) -> dict[str, str]:
    """The shipped problem that each test function of a file names most often, as a text or by a constant of the file."""
    text = _text_of(file)
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
