"""Hamilton's function against Legendre's transformation in numbers, and the canonical equations against its differences.

The Lagrangians are written down here a second time, by hand, as functions of numbers. At random q and p the velocities
are found by Newton's method on p = ∂L/∂q', H is p·q' − L there, and its slopes are central differences.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from math import cos, sin

import numpy as np
import pytest
import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.symbols import t
from lagrange.mechanics.momenta.hamiltonian import Hamiltonian, completed_squares
from lagrange.mechanics.solution import solve
from tests.support.problem_texts import read

Lagrangian = Callable[[Sequence[float], Sequence[float], float], float]

m, g, l, A, C, k, B, w, a = 1.3, 9.7, 0.8, 0.7, 0.45, 2.1, 0.9, 1.7, 0.3
VALUES = {"m": m, "g": g, "l": l, "A": A, "C": C, "k": k, "B": B, "Omega": w, "a": a}

PLANE = "axes: {i: right, j: down}\n"
PENDULUM = """
particles: {P: {mass: m, position: "l*sin(theta)*i + l*cos(theta)*j"}}
gravity: g*j
"""
DOUBLE = """
particles:
  P: {mass: m, position: "l*sin(u)*i + l*cos(u)*j"}
  Q: {mass: B, position: "(l*sin(u) + a*sin(v))*i + (l*cos(u) + a*cos(v))*j"}
gravity: g*j
"""
TOP = """
bodies: {top: {mass: m, inertia: [A, A, C], position: 0*i, orientation: {axes: 313, angles: [phi, theta, psi]}}}
forces: {weight: {potential: m*g*l*cos(theta)}}
"""


def pendulum(q: Sequence[float], v: Sequence[float], _: float) -> float:
    return m * l**2 * v[0] ** 2 / 2 + m * g * l * cos(q[0])


def double(q: Sequence[float], v: Sequence[float], _: float) -> float:
    mixed = l * a * v[0] * v[1] * cos(q[0] - q[1])
    kinetic = m * l**2 * v[0] ** 2 / 2 + B * (l**2 * v[0] ** 2 / 2 + a**2 * v[1] ** 2 / 2 + mixed)
    return kinetic + m * g * l * cos(q[0]) + B * g * (l * cos(q[0]) + a * cos(q[1]))


def shaken(q: Sequence[float], v: Sequence[float], time: float) -> float:
    """A pendulum whose support moves as a cos wt downwards."""
    down = -a * w * sin(w * time) - l * v[0] * sin(q[0])
    return m * ((l * v[0] * cos(q[0])) ** 2 + down**2) / 2 + m * g * (a * cos(w * time) + l * cos(q[0]))


def polar(q: Sequence[float], v: Sequence[float], _: float) -> float:
    return m * (v[0] ** 2 + q[0] ** 2 * v[1] ** 2) / 2 - k * q[0] ** 2 / 2


def turning(q: Sequence[float], v: Sequence[float], _: float) -> float:
    """In coordinates that turn: a term linear in the velocities, and one without."""
    return m * ((v[0] - w * q[1]) ** 2 + (v[1] + w * q[0]) ** 2) / 2


TURNING = '{mass: m, position: "(x*cos(Omega*t) - y*sin(Omega*t))*i + (x*sin(Omega*t) + y*cos(Omega*t))*j"}'
CASES = {
    "pendulum": ("[theta]", "[m, g, l]", PLANE + PENDULUM, pendulum),
    "double pendulum": ("[u, v]", "[m, B, g, l, a]", PLANE + DOUBLE, double),
    "shaken pendulum": (
        "[theta]",
        "[m, g, l, a, Omega]",
        PLANE + PENDULUM.replace('*j"}}', '*j + a*cos(Omega*t)*j"}}'),
        shaken,
    ),
    "polar": (
        "[r, phi]",
        "[m, k]",
        'particles: {P: {mass: m, position: "r*cos(phi)*i + r*sin(phi)*j"}}\nforces: {V: {potential: k*r^2/2}}\n',
        polar,
    ),
    "turning": ("[x, y]", "[m, Omega]", f"particles: {{P: {TURNING}}}\n", turning),
}


def found_in(coordinates: str, parameters: str, text: str) -> Hamiltonian:
    solution = solve(read(f"title: T\ncoordinates: {coordinates}\nparameters: {parameters}\n{text}find: hamiltonian\n"))
    assert solution.holds
    assert solution.own.hamiltonian is not None
    return solution.own.hamiltonian


def legendre(lagrangian: Lagrangian, q: Sequence[float], p: Sequence[float], time: float) -> tuple[float, np.ndarray]:
    """H(q, p, t) and the velocities. L is quadratic in them, so that differences of any step are exact."""
    n = len(q)
    e = np.eye(n)

    def slope(v: np.ndarray) -> np.ndarray:
        return np.array([(lagrangian(q, v + d, time) - lagrangian(q, v - d, time)) / 2 for d in e])

    zero = np.zeros(n)
    b = slope(zero)
    mass = np.array([slope(d) - b for d in e])
    v = np.linalg.solve(mass, np.array(p) - b)
    return float(np.dot(p, v)) - lagrangian(q, v, time), v


@pytest.mark.parametrize("name", CASES)
def test_it_is_legendres_transform_and_its_slopes_are_the_equations(name: str) -> None:
    *text, lagrangian = CASES[name]
    found = found_in(*text)
    rng = random.Random(name)
    n, h = len(found.coordinates), 1e-5
    for _ in range(3):
        q, p, time = (
            [rng.uniform(0.4, 1.4) for _ in range(n)],
            [rng.uniform(-1, 1) for _ in range(n)],
            rng.uniform(0, 2),
        )
        values = {
            sp.Symbol(s, **assumed): x for s, x in VALUES.items() for assumed in ({"positive": True}, {"real": True})
        }
        values |= dict(zip((*found.coordinates, *found.momenta), (*q, *p), strict=True)) | {t: time}

        def number(e: sp.Expr, at: Mapping[sp.Symbol, float] = values) -> float:
            return float(e.xreplace({s: sp.Float(v) for s, v in at.items()}))

        H, v = legendre(lagrangian, q, p, time)
        assert number(found.function) == pytest.approx(H, rel=1e-9)
        assert [number(e) for e in found.velocities] == pytest.approx(list(v), rel=1e-9)
        for i, rate in enumerate(found.rates):
            up, down = [*q], [*q]
            up[i], down[i] = q[i] + h, q[i] - h
            slope = (legendre(lagrangian, up, p, time)[0] - legendre(lagrangian, down, p, time)[0]) / (2 * h)
            assert number(rate) == pytest.approx(-slope, rel=1e-6, abs=1e-7)


def test_it_is_the_energy_only_where_the_positions_are_free_of_time() -> None:
    assert found_in(*CASES["double pendulum"][:3]).is_energy
    turning_frame = found_in(*CASES["turning"][:3])
    assert turning_frame.is_energy is False
    assert not turning_frame.depends_on_time
    assert found_in(*CASES["shaken pendulum"][:3]).depends_on_time


def test_the_heavy_top_has_the_form_of_the_books() -> None:
    x, p, q, r = sp.symbols("theta p_phi p_theta p_psi", real=True)
    found = found_in("[phi, theta, psi]", "[m, g, l, A, C]", TOP)
    mass, gravity, arm, across, axial = sp.symbols("m g l A C", positive=True)
    expected = q**2 / (2 * across) + (p - r * sp.cos(x)) ** 2 / (2 * across * sp.sin(x) ** 2) + r**2 / (2 * axial)
    assert sp.simplify(found.function - expected - mass * gravity * arm * sp.cos(x)) == 0
    assert found.cyclic == (0, 2)
    assert (p - r * sp.cos(x)) in found.function.atoms(sp.Add)  # the square of books, not multiplied out
    assert found.routhian is not None
    assert sp.simplify(found.routhian + found.function - across * sp.Symbol("theta'", real=True) ** 2 / 2
                       - q**2 / (2 * across)) == 0  # fmt: skip


def test_forces_without_a_potential_stay_in_the_equations() -> None:
    text = 'particles: {P: {mass: m, position: x*i}}\nforces: {drag: {on: P, vector: "-k*x\'*i"}}\n'
    found = found_in("[x]", "[m, k]", text)
    mass, factor = sp.symbols("m k", positive=True)
    assert found.rates == (-factor * found.momenta[0] / mass,)
    assert found.cyclic == ()


def test_names_of_the_file_are_left_alone() -> None:
    found = found_in("[theta]", "[m, g, l, p_theta]", PLANE + PENDULUM)
    assert found.momenta[0].name == "P_theta"


@pytest.mark.parametrize(
    "text",
    [
        "coordinates: [x, y]\nparameters: [m, l]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
        "constraints: {rod: x^2 + y^2 = l^2}\n",
        "coordinates: [x, y, theta]\nparameters: [m, I]\n"
        "bodies: {B: {mass: m, inertia: I, position: x*i + y*j, angle: theta}}\n"
        "constraints: {blade: \"x'*sin(theta) - y'*cos(theta) = 0\"}\n",
    ],
)
def test_coordinates_that_are_not_free_are_refused(text: str) -> None:
    with pytest.raises(NotCoveredError, match="not free"):
        solve(read(f"title: T\n{text}find: hamiltonian\n"))


def test_a_choice_of_free_coordinates_serves() -> None:
    text = (
        "title: T\ncoordinates: [x, y]\nparameters: [m, l]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
        "constraints: {rod: x^2 + y^2 = l^2}\nfind: hamiltonian\n"
        "generalized_coordinates: {angle: {coordinates: [u], substitute: {x: l*sin(u), y: l*cos(u)}}}\n"
    )
    solution = solve(read(text))
    assert solution.own.hamiltonian is None
    [choice] = solution.choices
    assert choice.hamiltonian is not None
    assert str(choice.hamiltonian.function) == "p_u**2/(2*l**2*m)"


def test_a_singular_form_has_no_squares() -> None:
    solution = solve(read(f"title: T\ncoordinates: [theta]\nparameters: [m, g, l]\n{PLANE + PENDULUM}"))
    one = sp.S.One
    assert completed_squares([[one, one], [one, one]], sp.symbols("p q"), solution.own.configuration.states) is None


# -- Rolling that can be integrated leaves free coordinates ------------------------------------------------------------


ROLLING = """title: t
parameters: [m, M, R, alpha, g]
coordinates: [X, s, theta]
particles: {wedge: {mass: M, position: X*i}}
bodies:
  cylinder: {mass: m, inertia: m*R^2/2, position: "(X + s*cos(alpha))*i - s*sin(alpha)*j", angle: theta}
constraints: {rolling: s' + R*theta' = 0}
gravity: -g*j
find: hamiltonian
"""


@pytest.mark.parametrize("choice", ["", "generalized_coordinates: {two: {coordinates: [X, s]}}\n"])
def test_rolling_that_integrates_leaves_free_coordinates(choice: str) -> None:
    """H of a cylinder that rolls on a wedge, by ½ p·M⁻¹p with M = [[M + m, m cos], [m cos, 3/2 m]]."""
    solution = solve(read(ROLLING + choice))
    assert solution.holds
    [found] = [v.hamiltonian for v in solution.views if v.hamiltonian is not None]
    assert [str(q) for q in found.integrated] == ["theta"]
    mass, wedge, tilt, height = 1.3, 3.1, 0.4, 0.7
    inertia = np.array([[wedge + mass, mass * cos(tilt)], [mass * cos(tilt), 1.5 * mass]])
    p = np.array([0.9, -1.7])
    expected = p @ np.linalg.solve(inertia, p) / 2 - mass * 9.7 * height * sin(tilt)
    values = {"m": mass, "M": wedge, "alpha": tilt, "g": 9.7, "s": height, "p_X": p[0], "p_s": p[1], "R": 0.2}
    value = found.function.xreplace({x: sp.Float(values[x.name]) for x in found.function.free_symbols})
    assert float(value) == pytest.approx(expected)


def test_a_blade_leaves_no_free_coordinates() -> None:
    text = """title: t
parameters: [m, I]
coordinates: [x, y, theta]
bodies: {skate: {mass: m, inertia: I, position: x*i + y*j, angle: theta}}
constraints: {blade: "y'*cos(theta) = x'*sin(theta)"}
find: hamiltonian
"""
    with pytest.raises(NotCoveredError, match="`blade` still acts"):
        solve(read(text))


# -- A Lagrangian whose momenta are not linear in the velocities -------------------------------------------------------


@pytest.mark.parametrize(
    ("lagrangian", "expected"),
    [
        ("-m*c^2*sqrt(1 - (r'^2 + r^2*phi'^2)/c^2) + K/r", "sqrt(m^2*c^4 + c^2*(p_r^2 + p_phi^2/r^2)) - K/r"),
        (
            "-m*c^2*sqrt(1 - (r'^2 + r^2*phi'^2)/c^2) + K*r^2*phi'",
            "c*sqrt(m^2*c^2 + p_r^2 + (p_phi - K*r^2)^2/r^2)",
        ),
    ],
)
def test_a_fast_particle(lagrangian: str, expected: str) -> None:
    """Goldstein, § 8.4: T + m c² = √(p² c² + m² c⁴), in a central field and with a potential linear in the velocity."""
    solution = solve(
        read(f"title: T\ncoordinates: [r, phi]\nparameters: [m, c, K]\nlagrangian: {lagrangian}\nfind: hamiltonian\n")
    )
    found = solution.own.hamiltonian
    assert found is not None
    assert solution.holds
    assert [found.coordinates[k].name for k in found.cyclic] == ["phi"]
    names = {s.name: s for s in found.function.free_symbols}
    wanted = sp.sympify(expected.replace("^", "**"), locals=names)
    values = {s: sp.Rational(n + 3, 7) for n, s in enumerate(sorted(found.function.free_symbols, key=str))}
    assert abs(float((found.function - wanted).xreplace(values))) < 1e-12
