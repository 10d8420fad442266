"""What a choice knows only through its velocities is put into its equations of motion."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

import lagrange
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.equations import Verdict, check_equations
from lagrange.answers.readings import read_answer
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import prime
from lagrange.explain.report import Report, report
from lagrange.mechanics.dynamics.equations import WithMultipliers
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.mechanics.solution import Method, solve
from lagrange.problem.model import Problem
from lagrange.render import latex
from lagrange.render.json import as_object
from tests.support.paths import PROBLEMS
from tests.support.second_route import Rigid, constants, moving, newton_euler, rotation, slots, t
from tests.support.shared import reported, solved

Read = Callable[[str], Problem]

LIBRARY = PROBLEMS / "motion"

DRUM = """
title: A bucket on a drum
parameters: [m, J, R, g, kappa]
coordinates: [y, phi]
particles: {P: {mass: m, position: y*j}}
bodies: {drum: {inertia: J, position: 0*i, angle: phi}}
constraints: {string: "R*phi' = y'"}
gravity: g*j
generalized_coordinates: {depth: {coordinates: [y]}}
"""

DISC = """
title: Rolling disc, upright
parameters: [m, A, C, R, F]
coordinates: [x, y, theta, phi]
let: {n: sin(theta)*i - cos(theta)*j}
bodies:
  disc: {mass: m, inertia: [A, A, C], position: x*i + y*j + R*k, axes: ["cross(k, n)", k, n],
         angular_velocity: "theta'*k + phi'*n"}
constraints: {along: "x' = R*phi'*cos(theta)", across: "y' = R*phi'*sin(theta)"}
forces: {push: {on: disc, vector: F*i}}
generalized_coordinates: {angles: {coordinates: [theta, phi]}}
"""


def final(problem: Problem, method: Method = Method.DALEMBERT) -> tuple[list[sp.Expr], list[str]]:
    """The equations of the only choice, and the names of the constraints that complete them; all checks hold."""
    solution = solve(problem, method=method)
    assert solution.holds
    [choice] = solution.choices
    assert isinstance(choice, InCoordinates)
    assert choice.motion is not None
    return [e.expression for e in choice.motion.final], [r.name for r in choice.motion.completing]


@pytest.mark.parametrize("method", [*Method])
@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        (
            "planetary-gear",
            [
                "phi''*(4*J_0*s^2*(r + s)^2 + J_1*r^2*(r + s)^2 + r^2*s^2*(J_2 + m*(r + s)^2))"
                " - r*s^2*(2*M_0*s - r*(L - 2*M_0))"
            ],
        ),
        (
            "swinging-yo-yo",
            [
                "(m*r^2 + I_G)*s'' - r*(m*r^2 + I_G)*phi'' - m*r^2*s*phi'^2 - m*g*r^2*cos(phi)",
                "r*(m*(s^2 + r^2) + I_G)*phi'' - (m*r^2 + I_G)*s'' + 2*m*r*s*s'*phi' + m*g*r*s*sin(phi)"
                " + m*g*r^2*cos(phi)",
            ],
        ),
    ],
)
def test_equations_are_in_the_chosen_coordinates(name: str, wanted: list[str], method: Method) -> None:
    problem = lagrange.load(LIBRARY / f"{name}.yaml")
    found, completing = final(problem, method)
    assert completing == []
    for e, text in zip(found, wanted, strict=True):
        [read] = read_answer(Fragment.of(text + " = 0"), problem.scope).components
        assert sp.expand(e - read) == 0


def test_a_gear_is_written_by_its_parts() -> None:
    """Each share of the inertia in factors: not J_1 r⁴ + 2 J_1 r³ s + ..."""
    [equation], _ = final(lagrange.load(LIBRARY / "planetary-gear.yaml"))
    assert "4*J_0*s**2*(r + s)**2" in str(equation)
    assert "J_1*r**2*(r + s)**2" in str(equation)


def test_a_disc_that_rolls_needs_no_place(problem: Read) -> None:
    """x'' and y'' have velocities in them, which cancel."""
    found, completing = final(problem(DISC))
    assert [str(e) for e in found] == ["theta''", "-F*R*cos(theta) + phi''*(C + R**2*m)"]
    assert completing == []


def test_a_position_that_is_left_is_completed_by_its_constraint(problem: Read) -> None:
    """A spiral spring on the drum: φ stays, φ'' does not."""
    spring = "forces: {spiral: {potential: kappa*phi^2/2}}\n"
    [plain], completing = final(problem(DRUM))
    assert "phi" not in {s.name for s in plain.free_symbols}
    assert completing == []
    [sprung], completing = final(problem(DRUM + spring))
    assert {"phi", "y''"} <= {s.name for s in sprung.free_symbols}
    assert {"phi'", "phi''"}.isdisjoint(s.name for s in sprung.free_symbols)
    assert completing == ["string"]


def test_finite_relations_that_cannot_be_solved_stay(problem: Read) -> None:
    """cos ψ = ... is not solved for ψ: the equations keep ψ'', and the constraint beside them."""
    text = DRUM.replace("R*phi' = y'", "y = R*(phi + sin(phi))").replace("R*phi'", "R*phi")
    [equation], completing = final(problem(text))
    assert "phi''" in {s.name for s in equation.free_symbols}
    assert completing == ["string"]


def test_what_is_put_in_is_said(problem: Read) -> None:
    shown = report(problem(DRUM))
    text = latex.render([(shown.derivation, shown.notation)])
    step = text[text.index("equation of motion") :]
    for line in (
        r"$\dot{\phi} = \dot{y}/R$ and $\ddot{\phi} = \ddot{y}/R$",
        "so its coefficient must vanish (multiplying by $R^{2}$):",
        r"(m R^{2} + J) \ddot{y} - m g R^{2} = 0",
    ):
        assert line in step.replace("&", "")
    [choice] = as_object(shown)["choices"]
    assert choice["equations"] == ["(m*R^2 + J)*y'' - m*g*R^2 = 0"]
    assert choice["through_velocities"] == {"phi'": "y'/R"}


def test_python_has_the_same(problem: Read) -> None:
    found = lagrange.solve(problem(DRUM))["depth"]
    assert [str(e) for e in found.equations] == ["-R**2*g*m + y''*(J + R**2*m)"]


def with_multipliers(solution: Solution, choice: str = "") -> WithMultipliers:
    dynamics = next(c.dynamics for c in solution.choices if c.name == choice) if choice else solution.own.dynamics
    assert dynamics is not None
    assert dynamics.with_multipliers is not None
    return dynamics.with_multipliers


def test_the_rolling_disc_by_newton_and_euler() -> None:
    """Equation by equation, λ included, with what is written out in i, j, k from R' Rᵀ."""
    x, y, phi, theta, psi = moving("x y phi theta psi")
    m, R, A, C, g = constants("m R A C g")
    turned = rotation("z", phi) * rotation("x", theta) * rotation("z", psi)
    disc = Rigid(m, (x, y, R * sp.sin(theta)), turned, (A, A, C), force=(0, 0, -m * g))
    arm = rotation("z", phi) * rotation("x", theta) * sp.Matrix([0, -R, 0])
    slip = sp.diff(sp.Matrix(disc.at), t) + disc.omega.cross(arm)
    kinematic = {"1": slip[0], "2": slip[1]}
    route = newton_euler("x y phi theta psi", [disc], kinematic=kinematic)
    solution = solved("rolling-disc")
    found = with_multipliers(solution)
    known = {s.name: s for pair in found.equations for e in pair for s in e.free_symbols}
    known |= {f"lambda_{n}": s for n, s in zip("12", found.multipliers, strict=True)}
    for (left, right), other in zip(found.equations, route.equations, strict=True):
        theirs = slots(other.doit())
        theirs = theirs.xreplace({s: known.get(s.name, sp.Symbol(s.name, real=True)) for s in theirs.free_symbols})
        assert is_zero(left - right - theirs) is True
        assert is_zero(left + right - theirs) is not (right != 0)


CARRIED = """
title: A skate that is pulled, on a floor
parameters: [m, I, a, F]
coordinates: [x, y, z, theta]
bodies: {B: {mass: m, inertia: I, position: x*i + y*j + z*k + a*e1_B, angle: theta}}
constraints:
  floor: z = 0
  blade: "y'*cos(theta) = x'*sin(theta)"
forces: {pull: {on: B, vector: F*i}}
generalized_coordinates:
  flat: {coordinates: [x, y, theta]}
  own: {coordinates: [X, Y, theta], substitute: {x: X*cos(theta) - Y*sin(theta), y: X*sin(theta) + Y*cos(theta), z: "0"}}
"""


def test_a_choice_keeps_the_multiplier_of_the_constraint_that_it_keeps(problem: Read) -> None:
    solution = solve(problem(CARRIED))
    assert solution.holds
    assert [s.name for s in with_multipliers(solution).multipliers] == ["lambda_floor", "lambda_blade"]
    flat = with_multipliers(solution, "flat")
    [blade] = flat.multipliers
    x, y, theta = sp.symbols("x y theta", real=True)
    m, inertia, a, pull = sp.symbols("m I a F", positive=True)
    sin, cos = sp.sin(theta), sp.cos(theta)
    ax, ay, alpha, w = prime(x, 2), prime(y, 2), prime(theta, 2), prime(theta)
    by_hand = (
        m * (ax - a * alpha * sin - a * w**2 * cos) - pull + blade * sin,
        m * (ay + a * alpha * cos - a * w**2 * sin) - blade * cos,
        inertia * alpha + m * a * (ay * cos - ax * sin + a * alpha) + pull * a * sin,
    )
    assert [is_zero(left - right - e) for (left, right), e in zip(flat.equations, by_hand, strict=True)] == [True] * 3


def shown(result: Report) -> str:
    lines = [e for s in as_object(result)["steps"] for b in s["body"] for e in b.get("equations", ())]
    return " ".join(e.get("label", "") for e in lines)


def test_they_are_printed_where_they_are_not_newtons_equations(problem: Read) -> None:
    printed = shown(report(problem(CARRIED)))
    assert "multiplied-theta" not in printed  # the list of free bodies has them
    assert "multiplied-flat-theta" in printed
    assert "multiplied-own-X" in printed
    particle = reported("ex11-ideal-pendulum")
    assert "multiplied" not in shown(particle)
    assert as_object(particle)["equations_with_multipliers"] == [
        "m*x'' = 2*x*lambda_rod",
        "m*y'' - m*g = 2*y*lambda_rod",
    ]
    assert "equations_with_multipliers" not in as_object(particle)["choices"][0]


def test_in_json_each_system_with_constraints_has_them_and_they_are_right(problem: Read) -> None:
    result = report(problem(CARRIED))
    found = as_object(result)
    reference = reference_of_solution(result.solution)
    for system in (found, *found["choices"]):
        texts = system["equations_with_multipliers"]
        assert check_equations([Fragment.of(e) for e in texts], reference).verdict is Verdict.EQUIVALENT
        n = next(n for n, e in enumerate(texts) if "lambda_blade" in e)
        wrong = [*texts[:n], texts[n].replace("lambda_blade", "(-lambda_blade)"), *texts[n + 1 :]]
        assert check_equations([Fragment.of(e) for e in wrong], reference).verdict is not Verdict.EQUIVALENT


def test_conditions_are_the_pivots_and_what_was_divided_by(problem: Read) -> None:
    found = as_object(report(problem(CARRIED)))
    assert found["conditions"] == ["cos(theta) != 0"]
    text = """
title: Planar motion
parameters: [m]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
"""
    assert as_object(report(problem(text)))["conditions"] == ["r != 0"]
    assert as_object(report(problem(text.replace("r*e_r", "r*i + phi*j"))))["conditions"] == []
