"""One walk over the blocks of a step for every format."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from lagrange.document.builders import display, prose
from lagrange.document.derivation import Equation, Table
from lagrange.render.walk import block_lines

x = sp.Symbol("x")


class Named:
    """Writes the name of each kind of block, and of how many it is."""

    def paragraphs(self, run: Sequence[Any]) -> Iterator[str]:
        yield f"paragraphs {len(run)}"

    def display(self, block: Any) -> Iterator[str]:
        yield f"display {len(block.equations)}"

    def table(self, block: Any) -> Iterator[str]:
        yield f"table {len(block.rows)}"


def test_paragraphs_that_follow_one_another_are_one_run() -> None:
    blocks = [prose("a"), prose("b"), display(Equation((x, x))), Table(("h",), (("c",),)), prose("d")]
    assert [*block_lines(blocks, Named())] == ["paragraphs 2", "display 1", "table 1", "paragraphs 1"]  # type: ignore[arg-type]
