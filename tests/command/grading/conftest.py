"""What tests of grading share."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from lagsolve.grading.pool import Pool
from tests.support.grading_calls import GENEROUS


@pytest.fixture
def pool() -> Iterator[Pool]:
    """Two processes, with limits that no test reaches by itself."""
    pool = Pool(2, GENEROUS)
    yield pool
    pool.shutdown(cancel_futures=True)
