"""Expressions in each programming language."""

from __future__ import annotations

import json
import math
import shutil
from pathlib import Path

import pytest
import sympy as sp

import lagrange
from lagrange.core.symbols import t
from lagrange.programs.languages import FUNCTIONS, JAVASCRIPT, LANGUAGES, PYTHON, GeneratedFunction, Printer
from lagrange.programs.prepared import prepared
from tests.programs.test_languages import RUNS, finished

SMALL = """
title: Every function
parameters: {m: {value: 2}}
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces:
  push: {on: P, vector: "(FORCE)*i"}
"""


FORCES = ["sin(x)/cos(x)", "tan(x) + cot(x) + sec(x) - csc(x)", "asin(x/2)*acos(x/3) - atan(x)", "atan2(x, 2) + x'",
          "sinh(x) - cosh(2*x) + tanh(x)", "exp(-x^2)*log(x + 2)", "sqrt(x + 3)/abs(x - 4)", "sign(x - 1)*x^5 - x^(-3)",
          "-(x - 1)^2/3 + 0.125*x", "(x^2 + 1)^(3/2) - (x + 2)^(-5/2)", "x*(-2)*(1 - x)*m/(7*x*m^2)", "pi*x - 1e-7"]  # fmt: skip


@pytest.mark.parametrize("language", [*LANGUAGES, "javascript"])
def test_every_function_is_what_sympy_says(language: str, tmp_path: Path) -> None:
    program = {"c": "cc", "matlab": "octave-cli", "julia": "julia", "javascript": "node"}.get(language, "")
    if program and shutil.which(program) is None:
        pytest.skip(f"there is no {program}")
    x, v, m = sp.Symbol("x", real=True), sp.Symbol("x'", real=True), sp.Symbol("m", positive=True)
    problem = lagrange.loads(SMALL.replace("FORCE", " + ".join(f"1*({e})" for e in FORCES)))
    made = prepared(problem)
    place = 0.83
    if language == "javascript":
        e = made.states.equations
        outputs = [*e.rates, e.force[0] / e.mass[0][0]]
        function = GeneratedFunction.of("f", (("t", t), ("y", (x, v)), ("p", (m,))), outputs)
        code = "\n".join([*JAVASCRIPT.function(function), f"console.log(JSON.stringify(f(0, [{place}, 0.5], [2])))"])
        (tmp_path / "f.js").write_text(code)
        [found] = [json.loads(finished(["node", "f.js"], tmp_path).stdout)]
    else:
        [found] = RUNS[language][0](made, [[place, 0.5]], tmp_path)
    [push] = problem.forces
    expected = push.vector.components[0].subs({x: place, v: 0.5, m: 2}).evalf(25) / 2  # type: ignore[union-attr]
    assert math.isclose(found[1], float(expected), rel_tol=1e-13)
    assert found[0] == 0.5


def test_what_is_not_on_the_list_is_refused() -> None:
    x = sp.Symbol("x")
    for e in (
        sp.gamma(x),
        sp.Function("system")(x),
        sp.oo * 1,
        sp.I * x,
        sp.Symbol("y"),
        sp.Piecewise((x, x > 0), (1, True)),
    ):
        with pytest.raises(lagrange.NotCoveredError):
            Printer(PYTHON.syntax, {x: "x"})(sp.sympify(e, strict=True))
    assert len(FUNCTIONS) == 14
