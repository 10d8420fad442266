"""`import lagrange`: what a program and a notebook use."""

from __future__ import annotations

import ast
import io
import subprocess
import sys
import unicodedata
from pathlib import Path

import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import lagrange
from lagrange.document.derivation import Derivation
from lagrange.render import markdown
from tests.support.paths import PROBLEMS, ROOT
from tests.support.processes import PATIENCE

PENDULUM = (PROBLEMS / "chapter6" / "ex11-ideal-pendulum.yaml").read_text(encoding="utf-8")
t = sp.Symbol("t")
l, m, g = sp.symbols("l m g")


@pytest.fixture(scope="module")
def pendulum() -> lagrange.Result:
    return lagrange.solve(lagrange.load("ex11"))


# the package


def test_everything_public_is_there_and_documented() -> None:
    for name in lagrange.__all__:
        found = getattr(lagrange, name)
        assert found.__doc__
        assert name in dir(lagrange)
    with pytest.raises(AttributeError, match="no attribute 'slove'"):
        lagrange.slove  # noqa: B018


def test_editors_and_mypy_see_what_is_there() -> None:
    tree = ast.parse((ROOT / "lagrange" / "__init__.py").read_text(encoding="utf-8"))
    [block] = [n for n in tree.body if isinstance(n, ast.If)]
    seen = {(n.module, a.name) for n in ast.walk(block) if isinstance(n, ast.ImportFrom) for a in n.names}
    homes = {(f"lagrange.{home}", name) for home, names in lagrange._HOMES.items() for name in names}
    assert seen == homes
    assert {name for _, name in homes} == set(lagrange.__all__) - {"__version__"}


def test_importing_costs_nothing() -> None:
    code = "import sys, lagrange; print(sorted({m.split('.')[0] for m in sys.modules} & {'sympy', 'yaml', 'rich'}))"
    code += "; print([m for m in sys.modules if m.startswith('lagrange.')])"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=PATIENCE, cwd=ROOT
    )
    assert done.stdout.split("\n")[:2] == ["[]", "[]"]


# load


def test_a_problem_is_loaded_from_wherever_it_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "mine.yaml"
    file.write_text(PENDULUM, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ex11-ideal-pendulum").mkdir()  # the library prevails over a folder, as in the command
    with file.open("rb") as binary, file.open(encoding="utf-8") as text:
        ways = [file, str(file), "mine.yaml", binary, text, io.StringIO(PENDULUM), "ex11", "ex11-ideal-pendulum"]
        problems = [lagrange.load(way) for way in ways]
    problems.append(lagrange.loads(PENDULUM.replace("\n", "\r\n")))
    assert {p.title for p in problems} == {"Ideal pendulum"}
    assert repr(problems[0]) == "<Problem 'Ideal pendulum': coordinates x, y; constraints rod; choices angle, depth>"


def test_a_mistake_is_shown_as_by_the_command(tmp_path: Path) -> None:
    with pytest.raises(lagrange.ProblemError) as caught:
        lagrange.loads("title: x\ncoordinates: [x, y]\nconstraints: {rod: x^2 + z^2 = 1}\n", "bead.yaml")
    assert str(caught.value) == (
        "error[unknown-symbol]: `z` is not declared\n"
        " --> bead.yaml:3:26\n"
        "  |\n"
        "3 | constraints: {rod: x^2 + z^2 = 1}\n"
        "  |                          ^\n"
        "  = help: the declared names are `x`, `y`"
    )
    for careless, said in {
        "ex99": "no shipped problem",
        "ex15": "may be any of",
        "nowhere.yaml": "there is no file",
        PENDULUM: "`lagrange.loads`",
        str(tmp_path): "is a folder",
        "": "may be any of|there is no",
    }.items():
        with pytest.raises(lagrange.ProblemError, match=said):
            lagrange.load(careless)
    with pytest.raises(TypeError, match="a path, an open file or a name, and not int"):
        lagrange.load(3)  # type: ignore[arg-type]


# solve


def test_what_is_found_has_names_and_shapes(pendulum: lagrange.Result) -> None:
    assert (pendulum.degrees_of_freedom, pendulum.classification.holonomic, pendulum.holds) == (1, True, True)
    assert [str(e) for e in pendulum.virtual_displacements] == ["2*delta(x)*x + 2*delta(y)*y"]
    assert len(pendulum.possible_displacements) == len(pendulum.constraints) == 1
    assert {str(k): str(v) for k, v in pendulum.dependent_displacements.items()} == {"delta(x)": "-delta(y)*y/x"}
    assert len(pendulum.newton) == 2
    assert all(c.passed for c in pendulum.checks)
    assert {a.verdict for a in pendulum.answers} == {lagrange.Verdict.EQUIVALENT}
    assert isinstance(pendulum.derivation, Derivation)
    assert repr(pendulum) == (
        "<Result of 'Ideal pendulum': 1 degree of freedom, holonomic, scleronomic; choices: angle, depth>"
    )
    own, angle = pendulum[""], pendulum["angle"]
    assert own is pendulum.own
    assert [*pendulum.choices] == ["angle", "depth"]
    assert own.mass_matrix.shape == (2, 2)
    assert own.force_vector.shape == (2, 1)
    assert own.constraint_matrix.shape == (1, 2)
    assert own.constraint_vector.shape == (1, 1)
    assert len(own.equations) == len(own.constraints) == len(own.multipliers) == 1
    assert len(own.equations_with_multipliers) == 2
    assert angle.constraint_matrix.shape == (0, 1)
    assert [str(e) for e in angle.equations] == ["g*sin(theta) + l*theta''"]
    assert str(angle.solved[angle.accelerations[0]]) == "-g*sin(theta)/l"
    assert set(map(str, angle.substitution)) == {"x", "y"}
    assert set(own.reactions) == set(angle.tensions) == set(own.reaction_forces) == {"rod"}
    assert angle.conserved[0].quantity == "energy"
    assert [str(s) for s in pendulum["depth"].signs] == ["sigma_1"]
    assert repr(angle) == "<Formulation in theta: choice angle>"
    assert repr(own) == "<Formulation in x, y: the file's own coordinates>"


def test_a_choice_alone_by_lagrange() -> None:
    result = lagrange.solve(lagrange.load("ex11"), "angle", method="lagrange")
    assert [*result.choices] == ["angle"]
    assert "T = " in str(result)
    with pytest.raises(KeyError, match="did you mean `angle`"):
        result["angel"]


def test_careless_calls_say_what_to_do(pendulum: lagrange.Result) -> None:
    with pytest.raises(TypeError, match=r"lagrange.solve\(lagrange.load\('ex11'\)\)"):
        lagrange.solve("ex11")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"lagrange.check\(lagrange.load\('ex11'\)\)"):
        lagrange.check("ex11", "x = 0")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="dalembert, lagrange"):
        lagrange.solve(pendulum.problem, method="newton")
    with pytest.raises(lagrange.ProblemError, match="no choice `angel`"):
        lagrange.solve(pendulum.problem, "angel")
    with pytest.raises(ValueError, match="did you mean `latex`"):
        pendulum.render("latx")
    with pytest.raises(ValueError, match="brief, steps or full"):
        pendulum.render(detail="long")


def test_a_problem_without_motion_has_no_equations() -> None:
    result = lagrange.solve(lagrange.load("beads-on-hoop"))
    assert result.own.equations == ()
    assert any(f.equilibrium is not None and f.equilibrium.branches for f in (result.own, *result.choices.values()))
    with pytest.raises(lagrange.ProblemError, match="no motion"):
        result.own.mass_matrix  # noqa: B018
    with pytest.raises(lagrange.ProblemError, match="no motion"):
        result.own.right_hand_side()


@pytest.mark.parametrize(
    ("format_", "begins"),
    [
        ("pretty", " Ideal pendulum"),
        ("latex", r"\documentclass"),
        ("markdown", "# "),
        ("html", "<!DOCTYPE"),
        ("json", "{"),
    ],
)
def test_it_is_rendered_as_by_the_command(pendulum: lagrange.Result, format_: str, begins: str) -> None:
    assert pendulum.render(format_).startswith(begins)
    assert len(pendulum.render("pretty", detail="brief")) < len(str(pendulum))
    lines = pendulum.render(width=60).splitlines()
    assert max(sum(not unicodedata.combining(c) for c in line) for line in lines) <= 60


def test_a_notebook_shows_mathematics(pendulum: lagrange.Result) -> None:
    whole = pendulum.report
    assert pendulum._repr_markdown_() == markdown.body(whole.derivation, whole.notation)
    assert pendulum._repr_markdown_().startswith("# Ideal pendulum")
    assert pendulum["angle"]._repr_markdown_() == "$$\nl \\ddot{\\theta} + g \\sin\\theta = 0\n$$"
    assert "equivalent" in lagrange.check(pendulum)._repr_markdown_()


# check


def verdicts(found: lagrange.Judgement) -> list[str]:
    return [e.verdict.value for e in found.each]


theta = dynamicsymbols("theta")
RIGHT = [
    "l theta'' + g sin theta = 0",
    r"\ddot\theta = -\frac gl \sin\theta",
    sp.Eq(l * theta.diff(t, 2), -g * sp.sin(theta)),
    m * l**2 * theta.diff(t, 2) + 1.0 * m * g * l * sp.sin(theta),
    sp.Derivative(l * theta.diff(t), t) + g * sp.sin(theta),
    l * sp.Symbol("theta''") + g * sp.sin(sp.Symbol("theta", real=True)),
    sp.Symbol("theta").diff(sp.Symbol("theta")) * (l * sp.Symbol("theta''") + g * sp.sin(sp.Symbol("theta"))),
]


def test_equations_given_outright_can_be_checked_against() -> None:
    problem = lagrange.loads(
        "title: p\ncoordinates: [theta]\nparameters: [l, g]\nequations: [\"l*theta'' + g*sin(theta) = 0\"]\n"
    )
    assert lagrange.check(problem, RIGHT[2]).verdict == "equivalent"
    with pytest.raises(lagrange.NotCoveredError):
        lagrange.solve(problem)


def test_undefined_functions_in_an_answer() -> None:
    result = lagrange.solve(lagrange.load("ex12"))
    assert lagrange.check(result, result.own.equations_in_time()).verdict == "equivalent"
    wrong = [2 * result.own.equations_in_time()[0].lhs, sp.Symbol("x''")]
    assert lagrange.check(result, wrong).verdict == "wrong"
