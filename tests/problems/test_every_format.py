"""Every shipped problem in every format, by Lagrange's equations too; `make sweep` runs these tests alone.

The command is run for the JSON, which is another run of the same problem, in which other points are drawn: it finds the
same. No line is wider than the terminal. TeX, pandoc and a browser read what is printed, where they are installed, of a
batch of problems at once, because each takes longer to begin than over most problems.
"""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner
from rich.cells import cell_len

from lagrange.answers.equations import Verdict, check_equations
from lagrange.core.diagnostics import Fragment
from lagrange.document.derivation import Derivation, Detail
from lagrange.document.math_writer import Notation
from lagrange.explain.report import Report
from lagrange.mechanics.dynamics.motion import Method
from lagrange.render import html, latex, markdown, terminal
from lagrange.render.json import as_object
from lagrange.render.json import render as render_json
from lagsolve.main import main as command
from tests.support.browser import CHROMIUM, all_measured
from tests.support.grouping import BATCHES, batch_of
from tests.support.nets.in_print import names_of_file, unfit
from tests.support.processes import PATIENCE
from tests.support.shared import SHIPPED, asking, file_of, reference_of, reported
from tests.support.tex import faults_of_tex, needs_tex

WIDTHS = (60, 80, 120)
PIXELS = (360, 1280)
in_batches = pytest.mark.parametrize("batch", range(BATCHES), ids="batch-{}".format)


@pytest.mark.parametrize("name", SHIPPED)
def test_another_run_by_the_command_finds_the_same(name: str) -> None:
    result = CliRunner().invoke(command, [str(file_of(name)), "--format", "json"])
    assert (result.exit_code, result.stderr.strip()) == (0, "")
    assert json.loads(result.stdout) == json.loads(render_json([reported(name)]))


@pytest.mark.parametrize("name", SHIPPED)
def test_what_is_printed_is_real_and_has_names_of_the_file(name: str) -> None:
    names = names_of_file(file_of(name).read_text(encoding="utf-8"))
    assert list(unfit(reported(name), as_object(reported(name)), names)) == []


@pytest.mark.parametrize("name", asking("motion"))
def test_the_equations_of_motion_in_json_are_those_derived(name: str) -> None:
    found = as_object(reported(name))
    for system in filter(None, [found.get("equations"), *(c.get("equations") for c in found["choices"])]):
        assert check_equations([Fragment.of(e) for e in system], reference_of(name)).verdict is Verdict.EQUIVALENT


def too_wide(found: Report, detail: Detail) -> list[str]:
    return [
        line
        for width in WIDTHS
        for line in terminal.text(found.derivation, found.notation, width, detail).splitlines()
        if cell_len(line) > width
    ]


@pytest.mark.parametrize("name", SHIPPED)
def test_no_line_is_wider_than_the_terminal(name: str) -> None:
    assert [line for detail in Detail for line in too_wide(reported(name), detail)] == []


@pytest.mark.parametrize("name", asking("motion"))
def test_by_lagranges_equations_nothing_is_undecided_or_too_wide(name: str) -> None:
    found = reported(name, Method.LAGRANGE)
    assert [str(d) for d in (*found.shortcomings, *found.notes)] == []
    assert too_wide(found, Detail.FULL) == []


def derivations(batch: int, method: Method = Method.DALEMBERT) -> dict[str, tuple[Derivation, Notation]]:
    """Those of a batch of problems, by name."""
    names = SHIPPED if method is Method.DALEMBERT else asking("motion")
    found = {name: reported(name, method) for name in names if batch_of(name) == batch}
    return {name: (r.derivation, r.notation) for name, r in found.items()}


@needs_tex
@in_batches
@pytest.mark.parametrize(
    ("method", "detail"), [*((Method.DALEMBERT, detail) for detail in Detail), (Method.LAGRANGE, Detail.FULL)]
)
def test_tex_sets_it_without_complaint(method: Method, detail: Detail, batch: int, tmp_path: Path) -> None:
    pages = derivations(batch, method)
    if faults_of_tex(latex.render([*pages.values()], detail=detail), tmp_path):
        found = {name: faults_of_tex(latex.render([page], detail=detail), tmp_path) for name, page in pages.items()}
        pytest.fail("\n".join(f"{name}: {faults}" for name, faults in found.items() if faults) or "all together")


@pytest.mark.skipif(shutil.which("pandoc") is None, reason="there is no pandoc")
@in_batches
@pytest.mark.parametrize("reader", ["markdown", "gfm+tex_math_dollars"])
def test_pandoc_has_nothing_to_say(reader: str, batch: int) -> None:
    pages = [*derivations(batch).values()]
    for detail in Detail:
        call = ["pandoc", "-f", reader, "-t", "html", "--mathml"]
        done = subprocess.run(
            call, input=markdown.render(pages, detail), capture_output=True, text=True, check=False, timeout=PATIENCE
        )
        assert done.stderr == ""


@pytest.mark.skipif(CHROMIUM is None, reason="there is no browser")
@in_batches
def test_a_browser_shows_it_whole(batch: int) -> None:
    pages = [*derivations(batch).values()]
    for found in all_measured([(html.render(pages, detail), width) for detail in Detail for width in PIXELS]):
        assert found["drawn"]
        assert found["faults"] == []
