"""Documents compiled by a real TeX."""

import re
import shutil
import subprocess
from collections import Counter

import pytest

from tests.support.processes import PATIENCE

needs_tex = pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
FAULT = re.compile(r"^(Overfull \\hbox.*|! .*)$", re.MULTILINE)


def faults_of_tex(document, folder):
    """What TeX complains about, errors and overfull boxes, and what a second run would: undefined and repeated labels."""
    (folder / "a.tex").write_text(document, encoding="utf-8")
    command = ["pdflatex", "-draftmode", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
    done = subprocess.run(
        command, cwd=folder, capture_output=True, stdin=subprocess.DEVNULL, check=False, timeout=PATIENCE
    )
    faults = FAULT.findall((folder / "a.log").read_text(encoding="latin-1")) + faults_of_labels(document)
    return faults or [f"exit status {done.returncode}"] * bool(done.returncode)


def faults_of_labels(document):
    """Duplicate labels, and references to missing ones."""
    labels = Counter(re.findall(r"\\label\{([^}]*)\}", document))
    references = re.findall(r"\\(?:eq|auto|page)?ref\{([^}]*)\}", document)
    repeated = [f"label {name} repeated" for name, times in labels.items() if times > 1]
    return repeated + [f"label {name} undefined" for name in references if name not in labels]


def compiled(text, folder):
    """The log of two runs."""
    (folder / "a.tex").write_text(text, encoding="utf-8")
    for _ in range(2):
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
        run = subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=PATIENCE)
        log = run.stdout.decode("latin-1")
        assert run.returncode == 0, log[-2000:]
    return log
