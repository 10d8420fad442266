"""`lagsolve new --for`: files that a platform can use, and that grade when they are run as the platform runs them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.command.test_main import run
from tests.support.paths import ROOT

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the scripts are for bash")


def ran(script: Path, **environment: str) -> None:
    """Runs a script, with `lagsolve` as it is here."""
    command = Path("lagsolve")
    command.write_text(f'#!/bin/sh\nexec {sys.executable} -m lagsolve "$@"\n')
    command.chmod(0o755)
    path = os.pathsep.join((str(ROOT), str(ROOT / "cli")))
    more = {"LAGSOLVE": str(command.absolute()), "PYTHONPATH": path, **environment}
    subprocess.run(["bash", str(script)], env=os.environ | more, check=True, timeout=120, capture_output=True)


def test_gradescope(here: Path) -> None:
    assert run("new", "auto", "--from", "ex11", "--for", "gradescope").exit_code == 0
    assert sorted(p.name for p in Path("auto").iterdir()) == ["problem.yaml", "run_autograder", "setup.sh"]
    for name in ("setup.sh", "run_autograder"):
        assert os.access(Path("auto") / name, os.X_OK)
        subprocess.run(["bash", "-n", f"auto/{name}"], check=True, timeout=60)
    root = here / "autograder"  # as https://gradescope-autograders.readthedocs.io/en/latest/specs/ has it
    (root / "submission").mkdir(parents=True)
    (root / "submission" / "answer.txt").write_text("theta'' + g/l*sin(theta) = 0\n")
    Path("auto").rename(root / "source")
    metadata = {"created_at": "2026-11-20T20:05:00-07:00", "assignment": {"due_date": "2026-11-20T20:00:00-07:00"}}
    (root / "submission_metadata.json").write_text(json.dumps(metadata))
    ran(root / "source" / "run_autograder", AUTOGRADER_ROOT=str(root))
    found = json.loads((root / "results" / "results.json").read_text())
    assert (found["score"], found["output"]) == (1, "Handed in 5 min after it was due.")


def test_gradescope_always_has_a_result(here: Path) -> None:
    assert run("new", "auto", "--from", "ex11", "--for", "gradescope").exit_code == 0
    Path("autograder").mkdir()
    ran(Path("auto/run_autograder"), AUTOGRADER_ROOT=str(here / "autograder"))  # there is no problem, and no submission
    found = json.loads(Path("autograder/results/results.json").read_text())
    assert found["score"] == 0
    assert "could not be graded" in found["output"]


def test_prairielearn(here: Path) -> None:
    assert run("new", "pendulum", "--from", "ex11", "--for", "prairielearn").exit_code == 0
    info = json.loads(Path("pendulum/info.json").read_text())
    assert {"uuid", "title", "topic", "type", "gradingMethod", "externalGradingOptions"} <= set(info)
    options = info["externalGradingOptions"]
    assert {"enabled", "image", "entrypoint", "timeout"} == set(options)
    assert options["entrypoint"] == "/grade/tests/run.sh"
    question = Path("pendulum/question.html").read_text()
    assert "{{" not in question
    assert "<svg" in Path("pendulum/clientFilesQuestion/figure.svg").read_text()
    assert 'file-name="figure.svg"' in question
    Path("pendulum").rename(here / "question")
    (here / "grade" / "student").mkdir(parents=True)
    (here / "question" / "tests").rename(here / "grade" / "tests")
    (here / "grade" / "student" / "answer.txt").write_text("l*theta'' = g*sin(theta)\n")
    ran(here / "grade" / "tests" / "run.sh", GRADE_ROOT=str(here / "grade"))
    found = json.loads((here / "grade" / "results" / "results.json").read_text())
    assert (found["gradable"], found["score"]) == (True, 0)


def test_the_template_of_coderunner_prints_json(here: Path) -> None:
    """With what Twig puts in: texts whose quotes and backslashes are escaped for Python."""
    from lagsolve.platforms.questions import TEMPLATE

    problem = run("show", "ex11").stdout

    def escaped(value: str) -> str:
        return value.replace("\\", "\\\\").replace('"', '\\"')

    program = TEMPLATE.replace("{{ QUESTION.globalextra | e('py') }}", escaped(problem))
    program = program.replace("{{ STUDENT_ANSWER | e('py') }}", escaped('theta\'\' = """\\n'))
    program = program.replace("{{ QUESTION.parameters.hint | default(1) }}", "1")
    (here / "prog.py").write_text(program)
    path = os.pathsep.join((str(ROOT), str(ROOT / "cli")))
    for environment in ({"PYTHONPATH": path}, {"PYTHONPATH": str(here)}):
        (here / "lagsolve.py").write_text("")  # shadows it in the second run
        done = subprocess.run(
            [sys.executable, "-P", "prog.py"],
            env=os.environ | environment,
            capture_output=True,
            text=True,
            timeout=120,
        )
        found = json.loads(done.stdout)
        assert found["fraction"] == 0
        assert "epiloguehtml" in found


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["x", "--for", "gradescope"], "--from"),
        (["x", "--for", "moodle", "--from", "ex11"], "x.xml"),
        (["there", "--for", "gradescope", "--from", "ex11"], "already exists"),
        (["x", "--for", "prairielearn", "--from", "no-such-problem"], "no-such-problem"),
        (["nowhere/x.xml", "--for", "moodle", "--from", "ex11"], "cannot be written"),
    ],
)
def test_what_is_refused(arguments: list[str], said: str, here: Path) -> None:
    (here / "there").mkdir()
    result = run("new", *arguments)
    assert result.exit_code == 2
    assert said in result.stderr
    assert sorted(p.name for p in here.iterdir()) == ["there"]
