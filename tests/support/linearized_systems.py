"""Systems that oscillate, with their Lagrangians written by hand and their numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from random import Random

import sympy as sp
from mpmath import cos, mp, mpc, mpf, sin, sqrt

from lagrange.core.diagnostics import Source
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem

mp.dps = 40
Numbers = dict[str, mpf]


@dataclass(frozen=True)
class System:
    """A system.

    text         its problem file without title and question
    lagrangian   L(q, v, parameters)
    place        the equilibrium in the coordinates of L
    coordinates  the same in those of the problem, by name
    force        Q(q, v, parameters), shape (n,)
    exists       whether it exists for these parameters
    """

    text: str
    lagrangian: Callable[..., mpf]
    place: Callable[[Numbers], list[mpf]]
    coordinates: Callable[[Numbers], dict[str, mpf]]
    force: Callable[..., list[mpf]] | None = None
    exists: Callable[[Numbers], bool] = lambda _: True


PENDULUM = """
parameters: [m, l, g]
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}
gravity: -g*j
"""
IN_X_AND_Y = """
parameters: [m, l, g, b]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
forces: {air: {on: P, vector: "-b*x'*i - b*y'*j"}}
gravity: -g*j
"""
DOUBLE = """
parameters: [m1, m2, l1, l2, g]
coordinates: [theta1, theta2]
particles:
  P: {mass: m1, position: l1*sin(theta1)*i - l1*cos(theta1)*j}
  Q: {mass: m2, position: r_P + l2*sin(theta2)*i - l2*cos(theta2)*j}
gravity: -g*j
"""
COUPLED = """
parameters: [m, l, g, c, a]
coordinates: [theta1, theta2]
particles:
  P: {mass: m, position: l*sin(theta1)*i - l*cos(theta1)*j}
  Q: {mass: m, position: (a + l*sin(theta2))*i - l*cos(theta2)*j}
forces: {spring: {spring: c, between: [P, Q], length: a}}
gravity: -g*j
"""
MOLECULE = """
parameters: [m, M, c, b]
coordinates: [x1, x2, x3]
particles: {A: {mass: m, position: x1*i}, B: {mass: M, position: x2*i}, C: {mass: m, position: x3*i}}
forces:
  left: {spring: c, between: [A, B], length: b, sense: positive}
  right: {spring: c, between: [B, C], length: b, sense: positive}
"""
HOOP = """
parameters: [m, R, g, Omega]
coordinates: [theta]
particles:
  P: {mass: m, position: R*sin(theta)*cos(Omega*t)*i + R*sin(theta)*sin(Omega*t)*j - R*cos(theta)*k}
gravity: -g*k
"""
PARABOLA = """
parameters: [m, a, g, Omega]
coordinates: [x]
particles: {P: {mass: m, position: x*cos(Omega*t)*i + x*sin(Omega*t)*j + a*x^2*k}}
gravity: -g*k
"""
TABLE = """
parameters: [m, c, k, Omega]
coordinates: [x, y]
let: {e1: cos(Omega*t)*i + sin(Omega*t)*j, e2: -sin(Omega*t)*i + cos(Omega*t)*j}
particles: {P: {mass: m, position: x*e1 + y*e2}}
forces: {plate: {potential: c*x^2/2 + k*y^2/2}}
"""
DAMPED = """
parameters: [m, c, b]
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {spring: {potential: c*x^2/2}, oil: {on: P, vector: "-b*x'*i"}}
"""
ONE_DAMPER = """
parameters: [m, c, b, l]
coordinates: [x1, x2]
particles: {P: {mass: m, position: x1*i}, Q: {mass: m, position: x2*i}}
forces:
  left: {spring: c, between: [0*i, P], length: l, sense: positive}
  middle: {spring: c, between: [P, Q], length: l, sense: positive}
  oil: {damper: b, between: [P, Q]}
"""
CART = """
parameters: [m, M, l, g, k]
coordinates: [x, theta]
particles:
  A: {mass: M, position: x*i}
  P: {mass: m, position: (x + l*sin(theta))*i + l*cos(theta)*j}
forces: {springs: {potential: k*x^2/2 + k*l^2*theta^2/2}}
gravity: -g*j
"""
SPRING_PENDULUM = """
parameters: [m, c, l, g]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
forces: {spring: {spring: c, between: [0*e_r, P], length: l, sense: positive}}
gravity: g*i
"""
SADDLE = """
parameters: [m, a, b, g]
coordinates: [x, y, z]
particles: {P: {mass: m, position: x*i + y*j + z*k}}
constraints: {surface: z = a*x^2/2 - b*y^2/2}
gravity: -g*k
"""
ROTATING_SADDLE = """
parameters: [m, a, g, Omega]
coordinates: [x, y]
let: {e1: cos(Omega*t)*i + sin(Omega*t)*j, e2: -sin(Omega*t)*i + cos(Omega*t)*j}
particles: {P: {mass: m, position: x*e1 + y*e2 + a*(x^2 - y^2)/2*k}}
gravity: -g*k
"""
SPHERE = """
parameters: [m, l, g]
coordinates: [x, y, z]
particles: {P: {mass: m, position: x*i + y*j + z*k}}
constraints: {rod: x^2 + y^2 + z^2 = l^2}
gravity: -g*k
"""
ROD = """
parameters: [m, l, g, c]
coordinates: [theta]
bodies: {rod: {mass: m, inertia: m*l^2/12, position: l/2*sin(theta)*i + l/2*cos(theta)*j, angle: -theta}}
forces: {spring: {potential: c*theta^2/2}}
gravity: -g*j
"""
MAGNET = """
parameters: [m, q, B, c]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces: {lorentz: {on: P, vector: "q*B*y'*i - q*B*x'*j"}, hill: {potential: -c*(x^2 + y^2)/2}}
"""


def double(q, v, p):
    speed = p["l1"] ** 2 * v[0] ** 2 + p["l2"] ** 2 * v[1] ** 2
    speed += 2 * p["l1"] * p["l2"] * v[0] * v[1] * cos(q[0] - q[1])
    height = -p["l1"] * cos(q[0]), -p["l1"] * cos(q[0]) - p["l2"] * cos(q[1])
    kinetic = p["m1"] * p["l1"] ** 2 * v[0] ** 2 / 2 + p["m2"] * speed / 2
    return kinetic - p["m1"] * p["g"] * height[0] - p["m2"] * p["g"] * height[1]


def coupled(q, v, p):
    l, a = p["l"], p["a"]
    apart = sqrt((a + l * sin(q[1]) - l * sin(q[0])) ** 2 + (l * cos(q[1]) - l * cos(q[0])) ** 2)
    kinetic = p["m"] * l**2 * (v[0] ** 2 + v[1] ** 2) / 2
    return kinetic + p["m"] * p["g"] * l * (cos(q[0]) + cos(q[1])) - p["c"] * (apart - a) ** 2 / 2


def molecule(q, v, p):
    kinetic = p["m"] * (v[0] ** 2 + v[2] ** 2) / 2 + p["M"] * v[1] ** 2 / 2
    return kinetic - p["c"] * ((q[1] - q[0] - p["b"]) ** 2 + (q[2] - q[1] - p["b"]) ** 2) / 2


def hoop(q, v, p):
    kinetic = p["m"] * p["R"] ** 2 * (v[0] ** 2 + p["Omega"] ** 2 * sin(q[0]) ** 2) / 2
    return kinetic + p["m"] * p["g"] * p["R"] * cos(q[0])


def parabola(q, v, p):
    kinetic = p["m"] * (v[0] ** 2 * (1 + 4 * p["a"] ** 2 * q[0] ** 2) + p["Omega"] ** 2 * q[0] ** 2) / 2
    return kinetic - p["m"] * p["g"] * p["a"] * q[0] ** 2


def turning(q, v, p):
    """The kinetic energy of a particle in rotating axes."""
    return p["m"] * ((v[0] - p["Omega"] * q[1]) ** 2 + (v[1] + p["Omega"] * q[0]) ** 2) / 2


def saddle(q, v, p):
    rise = p["a"] * q[0] * v[0] - p["b"] * q[1] * v[1]
    kinetic = p["m"] * (v[0] ** 2 + v[1] ** 2 + rise**2) / 2
    return kinetic - p["m"] * p["g"] * (p["a"] * q[0] ** 2 - p["b"] * q[1] ** 2) / 2


def rotating_saddle(q, v, p):
    rise = p["a"] * (q[0] * v[0] - q[1] * v[1])
    return turning(q, v, p) + p["m"] * rise**2 / 2 - p["m"] * p["g"] * p["a"] * (q[0] ** 2 - q[1] ** 2) / 2


def cart(q, v, p):
    speed = v[0] ** 2 + 2 * p["l"] * v[0] * v[1] * cos(q[1]) + p["l"] ** 2 * v[1] ** 2
    springs = p["k"] * (q[0] ** 2 + p["l"] ** 2 * q[1] ** 2) / 2
    return p["M"] * v[0] ** 2 / 2 + p["m"] * speed / 2 - p["m"] * p["g"] * p["l"] * cos(q[1]) - springs


def spring_pendulum(q, v, p):
    kinetic = p["m"] * (v[0] ** 2 + q[0] ** 2 * v[1] ** 2) / 2
    return kinetic + p["m"] * p["g"] * q[0] * cos(q[1]) - p["c"] * (q[0] - p["l"]) ** 2 / 2


def sphere(sign):
    def of(q, v, p):
        z = sign * sqrt(p["l"] ** 2 - q[0] ** 2 - q[1] ** 2)
        rise = -(q[0] * v[0] + q[1] * v[1]) / z
        return p["m"] * (v[0] ** 2 + v[1] ** 2 + rise**2) / 2 - p["m"] * p["g"] * z

    return of


def rod(q, v, p):
    potential = p["m"] * p["g"] * p["l"] / 2 * cos(q[0]) + p["c"] * q[0] ** 2 / 2
    return p["m"] * p["l"] ** 2 * v[0] ** 2 / 6 - potential


def pendulum(q, v, p):
    return p["m"] * p["l"] ** 2 * v[0] ** 2 / 2 + p["m"] * p["g"] * p["l"] * cos(q[0])


def table(q, v, p):
    return turning(q, v, p) - p["c"] * q[0] ** 2 / 2 - p["k"] * q[1] ** 2 / 2


def magnet(q, v, p):
    potential = -p["c"] * (q[0] ** 2 + q[1] ** 2) / 2
    return p["m"] * (v[0] ** 2 + v[1] ** 2) / 2 - potential


def one_damper(q, v, p):
    potential = p["c"] * ((q[0] - p["l"]) ** 2 + (q[1] - q[0] - p["l"]) ** 2) / 2
    return p["m"] * (v[0] ** 2 + v[1] ** 2) / 2 - potential


def origin(*names: str) -> Callable[[Numbers], dict[str, mpf]]:
    return lambda _: dict.fromkeys(names, mpf(0))


def tilted(p: Numbers) -> mpf:
    return mp.acos(p["g"] / (p["Omega"] ** 2 * p["R"]))


SYSTEMS = {
    "pendulum": System(PENDULUM, pendulum, lambda _: [mpf(0)], origin("theta")),
    "pendulum-above": System(PENDULUM, pendulum, lambda _: [mp.pi], lambda _: {"theta": mp.pi}),
    "pendulum-in-x-and-y": System(
        IN_X_AND_Y, pendulum, lambda _: [mpf(0)], lambda p: {"x": mpf(0), "y": -p["l"]},
        lambda _, v, p: [-p["b"] * p["l"] ** 2 * v[0]]),
    "double-pendulum": System(DOUBLE, double, lambda _: [mpf(0)] * 2, origin("theta1", "theta2")),
    "double-pendulum-folded": System(
        DOUBLE, double, lambda _: [mpf(0), mp.pi], lambda _: {"theta1": mpf(0), "theta2": mp.pi}),
    "coupled": System(COUPLED, coupled, lambda _: [mpf(0)] * 2, origin("theta1", "theta2")),
    "coupled-above": System(
        COUPLED, coupled, lambda _: [mp.pi] * 2, lambda _: {"theta1": mp.pi, "theta2": mp.pi}),
    "molecule": System(
        MOLECULE, molecule, lambda p: [mpf(2), 2 + p["b"], 2 + 2 * p["b"]],
        lambda p: {"x1": mpf(2), "x2": 2 + p["b"], "x3": 2 + 2 * p["b"]}),
    "hoop-bottom": System(HOOP, hoop, lambda _: [mpf(0)], origin("theta")),
    "hoop-side": System(
        HOOP, hoop, lambda p: [tilted(p)], lambda p: {"theta": tilted(p)},
        exists=lambda p: p["g"] < p["Omega"] ** 2 * p["R"]),
    "parabola": System(PARABOLA, parabola, lambda _: [mpf(0)], origin("x")),
    "table": System(TABLE, table, lambda _: [mpf(0)] * 2, origin("x", "y")),
    "damped": System(
        DAMPED, lambda q, v, p: p["m"] * v[0] ** 2 / 2 - p["c"] * q[0] ** 2 / 2, lambda _: [mpf(0)], origin("x"),
        lambda _, v, p: [-p["b"] * v[0]]),
    "one-damper": System(
        ONE_DAMPER, one_damper, lambda p: [p["l"], 2 * p["l"]], lambda p: {"x1": p["l"], "x2": 2 * p["l"]},
        lambda _, v, p: [-p["b"] * (v[0] - v[1]), p["b"] * (v[0] - v[1])]),
    "cart": System(CART, cart, lambda _: [mpf(0)] * 2, origin("x", "theta")),
    "spring-pendulum": System(
        SPRING_PENDULUM, spring_pendulum, lambda p: [p["l"] + p["m"] * p["g"] / p["c"], mpf(0)],
        lambda p: {"r": p["l"] + p["m"] * p["g"] / p["c"], "phi": mpf(0)}),
    "saddle": System(SADDLE, saddle, lambda _: [mpf(0)] * 2, origin("x", "y", "z")),
    "rotating-saddle": System(ROTATING_SADDLE, rotating_saddle, lambda _: [mpf(0)] * 2, origin("x", "y")),
    "sphere-bottom": System(
        SPHERE, sphere(-1), lambda _: [mpf(0)] * 2, lambda p: {"x": mpf(0), "y": mpf(0), "z": -p["l"]}),
    "sphere-top": System(
        SPHERE, sphere(1), lambda _: [mpf(0)] * 2, lambda p: {"x": mpf(0), "y": mpf(0), "z": p["l"]}),
    "rod": System(ROD, rod, lambda _: [mpf(0)], origin("theta")),
    "magnet": System(
        MAGNET, magnet, lambda _: [mpf(0)] * 2, origin("x", "y"),
        lambda _, v, p: [p["q"] * p["B"] * v[1], -p["q"] * p["B"] * v[0]]),
}  # fmt: skip


def solved(text: str, find: str = "find: linearization") -> Solution:
    return solve(read_problem(Source("problem.yaml", f"title: T\n{text}\n{find}\n")))


def linear_equations(solution: Solution) -> Linearization:
    found = [solution.own.linearization, *(c.linearization for c in solution.choices)]
    return next(f for f in found if f is not None)


@cache
def of(system: System) -> Linearization:
    """The linear equations of a system, all checks of which hold."""
    solution = solved(system.text)
    assert solution.holds
    return linear_equations(solution)


def numbers(system: System, seed: int) -> Numbers:
    """Random values of the parameters."""
    random = Random(seed)
    names = system.text.split("parameters: [")[1].split("]")[0].split(", ")
    return {name: mpf(random.randint(20, 300)) / 100 for name in names}


def at_numbers(e: sp.Expr, values: dict[str, mpf]) -> mpc:
    rule = {s: sp.Float(str(values[s.name]), 40) for s in e.free_symbols}
    return mpc(sp.N(e.xreplace(rule), 40))


def there(found: Linearization, system: System, p: Numbers) -> SmallOscillations:
    """The linear equations of the branch that the equilibrium is on."""
    values = p | system.coordinates(p)
    fitting = [
        s
        for b, s in zip(found.branches, found.at, strict=True)
        if s is not None and all(abs(at_numbers(r.lhs - r.rhs, values)) < mpf(10) ** -20 for r in b.equations)
    ]
    assert len(fitting) == 1
    return fitting[0]
