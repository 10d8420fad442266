"""A derivation in a notebook."""

from __future__ import annotations

import re

from lagrange.render import html
from lagrange.render.notes.notebook import style_sheet


def test_the_style_sheet_reaches_nothing_outside() -> None:
    rules = re.sub(r"@media[^{]*\{", "", style_sheet())
    selectors = [s.strip() for rule in re.findall(r"([^{}]+)\{", rules) for s in rule.split(",")]
    assert len(selectors) > 60
    assert [s for s in selectors if ".lagsolve" not in s] == []
    assert style_sheet().count("{") == style_sheet().count("}")
    assert len(re.findall(r"[^{}]+\{", html.CSS)) < len(re.findall(r"[^{}]+\{", style_sheet()))
