"""`lagsolve grade` as a command: a batch with everything in it, interruptions, processes that are killed, a cluster."""

from __future__ import annotations

import csv
import importlib.util
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager, ExitStack, contextmanager
from pathlib import Path

import pytest

from lagrange.answers.submissions import Submission
from lagrange.core.diagnostics import Source
from lagsolve.grading.examine import examine, outcomes
from lagsolve.grading.run import Progress
from tests.command.test_main import run
from tests.support import grading_calls
from tests.support.paths import PROBLEMS, ROOT
from tests.support.processes import PATIENCE, started

RIGHT, WRONG = "theta'' + g/l*sin(theta) = 0\n", "theta'' = 0\n"
PENDULUM = "ex11-ideal-pendulum"

pytestmark = pytest.mark.skipif(os.name != "posix", reason="limits and signals are those of POSIX")


@pytest.fixture
def answers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder of submissions in the current folder."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "answers").mkdir()
    return tmp_path / "answers"


@pytest.fixture
def trouble(monkeypatch: pytest.MonkeyPatch) -> None:
    """Submissions that say LOOP, EAT, KILL or FAIL get what they want."""
    monkeypatch.setattr("lagsolve.grading.run.examine", grading_calls.examine)


def rows(file: str | Path = "marks.csv") -> dict[str, dict[str, str]]:
    with Path(file).open(encoding="utf-8", newline="") as text:
        return {r["submission"]: r for r in csv.DictReader(text)}


@pytest.mark.usefixtures("trouble")
def test_nothing_that_happens_to_one_submission_stops_the_batch(answers: Path) -> None:
    for n in range(4):
        (answers / f"right{n}.txt").write_text(RIGHT)
    for word in ("LOOP", "EAT", "KILL", "FAIL"):
        (answers / f"{word.lower()}.txt").write_text(word)
    (answers / "once.txt").write_text(f"ONCE {answers.parent / 'mark'}")
    (answers / "wrong.txt").write_text(WRONG)
    (answers / "binary.txt").write_bytes(bytes(range(256)) * 100)
    with (answers / "large.txt").open("wb") as file:
        file.truncate(50 << 20)
    (answers / "link.txt").symlink_to("/etc/passwd")
    (answers / "=1+1.txt").write_text(RIGHT)
    result = run("grade", PENDULUM, "answers", "--csv", "marks.csv", "--feedback", "pages", *LIMITS)
    assert result.exit_code == 3
    found = rows()
    assert {name: r["verdict"] for name, r in found.items()} == {
        **{f"right{n}.txt": "equivalent" for n in range(4)},
        **dict.fromkeys(("loop.txt", "eat.txt", "kill.txt", "fail.txt"), "undecided"),
        **dict.fromkeys(("binary.txt", "large.txt", "link.txt"), "unreadable"),
        "'=1+1.txt": "equivalent",
        "once.txt": "equivalent",
        "wrong.txt": "wrong",
    }
    assert found["loop.txt"]["remark"] == "it takes longer than 10 s"
    assert found["eat.txt"]["remark"] == "it needs more than 512 MB of memory"
    assert "signal 9" in found["kill.txt"]["remark"]
    assert "ValueError: a mistake" in found["fail.txt"]["remark"]
    assert "50" not in found["right0.txt"]["remark"]
    assert result.stdout.splitlines()[-1] == ("14 submissions: 6 equivalent, 1 wrong, 3 unreadable, 4 undecided")
    assert sorted(p.name for p in Path("pages").iterdir()) == sorted(r["feedback"] for r in found.values())
    assert not Path("marks.csv.journal").exists()
    assert "**Wrong**" in Path("pages/wrong.txt.md").read_text()


LIMITS = ("--jobs", "2", "--timeout", "10", "--memory", "512")


def test_every_verdict_is_a_complete_batch(answers: Path) -> None:
    for name, text in {"a": RIGHT, "b": WRONG, "c": "0 = 0", "d": "x = = 1", "e": "x^2 + y^2 = l^2"}.items():
        (answers / name).write_text(text)
    result = run("grade", PENDULUM, "answers", "--jobs", "1", env={"COLUMNS": "120"})
    assert (result.exit_code, messages(result.stderr.encode())) == (0, "")
    rows = [line for line in result.stdout.splitlines()[2:] if line[:2] in ("a ", "b ", "c ", "d ", "e ")]
    assert [line.split()[:2] for line in rows] == [
        ["a", "equivalent"],
        ["b", "wrong"],
        ["c", "trivial"],
        ["d", "unreadable"],
        ["e", "incomplete"],
    ]
    assert sorted(p.name for p in answers.parent.iterdir()) == ["answers"]


def test_csv_on_standard_output_is_nothing_but_csv(answers: Path) -> None:
    (answers / "a").write_text(RIGHT)
    result = run("grade", PENDULUM, "answers/a", "--csv", "-", "--jobs", "1")
    assert re.fullmatch(
        r"submission,verdict,right,required,missing,remark,seconds,feedback,mistakes,points,possible,"
        r"problem,student,attempt,counts,submitted,late\n"
        r"a,equivalent,1,1,0,,[\d.]+,,,1,1,ex11-ideal-pendulum,a,,,,\n",
        result.stdout.replace("\r\n", "\n"),
    )


def test_the_pages_do_not_tell_the_answer(answers: Path) -> None:
    texts = ["phi1'' = 0\nphi2'' = 0", "0 = 0", "phi3'' = 0", "phi1'' = g", "x1 = 1/0", ""]
    for n, text in enumerate(texts):
        (answers / f"{n}").write_text(text)
    assert run("grade", "ex18", "answers", "--feedback", "pages", "--jobs", "1").exit_code == 0
    pages = [p.read_text(encoding="utf-8") for p in Path("pages").iterdir()]
    assert len(pages) == len(texts)
    for text in pages:
        assert "cos(" not in text
        assert "sin(" not in text
        assert "\\cos" not in text
        assert not re.search(
            r"cos |sin |\bm2\b.*\bl2\b.*phi", text.replace("the declared names are", "").split("= help")[0]
        )


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["no-such-problem", "answers"], "no-such-problem"),
        ([PENDULUM], "Missing argument"),
        ([PENDULUM, "nowhere"], "nowhere cannot be read"),
        ([PENDULUM, "empty"], "there is no submission in empty"),
        ([PENDULUM, "answers", "--jobs", "0"], "--jobs"),
        ([PENDULUM, "answers", "--timeout", "0"], "--timeout"),
        ([PENDULUM, "answers", "--timeout", "nan"], "--timeout"),
        ([PENDULUM, "answers", "--memory", "1"], "--memory"),
        ([PENDULUM, "answers", "--csv", "no/folder/marks.csv"], "cannot be written"),
        ([PENDULUM, "answers", "--csv", "empty"], "cannot be written"),
        ([PENDULUM, "answers", "--csv", "answers/a"], "is not a table of grades"),
        ([PENDULUM, "answers", "--feedback", "/dev/null"], "cannot be written"),
        ([PENDULUM, "answers", "--feedback", "answers"], "would be graded next time"),
        ([PENDULUM, "answers", "--feedback", "./answers/../answers"], "would be graded next time"),
        ([PENDULUM, "answers", "--dask", "tcp://x:1", "--jobs", "2"], "--jobs is for this machine"),
    ],
)
def test_what_cannot_begin(arguments: list[str], said: str, answers: Path) -> None:
    (answers / "a").write_text(RIGHT)
    Path("empty").mkdir()
    result = run("grade", *arguments)
    assert (result.exit_code, result.stdout) == (2, "")
    assert said in result.stderr
    assert [p.read_text() for p in answers.iterdir()] == [RIGHT]
    assert sorted(p.name for p in Path().iterdir()) == ["answers", "empty"]


@pytest.mark.usefixtures("answers")
def test_memory_in_which_the_problem_cannot_be_solved(monkeypatch: pytest.MonkeyPatch) -> None:
    Path("answers/a").write_text(RIGHT)
    monkeypatch.setattr("lagsolve.grading.run.prepare", lambda _: None)
    monkeypatch.setattr("lagsolve.grading.run.partial", lambda *_: grading_calls.eat)
    result = run("grade", PENDULUM, "answers", "--csv", "marks.csv", *LIMITS)
    assert result.exit_code == 2
    assert "limits-too-low" in result.stderr
    assert not Path("marks.csv.journal").exists()


def test_files_beside_the_answers_are_told_from_them(answers: Path) -> None:
    (answers / "a.txt").write_text(RIGHT)
    (answers / "problem.yaml").write_text((PROBLEMS / "chapter6" / f"{PENDULUM}.yaml").read_text())
    os.chdir(answers)
    for _ in range(2):
        assert run("grade", "problem.yaml", ".", "--csv", "marks.csv", "--feedback", "pages").exit_code == 0
        assert list(rows()) == ["a.txt"]
        assert [p.name for p in Path("pages").iterdir()] == ["a.txt.md"]


def test_a_link_where_a_page_is_to_be_is_replaced_and_not_followed(answers: Path) -> None:
    (answers / "a").write_text(RIGHT)
    Path("precious").write_text("precious")
    Path("pages").mkdir()
    Path("pages/a.md").symlink_to(Path("precious").resolve())
    assert run("grade", PENDULUM, "answers", "--feedback", "pages", "--jobs", "1").exit_code == 0
    assert Path("precious").read_text() == "precious"
    assert "**Equivalent**" in Path("pages/a.md").read_text()


def test_no_module_is_loaded_from_the_folder_of_the_answers(answers: Path) -> None:
    """The workers of a command that does not itself look there: the installed `lagsolve`, or `python -P`."""
    modules = ("sympy", "pickle", "struct", "signal", "sitecustomize", "lagsolve", "threading")
    for name in modules:
        (answers / f"{name}.py").write_text("open('/dev/stdout', 'w').write('loaded'); open('loaded', 'w')")
    (answers / "a.txt").write_text(RIGHT)
    program = f"import sys; sys.path[:] = {[p for p in sys.path if p]!r}; from lagsolve.main import main; main()"
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    called = [sys.executable, "-P", "-c", program, "grade", PENDULUM, "a.txt", "--csv", "-", "--jobs", "1"]
    done = subprocess.run(called, cwd=answers, env=environment, capture_output=True, check=True, timeout=PATIENCE)
    assert b"a.txt,equivalent" in done.stdout
    assert not (answers / "loaded").exists()


def test_a_device_has_no_journal(answers: Path) -> None:
    (answers / "a.txt").write_text(RIGHT)
    assert run("grade", PENDULUM, "answers", "--csv", "/dev/null", "--jobs", "1").exit_code == 0
    assert not Path("/dev/null.journal").exists()
    assert Path("/dev/null").is_char_device()


# Any executor


def test_an_executor_of_the_standard_library_will_do() -> None:
    source = Source("p", (PROBLEMS / "chapter6" / f"{PENDULUM}.yaml").read_text())
    handed_in = [Submission(f"{n}", (("a", t.encode()),)) for n, t in enumerate([RIGHT, WRONG] * 20)]
    taken, most = 0, 0

    def one_by_one() -> Iterator[Submission]:
        nonlocal taken, most
        for s in handed_in:
            taken += 1
            most = max(most, taken - done)
            yield s

    done = 0
    with ThreadPoolExecutor(1) as executor:
        for outcome in outcomes(one_by_one(), executor, examine, (source,), ahead=3):
            if outcome is not None:
                submission, graded = outcome
                assert graded.verdict == ("wrong" if int(submission.name) % 2 else "equivalent")
                done += 1
    assert done == 40
    assert most <= 6  # those that are handed over, and those that are ready


# Interruptions

COMMAND = """
import sys
sys.path[:0] = {path!r}
import lagsolve.grading.run as order
from tests.support import grading_calls
order.examine = grading_calls.examine
{more}
from lagsolve.main import main
main(prog_name="lagsolve")
"""


def command(*arguments: str, more: str = "") -> list[str]:
    """The command line of a process that grades the answers, after some more statements."""
    path = [*sys.path, str(ROOT)]
    return [sys.executable, "-c", COMMAND.format(path=path, more=more), "grade", PENDULUM, "answers", *arguments]


PIPES = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}


def grading(*arguments: str) -> AbstractContextManager[subprocess.Popen[bytes]]:
    """The command in a process, and a process group, of its own."""
    return started(command("--csv", "marks.csv", *arguments), **PIPES, start_new_session=True)


def messages(stderr: bytes) -> str:
    """Standard error without progress, of which there is some on a slow machine."""
    return "".join(line for line in stderr.decode().splitlines(keepends=True) if " graded, " not in line)


def wait_until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + 120
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


def noted() -> int:
    journal = Path("marks.csv.journal")
    return journal.read_text().count("\n") if journal.exists() else 0


def batch_that_stops_in_the_middle(answers: Path) -> None:
    """Ten right answers, then one that takes for ever."""
    for n in range(10):
        (answers / f"a{n}.txt").write_text(RIGHT)
    (answers / "loop.txt").write_text("LOOP")
    (answers / "z.txt").write_text(WRONG)


def mark_the_journal() -> None:
    """Changes the journal, so that reused rows can be distinguished from rows graded again."""
    journal = Path("marks.csv.journal")
    lines = [
        json.loads(line) for line in journal.read_text().splitlines() if line.startswith("{") and line.endswith("}")
    ]
    for line in lines:
        line["row"]["remark"] = "noted before"
    journal.write_text("".join(f"{json.dumps(line)}\n" for line in lines))


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL, signal.SIGTERM])
def test_an_interrupted_batch_goes_on_where_it_was(how: signal.Signals, answers: Path) -> None:
    batch_that_stops_in_the_middle(answers)
    with grading("--jobs", "1", "--timeout", "600") as process:
        wait_until(lambda: noted() == 10)
        os.killpg(process.pid, how)
        stdout, stderr = process.communicate(timeout=PATIENCE)
    assert stdout == b""
    assert not Path("marks.csv").exists()
    if how == signal.SIGINT:
        assert process.returncode == 130
        assert messages(stderr) == (
            "interrupted: 10 of 12 submissions are graded; the same command continues from here\n"
        )
    mark_the_journal()
    (answers / "loop.txt").write_text(RIGHT)
    (answers / "a3.txt").write_text(WRONG)  # changed in the meantime: graded again
    with grading("--jobs", "1", "--timeout", "600") as process:
        stdout, stderr = process.communicate(timeout=PATIENCE)
    assert (process.returncode, messages(stderr)) == (0, "")
    found = rows()
    assert len(found) == 12
    assert {name for name, r in found.items() if r["remark"] == "noted before"} == {
        f"a{n}.txt" for n in range(10) if n != 3
    }
    assert [found[n]["verdict"] for n in ("a3.txt", "loop.txt", "z.txt")] == ["wrong", "equivalent", "wrong"]
    assert not Path("marks.csv.journal").exists()


def test_after_an_interruption_a_page_that_is_not_there_is_written(answers: Path) -> None:
    batch_that_stops_in_the_middle(answers)
    with grading("--jobs", "1", "--timeout", "600", "--feedback", "pages") as process:
        wait_until(lambda: noted() == 10)
        os.killpg(process.pid, signal.SIGINT)
    mark_the_journal()
    Path("pages/a3.txt.md").unlink()
    (answers / "loop.txt").write_text(RIGHT)
    with grading("--jobs", "1", "--timeout", "600", "--feedback", "pages") as process:
        process.communicate(timeout=PATIENCE)
    assert [n for n, r in rows().items() if r["remark"] != "noted before"] == ["a3.txt", "loop.txt", "z.txt"]
    assert len(list(Path("pages").glob("*.md"))) == 12


def test_without_a_file_nothing_is_noted(answers: Path) -> None:
    (answers / "loop.txt").write_text("LOOP")
    for options, said in (["--feedback", "pages"], b"the same command continues"), ([], b"would continue"):
        with started(command(*options), stderr=subprocess.PIPE, start_new_session=True) as process:
            wait_until(lambda pid=process.pid: len(children(pid)) == 1)  # type: ignore[misc]
            os.killpg(process.pid, signal.SIGINT)
            assert said in process.communicate(timeout=PATIENCE)[1]
        assert process.returncode == 130


def children(pid: int) -> list[int]:
    found = []
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            before, after = status.read_text().rsplit(") ", 1)
        except OSError:
            continue
        if int(after.split()[1]) == pid and after[0] != "Z":
            found.append(int(before.split()[0]))
    return found


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="processes are found in /proc")
def test_workers_are_killed_under_a_batch(answers: Path) -> None:
    """Whatever they were about: their submissions are tried again."""
    for n in range(400):
        (answers / f"{n:03}.txt").write_text(RIGHT)
    with grading("--jobs", "2") as process:
        for enough in (20, 100):
            wait_until(lambda: noted() >= enough)  # noqa: B023
            for child in children(process.pid):
                os.kill(child, signal.SIGKILL)
        stderr = process.communicate(timeout=PATIENCE)[1]
    assert (process.returncode, messages(stderr)) == (0, "")
    assert {r["verdict"] for r in rows().values()} == {"equivalent"}
    assert len(rows()) == 400


def test_progress_on_a_terminal_is_one_line_that_goes_away(answers: Path) -> None:
    import pty

    for n in range(60):
        (answers / f"{n}.txt").write_text(RIGHT)
    master, slave = pty.openpty()
    with started(command("--jobs", "1"), stdout=subprocess.PIPE, stderr=slave) as process:
        os.close(slave)
        stdout = process.communicate(timeout=PATIENCE)[0].decode()
    shown = os.read(master, 100_000).decode()
    os.close(master)
    assert "60 submissions: 60 equivalent" in stdout
    assert "\x1b" not in stdout
    assert "\n" not in shown
    assert re.search(r"\r\x1b\[K\d+ of 60 graded, ", shown)
    assert shown.endswith("\r\x1b[K")


# A cluster

needs_dask = pytest.mark.skipif(importlib.util.find_spec("distributed") is None, reason="the extra `cluster`")


@contextmanager
def cluster(folder: Path) -> Iterator[str]:
    """A scheduler and two workers, processes on the loopback interface; its address."""
    file = folder / "scheduler.json"
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([*sys.path, str(ROOT)])}
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "env": environment, "cwd": folder}

    with ExitStack() as processes:

        def dask(what: str, *arguments: str) -> None:
            command = [sys.executable, "-m", f"distributed.cli.dask_{what}", "--scheduler-file", str(file)]
            process = processes.enter_context(started([*command, *arguments], patience=400, **quiet))
            processes.callback(process.terminate)  # is done before it is waited for

        dask("scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard")
        wait_until(lambda: file.exists() and file.read_text().strip().endswith("}"))
        options = ("--host", "127.0.0.1", "--nthreads", "1", "--no-dashboard", "--local-directory", str(folder))
        for n in range(2):
            dask("worker", "--name", f"worker{n}", *options)
        yield json.loads(file.read_text())["address"]


@needs_dask
def test_a_course_on_a_cluster(answers: Path, tmp_path: Path) -> None:
    """A real scheduler and two workers; limits hold there, too."""
    for n in range(30):
        (answers / f"{n:02}.txt").write_text(WRONG if n % 3 else RIGHT)
    for word in ("LOOP", "EAT", "KILL"):
        (answers / f"{word.lower()}.txt").write_text(word)
    (tmp_path / "dask").mkdir()
    with cluster(tmp_path / "dask") as address:
        options = ["--csv", "marks.csv", "--feedback", "pages", "--timeout", "10", "--memory", "512", "--dask", address]
        more = "order.examine_within_limits = grading_calls.examine_within_limits"
        done = subprocess.run(command(*options, more=more), capture_output=True, check=False, timeout=300)
    assert (done.returncode, messages(done.stderr)) == (3, "")
    found = rows()
    assert {n: r["verdict"] for n, r in found.items() if n[0].isdigit()} == {
        f"{n:02}.txt": "wrong" if n % 3 else "equivalent" for n in range(30)
    }
    assert found["loop.txt"]["remark"] == "it takes longer than 10 s"
    assert found["eat.txt"]["remark"] == "it needs more than 512 MB of memory"
    assert "signal 9" in found["kill.txt"]["remark"]
    assert len(list(Path("pages").iterdir())) == 33
    processes = {line for p in (tmp_path / "dask").glob("by-*") for line in p.read_text().split()}
    assert len(processes) == 2, "both workers had their share"


@needs_dask
def test_a_cluster_that_is_not_there(answers: Path) -> None:
    (answers / "a").write_text(RIGHT)
    for address in ("tcp://127.0.0.1:1", "nonsense://"):
        more = "import lagsolve.grading.pool; lagsolve.grading.pool.CLUSTER_SECONDS = 1"
        done = subprocess.run(command("--dask", address, more=more), capture_output=True, check=False, timeout=300)
        assert (done.returncode, done.stdout) == (2, b"")
        assert done.stderr.startswith(b"error[no-cluster]")
        assert b"Traceback" not in done.stderr


def test_without_the_extra_the_message_says_what_to_install(answers: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (answers / "a").write_text(RIGHT)
    monkeypatch.setitem(sys.modules, "distributed", None)
    result = run("grade", PENDULUM, "answers", "--dask", "tcp://127.0.0.1:1")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "pip install 'lagsolve[cluster]'" in result.stderr


# -- The progress of a batch -------------------------------------------------------------------------------------------


def test_a_line_now_and_then(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    times = iter([0.0, 1.0, 100.0, 200.0])
    monkeypatch.setattr("lagsolve.grading.run.time.monotonic", lambda: next(times))
    progress = Progress(1000)
    progress.step(1, graded=True)  # too soon
    progress.step(101, graded=True)
    progress.step(201, graded=True)
    progress.end()
    lines = capsys.readouterr().err.splitlines()
    assert lines == ["101 of 1,000 graded, 100 s, about 890 s more", "201 of 1,000 graded, 200 s, about 795 s more"]
