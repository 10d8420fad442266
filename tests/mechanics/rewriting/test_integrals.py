"""Integrals without constants, and multiples of one velocity."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.dynamics.conservation import ConservedQuantity
from lagrange.mechanics.rewriting.integrals import energy_excess, is_multiple_of, without_constants
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load
from tests.support.shared import SHIPPED


def test_the_rest_energy_is_left_out() -> None:
    """γ m c² + ½ k x² at c = 5, v = 3, m = 1, k = 2, x = 1: γ = 5/4, 31.25 + 1."""
    view = solve(load(str(SHIPPED["relativistic-oscillator"]))).chosen
    assert view.conserved is not None
    [energy] = [i for i in view.conserved.integrals if i.quantity is ConservedQuantity.ENERGY]
    shown = without_constants(energy, view.configuration).expression
    values = {"c": 5, "x'": 3, "m": 1, "k": 2, "x": 1}
    assert shown.xreplace({s: sp.Integer(values[s.name]) for s in shown.free_symbols}) == sp.Rational(129, 4)


def test_a_spin_that_is_a_multiple_of_a_constant_rate() -> None:
    view = solve(load(str(SHIPPED["ball-in-a-pipe"]))).chosen
    assert view.conserved is not None
    v = next(v for v in view.configuration.slots.velocities if v.name == "phi'")
    spins = [i for i in view.conserved.integrals if i.quantity is ConservedQuantity.MOMENTUM]
    assert [is_multiple_of(i.expression, v, view.configuration) for i in spins] == [True]
    energy = next(i for i in view.conserved.integrals if i.quantity is ConservedQuantity.ENERGY)
    assert not is_multiple_of(energy.expression, v, view.configuration)


def test_the_energy_beside_jacobis_integral() -> None:
    """In a tube that turns at the rate Ω: E − J = m Ω² r², twice the kinetic energy of turning.

    The torque on the tube is d(m r² Ω)/dt = 2 m Ω r r', its power 2 m Ω² r r'.
    """
    view = solve(load(str(SHIPPED["bead-in-a-turning-tube"]))).chosen
    assert view.conserved is not None
    beside = energy_excess(view.conserved)
    assert beside is not None
    assert beside.rate is not None
    values = {"m": 2, "Omega": 3, "r": 5, "r'": 7}
    excess, rate = (
        e.xreplace({s: sp.Integer(values[s.name]) for s in e.free_symbols}) for e in (beside.excess, beside.rate)
    )
    assert (excess, rate) == (2 * 9 * 25, 2 * 2 * 9 * 5 * 7)
