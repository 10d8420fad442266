"""Linear equations about a motion in numbers: the published bicycle, and systems whose equations are known by hand."""

from dataclasses import replace
from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sp

from lagrange.core.diagnostics import Fragment, NotCoveredError, ProblemError
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem
from lagrange.mechanics.constraints.constraints import constraint_row
from lagrange.mechanics.constraints.kinematics import Configuration, file_configuration
from lagrange.mechanics.nearby.checks import check_linear_motion
from lagrange.mechanics.nearby.linear_motion import LinearMotion, linear_motion
from lagrange.mechanics.nearby.long_equations import long_equations
from lagrange.problem.loader import load
from lagrange.problem.model import Problem
from lagrange.programs.first_order import long_first_order
from lagrange.programs.numerical_system import NumericalSystem
from lagrange.programs.state_equations import StateEquations
from tests.support.shared import loaded

# Meijaard, Papadopoulos, Ruina and Schwab (2007), section 4: M q'' + v C1 q' + (g K0 + v² K2) q = 0, q = (lean, steer).
M = (80.81722, 2.31941332208709), (2.31941332208709, 0.29784188199686)
C1 = (0, 33.86641391492494), (-0.85035641456978, 1.68540397397560)
K0 = (-80.95, -2.59951685249872), (-2.59951685249872, -0.80329488458618)
K2 = (0, 76.59734589573222), (0, 2.65431523794604)
AT_5 = (
    -14.07838969279822,
    -0.32286642900409,
    -0.77534188219585 - 4.46486771378823j,
    -0.77534188219585 + 4.46486771378823j,
)


def configuration_of(problem: Problem) -> Configuration:
    system = ConstrainedSystem(problem.slots, tuple(constraint_row(c, problem.slots) for c in problem.constraints))
    return file_configuration(problem, system)


@cache
def bicycle() -> tuple[Problem, Configuration, LinearMotion]:
    problem = loaded("large/whipple-bicycle")
    configuration = configuration_of(problem)
    return problem, configuration, linear_motion(problem, configuration)


def coefficients(table, letter: sp.Symbol, power: int) -> list[list[float]]:
    return [[float(sp.Poly(e, letter).coeff_monomial(letter**power)) for e in row] for row in table]


def test_the_published_bicycle() -> None:
    *_, found = bicycle()
    [alone, block] = found.blocks
    v = found.letters[0]
    assert [q.name for q in block.coordinates] == ["phi", "delta"]
    assert [q.name for q in alone.coordinates] == ["x"]
    for table, power, published, scale in (
        (block.mass, 0, M, 1),
        (block.damping, 1, C1, 1),
        (block.stiffness, 0, K0, 9.81),
        (block.stiffness, 2, K2, 1),
    ):
        for row, expected in zip(coefficients(table, v, power), published, strict=True):
            assert row == pytest.approx([scale * e for e in expected], rel=5e-14, abs=1e-13)
    assert not any(c for k in (0, 2) for row in coefficients(block.damping, v, k) for c in row)
    assert not any(c for row in coefficients(block.stiffness, v, 1) for c in row)


def published(row: int, damping: float | None = None) -> Fragment:
    """One row of M q'' + v C1 q' + (g K0 + v² K2) q = 0, as an answer."""
    c = C1[row][1] if damping is None else damping
    return Fragment.of(
        f"{M[row][0]}*phi'' + {M[row][1]}*delta'' + {C1[row][0]}*v*phi' + {c}*v*delta' + 9.81*({K0[row][0]})*phi"
        f" + (9.81*({K0[row][1]}) + {K2[row][1]}*v^2)*delta = 0"
    )


def test_the_published_exponents_at_five_metres_a_second() -> None:
    *_, found = bicycle()
    five = {found.letters[0]: sp.Integer(5)}

    def at(table):
        return tuple(tuple(e.xreplace(five) for e in row) for row in table)

    b = found.blocks[1]
    numbers = replace(b, mass=at(b.mass), damping=at(b.damping), stiffness=at(b.stiffness))
    exponents = sorted((complex(p) for p in numbers.exponents), key=lambda p: (p.real, p.imag))
    assert exponents == pytest.approx(sorted(AT_5, key=lambda p: (p.real, p.imag)), rel=1e-11)


def problem_of(tmp_path, text: str) -> tuple[Problem, Configuration]:
    path = tmp_path / "p.yaml"
    path.write_text(text)
    problem = load(path)
    return problem, configuration_of(problem)


DISC = """
title: A disc that rolls straight ahead
parameters: {m: {value: 3}, R: {value: 1/2}, g: {value: 10}, v: positive}
coordinates: [x, y, phi, theta, psi]
bodies:
  disc:
    mass: m
    inertia: [m*R^2/4, m*R^2/4, m*R^2/2]
    position: x*i + y*j + R*sin(theta)*k
    orientation: {axes: 313, angles: [phi, theta, psi]}
constraints:
  rolling: r_disc' + cross(omega_disc, -R*n2_disc) = 0
gravity: -g*k
initial: {phi: 0, theta: pi/2, phi': 0, theta': 0, x: 0, y: 0, psi: 0, psi': v/R}
"""


def test_a_rolling_disc_is_stable_from_the_known_speed_on(tmp_path) -> None:
    found = linear_motion(*problem_of(tmp_path, DISC))
    [block] = [b for b in found.blocks if len(b.coordinates) > 1]
    p, v = sp.symbols("p v")
    tables = [sp.Matrix(t).xreplace({found.letters[0]: v}) for t in (block.mass, block.damping, block.stiffness)]
    polynomial = sp.Poly((tables[0] * p**2 + tables[1] * p + tables[2]).det(), p)
    # p² + (12/5) (v/R)² − (4/5) g/R: stable where (v/R)² > g/(3R), Routh
    wobble = polynomial.coeff_monomial(p**2) / polynomial.coeff_monomial(p**4)
    assert sp.expand(wobble - (sp.Rational(48, 5) * v**2 - 16)) == 0


PENDULUM = """
title: A pendulum in dependent coordinates, with a spring and a damper
parameters: {m: {value: 2}, l: {value: 3}, g: {value: 10}, s: {value: 5}, c: {value: 7}}
axes: {i: right, j: down}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
gravity: g*j
forces: {spring: {potential: s*x^2/2}, drag: {on: P, vector: -c*r_P'}}
initial: {x: 0, y: l, x': 0}
"""


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("x: 0, y: l, x': 0", "x: l, y: 0, y': 0", "not-steady"),
        ("x: 0, y: l, x': 0", "x: 0, y: 2*l, x': 0", "initial-off-constraints"),
        ("initial: {x: 0, y: l, x': 0}", "", "no-reference-motion"),
        ("m: {value: 2}, l: {value: 3}, g: {value: 10}", "m: positive, l: positive, g: positive", "values-needed"),
    ],
)
def test_what_is_refused(tmp_path, old: str, new: str, code: str) -> None:
    with pytest.raises(ProblemError) as error:
        linear_motion(*problem_of(tmp_path, PENDULUM.replace(old, new)))
    assert error.value.diagnostics[0].code == code


def test_what_is_no_polynomial_in_a_letter_is_refused(tmp_path) -> None:
    with pytest.raises(NotCoveredError):
        linear_motion(*problem_of(tmp_path, PENDULUM.replace("l: {value: 3}", "l: positive")))


ASKEW = """
title: A body that turns about a vertical axis and hangs from two joints
parameters: {{m: {{value: 3}}, a: {{value: 1/2}}, g: {{value: 10}}, n: {{value: 2}}}}
coordinates: [phi, alpha, beta]
bodies:
  B: {{mass: m, inertia: {inertia}, position: {position}, orientation: {{axes: 312, angles: [phi, alpha, {last}]}}}}
gravity: -g*k
initial: {{phi: 0, alpha: 0, beta: 0, phi': n, alpha': 0, beta': 0}}
"""


def test_products_of_inertia_are_those_of_principal_axes_turned(tmp_path) -> None:
    """Axes turned through atan(3/4) about the second one: J_13 = (A − C) sin cos, and nothing else changes."""
    plain = ASKEW.format(inertia="[5, 6, 2]", position="-a*e3_B", last="beta")
    turned = ASKEW.format(
        inertia='[["(5*16 + 2*9)/25", 0, 36/25], [0, 6, 0], [36/25, 0, "(5*9 + 2*16)/25"]]',
        position='"-a*(4/5*e3_B - 3/5*e1_B)"',
        last="beta + atan(3/4)",
    )
    found = []
    for text in (plain, turned):
        problem, configuration = problem_of(tmp_path, text)
        found.append(linear_motion(problem, configuration))
        assert check_linear_motion(problem, configuration, found[-1])[0].passed
    for b, c in zip(found[0].blocks, found[1].blocks, strict=True):
        assert b.coordinates == c.coordinates
        for s, t in zip((b.mass, b.damping, b.stiffness), (c.mass, c.damping, c.stiffness), strict=True):
            assert [float(e) for e in sp.Matrix(s)] == pytest.approx([float(e) for e in sp.Matrix(t)], abs=1e-12)


def test_the_bicycle_that_simulate_integrates_has_the_published_exponents() -> None:
    """The first-order equations with all nine coordinates, deviations from rolling upright at 5 m/s in numbers."""
    problem, configuration, _ = bicycle()
    view = SimpleNamespace(configuration=configuration, name="")
    solved = SimpleNamespace(
        own=view, long_equations=long_equations(problem, configuration), classification=SimpleNamespace(redundant=())
    )
    states = StateEquations(problem, view, configuration, long_first_order(solved))
    values = {p.symbol: float(p.value) for p in problem.parameters if p.value is not None}
    (speed,) = (p.symbol for p in problem.parameters if p.symbol.name == "v")
    system = NumericalSystem(states, {**values, speed: 5.0})
    names = [s.name for s in states.state]
    rolling = system.projected(0.0, tuple(float(n == "x'") for n in names))  # forms without a term in dt: any multiple
    assert rolling is not None
    upright = [
        5 * x / rolling[names.index("x'")] if n.endswith("'") else x for n, x in zip(names, rolling, strict=True)
    ]
    chosen = [names.index(n) for n in ("phi", "delta", "phi'", "delta'")]

    def deviated(k: int, size: float) -> tuple[np.ndarray, np.ndarray]:
        y = system.projected(0.0, tuple(x + size * (i == k) for i, x in enumerate(upright)))
        assert y is not None
        return np.array(y)[chosen], np.array(system.rate(0.0, *y))[chosen]

    size = 1e-4
    columns = [
        [(a - b) / (2 * size) for a, b in zip(deviated(k, size), deviated(k, -size), strict=True)] for k in chosen
    ]
    places, rates = (np.column_stack(parts) for parts in zip(*columns, strict=True))
    exponents = np.linalg.eigvals(rates @ np.linalg.inv(places))
    assert sorted(exponents, key=lambda z: (round(z.imag, 3), z.real)) == pytest.approx(
        [AT_5[2], AT_5[0], AT_5[1], AT_5[3]], rel=1e-6
    )
