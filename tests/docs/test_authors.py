"""docs/authors.md is true: its commands run, its document compiles with two fragments in it, its Makefile builds it."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner

from lagrange.explain.report import report
from lagrange.problem.model import Problem
from lagsolve.main import main
from tests.docs.test_readme import BEAD
from tests.support.paths import ROOT
from tests.support.processes import PATIENCE

PAGE = (ROOT / "docs" / "authors.md").read_text(encoding="utf-8")


def blocks(kind: str) -> list[str]:
    return re.findall(rf"^```{kind}\n(.*?)^```", PAGE, re.DOTALL | re.MULTILINE)


COMMANDS = [re.split(r"\s+# ", line)[0] for text in blocks("sh") for line in text.splitlines()]
[DOCUMENT] = blocks("latex")
[MAKEFILE] = blocks("make")
PDFLATEX, MAKE = shutil.which("pdflatex"), shutil.which("make")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("bead.yaml").write_text(BEAD, encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_run(command: str, folder: Path) -> None:
    result = CliRunner().invoke(main, shlex.split(command)[1:])
    assert (result.exit_code, result.output) == (0, "")
    [written] = re.findall(r"-o (\S+)", command)
    assert (folder / written).read_text(encoding="utf-8")


@pytest.mark.usefixtures("folder")
def test_its_labels_are_there() -> None:
    for name in ("bead.tex", "pendulum.tex"):
        [command] = [c for c in COMMANDS if c.endswith(f"-o {name}")]
        CliRunner().invoke(main, shlex.split(command)[1:])
    written = Path("bead.tex").read_text(encoding="utf-8") + Path("pendulum.tex").read_text(encoding="utf-8")
    for label in re.findall(r"\\eqref\{(.*?)\}", DOCUMENT):
        assert rf"\label{{{label}}}" in written
    needed = set(re.findall(r"\\use(?:package|tikzlibrary)\{[^}]*\}", written))
    assert needed
    assert all(n in DOCUMENT for n in needed)


@pytest.mark.skipif(not (PDFLATEX and MAKE), reason="pdflatex and make are needed")
def test_the_makefile_builds_the_document(folder: Path) -> None:
    Path("notes.tex").write_text(DOCUMENT, encoding="utf-8")
    Path("Makefile").write_text(MAKEFILE, encoding="utf-8")
    paths = os.pathsep.join([str(ROOT), str(ROOT / "cli")])
    command = [str(MAKE), f"LAGSOLVE={sys.executable} -m lagsolve"]
    done = subprocess.run(
        command, env={**os.environ, "PYTHONPATH": paths}, capture_output=True, text=True, check=False, timeout=PATIENCE
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    log = (folder / "notes.log").read_text(encoding="utf-8", errors="replace")
    assert not re.findall(r"^(?:Overfull.*|LaTeX Warning: .*(?:undefined|multiply).*|! .*)$", log, re.MULTILINE)
    again = subprocess.run([*command, "-q"], check=False, timeout=PATIENCE)
    assert again.returncode == 0


def test_the_example_of_notation_solves(problem: Callable[[str], Problem]) -> None:
    [text] = blocks("yaml")
    found = report(problem(text))
    assert found.holds
    [reaction] = found.solution.law.newton.reactions  # type: ignore[union-attr]
    assert str(reaction.symbol) == "N"


def test_links_lead_somewhere() -> None:
    for target in re.findall(r"\]\(([^)#]+)\)", PAGE):
        assert target.startswith("https://") or (ROOT / "docs" / target).exists(), target
