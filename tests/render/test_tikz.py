"""Drawings in LaTeX, compiled by a real TeX."""

from __future__ import annotations

import shutil
import subprocess

import pytest

from lagrange.render import latex
from tests.support.drawings import DRAWN
from tests.support.processes import PATIENCE
from tests.support.shared import reported


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="there is no pdflatex")
def test_pictures_compile(tmp_path) -> None:
    document = latex.render([(reported(n).derivation, reported(n).notation) for n in DRAWN])
    (tmp_path / "a.tex").write_text(document, encoding="utf-8")
    call = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
    done = subprocess.run(
        call, cwd=tmp_path, capture_output=True, stdin=subprocess.DEVNULL, check=False, timeout=PATIENCE
    )
    assert done.returncode == 0
    assert "Overfull" not in (tmp_path / "a.log").read_text(encoding="latin-1")
