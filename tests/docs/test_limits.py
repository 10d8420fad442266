"""Limits stand in one module a package, `limits.py`, each with its reason; so do the numbers of random points of the algebra.

This is the test of every module `limits.py`.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from tests.support.paths import ROOT

ALGEBRA = ROOT / "lagrange" / "algebra"
PACKAGES = (ROOT / "lagrange", ROOT / "cli" / "lagsolve")
GATHERED = sorted([*(p for k in PACKAGES for p in k.rglob("limits.py")), ALGEBRA / "exact" / "points_needed.py"])
REPRESENTATION = {"BITS", "LARGEST", "M", "OPAQUE", "REAL_WEIGHT", "SIGNED", "UNIT", "WIDTH"}
"""Numbers that a representation is made of: bits of a packed exponent, the circle of a field. They bound nothing."""


def numbers(path: Path) -> dict[str, int]:
    """The constants of a module that are numbers, or tuples of them, with their lines."""
    found = {}
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=value) if name.isupper():
                if all(isinstance(n.value, int) for n in ast.walk(value) if isinstance(n, ast.Constant)) and not any(
                    isinstance(n, ast.Name | ast.Call | ast.Attribute) for n in ast.walk(value)
                ):
                    found[name] = node.lineno
    return found


@pytest.mark.parametrize("path", sorted(ALGEBRA.glob("*/*.py")), ids=lambda p: f"{p.parent.name}/{p.stem}")
def test_no_other_module_has_a_limit(path: Path) -> None:
    own = {name for name in numbers(path) if not name.startswith("_")}
    assert path in GATHERED or own <= REPRESENTATION


@pytest.mark.parametrize("path", GATHERED, ids=lambda p: p.relative_to(ROOT).as_posix())
def test_every_limit_has_its_reason(path: Path) -> None:
    """A comment above, or a docstring below, for one limit or for several that belong together, with no empty line."""
    lines = path.read_text(encoding="utf-8").splitlines()
    for name, place in numbers(path).items():
        above, below = lines[:place][::-1], [*lines[place - 1 :], ""]
        paragraph = [*above[: above.index("")], *below[: below.index("")]]
        assert any(line.startswith(("#", '"""')) for line in paragraph), name


def test_every_limit_is_used() -> None:
    texts = [p.read_text(encoding="utf-8") for k in PACKAGES for p in k.rglob("*.py") if p not in GATHERED]
    used = {*re.findall(r"\w+", "\n".join(texts))}
    assert [name for path in GATHERED for name in numbers(path) if name not in used] == []
