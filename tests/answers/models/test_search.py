"""Feedback contains nothing untested, and nothing about correct equations."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.examiner import Examiner
from lagrange.answers.models.search import changed_rows, explained, inverted
from lagrange.answers.readings import read_answer
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from tests.answers.models.slips import examiner, feedback_on
from tests.support.shared import reference_of

ANSWERS = [
    # no mistake of the table makes these
    ("ex11-ideal-pendulum", ["theta'' + 7*g/l*sin(3*theta)"], False),
    ("spring-pendulum", ["r'' + r^3", "phi'' + r"], False),
    ("ex11-ideal-pendulum", ["l*theta'' - g*sin(theta)"], True),
]


@pytest.mark.parametrize(("name", "equations", "found"), ANSWERS)
def test_a_model_is_named_only_where_it_reproduces_the_answer(name: str, equations: list[str], found: bool) -> None:
    reference = reference_of(name)
    [*_, candidate] = (c for c in reference.candidates if c.mechanics is not None and c.choice != "depth")
    answers = [read_answer(Fragment.of(f"{e} = 0"), reference.scope) for e in equations]
    read = [candidate.read(a.components[0]) for a in answers]
    assert any(explained(read, [0], candidate.models)) is found


def test_variations_are_made_once_and_all_have_rows() -> None:
    models = reference_of("pole-on-cart").candidates[0].models
    at = models.states(())[0]
    first, again = [*models.variations], [*models.variations]
    assert [a is b for a, b in zip(first, again, strict=True)] == [True] * len(first)
    assert all(v.mechanics is None or changed_rows(v, at) is not None for _, v in first)


def test_a_missing_mechanics_is_no_error() -> None:
    assert explained([], [], reference_of("pole-on-cart").candidates[0].models) == ()


@pytest.mark.parametrize(
    ("reaction", "said"),
    [
        ("2*lambda_blade*sin(theta) +", "The reaction of `blade` is counted twice in the equation of x."),
        ("", "The reaction of `blade` is left out in the equation of x."),
    ],
)
def test_a_reaction_in_one_equation(reaction: str, said: str) -> None:
    own = f"{reaction} m*x'' - a*m*theta''*sin(theta) - a*m*theta'^2*cos(theta) = 0"
    others = (
        "m*y'' + a*m*theta''*cos(theta) - a*m*theta'^2*sin(theta) = lambda_blade*cos(theta)",
        "(I_G + m*a^2)*theta'' - a*m*x''*sin(theta) + a*m*y''*cos(theta) = 0",
    )
    wrong, *_ = examiner("sleigh").check(tuple(map(Fragment.of, (own, *others)))).each
    assert wrong.diagnosis == said
    assert wrong.model == "reaction in one equation"


def test_rules_are_inverted() -> None:
    x, y, a, b = sp.symbols("x y a b")
    for rule in ({x: a - x}, {x: x + y}, {a: b, b: a}, {x: -x, y: -y}):
        inverse = inverted(rule)
        assert inverse is not None
        for symbol in (x, y, a, b):
            assert sp.expand(symbol.xreplace(rule).xreplace(inverse)) == symbol
    assert inverted({x: y + a, y: x}) is None


def test_two_mistakes_are_named_only_where_they_make_the_answer() -> None:
    both = ("m*r'' - m*r*phi'^2 + c*r + m*g*cos(phi) = 0", "r*phi'' + 2*r'*phi' - g*sin(phi) = 0")
    for wrong in examiner("spring-pendulum").check(tuple(map(Fragment.of, both))).each:
        assert wrong.model == "gravity reversed; spring with its length for its extension"
    neither = ("m*r'' - m*r*phi'^2 + c*r + m*g*cos(2*phi) = 0", "r*phi'' + 2*r'*phi' - g*sin(phi) = 0")
    assert not any(";" in e.model for e in examiner("spring-pendulum").check(tuple(map(Fragment.of, neither))).each)


def test_a_coefficient_of_friction_where_nothing_slips() -> None:
    equation = Fragment.of("x'' = g*sin(alpha) - mu*g*cos(alpha)")
    [wrong] = examiner("cylinder-on-rough-incline").check((equation,)).each
    assert wrong.diagnosis == "It depends on mu, and the motion does not."


def test_one_length_for_another_in_one_equation() -> None:
    equations = (
        "(m1+m2)*l1*phi1'' + m2*l1*phi2''*cos(phi1-phi2) + m2*l1*phi2'^2*sin(phi1-phi2) + (m1+m2)*g*sin(phi1) = 0",
        "l2*phi2'' + l1*phi1''*cos(phi1-phi2) - l1*phi1'^2*sin(phi1-phi2) + g*sin(phi2) = 0",
    )
    first, second = examiner("ex18-double-pendulum").check(tuple(map(Fragment.of, equations))).each
    assert first.diagnosis == "This is the equation of phi1 with l1 in place of l2 throughout."
    assert second.verdict.value == "equivalent"


WEDGE = """
title: A bead on a wavy wedge
parameters: [m, M, g, h]
coordinates: [X, x]
particles:
  wedge: {mass: M, position: X*i}
  P: {mass: m, position: (X + x)*i + h*sin(x/h)*j}
gravity: -g*j
"""


def test_an_equation_between_accelerations_is_not_explained_by_a_problem_in_which_they_vanish() -> None:
    wedge = Examiner.of(read_problem(Source("problem.yaml", WEDGE)))
    [any_numbers] = wedge.check((Fragment.of("2*(M + m)*X'' = 5*m*x'' + M*X''/3"),)).each
    assert any_numbers.diagnosis == "Something is wrong in its terms with accelerations."
    [own] = wedge.check((Fragment.of("m*X'' + m*x'' = 0"),)).each
    assert own.model == "mass left out"


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        (
            "ladder-leaves-the-wall",
            "m*l^2/2*theta'^2 = m*g*l*(cos(alpha) - cos(theta)); theta'' = g*sin(theta)/l",
            "without the rotational energy of `ladder`",
        ),
        (
            "swinging-yo-yo",
            "r*psi' = -s'; (m + I_G/r^2)*s'' = m*s*phi'^2 + m*g*cos(phi); s*phi'' + 2*s'*phi' + g*sin(phi) = 0",
            "without r in the position",
        ),
    ],
)
def test_equations_of_motion_beside_wrong_lines(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
