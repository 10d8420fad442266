"""A sheet of all figures (`make figures`), to be looked through before a release: the system and its free bodies of
every shipped problem, with those that have none.

    python -m tests.support.figure_sheet [--out FILE.html] [--png FOLDER] [NAME | FILE.yaml ...]

Names are of shipped problems, in part; files may be any problems, such as new ones. With `--png` the sheet is also photographed by Chromium, a few problems to a picture. Only what a figure needs is
derived (kinematics and Newton's law), which takes a minute for all problems instead of ten.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from html import escape
from pathlib import Path

from lagrange.core.diagnostics import ProblemError
from lagrange.document.derivation import Picture, Rule, Step
from lagrange.document.math_writer import UNICODE, Writer
from lagrange.document.scene import Scene
from lagrange.explain.illustrations import illustrated
from lagrange.explain.report import notation_of
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.render.html import CSS
from lagrange.render.svg import figure
from tests.support.browser import CHROMIUM
from tests.support.shared import SHIPPED, loaded

PER_PICTURE = 24
COLUMNS, WIDTH, HEIGHT = 4, 480, 400


def solution_for_figures(name: str) -> Solution:
    """Kinematics and Newton's law of a shipped problem or a file, enough to draw it."""
    return kinematics_and_law(loaded(Path(name) if name.endswith(".yaml") else name))


def figures_of(solution: Solution) -> list[Scene]:
    """The figure of the system and the free bodies."""
    steps = (Step(Rule.STATEMENT, "", ()),)
    notation = notation_of(solution)
    drawn = [b.draw() for s in illustrated(steps, solution, notation) for b in s.body if isinstance(b, Picture)]
    return [scene for scene in drawn if scene is not None]


def cell(name: str) -> str:
    """The figures of one problem as HTML."""
    try:
        solution = solution_for_figures(name)
        write = Writer(UNICODE, notation_of(solution), on_page=True).plain
        drawn = ["\n".join(figure(scene, name, write)) for scene in figures_of(solution)]
    except ProblemError as error:
        drawn = [f"<pre>{escape(error.show())}</pre>"]
    size = f"--high: {(HEIGHT - 40) // max(len(drawn), 1)}px"
    return f'<div class="cell" style="{size}"><b>{escape(Path(name).stem)}</b><br>{"".join(drawn) or "<i>no figure</i>"}</div>'


def sheet(cells: Sequence[str]) -> str:
    """A page with all cells."""
    own = (
        f"body {{ margin: 0; background: #fff; }} .cell {{ float: left; width: {WIDTH}px; height: {HEIGHT}px; "
        "overflow: hidden; border: 1px solid #ccc; box-sizing: border-box; font: 13px sans-serif; } "
        ".cell svg { max-width: 96%; max-height: var(--high); width: auto; height: auto; }"
    )
    return f"<!DOCTYPE html><meta charset=utf-8><style>{CSS}{own}</style>" + "\n".join(cells)


def photograph(page: str, file: Path, rows: int) -> None:
    """A picture of a page."""
    assert CHROMIUM is not None
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder, "sheet.html")
        source.write_text(page, encoding="utf-8")
        size = f"--window-size={COLUMNS * WIDTH},{rows * HEIGHT}"
        flags = [
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--hide-scrollbars",
            f"--user-data-dir={folder}/profile",
        ]
        call = [CHROMIUM, *flags, size, f"--screenshot={file}", source.as_uri()]
        subprocess.run(call, capture_output=True, timeout=120, check=True)


def main() -> int:
    """Write the sheet."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("names", nargs="*")
    parser.add_argument("--out", type=Path, default=Path("figures.html"))
    parser.add_argument("--png", type=Path)
    arguments = parser.parse_args()
    files = [n for n in arguments.names if n.endswith(".yaml")]
    parts = [n for n in arguments.names if n not in files]
    names = [n for n in SHIPPED if not arguments.names or any(part in n for part in parts)] + files
    with ProcessPoolExecutor(2) as pool:
        cells = list(pool.map(cell, names, chunksize=4))
    arguments.out.write_text(sheet(cells), encoding="utf-8")
    print(f"{sum('no figure' not in c for c in cells)} of {len(cells)} have a figure: {arguments.out}", file=sys.stderr)
    if arguments.png:
        arguments.png.mkdir(parents=True, exist_ok=True)
        for start in range(0, len(cells), PER_PICTURE):
            part = cells[start : start + PER_PICTURE]
            rows = -(-len(part) // COLUMNS)
            photograph(sheet(part), arguments.png / f"sheet{start // PER_PICTURE + 1:02}.png", rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
