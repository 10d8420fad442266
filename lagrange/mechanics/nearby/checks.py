"""The linear equations about a motion, by another route: Lagrange's, at a state nearby, in numbers.

From the steady state the independent coordinates and velocities are moved by ε times drawn numbers, the others follow
from the constraints as they are, not to first order; the accelerations follow from the linear equations. There

    Σ ∂²T/∂q_k'∂q_j' q_j'' + Σ ∂²T/∂q_k'∂q_j q_j' − ∂T/∂q_k − Q_k = Σ λ a_k

must hold up to ε². T is the kinetic energy of the system as the file gives it; neither the accelerations of points
nor the elimination that led to the linear equations is used.
"""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import solution
from lagrange.algebra.forms.jets import BITS, Jet
from lagrange.core.diagnostics import ProblemError
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy, share_of_damper, share_of_load, share_of_torque
from lagrange.mechanics.limits import CHECKED_DISTANCE, CHECKED_REMAINDER
from lagrange.mechanics.nearby.linear_equations import Expansions, reference
from lagrange.mechanics.nearby.linear_motion import LinearMotion
from lagrange.problem.model import Problem

NAME = "the linear equations agree with Lagrange's equations"


def check_linear_motion(problem: Problem, configuration: Configuration, motion: LinearMotion) -> list[Check]:
    """At one drawn state nearby, with drawn values of parameters that have none."""
    random = Random(5)
    slots = configuration.slots
    numbers = problem.given_values
    numbers |= {s: sp.Rational(random.randint(20, 60), 17) for s in motion.letters}
    velocity = dict(zip(slots.coordinates, slots.velocities, strict=True))
    tiny = sp.Rational(1, 10**CHECKED_DISTANCE)
    state = {s: e.xreplace(numbers) for s, e in motion.state.items()}
    stated = {i.symbol: state[i.symbol] for i in problem.initial if i.symbol not in motion.bound}
    accelerations: dict[sp.Symbol, sp.Expr] = {}
    for block in motion.blocks:
        size = len(block.coordinates)
        moved = [tiny * sp.Rational(random.randint(-99, 99), 50) for _ in range(2 * size)]
        for q, x, v in zip(block.coordinates, moved[:size], moved[size:], strict=True):
            stated[q], stated[velocity[q]] = state[q] + x, state[velocity[q]] + v
        tables = (sp.Matrix(m).xreplace(numbers) for m in (block.mass, block.damping, block.stiffness))
        mass, damping, stiffness = tables
        pull = -(damping * sp.Matrix(moved[size:]) + stiffness * sp.Matrix(moved[:size]))
        accelerations |= dict(zip(block.coordinates, mass.LUsolve(pull), strict=True))
    try:
        near = reference(configuration, stated, numbers, state)
    except ProblemError:
        return [Check(NAME, None, "no state nearby was found")]
    about = Expansions(slots, near.values)
    left = _remainder(configuration, about, near.used, [accelerations.get(q) for q in slots.coordinates])
    how = f"in numbers, at a drawn state in a distance of 10^-{CHECKED_DISTANCE}: their remainder is of second order"
    return [Check(NAME, None if left is None else bool(left < CHECKED_REMAINDER), how)]


def _remainder(
    configuration: Configuration, about: Expansions, used: Sequence[int], given: Sequence[sp.Expr | None]
) -> Any | None:
    """What Lagrange's equations leave over after the reactions that fit best, with given accelerations."""
    slots, _n = configuration.slots, about.size
    rates = [about.number(v) for v in slots.velocities]
    rows = [configuration.rows[k] for k in used]
    coefficients = [[about.value(a) for a in row.coefficients] for row in rows]
    # a·q'' = −(d/dt a)·q' − d/dt a_t
    right = []
    for row in rows:
        rate = about.jet(row.velocity_form(slots), 1, moving=True)
        right.append(-sum(s * v for s, v in zip(about.gradient(rate), rates, strict=True)))
    known = [None if e is None else about.number(e) for e in given]
    for line, places in zip(coefficients, range(len(right)), strict=True):
        right[places] -= sum(a * x for a, x in zip(line, known, strict=True) if x is not None)
    loose = [k for k, x in enumerate(known) if x is None]
    solved = solution(about.reals, [[line[k] for k in loose] for line in coefficients], right) if loose else []
    if solved is None:
        return None
    for k, x in zip(loose, solved, strict=True):
        known[k] = x
    balance = lagrange_in_numbers(configuration, about, rates, known)
    transposed = [list(column) for column in zip(*coefficients, strict=True)]
    normal = [[sum(x * y for x, y in zip(r, s, strict=True)) for s in coefficients] for r in coefficients]
    loads = [sum(x * y for x, y in zip(r, balance, strict=True)) for r in coefficients]
    forces = solution(about.reals, normal, loads) if normal else []
    if forces is None:
        return None
    rest = (
        [b - sum(a * f for a, f in zip(line, forces, strict=True)) for b, line in zip(balance, transposed, strict=True)]
        if normal
        else balance
    )
    return max(map(abs, rest))


def lagrange_in_numbers(
    configuration: Configuration, about: Expansions, rates: Sequence[Any], accelerations: Sequence[Any]
) -> list[Any]:
    """The left sides of Lagrange's equations, shape (n,), at the state with these accelerations."""
    slots, n = configuration.slots, about.size
    kinetic = about.jet(kinetic_energy(configuration), 2, moving=True)
    zero = about.reals.number(0)

    def second(i: int, k: int) -> Any:
        value = kinetic[2].get((1 << BITS * i) + (1 << BITS * k), zero)
        return 2 * value if i == k else value

    first = about.gradient(kinetic)
    potential: Jet = about.jet(configuration.potential, 1)
    slopes = about.gradient(potential)
    left = []
    for k, v in enumerate(slots.velocities):
        total = sum(second(n + k, n + j) * accelerations[j] + second(n + k, j) * rates[j] for j in range(n))
        shares = [share_of_load(f, v, configuration) for f in configuration.loads]
        shares += [share_of_torque(m, v, configuration) for m in configuration.torques]
        shares += [share_of_damper(d, v, slots) for d in configuration.dampers]
        shares += [configuration.generalized[k]] if configuration.generalized else []
        force = sum((about.value(e) for e in shares), zero)
        left.append(total - first[k] + slopes[k] - force)
    return left
