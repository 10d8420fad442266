"""Lagrange's equations as the method: against d'Alembert's principle, SymPy's LagrangesMethod, and as a text.

The text of the steps is read back and must be an identity in T and V; a constraint on velocities put into T before
differentiating gives something else, and the program does not do it.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import prime
from lagrange.document.derivation import Display, Rule
from lagrange.document.math_writer import text
from lagrange.expressions.reader import read_equation, read_scalar
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import System, compare
from lagrange.mechanics.dynamics.equations import equations_of_motion
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.dynamics.principle import dalembert
from lagrange.mechanics.energy_symbols import energy_symbols
from lagrange.mechanics.solution import solve
from lagrange.render.json import as_object
from tests.support.derivation_text import reading, words
from tests.support.lagrange_motions import by_lagrange, euler_lagrange, motions
from tests.support.printed_equations import equations_in, unreadable
from tests.support.second_route import Route, constants, lagrange, moving, slots
from tests.support.second_route import t as time
from tests.support.shared import asking, loaded, reported

HARDER = """
    atwood charged_particle damped_oscillator driven_wire dumbbell_with_blade_at_end free_top free_top_quasi
    heavy_sleigh heavy_slider_crank moved_support pars pushed_plate rod_twice rolling_cylinder_by_velocities
    rotating_hoop stretched_dumbbell triple_pendulum turning_rail two_wheels undefined_forces
""".split()  # noqa: SIM905
NAMES = [*asking("motion"), *HARDER]


# -- truth -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
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
        c.name for c in reported("ex11-ideal-pendulum").solution.checks
    }


def test_a_mistake_in_one_method_is_found_by_the_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the weight in V nothing but d'Alembert's principle knows of it."""
    import lagrange.mechanics.dynamics.energies

    monkeypatch.setattr(
        lagrange.mechanics.dynamics.energies, "potential_energy", lambda configuration: configuration.potential
    )
    checks = solve(loaded("ex11-ideal-pendulum"), method=Method.LAGRANGE).checks
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
    expressions = [p.mass for p in configuration.points] + [
        m for r in configuration.rotations for m in r.inertia.moments
    ]
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


@pytest.mark.parametrize("name", NAMES)
def test_the_reason_stands_wherever_a_constraint_binds_velocities(name: str) -> None:
    found = by_lagrange(name)
    [first, *others] = [s for s in found.derivation.steps if s.rule is Rule.LAGRANGE]
    here, *elsewhere = ([m.configuration.rows[n] for n in m.used] for m in motions(found))
    assert ("not substituted into" in words(first)) == any(r.finite is None for r in here)
    for step, rows in zip(others, elsewhere, strict=True):
        kinematic = any(r.finite is None for r in rows)
        assert ("is differentiated before" in words(step)) == kinematic


# -- the text --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_references_point_back_and_steps_come_in_order(name: str) -> None:
    derivation = by_lagrange(name).derivation
    labels: set[str] = set()
    for kind, label in reading(derivation):
        if kind == "label":
            assert label not in labels, f"{label} stands twice"
            labels.add(label)
        else:
            assert label in labels, f"{label} is referred to before it stands"
    rules = [s.rule for s in derivation.steps if not s.title.startswith(("Matrix form", "Solved for"))]
    assert Rule.PRINCIPLE not in rules
    assert Rule.WORKLESS not in rules
    several = len(motions(by_lagrange(name)))
    three = (Rule.ENERGIES, Rule.LAGRANGE, Rule.EQUATIONS_OF_MOTION)
    assert [r for r in rules if r in three] == list(three) * several
    assert all(s.title and s.body for s in derivation.steps)
    if by_lagrange(name).solution.problem.lagrangian is None:  # of which the page says that d'Alembert cannot check it
        assert not any("d'Alembert" in words(s) for s in derivation.steps if s.rule is not Rule.QUASI_VELOCITIES)


@pytest.mark.parametrize("name", NAMES)
def test_what_stands_in_the_steps_is_true(name: str) -> None:
    """T, V, v², p_k, d/dt p_k, ∂L/∂q_k and Q_k, read back with the letters of their coordinates."""
    found = by_lagrange(name)
    reference = reference_of_solution(found.solution)
    named = energy_symbols(found.solution)
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


@pytest.mark.parametrize("name", NAMES)
def test_json_is_read_back(name: str) -> None:
    found = by_lagrange(name)
    result = as_object(found)
    reference = reference_of_solution(found.solution)
    assert result["method"] == "lagrange"
    assert [f for e in equations_in(result) for f in unreadable(e, reference)] == []
    for part, motion in zip([result, *result["choices"]], motions(found), strict=True):
        printed, principle = part["lagrange"], motion.principle
        slots_ = motion.configuration.slots
        scope = replace(reference.scope, slots=slots_)

        def value(expression: str, scope: object = scope) -> sp.Expr:
            read: sp.Expr = read_scalar(Fragment.of(expression), scope)  # type: ignore[arg-type]
            return read

        kinetic, potential = value(printed["kinetic_energy"]), value(printed["potential_energy"])
        if "lagrangian" in printed:  # a potential depends on velocities
            kinetic = value(printed["lagrangian"]) + potential
        for k, (q, v) in enumerate(zip(slots_.coordinates, slots_.velocities, strict=True)):
            momentum, force = value(printed["momenta"][q.name]), value(printed["generalized_forces"][q.name])
            assert is_zero(momentum - kinetic.diff(v)) is True
            quasi = (
                value(printed["quasi_coordinate_terms"][q.name]) if "quasi_coordinate_terms" in printed else sp.S.Zero
            )
            of_masses = value(printed["variable_mass_terms"][q.name]) if "variable_mass_terms" in printed else sp.S.Zero
            left = slots_.time_derivative(momentum) - kinetic.diff(q) + potential.diff(q) - force - quasi - of_masses
            assert is_zero(left - principle.coefficients[k].to_sympy()) is True


def test_json_of_the_other_method_has_nothing_of_this() -> None:
    result = as_object(reported("ex11-ideal-pendulum"))
    assert "method" not in result
    assert "lagrange" not in result
    assert all("lagrange" not in c for c in result["choices"])
