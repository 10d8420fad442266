"""What the constraints determine of the motion is substituted, and only that.

Coordinates that two contacts hold together, and the forces there.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.core.symbols import prime
from lagrange.mechanics.rewriting.held_coordinates import (
    _coefficients,
    held_together,
    held_values,
    in_remaining_velocities,
    where_held,
    without_given_rates,
)
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.work import units

BOWL = """title: A ball in a bowl
parameters: {m: positive, r: positive, R: positive, h: real, g: positive}
coordinates: [a, phi, psi, z]
bodies:
  ball: {mass: m, inertia: 2*m*r^2/5, position: "a*(sin(phi)*i - cos(phi)*j) + z*k", angle: psi}
constraints: {bowl: "2*a = 2*R - 2*r", plane: "z + h = a", rolling: "(R - r)*phi' + r*psi' = 0"}
gravity: -g*j
"""


def test_a_ball_in_a_bowl() -> None:
    """7 (R − r) φ'' + 5 g sin φ = 0, as energy gives it: ½ m (1 + 2/5) (R − r)² φ'² − m g (R − r) cos φ."""
    solution = solve(read_problem(Source("bowl.yaml", BOWL)), complete=False)
    configuration = solution.own.configuration
    a, phi, _, z = configuration.slots.coordinates
    R, r, g = (next(p.symbol for p in solution.problem.parameters if p.symbol.name == n) for n in ("R", "r", "g"))
    held = held_values(configuration)
    assert held == {a: R - r, prime(a): 0, prime(a, 2): 0}  # z is held by two constraints together
    assert where_held(a * sp.sin(phi) + prime(a, 2), held) == (R - r) * sp.sin(phi)
    assert where_held(z**2, held) == z**2
    freed = without_given_rates(solution.chosen)
    assert freed is not None
    wanted = 7 * (R - r) * prime(phi, 2) + 5 * g * sp.sin(phi)
    ratios = [sp.cancel(where_held(e.expression, held) / wanted) for e in freed.equations]
    assert any(x != 0 and not x.free_symbols & {phi, prime(phi, 2)} for x in ratios)


# -- The energy without the velocities that a choice of coordinates eliminates -----------------------------------------


ROLLER = """
title: Roller on an incline, and one whose turns a spring counts
parameters: [m, I, R, g, alpha, c]
coordinates: [x, theta]
bodies: {roller: {mass: m, inertia: I, position: x*i, angle: -theta}}
constraints: {rolling: x' = R*theta'}
forces: {weight: {on: roller, vector: m*g*sin(alpha)*i}}
generalized_coordinates: {way: {coordinates: [x]}}
"""
x, theta = sp.symbols("x' theta'", real=True)
m, I, R, c = sp.symbols("m I R c", positive=True)


def test_the_energy_is_collected_in_the_velocities_that_remain() -> None:
    [choice] = solve(read_problem(Source("roller.yaml", ROLLER))).choices
    motion = choice.motion
    assert motion is not None
    place, angle = sp.symbols("x theta", real=True)
    kinetic = m * x**2 / 2 + I * theta**2 / 2
    found = in_remaining_velocities(kinetic - c * place, motion)
    assert theta not in found.free_symbols
    assert sp.expand(found - (kinetic - c * place).subs(theta, x / R)) == 0
    kept = kinetic + c * angle**2  # of what the angle itself is, ẋ = R θ̇ says nothing
    assert in_remaining_velocities(kept, motion) == kept


# Held together


CAR = """title: A car that is pulled
parameters: [m, J, a, b, h, F, g]
coordinates: [x, y, phi]
bodies:
  car: {mass: m, inertia: J, position: x*i + y*j, angle: phi}
constraints:
  front: {equation: "y + a*sin(phi) - h*cos(phi) = 0", reaction: N}
  rear: {equation: "y - b*sin(phi) - h*cos(phi) = 0", reaction: S}
gravity: -g*j
forces:
  pull: {on: car, vector: F*i, at: "r_car - h*e2_car"}
"""


def test_two_axles_hold_height_and_tilt() -> None:
    """The forces against moments about the two points of contact: N (a + b) = m g b − F h, S (a + b) = m g a + F h."""
    solution = solve(read_problem(Source("car.yaml", CAR)), complete=False)
    held = held_together(solution)
    assert held is not None
    letters = {p.symbol.name: p.symbol for p in solution.problem.parameters}
    m, a, b, h, F, g = (letters[n] for n in ("m", "a", "b", "h", "F", "g"))
    assert {q.name: e for q, e in held.values.items()} == {"y": h, "phi": 0}  # without an initial state
    forces = {s.name: e for s, e in held.forces.items()}
    assert sp.simplify(forces["N"] * (a + b) - (m * g * b - F * h)) == 0
    assert sp.simplify(forces["S"] * (a + b) - (m * g * a + F * h)) == 0


@pytest.mark.parametrize(
    "constraints",
    [
        'front: {equation: "y - h = 0", reaction: N}',  # each by itself
        'front: {equation: "y + a*sin(phi) - h*cos(phi) = 0", reaction: N}',  # it can still tilt
    ],
)
def test_what_is_not_held_together(constraints: str) -> None:
    head, _, rest = CAR.partition("  front:")
    text = f"{head}  {constraints}\n{rest[rest.index('gravity') :]}"
    assert held_together(solve(read_problem(Source("car.yaml", text)), complete=False)) is None


def test_the_coefficients_of_forces_in_a_law() -> None:
    a, b, N, T = sp.symbols("a b N T", real=True)
    e = (a + b) * (N - sp.sin(a) * T) + b * N / 2 + a**2
    assert _coefficients(e, [N, T]) == [sp.expand(e).diff(u) for u in (N, T)]
    assert _coefficients(a * b, [N, T]) == [0, 0]
    for other in (N * T + N, N**2 + T, sp.sqrt(N), sp.sin(N) * T, sp.Abs(N - a)):
        assert _coefficients(other, [N, T]) is None


def test_the_coefficients_of_many_forces_take_one_walk() -> None:
    few, many = (sp.symbols(f"N1:{n + 1}") for n in (50, 200))
    works = [units(lambda some=some: _coefficients(sp.Add(*(3 * N for N in some)), some)) for some in (few, many)]
    assert works[1] < 6 * works[0]
