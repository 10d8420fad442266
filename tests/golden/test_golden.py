"""What the shipped problems look like, letter by letter, in every format.

For presentation only: truth is tested elsewhere. `make golden` writes the files anew; read the difference before it is
committed. What a failing test got is left in `tests/actual/`.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from lagrange.mechanics.dynamics.motion import Method
from lagrange.render import html, json, latex, markdown, terminal
from lagrange.render.html import CSS
from tests.support.paths import ROOT
from tests.support.shared import SHIPPED, reported

GOLDEN = ROOT / "tests" / "golden"
ACTUAL = ROOT / "tests" / "actual"
FORMATS = {
    "60.txt": lambda r: terminal.text(r.derivation, r.notation, 60),
    "80.txt": lambda r: terminal.text(r.derivation, r.notation, 80),
    "tex": lambda r: latex.render([(r.derivation, r.notation)]),
    "json": lambda r: json.render([r]),
}
PAGES = {
    "md": lambda r: markdown.render([(r.derivation, r.notation)]),
    "html": lambda r: html.render([(r.derivation, r.notation)]),
}

CHAPTER = [name for name, path in SHIPPED.items() if path.parent.name == "chapter6"]
AT_REST = ["bifilar-suspension", "double-pendulum-small-oscillations", "ladder", "ziegler-column"]
"""Statics and small oscillations, of which the chapter has nothing."""
KEPT = {
    "60.txt": ["ex05-ice-skate", "ex11-ideal-pendulum", "ex16-rod-on-two-planes", "ex18-double-pendulum"],
    "80.txt": [*CHAPTER, *AT_REST],
    "tex": [*CHAPTER, *AT_REST],
    "json": ["ex11-ideal-pendulum", "ladder", "rolling-disc"],
}
"""Few of 60 columns, which differ from 80 in the breaking of lines only, and of JSON, which is read back elsewhere."""
BY_LAGRANGE = ["ex11-ideal-pendulum", "ex17-spherical-pendulum", "rolling-disc"]
KEPT_PAGES = [n for n in CHAPTER if n.startswith(("ex04", "ex06", "ex11", "ex16", "ex17", "ex18"))]


@pytest.mark.parametrize(("name", "ending"), [(n, ending) for ending, names in KEPT.items() for n in names])
def test_output_is_as_it_was(name: str, ending: str, request: pytest.FixtureRequest) -> None:
    """What is printed unasked; JSON is complete."""
    compare(f"{name}.{ending}", FORMATS[ending](reported(name, complete=ending == "json")), request)


@pytest.mark.parametrize("ending", ["80.txt", "tex"])
@pytest.mark.parametrize("name", BY_LAGRANGE)
def test_output_by_lagranges_equations_is_as_it_was(name: str, ending: str, request: pytest.FixtureRequest) -> None:
    printed = reported(name, Method.LAGRANGE, complete=False)
    compare(f"{name}.lagrange.{ending}", FORMATS[ending](printed), request)


@pytest.mark.parametrize("ending", PAGES)
@pytest.mark.parametrize("name", KEPT_PAGES)
def test_pages_are_as_they_were(name: str, ending: str, request: pytest.FixtureRequest) -> None:
    printed = PAGES[ending](reported(name, complete=False)).replace(f"\n{CSS}\n", "...")
    compare(f"{name}.{ending}", re.sub(r"'sha256-[^']*'", "'sha256-...'", printed), request)


def compare(name: str, actual: str, request: pytest.FixtureRequest) -> None:
    """Compares with the golden file of this name, or writes it."""
    golden = GOLDEN / name
    if request.config.getoption("--renew"):
        golden.write_text(actual, encoding="utf-8")
        return
    expected = golden.read_text(encoding="utf-8") if golden.exists() else "(no golden file)"
    if actual != expected:
        ACTUAL.mkdir(exist_ok=True)
        Path(ACTUAL / golden.name).write_text(actual, encoding="utf-8")
    assert actual == expected


def test_no_golden_file_is_left_over() -> None:
    expected = {f"{n}.{ending}" for ending, names in KEPT.items() for n in names}
    expected |= {f"{n}.lagrange.{ending}" for n in BY_LAGRANGE for ending in ("80.txt", "tex")}
    expected |= {f"{n}.{ending}" for n in KEPT_PAGES for ending in PAGES}
    assert {p.name for p in GOLDEN.iterdir() if p.suffix not in ("", ".py")} - {"README.md"} == expected
