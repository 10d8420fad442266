"""Documents compiled by a real TeX."""

import shutil
import subprocess

import pytest

from tests.support.processes import PATIENCE

needs_tex = pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")


def compiled(text, folder):
    """The log of two runs."""
    (folder / "a.tex").write_text(text, encoding="utf-8")
    for _ in range(2):
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
        run = subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=PATIENCE)
        log = run.stdout.decode("latin-1")
        assert run.returncode == 0, log[-2000:]
    return log
