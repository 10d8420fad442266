"""Lagrange's equations as the method: against d'Alembert's principle, SymPy's LagrangesMethod, and as a text.

What stands in the steps is read back and must be an identity in T and V; a constraint on velocities put into T before
differentiating gives something else, and the program does not do it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest
import sympy as sp
from conftest import PROBLEMS
from second_route import Route, constants, lagrange, moving, slots
from second_route import t as time
from sweep import equations_in, unreadable
from test_explain import reading, words

from lagrange.algebra.exact.exact import is_zero
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import prime
from lagrange.document.derivation import Display, Rule
from lagrange.document.math_writer import text
from lagrange.explain.report import Report, report
from lagrange.expressions.reader import read_equation, read_scalar
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import System, compare
from lagrange.mechanics.dynamics.equations import equations_of_motion
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.dynamics.multipliers import LagrangeMotion
from lagrange.mechanics.dynamics.principle import dalembert
from lagrange.mechanics.energy_symbols import letters
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load
from lagrange.problem.model import Find, Problem
from lagrange.render.json import as_object

Read = Callable[[str], Problem]

FOLDER = Path(__file__).parent / "systems"
SHIPPED = {p.stem: p for p in sorted(PROBLEMS.glob("*/*.yaml")) if Find.MOTION in load(p).find}
HARDER = """
    atwood charged_particle damped_oscillator driven_wire dumbbell_with_blade_at_end free_top free_top_quasi
    heavy_sleigh heavy_slider_crank moved_support pars pushed_plate rod_twice rolling_cylinder_by_velocities
    rotating_hoop stretched_dumbbell triple_pendulum turning_rail two_wheels undefined_forces
""".split()  # noqa: SIM905
PATHS = SHIPPED | {n: FOLDER / f"{n}.yaml" for n in HARDER}


@cache
def by_lagrange(name: str) -> Report:
    return report(load(PATHS[name]), method=Method.LAGRANGE)


def motions(found: Report) -> list[LagrangeMotion]:
    """Those that are written down, in the file's coordinates and in the choices."""
    solution = found.solution
    several = [solution.dynamics, *(c.dynamics for c in solution.choices)]
    written = [m.written for m in several if m is not None]
    assert written
    assert all(isinstance(m, LagrangeMotion) for m in written)
    return [m for m in written if isinstance(m, LagrangeMotion)]


# -- truth -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", PATHS)
def test_the_two_methods_describe_the_same_motion(name: str) -> None:
    found = by_lagrange(name)
    assert found.shortcomings == ()
    for motion in motions(found):
        other = equations_of_motion(dalembert(motion.configuration), motion.elimination)
        forward = compare(motion.expressions, System(motion.configuration, other.expressions))
        back = compare(other.expressions, System(motion.configuration, motion.expressions))
        assert forward is not None
        assert back is not None
        assert forward.agree
        assert back.agree


def test_each_method_is_checked_by_the_other() -> None:
    names = {c.name for c in by_lagrange("ex11-ideal-pendulum").solution.checks}
    assert "d'Alembert's principle gives the same motion" in names
    assert not any(n.startswith("Lagrange's equations give") for n in names)
    assert "Lagrange's equations give the same motion" in {
        c.name for c in report(load(PATHS["ex11-ideal-pendulum"])).solution.checks
    }


def test_a_mistake_in_one_method_is_found_by_the_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the weight in V nothing but d'Alembert's principle knows of it."""
    import lagrange.mechanics.dynamics.energies

    monkeypatch.setattr(lagrange.energies, "potential_energy", lambda configuration: configuration.potential)
    checks = solve(load(PATHS["ex11-ideal-pendulum"]), method=Method.LAGRANGE).checks
    failed = {c.name for c in checks if c.passed is False}
    assert "d'Alembert's principle gives the same motion" in failed
    assert "the reactions satisfy the equations of d'Alembert's principle with multipliers" in failed


def pendulum() -> Route:
    x, y = moving("x y")
    m, l, g = constants("m l g")
    return lagrange("x y", m * (d(x) ** 2 + d(y) ** 2) / 2, -m * g * y, geometric={"rod": x**2 + y**2 - l**2})


def double_pendulum() -> Route:
    phi1, phi2 = moving("phi1 phi2")
    m1, m2, l1, l2, g = constants("m1 m2 l1 l2 g")
    kinetic = m1 * l1**2 * d(phi1) ** 2 / 2 + m2 / 2 * (
        l1**2 * d(phi1) ** 2 + l2**2 * d(phi2) ** 2 + 2 * l1 * l2 * d(phi1) * d(phi2) * sp.cos(phi1 - phi2)
    )
    return lagrange("phi1 phi2", kinetic, -(m1 + m2) * g * l1 * sp.cos(phi1) - m2 * g * l2 * sp.cos(phi2))


def heavy_top() -> Route:
    phi, theta, psi = moving("phi theta psi")
    m, l, g, a, c = constants("m l g A C")
    kinetic = (a + m * l**2) * (d(theta) ** 2 + d(phi) ** 2 * sp.sin(theta) ** 2) / 2
    kinetic += c * (d(psi) + d(phi) * sp.cos(theta)) ** 2 / 2
    return lagrange("phi theta psi", kinetic, m * g * l * sp.cos(theta))


def sleigh() -> Route:
    x, y, theta = moving("x y theta")
    m, a, inertia = constants("m a I_G")
    return lagrange(
        "x y theta", sleigh_kinetic(x, y, theta, m, a, inertia),
        kinematic={"blade": d(y) * sp.cos(theta) - d(x) * sp.sin(theta)},
    )  # fmt: skip


def sleigh_kinetic(*of: sp.Expr) -> sp.Expr:
    x, y, theta, m, a, inertia = of
    velocity = d(x) - a * d(theta) * sp.sin(theta), d(y) + a * d(theta) * sp.cos(theta)
    return m * (velocity[0] ** 2 + velocity[1] ** 2) / 2 + inertia * d(theta) ** 2 / 2


def rolling_disc() -> Route:
    x, y, phi, theta, psi = moving("x y phi theta psi")
    m, radius, a, c, g = constants("m R A C g")
    spin = d(psi) + d(phi) * sp.cos(theta)
    kinetic = m * (d(x) ** 2 + d(y) ** 2 + (radius * sp.cos(theta) * d(theta)) ** 2) / 2
    kinetic += a * (d(theta) ** 2 + d(phi) ** 2 * sp.sin(theta) ** 2) / 2 + c * spin**2 / 2
    rolling = {
        "1": d(x) + radius * (sp.cos(phi) * spin - sp.sin(phi) * sp.sin(theta) * d(theta)),
        "2": d(y) + radius * (sp.sin(phi) * spin + sp.cos(phi) * sp.sin(theta) * d(theta)),
    }
    return lagrange("x y phi theta psi", kinetic, m * g * radius * sp.sin(theta), kinematic=rolling)


def d(e: sp.Expr) -> sp.Expr:
    return sp.diff(e, time)


BY_SYMPY = {
    ("ex11-ideal-pendulum", ""): pendulum,
    ("ex18-double-pendulum", "angles"): double_pendulum,
    ("heavy-top", ""): heavy_top,
    ("sleigh", ""): sleigh,
    ("rolling-disc", ""): rolling_disc,
}


def system_of(route: Route, configuration: Configuration) -> System:
    """A route's equations with its multipliers, in the symbols of a configuration."""
    names = {s for e in route.system for s in e.free_symbols}
    known = symbols_in(configuration)
    rule = {s: known.get(s.name, sp.Symbol(s.name, real=True)) for s in names}
    equations = tuple(slots(sp.sympify(e)).xreplace(rule) for e in route.equations)
    hidden = tuple(sorted((rule[s] for s in names if s.name.startswith("lam")), key=str))
    return System(configuration, equations, hidden)


def symbols_in(configuration: Configuration) -> dict[str, sp.Symbol]:
    """Parameters carry assumptions: they are taken from where they occur."""
    expressions = [p.mass for p in configuration.points] + [m for r in configuration.rotations for m in r.inertia]
    expressions += [c for p in configuration.points for c in p.position.components]
    expressions += [c for f in configuration.loads for c in f.vector.components]
    expressions += [a for r in configuration.rows for a in (*r.coefficients, r.finite or sp.S.Zero)]
    return {s.name: s for e in expressions for s in sp.sympify(e).free_symbols}


@pytest.mark.parametrize(("name", "choice"), BY_SYMPY)
def test_against_sympys_lagranges_method(name: str, choice: str) -> None:
    [motion] = (m for m in motions(by_lagrange(name)) if m.configuration.name == choice)
    system = system_of(BY_SYMPY[name, choice](), motion.configuration)
    found = compare(motion.expressions, system)
    assert found is not None
    assert found.agree
    wrong = compare([motion.expressions[0] + 1, *motion.expressions[1:]], system)
    assert wrong is not None
    assert not wrong.agree


# -- a constraint on velocities is not put into T --------------------------------------------------------------------


def euler_lagrange(function: sp.Expr, coordinates: list[sp.Symbol], motion: LagrangeMotion) -> list[sp.Expr]:
    """d/dt ∂L/∂q' − ∂L/∂q, without multipliers."""
    own = motion.configuration.slots
    return [own.time_derivative(function.diff(prime(q))) - function.diff(q) for q in coordinates]


@pytest.mark.parametrize(
    ("name", "excluded"),
    [("sleigh", ["y"]), ("rolling-disc", ["x", "y"]), ("heavy_sleigh", ["y"])],
)
def test_with_the_constraint_put_in_first_the_equations_are_others(name: str, excluded: list[str]) -> None:
    """The copied mistake: x' = −R (...) put into T, then Lagrange's equations of what is left, without multipliers."""
    [motion] = motions(by_lagrange(name))
    found, configuration = motion.principle, motion.configuration
    slots_ = configuration.slots
    gone = [q for q in slots_.coordinates if q.name in excluded]
    forms = [r.velocity_form(slots_) for r in configuration.rows]
    rates = sp.solve(forms, [prime(q) for q in gone], dict=True)[0]
    function = (found.kinetic - found.potential).xreplace(rates)
    assert not function.free_symbols & {prime(q) for q in gone}
    rest = [q for q in slots_.coordinates if q not in gone]
    mistaken = compare(euler_lagrange(function, rest, motion), System(configuration, motion.expressions))
    assert mistaken is not None
    assert not mistaken.agree
    assert all(found.momenta[slots_.coordinates.index(q)].has(prime(q)) for q in gone)  # the program does not
    agreed = compare(motion.expressions, System(configuration, motion.expressions))
    assert agreed is not None
    assert agreed.agree


def test_an_integrable_constraint_could_be_put_in() -> None:
    """x' = R φ' comes to a finite relation: there it is no mistake, and the text does not call it one."""
    found = by_lagrange("rolling_cylinder_by_velocities")
    motion = motions(found)[0]
    configuration, principle = motion.configuration, motion.principle
    slots_ = configuration.slots
    assert all(r.finite is None for r in configuration.rows)
    gone = [slots_.coordinates[k] for k in motion.elimination.dependent]
    forms = [r.velocity_form(slots_) for r in configuration.rows]
    rates = sp.solve(forms, [prime(q) for q in gone], dict=True)[0]
    rest = [q for q in slots_.coordinates if q not in gone]
    lagrangian = principle.kinetic - principle.potential
    shares = {q: sp.Add(*(lagrangian.diff(g) * rates[prime(g)].diff(prime(q)) for g in gone)) for q in rest}
    put_in = euler_lagrange(principle.kinetic.xreplace(rates), rest, motion)
    forces = [lagrangian.diff(q) - principle.kinetic.diff(q) + shares[q] for q in rest]
    same = compare([e - f for e, f in zip(put_in, forces, strict=True)], System(configuration, motion.expressions))
    assert same is not None
    assert same.agree
    said = words(next(s for s in found.derivation.steps if s.rule is Rule.LAGRANGE))
    assert "comes to a finite relation" in said or "come to finite relations" in said
    assert "would be lost" not in said


@pytest.mark.parametrize("name", PATHS)
def test_the_reason_stands_wherever_a_constraint_binds_velocities(name: str) -> None:
    found = by_lagrange(name)
    [first, *others] = [s for s in found.derivation.steps if s.rule is Rule.LAGRANGE]
    here, *elsewhere = ([m.configuration.rows[n] for n in m.used] for m in motions(found))
    assert ("put into" in words(first)) == any(r.finite is None for r in here)
    for step, rows in zip(others, elsewhere, strict=True):
        kinematic = any(r.finite is None for r in rows)
        assert ("is differentiated before" in words(step)) == kinematic


# -- the text --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", PATHS)
def test_references_point_back_and_steps_come_in_order(name: str) -> None:
    derivation = by_lagrange(name).derivation
    labels: set[str] = set()
    for kind, label in reading(derivation):
        if kind == "label":
            assert label not in labels, f"{label} stands twice"
            labels.add(label)
        else:
            assert label in labels, f"{label} is referred to before it stands"
    rules = [s.rule for s in derivation.steps if not s.title.startswith(("In matrix form", "Solved for"))]
    assert Rule.PRINCIPLE not in rules
    assert Rule.WORKLESS not in rules
    several = len(motions(by_lagrange(name)))
    three = (Rule.ENERGIES, Rule.LAGRANGE, Rule.EQUATIONS_OF_MOTION)
    assert [r for r in rules if r in three] == list(three) * several
    assert all(s.title and s.body for s in derivation.steps)
    assert not any("d'Alembert" in words(s) for s in derivation.steps if s.rule is not Rule.QUASI_VELOCITIES)


@pytest.mark.parametrize("name", PATHS)
def test_what_stands_in_the_steps_is_true(name: str) -> None:
    """T, V, v², p_k, d/dt p_k, ∂L/∂q_k and Q_k, read back with the letters of their coordinates."""
    found = by_lagrange(name)
    reference = reference_of_solution(found.solution)
    named = letters(found.solution)
    several = motions(found)
    steps = [s for s in found.derivation.steps if s.rule in (Rule.ENERGIES, Rule.LAGRANGE)]
    counted = 0
    for motion, pair in zip(several, zip(steps[::2], steps[1::2], strict=True), strict=True):
        suffix = f"-{motion.configuration.name}" if motion.configuration.name else ""
        meanings = {s.name: e for s, e in named.meanings(motion.principle).items()}
        bodies = {n for r in motion.configuration.rotations for n in (f"omega_{r.name}", f"H_{r.name}")}
        scope = replace(
            reference.scope,
            scalars={**reference.scope.scalars, **meanings},
            slots=motion.configuration.slots,
        )
        kinds = tuple(f"{k}{suffix}" for k in ("kinetic", "potential", "square", "p", "rate", "slope", "generalized"))
        for step in pair:
            for block in step.body:
                for e in block.equations if isinstance(block, Display) else ():
                    if e.label is None or not e.label.startswith(kinds):
                        continue
                    sides = [text(s, found.notation) for s in e.sides]
                    if motion.configuration.name:
                        sides = [s for s in sides if not any(b in s for b in bodies)]  # those of the file's coordinates
                    for left, right in pairwise(sides):
                        equation = read_equation(Fragment.of(f"{left} = {right}"), scope)
                        assert is_zero(equation.lhs - equation.rhs) is True, f"{left} = {right}"
                        counted += 1
    assert counted >= 3 * len(several)


@pytest.mark.parametrize("name", PATHS)
def test_json_is_read_back(name: str) -> None:
    found = by_lagrange(name)
    result = as_object(found)
    reference = reference_of_solution(found.solution)
    assert result["method"] == "lagrange"
    assert [f for e in equations_in(result) for f in unreadable(e, reference)] == []
    for part, motion in zip([result, *result["choices"]], motions(found), strict=True):
        told, principle = part["lagrange"], motion.principle
        slots_ = motion.configuration.slots
        scope = replace(reference.scope, slots=slots_)

        def value(expression: str, scope: object = scope) -> sp.Expr:
            read: sp.Expr = read_scalar(Fragment.of(expression), scope)  # type: ignore[arg-type]
            return read

        kinetic, potential = value(told["kinetic_energy"]), value(told["potential_energy"])
        for k, (q, v) in enumerate(zip(slots_.coordinates, slots_.velocities, strict=True)):
            momentum, force = value(told["momenta"][q.name]), value(told["generalized_forces"][q.name])
            assert is_zero(momentum - kinetic.diff(v)) is True
            quasi = value(told["quasi_coordinate_terms"][q.name]) if "quasi_coordinate_terms" in told else sp.S.Zero
            left = slots_.time_derivative(momentum) - kinetic.diff(q) + potential.diff(q) - force - quasi
            assert is_zero(left - principle.coefficients[k].to_sympy()) is True


def test_json_of_the_other_method_has_nothing_of_this() -> None:
    result = as_object(report(load(PATHS["ex11-ideal-pendulum"])))
    assert "method" not in result
    assert "lagrange" not in result
    assert all("lagrange" not in c for c in result["choices"])


BY_HAND: Mapping[tuple[str, int], tuple[str, str]] = {
    ("ex11-ideal-pendulum", 0): ("m*(x'^2 + y'^2)/2", "-m*g*y"),
    ("ex11-ideal-pendulum", 1): ("m*l^2*theta'^2/2", "-m*g*l*cos(theta)"),
    ("ex18-double-pendulum", 1): (
        "(m1 + m2)*l1^2*phi1'^2/2 + m2*l1*l2*phi1'*phi2'*cos(phi1 - phi2) + m2*l2^2*phi2'^2/2",
        "-(m1 + m2)*g*l1*cos(phi1) - m2*g*l2*cos(phi2)",
    ),
    ("heavy-top", 0): (
        "(m*l^2 + A)*(phi'^2*sin(theta)^2 + theta'^2)/2 + C*(phi'*cos(theta) + psi')^2/2",
        "m*g*l*cos(theta)",
    ),
    ("spring-pendulum", 0): ("m*(r'^2 + r^2*phi'^2)/2", "c*(r - l)^2/2 - m*g*r*cos(phi)"),
    ("sliding-ladder", 0): ("m*(x'^2 + y'^2)/2 + m*l^2*theta'^2/6", "m*g*y"),
}


@pytest.mark.parametrize(("name", "which"), BY_HAND)
def test_energies_look_as_by_hand(name: str, which: int) -> None:
    found = by_lagrange(name)
    principle = motions(found)[which].principle
    written = tuple(text(e, found.notation) for e in (principle.kinetic, principle.potential))
    assert written == BY_HAND[name, which]


# -- what is not plain -----------------------------------------------------------------------------------------------

TAKEN = """
title: Pendulum with a spring, whose names are taken
parameters: [m, L, T, V, p_x, v_P, g, Q_y]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = L^2}
gravity: g*j
forces:
  spring: {spring: T, between: [P, V*i]}
  wind: {on: P, vector: p_x*i + v_P*Q_y*j}
"""


def test_letters_that_a_problem_has_used(problem: Read) -> None:
    found = report(problem(TAKEN), method=Method.LAGRANGE)
    named = letters(found.solution)
    assert (named.kinetic.name, named.potential.name, named.lagrangian.name) == ("K", "U", "Lambda")
    x, y = found.solution.problem.slots.coordinates
    assert (named.momentum(x).name, named.force(y).name, named.speed("P").name) == ("P_x", "K_y", "u_P")
    reference = reference_of_solution(found.solution)
    assert [f for e in equations_in(as_object(found)) for f in unreadable(e, reference)] == []
    assert found.holds


def test_constant_forces_are_no_part_of_the_potential_energy(problem: Read) -> None:
    found = report(problem(TAKEN), method=Method.LAGRANGE)
    [motion] = motions(found)
    assert [text(q) for q in motion.principle.applied] == ["p_x", "Q_y*v_P"]
    assert {s.name for s in motion.principle.potential.free_symbols} == {"T", "V", "g", "m", "x", "y"}


def test_quasi_coordinates_have_their_term_told() -> None:
    found = by_lagrange("free_top_quasi")
    [motion] = motions(found)
    assert motion.principle.has_quasi_coordinates
    step = next(s for s in found.derivation.steps if s.rule is Rule.LAGRANGE)
    assert "Hamel" in words(step)
    labels = [e.label for b in step.body if isinstance(b, Display) for e in b.equations]
    assert {"quasi-p", "quasi-q", "quasi-r"} <= set(labels)
    without = [r - p - q for r, p, q in zip(motion.principle.rates, motion.principle.partials, motion.principle.applied, strict=True)]  # fmt: skip
    assert any(
        is_zero(e - c.to_sympy()) is False for e, c in zip(without, motion.principle.coefficients, strict=True)
    )  # left out, the equations would be others


def test_nothing_is_said_of_quasi_coordinates_where_angles_are_given() -> None:
    assert "quasi" not in words(next(s for s in by_lagrange("heavy-top").derivation.steps if s.rule is Rule.LAGRANGE))


def test_statics_is_the_same_page_with_a_remark() -> None:
    path = PROBLEMS / "statics" / "ladder.yaml"
    plain, asked = report(load(path)), report(load(path), method=Method.LAGRANGE)
    assert asked.derivation == plain.derivation
    assert [n.code for n in asked.notes] == ["method-without-motion"]
    assert plain.notes == ()
    assert asked.holds
    assert "method" not in as_object(asked)
