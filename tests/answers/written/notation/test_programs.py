"""State functions of programs, macros of a document, and words about degrees of freedom, as they are read."""

from __future__ import annotations

import pytest

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
