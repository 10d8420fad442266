"""Worksheets as blocks of MyST and Quarto: closed, without headings inside, the solution bound to its exercise."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

from lagrange.explain.page.worksheets import worked_solution, worksheet
from lagrange.render.notes import exercises
from lagrange.render.notes.flavours import Flavour
from lagrange.render.notes.svg_file import Figures
from lagrange.render.tex_layout import Vectors
from tests.support.processes import PATIENCE
from tests.support.shared import reported


def text(flavour: Flavour, *, exercise: bool = True, solution: bool = True, figures: Figures | None = None) -> str:
    found = reported("ex11-ideal-pendulum", complete=False)
    both = found.solution, found.derivation
    sheet = exercises.Sheet(
        worksheet(*both) if exercise else None, worked_solution(*both) if solution else None, found.notation
    )
    return exercises.render([sheet, sheet], Vectors.BOLD, flavour, figures)


def test_myst() -> None:
    figures = Figures("page")
    page = text(Flavour.MYST, figures=figures)
    assert re.findall(r"^`{5}\{(\w+)\} (.*)\n:label: (.*)$", page, re.MULTILINE) == [
        ("exercise", "Ideal pendulum", "ideal-pendulum"),
        ("solution", "ideal-pendulum", "ideal-pendulum-solution"),
        ("exercise", "Ideal pendulum", "ideal-pendulum-2"),
        ("solution", "ideal-pendulum-2", "ideal-pendulum-2-solution"),
    ]
    assert len(re.findall("^`{5}$", page, re.MULTILINE)) == 4
    assert not re.search("^#", page, re.MULTILINE)
    labels = re.findall(r"^\$\$ \((\S+)\)$", page, re.MULTILINE)
    assert len(set(labels)) == len(labels) > 20
    assert set(re.findall(r"\{eq\}`(\S+?)`", page)) <= set(labels)
    assert [*figures.files] == ["page.svg", "page-2.svg", "page-3.svg"]


def test_parts_have_the_same_numbers() -> None:
    sheet, solution = (
        re.findall(r"^\*\*\d+.*\*\*$", text(Flavour.MYST, exercise=e, solution=not e), re.MULTILINE)
        for e in (True, False)
    )
    assert sheet == solution
    assert sheet[0] == r"**1\. The constraint and the degrees of freedom**"


def test_quarto() -> None:
    page = text(Flavour.QUARTO)
    assert page.count(":::: {#exr-ideal-pendulum}\n\n## Ideal pendulum\n") == 1
    assert page.count(":::: {.solution}\n") == 2
    assert len(re.findall("^::::$", page, re.MULTILINE)) == 4
    assert len(re.findall("^#", page, re.MULTILINE)) == 2


@pytest.mark.skipif(shutil.which("pandoc") is None, reason="there is no pandoc")
def test_pandoc_sees_the_divs() -> None:
    done = subprocess.run(
        ["pandoc", "-f", "markdown", "-t", "html", "--mathml"],
        input=text(Flavour.QUARTO), capture_output=True, text=True, timeout=PATIENCE, check=True,
    )  # fmt: skip
    assert done.stderr == ""
    assert done.stdout.count('<div class="solution">') == 2
    assert 'id="exr-ideal-pendulum-2"' in done.stdout
