"""The stages on small problems: what each refuses, and what it states beside its result."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import NotCoveredError, ProblemError
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]

PENDULUM = """
title: Pendulum
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
gravity: g*j
"""


def refusal(problem: Problem) -> tuple[str, str, int]:
    """Code, message and exit status of the one thing that is wrong."""
    with pytest.raises(ProblemError) as caught:
        solve(problem)
    [found] = caught.value.diagnostics
    assert found.span is None or found.span.end > found.span.start
    return found.code, str(found), caught.value.exit_status


@pytest.mark.parametrize(
    ("choice", "code", "says"),
    [
        ("coordinates: [theta], substitute: {x: l*sin(theta), y: l*sin(theta)}", "choice-against-constraint", "`rod`"),
        (
            "coordinates: [theta], substitute: {x: 2*l*sin(theta), y: l*cos(theta)}",
            "choice-against-constraint",
            "`rod`",
        ),
        ("coordinates: [a, b], substitute: {x: l*sin(a + b), y: l*cos(a + b)}", "dependent-coordinates", "leave 1 out"),
        ("coordinates: [theta], substitute: {x: l, y: 0*theta}", "dependent-coordinates", "`theta`"),
    ],
)
def test_choices_that_are_refused(problem: Read, choice: str, code: str, says: str) -> None:
    text = f"{PENDULUM}generalized_coordinates: {{angle: {{{choice}}}}}\n"
    found, message, status = refusal(problem(text))
    assert (found, status) == (code, 2)
    assert says in message
    assert "problem.yaml:8" in message


def test_a_choice_with_too_few_coordinates(problem: Read) -> None:
    text = """
title: Free particle
parameters: [m, l]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
generalized_coordinates: {line: {coordinates: [s], substitute: {x: s, y: 2*s}}}
"""
    assert refusal(problem(text))[0] == "too-few-coordinates"


@pytest.mark.parametrize(
    ("constraints", "named"),
    [
        ("{a: x = 0, b: x = 1}", ("`a`", "`b`")),
        ("{a: x = 0, b: y = 2, c: x + y = 1}", ("`a`", "`b`", "`c`")),
        ('{a: "x\' = 0", b: "x\' = t"}', ("`a`", "`b`")),
        ("{a: \"x' + y' = 1\", b: \"2*x' + 2*y' = 3\"}", ("`a`", "`b`")),
    ],
)
def test_contradictory_constraints_are_named(problem: Read, constraints: str, named: tuple[str, ...]) -> None:
    text = f"title: T\ncoordinates: [x, y]\nconstraints: {constraints}\nfind: constraints\n"
    code, message, status = refusal(problem(text))
    assert (code, status) == ("contradictory-constraints", 2)
    assert all(n in message for n in named)


@pytest.mark.parametrize("equation", ["x^3 = c", "x^4 = 2", "x^5 + x = c", "tan(x) = c", "exp(x) = 2"])
def test_satisfiable_constraints_are_no_contradiction(problem: Read, equation: str) -> None:
    text = f"title: T\nparameters: [c]\ncoordinates: [x, y]\nconstraints: {{k: '{equation}'}}\n"
    assert solve(problem(text)).classification.degrees_of_freedom == 1


def test_a_constraint_whose_differential_vanishes_is_refused(problem: Read) -> None:
    text = "title: T\ncoordinates: [x, y]\nconstraints: {k: sin(x) = 1}\n"
    assert refusal(problem(text))[0] == "singular-constraint"


def test_a_redundant_constraint_is_named_and_not_counted(problem: Read) -> None:
    text = "title: T\ncoordinates: [x, y, z]\nconstraints: {a: x = y, b: y = z, c: x = z}\n"
    found = solve(problem(text)).classification
    assert found.redundant == ("c",)
    assert (found.rank, found.degrees_of_freedom, found.configuration_dimension) == (2, 1, 1)


def test_a_coordinate_without_inertia_is_named(problem: Read) -> None:
    text = """
title: T
parameters: [m, k]
coordinates: [x, s]
particles: {P: {mass: m, position: x*i}, Q: {mass: 0, position: s*j}}
forces: {field: {potential: k*(x - s)^2/2}}
"""
    code, message, status = refusal(problem(text))
    assert (code, status) == ("no-inertia", 2)
    assert "`s`" in message
    assert "`x`" not in message


def test_massless_points_are_welcome_where_something_else_has_the_mass(problem: Read) -> None:
    text = """
title: T
parameters: [m, l, g]
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i + l*cos(theta)*j}, Q: {position: l*sin(theta)*i}}
gravity: g*j
"""
    solution = solve(problem(text))
    assert solution.holds
    assert solution.motion is not None


@pytest.mark.parametrize(
    ("more", "what"),
    [
        ("find: linearization\nunknowns: [N]", "small oscillations with unknown forces"),
    ],
)
def test_what_is_not_covered_is_refused_and_never_guessed(problem: Read, more: str, what: str) -> None:
    with pytest.raises(NotCoveredError) as caught:
        solve(problem(f"{PENDULUM}{more}\n"))
    assert caught.value.exit_status == 3
    assert what in str(caught.value)


def test_pivots_are_stated(problem: Read) -> None:
    solution = solve(problem(PENDULUM))
    x, y = sp.symbols("x y", real=True)
    assert solution.elimination.pivots == (x,)
    assert solution.elimination.solution == ((-y / x,),)


def test_what_an_equation_is_divided_by_is_stated(problem: Read) -> None:
    text = """
title: Planar motion
parameters: [m]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
"""
    motion = solve(problem(text)).motion
    assert motion is not None
    r = sp.Symbol("r", real=True)
    first, second = motion.equations
    assert (first.factor.expression, first.factor.nonzero) == (sp.Symbol("m", positive=True), ())
    assert second.factor.nonzero == (r,)


def test_free_motion_keeps_its_acceleration(problem: Read) -> None:
    """m z'' = 0 is divided by m and not by z''."""
    solution = solve(problem("title: T\nparameters: [m]\ncoordinates: [z]\nparticles: {P: {mass: m, position: z*k}}\n"))
    assert solution.motion is not None
    assert solution.motion.expressions == (sp.Symbol("z''", real=True),)


def test_rolling_without_slip_is_used_through_velocities(problem: Read) -> None:
    """A choice of y alone, where φ' = y'/R is a constraint on velocities only."""
    text = """
title: T
parameters: [m, M, R, g]
coordinates: [y, phi]
particles: {P: {mass: m, position: y*j}, Q: {mass: M, position: R*cos(phi)*i + R*sin(phi)*k}}
constraints: {string: "R*phi' = y'"}
gravity: g*j
generalized_coordinates: {depth: {coordinates: [y]}}
answers:
  degrees_of_freedom: 1
  classification: [holonomic, scleronomic]
  integrable: {string: true}
  equations: ["(m + M)*y'' = m*g"]
"""
    from lagrange.explain.report import report

    result = report(problem(text))
    assert result.holds
    [choice] = result.solution.choices
    assert [q.name for q in choice.coordinates.through_rates] == ["phi"]


def test_a_spot_value_satisfies_the_equations(problem: Read) -> None:
    text = f"{PENDULUM}generalized_coordinates: {{angle: {{coordinates: [th], substitute: {{x: l*sin(th), y: l*cos(th)}}}}}}\n"
    [choice] = solve(problem(text)).choices
    assert choice.spot is not None
    values = {s.name: v for s, v in choice.spot.values.items()}
    [acceleration] = choice.spot.accelerations.values()
    assert abs(acceleration + values["g"] / values["l"] * sp.sin(values["th"])) < 1e-5


def test_spot_values_are_sensible(problem: Read) -> None:
    """An angle of an incline is less than a right one, and of a + b cos ωt the first is the larger."""
    text = """
title: A block on an incline
parameters: [m, g, a, b, alpha, omega]
coordinates: [x]
particles: {P: {mass: m, position: "[x*cos(alpha), x*sin(alpha) + b*cos(omega*t) + a*x^2]"}}
gravity: -g*j
"""
    spot = solve(problem(text)).spot
    assert spot is not None
    values = {s.name: v for s, v in spot.values.items()}
    assert 0 < values["alpha"] < 1.5
    assert values["a"] > values["b"] > 0
    assert values["omega"].is_Integer


@pytest.mark.parametrize(("long", "short"), [("l", "c"), ("c", "l")])
def test_either_of_two_letters_may_have_to_be_the_larger(problem: Read, long: str, short: str) -> None:
    text = f"""
title: Offset crank
parameters: [m, l, c, g]
coordinates: [s, y]
particles: {{P: {{mass: m, position: s*i + y*j}}}}
gravity: -g*j
constraints: {{rod: (s - sqrt({long}^2 - {short}^2))^2 + y^2 = {long}^2}}
"""
    spot = solve(problem(text)).spot
    assert spot is not None
    values = {s.name: v for s, v in spot.values.items()}
    assert values[long] > values[short] > 0


def test_springs_in_motion(problem: Read) -> None:
    """m x'' = −c (√(x² + h²) − b) x/√(x² + h²), the component of the pull."""
    text = """
title: Bead on a wire, with a spring
parameters: [m, c, b, h]
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {s: {spring: c, between: [P, "[0, h]"], length: b}}
"""
    solution = solve(problem(text))
    assert solution.holds
    assert solution.motion is not None
    m, c, b, h = (sp.Symbol(n, positive=True) for n in "mcbh")
    x, acceleration = sp.Symbol("x", real=True), sp.Symbol("x''", real=True)
    distance = sp.sqrt(x**2 + h**2)
    [equation] = solution.motion.expressions
    expected = -c * (distance - b) * x / distance / m
    numbers = {m: 2, c: 3, b: sp.Rational(1, 2), h: sp.Rational(3, 4), x: 1}
    [found] = sp.solve(equation.xreplace(numbers), acceleration)
    assert found == expected.xreplace(numbers)
