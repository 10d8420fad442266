"""`import lagrange`: what a program and a notebook use."""

from __future__ import annotations

import ast
import io
import json
import subprocess
import sys
import unicodedata
from pathlib import Path

import pytest
import sympy as sp
from conftest import PROBLEMS, ROOT
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

import lagrange
from lagrange.api.time_functions import Reader, in_functions_of_time
from lagrange.document.derivation import Derivation

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
    assert {name for _, name in homes} == set(lagrange.__all__)


def test_importing_costs_nothing() -> None:
    code = "import sys, lagrange; print(sorted({m.split('.')[0] for m in sys.modules} & {'sympy', 'yaml', 'rich'}))"
    code += "; print([m for m in sys.modules if m.startswith('lagrange.')])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT)
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
        "  = help: declared are `x`, `y`"
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


def test_matrices_make_the_equations(pendulum: lagrange.Result) -> None:
    own = pendulum.own
    a, lam = sp.Matrix(own.accelerations), sp.Matrix(own.multipliers)
    left = own.mass_matrix * a - own.force_vector - own.constraint_matrix.T * lam
    assert all(sp.expand(e.lhs - e.rhs - r) == 0 for e, r in zip(own.equations_with_multipliers, left, strict=True))


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


def test_json_and_python_say_the_same(pendulum: lagrange.Result) -> None:
    found = json.loads(pendulum.render("json"))
    assert found["degrees_of_freedom"] == pendulum.degrees_of_freedom
    assert [c["name"] for c in found["choices"]] == [*pendulum.choices]


def test_a_notebook_shows_mathematics(pendulum: lagrange.Result) -> None:
    assert pendulum._repr_markdown_().startswith("# Ideal pendulum")
    assert pendulum["angle"]._repr_markdown_() == "$$\nl \\ddot{\\theta} + g \\sin\\theta = 0\n$$"
    assert "equivalent" in lagrange.check(pendulum)._repr_markdown_()


# functions of time


def test_functions_of_time_are_those_of_sympy(pendulum: lagrange.Result) -> None:
    theta = dynamicsymbols("theta")
    [equation] = pendulum["angle"].equations_in_time()
    names = {s: sp.Symbol(s.name) for s in equation.free_symbols}
    assert equation.xreplace(names) == sp.Eq(l * theta.diff(t, 2) + g * sp.sin(theta), 0)
    assert len(pendulum.own.equations_in_time()) == 2  # the constraint is one of them
    s = sp.Symbol("s")
    assert pendulum["angle"].in_time(pendulum["angle"].velocities[0], s) == sp.Function("theta")(s).diff(s)


@pytest.mark.parametrize(
    "name", ["ex09", "ex11", "ex13", "kapitza-pendulum", "sleigh", "foucault-pendulum", "mass-on-belt"]
)
def test_functions_of_time_are_read_back(name: str) -> None:
    problem = lagrange.load(name)
    reader = Reader(problem.scope)
    for c in problem.constraints:
        rate = problem.slots.time_derivative(c.function)
        for e in (c.function, rate if c.kinematic else problem.slots.time_derivative(rate)):
            written = in_functions_of_time(e, problem.slots)
            assert not any(str(s).endswith("'") for s in written.free_symbols)
            assert sp.expand(reader.expression(written) - e) == 0


def test_a_prescribed_motion_has_the_rates_that_a_text_may_have() -> None:
    scope = lagrange.loads("title: p\ncoordinates: [x]\nfunctions: {u: [t]}\n").scope
    u = dynamicsymbols("u")
    assert str(Reader(scope).expression(sp.Derivative(u.diff(t, 3), t))) == "u''''"
    with pytest.raises(lagrange.ProblemError, match="too-many-primes"):
        Reader(scope).expression(u.diff(t, 5))


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


@pytest.mark.parametrize("answer", RIGHT, ids=str)
def test_right_answers_in_every_form(pendulum: lagrange.Result, answer: object) -> None:
    found = lagrange.check(pendulum, answer)
    assert (found.verdict, found.choice, found.missing) == ("equivalent", "angle", 0)
    assert [str(e) for e in found.derived] == ["g*sin(theta) + l*theta''"]


def test_an_answer_of_several_equations(pendulum: lagrange.Result) -> None:
    x, y = dynamicsymbols("x y")
    lam = sp.Symbol("lambda_rod")
    answer = [sp.Eq(m * x.diff(t, 2), 2 * lam * x), m * y.diff(t, 2) - m * g - 2 * lam * y, "x^2 + y^2 = l^2"]
    assert lagrange.check(pendulum, answer).verdict == "equivalent"
    assert lagrange.check(pendulum, sp.Matrix(answer[1:2])).verdict in ("incomplete", "wrong")
    assert lagrange.check(pendulum, pendulum.own.equations_with_multipliers).verdict == "equivalent"
    assert lagrange.check(pendulum, pendulum.own.equations_in_time()).verdict == "equivalent"


def test_sympys_own_equations(pendulum: lagrange.Result) -> None:
    lagrangian = m * l**2 * theta.diff() ** 2 / 2 + m * g * l * sp.cos(theta)
    equations = LagrangesMethod(lagrangian, [theta]).form_lagranges_equations()
    assert lagrange.check(pendulum.problem, equations).verdict == "equivalent"


def test_a_wrong_sign_is_found(pendulum: lagrange.Result) -> None:
    found = lagrange.check(pendulum, sp.Eq(l * theta.diff(t, 2), g * sp.sin(theta)))
    assert found.verdict == lagrange.Verdict.WRONG
    assert "the sign of the term g*sin(theta)" in found.each[0].diagnosis
    assert "✗ l*theta'' = g*sin(theta)" in str(found)
    assert "sign" not in found.hinted(1).each[0].diagnosis


BAD = {
    "`tha` is not declared": sp.Symbol("tha") + theta,
    "`besselj` has no meaning": sp.besselj(0, theta),
    "`Integral` has no meaning": sp.Integral(theta, t),
    "`ImaginaryUnit` has no meaning": sp.I * theta,
    "`f(x(t))` is not declared": sp.Function("f")(dynamicsymbols("x")),
    "`theta(2*t)` is not declared": sp.Function("theta")(2 * t),
    "a time derivative of `theta''` arises here": theta.diff(t, 3),
    "derivative of `theta''` arises": sp.Derivative(l * theta.diff(t, 2) + theta, t),
    "time derivative of `theta''`": sp.Symbol("theta'''"),
    "`NoneType` has no meaning": None,
    "`object` has no meaning": 3.5j,
    "`StrictLessThan` has no meaning": theta < 0,
}


@pytest.mark.parametrize(("said", "answer"), BAD.items(), ids=BAD)
def test_what_cannot_be_read_says_why(pendulum: lagrange.Result, said: str, answer: object) -> None:
    found = lagrange.check(pendulum, [answer, RIGHT[0]])
    said = said.replace("`object`", "`complex`")
    assert found.verdict == "unreadable"
    assert said in found.each[0].diagnosis
    assert said in str(found)
    assert found.messages


@pytest.mark.parametrize(("answer", "verdict"), [(sp.Eq(theta, theta), "trivial"), (sp.Eq(1, 0), "wrong"), ([], None)])
def test_what_says_nothing(pendulum: lagrange.Result, answer: object, verdict: str | None) -> None:
    if verdict is None:
        with pytest.raises(lagrange.ProblemError, match="no equation to check"):
            lagrange.check(pendulum, answer)
    else:
        assert lagrange.check(pendulum, answer).verdict == verdict


def test_the_answers_of_the_file(pendulum: lagrange.Result) -> None:
    found = lagrange.check(pendulum)
    assert found.verdict == "equivalent"
    assert {a.name for a in found.others} >= {"degrees_of_freedom"}


def test_equations_given_outright_can_be_checked_against() -> None:
    problem = lagrange.loads(
        "title: p\ncoordinates: [theta]\nparameters: [l, g]\nequations: [\"l*theta'' + g*sin(theta) = 0\"]\n"
    )
    assert lagrange.check(problem, RIGHT[2]).verdict == "equivalent"
    with pytest.raises(lagrange.NotCoveredError):
        lagrange.solve(problem)


def test_an_equilibrium_has_alternatives() -> None:
    problem = lagrange.loads(
        "title: p\ncoordinates: [theta]\nparameters: [m, l, g]\nfind: equilibrium\n"
        "forces: {weight: {potential: -m*g*l*cos(theta)}}\n"
    )
    angle = sp.Symbol("theta")
    result = lagrange.solve(problem)
    assert lagrange.check(result, [[sp.Eq(angle, 0)], [sp.Eq(angle, sp.pi)]]).verdict == "equivalent"
    assert lagrange.check(result, [["theta = 0"]]).verdict == "incomplete"
    assert lagrange.check(result, sp.Eq(sp.sin(angle), 0)).verdict == "equivalent"


def test_undefined_functions_in_an_answer() -> None:
    result = lagrange.solve(lagrange.load("ex12"))
    assert lagrange.check(result, result.own.equations_in_time()).verdict == "equivalent"
    wrong = [2 * result.own.equations_in_time()[0].lhs, sp.Symbol("x''")]
    assert lagrange.check(result, wrong).verdict == "wrong"
