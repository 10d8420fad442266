"""Documents compiled by a real TeX."""

import re
import shutil
import subprocess

import pytest

from tests.support.processes import PATIENCE

needs_tex = pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
FAULT = re.compile(r"^(Overfull \\hbox.*|LaTeX Warning: .*(?:undefined|multiply).*|! .*)$", re.MULTILINE)


def faults_of_tex(document, folder):
    """What TeX complains about in the second run: errors, overfull boxes, undefined and repeated labels."""
    (folder / "a.tex").write_text(document, encoding="utf-8")
    command = ["pdflatex", "-draftmode", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
    for _ in range(2):
        done = subprocess.run(
            command, cwd=folder, capture_output=True, stdin=subprocess.DEVNULL, check=False, timeout=PATIENCE
        )
    faults = FAULT.findall((folder / "a.log").read_text(encoding="latin-1"))
    return faults or [f"exit status {done.returncode}"] * bool(done.returncode)


def compiled(text, folder):
    """The log of two runs."""
    (folder / "a.tex").write_text(text, encoding="utf-8")
    for _ in range(2):
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
        run = subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=PATIENCE)
        log = run.stdout.decode("latin-1")
        assert run.returncode == 0, log[-2000:]
    return log
