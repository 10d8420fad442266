"""Systems whose displacements are too long to be solved for."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import NotCoveredError
from lagrange.mechanics.large_systems import stages_of_large
from tests.support.shared import loaded


@pytest.mark.parametrize("name", ["ex11-ideal-pendulum", "centre-of-percussion"])
def test_what_they_do_not_cover_is_refused(name: str) -> None:
    with pytest.raises(NotCoveredError, match="too long to be solved for"):
        list(stages_of_large(loaded(name), lambda _: None))
