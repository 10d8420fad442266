"""Why a question has no answer.

Branches that the values of a problem exclude.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

import lagrange
from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.diagnostics import ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.questions.ranges import branches_with
from lagrange.mechanics.results import values_in
from lagrange.mechanics.solution import solve
from lagrange.render import terminal
from tests.mechanics.questions.test_questions import asked
from tests.mechanics.test_book_questions import Read

STONE = """
title: Stone
parameters: [m, g, v, h]
coordinates: [y]
particles: {P: {mass: m, position: y*j}}
gravity: -g*j
initial: {y: 0, y': v}
ask: {QUESTION}
"""


@pytest.mark.parametrize(
    ("question", "code"),
    [
        ("speed: {quantity: y'}", "not-determined"),
        ("speed: {quantity: y', when: y'' = 0}", "never-holds"),
    ],
)
def test_the_reason_has_a_code(question: str, code: str) -> None:
    with pytest.raises(ProblemError) as caught:
        solve(lagrange.loads(STONE.replace("QUESTION", question)), complete=False)
    assert [d.code for d in caught.value.diagnostics] == [code]


# Ranges


ROLLER = """
title: A cylinder slides in a pipe
axes: {i: right, j: down}
parameters: [m, g, R, r]
coordinates: [x, y]
particles: {c: {mass: m, position: x*i + y*j}}
constraints: {wall: {equation: x^2 + y^2 <= (R - r)^2, reaction: N, by: surface}}
gravity: g*j
generalized_coordinates:
  a: {coordinates: [phi], substitute: {x: (R - r)*sin(phi), y: (R - r)*cos(phi)}}
"""


def test_a_difference_of_radii_is_positive_in_the_sense_of_the_file(problem: Read) -> None:
    solved = report(problem(ROLLER))
    page = terminal.text(solved.derivation, solved.notation, 120)
    assert "N = m (R − r) (ẋ² + ẏ² + g y)/(x² + y²) = m (R − r) φ̇² + m g cos φ" in page
    assert "|R − r|" not in page
    assert "with R − r > 0" in page


# In numbers


STONE_IN_NUMBERS = """
title: Stone
parameters: {m: 2 kg, g: 9.81 m/s^2, v: 3 m/s, h: {unit: m}}
coordinates: {y: {unit: m}}
particles: {P: {mass: m, position: y*j}}
gravity: -g*j
initial: {y: 0, y': v}
ask: {top: {quantity: y, when: y' = 0}}
"""


def test_a_condition_that_the_values_violate_excludes_its_branch_and_an_open_one_does_not() -> None:
    solution = solve(lagrange.loads(STONE_IN_NUMBERS), complete=False)
    [asked], values = solution.asked, values_in(solution)
    assert values is not None
    [branch] = asked.branches
    m, g, v, h = (p.symbol for p in solution.problem.parameters)
    conditions = [SignCondition(v, ">", 2 * v), SignCondition(g, ">", m), SignCondition(h, ">", m)]
    branches = tuple(replace(branch, conditions=(c,)) for c in conditions)
    assert branches_with(replace(asked, branches=branches), values) == branches[1:]


THROWN = """title: A ball thrown from the foot of a slope
axes: {i: right, j: up}
parameters: {m: positive, g: positive, v: positive, alpha: acute, beta: acute}
coordinates: [x, y]
particles: {ball: {mass: m, position: x*i + y*j}}
gravity: -g*j
initial: {x: 0, y: 0, x': v*cos(alpha), y': v*sin(alpha)}
"""


def test_an_acute_angle_that_is_asked_for_is_acute(problem: Read) -> None:
    """At right angles to the slope at the start, it would be thrown at β + π/2 or β − π/2, which are not acute."""
    hits = "ask: {it: {quantity: alpha, when: [y = x*tan(beta), \"x'*cos(beta) + y'*sin(beta) = 0\"]}}\n"
    [b] = asked(problem, THROWN + hits).branches
    beta = next(iter(b.rhs.free_symbols))
    assert is_zero(b.rhs - sp.cot(beta) - 2 * sp.tan(beta)) is True
    with pytest.raises(ProblemError) as error:
        asked(problem, THROWN + "ask: {it: {quantity: alpha, when: [t = 0, \"x'*cos(beta) + y'*sin(beta) = 0\"]}}\n")
    assert error.value.diagnostics[0].code == "never-holds"


SPOOL = """
title: Spool drawn by its thread
parameters: {m: positive, J: positive, R: positive, a: positive, F: positive, beta: acute, mu: positive, g: positive}
coordinates: [x, y, psi]
bodies: {spool: {mass: m, inertia: J, position: x*i + y*j, angle: -psi}}
constraints:
  floor: {equation: y >= R, reaction: N}
  rolling: {equation: "x' = R*psi'", reaction: H}
gravity: -g*j
forces: {thread: {on: spool, vector: F*cos(beta)*i + F*sin(beta)*j, at: r_spool + a*sin(beta)*i - a*cos(beta)*j}}
initial: {x: 0, x': 0, psi: 0}
ask: {least: {quantity: mu, when: H = mu*N}}
"""


def test_friction_is_not_answered_with_a_contact_that_pulls(problem: Read) -> None:
    """H = −F (J cos β + m a R)/(J + m R²) is never μ N with N ≥ 0: what is meant is its size."""
    [found] = solve(problem(SPOOL), complete=False).asked
    m, J, R, a, F, g = sp.symbols("m J R a F g", positive=True)
    [b] = found.branches
    [beta] = {s for s in b.values[0].free_symbols if s.name == "beta"}
    expected = F * (J * sp.cos(beta) + m * a * R) / ((J + m * R**2) * (m * g - F * sp.sin(beta)))
    assert is_zero(b.values[0] - expected)
    assert found.opposite == sp.Symbol("H", real=True)
