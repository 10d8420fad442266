"""Markdown for MyST and Quarto: every reference has its label, every label is given once, pandoc reads every formula."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

from lagrange.document.derivation import Derivation, Detail
from lagrange.render import markdown
from lagrange.render.flavours import Flavour, Labels
from lagrange.render.svg import Figures
from tests.support.processes import PATIENCE
from tests.support.sample_derivations import pendulum
from tests.support.shared import reported

LABELLED = (Flavour.MYST, Flavour.QUARTO)
GIVEN = {Flavour.MYST: r"^\$\$ \((\S+)\)$", Flavour.QUARTO: r"^\$\$ \{#eq-(\S+)\}$"}
USED = {Flavour.MYST: r"\{eq\}`(\S+?)`", Flavour.QUARTO: r"\(\[-@eq-([\w-]+)\]\)"}


def page(flavour: Flavour, name: str = "ex11-ideal-pendulum") -> tuple[str, Figures]:
    found, figures = reported(name), Figures("page")
    text = markdown.render([(found.derivation, found.notation)], flavour=flavour, figures=figures)
    return text, figures


@pytest.mark.parametrize("flavour", LABELLED)
@pytest.mark.parametrize("name", ["ex11-ideal-pendulum", "ex06-two-particle-skate", "leaving-a-sphere"])
def test_every_reference_has_its_label(flavour: Flavour, name: str) -> None:
    text, _ = page(flavour, name)
    given, used = (re.findall(pattern[flavour], text, re.MULTILINE) for pattern in (GIVEN, USED))
    assert len(given) > 5
    assert len(used) > 3
    assert len(set(given)) == len(given)
    assert set(used) <= set(given)
    assert all(re.fullmatch("[a-z0-9-]+", label) for label in given)
    assert r"\qquad (" not in text


def test_as_many_labels_as_numbers() -> None:
    plain, _ = page(Flavour.GITHUB)
    numbers = re.findall(r"\\qquad \((\d+)\)", plain)
    assert numbers == [str(n + 1) for n in range(len(numbers))]
    for flavour in LABELLED:
        assert len(re.findall(GIVEN[flavour], page(flavour)[0], re.MULTILINE)) == len(numbers)


def test_names_that_differ_in_case_have_different_labels() -> None:
    labels = Labels("p", {})
    assert [labels.of(x) for x in ("rod-A", "rod-a", "rod_a", "rod-A")] == [
        "p-rod-a",
        "p-rod-a-2",
        "p-rod-a-3",
        "p-rod-a",
    ]


@pytest.mark.parametrize("flavour", Flavour)
def test_figures_are_beside_the_page(flavour: Flavour) -> None:
    text, figures = page(flavour)
    assert [*figures.files] == ["page.svg", "page-2.svg", "page-3.svg"]
    start = {Flavour.MYST: "```{figure} ", Flavour.QUARTO: "](", Flavour.GITHUB: "]("}[flavour]
    assert [text.count(f"{start}{name}") for name in figures.files] == [1, 1, 1]


@pytest.mark.parametrize("flavour", Flavour)
def test_without_files_there_are_no_figures(flavour: Flavour) -> None:
    found = reported("ex11-ideal-pendulum")
    text = markdown.render([(found.derivation, found.notation)], flavour=flavour)
    assert ".svg" not in text


def test_what_is_folded() -> None:
    """The other coordinates of Ex. 11: a fence of MyST has shorter ones inside, a callout of Quarto has its title."""
    myst, quarto = (page(flavour)[0] for flavour in LABELLED)
    assert re.search(r"^````\{admonition\} Other coordinate.*\n:class: dropdown$", myst, re.MULTILINE)
    assert myst.count("\n````\n") == 1
    assert re.search(r'^::: \{\.callout-note collapse="true"\}\n## Other coordinate', quarto, re.MULTILINE)
    assert "<details>" not in myst + quarto


HOSTILE = "{{< include /etc/passwd >}} {eq}`x` @eq-x ::: {.x} {{ y }} [z](javascript:1) <b>"


@pytest.mark.parametrize("flavour", Flavour)
def test_no_text_is_a_command(flavour: Flavour) -> None:
    """Shortcodes, roles, citations, substitutions and fences are text."""
    derivation, notation = pendulum()
    text = markdown.render([(Derivation(HOSTILE, HOSTILE, derivation.steps), notation)], Detail.FULL, flavour=flavour)
    head = text.split("\n\n")[0:2]
    for line in head:
        assert not re.search(r"(?<!\\)[{}@`<]", line), line


@pytest.mark.parametrize("opening", ["::: {.x}", "% gone", "+++", "---", "--- x"])
def test_a_paragraph_opens_no_block(opening: str) -> None:
    assert markdown._OPENING.sub(r"\1\\\2", opening) == f"\\{opening}"


@pytest.mark.skipif(shutil.which("pandoc") is None, reason="there is no pandoc")
@pytest.mark.parametrize("flavour", LABELLED)
def test_pandoc_reads_every_formula(flavour: Flavour) -> None:
    """Pandoc knows the divs of Quarto, but not the fences of MyST, which are taken away before."""
    text, _ = page(flavour)
    text = re.sub(r"^```\{figure\}.*?^```$|^````.*?$|^:class: .*?$", "", text, flags=re.MULTILINE | re.DOTALL)
    done = subprocess.run(
        ["pandoc", "-f", "markdown", "-t", "html", "--mathml"],
        input=text, capture_output=True, text=True, timeout=PATIENCE, check=True,
    )  # fmt: skip
    assert done.stderr == ""
    assert done.stdout.count('display="block"') == len(re.findall(r"^\$\$", text, re.MULTILINE)) // 2
