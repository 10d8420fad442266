"""What the chapter's problems look like, letter by letter, in every format.

For presentation only: truth is tested elsewhere. `make golden` writes the files anew; read the difference before it is
committed. What a failing test got is left in `tests/actual/`.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import PROBLEMS, ROOT

from lagrange.explain.report import Report, report
from lagrange.mechanics.dynamics.motion import Method
from lagrange.problem.loader import load
from lagrange.render import html, json, latex, markdown
from lagrange.render import terminal as pretty
from lagrange.render.stylesheet import CSS

GOLDEN = ROOT / "tests" / "golden"
ACTUAL = ROOT / "tests" / "actual"
SHIPPED = sorted(PROBLEMS.glob("chapter6/*.yaml"))
BY_LAGRANGE = ("chapter6/ex11-ideal-pendulum", "chapter6/ex17-spherical-pendulum", "motion/rolling-disc")


@pytest.fixture(scope="module", params=SHIPPED, ids=lambda p: p.stem)
def solved(request: pytest.FixtureRequest) -> tuple[str, Report, Report]:
    """The name, what is printed, and what is complete, for JSON."""
    problem = load(request.param)
    return request.param.stem, report(problem, complete=False), report(problem)


FORMATS = {
    "60.txt": lambda r: pretty.text(r.derivation, r.notation, 60),
    "80.txt": lambda r: pretty.text(r.derivation, r.notation, 80),
    "tex": lambda r: latex.render([(r.derivation, r.notation)]),
    "json": lambda r: json.render([r]),
}
PAGES = {
    "md": lambda r: markdown.render([(r.derivation, r.notation)]),
    "html": lambda r: html.render([(r.derivation, r.notation)]),
}
KEPT = [p for p in SHIPPED if p.name.startswith(("ex04", "ex06", "ex11", "ex16", "ex17", "ex18"))]
"""The problems whose pages are kept as well."""


@pytest.mark.parametrize("ending", FORMATS)
def test_output_is_as_it_was(solved: tuple[str, Report, Report], ending: str, request: pytest.FixtureRequest) -> None:
    name, printed, complete = solved
    compare(f"{name}.{ending}", FORMATS[ending](complete if ending == "json" else printed), request)


@pytest.mark.parametrize("ending", ["80.txt", "tex"])
@pytest.mark.parametrize("name", BY_LAGRANGE)
def test_output_by_lagranges_equations_is_as_it_was(name: str, ending: str, request: pytest.FixtureRequest) -> None:
    printed = report(load(PROBLEMS / f"{name}.yaml"), complete=False, method=Method.LAGRANGE)
    compare(_by_lagrange(name, ending), FORMATS[ending](printed), request)


def _by_lagrange(name: str, ending: str) -> str:
    return f"{name.partition('/')[2]}.lagrange.{ending}"


@pytest.mark.parametrize("ending", PAGES)
@pytest.mark.parametrize("solved", KEPT, ids=lambda p: p.stem, indirect=True)
def test_pages_are_as_they_were(
    solved: tuple[str, Report, Report], ending: str, request: pytest.FixtureRequest
) -> None:
    name, printed, _ = solved
    compare(f"{name}.{ending}", PAGES[ending](printed).replace(f"\n{CSS}\n", "..."), request)


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
    expected = {f"{p.stem}.{ending}" for p in SHIPPED for ending in FORMATS}
    expected |= {_by_lagrange(name, ending) for name in BY_LAGRANGE for ending in ("80.txt", "tex")}
    expected |= {f"{p.stem}.{ending}" for p in KEPT for ending in PAGES}
    assert {p.name for p in GOLDEN.iterdir() if p.name != "README.md"} == expected
