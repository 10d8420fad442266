"""Impacts against numbers: free bodies in Cartesian coordinates, constraints by differences, one linear system.

Each shipped problem is set up again from its figure: masses of free bodies, the places that constraints keep together,
the blows, at numbers. M Δv = Ĵ + Aᵀ Λ with A v = −e A v_0 is solved by numpy; nothing of the program is used.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import cos, pi, sin, sqrt

import numpy as np
import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError, Source
from lagrange.mechanics.momenta.impact import ImpulsiveMotion
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from tests.support.shared import reported

m, M, l, a, J, v, e, alpha, R, h, omega, I_G = 1.3, 2.9, 1.7, 0.6, 2.2, 3.1, 0.4, 0.7, 0.9, 0.25, 2.3, 0.8
VALUES = {"m": m, "M": M, "l": l, "a": a, "J": J, "v": v, "e": e, "alpha": alpha, "R": R, "h": h, "omega": omega,
          "I_G": I_G, "g": 9.81}  # fmt: skip
Place = Callable[[Sequence[float]], Sequence[float]]


def struck(
    masses: Sequence[float],
    place: Sequence[float],
    before: Sequence[float],
    kept: Place,
    blow: Sequence[float] | None = None,
    restitution: float = 0,
) -> np.ndarray:
    """The velocities after; `kept` are the functions of the free coordinates that constraints keep at zero."""
    x, v0 = np.array(place, float), np.array(before, float)
    step = 1e-6
    size = len(x)
    columns = [
        (np.array(kept(x + step * unit)) - np.array(kept(x - step * unit))) / (2 * step) for unit in np.eye(size)
    ]
    A = np.array(columns).T
    rows = len(A)
    system = np.block([[np.diag(masses), -A.T], [A, np.zeros((rows, rows))]])
    right = np.concatenate([np.diag(masses) @ v0 + (np.zeros(size) if blow is None else blow), -restitution * A @ v0])
    return np.linalg.solve(system, right)[:size]


def rod(length: float) -> list[float]:
    return [m, m, m * length**2 / 12]


def _percussion() -> dict[str, float]:
    # y downwards, the angle from x to y; the hinge at the upper end
    def kept(q: Sequence[float]) -> list[float]:
        return [q[0] - l / 2 * cos(q[2]), q[1] - l / 2 * sin(q[2])]

    after = struck(rod(l), [0, l / 2, pi / 2], [0, 0, 0], kept, [J, 0, -(a - l / 2) * J])
    return {"x": after[0], "theta": after[2]}


def _edge() -> dict[str, float]:
    after = struck(rod(2 * l), [0, 0, 0], [0, -v, 0], lambda q: [q[1] + a * sin(q[2])])
    return {"y": after[1], "theta": after[2]}


def _caught() -> dict[str, float]:
    def kept(q: Sequence[float]) -> list[float]:
        return [q[0] - l / 2 * cos(q[2]), q[1] - l / 2 * sin(q[2])]

    after = struck(rod(l), [l / 2, 0, 0], [0, v, 0], kept)
    return {"x": after[0], "y": after[1], "theta": after[2]}


def _ballistic() -> dict[str, float]:
    def kept(q: Sequence[float]) -> list[float]:
        return [q[0] ** 2 + q[1] ** 2 - l**2, q[2] - q[0], q[3] - q[1]]

    after = struck([M, M, m, m], [0, -l, 0, -l], [0, 0, v, 0], kept)
    return {"x": after[0], "s": after[2], "theta": after[0] / l}


def _wedge() -> dict[str, float]:
    def kept(q: Sequence[float]) -> list[float]:
        return [(q[0] - q[2]) * sin(alpha) + q[1] * cos(alpha)]

    after = struck([m, m, M], [0, 0, 0], [0, -v, 0], kept, restitution=e)
    return {"x": after[0], "y": after[1], "X": after[2]}


def _rods() -> dict[str, float]:
    def ends(q: Sequence[float], k: int) -> tuple[list[float], list[float]]:
        x, y, phi = q[3 * k : 3 * k + 3]
        c, s = l / 2 * cos(phi), l / 2 * sin(phi)
        return [x - c, y - s], [x + c, y + s]

    def kept(q: Sequence[float]) -> list[float]:
        return [p - o for k in range(2) for p, o in zip(ends(q, k)[1], ends(q, k + 1)[0], strict=True)]

    place = [l / 2, 0, 0, 3 * l / 2, 0, 0, 5 * l / 2, 0, 0]
    after = struck(rod(l) * 3, place, [0] * 9, kept, [0, J, -J * l / 2] + [0] * 6)
    return {"alpha": after[2], "beta": after[5], "gamma": after[8], "y": after[1] - l / 2 * after[2]}


def _step() -> dict[str, float]:
    # the edge seen from the centre, kept in place by the point of the disc that touches it; clockwise angle
    b = sqrt(2 * R * h - h * h)

    def kept(q: Sequence[float]) -> list[float]:
        c, s = cos(-q[2]), sin(-q[2])
        return [q[0] + c * b - s * (h - R) - b, q[1] + s * b + c * (h - R) - (h - R)]

    after = struck([m, m, m * R**2 / 2], [0, 0, 0], [R * omega, 0, omega], kept)
    return {"x": after[0], "y": after[1], "theta": after[2]}


def _sleigh() -> dict[str, float]:
    # along i; the mass centre and the angle; the blade moves across with y' - a θ'
    after = struck([m, m, I_G], [a, 0, 0], [0, 0, 0], lambda q: [q[1] - a * q[2]], [0, J, 0])
    return {"theta": after[2]}


ROUTES = {
    "centre-of-percussion": _percussion,
    "rod-falls-on-an-edge": _edge,
    "rod-caught-at-an-end": _caught,
    "ballistic-pendulum": _ballistic,
    "ball-on-a-wedge": _wedge,
    "three-struck-rods": _rods,
    "disc-against-a-step": _step,
    "struck-sleigh": _sleigh,
}


def in_numbers(expression: sp.Expr) -> float:
    values = {s: VALUES[s.name] for s in expression.free_symbols}
    return float(expression.xreplace({s: sp.Float(x) for s, x in values.items()}).evalf())


def impact_of(name: str) -> ImpulsiveMotion:
    found = reported(name).solution.impact
    assert found is not None
    return found


@pytest.mark.parametrize("name", ROUTES)
def test_velocities_agree_with_free_bodies_in_numbers(name: str) -> None:
    report = reported(name)
    assert report.holds, report.shortcomings
    derived = {q.name: u for q, u in impact_of(name).all_velocities.items()}
    for coordinate, number in ROUTES[name]().items():
        assert in_numbers(derived[coordinate]) == pytest.approx(number, rel=1e-6), coordinate


def problem(text: str) -> Problem:
    return read_problem(Source("test.yaml", text))


def solved(text: str) -> ImpulsiveMotion:
    found = solve(problem(text)).impact
    assert found is not None
    return found


LINE = """
title: Two particles on a line
parameters: {m_1: positive, m_2: positive, u_1: real, u_2: real, e: nonnegative}
coordinates: [x_1, x_2]
particles: {P: {mass: m_1, position: x_1*i}, Q: {mass: m_2, position: x_2*i}}
impact:
  before: {x_1': u_1, x_2': u_2}
  constraints: {touch: {equation: x_2 - x_1 >= 0, reaction: N}}
  restitution: {touch: e}
"""


def test_two_particles_with_restitution() -> None:
    found = solved(LINE)
    m1, m2 = sp.symbols("m_1 m_2", positive=True)
    u1, u2 = sp.symbols("u_1 u_2", real=True)
    k = sp.Symbol("e", nonnegative=True)
    assert sp.simplify(found.velocities[0] - (m1 * u1 + m2 * u2 - m2 * k * (u1 - u2)) / (m1 + m2)) == 0
    assert sp.simplify(found.energy_lost - m1 * m2 * (1 - k**2) * (u1 - u2) ** 2 / (2 * (m1 + m2))) == 0
    approach, push = found.conditions
    assert sp.expand(approach.quantity - (u1 - u2)) == 0
    assert push.is_impulse


def test_velocities_that_are_not_given_stay_symbols() -> None:
    found = solved(LINE.replace("  before: {x_1': u_1, x_2': u_2}\n", ""))
    assert {s.name for u in found.velocities for s in u.free_symbols} == {"m_1", "m_2", "e", "x_1'_0", "x_2'_0"}


TABLE = """
title: A table that lands on four legs
parameters: [m, I, a, v]
coordinates: [y, theta]
bodies: {top: {mass: m, inertia: I, position: y*j, angle: theta}}
impact:
  before: {y': -v, theta': 0, theta: 0}
  constraints: {left: y - a*sin(theta) = 0, middle: y = 0, right: y + a*sin(theta) = 0}
"""


def test_dependent_constraints_leave_impulses_open_and_velocities_known() -> None:
    found = solved(TABLE)
    assert found.velocities == (0, 0)
    assert found.open_impulses == ("left", "middle", "right")
    assert sp.expand(found.energy_lost - sp.sympify("m*v**2/2", locals=_locals())) == 0
    assert as_object(_report(TABLE))["impact"]["impulses"] == {"left": None, "middle": None, "right": None}


def _locals() -> dict[str, sp.Symbol]:
    return {n: sp.Symbol(n, positive=True) for n in "mv"}


def _report(text: str):
    from lagrange.explain.report import report

    return report(problem(text))


HANGING = """
title: A bead on a string that becomes taut
parameters: [m, l, u, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
gravity: -g*j
impact:
  before: {x': u, y': 0, x: 0.6*l, y: -0.8*l}
  constraints: {string: {equation: x^2 + y^2 <= l^2, reaction: T}}
"""


def test_a_string_that_becomes_taut_keeps_the_velocity_across_it() -> None:
    found = solved(HANGING)
    m_, u = sp.Symbol("m", positive=True), sp.Symbol("u", positive=True)
    assert found.velocities == (sp.Rational(16, 25) * u, sp.Rational(12, 25) * u)
    [string] = found.impulses
    assert string.value == sp.Rational(3, 5) * m_ * u  # the tension pulls
    assert not found.conditions


WRONG = [
    (LINE.replace("x_1': u_1, x_2': u_2", "x_1': 1, x_2': 2"), "contradictory-impact"),
    (HANGING.replace("x: 0.6*l", "x: 0.7*l"), "contradictory-state"),
    (LINE.replace("touch: e}", "touch: 2}"), "bad-restitution"),
    (LINE.replace("restitution: {touch", "restitution: {tuch"), "unknown-name"),
    (LINE.replace("before: {x_1': u_1", "before: {x_1'': u_1"), "no-state"),
    (LINE.split("impact:", maxsplit=1)[0] + "impact: {before: {x_1': u_1}}\n", "empty-impact"),
    (LINE.split("impact:", maxsplit=1)[0] + "find: impact\n", "missing-key"),
    (HANGING.replace("impact:", "constraints: {floor: y = -0.8*l}\nimpact:").replace("y': 0", "y': u"),
     "contradictory-state"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "code"), WRONG)
def test_what_is_wrong_is_said_at_its_place(text: str, code: str) -> None:
    with pytest.raises(ProblemError) as error:
        solve(problem(text))
    [first, *_] = error.value.diagnostics
    assert first.code == code
    assert first.help
    assert first.span is not None


def test_dry_friction_is_refused() -> None:
    rough = """
title: A block with friction
parameters: [m, mu, J, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {floor: y = 0}
gravity: -g*j
forces: {rub: {friction: mu, constraint: floor, on: P}}
impact: {impulses: {blow: {on: P, vector: J*i}}}
"""
    with pytest.raises(ProblemError, match="dry friction"):
        solve(problem(rough))


def test_the_share_of_the_energy_that_is_lost() -> None:
    """Of ½ m v² a bullet in a block at rest keeps m/(M + m)."""
    motion = reported("ballistic-pendulum").solution.impact
    assert motion is not None
    assert motion.share_lost is not None
    assert str(motion.share_lost) == "M/(M + m)"
