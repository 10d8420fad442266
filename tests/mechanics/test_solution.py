"""The stages on small problems: what each refuses, and what it states beside its result."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import GaveUpError, NotCoveredError, ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load
from lagrange.problem.model import Problem
from lagrange.render import terminal
from lagrange.render.json import as_object
from lagsolve.exit_statuses import status_of_error
from tests.support.paths import PROBLEMS

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
    return found.code, str(found), status_of_error(caught.value)


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
    assert solution.own.motion is not None


@pytest.mark.parametrize(
    ("more", "what"),
    [
        ("find: linearization\nunknowns: [N]", "small oscillations with unknown forces"),
    ],
)
def test_what_is_not_covered_is_refused_and_never_guessed(problem: Read, more: str, what: str) -> None:
    with pytest.raises(NotCoveredError) as caught:
        solve(problem(f"{PENDULUM}{more}\n"))
    assert status_of_error(caught.value) == 3
    assert what in str(caught.value)


def test_pivots_are_stated(problem: Read) -> None:
    solution = solve(problem(PENDULUM))
    x, y = sp.symbols("x y", real=True)
    assert solution.own.elimination.pivots == (x,)
    assert solution.own.elimination.solution == ((-y / x,),)


def test_what_an_equation_is_divided_by_is_stated(problem: Read) -> None:
    text = """
title: Planar motion
parameters: [m]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
"""
    motion = solve(problem(text)).own.motion
    assert motion is not None
    r = sp.Symbol("r", real=True)
    first, second = motion.equations
    assert (first.factor.expression, first.factor.nonzero) == (sp.Symbol("m", positive=True), ())
    assert second.factor.nonzero == (r,)


def test_free_motion_keeps_its_acceleration(problem: Read) -> None:
    """m z'' = 0 is divided by m and not by z''."""
    solution = solve(problem("title: T\nparameters: [m]\ncoordinates: [z]\nparticles: {P: {mass: m, position: z*k}}\n"))
    assert solution.own.motion is not None
    assert solution.own.motion.expressions == (sp.Symbol("z''", real=True),)


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
    assert solution.own.motion is not None
    m, c, b, h = (sp.Symbol(n, positive=True) for n in "mcbh")
    x, acceleration = sp.Symbol("x", real=True), sp.Symbol("x''", real=True)
    distance = sp.sqrt(x**2 + h**2)
    [equation] = solution.own.motion.expressions
    expected = -c * (distance - b) * x / distance / m
    numbers = {m: 2, c: 3, b: sp.Rational(1, 2), h: sp.Rational(3, 4), x: 1}
    [found] = sp.solve(equation.xreplace(numbers), acceleration)
    assert found == expected.xreplace(numbers)


def test_what_is_known_when_the_work_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """The constraints are classified, and the stage at which the work ended is named."""
    sp.core.cache.clear_cache()
    monkeypatch.setattr("lagrange.mechanics.solution.UNITS_OF_SOLVING", 4_000)
    explained = report(load(PROBLEMS / "chapter6/ex18-double-pendulum.yaml"))
    solution = explained.solution
    assert solution.classification.degrees_of_freedom == 2
    assert solution.own.motion is None
    assert not solution.holds
    assert "the work allowed for one problem is used up" in solution.given_up
    assert [d.message for d in explained.shortcomings if d.code == "given-up"] == [f"given up at: {solution.given_up}"]
    assert "Given up at: " in terminal.text(explained.derivation, explained.notation, 200)
    assert as_object(explained)["given_up"] == solution.given_up


def test_nothing_is_known_of_constraints_that_take_too_much_work(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lagrange.mechanics.solution.UNITS_OF_SOLVING", 1)
    with pytest.raises(GaveUpError, match="given up at: classifying the constraints"):
        solve(load(PROBLEMS / "chapter6/ex18-double-pendulum.yaml"))
