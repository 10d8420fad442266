"""Ratios of times, each the median of several pairs measured in turn: `make bench`.

    python tests/bench/ratios.py [processes] [equations] [growth] [problems] [--runs N]

A pair is the program and its peer on the same work, one after the other, so that a machine that is busy for a while is
busy for both. Times are seconds of processor time, of processes as the system accounts for them.

processes   the whole command against importing SymPy or click
equations   the equations of motion of a pendulum of n links, against SymPy's LagrangesMethod and KanesMethod; both sides
            are timed in a process of their own, from positions to equations; operations are counted in what comes out
growth      reading, the whole derivation with its checks, the page and the JSON of systems of n; exponents are fitted
problems    every shipped problem: seconds beyond importing SymPy, and the most memory
"""

from __future__ import annotations

import argparse
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PYTHON = sys.executable
LAGSOLVE = [PYTHON, "-m", "lagsolve"]
SIZES = (2, 4, 8, 16, 32)
MEBIBYTE = 1 << 10  # ru_maxrss counts kibibytes on Linux


@dataclass(frozen=True)
class Spent:
    """What one process took: seconds of the processor, mebibytes, and what it printed."""

    seconds: float
    memory: float
    output: str


def run(command: Sequence[str]) -> Spent:
    """One process, its output kept. Bytecode is written and used, whatever the environment says, as where it is installed."""
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    environment["PYTHONPATH"] = os.pathsep.join(map(str, (ROOT, ROOT / "cli")))
    with tempfile.TemporaryFile("w+", encoding="utf-8") as output:
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.DEVNULL, cwd=ROOT, env=environment)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        return Spent(usage.ru_utime + usage.ru_stime, usage.ru_maxrss / MEBIBYTE, output.read())


def paired(ours: Callable[[], float], peer: Callable[[], float], runs: int) -> tuple[float, float, float]:
    """Medians of ours, of the peer, and of the ratios, one pair after the other."""
    pairs = [(ours(), peer()) for _ in range(runs)]
    mine, theirs = zip(*pairs, strict=True)
    return statistics.median(mine), statistics.median(theirs), statistics.median(a / b for a, b in pairs)


# Whole processes


def processes(runs: int) -> None:
    """The command against what it must import."""
    rows = [
        ("lagsolve ex18", [*LAGSOLVE, "problems/chapter6/ex18-double-pendulum.yaml"], "sympy", "<= 2.5, goal 1.5"),
        ("lagsolve --help", [*LAGSOLVE, "--help"], "click", "<= 2, goal 1.5"),
    ]
    print(f"{'whole process':28}{'seconds':>10}{'peer':>16}{'seconds':>10}{'ratio':>8}   bar")
    for name, command, module, bar in rows:
        peer = [PYTHON, "-c", f"import {module}"]
        run(command), run(peer)  # files into the cache of the system, bytecode written
        mine, theirs, ratio = paired(lambda c=command: run(c).seconds, lambda p=peer: run(p).seconds, runs)
        print(f"{name:28}{mine:10.3f}{'import ' + module:>16}{theirs:10.3f}{ratio:8.2f}   {bar}", flush=True)


# Equations of motion


OURS = """
import json, sys, time
from tests.support.families import links
from lagrange.core.diagnostics import Source
from lagrange.problem.loader import read_problem
from lagrange.mechanics.constraints.kinematics import file_configuration
from lagrange.mechanics.solution import Method, classify, law_of_motion, virtual_displacements
def equations(problem):
    classification = classify(problem)
    configuration = file_configuration(problem, classification.constrained)
    elimination = virtual_displacements(configuration.constrained)
    law = law_of_motion(problem, configuration, elimination, classification.rank, False, Method.DALEMBERT)
    return law.equations(configuration, elimination).expressions
equations(read_problem(Source("warm", links(2))))
problem = read_problem(Source("links", links(int(sys.argv[1]))))
started = time.process_time()
found = equations(problem)
took = time.process_time() - started
print(json.dumps([took, sum(int(e.count_ops()) for e in found)]))
"""
SET_UP = """
import json, sys, time
from sympy import count_ops, symbols, sin, cos
from sympy.physics.mechanics import *
def system(n):
    return (dynamicsymbols(f"theta1:{n + 1}"), dynamicsymbols(f"u1:{n + 1}"), symbols(f"m1:{n + 1}", positive=True),
            symbols(f"l1:{n + 1}", positive=True), symbols("g", positive=True), ReferenceFrame("N"), Point("O"))
"""
LAGRANGES = """
def equations(n):
    q, _, m, l, g, N, O = system(n)
    O.set_vel(N, 0)
    position, particles = 0 * N.x, []
    for k in range(n):
        position = position + l[k] * sin(q[k]) * N.x + l[k] * cos(q[k]) * N.y
        point = O.locatenew(f"P{k}", position)
        point.set_vel(N, position.dt(N))
        particles.append(Particle(f"a{k}", point, m[k]))
        particles[-1].potential_energy = -m[k] * g * position.dot(N.y)
    return LagrangesMethod(Lagrangian(N, *particles), q).form_lagranges_equations()
"""
KANES = """
def equations(n):
    q, u, m, l, g, N, O = system(n)
    O.set_vel(N, 0)
    before, particles, loads, kinematic = O, [], [], []
    for k in range(n):
        A = N.orientnew(f"A{k}", "Axis", [q[k], -N.z])
        A.set_ang_vel(N, -u[k] * N.z)
        point = before.locatenew(f"P{k}", l[k] * A.y)
        point.v2pt_theory(before, N, A)
        particles.append(Particle(f"a{k}", point, m[k]))
        loads.append((point, m[k] * g * N.y))
        kinematic.append(q[k].diff() - u[k])
        before = point
    fr, frstar = KanesMethod(N, q_ind=q, u_ind=u, kd_eqs=kinematic).kanes_equations(particles, loads)
    return fr + frstar
"""
TIMED = """
equations(2)
started = time.process_time()
found = equations(int(sys.argv[1]))
took = time.process_time() - started
print(json.dumps([took, int(count_ops(found))]))
"""


def equations(runs: int) -> None:
    """The equations of motion of a pendulum of n links, against SymPy's."""
    print(f"\n{'equations of n links':24}{'n':>3}{'seconds':>10}{'operations':>12}{'peer':>18}{'seconds':>10}"
          f"{'operations':>12}{'1 to':>8}   bar")  # fmt: skip
    rows = [
        ("LagrangesMethod", SET_UP + LAGRANGES + TIMED, 8, "30, goal 100"),
        ("KanesMethod", SET_UP + KANES + TIMED, 16, "5, goal 15"),
        ("LagrangesMethod", SET_UP + LAGRANGES + TIMED, 16, "100, goal 300"),
    ]
    for name, peer, n, bar in rows:
        counted: dict[str, int] = {}

        def seconds(who: str, code: str, size: int = n, counted: dict[str, int] = counted) -> float:
            took, counted[who] = json.loads(run([PYTHON, "-c", code, str(size)]).output)
            return float(took)

        mine, theirs, ratio = paired(lambda s=seconds: s("ours", OURS), lambda s=seconds, c=peer: s("peer", c), runs)
        print(f"{'positions to equations':24}{n:3}{mine:10.3f}{counted['ours']:12,}{name:>18}{theirs:10.2f}"
              f"{counted['peer']:12,}{1 / ratio:8.0f}   {bar}", flush=True)  # fmt: skip


# Growth


WHOLE = """
import json, sys, time
from tests.support.families import FAMILIES
from lagrange.document.derivation import Detail
from lagrange.core.diagnostics import Source
from lagrange.problem.loader import read_problem
from lagrange.render import json as as_json
from lagrange.render import terminal
from lagrange.explain.report import report
def whole(family, n):
    started = time.process_time()
    found = report(read_problem(Source(family, FAMILIES[family](n))))
    solved = time.process_time()
    as_json.render([found])
    written = time.process_time()
    terminal.text(found.derivation, found.notation, 80, Detail.STEPS)
    return [solved - started, written - solved, time.process_time() - written, found.holds]
whole(sys.argv[1], 2)
print(json.dumps(whole(sys.argv[1], int(sys.argv[2]))))
"""


def growth(runs: int) -> None:
    """Whole derivations with checks, of systems of n, and how their times grow."""
    sys.path.insert(0, str(ROOT))
    from tests.support.families import FAMILIES

    print(
        f"\n{'whole derivation':14}{'n':>4}{'solved':>10}{'JSON':>8}{'page':>8}{'MiB':>7}   checks   exponent from here to the next"
    )
    for family in FAMILIES:
        solved: list[float] = []
        for n in SIZES:
            found = [run([PYTHON, "-c", WHOLE, family, str(n)]) for _ in range(runs if n < SIZES[-1] else 3)]
            rows = [json.loads(f.output) for f in found]
            times = [statistics.median(row[k] for row in rows) for k in range(3)]
            if solved:
                print(f"   {math.log2(times[0] / solved[-1]):.2f}", end="")
            solved.append(times[0])
            line = f"{family:14}{n:4}{times[0]:10.2f}{times[1]:8.2f}{times[2]:8.2f}{max(f.memory for f in found):7.0f}"
            print(f"\n{line}   {'hold' if all(row[3] for row in rows) else 'FAIL'}  ", end="", flush=True)
        print(f"\n{family:14}exponent fitted to n >= 4: {fitted(SIZES[1:], solved[1:]):.2f}", flush=True)


def fitted(sizes: Sequence[int], times: Sequence[float]) -> float:
    """The slope of log time against log size, by least squares."""
    x, y = [math.log(n) for n in sizes], [math.log(s) for s in times]
    return statistics.linear_regression(x, y).slope


# The library


def problems(runs: int) -> None:
    """Every shipped problem as a process that prints its page."""
    sys.path.insert(0, str(ROOT))
    from lagrange.problem import library

    print(f"\n{'shipped problem, seconds beyond importing SymPy':52}{'seconds':>8}{'MiB':>7}")
    rows = []
    for name, path in library.entries().items():
        pairs = [(run([PYTHON, "-c", "import sympy"]), run([*LAGSOLVE, str(path)])) for _ in range(runs)]
        beyond = statistics.median(ours.seconds - peer.seconds for peer, ours in pairs)
        rows.append((beyond, max(ours.memory for _, ours in pairs)))
        print(f"{name:52}{beyond:8.2f}{rows[-1][1]:7.0f}", flush=True)
    seconds, memory = zip(*rows, strict=True)
    print(f"{'median':52}{statistics.median(seconds):8.2f}{statistics.median(memory):7.0f}")
    print(f"{'most':52}{max(seconds):8.2f}{max(memory):7.0f}")


SECTIONS = {"processes": processes, "equations": equations, "growth": growth, "problems": problems}


def main() -> None:
    """Prints the tables that are asked for, or all."""
    parser = argparse.ArgumentParser(description="Ratios of times.")
    parser.add_argument("sections", nargs="*", metavar="SECTION", help=", ".join(SECTIONS))
    parser.add_argument("--runs", type=int, default=5)
    given = parser.parse_args()
    for name in given.sections or SECTIONS:
        SECTIONS[name](given.runs)


if __name__ == "__main__":
    main()
