"""State functions of programs, macros of a document, and words about degrees of freedom, as they are read."""

from __future__ import annotations

import pytest

from lagrange.answers.written.in_words import stated_in_words
from lagrange.answers.written.notation.macros import macros_of, with_macros
from lagrange.answers.written.notation.matrices import with_named_matrices
from lagrange.answers.written.notation.programs import equations_of_program
from lagrange.core.diagnostics import Fragment


@pytest.mark.parametrize(
    ("program", "equations"),
    [
        ("def f(t, y):\n    th, om = y\n    return [om, -g/l*np.sin(th)]", ["th'' = -g/l*sin(th)"]),
        ("def f(y, t):\n    y1, y2 = y[0], y[1]\n    return y2, -y1", ["y1'' = -y1"]),
        ("f = @(t,y) [y(2); -y(1)]", ["state_1'' = -state_1"]),
        ("% y(1) = theta\nfunction dy = f(t, y)\ndy(1) = y(2);\ndy(2) = -k*y(1);\nend", ["theta'' = -k*theta"]),
        ("function f!(du, u, p, t)\n    q, w = u\n    du[1] = w\n    du[2] = -p*q\nend", ["q'' = -p*q"]),
        ("def f(t, y):\n    u, w = y\n    return [a*w, -a*u]", ["u' = a*w", "w' = -a*u"]),
        ("def f(t, z):\n    x, v = z\n    c = cos(x)\n    return [v, c**2]", ["x'' = (cos(x))**2"]),
        ("A = [0 1; -k 0];\nxdot = A*[x; v];", ["x'' = (-k)*(x)"]),
        (
            "function dz = f(t, z)\na = z(1); b = z(2); u = z(3); w = z(4);\nM = [m, n; n, p];\nr = [1; 2];\n"
            "acc = M\\r;\ndz = [u; w; acc];",
            ["(m)*a'' + (n)*b'' = 1", "(n)*a'' + (p)*b'' = 2"],
        ),
        ("m*x'' = -k*x", []),
        ("import os\ndef f(t, y):\n    os.system('true')\n    x, v = y\n    return [v, -x]", ["x'' = -x"]),
    ],
)
def test_state_functions(program: str, equations: list[str]) -> None:
    assert [e.text for e in equations_of_program(Fragment.of(program))] == equations


def test_a_program_that_grows_is_refused() -> None:
    doubling = "".join(f"    a{n + 1} = a{n} + a{n}\n" for n in range(60))
    assert equations_of_program(Fragment.of(f"def f(t, y):\n    a0, v = y\n{doubling}    return [v, a60]")) == []


@pytest.mark.parametrize(
    ("written", "body", "read"),
    [
        (r"\newcommand{\tdd}{\ddot\theta}", r"\tdd = 0", r"\ddot\theta  = 0"),
        (r"\newcommand{\diff}[2]{\frac{d #1}{d #2}}", r"\diff{x}{t} = 0", r"\frac{d x}{d t}  = 0"),
        (r"\def\a{m}\def\b{\a x}", r"\b^2", "{m  x}^2"),
        (r"\newcommand{\a}{\a\a}", r"\a", r"\a\a "),
    ],
)
def test_macros_are_written_out_once(written: str, body: str, read: str) -> None:
    assert with_macros(Fragment.of(body), macros_of(written)).text == read


@pytest.mark.parametrize(
    ("text", "freedom", "classes"),
    [
        ("Degrees of freedom: 6 - 1 = 5", 5, ()),
        ("x^2 + y^2 = l^2\nDOF = 1, holonomic", 1, ("holonomic",)),
        ("It has two degrees of freedom and is not holonomic", 2, ("nonholonomic",)),
        (r"\( f=6-1=5 \), scleronomic", 5, ("scleronomic",)),
        ("Zahl der Freiheitsgrade: 5, anholonom, rheonom", 5, ("nonholonomic", "rheonomic")),
        ("m x'' + k x = 0", None, ()),
    ],
)
def test_freedom_and_classes_in_words(text: str, freedom: int | None, classes: tuple[str, ...]) -> None:
    stated = stated_in_words(text)
    assert (stated.degrees_of_freedom, stated.classification) == (freedom, classes)


def test_named_matrices_are_written_out() -> None:
    column = r"\begin{pmatrix}%s\\%s\end{pmatrix}"
    matrix = r"\begin{pmatrix}a & b\\c & d\end{pmatrix}"
    texts = [rf"M = {matrix}", rf"M\ddot q = {column % (1, 2)}"]
    rows = column % (r"\ddot{x}", r"\ddot{y}")
    assert with_named_matrices(texts, [["x", "y"]]) == [None, rf"{matrix}{rows} = {column % (1, 2)}"]
