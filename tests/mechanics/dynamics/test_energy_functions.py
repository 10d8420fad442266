"""The energy and Jacobi's integral: which is conserved, and at what rate it changes otherwise."""

from __future__ import annotations

from functools import cache

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.mechanics.dynamics.conservation import Because, Conserved, ConservedQuantity
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.conserved import GIVEN_FORCE, differences, of
from tests.truth.test_textbook_systems import solution_of


@cache
def solved(name: str) -> Solution:
    return solution_of(name).solution


def test_energies_that_are_conserved_say_so_in_every_choice() -> None:
    for name in ("cart_with_pendulum", "particle_in_cone", "paraboloid", "slider_crank"):
        for c in solved(name).choices:
            assert c.conserved is not None
            assert ConservedQuantity.ENERGY in {i.quantity for i in c.conserved.integrals}, (name, c.name)


def kinds(found: Conserved) -> list[tuple[str, str]]:
    return [(i.quantity.value, i.because.value) for i in found.integrals]


def test_a_given_force_has_its_potential_and_the_plane_its_rotation() -> None:
    found = of(GIVEN_FORCE)
    assert kinds(found) == [("angular-momentum", "rotation"), ("energy", "conservative")]
    x, y = (sp.Symbol(n, real=True) for n in "xy")
    kappa = sp.Symbol("kappa", positive=True)
    assert (found.integrals[1].expression - (-kappa / sp.sqrt(x**2 + y**2))).free_symbols.isdisjoint({x, y})


def test_the_potential_of_an_undefined_force_is_not_denied() -> None:
    text = GIVEN_FORCE.replace("coordinates: [x, y]", "functions: {f: [r]}\ncoordinates: [x, y]")
    found = of(text.replace("-kappa*(x*i + y*j)/(x^2 + y^2)^(3/2)", "f(x)*i"))
    assert found.energy is not None
    assert found.energy.hidden
    assert kinds(found) == [("momentum", "cyclic")]


JUMPS = """
title: Two particles and forces that jump
parameters: [m, c]
coordinates: [x, y]
particles: {A: {mass: m, position: x*i}, B: {mass: m, position: y*i}}
forces: {a: {on: A, vector: "(%s)*i"}, b: {on: B, vector: "(%s)*i"}}
"""


@pytest.mark.parametrize(
    ("on_a", "on_b", "potential"),
    [
        ("-c*sign(x)", "0", "c*Abs(x)"),
        ("-c*sign(x) - c*x", "0", "c*Abs(x) + c*x**2/2"),
        ("-c*sign(x - y)", "c*sign(x - y)", "c*Abs(x - y)"),
        ("-c*sign(y)", "0", None),
        ("-c*sign(x)*x'^2", "0", None),
    ],
)
def test_forces_that_jump_have_potentials_too(on_a: str, on_b: str, potential: str | None) -> None:
    """−c sgn x is the slope of c |x|, as gravity towards a plane from both sides; c sgn y along x has none."""
    found = of(JUMPS % (on_a, on_b))
    energies = [i.expression for i in found.integrals if i.quantity is ConservedQuantity.ENERGY]
    assert bool(energies) is (potential is not None)
    if potential is not None:
        letters = {n: sp.Symbol(n, real=True) for n in ("x", "y", "x'", "y'")}
        letters |= {n: sp.Symbol(n, positive=True) for n in ("m", "c")}
        v = energies[0].xreplace({letters["x'"]: sp.S.Zero, letters["y'"]: sp.S.Zero})
        assert sp.expand(v - sp.sympify(potential, locals=letters)) == 0


def test_a_potential_that_is_not_found_is_not_denied() -> None:
    found = of(JUMPS % ("-c*x*abs(x)", "0"))
    assert found.energy is None or found.energy.hidden


FRICTION = """
title: Block on a rough table
parameters: [m, g, mu]
coordinates: [x, y, z]
particles:
  P: {mass: m, position: x*i + y*j + z*k}
gravity: -g*k
constraints: {table: z = 0}
forces:
  rub: {friction: mu, constraint: table, on: P, contact: positive}
"""


def test_friction_takes_energy_even_where_it_is_constant() -> None:
    found = of(FRICTION)
    assert not found.integrals
    assert found.energy is not None
    s = {n: sp.Symbol(n, real=True) for n in ("x'", "y'")}
    p = {n: sp.Symbol(n, positive=True) for n in ("m", "g", "mu")}
    expected = -p["mu"] * p["m"] * p["g"] * sp.sqrt(s["x'"] ** 2 + s["y'"] ** 2)
    assert sp.simplify(found.energy.rate - expected) == 0


DRAG = """
title: Shot against the air
parameters: [m]
functions: {D: [v]}
coordinates: [x, y]
particles:
  P: {mass: m, position: x*i + y*j}
let: {v: "sqrt(x'^2 + y'^2)"}
forces:
  air: {on: P, vector: "-D(v)/v*(x'*i + y'*j)"}
"""


def test_the_power_of_a_resistance_is_one_term() -> None:
    """−v D(v), and not −x'² D(v)/v − y'² D(v)/v."""
    found = of(DRAG)
    assert found.energy is not None
    assert found.energy.rate is not None
    assert not found.energy.rate.is_Add
    assert len(found.energy.rate.atoms(sp.Pow)) == 3  # the two squares and v


HOOP = """
title: Bead on a hoop that turns
parameters: [m, R, g, Omega]
coordinates: [theta]
particles:
  P: {mass: m, position: R*sin(theta)*(cos(Omega*t)*i + sin(Omega*t)*j) - R*cos(theta)*k}
gravity: -g*k
"""


def test_a_hoop_that_is_turned_conserves_jacobis_integral_and_not_the_energy() -> None:
    found = of(HOOP)
    assert kinds(found) == [("jacobi", "time-free")]
    assert found.energy is not None
    assert found.energy.rate is not None
    turned = of(HOOP.replace("Omega*t", "Omega*t^2"))
    assert not turned.integrals
    assert turned.energy is not None


LIFT = """
title: Pendulum in a lift that rises with constant acceleration
parameters: [m, l, g, a]
coordinates: [theta]
particles: {P: {mass: m, position: "l*sin(theta)*i + (a*t^2/2 - l*cos(theta))*j"}}
gravity: -g*j
"""


def test_in_a_lift_with_constant_acceleration_the_pendulum_has_an_energy_with_more_weight() -> None:
    """l θ'' + (g + a) sin θ = 0; of any other lift it has none."""
    found = of(LIFT)
    assert kinds(found) == [("jacobi", "time-rate")]
    assert differences(found, "m*l^2*v_theta^2/2 - m*l*(g + a)*cos(theta)") == [0]
    assert found.energy is not None  # as seen from the ground it is not constant
    assert not of(LIFT.replace("a*t^2/2", "a*sin(t)")).integrals


SCREW = """
title: A particle on a ramp that turns uniformly
parameters: [m, a, omega, g]
coordinates: [rho, phi, z]
frame: {type: cylindrical, coordinates: [rho, phi, z]}
particles: {P: {mass: m, position: rho*e_rho + z*k}}
constraints: {ramp: z = a*(phi - omega*t)}
gravity: -g*k
generalized_coordinates: {lab: {coordinates: [rho, phi]}}
"""


def test_jacobis_integral_of_what_is_carried_has_no_constant_terms() -> None:
    [choice] = solve(read_problem(Source("p.yaml", SCREW))).choices
    assert choice.conserved is not None
    [jacobi] = choice.conserved.integrals
    assert jacobi.because is Because.CARRIED
    slots = choice.conserved.motion.configuration.slots
    moving = {*slots.coordinates, *slots.velocities}
    assert all(not term.free_symbols.isdisjoint(moving) for term in sp.Add.make_args(jacobi.expression))


CORD = """
title: A disc and a cord
parameters: [m, J, R, T]
coordinates: [{coordinates}]
bodies:
  disc: {{mass: m, inertia: J, position: {position}, angle: phi}}
forces:
  cord: {{on: disc, vector: T*j, at: {at}}}
"""


@pytest.mark.parametrize(
    ("coordinates", "position", "at", "expected"),
    [
        ("phi", "0*i", "R*i", ["J*v_phi^2/2 - T*R*phi"]),  # a cord that leaves the disc on its right, at every angle
        ("phi", "0*i", "R*e1_disc", ["J*v_phi^2/2 - T*R*sin(phi)"]),  # a cord tied to the rim
        ("y, phi", "-y*j", "R*i - y*j", ["J*v_phi + m*R*v_y", "m*v_y^2/2 + J*v_phi^2/2 + T*y - T*R*phi"]),  # a yo-yo
        ("phi", "0*i", "R*cos(2*phi)*i", ["J*v_phi^2/2 - T*R*sin(2*phi)/2"]),  # neither
    ],
    ids=["unwinding", "tied", "yo-yo", "moving"],
)
def test_the_potential_of_a_cord(coordinates: str, position: str, at: str, expected: list[str]) -> None:
    """−F·r is the potential of a constant force only where its point of application is carried by the body."""
    found = of(CORD.format(coordinates=coordinates, position=position, at=at))
    assert [sp.simplify(d) for d in differences(found, *expected)] == [0] * len(expected)
