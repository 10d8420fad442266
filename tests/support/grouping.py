"""Which process runs which test: all tests of a problem run in one, which solves it once (`shared.py`).

With several processes (`--dist loadgroup`) xdist hands out groups of tests. Its own way, a mark `xdist_group`, does nothing
under pytest 9.2, where the name of a test can no longer be changed; so the group is read from the name.
"""

from __future__ import annotations

import re
import zlib
from functools import cache

from xdist.scheduler import LoadScopeScheduling

from tests.support.paths import PROBLEMS, SYSTEM_FILES

NAMES = sorted({p.stem for p in (*PROBLEMS.glob("*/*.yaml"), *SYSTEM_FILES.glob("*.yaml"))}, key=len, reverse=True)
PROBLEM = re.compile(rf"(?:^|[-/])({'|'.join(map(re.escape, NAMES))})(?:-|$)")


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


class ByProblem(LoadScopeScheduling):  # type: ignore[misc]
    """Hands out the tests of a group together, large groups first."""

    def _split_scope(self, nodeid: str) -> str:
        return group_of(nodeid)
