"""What is conserved, against the literature and against motions integrated from equations of a second route.

The table has integrals as books have them, and functions that are not conserved although they look like it: momenta of
cyclic coordinates in nonholonomic systems, energies where constraints move. `v_q` stands for q'.
"""

from __future__ import annotations

from functools import cache

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Prose, Rule
from lagrange.explain.report import report
from lagrange.mechanics.dynamics.conservation import Because, Conserved, ConservedQuantity, quantity_of
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.render.json import as_object
from tests.support.conserved import of, read
from tests.support.second_route import states
from tests.support.trajectories import Motion, State, function_of
from tests.truth.test_textbook_systems import SYSTEMS, concrete, names_in, routes_of, solution_of

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


@cache
def solved(name: str) -> Solution:
    return solution_of(name).solution


@cache
def motion_of(name: str) -> tuple[State, ...]:
    """A motion of the system, as the second route gives it."""
    book, solution = SYSTEMS[name], solved(name)
    route = routes_of(name)[0]
    found = solution.own.conserved
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
    found = solved(name).own.conserved
    assert found is not None
    for i in found.integrals:
        assert i.constant is True
        assert change(name, i.expression) < CONSTANT, i


@pytest.mark.parametrize("name", SYSTEMS)
def test_what_is_called_not_conserved_changes(name: str) -> None:
    found = solved(name).own.conserved
    assert found is not None
    for momentum in found.bound.values():
        assert change(name, momentum) > CHANGES, momentum
    if found.energy is not None:
        assert found.energy.rate is not None
        assert change(name, found.energy.expression) > CHANGES


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_rate_of_the_energy_is_that_along_the_motion(name: str) -> None:
    found = solved(name).own.conserved
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
    found = solved(name).own.conserved
    assert found is not None
    for text in KNOWN[name][0]:
        assert change(name, read(text)) < CONSTANT, f"{text} is not even conserved"
        assert any(_same(name, read(text), i.expression) for i in found.integrals), text


@pytest.mark.parametrize("name", KNOWN)
def test_what_is_not_conserved_is_not_claimed(name: str) -> None:
    found = solved(name).own.conserved
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
    found = solved(name).own.conserved
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


# -- made-up systems ---------------------------------------------------------------------------------------------------


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


def test_the_step_says_why_and_json_has_the_multipliers() -> None:
    shown = report(read_problem(Source("p.yaml", SKATE)))
    [step] = [s for s in shown.derivation.steps if s.rule is Rule.CONSERVED]
    words = "".join(p for b in step.body if isinstance(b, Prose) for p in b.parts if isinstance(p, str))
    assert "their momenta are not conserved" in words
    assert "No force does work" in words
    entries = as_object(shown)["conserved"]
    assert [e["kind"] for e in entries] == ["momentum", "momentum", "energy"]
    assert entries[1]["displacement"] == {"x": "cos(theta)", "y": "sin(theta)"}
    assert all(e["multipliers"] for e in entries)
    assert not any("rate" in e for e in entries)


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


def test_a_screw_is_no_rotation() -> None:
    """A field that winds about the k axis: δz = p ε goes with the rotation, and no angular momentum is conserved."""
    text = (
        "title: Helical field\nparameters: [m, c, p]\ncoordinates: [x, y, z]\n"
        "particles: {P: {mass: m, position: x*i + y*j + z*k}}\n"
        "forces: {f: {potential: c*(x*cos(z/p) + y*sin(z/p))}}\n"
    )
    found = report(read_problem(Source("p.yaml", text)))
    conserved = found.solution.own.conserved
    assert conserved is not None
    assert [(i.quantity.value, i.because) for i in conserved.integrals] == [
        ("momentum", Because.SCREW),
        ("energy", Because.CONSERVATIVE),
    ]
    [step] = [s for s in found.derivation.steps if s.rule is Rule.CONSERVED]
    words = " ".join(str(p) for b in step.body if isinstance(b, Prose) for p in b.parts)
    assert "The screw displacement" in words
    assert "angular momentum" not in words


TURNED = "coordinates: [{q}, phi]\nparameters: [h, m, J]\nbodies: {{B: {{mass: m, inertia: [J, J, J], position: {q}*{along}, "


@pytest.mark.parametrize(("along", "quantity"), [("k", "MOMENTUM"), ("i", "ANGULAR_MOMENTUM")])
def test_the_momentum_of_a_screw_is_no_angular_momentum(along: str, quantity: str) -> None:
    """m h ż + J φ̇ of a nut on a thread; of a disc that rolls it is that about the line on which it rolls."""
    text = f"title: Nut\n{TURNED.format(q='z', along=along)}orientation: {{axes: 313, angles: [phi, 0, 0]}}}}}}\n"
    motion = solve(read_problem(Source("nut.yaml", text + "constraints: {thread: z = h*phi}\n"))).own
    conserved = motion.conserved
    assert conserved is not None
    called = [quantity_of(i, motion.configuration) for i in conserved.integrals]
    assert called == [ConservedQuantity[quantity], ConservedQuantity.ENERGY]


@pytest.mark.parametrize(
    ("what", "quantity"),
    [
        ("particles: {P: {mass: m, position: h*(cos(phi)*i + sin(phi)*j + phi*k)}}", "MOMENTUM"),
        ("particles: {P: {mass: m, position: h*(cos(phi)*i + sin(phi)*(3*j + 4*k)/5)}}", "ANGULAR_MOMENTUM"),
        (
            "bodies: {B: {mass: m, inertia: [J, J, J], position: h*phi*k, orientation: {axes: 313, angles: [phi, 0, 0]}}}",
            "MOMENTUM",
        ),
        (
            "bodies: {A: {inertia: J, position: 0*i, angle: phi}, B: {inertia: J, position: h*i, angle: -2*phi}}",
            "MOMENTUM",
        ),
        ("bodies: {wheel: {mass: m, inertia: J, position: h*phi*i, angle: -phi}}", "ANGULAR_MOMENTUM"),
    ],
)
def test_one_coordinate_that_moves_like_a_screw_or_like_gears_has_no_angular_momentum(what: str, quantity: str) -> None:
    text = f"title: T\nparameters: [m, h, J]\ncoordinates: [phi]\n{what}\n"
    motion = solve(read_problem(Source("p.yaml", text))).own
    assert motion.conserved is not None
    called = [quantity_of(i, motion.configuration) for i in motion.conserved.integrals]
    assert called == [ConservedQuantity[quantity], ConservedQuantity.ENERGY]
