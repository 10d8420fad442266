"""Small oscillations against numbers from hand-written Lagrangians: nothing of the program takes part in those.

Each system has its problem file, and L(q, v) with the generalized forces Q(q, v) of what has no potential, written by
hand in coordinates that need no constraints. The second derivatives of L are taken numerically at the equilibrium, also
given by hand, at random values of the parameters; det(M p² + D p + K) = 0 is solved in numbers.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

import pytest
import sympy as sp
from conftest import PROBLEMS
from mpmath import cos, diff, matrix, mp, mpc, mpf, polyroots, sin, sqrt

from lagrange.answers.examiner import compared_answers
from lagrange.core.diagnostics import NotCoveredError, ProblemError, Source
from lagrange.document.derivation import Detail, Display
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations
from lagrange.mechanics.equilibrium.stability import Verdict
from lagrange.mechanics.solution import Solution, solve
from lagrange.problem.loader import load, read_problem
from lagrange.render import terminal as pretty

mp.dps = 40
Numbers = dict[str, mpf]


@dataclass(frozen=True)
class System:
    """A system.

    text         its problem file, but for title and question
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
SEEDS = range(4)


def solved(text: str, find: str = "find: linearization") -> Solution:
    return solve(read_problem(Source("problem.yaml", f"title: T\n{text}\n{find}\n")))


def linear_equations(solution: Solution) -> Linearization:
    found = [solution.linearization, *(c.linearization for c in solution.choices)]
    return next(f for f in found if f is not None)


@pytest.fixture(scope="module")
def known() -> dict[str, Linearization]:
    return {}


def of(system: System, known: dict[str, Linearization]) -> Linearization:
    if system.text not in known:
        solution = solved(system.text)
        assert solution.holds
        known[system.text] = linear_equations(solution)
    return known[system.text]


def numbers(system: System, seed: int) -> Numbers:
    """Random values of the parameters."""
    random = Random(seed)
    names = system.text.split("parameters: [")[1].split("]")[0].split(", ")
    return {name: mpf(random.randint(20, 300)) / 100 for name in names}


def at_numbers(e: sp.Expr, values: dict[str, mpf]) -> mpc:
    rule = {s: sp.Float(str(values[s.name]), 40) for s in e.free_symbols}
    return mpc(sp.N(e.xreplace(rule), 40))


def exponents(system: System, p: Numbers) -> tuple[list[mpc], int]:
    """The roots of det(M p² + D p + K), from the Lagrangian in numbers, and their number."""
    q0 = system.place(p)
    n = len(q0)
    at = [*q0, *[mpf(0)] * n]

    def second(i: int, j: int) -> mpf:
        order = [0] * (2 * n)
        order[i] += 1
        order[j] += 1
        return diff(lambda *s: system.lagrangian(s[:n], s[n:], p), tuple(at), tuple(order))

    def of_force(i: int, j: int) -> mpf:
        if system.force is None:
            return mpf(0)
        order = [0] * (2 * n)
        order[j] = 1
        return diff(lambda *s: system.force(s[:n], s[n:], p)[i], tuple(at), tuple(order))

    mass = matrix(n, n)
    rate = matrix(n, n)
    stiff = matrix(n, n)
    for i in range(n):
        for j in range(n):
            mass[i, j] = second(n + i, n + j)
            rate[i, j] = second(n + i, j) - second(i, n + j) - of_force(i, n + j)
            stiff[i, j] = -second(i, j) - of_force(i, j)
    nodes = [mpf(k) for k in range(-n, n + 1)]
    values = [mp.det(mass * x**2 + rate * x + stiff) for x in nodes]
    powers = matrix([[x**k for k in range(2 * n, -1, -1)] for x in nodes])
    coefficients = list(mp.lu_solve(powers, matrix(values)))
    cleaned = [c if abs(c) > mpf(10) ** -12 else mpf(0) for c in coefficients]
    return polyroots(cleaned, maxsteps=500, extraprec=400), 2 * n


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


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", SYSTEMS)
def test_frequencies_and_stability_are_those_of_the_numbers(
    name: str, seed: int, known: dict[str, Linearization]
) -> None:
    system = SYSTEMS[name]
    found = of(system, known)
    p = numbers(system, seed)
    if not system.exists(p):
        p["Omega"] *= 12
    s = there(found, system, p)
    wanted, number = exponents(system, p)
    values = p | system.coordinates(p)

    polynomial = sp.Poly(s.characteristic, s.unknown)
    assert polynomial.degree() == number
    scale = sum(abs(at_numbers(c, values)) for c in polynomial.all_coeffs())
    for root in wanted:
        unknown = mpc(0, -1) * root if s.oscillates else root
        at = sum(at_numbers(c, values) * unknown**k for (k,), c in polynomial.terms())
        assert abs(at) < scale * (1 + abs(unknown)) ** number * mpf(10) ** -9

    closed = [f for f in s.frequencies if f.square is not None]
    if s.oscillates and len(closed) == len(s.frequencies):
        stated = sorted((at_numbers(f.square, values).real for f in closed for _ in range(f.multiplicity)), key=float)
        squares = sorted((-(r**2) for r in wanted), key=lambda z: float(z.real))[::2]
        for a, b in zip(stated, squares, strict=True):
            if abs(b.imag) < mpf(10) ** -8:
                assert abs(a - b.real) < mpf(10) ** -6 * (1 + abs(b))

    grows = max(r.real for r in wanted) > mpf(10) ** -6
    judged = s.judgement.stability
    if judged.verdict is Verdict.CONDITIONAL:
        holds = all(
            at_numbers(c.lhs - c.rhs, values).real * (1 if c.relation == ">" else -1) > 0 for c in judged.conditions
        )
        assert holds == (not grows)
    elif judged.verdict is not Verdict.UNDECIDED:
        assert grows == (judged.verdict is Verdict.UNSTABLE)
    if s.judgement.asymptotic and judged.verdict is Verdict.STABLE:
        assert max(r.real for r in wanted) < 0


def test_both_regimes_were_met(known: dict[str, Linearization]) -> None:
    """The conditions of the tests above are true at some of their values and false at others."""
    for name in ("hoop-bottom", "parabola", "rod", "magnet"):
        found = of(SYSTEMS[name], known)
        met = set()
        for seed in range(12):
            p = numbers(SYSTEMS[name], seed)
            s = there(found, SYSTEMS[name], p)
            assert s.judgement.stability.verdict is Verdict.CONDITIONAL
            met.add(all(at_numbers(c.lhs - c.rhs, p).real * (1 if c.relation == ">" else -1) > 0
                        for c in s.judgement.stability.conditions))  # fmt: skip
        assert met == {True, False}, name


# Modes, verdicts, answers, what is refused


def test_published_modes_of_the_molecule(known: dict[str, Linearization]) -> None:
    """Goldstein, section 6.4: ω = 0, √(k/m), √(k/m (1 + 2m/M)), with (1, 1, 1), (1, 0, −1), (1, −2m/M, 1)."""
    m, M, c = sp.symbols("m M c", positive=True)
    [s] = of(SYSTEMS["molecule"], known).at
    assert s is not None
    wanted = [(0, (1, 1, 1)), (c / m, (1, 0, -1)), (c / m * (1 + 2 * m / M), (1, -2 * m / M, 1))]
    for f, (square, mode) in zip(s.frequencies, wanted, strict=True):
        assert sp.cancel(f.square - square) == 0
        [found] = f.modes
        assert all(sp.cancel(a - b) == 0 for a, b in zip(found, mode, strict=True))
    assert s.judgement.stability.verdict is Verdict.UNDECIDED  # it may drift


def test_modes_of_the_double_pendulum(known: dict[str, Linearization]) -> None:
    """Every mode satisfies (K − ω² M) a = 0 in numbers, and different ones are orthogonal."""
    system = SYSTEMS["double-pendulum"]
    found = of(system, known)
    for seed in SEEDS:
        p = numbers(system, seed)
        s = there(found, system, p)
        mass, stiff = (
            matrix([[at_numbers(e, p) for e in row] for row in x]) for x in (s.system.mass, s.system.stiffness)
        )
        modes = [matrix([at_numbers(a, p) for a in f.modes[0]]) for f in s.frequencies]
        for f, mode in zip(s.frequencies, modes, strict=True):
            assert mp.norm((stiff - at_numbers(f.square, p) * mass) * mode) < mpf(10) ** -25
        assert abs((modes[0].T * mass * modes[1])[0]) < mpf(10) ** -25


DEGENERATE = """
parameters: [m, c, b]
coordinates: [x, y, z]
particles: {A: {mass: m, position: x*i}, B: {mass: m, position: y*i}, C: {mass: m, position: z*i}}
forces: {ring: {potential: c*((x - y)^2 + (y - z)^2 + (z - x)^2)/2 + b*(x + y + z)^2/2}}
"""


def test_a_frequency_that_belongs_to_two_modes() -> None:
    [s] = linear_equations(solved(DEGENERATE)).at
    assert s is not None
    assert sorted((str(f.square), f.multiplicity, len(f.modes)) for f in s.frequencies) == [
        ("3*b/m", 1, 1),
        ("3*c/m", 2, 2),
    ]


TRIPLE = """
parameters: [m, l, g]
coordinates: [a, b, c]
particles:
  P: {mass: m, position: l*sin(a)*i - l*cos(a)*j}
  Q: {mass: m, position: r_P + l*sin(b)*i - l*cos(b)*j}
  R: {mass: m, position: r_Q + l*sin(c)*i - l*cos(c)*j}
gravity: -g*j
"""


def test_a_cubic_equation_stays_an_equation() -> None:
    """The triple pendulum: x³ − 9x² + 18x − 6 = 0 for x = ω² l/g, Laguerre's polynomial; stable all the same."""
    s = linear_equations(solved(TRIPLE)).at[0]
    assert s is not None
    [f] = s.frequencies
    assert f.square is None
    x, g, l = f.letter, *sp.symbols("g l", positive=True)
    polynomial = sp.Poly(f.factor.xreplace({x: x * g / l}), x).monic()
    assert polynomial.all_coeffs() == [1, -9, 18, -6]
    assert s.judgement.stability.verdict is Verdict.STABLE


def test_the_second_variation_says_the_same() -> None:
    """Stability from `stability`, by statics, at every equilibrium of systems at rest that do not turn."""
    for text in (PENDULUM, DOUBLE, CART, SPRING_PENDULUM, ROD, IN_X_AND_Y.replace("forces", "answers: {}\n#")):
        solution = solved(text, "find: [equilibrium, linearization]")
        found = linear_equations(solution)
        assert solution.equilibrium is not None
        assert solution.stability is not None
        assert [b.relations for b in solution.equilibrium.branches] == [b.relations for b in found.branches]
        for by_variation, s in zip(solution.stability.verdicts, found.at, strict=True):
            if s is not None and by_variation.verdict is not Verdict.UNDECIDED:
                assert by_variation.verdict is s.judgement.stability.verdict
                assert {str(c) for c in by_variation.conditions} == {str(c) for c in s.judgement.stability.conditions}


def test_one_damped_coordinate(known: dict[str, Linearization]) -> None:
    [s] = of(SYSTEMS["damped"], known).at
    m, c, b = sp.symbols("m c b", positive=True)
    assert s is not None
    assert s.damped is not None
    assert s.damped.own == c / m
    assert sp.cancel(s.damped.square - (c / m - b**2 / (4 * m**2))) == 0
    assert sp.cancel(s.damped.rate - b / (2 * m)) == 0


NONHOLONOMIC = """
parameters: [m, J, c, k]
coordinates: [x, y, theta]
bodies: {skate: {mass: m, inertia: J, position: x*i + y*j, angle: theta}}
constraints: {blade: "x'*sin(theta) = y'*cos(theta)"}
forces: {springs: {potential: c*x^2/2 + k*theta^2/2}}
"""


def test_a_kinematic_constraint() -> None:
    """A skate at rest along the x axis: across the blade it stays, along it and about it there are springs."""
    found = linear_equations(solved(NONHOLONOMIC))
    [s] = [s for s in found.at if s is not None]
    assert [found.configuration.slots.coordinates[k].name for k in s.free] == ["x", "theta"]
    assert {str(f.square) for f in s.frequencies} == {"c/m", "k/J"}


PULLED = NONHOLONOMIC.replace("k]", "k, f]").replace("c*x^2/2", "c*(x - y)^2/2 - f*y")


def test_a_reaction_that_turns_with_the_body() -> None:
    """At rest the blade bears λ = f; turned by ξ_3 it pushes the skate along: m ξ_1'' + c ξ_1 − f ξ_3 = 0."""
    [s] = [s for s in linear_equations(solved(PULLED)).at if s is not None]
    c, k, f = sp.symbols("c k f", positive=True)
    stiffness = sp.Matrix(s.system.stiffness)
    assert stiffness == sp.Matrix([[c, -f], [0, k]])
    assert not s.system.symmetric


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (PENDULUM.replace("gravity: -g*j", "unknowns: [N]\nforces: {push: {on: P, vector: N*i}}"), "unknown forces"),
        (HOOP.replace("gravity: -g*k", "forces: {wind: {on: P, vector: g*cos(Omega*t)*k}}"), "contain time"),
        (HOOP.replace("Omega*t", "u").replace("coordinates", "functions: {u: [t]}\ncoordinates"), "prescribed motion"),
        (SPHERE.replace("rod: x^2", "rod: (x - m*t)^2"), "moving constraint `rod`"),
        (SPHERE.replace("rod: x^2 + y^2 + z^2 = l^2", "rate: x'^2 + y'^2 = l^2"), "not linear in the velocities"),
        (IN_X_AND_Y.replace("{air:", "{rub: {friction: b, constraint: rod, on: P}, air:"), "dry friction"),
    ],
)
def test_what_is_refused(text: str, said: str) -> None:
    with pytest.raises(NotCoveredError, match=said) as caught:
        solved(text)
    assert caught.value.exit_status == 3


PASS = """
parameters: [m, c, f]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces: {saddle: {potential: c*x^2/2 - f*y^2/2}}
"""


@pytest.mark.parametrize(
    ("text", "stated", "verdict"),
    [
        (PENDULUM, "[sqrt(g/l)]", "equivalent"),
        (PENDULUM, "[-sqrt(g/l)]", "equivalent"),
        (PENDULUM, "[sqrt(l/g)]", "wrong"),
        (PENDULUM, "[g*i]", "unreadable"),
        (DOUBLE, "[sqrt(g/l1)]", "wrong"),
        (COUPLED, '[sqrt(g/l), "sqrt(g/l + 2*c/m)"]', "equivalent"),
        (COUPLED, '["sqrt(g/l + 2*c/m)"]', "incomplete"),
        (COUPLED, '["sqrt(g/l + 2*c/m)", "-sqrt(g/l + 2*c/m)"]', "incomplete"),
        (COUPLED, '[sqrt(g/l), "sqrt(g/l + c/m)"]', "wrong"),
        (MOLECULE, '[0, sqrt(c/m), "sqrt(c/m*(1 + 2*m/M))"]', "equivalent"),
        (MOLECULE, '[sqrt(c/m), "sqrt(c/m*(1 + 2*m/M))"]', "equivalent"),
        (HOOP, '[["sqrt(g/R - Omega^2)"], ["sqrt(Omega^2 - g^2/(Omega^2*R^2))"]]', "equivalent"),
        (HOOP, '[["sqrt(g/R - Omega^2)"], ["sqrt(g/R + Omega^2)"]]', "wrong"),
        (DAMPED, "[sqrt(c/m)]", "undecided"),
        (PASS, "[sqrt(c/m)]", "equivalent"),  # ω² = −f/m grows, and is no frequency
        (PASS, "[sqrt(f/m)]", "wrong"),
    ],
)
def test_stated_frequencies(text: str, stated: str, verdict: str) -> None:
    solution = solved(text, f"find: linearization\nanswers: {{frequencies: {stated}}}")
    [answer] = compared_answers(solution)
    assert answer.name == "frequencies"
    assert answer.verdict.value == verdict


def test_an_imaginary_frequency_cannot_be_stated() -> None:
    with pytest.raises(ProblemError, match="state the real frequencies only") as caught:
        solved(PASS, 'find: linearization\nanswers: {frequencies: [sqrt(c/m), "sqrt(-f/m)"]}')
    assert [d.code for d in caught.value.diagnostics] == ["not-real"]


def test_equilibria_of_the_motion_in_answers() -> None:
    stated = '[["theta = 0"], ["theta = pi"], ["cos(theta) = g/(Omega^2*R)"]]'
    for wrong in (False, True):
        text = stated.replace("Omega^2", "Omega") if wrong else stated
        [answer] = compared_answers(solved(HOOP, f"find: linearization\nanswers: {{equilibrium: {text}}}"))
        assert (answer.verdict.value == "equivalent") != wrong


SPRUNG_CART = """
title: Cart with a spring and a pendulum
parameters: [M, m, g, l, c]
coordinates: [x, theta]
particles:
  A: {mass: M, position: x*i}
  B: {mass: m, position: r_A + l*sin(theta)*i - l*cos(theta)*j}
forces: {pull: {potential: c*x^2/2}}
gravity: -g*j
find: [motion, linearization]
"""


def test_a_long_mode_has_lines_of_its_own() -> None:
    """−ω² (M + m) ξ₁ − ω² m l ξ₂ + c ξ₁ = 0 holds for what each pair of lines says."""
    steps = report(read_problem(Source("cart", SPRUNG_CART))).derivation.steps
    displays = (b for step in steps for b in step.body if isinstance(b, Display))
    roots = next(d for d in displays if any(str(e.sides[0]).startswith("omega_1") for e in d.equations))
    assert [str(e.sides[0]) for e in roots.equations] == ["omega_1**2", "xi_2/xi_1", "omega_2**2", "xi_2/xi_1"]
    M, m, g, l, c = sp.symbols("M m g l c", positive=True)
    values = {M: 3, m: 2, g: 10, l: sp.Rational(1, 2), c: 7}
    for square, ratio in zip(roots.equations[::2], roots.equations[1::2], strict=True):
        w, r = (e.sides[1].subs(values) for e in (square, ratio))
        assert sp.radsimp(sp.expand(-w * 5 - w * r + 7)) == 0


def test_modes_of_a_follower_force_and_what_they_presuppose() -> None:
    """(2c − l P) (l P − 2c) once stood below the line."""
    [path] = PROBLEMS.rglob("ziegler-column.yaml")
    found = solve(load(str(path))).linearization
    assert found is not None
    [s] = [s for s in found.at if s is not None]
    for f in s.frequencies:
        [(first, second)] = f.modes
        assert first == 1
        assert sp.fraction(second)[1].count_ops() <= 5
        assert [(c.relation, str(c.lhs), str(c.rhs)) for c in f.presupposed] == [("≠", "2*c", "P*l")]


def test_roots_that_may_be_equal_are_stable_where_they_are_not() -> None:
    """c/m and κ/J with a force between them one way only: at c J = κ m there is resonance."""
    [path] = PROBLEMS.rglob("skate-on-springs.yaml")
    found = solve(load(str(path))).linearization
    assert found is not None
    [s] = [s for s in found.at if s is not None]
    stability = s.judgement.stability
    assert stability.verdict is Verdict.CONDITIONAL
    assert [c.relation for c in stability.conditions] == ["≠"]
    assert {str(c.lhs) for f in s.frequencies for c in f.presupposed} == {"y"}


def test_brief_names_the_small_changes_where_they_are_used() -> None:
    told = report(load(str(next(PROBLEMS.rglob("ziegler-column.yaml")))))
    brief = pretty.text(told.derivation, told.notation, 80, Detail.BRIEF)
    assert "Let ξ₁ and ξ₂ be the small changes of θ and ψ from rest.\n" in brief


CAM = """
axes: {i: right, j: up}
parameters: [m, J, a, b, g]
coordinates: [x, y, theta]
bodies: {cam: {mass: m, inertia: J, position: x*i + y*j, angle: theta}}
constraints: {contact: y = sqrt(a^2*sin(theta)^2 + b^2*cos(theta)^2)}
gravity: -g*j
"""


def test_a_zero_root_beside_one_that_may_be_negative() -> None:
    """An ellipse on smooth ground may glide away; upright (y = a at θ = π/2) it falls over where a > b."""
    solution = solved(CAM, "find: [equilibrium, linearization]")
    found = linear_equations(solution)
    a, b = sp.symbols("a b", positive=True)
    theta, y = (sp.Symbol(n, real=True) for n in ("theta", "y"))
    assert solution.stability is not None
    for branch, s, second in zip(found.branches, found.at, solution.stability.verdicts, strict=True):
        at = {r.lhs: r.rhs for r in branch.relations}
        upright = at[theta] in (sp.pi / 2, -sp.pi / 2)
        assert at[y] == (a if upright else b)
        assert s is not None
        for stability in (s.judgement.stability, second):
            assert stability.verdict is Verdict.UNDECIDED
            [condition] = stability.unstable
            larger = condition.lhs if condition.relation == ">" else condition.rhs
            assert {condition.lhs, condition.rhs} == {a, b}
            assert larger == (a if upright else b)
    told = report(read_problem(Source("cam", f"title: cam\n{CAM}find: linearization\n")))
    page = " ".join(pretty.text(told.derivation, told.notation, 80, Detail.STEPS).split())
    assert "is unstable where a > b. To the root zero belongs a uniform motion" in page


SPUN_TOP = """
parameters: [m, A, C, g, l, Omega]
coordinates: [alpha, beta]
bodies:
  top: {mass: m, inertia: [A, A, C], position: l*e3_top, orientation: {axes: 123, angles: [alpha, beta, Omega*t]}}
gravity: -g*k
"""


def test_a_sleeping_top_by_one_condition() -> None:
    """Klein and Sommerfeld: C² Ω² > 4 (A + m l²) m g l, which implies the condition with 2 for 4."""
    found = linear_equations(solved(SPUN_TOP))
    m, A, C, g, l, Omega = sp.symbols("m A C g l Omega", positive=True)
    alpha, beta = (sp.Symbol(n, real=True) for n in ("alpha", "beta"))
    [upright] = [n for n, b in enumerate(found.branches) if {r.lhs: r.rhs for r in b.relations} == {alpha: 0, beta: 0}]
    s = found.at[upright]
    assert s is not None
    [condition] = s.judgement.stability.conditions
    assert condition.relation == ">"
    assert sp.expand(condition.lhs - condition.rhs - C**2 * Omega**2 + 4 * m * g * l * (A + m * l**2)) == 0
    for f in s.frequencies:  # without the common factor (A + m l²)²
        assert f.square is not None
        assert f.square.count_ops() < 50


POLAR_SPRING = """
parameters: [m, c, l, g]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
gravity: g*i
forces: {spring: {spring: c, between: [0*i, P], length: l}}
"""


def test_the_sign_in_a_spring_has_a_derivative_away_from_its_jump() -> None:
    """The spring's length is |r|; at r = l + m g/c, φ = 0 small motions have ω² = c/m and g/(l + m g/c)."""
    found = linear_equations(solved(POLAR_SPRING))
    m, c, l, g = sp.symbols("m c l g", positive=True)
    assert all(s is not None for s in found.at)
    r = sp.Symbol("r", real=True)
    [lowest] = [
        s
        for b, s in zip(found.branches, found.at, strict=True)
        if any(sp.cancel(x.rhs - l - m * g / c) == 0 for x in b.relations if x.lhs == r)
    ]
    assert lowest is not None
    assert {sp.cancel(f.square) for f in lowest.frequencies if f.square is not None} == {c / m, c * g / (m * g + c * l)}
    assert lowest.judgement.stability.verdict is Verdict.STABLE


TILTED = """
parameters: [m, c, l, g, Omega, alpha]
coordinates: [s]
particles: {P: {mass: m, position: s*sin(alpha)*(cos(Omega*t)*i + sin(Omega*t)*j) + s*cos(alpha)*k}}
gravity: -g*k
forces: {spring: {potential: c*(s - l)^2/2}}
"""


def test_what_is_divided_by_is_said_with_angles_of_parameters_in_it() -> None:
    """s (c − m Ω² sin² α) = c l − m g cos α on a wire that turns, inclined by α: c ≠ m Ω² sin² α."""
    [branch] = linear_equations(solved(TILTED)).branches
    m, c, Omega, alpha = sp.symbols("m c Omega alpha", positive=True)
    [condition] = branch.conditions
    assert condition.relation == "≠"
    assert sp.expand(condition.lhs - condition.rhs - c + m * Omega**2 * sp.sin(alpha) ** 2) == 0
