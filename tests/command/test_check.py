"""`lagsolve check`: how answers are given, what is printed, and the exit status."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from lagrange import load
from lagrange.answers.equations import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.examiner import Judgement
from lagsolve.exit_statuses import status_of_verdict
from tests.command.test_main import OSCILLATOR, PENDULUM, REFERENCE, RIGHT, SKATE, run


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "oscillator.yaml").write_text(OSCILLATOR, encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize(
    ("equations", "verdict", "status"),
    [
        ([RIGHT], "equivalent", 0),
        (["l θ̈ = −g sin θ"], "equivalent", 0),
        (["theta'' = 0"], "wrong", 1),
        (["sin(theta)^2 + cos(theta)^2 = 1"], "trivial", 1),
        (["x^2 + y^2 = l^2"], "incomplete", 1),
        (["theta'' + q = 0"], "unreadable", 2),
        ([RIGHT, "theta'' ="], "equivalent", 0),
        (["theta'^2 = 1", "theta'' ="], "wrong", 1),
        ([""], "unreadable", 2),
    ],
)
def test_verdicts_and_exit_statuses(equations: list[str], verdict: str, status: int) -> None:
    arguments = [a for e in equations for a in ("-e", e)]
    result = run("check", PENDULUM, *arguments)
    assert result.exit_code == status
    assert result.stdout.startswith(f"{verdict}: ")
    assert all(e in result.stdout for e in equations)
    found = json.loads(run("check", PENDULUM, *arguments, "--format", "json").stdout)
    assert found.keys() == {"verdict", "equations", "missing"}
    assert found["verdict"] == verdict
    assert [e["text"] for e in found["equations"]] == equations
    for equation in found["equations"]:
        assert equation.keys() - {"cause", "model"} == {"text", "verdict", "diagnosis", "remarks"}
        assert isinstance(equation["diagnosis"], str)
        assert isinstance(equation["remarks"], list)


def test_undecided_is_status_3(monkeypatch: pytest.MonkeyPatch) -> None:
    verdict = AnswerVerdict(Verdict.UNDECIDED, (EquationVerdict(RIGHT, Verdict.UNDECIDED, "who knows"),))
    monkeypatch.setattr(
        "lagrange.answers.examiner.Examiner.check", lambda self, _: Judgement(verdict, problem=self.problem)
    )
    result = run("check", PENDULUM, "-e", RIGHT)
    assert result.exit_code == 3
    assert result.stdout.startswith("undecided: ")
    assert "who knows" in result.stdout


def test_what_cannot_be_read_is_located_on_standard_error() -> None:
    result = run("check", PENDULUM, "-e", RIGHT, "-e", "theta'' + q = 0")
    assert " --> equation 2:1:11" in result.stderr
    assert " --> " not in result.stdout


@pytest.mark.usefixtures("here")
def test_how_an_equation_was_read_is_said_on_standard_error() -> None:
    result = run("check", "oscillator.yaml", "-e", "x'' = -k/m x")
    assert result.exit_code == 0
    assert "note[read-as]" in result.stderr
    assert "note[" not in result.stdout


def test_an_answer_file_has_an_equation_a_line(here: Path) -> None:
    (here / "answer.txt").write_text("\ufeff# mine\r\n\r\n  m*x'' = -k*x\r\n", encoding="utf-8")
    result = run("check", "oscillator.yaml", "answer.txt")
    assert (result.exit_code, result.stderr) == (0, "")
    assert "m*x'' = -k*x" in result.stdout
    both = run("check", "oscillator.yaml", "answer.txt", "-e", "x'' = x", "--format", "json")
    assert [e["verdict"] for e in json.loads(both.stdout)["equations"]] == ["wrong", "equivalent"]


def test_mistakes_in_an_answer_file_have_their_line(here: Path) -> None:
    (here / "answer.txt").write_text("# mine\n\nm*x'' = -k*z\n", encoding="utf-8")
    result = run("check", "oscillator.yaml", "answer.txt")
    assert result.exit_code == 2
    assert " --> answer.txt:3:12" in result.stderr


@pytest.mark.usefixtures("here")
def test_standard_input_is_an_answer_or_a_problem_and_not_both() -> None:
    assert run("check", "oscillator.yaml", "-", text="m x'' + k x = 0\n").exit_code == 0
    assert run("check", "-", "-e", "m x'' + k x = 0", text=OSCILLATOR).exit_code == 0
    result = run("check", "-", "-", text=OSCILLATOR)
    assert (result.exit_code, result.stdout) == (2, "")
    assert "cannot be both" in result.stderr


@pytest.mark.parametrize("text", ["", "\n\n", "# nothing\n"])
def test_an_empty_answer_is_not_the_answer_of_the_file(text: str, here: Path) -> None:
    (here / "answer.txt").write_text(text, encoding="utf-8")
    result = run("check", PENDULUM, "answer.txt")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "there is no equation to check" in result.stderr


def test_without_an_answer_those_of_the_file_are_compared() -> None:
    result = run("check", PENDULUM)
    assert result.exit_code == 0
    for line in ("✓ degrees of freedom", "✓ classification", "✓ integrable", f"✓ {RIGHT}"):
        assert line in result.stdout
    found = json.loads(run("check", SKATE, "--format", "json").stdout)
    names = ["degrees_of_freedom", "classification", "integrable"]
    assert found == {
        "verdict": "equivalent",
        "equations": [],
        "missing": 0,
        "answers": [{"name": n, "verdict": "equivalent"} for n in names],
    }


@pytest.mark.parametrize(
    ("answers", "status", "verdict"),
    [
        ("{degrees_of_freedom: 2}", 1, "wrong"),
        ("{degrees_of_freedom: 1, equations: [\"x'' = x\"]}", 1, "wrong"),
        ("{degrees_of_freedom: 2, equations: [\"m*x'' = -k*x\"]}", 1, "wrong"),
        ("{degrees_of_freedom: 1, equations: [0 = 0]}", 1, "trivial"),
        ("{degrees_of_freedom: 1, equations: [m*x''/(sin(x)^2 + cos(x)^2 - 1) = 0]}", 2, "unreadable"),
        ("{degrees_of_freedom: 2, equations: [m*x''/(sin(x)^2 + cos(x)^2 - 1) = 0]}", 2, "unreadable"),
    ],
)
def test_the_verdict_on_the_answers_of_a_file(answers: str, status: int, verdict: str, here: Path) -> None:
    (here / "a.yaml").write_text(f"{OSCILLATOR}answers: {answers}\n", encoding="utf-8")
    result = run("check", "a.yaml")
    assert result.exit_code == status
    assert result.stdout.startswith(f"{verdict}: ")


@pytest.mark.parametrize(
    ("equations", "other", "status"),
    [
        (Verdict.EQUIVALENT, Verdict.EQUIVALENT, 0),
        (Verdict.EQUIVALENT, Verdict.UNDECIDED, 3),
        (Verdict.INCOMPLETE, Verdict.EQUIVALENT, 1),
        (Verdict.INCOMPLETE, Verdict.UNDECIDED, 3),
        (Verdict.UNDECIDED, Verdict.WRONG, 1),
        (Verdict.UNREADABLE, Verdict.WRONG, 2),
    ],
)
def test_the_first_verdict_that_applies_counts(equations: Verdict, other: Verdict, status: int) -> None:
    other_answers = (AnswerVerdict(other, name="integrable"),)
    result = Judgement(AnswerVerdict(equations), other_answers, problem=load(PENDULUM))
    assert status_of_verdict(result.verdict) == status
    assert result.headline.startswith(f"{result.verdict}: ")


@pytest.mark.usefixtures("here")
def test_nothing_to_compare() -> None:
    result = run("check", "oscillator.yaml")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "there is no equation to check" in result.stderr
    result = run("check", "ballistic-pendulum", "-e", "theta'' = 0")
    assert (result.exit_code, result.stderr) == (1, "")
    assert "accelerations have no meaning during an impact" in result.stdout
    result = run("check", SKATE, "-e", "x = 0")
    assert (result.exit_code, result.stderr) == (1, "")
    assert "the constraints do not require it" in result.stdout


def test_a_reference_given_outright(here: Path) -> None:
    (here / "r.yaml").write_text(REFERENCE, encoding="utf-8")
    assert run("check", "r.yaml", "-e", "x'' = -k/m*x").exit_code == 0
    assert run("check", "r.yaml", "-e", "x'' = k/m*x").exit_code == 1
    (here / "r.yaml").write_text(REFERENCE + "answers: {equations: [\"m*x'' = -k*x\"]}\n", encoding="utf-8")
    assert run("check", "r.yaml").exit_code == 0


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize("arguments", [[], ["nonsense"], [PENDULUM, "absent.txt"], [PENDULUM, "--format", "latex"]])
def test_usage(arguments: list[str]) -> None:
    result = run("check", *arguments)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr


TABLE = [  # the LaTeX of the table of answers, with the plain answer that it is
    (r"\ddot{\theta}+\frac{g}{l}\sin\theta=0", 0),
    (r"$\ddot\theta = -\frac gl \sin(\theta)$", 0),
    (r"ml\ddot{\theta}+mg\sin{\theta}=0", 0),
    (r"\frac{\mathrm{d}^{2}\theta}{\mathrm{d}t^{2}}=-\dfrac{g}{l}\sin\left(\theta(t)\right)", 0),
    (r"\frac{d}{dt}\left(m l^2\dot\theta\right)+mgl\sin\theta=0", 0),
    (r"\theta'' + \frac{g}{l}\sin\theta = 0", 0),
    (r"\ddot\theta = \frac gl \sin\theta", 1),
    (r"\ddot\theta + \frac gl \cos\theta = 0", 1),
    (r"\sin^2\theta + \cos^2\theta = 1", 1),
    (r"\frac{d^2\theta}{dt^2} + \frac{g}{\ell}\sin\theta = 0", 0),
    (r"\frac{d^2\theta}{dt^2} + \frac{g}{L}\sin\theta = 0", 2),
]


@pytest.mark.parametrize(("equation", "status"), TABLE)
def test_answers_in_latex(equation: str, status: int) -> None:
    result = run("check", PENDULUM, "-e", equation)
    assert result.exit_code == status
    assert "did you mean `l`" in result.stderr or status != 2


def test_several_equations_in_one_text() -> None:
    cases = r"\begin{cases} m\ddot{x} = 2x\lambda_{\text{rod}} \\ m\ddot{y} = mg + 2y\lambda_{\text{rod}} \end{cases}"
    found = json.loads(run("check", PENDULUM, "-e", cases, "--format", "json").stdout)
    assert found["verdict"] == "equivalent"
    assert [e["text"] for e in found["equations"]] == [
        r"m\ddot{x} = 2x\lambda_{\text{rod}}",
        r"m\ddot{y} = mg + 2y\lambda_{\text{rod}}",
    ]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.tex", "\\documentclass{article}\n\\begin{document}\nSo\n\\begin{align}\n  l\\ddot\\theta &= -g\\sin\\theta.\n\\end{align}\n\\end{document}\n"),
        ("a.md", "# Answer\n\nThe equation is $l\\ddot\\theta = -g\\sin\\theta$, which was to be found.\n"),
        ("a.md", "Here it is:\n\n```\nl*theta'' = -g*sin(theta)\n```\n"),
        ("a.txt", "My answer\n\n1) l theta'' = -g sin theta\n"),
    ],
)  # fmt: skip
def test_answer_files_with_prose(here: Path, name: str, text: str) -> None:
    (here / name).write_text(text, encoding="utf-8")
    assert run("check", PENDULUM, name).exit_code == 0


def test_an_error_in_a_file_has_its_place(here: Path) -> None:
    (here / "a.md").write_text(
        "# Answer\n\nWe find $\\ddot\\theta + \\frac{g}{q}\\sin\\theta = 0$.\n", encoding="utf-8"
    )
    result = run("check", PENDULUM, "a.md")
    assert result.exit_code == 2
    assert "a.md:3:33" in result.stderr


def test_the_answers_of_a_file_may_be_in_latex(here: Path) -> None:
    text = OSCILLATOR + "answers: {equations: ['$$ m\\ddot{x} = -k x $$']}\n"
    (here / "latex.yaml").write_text(text, encoding="utf-8")
    assert run("check", "latex.yaml").exit_code == 0
    (here / "wrong.yaml").write_text(text.replace("ddot", "dot"), encoding="utf-8")
    assert run("check", "wrong.yaml").exit_code == 1
    (here / "bad.yaml").write_text(text.replace("ddot", "foo"), encoding="utf-8")
    assert "unknown-command" in run("check", "bad.yaml").stderr


@pytest.mark.parametrize("width", [40, 60, 80, 120])
def test_an_equation_is_broken_before_its_signs(width: int) -> None:
    """Not inside brackets if the terms fit; the feedback is printed below it."""
    equation = (
        "(m1 + m2)*l1*phi1'' + m2*l2*phi2''*cos(phi1 - phi2) + m2*l2*phi2'^2*sin(phi1 - phi2) = -(m1 + m2)*g*sin(phi1)"
    )
    result = run(
        "check",
        "ex18-double-pendulum",
        "-e",
        f"phi1'*l1*phi1'' = 0*{'(m1 + m2)*' * 8}g",
        "-e",
        equation,
        env={"COLUMNS": str(width)},
    )
    lines = result.stdout.splitlines()
    assert max(map(len, lines)) <= width
    begun = next(n for n, line in enumerate(lines) if line.startswith("  ✓ (m1 + m2)"))
    shown = lines[begun:]
    assert " ".join(" ".join(shown).split()) == f"✓ {equation}"
    assert all(line.count("(") == line.count(")") for line in shown)
    assert all(line.lstrip()[0] in "+-=" for line in shown[1:])


@pytest.mark.usefixtures("here")
def test_how_an_equation_was_read_is_shown_where_it_may_surprise() -> None:
    shown = run("check", "oscillator.yaml", "-e", "x'' = -k/m x").stdout
    assert "read as ẍ = −(k/m) x" in shown
    assert "read as" not in run("check", "oscillator.yaml", "-e", "x'' = -k*x/m").stdout
