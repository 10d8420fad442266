"""Worksheets, talks, and Markdown with figures, as the command writes them."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.command.test_main import run
from tests.support.tex import faults_of_tex, needs_tex

OSCILLATOR = """\
title: Oscillator
parameters: [m, k]
coordinates: [x]
particles: {P: {mass: m, position: x*e_x}}
forces: {spring: {spring: k, between: [P, 0*e_x], length: 0}}
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "o.yaml").write_text(OSCILLATOR, encoding="utf-8")
    return tmp_path


def test_figures_are_written_beside_the_page(folder: Path) -> None:
    result = run("o.yaml", "-o", "page.md")
    assert (result.exit_code, result.output) == (0, "")
    assert "](page.svg)" in (folder / "page.md").read_text(encoding="utf-8")
    assert "<svg" in (folder / "page.svg").read_text(encoding="utf-8")
    assert run("o.yaml", "-o", "page.md").exit_code == 0  # its own figures are replaced


def test_a_foreign_picture_is_not_overwritten(folder: Path) -> None:
    (folder / "page.svg").write_text("<svg>mine</svg>", encoding="utf-8")
    result = run("o.yaml", "-o", "page.md")
    assert result.exit_code == 2
    assert "page.svg would be overwritten" in result.stderr
    assert (folder / "page.svg").read_text(encoding="utf-8") == "<svg>mine</svg>"
    assert not (folder / "page.md").exists()


@pytest.mark.usefixtures("folder")
def test_standard_output_has_no_figures() -> None:
    assert ".svg" not in run("o.yaml", "--format", "markdown").stdout


@pytest.mark.usefixtures("folder")
def test_worksheets_in_every_format() -> None:
    for options, begins in (
        ((), " Oscillator"),
        (("--format", "markdown"), "# Oscillator"),
        (("--for", "myst"), "`````{exercise} Oscillator"),
        (("--for", "quarto"), ":::: {#exr-oscillator}"),
        (("--format", "html"), "<!DOCTYPE html>"),
        (("--fragment",), "% lagsolve: needs"),
    ):
        result = run("o.yaml", "--worksheet", *options)
        assert result.exit_code == 0, result.stderr
        assert result.stdout.startswith(begins)
        assert "how many degrees of freedom has the system" in result.stdout.lower()
        assert "solution" not in result.stdout


@pytest.mark.usefixtures("folder")
def test_the_solution_alone_and_after_the_sheet() -> None:
    alone, after = (run("o.yaml", *options).stdout for options in (("--solution",), ("--worksheet", "--solution")))
    assert alone.startswith(" Oscillator: solution")
    assert after.endswith(alone)


@needs_tex
def test_a_sheet_with_its_solution_compiles(folder: Path) -> None:
    assert run("o.yaml", "ex11", "--worksheet", "--solution", "-o", "s.tex").exit_code == 0
    text = (folder / "s.tex").read_text(encoding="utf-8")
    assert text.count(r"\clearpage") == 3
    assert faults_of_tex(text, folder) == []


@pytest.mark.usefixtures("folder")
def test_a_talk() -> None:
    assert run("o.yaml", "--beamer").stdout.startswith(r"\documentclass[10pt,aspectratio=169]{beamer}")
    assert r"\documentclass[" not in run("o.yaml", "--beamer", "--fragment").stdout.split("\n", 3)[3]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--beamer", "--format", "html"), "--beamer goes with --format latex"),
        (("--for", "myst", "--format", "latex"), "--for myst goes with --format markdown"),
        (("--worksheet", "--format", "json"), "JSON has all of it"),
        (("--solution", "--detail", "full"), "--detail full does not go with"),
    ],
)
@pytest.mark.usefixtures("folder")
def test_options_that_contradict_one_another(options: tuple[str, ...], said: str) -> None:
    result = run("o.yaml", *options)
    assert result.exit_code == 2
    assert said in " ".join(result.stderr.split())
