"""What is handed in: where equations are found in files with prose around them, and the verdict on a submission."""

from __future__ import annotations

import contextlib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from lagrange.answers.equations import Verdict
from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Graded, Grader, Submission, equations_in_file
from lagrange.core.diagnostics import ProblemError, Source
from lagrange.problem.loader import load, read_problem
from tests.support.chance import examples
from tests.support.paths import PROBLEMS
from tests.support.shared import loaded, solved

# -- files -----------------------------------------------------------------------------------------------------------


def found(text: str, ending: str) -> list[str]:
    source = Source(f"answer{ending}", text)
    fragments = equations_in_file(source, ending)
    for fragment in fragments:
        span = fragment.span(0, len(fragment.text))
        assert text[span.start : span.end] == fragment.text
    return [f.text.strip() for f in fragments]


LINES = {
    "x'' = 0\ny'' = 0\n": ["x'' = 0", "y'' = 0"],
    "# my answer = good\n\nx'' = 0\n": ["x'' = 0"],
    "% a comment = here\nx'' = 0\n": ["x'' = 0"],
    "The equation of motion is\nx'' = 0\nwhich is simple.\n": ["x'' = 0"],
    "1) x'' = 0\n2) y'' = 0": ["x'' = 0", "y'' = 0"],
    "(1) x'' = 0\n(2) y'' = 0": ["x'' = 0", "y'' = 0"],
    "1. x'' = 0\n2. y'' = 0": ["x'' = 0", "y'' = 0"],
    "(2) x'' = 0": ["(2) x'' = 0"],
    "2.5 x'' = 0": ["2.5 x'' = 0"],
    "a) x'' = 0\nb) y'' = 0": ["x'' = 0", "y'' = 0"],
    "(a) x'' = 0": ["(a) x'' = 0"],
    "Eq. 1: x'' = 0": ["x'' = 0"],
    "theta-equation: x'' = 0": ["x'' = 0"],
    "1) in the direction of x: x'' = 0": ["x'' = 0"],
    "* x'' = 0\n• y'' = 0": ["x'' = 0", "y'' = 0"],
    "- x'' = 0": ["- x'' = 0"],
    "(x + y)'' = 0": ["(x + y)'' = 0"],
    "x := 3": ["x := 3"],
    "x'' = 0\r\ny'' = 0\r\n": ["x'' = 0", "y'' = 0"],
    "$\\ddot x = 0$\nso $y = 1$": [r"\ddot x = 0", "y = 1"],
    "\\ddot x = 0 \\\\\n\\ddot y = 0\n": [r"\ddot x = 0", r"\ddot y = 0"],
    "\\begin{align}\n x &= 0 \\\\\n y &= 1\n\\end{align}\nz = 2": ["x &= 0", "y &= 1", "z = 2"],
    "1: $$\nx = 0\n$$\n(2) y = 1": ["x = 0", "y = 1"],
    "x'' = 0\n\n- a remark\n": ["x'' = 0"],
    "x'' = 0\n- this is because nothing acts\n": ["x'' = 0"],
    "": [],
    "nothing\n": [],
}


@pytest.mark.parametrize("text", LINES)
@pytest.mark.parametrize("ending", [".txt", "", ".TXT"])
def test_lines(text: str, ending: str) -> None:
    assert found(text, ending) == LINES[text]


LATEX = {
    "\\ddot x = 0 % = 1\n\\ddot y = 0": [r"\ddot x = 0", r"\ddot y = 0"],
    "% $z = 1$\nWe find $x = 0$ where $y$ is free.\n\\[ y = 1 \\]\n": ["x = 0", "y = 1"],
    "\\documentclass{article}\n\\newcommand{\\a}{$q = 1$}\n\\begin{document}\nThe answer, a = b, is\n\\begin{equation}\n  x = 0\n"
    "\\end{equation}\n\\end{document}\n $z = 2$": ["x = 0"],
    "\\begin{document}\nnothing = here\n\\end{document}": [],
    "\\begin{verbatim}\n$z = 1$\n\\end{verbatim} $x = 0$": ["x = 0"],
    "\\begin{align}\n  m\\ddot x &= 0, \\label{eq:1}\\\\\n  % y &= 2 \\\\\n  \\ddot y &= 0.\n\\end{align}\n": [r"m\ddot x &= 0", r"\ddot y &= 0"],
    "Costs 5\\$ and 6\\$. $x = 0$": ["x = 0"],
    "\\section{x = 1}\n$$ x = 0 $$": ["x = 0"],
}  # fmt: skip


@pytest.mark.parametrize("text", LATEX)
def test_latex(text: str) -> None:
    assert found(text, ".tex") == LATEX[text]


MARKDOWN = {
    "# Answer\n\nWe find $x = 0$ and so on: a = b.\n": ["x = 0"],
    "## x = 1\n\n- $\\ddot x = 0$\n- $\\ddot y = 0$\n": [r"\ddot x = 0", r"\ddot y = 0"],
    "$$\n\\ddot x = 0\n$$\n": [r"\ddot x = 0"],
    "```\nx'' = 0\n# no = comment\ny'' = 0\n```\nwhere a = b\n": ["x'' = 0", "y'' = 0"],
    "```latex\n\\begin{aligned}\nx &= 0 \\\\\ny &= 1\n\\end{aligned}\n```": ["x &= 0", "y &= 1"],
    "~~~\nx'' = 0\n~~~\n": ["x'' = 0"],
    "```\nx'' = 0": ["x'' = 0"],
    "The first is `x'' = 0`, the second `y'' = 0`; `code` is no equation.": ["x'' = 0", "y'' = 0"],
    "$y = 1$ comes before `x'' = 0`.": ["y = 1", "x'' = 0"],
    "- x'' = 0\n- y'' = 0\n": ["x'' = 0", "y'' = 0"],
    "1. x'' = 0\n2. y'' = 0\n": ["x'' = 0", "y'' = 0"],
    "> x'' = 0": ["x'' = 0"],
    "It costs $5 and not $6.\n\nx'' = 0": ["x'' = 0"],
    "nothing": [],
}


@pytest.mark.parametrize("text", MARKDOWN)
def test_markdown(text: str) -> None:
    assert found(text, ".md") == MARKDOWN[text]


@pytest.mark.parametrize(
    ("text", "ending", "code", "column"),
    [
        ("We find $x = 0", ".tex", "not-closed", 8),
        ("We find $x = 0\n\nand more", ".md", "not-closed", 8),
        ("\\begin{align} x &= 0", ".txt", "not-closed", 0),
        ("\\[ x = 0", ".tex", "not-closed", 0),
    ],
)
def test_what_is_refused(text: str, ending: str, code: str, column: int) -> None:
    with pytest.raises(ProblemError) as caught:
        found(text, ending)
    [finding] = caught.value.diagnostics
    assert finding.span is not None
    assert (finding.code, finding.span.start) == (code, column)


@given(
    st.lists(
        st.sampled_from([
            "$", "$$", "\\(", "\\)", "\\[", "\\]", "\\begin{align}", "\\end{align}", "\\\\", "&", "=", "x", "\n", "\n\n", "{", "}", "```\n", "`",
            "% ", "# ", "(1) ", "a: ", "\\text{and}", ",", "\\quad", "\\boxed{", "\\label{a}", "\\begin{document}", "\\end{document}", "- ", " ",
        ]),
        max_size=40,
    ),
    st.sampled_from([".txt", ".md", ".tex"]),
)  # fmt: skip
@settings(max_examples=examples(500), deadline=None)
def test_any_file_is_taken_apart_or_refused(parts: list[str], ending: str) -> None:
    text = "".join(parts)
    try:
        pieces = equations_in_file(Source("answer", text), ending)
    except ProblemError as error:
        error.show()
        return
    ends = 0
    for fragment in pieces:
        span = fragment.span(0, len(fragment.text))
        assert text[span.start : span.end] == fragment.text
        if ending != ".md":
            assert span.start >= ends
            ends = span.end


@pytest.mark.parametrize(
    "text",
    [
        "x = 0\n",
        "$",
        "$$",
        "\\\\",
        "{",
        "\\boxed{x = ",
        "x = 0, \\quad ",
        "`x = ",
        "```\n",
        "(1) ",
        "%\n",
        "\\text{and} = ",
        "\\text{",
        "\\text{{{{}",
    ],
)
@pytest.mark.parametrize("ending", [".txt", ".md", ".tex"])
def test_long_files_take_no_longer_than_their_length(text: str, ending: str) -> None:
    """A fifth of a megabyte, each in a moment; what grew with the square of the length would not come back."""
    with contextlib.suppress(ProblemError):
        equations_in_file(Source("answer", text * (200_000 // len(text))), ending)


SECOND = "l2*phi2'' + l1*phi1''*cos(phi1 - phi2) - l1*phi1'^2*sin(phi1 - phi2) + g*sin(phi2) = 0"


def prepared(name: str) -> Grader:
    return Grader.of(Examiner.of(load(next(PROBLEMS.glob(f"*/{name}*.yaml")))))


@pytest.fixture(scope="module")
def pendulum() -> Grader:
    return prepared("ex11")


@pytest.fixture(scope="module")
def double() -> Grader:
    return prepared("ex18")


def grade(grader: Grader, *texts: str | bytes) -> Graded:
    files = tuple((f"file{n}", t if isinstance(t, bytes) else t.encode()) for n, t in enumerate(texts, start=1))
    return grader.grade(Submission("somebody", files))


@pytest.mark.parametrize(
    ("text", "verdict", "right"),
    [
        ("theta'' + g/l*sin(theta) = 0", Verdict.EQUIVALENT, 1),
        ("# mine\n\n2 l θ̈ = −2 g sin θ\n", Verdict.EQUIVALENT, 1),
        ("theta'' = 0", Verdict.WRONG, 0),
        ("theta'' + g/l*sin(theta) = 0\ntheta'' = 0", Verdict.WRONG, 1),
        ("x^2 + y^2 = l^2", Verdict.INCOMPLETE, 0),
        ("0 = 0", Verdict.TRIVIAL, 0),
        ("theta'' + q = 0", Verdict.UNREADABLE, 0),
        ("theta'' + g/l*sin(theta) = 0\nsee = my other sheet", Verdict.EQUIVALENT, 1),
        ("theta''/(sin(theta)^2 + cos(theta)^2 - 1) = 0", Verdict.UNREADABLE, 0),
        ("", Verdict.UNREADABLE, 0),
        (b"\xff\xfe\x00", Verdict.UNREADABLE, 0),
        ("x = 1\n" * 13, Verdict.UNREADABLE, 0),
        ("(" * 1999, Verdict.UNREADABLE, 0),
    ],
)
def test_the_verdict_and_what_is_right(text: str | bytes, verdict: Verdict, right: int, pendulum: Grader) -> None:
    graded = grade(pendulum, text)
    assert (graded.verdict, graded.right, graded.required) == (verdict, right, 1)
    assert graded.headline.startswith(f"{verdict}: ")
    assert graded.remark or verdict is Verdict.EQUIVALENT


@pytest.mark.parametrize(
    ("text", "right"),
    [
        (SECOND, 1),
        (f"{SECOND}\n{SECOND.replace('= 0', '= 1')}", 1),
        (f"{SECOND}\n3*({SECOND.replace('= 0', ') = 0')}", 1),
        (f"{SECOND.replace('l2', 'L2')}", 0),
    ],
)
def test_one_of_two_equations(text: str, right: int, double: Grader) -> None:
    graded = grade(double, text)
    assert (graded.right, graded.required) == (right, 2)


def test_the_files_of_one_submission_are_one_answer(double: Grader) -> None:
    answers = double.examiner.problem.answers
    assert answers is not None
    first, second = (f.text for f in answers.equations)
    assert grade(double, first).verdict is Verdict.INCOMPLETE
    assert grade(double, first, second).verdict is Verdict.EQUIVALENT
    assert "file2:1:" in " ".join(grade(double, first, "phi1'' = huh").messages)


def test_nothing_depends_on_what_was_graded_before(pendulum: Grader) -> None:
    texts = ["theta'' = 0", "theta'' + g/l*sin(theta) = 0", "???", "theta'' = 0"]
    found = [grade(pendulum, t) for t in texts]
    assert found[0].verdict is found[3].verdict is Verdict.WRONG
    assert (found[0].equations, found[0].messages) == (found[3].equations, found[3].messages)
    assert found[1].verdict is Verdict.EQUIVALENT


def test_positions_of_equilibrium_are_not_counted_as_equations() -> None:
    grader = prepared("ex16")
    answers = grader.examiner.problem.answers
    assert answers is not None
    assert answers.equilibrium
    graded = grade(grader, " or ".join(f.text for a in answers.equilibrium for f in a))
    assert graded.verdict in (Verdict.EQUIVALENT, Verdict.WRONG, Verdict.INCOMPLETE)
    assert (graded.right, graded.required) == (None, None)
    assert grade(grader, "0 = 0").required is None


def test_a_reference_given_outright() -> None:
    text = "title: r\nparameters: [m, k]\ncoordinates: [x]\nequations: [\"m*x'' + k*x = 0\"]\n"
    grader = Grader.of(Examiner.of(read_problem(Source("r.yaml", text))))
    assert grade(grader, "x'' = -(k/m) x").right == 1


def test_a_problem_without_equations_of_motion_is_graded_by_its_constraints() -> None:
    grader = prepared("ex05")
    assert grade(grader, "x' sin(theta) = y' cos(theta)\n2 DOF, nonholonomic").verdict is Verdict.EQUIVALENT
    assert grade(grader, "x' sin(theta) = y' cos(theta)\n2 DOF, holonomic").verdict is Verdict.WRONG
    assert grade(grader, "theta'' = 0").verdict is Verdict.WRONG


@pytest.mark.parametrize(
    ("text", "ending"),
    [
        ("x=1\n" * 262_000, ".txt"),
        ("$x=1$\n" * 150_000, ".tex"),
        ("\n" * 1_000_000, ".txt"),
        ("x\n" * 500_000, ".md"),
        ("$x$" * 300_000, ".tex"),
        ("`a`" * 300_000, ".md"),
        ("<p>x=1</p>" * 100_000, ".html"),
        ("x = " + "Eq(" * 300_000, ".txt"),
    ],
)
def test_files_that_are_too_long_are_refused_before_they_are_read(
    text: str, ending: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(*_: object) -> None:
        raise AssertionError("it is read")

    monkeypatch.setattr("lagrange.answers.submissions.marks_of", never)
    monkeypatch.setattr("lagrange.answers.submissions._lines", never)
    with pytest.raises(ProblemError) as refused:
        equations_in_file(Source("answer", text), ending)
    assert refused.value.diagnostics[0].code == "too-many-equations"


def test_equations_of_all_files_of_a_submission_are_counted_together() -> None:
    files = tuple((f"{n}.txt", b"theta'' = 0\n" * 600) for n in range(3))
    graded = Grader.of(Examiner(loaded("ex11-ideal-pendulum"), solved("ex11-ideal-pendulum"))).grade(
        Submission("a", files)
    )
    assert graded.verdict.value == "unreadable"
    assert "1,000 equations in all its files" in graded.headline


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("The ladder stands for tan(theta) <= 2 mu/(1 - mu nu); if mu nu >= 1, at every angle.", "equivalent"),
        ("tan(eps) = mu, tan(del) = nu\nrest: tan(theta)*(1 - tan(eps)*tan(del)) <= 2*tan(eps)", "equivalent"),
        ("The ladder stands for tan(theta) <= 2 mu/(1 + mu nu); if mu nu >= 1, at every angle.", "wrong"),
    ],
)
def test_when_a_condition_is_none_and_functions_of_names_that_the_answer_defines(text: str, verdict: str) -> None:
    grader = Grader.of(Examiner(loaded("ladder-on-rough-ground"), solved("ladder-on-rough-ground")))
    assert grader.grade(Submission("x", (("a.txt", text.encode()),))).verdict.value == verdict


def test_a_count_of_coordinates_is_arithmetic() -> None:
    grader = Grader.of(Examiner(loaded("ex04-dumbbell"), solved("ex04-dumbbell")))
    text = "6 - 1 = 5 degrees of freedom, holonomic, scleronomic\n(x2 - x1)^2 + (y2 - y1)^2 + (z2 - z1)^2 = l^2\n"
    assert grader.grade(Submission("x", (("a.txt", text.encode()),))).verdict.value == "equivalent"
