"""Masses that vary: how they are read and refused, and what they change in the results."""

from __future__ import annotations

import pytest
import sympy as sp

import lagrange
from lagrange.answers.equations import Verdict
from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import NotCoveredError, ProblemError, Source
from lagrange.mechanics.constraints.variable_mass import validities
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from tests.support.shared import reported

HEAD = "title: t\nparameters: [m_0, q, u, g, k, l]\ncoordinates: [x, y]\n"


def read(particle: str, more: str = "") -> Problem:
    return read_problem(Source("case.yaml", f"{HEAD}particles: {{P: {{position: x*i + y*j, {particle}}}}}\n{more}\n"))


def refusal(particle: str, more: str = "") -> str:
    with pytest.raises(ProblemError) as caught:
        solve(read(particle, more))
    return caught.value.diagnostics[0].code


def solved(particle: str, more: str = "", method: Method = Method.DALEMBERT) -> Solution:
    solution = solve(read(particle, more), method=method)
    assert [c.name for c in solution.checks if c.passed is not True] == []
    return solution


@pytest.mark.parametrize(
    ("particle", "code"),
    [
        ("mass: m_0 - q*t", "variable-mass"),
        ("mass: k*x", "variable-mass"),
        ("mass: m_0, leaves: {velocity: 0}", "mass-exchange"),
        ("mass: m_0 - q*t, gains: {velocity: 0}", "mass-exchange"),
        ("mass: m_0 + q*t, leaves: {velocity: 0}", "mass-exchange"),
        ("mass: m_0 - q*t, leaves: {velocity: 0}, gains: {velocity: 0}", "mass-exchange"),
        ("mass: m_0 - q*t, leaves: {velocity: 0, relative: -u*i}", "mass-exchange"),
        ("mass: m_0 - q*t, leaves: {}", "mass-exchange"),
        ("mass: m_0 - q*t, leaves: {speed: u*i}", "unknown-key"),
        ("mass: m_0*x', leaves: {velocity: 0}", "not-allowed-here"),
        ("mass: -q*t, leaves: {velocity: 0}", "starts-without-mass"),
    ],
)
def test_what_says_too_little_or_contradicts_itself_is_refused(particle: str, code: str) -> None:
    assert refusal(particle, "initial: {x: 0}") == code


def test_a_rigid_body_keeps_its_mass() -> None:
    text = f"{HEAD}bodies: {{B: {{mass: m_0 - q*t, inertia: k, position: x*i + y*j, angle: t}}}}\n"
    with pytest.raises(ProblemError, match="a rigid body keeps its mass"):
        read_problem(Source("case.yaml", text))


@pytest.mark.parametrize(
    "entries",
    ["mass: m_0 - q*t, inertia: k", "mass: m_0, inertia: k*t", "mass: m_0, inertia: k, leaves: {relative: -u*e1_B}"],
)
def test_the_part_of_a_body_that_varies_is_a_particle(entries: str) -> None:
    text = f"{HEAD}bodies: {{B: {{{entries}, position: x*i + y*j, angle: t}}}}\n"
    with pytest.raises(ProblemError) as error:
        read_problem(Source("case.yaml", text))
    assert any("particle that the body carries" in d.help for d in error.value.diagnostics)
    assert "circular-definition" not in [d.code for d in error.value.diagnostics]


@pytest.mark.parametrize("find", ["equilibrium", "hamiltonian", "steady", "response", "linearization"])
def test_what_needs_a_constant_mass_is_refused(find: str) -> None:
    with pytest.raises(NotCoveredError, match="`P`"):
        solve(read("mass: m_0 - q*t, leaves: {velocity: 0}", f"find: {find}"))


def test_lagranges_equations_get_the_terms_of_the_mass() -> None:
    """Pesce 2003: Q + (dm/dt) u for m(t), and − ∂m/∂q v²/2 in addition for m(q)."""
    v, w = (sp.Symbol(n, real=True) for n in ("x'", "y'"))
    k, q, u = (sp.Symbol(n, positive=True) for n in ("k", "q", "u"))
    of_time = solved("mass: m_0 - q*t, leaves: {relative: u*i}", method=Method.LAGRANGE).own.motion.principle
    assert of_time.of_masses == (-q * v, -q * w)
    assert of_time.applied == (-q * u, 0)
    of_place = solved("mass: k*x, gains: {velocity: 0}", method=Method.LAGRANGE).own.motion.principle
    assert [sp.expand(e) for e in of_place.of_masses] == [k * v**2 / 2 - k * w**2 / 2, k * v * w]
    assert [sp.expand(e) for e in of_place.applied] == [-k * v**2, -k * v * w]


def test_mass_that_leaves_without_relative_velocity_changes_nothing_but_the_mass() -> None:
    bucket = "constraints: {rod: x^2 + y^2 = l^2}\ngravity: -g*j"
    leaking = solved("mass: m_0 - q*t, leaves: {relative: 0}", bucket)
    tight = solved("mass: m_0", bucket)
    assert leaking.own.motion.expressions == tight.own.motion.expressions


def test_nothing_is_conserved_that_is_not() -> None:
    """Across the thrust a rocket keeps the momentum of itself and its gas, and not its own."""
    rocket = solved("mass: m_0 - q*t, leaves: {relative: -u*i}")
    w, y, t = (sp.Symbol(n, real=True) for n in ("y'", "y", "t"))
    m_0, q = sp.symbols("m_0 q", positive=True)
    momenta = [sp.expand(i.expression) for i in rocket.own.conserved.integrals]
    assert momenta == [sp.expand((m_0 - q * t) * w + q * y)]
    assert rocket.own.conserved.energy is not None
    drop = solved("mass: k*x, gains: {velocity: 0}", "gravity: g*i")
    assert drop.own.conserved.energy is not None
    smooth = solved("mass: k*x, gains: {relative: 0}")
    assert smooth.own.conserved.energy is not None  # mass that comes with the velocity brings energy in


def test_prescribed_masses_choices_and_quasi_velocities() -> None:
    more = (
        "functions: {m: [t]}\ngravity: -g*j\nspeeds: {w: x' + y', s: x' - y'}\n"
        "generalized_coordinates: {polar: {coordinates: [r, phi], substitute: {x: r*cos(phi), y: r*sin(phi)}}}"
    )
    solution = solved("mass: m, leaves: {relative: -u*i + k*j}", more)
    assert {c.choice for c in solution.checks} >= {"", "polar"}
    by_place = "generalized_coordinates: {polar: {coordinates: [r, phi], substitute: {x: r*cos(phi), y: r*sin(phi)}}}"
    for way in ("velocity: u*i", "relative: u*j"):
        solved(f"mass: m_0 + k*x^2, gains: {{{way}}}", by_place)


def test_the_range_in_which_the_mass_is_positive() -> None:
    t, x = sp.Symbol("t", real=True), sp.Symbol("x", real=True)
    m_0, q, k = sp.symbols("m_0 q k", positive=True)

    def found(particle: str) -> list[tuple[object, ...]]:
        configuration = solved(particle).own.configuration
        return [(v.symbol, v.bound, v.above) for v in validities(configuration.variable_masses, configuration.slots)]

    assert found("mass: m_0 - q*t, leaves: {velocity: 0}") == [(t, m_0 / q, False)]
    assert found("mass: m_0 + k*x, gains: {velocity: 0}") == [(x, -m_0 / k, True)]
    assert found("mass: m_0*exp(-q*t), leaves: {velocity: 0}") == []
    assert found("mass: k*x^3, gains: {velocity: 0}") == [(None, 0, False)]


def test_the_page_and_json_show_the_reactive_force() -> None:
    rocket = reported("rocket")
    shown = as_object(rocket)["variable_masses"]["rocket"]
    assert shown == {"mass": "m_0 - q*t", "rate": "-q", "leaves": True, "velocity": "-u*j", "relative": True,
                     "reactive_force": "q*u*j", "valid": "t < m_0/q"}  # fmt: skip
    page = str(as_object(rocket)["steps"])
    assert "Phi_rocket = q*u*j" in page
    assert "The equations hold as long as the mass is positive, t < m_0/q." in page
    assert "Time appears explicitly in a mass" in page
    heap = str(as_object(reported("load-that-lifts-a-chain"))["steps"])
    assert "as long as mass joins, -rho*y' > 0, and the mass is positive, y < h" in heap
    assert all(a.verdict is Verdict.EQUIVALENT for a in rocket.answers)


def test_a_simulation_ends_where_mass_no_longer_joins() -> None:
    lifted = lagrange.solve(lagrange.load("load-that-lifts-a-chain"))
    motion = lifted.simulate(5, values={"M": 2, "rho": 1, "h": 6, "g": 9.81})
    end = motion.events[-1]
    assert (end.kind, end.name) == ("exchange", "chain")
    assert motion["x"][-1] == pytest.approx(12**0.5)


def test_a_law_of_velocities_is_that_of_a_mass_that_is_a_coordinate() -> None:
    """A drop that sweeps up mist, dm/dt = k m x', falls with x'' = g − k x'², as it does with m = m_0 e^(kx)."""
    particle = "particles: {{drop: {{mass: {}, position: -x*j, gains: {{velocity: 0}}}}}}"
    head = "title: t\nparameters: [k, g, m_0]\ngravity: -g*j\n"
    law = "coordinates: [x, m]\nconstraints: {growth: \"m' = k*m*x'\"}\n" + particle.format("m")
    integrated = "coordinates: [x]\n" + particle.format("m_0*exp(k*x)")
    answers = "\nanswers: {equations: [\"x'' = g - k*x'^2\"]}\n"
    for text in (law, integrated):
        solution = solve(read_problem(Source("case.yaml", head + text + answers)))
        assert solution.holds
        assert [a.verdict for a in compared_answers(solution)] == [Verdict.EQUIVALENT]
