"""Every shipped problem in every format (`make sweep`), those of motion by Lagrange's equations too.

The command is run for the JSON: exit status 0, nothing said, every equation in it read back, those of motion found
equivalent. Then the terminal at three widths, where no line may be wider, and LaTeX, which is compiled where there is a
pdflatex: errors, overfull boxes and undefined references are failures. Markdown is read by pandoc, where a warning is a
failure, and the problems on one web page are opened in a browser, at a phone's and a desk's width. Several processes share
the problems. Seconds are those of the run of the command, with SymPy and the program imported before.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

from click.testing import CliRunner
from rich.cells import cell_len

from lagrange.answers.equations import Verdict, check_equations
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.document.derivation import Derivation, Detail
from lagrange.document.notation import Notation
from lagrange.explain.report import Report, report
from lagrange.expressions.reader import read_equation
from lagrange.mechanics.dynamics.motion import Method
from lagrange.problem import library
from lagrange.problem.loader import load
from lagrange.problem.model import Find
from lagrange.render import html, latex, markdown, terminal
from lagrange.render import json as json_format
from lagsolve.main import main as command
from tests.support.browser import CHROMIUM, measured
from tests.support.processes import PATIENCE

WIDTHS = (60, 80, 120)
MOST_PARTS = 4
"""Processes that share the problems."""
TOGETHER = 20
"""Derivations in one LaTeX document: TeX takes longer over its packages than over most of them."""
BAD_TEX = re.compile(r"^(Overfull \\hbox.*|LaTeX Warning: .*(?:undefined|multiply).*|! .*)$", re.MULTILINE)
Document = tuple[Derivation, Notation, Detail]
EQUATIONS = ("equation", "equations", "possible_displacements", "virtual_displacements", "newton", "equilibrium")


@dataclass
class Tally:
    """What passed and what did not, in the order in which it was tried."""

    failures: list[str] = field(default_factory=list)
    passed: int = 0

    def add(self, what: str, faults: list[str]) -> None:
        """One thing tried, with what is wrong with it."""
        if faults:
            self.failures.append(what)
            print(f"FAILED {what}", *(f"    {f}" for f in faults), sep="\n", flush=True)
        else:
            self.passed += 1

    def attempt(self, what: str, check: Callable[[], list[str]]) -> None:
        """The same, where trying may itself fail."""
        try:
            self.add(what, check())
        except Exception as error:
            self.add(what, [f"{type(error).__name__}: {error}"])


def main() -> int:
    """Runs the sweep; the exit status."""
    print(f"{'problem':44}{'seconds':>8}", flush=True)
    names = list(library.entries())
    parts = min(os.cpu_count() or 1, MOST_PARTS)
    with ProcessPoolExecutor(parts) as pool:
        tallies = list(pool.map(swept, [names[k::parts] for k in range(parts)]))
    failures = [failure for tally in tallies for failure in tally.failures]
    for failure in failures:
        print(f"FAILED {failure}")
    print(f"{sum(tally.passed for tally in tallies)} passed, {len(failures)} failed")
    return bool(failures)


def swept(names: Sequence[str]) -> Tally:
    """Some of the problems."""
    tally = Tally()
    documents: dict[str, Document] = {}
    derivations: list[tuple[Derivation, Notation]] = []
    for name in names:
        path = library.entries()[name]
        started = time.perf_counter()
        result = CliRunner().invoke(command, [str(path), "--format", "json"])
        print(f"{name:44}{time.perf_counter() - started:8.2f}", flush=True)
        tally.add(f"{name}: exit status", faults_of_run(result.exit_code, result.stderr))
        try:
            found = report(load(path))
        except Exception as error:
            tally.add(f"{name}: solve", [f"{type(error).__name__}: {error}"])
            continue
        derivations.append((found.derivation, found.notation))
        tally.attempt(f"{name}: pages", lambda f=found, n=name: rendered(n, f, documents, tally))
        tally.attempt(f"{name}: json", lambda r=result, f=found: faults_of_json(json.loads(r.stdout), f))
        if Find.MOTION in found.solution.problem.find:
            tally.attempt(f"{name}: by Lagrange", lambda p=path, n=name: by_lagrange(n, p, documents, tally))
    compile_all(documents, tally)
    read_all(derivations, tally)
    open_all(derivations, tally)
    return tally


def faults_of_run(status: int, said: str) -> list[str]:
    """What is wrong with how the command ended."""
    return [f"exit status {status}"] * bool(status) + [said.strip()] * bool(said.strip())


def rendered(name: str, found: Report, documents: dict[str, Document], tally: Tally) -> list[str]:
    """Renders a problem in every format that is not for many at once."""
    for detail in Detail:
        for width in WIDTHS:
            text = terminal.text(found.derivation, found.notation, width, detail)
            wide = [line for line in text.splitlines() if cell_len(line) > width]
            tally.add(f"{name}: terminal, {width} columns, {detail.name.lower()}", wide)
        documents[f"{name}, {detail.name.lower()}"] = (found.derivation, found.notation, detail)
    return []


def by_lagrange(name: str, path: Path, documents: dict[str, Document], tally: Tally) -> list[str]:
    """The same by Lagrange's equations, with everything that is shown at full detail."""
    found = report(load(path), method=Method.LAGRANGE)
    reference = reference_of_solution(found.solution)
    result = json.loads(json_format.render([found]))
    tally.add(f"{name}: by Lagrange, json", [f for text in equations_in(result) for f in unreadable(text, reference)])
    for width in WIDTHS:
        text = terminal.text(found.derivation, found.notation, width, Detail.FULL)
        wide = [line for line in text.splitlines() if cell_len(line) > width]
        tally.add(f"{name}: by Lagrange, terminal, {width} columns", wide)
    documents[f"{name}, by Lagrange"] = (found.derivation, found.notation, Detail.FULL)
    return [str(d) for d in (*found.shortcomings, *found.notes)]


# JSON


def faults_of_json(found: dict[str, Any], result: Report) -> list[str]:
    """Equations that cannot be read back, and equations of motion that say something else than those they stand for."""
    reference = reference_of_solution(result.solution)
    faults = [fault for text in equations_in(found) for fault in unreadable(text, reference)]
    systems = [found.get("equations"), *(c.get("equations") for c in found["choices"])]
    for system in filter(None, systems):
        verdict = check_equations([Fragment.of(e) for e in system], reference).verdict
        if verdict is not Verdict.EQUIVALENT:
            faults.append(f"read back, they are {verdict}: {'; '.join(system)}")
    if found != json.loads(json_format.render([result])):
        faults.append("another run gives another result")
    return faults


def equations_in(found: Any) -> Iterator[str]:
    """The equations of a JSON object, wherever in it they are."""
    if isinstance(found, dict):
        for key, value in found.items():
            if key == "steps":
                yield from (e["text"] for s in value for b in s["body"] for e in b.get("equations", ()) if "text" in e)
            elif key in EQUATIONS and not isinstance(value, int):  # the count of unknowns has a number
                yield from texts(value)
            else:
                yield from equations_in(value)
    elif isinstance(found, list):
        for item in found:
            yield from equations_in(item)


def texts(value: Any) -> Iterator[str]:
    """A text, or those in lists of lists of them."""
    if isinstance(value, str):
        yield value
    else:
        for item in value:
            yield from texts(item)


def unreadable(text: str, reference: Reference) -> list[str]:
    """Why an equation cannot be read back, if so. One with several signs = is read as one for each."""
    sides = text.split(" = ")
    faults = []
    for left, right in pairwise(sides):
        try:
            read_equation(Fragment.of(f"{left} = {right}"), reference.scope)
        except ProblemError as error:
            faults.append(f"cannot be read back: {text}: {error}")
    return faults


# LaTeX


def compile_all(documents: dict[str, Document], tally: Tally) -> None:
    """Compiles the documents, many as one; where TeX complains, each by itself, so that it is named."""
    if shutil.which("pdflatex") is None:
        print(f"SKIPPED: there is no pdflatex, so {len(documents)} LaTeX documents are not compiled")
        return
    for detail in Detail:
        these = [name for name, (*_, d) in documents.items() if d is detail]
        for names in (these[k : k + TOGETHER] for k in range(0, len(these), TOGETHER)):
            together = [documents[name][:2] for name in names]
            faults = faults_of_tex(latex.render(together, detail=detail))
            for name, page in zip(names, together, strict=True):
                tally.add(f"{name}: pdflatex", faults and faults_of_tex(latex.render([page], detail=detail)))
            if len(names) > 1:
                tally.add(f"{names[0]} to {names[-1]}: pdflatex", faults)


def faults_of_tex(document: str) -> list[str]:
    """What TeX complains about in the second run."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "a.tex").write_text(document, encoding="utf-8")
        for _ in range(2):
            call = ["pdflatex", "-draftmode", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
            done = subprocess.run(
                call, cwd=folder, capture_output=True, stdin=subprocess.DEVNULL, check=False, timeout=PATIENCE
            )
        log = Path(folder, "a.log").read_text(encoding="latin-1")
        faults = BAD_TEX.findall(log)
        return faults or [f"exit status {done.returncode}"] * bool(done.returncode)


# Markdown and HTML


def read_all(derivations: Sequence[tuple[Derivation, Notation]], tally: Tally) -> None:
    """All problems in Markdown, read by pandoc as its own and as GitHub's."""
    if shutil.which("pandoc") is None:
        print("SKIPPED: there is no pandoc, so no Markdown is read")
        return
    for detail in Detail:
        text = markdown.render(derivations, detail)
        for reader in ("markdown", "gfm+tex_math_dollars"):
            call = ["pandoc", "-f", reader, "-t", "html", "--mathml"]
            done = subprocess.run(call, input=text, capture_output=True, text=True, check=False, timeout=PATIENCE)
            tally.add(f"pandoc, {reader}, {detail.name.lower()}", done.stderr.splitlines())


def open_all(derivations: Sequence[tuple[Derivation, Notation]], tally: Tally) -> None:
    """All problems on one page, in a browser."""
    if CHROMIUM is None:
        print("SKIPPED: there is no browser, so no web page is opened")
        return
    for detail in Detail:
        page = html.render(derivations, detail)
        for width in (360, 1280):
            found = measured(page, width)
            faults = found["faults"] if found["drawn"] else ["nothing is drawn"]
            tally.add(f"browser, {width} pixels, {detail.name.lower()}", faults)


if __name__ == "__main__":
    sys.exit(main())
