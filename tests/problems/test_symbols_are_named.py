"""On every page of the library, each symbol is named before it is used, or in the same breath."""

from __future__ import annotations

import pytest

from tests.support.named_symbols import unnamed_symbols
from tests.support.shared import SHIPPED, reported


@pytest.mark.parametrize("name", SHIPPED)
def test_every_symbol_is_named_before_it_is_used(name: str) -> None:
    assert unnamed_symbols(reported(name, complete=False)) == []
