"""Programs in each language: their function f is that of the page, their comments are closed.

Names of a problem as names of a programming language.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path
from random import Random

import pytest
import sympy as sp

import lagrange
from lagrange.core.symbols import t
from lagrange.programs.languages import LANGUAGES, RESERVED, ProgramNames, Target, legal_name
from lagrange.programs.prepared import Prepared, prepared
from lagrange.programs.source import source_file
from tests.support.processes import PATIENCE
from tests.support.shared import in_numbers

HOSTILE = """
title: "coding: utf-7 */ int main() { return 1; } //\\\\"
source: "%{ #= ??/ ''' \\u2028 system('false')"
parameters:
  lambda: {value: 2, meaning: "a mass \\n#include <nothing>\\n*/ x = 1;"}
  I: {value: 3, unit: kg}
  f: {value: 0.5, meaning: "end \\u000a exit(1)"}
  y: {value: 9.81}
  N': 1
coordinates: {t1: "the first */", p: "%}"}
particles: {P: {mass: lambda, position: t1*i + f*sin(p)*j}, Q: {mass: I, position: p*k}}
gravity: -y*j
"""


def finished(command: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=PATIENCE, check=False)


def of_text(text: str) -> Prepared:
    return prepared(lagrange.loads(text))


def random_state(made: Prepared, seed: int) -> list[float]:
    random = Random(seed)
    return [y + random.uniform(-0.2, 0.2) for y in made.start.state]


def errors(made: Prepared, time: float, y: list[float], rate: list[float]) -> list[float]:
    """What the rates leave of the equations of motion of the page, and of the constraints differentiated twice.

    These are the printed equations, without matrices, eliminations, common subexpressions and printers.
    """
    states, [view] = made.states, [v for v in made.solution.views if v.name == made.states.name]
    e = states.equations
    values = {**made.start.values, t: time, **dict(zip(states.state, y, strict=True))}
    velocities = dict(zip(e.slots.velocities, rate, strict=False))
    assert view.dynamics is not None
    if e.speeds == e.slots.velocities:
        assert list(velocities.values()) == y[len(rate) // 2 :]
        accelerations = dict(zip(e.slots.accelerations, rate[len(velocities) :], strict=True))
        left = (*view.dynamics.equations.expressions, *view.dynamics.equations.configuration.accelerated_constraints)
    else:
        assert view.in_speeds is not None
        assert view.in_speeds.equations is not None
        kinematic = [s - r for s, r in zip(e.slots.velocities, e.rates, strict=True)]
        left = (*view.in_speeds.equations.expressions, *kinematic)
        accelerations = dict(zip(e.speed_rates, rate[len(e.rates) :], strict=True))
    rule = {**velocities, **accelerations, **values}
    return [float(x.subs(rule).evalf(20)) / (1 + float(abs(max(rate, key=abs)))) for x in left]


CASES = [("ex18-double-pendulum", None), ("ex18-double-pendulum", ""), ("ladder-leaves-the-wall", None), ("rolling-disc", None), ("mass-on-belt", None),
         ("sleigh", None), ("kapitza-pendulum", None)]  # fmt: skip


IDS = [f"{name}-{choice}" for name, choice in CASES]


def run_python(made: Prepared, states: list[list[float]], _: Path) -> list[list[float]]:
    namespace: dict[str, object] = {}
    exec(source_file(made.states, made.start, Target.PYTHON), namespace)
    f = namespace["f"]
    assert callable(f)
    return [f(0.3, y) for y in states]


def run_c(made: Prepared, states: list[list[float]], folder: Path) -> list[list[float]]:
    rows = ", ".join("{" + ", ".join(map(repr, y)) + "}" for y in states)
    n = len(states[0])
    main = f"""
#include <stdio.h>
int main(void) {{
    double y[{len(states)}][{n}] = {{{rows}}}, out[{n}];
    for (int k = 0; k < {len(states)}; k++) {{
        f(0.3, y[k], f_parameters, out);
        for (int j = 0; j < f_size; j++) printf("%.17g ", out[j]);
        printf("\\n");
    }}
    return 0;
}}
"""
    (folder / "f.c").write_text(source_file(made.states, made.start, Target.C) + main, encoding="utf-8")
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function", "-pedantic"]
    built = finished(["cc", *flags, "f.c", "-o", "f", "-lm"], folder)
    assert built.returncode == 0, built.stderr
    return _numbers(finished(["./f"], folder).stdout)


def run_octave(made: Prepared, states: list[list[float]], folder: Path) -> list[list[float]]:
    (folder / "f.m").write_text(source_file(made.states, made.start, Target.MATLAB), encoding="utf-8")
    rows = "; ".join(" ".join(map(repr, y)) for y in states)
    code = f"y = [{rows}]; for k = 1:rows(y) printf('%.17g ', f(0.3, y(k, :).')); printf('\\n'); end"
    made_of = finished(["octave-cli", "-qf", "--eval", code], folder)
    assert made_of.returncode == 0, made_of.stderr
    return _numbers(made_of.stdout)


def run_julia(made: Prepared, states: list[list[float]], folder: Path) -> list[list[float]]:
    rows = "; ".join(" ".join(map(repr, y)) for y in states)
    more = f'\nfor y in eachrow([{rows}])\n    println(join(f(0.3, collect(y)), " "))\nend\n'
    (folder / "f.jl").write_text(source_file(made.states, made.start, Target.JULIA) + more, encoding="utf-8")
    made_of = finished(["julia", "f.jl"], folder)
    assert made_of.returncode == 0, made_of.stderr
    return _numbers(made_of.stdout)


def _numbers(text: str) -> list[list[float]]:
    return [[float(x) for x in line.split()] for line in text.splitlines()]


RUNS = {
    "python": (run_python, ""),
    "c": (run_c, "cc"),
    "matlab": (run_octave, "octave-cli"),
    "julia": (run_julia, "julia"),
}


@pytest.mark.parametrize("language", RUNS)
@pytest.mark.parametrize(("name", "choice"), CASES, ids=IDS)
def test_the_exported_f_satisfies_the_equations_of_the_page(
    name: str, choice: str | None, language: str, tmp_path: Path
) -> None:
    run, program = RUNS[language]
    if program and shutil.which(program) is None:
        pytest.skip(f"there is no {program}")
    made = in_numbers(name, choice)
    states = [random_state(made, seed) for seed in range(3)]
    if made.states.equations.velocity_forms:  # the equations of the page have used the constraints
        states = [[*made.start.state]]
    for y, rate in zip(states, run(made, states, tmp_path), strict=True):
        assert max(map(abs, errors(made, 0.3, y, rate))) < 1e-11


@pytest.mark.parametrize("language", RUNS)
def test_no_text_of_a_file_leaves_its_comment(language: str, tmp_path: Path) -> None:
    run, program = RUNS[language]
    made = of_text(HOSTILE.replace("  N': 1\n", ""))
    text = source_file(made.states, made.start, Target(language))
    comment = LANGUAGES[Target(language)].comment
    for line in text.splitlines():
        assert line.lstrip().startswith(comment) or not re.search("coding|include <nothing|exit|system|return 1", line)
        assert not line.endswith("\\")
        assert "??/" not in line
    assert "coding" not in "".join(text.splitlines()[:2])  # a cookie of Python's would count there
    if program and shutil.which(program) is None:
        pytest.skip(f"there is no {program}")
    y = [0.1, 0.2, 0.3, 0.4]
    [rate] = run(made, [y], tmp_path)
    assert max(map(abs, errors(made, 0.3, y, rate))) < 1e-12


# Names


def test_names_are_legal_and_differ() -> None:
    assert [legal_name(n) for n in ("theta'", "θ''", "x_1", "2x", "π", "ξ₁")] == [
        "theta_dot", "theta_ddot", "x_1", "", "pi", "xi",
    ]  # fmt: skip
    names = ProgramNames()
    made = [names.readable(sp.Symbol(n)) for n in ("lambda", "x'", "x_dot", "I", "sin", "é", "f", "a", "a")]
    assert made == ["lambda_", "x_dot", "x_dot_1", "I_", "sin_", "s", "f_", "a", "a"]
    assert not set(made) & RESERVED
