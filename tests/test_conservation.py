"""What is conserved, against the literature and against motions integrated from equations of a second route.

The table has integrals as books have them, and functions that are not conserved although they look like it: momenta of
cyclic coordinates in nonholonomic systems, energies where constraints move. `v_q` stands for q'.
"""

from __future__ import annotations

import re
from functools import cache

import pytest
import sympy as sp
from second_route import states
from test_textbook_systems import SYSTEMS, concrete, names_in, routes_of, solution_of
from trajectories import Motion, State, function_of

from lagrange.algebra.fourier.textbook import Textbook
from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Prose, Rule
from lagrange.explain.report import report
from lagrange.mechanics.dynamics.conservation import Because, Conserved, Quantity, first_integral
from lagrange.mechanics.dynamics.energy_functions import energy_functions
from lagrange.mechanics.dynamics.noether import Kind, candidates, symmetries
from lagrange.mechanics.solution import Solution, solve
from lagrange.problem.loader import read_problem
from lagrange.render.json import as_object

STEP, STEPS = 0.004, 60
CONSTANT, CHANGES = 3e-7, 1e-5
WILDEST = 60
"""A motion with larger accelerations is not integrated so exactly: another is taken."""

KNOWN: dict[str, tuple[list[str], list[str]]] = {
    # name: (what is conserved, what is not)
    "kepler": (["m*r^2*v_phi", "m*(v_r^2 + r^2*v_phi^2)/2 - kappa/r"], ["m*v_r"]),
    "heavy_top": (
        [
            "((A + m*l^2)*sin(theta)^2 + C*cos(theta)^2)*v_phi + C*v_psi*cos(theta)",
            "C*(v_psi + v_phi*cos(theta))",
            "(A + m*l^2)*(v_theta^2 + v_phi^2*sin(theta)^2)/2 + C*(v_psi + v_phi*cos(theta))^2/2 + m*g*l*cos(theta)",
        ],
        ["(A + m*l^2)*v_theta"],
    ),
    "spherical_pendulum": (
        ["m*l^2*v_phi*sin(theta)^2", "m*l^2*(v_theta^2 + v_phi^2*sin(theta)^2)/2 - m*g*l*cos(theta)"],
        ["m*l^2*v_theta"],
    ),
    "ball_on_turntable": (
        [
            "v_gamma*2*m*R^2/5",
            "2*m*R^2*v_alpha/5 - m*R*v_y",
            "2*m*R^2*v_beta/5 + m*R*v_x",
            "m*(v_x^2 + v_y^2)/2 + m*R^2*(v_alpha^2 + v_beta^2 + v_gamma^2)/5 - m*Omega*(x*v_y - y*v_x)",
        ],
        ["m*(v_x^2 + v_y^2)/2 + m*R^2*(v_alpha^2 + v_beta^2 + v_gamma^2)/5", "m*v_x"],
    ),
    "rolling_disc": ([], ["v_x", "v_y"]),
    "heavy_sleigh": (
        ["m*(v_x^2 + v_y^2)/2 + m*a*v_theta*(v_y*cos(theta) - v_x*sin(theta)) + (I_G + m*a^2)*v_theta^2/2"],
        ["m*v_x - m*a*v_theta*sin(theta)", "m*v_y + m*a*v_theta*cos(theta)", "(I_G + m*a^2)*v_theta"],
    ),
    "knife_edge": (["2*m*a^2*v_theta"], ["2*m*v_x"]),
    "drifting_skate": (
        ["2*m*l^2*v_theta", "m*(v_x^2 + v_y^2) + m*l^2*v_theta^2 - 2*m*v*v_x"],
        ["m*(v_x^2 + v_y^2) + m*l^2*v_theta^2", "2*m*v_x"],
    ),
    "conveyor": (["m*v_x + m*c*v_y"], ["m*(v_x^2 + v_y^2)/2", "m*v_x"]),
    "foucault": (
        [
            "m*(X*v_Y - Y*v_X) + m*Omega*(X^2 + Y^2)",
            "m*(v_X^2 + v_Y^2)/2 + m*w^2*(X^2 + Y^2)/2 - m*Omega^2*(X^2 + Y^2)/2",
        ],
        ["m*(v_X^2 + v_Y^2)/2 + m*w^2*(X^2 + Y^2)/2"],
    ),
    "charged_particle": (
        ["m*v_z", "m*v_x - sigma*q*B*y", "m*(v_x^2 + v_y^2 + v_z^2)/2 - sigma*q*E*y"],
        ["m*(v_x^2 + v_y^2 + v_z^2)/2", "m*v_x"],
    ),
    "projectile_with_drag": (
        ["m*v_x + c*x", "m*v_y + c*y"],
        ["m*v_x", "m*(v_x^2 + v_y^2 + v_z^2)/2 + m*g*z"],
    ),
    "central_force_in_space": (["m*r^2*v_phi*sin(theta)^2"], ["m*(v_r^2 + r^2*v_theta^2 + r^2*v_phi^2*sin(theta)^2)/2"]),
    "free_top": ([], ["C*(v_psi + v_phi*cos(theta))"]),
    "heavy_top_cardan": (["C*(v_gamma + v_alpha*sin(beta))"], ["v_alpha"]),
    "compound_pendulum": (["(I_G + m*a^2)*v_theta^2/2 - m*g*a*cos(theta)"], ["v_theta"]),
    "elastic_pendulum": (
        ["m*(v_r^2 + r^2*v_phi^2)/2 + kappa*(r - l0)^2/2 - m*g*r*cos(phi)"],
        ["m*r^2*v_phi"],
    ),
    "driven_wheel": (["(m*l^2 + A)*v_theta^2/2 - m*g*l*cos(theta)"], ["v_theta"]),
    "moved_support": ([], ["m*l^2*v_theta^2/2 - m*g*l*cos(theta)"]),
    "damped_oscillator": ([], ["m*v_x^2/2 + c*x^2/2"]),
    "torus": (["m*(x*v_y - y*v_x)", "m*(v_x^2 + v_y^2 + v_z^2)/2 + m*g*z"], ["m*v_x"]),
    "moving_surface": (
        ["m*(v_x^2 + v_y^2 + v_z^2)/2 + m*g*z - m*v*v_x"],
        ["m*(v_x^2 + v_y^2 + v_z^2)/2 + m*g*z"],
    ),
    "turning_rail": (["m*(v_x^2 + v_y^2)/2 - F*x"], ["m*v_y"]),
    "heisenberg": (["m*(v_x^2 + v_y^2 + v_z^2)/2 + m*g*z"], ["m*(x*v_y - y*v_x)"]),
    "two_wheels": (
        ["2*m*b^2*v_theta + mu*b*R*(v_phi2 - v_phi1)", "m*(v_x^2 + v_y^2) + m*b^2*v_theta^2 + mu*R^2*(v_phi1^2 + v_phi2^2)/2"],
        ["2*m*v_x"],
    ),
    "stretched_dumbbell": ([], ["m*(v_x1 + v_x2)", "m*(v_x1^2 + v_y1^2 + v_x2^2 + v_y2^2)/2"]),
    "integrable_together": (["m*(v_x^2 + v_y^2 + v_z^2)/2 + m*g*z"], ["m*v_x"]),
    "free_top_quasi": ([], ["A*v_p^2/2 + B*v_q^2/2 + C*v_r^2/2"]),
    "heavy_slider_crank": ([], []),
    "triple_pendulum": ([], ["m*l^2*(3*v_a + 2*v_b*cos(a - b) + v_c*cos(a - c))"]),
    "cart_with_pendulum": ([], []),
    "block_on_wedge": ([], []),
}  # fmt: skip


def read(text: str) -> sp.Expr:
    """An expression of the table; v_q is q'."""
    names = set(re.findall(r"[A-Za-z_]\w*", text)) - {"sin", "cos", "sqrt"}
    local = {n: sp.Symbol(n.removeprefix("v_") + "'" if n.startswith("v_") else n, real=True) for n in names}
    return sp.sympify(text.replace("^", "**"), locals=local)


@cache
def solved(name: str) -> Solution:
    return solution_of(name).solution


@cache
def motion_of(name: str) -> tuple[State, ...]:
    """A motion of the system, as the second route gives it."""
    book, solution = SYSTEMS[name], solved(name)
    route = routes_of(name)[0]
    found = solution.conserved
    assert found is not None
    shown = [concrete(i.expression, book) for i in found.integrals]
    if found.energy is not None:
        shown += [concrete(e, book) for e in (found.energy.expression, found.energy.rate) if e is not None]
    parameters = {p.symbol.name for p in solution.problem.parameters}
    extra = names_in([*shown, *(read(e) for part in KNOWN.get(name, ()) for e in part)]) | parameters
    extra = {n for n in extra if n not in route.unknowns and not n.startswith("lambda_") and not n.endswith("''")}
    prescribed = [u.name for u in solution.problem.slots.prescribed]
    extra |= {u + primes for u in prescribed for primes in ("", "'", "''")}
    for start in states(route, extra, book.ranges, 7, 6):
        values = {n: float(v) for n, v in start.items()}
        try:
            motion = tuple(Motion(route, prescribed).trajectory(values, STEP, STEPS))
        except (ValueError, ZeroDivisionError, OverflowError, AssertionError):
            continue
        if max(abs(v) for s in motion for n, v in s.items() if n.rstrip("'") in route.coordinates) < WILDEST:
            return motion
    raise AssertionError("no motion")


def change(name: str, expression: sp.Expr) -> float:
    """The largest change of an expression along the motion, relative to its size."""
    value = function_of(concrete(expression, SYSTEMS[name]))
    values = [value(s) for s in motion_of(name)]
    return max(abs(v - values[0]) for v in values) / (1 + abs(values[0]))


@pytest.mark.parametrize("name", SYSTEMS)
def test_what_is_called_conserved_is_constant_along_motions_of_the_second_route(name: str) -> None:
    found = solved(name).conserved
    assert found is not None
    for i in found.integrals:
        assert i.constant is True
        assert change(name, i.expression) < CONSTANT, i


@pytest.mark.parametrize("name", SYSTEMS)
def test_what_is_called_not_conserved_changes(name: str) -> None:
    found = solved(name).conserved
    assert found is not None
    for momentum in found.bound.values():
        assert change(name, momentum) > CHANGES, momentum
    if found.energy is not None:
        assert found.energy.rate is not None
        assert change(name, found.energy.expression) > CHANGES


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_rate_of_the_energy_is_that_along_the_motion(name: str) -> None:
    found = solved(name).conserved
    assert found is not None
    if found.energy is None:
        return
    assert found.energy.rate is not None
    called = {c.reaction: sp.Symbol(f"lambda_{c.name}", real=True) for c in solved(name).problem.constraints}
    rate = concrete(found.energy.rate.xreplace(called), SYSTEMS[name])
    motion = motion_of(name)
    if not names_in([rate]) <= motion[0].keys():
        pytest.skip("the second route has no such multiplier")
    energy, value = function_of(concrete(found.energy.expression, SYSTEMS[name])), function_of(rate)
    for n in (10, 30, 50):
        before2, before, after, after2 = (energy(motion[n + k]) for k in (-2, -1, 1, 2))
        slope = (before2 - 8 * before + 8 * after - after2) / (12 * STEP)
        assert slope == pytest.approx(value(motion[n]), rel=1e-3, abs=1e-4)


@pytest.mark.parametrize("name", KNOWN)
def test_the_integrals_of_the_literature_are_found(name: str) -> None:
    """Each is one of those found, up to a constant factor and a constant, at the states of a motion and others."""
    found = solved(name).conserved
    assert found is not None
    for text in KNOWN[name][0]:
        assert change(name, read(text)) < CONSTANT, f"{text} is not even conserved"
        assert any(_same(name, read(text), i.expression) for i in found.integrals), text


@pytest.mark.parametrize("name", KNOWN)
def test_what_is_not_conserved_is_not_claimed(name: str) -> None:
    found = solved(name).conserved
    assert found is not None
    for text in KNOWN[name][1]:
        assert change(name, read(text)) > CHANGES, f"{text} is conserved"
        assert not any(_same(name, read(text), i.expression) for i in found.integrals), text


def _same(name: str, one: sp.Expr, other: sp.Expr) -> bool:
    """Whether a − b or a/b is constant at random states with the same parameters, whether on one motion or not."""
    route, book = routes_of(name)[0], SYSTEMS[name]
    motion = motion_of(name)
    fixed = {p.symbol.name for p in solved(name).problem.parameters}
    f, g = (function_of(concrete(e, book)) for e in (one, other))
    values = []
    for s in states(route, set(motion[0]) - set(route.unknowns), book.ranges, 11, 5):
        there = {k: motion[0][k] if k in fixed else float(v) for k, v in s.items()}
        values.append((f(there), g(there)))
    ratio = next(((a - values[0][0]) / d for a, b in values[1:] if abs(d := b - values[0][1]) > 1e-6), None)
    if ratio is None or abs(ratio) < 1e-9:
        return False
    return all(abs((a - values[0][0]) - ratio * (b - values[0][1])) < 1e-7 * (1 + abs(a)) for a, b in values)


# -- proofs ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_multipliers_prove_the_integral(name: str) -> None:
    """Σ ν_k E_k = dI/dt along motions that are no motions of the system: accelerations are arbitrary."""
    found = solved(name).conserved
    assert found is not None
    book, slots = SYSTEMS[name], solved(name).problem.slots
    motion = motion_of(name)
    for i in found.integrals:
        if i.because in (Because.NO_REACTION, Because.DEPENDENT):
            assert not i.multipliers
            continue
        assert i.multipliers, i
        sides = sp.Add(*(m * e for m, e in zip(i.multipliers, found.motion.expressions, strict=True)))
        rate = slots.time_derivative(i.expression)
        left, right = function_of(concrete(sides, book)), function_of(concrete(rate, book))
        for n, s in enumerate(motion[::25]):
            pushed = {**s, **{f"{q}''": 0.3 + 0.7 * k + n for k, q in enumerate(map(str, slots.coordinates))}}
            assert left(pushed) == pytest.approx(right(pushed), rel=1e-7, abs=1e-7)


def test_energies_that_are_conserved_say_so_in_every_choice() -> None:
    for name in ("cart_with_pendulum", "particle_in_cone", "paraboloid", "slider_crank"):
        for c in solved(name).choices:
            assert c.conserved is not None
            assert Quantity.ENERGY in {i.quantity for i in c.conserved.integrals}, (name, c.name)


# -- made-up systems ---------------------------------------------------------------------------------------------------


def of(text: str) -> Conserved:
    found = solve(read_problem(Source("p.yaml", text)), complete=True).conserved
    assert found is not None
    return found


def kinds(found: Conserved) -> list[tuple[str, str]]:
    return [(i.quantity.value, i.because.value) for i in found.integrals]


SKATE = """
title: Skate on ice
parameters: [m, J]
coordinates: [x, y, theta]
bodies:
  S: {mass: m, position: x*i + y*j, inertia: J, angle: theta}
constraints:
  blade: x'*sin(theta) - y'*cos(theta) = 0
"""


def test_a_virtual_displacement_of_a_skate_gives_a_momentum_although_no_coordinate_does() -> None:
    found = of(SKATE)
    assert kinds(found) == [("momentum", "cyclic"), ("momentum", "admitted"), ("energy", "conservative")]
    assert [q.name for q in found.bound] == ["x", "y"]
    assert not found.potential


def test_first_integrals_of_others_are_recognised() -> None:
    found = of(SKATE)
    x, y, theta = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta"))
    turn = sp.Symbol("theta'", real=True)
    assert first_integral(found.motion, x**2 + y**2) is True
    assert first_integral(found.motion, x * sp.cos(theta) + y * sp.sin(theta) + 3 * turn**2) is True
    assert first_integral(found.motion, x) is False
    assert first_integral(found.motion, x**2 - y**2) is False


GIVEN_FORCE = """
title: Central force, given
parameters: [m, kappa, c]
coordinates: [x, y]
particles:
  P: {mass: m, position: x*i + y*j}
forces:
  pull: {on: P, vector: "-kappa*(x*i + y*j)/(x^2 + y^2)^(3/2)"}
"""


def test_a_given_force_has_its_potential_and_the_plane_its_rotation() -> None:
    found = of(GIVEN_FORCE)
    assert kinds(found) == [("angular-momentum", "rotation"), ("energy", "conservative")]
    x, y = (sp.Symbol(n, real=True) for n in "xy")
    kappa = sp.Symbol("kappa", positive=True)
    assert (found.integrals[1].expression - (-kappa / sp.sqrt(x**2 + y**2))).free_symbols.isdisjoint({x, y})


def test_a_force_across_the_radius_has_no_potential_and_no_angular_momentum() -> None:
    found = of(GIVEN_FORCE.replace("-kappa*(x*i + y*j)", "kappa*(x*j - y*i)"))
    assert not found.integrals
    assert found.energy is not None
    assert not found.energy.hidden


def test_the_potential_of_an_undefined_force_is_not_denied() -> None:
    text = GIVEN_FORCE.replace("coordinates: [x, y]", "functions: {f: [r]}\ncoordinates: [x, y]")
    found = of(text.replace("-kappa*(x*i + y*j)/(x^2 + y^2)^(3/2)", "f(x)*i"))
    assert found.energy is not None
    assert found.energy.hidden
    assert kinds(found) == [("momentum", "cyclic")]


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


def test_the_step_says_why_and_json_has_the_multipliers() -> None:
    shown = report(read_problem(Source("p.yaml", SKATE)))
    [step] = [s for s in shown.derivation.steps if s.rule is Rule.CONSERVED]
    words = "".join(p for b in step.body if isinstance(b, Prose) for p in b.parts if isinstance(p, str))
    assert "their momenta are not conserved" in words
    assert "Nothing does work" in words
    entries = as_object(shown)["conserved"]
    assert [e["kind"] for e in entries] == ["momentum", "momentum", "energy"]
    assert entries[1]["displacement"] == {"x": "cos(theta)", "y": "sin(theta)"}
    assert all(e["multipliers"] for e in entries)
    assert not any("rate" in e for e in entries)


MAGNET = """
title: Charges in a magnetic field
parameters: [m, q, B, k]
coordinates: [x, y, X, Y]
particles:
  P: {mass: m, position: x*i + y*j}
  Q: {mass: m, position: X*i + Y*j}
forces:
  on_P: {on: P, vector: "q*B*(y'*i - x'*j)"}
  on_Q: {on: Q, vector: "q*B*(Y'*i - X'*j)"}
  repulsion: {potential: "k/sqrt((x - X)^2 + (y - Y)^2)"}
"""


def differences(found: Conserved, *expected: str) -> list[sp.Expr]:
    """The integrals less the expected ones, in the symbols of the table."""
    plain = [i.expression.xreplace({s: sp.Symbol(s.name, real=True) for s in i.expression.free_symbols})
             for i in found.integrals]  # fmt: skip
    return [sp.expand(p - read(e)) for p, e in zip(plain, expected, strict=True)]


def words_of(text: str) -> str:
    """The prose of the step."""
    shown = report(read_problem(Source("p.yaml", text)))
    [step] = [s for s in shown.derivation.steps if s.rule is Rule.CONSERVED]
    return "".join(p for b in step.body if isinstance(b, Prose) for p in b.parts if isinstance(p, str))


def test_two_charges_have_momenta_and_an_angular_momentum_in_a_magnetic_field() -> None:
    """Landau and Lifshitz II, § 21: the generalized momenta of both in the gauges where what is displaced is symmetric."""
    found = of(MAGNET)
    assert [k for k, _ in kinds(found)] == ["momentum", "momentum", "angular-momentum", "energy"]
    assert {b for k, b in kinds(found) if k != "energy"} == {"rate"}
    assert all(i.constant and i.multipliers for i in found.integrals)
    assert differences(
        found,
        "m*(v_x + v_X) - q*B*(y + Y)",
        "m*(v_y + v_Y) + q*B*(x + X)",
        "m*(x*v_y - y*v_x + X*v_Y - Y*v_X) + q*B*(x^2 + y^2 + X^2 + Y^2)/2",
        "m*(v_x^2 + v_y^2 + v_X^2 + v_Y^2)/2 + k/sqrt((x - X)^2 + (y - Y)^2)",
    ) == [0, 0, 0, 0]


def test_an_electric_field_takes_angular_momentum_away_and_leaves_the_difference_along_it() -> None:
    found = of(MAGNET.replace("k/sqrt((x - X)^2 + (y - Y)^2)", "k*(y + Y)"))
    assert {k for k, _ in kinds(found)} == {"momentum", "energy"}
    left = differences(found, "m*v_x - q*B*y", "m*v_X - q*B*Y", "m*(v_y - v_Y) + q*B*(x - X)",
                       "m*(v_x^2 + v_y^2 + v_X^2 + v_Y^2)/2 + k*(y + Y)")  # fmt: skip
    assert left[:2] == [0, 0]
    assert left[3] == 0
    assert left[2] in (0, sp.expand(read("-2*m*(v_y - v_Y) - 2*q*B*(x - X)")))  # or its negative


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


BALANCED = """
title: A particle on a turntable, held by a spring that balances the centrifugal force
parameters: [m, omega]
coordinates: [x, y]
let: {e: cos(omega*t)*i + sin(omega*t)*j, n: -sin(omega*t)*i + cos(omega*t)*j}
particles: {P: {mass: m, position: x*e + y*n}}
forces: {spring: {spring: m*omega^2, between: [P, 0*i]}}
"""


def test_a_momentum_of_a_coordinate_that_occurs_in_the_energies_is_not_called_cyclic() -> None:
    """m x' − 2 m ω y, because x'' − 2 ω y' = 0; but L has m ω (x y' − y x')."""
    found = of(BALANCED)
    assert ("momentum", "gauge") not in kinds(found)
    assert differences(of(BALANCED), *(
        "m*(x*v_y - y*v_x) + m*omega*(x^2 + y^2)", "m*v_x - 2*m*omega*y", "m*v_y + 2*m*omega*x",
        "m*(v_x^2 + v_y^2)/2", "m*((v_x - omega*y)^2 + (v_y + omega*x)^2)/2 + m*omega^2*(x^2 + y^2)/2",
    )) == [0, 0, 0, 0, 0]  # fmt: skip
    assert "in the energies, and the force" not in words_of(BALANCED)


PARALLEL = """
title: Two blades that are turned together, with a spring between them
parameters: [m, k]
coordinates: [x, y, X, Y]
functions: {u: [t]}
particles:
  P: {mass: m, position: x*i + y*j}
  Q: {mass: m, position: X*i + Y*j}
constraints:
  one: "x'*sin(u) = y'*cos(u)"
  other: "X'*sin(u) = Y'*cos(u)"
forces: {spring: {spring: k, between: [P, Q]}}
"""


def test_virtual_displacements_of_two_blades_together_give_a_momentum() -> None:
    """m (v + V), the speeds along the blades: the spring pulls them together, and the heading turns both velocities."""
    found = of(PARALLEL)
    assert ("momentum", "admitted") in kinds(found)
    [momentum] = [i for i in found.integrals if i.because is Because.ADMITTED]
    assert momentum.constant
    assert momentum.multipliers
    assert {str(q) for q in momentum.displacement or ()} == {"x", "y", "X", "Y"}


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


def test_a_momentum_is_found_whatever_parameters_are_drawn() -> None:
    """Of some R and a no rod of the length a fits in the field that is drawn: then others are drawn."""
    motion = solved("three_on_a_ring").motion
    assert motion is not None
    configuration = motion.configuration
    energies = energy_functions(configuration, Textbook(motion.principle.ring))
    found = candidates(energies, [])
    for seed in range(12):
        configuration.states.fields.random.seed(seed)
        assert {s.kind for s in symmetries(found, configuration)} == {Kind.TRANSLATION}, seed
