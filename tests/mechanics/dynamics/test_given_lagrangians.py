"""Lagrangians given outright, and potentials that depend on velocities, against numbers.

The Lagrangian of each shipped problem is typed again in Python. Its action between two instants, over a polyline through
a curve q(t), is a function of the values of q; its derivative by one of them is Lagrange's expression, in numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import cos, sin, sqrt

import numpy as np
import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.solution import solve
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.support.problem_texts import read
from tests.support.shared import reported

VALUES = {
    "m": 1.3,
    "c": 4.7,
    "k": 2.1,
    "L_c": 0.9,
    "C": 1.4,
    "R": 0.3,
    "q": 0.7,
    "B": 1.9,
    "E": -0.8,
    "g": 9.81,
    "I": 0.6,
}
m, c, k, L_c, C, R, q_e, B, E, g, inertia = (
    VALUES[n] for n in ("m", "c", "k", "L_c", "C", "R", "q", "B", "E", "g", "I")
)
Numbers = Sequence[float]
Function = Callable[[Numbers, Numbers], float]


def euler(L: Function, curve: Callable[[float], np.ndarray], k: int) -> float:
    """d/dt ∂L/∂q_k' − ∂L/∂q_k at t = 0: minus the slope of the action of a finely divided curve, for each second."""
    h, step = 2e-3, 1e-4

    def action(shift: float) -> float:
        points = [curve(n * h) for n in (-1, 0, 1)]
        points[1] = points[1] + shift * np.eye(len(points[1]))[k]
        return sum(h * L((points[n] + points[n + 1]) / 2, (points[n + 1] - points[n]) / h) for n in range(2))

    return -(action(step) - action(-step)) / (2 * step) / h


LAGRANGIANS: dict[str, Function] = {
    "oscillating-circuit": lambda q, v: L_c * v[0] ** 2 / 2 - q[0] ** 2 / (2 * C),
    "relativistic-oscillator": lambda q, v: -m * c**2 * sqrt(1 - v[0] ** 2 / c**2) - k * q[0] ** 2 / 2,
    "charge-in-a-magnetic-field": lambda q, v: (
        m * (v[0] ** 2 + v[1] ** 2) / 2 + q_e * E * q[1] + q_e * B / 2 * (q[0] * v[1] - q[1] * v[0])
    ),
    "weber-attraction": lambda q, v: m * (v[0] ** 2 + q[0] ** 2 * v[1] ** 2) / 2 - k / q[0] * (1 + v[0] ** 2 / c**2),
    "blade-from-a-lagrangian": lambda q, v: m * (v[0] ** 2 + v[1] ** 2) / 2 + inertia * v[2] ** 2 / 2 + m * g * q[0],
}


@pytest.mark.parametrize("name", LAGRANGIANS)
def test_accelerations_make_the_action_stationary(name: str) -> None:
    report = reported(name)
    assert report.holds, report.shortcomings
    L = LAGRANGIANS[name]
    solution = report.solution
    slots = solution.own.configuration.slots
    q, v = np.array([0.9, 0.4, 0.7])[: len(slots.coordinates)], np.array([0.5, 0.3, -0.6])[: len(slots.coordinates)]
    rows = []
    if name.startswith("blade"):
        v[1] = v[0] * sin(q[2]) / cos(q[2])  # along the blade
        rows = [[sin(q[2]), -cos(q[2]), 0]]
    state = {s: sp.Float(x) for s, x in zip((*slots.coordinates, *slots.velocities), (*q, *v), strict=True)}
    motion = solution.own.motion
    assert motion is not None
    equations = [*motion.expressions, *motion.configuration.accelerated_constraints]
    known = [
        f.xreplace(state).xreplace(
            {s: sp.Float(VALUES[s.name]) for s in f.free_symbols if s.name in VALUES and s not in state}
        )
        for f in equations
    ]
    solved = sp.linsolve(known, *slots.accelerations)
    [accelerations] = [[float(x) for x in s] for s in solved]

    def curve(t: float) -> np.ndarray:
        return q + v * t + np.array(accelerations) * t**2 / 2

    left = np.array([euler(L, curve, n) for n in range(len(q))])
    if name == "oscillating-circuit":
        left = left + R * v
    if rows:  # the reaction is along the form of the constraint
        form = np.array(rows[0])
        left = left - form * (form @ left) / (form @ form)
    assert left == pytest.approx(np.zeros(len(left)), abs=1e-3)


def test_the_derivation_says_that_no_other_principle_checks_it() -> None:
    report = reported("oscillating-circuit")
    names = [check.name for check in report.solution.checks]
    assert "the derivatives of L along a curve give the same motion" in names
    assert not any("Alembert" in name for name in names)
    assert as_object(report)["method"] == "lagrange"


PENDULUM = "parameters: [m, l, g]\ncoordinates: [theta]\n"
GIVEN = f"""{PENDULUM}lagrangian: "m*l^2*theta'^2/2 + m*g*l*cos(theta)"\n"""
MASSES = f"""{PENDULUM}particles: {{P: {{mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}}}\ngravity: -g*j\n"""


@pytest.mark.parametrize("find", ["motion", "[motion, hamiltonian]", "linearization"])
def test_a_lagrangian_gives_what_its_masses_give(find: str) -> None:
    given, masses = (solve(read(f"title: T\n{text}find: {find}\n")) for text in (GIVEN, MASSES))
    assert given.holds
    ours, theirs = given.own.motion, masses.own.motion
    assert ours is not None
    assert theirs is not None
    assert ours.expressions == theirs.expressions
    if given.own.hamiltonian is not None and masses.own.hamiltonian is not None:
        assert sp.expand(given.own.hamiltonian.function - masses.own.hamiltonian.function) == 0
    if given.own.linearization is not None and masses.own.linearization is not None:
        pairs = zip(given.own.linearization.at, masses.own.linearization.at, strict=True)
        assert all(a is not None and b is not None and a.equations == b.equations for a, b in pairs)


CHARGE = """parameters: {m: positive, q: real, B: real, R: positive}
coordinates: [x, y, z]
particles: {P: {mass: m, position: x*i + y*j + z*k}}
constraints: {ring: x^2 + y^2 = R^2}
forces: {field: {potential: "-q*B/2*(x*z' - z*x')"}}
generalized_coordinates: {angle: {coordinates: [theta, z], substitute: {x: R*sin(theta), y: -R*cos(theta)}}}
speeds: {u: "z'"}
"""


@pytest.mark.parametrize("method", ["dalembert", "lagrange"])
def test_a_field_in_other_coordinates_with_constraints_and_quasi_velocities(method: str) -> None:
    from lagrange.mechanics.dynamics.motion import Method

    solution = solve(read(f"title: T\n{CHARGE}"), method=Method(method))
    assert solution.holds, [c.name for c in solution.checks if not c.passed]


def test_quasi_velocities_of_a_given_lagrangian() -> None:
    """A blade on a slope: u' = g sin α cos θ, without the accelerations x'' and y''."""
    found = report(
        read("""title: T
parameters: {m: positive, J: positive, g: positive, alpha: acute}
coordinates: [x, y, theta]
lagrangian: "m*(x'^2 + y'^2)/2 + J*theta'^2/2 + m*g*x*sin(alpha)"
constraints: {blade: "y'*cos(theta) = x'*sin(theta)"}
speeds: {u: "x'*cos(theta) + y'*sin(theta)"}
answers: {equations: ["u' = g*sin(alpha)*cos(theta)", "theta'' = 0"]}
""")
    )
    assert found.solution.holds
    assert [a.verdict.value for a in found.answers] == ["equivalent"]
    equations = found.solution.own.in_speeds.equations.expressions
    assert not any(s.name in ("x''", "y''") for e in equations for s in e.free_symbols)
    assert "d'Alembert's principle reads" not in terminal.text(found.derivation, found.notation, 100)


WRONG = [
    (MASSES + 'lagrangian: "theta\'^2"\n', "two-systems"),
    (GIVEN.replace("theta'^2", "theta''^2"), "not-allowed-here"),
    (GIVEN + "forces: {drag: {generalized: {phi: 1}}}\n", "unknown-name"),
    (GIVEN + "forces: {drag: {generalized: 3}}\n", "wrong-kind"),
    (f"{PENDULUM}lagrangian: theta^2\n", "no-inertia"),
]


@pytest.mark.parametrize(("text", "code"), WRONG)
def test_mistakes(text: str, code: str) -> None:
    with pytest.raises(ProblemError) as error:
        solve(read(f"title: T\n{text}"))
    assert error.value.diagnostics[0].code == code
    assert error.value.diagnostics[0].help


def test_momenta_that_are_not_linear_in_the_velocities_have_no_hamiltonian_here() -> None:
    text = "title: T\ncoordinates: [x]\nlagrangian: x'^4 + x'^3 + x'^2 - x^2\nfind: hamiltonian\n"
    with pytest.raises(ProblemError, match="not linear in the velocities"):
        solve(read(text))
