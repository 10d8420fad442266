"""The command as a process: what it loads, terminals and pipes, interruptions, locales."""

from __future__ import annotations

import errno
import os
import pty
import re
import select
import signal
import subprocess
import sys
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

import pytest

from tests.support.processes import PATIENCE, started

LAGSOLVE = [str(Path(sys.executable).with_name("lagsolve"))]
MODULE = [sys.executable, "-m", "lagsolve"]
SKATE = "ex05"
DROPPED = ("COLUMNS", "NO_COLOR", "FORCE_COLOR", "TTY_COMPATIBLE", "LAGSOLVE_DEBUG", "LANG", "PYTHONUNBUFFERED")


def surroundings(more: Mapping[str, str] | None = None) -> dict[str, str]:
    kept = {k: v for k, v in os.environ.items() if k not in DROPPED and not k.startswith(("LC_", "PYTHON"))}
    return kept | {"TERM": "xterm-256color"} | dict(more or {})


def run(
    *arguments: str, command: list[str] = LAGSOLVE, env: Mapping[str, str] | None = None, **more: object
) -> subprocess.CompletedProcess[bytes]:
    """Runs the command, without standard input unless some is given. No run may end in a traceback."""
    options = {"stdout": subprocess.PIPE, "stdin": subprocess.DEVNULL, "stderr": subprocess.PIPE} | more
    called = [*command, *arguments]
    done = subprocess.run(called, env=surroundings(env), check=False, timeout=PATIENCE, **options)
    assert b"Traceback" not in done.stderr
    assert b"Exception ignored" not in done.stderr
    return done


@pytest.fixture(scope="module")
def skate() -> bytes:
    return run(SKATE).stdout


def test_both_ways_to_start_it(skate: bytes) -> None:
    assert skate.decode().startswith(" Ice skate ")
    assert run(SKATE, command=MODULE).stdout == skate
    assert b"Usage: lagsolve PROBLEM..." in run("-h", command=MODULE).stdout
    assert b"Usage: lagsolve PROBLEM..." in run("-h").stdout


# What is loaded

LIGHT = (
    "list list+ice list+--long -h --help --version show+ex05 grade grade+--help check+--help solve+--help help ex05+--format+docx"
    " -+--watch new+- new+-+--from+ex05 schema completion+bash"
)


LOADED_BY_SCHEMA = ("problem.keys", "problem.yaml", "problem.yaml.kinds", "core.unit_names")


@pytest.mark.parametrize("arguments", LIGHT.split())
def test_sympy_is_not_loaded_before_it_is_needed(arguments: str) -> None:
    loaded = modules(arguments.split("+"))
    assert "lagsolve.main" in loaded
    assert not loaded & {"sympy", "mpmath", "rich", "lagrange.problem.loader"}
    own = {m for m in loaded if m.partition(".")[0] == "lagrange"}
    assert arguments.startswith("new") or own <= {
        "lagrange",
        "lagrange.problem",
        "lagrange.problem.library",
        *(f"lagrange.{m}" for m in LOADED_BY_SCHEMA if arguments == "schema"),
        "lagrange.core",
        "lagrange.core.limits",
        "lagrange.core.printable",
        "lagrange.core.records",
    }


def test_help_loads_click_and_little_more() -> None:
    """Time is not measured here; what takes time is importing."""
    click = modules(None)
    more = modules(["--help"]) - click
    own = {name for name in more if name.split(".")[0] == "lagsolve"}
    assert own == {
        "lagsolve",
        *(
            f"lagsolve.{m}"
            for m in (
                "main",
                "problem_commands",
                "command_group",
                "course_commands",
                "program_commands",
                "exit_statuses",
                "limits",
            )
        ),
    }
    assert not more & {"pathlib", "dataclasses", "subprocess", "json", "yaml", "difflib", "importlib.metadata"}
    assert len(more) < 25, sorted(more)


def modules(arguments: list[str] | None) -> set[str]:
    """The modules that a run loads; without arguments, those that importing click loads."""
    call = f"sys.argv = ['lagsolve', *{arguments}]; from lagsolve.main import main; main()"
    program = f"""
import sys, click
try:
    {call if arguments is not None else "pass"}
except SystemExit:
    pass
print("MODULES", *sys.modules)
"""
    printed = subprocess.run(
        [sys.executable, "-c", program], env=surroundings(), capture_output=True, check=True, timeout=PATIENCE
    )
    return set(printed.stdout.decode().rpartition("MODULES")[2].split())


# Terminals and pipes


def test_a_pipe_gets_no_colours_unless_they_are_asked_for(skate: bytes) -> None:
    assert b"\x1b" not in skate
    assert b"\x1b[" in run(SKATE, env={"FORCE_COLOR": "1"}).stdout


COLOUR = re.compile(rb"\x1b\[[\d;]*3\d")


@pytest.mark.parametrize(
    ("env", "styled", "coloured"),
    [({}, True, True), ({"NO_COLOR": "1"}, True, False), ({"TERM": "dumb"}, False, False)],
)
def test_colours_of_a_terminal(env: dict[str, str], styled: bool, coloured: bool, skate: bytes) -> None:
    printed = on_terminal([SKATE], env)
    assert (b"\x1b[" in printed) == styled
    assert bool(COLOUR.search(printed)) == coloured
    plain = re.sub(rb"\x1b\[[\d;]*m", b"", printed).replace(b"\r\n", b"\n")
    assert plain == run(SKATE, env={"COLUMNS": "70"}).stdout != skate


def test_errors_and_json_are_not_coloured() -> None:
    assert b"\x1b" not in on_terminal(["nonsense"], {})
    assert b"\x1b" not in on_terminal([SKATE, "--format", "json"], {})


PROGRESS = re.compile(rb"\r\x1b\[K([a-z' ]+ \.\.\. \d+ s(?=\r))?")


def on_terminal(arguments: list[str], env: Mapping[str, str]) -> bytes:
    """What a run prints on a terminal 70 columns wide, without progress, of which there is some on a slow machine."""
    ours, its = pty.openpty()
    import fcntl
    import struct
    import termios

    fcntl.ioctl(its, termios.TIOCSWINSZ, struct.pack("HHHH", 40, 70, 0, 0))
    printed = b""
    with started([*LAGSOLVE, *arguments], stdin=its, stdout=its, stderr=its, env=surroundings(env)):
        os.close(its)
        while True:
            try:
                piece = os.read(ours, 4096)
            except OSError as error:
                if error.errno != errno.EIO:  # this is how Linux says that it is the end
                    raise
                piece = b""
            if not piece:
                break
            printed += piece
    os.close(ours)
    assert b"Traceback" not in printed
    return PROGRESS.sub(b"", printed)


@pytest.mark.parametrize("unbuffered", ["", "1"])
@pytest.mark.parametrize("arguments", ["ex05", "list", "check ex05", "--help", "schema", "new -", "completion fish"])
def test_a_reader_that_has_gone(arguments: str, unbuffered: str) -> None:
    """`lagsolve ... | head -1`: a status of its own, since 1 says that an answer is wrong."""
    read, write = os.pipe()
    os.close(read)
    done = run(*arguments.split(), stdout=write, env={"PYTHONUNBUFFERED": unbuffered})
    os.close(write)
    assert done.stderr == b""
    assert done.returncode == 141


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
@pytest.mark.parametrize("unbuffered", ["", "1"])
@pytest.mark.parametrize("arguments", ["ex05", "list", "ex05 -o /dev/full --format latex"])
def test_a_full_disk(arguments: str, unbuffered: str) -> None:
    with open("/dev/full", "wb") as full:
        done = run(*arguments.split(), stdout=full, env={"PYTHONUNBUFFERED": unbuffered})
    assert done.returncode == 2
    assert b"error[cannot-write]" in done.stderr
    assert b"No space left on device" in done.stderr


@pytest.mark.parametrize(
    ("call", "said"),
    [("ex05 >&-", b"standard output cannot be written: it is closed"), ("- <&-", b"standard input is closed")],
)
def test_closed_streams(call: str, said: bytes) -> None:
    done = run(f'"$0" {call}', LAGSOLVE[0], command=["sh", "-c"], stdin=None)
    assert done.returncode == 2
    assert said in done.stderr


def test_an_interruption() -> None:
    """SIGINT while the program waits for a problem."""
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    with suppress(BlockingIOError):
        while True:
            os.write(writer, b"#" * 4096)  # until the pipe is full
    pipes = {"stdin": reader, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with started([*LAGSOLVE, "-"], env=surroundings(), **pipes) as process:
        select.select([], [writer], [], PATIENCE)  # until the program reads
        time.sleep(0.5)  # until it waits for more: Python sees no signal that comes just before it begins to wait
        process.send_signal(signal.SIGINT)
        printed, said = process.communicate(timeout=PATIENCE)
    os.close(reader)
    os.close(writer)
    assert (process.returncode, printed, said) == (130, b"", b"interrupted\n")


# Locales

ASCII = {"PYTHONIOENCODING": "ascii"}
C = {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}


@pytest.mark.parametrize("env", [ASCII, C, {"PYTHONIOENCODING": "latin-1"}])
def test_output_is_utf8_in_every_locale(env: dict[str, str], skate: bytes, tmp_path: Path) -> None:
    assert run(SKATE, env=env).stdout == skate
    file = tmp_path / "output.txt"
    assert run(SKATE, "-o", str(file), env=env).returncode == 0
    assert file.read_bytes() == skate
    greek = run("-", env=env, stdin=None, input="title: θ\ncoordinates: [θθ, x]\nconstraints: {a: ω = 0}\n".encode())
    assert greek.returncode == 2
    assert "ω".encode() in greek.stderr


@pytest.mark.parametrize("env", [{}, C])
def test_names_of_files_that_are_no_text(env: dict[str, str], tmp_path: Path) -> None:
    if sys.platform == "darwin":
        pytest.skip("such names are not allowed there")
    name = os.fsdecode(os.fsencode(tmp_path) + b"/\xff\xc3\xa9.yaml")
    absent = run(name, env=env)
    assert (absent.returncode, absent.stdout) == (2, b"")
    assert b"there is no file" in absent.stderr
    Path(name).write_text("title: Nothing\ncoordinates: [x]\n", encoding="utf-8")
    assert b"Nothing" in run(name, env=env).stdout
