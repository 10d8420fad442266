"""What a result says, against numbers and hand calculations."""

from __future__ import annotations

from functools import cache

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.mechanics.meaning import ResultMeaning, meaning
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load, read_problem
from tests.support.shared import SHIPPED

SPRING = """
title: Mass on a spring and a rod
parameters: {m: positive, M: positive, l: positive, g: positive}
coordinates: [s, theta]
particles:
  A: {mass: M, position: s*i}
  B: {mass: m, position: "[s + l*sin(theta), -l*cos(theta)]"}
gravity: -g*j
"""


@cache
def of(name: str) -> ResultMeaning:
    found = meaning(solve(load(str(SHIPPED[name]))))
    assert found is not None
    return found


def symbols(m: ResultMeaning) -> dict[str, sp.Symbol]:
    return {s.name: s for e in m.view.motion.final for s in e.expression.free_symbols}  # type: ignore[union-attr]


def test_limits_hold_in_numbers() -> None:
    """The accelerations at a small value of the parameter are those of the limit, to first order."""
    for name in ("ex11-ideal-pendulum", "double-atwood", "ex18-double-pendulum"):
        m = of(name)
        assert m.limits, name
        motion = m.view.motion
        assert motion is not None
        accelerations = m.view.configuration.slots.accelerations
        every = sorted({s for e in motion.expressions for s in e.free_symbols} - {*accelerations}, key=str)
        for limit in m.limits:
            there = {s: sp.Rational(7 + 3 * n, 10 + n) for n, s in enumerate(every)}
            near = sp.Rational(10**8) if limit.to == sp.oo else there.get(limit.to, 0) + sp.Rational(1, 10**8)
            exact = [e.xreplace({**there, limit.parameter: near}) for e in motion.expressions]
            limiting = [e.xreplace(there) for e in limit.equations]
            a, b = (sp.linsolve(es, *accelerations) for es in (exact, limiting))
            for x, y in zip(next(iter(a)), next(iter(b)), strict=True):
                assert abs(float(x - y)) < 1e-5, (name, limit.parameter)


def test_a_mass_that_grows_leaves_the_upper_pendulum_alone() -> None:
    m = of("ex18-double-pendulum")
    growing = [x for x in m.limits if x.to == sp.oo or x.to == 0]
    assert growing
    assert all(x.parameter.name in {"g", "l1", "l2", "m1", "m2"} for x in growing)


def test_a_parameter_without_which_nothing_moves_has_no_limit() -> None:
    """At l = 0 the pendulum's equation is g sin θ = 0, which determines no motion."""
    assert {x.parameter.name for x in of("ex11-ideal-pendulum").limits} == {"g"}


def test_the_tension_is_split_into_rest_and_motion() -> None:
    m = of("ex11-ideal-pendulum")
    [parts] = m.parts
    s = symbols(m)
    mass = next(x for x in parts.at_rest.free_symbols if x.name == "m")
    rate = next(x for x in parts.added.free_symbols if x.name == "theta'")
    assert sp.expand(parts.at_rest - mass * s["g"] * sp.cos(s["theta"])) == 0
    assert sp.expand(parts.added - mass * s["l"] * rate**2) == 0


def test_a_moving_constraint_is_never_at_rest() -> None:
    assert not of("ex17-spherical-pendulum").parts


def test_units_are_those_of_every_term() -> None:
    terms = of("ex11-ideal-pendulum").terms
    assert terms is not None
    assert terms[2] == "1/s^2"  # of (g/l) sin θ, as of θ''


@pytest.mark.parametrize(
    "name",
    [
        "ex18-double-pendulum",  # one equation in N, the other in m/s²
        "aircraft",  # the equations on the page are those in quasi-velocities
        "relativistic-oscillator",  # kg m⁴/s⁵
    ],
)
def test_no_unit_where_it_is_not_that_of_every_printed_term(name: str) -> None:
    assert of(name).terms is None


@pytest.mark.parametrize("name", ["sliding-ladder", "ladder-leaves-the-wall", "load-that-lifts-a-chain"])
def test_no_caution_about_a_value_that_statics_does_not_give(name: str) -> None:
    assert not of(name).parts


@pytest.mark.parametrize("name", ["ex11-ideal-pendulum"])
def test_small_motion_has_the_period_of_the_pendulum(name: str) -> None:
    small = of(name).small
    assert small is not None
    squares = [at.frequencies[0].square for at in small.at if at is not None]
    s = symbols(of(name))
    assert s["g"] / s["l"] in squares


def test_three_degrees_of_freedom_get_no_small_motion() -> None:
    third = SPRING.replace("[s, theta]", "[s, theta, q]").replace("gravity", "  C: {mass: m, position: q*i}\ngravity")
    found = meaning(solve(read_problem(Source("spring", third))))
    assert found is not None
    assert found.small is None


def test_without_a_degree_of_freedom_there_is_nothing_to_say() -> None:
    text = "title: t\nparameters: [m]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\nconstraints: {c: x = 1}\n"
    assert meaning(solve(read_problem(Source("t", text)))) is None


def test_a_velocity_as_of_light_becomes_infinite_and_not_zero() -> None:
    """Weber's law becomes Coulomb's; the only mass does not vanish."""
    found = of("weber-attraction")
    [limit] = [x for x in found.limits if x.parameter.name == "c"]
    assert limit.to == sp.oo
    s = symbols(found)
    r, k, m = s["r"], s["k"], s["m"]
    radial = limit.equations[0]
    coulomb = m * (s["r''"] - r * s["phi'"] ** 2) - k / r**2
    assert sp.simplify(radial / coulomb) == -r
    assert all(x.to != 0 or x.parameter.name != "m" for x in found.limits)


BOWL = """
title: Outside of a cylinder
axes: {i: right, j: up}
parameters: [m, R, g]
coordinates: [r, theta]
frame: {type: polar, coordinates: [r, theta]}
particles: {P: {mass: m, position: r*e_r}}
constraints: {cylinder: {equation: r >= R, reaction: N}}
gravity: -g*j
generalized_coordinates: {angle: {coordinates: [theta], substitute: {r: R}}}
"""


@pytest.mark.parametrize(("sign", "without_weight"), [(">=", False), ("<=", True)])
def test_no_limit_in_which_contact_is_lost(sign: str, without_weight: bool) -> None:
    """Without weight N = −m R theta'^2 on the outside, where there is no contact, and m R theta'^2 on the inside."""
    found = meaning(solve(read_problem(Source("cylinder.yaml", BOWL.replace(">=", sign)))))
    assert found is not None
    assert any(x.parameter.name == "g" for x in found.limits) is without_weight


def test_no_limit_for_a_ladder_that_would_have_to_be_pulled() -> None:
    """Without weight N = −m l θ'² sin θ, and neither floor nor wall touches it."""
    assert not [x for x in of("sliding-ladder").limits if x.parameter.name == "g"]


def test_no_limit_says_only_that_nothing_accelerates() -> None:
    """A mass that grows stands still and without forces nothing is accelerated: neither is worth a line."""
    text = "title: Two\nparameters: [m, M, k]\ncoordinates: [x, X]\nparticles: {P: {mass: m, position: x*i}, "
    text += "S: {mass: M, position: X*i}}\nforces: {f: {spring: k, between: [P, S]}}\n"
    found = meaning(solve(read_problem(Source("two.yaml", text))))
    assert found is not None
    still = [x for x in found.limits if all(e in found.view.configuration.slots.accelerations for e in x.equations)]
    assert not still
    assert not [x for x in found.limits if x.to == sp.oo]


def test_contact_on_a_dome_lasts_up_to_a_velocity() -> None:
    [end] = of("slide-off-a-dome").ends
    view = of("slide-off-a-dome").view
    assert view.dynamics is not None
    assert view.dynamics.reactions is not None
    N = view.dynamics.reactions.sizes["dome"]
    for speed, sign in ((0.9, 1), (1.1, -1)):
        values = {"m": 1, "R": 2, "g": 10, "theta": sp.Rational(1, 2)}
        numbers = {s: values[s.name] for s in (N.free_symbols | end.square.free_symbols) if s.name in values}
        at = N.subs(end.velocity, speed * sp.sqrt(end.square)).subs(numbers)
        assert sp.sign(at.evalf()) == sign
    assert end.relation == "<"


def test_the_taut_string_of_a_loop_needs_a_velocity() -> None:
    text = """
title: Bob on a string
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {string: {equation: x^2 + y^2 <= l^2, reaction: T}}
gravity: -g*j
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
"""
    found = meaning(solve(read_problem(Source("string.yaml", text))))
    assert found is not None
    [end] = found.ends
    g, l = (next(s for s in end.square.free_symbols if s.name == n) for n in ("g", "l"))
    theta = found.view.configuration.slots.coordinates[0]
    assert (end.relation, sp.expand(end.square - g / l * sp.cos(theta))) == (">", 0)
