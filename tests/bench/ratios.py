"""Ratios of times, each the median of several pairs measured in turn: `make bench`.

    python tests/bench/ratios.py [processes] [equations] [mechanisms] [growth] [problems] [--runs N]

A pair is the program and its peer on the same work, one after the other, so that a machine that is busy for a while is
busy for both. Times are seconds of processor time, of processes as the system accounts for them.

processes   the whole command against importing SymPy or click
equations   the equations of motion of a pendulum of n links, against SymPy's LagrangesMethod and KanesMethod; both sides
            are timed in a process of their own, from positions to equations; operations are counted in what comes out,
            every coordinate, velocity and acceleration a plain symbol
mechanisms  the same of a slider-crank and of a rolling disc, against KanesMethod in the same coordinates and speeds
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
        ("lagsolve ex18", [*LAGSOLVE, "problems/chapter6/ex18-double-pendulum.yaml"], "sympy", "<= 1.9, goal 1.5"),
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
from lagrange.mechanics.dynamics.quasi_equations import quasi_equations
from lagrange.mechanics.dynamics.quasi_velocities import quasi_velocities
from lagrange.mechanics.solution import Method, classify, law_of_motion, virtual_displacements
def equations(problem):
    classification = classify(problem)
    configuration = file_configuration(problem, classification.constrained)
    elimination = virtual_displacements(configuration.constrained)
    law = law_of_motion(problem, configuration, elimination, classification.rank, False, Method.DALEMBERT)
    return law.equations(configuration, elimination).expressions
def in_speeds(problem):
    configuration = file_configuration(problem, classify(problem).constrained)
    return quasi_equations(quasi_velocities(problem.speeds, configuration), configuration).expressions
text, derived = sys.argv[1], {"equations": equations, "in speeds": in_speeds}[sys.argv[2]]
equations(read_problem(Source("warm", links(2))))
problem = read_problem(Source("timed", text))
started = time.process_time()
found = derived(problem)
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
WARM = "equations(2)\n"
TIMED = """
started = time.process_time()
found = equations(int(sys.argv[1]))
took = time.process_time() - started
plain = found.xreplace({s: symbols(f"s{k}") for k, s in enumerate(find_dynamicsymbols(found))})
print(json.dumps([took, int(count_ops(plain))]))
"""


def equations(runs: int) -> None:
    """The equations of motion of a pendulum of n links, against SymPy's."""
    sys.path.insert(0, str(ROOT))
    from tests.support.families import links

    print(f"\n{'equations of n links':24}{'n':>3}{'seconds':>10}{'operations':>12}{'peer':>18}{'seconds':>10}"
          f"{'operations':>12}{'1 to':>8}   bar")  # fmt: skip
    rows = [
        ("LagrangesMethod", SET_UP + LAGRANGES + WARM, 8, "30, goal 100"),
        ("KanesMethod", SET_UP + KANES + WARM, 16, "5, goal 15"),
        ("LagrangesMethod", SET_UP + LAGRANGES + WARM, 16, "100, goal 300"),
    ]
    for name, peer, n, bar in rows:
        ours = [PYTHON, "-c", OURS, links(n), "equations"]
        found = against(ours, [PYTHON, "-c", peer + TIMED, str(n)], runs)
        print(f"{'positions to equations':24}{n:3}{row(name, found)}   {bar}", flush=True)


def against(ours: Sequence[str], peer: Sequence[str], runs: int) -> tuple[float, int, float, int, float]:
    """Seconds and operations of ours and of the peer, each printed by a process, and the ratio of the seconds."""
    counted: dict[str, int] = {}

    def seconds(who: str, command: Sequence[str]) -> float:
        took, counted[who] = json.loads(run(command).output)
        return float(took)

    mine, theirs, ratio = paired(lambda: seconds("ours", ours), lambda: seconds("peer", peer), runs)
    return mine, counted["ours"], theirs, counted["peer"], ratio


def row(name: str, found: tuple[float, int, float, int, float]) -> str:
    """What `against` found, beside the name of the peer."""
    mine, operations, theirs, others, ratio = found
    return f"{mine:10.3f}{operations:12,}{name:>18}{theirs:10.3f}{others:12,}{1 / ratio:8.1f}"


# Mechanisms


SLIDER_CRANK = """
title: Slider-crank
axes: {i: right, j: up}
parameters: {r: {assume: positive}, l: {assume: positive}, a: {assume: positive}, J: {assume: positive},
  I: {assume: positive}, m: {assume: positive}, M: {assume: positive}, g: {assume: positive}, Q: real, P: real}
coordinates: [theta, phi]
bodies:
  crank: {mass: 0, inertia: J, position: 0*i, angle: theta}
  rod: {mass: m, inertia: I, position: r*cos(theta)*i + r*sin(theta)*j + a*cos(phi)*i - a*sin(phi)*j, angle: -phi}
particles:
  B: {mass: M, position: (r*cos(theta) + l*cos(phi))*i}
constraints:
  piston: r*sin(theta) - l*sin(phi) = 0
gravity: -g*j
forces:
  motor: {on: crank, moment: Q*k}
  load: {on: B, vector: P*i}
"""
SLIDER_CRANK_KANE = """
def equations(_):
    theta, phi, u, w = dynamicsymbols("theta phi u w")
    r, l, a, J, I, m, M, g = symbols("r l a J I m M g", positive=True)
    Q, P = symbols("Q P")
    N, O = ReferenceFrame("N"), Point("O")
    O.set_vel(N, 0)
    crank, rod = N.orientnew("crank", "Axis", [theta, N.z]), N.orientnew("rod", "Axis", [-phi, N.z])
    crank.set_ang_vel(N, u * N.z)
    rod.set_ang_vel(N, -w * N.z)
    pin, centre, piston = O.locatenew("A", r * crank.x), Point("G"), Point("B")
    pin.v2pt_theory(O, N, crank)
    centre.set_pos(pin, a * rod.x)
    centre.v2pt_theory(pin, N, rod)
    piston.set_pos(pin, l * rod.x)
    piston.v2pt_theory(pin, N, rod)
    bodies = [RigidBody("crank", O, crank, 0, (inertia(crank, 0, 0, J), O)),
              RigidBody("rod", centre, rod, m, (inertia(rod, 0, 0, I), centre)), Particle("B", piston, M)]
    loads = [(crank, Q * N.z), (centre, -m * g * N.y), (piston, P * N.x)]
    closed = [r * sin(theta) - l * sin(phi)]
    kane = KanesMethod(N, q_ind=[theta], q_dependent=[phi], u_ind=[u], u_dependent=[w],
        kd_eqs=[theta.diff() - u, phi.diff() - w], configuration_constraints=closed,
        velocity_constraints=[r * cos(theta) * u - l * cos(phi) * w])
    fr, frstar = kane.kanes_equations(bodies, loads)
    return fr + frstar
"""
ROLLING_DISC_KANE = """
def equations(_):
    phi, theta, psi, u1, u2, u3 = dynamicsymbols("phi theta psi u1 u2 u3")
    m, R, A, C, g = symbols("m R A C g", positive=True)
    N = ReferenceFrame("N")
    heading = N.orientnew("heading", "Axis", [phi, N.z])
    lean = heading.orientnew("lean", "Axis", [theta, heading.x])
    disc = lean.orientnew("disc", "Axis", [psi, lean.z])
    turning = disc.ang_vel_in(N)
    disc.set_ang_vel(N, u1 * lean.x + u2 * lean.y + u3 * lean.z)
    contact = Point("contact")
    contact.set_vel(N, 0)
    centre = contact.locatenew("centre", R * lean.y)
    centre.v2pt_theory(contact, N, disc)
    body = RigidBody("disc", centre, disc, m, (inertia(lean, A, A, C), centre))
    kinematic = [(disc.ang_vel_in(N) - turning).dot(e) for e in lean]
    kane = KanesMethod(N, q_ind=[phi, theta, psi], u_ind=[u1, u2, u3], kd_eqs=kinematic)
    fr, frstar = kane.kanes_equations([body], [(centre, -m * g * N.z)])
    return fr + frstar
"""
ROLLING_DISC_WITH_PLACE_KANE = """
def equations(_):
    x, y, phi, theta, psi, u1, u2, u3, u4, u5 = dynamicsymbols("x y phi theta psi u1 u2 u3 u4 u5")
    m, R, A, C, g = symbols("m R A C g", positive=True)
    N, O = ReferenceFrame("N"), Point("O")
    O.set_vel(N, 0)
    heading = N.orientnew("heading", "Axis", [phi, N.z])
    lean = heading.orientnew("lean", "Axis", [theta, heading.x])
    disc = lean.orientnew("disc", "Axis", [psi, lean.z])
    kinematic = [(u1 * lean.x + u2 * lean.y + u3 * lean.z - disc.ang_vel_in(N)).dot(e) for e in lean]
    disc.set_ang_vel(N, u1 * lean.x + u2 * lean.y + u3 * lean.z)
    centre = O.locatenew("centre", x * N.x + y * N.y + R * sin(theta) * N.z)
    centre.set_vel(N, u4 * N.x + u5 * N.y + R * cos(theta) * u1 * N.z)
    slip = centre.vel(N) + disc.ang_vel_in(N).cross(-R * lean.y)
    body = RigidBody("disc", centre, disc, m, (inertia(lean, A, A, C), centre))
    kane = KanesMethod(N, q_ind=[x, y, phi, theta, psi], u_ind=[u1, u2, u3], u_dependent=[u4, u5],
        kd_eqs=kinematic + [x.diff() - u4, y.diff() - u5], velocity_constraints=[slip.dot(N.x), slip.dot(N.y)])
    fr, frstar = kane.kanes_equations([body], [(centre, -m * g * N.z)])
    return fr + frstar
"""


def mechanisms(runs: int) -> None:
    """The equations of motion of two mechanisms with constraints, against SymPy's; warmed up on two links."""
    print(f"\n{'equations of':24}{'':3}{'seconds':>10}{'operations':>12}{'peer':>18}{'seconds':>10}"
          f"{'operations':>12}{'1 to':>8}")  # fmt: skip
    disc = (ROOT / "problems/motion/rolling-disc.yaml").read_text(encoding="utf-8")
    rows = [
        ("a slider-crank", SLIDER_CRANK, "equations", SLIDER_CRANK_KANE),
        ("a disc, from its place", disc, "in speeds", ROLLING_DISC_WITH_PLACE_KANE),
        ("a disc, from the contact", disc, "in speeds", ROLLING_DISC_KANE),
    ]
    for name, text, derived, peer in rows:
        theirs = [PYTHON, "-c", SET_UP + KANES + WARM + peer + TIMED, "0"]
        found = against([PYTHON, "-c", OURS, text, derived], theirs, runs)
        print(f"{name:27}{row('KanesMethod', found)}", flush=True)


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
            rows = [json.loads(f.output) for f in found if f.output]
            if not rows:
                print(f"\n{family:14}{n:4}   not solved", end="")
                break
            times = [statistics.median(row[k] for row in rows) for k in range(3)]
            if solved:
                print(f"   {math.log2(times[0] / solved[-1]):.2f}", end="")
            solved.append(times[0])
            line = f"{family:14}{n:4}{times[0]:10.2f}{times[1]:8.2f}{times[2]:8.2f}{max(f.memory for f in found):7.0f}"
            print(f"\n{line}   {'hold' if all(row[3] for row in rows) else 'FAIL'}  ", end="", flush=True)
        print(f"\n{family:14}exponent fitted to n >= 4: {fitted(SIZES[1 : len(solved)], solved[1:]):.2f}", flush=True)


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


SECTIONS = {
    "processes": processes,
    "equations": equations,
    "mechanisms": mechanisms,
    "growth": growth,
    "problems": problems,
}


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
