"""`lagsolve new --for`: the files with which a platform grades a problem, ready to be uploaded.

    gradescope    a folder: setup.sh, run_autograder, the problem; to be zipped
    prairielearn  a question: info.json, question.html, tests/; a Dockerfile for the image it runs in
    moodle        an XML file with an essay question
    coderunner    an XML file with CodeRunner's prototype and a question

Gradescope's sandbox is Ubuntu, with a network while the image is built; PrairieLearn's has no network, and Jobe has
only what its administrator has installed; docs/teachers.md says what follows from that.
"""

from __future__ import annotations

import json
import shlex
from pathlib import Path

import click

import lagrange
from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagsolve.command_group import write_stderr
from lagsolve.written_files import unwritable, write_file

_XML = ("moodle", "coderunner")

_SETUP = """\
#!/usr/bin/env bash
# Gradescope runs this once, when the image of the autograder is built.
set -euo pipefail
cd /autograder/source
apt-get update
# Ubuntu 22.04 has Python 3.11 as a package of its own; later releases have a newer one as python3.
apt-get install -y python3.11 python3.11-venv || apt-get install -y python3 python3-venv
python=$(command -v python3.11 || command -v python3)
"$python" -c 'import sys; sys.exit(sys.version_info < (3, 11) and "lagsolve needs Python 3.11: choose a newer image")'
"$python" -m venv /autograder/venv
# A wheel beside this file is taken if there is one (python -m build --wheel, in a clone of lagsolve).
wheel=$(ls lagsolve-*.whl 2>/dev/null | tail -n 1 || true)
/autograder/venv/bin/python -m pip install --quiet "${{wheel:-lagsolve=={version}}}"
/autograder/venv/bin/lagsolve --version
"""

_RUN = """\
#!/usr/bin/env bash
# Gradescope runs this for each submission; it must write /autograder/results/results.json.
root=${{AUTOGRADER_ROOT:-/autograder}}
lagsolve=${{LAGSOLVE:-/autograder/venv/bin/lagsolve}}
mkdir -p "$root/results"
metadata=()
[ -f "$root/submission_metadata.json" ] && metadata=(--roster "$root/submission_metadata.json")
"$lagsolve" grade "$root/source/{problem}" "$root/submission" --format gradescope --hint 1 \\
    --jobs 1 "${{metadata[@]}}" -o "$root/results/results.json"
status=$?
if [ ! -s "$root/results/results.json" ]; then
    echo '{{"score": 0, "output": "The answer could not be graded: please tell your instructor."}}' \\
        > "$root/results/results.json"
fi
echo "lagsolve ended with status $status"
"""

_DOCKERFILE = """\
# The image in which PrairieLearn runs the grader: it has no network, so that lagsolve must be inside.
FROM python:3.12-slim
COPY lagsolve-*.whl /tmp/
RUN python -m pip install --no-cache-dir /tmp/lagsolve-*.whl
"""

_PL_RUN = """\
#!/usr/bin/env bash
# PrairieLearn runs this for each submission; it must write /grade/results/results.json.
root=${{GRADE_ROOT:-/grade}}
mkdir -p "$root/results"
"${{LAGSOLVE:-lagsolve}}" grade "$root/tests/{problem}" "$root/student" --format prairielearn --hint 1 \\
    --jobs 1 --timeout 25 -o "$root/results/results.json"
if [ ! -s "$root/results/results.json" ]; then
    echo '{{"gradable": false, "format_errors": ["The answer could not be graded: please tell your instructor."]}}' \\
        > "$root/results/results.json"
fi
"""

_PL_SERVER = '''\
"""Instead of an external grader: where lagsolve is installed for the Python of PrairieLearn's questions.

Set "gradingMethod": "Internal" in info.json, and take <pl-rich-text-editor>, <pl-string-input
answers-name="equations"> or another element that keeps a text, instead of the file editor.
"""

from pathlib import Path

from lagsolve.platforms.prairielearn import grade_element

PROBLEM = (Path(__file__).parent / "tests" / "{problem}").read_text(encoding="utf-8")


def grade(data):
    grade_element(data, "equations", PROBLEM, hint=1)
    parts = data["partial_scores"].values()
    data["score"] = sum(p["score"] * p.get("weight", 1) for p in parts) / (sum(p.get("weight", 1) for p in parts) or 1)
'''


def create_for(platform: str, file: str, source: Source) -> None:
    """Writes what a platform needs for a problem. Raises ProblemError; overwrites nothing."""
    if platform in _XML:
        from lagsolve.platforms import questions

        if not file.lower().endswith(".xml"):
            raise click.UsageError(f"a question for Moodle is an XML file: lagsolve new {shlex.quote(file)}.xml ...")
        path = Path(file)
        _refuse_existing(path)
        text = questions.essay(source) if platform == "moodle" else questions.coderunner(source)
        write_file(path, text, follow=False)
        write_stderr(f"{path} is a question bank in Moodle XML: import it there")
        return
    folder = Path(file)
    _refuse_existing(folder)
    files = _gradescope() if platform == "gradescope" else _prairielearn(source)
    files[_PLACES[platform] + _PROBLEM] = source.text
    try:
        for name in {str(Path(name).parent) for name in files}:
            (folder / name).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise unwritable(str(folder), error) from None
    for name, text in files.items():
        write_file(folder / name, text, follow=False)
        if text.startswith("#!"):
            (folder / name).chmod(0o755)
    write_stderr(_NEXT[platform].format(folder=shlex.quote(str(folder))))


_PROBLEM = "problem.yaml"
_PLACES = {"gradescope": "", "prairielearn": "tests/"}
_NEXT = {
    "gradescope": "{folder} is an autograder: put a wheel of lagsolve into it, and upload a zip file of its files\n"
    "  (cd {folder} && zip ../autograder.zip *)",
    "prairielearn": "{folder} is a question: build the image of its Dockerfile, name it in info.json, sync the course",
}


def _gradescope() -> dict[str, str]:
    return {"setup.sh": _SETUP.format(version=lagrange.__version__), "run_autograder": _RUN.format(problem=_PROBLEM)}


def _prairielearn(source: Source) -> dict[str, str]:
    from uuid import NAMESPACE_URL, uuid5

    from lagrange.explain.report import report
    from lagrange.problem.loader import read_problem
    from lagsolve.platforms.questions import figure_of, statement_of

    solved = report(read_problem(source), complete=False)
    picture = figure_of(solved.derivation, solved.notation)
    statement = "\n  ".join(statement_of(solved.solution.problem, solved.notation))
    statement = statement.replace(r"\(", "$").replace(r"\)", "$").replace("{{", "{ {")  # not Mustache's
    shown = '\n  <pl-figure file-name="figure.svg"></pl-figure>' if picture else ""
    info = {
        "uuid": str(uuid5(NAMESPACE_URL, f"lagsolve:{source.text}")),
        "title": solved.solution.problem.title,
        "topic": "Mechanics",
        "type": "v3",
        "singleVariant": True,
        "gradingMethod": "External",
        "externalGradingOptions": {
            "enabled": True,
            "image": "YOUR-ORGANIZATION/lagsolve",
            "entrypoint": "/grade/tests/run.sh",
            "timeout": 30,
        },
    }
    question = (
        f"<pl-question-panel>\n  {statement}{shown}\n</pl-question-panel>\n\n"
        '<pl-file-editor file-name="answer.txt"></pl-file-editor>\n\n'
        "<pl-submission-panel>\n  <pl-external-grader-results></pl-external-grader-results>\n</pl-submission-panel>\n"
    )
    files = {
        "info.json": json.dumps(info, indent=2, ensure_ascii=False) + "\n",
        "question.html": question,
        "tests/run.sh": _PL_RUN.format(problem=_PROBLEM),
        "Dockerfile": _DOCKERFILE,
        "server.py.internal": _PL_SERVER.format(problem=_PROBLEM),
    }
    return files | ({"clientFilesQuestion/figure.svg": picture[0]} if picture else {})


def _refuse_existing(path: Path) -> None:
    if path.exists() or path.is_symlink():
        help_ = "nothing was written: give it another name, or remove the old one first"
        raise ProblemError(Diagnostic("file-exists", f"{path} already exists", help=help_))
