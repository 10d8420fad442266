r"""Vectors in TeX: bold, underlined, or with an arrow, as a lecturer writes them.

The letter alone is marked, under the dots and before the index: `\ddot{\mathbf{r}}_{P}`, `\ddot{\underline{r}}_{P}`.
"""

from __future__ import annotations

import re
from enum import StrEnum

_BOLD = re.compile(r"\\(?:mathbf|boldsymbol)\{")


class Vectors(StrEnum):
    """How vectors are marked."""

    BOLD = "bold"
    UNDERLINED = "underlined"
    ARROW = "arrow"

    def written(self, code: str) -> str:
        """TeX with bold letters, marked in this way."""
        command = {Vectors.UNDERLINED: r"\underline{", Vectors.ARROW: r"\vec{"}.get(self)
        return code if command is None else _BOLD.sub(lambda _: command, code)
