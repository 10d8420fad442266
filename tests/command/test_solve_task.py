"""`--watch`, and what is shown while something takes long. Nothing here waits for a clock."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from lagrange import load
from lagrange.explain.report import report
from lagrange.mechanics.solution import solve
from lagsolve import solve_task
from lagsolve.output import Destination
from lagsolve.solve_task import SolveTask
from tests.support.paths import PROBLEMS
from tests.support.processes import PATIENCE, started

ONE = "title: One\nparameters: [m, g]\ncoordinates: [y]\nparticles: {P: {mass: m, position: y*j}}\ngravity: -g*j\n"
TWO = ONE.replace("One", "Two")


class Editor:
    """Does one thing after another, each while the program waits; then Ctrl-C."""

    def __init__(self, *deeds: Callable[[], object]) -> None:
        self.deeds: Iterator[Callable[[], object]] = iter(deeds)

    def __call__(self) -> None:
        deed = next(self.deeds, None)
        if deed is None:
            raise KeyboardInterrupt
        deed()


def nothing() -> None:
    """A look that finds everything as it was."""


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("a.yaml").write_text(ONE)
    return Path("a.yaml")


def watch(*problems: str, editor: Editor, output: str | None = None) -> None:
    destination = Destination.of(None, output, fragment=False, detail="brief")
    with pytest.raises(KeyboardInterrupt):
        solve_task.watch_for_ever(SolveTask(problems, None, "dalembert", destination), editor)


def saved(path: Path, text: str) -> Callable[[], object]:
    return lambda: path.write_text(text)


def renamed(path: Path, text: str) -> Callable[[], None]:
    """Saving as many editors do: another file is written and takes the name."""

    def save() -> None:
        other = path.with_suffix(".new")
        other.write_text(text)
        os.utime(other, ns=(path.stat().st_atime_ns, path.stat().st_mtime_ns))
        other.rename(path)

    return save


def seen(paths: list[Path], *deeds: Callable[[], object]) -> list[bool]:
    found = []
    with suppress(KeyboardInterrupt):
        for again in solve_task.changes(paths, Editor(*deeds)):
            found.append(again)
    return found


# When


def test_nothing_is_done_again_without_a_change(file: Path) -> None:
    assert seen([file], nothing, nothing, nothing) == [False]


@pytest.mark.parametrize("save", [saved, renamed])
def test_a_saved_file_is_a_change(save: Callable[[Path, str], Callable[[], object]], file: Path) -> None:
    assert seen([file], nothing, save(file, ONE + "\n"), nothing, nothing) == [False, True]
    assert seen([file], save(file, TWO), nothing, nothing, save(file, ONE), nothing) == [False, True, True]


def test_a_file_that_is_being_written_is_waited_for(file: Path) -> None:
    pieces = [saved(file, ""), saved(file, TWO[:20]), saved(file, TWO)]
    assert seen([file], *pieces) == [False]
    assert seen([file], *pieces, nothing, nothing) == [False, True]


def test_a_file_that_is_away_for_a_moment_is_waited_for(file: Path) -> None:
    assert seen([file], file.unlink, saved(file, TWO), nothing, nothing) == [False, True]
    assert seen([file], file.unlink, nothing, nothing, saved(file, TWO), nothing) == [False, True, True]


def test_each_of_several_files_counts(file: Path) -> None:
    other = Path("b.yaml")
    assert seen([file, other], saved(other, TWO), nothing, saved(file, TWO * 2), nothing) == [False, True, True]


def test_a_change_made_while_it_was_solving_counts(file: Path) -> None:
    found = []
    with suppress(KeyboardInterrupt):
        for again in solve_task.changes([file], Editor(nothing, nothing, nothing)):
            found.append(again)
            if len(found) == 1:
                file.write_text(TWO * 2)
    assert found == [False, True]


# What


def test_it_solves_again_and_an_error_is_no_end(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    watch("a.yaml", editor=Editor(saved(file, "title: [\n"), nothing, saved(file, TWO), nothing))
    out, said = capsys.readouterr()
    assert out.index(" One") < out.index(" Two")
    assert said.count("watching a.yaml; Ctrl-C ends it") == 3
    assert said.count("error[not-yaml]") == 1
    assert "\x1b" not in out


def test_a_file_that_is_not_there_yet(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    other = Path("new.yaml")
    watch("new.yaml", editor=Editor(nothing, lambda: file.rename(other), nothing))
    out, said = capsys.readouterr()
    assert "there is no file new.yaml" in said
    assert " One" in out


def test_it_writes_the_file_again(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    seen: list[str] = []
    look = lambda: seen.append(Path("a.md").read_text())  # noqa: E731
    watch(
        "a.yaml", editor=Editor(look, saved(file, TWO), nothing, look, saved(file, "x"), nothing, look), output="a.md"
    )
    out, said = capsys.readouterr()
    assert out == ""
    assert [text.splitlines()[0] for text in seen] == ["# One", "# Two", "# Two"]
    assert said.count("a.md is written; watching a.yaml") == 2
    assert said.count("\nwatching a.yaml") == 1


def test_what_cannot_be_written_is_no_end(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    watch("a.yaml", editor=Editor(saved(file, TWO), nothing), output="no/folder/a.md")
    assert capsys.readouterr().err.count("error[cannot-write]") == 2


def test_several_problems_and_shipped_ones(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    watch("ex05", "a.yaml", "ex05", editor=Editor(saved(file, TWO), nothing))
    out, said = capsys.readouterr()
    assert out.count("Ice skate") == 4
    assert out.index(" One") < out.index(" Two")
    assert f"watching {PROBLEMS / 'chapter6' / 'ex05-ice-skate.yaml'} a.yaml; Ctrl-C ends it" in said


def test_a_terminal_is_cleared(file: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(solve_task, "styled", lambda: True)
    watch("a.yaml", editor=Editor(saved(file, TWO), nothing))
    first, cleared, second = capsys.readouterr().out.partition("\x1b[H\x1b[2J")
    assert " One" in first
    assert cleared
    assert " Two" in second


def test_a_process_watches_until_it_is_interrupted(file: Path) -> None:
    command = [sys.executable, "-m", "lagsolve", str(file), "--watch", "--detail", "brief"]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "encoding": "utf-8"}
    with started(command, **pipes) as process:
        assert process.stderr is not None
        for line in process.stderr:
            if line.startswith("watching"):
                break
        renamed(file, TWO)()
        for line in process.stderr:
            if line.startswith("watching"):
                break
        process.send_signal(signal.SIGINT)
        out, said = process.communicate(timeout=PATIENCE)
    assert out.index(" One") < out.index(" Two")
    assert (process.returncode, said) == (130, "interrupted\n")


# What is running


def test_the_stages_are_announced_in_their_order() -> None:
    """The list that `lagsolve` shows one after the other; statics and oscillations have stages of their own."""
    stages: list[str] = []
    report(load("ex11-ideal-pendulum"), "angle", on_stage=stages.append)
    assert stages == [
        *("classifying the constraints", "displacements", "choices of coordinates", "checks", "Newton's law"),
        *("equations of motion and reactions", "checks"),
        *("equations of motion and reactions, choice angle", "checks, choice angle"),
        *("comparing answers", "explanations and pictures"),
    ]
    report(load("roberval-balance"), on_stage=stages.append)
    assert {"equilibria", "stability"} <= {*stages}
    solve(load("coupled-pendulums"), on_stage=stages.append)
    assert "small oscillations" in stages


# Ctrl-C


@pytest.mark.parametrize(
    "module", ["click", "lagsolve.command_group", "sympy.core", "lagrange.problem.loader", "lagrange.explain.report"]
)
def test_ctrl_c_during_an_import_is_no_traceback(module: str) -> None:
    program = f"""
import sys
class Interrupted:
    def find_spec(self, name, path=None, target=None):
        if name == {module!r}:
            raise KeyboardInterrupt
sys.meta_path.insert(0, Interrupted())
sys.argv = ["lagsolve", "ex05"]
from lagsolve.__main__ import run
run()
"""
    called = [sys.executable, "-c", program]
    done = subprocess.run(called, capture_output=True, text=True, check=False, timeout=PATIENCE)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "interrupted\n")
